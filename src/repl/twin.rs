//! Conditions that are watched though no transition has them.

use std::cell::OnceCell;

use super::session::Nobody;
use crate::interp::{Inputs, Machine};
use crate::plan::Plan;
use crate::sim;
use crate::verify::{Stretch, readings};

/// A machine that is told the same as the one that is driven, and computes one condition more.
#[derive(Debug, Clone)]
pub(super) struct Twin<'d> {
    plan: &'d Plan,
    machine: Machine<'d>,
}

impl<'d> Twin<'d> {
    /// Before its first tick, by a plan that watches one condition.
    pub(super) fn new(plan: &'d Plan, seed: u64) -> Self {
        Self { plan, machine: sim::machine(plan, seed) }
    }

    /// The same before its first tick.
    pub(super) fn afresh(&self, seed: u64) -> Self {
        Self::new(self.plan, seed)
    }

    /// One tick, so many nanoseconds after the one before.
    pub(super) fn step(&mut self, inputs: Inputs<'_>, dt: u64) {
        self.machine.step(inputs, dt, &mut Nobody);
    }

    /// Everything that was told before, in ticks of so many nanoseconds.
    pub(super) fn follow(&mut self, stretches: &[Stretch], tick: u64) {
        let mut dt = 0;
        for stretch in stretches {
            let readings = readings(&stretch.told);
            for _ in 0..stretch.ticks {
                self.step(Inputs { readings: &readings, done: stretch.done }, dt);
                dt = tick;
            }
        }
    }

    /// Whether the condition held at the end of the last tick.
    pub(super) fn holds(&self) -> bool {
        self.plan.watched.first().is_some_and(|&watched| self.machine.bool(watched))
    }
}

/// Plans that stay as long as what is driven, each in front of the next.
#[derive(Debug, Default)]
pub(super) struct Plans(OnceCell<(Plan, Box<Plans>)>);

impl Plans {
    /// Keeps one more.
    pub(super) fn keep(&self, plan: Plan) -> &Plan {
        let mut last = self;
        while let Some((_, next)) = last.0.get() {
            last = next;
        }
        let (plan, _) = last.0.get_or_init(|| (plan, Box::default()));
        plan
    }
}
