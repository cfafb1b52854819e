//! Everything a diagram can do while conditions are watched: a graph of where the machine can be after each tick.
//!
//! Whatever a sensor can read and whichever sensors have failed, on any tick, is followed; what is known of the past is
//! not, beyond timers and counters. So the graph has every run, and some that cannot be.

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use super::dwell::{Clock, Gates, State};
use super::examined::fault_sets;
use super::faults::FaultSet;
use super::formula::{Atom, Formula};
use super::ticks::{Scene, Tick, feasible};
use crate::base::Id;
use crate::ir::{Expr, Mode, Program};

/// There are too many cases to look into.
pub(super) struct TooLarge;

/// More places than this are not looked into.
const MOST_NODES: usize = 1 << 13;
/// Nor more ways between them.
const MOST_EDGES: usize = 1 << 18;

/// Where the machine is at the end of a tick.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct Node {
    pub(super) mode: Id<Mode>,
    /// The thresholds passed and the edges counted by then.
    pub(super) state: State,
    /// Whether the tick entered the mode.
    pub(super) entered: bool,
    /// A bit for each watched condition that holds.
    pub(super) holds: u64,
}

/// What the next tick can lead to.
pub(super) struct Edge {
    pub(super) to: usize,
    /// The thresholds of the mode before that the tick has passed.
    pub(super) passed: usize,
}

/// A mode with all that can happen in it on a tick.
struct View {
    formula: Formula,
    clock: Clock,
    cases: Vec<Case>,
}

/// A mode under one set of faults.
struct Case {
    ticks: Vec<Tick>,
    gates: Gates,
}

impl View {
    fn new(scene: &Scene<'_>, mode: Id<Mode>, watched: &[Id<Expr>], most_faults: usize) -> Option<Self> {
        let formula = Formula::watching(scene.program, scene.diagram, mode, watched)?;
        let mode = &scene.diagram.modes[mode];
        let reports_done = reports_done(scene.program, mode);
        let is_possible = |tick: &Tick| reports_done || !formula.is_done(tick.truth);
        let case = |faults: FaultSet| {
            let mut ticks = feasible(scene, &formula, &faults)?;
            ticks.retain(is_possible);
            Some(Case { gates: Gates::new(scene, mode, &faults), ticks })
        };
        let cases = fault_sets(scene, mode, &formula, most_faults)?.into_iter().map(case).collect::<Option<_>>()?;
        Some(Self { clock: Clock::new(&formula)?, cases, formula })
    }

    /// The atoms that are true at the end of a tick because of the mode the machine is in then, and of where it was before.
    fn at_end(&self, before: Option<Id<Mode>>, mode: Id<Mode>, passed: usize) -> u64 {
        let lasted = &self.clock.thresholds[..passed];
        let holds = |atom: &Atom| match atom {
            Atom::In(named) => *named == mode,
            Atom::Entered(named) => *named == mode && before != Some(*named),
            Atom::Left(named) => *named != mode && before == Some(*named),
            Atom::Lasted(duration) => lasted.contains(duration),
            _ => false,
        };
        self.formula.truth_of(holds)
    }

    /// What is watched at the end of a tick; `None` where the past contradicts it.
    fn holds(&self, truth: u64) -> Option<u64> {
        let values = self.formula.values(truth)?;
        let bits = self.formula.watched.iter().zip(0..).map(|(node, bit)| u64::from(values[*node]) << bit);
        Some(bits.sum())
    }
}

/// Whether an action of a mode reports completion.
pub(super) fn reports_done(program: &Program, mode: &Mode) -> bool {
    mode.actions.iter().chain(&mode.on_enter).any(|call| program.actions[call.action].reports_done)
}

/// The graph.
pub(super) struct Product<'s, 'a> {
    scene: &'s Scene<'a>,
    /// Nanoseconds.
    longest_tick: u64,
    /// By mode.
    views: Vec<View>,
    pub(super) nodes: Vec<Node>,
    /// By node; those that were not looked into have none.
    pub(super) edges: Vec<Vec<Edge>>,
    known: HashMap<Node, usize>,
    outcomes: HashMap<(Id<Mode>, State), Rc<Outcomes>>,
}

/// Where a tick leads, if it leaves its mode, and what is watched at its end.
type Outcomes = BTreeSet<(Option<Id<Mode>>, u64)>;

impl<'s, 'a> Product<'s, 'a> {
    pub(super) fn new(
        scene: &'s Scene<'a>,
        watched: &[Id<Expr>],
        most_faults: usize,
        longest_tick: u64,
    ) -> Result<Self, TooLarge> {
        let view = |mode| View::new(scene, mode, watched, most_faults).ok_or(TooLarge);
        let views = scene.diagram.modes.ids().map(view).collect::<Result<_, _>>()?;
        let (known, outcomes) = (HashMap::new(), HashMap::new());
        Ok(Self { scene, longest_tick, views, nodes: Vec::new(), edges: Vec::new(), known, outcomes })
    }

    /// Follows every tick from the first on, up to a place of which `ends` says so; answers that place.
    pub(super) fn explore(&mut self, ends: impl Fn(&Node) -> bool) -> Result<Option<usize>, TooLarge> {
        self.begin();
        let (mut next, mut edges) = (0, 0);
        while next < self.nodes.len() {
            if ends(&self.nodes[next]) {
                return Ok(Some(next));
            }
            let found = self.follow(next);
            edges += found.len();
            self.edges.push(found);
            if self.nodes.len() > MOST_NODES || edges > MOST_EDGES {
                return Err(TooLarge);
            }
            next += 1;
        }
        Ok(None)
    }

    /// The first tick enters the entry mode, whatever is read on it.
    fn begin(&mut self) {
        let Some(entry) = self.scene.diagram.entry else { return };
        let view = &self.views[entry.index()];
        let mut found = BTreeSet::new();
        for state in view.clock.counted(&view.clock.start()) {
            let held = view.clock.truth(&view.formula, &state) | view.at_end(None, entry, 0);
            let ticks = view.cases.iter().flat_map(|case| &case.ticks);
            let first = ticks.filter(|tick| !view.formula.is_done(tick.truth));
            found.extend(first.filter_map(|tick| view.holds(tick.truth | held)));
        }
        for holds in found {
            self.enter(entry, holds);
        }
    }

    fn enter(&mut self, mode: Id<Mode>, holds: u64) -> usize {
        let state = self.views[mode.index()].clock.start();
        self.node(Node { mode, state, entered: true, holds })
    }

    fn node(&mut self, node: Node) -> usize {
        let next = self.nodes.len();
        let index = *self.known.entry(node.clone()).or_insert(next);
        if index == next {
            self.nodes.push(node);
        }
        index
    }

    /// Every tick from a place.
    fn follow(&mut self, node: usize) -> Vec<Edge> {
        let node = self.nodes[node].clone();
        let mut edges = Vec::new();
        for state in self.next_states(&node) {
            let passed = state.0;
            for &(target, holds) in self.outcomes(node.mode, &state).iter() {
                let to = match target {
                    Some(target) => self.enter(target, holds),
                    None => self.node(Node { mode: node.mode, state: state.clone(), entered: false, holds }),
                };
                edges.push(Edge { to, passed });
            }
        }
        edges
    }

    /// The timers and counters that the next tick can find. It passes no more thresholds than it is long.
    fn next_states(&self, node: &Node) -> Vec<State> {
        let clock = &self.views[node.mode.index()].clock;
        let (passed, counts) = &node.state;
        let latest = self.latest(node).map_or(u64::MAX, |dwell| dwell.saturating_add(self.longest_tick));
        let further = clock.thresholds[*passed..].iter().take_while(|threshold| **threshold <= latest).count();
        (*passed..=passed + further).flat_map(|passed| clock.counted(&(passed, counts.clone()))).collect()
    }

    /// The longest that the machine can have been in its mode; `None` without an end. Nanoseconds.
    fn latest(&self, node: &Node) -> Option<u64> {
        if node.entered { Some(0) } else { self.until(node.mode, node.state.0).map(|threshold| threshold - 1) }
    }

    /// The shortest, in nanoseconds.
    pub(super) fn earliest(&self, node: &Node) -> u64 {
        node.state.0.checked_sub(1).and_then(|last| self.until(node.mode, last)).unwrap_or(0)
    }

    /// The threshold that is next when so many have been passed, in nanoseconds.
    pub(super) fn until(&self, mode: Id<Mode>, passed: usize) -> Option<u64> {
        self.views[mode.index()].clock.thresholds.get(passed).copied()
    }

    fn outcomes(&mut self, mode: Id<Mode>, state: &State) -> Rc<Outcomes> {
        if let Some(known) = self.outcomes.get(&(mode, state.clone())) {
            return Rc::clone(known);
        }
        let outcomes = Rc::new(self.select(mode, state));
        self.outcomes.insert((mode, state.clone()), Rc::clone(&outcomes));
        outcomes
    }

    fn select(&self, id: Id<Mode>, state: &State) -> Outcomes {
        let (mode, view) = (&self.scene.diagram.modes[id], &self.views[id.index()]);
        let held = view.clock.truth(&view.formula, state);
        let mut outcomes = BTreeSet::new();
        for case in &view.cases {
            for tick in &case.ticks {
                let truth = tick.truth | held;
                let target = case.gates.lost.or_else(|| {
                    let values = view.formula.claimed(truth);
                    let is_set = |(root, open): &(&usize, &bool)| values[**root] && **open;
                    let taken = view.formula.roots.iter().zip(&case.gates.open).position(|exit| is_set(&exit));
                    taken.and_then(|index| mode.transitions[index].target)
                });
                let (end, passed) = target.map_or((id, state.0), |target| (target, 0));
                let end = view.at_end(Some(id), end, passed);
                outcomes.extend(view.holds(truth | end).map(|holds| (target, holds)));
            }
        }
        outcomes
    }
}
