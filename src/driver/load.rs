//! Files, and the files they import.

use std::collections::HashMap;

use super::library;
use crate::base::{FileId, Sources, Span};
use crate::diag::{self, Diagnostic, rules};
use crate::sema::{Import, Unit};
use crate::syntax::{self, Memo, ast, ast::FileKind};

/// Where files come from: a disk, an editor's unsaved text, a test.
pub trait Files {
    /// The text of a file.
    fn read(&self, path: &str) -> Result<String, FileError>;

    /// The kind of a file; `None` for one that is not of the language.
    fn kind(&self, path: &str) -> Option<FileKind> {
        kind(path)
    }
}

/// Why a file's text cannot be had.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FileError {
    /// There is no such file.
    Missing,
    /// Its bytes are not UTF-8 from some byte on.
    NotUtf8 {
        /// The first byte that is no text.
        byte: usize,
    },
    /// Something else, in the system's words.
    Unreadable(String),
}

/// The largest file in bytes; places in text are 32-bit.
const LARGEST: usize = 256 << 20;

/// Files that were read and parsed, with what was found on the way.
#[derive(Debug)]
pub struct Loaded {
    pub(super) roots: Vec<FileId>,
    pub(super) sources: Sources,
    pub(super) units: Vec<Unit>,
    pub(super) findings: Vec<Diagnostic>,
}

/// Reads and parses `roots` and everything they import. Total. Linear in the size of the files, but for what was parsed
/// before.
pub fn load(memo: &mut Memo, files: &dyn Files, roots: &[String]) -> Loaded {
    let mut loader = Loader {
        memo,
        files,
        known: HashMap::new(),
        loaded: Loaded { roots: Vec::new(), sources: Sources::default(), units: Vec::new(), findings: Vec::new() },
    };
    for root in roots {
        let path = own(clean(root));
        let root = match loader.known.get(&path) {
            Some(known) => *known,
            None => {
                let text = loader.text(&path);
                loader.add(path, text)
            }
        };
        if let Some(root) = root
            && !loader.loaded.roots.contains(&root)
        {
            loader.loaded.roots.push(root);
        }
    }
    // Files found on the way are appended, so this walks through all of them.
    let mut next = 0;
    while next < loader.loaded.units.len() {
        loader.follow_imports(next);
        next += 1;
    }
    loader.loaded.findings.extend(cycles(&loader.loaded.units, &loader.loaded.sources));
    loader.loaded
}

struct Loader<'a> {
    memo: &'a mut Memo,
    files: &'a dyn Files,
    /// Every path that was asked for; `None` for one that could not be read.
    known: HashMap<String, Option<FileId>>,
    loaded: Loaded,
}

impl Loader<'_> {
    fn text(&self, path: &str) -> Result<String, FileError> {
        if path.starts_with(LIBRARY) {
            return library::find(path).map(str::to_owned).ok_or(FileError::Missing);
        }
        self.files.read(path)
    }

    /// Parses a file, or reports why it cannot be.
    fn add(&mut self, path: String, text: Result<String, FileError>) -> Option<FileId> {
        let (text, problem) = match text {
            Ok(text) if text.len() > LARGEST => (String::new(), Some(too_large(&path, text.len()))),
            Ok(text) => (text, None),
            Err(error) => (String::new(), Some(unreadable(&path, &error))),
        };
        let file = self.loaded.sources.add(path.clone(), text);
        let kind = self.files.kind(&path);
        let problem = problem.or_else(|| kind.is_none().then(|| unknown_kind(&path)));
        if let Some((rule, message, help)) = problem {
            let span = Span::new(file, 0, 0);
            self.loaded.findings.push(Diagnostic::new(rule, span, message).help_maybe(help));
            self.known.insert(path, None);
            return None;
        }
        let text = self.loaded.sources.get(file).map_or("", |source| source.text.as_str());
        let (tree, findings) = syntax::parse_again(self.memo, file, kind.unwrap_or(FileKind::Modes), text);
        let is_fault = |finding: &&Diagnostic| {
            [&rules::SYNTAX_ERROR, &rules::TOO_DEEP, &rules::KEYWORD_AS_NAME].contains(&finding.rule)
        };
        let faults = findings.iter().filter(is_fault).map(Diagnostic::span).collect();
        self.loaded.findings.extend(findings);
        self.loaded.units.push(Unit { file, tree, imports: Vec::new(), faults });
        self.known.insert(path, Some(file));
        Some(file)
    }

    fn follow_imports(&mut self, unit: usize) {
        let tree = &self.loaded.units[unit].tree;
        let imports: Vec<_> = tree
            .items
            .iter()
            .filter_map(|item| match item {
                ast::Item::Import(import) => Some(import.clone()),
                _ => None,
            })
            .collect();
        for import in imports {
            if let Some(file) = self.import(&import) {
                self.loaded.units[unit].imports.push(Import { file, span: import.span });
            }
        }
    }

    /// The file an import leads to.
    fn import(&mut self, import: &ast::Import) -> Option<FileId> {
        let importer = self.loaded.sources.path(import.span.file).to_owned();
        let name: Vec<_> = import.path.segments.iter().map(|name| name.text.as_str()).collect();
        let beside = match importer.rsplit_once('/') {
            Some((folder, _)) if name.first() != Some(&"std") => format!("{folder}/"),
            _ => String::new(),
        };
        let stem = clean(&format!("{beside}{}", name.join("/")));
        let of_library = name.first() == Some(&"std") || importer.starts_with(LIBRARY);
        let stem = if of_library { stem } else { own(stem) };
        let mut found = Vec::new();
        for path in [format!("{stem}.msd"), format!("{stem}.fsfn")] {
            if self.known.contains_key(&path) {
                found.push((path, None));
                continue;
            }
            match self.text(&path) {
                Err(FileError::Missing) => {}
                text => found.push((path, Some(text))),
            }
        }
        if found.len() > 1 {
            self.loaded.findings.push(ambiguous(import, &stem));
        }
        let Some((path, text)) = found.into_iter().next() else {
            self.loaded.findings.push(missing(import, &name.join("."), &stem));
            return None;
        };
        match text {
            Some(text) => self.add(path, text),
            None => self.known.get(&path).copied().flatten(),
        }
    }
}

/// Where the paths of the standard library begin.
const LIBRARY: &str = "std/";

/// The path of a file that is not of the library, though it may stand in a folder of that name.
fn own(path: String) -> String {
    if path.starts_with(LIBRARY) { format!("./{path}") } else { path }
}

/// A file in the canonical layout.
///
/// # Errors
/// The findings of a file that does not parse.
pub fn format(sources: &Sources, file: FileId) -> Result<String, Vec<Diagnostic>> {
    let text = sources.get(file).map_or("", |source| &source.text);
    match sources.path(file) {
        // Standard input has no ending that says what it holds.
        "-" => syntax::format(file, FileKind::Modes, text)
            .or_else(|findings| syntax::format(file, FileKind::Fusion, text).map_err(|_| findings)),
        path => syntax::format(file, kind(path).unwrap_or(FileKind::Modes), text),
    }
}

/// The kind of file a path names; `None` for one that is not of the language.
pub fn kind(path: &str) -> Option<FileKind> {
    match path.rsplit_once('.').map(|(_, ending)| ending) {
        Some("msd") => Some(FileKind::Modes),
        Some("fsfn") => Some(FileKind::Fusion),
        _ if path == "-" => Some(FileKind::Modes),
        _ => None,
    }
}

/// A path without `.` and without `..` behind a folder, so that one file has one name.
fn clean(path: &str) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for (index, part) in path.split('/').enumerate() {
        match part {
            "" if index > 0 => {}
            "." => {}
            ".." if parts.last().is_some_and(|last| !last.is_empty() && *last != "..") => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

type Problem = (&'static diag::Rule, String, Option<String>);

fn unreadable(path: &str, error: &FileError) -> Problem {
    match error {
        FileError::Missing => (&rules::UNREADABLE_FILE, format!("there is no file `{path}`"), None),
        FileError::Unreadable(reason) => (&rules::UNREADABLE_FILE, format!("`{path}` cannot be read: {reason}"), None),
        FileError::NotUtf8 { byte } => {
            let help = Some("save it as UTF-8".to_owned());
            (&rules::NOT_UTF8, format!("`{path}` is not UTF-8 text from byte {byte} on"), help)
        }
    }
}

fn too_large(path: &str, bytes: usize) -> Problem {
    let message = format!("`{path}` has {bytes} bytes; the most is {LARGEST}");
    (&rules::FILE_TOO_LARGE, message, Some("split it into several files".to_owned()))
}

fn unknown_kind(path: &str) -> Problem {
    let help = "modes, robots and scenarios stand in `.msd` files, variables and networks in `.fsfn` files";
    (&rules::UNKNOWN_FILE_KIND, format!("`{path}` ends neither in `.msd` nor in `.fsfn`"), Some(help.to_owned()))
}

fn missing(import: &ast::Import, name: &str, stem: &str) -> Diagnostic {
    let span = import.path.span;
    if name == "std" || name.starts_with("std.") {
        let names: Vec<_> = library::names().collect();
        let help = diag::did_you_mean(name, names.iter().map(String::as_str));
        let message = format!("the standard library has no `{name}`");
        let diagnostic = Diagnostic::new(&rules::MISSING_IMPORT, span, message).help_maybe(help);
        return diagnostic.note(format!("it has: {}", names.join(", ")));
    }
    let diagnostic =
        Diagnostic::new(&rules::MISSING_IMPORT, span, format!("no file beside this one is named `{name}`"))
            .note(format!("looked for `{stem}.msd` and `{stem}.fsfn`"));
    let of_library = library::names().find(|known| known.ends_with(&format!(".{name}")));
    match (name.strip_suffix(".msd").or(name.strip_suffix(".fsfn")), of_library) {
        (Some(name), _) => diagnostic.help(format!("write `import {name}`, without the ending")),
        (None, Some(known)) => diagnostic.help(format!("write `import {known}` for the one of the standard library")),
        (None, None) => diagnostic,
    }
}

fn ambiguous(import: &ast::Import, stem: &str) -> Diagnostic {
    let message = format!("there is a `{stem}.msd` and a `{stem}.fsfn`");
    Diagnostic::new(&rules::AMBIGUOUS_IMPORT, import.path.span, message)
        .note("an import names a file without its ending")
        .help("rename one of them")
}

/// One finding for each import that closes a circle.
fn cycles(units: &[Unit], sources: &Sources) -> Vec<Diagnostic> {
    #[derive(Clone, Copy, PartialEq)]
    enum State {
        New,
        Open,
        Closed,
    }
    let places: HashMap<FileId, usize> = units.iter().enumerate().map(|(place, unit)| (unit.file, place)).collect();
    let mut states = vec![State::New; units.len()];
    let mut findings = Vec::new();
    for start in 0..units.len() {
        if states[start] != State::New {
            continue;
        }
        // The way from the start to here: units, and how many of their imports were followed.
        let mut way = vec![(start, 0)];
        states[start] = State::Open;
        while let Some((unit, followed)) = way.last_mut() {
            let (unit, import) = (*unit, units[*unit].imports.get(*followed).copied());
            *followed += 1;
            let Some(import) = import else {
                states[unit] = State::Closed;
                way.pop();
                continue;
            };
            let Some(&target) = places.get(&import.file) else { continue };
            match states[target] {
                State::Closed => {}
                State::New => {
                    states[target] = State::Open;
                    way.push((target, 0));
                }
                State::Open => {
                    let first = way.iter().position(|&(unit, _)| unit == target).unwrap_or_default();
                    let circle: Vec<_> = way[first..].iter().map(|&(unit, _)| sources.path(units[unit].file)).collect();
                    findings.push(cycle(import.span, &circle));
                }
            }
        }
    }
    findings
}

fn cycle(import: Span, circle: &[&str]) -> Diagnostic {
    let message = match circle {
        [_] => "this file imports itself".to_owned(),
        _ => "this import closes a circle of files".to_owned(),
    };
    let whole: Vec<_> = circle.iter().chain(circle.first()).map(|path| format!("`{path}`")).collect();
    Diagnostic::new(&rules::IMPORT_CYCLE, import, message)
        .note(format!("the circle: {}", whole.join(" imports ")))
        .help("move what both need into a file of its own")
}

#[cfg(test)]
mod tests {
    use super::clean;

    #[test]
    fn one_file_has_one_path() {
        assert_eq!(clean("./a/./b/../c.msd"), "a/c.msd");
        assert_eq!(clean("../a.msd"), "../a.msd");
        assert_eq!(clean("a/../../b.msd"), "../b.msd");
        assert_eq!(clean("/a//b.msd"), "/a/b.msd");
    }
}
