//! What was found and what happened, for people and for programs: one renderer a file, each a function from values to
//! text.
//!
//! Imports: base, diag, interp, kernel, plan, trace
//! Crates: codespan-reporting, csv, serde, serde_json

mod degrees;
mod eval;
mod human;
mod json;
mod paint;
mod places;
mod run;
mod short;
mod table;
mod timeline;
mod trace;

#[cfg(test)]
mod samples;

pub use degrees::eval;
pub use eval::{Evaluated, eval_json};
pub use human::{human, summary};
pub use json::json;
pub use run::{Outcome, Verdict, run};
pub use short::short;
pub use table::{TableError, eval_csv};
pub use timeline::timeline;
pub use trace::{trace_csv, trace_jsonl};
