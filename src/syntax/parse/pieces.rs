//! Where declarations and their members begin and end, as far as can be told without the grammar.

use std::ops::Range;

use super::layout::{Layout, is_operator};
use super::scan::Kind;
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
            Self::Robot => &["body", "sensor", "sense", "logical", "action", "optional"],
            Self::Diagram => &["sense", "entry", "flag", "mode", "final"],
            Self::Mode => &["decide", "on"],
            Self::Arbiter => &["emergency", "client", "ties"],
            Self::Team => &["robot"],
            Self::World => &["wall", "door", "box", "goal"],
            Self::Scenario => &["duration", "tick", "seed", "place", "fault", "fail", "expect"],
        }
    }
}

impl Layout<'_> {
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
        let mut at = self.behind_block(start);
        if self.lost_brace(start) {
            return at;
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
                let is_settings = self.word(at.wrapping_sub(1)) == "using" || self.opens_set(at);
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
        while at < piece.end && !self.lost_brace(at) {
            if self.kind(at) != Some(Kind::OpenBrace) {
                at += 1;
            } else if self.word(at.wrapping_sub(1)) == "using" || self.opens_set(at) {
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
            if extra
                || separate
                || after_block && !is_operator(self.token_text(at)) && self.kind(at) != Some(Kind::Close)
            {
                if start < at {
                    pieces.push(start..at);
                }
                start = if extra { at + 1 } else { at };
                depth = 0;
            }
            after_block = false;
            if extra {
                at += 1;
                continue;
            }
            match self.kind(at) {
                Some(Kind::Open) => depth += 1,
                Some(Kind::Close) => depth = depth.saturating_sub(1),
                Some(Kind::OpenBrace) => {
                    let is_set = self.opens_set(at);
                    at = self.behind_block(at).min(end);
                    after_block = !is_set;
                    continue;
                }
                _ if self.lost_brace(at) => {
                    at = self.behind_block(at).min(end);
                    after_block = true;
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
