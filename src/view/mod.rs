//! Pictures: what a run did, as a figure.
//!
//! Imports: trace
//! Crates: –

mod plot;

pub use plot::plot;
