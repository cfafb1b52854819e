//! The texts that the editor has open, over the disk.

use std::collections::BTreeMap;
use std::rc::Rc;

use lsp_types::{Diagnostic, TextDocumentContentChangeEvent, Uri};

use super::folder::Folder;
use super::known::Known;
use super::{Desk, Lines};
use crate::diag::Levels;
use crate::driver::{self, FileError, Files};
use crate::syntax::{self, ast::FileKind};

/// A text that is open, and what is known of it.
pub(super) struct Document {
    /// As the client calls it.
    pub(super) uri: Uri,
    pub(super) text: String,
    pub(super) version: i32,
    pub(super) levels: Levels,
    /// An analysis of the text as it stands; `None` after a change.
    pub(super) known: Option<Rc<Known>>,
    /// Whether that has all that is wanted: its properties were looked at too, or there are none.
    pub(super) is_thorough: bool,
    /// What the client was told last.
    pub(super) told: Option<Vec<Diagnostic>>,
    /// Whether that is what is known now.
    pub(super) is_told: bool,
}

impl Document {
    /// Takes over a change of the whole text or of a part of it.
    pub(super) fn change(&mut self, change: TextDocumentContentChangeEvent) {
        let Some(range) = change.range else {
            self.text = change.text;
            return;
        };
        let lines = Lines::new(&self.text);
        let (start, end) = (lines.byte(&self.text, range.start), lines.byte(&self.text, range.end));
        self.text.replace_range(start..end.max(start), &change.text);
    }
}

/// The open documents by their paths.
#[derive(Default)]
pub(super) struct Documents {
    pub(super) open: BTreeMap<String, Document>,
}

impl Documents {
    /// Whether that is what is known of a document now.
    pub(super) fn is_current(&self, path: &str, known: &Rc<Known>) -> bool {
        let document = self.open.get(path).and_then(|document| document.known.as_ref());
        document.is_some_and(|current| Rc::ptr_eq(current, known))
    }

    /// A document with properties that were not looked at: its path, what is known of it, and its levels.
    pub(super) fn unproved(&self) -> Option<(String, Rc<Known>, Levels)> {
        self.open.iter().find_map(|(path, document)| {
            let known = document.known.as_ref().filter(|_| !document.is_thorough)?;
            Some((path.clone(), Rc::clone(known), document.levels.clone()))
        })
    }

    /// Forgets what is known of the documents that a file takes part in.
    pub(super) fn forget(&mut self, path: &str) {
        for (name, document) in &mut self.open {
            if name == path || document.known.as_ref().is_some_and(|known| known.file(path).is_some()) {
                document.known = None;
            }
        }
    }

    /// Forgets what is known of all: a file has come or gone.
    pub(super) fn forget_all(&mut self) {
        for document in self.open.values_mut() {
            document.known = None;
        }
    }
}

/// Open texts, and the disk where nothing is open.
pub(super) struct Overlay<'a> {
    pub(super) documents: &'a Documents,
    pub(super) folder: &'a Folder,
    pub(super) desk: &'a dyn Desk,
}

impl Files for Overlay<'_> {
    fn read(&self, path: &str) -> Result<String, FileError> {
        match self.documents.open.get(path) {
            Some(document) => Ok(document.text.clone()),
            None => self.desk.read(&self.folder.on_disk(path)),
        }
    }

    fn kind(&self, path: &str) -> Option<FileKind> {
        driver::kind(path).or_else(|| self.documents.open.get(path).map(|document| syntax::kind_of(&document.text)))
    }
}

/// Some texts over all others: files as they would be after a change.
pub(super) struct Changed<'a> {
    pub(super) texts: BTreeMap<String, String>,
    pub(super) under: Overlay<'a>,
}

impl Files for Changed<'_> {
    fn read(&self, path: &str) -> Result<String, FileError> {
        self.texts.get(path).map_or_else(|| self.under.read(path), |text| Ok(text.clone()))
    }

    fn kind(&self, path: &str) -> Option<FileKind> {
        self.under.kind(path)
    }
}
