//! Checked IR to its ordered executable form: every default decided, every step in order.
//!
//! Imports: base, ir
//! Crates: –

mod types;

pub use types::*;
