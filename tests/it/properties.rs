//! Properties: what is proved, what is refuted and by how short a run, and what stays open.

use lmslc::diag::{Diagnostic, rules};
use lmslc::driver::{Analysis, Options, analyze};
use lmslc::plan;
use lmslc::sim::{self, RunOptions};

use crate::support::{Memory, analyze_path, analyze_texts, doubts, report};

const ROBOT: &str = "
    robot cart {
        body differential_drive { mass 50 kg  size (1 m, 1 m)  track 0.6 m  traction 0.5 }
        sensor x: 1 in 0 .. 10 fails 3
        optional sensor y: 1 in 0 .. 10 fails 7
        action halt() = body.stop()
        action turn(angle: rad) -> done = body.rotate(angle)
    }
    ";

const MODES: &str = "
    behavior b on cart {
        flag high = x > 5
        entry rest
        mode rest { halt()  1: after 1 s and high -> go  2: after 2 s -> turn }
        mode go requires y else rest { halt()  1: after 500 ms -> turn  2: not high -> rest }
        mode turn { turn(1 rad)  1: done -> rest }
    }
    ";

fn look(text: &str, faults: usize, verify: bool) -> Analysis {
    let files = Memory::new(&[("b.msd", text)]);
    analyze(&files, &["b.msd".to_owned()], &Options { faults, verify, ..Options::default() })
}

fn on(modes: &str, property: &str) -> String {
    format!("{ROBOT}{modes}property p: {property}\n")
}

fn of(analysis: &Analysis, rule: &'static lmslc::diag::Rule) -> Option<Diagnostic> {
    analysis.findings.iter().find(|finding| finding.rule == rule).cloned()
}

#[track_caller]
fn proves(modes: &str, property: &str) {
    let analysis = look(&on(modes, property), 1, true);
    assert_eq!((analysis.proved, analysis.has_errors()), (1, false), "{property}\n{}", report(&analysis));
}

/// Demands that a property is refuted by a run of so many lines, and that the simulator shows it; answers the lines.
#[track_caller]
fn refutes(modes: &str, property: &str, lines: usize) -> Vec<String> {
    let text = on(modes, property);
    let analysis = look(&text, 1, true);
    let finding = of(&analysis, &rules::PROPERTY_REFUTED);
    let finding = finding.unwrap_or_else(|| panic!("{property}\n{}", report(&analysis)));
    let [shown] = &*analysis.counterexamples else { panic!("{property} is not shown\n{}", report(&analysis)) };
    assert!(finding.help.unwrap().contains(shown.text.trim_end()));
    assert!(is_broken(&text, &shown.text, &shown.name), "{property}\n{}", shown.text);
    let story: Vec<_> = finding.notes[0].lines().skip(1).map(str::to_owned).collect();
    assert_eq!(story.len(), lines, "{property}\n{}", finding.notes[0]);
    story
}

/// Whether the simulator breaks the property of a file in a scenario that is added to it.
fn is_broken(text: &str, scenario: &str, name: &str) -> bool {
    let analysis = look(&format!("{text}{scenario}"), 1, false);
    let checked = analysis.checked().unwrap_or_else(|| panic!("{}", report(&analysis)));
    let scenario = analysis.program.scenarios.values().find(|scenario| scenario.symbol.name == name).unwrap();
    let run = sim::run(&analysis.program, &plan::build_scenario(checked, scenario), scenario, &RunOptions::default());
    let verdicts = run.unwrap().verdicts;
    let [verdict] = &*verdicts else { panic!("{verdicts:?}") };
    assert!(verdict.text.starts_with("property p: "), "{}", verdict.text);
    !verdict.passed
}

#[test]
fn what_never_happens_is_proved() {
    for property in [
        "never go and failed(y)",
        "never go and after 510 ms",
        "never rest and after 2 s",
        "never turn and rest",
        "never go and not high and after 10 ms",
        "always rest or go or turn",
        "always not rising(go) or high",
        "always not rising(turn) or falling(go) or falling(rest)",
        "always not failed(x) or not high",
    ] {
        proves(MODES, property);
    }
}

#[test]
fn what_can_happen_is_refuted_by_a_short_run() {
    let start = "at 0 s: `rest` is entered; `x` at 0; `y` at 0";
    assert_eq!(refutes(MODES, "never rest", 1), [start]);
    let story = refutes(MODES, "never go", 2);
    assert_eq!(story, [start, "at 1 s: `rest` -> `go`; `x` at 8"]);
    refutes(MODES, "never turn", 2);
    refutes(MODES, "never go and after 490 ms", 3);
    refutes(MODES, "never go and y > 9", 2);
    refutes(MODES, "always rest or turn", 2);
    refutes(MODES, "always not (turn and failed(y))", 2);
    refutes(MODES, "never turn and failed(x)", 2);
    let story = refutes(MODES, "never falling(go) and failed(y)", 3);
    assert_eq!(story[2], "at 1.01 s: `go` -> `rest`; `y` has failed");
}

#[test]
fn a_run_waits_for_what_has_to_last() {
    let modes = "
        behavior b on cart {
            entry a
            mode a { halt()  1: held(x > 5, 300 ms) -> b  2: count(y > 5) >= 3 -> c }
            mode b { halt()  1: latched(y > 9) and after 1 s -> c  2: rising(x < 1) -> a }
            mode c { halt()  1: after 10 s -> a }
        }
        ";
    let story = refutes(modes, "never b", 2);
    assert_eq!(story[1], "at 300 ms: `a` -> `b`");
    // Three edges: up, down, up, down, up.
    refutes(modes, "never rising(c) and falling(a)", 6);
    refutes(modes, "never falling(b) and c", 3);
}

#[test]
fn answers_in_time_are_proved() {
    for property in [
        // One timer expires on the tick on which the limit is seen to have passed.
        "go leads to turn or rest within 500 ms",
        "rest leads to go or turn within 2 s",
        "rest and after 1500 ms leads to not rest within 500 ms",
        "turn leads to turn within 1 ms",
    ] {
        proves(MODES, property);
    }
}

#[test]
fn answers_that_can_be_late_are_refuted() {
    refutes(MODES, "rest leads to go within 10 s", 3);
    refutes(MODES, "go leads to turn within 500 ms", 3);
    let story = refutes(MODES, "rest leads to not rest within 1.99 s", 2);
    assert_eq!(story[1], "at 1.99 s: in `rest`; still no answer");
    // Out of `go` and into it again.
    refutes(MODES, "rising(rest) leads to turn within 2.51 s", 4);
}

#[test]
fn a_sum_of_timers_needs_a_tick_more() {
    let modes = "
        behavior b on cart {
            entry one
            mode one   { halt()  1: after 300 ms -> two }
            mode two   { halt()  1: after 500 ms -> three }
            mode three { halt()  1: after 1 s -> one }
        }
        ";
    proves(modes, "rising(one) leads to three within 810 ms");
    let analysis = look(&on(modes, "rising(one) leads to three within 800 ms"), 1, true);
    let finding = of(&analysis, &rules::PROPERTY_REFUTED).unwrap();
    assert!(finding.notes[0].starts_with("a run with ticks of 9 ms:\n"), "{}", finding.notes[0]);
    assert_eq!(finding.notes[1], "`within 810 ms` is proved");
    // A scenario with longer ticks makes more room necessary.
    let slow = "scenario slow runs b { duration 1 s  tick 50 ms }\n";
    let text = on(modes, "rising(one) leads to three within 810 ms") + slow;
    assert!(look(&text, 1, true).has_errors());
}

#[test]
fn as_many_sensors_fail_at_a_time_as_are_asked_for() {
    let property = "never failed(x) and failed(y) and turn";
    let with = |faults| look(&on(MODES, property), faults, true);
    assert_eq!((with(1).proved, with(2).proved), (1, 0));
    assert_eq!(look(&on(MODES, "never failed(x)"), 0, true).proved, 1);
    assert_eq!(of(&with(2), &rules::PROPERTY_REFUTED).unwrap().notes[0].lines().count(), 3);
}

#[test]
fn what_the_past_decides_stays_open() {
    let modes = "
        behavior b on cart {
            entry a
            mode a { halt()  1: count(x > 5) >= 2 and not latched(x > 5) -> b }
            mode b { halt()  1: after 1 s -> a }
        }
        ";
    let analysis = look(&on(modes, "never b"), 1, true);
    let finding = of(&analysis, &rules::PROPERTY_UNDECIDED).unwrap();
    assert!(finding.notes[0].starts_with("it cannot be excluded in `b`"), "{finding:?}");
    assert_eq!((analysis.proved, doubts(&analysis).len()), (0, 0));
    let analysis = look(&on(modes, "rising(a) leads to b within 1 s"), 1, true);
    assert!(of(&analysis, &rules::PROPERTY_REFUTED).is_some());
}

#[test]
fn an_event_with_a_memory_can_be_waited_for() {
    let text = format!(
        "import n\n{ROBOT}
         behavior b on cart {{
            sense n(x)
            entry a
            mode a {{ halt()  1: sure -> b }}
            mode b {{ halt()  1: after 1 s -> a }}
         }}
         property p: never b\n"
    );
    let fusion = "
        variable level: 1 in 0 .. 10 { low = ramp(6, 4)  high = ramp(4, 6) }
        network n(v: level) { event sure confirm 200 ms { contributor (high) detractor (low) } }";
    let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", fusion)]);
    let finding = of(&analysis, &rules::PROPERTY_REFUTED).unwrap_or_else(|| panic!("{}", report(&analysis)));
    assert!(finding.notes[0].ends_with("at 200 ms: `a` -> `b`"), "{}", finding.notes[0]);
}

#[test]
fn an_interface_is_judged_without_a_scenario() {
    let text = "
        interface base { sensor x: 1 in 0 .. 10  action halt() }
        behavior b on base {
            entry a
            mode a { halt()  1: x > 5 -> b }
            final mode b { halt() }
        }
        property p: never b\n";
    let analysis = look(text, 1, true);
    let finding = of(&analysis, &rules::PROPERTY_REFUTED).unwrap();
    assert!(analysis.counterexamples.is_empty() && finding.help.is_none());
    assert_eq!(finding.notes.last().unwrap(), "no scenario can show it: the behavior is written on an interface");
    let bodiless = on(MODES, "never go")
        .replace("body differential_drive { mass 50 kg  size (1 m, 1 m)  track 0.6 m  traction 0.5 }", "");
    let bodiless = bodiless.replace(" = body.stop()", "").replace(" = body.rotate(angle)", "");
    let analysis = look(&bodiless, 1, true);
    let finding = of(&analysis, &rules::PROPERTY_REFUTED).unwrap();
    assert_eq!(finding.notes.last().unwrap(), "no scenario can show it: its robot has no body");
}

#[test]
fn an_action_that_completes_is_waited_for_in_the_simulator() {
    refutes(MODES, "never rising(rest) and falling(turn)", 3);
}

#[test]
fn scenarios_watch_the_properties_of_what_they_run() {
    let text = on(MODES, "rest leads to go within 1 s");
    let scenario = "scenario s runs b { duration 3 s  fault x = 9  fault y = 0  expect modes rest, go }\n";
    let analysis = look(&format!("{text}{scenario}"), 1, false);
    let scenario = analysis.program.scenarios.values().next().unwrap();
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    let run = sim::run(&analysis.program, &plan, scenario, &RunOptions::default()).unwrap();
    let seen: Vec<_> = run.verdicts.iter().map(|verdict| (verdict.text.as_str(), verdict.passed)).collect();
    assert_eq!(seen, [("modes rest, go", true), ("property p: rest leads to go within 1 s", true)]);
    assert_eq!(run.verdicts[1].seen, "answered after 1 s at most");
}

#[test]
fn a_property_speaks_of_the_behavior_that_has_what_it_names() {
    let two = format!("{ROBOT}{MODES}behavior c on cart {{ entry on_its_own  final mode on_its_own {{ halt() }} }}\n");
    let found = |property: &str| {
        let analysis = look(&format!("{two}property {property}\n"), 1, true);
        let codes: Vec<_> = doubts(&analysis).iter().map(|finding| finding.rule.code).collect();
        (analysis.proved, codes)
    };
    assert_eq!(found("p: always on_its_own"), (1, vec![]));
    assert_eq!(found("p: never go and failed(y)"), (1, vec![]));
    assert_eq!(found("p: never x > 5 and failed(x)"), (0, vec!["LM0206"]));
    assert_eq!(found("p of c: never x > 5 and failed(x)"), (1, vec![]));
    assert_eq!(found("p of d: never x > 5"), (0, vec!["LM0201"]));
    assert_eq!(found("p of cart: never x > 5"), (0, vec!["LM0204"]));
    assert_eq!(found("p of c: rest leads to go"), (0, vec!["LM0311", "LM0201", "LM0201"]));
}

#[test]
fn the_examples_are_proved() {
    let analysis = analyze_path("examples/j5/properties.msd");
    let count = analysis.program.properties.values().count();
    assert_eq!((analysis.proved, doubts(&analysis).len()), (count, 0), "{}", report(&analysis));
    assert!(count >= 4);
}
