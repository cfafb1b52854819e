//! `lmslc check --fix`: carries out the fixes that cannot change behavior.

use super::files::{self, Disk};
use super::flags::AnalysisFlags;
use super::terminal::Terminal;
use crate::diag::apply_fixes;
use crate::driver::Analysis;

/// How often files are checked anew after fixes. Fixes that touch each other need a round each; a fix that never goes
/// away must not keep us forever.
const ROUNDS: usize = 100;

/// Applies the fixes to the files that were asked for, not to those they import, and says how many there were. Answers
/// what is found after that.
///
/// # Errors
/// The exit code; the reason has been reported.
pub(super) fn fix(paths: &[String], flags: Option<&AnalysisFlags>, terminal: &Terminal) -> Result<Analysis, u8> {
    if paths.iter().any(|path| path == "-") {
        return Err(terminal.fail("standard input cannot be fixed", Some("give the file by its name")));
    }
    let mut analysis = Disk::default().analyze(paths, flags, terminal)?;
    let mut count = 0;
    for _ in 0..ROUNDS {
        let writable = |file| analysis.roots.contains(&file) && !analysis.sources.path(file).starts_with("std/");
        let fixes = analysis.findings.iter().filter_map(|finding| finding.fix.as_ref());
        let fixes = fixes.filter(|fix| fix.edits.iter().all(|edit| writable(edit.span.file)));
        let fixed = apply_fixes(fixes, &analysis.sources);
        if fixed.count == 0 {
            break;
        }
        for (&file, text) in &fixed.texts {
            files::write(analysis.sources.path(file), text.as_bytes(), terminal)?;
        }
        count += fixed.count;
        analysis = Disk::default().analyze(paths, flags, terminal)?;
    }
    terminal.note(&format!("{count} finding{} fixed", if count == 1 { "" } else { "s" }));
    Ok(analysis)
}
