//! What failed sensors do to a machine: where it is caught, where it never gets, and whether it still ends well.

use std::collections::BTreeMap;
use std::rc::Rc;

use crate::analysis::modes::{Change, Changes, Fault, FaultSet};
use crate::analysis::reachability::{Graph, is_in};
use crate::base::Id;
use crate::ir::{Diagram, Mode};

/// What some failed sensors do.
pub(in crate::analysis) struct Effect {
    pub(in crate::analysis) faults: FaultSet,
    /// Modes that the machine can be in and never leaves again. Several that lead through the entry are no trap.
    pub(in crate::analysis) traps: Vec<Loss>,
    /// Modes that a machine never gets to if it starts with the sensors failed; those behind them are left out.
    pub(in crate::analysis) missed: Vec<Loss>,
    /// Modes that the machine can be in and from which it never gets to a safe one again.
    pub(in crate::analysis) unsafe_modes: Loss,
}

/// Modes to which something happens because exits are not taken that otherwise would be.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(in crate::analysis) struct Loss {
    /// The modes, sorted.
    pub(in crate::analysis) modes: Vec<Id<Mode>>,
    /// The exits, each as its mode and its position there; none for nothing at all.
    pub(in crate::analysis) exits: Vec<(Id<Mode>, usize)>,
}

/// The effects of all changes that have one, smallest sets of failed sensors first. Sensors may fail at any time. Each
/// change costs a walk through the diagram.
pub(in crate::analysis) fn effects(diagram: &Diagram, changes: &Changes) -> Vec<Effect> {
    let Some(entry) = diagram.entry else { return Vec::new() };
    let healthy = Graph::new(diagram, |mode| changes.healthy[mode.index()].targets(&diagram.modes[mode]));
    let safe: Vec<_> = diagram.modes.ids().filter(|mode| *mode == entry || diagram.modes[*mode].is_final).collect();
    let healthy = Walk { started: Rc::new(healthy.reached([entry])), safe: healthy.leading_to(safe.clone()) };
    let mut reached: BTreeMap<&FaultSet, Rc<Vec<bool>>> = BTreeMap::new();
    let mut effects = Vec::new();
    for change in &changes.under {
        let graph = Graph::new(diagram, |mode| changes.exits(change, mode).targets(&diagram.modes[mode]));
        let before = (0..change.faults.len()).map(|without| {
            let mut fewer = change.faults.clone();
            fewer.remove(without);
            Rc::clone(reached.get(&fewer).unwrap_or(&healthy.started))
        });
        let before: Vec<_> = before.collect();
        let was_reached = |mode: &Id<Mode>| before.iter().any(|reached| reached[mode.index()]);
        let now = Rc::new(graph.reached(diagram.modes.ids().filter(was_reached)));
        let failed = Failed { diagram, change, lost: change.lost(&changes.healthy), graph: &graph, reached: &now };
        let traps = failed.traps();
        let missed = failed.missed(&healthy.started, &graph.reached([entry]));
        let unsafe_modes = failed.unsafe_modes(&healthy.safe, &graph.leading_to(safe.iter().copied()));
        reached.insert(&change.faults, now);
        effects.push(Effect { faults: change.faults.clone(), traps, missed, unsafe_modes });
    }
    effects
}

/// What is known of each mode while nothing has failed.
struct Walk {
    /// Whether the machine gets there.
    started: Rc<Vec<bool>>,
    /// Whether a safe mode can be reached from it.
    safe: Vec<bool>,
}

/// A diagram under some failures.
struct Failed<'a> {
    diagram: &'a Diagram,
    change: &'a Change,
    /// The exits that are no longer taken.
    lost: Vec<(Id<Mode>, usize)>,
    graph: &'a Graph,
    /// The modes that the machine can be in.
    reached: &'a [bool],
}

impl Failed<'_> {
    /// Whether a sensor that a mode requires is known to have failed.
    fn is_inhibited(&self, mode: Id<Mode>) -> bool {
        let mut required = self.diagram.modes[mode].requires.iter();
        required.any(|(sensor, _)| self.change.faults.contains(&(*sensor, Fault::Reported)))
    }

    /// The exits of some modes that are no longer taken, with where they led.
    fn lost_exits(&self, from: impl Fn(Id<Mode>) -> bool) -> impl Iterator<Item = (Id<Mode>, usize, Id<Mode>)> {
        let lost = self.lost.iter().filter(move |(mode, _)| from(*mode));
        lost.filter_map(|&(mode, index)| Some((mode, index, self.diagram.modes[mode].transitions[index].target?)))
    }

    fn traps(&self) -> Vec<Loss> {
        let of_group = |group: Vec<Id<Mode>>| {
            let ends = group.iter().all(|mode| self.graph.successors(*mode).all(|target| is_in(&group, target)));
            let starts_over = group.len() > 1 && self.diagram.entry.is_some_and(|entry| is_in(&group, entry));
            let is_caught = ends && !starts_over && self.reached[group[0].index()];
            let exits = self.lost_exits(|mode| is_caught && is_in(&group, mode));
            // What keeps the machine from entering a mode may keep it among others, but not in one for ever.
            let is_meant = |target: Id<Mode>| group.len() > 1 && self.is_inhibited(target);
            let out = exits.filter(|(_, _, target)| !is_in(&group, *target) && !is_meant(*target));
            let exits: Vec<_> = out.map(|(mode, index, _)| (mode, index)).collect();
            (!exits.is_empty()).then_some(Loss { modes: group, exits })
        };
        let mut traps: Vec<_> = self.graph.groups().into_iter().filter_map(of_group).collect();
        traps.sort_by(|one, other| one.modes.cmp(&other.modes));
        traps
    }

    fn missed(&self, healthy: &[bool], now: &[bool]) -> Vec<Loss> {
        let mut missed: BTreeMap<Id<Mode>, Vec<(Id<Mode>, usize)>> = BTreeMap::new();
        for (mode, index, target) in self.lost_exits(|mode| now[mode.index()]) {
            if healthy[target.index()] && !now[target.index()] {
                missed.entry(target).or_default().push((mode, index));
            }
        }
        missed.into_iter().map(|(mode, exits)| Loss { modes: vec![mode], exits }).collect()
    }

    fn unsafe_modes(&self, healthy: &[bool], now: &[bool]) -> Loss {
        let is_lost = |mode: &Id<Mode>| self.reached[mode.index()] && healthy[mode.index()] && !now[mode.index()];
        let exits = self.lost_exits(|mode| is_lost(&mode));
        let exits = exits.filter(|(_, _, target)| now[target.index()] && !self.is_inhibited(*target));
        let exits = exits.map(|(mode, index, _)| (mode, index)).collect();
        Loss { modes: self.diagram.modes.ids().filter(is_lost).collect(), exits }
    }
}
