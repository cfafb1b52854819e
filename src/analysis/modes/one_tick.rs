//! Modes that follow each other on every tick while the readings stay as they are.

use super::cycles::{Cycle, Pace, TooLarge, shortest};
use super::dwell::Way;
use super::ticks::Scene;
use super::{Examined, named_readings};
use crate::analysis::reachability::Graph;
use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::Mode;

pub(super) fn check(scene: &Scene<'_>, modes: &[Option<Examined>], findings: &mut Vec<Diagnostic>) {
    let diagram = scene.diagram;
    let Some(entry) = diagram.entry else { return };
    let graph = Graph::new(diagram, |mode| at_once(&diagram.modes[mode], modes[mode.index()].as_ref()));
    let all = Graph::new(diagram, |mode| super::successors(&diagram.modes[mode], modes[mode.index()].as_ref()));
    let reached = all.reached([entry]);
    for group in graph.groups().iter().filter(|group| group.len() > 1 && reached[group[0].index()]) {
        let cycle = shortest(scene, group, Pace::EveryTick);
        if let Some(cycle) = cycle.unwrap_or_else(|TooLarge| cycle_of_two(scene, &graph, group)) {
            findings.push(one_tick_cycle(scene, &cycle));
        }
    }
}

/// Where a mode without any failure may lead on its first tick.
fn at_once(mode: &Mode, examined: Option<&Examined>) -> Vec<Id<Mode>> {
    let Some(examined) = examined else { return Vec::new() };
    // What the past allows may be shown later, and be at once too.
    let looks_back = examined.formula.looks_back();
    let may_be = |way: &Way| looks_back || matches!(way, Way::Shown(path) if path.len() == 1);
    let exits = mode.transitions.iter().zip(&examined.stay.exits);
    let at_once = exits.filter(|(_, exit)| exit.taken.as_ref().is_some_and(may_be));
    at_once.filter_map(|(transition, _)| transition.target).collect()
}

/// A cycle of two modes of a group that is too large to be looked into as a whole.
fn cycle_of_two<'a>(scene: &Scene<'a>, graph: &Graph, group: &[Id<Mode>]) -> Option<Cycle<'a>> {
    let pairs = group.iter().flat_map(|mode| graph.successors(*mode).map(|other| (*mode, other)));
    let mutual = pairs.filter(|(mode, other)| mode < other && graph.successors(*other).any(|back| back == *mode));
    let mut cycles = mutual.map(|(mode, other)| shortest(scene, &[mode, other], Pace::EveryTick).unwrap_or(None));
    cycles.find_map(|cycle| cycle)
}

fn one_tick_cycle(scene: &Scene<'_>, cycle: &Cycle<'_>) -> Diagnostic {
    let names = cycle.names(scene.diagram);
    let message = format!("{names} follow each other on every tick, each left as soon as it is entered");
    let places: Vec<_> = cycle.steps.iter().map(|step| step.transition.span).collect();
    let mut diagnostic = Diagnostic::new(&rules::ONE_TICK_CYCLE, places[0], message)
        .here("holds on the tick after the mode was entered");
    for place in places.into_iter().skip(1).take(3) {
        diagnostic = diagnostic.label(place, "so does this, with the same readings");
    }
    let shown = named_readings(scene.program, &cycle.readings);
    if !shown.is_empty() {
        diagnostic = diagnostic.note(format!("it goes on as long as the readings stay: {shown}"));
    }
    diagnostic.help("make the conditions exclude each other, or let one of the modes last with `after`")
}
