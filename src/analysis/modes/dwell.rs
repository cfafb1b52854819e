//! One mode under one set of faults: which exits are taken, tick by tick, timer by timer.
//!
//! A mode's thresholds of `after` and its counters cut its stay into states. The machine gets from one state to a
//! later one if some feasible tick takes no exit. Ticks are taken to be shorter than the time between two thresholds.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::faults::{self, FaultSet};
use super::formula::{Atom, Formula};
use super::steady;
use super::ticks::{Scene, Tick, feasible};
use crate::base::{Exact, Id};
use crate::ir::{Mode, Sensor};

/// What can happen in a mode.
#[derive(Debug, Clone, Default)]
pub(super) struct Stay {
    /// Its transitions in order.
    pub(super) exits: Vec<Exit>,
    /// Whether some first tick takes no exit.
    pub(super) lasts: bool,
    /// Where the machine goes at once because a required sensor has failed; no exit is then tried.
    pub(super) lost: Option<Id<Mode>>,
    /// Where it can be before a tick.
    pub(super) states: BTreeSet<State>,
}

/// What can happen to a transition.
#[derive(Debug, Clone, Default)]
pub(super) struct Exit {
    /// How it is taken, if it can be.
    pub(super) taken: Option<Way>,
    /// Whether its condition holds on some tick of the mode.
    pub(super) holds: bool,
    /// Whether its condition fails on some tick of the mode.
    pub(super) fails: bool,
    /// Whether its condition would hold after a time that the mode never lasts.
    pub(super) holds_later: bool,
    /// For each kind of tick on which its condition holds: the transitions before it that could be taken, as bits.
    pub(super) masks: BTreeSet<u64>,
}

/// A way through a mode.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Way {
    /// Not excluded, but no readings are known that go it.
    Open,
    /// Ticks after the one that entered the mode. The last one takes the exit.
    Shown(Vec<Moment>),
}

/// What the machine is told on a tick.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moment {
    /// Nanoseconds since the mode was entered.
    pub dwell: u64,
    /// Whether the mode's action reports completion.
    pub done: bool,
    /// Readings in SI; those of other sensors do not matter.
    pub readings: Vec<(Id<Sensor>, Exact)>,
}

/// More states than this are not looked into.
const MOST_STATES: usize = 1 << 10;
/// Counters are followed up to here.
const MOST_EDGES: i128 = 64;

/// A stretch of a mode: the thresholds passed, and the edges counted.
pub(super) type State = (usize, Vec<u32>);

/// Where a mode can be left for under one set of faults.
#[derive(PartialEq)]
pub(super) struct Gates {
    /// For each transition whether its target is not inhibited.
    pub(super) open: Vec<bool>,
    /// Where the machine goes at once because a required sensor has failed; no exit is then tried.
    pub(super) lost: Option<Id<Mode>>,
}

impl Gates {
    pub(super) fn new(scene: &Scene<'_>, mode: &Mode, faults: &FaultSet) -> Self {
        let is_failed = |sensor| faults::is_reported(scene.program, faults, sensor);
        let fails = |mode: &Mode| mode.requires.iter().any(|(sensor, _)| is_failed(*sensor));
        let inhibited = |target: Id<Mode>| fails(&scene.diagram.modes[target]);
        let lost = mode.otherwise.filter(|otherwise| fails(mode) && !inhibited(*otherwise));
        let open = mode.transitions.iter().map(|transition| !transition.target.is_some_and(inhibited)).collect();
        Self { open, lost }
    }
}

/// A mode under one set of faults.
pub(super) struct Case {
    ticks: Vec<Tick>,
    gates: Gates,
}

impl Case {
    /// `None` where there are too many ticks to look into.
    pub(super) fn new(scene: &Scene<'_>, mode: &Mode, formula: &Formula, faults: &FaultSet) -> Option<Self> {
        let gates = Gates::new(scene, mode, faults);
        // Where the machine goes elsewhere at once, no exit is tried on any tick.
        let ticks = if gates.lost.is_some() { Vec::new() } else { feasible(scene, formula, faults)? };
        Some(Self { ticks, gates })
    }

    /// Whether the same can happen as under other faults.
    pub(super) fn is_like(&self, other: &Self) -> bool {
        let truths = |case: &Self| {
            let mut truths: Vec<_> = case.ticks.iter().map(|tick| tick.truth).collect();
            truths.sort_unstable();
            truths
        };
        self.gates == other.gates && self.ticks.len() == other.ticks.len() && truths(self) == truths(other)
    }
}

/// What can happen in a mode on ticks that are each of one of these cases, from its entry on and from where it may have
/// been `before` the last sensor failed. Ticks are shown from the entry on, for the first case alone. `None` where there
/// is too much to look into.
pub(super) fn stay(formula: &Formula, cases: &[Rc<Case>], before: &BTreeSet<State>) -> Option<Stay> {
    let clock = Clock::new(formula)?;
    let lost = cases.first().and_then(|case| case.gates.lost);
    let exits = vec![Exit::default(); formula.roots.len()];
    let mut stay = Stay { exits, lasts: false, lost, states: BTreeSet::new() };

    let start = clock.start();
    // The count of the first tick may already be 1: the edge on the tick of entry is before, the next one is not.
    let mut waiting = clock.counted(&start);
    let firsts = waiting.len();
    let mut found: BTreeMap<State, Option<Vec<Moment>>> = waiting.iter().map(|state| (state.clone(), None)).collect();
    found.insert(start, Some(Vec::new()));
    let mut before = before.iter();
    let mut values = Vec::with_capacity(formula.nodes.len());
    let mut next = 0;
    loop {
        // What is shown comes first, so that it is found first.
        let Some(state) = waiting.get(next).cloned() else {
            let Some(state) = before.next() else { break };
            if !found.contains_key(state) {
                found.insert(state.clone(), None);
                waiting.push(state.clone());
            }
            continue;
        };
        let path = found.get(&state).cloned().flatten();
        let held = clock.truth(formula, &state);
        let mut stays: Option<Option<Vec<Moment>>> = None;
        for (position, case) in cases.iter().enumerate() {
            let path = path.as_ref().filter(|_| position == 0);
            for tick in &case.ticks {
                if !formula.write_values(tick.truth | held, &mut values) {
                    continue;
                }
                let extended = || extended(path?, clock.starts(state.0), formula, tick, &values);
                stay.note(formula, &values, &case.gates.open, || extended().map_or(Way::Open, Way::Shown));
                let taken = formula.roots.iter().zip(&case.gates.open).any(|(root, open)| values[*root] && *open);
                if !taken && !matches!(stays, Some(Some(_))) {
                    stays = Some(extended());
                }
            }
        }
        if path.as_ref().is_some_and(Vec::is_empty) {
            stay.wait(formula, &cases[0], &[], 0);
        }
        if let Some(Some(clear)) = &stays {
            stay.wait(formula, &cases[0], clear, clock.starts(state.0));
        }
        if let Some(path) = stays {
            stay.lasts |= next < firsts;
            for later in clock.later(&state) {
                let is_shown = later.1 == state.1;
                if !found.contains_key(&later) {
                    found.insert(later.clone(), path.clone().filter(|_| is_shown));
                    waiting.push(later);
                }
            }
        }
        if found.len() > MOST_STATES {
            return None;
        }
        next += 1;
    }
    for state in clock.all().filter(|state| !found.contains_key(state)) {
        let held = clock.truth(formula, &state);
        for values in cases.iter().flat_map(|case| &case.ticks).filter_map(|tick| formula.values(tick.truth | held)) {
            for (exit, root) in stay.exits.iter_mut().zip(&formula.roots) {
                exit.holds_later |= values[*root];
            }
        }
    }
    stay.states = found.into_keys().collect();
    Some(stay)
}

/// The path and one more tick, where readings are known for it.
fn extended(path: &[Moment], dwell: u64, formula: &Formula, tick: &Tick, values: &[bool]) -> Option<Vec<Moment>> {
    if !formula.looks_at_nothing(tick.truth, values, path.is_empty()) {
        return None;
    }
    let readings = tick.readings.clone()?;
    let done = formula.is_done(tick.truth);
    let mut path = path.to_vec();
    path.push(Moment { dwell, done, readings });
    Some(path)
}

impl Stay {
    /// Notes the exits that are taken if the readings of some tick stay, from so many nanoseconds in the mode on. On the
    /// ticks before nothing was true that is remembered.
    fn wait(&mut self, formula: &Formula, case: &Case, before: &[Moment], dwell: u64) {
        let is_settled = |exit: &Exit| matches!(exit.taken, None | Some(Way::Shown(_)));
        let past = formula.truth_of(|atom| matches!(atom, Atom::Past(..) | Atom::Open(_)));
        for tick in case.ticks.iter().filter(|tick| tick.truth & past == 0) {
            if self.exits.iter().all(is_settled) {
                return;
            }
            let Some(readings) = &tick.readings else { continue };
            let is_entered = before.is_empty();
            let taken = steady::exit(formula, tick.truth, dwell, is_entered, &case.gates.open);
            let Some((exit, times)) = taken.filter(|(exit, _)| !is_settled(&self.exits[*exit])) else { continue };
            let done = formula.is_done(tick.truth);
            let moment = |time| Moment { dwell: dwell.saturating_add(time), done, readings: readings.clone() };
            self.exits[exit].taken =
                Some(Way::Shown(before.iter().cloned().chain(times.into_iter().map(moment)).collect()));
        }
    }

    /// Notes what a tick does.
    fn note(&mut self, formula: &Formula, values: &[bool], open: &[bool], way: impl Fn() -> Way) {
        let mut before = 0_u64;
        for (index, exit) in self.exits.iter_mut().enumerate() {
            if !values[formula.roots[index]] {
                exit.fails = true;
                continue;
            }
            exit.holds = true;
            exit.masks.insert(before);
            if !open[index] {
                continue;
            }
            if before == 0 && exit.taken.as_ref().is_none_or(|taken| *taken == Way::Open) {
                exit.taken = Some(way());
            }
            before |= 1 << index.min(63);
        }
    }
}

/// The thresholds and counters of a mode.
#[derive(Debug, Clone)]
pub struct Clock {
    /// Nanoseconds, ascending, each above 0.
    pub thresholds: Vec<u64>,
    /// Counted nodes, and the number past which nothing changes.
    pub counters: Vec<(usize, u32)>,
}

impl Clock {
    /// `None` where a counter is compared with more than is followed.
    pub(super) fn new(formula: &Formula) -> Option<Self> {
        let mut thresholds = BTreeSet::new();
        let mut counters: BTreeMap<usize, u32> = BTreeMap::new();
        for atom in &formula.atoms {
            match atom {
                Atom::After(duration) | Atom::Lasted(duration) => {
                    thresholds.insert(*duration);
                }
                Atom::Count(_, of, number) => {
                    let most = number.ratio().to_integer().clamp(0, MOST_EDGES + 1);
                    if most > MOST_EDGES || number.pi_power() != 0 {
                        return None;
                    }
                    let limit = counters.entry(*of).or_default();
                    *limit = (*limit).max(most as u32 + 1);
                }
                _ => {}
            }
        }
        Some(Self { thresholds: thresholds.into_iter().collect(), counters: counters.into_iter().collect() })
    }

    /// Nothing passed, and nothing counted.
    pub(super) fn start(&self) -> State {
        (0, vec![0; self.counters.len()])
    }

    /// The timers and counters that hold in a state.
    pub(super) fn truth(&self, formula: &Formula, (passed, counts): &State) -> u64 {
        let holds = |atom: &Atom| match atom {
            Atom::After(duration) => self.thresholds[..*passed].contains(duration),
            Atom::Count(comparison, of, number) => {
                let count = self.counters.iter().zip(counts).find(|((counted, _), _)| counted == of);
                count.is_some_and(|(_, count)| comparison.holds(Exact::new(i128::from(*count), 1, 0), *number))
            }
            _ => false,
        };
        formula.truth_of(holds)
    }

    /// A time at which that many thresholds are passed.
    fn starts(&self, passed: usize) -> u64 {
        passed.checked_sub(1).and_then(|last| self.thresholds.get(last)).copied().unwrap_or(0)
    }

    /// The states in which a tick leaves the counters of a state: each as it is, or one further.
    pub(super) fn counted(&self, (passed, counts): &State) -> Vec<State> {
        let mut states = vec![(*passed, counts.clone())];
        for (index, (_, limit)) in self.counters.iter().enumerate() {
            for position in 0..states.len().min(MOST_STATES) {
                let mut further = states[position].clone();
                if further.1[index] < *limit {
                    further.1[index] += 1;
                    states.push(further);
                }
            }
        }
        states
    }

    /// The states of the next tick.
    fn later(&self, state: &State) -> Vec<State> {
        let mut states = self.counted(state);
        if state.0 < self.thresholds.len() {
            states.extend(self.counted(&(state.0 + 1, state.1.clone())));
        }
        states
    }

    /// Every stretch between thresholds, each with counters at their start and at their end.
    fn all(&self) -> impl Iterator<Item = State> {
        let (_, none) = self.start();
        let most: Vec<_> = self.counters.iter().map(|(_, limit)| *limit).collect();
        (0..=self.thresholds.len()).flat_map(move |passed| [(passed, none.clone()), (passed, most.clone())])
    }
}
