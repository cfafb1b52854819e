//! Modes that follow each other on every tick while the readings stay as they are.

use std::collections::{BTreeSet, HashMap};

use super::Examined;
use super::dwell::Way;
use super::faults::FaultSet;
use super::formula::Formula;
use super::fusion::Readings;
use super::ticks::{Scene, feasible};
use crate::analysis::reachability::Graph;
use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode, Transition};

/// Modes times kinds of ticks: beyond that, only pairs of modes are looked into.
const MOST_STEPS: usize = 1 << 20;

/// A cycle of transitions, and readings that keep it going.
struct Cycle<'a> {
    transitions: Vec<(Id<Mode>, &'a Transition)>,
    readings: Readings,
}

pub(super) fn check(scene: &Scene<'_>, modes: &[Option<Examined>], findings: &mut Vec<Diagnostic>) {
    let diagram = scene.diagram;
    let Some(entry) = diagram.entry else { return };
    let graph = Graph::new(diagram, |mode| at_once(&diagram.modes[mode], modes[mode.index()].as_ref()));
    let all = Graph::new(diagram, |mode| super::successors(&diagram.modes[mode], modes[mode.index()].as_ref()));
    let reached = all.reached(entry);
    for group in graph.groups().iter().filter(|group| group.len() > 1 && reached[group[0].index()]) {
        if let Some(cycle) = cycle_among(scene, group).unwrap_or_else(|TooLarge| cycle_of_two(scene, &graph, group)) {
            findings.push(one_tick_cycle(scene, &cycle));
        }
    }
}

/// Where a mode without any failure leads on its first tick.
fn at_once(mode: &Mode, examined: Option<&Examined>) -> Vec<Id<Mode>> {
    let Some(examined) = examined else { return Vec::new() };
    let exits = mode.transitions.iter().zip(&examined.stay.exits);
    let at_once = exits.filter(|(_, exit)| matches!(&exit.taken, Some(Way::Shown(path)) if path.len() == 1));
    at_once.filter_map(|(transition, _)| transition.target).collect()
}

/// There are too many cases to look into.
struct TooLarge;

/// The shortest cycle among some modes.
fn cycle_among<'a>(scene: &Scene<'a>, group: &[Id<Mode>]) -> Result<Option<Cycle<'a>>, TooLarge> {
    let modes = &scene.diagram.modes;
    let transitions: Vec<_> =
        group.iter().flat_map(|mode| modes[*mode].transitions.iter().map(|exit| (*mode, exit))).collect();
    let formula =
        Formula::new(scene.program, scene.diagram, transitions.iter().map(|(_, exit)| *exit)).ok_or(TooLarge)?;
    let ticks = feasible(scene, &formula, &FaultSet::new()).ok_or(TooLarge)?;
    if ticks.len().saturating_mul(transitions.len()) > MOST_STEPS {
        return Err(TooLarge);
    }
    let mut shortest: Option<Cycle<'a>> = None;
    let mut known = BTreeSet::new();
    for tick in ticks {
        let Some(readings) = tick.readings else { continue };
        let values = formula.settled(tick.truth);
        let mut next: HashMap<Id<Mode>, &'a Transition> = HashMap::new();
        for ((mode, transition), root) in transitions.iter().zip(&formula.roots) {
            if values[*root] {
                next.entry(*mode).or_insert(transition);
            }
        }
        let chosen: Vec<_> = group.iter().map(|mode| next.get(mode).map(|exit| exit.span)).collect();
        if known.insert(chosen)
            && let Some(transitions) = shortest_cycle(group, &next)
            && shortest.as_ref().is_none_or(|shortest| transitions.len() < shortest.transitions.len())
        {
            shortest = Some(Cycle { transitions, readings });
        }
    }
    Ok(shortest)
}

/// The shortest cycle of at least two modes that each lead to one.
fn shortest_cycle<'a>(
    group: &[Id<Mode>],
    next: &HashMap<Id<Mode>, &'a Transition>,
) -> Option<Vec<(Id<Mode>, &'a Transition)>> {
    let mut walked: HashMap<Id<Mode>, Id<Mode>> = HashMap::new();
    let mut shortest: Option<Vec<_>> = None;
    for &start in group {
        let mut path: Vec<(Id<Mode>, &Transition)> = Vec::new();
        let mut mode = start;
        while let (Some(transition), None) = (next.get(&mode), walked.get(&mode)) {
            walked.insert(mode, start);
            path.push((mode, transition));
            let Some(target) = transition.target else { break };
            mode = target;
        }
        if walked.get(&mode) != Some(&start) || !next.contains_key(&mode) {
            continue;
        }
        let Some(begin) = path.iter().position(|(walked, _)| *walked == mode) else { continue };
        let cycle = path.split_off(begin);
        if cycle.len() > 1 && shortest.as_ref().is_none_or(|shortest| cycle.len() < shortest.len()) {
            shortest = Some(cycle);
        }
    }
    shortest
}

/// A cycle of two modes of a group that is too large to be looked into as a whole.
fn cycle_of_two<'a>(scene: &Scene<'a>, graph: &Graph, group: &[Id<Mode>]) -> Option<Cycle<'a>> {
    let pairs = group.iter().flat_map(|mode| graph.successors(*mode).map(|other| (*mode, other)));
    let mutual = pairs.filter(|(mode, other)| mode < other && graph.successors(*other).any(|back| back == *mode));
    let mut cycles = mutual.map(|(mode, other)| cycle_among(scene, &[mode, other]).unwrap_or(None));
    cycles.find_map(|cycle| cycle)
}

fn one_tick_cycle(scene: &Scene<'_>, cycle: &Cycle<'_>) -> Diagnostic {
    let Diagram { modes, .. } = scene.diagram;
    let names: Vec<_> = cycle.transitions.iter().take(5).map(|(mode, _)| modes[*mode].symbol.name.clone()).collect();
    let names: Vec<_> = names.into_iter().map(|name| format!("`{name}`")).collect();
    let shown: Vec<_> = cycle
        .readings
        .iter()
        .map(|(sensor, at)| {
            let sensor = &scene.program.sensors[*sensor];
            format!("`{}` at {}", sensor.symbol.name, sensor.unit.show(at.to_f64()))
        })
        .collect();
    let message = format!("{} follow each other on every tick, each left as soon as it is entered", names.join(", "));
    let first = cycle.transitions.first().map(|(_, transition)| transition.span).unwrap_or_default();
    let mut diagnostic =
        Diagnostic::new(&rules::ONE_TICK_CYCLE, first, message).here("holds on the tick after the mode was entered");
    for (_, transition) in cycle.transitions.iter().skip(1).take(3) {
        diagnostic = diagnostic.label(transition.span, "so does this, with the same readings");
    }
    if !shown.is_empty() {
        diagnostic = diagnostic.note(format!("it goes on as long as the readings stay: {}", shown.join(", ")));
    }
    diagnostic.help("make the conditions exclude each other, or let one of the modes last with `after`")
}
