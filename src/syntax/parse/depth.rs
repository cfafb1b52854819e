//! How deep parentheses and prefixes nest, before anything recurses into them.

use std::ops::Range;

use super::layout::Layout;
use super::scan::Kind;

/// The deepest nesting of parentheses, brackets, `not`, `-` and hedges that is taken.
pub const LIMIT: usize = 256;

/// The first token of a piece that nests too deep. Linear in the piece.
pub fn first_too_deep(layout: &Layout<'_>, piece: &Range<usize>) -> Option<usize> {
    // For each open parenthesis, how many prefixes stand in front of it.
    let mut open = Vec::new();
    let (mut depth, mut prefixes) = (0, 0);
    for index in piece.clone() {
        match layout.kind(index) {
            Some(Kind::Open) => {
                open.push(prefixes);
                depth += 1 + prefixes;
                prefixes = 0;
            }
            Some(Kind::Close) => {
                depth -= open.pop().map_or(0, |prefixes| 1 + prefixes);
                prefixes = 0;
            }
            _ if matches!(layout.token_text(index), "not" | "-" | "very" | "somewhat") => prefixes += 1,
            _ => prefixes = 0,
        }
        if depth + prefixes > LIMIT {
            return Some(index);
        }
    }
    None
}
