//! The text of every file of a compilation.

use super::{FileId, Span};

/// One file: the name to show, and its text.
#[derive(Debug, Clone)]
pub struct Source {
    /// The path as the user would write it, or `std/robots/j5.msd` for the standard library.
    pub path: String,
    /// The whole text, without a byte order mark.
    pub text: String,
}

/// All files of a compilation, in the order in which they were first needed.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    files: Vec<Source>,
}

impl Sources {
    /// Adds a file and names it.
    pub fn add(&mut self, path: impl Into<String>, text: impl Into<String>) -> FileId {
        let id = FileId(self.files.len() as u32);
        self.files.push(Source { path: path.into(), text: text.into() });
        id
    }

    /// The file of that name; `None` for an id of another compilation.
    pub fn get(&self, file: FileId) -> Option<&Source> {
        self.files.get(file.0 as usize)
    }

    /// The path to show for `file`, empty for an id of another compilation.
    pub fn path(&self, file: FileId) -> &str {
        self.get(file).map_or("", |source| &source.path)
    }

    /// The text under a span, empty where the span lies outside its file.
    pub fn slice(&self, span: Span) -> &str {
        self.get(span.file).and_then(|source| source.text.get(span.range())).unwrap_or("")
    }

    /// All files with their ids.
    pub fn iter(&self) -> impl Iterator<Item = (FileId, &Source)> {
        self.files.iter().enumerate().map(|(index, source)| (FileId(index as u32), source))
    }

    /// Line and column of a byte, both from 1; columns count characters.
    /// Costs a pass over the text before it.
    pub fn position(&self, file: FileId, byte: u32) -> (usize, usize) {
        let text = self.get(file).map_or("", |source| source.text.as_str());
        let mut end = (byte as usize).min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        let before = text.get(..end).unwrap_or("");
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        let line = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
        (line, before.get(line_start..).map_or(0, |rest| rest.chars().count()) + 1)
    }
}
