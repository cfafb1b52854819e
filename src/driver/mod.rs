//! The pipeline on one screen: files in, findings and a checked program out.
//!
//! Imports: analysis, base, diag, emit, ir, plan, sema, sim, syntax, verify
//! Crates: –

mod compile;
mod library;
mod load;

pub use compile::{NotCompiled, Plans};
pub use library::LIBRARY;
pub use load::{FileError, Files, Loaded, format, kind, load};

pub use crate::syntax::{Memo, is_name};

use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use crate::base::{FileId, Sources, Span};
use crate::diag::{self, Diagnostic, Levels, Rule, Severity, Suppressions};
use crate::{analysis, ir, plan, sema, sim, verify};

/// How to look at a compilation.
#[derive(Debug, Clone)]
pub struct Options {
    /// Which findings count, and how much.
    pub levels: Levels,
    /// The most sensors that are looked at as failed together.
    pub faults: usize,
    /// Whether properties are proved or refuted. A refuted one is an error, and a program with errors is not run.
    pub verify: bool,
    /// Set from outside when nobody waits for the properties any more: those that are left are not looked at.
    pub stop: Arc<AtomicBool>,
}

impl Default for Options {
    fn default() -> Self {
        Self { levels: Levels::default(), faults: 1, verify: true, stop: Arc::default() }
    }
}

/// Everything known about a compilation. Broken input gives a partial program and findings.
#[derive(Debug)]
pub struct Analysis {
    /// The files that were asked for, without those they import; one that could not be read is left out.
    pub roots: Vec<FileId>,
    /// The text of all files.
    pub sources: Sources,
    /// The syntax trees of all files that could be read, with what their imports led to.
    pub units: Vec<sema::Unit>,
    /// What they declare.
    pub program: ir::Program,
    /// Every name that was understood, and where what it means is declared; see [`sema::Lowered::uses`].
    pub uses: Vec<(Span, Span)>,
    /// What was found, sorted by place.
    pub findings: Vec<Diagnostic>,
    /// How many properties are proved.
    pub proved: usize,
    /// Scenarios that show the refuted ones.
    pub counterexamples: Vec<verify::Counterexample>,
}

impl Analysis {
    /// The token that plans are made from; `None` where a finding is an error.
    pub fn checked(&self) -> Option<plan::Checked<'_>> {
        plan::Checked::new(&self.program, &self.sources, &self.findings)
    }

    /// Whether some finding is an error.
    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(|finding| finding.severity == Severity::Error)
    }
}

/// Reads, lowers and checks `roots` and everything they import. Total: it never fails and never panics.
/// Linear in the size of the files, and in the cases of each mode.
pub fn analyze(files: &dyn Files, roots: &[String], options: &Options) -> Analysis {
    examine(load(&mut Memo::default(), files, roots), options)
}

/// Lowers and checks files that were read: what [`analyze`] does without the outside world.
pub fn examine(loaded: Loaded, options: &Options) -> Analysis {
    let Loaded { roots, sources, units, mut findings } = loaded;
    let sema::Lowered { program, diagnostics: mut lowering, uses } = sema::lower(&units, &sources);
    library::suggest(&mut lowering, &sources);
    findings.extend(lowering);
    let matters = |file| !library::holds(&sources, file);
    findings.extend(analysis::run(&program, options.faults, matters));
    findings.extend(sim::placements(&program));
    let is_broken = findings.iter().any(|finding| finding.severity == Severity::Error);
    let checked = plan::Checked::new(&program, &sources, &findings).filter(|_| options.verify);
    let verified =
        checked.map(|checked| verify::properties(checked, options.faults, matters, &options.stop)).unwrap_or_default();
    let verify::Verified { findings: unproved, proved, counterexamples } = verified;
    findings.extend(unproved);
    let suppressions = Suppressions::collect(&sources, &mut findings);
    let looked_at = |file, rule: &Rule| matters(file) && (options.faults > 0 || !rule.is_about_faults());
    findings.extend(suppressions.unused(&findings, &sources, looked_at));
    if is_broken {
        // What seems unused may be for the part that is broken.
        findings.retain(|finding| !finding.rule.name.starts_with("unused-"));
    }
    options.levels.apply(&mut findings, &suppressions);
    diag::sort(&mut findings);
    Analysis { roots, sources, units, program, uses, findings, proved, counterexamples }
}
