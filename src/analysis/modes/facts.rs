//! What a diagram can and cannot do under each set of failed sensors.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;

use super::dwell::{Case, Moment, State, Stay, Way, stay};
use super::examined::concerning;
use super::fault_sets::fault_sets;
use super::faults::{self, FaultSet};
use super::formula::Formula;
use super::ticks::Scene;
use crate::analysis::reachability::Graph;
use crate::base::Id;
use crate::ir::{Diagram, Mode, Program, Sensor};

/// What a diagram can do under some faults, which may strike one after another while it runs, and stay.
#[derive(Debug, Clone)]
pub struct Facts {
    /// The failed sensors.
    pub faults: FaultSet,
    /// What is known of each mode, by its id.
    pub modes: Vec<ModeFacts>,
    /// Modes that the machine can reach and then never leaves while the faults last: one mode that is not `final`, or
    /// several that would lead on, to modes that are not inhibited, if nothing had failed.
    pub traps: Vec<Vec<Id<Mode>>>,
}

/// What a mode can do under some faults.
#[derive(Debug, Clone)]
pub struct ModeFacts {
    /// Whether the machine can be in it; a `false` is proved.
    pub reachable: bool,
    /// Whether a sensor that it requires is known to have failed.
    pub inhibited: bool,
    /// How each of its transitions is taken; `None` is proved.
    pub exits: Vec<Option<Way>>,
    /// Ticks that lead here from the start, where they are known.
    pub trace: Option<Vec<Step>>,
}

/// A tick of a trace.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// The mode in which the tick begins.
    pub mode: Id<Mode>,
    /// What has failed by then.
    pub faults: FaultSet,
    /// What the machine is told.
    pub moment: Moment,
}

/// The facts of a diagram for every set of at most `up_to` failed sensors, smallest sets first. A sensor stuck at an
/// unknown reading is one set for each stretch of readings that the diagram can tell apart.
pub fn fault_table(program: &Program, diagram: Id<Diagram>, up_to: usize) -> Vec<Facts> {
    let scene = Scene::new(program, &program.diagrams[diagram]);
    let Some(entry) = scene.diagram.entry else { return Vec::new() };
    let mut table = Table::new(&scene);
    let mut known: BTreeMap<FaultSet, Rc<Reached>> = BTreeMap::new();
    let mut rows = Vec::new();
    for faults in table.fault_sets(up_to) {
        let before: Vec<_> =
            (0..faults.len()).filter_map(|without| known.get(&except(&faults, without))).cloned().collect();
        let reached = Rc::new(table.reached(entry, &faults, &before));
        let healthy = known.get(&FaultSet::new()).unwrap_or(&reached);
        rows.push(facts(&scene, &reached, healthy));
        known.insert(faults, reached);
    }
    rows
}

fn except(faults: &FaultSet, without: usize) -> FaultSet {
    faults.iter().enumerate().filter(|(index, _)| *index != without).map(|(_, fault)| *fault).collect()
}

/// The modes that are reached under some faults, and how.
struct Reached {
    faults: FaultSet,
    modes: BTreeMap<Id<Mode>, Arrival>,
    /// What can happen in each mode, by its id, once it is reached; `None` where that has too many cases.
    stays: Vec<Option<Rc<Stay>>>,
}

enum Arrival {
    /// It is the entry.
    Entry,
    /// It was reached before the last fault struck.
    Before(Rc<Reached>),
    /// From a mode, by ticks that are known or not.
    From(Id<Mode>, Way),
}

impl Reached {
    fn trace(&self, mode: Id<Mode>) -> Option<Vec<Step>> {
        let mut parts: Vec<Vec<Step>> = Vec::new();
        let (mut reached, mut mode) = (self, mode);
        loop {
            match reached.modes.get(&mode)? {
                Arrival::Entry => break,
                Arrival::Before(earlier) => reached = earlier,
                Arrival::From(_, Way::Open) => return None,
                Arrival::From(from, Way::Shown(moments)) => {
                    let step =
                        |moment: &Moment| Step { mode: *from, faults: reached.faults.clone(), moment: moment.clone() };
                    parts.push(moments.iter().map(step).collect());
                    mode = *from;
                }
            }
        }
        parts.reverse();
        Some(parts.concat())
    }
}

/// The modes of a diagram, and what is known of them by now.
pub(super) struct Table<'s, 'a> {
    scene: &'s Scene<'a>,
    /// The conditions of each mode, and the sensors whose failing concerns it.
    pub(super) formulas: Vec<Option<(Formula, BTreeSet<Id<Sensor>>)>>,
    stays: HashMap<Visit, Option<Rc<Stay>>>,
}

/// A mode, what has failed, and where the machine may have been in it before the last failure.
type Visit = (Id<Mode>, FaultSet, BTreeSet<State>);

impl<'s, 'a> Table<'s, 'a> {
    pub(super) fn new(scene: &'s Scene<'a>) -> Self {
        let formula = |mode: &Mode| {
            let formula = Formula::new(scene.program, scene.diagram, &mode.transitions).filter(|_| !mode.incomplete)?;
            let sensors = concerning(scene, mode, &formula);
            Some((formula, sensors))
        };
        Self { scene, formulas: scene.diagram.modes.values().map(formula).collect(), stays: HashMap::new() }
    }

    /// What can happen in a mode; only the faults that concern it count.
    fn stay(&mut self, mode: Id<Mode>, faults: &FaultSet, before: &[Rc<Reached>]) -> Option<Rc<Stay>> {
        let (formula, sensors) = self.formulas[mode.index()].as_ref()?;
        let mut states = BTreeSet::new();
        for earlier in before.iter().filter(|earlier| earlier.modes.contains_key(&mode)) {
            states.extend(earlier.stays[mode.index()].as_ref()?.states.iter().cloned());
        }
        let faults: FaultSet = faults.iter().filter(|(sensor, _)| sensors.contains(sensor)).copied().collect();
        let scene = self.scene;
        let new = |(mode, faults, states): &Visit| {
            let case = Case::new(scene, &scene.diagram.modes[*mode], formula, faults)?;
            stay(formula, &[Rc::new(case)], states).map(Rc::new)
        };
        self.stays.entry((mode, faults, states)).or_insert_with_key(new).clone()
    }

    /// Every mode that is reached under these faults, from the entry or from where the machine was before the last one.
    fn reached(&mut self, entry: Id<Mode>, faults: &FaultSet, before: &[Rc<Reached>]) -> Reached {
        let all = self.scene.diagram.modes.ids();
        let stays: Vec<_> = all.map(|mode| self.stay(mode, faults, before)).collect();
        let mut modes = BTreeMap::from([(entry, Arrival::Entry)]);
        for earlier in before {
            for mode in earlier.modes.keys() {
                modes.entry(*mode).or_insert_with(|| Arrival::Before(Rc::clone(earlier)));
            }
        }
        // What is shown first, so that as many modes as possible have a trace.
        for is_shown_only in [true, false] {
            let mut waiting: Vec<_> = modes.keys().copied().collect();
            let mut next = 0;
            while let Some(&mode) = waiting.get(next) {
                next += 1;
                for (target, way) in ways(&self.scene.diagram.modes[mode], stays[mode.index()].as_deref()) {
                    if !modes.contains_key(&target) && (way != Way::Open || !is_shown_only) {
                        waiting.push(target);
                        modes.insert(target, Arrival::From(mode, way));
                    }
                }
            }
        }
        Reached { faults: faults.clone(), modes, stays }
    }

    /// Every set of at most `up_to` faults of the sensors that the diagram looks at, smallest first.
    pub(super) fn fault_sets(&self, up_to: usize) -> Vec<FaultSet> {
        let modes: Vec<_> = self.formulas.iter().flatten().map(|(formula, sensors)| (formula, sensors)).collect();
        fault_sets(self.scene, &modes, up_to, usize::MAX)
    }
}

/// Where a mode can lead, and how.
fn ways(mode: &Mode, stay: Option<&Stay>) -> Vec<(Id<Mode>, Way)> {
    match stay {
        None => {
            let targets = mode.transitions.iter().filter_map(|exit| exit.target).chain(mode.otherwise);
            targets.map(|target| (target, Way::Open)).collect()
        }
        Some(Stay { lost: Some(otherwise), .. }) => {
            let moment = Moment { dwell: 0, done: false, readings: Vec::new() };
            vec![(*otherwise, Way::Shown(vec![moment]))]
        }
        Some(stay) => {
            let exits = mode.transitions.iter().zip(&stay.exits);
            exits.filter_map(|(transition, exit)| Some((transition.target?, exit.taken.clone()?))).collect()
        }
    }
}

/// What is known of a diagram once everything that is reached is.
fn facts(scene: &Scene<'_>, reached: &Reached, healthy: &Reached) -> Facts {
    let facts = |(id, mode): (Id<Mode>, &Mode)| ModeFacts {
        reachable: reached.modes.contains_key(&id),
        inhibited: is_inhibited(scene.program, mode, &reached.faults),
        exits: match &reached.stays[id.index()] {
            Some(stay) => stay.exits.iter().map(|exit| exit.taken.clone()).collect(),
            None => vec![Some(Way::Open); mode.transitions.len()],
        },
        trace: reached.trace(id),
    };
    let modes = scene.diagram.modes.iter().map(facts).collect();
    Facts { faults: reached.faults.clone(), modes, traps: traps(scene, reached, healthy) }
}

fn is_inhibited(program: &Program, mode: &Mode, faults: &FaultSet) -> bool {
    mode.requires.iter().any(|(sensor, _)| faults::is_reported(program, faults, *sensor))
}

fn traps(scene: &Scene<'_>, reached: &Reached, healthy: &Reached) -> Vec<Vec<Id<Mode>>> {
    let Scene { program, diagram, .. } = *scene;
    let leads = |of: &Reached| -> Vec<Vec<Id<Mode>>> {
        let modes = diagram.modes.values().zip(&of.stays);
        modes.map(|(mode, stay)| ways(mode, stay.as_deref()).into_iter().map(|(to, _)| to).collect()).collect()
    };
    let (now, healthy) = (leads(reached), leads(healthy));
    let graph = Graph::new(diagram, |mode| now[mode.index()].clone());
    let is_trap = |group: &Vec<Id<Mode>>| {
        let leaves = |leads: &[Vec<Id<Mode>>]| {
            let mut targets = group.iter().flat_map(|mode| &leads[mode.index()]);
            targets.any(|target| {
                !group.contains(target) && !is_inhibited(program, &diagram.modes[*target], &reached.faults)
            })
        };
        let is_meant = match group.as_slice() {
            [mode] => diagram.modes[*mode].is_final,
            _ => !leaves(&healthy),
        };
        reached.modes.contains_key(&group[0]) && !leaves(&now) && !is_meant
    };
    let mut traps: Vec<_> = graph.groups().into_iter().filter(is_trap).collect();
    traps.sort_unstable();
    traps
}
