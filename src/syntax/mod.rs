//! Text to syntax tree, by parsing with recovery, and to text in one canonical layout.
//!
//! Imports: base, diag
//! Crates: pest, pest_derive

pub mod ast;
mod format;
mod parse;

pub use format::format;
pub use parse::{KEYWORDS, Memo, Token, TokenKind, is_name, kind_of, parse, parse_again, tokens};
