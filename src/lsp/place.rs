//! Where in a text something is being written, half of it still missing: what is around it, and what stands before it.

use crate::syntax::{Token, TokenKind, tokens};

/// A declaration or a part of one, in whose braces a place lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Block<'t> {
    /// The word that it begins with: `behavior`, `mode`, `event`.
    pub(super) keyword: &'t str,
    /// The name behind it.
    pub(super) name: &'t str,
}

/// A list in parentheses in which a place lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct List<'t> {
    /// The word in front of it; empty without one.
    pub(super) head: &'t str,
    /// The byte at which that word ends.
    pub(super) head_end: usize,
    /// How many of its members stand before the place.
    pub(super) position: usize,
}

/// A place in a text.
pub(super) struct Place<'t> {
    text: &'t str,
    /// What stands before it, without the word that is being written.
    before: Vec<Token>,
    blocks: Vec<Block<'t>>,
}

/// The words behind which something in braces may follow.
const HEADS: &[&str] = &[
    "activity",
    "arbiter",
    "behavior",
    "body",
    "decide",
    "enter",
    "event",
    "exit",
    "goal",
    "interface",
    "mode",
    "network",
    "output",
    "robot",
    "scenario",
    "team",
    "using",
    "variable",
    "world",
];

/// The words that only declarations at the top level begin with.
const OUTERMOST: &[&str] = &[
    "activity",
    "arbiter",
    "behavior",
    "goal",
    "import",
    "interface",
    "network",
    "property",
    "robot",
    "scenario",
    "team",
    "variable",
    "world",
];

impl<'t> Place<'t> {
    /// The place at a byte of a text; `None` inside of a comment. One pass over the text before it.
    pub(super) fn new(text: &'t str, byte: usize) -> Option<Self> {
        let before = text.get(..byte)?;
        let line = before.rsplit(['\n', '\r']).next().unwrap_or("");
        if line.contains("//") {
            return None;
        }
        let mut tokens = tokens(before);
        tokens.pop_if(|last| last.kind == TokenKind::Word && last.end as usize == byte);
        let mut place = Self { text: before, before: tokens, blocks: Vec::new() };
        place.blocks = place.enclosing();
        Some(place)
    }

    fn word(&self, token: &Token) -> &'t str {
        self.text.get(token.start as usize..token.end as usize).unwrap_or("")
    }

    fn enclosing(&self) -> Vec<Block<'t>> {
        let (mut blocks, mut closed): (Vec<Block<'_>>, Option<Block<'_>>) = (Vec::new(), None);
        for (at, token) in self.before.iter().enumerate() {
            match token.kind {
                TokenKind::OpenBrace => blocks.push(self.head(at, closed.take())),
                TokenKind::CloseBrace => closed = blocks.pop(),
                // A brace that is missing further up is not missing for long.
                TokenKind::Word if token.flush && OUTERMOST.contains(&self.word(token)) => blocks.clear(),
                _ => {}
            }
        }
        blocks
    }

    /// What a brace belongs to; `closed` ended last before it.
    fn head(&self, brace: usize, closed: Option<Block<'t>>) -> Block<'t> {
        let before = self.before.get(..brace).unwrap_or_default();
        for (at, token) in before.iter().enumerate().rev() {
            let word = self.word(token);
            if HEADS.contains(&word) {
                let name = before.get(at + 1).map_or("", |next| self.word(next));
                return Block { keyword: word, name };
            }
            match token.kind {
                // Behind `using { ... }` come the network's own braces.
                TokenKind::CloseBrace if closed.is_some_and(|closed| closed.keyword == "using") => {
                    let network = before.iter().rposition(|token| self.word(token) == "network");
                    let name = network.and_then(|at| before.get(at + 1)).map_or("", |next| self.word(next));
                    return Block { keyword: "network", name };
                }
                TokenKind::OpenBrace | TokenKind::CloseBrace => break,
                _ => {}
            }
        }
        Block { keyword: "", name: "" }
    }

    /// The declaration at the top level that the place lies in the braces of.
    pub(super) fn declaration(&self) -> Option<Block<'t>> {
        self.blocks.first().copied()
    }

    /// The innermost part of it, sets in braces left aside.
    pub(super) fn block(&self) -> Option<Block<'t>> {
        self.blocks.iter().rev().find(|block| !block.keyword.is_empty()).copied()
    }

    /// The word or mark that many before the place, from 0; empty where there is none.
    pub(super) fn back(&self, count: usize) -> &'t str {
        let at = self.before.len().checked_sub(count + 1);
        at.and_then(|at| self.before.get(at)).map_or("", |token| self.word(token))
    }

    /// Whether a number stands right before the place.
    pub(super) fn is_behind_number(&self) -> bool {
        self.before.last().is_some_and(|token| token.kind == TokenKind::Number)
    }

    /// The words and marks of the line before the place; those from where its outermost open list begins, where that is
    /// further up.
    pub(super) fn line(&self) -> Vec<&'t str> {
        let opening = self.opening();
        let last_line_end = self.before.last().map_or(0, |token| token.end as usize);
        if opening.is_none() && self.text.get(last_line_end..self.end()).is_some_and(|gap| gap.contains('\n')) {
            return Vec::new();
        }
        let (mut depth, mut start) = (0_usize, self.before.len());
        let until = opening.map_or(self.before.len(), |(at, _)| at + 1);
        for (at, token) in self.before.iter().enumerate().take(until).rev() {
            match token.kind {
                TokenKind::Close => depth += 1,
                TokenKind::Open => depth = depth.saturating_sub(1),
                TokenKind::OpenBrace | TokenKind::CloseBrace if !self.is_set(at) => break,
                _ => {}
            }
            start = at;
            if token.first && depth == 0 {
                break;
            }
        }
        self.before.get(start..).unwrap_or_default().iter().map(|token| self.word(token)).collect()
    }

    /// Where the word that is being written begins, or the place.
    fn end(&self) -> usize {
        let last = self.before.last().map_or(0, |token| token.end as usize);
        let rest = self.text.get(last..).unwrap_or("");
        last + rest.len() - rest.trim_start().len()
    }

    /// Whether a brace opens or closes a set of names, `{low, med}`.
    fn is_set(&self, brace: usize) -> bool {
        let before = self.before.get(..=brace).unwrap_or_default();
        let open = before.iter().rposition(|token| token.kind == TokenKind::OpenBrace).unwrap_or(0);
        let front = open.checked_sub(1).and_then(|at| before.get(at)).map_or("", |token| self.word(token));
        ["(", ",", "of"].contains(&front)
    }

    /// Where the innermost list in parentheses opens in which the place lies, and how many of its members stand before.
    fn opening(&self) -> Option<(usize, usize)> {
        let (mut depth, mut position) = (0_usize, 0);
        for (at, token) in self.before.iter().enumerate().rev() {
            match token.kind {
                TokenKind::Close => depth += 1,
                TokenKind::CloseBrace if self.is_set(at) => depth += 1,
                TokenKind::Open if depth == 0 => return Some((at, position)),
                TokenKind::Open | TokenKind::OpenBrace if depth > 0 => depth -= 1,
                // The names of a set are one member.
                TokenKind::OpenBrace if self.is_set(at) => position = 0,
                TokenKind::OpenBrace | TokenKind::CloseBrace => return None,
                TokenKind::Mark if depth == 0 && self.word(token) == "," => position += 1,
                _ => {}
            }
        }
        None
    }

    /// The words of a column of the decision table in whose rows the place lies.
    pub(super) fn column(&self, position: usize) -> Vec<&'t str> {
        let Some(table) = self.before.iter().rposition(|token| self.word(token) == "decide") else { return Vec::new() };
        let (mut depth, mut columns) = (0_usize, vec![Vec::new()]);
        for token in self.before.get(table + 1..).unwrap_or_default() {
            match token.kind {
                TokenKind::Open => depth += 1,
                TokenKind::Close if depth == 1 => break,
                TokenKind::Close => depth -= 1,
                TokenKind::Mark if depth == 1 && self.word(token) == "," => columns.push(Vec::new()),
                _ => columns.last_mut().into_iter().for_each(|column| column.push(self.word(token))),
            }
        }
        columns.into_iter().nth(position).unwrap_or_default()
    }

    /// The innermost list in parentheses in which the place lies.
    pub(super) fn list(&self) -> Option<List<'t>> {
        let (opening, position) = self.opening()?;
        let head = opening.checked_sub(1).and_then(|at| self.before.get(at));
        let head = head.filter(|head| head.kind == TokenKind::Word);
        let head_end = head.map_or(0, |head| head.end as usize);
        Some(List { head: head.map_or("", |head| self.word(head)), head_end, position })
    }
}
