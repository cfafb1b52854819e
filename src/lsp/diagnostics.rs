//! Findings as the editor shows them.

use lsp_types::{Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, NumberOrString};

use super::folder::Folder;
use super::known::Known;
use crate::base::FileId;
use crate::diag::{self, Severity};

/// Who speaks, where an editor shows findings of several.
const SOURCE: &str = "lmslc";

/// What was found in a file.
pub(super) fn diagnostics(known: &Known, file: FileId, folder: &Folder) -> Vec<Diagnostic> {
    let of_file = known.analysis.findings.iter().filter(|finding| finding.span().file == file);
    of_file.map(|finding| diagnostic(finding, known, folder)).collect()
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
