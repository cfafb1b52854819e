//! One network on its own: readings in, degrees and flags out, one at a time or in columns.

use super::Reading;
use super::memory::{Memory, Told};
use crate::plan::{Bool, NetworkPlan, Real};

/// Evaluates a network, remembering what its events remember from one reading to the next.
#[derive(Debug, Clone)]
pub struct Evaluator<'p> {
    plan: &'p NetworkPlan,
    memory: Memory<1>,
}

impl<'p> Evaluator<'p> {
    /// Before its first reading.
    pub fn new(plan: &'p NetworkPlan) -> Self {
        Self { plan, memory: Memory::new(&plan.code) }
    }

    /// Evaluates one reading for each input, in SI, `dt` nanoseconds after the one before.
    pub fn evaluate(&mut self, readings: &[Reading], dt: u64) {
        let code = &self.plan.code;
        let read = |input: u32, _| readings.get(input as usize).copied();
        let told = Told { read, rows: 1, done: false, dt, active: 0, path: &[] };
        self.memory.run(code, 0..code.steps.len() as u32, &self.plan.inputs, &told);
    }

    /// A number of the last evaluation.
    pub fn real(&self, real: Real) -> f64 {
        self.memory.reals(real)[0]
    }

    /// A truth value of the last evaluation.
    pub fn bool(&self, bool: Bool) -> bool {
        self.memory.bools(bool)[0]
    }
}

const BLOCK: usize = 64;

/// Evaluates many readings of a network, block by block: the same as one after another, and faster.
#[derive(Debug, Clone)]
pub struct Columns<'p> {
    plan: &'p NetworkPlan,
    memory: Memory<BLOCK>,
    rows: usize,
}

impl<'p> Columns<'p> {
    /// How many rows are evaluated together at most.
    pub const BLOCK: usize = BLOCK;

    /// Before its first reading.
    pub fn new(plan: &'p NetworkPlan) -> Self {
        Self { plan, memory: Memory::new(&plan.code), rows: 0 }
    }

    /// Evaluates the rows of a block: for each input the readings of all rows, in SI, each `dt` nanoseconds after the one
    /// before. Of columns that differ in length or are longer than a block, as many rows as each of them has and a block
    /// holds.
    pub fn evaluate(&mut self, readings: &[Vec<f64>], dt: u64) {
        let code = &self.plan.code;
        self.rows = readings.iter().map(Vec::len).min().unwrap_or(0).min(Self::BLOCK);
        let read = |input: u32, row: usize| {
            let value = readings.get(input as usize)?.get(row)?;
            Some(Reading { value: *value, healthy: true })
        };
        let told = Told { read, rows: self.rows, done: false, dt, active: 0, path: &[] };
        self.memory.run(code, 0..code.steps.len() as u32, &self.plan.inputs, &told);
    }

    /// A number in each row of the last block.
    pub fn reals(&self, real: Real) -> &[f64] {
        &self.memory.reals(real)[..self.rows]
    }

    /// A truth value in each row of the last block.
    pub fn bools(&self, bool: Bool) -> &[bool] {
        &self.memory.bools(bool)[..self.rows]
    }
}
