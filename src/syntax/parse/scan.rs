//! One pass over the text that finds tokens and doc comments, for what the grammar cannot do: pair braces across
//! faults, cut a broken declaration into pieces, measure nesting, attach doc comments, and name what was found.

use std::ops::Range;

/// What a token is, as far as layout needs to know.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A name or a keyword.
    Word,
    /// An unsigned number.
    Number,
    /// `{`
    OpenBrace,
    /// `}`
    CloseBrace,
    /// `(` or `[`
    Open,
    /// `)` or `]`
    Close,
    /// Any other punctuation.
    Mark,
    /// What no valid file has.
    Foreign,
}

/// A token and where it stands.
#[derive(Debug, Clone, Copy)]
pub struct Token {
    /// What it is.
    pub kind: Kind,
    /// Its first byte.
    pub start: u32,
    /// One past its last byte.
    pub end: u32,
    /// Nothing but space stands in front of it on its line.
    pub first: bool,
    /// Nothing stands in front of it on its line.
    pub flush: bool,
}

/// All tokens and doc comments of a text.
#[derive(Debug, Default)]
pub struct Scan {
    pub tokens: Vec<Token>,
    doc_lines: Vec<Range<usize>>,
    /// Where the token after a block of doc comments starts, and which of the lines are its block.
    doc_blocks: Vec<(u32, Range<usize>)>,
}

const MARKS: [&[u8]; 9] = [b"->", b"=>", b"<=", b">=", b"==", b"!=", b"..", b"&&", b"||"];

impl Scan {
    /// Linear in the text.
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let mut scan = Self::default();
        let mut at = if text.starts_with('\u{feff}') { 3 } else { 0 };
        let (mut line_start, mut first, mut block) = (at, true, 0);
        while let Some(&byte) = bytes.get(at) {
            let rest = bytes.get(at..).unwrap_or_default();
            match byte {
                b'\n' | b'\r' => {
                    at += 1;
                    (line_start, first) = (at, true);
                }
                b' ' | b'\t' | 0x0b | 0x0c => at += 1,
                _ if rest.starts_with(b"//") => {
                    let length = count(rest, |byte| byte != b'\n' && byte != b'\r');
                    if rest.starts_with(b"///") && !rest.starts_with(b"////") {
                        scan.doc_lines.push(at..at + length);
                    }
                    at += length;
                }
                _ => {
                    let (kind, length) = token(rest);
                    if block < scan.doc_lines.len() {
                        scan.doc_blocks.push((at as u32, block..scan.doc_lines.len()));
                        block = scan.doc_lines.len();
                    }
                    let (start, end) = (at as u32, (at + length) as u32);
                    scan.tokens.push(Token { kind, start, end, first, flush: at == line_start });
                    at += length;
                    first = false;
                }
            }
        }
        scan
    }

    /// The doc lines in front of the token that starts there.
    pub fn doc_before(&self, start: u32) -> Option<&[Range<usize>]> {
        let index = self.doc_blocks.binary_search_by_key(&start, |block| block.0).ok()?;
        let (_, lines) = self.doc_blocks.get(index)?;
        self.doc_lines.get(lines.clone())
    }
}

fn token(rest: &[u8]) -> (Kind, usize) {
    match rest.first().copied().unwrap_or_default() {
        b'{' => (Kind::OpenBrace, 1),
        b'}' => (Kind::CloseBrace, 1),
        b'(' | b'[' => (Kind::Open, 1),
        b')' | b']' => (Kind::Close, 1),
        byte if byte.is_ascii_digit() => (Kind::Number, number(rest)),
        byte if is_letter(byte) => (Kind::Word, count(rest, is_letter)),
        byte if byte.is_ascii_graphic() => {
            let long = MARKS.iter().any(|mark| rest.starts_with(mark));
            (Kind::Mark, if long { 2 } else { 1 })
        }
        _ => (Kind::Foreign, count(rest, is_foreign)),
    }
}

fn number(rest: &[u8]) -> usize {
    let digits = |from: usize| rest.get(from..).map_or(0, |rest| count(rest, |byte| byte.is_ascii_digit()));
    let mut length = digits(0);
    if rest.get(length) == Some(&b'.') && digits(length + 1) > 0 {
        length += 1 + digits(length + 1);
    }
    if matches!(rest.get(length), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(rest.get(length + 1), Some(b'+' | b'-')));
        let power = digits(length + 1 + sign);
        length += if power > 0 { 1 + sign + power } else { 0 };
    }
    length
}

fn is_foreign(byte: u8) -> bool {
    !byte.is_ascii() || byte.is_ascii_control() && !matches!(byte, b'\t'..=b'\r')
}

fn is_letter(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_'
}

fn count(bytes: &[u8], holds: impl Fn(u8) -> bool) -> usize {
    bytes.iter().take_while(|&&byte| holds(byte)).count()
}
