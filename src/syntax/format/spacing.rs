//! What stands between two tokens on a line.

use super::items::Token;
use crate::syntax::parse::Rule;

/// Whether a space stands between two tokens.
pub fn is_spaced(left: &Token<'_>, right: &Token<'_>) -> bool {
    let is_tight_list = |token: &Token<'_>| matches!(token.parent, Rule::cell_set | Rule::any_of);
    match (left.rule, right.rule) {
        (Rule::open_paren | Rule::open_index, _)
        | (_, Rule::close_paren | Rule::close_index | Rule::comma | Rule::colon) => false,
        (Rule::open_brace, _) if is_tight_list(left) => false,
        (_, Rule::close_brace) if is_tight_list(right) => false,
        (_, Rule::open_index) => false,
        (_, Rule::open_paren) => !is_call(right.parent),
        (Rule::prefix, _) => left.text == "not",
        (Rule::range_mark, _) | (_, Rule::range_mark) => {
            let mark = if left.rule == Rule::range_mark { left } else { right };
            mark.parent != Rule::index_range
        }
        _ => true,
    }
}

/// Whether the parenthesis of a rule stands right behind a name.
fn is_call(rule: Rule) -> bool {
    matches!(rule, Rule::arguments | Rule::parameters | Rule::inputs | Rule::function | Rule::points)
}
