//! Fixes, one at a time or all at once.

use std::collections::HashMap;
use std::ops::RangeInclusive;

use lsp_types::{CodeAction, CodeActionKind, TextEdit, Uri, WorkspaceEdit};

use super::diagnostics::diagnostic;
use super::folder::{Folder, LIBRARY};
use super::known::Known;
use crate::base::{FileId, Span};
use crate::diag::{Edit, Fix, apply_fixes};

/// The fixes of what was found at some bytes of a file, and one for all that can be fixed in it together.
pub(super) fn actions(known: &Known, file: FileId, bytes: &RangeInclusive<usize>, folder: &Folder) -> Vec<CodeAction> {
    let writable = |edit: &Edit| !known.analysis.sources.path(edit.span.file).starts_with(LIBRARY);
    let of_file = known.analysis.findings.iter().filter(|finding| finding.span().file == file);
    let fixable = of_file.filter_map(|finding| Some((finding, finding.fix.as_ref()?)));
    let fixable: Vec<_> = fixable.filter(|(_, fix)| fix.edits.iter().all(writable)).collect();
    let touched = |span: Span| span.range().start <= *bytes.end() && *bytes.start() <= span.range().end;
    let mut actions: Vec<_> = fixable
        .iter()
        .filter(|(finding, _)| touched(finding.span()))
        .map(|(finding, fix)| CodeAction {
            title: fix.message.clone(),
            kind: Some(CodeActionKind::QUICKFIX),
            diagnostics: Some(vec![diagnostic(finding, known, folder)]),
            edit: Some(edit(known, &fix.edits, folder)),
            is_preferred: Some(true),
            ..CodeAction::default()
        })
        .collect();
    actions.extend(all(known, file, fixable.iter().map(|(_, fix)| *fix), folder));
    actions
}

/// Every fix of a file that does not touch an earlier one.
fn all<'f>(known: &Known, file: FileId, fixes: impl Iterator<Item = &'f Fix>, folder: &Folder) -> Option<CodeAction> {
    let fixed = apply_fixes(fixes, &known.analysis.sources);
    let text = fixed.texts.get(&file).filter(|_| fixed.texts.len() == 1)?.clone();
    let whole = Span::new(file, 0, known.text(file).len() as u32);
    Some(CodeAction {
        title: format!("fix what can be fixed ({})", fixed.count),
        kind: Some(CodeActionKind::SOURCE_FIX_ALL),
        edit: Some(edit(known, &[Edit { span: whole, text }], folder)),
        ..CodeAction::default()
    })
}

#[expect(clippy::mutable_key_type, reason = "the protocol's own type")]
fn edit(known: &Known, edits: &[Edit], folder: &Folder) -> WorkspaceEdit {
    let mut changes: HashMap<Uri, Vec<TextEdit>> = HashMap::new();
    for edit in edits {
        if let Some(location) = known.location(edit.span, folder) {
            let edit = TextEdit { range: location.range, new_text: edit.text.clone() };
            changes.entry(location.uri).or_default().push(edit);
        }
    }
    WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
}
