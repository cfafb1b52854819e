//! What stands on a terminal that does not stand in a file: progress, colors, its width.

use std::process::{Command, Stdio};

use tempfile::TempDir;

/// More than any command takes on the slowest machine, in milliseconds.
const PATIENCE: u64 = 120_000;
/// What takes a line off the terminal.
const ERASED: &str = "\u{1b}[2K";

/// A behavior, and scenarios that run it for longer than progress waits.
fn many(scenarios: usize) -> String {
    let behavior = "import std.robots.j5\n\nbehavior wander on j5 {\n    entry go\n\n    mode go {\n        \
                    drive(26 cm/s)\n        1: after 1 s -> rest\n    }\n    mode rest {\n        halt()\n        \
                    1: after 1 s -> go\n    }\n}\n";
    let scenario = |number| {
        format!(
            "\nscenario s{number} runs wander {{\n    duration 100 s\n    expect go -> rest within 0 s .. 5 s\n}}\n"
        )
    };
    behavior.to_owned() + &(0..scenarios).map(scenario).collect::<String>()
}

fn command(folder: &TempDir, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lmslc"));
    command.args(arguments).current_dir(folder.path()).env("TERM", "xterm");
    for name in ["NO_COLOR", "CLICOLOR_FORCE", "CI", "COLUMNS"] {
        command.env_remove(name);
    }
    command
}

/// Everything that a command writes to a terminal.
fn on_a_terminal(command: Command) -> String {
    rexpect::session::spawn_command(command, Some(PATIENCE)).unwrap().exp_eof().unwrap()
}

fn folder(text: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    std::fs::write(folder.path().join("many.msd"), text).unwrap();
    folder
}

#[test]
fn progress_is_shown_while_scenarios_run_and_gone_at_the_end() {
    let count = if cfg!(debug_assertions) { 30 } else { 1500 };
    let folder = folder(&many(count));
    let seen = on_a_terminal(command(&folder, &["test", "many.msd"]));
    assert!(seen.contains(&format!("/{count} scenarios run")), "{seen}");
    let (progress, left) = seen.rsplit_once(ERASED).unwrap();
    assert!(!progress.contains("many.msd: s0"), "it is gone before the first result");
    assert_eq!(left.lines().count(), count + 1, "{left}");
    assert!(left.trim_end().ends_with(&format!("{count} passed, 0 failed")), "{left}");
}

#[test]
fn progress_is_for_terminals_that_want_it_and_for_long_runs() {
    let folder = folder(&many(if cfg!(debug_assertions) { 8 } else { 400 }));
    for (name, value) in [("NO_COLOR", "1"), ("TERM", "dumb"), ("CI", "true")] {
        let mut command = command(&folder, &["test", "many.msd"]);
        command.env(name, value);
        let seen = on_a_terminal(command);
        assert!(!seen.contains("scenarios run") && !seen.contains(ERASED), "{name}: {seen}");
    }
    let quick = self::folder(&many(1).replace("100 s", "100 ms").replace(".. 5 s", ".. 50 ms"));
    let seen = on_a_terminal(command(&quick, &["test", "many.msd", "--quiet"]));
    assert!(!seen.contains("scenarios run") && !seen.contains(ERASED), "{seen}");
    let output = command(&folder, &["test", "many.msd"]).stdin(Stdio::null()).output().unwrap();
    let count = if cfg!(debug_assertions) { 8 } else { 400 };
    let line = |number| format!("ok     many.msd: s{number} (1 expectation)\n");
    assert_eq!(String::from_utf8(output.stdout).unwrap(), (0..count).map(line).collect::<String>());
    assert_eq!(String::from_utf8(output.stderr).unwrap(), format!("{count} passed, 0 failed\n"));
}

#[test]
fn colors_are_for_terminals_unless_the_environment_or_a_flag_says_otherwise() {
    let folder = folder("behavior");
    let has_color = |text: &str| text.contains("\u{1b}[");
    let arguments = ["check", "many.msd"];
    assert!(has_color(&on_a_terminal(command(&folder, &arguments))));
    for (name, value) in [("NO_COLOR", "1"), ("TERM", "dumb")] {
        let mut command = command(&folder, &arguments);
        command.env(name, value);
        assert!(!has_color(&on_a_terminal(command)), "{name}");
    }
    let piped = |arguments: &[&str], environment: &[(&str, &str)]| {
        let output = command(&folder, arguments).envs(environment.iter().copied()).output().unwrap();
        has_color(&String::from_utf8(output.stderr).unwrap())
    };
    assert!(!piped(&arguments, &[]));
    assert!(piped(&arguments, &[("CLICOLOR_FORCE", "1")]));
    assert!(!piped(&arguments, &[("CLICOLOR_FORCE", "0")]));
    assert!(!piped(&arguments, &[("CLICOLOR_FORCE", "1"), ("NO_COLOR", "1")]));
    assert!(piped(&["check", "many.msd", "--color", "always"], &[("NO_COLOR", "1")]));
    assert!(!piped(&["check", "many.msd", "--color", "never"], &[("CLICOLOR_FORCE", "1")]));
}
