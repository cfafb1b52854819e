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
    pub text: String,
}

impl Fence {
    /// Whether it is text of the language, of either kind.
    pub fn is_program(&self) -> bool {
        matches!(self.tag.as_str(), "msd" | "fsfn" | "msd,later" | "fsfn,later")
    }

    /// The path under which it is analyzed.
    pub fn path(&self) -> String {
        let ending = self.tag.trim_end_matches(",later");
        self.file.clone().unwrap_or_else(|| format!("page.{ending}"))
    }
}

/// The fenced blocks of a Markdown page, in order.
pub fn fences(page: &str) -> Vec<Fence> {
    let mut fences: Vec<Fence> = Vec::new();
    let (mut section, mut open) = (String::new(), false);
    for (line, number) in page.lines().zip(1..) {
        match line.strip_prefix("```") {
            Some(_) if open => open = false,
            Some(info) => {
                let tag = info.split(' ').next().unwrap().to_owned();
                let file = info.split_once("file=").map(|(_, file)| file.trim().to_owned());
                fences.push(Fence { line: number + 1, section: section.clone(), tag, file, text: String::new() });
                open = true;
            }
            None if open => {
                let text = &mut fences.last_mut().unwrap().text;
                text.push_str(line);
                text.push('\n');
            }
            None => {
                if let Some(heading) = line.strip_prefix("## ") {
                    heading.trim().clone_into(&mut section);
                }
            }
        }
    }
    assert!(!open, "a fence is not closed");
    fences
}

/// Analyzes the last of some fences; those before it are the files it may import.
pub fn analyze_fences(fences: &[&Fence]) -> Analysis {
    let texts: Vec<_> = fences.iter().rev().map(|fence| (fence.path(), fence.text.as_str())).collect();
    let texts: Vec<_> = texts.iter().map(|(path, text)| (path.as_str(), *text)).collect();
    analyze_texts(&texts)
}
