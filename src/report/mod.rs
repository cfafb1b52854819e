//! What was found and what happened, for people and for programs: one renderer a file, each a function from values to
//! text.
//!
//! Imports: base, diag
//! Crates: codespan-reporting, serde, serde_json

mod human;
mod json;
mod places;
mod short;

#[cfg(test)]
mod samples;

pub use human::{human, summary};
pub use json::json;
pub use short::short;
