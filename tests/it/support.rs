//! What tests share: files from memory and from the repository.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use lmslc::diag::{Diagnostic, Severity};
use lmslc::driver::{Analysis, FileError, Files, Options, analyze};

/// Files that stand only here.
pub struct Memory(HashMap<String, String>);

impl Memory {
    pub fn new(texts: &[(&str, &str)]) -> Self {
        Self(texts.iter().map(|(path, text)| ((*path).to_owned(), (*text).to_owned())).collect())
    }
}

impl Files for Memory {
    fn read(&self, path: &str) -> Result<String, FileError> {
        self.0.get(path).cloned().ok_or(FileError::Missing)
    }
}

/// Files of the repository, by their path from its root.
pub struct Repository;

impl Files for Repository {
    fn read(&self, path: &str) -> Result<String, FileError> {
        match std::fs::read(root().join(path)) {
            Ok(bytes) => {
                String::from_utf8(bytes).map_err(|error| FileError::NotUtf8 { byte: error.utf8_error().valid_up_to() })
            }
            Err(_) => Err(FileError::Missing),
        }
    }
}

pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Analyzes texts under their paths; the first one is asked for.
pub fn analyze_texts(texts: &[(&str, &str)]) -> Analysis {
    analyze(&Memory::new(texts), &[texts[0].0.to_owned()], &Options::default())
}

/// Analyzes one text and demands that nothing is found.
pub fn clean(path: &str, text: &str) -> Analysis {
    let analysis = analyze_texts(&[(path, text)]);
    assert!(doubts(&analysis).is_empty(), "{}", report(&analysis));
    analysis
}

/// What was found, without what is only worth knowing.
pub fn doubts(analysis: &Analysis) -> Vec<&Diagnostic> {
    analysis.findings.iter().filter(|finding| finding.severity > Severity::Info).collect()
}

/// The findings as a user sees them.
pub fn report(analysis: &Analysis) -> String {
    lmslc::report::human(&analysis.findings, &analysis.sources, false)
}

/// Analyzes a file of the repository.
pub fn analyze_path(path: &str) -> Analysis {
    analyze(&Repository, &[path.to_owned()], &Options::default())
}

/// The files below a folder of the repository with one of these endings, sorted, as paths from its root.
pub fn files_below(folder: &str, endings: &[&str]) -> Vec<String> {
    fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(&path, found);
            } else {
                found.push(path);
            }
        }
    }
    let mut found = Vec::new();
    walk(&root().join(folder), &mut found);
    let fits = |path: &PathBuf| path.extension().is_some_and(|ending| endings.contains(&ending.to_str().unwrap()));
    let mut paths: Vec<_> = found
        .into_iter()
        .filter(fits)
        .map(|path| path.strip_prefix(root()).unwrap().to_str().unwrap().to_owned())
        .collect();
    paths.sort();
    paths
}

/// Demands that a picture of the documentation is what is drawn now. With `UPDATE_PICTURES=1` it is redrawn.
pub fn keep_picture(path: &Path, drawn: &str) {
    if std::env::var("UPDATE_PICTURES").is_ok() {
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, drawn).unwrap();
    }
    let kept = std::fs::read_to_string(path).unwrap_or_default();
    assert!(kept == drawn, "{} is out of date; UPDATE_PICTURES=1 cargo test redraws it", path.display());
}

/// A fenced block of a Markdown page.
#[derive(Debug, Clone)]
pub struct Fence {
    /// The line of the page on which its text begins.
    pub line: usize,
    /// The heading of level two above it.
    pub section: String,
    /// The first word behind the backticks: `msd`, `fsfn,later`, `text`.
    pub tag: String,
    /// The file it is, where it says so: `file=bump.fsfn`.
    pub file: Option<String>,
    /// Whether it is a part of a file that is there already, made by a command: `file=bump.rs part`.
    pub is_part: bool,
    /// What it says; behind `file=bump.fsfn change` the whole file as it is with that change.
    pub text: String,
}

impl Fence {
    /// Whether it is text of the language, of either kind.
    pub fn is_program(&self) -> bool {
        matches!(self.tag.split(',').next(), Some("msd" | "fsfn"))
    }

    /// The path under which it is analyzed.
    pub fn path(&self) -> String {
        let ending = self.tag.split(',').next().unwrap();
        self.file.clone().unwrap_or_else(|| format!("page.{ending}"))
    }
}

/// The fenced blocks of a Markdown page, in order.
pub fn fences(page: &str) -> Vec<Fence> {
    let mut fences: Vec<Fence> = Vec::new();
    let mut section = String::new();
    let mut lines = page.lines().zip(1..);
    while let Some((line, number)) = lines.next() {
        if let Some(heading) = line.strip_prefix("## ") {
            heading.trim().clone_into(&mut section);
        }
        let Some(info) = line.strip_prefix("```") else { continue };
        let mut text = String::new();
        loop {
            match lines.next().expect("a fence is not closed") {
                ("```", _) => break,
                (line, _) => text += &format!("{line}\n"),
            }
        }
        let mut words = info.split(' ');
        let tag = words.next().unwrap().to_owned();
        let file = words.find_map(|word| word.strip_prefix("file=")).map(str::to_owned);
        let is_part = match words.next() {
            None => false,
            Some("part") => true,
            Some("change") => {
                let before = fences.iter().rfind(|fence| fence.file == file).expect("a file to change");
                text = changed(&before.text, &text);
                false
            }
            Some(other) => panic!("line {number}: `{other}`"),
        };
        fences.push(Fence { line: number + 1, section: section.clone(), tag, file, is_part, text });
    }
    fences
}

/// A file in which declarations take the place of the one that begins like their first, or stand at the end.
fn changed(before: &str, change: &str) -> String {
    let is_comment = |line: &&str| line.trim_start().starts_with("//");
    let first = change.lines().find(|line| !is_comment(line)).unwrap();
    let name = |line: &str| {
        let words = line.split(|c: char| c.is_whitespace() || c == ':').filter(|word| !word.is_empty());
        words.take(2).map(str::to_owned).collect::<Vec<_>>()
    };
    let lines: Vec<&str> = before.lines().collect();
    let Some(found) = lines.iter().position(|line| name(line) == name(first)) else {
        return format!("{before}\n{change}");
    };
    let start = found - lines[..found].iter().rev().take_while(|line| is_comment(line)).count();
    let indentation = |line: &str| line.len() - line.trim_start().len();
    let closes = |line: &&str| line.trim() == "}" && indentation(line) == indentation(lines[found]);
    let end = if lines[found].trim_end().ends_with('{') {
        found + 1 + lines[found..].iter().position(closes).unwrap()
    } else {
        found + 1
    };
    let [above, below] = [&lines[..start], &lines[end..]].map(|part| part.iter().map(|line| format!("{line}\n")));
    above.chain([change.to_owned()]).chain(below).collect()
}

/// Analyzes the last of some fences; those before it are the files it may import, as they stand last.
pub fn analyze_fences(fences: &[&Fence]) -> Analysis {
    let mut texts: Vec<(String, &str)> = Vec::new();
    for fence in fences.iter().rev() {
        if texts.iter().all(|(path, _)| *path != fence.path()) {
            texts.push((fence.path(), &fence.text));
        }
    }
    let texts: Vec<_> = texts.iter().map(|(path, text)| (path.as_str(), *text)).collect();
    analyze_texts(&texts)
}
