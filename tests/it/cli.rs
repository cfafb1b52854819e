//! The binary as a user meets it: arguments, files, what goes where, exit codes.

use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

use serde_json::Value;
use tempfile::TempDir;

use crate::support::{fences, keep_picture, root};

/// What a command answered.
struct Answer {
    code: i32,
    out: String,
    err: String,
}

impl Answer {
    /// Every line of standard output as JSON.
    fn lines(&self) -> Vec<Value> {
        self.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    }
}

/// A folder of its own to work in.
struct Project(TempDir);

impl Project {
    fn new(files: &[(&str, &str)]) -> Self {
        let project = Self(TempDir::new().unwrap());
        for (path, text) in files {
            project.write(path, text.as_bytes());
        }
        project
    }

    fn write(&self, path: &str, bytes: &[u8]) {
        let path = self.0.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, bytes).unwrap();
    }

    fn read(&self, path: &str) -> String {
        std::fs::read_to_string(self.0.path().join(path)).unwrap()
    }

    fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lmslc"));
        command.args(arguments).current_dir(self.0.path()).env("COLUMNS", "100").env_remove("NO_COLOR");
        command
    }

    fn run(&self, arguments: &[&str]) -> Answer {
        self.run_with(arguments, b"")
    }

    fn run_with(&self, arguments: &[&str], input: &[u8]) -> Answer {
        let mut command = self.command(arguments);
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // A command that does not read its input closes it early.
        let _ = child.stdin.take().unwrap().write_all(input);
        let output = child.wait_with_output().unwrap();
        Answer {
            code: output.status.code().unwrap(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

const CLEAN: &str = "\
import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 1 s -> rest
    }
    mode rest {
        halt()
        1: after 1 s -> go
    }
}
";

/// A warning, on line 11.
const DOUBTFUL: &str = "\
import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 1 s -> parked
    }

    mode parked {
        halt()
    }
}
";

/// An error, on line 8.
const WRONG: &str = "\
import std.robots.j5

behavior wander on j5 {
    entry go

    mode go {
        drive(26 cm/s)
        1: after 1 s -> rest
    }
}
";

/// Three scenarios; the second one is not met.
const TRIALS: &str = "\
import wander

scenario short runs wander {
    duration 1.5 s
    expect modes go, rest
}

scenario wrong runs wander {
    duration 3 s
    expect go -> rest within 1.5 s .. 2.5 s
    expect modes go, rest
}

scenario long extends short {
    duration 2.5 s
    expect modes go, rest, go
}
";

const BUMP: &str = "\
variable acceleration: cm/s^2 in -400 .. 400 {
    neg = ramp(100, -100)
    pos = ramp(-100, 100)
}

variable contact: N in 0 .. 400 fails 0 {
    low  = ramp(80, 20)
    high = ramp(20, 80)
}

network bump(left: acceleration, force: contact) {
    // lmsl: allow(single-point-of-failure) because a hit is a force
    event hit {
        contributor (neg, high)
        detractor   (_, low)
    }
}

network other(force: contact) {
    event pressed {
        contributor (high)
    }
}
";

fn example(path: &str) -> String {
    root().join("examples/j5").join(path).to_str().unwrap().to_owned()
}

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().unwrap().keys().map(String::as_str).collect()
}

// check

#[test]
fn check_answers_clean_findings_and_usage_by_its_exit_code() {
    let project = Project::new(&[("clean.msd", CLEAN), ("doubtful.msd", DOUBTFUL), ("wrong.msd", WRONG)]);
    let clean = project.run(&["check", "clean.msd"]);
    assert_eq!((clean.code, clean.out.as_str()), (0, ""));
    assert!(clean.err.contains("nothing found"), "{}", clean.err);
    let doubtful = project.run(&["check", "doubtful.msd"]);
    assert_eq!((doubtful.code, doubtful.out.as_str()), (0, ""), "a warning is no failure");
    assert!(doubtful.err.starts_with("warning[LM0406]: no transition leaves `parked`\n"), "{}", doubtful.err);
    assert!(doubtful.err.ends_with("1 warning\n"), "{}", doubtful.err);
    let wrong = project.run(&["check", "wrong.msd", "doubtful.msd"]);
    assert_eq!((wrong.code, wrong.out.as_str()), (1, ""));
    assert!(wrong.err.contains("error[LM0201]: no mode is named `rest`"), "{}", wrong.err);
    assert!(wrong.err.ends_with("1 error, 1 warning\n"), "{}", wrong.err);
    assert_eq!(project.run(&["check"]).code, 2);
    assert_eq!(project.run(&["check", "--format", "xml", "clean.msd"]).code, 2);
    assert_eq!(project.run(&["chekc", "clean.msd"]).code, 2);
    assert_eq!(project.run(&[]).code, 2);
}

#[test]
fn check_denies_warnings_where_it_is_told_to() {
    let project = Project::new(&[("doubtful.msd", DOUBTFUL), ("clean.msd", CLEAN)]);
    let denied = project.run(&["check", "--deny", "warnings", "doubtful.msd"]);
    assert_eq!(denied.code, 1);
    assert!(denied.err.starts_with("error[LM0406]"), "{}", denied.err);
    assert_eq!(project.run(&["check", "--deny", "warnings", "clean.msd"]).code, 0);
}

#[test]
fn check_prints_a_line_a_finding() {
    let project = Project::new(&[("wrong.msd", WRONG), ("doubtful.msd", DOUBTFUL)]);
    let short = project.run(&["check", "--format", "short", "wrong.msd", "doubtful.msd"]);
    assert_eq!(short.code, 1);
    assert_eq!(
        short.out,
        "wrong.msd:8:25: error[LM0201]: no mode is named `rest`\n\
         doubtful.msd:11:10: warning[LM0406]: no transition leaves `parked`\n"
    );
    assert_eq!(short.err, "");
}

#[test]
fn check_prints_an_object_a_finding() {
    let project = Project::new(&[("wrong.msd", WRONG), ("doubtful.msd", DOUBTFUL), ("clean.msd", CLEAN)]);
    let answer = project.run(&["check", "--format", "json", "wrong.msd", "doubtful.msd"]);
    assert_eq!((answer.code, answer.err.as_str()), (1, ""));
    let lines = answer.lines();
    assert_eq!(lines.len(), 2);
    for line in &lines {
        let mut found = keys(line);
        found.sort_unstable();
        let mut expected = vec!["schema", "code", "name", "severity", "message", "file", "start", "end", "labels"];
        expected.extend(["notes", "help", "witness", "fix"]);
        expected.sort_unstable();
        assert_eq!(found, expected);
        assert_eq!(line["schema"], 1);
        for end in ["start", "end"] {
            assert_eq!(line[end], line["labels"][0][end], "the first label is the primary one");
            assert!(["byte", "line", "column"].iter().all(|part| line[end][part].is_u64()));
        }
    }
    assert_eq!((&lines[0]["code"], &lines[0]["name"]), (&"LM0201".into(), &"unknown-name".into()));
    assert_eq!((&lines[0]["severity"], &lines[1]["severity"]), (&"error".into(), &"warning".into()));
    assert_eq!((&lines[0]["start"]["line"], &lines[0]["start"]["column"]), (&8.into(), &25.into()));
    let (start, end) = (lines[0]["start"]["byte"].as_u64().unwrap(), lines[0]["end"]["byte"].as_u64().unwrap());
    assert_eq!(&WRONG[start as usize..end as usize], "rest");
    assert_eq!(lines[1]["file"], "doubtful.msd");
    assert_eq!(project.run(&["check", "--format", "json", "clean.msd"]).out, "");
}

#[test]
fn check_takes_folders_and_standard_input() {
    let project = Project::new(&[
        ("a/clean.msd", CLEAN),
        ("a/b/wrong.msd", WRONG),
        ("a/.hidden/wrong.msd", WRONG),
        ("a/notes.txt", "no program"),
        ("empty/notes.txt", "no program"),
    ]);
    let folder = project.run(&["check", "--format", "short", "a"]);
    assert_eq!((folder.code, folder.out.lines().count()), (1, 1));
    assert!(folder.out.starts_with(&Path::new("a").join("b").join("wrong.msd").display().to_string()));
    let empty = project.run(&["check", "empty"]);
    assert_eq!(empty.code, 2);
    assert!(empty.err.contains("`empty` holds no `.msd` or `.fsfn` file"), "{}", empty.err);
    let piped = project.run_with(&["check", "--format", "short", "-"], WRONG.as_bytes());
    assert_eq!((piped.code, piped.out.as_str()), (1, "-:8:25: error[LM0201]: no mode is named `rest`\n"));
    assert_eq!(project.run_with(&["check", "-"], CLEAN.as_bytes()).code, 0);
    assert_eq!(project.run_with(&["check", "-"], b"\xff\xfe").code, 2);
    // A file beside standard input can be imported.
    project.write("clean.msd", CLEAN.as_bytes());
    let trial = "import clean\nscenario short runs wander { duration 1 s }\n";
    assert_eq!(project.run_with(&["check", "-"], trial.as_bytes()).code, 0);
}

#[test]
fn a_file_that_cannot_be_read_is_said_to_be_so() {
    let project = Project::new(&[("clean.msd", CLEAN), ("notes.txt", "no program"), ("folder.msd/x.txt", "")]);
    project.write("latin.msd", b"// the r\xf4le of the robot\n");
    project.write("hallway.msd", b"// 90\xb0\n");
    let large = std::fs::File::create(project.0.path().join("large.msd")).unwrap();
    large.set_len((256 << 20) + 1).unwrap();
    let cases = [
        ("missing.msd", "LM0001", "there is no file `missing.msd`"),
        ("latin.msd", "LM0002", "`latin.msd` is not UTF-8 text from byte 8 on"),
        ("notes.txt", "LM0005", "`notes.txt` ends neither in `.msd` nor in `.fsfn`"),
        ("large.msd", "LM0007", "`large.msd` has 268435457 bytes; the most is 268435456"),
    ];
    for (path, code, message) in cases {
        let answer = project.run(&["check", path, "clean.msd"]);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{path}");
        assert!(answer.err.contains(&format!("error[{code}]: {message}\n")), "{}", answer.err);
        for command in ["run", "test"] {
            assert_eq!(project.run(&[command, path]).code, 2, "{command} {path}");
        }
    }
    // What an import leads to can be unreadable too; it is reported once.
    let importing = "import latin\nimport std.robots.j5\nbehavior a extends role { entry go }\n";
    let answer = project.run_with(&["check", "--format", "short", "-"], importing.as_bytes());
    assert_eq!((answer.code, answer.out.lines().count()), (2, 1), "{}", answer.out);
    assert!(answer.out.starts_with("latin.msd:1:1: error[LM0002]"), "{}", answer.out);
}

#[test]
fn the_pages_about_files_show_what_is_said() {
    let project = Project::new(&[("obstacle_id.txt", ""), ("wander.msd", CLEAN)]);
    project.write("hallway.msd", b"// Turn 90 \xb0.\n");
    let large = std::fs::File::create(project.0.path().join("run_0412.msd")).unwrap();
    large.set_len(1 << 28).unwrap();
    for code in ["LM0001", "LM0002", "LM0005", "LM0802"] {
        let page = std::fs::read_to_string(root().join(format!("docs/errors/{code}.md"))).unwrap();
        let shown = fences(&page).into_iter().find(|fence| fence.section == "Example").unwrap().text;
        let (command, answer) = shown.split_once('\n').unwrap();
        let words: Vec<_> = command.split(' ').skip(2).collect();
        let found = project.run(&words);
        assert!(found.err.starts_with(answer), "{code}\nshown {answer}\nfound {}", found.err);
        assert_eq!(found.code, 2, "{code}");
    }
}

// lmsl.toml

#[test]
fn a_project_sets_the_levels_of_warnings() {
    let project = Project::new(&[("a/b/doubtful.msd", DOUBTFUL)]);
    let check = |configuration: &str| {
        project.write("a/lmsl.toml", configuration.as_bytes());
        project.run(&["check", "--format", "short", "a/b/doubtful.msd"])
    };
    let allowed = check("[levels]\ndead-end = \"allow\"\n");
    assert_eq!((allowed.code, allowed.out.as_str()), (0, ""));
    let denied = check("[levels]\nLM0406 = \"deny\"\n");
    assert_eq!(denied.code, 1);
    assert!(denied.out.contains("error[LM0406]"), "{}", denied.out);
    let warned = check("[levels]\ndead-end = \"warn\"\n");
    assert_eq!(warned.code, 0);
    assert!(warned.out.contains("warning[LM0406]"), "{}", warned.out);
    // A configuration nearer to the file counts, and one of another folder does not.
    project.write("a/b/lmsl.toml", b"[levels]\ndead-end = \"allow\"\n");
    assert_eq!(check("[levels]\ndead-end = \"deny\"\n").code, 0);
}

#[test]
fn a_wrong_configuration_is_pointed_at() {
    let project = Project::new(&[("doubtful.msd", DOUBTFUL)]);
    let check = |configuration: &str| {
        project.write("lmsl.toml", configuration.as_bytes());
        let answer = project.run(&["check", "doubtful.msd"]);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{configuration}");
        answer.err
    };
    let unknown = check("[levels]\n\ndead-and = \"allow\"\n");
    assert!(unknown.starts_with("error[LM0008]: there is no diagnostic `dead-and`\n"), "{unknown}");
    assert!(unknown.contains("lmsl.toml:3:1") && unknown.contains("did you mean `dead-end`?"), "{unknown}");
    let level = check("[levels]\nunreachable-mode = \"forbid\"\n");
    assert!(level.starts_with("error[LM0008]: `forbid` is not a level\n"), "{level}");
    assert!(level.contains("lmsl.toml:2:20"), "{level}");
    let fixed = check("[levels]\nunknown-name = \"allow\"\n");
    assert!(fixed.starts_with("error[LM0008]: `unknown-name` is always an error\n"), "{fixed}");
    assert!(check("[level]\n").contains("unknown field `level`"));
    assert!(check("[levels\n").contains("lmsl.toml:1:"));
    project.write("lmsl.toml", b"\xff");
    assert_eq!(project.run(&["check", "doubtful.msd"]).code, 2);
}

// run

#[test]
fn run_needs_one_scenario() {
    let project = Project::new(&[("wander.msd", CLEAN), ("trials.msd", TRIALS), ("wrong.msd", WRONG)]);
    let none = project.run(&["run", "wander.msd"]);
    assert_eq!(none.code, 2);
    assert!(none.err.starts_with("error[LM0802]: `wander.msd` holds no scenario to run\n"), "{}", none.err);
    let several = project.run(&["run", "trials.msd"]);
    assert_eq!(several.code, 2);
    assert!(
        several.err.contains("holds 3 scenarios") && several.err.contains("`short`, `wrong`, `long`"),
        "{}",
        several.err
    );
    let unknown = project.run(&["run", "trials.msd", "shrot"]);
    assert_eq!(unknown.code, 2);
    assert!(unknown.err.contains("no scenario `shrot`") && unknown.err.contains("did you mean `short`?"));
    let named = project.run(&["run", "trials.msd", "short"]);
    assert_eq!((named.code, named.err.as_str()), (0, ""));
    assert!(named.out.starts_with("short: wander on j5, 1.5 s, seed 1\n"), "{}", named.out);
    assert!(named.out.contains("ok      modes go, rest"), "{}", named.out);
    let broken = project.run(&["run", "wrong.msd"]);
    assert_eq!((broken.code, broken.out.as_str()), (1, ""));
    assert!(broken.err.contains("error[LM0201]"), "{}", broken.err);
}

#[test]
fn run_tells_what_was_expected_and_what_was_seen() {
    let project = Project::new(&[("wander.msd", CLEAN), ("trials.msd", TRIALS)]);
    let answer = project.run(&["run", "trials.msd", "wrong"]);
    assert_eq!((answer.code, answer.err.as_str()), (1, ""));
    assert!(answer.out.contains("FAILED  expected  go -> rest within 1.5 s .. 2.5 s\n"), "{}", answer.out);
    assert!(answer.out.contains("seen      taken at 1 s, 3 s\n"), "{}", answer.out);
    assert!(answer.out.contains("ok      modes go, rest\n"), "{}", answer.out);
}

#[test]
fn run_prints_one_object() {
    let project = Project::new(&[("wander.msd", CLEAN), ("trials.msd", TRIALS)]);
    let answer = project.run(&["run", "trials.msd", "wrong", "--format", "json"]);
    assert_eq!((answer.code, answer.err.as_str()), (1, ""));
    let [run] = answer.lines().try_into().unwrap();
    assert_eq!((&run["schema"], &run["scenario"]), (&1.into(), &"wrong".into()));
    let modes: Vec<_> =
        run["modes"].as_array().unwrap().iter().map(|m| (m["t"].as_f64(), m["mode"].as_str())).collect();
    assert_eq!(modes[..2], [(Some(0.0), Some("go")), (Some(1.0), Some("rest"))]);
    assert_eq!(run["flags"], Value::Array(Vec::new()));
    let expectations = run["expectations"].as_array().unwrap();
    assert_eq!(expectations[0]["text"], "go -> rest within 1.5 s .. 2.5 s");
    assert_eq!((&expectations[0]["passed"], &expectations[0]["seen"]), (&false.into(), &"taken at 1 s, 3 s".into()));
    assert_eq!((&expectations[1]["passed"], expectations[1].get("seen")), (&true.into(), None));
}

#[test]
fn run_takes_its_seed_from_the_command_line() {
    let project = Project::new(&[]);
    let manipulation = example("manipulation.msd");
    let trace = |seed: &[&str]| {
        let arguments = [&["run", &manipulation, "--trace", "run.csv"], seed].concat();
        assert_eq!(project.run(&arguments).code, 0, "{seed:?}");
        project.read("run.csv")
    };
    assert_eq!(trace(&[]), trace(&["--seed", "1"]), "the file says seed 1");
    assert_ne!(trace(&["--seed", "2"]), trace(&["--seed", "3"]));
    let shown = project.run(&["run", &manipulation, "--seed", "2"]).out;
    assert!(shown.contains("seed 2"), "{shown}");
    assert_eq!(project.run(&["run", &manipulation, "--seed", "-1"]).code, 2);
}

#[test]
fn a_fault_on_the_command_line_may_be_of_a_group() {
    let deadlock = root().join("examples/labmate/deadlock.msd");
    let deadlock = deadlock.to_str().unwrap();
    let project = Project::new(&[]);
    let run = |fault: &str| project.run(&["run", deadlock, "--fault", fault]);
    for fault in ["sonar[3]=10m", "front=10 m", "sonar=failed@1s"] {
        let answer = run(fault);
        assert!(answer.err.is_empty() && answer.code < 2, "{fault}: {}", answer.err);
    }
    assert!(run("front_bumper=set@1s").out.contains("FAILED  expected  never front_bumper or back_bumper"));
    for unknown in ["sonar[24]=10 m", "won=set", "fronts=1 m"] {
        let answer = run(unknown);
        assert_eq!(answer.code, 2, "{unknown}");
        assert!(!answer.err.contains("sonar[0]") && !answer.err.contains("`command`"), "{}", answer.err);
    }
}

#[test]
fn an_arbiter_is_built_with_its_clients_and_what_carries_out_their_commands() {
    let text = "import std.behaviors.simple_navigation\nimport std.robots.labmate\n\
        behavior calm on labmate { entry rest  final mode rest { stop() } }\n\
        arbiter both on labmate { client calm = calm priority 2  client wander = simple_navigation priority 1 }\n";
    let project = Project::new(&[("both.msd", text)]);
    let answer = project.run(&["build", "both.msd"]);
    assert!(!answer.err.contains("left out"), "{}", answer.err);
    for module in ["calm", "simple_navigation", "both", "labmate_drive"] {
        assert_eq!(answer.out.matches(&format!("pub mod {module} {{")).count(), 1, "{module}");
    }
    let answer = project.run(&["build", "both.msd", "--emit", "dot"]);
    assert!(answer.err.contains("the arbiter `both` is left out") && answer.out.contains("calm"), "{}", answer.err);
}

#[test]
fn a_fault_on_the_command_line_is_the_fault_of_a_scenario() {
    let project = Project::new(&[]);
    let (manipulation, faulted) = (example("manipulation.msd"), example("force_faulted.msd"));
    let trace = |arguments: &[&str]| {
        project.run(&[&["run"], arguments, &["--trace", "run.csv"]].concat());
        project.read("run.csv")
    };
    let fault = trace(&[&manipulation, "--fault", "contact_force=0N@0s"]);
    assert_eq!(fault, trace(&[&faulted, "force_faulted"]));
    assert_eq!(
        fault,
        trace(&[&manipulation, "--fault", "contact_force=0 N"]),
        "from the start, unless a time is given"
    );
    assert_eq!(
        fault,
        trace(&[&manipulation, "--fault", "contact_force=0@0"]),
        "in the unit of the sensor, and seconds"
    );
    assert_eq!(
        trace(&[&manipulation, "--fault", "contact_force=failed"]),
        trace(&[&faulted, "force_reported"]),
        "known to have failed"
    );
    assert_ne!(trace(&[&manipulation, "--fault", "contact_force=0.3kN@3s"]), fault);
    let both = ["--fault", "left_wheel_acceleration=any@0s", "--fault", "contact_force=0N@3000ms"];
    assert_ne!(trace(&[&[manipulation.as_str()], &both[..]].concat()), fault);
}

#[test]
fn a_wrong_fault_is_told_what_it_should_be() {
    let project = Project::new(&[]);
    let manipulation = example("manipulation.msd");
    let cases = [
        ("contact_force", "is not a fault"),
        ("contact_force=", "is not a fault"),
        ("contact_force=0V@0s", "is not a fault"),
        ("contact_force=0N@2m", "is not a fault"),
        ("contact_force=0N@-1s", "is not a fault"),
        ("contact_force=much@1s", "is not a fault"),
        ("contact_farce=0N@0s", "did you mean `contact_force`?"),
        ("=0N", "has no sensor ``"),
    ];
    for (fault, message) in cases {
        let answer = project.run(&["run", &manipulation, "--fault", fault]);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{fault}");
        assert!(answer.err.contains(message), "{fault}: {}", answer.err);
    }
}

#[test]
fn run_writes_traces_and_plots() {
    let project = Project::new(&[]);
    let manipulation = example("manipulation.msd");
    assert_eq!(project.run(&["run", &manipulation, "--trace", "a.csv", "--plot", "a.svg"]).code, 0);
    assert_eq!(project.run(&["run", &manipulation, "--trace", "a.jsonl"]).code, 0);
    let table = project.read("a.csv");
    let header: Vec<_> = table.lines().next().unwrap().split(',').collect();
    assert_eq!(header[..2], ["t", "mode"]);
    for column in ["contact_force", "obstacle_id.forward_collision"] {
        assert!(header.contains(&column), "{header:?}");
    }
    // 10 s in ticks of 10 ms, and the tick at the start.
    assert_eq!(table.lines().count(), 1 + 1001);
    assert!(table.lines().all(|line| line.split(',').count() == header.len()));
    let objects: Vec<Value> = project.read("a.jsonl").lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(objects.len(), 1001);
    let mut names = keys(&objects[0]);
    let mut columns = header.clone();
    names.sort_unstable();
    columns.sort_unstable();
    assert_eq!(names, columns);
    assert_eq!((&objects[0]["t"], &objects[0]["mode"]), (&0.0.into(), &"init".into()));
    let plot = project.read("a.svg");
    let plot = roxmltree::Document::parse(&plot).unwrap();
    assert_eq!(plot.root_element().tag_name().name(), "svg");
    let nowhere = project.run(&["run", &manipulation, "--trace", "no/such/folder/a.csv"]);
    assert_eq!(nowhere.code, 2);
    assert!(nowhere.err.contains("`no/such/folder/a.csv` cannot be written"), "{}", nowhere.err);
}

// test

#[test]
fn test_runs_every_scenario_of_the_files_it_is_given() {
    let project = Project::new(&[("wander.msd", CLEAN), ("trials.msd", TRIALS)]);
    let all = project.run(&["test", "trials.msd"]);
    assert_eq!(all.code, 1);
    assert!(all.err.ends_with("2 passed, 1 failed\n"), "{}", all.err);
    assert!(all.out.contains("ok     trials.msd: short (1 expectation)\n"), "{}", all.out);
    assert!(all.out.contains("FAILED trials.msd: wrong (2 expectations)\n"), "{}", all.out);
    assert!(all.out.contains("seen      taken at 1 s, 3 s\n"), "{}", all.out);
    let some = project.run(&["test", ".", "--filter", "o"]);
    assert_eq!(some.code, 1, "short and wrong, and long");
    let some = project.run(&["test", ".", "--filter", "lon"]);
    assert_eq!((some.code, some.out.lines().count()), (0, 1));
    assert!(some.err.ends_with("1 passed, 0 failed\n"), "{}", some.err);
    assert_eq!(project.run(&["test", ".", "--filter", "none"]).code, 2);
    assert_eq!(project.run(&["test", "wander.msd"]).code, 2, "no scenario at all");
    let lines = project.run(&["test", "trials.msd", "--format", "json"]);
    assert_eq!(lines.code, 1);
    let names: Vec<_> = lines.lines().iter().map(|run| run["scenario"].as_str().unwrap().to_owned()).collect();
    assert_eq!(names, ["short", "wrong", "long"], "in the order of the file");
    assert_eq!(lines.lines()[1], project.run(&["run", "trials.msd", "wrong", "--format", "json"]).lines()[0]);
}

#[test]
fn test_lists_what_no_scenario_went_through() {
    let project = Project::new(&[("wander.msd", CLEAN), ("trials.msd", TRIALS)]);
    let covered = |arguments: &[&str]| project.run(&[&["test", "--coverage"], arguments].concat());
    let short = covered(&["trials.msd", "--filter", "short"]);
    assert_eq!(
        short.out,
        "ok     trials.msd: short (1 expectation)\n\
         coverage of wander: 2 of 2 modes, 1 of 2 transitions in 1 scenario\n  \
           never taken    rest 1: after 1 s -> go  wander.msd:12\n"
    );
    let both = covered(&["trials.msd", "--filter", "o"]);
    assert!(
        both.out.ends_with("coverage of wander: 2 of 2 modes, 2 of 2 transitions in 3 scenarios\n"),
        "{}",
        both.out
    );
    let lines = covered(&["trials.msd", "--filter", "short", "--format", "json"]).lines();
    let wander = &lines[1]["coverage"]["behaviors"][0];
    assert_eq!((&wander["name"], &wander["scenarios"]), (&"wander".into(), &1.into()));
    assert_eq!((&wander["modes"]["total"], &wander["modes"]["covered"]), (&2.into(), &2.into()));
    let missed = serde_json::json!({ "of": "rest", "text": "1: after 1 s -> go", "file": "wander.msd", "line": 12 });
    assert_eq!(wander["transitions"]["missed"], serde_json::json!([missed]));
    project.write("idle.msd", CLEAN.replace("wander", "idle").as_bytes());
    let idle = covered(&["trials.msd", "idle.msd", "--filter", "short"]);
    assert!(idle.out.contains("coverage of idle: no scenario runs it\n"), "{}", idle.out);
}

#[test]
fn coverage_counts_the_rules_that_decide() {
    let folder = root();
    let example = folder.join("examples/j5/both_faulted.msd").to_str().unwrap().to_owned();
    let project = Project::new(&[]);
    let lines = project.run(&["test", "--coverage", "--format", "json", &example]).lines();
    let network = &lines[1]["coverage"]["networks"][0];
    // With all readings at 0 one rule speaks against a collision, and one against a heavy one (both_faulted.msd).
    assert_eq!((&network["name"], &network["rules"]["total"]), (&"obstacle_id".into(), &12.into()));
    assert_eq!(network["rules"]["covered"], 2);
    let behavior = &lines[1]["coverage"]["behaviors"][0];
    let missed = behavior["transitions"]["missed"].as_array().unwrap();
    assert!(missed.iter().any(|missed| missed["text"] == "else -> stop"), "{missed:?}");
}

// completions, man

#[test]
fn shells_and_manuals_know_every_command() {
    let project = Project::new(&[]);
    let commands = ["check", "build", "run", "test", "eval", "faults", "fmt", "graph", "new", "explain"];
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let answer = project.run(&["completions", shell]);
        assert_eq!((answer.code, answer.err.as_str()), (0, ""));
        assert!(commands.iter().all(|command| answer.out.contains(command)), "{shell}");
    }
    assert_eq!(project.run(&["completions", "abacus"]).code, 2);
    let manual = project.run(&["man"]);
    assert!(commands.iter().all(|command| manual.out.contains(&format!("lmslc\\-{command}"))), "{}", manual.out);
}

#[test]
fn explain_searches_its_pages() {
    let project = Project::new(&[]);
    let found = project.run(&["explain", "--search", "Hysteresis"]);
    assert!(found.out.contains("LM0524  unsteady-at-rest") && !found.out.contains("LM0101"), "{}", found.out);
    let none = project.run(&["explain", "--search", "unicorns"]);
    assert_eq!(none.code, 2);
    assert!(none.err.contains("no diagnostic speaks of `unicorns`"), "{}", none.err);
}

// graph

#[test]
fn graph_draws_what_it_is_asked_for() {
    let project = Project::new(&[("wander.msd", CLEAN), ("bump.fsfn", BUMP), ("wrong.msd", WRONG)]);
    let graph = |arguments: &[&str]| project.run(&[&["graph"], arguments].concat());
    let shown = graph(&["wander.msd"]);
    assert_eq!((shown.code, shown.err.as_str()), (0, ""));
    assert!(shown.out.starts_with("<svg ") && !shown.out.contains("class=\"gone\""), "{}", shown.out);
    assert_eq!(graph(&["wander.msd", "-o", "w.svg"]).out, "");
    assert_eq!(project.read("w.svg"), shown.out);
    assert!(graph(&["wander.msd", "--format", "dot"]).out.starts_with("digraph"));
    assert!(graph(&["wander.msd", "--failed", "contact_force"]).out.starts_with("<svg "));
    let near = graph(&["wander.msd", "--failed", "contact_farce"]);
    assert_eq!(near.code, 2);
    assert!(
        near.err.contains("`wander` has no sensor `contact_farce`")
            && near.err.contains("did you mean `contact_force`?"),
        "{}",
        near.err
    );
    let networks = graph(&["bump.fsfn", "--network", "-o", "pictures"]);
    assert_eq!((networks.code, networks.err.as_str()), (0, ""));
    assert!(project.read("pictures/bump.svg").contains("<title id=\"title\">Network bump</title>"));
    assert!(project.read("pictures/other.svg").contains("pressed"));
    assert_eq!(graph(&["bump.fsfn"]).code, 2, "no behavior");
    assert_eq!(graph(&["wander.msd", "--network"]).code, 2, "no network");
    assert_eq!(graph(&["bump.fsfn", "--network", "--format", "dot"]).code, 2);
    assert_eq!(graph(&["bump.fsfn", "--network", "--failed", "x"]).code, 2);
    let broken = graph(&["wrong.msd"]);
    assert!(
        broken.out.starts_with("<svg ") && broken.err.contains("error["),
        "drawn as far as it is understood: {}",
        broken.err
    );
}

/// The pictures of the documentation are those that the commands in it draw. With `UPDATE_PICTURES=1` they are redrawn.
#[test]
fn graph_drew_the_pictures_of_the_documentation() {
    let page = std::fs::read_to_string(root().join("docs/diagrams.md")).unwrap();
    let commands: Vec<_> = page.lines().filter_map(|line| line.strip_prefix("lmslc ")).collect();
    assert_eq!(commands.len(), 3);
    for (command, image) in commands.iter().zip(page.split("](images/").skip(1)) {
        let image = format!("docs/images/{}", image.split_once(')').unwrap().0);
        let arguments: Vec<_> = command.split(' ').take_while(|word| *word != "-o").collect();
        let output = Command::new(env!("CARGO_BIN_EXE_lmslc")).args(&arguments).current_dir(root()).output().unwrap();
        let drawn = String::from_utf8(output.stdout).unwrap();
        keep_picture(&root().join(&image), &drawn);
    }
}

// new

#[test]
fn new_makes_a_project_that_works_at_once() {
    let project = Project::new(&[]);
    let made = project.run(&["new", "my-patrol"]);
    assert_eq!((made.code, made.out.as_str()), (0, ""));
    assert!(made.err.starts_with("made `my-patrol`; next: cd my-patrol && "), "{}", made.err);
    for arguments in [
        ["check", "--deny", "warnings", "my-patrol"].as_slice(),
        &["test", "my-patrol"],
        &["run", "my-patrol/scenarios.msd", "box_ahead"],
        &["build", "my-patrol/my_patrol.msd"],
        &["fmt", "--check", "my-patrol"],
    ] {
        let answer = project.run(arguments);
        assert_eq!(answer.code, 0, "{arguments:?}\n{}{}", answer.out, answer.err);
    }
    assert!(project.read("my-patrol/lmsl.toml").contains("[levels]"));
    assert!(project.read("my-patrol/.github/workflows/behavior.yml").contains("lmslc test ."));
    let again = project.run(&["new", "my-patrol"]);
    assert_eq!(again.code, 2);
    assert!(again.err.contains("`my-patrol` exists already"), "{}", again.err);
    for wrong in ["behavior", "7up", "a.b", "-", ".."] {
        let answer = project.run(&["new", "--", wrong]);
        assert_eq!(answer.code, 2, "{wrong}: {}", answer.err);
    }
    assert_eq!(project.run(&["new", "x", "--robot", "r2d2"]).code, 2);
}

// fmt

#[test]
fn fmt_lays_files_out() {
    let rough = CLEAN.replace(": after", " :  after");
    let project =
        Project::new(&[("a/rough.msd", &rough), ("a/wander.msd", CLEAN), ("a/none.txt", "x"), ("wrong.msd", "mode {")]);
    let checked = project.run(&["fmt", "--check", "a"]);
    assert_eq!((checked.code, checked.err.as_str()), (1, "1 file would be formatted, 1 left as it is\n"));
    assert!(checked.out.starts_with("--- a/rough.msd\n+++ a/rough.msd\n@@ "), "{}", checked.out);
    assert_eq!(project.read("a/rough.msd"), rough, "nothing is written");
    let written = project.run(&["fmt", "a"]);
    assert_eq!((written.code, written.out.as_str()), (0, ""));
    assert_eq!(project.read("a/rough.msd"), CLEAN);
    assert_eq!(project.run(&["fmt", "--check", "a"]).code, 0);
    let piped = project.run_with(&["fmt", "-"], rough.as_bytes());
    assert_eq!((piped.code, piped.out.as_str()), (0, CLEAN));
    let network = project.run_with(&["fmt", "-"], BUMP.as_bytes());
    assert_eq!(network.code, 0, "{}", network.err);
    let wrong = project.run(&["fmt", "wrong.msd", "a"]);
    assert_eq!(wrong.code, 1);
    assert!(wrong.err.contains("error[LM0101]") && wrong.err.contains("1 file not understood"), "{}", wrong.err);
    assert_eq!(project.read("wrong.msd"), "mode {", "what is not understood is left alone");
    assert_eq!(project.run(&["fmt", "missing.msd"]).code, 2);
}

// eval

#[test]
fn eval_weighs_one_reading() {
    let project = Project::new(&[("bump.fsfn", BUMP)]);
    let human = project.run(&["eval", "bump.fsfn", "bump", "left=-100", "force=68"]);
    assert_eq!((human.code, human.err.as_str()), (0, ""));
    for part in ["left  -100 cm/s^2", "force  68 N", "hit  set", "0.800", "0.200", "margin"] {
        assert!(human.out.contains(part), "{part}: {}", human.out);
    }
    let answer = project.run(&["eval", "bump.fsfn", "bump", "force=68", "left=-1 m/s^2", "--format", "json"]);
    assert_eq!(answer.code, 0, "a reading may name another unit");
    let answer = project.run(&["eval", "bump.fsfn", "bump", "force=68N", "left=-100 cm/s^2", "--format", "json"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    let [value] = answer.lines().try_into().unwrap();
    let expected = serde_json::json!({
        "schema": 1,
        "inputs": {"left": -1.0, "force": 68.0},
        "degrees": {"left": {"neg": 1.0, "pos": 0.0}, "force": {"low": 0.2, "high": 0.8}},
        "events": {"hit": {"contributor": 0.8, "detractor": 0.2, "flag": true}},
        "outputs": {},
    });
    assert_eq!(value, expected);
    let failed = project.run(&["eval", "bump.fsfn", "bump", "force=failed", "left=nan", "--format", "json"]);
    let [value] = failed.lines().try_into().unwrap();
    assert!(value["inputs"]["force"].is_null() && value["inputs"]["left"].is_null());
    assert_eq!(value["degrees"]["force"]["low"], 1.0, "the failed reading is 0 N");
}

#[test]
fn eval_needs_every_input_once() {
    let project = Project::new(&[("bump.fsfn", BUMP)]);
    let cases: [(&[&str], &str); 7] = [
        (&["bump", "left=1"], "no reading is given for force"),
        (&["bump", "left=1", "force=2", "left=3"], "`left` is given twice"),
        (&["bump", "left=1", "forse=2"], "did you mean `force`?"),
        (&["bump", "left=1", "torque=2"], "known are: `left`, `force`"),
        (&["bump", "left=1", "force=much"], "`much` is not a reading of `force`"),
        (&["bump", "left=1", "2"], "`2` is not a reading"),
        (&["bmup", "left=1", "force=2"], "did you mean `bump`?"),
    ];
    for (arguments, message) in cases {
        let answer = project.run(&[&["eval", "bump.fsfn"], arguments].concat());
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{arguments:?}");
        assert!(answer.err.contains(message), "{arguments:?}: {}", answer.err);
    }
    let unknown = project.run(&["eval", "bump.fsfn", "steering"]);
    assert!(unknown.err.contains("known are: `bump`, `other`"), "{}", unknown.err);
    assert_eq!(project.run(&["eval", "missing.fsfn", "bump"]).code, 2);
    assert_eq!(project.run(&["eval", "bump.fsfn"]).code, 2);
}

#[test]
fn eval_weighs_tables() {
    let project = Project::new(&[("bump.fsfn", BUMP), ("in.csv", "force,left\n68,-1\n0,1\n")]);
    let answer = project.run(&["eval", "bump.fsfn", "bump", "--csv", "in.csv"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    assert_eq!(
        answer.out,
        "force,left,hit,hit.contributor,hit.detractor\n68.0,-1.0,true,0.8,0.2\n0.0,1.0,false,0.0,1.0\n"
    );
    let piped = project.run_with(&["eval", "bump.fsfn", "bump", "--csv", "-"], b"left,force\n-1,68\n");
    assert!(piped.out.ends_with("-1.0,68.0,true,0.8,0.2\n"), "{}", piped.out);
    let cases: [(&[u8], &str); 5] = [
        (b"left,forse\n1,2\n", "`wrong.csv`, line 1: `forse` is not an input of `bump`; did you mean `force`?"),
        (b"left\n1\n", "`wrong.csv`, line 1: there is no column for `force`"),
        (b"left,force\n1,2\n1\n", "`wrong.csv`, line 3: 1 value where the header has 2 columns"),
        (b"left,force\n1,2 N\n", "`wrong.csv`, line 2: `2 N` for `force` is not a number"),
        (b"left,force\n1,\xff\n", "`wrong.csv` cannot be read: it is not UTF-8 text from byte 13 on"),
    ];
    for (table, message) in cases {
        project.write("wrong.csv", table);
        let answer = project.run(&["eval", "bump.fsfn", "bump", "--csv", "wrong.csv"]);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{message}");
        assert!(answer.err.contains(message), "{}", answer.err);
    }
    assert_eq!(project.run(&["eval", "bump.fsfn", "bump", "--csv", "missing.csv"]).code, 2);
    assert_eq!(project.run(&["eval", "bump.fsfn", "bump", "left=1", "--csv", "in.csv"]).code, 2);
}

// explain

#[test]
fn explain_prints_pages_and_the_list() {
    let project = Project::new(&[]);
    let page = std::fs::read_to_string(root().join("docs/errors/LM0403.md")).unwrap();
    for rule in ["LM0403", "lm0403", "duplicate-priority"] {
        let answer = project.run(&["explain", rule]);
        assert_eq!((answer.code, answer.out.as_str()), (0, page.as_str()), "{rule}");
    }
    let near = project.run(&["explain", "duplicate-priorty"]);
    assert_eq!((near.code, near.out.as_str()), (2, ""));
    assert!(near.err.contains("did you mean `duplicate-priority`?"), "{}", near.err);
    let far = project.run(&["explain", "spaghetti"]);
    assert!(far.err.contains("`lmslc explain` lists all"), "{}", far.err);
    let list = project.run(&["explain"]);
    assert_eq!(list.code, 0);
    assert_eq!(list.out.lines().count(), lmslc::diag::RULES.len());
    assert!(list.out.contains("LM0403  duplicate-priority"), "{}", list.out);
}

// The terminal

// build

#[test]
fn build_writes_where_it_is_told_to() {
    let project = Project::new(&[("wander.msd", CLEAN), ("more/ramble.msd", &CLEAN.replace("wander", "ramble"))]);
    let build = |arguments: &[&str]| project.run(&[&["build", "--emit", "promela"], arguments].concat());
    let shown = build(&["wander.msd"]);
    assert_eq!((shown.code, shown.err.as_str()), (0, ""));
    assert!(shown.out.contains("proctype behavior_wander()") && shown.out.contains("go_1: mode = in_rest"));
    assert!(!shown.out.contains("failures"), "nothing fails unless told to");
    assert_eq!(build(&["wander.msd", "-o", "model.pml"]).out, "");
    assert_eq!(project.read("model.pml"), shown.out);
    assert_eq!(build(&["wander.msd", "-o", "more"]).code, 0);
    assert_eq!(project.read("more/wander.pml"), shown.out, "a folder gets a file of the behavior's name");
    assert_eq!(build(&["wander.msd", "more", "--output", "models/all"]).code, 0);
    assert_eq!(project.read("models/all/wander.pml"), shown.out);
    assert!(project.read("models/all/ramble.pml").contains("behavior_ramble"));
    let both = build(&["wander.msd", "more"]);
    assert!(both.out.contains(":: run behavior_wander()\n    :: run behavior_ramble()\n"), "{}", both.out);
}

#[test]
fn build_draws_and_lists() {
    let project = Project::new(&[("wander.msd", CLEAN), ("more/ramble.msd", &CLEAN.replace("wander", "ramble"))]);
    let build = |arguments: &[&str]| project.run(&[&["build"], arguments].concat());
    for (kind, extension, begins) in
        [("svg", "svg", "<svg "), ("dot", "dot", "digraph \"wander\""), ("mermaid", "mmd", "stateDiagram-v2\n")]
    {
        let shown = build(&["wander.msd", "--emit", kind]);
        assert_eq!((shown.code, shown.err.as_str()), (0, ""), "{kind}");
        assert!(shown.out.starts_with(begins), "{}", shown.out);
        assert_eq!(build(&["wander.msd", "more", "--emit", kind, "-o", "pictures"]).code, 0);
        assert_eq!(project.read(&format!("pictures/wander.{extension}")), shown.out);
        assert!(project.read(&format!("pictures/ramble.{extension}")).contains("ramble"));
        let both = build(&["wander.msd", "more", "--emit", kind]);
        assert_eq!((both.code, both.out.as_str()), (2, ""));
        assert!(both.err.contains("there are 2 of them, and each is a text of its own"), "{}", both.err);
    }
    let listing = build(&["wander.msd", "--emit", "ir"]);
    assert!(listing.out.contains("\nbehavior wander on j5\n"), "{}", listing.out);
    let plan = build(&["wander.msd", "--emit", "plan", "--robot", "j5"]);
    assert!(plan.out.starts_with("behavior wander on j5\n"), "{}", plan.out);
    assert!(build(&["wander.msd", "--emit", "ir", "--robot", "j5"]).err.contains("`--robot` says nothing"));
    assert!(build(&["wander.msd", "--emit", "ir", "--float", "f32"]).err.contains("`--float` says nothing"));
    assert!(build(&["wander.msd", "--emit", "dot", "--faults", "1"]).err.contains("`--faults` says nothing"));
}

#[test]
fn build_says_what_keeps_it_from_building() {
    let project = Project::new(&[
        ("wander.msd", CLEAN),
        ("again/wander.msd", CLEAN),
        ("ramble.msd", &CLEAN.replace("wander", "ramble")),
        ("doubtful.msd", DOUBTFUL),
        ("wrong.msd", WRONG),
        ("bump.fsfn", BUMP),
    ]);
    let failed = |arguments: &[&str], code: i32, message: &str| {
        let answer = project.run(&[&["build"], arguments].concat());
        assert_eq!((answer.code, answer.out.as_str()), (code, ""), "{}", answer.err);
        assert!(answer.err.contains(message), "{}", answer.err);
    };
    failed(&["wander.msd", "--faults", "1"], 2, "`--faults` says nothing about what is made here");
    failed(&["wander.msd", "--emit", "promela", "--float", "f32"], 2, "`--float` says nothing");
    failed(&["wander.msd", "--emit", "prolog"], 2, "promela");
    failed(&["--emit", "promela"], 2, "<FILES>");
    failed(&["bump.fsfn", "--emit", "promela"], 2, "`bump.fsfn` holds no behavior");
    failed(&["wrong.msd", "--emit", "promela"], 1, "error[LM0201]");
    failed(&["wander.msd", "--emit", "promela", "-o", "none/model.pml"], 2, "`none/model.pml` cannot be written");
    let same = ["wander.msd", "again/wander.msd", "--emit", "promela", "-o"];
    failed(&[same.as_slice(), &["models"]].concat(), 2, "several are named `wander`");
    let several = ["wander.msd", "ramble.msd", "--emit", "promela", "-o", "bump.fsfn"];
    failed(&several, 2, "the folder `bump.fsfn` cannot be made");
    assert!(project.run(&["build", "doubtful.msd", "--emit", "promela"]).err.contains("warning[LM0406]"));
}

#[test]
fn build_refuses_what_is_too_large() {
    let mode = |mode: u32| format!("mode m{mode} {{ halt()  1: after 1 s -> m{} }}\n", (mode + 1) % 256);
    let modes = (0..256).map(mode).collect::<Vec<_>>().concat();
    let long = format!("import std.robots.j5\nbehavior long on j5 {{ entry m0\n{modes} }}");
    let above = |index: u32| {
        let wheels = ["left", "right"].map(|side| format!("{side}_wheel_acceleration > 0.{} m/s^2", index + 10));
        format!("contact_force > {index} N and {}", wheels.join(" and "))
    };
    let many = (0..14).map(above).collect::<Vec<_>>().join(" or ");
    let wide = format!(
        "import std.robots.j5\nbehavior wide on j5 {{ entry a
         mode a {{ halt()  1: {many} -> b }}  mode b {{ halt()  1: after 1 s -> a }} }}"
    );
    let project = Project::new(&[("long.msd", &long), ("wide.msd", &wide)]);
    let refused = |path: &str, message: &str| {
        let answer = project.run(&["build", "--quiet", "--emit", "promela", path]);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""));
        assert!(answer.err.contains(message), "{}", answer.err);
    };
    refused("long.msd", "Promela has no names for more than 255 modes");
    refused("wide.msd", "mode `a` of `wide` has more cases than are looked into");
}

#[test]
fn color_comes_where_it_is_asked_for() {
    let project = Project::new(&[("wrong.msd", WRONG), ("bump.fsfn", BUMP)]);
    let colored = |answer: &Answer| answer.out.contains('\u{1b}') || answer.err.contains('\u{1b}');
    let commands: [&[&str]; 3] =
        [&["check", "wrong.msd"], &["eval", "bump.fsfn", "bump", "left=1", "force=2"], &["explain", "no-such"]];
    for command in commands {
        assert!(!colored(&project.run(command)), "{command:?}: a pipe is no terminal");
        assert!(!colored(&project.run(&[command, &["--color", "never"]].concat())), "{command:?}");
        assert!(colored(&project.run(&[command, &["--color", "always"]].concat())), "{command:?}");
        // What is asked for by name counts more than what the environment would like.
        let output =
            project.command(&[command, &["--color", "always"]].concat()).env("NO_COLOR", "1").output().unwrap();
        assert!([output.stdout, output.stderr].concat().contains(&0x1b), "{command:?}");
    }
    for format in ["short", "json"] {
        assert!(!colored(&project.run(&["check", "wrong.msd", "--format", format, "--color", "always"])), "{format}");
    }
    assert_eq!(project.run(&["check", "wrong.msd", "--color", "pink"]).code, 2);
}

#[test]
fn quiet_leaves_out_what_was_not_asked_for() {
    let project = Project::new(&[("clean.msd", CLEAN), ("doubtful.msd", DOUBTFUL), ("wrong.msd", WRONG)]);
    for path in ["clean.msd", "doubtful.msd"] {
        let answer = project.run(&["check", "-q", path]);
        assert_eq!((answer.code, answer.out.as_str(), answer.err.as_str()), (0, "", ""), "{path}");
    }
    let wrong = project.run(&["check", "--quiet", "wrong.msd"]);
    assert_eq!(wrong.code, 1);
    assert!(wrong.err.contains("error[LM0201]") && !wrong.err.contains("1 error"), "{}", wrong.err);
    // What kept a command from being carried out is never left out.
    let unmet = project.run(&["-q", "run", "clean.msd"]);
    assert!(unmet.err.contains("error[LM0802]"), "{}", unmet.err);
    project.write("lmsl.toml", b"[levels]\nno-such-rule = \"allow\"\n");
    let configured = project.run(&["-q", "check", "clean.msd"]);
    assert!(configured.err.contains("error[LM0008]"), "{}", configured.err);
    project.write("lmsl.toml", b"");
    let short = project.run(&["-q", "check", "--format", "short", "doubtful.msd"]);
    assert_eq!(short.out.lines().count(), 1, "what was asked for stays");
    let project = Project::new(&[("wander.msd", CLEAN), ("trials.msd", TRIALS)]);
    let tested = project.run(&["test", "-q", "trials.msd", "--filter", "short"]);
    assert_eq!((tested.code, tested.err.as_str()), (0, ""));
}

#[test]
fn every_command_says_what_it_is_for() {
    let project = Project::new(&[]);
    let help = project.run(&["--help"]);
    assert_eq!(help.code, 0);
    for command in ["check", "run", "test", "eval", "faults", "build", "explain"] {
        assert!(help.out.contains(&format!("\n  {command}")), "{}", help.out);
        let own = project.run(&[command, "--help"]);
        assert_eq!(own.code, 0);
        assert!(own.out.contains("Usage: lmslc"), "{}", own.out);
    }
    let version = project.run(&["--version"]);
    assert_eq!(version.out, format!("lmslc {}\n", env!("CARGO_PKG_VERSION")));
}

const REFUTED: &str = "\
import std.behaviors.obstacle_manipulation

property no_push: never push
property turns: stop leads to random_turn within 2 s
property calm: always not failed(contact_force) or not push
";

#[test]
fn what_refutes_a_property_is_written_and_run() {
    let project = Project::new(&[("robots/pusher.msd", REFUTED)]);
    let answer = project.run(&["check", "robots/pusher.msd", "--counterexamples", "."]);
    assert_eq!(answer.code, 1, "{}", answer.err);
    assert!(answer.err.contains("`lmslc run ./no_push_refuted.msd` shows how"), "{}", answer.err);
    for (name, seen) in [("no_push", "held at 2.01 s"), ("turns", "nothing by 4.011 s answered")] {
        let file = format!("{name}_refuted.msd");
        assert!(project.read(&file).contains("import robots.pusher\nimport std.behaviors.obstacle_manipulation\n"));
        let run = project.run(&["run", &file, "--format", "json"]);
        assert_eq!((run.code, run.err.as_str()), (1, ""));
        let expectations = run.lines()[0]["expectations"].as_array().unwrap().clone();
        let of = |name: &str| {
            let is_it = |one: &&Value| one["text"].as_str().unwrap().starts_with(&format!("property {name}: "));
            expectations.iter().find(is_it).unwrap().clone()
        };
        assert_eq!((&of(name)["passed"], &of("calm")["passed"]), (&Value::Bool(false), &Value::Bool(true)));
        assert!(of(name)["seen"].as_str().unwrap().starts_with(seen), "{expectations:?}");
    }
    assert!(!project.0.path().join("calm_refuted.msd").exists());
    // A refuted property keeps nothing from being run, and nothing is written where it cannot be imported.
    let answer = project.run(&["check", "robots/pusher.msd", "--counterexamples", "elsewhere"]);
    assert_eq!(answer.code, 2);
    assert!(answer.err.contains("no file in `elsewhere` can import `robots/pusher.msd`"), "{}", answer.err);
    project.write("robots/pusher.msd", REFUTED.replace("property no_push: never push\n", "").as_bytes());
    project.write("robots/pusher.msd", project.read("robots/pusher.msd").replace("2 s", "2.01 s").as_bytes());
    let answer = project.run(&["check", "robots/pusher.msd"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, "1 file checked: nothing found, 2 properties proved\n"));
}

#[test]
fn build_prints_code_or_writes_it() {
    let project = Project::new(&[
        ("b.msd", CLEAN),
        ("empty.msd", "world w { }\n"),
        ("broken.msd", "behavior b on j5 { }\n"),
        (
            "any.msd",
            "interface i { action go() }\nbehavior b on i { entry a final mode a { go() } }\nrobot r provides i { action go() }\nrobot s provides i { action go() }\n",
        ),
    ]);
    let printed = project.run(&["build", "b.msd"]);
    assert_eq!(printed.code, 0, "{}", printed.err);
    assert!(
        printed.out.starts_with("// @generated by lmslc ") && printed.out.contains("fn drive(&mut self, speed: f64)")
    );
    let written =
        project.run(&["build", "b.msd", "--emit", "rust", "--float", "f32", "--serde", "state", "-o", "b.rs"]);
    assert_eq!((written.code, written.out.as_str()), (0, ""));
    let code = project.read("b.rs");
    assert!(code.contains("speed: f32") && code.contains("feature = \"state\"") && !code.contains("f64"), "{code}");
    let nothing = project.run(&["build", "empty.msd"]);
    assert_eq!((nothing.code, nothing.out.as_str()), (2, ""));
    assert!(nothing.err.contains("`empty.msd` declares no behavior and no network"), "{}", nothing.err);
    assert_eq!(project.run(&["build", "broken.msd"]).code, 1);
    let several = project.run(&["build", "any.msd"]);
    assert!(several.code == 2 && several.err.contains("compile it for: r, s"), "{}", several.err);
    assert_eq!(project.run(&["build", "any.msd", "--robot", "s"]).code, 0);
}

#[test]
fn what_is_missing_is_told_with_what_there_is() {
    let files = [("wander.msd", CLEAN), ("trials.msd", TRIALS), ("bump.fsfn", BUMP), ("empty.fsfn", "")];
    let project = Project::new(&files);
    let cases: [(&[&str], &str); 9] = [
        (&["eval", "empty.fsfn", "bump"], "error: `empty.fsfn` holds no network\n"),
        (&["graph", "bump.fsfn"], "error: `bump.fsfn` holds no behavior\n  = help: `--network` draws its networks\n"),
        (&["graph", "empty.fsfn"], "error: `empty.fsfn` holds no behavior\n"),
        (&["test", "wander.msd"], "error: `wander.msd` holds no scenario to run\n  = help: write `scenario name runs"),
        (
            &["test", ".", "--filter", "zz"],
            "error: no scenario has `zz` in its name\n  = help: there are: `short`, `wrong`, `long`\n",
        ),
        (
            &["run", "trials.msd", "short", "--fault", "x=1@1s"],
            "error: the robot has no sensor `x`\n  = help: its sensors",
        ),
        (&["explain", "unreachable"], "error: there is no diagnostic `unreachable`\n  = help: `lmslc explain --search"),
        (&["explain", "zzz"], "error: there is no diagnostic `zzz`\n  = help: `lmslc explain` lists all\n"),
        (&["fmt", "nowhere.msd"], "error: there is no file `nowhere.msd`\n"),
    ];
    for (arguments, message) in cases {
        let answer = project.run(arguments);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{arguments:?}");
        assert!(answer.err.starts_with(message), "{arguments:?}: {}", answer.err);
    }
}

#[test]
fn a_file_is_taken_once_and_caches_are_passed_over() {
    let files =
        [("wander.msd", CLEAN), ("node_modules/a.msd", "broken"), ("made/CACHEDIR.TAG", ""), ("made/a.msd", "broken")];
    let project = Project::new(&files);
    let whole = project.0.path().join("wander.msd");
    let answer = project.run(&["check", ".", "wander.msd", "./wander.msd", whole.to_str().unwrap()]);
    assert_eq!((answer.code, answer.err.as_str()), (0, "1 file checked: nothing found\n"));
    assert_eq!(project.run(&["check", "made"]).code, 1, "what is named itself is not passed over");
}
