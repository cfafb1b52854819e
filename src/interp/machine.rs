//! The machine of a diagram: its state, and the tick.

use std::ops::Range;

use super::arbiter::{Clients, Proposal};
use super::memory::{Memory, Told};
use crate::kernel;
use crate::plan::{self, Arbiter, Plan, Row, Transition};

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
    /// Of what runs inside its modes, where that can matter again.
    inner: Vec<Option<Self>>,
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
    /// What runs inside each mode.
    inner: Vec<Option<Self>>,
    /// The active modes, from its own inward, as far as a condition asks for them.
    path: Vec<u32>,
    taken: Taken,
    /// Nanoseconds that the mode of the tick before had been active when this tick chose.
    lasted: u64,
}

impl<'p> Machine<'p> {
    /// A machine before its first tick. Everything random follows from `seed`.
    pub fn new(plan: &'p Plan, seed: u64) -> Self {
        let mut memory = Memory::new(&plan.code);
        let nothing = Told { read: |_, _| None, rows: 1, done: false, dt: 0, active: plan.entry, path: &[] };
        memory.run(&plan.code, plan.constants.clone(), &plan.inputs, &nothing);
        let longest = plan.calls.iter().map(|call| call.arguments.len()).max().unwrap_or(0);
        let arguments = Vec::with_capacity(longest);
        let clients = Clients::new(plan, seed);
        let inner = |run: plan::Run| Self::new(&plan.inner[run.inner as usize], 0);
        let inner: Vec<_> = plan.modes.iter().map(|mode| mode.runs.map(inner)).collect();
        let path = Vec::with_capacity(plan.code.paths.len());
        let (mode, taken) = (plan.entry, Taken::Stayed);
        Self {
            plan,
            memory,
            mode,
            entered: false,
            row: None,
            random: seed,
            arguments,
            clients,
            inner,
            path,
            taken,
            lasted: 0,
        }
    }

    /// Back to before the first tick.
    fn restart(&mut self, seed: u64) {
        (self.mode, self.entered, self.row, self.random) = (self.plan.entry, false, None, seed);
        self.memory.restart(&self.plan.code);
        self.inner.iter_mut().flatten().for_each(|inner| inner.restart(0));
    }

    /// The active mode, a position in [`Plan::modes`].
    pub fn mode(&self) -> u32 {
        self.mode
    }

    /// The diagram it runs.
    pub fn plan(&self) -> &'p Plan {
        self.plan
    }

    /// What runs inside the active mode.
    pub fn inner(&self) -> Option<&Self> {
        self.inner.get(self.mode as usize)?.as_ref().filter(|inner| inner.entered)
    }

    /// Why it is where it is since the last tick.
    pub fn taken(&self) -> Taken {
        self.taken
    }

    /// How long the mode before had been active when the last tick chose, ns.
    pub fn lasted(&self) -> u64 {
        self.lasted
    }

    /// Where it is, from its own mode inward: `explore.forward`.
    pub fn place(&self) -> String {
        let name = &self.current().name;
        self.inner().map_or_else(|| name.clone(), |inner| format!("{name}.{}", inner.place()))
    }

    /// Whether it or what runs inside it has entered a mode on the last tick.
    pub fn has_moved(&self) -> bool {
        self.taken != Taken::Stayed || self.inner().is_some_and(Self::has_moved)
    }

    /// Nanoseconds since the active mode was entered.
    pub fn dwell(&self) -> u64 {
        self.memory.dwell
    }

    /// A number of the last tick.
    pub fn real(&self, real: plan::Real) -> f64 {
        self.memory.reals(real)[0]
    }

    /// A number of the last tick, or a truth value as 1 or 0.
    pub fn value(&self, value: plan::Value) -> f64 {
        match value {
            plan::Value::Truth(value) => f64::from(u8::from(self.bool(value))),
            plan::Value::Number(value) => self.real(value),
        }
    }

    /// A truth value of the last tick.
    pub fn bool(&self, bool: plan::Bool) -> bool {
        self.memory.bools(bool)[0]
    }

    /// One tick, `dt` nanoseconds after the one before: sense, fuse, select, act. The first tick enters the entry mode.
    pub fn step<A: Actuators>(&mut self, inputs: Inputs<'_>, dt: u64, actuators: &mut A) -> Taken {
        let plan = self.plan;
        let told = self.sense(inputs, dt);
        if let Some(arbiter) = &plan.arbiter {
            self.taken = self.arbitrate(arbiter, inputs, dt, actuators);
            self.run(plan.watch.clone(), inputs, dt);
            return self.taken;
        }
        self.taken = if self.entered { self.select(told, dt) } else { Taken::Entered };
        let target = match self.taken {
            Taken::Stayed | Taken::Handed => None,
            Taken::Entered => Some(plan.entry),
            Taken::Transition(index) => plan.transitions.get(index as usize).map(|transition| transition.target),
            Taken::Lost { .. } => self.current().otherwise,
        };
        match target {
            Some(target) => {
                if self.entered {
                    self.drop_inner(inputs, actuators);
                    self.call(self.current().on_exit.clone(), true, actuators);
                }
                self.enter(target);
                self.begin(told, actuators);
            }
            None => {
                self.act(told, false, actuators);
                if let Some(inner) = &mut self.inner[self.mode as usize] {
                    inner.step(inputs, dt, actuators);
                }
            }
        }
        self.run(plan.watch.clone(), told, dt);
        self.taken
    }

    /// What is read on a tick, and what follows from it; answers what the machine itself is told.
    fn sense<'i>(&mut self, inputs: Inputs<'i>, dt: u64) -> Inputs<'i> {
        if self.entered {
            self.memory.dwell = self.memory.dwell.saturating_add(dt);
        }
        self.lasted = self.memory.dwell;
        let inputs = Inputs { done: self.is_done(inputs), ..inputs };
        self.run(self.plan.fuse.clone(), inputs, dt);
        inputs
    }

    /// Whether what the active mode does had completed by the end of the tick before: its action, or what runs inside it.
    fn is_done(&self, inputs: Inputs<'_>) -> bool {
        match self.current().runs {
            Some(_) => self.inner().is_some_and(|inner| inner.current().is_final),
            None => inputs.done,
        }
    }

    /// Gives the commands of a mode that has been entered, and lets begin what runs inside it.
    fn begin<A: Actuators>(&mut self, inputs: Inputs<'_>, actuators: &mut A) {
        self.call(self.current().on_enter.clone(), true, actuators);
        self.act(inputs, true, actuators);
        let Some(run) = self.current().runs else { return };
        let Some(inner) = &mut self.inner[self.mode as usize] else { return };
        // What had completed was something else.
        let inputs = Inputs { done: false, ..inputs };
        if run.resumes && inner.entered {
            inner.resume(inputs, actuators);
        } else {
            inner.restart(if inner.plan.is_random() { kernel::next_random(&mut self.random) } else { 0 });
            inner.step(inputs, 0, actuators);
        }
    }

    /// Enters the mode in which it was when it was dropped; no transition is tried on that tick.
    fn resume<A: Actuators>(&mut self, inputs: Inputs<'_>, actuators: &mut A) {
        let told = self.sense(inputs, 0);
        self.taken = Taken::Entered;
        self.enter(self.mode);
        self.begin(told, actuators);
    }

    /// Drops what runs inside the active mode: its last commands, the innermost first.
    fn drop_inner<A: Actuators>(&mut self, inputs: Inputs<'_>, actuators: &mut A) {
        let Some(inner) = &mut self.inner[self.mode as usize] else { return };
        if inner.plan.modes.iter().any(|mode| !mode.on_exit.is_empty()) {
            inner.sense(inputs, 0);
        }
        inner.drop_inner(inputs, actuators);
        inner.call(inner.current().on_exit.clone(), true, actuators);
    }

    /// Gives the commands of every tick.
    fn act(&mut self, inputs: Inputs<'_>, start: bool, actuators: &mut impl Actuators) {
        self.call(self.current().actions.clone(), start, actuators);
        self.decide(inputs, actuators);
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
            let holds = |(_, when): &&(u32, Option<plan::Bool>)| when.is_none_or(|when| self.memory.bools(when)[0]);
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
            inner: self
                .inner
                .iter()
                .zip(&self.plan.modes)
                .zip(0..)
                .map(|((inner, mode), place)| {
                    let matters = place == self.mode || mode.runs.is_some_and(|run| run.resumes);
                    inner.as_ref().filter(|inner| matters && inner.entered).map(|inner| inner.phase(dt))
                })
                .collect(),
            readings: self.memory.kept_readings().collect(),
        }
    }

    /// Nanoseconds until the next timer expires, if one runs.
    pub fn next_expiry(&self) -> Option<u64> {
        let inner = self.inner().and_then(Self::next_expiry);
        self.timers().flatten().filter(|left| *left > 0).chain(inner).min()
    }

    /// What is left on the timer of every step that may run while the mode lasts.
    fn timers(&self) -> impl Iterator<Item = Option<u64>> {
        let Plan { code, fuse, watch, transitions, .. } = self.plan;
        let exits = transitions[range(&self.current().transitions)].iter().map(|exit| &exit.steps);
        let steps = [fuse, watch].into_iter().chain(exits).flat_map(|steps| &code.steps[range(steps)]);
        steps.map(|step| self.memory.left(step))
    }

    fn current(&self) -> &'p plan::Mode {
        &self.plan.modes[self.mode as usize]
    }

    fn run(&mut self, steps: Range<u32>, inputs: Inputs<'_>, dt: u64) {
        let read = |input: u32, _| inputs.readings.get(input as usize).copied();
        self.note_path();
        let told = Told { read, rows: 1, done: inputs.done, dt, active: self.mode, path: &self.path };
        self.memory.run(&self.plan.code, steps, &self.plan.inputs, &told);
    }

    /// Notes where it is and what runs inside it, where a condition asks for that.
    fn note_path(&mut self) {
        self.path.clear();
        if self.plan.code.paths.is_empty() || !self.entered {
            return;
        }
        let mut path = std::mem::take(&mut self.path);
        let mut here: Option<&Self> = Some(self);
        while let Some(machine) = here {
            path.push(machine.mode);
            here = machine.inner();
        }
        self.path = path;
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
    fn decide(&mut self, inputs: Inputs<'_>, actuators: &mut impl Actuators) {
        let plan = self.plan;
        for index in self.current().rows.clone() {
            let Row { steps, condition, calls, pick, draws, .. } = &plan.rows[index as usize];
            self.run(steps.clone(), inputs, 0);
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
