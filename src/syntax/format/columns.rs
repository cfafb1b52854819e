//! Columns of items that stand below each other.

use super::items::{Item, Token};
use super::spacing::is_spaced;
use crate::syntax::parse::Rule;

/// An item in parts, of which those of neighbours begin in the same column.
pub struct Row(Vec<String>);

/// A part that is longer than this begins no column.
const LONG: usize = 60;

impl Row {
    /// The tokens of an item in one line.
    pub fn new(item: &Item<'_>) -> Self {
        let mut parts = vec![String::new()];
        let mut last: Option<&Token<'_>> = None;
        for token in &item.tokens {
            if begins_column(item.kind, token, last) {
                parts.push(String::new());
            }
            if let Some(part) = parts.last_mut() {
                if last.is_some_and(|last| is_spaced(last, token)) {
                    part.push(' ');
                }
                part.push_str(token.text);
            }
            last = Some(token);
        }
        Self(parts)
    }

    /// The whole of it without columns.
    pub fn text(&self) -> String {
        self.0.concat()
    }

    fn is_short(&self) -> bool {
        self.0.iter().all(|part| part.chars().count() <= LONG)
    }

    /// With its parts at least so wide, as far as they are followed by another one.
    fn padded(&self, widths: &[usize]) -> String {
        let mut text = String::new();
        for (index, part) in self.0.iter().enumerate() {
            text.push_str(part);
            let width = widths.get(index).filter(|_| index + 1 < self.0.len());
            let missing = width.map_or(0, |width| width.saturating_sub(part.chars().count()));
            text.extend(std::iter::repeat_n(' ', missing));
        }
        text
    }
}

/// Rows below each other as texts with columns.
pub fn aligned(rows: &[Row]) -> Vec<String> {
    let mut widths: Vec<usize> = Vec::new();
    for row in rows.iter().filter(|row| row.is_short()) {
        for (index, part) in row.0.iter().enumerate().take(row.0.len() - 1) {
            widths.resize(widths.len().max(index + 1), 0);
            widths[index] = widths[index].max(part.chars().count());
        }
    }
    rows.iter().map(|row| if row.is_short() { row.padded(&widths) } else { row.text() }).collect()
}

/// Whether items of a kind stand in columns below each other.
pub fn has_columns(kind: Rule) -> bool {
    matches!(
        kind,
        Rule::term
            | Rule::row
            | Rule::output_rule
            | Rule::flag
            | Rule::transition
            | Rule::decide_row
            | Rule::emergency
            | Rule::client
            | Rule::member
            | Rule::fault
            | Rule::fail
    )
}

/// Whether a column begins at a token of an item.
fn begins_column(kind: Rule, token: &Token<'_>, last: Option<&Token<'_>>) -> bool {
    let begins_cell = || last.is_some_and(|last| last.rule == Rule::comma && last.parent == Rule::row);
    let ends_row = token.rule == Rule::close_paren && token.parent == Rule::row;
    match kind {
        Rule::term | Rule::flag => token.rule == Rule::equals,
        Rule::row => begins_cell() || ends_row,
        Rule::decide_row => begins_cell() || ends_row || token.rule == Rule::fat_arrow,
        Rule::output_rule => token.rule == Rule::fat_arrow,
        Rule::transition => token.rule == Rule::arrow && token.parent == Rule::transition,
        Rule::emergency => token.rule == Rule::arrow,
        Rule::client => matches!(token.rule, Rule::equals | Rule::kw_priority),
        Rule::member => matches!(token.rule, Rule::equals | Rule::kw_runs),
        Rule::fault | Rule::fail => matches!(token.rule, Rule::equals | Rule::kw_from | Rule::kw_to),
        _ => false,
    }
}
