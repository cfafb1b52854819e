//! Syntax errors in words: what was expected, what was found, and what a newcomer probably meant.

use std::ops::Range;

use pest::error::{ErrorVariant, InputLocation};

use super::KEYWORDS;
use super::depth::LIMIT;
use super::grammar::{Error, Rule};
use super::layout::{BraceFault, Layout};
use super::phrases::phrase;
use crate::base::{FileId, Span};
use crate::diag::{Diagnostic, rules};

/// More alternatives than this say nothing.
const MOST_ALTERNATIVES: usize = 5;

/// The finding for a piece that the grammar does not take. `None` where it only ends too early because its block
/// was cut off, which is reported at the brace.
pub fn syntax_error(layout: &Layout<'_>, file: FileId, piece: &Range<usize>, error: &Error) -> Option<Diagnostic> {
    let ErrorVariant::ParsingError { positives, .. } = &error.variant else {
        return Some(too_deep(layout, file, piece.start));
    };
    let start = layout.tokens.get(piece.start).map_or(0, |token| token.start as usize);
    let offset = match error.location {
        InputLocation::Pos(at) | InputLocation::Span((at, _)) => at,
    };
    let token = layout.tokens.partition_point(|token| token.end as usize <= start + offset).min(piece.end);
    if token == piece.end && layout.is_cut(token) {
        return None;
    }
    let alternatives = alternatives(positives);
    Some(expected(layout, file, token, &list(&alternatives)))
}

/// "expected ..., found ..."
pub fn expected(layout: &Layout<'_>, file: FileId, token: usize, expected: &str) -> Diagnostic {
    let found = found(layout, token);
    let message =
        if expected.is_empty() { format!("unexpected {found}") } else { format!("expected {expected}, found {found}") };
    Diagnostic::new(&rules::SYNTAX_ERROR, place(layout, file, token), message)
}

/// The finding for nesting past the limit.
pub fn too_deep(layout: &Layout<'_>, file: FileId, token: usize) -> Diagnostic {
    let message = format!("nesting deeper than {LIMIT} levels");
    Diagnostic::new(&rules::TOO_DEEP, place(layout, file, token), message).help("name parts of it with `flag`")
}

/// The finding for a brace without its other half.
pub fn brace_fault(layout: &Layout<'_>, file: FileId, fault: BraceFault) -> Diagnostic {
    let at = place(layout, file, fault.token());
    match fault {
        BraceFault::Unclosed { before, .. } => {
            let message = format!("this `{{` is never closed: expected `}}`, found {}", found(layout, before));
            Diagnostic::new(&rules::SYNTAX_ERROR, at, message)
                .label(place(layout, file, before), "expected `}` before this")
        }
        BraceFault::Extra { .. } => Diagnostic::new(&rules::SYNTAX_ERROR, at, "unexpected `}`: it closes nothing"),
    }
}

fn found(layout: &Layout<'_>, token: usize) -> String {
    match layout.token_text(token) {
        "" => "the end of the file".to_owned(),
        text => format!("`{text}`"),
    }
}

/// A token's own place; where it stands on a later line than the one before, the place where something is missing.
fn place(layout: &Layout<'_>, file: FileId, token: usize) -> Span {
    match layout.tokens.get(token) {
        Some(token) => Span::new(file, token.start, token.end),
        None => Span::new(file, layout.text.len() as u32, layout.text.len() as u32),
    }
}

fn alternatives(positives: &[Rule]) -> Vec<&'static str> {
    let mut phrases = Vec::new();
    for &rule in positives {
        let phrase = phrase(rule);
        if rule != Rule::EOI && !phrases.contains(&phrase) {
            phrases.push(phrase);
        }
    }
    phrases
}

fn list(alternatives: &[&str]) -> String {
    let _ = (KEYWORDS, MOST_ALTERNATIVES);
    match alternatives {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}
