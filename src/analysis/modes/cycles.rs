//! Cycles of modes that go on while the readings stay as they are.

use std::collections::{BTreeSet, HashMap};

use super::faults::FaultSet;
use super::formula::{Atom, Formula};
use super::fusion::Readings;
use super::ticks::{Scene, decided};
use crate::base::Id;
use crate::ir::{Diagram, Mode, Transition};

/// A cycle of transitions, and readings that keep it going.
pub(super) struct Cycle<'a> {
    pub(super) steps: Vec<Step<'a>>,
    pub(super) readings: Readings,
}

impl Cycle<'_> {
    /// Its modes as messages name them.
    pub(super) fn names(&self, diagram: &Diagram) -> String {
        let names = self.steps.iter().take(5).map(|step| format!("`{}`", diagram.modes[step.mode].symbol.name));
        names.collect::<Vec<_>>().join(", ")
    }
}

/// A transition of a cycle.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    pub(super) mode: Id<Mode>,
    pub(super) transition: &'a Transition,
    /// Whether its mode lasts for some time before.
    pub(super) waits: bool,
    /// Whether it is not taken by time alone; told where the pace asks for it.
    pub(super) needs_readings: bool,
}

/// There are too many cases to look into.
pub(super) struct TooLarge;

/// What the cycles that are looked for have in common.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Pace {
    /// Every mode is left on the tick after it was entered.
    EveryTick,
    /// Some modes last, but none is left by time alone.
    Slower,
}

impl Pace {
    /// The most modes and atoms of a group, and the most transitions times kinds of ticks times times that are looked
    /// into. What is only worth knowing is not worth much time.
    fn limits(self) -> (usize, usize) {
        match self {
            Self::EveryTick => (usize::MAX, 1 << 20),
            Self::Slower => (16, 1 << 16),
        }
    }

    fn fits(self, steps: &[Step<'_>]) -> bool {
        match self {
            Self::EveryTick => steps.iter().all(|step| !step.waits),
            Self::Slower => steps.iter().any(|step| step.waits) && steps.iter().all(|step| step.needs_readings),
        }
    }
}

/// The shortest cycle of a pace among some modes, nothing having failed, no action completing.
pub(super) fn shortest<'a>(scene: &Scene<'a>, group: &[Id<Mode>], pace: Pace) -> Result<Option<Cycle<'a>>, TooLarge> {
    let (most, most_steps) = pace.limits();
    if group.len() > most {
        return Err(TooLarge);
    }
    let modes = &scene.diagram.modes;
    // Each with the place of its mode in the group.
    let exits =
        (0..).zip(group).flat_map(|(place, mode)| modes[*mode].transitions.iter().map(move |exit| (place, exit)));
    let exits: Vec<(usize, &'a Transition)> = exits.collect();
    let formula = Formula::new(scene.program, scene.diagram, exits.iter().map(|(_, exit)| *exit)).ok_or(TooLarge)?;
    if formula.atoms.len() > most {
        return Err(TooLarge);
    }
    // Nothing is known of what such an atom does while the readings stay.
    if formula.atoms.iter().any(|atom| matches!(atom, Atom::Open(_) | Atom::Inside(_))) {
        return Ok(None);
    }
    let ticks = decided(scene, &formula, &FaultSet::new()).ok_or(TooLarge)?;
    let dwells = dwells(&formula, pace);
    if ticks.len().saturating_mul(exits.len()).saturating_mul(dwells.len()) > most_steps {
        return Err(TooLarge);
    }
    let mut needs_readings = vec![false; exits.len()];
    for tick in ticks.iter().filter(|_| pace == Pace::Slower) {
        let values = formula.settled(tick.truth, u64::MAX);
        needs_readings.iter_mut().zip(&formula.roots).for_each(|(needs, root)| *needs |= !values[*root]);
    }
    let places: HashMap<Id<Mode>, usize> = group.iter().copied().zip(0..).collect();
    let mut found: Option<Cycle<'a>> = None;
    let mut known = BTreeSet::new();
    for tick in ticks {
        let Some(readings) = tick.readings else { continue };
        let mut next: Vec<Option<Step<'a>>> = vec![None; group.len()];
        for &dwell in &dwells {
            let values = formula.settled(tick.truth, dwell);
            let holding = exits.iter().zip(&needs_readings).zip(&formula.roots).filter(|(_, root)| values[**root]);
            for ((&(place, transition), &needs_readings), _) in holding {
                let step = Step { mode: group[place], transition, waits: dwell > 0, needs_readings };
                next[place].get_or_insert(step);
            }
        }
        let chosen: Vec<_> = next.iter().map(|step| step.map(|step| step.transition.span)).collect();
        if known.insert(chosen)
            && let Some(steps) = shortest_cycle(&places, &next, pace)
            && found.as_ref().is_none_or(|found| steps.len() < found.steps.len())
        {
            found = Some(Cycle { steps, readings });
        }
    }
    Ok(found)
}

/// The times in a mode at which its conditions can change, the first tick first.
fn dwells(formula: &Formula, pace: Pace) -> Vec<u64> {
    let after = formula.atoms.iter().filter_map(|atom| match atom {
        Atom::After(duration) if pace == Pace::Slower => Some(*duration),
        _ => None,
    });
    after.chain([0]).collect::<BTreeSet<_>>().into_iter().collect()
}

/// The shortest cycle of at least two modes that each lead to one.
fn shortest_cycle<'a>(
    places: &HashMap<Id<Mode>, usize>,
    next: &[Option<Step<'a>>],
    pace: Pace,
) -> Option<Vec<Step<'a>>> {
    let mut walked: Vec<Option<usize>> = vec![None; next.len()];
    let mut shortest: Option<Vec<_>> = None;
    for start in 0..next.len() {
        let mut path: Vec<Step<'a>> = Vec::new();
        let mut place = Some(start);
        while let Some(here) = place.filter(|here| walked[*here].is_none())
            && let Some(step) = next[here]
        {
            walked[here] = Some(start);
            path.push(step);
            place = step.transition.target.and_then(|target| places.get(&target)).copied();
        }
        let Some(place) = place.filter(|place| walked[*place] == Some(start)) else { continue };
        let Some(begin) = path.iter().position(|step| places[&step.mode] == place) else { continue };
        let cycle = path.split_off(begin);
        let is_shorter = shortest.as_ref().is_none_or(|shortest| cycle.len() < shortest.len());
        if cycle.len() > 1 && is_shorter && pace.fits(&cycle) {
            shortest = Some(cycle);
        }
    }
    shortest
}
