//! Text to syntax tree: parsing with recovery.
//!
//! Imports: base, diag
//! Crates: pest, pest_derive

pub mod ast;
mod parse;

pub use parse::{KEYWORDS, parse};
