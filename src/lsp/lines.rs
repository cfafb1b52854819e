//! Bytes to the protocol's positions and back: lines, and UTF-16 code units in a line, both from 0.

use lsp_types::{Position, Range};

/// Where the lines of a text begin. A line ends with `\n`, `\r\n` or `\r`.
#[derive(Debug, Clone)]
pub struct Lines {
    starts: Vec<usize>,
}

impl Lines {
    /// One pass over the text.
    pub fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let ends = |at: &usize| match bytes.get(*at) {
            Some(b'\n') => true,
            Some(b'\r') => bytes.get(at + 1) != Some(&b'\n'),
            _ => false,
        };
        let starts = std::iter::once(0).chain((0..bytes.len()).filter(ends).map(|end| end + 1)).collect();
        Self { starts }
    }

    /// Where a byte of the text stands; one inside of a character counts as its first. Costs a pass over its line.
    pub fn position(&self, text: &str, byte: usize) -> Position {
        let byte = text.floor_char_boundary(byte);
        let line = self.starts.partition_point(|&start| start <= byte).saturating_sub(1);
        let start = self.starts.get(line).copied().unwrap_or(0);
        let before = text.get(start..byte).unwrap_or("");
        Position::new(line as u32, before.chars().map(char::len_utf16).sum::<usize>() as u32)
    }

    /// Where a range of bytes stands.
    pub fn range(&self, text: &str, bytes: std::ops::Range<usize>) -> Range {
        Range::new(self.position(text, bytes.start), self.position(text, bytes.end))
    }

    /// The byte at a position. One behind the end of its line counts as that end, as the protocol has it, and one behind
    /// the last line as the end of the text.
    pub fn byte(&self, text: &str, position: Position) -> usize {
        let Some(&start) = self.starts.get(position.line as usize) else { return text.len() };
        let rest = text.get(start..).unwrap_or("");
        let line = rest.split(['\n', '\r']).next().unwrap_or("");
        let mut units = 0;
        let mut before = line.char_indices().skip_while(|(_, c)| {
            units += c.len_utf16();
            units <= position.character as usize
        });
        start + before.next().map_or(line.len(), |(at, _)| at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_utf_16_code_units() {
        let text = "// é 🌏 ∈ x\r\nmode\rb";
        let lines = Lines::new(text);
        let at = |word: &str| lines.position(text, text.find(word).unwrap());
        assert_eq!(at("x"), Position::new(0, 10));
        assert_eq!(at("mode"), Position::new(1, 0));
        assert_eq!(at("b"), Position::new(2, 0));
        for (byte, _) in text.char_indices().filter(|(_, c)| *c != '\n') {
            assert_eq!(lines.byte(text, lines.position(text, byte)), byte);
        }
    }

    #[test]
    fn a_position_outside_the_text_is_moved_into_it() {
        let text = "ab\n🌏";
        let lines = Lines::new(text);
        assert_eq!(lines.byte(text, Position::new(0, 99)), 2);
        assert_eq!(lines.byte(text, Position::new(1, 1)), 3, "in the middle of a character");
        assert_eq!(lines.byte(text, Position::new(9, 0)), text.len());
        assert_eq!(lines.position(text, 99), Position::new(1, 2));
    }
}
