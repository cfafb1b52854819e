//! Another name for what is named in many places.

use std::collections::{BTreeMap, BTreeSet};

use lsp_types::{TextEdit, Uri, WorkspaceEdit};

use super::folder::{Folder, LIBRARY};
use super::known::Known;
use crate::base::{FileId, Span};
use crate::diag::{Edit, Fix, Severity, apply_fixes};
use crate::driver;

/// The places that a name has to be changed in together.
///
/// # Errors
/// Why it cannot be changed.
pub(super) fn places(known: &Known, name: Span) -> Result<BTreeSet<Span>, String> {
    let sources = &known.analysis.sources;
    let old = sources.slice(name);
    let mut kin = known.kin(name);
    // An alias of a network is a name of its own.
    kin.retain(|place| sources.slice(*place) == old);
    if !driver::is_name(old) {
        return Err("there is no name that could be changed".to_owned());
    }
    match kin.iter().find(|place| sources.path(place.file).starts_with(LIBRARY)) {
        Some(place) => {
            Err(format!("`{old}` is named in `{}`, which is of the standard library", sources.path(place.file)))
        }
        None => Ok(kin),
    }
}

/// The texts of files after another name was put in some places.
pub(super) fn renamed(known: &Known, places: &BTreeSet<Span>, new: &str) -> BTreeMap<FileId, String> {
    let edits = places.iter().map(|&span| Edit { span, text: new.to_owned() }).collect();
    apply_fixes([&Fix { message: String::new(), edits }], &known.analysis.sources).texts
}

/// What is wrong after a change and was not before.
pub(super) fn new_error(before: &Known, after: &Known) -> Option<String> {
    let errors = |known: &Known| {
        let findings = known.analysis.findings.iter().filter(|finding| finding.severity == Severity::Error);
        findings.map(|finding| finding.message.clone()).collect::<Vec<_>>()
    };
    let (before, after) = (errors(before), errors(after));
    let is_new = |message: &String| !before.contains(message);
    if after.len() > before.len() { after.into_iter().find(is_new) } else { None }
}

/// The change, file by file.
#[expect(clippy::mutable_key_type, reason = "the protocol's own type")]
pub(super) fn edit(known: &Known, places: &BTreeSet<Span>, new: &str, folder: &Folder) -> WorkspaceEdit {
    let mut changes: std::collections::HashMap<Uri, Vec<TextEdit>> = std::collections::HashMap::new();
    for place in places {
        if let Some(location) = known.location(*place, folder) {
            changes.entry(location.uri).or_default().push(TextEdit { range: location.range, new_text: new.to_owned() });
        }
    }
    WorkspaceEdit { changes: Some(changes), ..WorkspaceEdit::default() }
}
