//! Runs a plan: one call of [`Machine::step`] is one tick.
//!
//! Imports: kernel, plan
//! Crates: –

mod arbiter;
mod machine;
mod memory;
mod network;

pub use arbiter::Proposal;
pub use machine::{Actuators, Inputs, Machine, Phase, Reading, Taken};
pub use network::{Columns, Evaluator};
