//! A behavior driven by hand: scripts on standard input, the sessions they leave behind, and a terminal.

use std::io::Write as _;
use std::process::{Command, Stdio};

use serde_json::Value;
use tempfile::TempDir;

use crate::support::root;

const MANIPULATION: &str = "examples/j5/manipulation.msd";

/// Everything that conditions can be made of.
const CONDITIONS: &str = "\
import std.robots.j5

behavior careful on j5 {
    flag pressed = contact_force > 50 N
    flag uneven  = left_wheel_acceleration > right_wheel_acceleration

    entry calm

    mode calm {
        halt()
        1: count(pressed) >= 2 or held(pressed, 50 ms) -> alarmed
        2: not failed(contact_force) and rising(uneven) and pressed -> alarmed
    }
    mode alarmed requires contact_force else calm {
        turn(90 deg)
        1: done and not pressed -> calm
    }
}
";

struct Answer {
    code: i32,
    out: String,
    err: String,
}

/// A folder to drive in.
struct Desk(TempDir);

impl Desk {
    fn new(files: &[(&str, &str)]) -> Self {
        let desk = Self(TempDir::new().unwrap());
        for (path, text) in files {
            std::fs::write(desk.0.path().join(path), text).unwrap();
        }
        desk
    }

    fn lmslc(&self, arguments: &[&str], input: &str) -> Answer {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lmslc"));
        command.args(arguments).current_dir(self.0.path()).env("COLUMNS", "100").env_remove("NO_COLOR");
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        // A command that does not read its input closes it early.
        let _ = child.stdin.take().unwrap().write_all(input.as_bytes());
        let output = child.wait_with_output().unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        Answer { code: output.status.code().unwrap(), out: text(output.stdout), err: text(output.stderr) }
    }

    /// Drives a file of the repository, or of this folder.
    fn drive(&self, file: &str, script: &str) -> Answer {
        let known = root().join(file);
        let file = if known.exists() { known.to_str().unwrap().to_owned() } else { file.to_owned() };
        self.lmslc(&["repl", &file], script)
    }

    /// The modes that a run of a file goes through.
    fn modes(&self, arguments: &[&str]) -> Vec<String> {
        let answer = self.lmslc(&[&["run", "--format", "json"], arguments].concat(), "");
        assert_eq!(answer.code, 0, "{}{}", answer.out, answer.err);
        let run: Value = serde_json::from_str(&answer.out).unwrap();
        let modes = run["modes"].as_array().unwrap().iter();
        modes.map(|entered| entered["mode"].as_str().unwrap().to_owned()).collect()
    }
}

#[test]
fn a_script_is_answered_line_by_line() {
    let answer = Desk::new(&[]).drive(
        MANIPULATION,
        "// the first box is light\nstep 2 s\nset contact_force = 0.12 kN\nstep\nwhy\nset contact_force = 500 N\nstep\n\
         why\nundo\nundo\nfail contact_force\nstep\nwhy\nshow\nquit\nstep\n",
    );
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
}

#[test]
fn conditions_are_taken_apart() {
    let answer = Desk::new(&[("careful.msd", CONDITIONS)]).drive(
        "careful.msd",
        "step\nset contact_force = 60\nstep 2\nwhy\nset contact_force = 0\nstep\nset contact_force = 60\n\
         set left_wheel_acceleration = 100 cm/s^2\nstep\nwhy\nundo\nundo\nfail contact_force\nstep\nheal contact_force\n\
         set contact_force = 60\nstep 60 ms\nwhy\nwatch pressed\nset contact_force = 0\ndone\nstep 2\nwhy\n",
    );
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
}

#[test]
fn arrays_and_logical_sensors_are_set_as_one() {
    let answer = Desk::new(&[]).drive(
        "stdlib/behaviors/collision_avoidance.msd",
        "set sonar = 5\nstep\nwatch front\nset front = 0.3\nset sonar[0] = 0.2\nstep\ndegrees clearances\nfail front\nstep\n\
         heal sonar\nheal sonar\nset front_bumper = set\nset front_bumper = 3\nstep\nset nothing = 3\n",
    );
    assert_eq!(answer.code, 1);
    insta::assert_snapshot!(answer.out + &answer.err);
}

#[test]
fn an_inhibited_target_is_told_from_a_condition_that_does_not_hold() {
    let answer = Desk::new(&[]).drive(
        MANIPULATION,
        "step 2 s\nfail contact_force\nset left_wheel_acceleration = -4\nset right_wheel_acceleration = -4\nstep\nwhy\n",
    );
    assert_eq!(answer.code, 0);
    let inhibited = "but push is inhibited: it requires `contact_force`, which has failed";
    assert!(answer.out.contains(inhibited), "{}", answer.out);
}

#[test]
fn what_cannot_be_carried_out_says_so_and_changes_nothing() {
    let script = "stpe\nstep 2 N\nstep 0\nstep 400 h\nset contct_force = 3\nset contact_force = 3 V\nset contact_force = x\n\
                  set contact_force\nset\nfail\nfail it\nheal contact_force\nwatch force\nunwatch contact_force\ndone\nwhy\n\
                  degrees\ndegrees x\nsave here.msd\nsave\nload nowhere.csv\nundo\nshow what\nshow\n";
    let answer = Desk::new(&[]).drive(MANIPULATION, script);
    assert_eq!((answer.code, answer.err.as_str()), (1, ""));
    assert_eq!(answer.out.matches("  error: ").count(), script.lines().count() - 1, "{}", answer.out);
    insta::assert_snapshot!(answer.out);
}

#[test]
fn no_line_makes_it_panic() {
    let words =
        ["set", "step", "=", "é", "contact_force", "1e999", "-", "NaN", "99999999999999999999", "//", "\u{0}", "'"];
    let lines =
        words.iter().flat_map(|one| words.iter().map(move |two| format!("{one} {two}\nset contact_force = {two}")));
    let answer = Desk::new(&[]).drive(MANIPULATION, &lines.collect::<Vec<_>>().join("\n"));
    assert_eq!(answer.code, 1, "{}", answer.err);
}

#[test]
fn a_saved_session_goes_through_the_same_modes() {
    let desk = Desk::new(&[]);
    let script = "step 2 s\nset contact_force = 120 N\nstep 500 ms\nset contact_force = 300 N\nstep 500 ms\n\
                  set contact_force = 0 N\nstep 2 s\ndone\nstep 1 s\nfail contact_force\n\
                  set left_wheel_acceleration = -1.5 m/s^2\nstep 1 s\nsave by_hand.msd\nsave by_hand.msd\n";
    let answer = desk.drive(MANIPULATION, script);
    assert_eq!(answer.code, 1, "the second time the file is there: {}", answer.out);
    let modes = ["init", "forward", "push", "stop", "back_up", "random_turn", "forward"];
    let reached: Vec<_> = answer.out.lines().filter(|line| line.contains(" -> ") || line.contains("entered")).collect();
    let went = desk.modes(&["by_hand.msd"]);
    assert_eq!(reached.len(), modes.len(), "{reached:#?}");
    assert_eq!(went, modes);
    assert_eq!(desk.lmslc(&["check", "by_hand.msd", "--deny", "warnings"], "").code, 0);
    assert_eq!(desk.lmslc(&["fmt", "--check", "by_hand.msd"], "").code, 0);
    insta::assert_snapshot!(std::fs::read_to_string(desk.0.path().join("by_hand.msd")).unwrap());
}

#[test]
fn a_session_that_the_simulator_does_not_repeat_is_not_saved() {
    let desk = Desk::new(&[("careful.msd", CONDITIONS)]);
    let alarm = "step\nset contact_force = 60 N\nstep 100 ms\n";
    let answer = desk.drive("careful.msd", &format!("{alarm}set contact_force = 0\nstep 1 min\nsave never_done.msd\n"));
    assert_eq!(answer.code, 1);
    assert!(answer.out.contains("the simulated robot completes its actions at other times"), "{}", answer.out);
    let answer = desk.drive("careful.msd", &format!("{alarm}save alarm.msd\nsave careful.msd\n"));
    assert!(answer.out.contains("the program has something named `careful`"), "{}", answer.out);
    assert_eq!(desk.modes(&["alarm.msd"]), ["calm", "alarmed"]);
}

#[test]
fn a_trace_is_replayed_and_can_be_changed() {
    let desk = Desk::new(&[]);
    let file = root().join(MANIPULATION);
    let file = file.to_str().unwrap();
    for trace in ["trace.csv", "trace.jsonl"] {
        let run = desk.modes(&[file, "--trace", trace]);
        assert_eq!(run.len(), 6);
        let answer =
            desk.drive(MANIPULATION, &format!("load {trace}\nstep 10 s\nundo\ndone\nstep\nsave {trace}.msd\n"));
        assert!(answer.out.contains("  1001 ticks, in the modes of the trace\n"), "{}", answer.out);
        assert!(answer.out.contains("random_turn -> forward"), "{}", answer.out);
    }
    let failed = desk.lmslc(&["run", file, "--fault", "contact_force=failed@6s", "--trace", "failed.csv"], "");
    assert_eq!(failed.code, 1, "a box is pushed no longer");
    let answer = desk.drive(MANIPULATION, "load failed.csv\nshow\nsave failed.msd\n");
    assert!(answer.out.contains("contact_force             failed"), "{}", answer.out);
    assert_eq!(desk.modes(&["failed.msd"]), ["init", "forward", "push", "stop", "back_up", "random_turn"]);
    let slower = desk.lmslc(&["repl", file, "--tick", "20ms"], "load failed.csv\n");
    assert!(slower.out.contains("begin the session with `--tick 10ms`"), "{}", slower.out);
}

#[test]
fn the_behavior_is_chosen_by_name() {
    let two = CONDITIONS.to_owned()
        + "behavior bold on j5 {\n    entry go\n    final mode go {\n        drive(26 cm/s)\n    }\n}\n";
    let desk = Desk::new(&[("two.msd", &two)]);
    let refused = desk.lmslc(&["repl", "two.msd"], "");
    assert_eq!(refused.code, 2);
    assert!(refused.err.contains("`two.msd` has 2 behaviors; which one?"), "{}", refused.err);
    assert!(desk.lmslc(&["repl", "two.msd", "blod"], "").err.contains("did you mean `bold`?"));
    let answer = desk.lmslc(&["repl", "two.msd", "bold"], "step\nwhy\nstep\nwhy\nshow\n");
    assert_eq!(answer.code, 0);
    insta::assert_snapshot!(answer.out);
}

#[test]
fn a_terminal_has_completion_and_history() {
    let state = TempDir::new().unwrap();
    let session = |no_color: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lmslc"));
        command.arg("repl").arg(root().join(MANIPULATION)).env("TERM", "xterm").env("NO_COLOR", no_color);
        command.env("XDG_STATE_HOME", state.path());
        rexpect::session::spawn_command(command, Some(20_000)).unwrap()
    };
    let mut terminal = session("1");
    type_line(&mut terminal, "ste\t2 s\r", "at 2 s: in forward");
    type_line(&mut terminal, "fail con\t\r", "");
    type_line(&mut terminal, "step\r", "at 2.01 s: in forward");
    // The line before, once more.
    type_line(&mut terminal, "\u{1b}[A\r", "at 2.02 s: in forward");
    type_line(&mut terminal, "\u{4}", "");
    terminal.exp_eof().unwrap();
    // The lines of one session are there in the next, which the last line of the first has ended.
    let mut terminal = session("1");
    type_line(&mut terminal, "step 2 s\r", "at 2 s: in forward");
    type_line(&mut terminal, "\u{1b}[A\u{1b}[A\r", "at 2.01 s: in forward");
    type_line(&mut terminal, "wat\tcontact_force > 50 N and forward_c\t\r", "");
    type_line(&mut terminal, "watch\r", "contact_force > 50 N and forward_collision  no");
    type_line(&mut terminal, "\u{4}", "");
    terminal.exp_eof().unwrap();
    assert!(std::fs::read_to_string(state.path().join("lmslc/repl_history")).unwrap().contains("fail contact_force"));
    let mut terminal = session("");
    type_line(&mut terminal, "watch held(contact_force > 1 N, 1 s)\r", "\u{1b}[36mcontact_force");
    type_line(&mut terminal, "\u{4}", "");
    terminal.exp_eof().unwrap();
}

/// A line is drawn where the terminal says that its cursor is.
fn type_line(terminal: &mut rexpect::session::PtySession, keys: &str, answer: &str) {
    terminal.exp_string("\u{1b}[6n").unwrap();
    terminal.send("\u{1b}[1;1R").unwrap();
    terminal.send(keys).unwrap();
    terminal.flush().unwrap();
    terminal.exp_string(answer).unwrap();
}

#[test]
fn conditions_are_watched_as_a_transition_would_see_them() {
    let desk = Desk::new(&[("careful.msd", CONDITIONS)]);
    let answer = desk.drive(
        "careful.msd",
        "watch contact_force > 50 N and after 20 ms\nwatch held(pressed, 30 ms)\nwatch alarmed\nstep\n\
         set contact_force = 60\nstep 3\nwatch count(rising(pressed)) >= 1\nwatch done\nstep 10\nundo\nstep 2\n\
         unwatch alarmed\nstep 10\nwatch\n",
    );
    assert_eq!((answer.code, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
}

#[test]
fn what_is_no_condition_is_not_watched() {
    let desk = Desk::new(&[("careful.msd", CONDITIONS)]);
    let script = "watch contact_force > 50\nwatch contact_force >\nwatch contct_force > 5 N\nwatch pressed }\n\
                  watch pressed world w { }\nwatch pressed leads to uneven within 1 s\nwatch (pressed\nwatch alarmde\n\
                  watch done\nwatch done\nwatch alarmed and\n";
    let answer = desk.drive("careful.msd", script);
    assert_eq!(answer.code, 1);
    assert_eq!(answer.out.matches("  error: ").count(), script.lines().count() - 1, "{}", answer.out);
    insta::assert_snapshot!(answer.out);
}

#[test]
fn a_watched_condition_follows_a_trace_that_is_loaded() {
    let desk = Desk::new(&[]);
    desk.modes(&[root().join(MANIPULATION).to_str().unwrap(), "--trace", "run.csv"]);
    let answer = desk.drive(MANIPULATION, "watch push or stop\nload run.csv\nstep 1\nundo\nundo\nstep\n");
    assert_eq!(answer.code, 0, "{}", answer.out);
    assert!(answer.out.contains("push or stop  no"), "{}", answer.out);
}
