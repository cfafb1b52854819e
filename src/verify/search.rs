//! Looks for a run that refutes a property, by running the machine: breadth first, over what it can be told.

use std::collections::HashMap;

use super::told::{Cues, Stretch, Told, readings};
use crate::interp::{Inputs, Machine, Phase, Reading};
use crate::ir::Claim;
use crate::plan::Plan;

/// More ticks than this are not tried,
const MOST_TICKS: usize = 1 << 16;
/// nor more than compute so many values,
const MOST_WORK: usize = 1 << 23;
/// nor longer runs than this many ticks.
const LONGEST: u64 = 1 << 20;

/// What has been seen of a claim up to a tick.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Monitor {
    /// When the earliest cause was that has no effect yet, in nanoseconds.
    pub(super) since: Option<u64>,
}

impl Monitor {
    /// Whether the tick at `time` refutes the claim, whose conditions the plan watches.
    pub(super) fn sees(&mut self, claim: Claim, plan: &Plan, machine: &Machine<'_>, time: u64) -> bool {
        let holds = |index: usize| plan.watched.get(index).is_some_and(|watched| machine.bool(*watched));
        match claim {
            Claim::Never(_) => holds(0),
            Claim::Always(_) => !holds(0),
            Claim::LeadsTo(response) => {
                if holds(0) {
                    self.since = self.since.or(Some(time));
                }
                if holds(1) {
                    self.since = None;
                }
                self.since.is_some_and(|since| time - since >= response.within)
            }
        }
    }
}

/// Commands go nowhere.
pub(super) struct Unheard;

impl crate::interp::Actuators for Unheard {
    fn command(&mut self, _action: u32, _arguments: &[f64], _start: bool) {}
}

#[derive(Clone)]
struct Node<'p> {
    machine: Machine<'p>,
    monitor: Monitor,
    /// Nanoseconds at its tick.
    time: u64,
    /// What led here from which node; none before the first tick.
    way: Option<(usize, Stretch)>,
}

struct Search<'p> {
    plan: &'p Plan,
    claim: Claim,
    /// Nanoseconds.
    tick: u64,
    nodes: Vec<Node<'p>>,
    /// How long a cause has been waiting at most in each phase.
    known: HashMap<(Phase, bool), u64>,
    steps: usize,
}

/// What came of a search.
pub(super) enum Found {
    /// A run of few stretches that refutes the claim.
    Run(Vec<Stretch>),
    /// There is none with what was tried.
    Nothing,
    /// There is too much to try.
    TooMuch,
}

/// Looks for a run with ticks of one length, in nanoseconds.
pub(super) fn search(plan: &Plan, claim: Claim, tick: u64, cues: &Cues) -> Found {
    let first = Node { machine: Machine::new(plan, 0), monitor: Monitor::default(), time: 0, way: None };
    let mut search = Search { plan, claim, tick, nodes: vec![first], known: HashMap::new(), steps: 0 };
    let most = MOST_TICKS.min(MOST_WORK / plan.code.steps.len().max(1));
    let mut next = 0;
    while next < search.nodes.len() {
        if search.steps > most {
            return Found::TooMuch;
        }
        let node = &search.nodes[next];
        let phase = node.machine.phase(tick);
        let now = node.way.as_ref().map_or(&cues.rest, |(_, stretch)| &stretch.told).clone();
        let tried = cues.of_mode.get(node.machine.mode() as usize).map_or(&[][..], Vec::as_slice);
        // What changes nothing is tried first, so that readings change only where they must.
        let told = tried.iter().map(|cue| (cues.apply(&now, cue), cue.done));
        for (told, done) in std::iter::once((now.clone(), false)).chain(told) {
            if let Some(found) = search.follow(next, &phase, &told, done) {
                return Found::Run(found);
            }
        }
        next += 1;
    }
    Found::Nothing
}

impl<'p> Search<'p> {
    /// Tells the machine something for one tick and, if nothing comes of it, until time changes something. Answers a run
    /// that refutes.
    fn follow(&mut self, from: usize, before: &Phase, told: &Told, done: bool) -> Option<Vec<Stretch>> {
        let readings = readings(told);
        let stretch = |ticks| Stretch { told: told.clone(), done, ticks };
        let mut node = self.nodes[from].clone();
        let is_first = node.way.is_none();
        if is_first && done {
            return None;
        }
        let waiting = node.monitor.since;
        if self.refutes(&mut node, &readings, done, if is_first { 0 } else { self.tick }) {
            return Some(self.path(from, stretch(1)));
        }
        let phase = node.machine.phase(self.tick);
        if is_first || done || phase != *before || node.monitor.since != waiting {
            self.add(&node, phase, (from, stretch(1)));
            return None;
        }
        // What was told once more changes nothing more.
        let waits = self.waits(&node)?;
        if self.refutes(&mut node, &readings, done, waits * self.tick) {
            return Some(self.path(from, stretch(1 + waits)));
        }
        let phase = node.machine.phase(self.tick);
        self.add(&node, phase, (from, stretch(1 + waits)));
        None
    }

    /// One tick; whether it refutes the claim.
    fn refutes(&mut self, node: &mut Node<'p>, readings: &[Reading], done: bool, dt: u64) -> bool {
        self.steps += 1;
        node.machine.step(Inputs { readings, done }, dt, &mut Unheard);
        node.time += dt;
        node.monitor.sees(self.claim, self.plan, &node.machine, node.time)
    }

    /// How many ticks pass before one on which a timer expires, or up to the one on which an effect is late.
    fn waits(&self, node: &Node<'_>) -> Option<u64> {
        let expiry = node.machine.next_expiry().map(|left| left.div_ceil(self.tick) - 1);
        let late = match (self.claim, node.monitor.since) {
            (Claim::LeadsTo(response), Some(since)) => {
                Some((response.within - (node.time - since)).div_ceil(self.tick))
            }
            _ => None,
        };
        let waits = expiry.into_iter().chain(late).min().filter(|ticks| *ticks > 0)?;
        (node.time / self.tick + waits < LONGEST).then_some(waits)
    }

    /// Keeps a node that does something new: of two in one phase the one whose cause waits longer.
    fn add(&mut self, node: &Node<'p>, phase: Phase, way: (usize, Stretch)) {
        let waiting = node.monitor.since.map_or(0, |since| node.time - since);
        let key = (phase, node.monitor.since.is_some());
        if self.known.get(&key).is_none_or(|known| *known < waiting) {
            self.known.insert(key, waiting);
            self.nodes.push(Node { way: Some(way), ..node.clone() });
        }
    }

    fn path(&self, from: usize, last: Stretch) -> Vec<Stretch> {
        let mut path = vec![last];
        let mut at = from;
        while let Some((before, stretch)) = &self.nodes[at].way {
            path.push(stretch.clone());
            at = *before;
        }
        path.reverse();
        path
    }
}
