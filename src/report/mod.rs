//! What was found and what happened, for people and for programs: one renderer a file, each a function from values to
//! text.
//!
//! Imports: analysis, base, diag, interp, ir, kernel, plan, trace
//! Crates: codespan-reporting, csv, serde, serde_json

mod coverage;
mod degrees;
mod eval;
mod faults;
mod github;
mod human;
mod json;
mod log;
mod measures;
mod paint;
mod places;
mod recorded;
mod run;
mod sarif;
mod short;
mod table;
mod timeline;
mod trace;

#[cfg(test)]
mod samples;

pub use coverage::{coverage, coverage_json};
pub use degrees::eval;
pub use eval::{Evaluated, eval_json};
pub use faults::{faults, faults_html, faults_json, faults_markdown};
pub use github::github;
pub use human::{human, summary};
pub use json::json;
pub use log::log;
pub use measures::{Measured, measures_markdown};
pub use recorded::{Recorded, read_trace};
pub use run::{Outcome, Verdict, run};
pub use sarif::sarif;
pub use short::short;
pub use table::{TableError, eval_csv};
pub use timeline::timeline;
pub use trace::{trace_csv, trace_jsonl};
