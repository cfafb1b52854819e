//! A condition of the user's, as part of the program.

use crate::base::{FileId, Sources};
use crate::diag::{Diagnostic, Severity};
use crate::driver::{self, Analysis, FileError, Files, Options};
use crate::ir::{Claim, Platform};
use crate::plan::{self, Plan};
use crate::repl::Refusal;

/// The plan of a behavior that watches a condition. It is understood as one of a property at the end of the file, so that
/// it can name what a property can.
///
/// # Errors
/// What is wrong with the condition.
pub(super) fn plan(analysis: &Analysis, behavior: &str, platform: Platform, text: &str) -> Result<Plan, Refusal> {
    let refusal = |help: Option<String>| Refusal { message: format!("`{text}` is no condition"), help };
    let Some(root) = analysis.roots.first().copied() else { return Err(refusal(None)) };
    let file = analysis.sources.get(root).map_or("", |source| &source.text);
    let mut name = "watched".to_owned();
    while analysis.sources.iter().any(|(_, source)| source.text.contains(&name)) {
        name.push('_');
    }
    let text_of_file = format!("{file}\nproperty {name} of {behavior}: never {text}");
    let texts = Extended { sources: &analysis.sources, root, text: &text_of_file };
    let options = Options { verify: false, faults: 0, ..Options::default() };
    let extended = driver::analyze(&texts, &[analysis.sources.path(root).to_owned()], &options);
    let is_error = |finding: &&Diagnostic| finding.severity == Severity::Error;
    if let Some(Diagnostic { message, help, .. }) = extended.findings.iter().find(is_error) {
        let message = message.replace("the end of the file", "the end of the line");
        return Err(Refusal { message, help: help.clone() });
    }
    let property = extended.program.properties.values().find(|property| property.symbol.name == name);
    match (extended.checked(), property.map(|property| (property, property.claim))) {
        // What goes on behind the condition is none of it.
        (Some(checked), Some((property, Claim::Never(condition))))
            if property.span.end as usize == text_of_file.len() =>
        {
            Ok(plan::build_on(checked, property.diagram, platform, &[condition]))
        }
        _ => Err(refusal(None)),
    }
}

/// The files of an analysis, with more text in one of them.
struct Extended<'a> {
    sources: &'a Sources,
    root: FileId,
    text: &'a str,
}

impl Files for Extended<'_> {
    fn read(&self, path: &str) -> Result<String, FileError> {
        if self.sources.path(self.root) == path {
            return Ok(self.text.to_owned());
        }
        let known = self.sources.iter().find(|(_, source)| source.path == path);
        known.map(|(_, source)| source.text.clone()).ok_or(FileError::Missing)
    }
}
