//! What is known of a file and of all it imports.

use std::cell::OnceCell;
use std::ops::Range;

use lsp_types::{Location, Position};

use super::Lines;
use super::folder::Folder;
use super::names::{self, Declared};
use crate::base::{FileId, Span};
use crate::driver::Analysis;

/// An analysis, with what places in it are in the protocol.
pub(super) struct Known {
    pub(super) analysis: Analysis,
    lines: Vec<OnceCell<Lines>>,
    declared: OnceCell<Declared>,
}

impl Known {
    pub(super) fn new(analysis: Analysis) -> Self {
        let lines = analysis.sources.iter().map(|_| OnceCell::new()).collect();
        Self { analysis, lines, declared: OnceCell::new() }
    }

    /// The file of that path.
    pub(super) fn file(&self, path: &str) -> Option<FileId> {
        self.analysis.sources.iter().find(|(_, source)| source.path == path).map(|(file, _)| file)
    }

    /// The text of a file; empty for one of another analysis.
    pub(super) fn text(&self, file: FileId) -> &str {
        self.analysis.sources.get(file).map_or("", |source| &source.text)
    }

    fn lines(&self, file: FileId) -> Option<&Lines> {
        Some(self.lines.get(file.0 as usize)?.get_or_init(|| Lines::new(self.text(file))))
    }

    /// Where bytes of a file stand.
    pub(super) fn range_of(&self, file: FileId, bytes: Range<usize>) -> lsp_types::Range {
        self.lines(file).map(|lines| lines.range(self.text(file), bytes)).unwrap_or_default()
    }

    /// Where a span stands in its file.
    pub(super) fn range(&self, span: Span) -> lsp_types::Range {
        self.range_of(span.file, span.range())
    }

    /// The byte at a position of a file.
    pub(super) fn byte(&self, file: FileId, position: Position) -> usize {
        self.lines(file).map_or(0, |lines| lines.byte(self.text(file), position))
    }

    /// What is declared.
    pub(super) fn declared(&self) -> &Declared {
        self.declared.get_or_init(|| names::declared(&self.analysis.program))
    }

    /// Where a span can be opened.
    pub(super) fn location(&self, span: Span, folder: &Folder) -> Option<Location> {
        Some(Location::new(folder.uri(self.analysis.sources.path(span.file))?, self.range(span)))
    }
}
