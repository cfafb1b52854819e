//! Where things stand in the source, without the folders of one machine.

use crate::base::{FileId, Source, Sources, Span};

/// The sources of a compilation with the first byte of each of their lines.
pub(super) struct Places<'a> {
    sources: &'a Sources,
    files: Vec<(&'a Source, Vec<usize>)>,
    /// The folder of the first root, with its slash; paths are shown from there.
    folder: &'a str,
}

impl<'a> Places<'a> {
    pub(super) fn new(sources: &'a Sources, roots: &[FileId]) -> Self {
        let starts = |text: &str| std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        let files = sources.iter().map(|(_, source)| (source, starts(&source.text))).collect();
        let root = roots.first().map_or("", |&root| sources.path(root));
        Self { sources, files, folder: &root[..root.rfind('/').map_or(0, |slash| slash + 1)] }
    }

    /// A file's path from the first root's folder, in the standard library from `std`; its name where it lies elsewhere.
    pub(super) fn path(&self, file: FileId) -> &'a str {
        let path = self.sources.path(file);
        match path.strip_prefix(self.folder) {
            Some(below) if !below.starts_with('/') => below,
            _ if path.starts_with("std/") => path,
            _ => path.rsplit('/').next().unwrap_or(path),
        }
    }

    /// The line on which a span begins, from 1.
    pub(super) fn line(&self, span: Span) -> usize {
        self.files
            .get(span.file.0 as usize)
            .map_or(1, |(_, starts)| starts.partition_point(|&start| start <= span.start as usize))
    }

    /// `file:line`
    pub(super) fn place(&self, span: Span) -> String {
        format!("{}:{}", self.path(span.file), self.line(span))
    }

    /// Source text as it stands, if that is on one line, and else put on one.
    pub(super) fn text(&self, span: Span) -> String {
        let text = self.sources.slice(span).trim();
        if text.contains(['\n', '\r']) {
            text.split_whitespace().collect::<Vec<_>>().join(" ")
        } else {
            text.to_owned()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_tell_nothing_of_the_machine() {
        let mut sources = Sources::default();
        let files = ["/home/me/robot/a.msd", "/home/me/robot/lib/b.fsfn", "/etc/c.msd", "std/robots/j5.msd"]
            .map(|path| sources.add(path, "one\ntwo\n"));
        let places = Places::new(&sources, &files);
        assert_eq!(files.map(|file| places.path(file)), ["a.msd", "lib/b.fsfn", "c.msd", "std/robots/j5.msd"]);
        assert_eq!(places.place(Span::new(files[0], 4, 5)), "a.msd:2");
        assert_eq!(places.place(Span::new(files[0], 3, 5)), "a.msd:1");
        let beside = Places::new(&sources, &files[3..]);
        assert_eq!(beside.path(files[3]), "j5.msd");
    }
}
