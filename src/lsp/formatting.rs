//! Laying a file out in the one canonical way.

use lsp_types::TextEdit;

use super::Lines;
use crate::base::FileId;
use crate::syntax::{self, ast::FileKind};

/// The change that formats a text: nothing where it is laid out so, or does not parse. Lines that stay are left out at
/// either end, so that the cursor keeps its place.
pub(super) fn formatting(kind: FileKind, text: &str) -> Vec<TextEdit> {
    let Ok(formatted) = syntax::format(FileId(0), kind, text) else { return Vec::new() };
    if formatted == text {
        return Vec::new();
    }
    let same = |pair: &(&str, &str)| pair.0 == pair.1;
    let (old, new): (Vec<_>, Vec<_>) =
        (text.split_inclusive('\n').collect(), formatted.split_inclusive('\n').collect());
    let head = old.iter().copied().zip(new.iter().copied()).take_while(same).count();
    let most = old.len().min(new.len()) - head;
    let tail = old.iter().rev().copied().zip(new.iter().rev().copied()).take(most).take_while(same).count();
    let length = |lines: &[&str]| lines.iter().map(|line| line.len()).sum::<usize>();
    let (start, end) = (length(&old[..head]), text.len() - length(&old[old.len() - tail..]));
    let range = Lines::new(text).range(text, start..end);
    vec![TextEdit { range, new_text: new[head..new.len() - tail].concat() }]
}
