//! `--watch`: another round for every change of what was read, and for nothing else.

use std::io::{BufRead as _, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use tempfile::TempDir;

/// More than any round takes on the slowest machine.
const PATIENCE: Duration = Duration::from_mins(1);

const WANDER: &str = "\
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

const TRIALS: &str = "\
import wander

scenario short runs wander {
    duration 1.5 s
    expect modes go, rest
}
";

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lmslc"));
    at_the_desk(command.args(arguments), folder);
    command
}

fn at_the_desk<'c>(command: &'c mut Command, folder: &Path) -> &'c mut Command {
    command.current_dir(folder).env("COLUMNS", "100").env("NO_COLOR", "1").env("TERM", "xterm")
}

/// A command that watches a folder.
struct Watching {
    folder: TempDir,
    child: Child,
    lines: Receiver<String>,
}

impl Watching {
    fn new(files: &[(&str, &str)], arguments: &[&str]) -> Self {
        let folder = TempDir::new().unwrap();
        for (path, text) in files {
            std::fs::write(folder.path().join(path), text).unwrap();
        }
        // What goes to standard output and what goes to standard error, in the order in which it is said.
        let mut shell = Command::new("sh");
        shell.args(["-c", "exec \"$@\" 2>&1", "sh", env!("CARGO_BIN_EXE_lmslc")]).args(arguments);
        let mut child = at_the_desk(&mut shell, folder.path()).stdout(Stdio::piped()).spawn().unwrap();
        let (send, lines) = channel();
        pass_on(child.stdout.take().unwrap(), send);
        Self { folder, child, lines }
    }

    fn write(&self, path: &str, text: &str) {
        std::fs::write(self.folder.path().join(path), text).unwrap();
    }

    fn path(&self, path: &str) -> std::path::PathBuf {
        self.folder.path().join(path)
    }

    /// What the next round says, up to the line in which it waits.
    fn round(&self) -> String {
        let mut said = String::new();
        loop {
            let line = self.lines.recv_timeout(PATIENCE).unwrap_or_else(|error| panic!("{error} after:\n{said}"));
            said += &line;
            said.push('\n');
            if line.starts_with("watching ") {
                return said;
            }
        }
    }
}

impl Drop for Watching {
    fn drop(&mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }
}

fn pass_on(from: impl Read + Send + 'static, to: Sender<String>) {
    std::thread::spawn(move || {
        for line in BufReader::new(from).lines() {
            // Nobody listens when the test is over.
            if to.send(line.unwrap()).is_err() {
                return;
            }
        }
    });
}

#[test]
fn every_change_of_what_was_read_is_a_round() {
    let files = [("wander.msd", WANDER), ("trials.msd", TRIALS)];
    let watching = Watching::new(&files, &["check", ".", "--watch"]);
    assert_eq!(watching.round(), "2 files checked: nothing found\nwatching 2 files; Ctrl-C ends\n");

    watching.write("wander.msd", &WANDER.replace("-> rest", "-> rset"));
    let said = watching.round();
    assert!(said.starts_with("--- `wander.msd` has changed\nerror[LM0201]: no mode is named `rset`\n"), "{said}");
    assert!(said.ends_with("\nwatching 2 files; Ctrl-C ends\n"), "{said}");

    // Half a file, as a person leaves it.
    watching.write("wander.msd", &WANDER[..70]);
    assert!(watching.round().contains("error[LM01"));

    // As editors save: into another file that then takes its name.
    watching.write("wander.msd~", WANDER);
    std::fs::rename(watching.path("wander.msd~"), watching.path("wander.msd")).unwrap();
    assert!(watching.round().contains("2 files checked: nothing found"));

    std::fs::remove_file(watching.path("wander.msd")).unwrap();
    let said = watching.round();
    assert!(said.contains("no file beside this one is named `wander`"), "{said}");
    assert!(said.ends_with("watching 1 file; Ctrl-C ends\n"), "{said}");

    watching.write("wander.msd", WANDER);
    assert!(watching.round().contains("2 files checked: nothing found"));

    watching.write("lmsl.toml", "[levels]\nno-such-rule = \"warn\"\n");
    let said = watching.round();
    assert!(said.contains("`lmsl.toml` has changed") && said.contains("no diagnostic `no-such-rule`"), "{said}");

    std::fs::remove_file(watching.path("lmsl.toml")).unwrap();
    assert!(watching.round().contains("2 files checked: nothing found"));

    std::fs::create_dir(watching.path("more")).unwrap();
    watching.write("more/world.msd", "world empty {\n}\n");
    assert!(watching.round().contains("3 files checked"));

    // Folders that are passed over, other files, and what is written as it was are no changes.
    std::fs::create_dir(watching.path("node_modules")).unwrap();
    watching.write("node_modules/other.msd", "broken");
    watching.write("notes.txt", "broken");
    watching.write("wander.msd", WANDER);
    watching.write("trials.msd", "broken");
    assert!(watching.round().starts_with("--- `trials.msd` has changed\nerror[LM0101]"));
}

#[test]
fn an_import_that_is_not_there_yet_is_waited_for() {
    let watching = Watching::new(&[("trials.msd", TRIALS)], &["check", "trials.msd", "--watch", "--format", "short"]);
    assert!(watching.round().starts_with("trials.msd:1:8: error[LM0003]"));
    watching.write("wander.msd", WANDER);
    assert_eq!(watching.round(), "--- `wander.msd` has changed\nwatching 2 files; Ctrl-C ends\n");
}

#[test]
fn a_file_that_is_not_there_yet_is_waited_for() {
    let watching = Watching::new(&[], &["check", "wander.msd", "--watch"]);
    assert!(watching.round().contains("watching 0 files"));
    watching.write("wander.msd", WANDER);
    assert!(watching.round().contains("1 file checked: nothing found"));
}

#[test]
fn scenarios_are_run_again() {
    let watching = Watching::new(&[("wander.msd", WANDER), ("trials.msd", TRIALS)], &["test", ".", "--watch"]);
    let said = watching.round();
    assert!(said.contains("ok     trials.msd: short") && said.contains("1 passed, 0 failed"), "{said}");
    watching.write("wander.msd", &WANDER.replacen("after 1 s", "after 2 s", 1));
    let said = watching.round();
    assert!(said.contains("FAILED trials.msd: short") && said.contains("0 passed, 1 failed"), "{said}");
}

#[test]
fn what_cannot_be_watched_is_refused() {
    let folder = TempDir::new().unwrap();
    for (arguments, reason) in [
        (&["check", "-", "--watch"][..], "error: standard input cannot be watched\n"),
        (&["test", "-", "--watch"], "error: standard input cannot be watched\n"),
        (&["check", ".", "--watch", "--format", "json"], "error: `--watch` goes with what people read"),
        (&["test", ".", "--watch", "--format", "json"], "error: `--watch` goes with what people read"),
        (&["check", ".", "--watch", "--fix"], "error: the argument '--watch' cannot be used with '--fix'"),
        (&["check", ".", "--watch", "--deny", "no-such-rule"], "error: there is no diagnostic `no-such-rule`"),
    ] {
        let output = command(folder.path(), arguments).stdin(Stdio::null()).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        let said = String::from_utf8(output.stderr).unwrap();
        assert!(said.starts_with(reason), "{said}");
    }
}

#[test]
fn a_terminal_is_cleared_for_each_round_until_it_is_interrupted() {
    let folder = TempDir::new().unwrap();
    std::fs::write(folder.path().join("wander.msd"), WANDER).unwrap();
    let command = command(folder.path(), &["check", "wander.msd", "--watch"]);
    let patience = u64::try_from(PATIENCE.as_millis()).unwrap();
    let mut terminal = rexpect::session::spawn_command(command, Some(patience)).unwrap();
    terminal.exp_string("\u{1b}[H").unwrap();
    terminal.exp_string("1 file checked").unwrap();
    terminal.exp_string("Ctrl-C ends").unwrap();
    std::fs::write(folder.path().join("wander.msd"), "").unwrap();
    terminal.exp_string("\u{1b}[2J").unwrap();
    terminal.exp_string("Ctrl-C ends").unwrap();
    terminal.send_control('c').unwrap();
    terminal.exp_eof().unwrap();
    // A shell shows it as 130.
    let end = format!("{:?}", terminal.process().wait().unwrap());
    assert!(end.contains("SIGINT"), "{end}");
}
