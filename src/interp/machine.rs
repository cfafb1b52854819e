//! The machine of a diagram: its state, and the tick.

use std::ops::Range;

use super::arbiter::{Clients, Proposal};
use super::memory::{Memory, Told};
use crate::kernel;
use crate::plan::{Arbiter, Plan, Row, Transition};

/// What a sensor says on one tick.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reading {
    /// The number in SI; anything at all, also not finite.
    pub value: f64,
    /// Whether the sensor is not known to have failed.
    pub healthy: bool,
}

/// What the machine is told on one tick.
#[derive(Debug, Clone, Copy)]
pub struct Inputs<'a> {
    /// One reading for each input of the plan, in order. Missing ones count as failed.
    pub readings: &'a [Reading],
    /// Whether the action of the active mode had reported completion by the end of the tick before.
    pub done: bool,
}

/// What carries out the machine's commands.
pub trait Actuators {
    /// Carries out an action, a position in [`Plan::actions`], with its arguments in SI. `start` is true on the tick
    /// that entered the mode, so that a repeated command can be told from a new one.
    fn command(&mut self, action: u32, arguments: &[f64], start: bool);
}

/// Why the machine is where it is after a tick.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Taken {
    /// It stayed.
    Stayed,
    /// It entered its entry mode: the first tick.
    Entered,
    /// It took a transition, a position in [`Plan::transitions`].
    Transition(u32),
    /// The robot was handed to another client, or to an emergency, or to nobody.
    Handed,
    /// It left a mode whose required input had failed.
    Lost {
        /// The mode that was left.
        from: u32,
        /// The input that failed.
        input: u32,
    },
}

/// All that the modes of the next ticks depend on besides their inputs, times only as far as the next tick can tell.
/// What outputs keep only reaches commands.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Phase {
    mode: u32,
    /// Whether each timer will have expired on the next tick.
    expired: Vec<Option<bool>>,
    memories: Vec<bool>,
    latches: Vec<bool>,
    counters: Vec<u32>,
    readings: Vec<u64>,
}

/// A diagram being run. `step` allocates nothing.
#[derive(Debug, Clone)]
pub struct Machine<'p> {
    plan: &'p Plan,
    memory: Memory<1>,
    mode: u32,
    entered: bool,
    /// The row of the mode's decision table that fitted on the tick before.
    row: Option<u32>,
    random: u64,
    arguments: Vec<f64>,
    /// The clients of an arbiter; none of anything else.
    clients: Clients<'p>,
}

impl<'p> Machine<'p> {
    /// A machine before its first tick. Everything random follows from `seed`.
    pub fn new(plan: &'p Plan, seed: u64) -> Self {
        let mut memory = Memory::new(&plan.code);
        let nothing = Told { read: |_, _| None, rows: 1, done: false, dt: 0, active: plan.entry };
        memory.run(&plan.code, plan.constants.clone(), &plan.inputs, &nothing);
        let longest = plan.calls.iter().map(|call| call.arguments.len()).max().unwrap_or(0);
        let arguments = Vec::with_capacity(longest);
        let clients = Clients::new(plan, seed);
        Self { plan, memory, mode: plan.entry, entered: false, row: None, random: seed, arguments, clients }
    }

    /// The active mode, a position in [`Plan::modes`].
    pub fn mode(&self) -> u32 {
        self.mode
    }

    /// Nanoseconds since the active mode was entered.
    pub fn dwell(&self) -> u64 {
        self.memory.dwell
    }

    /// A number of the last tick.
    pub fn real(&self, real: crate::plan::Real) -> f64 {
        self.memory.reals(real)[0]
    }

    /// A truth value of the last tick.
    pub fn bool(&self, bool: crate::plan::Bool) -> bool {
        self.memory.bools(bool)[0]
    }

    /// One tick, `dt` nanoseconds after the one before: sense, fuse, select, act. The first tick enters the entry mode.
    pub fn step(&mut self, inputs: Inputs<'_>, dt: u64, actuators: &mut impl Actuators) -> Taken {
        let plan = self.plan;
        if self.entered {
            self.memory.dwell = self.memory.dwell.saturating_add(dt);
        }
        self.run(plan.fuse.clone(), inputs, dt);
        if let Some(arbiter) = &plan.arbiter {
            let taken = self.arbitrate(arbiter, inputs, dt, actuators);
            self.run(plan.watch.clone(), inputs, dt);
            return taken;
        }
        let taken = if self.entered { self.select(inputs, dt) } else { Taken::Entered };
        let target = match taken {
            Taken::Stayed | Taken::Handed => None,
            Taken::Entered => Some(plan.entry),
            Taken::Transition(index) => plan.transitions.get(index as usize).map(|transition| transition.target),
            Taken::Lost { .. } => self.current().otherwise,
        };
        if let Some(target) = target {
            if self.entered {
                self.call(self.current().on_exit.clone(), true, actuators);
            }
            self.enter(target);
            self.call(self.current().on_enter.clone(), true, actuators);
        }
        self.call(self.current().actions.clone(), target.is_some(), actuators);
        self.decide(inputs, dt, actuators);
        self.run(plan.watch.clone(), inputs, dt);
        taken
    }

    /// What the clients of an arbiter proposed on the last tick, and what became of it; none of anything else.
    pub fn proposals(&self) -> &[Proposal] {
        &self.clients.proposals
    }

    /// The machine of a client, by its position.
    pub fn client(&self, position: usize) -> Option<&Self> {
        self.clients.machines.get(position)
    }

    /// Lets every client propose, and one of them or an emergency command the robot.
    fn arbitrate(
        &mut self,
        arbiter: &'p Arbiter,
        inputs: Inputs<'_>,
        dt: u64,
        actuators: &mut impl Actuators,
    ) -> Taken {
        self.clients.propose(arbiter, inputs, dt);
        let priorities = arbiter.clients.iter().map(|client| {
            let holds =
                |(_, when): &&(u32, Option<crate::plan::Bool>)| when.is_none_or(|when| self.memory.bools(when)[0]);
            client.priorities.iter().find(holds).map(|(level, _)| *level)
        });
        let winner = self.clients.choose(priorities, arbiter.ties, &mut self.random);
        let emergency = arbiter.emergencies.iter().find(|emergency| self.memory.bools(emergency.condition)[0]);
        let (before, had) = (self.mode, self.entered);
        self.mode = match (emergency, winner) {
            (Some(_), _) => Arbiter::EMERGENCY,
            (None, Some(winner)) => Arbiter::OTHERS + winner as u32,
            (None, None) => Arbiter::NOBODY,
        };
        let changed = !had || before != self.mode;
        if changed {
            self.entered = true;
            self.memory.enter_mode();
        }
        self.clients.settle(emergency.is_none().then_some(winner).flatten());
        match emergency {
            Some(emergency) => self.call(emergency.call..emergency.call + 1, changed, actuators),
            None => {
                if let Some(Proposal { action: Some(action), arguments, start, .. }) =
                    winner.and_then(|winner| self.clients.proposals.get(winner))
                {
                    actuators.command(*action, arguments, *start || changed);
                }
            }
        }
        match (had, changed) {
            (false, _) => Taken::Entered,
            (true, true) => Taken::Handed,
            (true, false) => Taken::Stayed,
        }
    }

    /// Where it is, for a next tick `dt` nanoseconds later. Two machines of one plan in one phase do the same on it.
    pub fn phase(&self, dt: u64) -> Phase {
        let (memories, latches, counters) = self.memory.past();
        Phase {
            mode: self.mode,
            expired: self.timers().map(|left| left.map(|left| left <= dt)).collect(),
            memories: memories.to_vec(),
            latches: latches.to_vec(),
            counters: counters.to_vec(),
            readings: self.memory.kept_readings().collect(),
        }
    }

    /// Nanoseconds until the next timer expires, if one runs.
    pub fn next_expiry(&self) -> Option<u64> {
        self.timers().flatten().filter(|left| *left > 0).min()
    }

    /// What is left on the timer of every step that may run while the mode lasts.
    fn timers(&self) -> impl Iterator<Item = Option<u64>> {
        let Plan { code, fuse, watch, transitions, .. } = self.plan;
        let exits = transitions[range(&self.current().transitions)].iter().map(|exit| &exit.steps);
        let steps = [fuse, watch].into_iter().chain(exits).flat_map(|steps| &code.steps[range(steps)]);
        steps.map(|step| self.memory.left(step))
    }

    fn current(&self) -> &'p crate::plan::Mode {
        &self.plan.modes[self.mode as usize]
    }

    fn run(&mut self, steps: Range<u32>, inputs: Inputs<'_>, dt: u64) {
        let read = |input: u32, _| inputs.readings.get(input as usize).copied();
        let told = Told { read, rows: 1, done: inputs.done, dt, active: self.mode };
        self.memory.run(&self.plan.code, steps, &self.plan.inputs, &told);
    }

    /// The first input that a mode requires and that has failed.
    fn missing(&self, mode: u32, inputs: Inputs<'_>) -> Option<u32> {
        let required = &self.plan.modes[mode as usize].required;
        let failed = |input: &u32| !inputs.readings.get(*input as usize).is_some_and(|reading| reading.healthy);
        self.plan.required[required.start as usize..required.end as usize].iter().copied().find(failed)
    }

    fn select(&mut self, inputs: Inputs<'_>, dt: u64) -> Taken {
        if let (Some(input), Some(otherwise)) = (self.missing(self.mode, inputs), self.current().otherwise)
            && self.missing(otherwise, inputs).is_none()
        {
            return Taken::Lost { from: self.mode, input };
        }
        for index in self.current().transitions.clone() {
            let Transition { steps, condition, target, .. } = &self.plan.transitions[index as usize];
            self.run(steps.clone(), inputs, dt);
            if self.memory.bools(*condition)[0] && self.missing(*target, inputs).is_none() {
                return Taken::Transition(index);
            }
        }
        Taken::Stayed
    }

    fn enter(&mut self, mode: u32) {
        self.mode = mode;
        self.entered = true;
        self.row = None;
        self.memory.enter_mode();
        self.draw(&self.current().draws);
    }

    fn draw(&mut self, draws: &Range<u32>) {
        for draw in &self.plan.draws[range(draws)] {
            let drawn = kernel::draw(&mut self.random, draw.low, draw.high);
            self.memory.set_reals(draw.to, |_, _| drawn);
        }
    }

    /// Gives the command of the row of the mode's decision table that fits.
    fn decide(&mut self, inputs: Inputs<'_>, dt: u64, actuators: &mut impl Actuators) {
        let plan = self.plan;
        for index in self.current().rows.clone() {
            let Row { steps, condition, calls, pick, draws, .. } = &plan.rows[index as usize];
            self.run(steps.clone(), inputs, dt);
            if !self.memory.bools(*condition)[0] {
                continue;
            }
            let begins = self.row != Some(index);
            if begins {
                self.row = Some(index);
                self.draw(draws);
            }
            let calls = match pick {
                None => calls.clone(),
                Some(pick) => {
                    let picked = (calls.start + self.memory.reals(*pick)[0] as u32).min(calls.end - 1);
                    picked..picked + 1
                }
            };
            return self.call(calls, begins, actuators);
        }
    }

    fn call(&mut self, calls: Range<u32>, start: bool, actuators: &mut impl Actuators) {
        for call in &self.plan.calls[range(&calls)] {
            self.arguments.clear();
            let arguments = &self.plan.arguments[range(&call.arguments)];
            self.arguments.extend(arguments.iter().map(|&real| self.memory.reals(real)[0]));
            actuators.command(call.action, &self.arguments, start);
        }
    }
}

fn range(range: &Range<u32>) -> Range<usize> {
    range.start as usize..range.end as usize
}
