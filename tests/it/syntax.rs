//! Parsing of both kinds of file: what is sound, what is broken, and what is absurd.

use std::path::{Path, PathBuf};

use lmslc::base::{FileId, Sources};
use lmslc::diag::Diagnostic;
use lmslc::syntax::ast::{File, FileKind};
use lmslc::syntax::parse;

fn kind_of(path: &Path) -> FileKind {
    if path.extension().is_some_and(|extension| extension == "fsfn") { FileKind::Fusion } else { FileKind::Modes }
}

fn corpus(folder: &str) -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/syntax").join(folder);
    let mut paths: Vec<_> = std::fs::read_dir(root).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "fsfn" || extension == "msd"));
    paths.sort();
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).unwrap();
        (path, text)
    };
    paths.into_iter().map(read).collect()
}

fn parse_modes(text: &str) -> (File, Vec<Diagnostic>) {
    parse(FileId(0), FileKind::Modes, text)
}

/// Each finding with its place and the line it stands on.
fn render(path: &str, text: &str, diagnostics: &[Diagnostic]) -> String {
    use std::fmt::Write as _;
    let mut sources = Sources::default();
    let file = sources.add(path, text);
    let mut shown = String::new();
    for diagnostic in diagnostics {
        let (line, column) = sources.position(file, diagnostic.span().start);
        let source = text.lines().nth(line - 1).unwrap_or("");
        let marks = "^".repeat((diagnostic.span().end - diagnostic.span().start).max(1) as usize);
        writeln!(shown, "{line}:{column} {} {}", diagnostic.rule.code, diagnostic.message).unwrap();
        writeln!(shown, "    {source}\n    {}{marks}", " ".repeat(column - 1)).unwrap();
        for label in diagnostic.labels.iter().skip(1) {
            let (line, column) = sources.position(file, label.span.start);
            writeln!(shown, "    {line}:{column} {}", label.message).unwrap();
        }
        if let Some(help) = &diagnostic.help {
            writeln!(shown, "    help: {help}").unwrap();
        }
    }
    shown
}

#[test]
fn sound_files_parse_without_findings() {
    for (path, text) in corpus("pass") {
        let (_, diagnostics) = parse(FileId(0), kind_of(&path), &text);
        assert_eq!(render("", &text, &diagnostics), "", "{}", path.display());
    }
}
