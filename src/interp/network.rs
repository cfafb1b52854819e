//! One network on its own: readings in, degrees and flags out.

use super::memory::Memory;
use super::{Inputs, Reading};
use crate::plan::{Bool, NetworkPlan, Real};

/// Evaluates a network, remembering what its events remember from one reading to the next.
#[derive(Debug, Clone)]
pub struct Evaluator<'p> {
    plan: &'p NetworkPlan,
    memory: Memory,
}

impl<'p> Evaluator<'p> {
    /// Before its first reading.
    pub fn new(plan: &'p NetworkPlan) -> Self {
        Self { plan, memory: Memory::new(&plan.code) }
    }

    /// Evaluates one reading for each input, in SI, `dt` nanoseconds after the one before.
    pub fn evaluate(&mut self, readings: &[Reading], dt: u64) {
        let code = &self.plan.code;
        let told = Inputs { readings, done: false };
        self.memory.run(code, 0..code.steps.len() as u32, &self.plan.inputs, told, dt, 0);
    }

    /// A number of the last evaluation.
    pub fn real(&self, real: Real) -> f64 {
        self.memory.real(real)
    }

    /// A truth value of the last evaluation.
    pub fn bool(&self, bool: Bool) -> bool {
        self.memory.bool(bool)
    }
}
