//! Findings as the editor shows them.

use std::collections::{BTreeMap, VecDeque};

use lsp_types::{
    Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, Location, NumberOrString,
};

use super::folder::Folder;
use super::known::Known;
use crate::base::{FileId, Span};
use crate::diag::{self, Severity};

/// Who speaks, where an editor shows findings of several.
const SOURCE: &str = "lmslc";

/// What was found in a file, and the errors in files that it imports, unless they are open and have these themselves.
pub(super) fn diagnostics(
    known: &Known,
    file: FileId,
    is_open: impl Fn(&str) -> bool,
    folder: &Folder,
) -> Vec<Diagnostic> {
    let of_file = known.analysis.findings.iter().filter(|finding| finding.span().file == file);
    let of_file = of_file.map(|finding| diagnostic(finding, known, folder));
    let is_shown = |imported: &FileId| !is_open(known.analysis.sources.path(*imported));
    let imported = imported(known, file).into_iter().filter(|(imported, _)| is_shown(imported));
    of_file.chain(imported.filter_map(|(imported, import)| broken(known, imported, import, folder))).collect()
}

/// The files that a file imports, itself or through others, each with the import of its own that leads there first.
fn imported(known: &Known, file: FileId) -> BTreeMap<FileId, Span> {
    let imports =
        |of: FileId| known.analysis.units.iter().filter(move |unit| unit.file == of).flat_map(|unit| &unit.imports);
    let mut found = BTreeMap::new();
    let mut waiting: VecDeque<_> = imports(file).map(|import| (import.file, import.span)).collect();
    while let Some((imported, span)) = waiting.pop_front() {
        if imported != file && !found.contains_key(&imported) {
            found.insert(imported, span);
            waiting.extend(imports(imported).map(|import| (import.file, span)));
        }
    }
    found
}

/// The errors in an imported file, told at its import.
fn broken(known: &Known, imported: FileId, import: Span, folder: &Folder) -> Option<Diagnostic> {
    let findings = known.analysis.findings.iter();
    let errors = findings.filter(|finding| finding.span().file == imported && finding.severity == Severity::Error);
    let errors: Vec<_> = errors.map(|finding| diagnostic(finding, known, folder)).collect();
    let first = errors.first()?;
    let path = known.analysis.sources.path(imported);
    let counted = if errors.len() == 1 { "an error".to_owned() } else { format!("{} errors", errors.len()) };
    let related = errors.iter().filter_map(|error| {
        let location = Location::new(folder.uri(path)?, error.range);
        Some(DiagnosticRelatedInformation { location, message: error.message.clone() })
    });
    Some(Diagnostic {
        range: known.range(import),
        code: first.code.clone(),
        message: format!("`{path}` has {counted}: {}", first.message),
        related_information: Some(related.collect()),
        tags: None,
        ..first.clone()
    })
}

/// A finding: its notes and help below its message, its other places as related ones.
pub(super) fn diagnostic(finding: &diag::Diagnostic, known: &Known, folder: &Folder) -> Diagnostic {
    let mut message = finding.text();
    if let Some(here) = finding.labels.first().filter(|label| !label.message.is_empty()) {
        message = message.replacen(&finding.message, &format!("{}: {}", finding.message, here.message), 1);
    }
    let related = finding.labels.iter().skip(1).filter_map(|label| {
        let location = known.location(label.span, folder)?;
        Some(DiagnosticRelatedInformation { location, message: label.message.clone() })
    });
    let related: Vec<_> = related.collect();
    Diagnostic {
        range: known.range(finding.span()),
        severity: Some(severity(finding.severity)),
        code: Some(NumberOrString::String(finding.rule.code.to_owned())),
        source: Some(SOURCE.to_owned()),
        message,
        related_information: (!related.is_empty()).then_some(related),
        tags: finding.rule.name.starts_with("unused-").then(|| vec![DiagnosticTag::UNNECESSARY]),
        ..Diagnostic::default()
    }
}

/// What is only worth knowing is a hint, which editors show without a mark in the margin.
fn severity(severity: Severity) -> DiagnosticSeverity {
    match severity {
        Severity::Error => DiagnosticSeverity::ERROR,
        Severity::Warning => DiagnosticSeverity::WARNING,
        Severity::Info => DiagnosticSeverity::HINT,
    }
}
