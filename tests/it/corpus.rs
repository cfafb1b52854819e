//! Cases as files: the findings are written on the lines they belong to, their wording is kept in a snapshot beside.
//!
//! `//~ error LM0301, warning LM0404` at the end of a line names every finding whose primary label starts on it. A
//! file without such a comment raises nothing at all, but what is only worth knowing is told of the codes that the file
//! names alone. A folder with a `main.msd` is one case of several files.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use lmslc::diag::{Diagnostic, RULES, Severity};
use lmslc::driver::Analysis;

use crate::support::{analyze_path, files_below, root};

const FOLDERS: [&str; 6] = ["files", "names", "units", "modes", "fuzzy", "scenarios"];

/// Rules that no text of the language raises, only files, arguments and faults of the compiler. The tests of the
/// command line show them.
const NOT_FROM_TEXT: [&str; 7] = ["LM0001", "LM0002", "LM0005", "LM0007", "LM0008", "LM0802", "LM9901"];

/// The file to analyze for each case, as a path from the repository's root.
fn cases() -> Vec<String> {
    let mut cases = Vec::new();
    for folder in FOLDERS {
        let below = format!("tests/corpus/{folder}");
        for path in files_below(&below, &["msd", "fsfn"]) {
            let inside = path.strip_prefix(&format!("{below}/")).unwrap();
            if !inside.contains('/') || inside.ends_with("/main.msd") {
                cases.push(path);
            }
        }
    }
    cases
}

/// A finding as the comments tell it: path, line, severity, code.
type Told = (String, usize, String, String);

/// What the comments of a file expect, one entry a finding.
fn expected(path: &str, text: &str) -> Vec<Told> {
    let mut expected = Vec::new();
    for (line, number) in text.lines().zip(1..) {
        let Some((_, findings)) = line.split_once("//~") else { continue };
        for finding in findings.split(',') {
            let (severity, code) = finding.trim().split_once(' ').unwrap_or_else(|| panic!("{path}:{number}"));
            assert!(matches!(severity, "error" | "warning" | "info"), "{path}:{number}: {severity}");
            expected.push((path.to_owned(), number, severity.to_owned(), code.to_owned()));
        }
    }
    expected
}

fn found(analysis: &Analysis) -> Vec<Told> {
    let told = |finding: &Diagnostic| {
        let span = finding.span();
        let (line, _) = analysis.sources.position(span.file, span.start);
        let (severity, code) = (finding.severity.name().to_owned(), finding.rule.code.to_owned());
        (analysis.sources.path(span.file).to_owned(), line, severity, code)
    };
    analysis.findings.iter().map(told).collect()
}

/// The findings of one case, with all of its files' comments compared.
fn check(path: &str) -> Result<Analysis, String> {
    let analysis = analyze_path(path);
    let mut expected: Vec<Told> = analysis
        .sources
        .iter()
        .filter(|(_, source)| !source.path.starts_with("std/"))
        .flat_map(|(_, source)| expected(&source.path, &source.text))
        .collect();
    let mut found = found(&analysis);
    found.retain(|told| told.2 != "info" || expected.iter().any(|other| other.3 == told.3));
    expected.sort();
    found.sort();
    if expected == found {
        return Ok(analysis);
    }
    let mut difference = format!("{path}\n");
    for side in [&expected, &found] {
        let (word, other) = if side == &expected { ("missing", &found) } else { ("not expected", &expected) };
        let mut left = other.clone();
        for told in side {
            match left.iter().position(|other| other == told) {
                Some(place) => drop(left.remove(place)),
                None => writeln!(difference, "  {word}: {}:{}: {} {}", told.0, told.1, told.2, told.3).unwrap(),
            }
        }
    }
    Err(difference + &crate::support::report(&analysis))
}

/// The findings for people. The wording of what does not parse belongs to the tests of the parser.
fn wording(analysis: &Analysis) -> String {
    let named = |code: &str| analysis.sources.iter().any(|(_, source)| source.text.contains(&format!("info {code}")));
    let own = |finding: &&Diagnostic| {
        let code = finding.rule.code;
        let told = finding.severity > Severity::Info || named(code);
        told && (!code.starts_with("LM01") || code == "LM0105")
    };
    let findings: Vec<_> = analysis.findings.iter().filter(own).cloned().collect();
    lmslc::report::human(&findings, &analysis.sources, false)
}

#[test]
fn every_case_has_the_findings_on_its_lines_and_no_others() {
    let cases = cases();
    assert!(cases.len() > 70, "{}", cases.len());
    let wrong: Vec<_> = cases.iter().filter_map(|path| check(path).err()).collect();
    assert!(wrong.is_empty(), "{} cases differ\n\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn every_message_reads_as_it_was_accepted() {
    let mut kept = BTreeSet::new();
    for path in cases() {
        let text = wording(&analyze_path(&path));
        if text.is_empty() {
            continue;
        }
        let (folder, file) = path.rsplit_once('/').unwrap();
        let (folder, name) = match file {
            "main.msd" => folder.rsplit_once('/').unwrap(),
            file => (folder, file),
        };
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path(root().join(folder));
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| insta::assert_snapshot!(name, text));
        kept.insert(format!("{folder}/{name}.snap"));
    }
    let on_disk: BTreeSet<_> =
        FOLDERS.iter().flat_map(|folder| files_below(&format!("tests/corpus/{folder}"), &["snap"])).collect();
    let idle: Vec<_> = on_disk.difference(&kept).collect();
    assert!(idle.is_empty(), "snapshots of no case: {idle:?}");
}

#[test]
fn every_rule_that_text_can_raise_is_raised() {
    let raised: BTreeSet<String> = cases()
        .iter()
        .flat_map(|path| {
            let folder = path.strip_suffix("/main.msd").map(str::to_owned);
            let paths = folder.map_or(vec![path.clone()], |folder| files_below(&folder, &["msd", "fsfn"]));
            paths.into_iter().flat_map(|path| {
                let text = std::fs::read_to_string(root().join(&path)).unwrap();
                expected(&path, &text).into_iter().map(|told| told.3)
            })
        })
        .collect();
    for rule in RULES {
        let from_text = !NOT_FROM_TEXT.contains(&rule.code);
        assert_eq!(raised.contains(rule.code), from_text, "{}: {}", rule.code, rule.name);
    }
}

#[test]
fn at_most_one_line_of_a_comment_is_read() {
    let told = expected("a.msd", "x //~ error LM0301, warning LM0404\ny // no\n");
    let told: Vec<_> = told.iter().map(|(_, line, severity, code)| (*line, severity.as_str(), code.as_str())).collect();
    assert_eq!(told, [(1, "error", "LM0301"), (1, "warning", "LM0404")]);
}
