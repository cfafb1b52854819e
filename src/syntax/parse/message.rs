//! Syntax errors in words: what was expected, what was found, and what a newcomer probably meant.

use std::ops::Range;

use pest::error::{ErrorVariant, InputLocation};

use super::KEYWORDS;
use super::depth::LIMIT;
use super::grammar::{Error, Rule};
use super::layout::{BraceFault, Layout};
use super::phrases::phrase;
use super::pieces::{Block, DECLARATIONS};
use super::scan::Kind;
use crate::base::{FileId, Span};
use crate::diag::{Diagnostic, did_you_mean, rules};

/// More alternatives than this say nothing.
const MOST_ALTERNATIVES: usize = 5;

/// What can go on after any value, or end it.
const GOES_ON: [Rule; 11] = [
    Rule::infix,
    Rule::operator,
    Rule::connective,
    Rule::dot,
    Rule::open_paren,
    Rule::open_index,
    Rule::arguments,
    Rule::indices,
    Rule::unit_times,
    Rule::unit_over,
    Rule::EOI,
];

/// A shorter word is like too many others.
const SHORTEST_MISSPELT: usize = 3;

/// The finding for a piece that the grammar does not take. `None` where it only ends too early because its block
/// was cut off, which is reported at the brace.
pub fn syntax_error(layout: &Layout<'_>, file: FileId, piece: &Range<usize>, error: &Error) -> Option<Diagnostic> {
    let ErrorVariant::ParsingError { positives, .. } = &error.variant else {
        // The parser ran out of stack, which the limit on nesting is there to prevent.
        return Some(too_deep(layout, file, piece.start));
    };
    let start = layout.tokens.get(piece.start).map_or(0, |token| token.start as usize);
    let offset = match error.location {
        InputLocation::Pos(at) | InputLocation::Span((at, _)) => at,
    };
    let token = layout.tokens.partition_point(|token| token.end as usize <= start + offset).min(piece.end);
    let is_at_end = token == piece.end;
    if is_at_end && layout.is_cut(token) {
        return None;
    }
    if !is_at_end && is_keyword_as_name(layout, token, positives) {
        return Some(keyword_as_name(place(layout, file, token), layout.token_text(token)));
    }
    let mut diagnostic = expected(layout, file, token, &list(&alternatives(layout, token, positives)));
    let is_missing = is_at_end || positives.contains(&Rule::open_brace);
    if is_missing && let Some(label) = diagnostic.labels.first_mut() {
        label.span = place_behind(layout, file, token);
    }
    Some(diagnostic.help_maybe(help(layout, piece, token, positives)))
}

/// "expected ..., found ..."
pub fn expected(layout: &Layout<'_>, file: FileId, token: usize, expected: &str) -> Diagnostic {
    let found = found(layout, token);
    let message = match expected {
        "" => format!("unexpected {found}"),
        _ => format!("expected {expected}, found {found}"),
    };
    Diagnostic::new(&rules::SYNTAX_ERROR, place(layout, file, token), message)
}

/// The finding for `a < b < c`.
pub fn chained_comparison(span: Span) -> Diagnostic {
    Diagnostic::new(&rules::SYNTAX_ERROR, span, "comparisons do not chain")
        .help("write two comparisons joined by `and`, as in `a < b and b < c`")
}

/// The finding for `x is t + 1`.
pub fn value_after_test(span: Span, operator: &str) -> Diagnostic {
    Diagnostic::new(&rules::SYNTAX_ERROR, span, format!("`{operator}` after a test with `is`"))
        .help("a test is true or false, not a value: join it with `and` or `or`")
}

/// The finding for `a + not b`.
pub fn not_inside_value(span: Span) -> Diagnostic {
    Diagnostic::new(&rules::SYNTAX_ERROR, span, "`not` stands inside a value")
        .help("`not` goes in front of a whole condition, as in `not a < b`")
}

/// The finding for nesting past the limit.
pub fn too_deep(layout: &Layout<'_>, file: FileId, token: usize) -> Diagnostic {
    let message = format!("nesting deeper than {LIMIT} levels");
    Diagnostic::new(&rules::TOO_DEEP, place(layout, file, token), message).help("name parts of it with `flag`")
}

/// The finding for a keyword that stands where a name is needed.
pub fn keyword_as_name(span: Span, keyword: &str) -> Diagnostic {
    let message = format!("`{keyword}` is a keyword and cannot be a name");
    Diagnostic::new(&rules::KEYWORD_AS_NAME, span, message).help(format!("pick another name, such as `{keyword}_`"))
}

/// The finding for a brace without its other half.
pub fn brace_fault(layout: &Layout<'_>, file: FileId, fault: BraceFault) -> Option<Diagnostic> {
    let at = place(layout, file, fault.token());
    match fault {
        BraceFault::Unclosed { before, .. } => {
            let message = format!("this `{{` is never closed: expected `}}`, found {}", found(layout, before));
            let diagnostic = Diagnostic::new(&rules::SYNTAX_ERROR, at, message);
            Some(diagnostic.label(place(layout, file, before), "expected `}` before this"))
        }
        BraceFault::Extra { expected: true, .. } => None,
        BraceFault::Extra { .. } => {
            let brace = layout.token_text(fault.token());
            let what = if brace == "}" { "it closes nothing" } else { "it opens nothing" };
            Some(Diagnostic::new(&rules::SYNTAX_ERROR, at, format!("unexpected `{brace}`")).here(what))
        }
    }
}

fn found(layout: &Layout<'_>, token: usize) -> String {
    match layout.token_text(token) {
        "" => "the end of the file".to_owned(),
        text => format!("`{text}`"),
    }
}

fn place(layout: &Layout<'_>, file: FileId, token: usize) -> Span {
    match layout.tokens.get(token) {
        Some(token) => Span::new(file, token.start, token.end),
        None => Span::new(file, layout.text.len() as u32, layout.text.len() as u32),
    }
}

/// Where something is missing in front of a token: behind the one before it, if that stands on an earlier line.
fn place_behind(layout: &Layout<'_>, file: FileId, token: usize) -> Span {
    let is_first = layout.tokens.get(token).is_none_or(|token| token.first);
    match token.checked_sub(1).and_then(|before| layout.tokens.get(before)) {
        Some(before) if is_first => Span::new(file, before.end, before.end),
        _ => place(layout, file, token),
    }
}

/// Whether a declaration's name is a keyword.
fn is_keyword_as_name(layout: &Layout<'_>, token: usize, positives: &[Rule]) -> bool {
    let before = token.checked_sub(1).map_or("", |before| layout.word(before));
    let declares = DECLARATIONS.contains(&before)
        || matches!(
            before,
            "event" | "output" | "sensor" | "logical" | "action" | "mode" | "flag" | "entry" | "client"
        );
    declares && positives.contains(&Rule::name) && KEYWORDS.contains(&layout.word(token))
}

/// What was expected, without what can go on after any value where something else is needed.
fn alternatives(layout: &Layout<'_>, token: usize, positives: &[Rule]) -> Vec<&'static str> {
    let follows_number = token.checked_sub(1).and_then(|before| layout.kind(before)) == Some(Kind::Number);
    let follows_value = positives.contains(&Rule::infix);
    let goes_on = |rule| match rule {
        Rule::kw_is | Rule::is_test => follows_value,
        Rule::unit | Rule::unit_factor | Rule::unit_name => follows_number,
        _ => GOES_ON.contains(&rule),
    };
    let mut phrases = Vec::new();
    for &rule in positives.iter().filter(|&&rule| !goes_on(rule)) {
        let phrase = phrase(rule);
        if !phrases.contains(&phrase) {
            phrases.push(phrase);
        }
    }
    if phrases.is_empty() && !positives.contains(&Rule::EOI) {
        let is_call = positives.iter().any(|rule| matches!(rule, Rule::open_paren | Rule::arguments));
        let first = positives.first().map(|&rule| phrase(rule));
        phrases.extend(if is_call { Some("`(`") } else { first });
    }
    if phrases.contains(&phrase(Rule::expression)) {
        phrases.retain(|&other| other != phrase(Rule::name));
    }
    phrases
}

fn list(alternatives: &[&str]) -> String {
    match alternatives.get(..alternatives.len().min(MOST_ALTERNATIVES)).unwrap_or_default() {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}

/// What a newcomer probably meant.
fn help(layout: &Layout<'_>, piece: &Range<usize>, token: usize, positives: &[Rule]) -> Option<String> {
    let found = layout.token_text(token);
    let before = token.checked_sub(1).map_or("", |before| layout.token_text(before));
    let wants = |rule| positives.contains(&rule);
    let fixed = match found {
        ";" => "the language has no `;`: take it away",
        "&&" => "write `and`",
        "||" => "write `or`",
        "!" => "write `not`",
        "=" if wants(Rule::infix) => "write `==` to compare",
        "=" if wants(Rule::colon) => "write `:`",
        ":" if wants(Rule::equals) => "write `=`",
        "->" if wants(Rule::fat_arrow) => "write `=>`",
        "=>" if wants(Rule::arrow) => "write `->`",
        "," => "take the `,` away",
        _ if before == "," => "take the `,` away, or say what follows it",
        _ if before == ":" && (wants(Rule::unit) || wants(Rule::unit_name)) => {
            "name the unit; that of a plain number is written `1`"
        }
        _ if wants(Rule::target) => "name the mode that the transition leads to",
        _ if layout.kind(piece.start) == Some(Kind::Number) && (wants(Rule::colon) || wants(Rule::arrow)) => {
            "a transition is written `1: condition -> mode`"
        }
        _ => "",
    };
    if fixed.is_empty() {
        let word = Some(layout.word(token)).filter(|word| word.len() >= SHORTEST_MISSPELT)?;
        let candidates = positives.iter().flat_map(|&rule| spellings(rule));
        did_you_mean(word, candidates.filter(|spelling| spelling.starts_with(|first: char| first.is_alphabetic())))
    } else {
        Some(fixed.to_owned())
    }
}

/// The words that a rule can begin with, to compare a misspelt one with.
fn spellings(rule: Rule) -> Vec<&'static str> {
    match rule {
        Rule::declaration => DECLARATIONS.to_vec(),
        Rule::network_item => Block::Network.keywords().to_vec(),
        Rule::robot_item => Block::Robot.keywords().to_vec(),
        Rule::diagram_item => Block::Diagram.keywords().to_vec(),
        Rule::arbiter_item => Block::Arbiter.keywords().to_vec(),
        Rule::world_item => Block::World.keywords().to_vec(),
        Rule::scenario_item => Block::Scenario.keywords().to_vec(),
        Rule::sensor_clause => vec!["fails", "noise", "accuracy", "period", "beam"],
        Rule::event_option => vec!["over", "hysteresis", "hold", "confirm"],
        _ => phrase(rule).split('`').skip(1).step_by(2).collect(),
    }
}
