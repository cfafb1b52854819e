//! The clients of an arbiter: what they propose, and who wins (Sobh §3.3).

use super::machine::{Actuators, Inputs, Machine, Reading};
use crate::kernel;
use crate::plan::{Arbiter, Plan, Ties};

/// What a client proposed on a tick, and what became of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Proposal {
    /// The action, a position in [`Plan::actions`]; `None` where it proposed nothing.
    pub action: Option<u32>,
    /// Its arguments in SI.
    pub arguments: Vec<f64>,
    /// Whether it is a new command, and not one that goes on.
    pub start: bool,
    /// Whether it was executed.
    pub won: bool,
}

impl Proposal {
    /// Whether another command was executed instead.
    pub fn lost(&self) -> bool {
        self.action.is_some() && !self.won
    }
}

impl Actuators for Proposal {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        self.action = Some(action);
        self.arguments.clear();
        self.arguments.extend_from_slice(arguments);
        self.start = start;
    }
}

/// The clients of an arbiter. They see what became of their proposals one tick later.
#[derive(Debug, Clone)]
pub(super) struct Clients<'p> {
    pub(super) machines: Vec<Machine<'p>>,
    pub(super) proposals: Vec<Proposal>,
    readings: Vec<Reading>,
    /// The priorities of what is proposed.
    levels: Vec<Option<u32>>,
}

impl<'p> Clients<'p> {
    pub(super) fn new(plan: &'p Plan, mut seed: u64) -> Self {
        let clients = plan.arbiter.iter().flat_map(|arbiter| &arbiter.clients);
        let machines: Vec<_> =
            clients.map(|client| Machine::new(&client.plan, kernel::next_random(&mut seed))).collect();
        let longest = plan.actions.iter().map(|action| action.parameters.len()).max().unwrap_or(0);
        let proposal = || Proposal { action: None, arguments: Vec::with_capacity(longest), start: false, won: false };
        let proposals = machines.iter().map(|_| proposal()).collect();
        let room = if machines.is_empty() { 0 } else { plan.inputs.len() };
        let levels = Vec::with_capacity(machines.len());
        Self { machines, proposals, readings: Vec::with_capacity(room), levels }
    }

    /// One tick of every client.
    pub(super) fn propose(&mut self, arbiter: &Arbiter, inputs: Inputs<'_>, dt: u64) {
        self.readings.clear();
        self.readings.extend_from_slice(inputs.readings);
        for (machine, proposal) in self.machines.iter_mut().zip(&mut self.proposals) {
            for (input, truth) in [(arbiter.won, proposal.won), (arbiter.lost, proposal.lost())] {
                if let Some(reading) = input.and_then(|input| self.readings.get_mut(input as usize)) {
                    *reading = Reading { value: f64::from(u8::from(truth)), healthy: true };
                }
            }
            // What has completed was the command that was executed.
            let inputs = Inputs { readings: &self.readings, done: inputs.done && proposal.won };
            proposal.action = None;
            machine.step(inputs, dt, proposal);
        }
    }

    /// Who wins of those that propose something, each with its priority.
    pub(super) fn choose(
        &mut self,
        priorities: impl Iterator<Item = Option<u32>>,
        ties: Ties,
        random: &mut u64,
    ) -> Option<usize> {
        self.levels.clear();
        self.levels.extend(self.proposals.iter().zip(priorities).map(|(proposal, level)| proposal.action.and(level)));
        match ties {
            Ties::InOrder => kernel::first_choice(&self.levels),
            Ties::Random => kernel::any_choice(&self.levels, random),
        }
    }

    /// Notes who won.
    pub(super) fn settle(&mut self, winner: Option<usize>) {
        for (place, proposal) in self.proposals.iter_mut().enumerate() {
            proposal.won = winner == Some(place);
        }
    }
}
