//! Every diagnostic has a page whose example raises it and whose correction does not.

use std::collections::BTreeSet;

use lmslc::diag::{RULES, Rule, Severity};

use crate::support::{Fence, analyze_fences, fences, report, root};

/// Pages about files, arguments and faults of the compiler: no text of the language raises these.
const NO_PROGRAM: [&str; 7] = ["LM0001", "LM0002", "LM0005", "LM0007", "LM0008", "LM0802", "LM9901"];

fn page(code: &str) -> String {
    let path = format!("docs/errors/{code}.md");
    std::fs::read_to_string(root().join(&path)).unwrap_or_else(|_| panic!("{path} is missing"))
}

/// The programs under a heading. A case of several files has them all, the one to check last.
fn programs(fences: &[Fence], section: &str) -> Vec<Fence> {
    fences.iter().filter(|fence| fence.section == section && fence.is_program()).cloned().collect()
}

/// What programs raise; of what is only worth knowing, that of one rule.
fn codes(programs: &[Fence], of: &Rule) -> (BTreeSet<&'static str>, String) {
    let analysis = analyze_fences(&programs.iter().collect::<Vec<_>>());
    let told = analysis.findings.iter().filter(|finding| finding.severity > Severity::Info || finding.rule == of);
    (told.map(|finding| finding.rule.code).collect(), report(&analysis))
}

#[test]
fn every_rule_has_a_page_of_its_own() {
    for rule in RULES {
        let text = page(rule.code);
        assert!(text.starts_with(&format!("# {}: {}\n\n", rule.code, rule.name)), "{}", rule.code);
        assert_eq!(text, rule.page, "{}: the embedded page is the one on disk", rule.code);
        let headings: Vec<_> = text.lines().filter(|line| line.starts_with("## ")).collect();
        assert_eq!(headings, ["## Example", "## Correction"], "{}", rule.code);
    }
    let codes: BTreeSet<_> = RULES.iter().map(|rule| rule.code).collect();
    let names: BTreeSet<_> = RULES.iter().map(|rule| rule.name).collect();
    assert_eq!((codes.len(), names.len()), (RULES.len(), RULES.len()), "a code or a name is used twice");
    for entry in std::fs::read_dir(root().join("docs/errors")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(name == "README.md" || codes.contains(name.trim_end_matches(".md")), "{name} is the page of no rule");
    }
}

#[test]
fn every_example_raises_its_rule_and_no_correction_raises_any() {
    let mut wrong = Vec::new();
    for rule in RULES {
        let fences = fences(&page(rule.code));
        let (bad, good) = (programs(&fences, "Example"), programs(&fences, "Correction"));
        assert_eq!(bad.is_empty(), NO_PROGRAM.contains(&rule.code), "{}", rule.code);
        assert_eq!(bad.is_empty(), good.is_empty(), "{}", rule.code);
        if bad.is_empty() {
            continue;
        }
        let (found, text) = codes(&bad, rule);
        // A mode is cut off by transitions that are never taken, and each of them is a finding too.
        let with = if rule.code == "LM0414" { Some("LM0402") } else { None };
        if found != with.into_iter().chain([rule.code]).collect() {
            wrong.push(format!("{}: the example raises {found:?}\n{text}", rule.code));
        }
        let (found, text) = codes(&good, rule);
        if !found.is_empty() {
            wrong.push(format!("{}: the correction raises {found:?}\n{text}", rule.code));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_index_lists_every_rule() {
    let mut expected = "# Diagnostics\n\nEvery finding has a code, a name and a page. `lmslc explain LM0403` or \
        `lmslc explain duplicate-priority` prints the page. `lmsl.toml`, flags and comments in the source change the level \
        of those that are warnings: see [levels](../ci.md#levels).\n\n\
        | code | name | level | found when |\n|---|---|---|---|\n"
        .to_owned();
    for rule in RULES {
        let (code, name, level) = (rule.code, rule.name, rule.level.name());
        expected += &format!("| [{code}]({code}.md) | `{name}` | {level} | {} |\n", rule.summary);
    }
    let found = std::fs::read_to_string(root().join("docs/errors/README.md")).unwrap_or_default();
    assert!(found == expected, "copy this text to docs/errors/README.md:\n{expected}");
}

#[test]
fn the_page_of_units_lists_every_unit() {
    let text = page("LM0302");
    for unit in lmslc::base::UNITS {
        assert!(text.contains(&format!("`{}`", unit.name)), "LM0302.md does not list `{}`", unit.name);
    }
}
