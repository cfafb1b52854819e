//! What a continuous integration relies on: machine formats, levels, suppressions, fixes and exit codes.

use std::path::Path;
use std::process::{Command, Output};

use lmslc::diag::{Level, Levels, find_rule};
use lmslc::driver::{Analysis, Options, analyze};
use lmslc::report;
use serde_json::Value;

use crate::support::{Repository, files_below, root};

/// `parked` is a dead end and `lost` is unreachable; the first import is unused.
const WANDER: &str = "import std.networks.obstacle_id
import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 5 s -> parked
    }
    mode parked {
        halt()
    }
    mode lost {
        halt()
        1: after 1 s -> go
    }
}
";

fn lmslc(folder: &Path, arguments: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lmslc"));
    command.args(arguments.split_whitespace()).current_dir(folder).env("COLUMNS", "100").env("NO_COLOR", "1");
    command.output().unwrap()
}

fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (path, text) in files {
        std::fs::write(folder.path().join(path), text).unwrap();
    }
    folder
}

/// The exit code, and standard output followed by standard error.
fn answer(folder: &Path, arguments: &str) -> (i32, String) {
    let output = lmslc(folder, arguments);
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap()).concat();
    (output.status.code().unwrap(), text)
}

/// The exit code and the findings, as `error dead-end`, of a check of `wander.msd`.
fn check(folder: &Path, flags: &str) -> (i32, Vec<String>) {
    let (code, text) = answer(folder, &format!("check wander.msd --format json {flags}"));
    let finding = |line: &str| {
        let finding: Value = serde_json::from_str(line).unwrap();
        format!("{} {}", finding["severity"].as_str().unwrap(), finding["name"].as_str().unwrap())
    };
    (code, text.lines().map(finding).collect())
}

fn analyze_repository(path: &str, options: &Options) -> Analysis {
    analyze(&Repository, &[path.to_owned()], options)
}

#[test]
fn sarif_keeps_to_the_published_schema() {
    let schema = std::fs::read_to_string(root().join("tests/schemas/sarif-schema-2.1.0.json")).unwrap();
    // The published pattern of a language has a bracket too many; strict readers of patterns want it escaped.
    let schema = schema.replace("{2}]?$", r"{2}\\]?$");
    let schema = jsonschema::validator_for(&serde_json::from_str(&schema).unwrap()).unwrap();
    let mut results = 0;
    for path in files_below("tests/corpus", &["msd", "fsfn"]) {
        let analysis = analyze_repository(&path, &Options::default());
        let log: Value = serde_json::from_str(&report::sarif(&analysis.findings, &analysis.sources)).unwrap();
        let errors: Vec<_> = schema.iter_errors(&log).map(|error| error.to_string()).collect();
        assert!(errors.is_empty(), "{path}: {errors:?}");
        let run = &log["runs"][0];
        assert_eq!(run["results"].as_array().unwrap().len(), analysis.findings.len(), "{path}");
        for (result, finding) in run["results"].as_array().unwrap().iter().zip(&analysis.findings) {
            let rule = &run["tool"]["driver"]["rules"][result["ruleIndex"].as_u64().unwrap() as usize];
            assert_eq!(rule["id"], finding.rule.code);
            assert_eq!(rule["help"]["markdown"], finding.rule.page);
            assert_eq!(result["relatedLocations"].as_array().unwrap().len(), finding.labels.len() - 1);
            results += 1;
        }
    }
    assert!(results > 100, "{results}");
    let mut wrong: Value = serde_json::from_str(&report::sarif(&[], &lmslc::base::Sources::default())).unwrap();
    assert!(schema.is_valid(&wrong));
    wrong["runs"][0]["results"] = serde_json::json!([{ "massage": {} }]);
    assert!(!schema.is_valid(&wrong), "the schema is held against something");
}

#[test]
fn sarif_has_the_fix_and_leaves_out_what_is_suppressed() {
    let excused = WANDER.replace("mode lost {", "mode lost { // lmsl: allow(unreachable-mode) because of the map");
    let folder = folder(&[("wander.msd", &excused)]);
    let output = lmslc(folder.path(), "check wander.msd --format sarif");
    assert_eq!(output.status.code(), Some(0));
    let log: Value = serde_json::from_slice(&output.stdout).unwrap();
    insta::assert_snapshot!(serde_json::to_string_pretty(&log["runs"][0]["results"]).unwrap());
}

#[test]
fn github_gets_workflow_commands() {
    let folder = folder(&[("wander.msd", WANDER)]);
    let (code, text) = answer(folder.path(), "check wander.msd --format github --deny dead-end");
    assert_eq!(code, 1);
    insta::assert_snapshot!(text);
}

#[test]
fn json_has_the_fix() {
    let folder = folder(&[("wander.msd", WANDER)]);
    let (_, text) = answer(folder.path(), "check wander.msd --format json");
    let fixes = text.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["fix"].to_string());
    insta::assert_snapshot!(fixes.collect::<Vec<_>>().join("\n"));
}

#[test]
fn flags_set_levels() {
    let folder = folder(&[("wander.msd", WANDER)]);
    let check = |flags: &str| check(folder.path(), flags);
    let found = |findings: [&str; 3]| findings.map(str::to_owned).to_vec();
    assert_eq!(check(""), (0, found(["warning unused-import", "warning dead-end", "warning unreachable-mode"])));
    assert_eq!(
        check("--deny dead-end --deny LM0404"),
        (1, found(["warning unused-import", "error dead-end", "error unreachable-mode"]))
    );
    assert_eq!(
        check("--deny warnings"),
        (1, found(["error unused-import", "error dead-end", "error unreachable-mode"]))
    );
    let two_allowed = check("--allow DEAD-END --allow lm0207 --deny warnings");
    assert_eq!(two_allowed, (1, vec!["error unreachable-mode".to_owned()]));
    let strictest = check("--deny dead-end --warn dead-end --allow dead-end --allow LM0404 --allow LM0207");
    assert_eq!(strictest, (1, vec!["error dead-end".to_owned()]));
}

#[test]
fn flags_are_over_comments_and_comments_over_the_configuration() {
    let comment = "// lmsl: allow(dead-end) because it is the end\n    mode parked {";
    let folder = folder(&[("wander.msd", &WANDER.replace("mode parked {", comment))]);
    let configure = |text: &str| std::fs::write(folder.path().join("lmsl.toml"), text).unwrap();
    let check = |flags: &str| check(folder.path(), &format!("--allow LM0404 --allow LM0207 {flags}"));
    let found = |code: i32, finding: &str| (code, vec![finding.to_owned()]);

    configure("[levels]\ndead-end = \"deny\"");
    assert_eq!(check(""), (0, vec![]));
    assert_eq!(check("--deny warnings"), (0, vec![]));
    assert_eq!(check("--warn dead-end"), found(0, "warning dead-end"));
    configure("[levels]\ndead-end = \"allow\"");
    assert_eq!(check(""), (0, vec![]), "a comment is used though the rule is allowed");
    assert_eq!(check("--deny dead-end"), found(1, "error dead-end"));

    std::fs::write(folder.path().join("wander.msd"), WANDER).unwrap();
    assert_eq!(check(""), (0, vec![]));
    assert_eq!(check("--warn dead-end"), found(0, "warning dead-end"));
    configure("[levels]\ndead-end = \"deny\"");
    assert_eq!(check(""), found(1, "error dead-end"));
    assert_eq!(check("--allow dead-end"), (0, vec![]));
}

#[test]
fn wrong_flags_say_what_was_meant() {
    let folder = folder(&[("wander.msd", WANDER)]);
    let flags = ["--deny dead-and", "--deny warning", "--allow warnings", "--warn unknown-name", "--fix -"];
    let answers = flags.map(|flags| {
        let (code, text) = answer(folder.path(), &format!("check wander.msd {flags}"));
        assert_eq!(code, 2, "{flags}");
        format!("{flags}\n{text}")
    });
    insta::assert_snapshot!(answers.join("\n"));
    assert_eq!(answer(folder.path(), "check wander.msd --deny unknown-name --allow LM0207").0, 0);
}

#[test]
fn a_denied_suppression_is_a_finding_and_not_a_wrong_argument() {
    let folder = folder(&[("wander.msd", &format!("// lmsl: allow-file(LM0404)\n{WANDER}"))]);
    assert_eq!(check(folder.path(), "--deny bad-suppression").0, 1);
    assert_eq!(check(folder.path(), "--allow bad-suppression").0, 0);
}

#[test]
fn fix_writes_what_is_safe_and_reports_the_rest() {
    let comments =
        "// lmsl: allow(dead-end) because nothing ends there\n        drive(26 cm/s) // lmsl: allow(LM0404) because";
    let text = WANDER.replace("drive(26 cm/s)", &format!("{comments} too")).replace('\n', "\r\n");
    let folder = folder(&[("wander.msd", &text)]);
    let (code, said) = answer(folder.path(), "check wander.msd --fix");
    assert_eq!(code, 0);
    insta::assert_snapshot!(said);
    let fixed = std::fs::read_to_string(folder.path().join("wander.msd")).unwrap();
    let expected = WANDER.replace("import std.networks.obstacle_id\n", "").replace('\n', "\r\n");
    assert_eq!(fixed, expected);
    let (_, again) = answer(folder.path(), "check wander.msd --fix --format short");
    assert!(again.ends_with("0 findings fixed\n"), "{again}");
    assert_eq!(std::fs::read_to_string(folder.path().join("wander.msd")).unwrap(), expected);
}

#[test]
fn fix_leaves_alone_what_was_not_asked_for() {
    let main = WANDER.replace("std.robots.j5", "wander2");
    let other = "import std.networks.obstacle_id\nimport std.robots.j5\n";
    let main = main.replace("on j5", "extends base");
    let base = format!("{other}behavior base on j5 {{ entry go final mode go {{ halt() }} }}\n");
    let folder = folder(&[("wander.msd", &main), ("wander2.msd", &base)]);
    let (_, text) = answer(folder.path(), "check wander.msd --fix --format short");
    assert!(text.contains("wander2.msd:1:1: warning[LM0207]") && text.ends_with("1 finding fixed\n"), "{text}");
    assert_eq!(std::fs::read_to_string(folder.path().join("wander2.msd")).unwrap(), base);
    let (_, text) = answer(folder.path(), "check wander.msd --fix --allow unused-import --format short");
    assert!(!text.contains("LM0207") && text.ends_with("0 findings fixed\n"), "{text}");
    let (code, _) = answer(folder.path(), "check std/robots/j5.msd --fix");
    assert!(code == 2 && !folder.path().join("std").exists(), "the library is imported, not a file to be named");
}

#[test]
fn nothing_seems_unused_beside_an_error() {
    let folder = folder(&[("wander.msd", &WANDER.replace("-> parked", "-> nowhere"))]);
    let (code, findings) = check(folder.path(), "");
    assert_eq!(code, 1);
    assert!(findings.iter().all(|finding| !finding.contains("unused")), "{findings:?}");
}

#[test]
fn the_library_takes_levels_without_a_command_line() {
    let path = "tests/corpus/files/suppressions.msd";
    let count = |levels: &Levels, name: &str| {
        let analysis = analyze_repository(path, &Options { levels: levels.clone(), ..Options::default() });
        analysis.findings.iter().filter(|finding| finding.rule.name == name).count()
    };
    let rule = find_rule("dead-end").unwrap();
    let mut levels = Levels::default();
    assert_eq!(count(&levels, "dead-end"), 1);
    assert!(levels.set(rule, Level::Deny));
    assert_eq!(count(&levels, "dead-end"), 1);
    assert!(levels.set_over_all(rule, Level::Warn));
    assert_eq!(count(&levels, "dead-end"), 2);
    assert!(!levels.set_over_all(find_rule("unknown-name").unwrap(), Level::Allow));
}
