//! Diagnostics as JSON, one object a line.

use serde::Serialize;

use super::places::Places;
use crate::base::{Sources, Span};
use crate::diag::{self, Diagnostic};

/// The version of every JSON shape of this room; it grows when a shape changes in a way that breaks its readers.
pub(super) const SCHEMA: u32 = 1;

#[derive(Serialize)]
struct Finding<'a> {
    schema: u32,
    code: &'a str,
    name: &'a str,
    severity: &'a str,
    message: &'a str,
    #[serde(flatten)]
    place: Place<'a>,
    labels: Vec<Label<'a>>,
    notes: &'a [String],
    help: Option<&'a str>,
    witness: Option<()>,
    fix: Option<Fix<'a>>,
}

#[derive(Serialize)]
struct Label<'a> {
    message: &'a str,
    #[serde(flatten)]
    place: Place<'a>,
}

#[derive(Serialize)]
struct Fix<'a> {
    message: &'a str,
    edits: Vec<Edit<'a>>,
}

#[derive(Serialize)]
struct Edit<'a> {
    #[serde(flatten)]
    place: Place<'a>,
    text: &'a str,
}

#[derive(Serialize)]
struct Place<'a> {
    file: &'a str,
    start: Position,
    end: Position,
}

/// `byte` from 0, `line` and `column` from 1, columns in characters; the end of a place is one past its last byte.
#[derive(Serialize)]
struct Position {
    byte: u32,
    line: usize,
    column: usize,
}

/// Renders diagnostics in their order, one JSON object a line. `labels` holds all places, the primary one first.
pub fn json(diagnostics: &[Diagnostic], sources: &Sources) -> String {
    let places = Places::new(sources);
    diagnostics.iter().map(|diagnostic| to_line(&finding(diagnostic, &places))).collect()
}

/// One object and the end of its line. The values of this room have text for keys and finite trees for values, so
/// writing one does not fail.
pub(super) fn to_line(value: &impl Serialize) -> String {
    serde_json::to_string(value).map(|text| text + "\n").unwrap_or_default()
}

fn finding<'a>(diagnostic: &'a Diagnostic, places: &Places<'a>) -> Finding<'a> {
    let labels = diagnostic.labels.iter();
    let labels = labels.map(|label| Label { message: &label.message, place: place(label.span, places) });
    Finding {
        schema: SCHEMA,
        code: diagnostic.rule.code,
        name: diagnostic.rule.name,
        severity: diagnostic.severity.name(),
        message: &diagnostic.message,
        place: place(diagnostic.span(), places),
        labels: labels.collect(),
        notes: &diagnostic.notes,
        help: diagnostic.help.as_deref(),
        witness: None,
        fix: diagnostic.fix.as_ref().map(|change| fix(change, places)),
    }
}

fn fix<'a>(fix: &'a diag::Fix, places: &Places<'a>) -> Fix<'a> {
    let edits = fix.edits.iter().map(|edit| Edit { place: place(edit.span, places), text: &edit.text });
    Fix { message: &fix.message, edits: edits.collect() }
}

fn place<'a>(span: Span, places: &Places<'a>) -> Place<'a> {
    let position = |byte| {
        let (line, column) = places.position(span.file, byte);
        Position { byte, line, column }
    };
    Place { file: places.path(span.file), start: position(span.start), end: position(span.end) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::samples;

    #[test]
    fn every_finding_is_one_object() {
        let (diagnostics, sources) = samples::diagnostics();
        insta::assert_snapshot!(json(&diagnostics, &sources));
    }

    #[test]
    fn what_is_not_said_is_null() {
        let (diagnostics, sources) = samples::diagnostics();
        let text = json(&diagnostics, &sources);
        let last: serde_json::Value = serde_json::from_str(text.lines().last().unwrap()).unwrap();
        assert!(last["help"].is_null() && last["witness"].is_null() && last["fix"].is_null());
        assert_eq!(last["schema"], 1);
        assert_eq!(last["notes"].as_array().map(Vec::len), Some(0));
    }
}
