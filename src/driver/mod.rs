//! The pipeline on one screen: files in, findings and a checked program out.
//!
//! Imports: analysis, base, diag, ir, plan, sema, sim, syntax
//! Crates: –

mod library;
mod load;

pub use library::LIBRARY;
pub use load::{FileError, Files};

use crate::base::{FileId, Sources};
use crate::diag::{self, Diagnostic, Levels, Severity, Suppressions};
use crate::{analysis, ir, plan, sema, sim};

/// How to look at a compilation.
#[derive(Debug, Clone)]
pub struct Options {
    /// Which findings count, and how much.
    pub levels: Levels,
    /// The most sensors that are looked at as failed together.
    pub faults: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { levels: Levels::default(), faults: 1 }
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
    /// What was found, sorted by place.
    pub findings: Vec<Diagnostic>,
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
    let load::Loaded { roots, sources, units, mut findings } = load::load(files, roots);
    let (program, mut lowering) = sema::lower(&units, &sources);
    library::suggest(&mut lowering, &sources);
    findings.extend(lowering);
    findings.extend(analysis::run(&program, options.faults, |file| !library::holds(&sources, file)));
    findings.extend(sim::placements(&program));
    let suppressions = Suppressions::collect(&sources, &mut findings);
    findings.extend(suppressions.unused(&findings, &sources));
    if findings.iter().any(|finding| finding.severity == Severity::Error) {
        // What seems unused may be for the part that is broken.
        findings.retain(|finding| !finding.rule.name.starts_with("unused-"));
    }
    options.levels.apply(&mut findings, &suppressions);
    diag::sort(&mut findings);
    Analysis { roots, sources, units, program, findings }
}
