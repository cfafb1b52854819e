//! What is very long, very deep or cut off anywhere is still read, and answered.

use std::fmt::Write as _;

use lmslc::diag::Severity;

use crate::support::{analyze_texts, clean, report, root};

/// A behavior with so many modes, five lines each, one leading to the next.
fn long_behavior(modes: usize) -> String {
    let mut text = "import std.robots.j5\n\nbehavior long on j5 {\n    entry m0\n".to_owned();
    for mode in 0..modes {
        let next = (mode + 1) % modes;
        write!(
            text,
            "    mode m{mode} {{\n        drive(26 cm/s)\n        1: contact_force > 115 N and after 2 s -> m0\n        \
             2: after 5 s -> m{next}\n    }}\n"
        )
        .unwrap();
    }
    text + "}\n"
}

#[test]
fn a_hundred_thousand_lines_are_a_file_like_any_other() {
    let text = long_behavior(20_000);
    assert!(text.lines().count() > 100_000);
    let analysis = clean("long.msd", &text);
    assert_eq!(analysis.program.diagrams.values().next().unwrap().modes.len(), 20_000);
}

#[test]
fn thousands_of_misspelt_names_are_thousands_of_findings() {
    let text = long_behavior(2_000).replace("-> m", "-> mode_");
    let analysis = analyze_texts(&[("long.msd", &text)]);
    assert_eq!(analysis.findings.len(), 4_000);
    assert!(analysis.findings.iter().all(|finding| finding.rule.code == "LM0201"));
    assert_eq!(report(&analysis).matches("error[LM0201]").count(), 4_000);
}

fn with_flag(condition: &str) -> String {
    format!(
        "import std.robots.j5\n\nbehavior wander on j5 {{\n    flag pressed = {condition}\n\n    entry go\n\n    \
         mode go {{\n        drive(26 cm/s)\n        1: pressed -> again\n    }}\n}}\n"
    )
}

#[test]
fn ten_thousand_parentheses_are_too_many_and_one_finding() {
    let condition = format!("{}contact_force > 100 N{}", "(".repeat(10_000), ")".repeat(10_000));
    let analysis = analyze_texts(&[("deep.msd", &with_flag(&condition))]);
    let codes: Vec<_> = analysis.findings.iter().map(|finding| finding.rule.code).collect();
    assert_eq!(codes, ["LM0102"]);
    let halves = ["(".repeat(10_000), ")".repeat(10_000), "not ".repeat(10_000), "{".repeat(10_000)];
    for half in halves {
        let analysis = analyze_texts(&[("deep.msd", &with_flag(&half))]);
        assert!(analysis.has_errors(), "{}", &half[..4]);
    }
}

#[test]
fn a_hundred_thousand_conditions_in_a_row_are_none_too_many() {
    clean("wide.msd", &with_flag(&vec!["contact_force > 100 N"; 100_000].join(" and ")));
}

/// Whether a text can be a whole file: nothing is open, and its last line of code ends a declaration.
fn may_be_whole(prefix: &str, whole: &str) -> bool {
    let code = |text: &str| {
        let lines = text.lines().map(|line| line.split("//").next().unwrap().trim_end().to_owned());
        lines.filter(|line| !line.is_empty()).collect::<Vec<_>>()
    };
    let (lines, whole) = (code(prefix), code(whole));
    let depth: i32 =
        lines.iter().flat_map(|line| line.chars()).map(|c| i32::from(c == '{') - i32::from(c == '}')).sum();
    let last = lines.last().map_or("", String::as_str);
    let is_import = last.starts_with("import ") && whole.iter().any(|line| line == last);
    depth == 0 && (lines.is_empty() || is_import || last.ends_with('}'))
}

fn every_prefix_is_answered(path: &str) {
    let text = std::fs::read_to_string(root().join(path)).unwrap();
    let name = path.rsplit('/').next().unwrap();
    let mut broken = 0;
    for (end, _) in text.char_indices() {
        let prefix = &text[..end];
        let analysis = analyze_texts(&[(name, prefix)]);
        let errors = analysis.findings.iter().filter(|finding| finding.severity == Severity::Error).count();
        if !may_be_whole(prefix, &text) {
            broken += 1;
            assert!(errors > 0, "no error in the first {end} bytes of {path}:\n{prefix}");
        } else if errors == 0 {
            assert!(analysis.checked().is_some());
        }
        // A brace that stays open is one fault, half a word where the text ends another.
        assert!(errors <= 2, "the first {end} bytes of {path}\n{}", report(&analysis));
    }
    assert!(broken > 500, "{broken}");
}

#[test]
fn a_scenario_may_be_cut_off_anywhere() {
    every_prefix_is_answered("examples/j5/manipulation.msd");
}

#[test]
fn a_network_may_be_cut_off_anywhere() {
    every_prefix_is_answered("stdlib/networks/obstacle_id.fsfn");
}
