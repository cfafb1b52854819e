//! Checked IR to its ordered executable form: every default decided, every step in order.
//!
//! Imports: base, diag, ir, membership
//! Crates: –

mod builder;
mod code;
mod diagram;
mod evidence;
mod network;
mod output;
mod parts;
mod platform;
mod slabs;
mod types;

pub use code::*;
pub use diagram::{build, build_alone, build_on, build_scenario};
pub use network::build_network;
pub use types::*;

use crate::base::{Sources, Span, Unit};
use crate::diag::{Diagnostic, Severity};
use crate::ir;

/// A program without errors. Plans are made from nothing else, so no code comes from a program that has no meaning.
#[derive(Debug, Clone, Copy)]
pub struct Checked<'a> {
    program: &'a ir::Program,
    sources: &'a Sources,
}

impl<'a> Checked<'a> {
    /// The token for a program with these findings; `None` where one of them is an error.
    pub fn new(program: &'a ir::Program, sources: &'a Sources, findings: &[Diagnostic]) -> Option<Self> {
        let sound = findings.iter().all(|finding| finding.severity != Severity::Error);
        sound.then_some(Self { program, sources })
    }

    /// The program.
    pub fn program(&self) -> &'a ir::Program {
        self.program
    }

    /// Source text on one line.
    fn on_one_line(&self, span: Span) -> String {
        self.sources.slice(span).split_whitespace().collect::<Vec<_>>().join(" ")
    }
}

/// How a sensor or an input is read. Without a fail reading of its own it takes the one of `others`, then 0, or the end
/// of its range nearest to 0.
fn input(
    symbol: &ir::Symbol,
    unit: &Unit,
    range: (crate::base::Exact, crate::base::Exact),
    fails: &[&[ir::FailReading]],
) -> Input {
    let (low, high) = (range.0.to_f64(), range.1.to_f64());
    let declared = fails.iter().flat_map(|fails| fails.iter()).find_map(|fail| match fail {
        ir::FailReading::Value(value) => Some(value.to_f64()),
        ir::FailReading::Any | ir::FailReading::Absent => None,
    });
    let fail = declared.unwrap_or_else(|| 0.0_f64.clamp(low, high));
    Input { name: symbol.name.clone(), origin: origin(symbol), unit: unit.clone(), low, high, fail }
}

fn origin(symbol: &ir::Symbol) -> Origin {
    Origin { span: symbol.span, doc: symbol.doc.clone() }
}
