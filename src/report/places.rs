//! Bytes to lines and columns, with the starts of all lines looked up once.

use std::ops::Range;

use codespan_reporting::files::{Error, Files, line_starts};

use crate::base::{FileId, Source, Sources, Span};

/// The sources of a compilation with the first byte of each of their lines. Built in one pass over all text; every
/// question after that costs a binary search and, for a column, a pass over the line before it.
pub(super) struct Places<'a> {
    files: Vec<(&'a Source, Vec<usize>)>,
}

impl<'a> Places<'a> {
    pub(super) fn new(sources: &'a Sources) -> Self {
        Self { files: sources.iter().map(|(_, source)| (source, line_starts(&source.text).collect())).collect() }
    }

    fn file(&self, id: FileId) -> Option<&(&'a Source, Vec<usize>)> {
        self.files.get(id.0 as usize)
    }

    /// The path to show; empty for an id of another compilation.
    pub(super) fn path(&self, id: FileId) -> &'a str {
        self.file(id).map_or("", |(source, _)| source.path.as_str())
    }

    /// Line and column of a byte, both from 1; columns count characters. As [`Sources::position`], only faster.
    pub(super) fn position(&self, id: FileId, byte: u32) -> (usize, usize) {
        let Some((source, starts)) = self.file(id) else { return (1, 1) };
        let byte = boundary(&source.text, byte as usize);
        let line = line_of(starts, byte);
        let start = starts.get(line).copied().unwrap_or(0);
        let before = source.text.get(start..byte).unwrap_or("");
        (line + 1, before.chars().count() + 1)
    }

    /// The part of a span that can be shown: inside its file, between characters, and not reaching over the end of
    /// its last line into the next. `None` where there is nothing to show: in a file without text, or of another
    /// compilation.
    pub(super) fn shown(&self, span: Span) -> Option<Range<usize>> {
        let (source, _) = self.file(span.file).filter(|(source, _)| !source.text.is_empty())?;
        let start = boundary(&source.text, span.start as usize);
        let end = boundary(&source.text, span.end as usize).max(start);
        let text = source.text.get(start..end).unwrap_or("");
        let kept = text.trim_end_matches(['\n', '\r']);
        Some(start..start + kept.len())
    }
}

/// The last place between characters at or before a byte.
fn boundary(text: &str, byte: usize) -> usize {
    text.floor_char_boundary(byte)
}

fn line_of(starts: &[usize], byte: usize) -> usize {
    starts.partition_point(|&start| start <= byte).saturating_sub(1)
}

impl<'a> Files<'a> for Places<'_> {
    type FileId = FileId;
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, id: FileId) -> Result<&'a str, Error> {
        self.file(id).map(|(source, _)| source.path.as_str()).ok_or(Error::FileMissing)
    }

    fn source(&'a self, id: FileId) -> Result<&'a str, Error> {
        self.file(id).map(|(source, _)| source.text.as_str()).ok_or(Error::FileMissing)
    }

    fn line_index(&'a self, id: FileId, byte: usize) -> Result<usize, Error> {
        self.file(id).map(|(_, starts)| line_of(starts, byte)).ok_or(Error::FileMissing)
    }

    fn line_range(&'a self, id: FileId, line: usize) -> Result<Range<usize>, Error> {
        let (source, starts) = self.file(id).ok_or(Error::FileMissing)?;
        let max = starts.len().saturating_sub(1);
        let start = starts.get(line).copied().ok_or(Error::LineTooLarge { given: line, max })?;
        Ok(start..starts.get(line + 1).copied().unwrap_or(source.text.len()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_agree_with_the_slow_way_everywhere() {
        let mut sources = Sources::default();
        let file = sources.add("a.msd", "é∈🌏\r\n\nmode forward {\n}\n");
        let places = Places::new(&sources);
        for byte in 0..40 {
            assert_eq!(places.position(file, byte), sources.position(file, byte), "byte {byte}");
        }
        assert_eq!(places.position(FileId(7), 3), (1, 1));
    }

    #[test]
    fn a_span_outside_its_file_is_cut_to_it() {
        let mut sources = Sources::default();
        let file = sources.add("a.msd", "é\nb\n");
        let places = Places::new(&sources);
        assert_eq!(places.shown(Span::new(file, 1, 99)), Some(0..4));
        assert_eq!(places.shown(Span::new(file, 3, 1)), Some(3..3));
        assert_eq!(places.shown(Span::new(file, 0, 3)), Some(0..2));
        assert_eq!(places.shown(Span::new(FileId(3), 0, 1)), None);
    }
}
