//! Tokens with their braces paired, also around missing and extra ones.

use std::ops::Range;

use super::pieces::{Block, DECLARATIONS};
use super::scan::{Kind, Scan, Token};

/// A brace without its other half.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BraceFault {
    /// An opening brace, and the token in front of which it should have been closed.
    Unclosed { open: usize, before: usize },
    /// A closing brace that closes nothing, or an opening one that opens nothing; `expected` where the declaration
    /// before it has no opening brace, which is reported there.
    Extra { brace: usize, expected: bool },
}

/// Tokens with their braces paired.
pub struct Layout<'a> {
    pub text: &'a str,
    pub tokens: &'a [Token],
    /// For every opening brace the token that closes it, or the one in front of which it should have been closed;
    /// the same for the keyword of a block whose opening brace is missing; 0 for any other token.
    closes: Vec<u32>,
    /// Braces without their other half, in the order of the text.
    pub faults: Vec<BraceFault>,
    /// The tokens in front of which blocks were cut off, in order.
    cuts: Vec<usize>,
}

/// The blocks of declarations.
const HOLDERS: [Block; 7] =
    [Block::Network, Block::Robot, Block::Diagram, Block::Arbiter, Block::Team, Block::World, Block::Scenario];

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
        let mut layout = Self { text, tokens: &scan.tokens, closes, faults: Vec::new(), cuts: Vec::new() };
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

    pub fn is_first(&self, index: usize) -> bool {
        self.tokens.get(index).is_some_and(|token| token.first)
    }

    pub fn is_flush(&self, index: usize) -> bool {
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
        self.cuts.binary_search(&index).is_ok()
    }

    pub fn is_extra(&self, index: usize) -> bool {
        let from = self.faults.partition_point(|fault| fault.token() < index);
        self.faults.get(from).is_some_and(|fault| matches!(fault, BraceFault::Extra { brace, .. } if *brace == index))
    }

    fn pair_braces(&mut self) {
        let mut stack: Vec<(usize, Opener)> = Vec::new();
        // The keyword whose block has not been opened yet.
        let mut header: Option<(usize, Opener)> = None;
        let mut set_close = None;
        for index in 0..self.tokens.len() {
            match self.kind(index) {
                Some(Kind::Word | Kind::Number) => {
                    let cut = self.cut_by(index, &stack);
                    self.close_down_to(cut, &mut stack, index);
                    stack.extend(header.take_if(|&mut (_, opener)| self.lacks_brace(index, opener)));
                    let opener = self.opener(index, stack.is_empty());
                    header = opener.map(|opener| (index, opener)).or(header);
                }
                Some(Kind::OpenBrace) if self.opens_set(index) => {
                    set_close = self.set_end(index);
                    self.set_close(index, set_close.unwrap_or(0));
                }
                Some(Kind::OpenBrace) if self.kind(index.wrapping_sub(1)) == Some(Kind::OpenBrace) => {
                    self.faults.push(BraceFault::Extra { brace: index, expected: false });
                }
                Some(Kind::OpenBrace) => {
                    stack.push((index, header.take().map_or(Opener::Other, |(_, opener)| opener)));
                }
                // Half a set is reported with the line it stands in.
                Some(Kind::CloseBrace) if set_close == Some(index) || self.closes_set(index) => {}
                Some(Kind::CloseBrace) => {
                    match stack.last() {
                        Some(&(open, of)) if !self.is_too_early(index, of, stack.len()) => {
                            stack.pop();
                            self.set_close(open, index);
                        }
                        _ => self.faults.push(BraceFault::Extra { brace: index, expected: header.is_some() }),
                    }
                    header = None;
                }
                _ => {}
            }
        }
        self.close_down_to(0, &mut stack, self.tokens.len());
        self.faults.sort_by_key(BraceFault::token);
    }

    /// Whether this token stands inside the block of a keyword that has not been opened: its brace is missing.
    fn lacks_brace(&self, index: usize, opener: Opener) -> bool {
        let (word, next) = (self.word(index), self.token_text(index + 1));
        match opener {
            Opener::Declaration => {
                let is_member = HOLDERS.iter().any(|block| block.keywords().contains(&word)) || next == "=";
                self.is_first(index) && is_member && !self.starts_declaration(index)
            }
            Opener::Mode => match self.kind(index) {
                Some(Kind::Number) => next == ":",
                _ => next == "(" || matches!(word, "on" | "decide"),
            },
            Opener::Member => matches!(word, "contributor" | "detractor") || self.is_first(index) && next == "=",
            Opener::Other => false,
        }
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
        let open = stack.get(depth..).unwrap_or_default().iter().map(|&(open, _)| open);
        if let Some(open) = open.rev().find(|&open| self.kind(open) == Some(Kind::OpenBrace)) {
            self.faults.push(BraceFault::Unclosed { open, before });
            self.cuts.push(before);
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

    /// Whether this is the keyword of a block whose opening brace is missing.
    pub fn lost_brace(&self, index: usize) -> bool {
        self.kind(index) == Some(Kind::Word) && self.closes.get(index).is_some_and(|&close| close != 0)
    }

    /// What a block that opens behind this word belongs to, if the word says.
    fn opener(&self, index: usize, outside: bool) -> Option<Opener> {
        if outside && self.starts_declaration(index) {
            return Some(Opener::Declaration).filter(|_| !matches!(self.word(index), "import" | "property"));
        }
        let next_is_word = self.kind(index + 1) == Some(Kind::Word);
        match self.word(index) {
            // In `explore.mode is stop` it asks where another diagram is.
            "mode" if next_is_word && self.word(index + 1) != "is" => Some(Opener::Mode),
            "event" | "output" | "body" if next_is_word => Some(Opener::Member),
            _ => None,
        }
    }

    /// Whether what follows a closing brace still belongs to the block it would close.
    fn is_too_early(&self, close: usize, of: Opener, depth: usize) -> bool {
        let next = close + 1;
        match of {
            Opener::Declaration if depth == 1 => {
                let is_member = HOLDERS.iter().any(|block| block.keywords().contains(&self.word(next)));
                // The goal of a world is a place, and has no name.
                let is_layer = self.word(next) == "goal" && self.kind(next + 1) == Some(Kind::Word);
                is_member && !is_layer && self.is_first(next) && !self.is_flush(next)
            }
            Opener::Mode => self.kind(next) == Some(Kind::Number) && self.token_text(next + 1) == ":",
            _ => false,
        }
    }

    /// Whether a brace opens a set of terms: in a row, or behind `any of`.
    pub fn opens_set(&self, open: usize) -> bool {
        let before = open.checked_sub(1).map_or("", |before| self.token_text(before));
        matches!(before, "(" | "," | "of") || self.set_end(open).is_some_and(|close| self.closes_set(close))
    }

    /// The brace that closes a set of terms.
    fn set_end(&self, open: usize) -> Option<usize> {
        let mut at = open + 1;
        while self.token_text(at) == "," || self.kind(at) == Some(Kind::Word) && !is_operator(self.word(at)) {
            at += 1;
        }
        (self.kind(at) == Some(Kind::CloseBrace)).then_some(at)
    }

    /// Whether something follows a closing brace that cannot follow a block.
    fn closes_set(&self, close: usize) -> bool {
        matches!(self.token_text(close + 1), ")" | "," | "->" | "=>" | "and" | "or")
    }

    pub fn starts_declaration(&self, index: usize) -> bool {
        DECLARATIONS.contains(&self.word(index))
            && !matches!(self.kind(index + 1), Some(Kind::Open | Kind::Mark | Kind::Number))
            && self.token_text(index + 2) != "="
    }
}

impl BraceFault {
    /// The brace itself.
    pub fn token(&self) -> usize {
        match self {
            Self::Unclosed { open, .. } => *open,
            Self::Extra { brace, .. } => *brace,
        }
    }
}

/// Whether an expression or a list goes on after this token, so that a line that follows it begins nothing new.
pub fn is_operator(token: &str) -> bool {
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
