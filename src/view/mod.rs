//! What other eyes and tools read: a run as a figure, a diagram as a model.
//!
//! Imports: analysis, base, ir, trace
//! Crates: –

mod plot;
mod promela;

pub use plot::plot;
pub use promela::promela;
