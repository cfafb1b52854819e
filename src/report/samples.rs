//! What the tests of this room render.

use crate::base::{FileId, Sources, Span, Unit};
use crate::diag::{Diagnostic, find_rule};
use crate::plan::{Code, Event, Input, NetworkPlan, Origin, Shape, Step};
use crate::report::Verdict;
use crate::trace::{Column, Evidence, ModeChange, Signal, Trace};

fn rule(code: &str) -> &'static crate::diag::Rule {
    find_rule(code).unwrap()
}

/// Three findings in two files: several labels, notes of two lines, a place in each file, and one without anything.
pub fn diagnostics() -> (Vec<Diagnostic>, Sources) {
    let mut sources = Sources::default();
    let behavior = "behavior obstacle_manipulation on J5 {\n    \
                    mode forward {\n        \
                    transition 1 to push when obstacle_id.forward_colision\n        \
                    transition 1 to stop when obstacle_id.heavy_obstacle\n    }\n}\n";
    let msd = sources.add("examples/j5.msd", behavior);
    let fsfn = sources.add("examples/obstacle.fsfn", "// größer als 1 µm\nvariable force: N in 0 .. 250 {\n}\n");
    let at = |file: FileId, words: &str, occurrence: usize| {
        let text = &sources.get(file).unwrap().text;
        let (start, _) = text.match_indices(words).nth(occurrence).unwrap();
        Span::new(file, start as u32, (start + words.len()) as u32)
    };
    let unknown = Diagnostic::new(rule("LM0201"), at(msd, "forward_colision", 0), "no event `forward_colision`")
        .here("not an event of `obstacle_id`")
        .help("did you mean `forward_collision`?");
    let twice = Diagnostic::new(rule("LM0403"), at(msd, "1", 1), "two transitions of `forward` with priority 1")
        .here("priority 1 again")
        .label(at(msd, "1", 0), "first used here")
        .label(at(fsfn, "force", 0), "both look at this variable")
        .note("the transition with the smallest number is taken\nwhere several conditions hold")
        .note("priorities are whole numbers from 1");
    let empty = Diagnostic::new(rule("LM0503"), at(fsfn, "variable force: N in 0 .. 250 {\n}\n", 0), "no terms");
    (vec![unknown, twice, empty], sources)
}

/// A run of four ticks a second with two collisions, for its words and numbers, not for its physics.
pub fn trace() -> Trace {
    let times: Vec<u64> = (0..=40).map(|tick| tick * 250_000_000).collect();
    let series = |of: &dyn Fn(f64) -> f64| times.iter().map(|&time| of(crate::trace::seconds(time))).collect();
    let column = |name: &str, unit: &str, signal, of: &dyn Fn(f64) -> f64| Column {
        name: name.to_owned(),
        unit: unit.to_owned(),
        signal,
        values: series(of),
    };
    let between = |from: f64, to: f64| move |t: f64| f64::from(from <= t && t < to);
    let evidence = |name: &str, text: &str| Evidence { name: name.to_owned(), text: text.to_owned() };
    let change = |time: u64, from, to, priority, condition: &str, evidence: Vec<Evidence>| ModeChange {
        time: time * 1_000_000,
        from,
        to,
        priority,
        condition: condition.to_owned(),
        evidence,
    };
    let modes = ["init", "forward", "stop", "back_up", "random_turn", "push"];
    Trace {
        scenario: "two_obstacles".to_owned(),
        behavior: "obstacle_manipulation".to_owned(),
        robot: "j5".to_owned(),
        seed: 1,
        modes: modes.map(str::to_owned).to_vec(),
        mode: times.iter().map(|&time| [0, 1, 5, 2, 3][(time / 2_000_000_000).min(4) as usize]).collect(),
        columns: vec![
            column("left_wheel_acceleration", "m/s^2", Signal::Reading(0), &|t| -1.71 * between(5.0, 5.25)(t)),
            column("contact_force", "N", Signal::Reading(1), &|t| 117.72 * between(5.0, 8.0)(t) + t / 3.0),
            column("obstacle_id.forward_collision", "1", Signal::Event(0), &|t| {
                between(5.0, 5.5)(t) + between(8.0, 8.25)(t)
            }),
            column("obstacle_id.heavy_obstacle", "1", Signal::Event(1), &between(8.0, 99.0)),
        ],
        changes: vec![
            change(0, None, 0, None, "", Vec::new()),
            change(2000, Some(0), 1, Some(1), "after 2 s", vec![evidence("time in mode", "2.00 s")]),
            change(
                5000,
                Some(1),
                5,
                Some(2),
                "forward_collision",
                vec![
                    evidence("forward_collision", "contributor 0.93 > detractor 0.00"),
                    evidence("left_wheel_acceleration", "-1.71 m/s^2"),
                    evidence("right_wheel_acceleration", "-1.71 m/s^2"),
                    evidence("contact_force", "117.72 N"),
                ],
            ),
            change(
                8000,
                Some(5),
                2,
                Some(1),
                "heavy_obstacle and not failed(contact_force) and after 1 s",
                vec![evidence("heavy_obstacle", "contributor 1.00 > detractor 0.00")],
            ),
            change(9500, Some(2), 3, None, "contact_force failed", Vec::new()),
        ],
        times,
        ..Trace::default()
    }
}

/// One expectation that is met, and one that is not.
pub fn verdicts() -> Vec<Verdict<'static>> {
    vec![
        Verdict { text: "modes init -> forward -> push -> stop -> back_up", passed: true, seen: None },
        Verdict {
            text: "never heavy_obstacle within 0 s .. 9 s",
            passed: false,
            seen: Some("heavy_obstacle set at 8 s, in mode stop: contributor 1.00 > detractor 0.00"),
        },
    ]
}

/// Acceleration and force, two terms each, and one event with two rules for it and one against it.
pub fn network() -> NetworkPlan {
    let input = |name: &str, unit: &str, low, high| Input {
        name: name.to_owned(),
        origin: Origin::default(),
        unit: Unit { text: unit.to_owned(), ..Unit::one() },
        low,
        high,
        fail: 0.0,
    };
    let degree = |of, zero_at, one_at, to| Step::Degree { of, shape: Shape::Ramp { zero_at, one_at }, to };
    let steps = vec![
        Step::Read { input: 0, to: 0 },
        Step::Read { input: 1, to: 1 },
        degree(0, 0.0, -1.0, 2),
        degree(0, -1.0, 0.0, 3),
        degree(1, 200.0, 0.0, 4),
        degree(1, 0.0, 200.0, 5),
        Step::Minimum { of: 0..2, to: 6 },
        Step::Minimum { of: 2..4, to: 7 },
        Step::Maximum { of: 4..6, to: 8 },
        Step::Minimum { of: 6..8, to: 9 },
        Step::Outweighs { contributor: 8, detractor: 9, to: 0 },
    ];
    let code = Code { steps, real_lists: vec![2, 4, 2, 5, 6, 7, 3, 4], reals: 10, bools: 1, ..Code::default() };
    let term = |name: &str, real| (name.to_owned(), real);
    let origin = Origin::default;
    NetworkPlan {
        position: 0,
        name: "obstacle_id".to_owned(),
        origin: origin(),
        inputs: vec![input("left", "m/s^2", -4.0, 4.0), input("force", "N", 0.0, 300.0)],
        code,
        degrees: vec![vec![term("neg", 2), term("zero", 3)], vec![term("low", 4), term("high", 5)]],
        strengths: vec![(vec![6, 7], vec![9])],
        rules: vec![(vec![Span::default(); 2], vec![Span::default()])],
        events: vec![Event {
            name: "forward_collision".to_owned(),
            origin: origin(),
            contributor: 8,
            detractor: 9,
            flag: 0,
        }],
        outputs: Vec::new(),
    }
}
