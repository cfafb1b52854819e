//! Where declarations, blocks and their members begin and end, also around missing and extra braces.

use std::ops::Range;

use super::scan::{Kind, Scan, Token};
use crate::diag::nearest;

/// The words that begin a declaration at the top level.
pub const DECLARATIONS: &[&str] = &[
    "import",
    "variable",
    "network",
    "interface",
    "robot",
    "behavior",
    "activity",
    "goal",
    "arbiter",
    "team",
    "world",
    "scenario",
    "property",
];

/// The kinds of block that hold members.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Block {
    Terms,
    Network,
    Event,
    Robot,
    Diagram,
    Mode,
    Commands,
    Decide,
    Arbiter,
    Team,
    World,
    Scenario,
}

impl Block {
    /// The words that begin a member.
    pub fn keywords(self) -> &'static [&'static str] {
        match self {
            Self::Terms | Self::Commands | Self::Decide => &[],
            Self::Network => &["event", "output", "rule"],
            Self::Event => &["contributor", "detractor", "rule"],
            Self::Robot => &["body", "sensor", "logical", "action", "optional"],
            Self::Diagram => &["sense", "entry", "flag", "mode", "final"],
            Self::Mode => &["decide", "on"],
            Self::Arbiter => &["emergency", "client", "ties"],
            Self::Team => &["robot"],
            Self::World => &["wall", "door", "box", "goal"],
            Self::Scenario => &["duration", "tick", "seed", "place", "fault", "fail", "expect"],
        }
    }
}

/// A brace without its other half.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BraceFault {
    /// An opening brace, and the token in front of which it should have been closed.
    Unclosed { open: usize, before: usize },
    /// A closing brace that closes nothing; `expected` where the declaration before it has no opening brace, which
    /// is reported there.
    Extra { close: usize, expected: bool },
}

/// Tokens with their braces paired.
pub struct Layout<'a> {
    pub text: &'a str,
    pub tokens: &'a [Token],
    /// For every opening brace the token that closes it, or the one in front of which it should have been closed.
    closes: Vec<u32>,
    pub faults: Vec<BraceFault>,
}

/// What an opening brace belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Opener {
    Declaration,
    Mode,
    Member,
    Other,
}

impl<'a> Layout<'a> {
    /// Linear in the tokens.
    pub fn new(text: &'a str, scan: &'a Scan) -> Self {
        let closes = vec![0; scan.tokens.len()];
        let mut layout = Self { text, tokens: &scan.tokens, closes, faults: Vec::new() };
        layout.pair_braces();
        layout
    }

    pub fn kind(&self, index: usize) -> Option<Kind> {
        self.tokens.get(index).map(|token| token.kind)
    }

    pub fn token_text(&self, index: usize) -> &'a str {
        self.tokens.get(index).and_then(|token| self.text.get(token.start as usize..token.end as usize)).unwrap_or("")
    }

    /// The word there, empty for any other token.
    pub fn word(&self, index: usize) -> &'a str {
        if self.kind(index) == Some(Kind::Word) { self.token_text(index) } else { "" }
    }

    fn is_first(&self, index: usize) -> bool {
        self.tokens.get(index).is_some_and(|token| token.first)
    }

    fn is_flush(&self, index: usize) -> bool {
        self.tokens.get(index).is_some_and(|token| token.flush)
    }

    /// The token behind a block that opens there.
    pub fn behind_block(&self, open: usize) -> usize {
        let close = self.close_of(open);
        if self.kind(close) == Some(Kind::CloseBrace) && !self.is_extra(close) { close + 1 } else { close }
    }

    /// The token that closes a block, or in front of which it should have been closed.
    pub fn close_of(&self, open: usize) -> usize {
        self.closes.get(open).map_or(self.tokens.len(), |&close| close as usize).max(open + 1)
    }

    /// Whether a brace in `piece` has no other half.
    pub fn has_fault(&self, piece: &Range<usize>) -> bool {
        let from = self.faults.partition_point(|fault| fault.token() < piece.start);
        self.faults.get(from).is_some_and(|fault| fault.token() < piece.end)
    }

    /// Whether a block was cut off in front of that token.
    pub fn is_cut(&self, index: usize) -> bool {
        self.faults.iter().any(|fault| matches!(fault, BraceFault::Unclosed { before, .. } if *before == index))
    }

    fn is_extra(&self, index: usize) -> bool {
        let from = self.faults.partition_point(|fault| fault.token() < index);
        self.faults.get(from).is_some_and(|fault| matches!(fault, BraceFault::Extra { close, .. } if *close == index))
    }

    fn pair_braces(&mut self) {
        let mut stack: Vec<(usize, Opener)> = Vec::new();
        let mut opener = Opener::Other;
        let mut expects_block = false;
        for index in 0..self.tokens.len() {
            match self.kind(index) {
                Some(Kind::Word) => {
                    let cut = self.cut_by(index, &stack);
                    self.close_down_to(cut, &mut stack, index);
                    opener = self.opener(index, stack.is_empty()).unwrap_or(opener);
                    if stack.is_empty() && self.starts_declaration(index) {
                        expects_block = !matches!(self.word(index), "import" | "property");
                    }
                }
                Some(Kind::OpenBrace) => {
                    stack.push((index, opener));
                    opener = Opener::Other;
                    expects_block = false;
                }
                Some(Kind::CloseBrace) => {
                    match stack.last() {
                        Some(&(open, of)) if !self.is_too_early(index, of, stack.len()) => {
                            stack.pop();
                            self.set_close(open, index);
                        }
                        _ => self.faults.push(BraceFault::Extra { close: index, expected: expects_block }),
                    }
                    opener = Opener::Other;
                }
                _ => {}
            }
        }
        self.close_down_to(0, &mut stack, self.tokens.len());
        self.faults.sort_by_key(BraceFault::token);
    }

    /// How many blocks stay open in front of a word that cannot stand in them.
    fn cut_by(&self, index: usize, stack: &[(usize, Opener)]) -> usize {
        let all = stack.len();
        if all == 0 || !self.is_first(index) {
            return all;
        }
        if self.is_flush(index) && self.starts_declaration(index) {
            return 0;
        }
        let opener = match self.word(index) {
            "mode" | "final" | "entry" | "flag" | "sense" => Opener::Mode,
            "event" | "output" | "sensor" | "logical" | "action" => Opener::Member,
            _ => return all,
        };
        if self.kind(index + 1) != Some(Kind::Word) {
            return all;
        }
        stack.iter().rposition(|&(_, of)| of == opener).unwrap_or(all)
    }

    fn close_down_to(&mut self, depth: usize, stack: &mut Vec<(usize, Opener)>, before: usize) {
        // One missing brace leaves every block around it open: only the innermost is worth a message.
        if let Some(&(open, _)) = stack.get(depth..).and_then(<[_]>::last) {
            self.faults.push(BraceFault::Unclosed { open, before });
        }
        for (open, _) in stack.drain(depth.min(stack.len())..) {
            if let Some(close) = self.closes.get_mut(open) {
                *close = before as u32;
            }
        }
    }

    fn set_close(&mut self, open: usize, close: usize) {
        if let Some(slot) = self.closes.get_mut(open) {
            *slot = close as u32;
        }
    }

    /// What a block that opens behind this word belongs to, if the word says.
    fn opener(&self, index: usize, outside: bool) -> Option<Opener> {
        if outside && self.starts_declaration(index) {
            return Some(Opener::Declaration);
        }
        let next_is_word = self.kind(index + 1) == Some(Kind::Word);
        match self.word(index) {
            "mode" if next_is_word => Some(Opener::Mode),
            "event" | "output" | "body" if next_is_word => Some(Opener::Member),
            _ => None,
        }
    }

    /// Whether what follows a closing brace still belongs to the block it would close.
    fn is_too_early(&self, close: usize, of: Opener, depth: usize) -> bool {
        let next = close + 1;
        match of {
            Opener::Declaration if depth == 1 => {
                let words = [Block::Diagram, Block::Network, Block::Robot, Block::Arbiter, Block::Scenario];
                let is_member = words.iter().any(|block| block.keywords().contains(&self.word(next)));
                is_member && self.is_first(next) && !self.is_flush(next)
            }
            Opener::Mode => self.kind(next) == Some(Kind::Number) && self.token_text(next + 1) == ":",
            _ => false,
        }
    }

    fn starts_declaration(&self, index: usize) -> bool {
        DECLARATIONS.contains(&self.word(index))
            && !matches!(self.kind(index + 1), Some(Kind::Open | Kind::Mark | Kind::Number))
            && self.token_text(index + 2) != "="
    }

    /// The pieces of the file: one for each declaration, and for text between them.
    pub fn declarations(&self) -> Vec<Range<usize>> {
        let mut pieces = Vec::new();
        let mut at = 0;
        while at < self.tokens.len() {
            let end = self.declaration_end(at).max(at + 1);
            if !(end == at + 1 && self.is_extra(at)) {
                pieces.push(at..end);
            }
            at = end;
        }
        pieces
    }

    fn declaration_end(&self, start: usize) -> usize {
        let known = DECLARATIONS.contains(&self.word(start));
        let one_line = matches!(self.word(start), "import" | "property");
        let is_near = known || nearest(self.word(start), DECLARATIONS.iter().copied()).is_some();
        let mut at = start + 1;
        if self.kind(start) == Some(Kind::OpenBrace) {
            at = self.behind_block(start);
        }
        while let Some(kind) = self.kind(at) {
            let begins = self.is_first(at) || self.word(start) == "import" && at > start + 1;
            if begins && self.starts_declaration(at) || self.is_extra(at) {
                return at;
            }
            if one_line && self.is_flush(at) && kind == Kind::Word && !is_operator(self.word(at)) {
                return at;
            }
            if kind == Kind::OpenBrace {
                let is_settings = self.word(at.wrapping_sub(1)) == "using" || self.word(at.wrapping_sub(1)) == "of";
                at = self.behind_block(at);
                if is_near && !is_settings {
                    return at;
                }
            } else {
                at += 1;
            }
        }
        at
    }

    /// The opening brace of a declaration's or member's own block.
    pub fn block_of(&self, piece: &Range<usize>) -> Option<usize> {
        let mut at = piece.start;
        while at < piece.end {
            if self.kind(at) != Some(Kind::OpenBrace) {
                at += 1;
            } else if matches!(self.word(at.wrapping_sub(1)), "using" | "of") {
                at = self.behind_block(at);
            } else {
                return Some(at);
            }
        }
        None
    }

    /// The pieces of a block, one for each member as far as can be told.
    pub fn members(&self, block: Block, open: usize) -> Vec<Range<usize>> {
        let end = self.close_of(open);
        let mut pieces = Vec::new();
        let (mut at, mut start, mut depth, mut after_block) = (open + 1, open + 1, 0_u32, false);
        while at < end {
            let extra = self.is_extra(at);
            let separate = (depth == 0 || self.is_first(at)) && self.starts_member(block, at, open);
            if extra || separate || after_block && !is_operator(self.token_text(at)) {
                if start < at {
                    pieces.push(start..at);
                }
                start = if extra { at + 1 } else { at };
                depth = 0;
            }
            after_block = false;
            match self.kind(at) {
                Some(Kind::Open) => depth += 1,
                Some(Kind::Close) => depth = depth.saturating_sub(1),
                Some(Kind::OpenBrace) => {
                    let is_set = depth > 0 || self.word(at - 1) == "of";
                    at = self.behind_block(at).min(end);
                    after_block = !is_set;
                    continue;
                }
                _ => {}
            }
            at += 1;
        }
        if start < end {
            pieces.push(start..end);
        }
        pieces
    }

    fn starts_member(&self, block: Block, at: usize, open: usize) -> bool {
        let (word, next) = (self.word(at), self.token_text(at + 1));
        let before = self.token_text(at - 1);
        let fresh = self.is_first(at) && (at == open + 1 || !is_operator(before)) && !is_operator(word);
        let is_keyword = block.keywords().contains(&word);
        let begins = match block {
            Block::Terms => self.kind(at) == Some(Kind::Word) && (next == "=" || fresh),
            Block::Network | Block::Arbiter => is_keyword,
            Block::Diagram => is_keyword && before != "final",
            Block::Robot if word == "body" => self.kind(at + 1) == Some(Kind::Word) && before != "=",
            Block::Robot => is_keyword && before != "optional",
            Block::Event => is_keyword || self.starts_row(at, fresh),
            Block::Decide => self.starts_row(at, fresh),
            Block::Mode if self.kind(at) == Some(Kind::Number) => next == ":" || fresh,
            Block::Mode => is_keyword || fresh && self.kind(at) == Some(Kind::Word) || self.starts_call(at, fresh),
            Block::Commands => self.starts_call(at, fresh),
            Block::Team => word == "robot" || fresh && matches!(next, "." | "="),
            Block::World => is_keyword && (fresh || matches!(before, ")" | "open")),
            Block::Scenario => match word {
                "duration" | "tick" | "seed" => fresh || self.kind(at + 1) == Some(Kind::Number),
                _ => is_keyword,
            },
        };
        let is_near = || nearest(word, block.keywords().iter().copied()).is_some();
        begins || fresh && self.kind(at + 1) == Some(Kind::Word) && is_near()
    }

    fn starts_row(&self, at: usize, fresh: bool) -> bool {
        self.kind(at) == Some(Kind::Open) && (fresh || matches!(self.token_text(at - 1), ")" | "nothing"))
    }

    fn starts_call(&self, at: usize, fresh: bool) -> bool {
        let is_fresh = fresh || matches!(self.token_text(at - 1), ")" | "{");
        is_fresh && self.kind(at) == Some(Kind::Word) && matches!(self.token_text(at + 1), "(" | ".")
    }
}

impl BraceFault {
    /// The brace itself.
    pub fn token(&self) -> usize {
        match self {
            Self::Unclosed { open, .. } => *open,
            Self::Extra { close, .. } => *close,
        }
    }
}

/// Whether an expression or a list goes on after this token, so that a line that follows it begins nothing new.
fn is_operator(token: &str) -> bool {
    matches!(
        token,
        "and"
            | "or"
            | "not"
            | "is"
            | "after"
            | "any"
            | "of"
            | "leads"
            | "to"
            | "within"
            | "->"
            | "=>"
            | "="
            | "+"
            | "-"
            | "*"
            | "/"
            | "<"
            | "<="
            | ">"
            | ">="
            | "=="
            | "!="
            | ","
            | ":"
            | "."
            | ".."
            | "("
            | "["
    )
}
