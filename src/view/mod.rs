//! What other eyes and tools read: runs and diagrams as pictures, diagrams as models, programs as listings.
//!
//! Imports: analysis, base, ir, membership, plan, trace
//! Crates: dagre

pub mod chart;
mod listing;
mod network;
mod plot;
mod promela;
mod svg;

pub use listing::{plans, program};
pub use network::network;
pub use plot::plot;
pub use promela::promela;

use crate::ir::Comparison;

fn sign(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Less => "<",
        Comparison::LessOrEqual => "<=",
        Comparison::Greater => ">",
        Comparison::GreaterOrEqual => ">=",
        Comparison::Equal => "==",
        Comparison::NotEqual => "!=",
    }
}
