//! What is not written but good to see: numbers in SI, and how many terms a variable has.

use lsp_types::{InlayHint, InlayHintKind, InlayHintLabel};

use super::known::Known;
use crate::base::{Exact, FileId, Unit};
use crate::syntax::{Token, TokenKind, tokens};

/// The hints in some bytes of a file.
pub(super) fn hints(known: &Known, file: FileId, bytes: &std::ops::Range<usize>) -> Vec<InlayHint> {
    let text = known.text(file);
    let variables = known.analysis.program.variables.values().filter(|variable| variable.symbol.span.file == file);
    let terms = variables.map(|variable| {
        let count = variable.terms.len();
        let label = format!("{count} term{}", if count == 1 { "" } else { "s" });
        (variable.symbol.span.range().end, label)
    });
    let mut found: Vec<_> = terms.chain(quantities(text)).filter(|(at, _)| bytes.contains(at)).collect();
    found.sort();
    found.into_iter().map(|(at, label)| hint(known, file, at, label)).collect()
}

fn hint(known: &Known, file: FileId, at: usize, label: String) -> InlayHint {
    InlayHint {
        position: known.range_of(file, at..at).start,
        label: InlayHintLabel::String(label),
        kind: Some(InlayHintKind::TYPE),
        text_edits: None,
        tooltip: None,
        padding_left: Some(true),
        padding_right: None,
        data: None,
    }
}

/// Where quantities end that are not written in SI, and what they are in it.
fn quantities(text: &str) -> Vec<(usize, String)> {
    let tokens = tokens(text);
    let found =
        tokens.iter().enumerate().filter(|(_, token)| token.kind == TokenKind::Number).filter_map(|(at, number)| {
            let unit_end = unit_end(text, &tokens, at + 1)?;
            let start = tokens.get(at + 1)?.start as usize;
            let unit = Unit::parse(text.get(start..unit_end)?).filter(|unit| unit.scale != Exact::ONE)?;
            let is_negative = text.get(..number.start as usize)?.ends_with('-');
            let number =
                Exact::parse(text.get(number.start as usize..number.end as usize)?)?.times(unit.scale)?.to_f64();
            let value = if is_negative { -number } else { number };
            Some((unit_end, format!("= {} {}", rounded(value), unit.dimension.si_unit())))
        });
    found.collect()
}

/// Six digits, as an engineer reads them.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// Where a unit ends that begins with a word: it is written without space.
fn unit_end(text: &str, tokens: &[Token], first: usize) -> Option<usize> {
    let first_token = tokens.get(first).filter(|token| token.kind == TokenKind::Word)?;
    let mut end = first_token.end;
    for token in tokens.get(first + 1..)? {
        let word = text.get(token.start as usize..token.end as usize)?;
        if token.start != end
            || !(token.kind == TokenKind::Word || token.kind == TokenKind::Number || ["/", "*", "^"].contains(&word))
        {
            break;
        }
        end = token.end;
    }
    Some(end as usize)
}
