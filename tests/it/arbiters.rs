//! Arbiters: who commands a robot, and what everybody sees of it a tick later.

use lmslc::interp::{Actuators, Inputs, Machine, Reading};
use lmslc::plan;
use lmslc::sim::{RunOptions, run};
use lmslc::trace::Trace;

use crate::support::{analyze_path, analyze_texts, report};

const ROBOT: &str = "
    robot cart runs drive {
        body differential_drive { mass 20 kg  size (0.6 m, 0.5 m)  track 0.4 m  traction 0.5 }
        sensor near: m in 0 .. 9  fails 9
        sensor bumper: contact  fails set
        action go(distance: m) -> done
        action back(distance: m) -> done
        action stop()
        action brake() = body.stop()
        action roll(distance: m) -> done = body.travel(distance, 20 cm/s)
    }
    behavior drive on cart {
        entry idle
        mode idle    { brake()  1: command is go -> moving }
        mode moving  { roll(command.distance)  1: not command is go -> idle  2: done -> idle }
    }
    behavior onward on cart { entry go_on  final mode go_on { go(0 m) } }
    behavior other on cart { entry go_back  final mode go_back { back(0 m) } }
    behavior shy on cart {
        flag is_near = near < 1 m
        entry watch
        final mode watch { decide (is_near) { (set) => stop()  (clear) => nothing } }
    }
    ";

/// What was commanded on each tick, by name.
#[derive(Default)]
struct Commands {
    names: Vec<String>,
    now: Option<u32>,
}

impl Actuators for Commands {
    fn command(&mut self, action: u32, _: &[f64], _: bool) {
        self.now = Some(action);
    }
}

/// Who had the robot on each tick and what it was told, given the distance and the bumper on each.
fn ticks(arbiter: &str, told: &[(f64, bool)], seed: u64) -> Vec<(String, String)> {
    let analysis = analyze_texts(&[("cart.msd", &format!("{ROBOT}{arbiter}"))]);
    assert!(!analysis.has_errors(), "{}", report(&analysis));
    let checked = analysis.checked().unwrap();
    let (id, _) = analysis.program.diagrams.iter().find(|(_, diagram)| diagram.arbiter.is_some()).unwrap();
    let plan = plan::build_alone(checked, id, &[]);
    let mut machine = Machine::new(&plan, seed);
    let mut commands = Commands::default();
    for &(near, bumper) in told {
        let reading = |name: &str| match name {
            "near" => near,
            "bumper" => f64::from(u8::from(bumper)),
            _ => 0.0,
        };
        let readings: Vec<_> =
            plan.inputs.iter().map(|input| Reading { value: reading(&input.name), healthy: true }).collect();
        commands.now = None;
        machine.step(Inputs { readings: &readings, done: false }, 10_000_000, &mut commands);
        let name = commands.now.map_or("-", |action| plan.actions[action as usize].name.as_str());
        commands.names.push(format!("{} {name}", plan.modes[machine.mode() as usize].name));
    }
    let split = |line: &String| line.split_once(' ').map(|(who, what)| (who.to_owned(), what.to_owned()));
    commands.names.iter().filter_map(split).collect()
}

fn pairs(ticks: &[(String, String)]) -> Vec<(&str, &str)> {
    ticks.iter().map(|(who, what)| (who.as_str(), what.as_str())).collect()
}

#[test]
fn the_smallest_number_wins_whatever_the_order_in_the_text() {
    for clients in [
        "client onward = onward priority 9  client shy = shy priority 1",
        "client shy = shy priority 1  client onward = onward priority 9",
    ] {
        let found =
            ticks(&format!("arbiter crew on cart {{ {clients} }}"), &[(5.0, false), (0.5, false), (5.0, false)], 1);
        assert_eq!(pairs(&found), [("onward", "go"), ("shy", "stop"), ("onward", "go")]);
    }
}

#[test]
fn nobody_commands_where_nobody_proposes() {
    let found = ticks("arbiter crew on cart { client shy = shy priority 1 }", &[(5.0, false), (0.5, false)], 1);
    assert_eq!(pairs(&found), [("nobody", "-"), ("shy", "stop")]);
}

#[test]
fn an_emergency_bypasses_everyone() {
    let crew = "arbiter crew on cart { emergency bumper -> brake()  client onward = onward priority 1 }";
    let found = ticks(crew, &[(5.0, false), (5.0, true), (5.0, false)], 1);
    assert_eq!(pairs(&found), [("onward", "go"), ("emergency", "brake"), ("onward", "go")]);
}

#[test]
fn ties_are_broken_in_order_or_by_chance() {
    let crew = |ties: &str| {
        format!("arbiter crew on cart {{ client one = onward priority 4  client two = other priority 4  ties {ties} }}")
    };
    let told = vec![(5.0, false); 64];
    assert!(ticks(&crew("in_order"), &told, 1).iter().all(|(who, _)| who == "one"));
    let by_chance = ticks(&crew("random"), &told, 1);
    let ones = by_chance.iter().filter(|(who, _)| who == "one").count();
    assert!((12..=52).contains(&ones), "{ones} of 64");
    assert_eq!(by_chance, ticks(&crew("random"), &told, 1), "a run is a function of its seed");
    assert_ne!(by_chance, ticks(&crew("random"), &told, 2));
}

#[test]
fn priorities_may_depend_on_conditions() {
    let crew = "arbiter crew on cart {
        client shy = shy priority 1 when near < 50 cm else 5
        client onward = onward priority 3
    }";
    let found = ticks(crew, &[(0.9, false), (0.4, false)], 1);
    assert_eq!(pairs(&found), [("onward", "go"), ("shy", "stop")]);
}

#[test]
fn clients_see_a_tick_later_who_won() {
    let crew = "behavior yielding on cart {
            entry push_on
            mode push_on  { go(0 m)    1: lost -> fall_back }
            mode fall_back { back(0 m)  1: won  -> push_on }
        }
        arbiter crew on cart { client shy = shy priority 1  client yielding = yielding priority 5 }";
    let found = ticks(crew, &[(5.0, false), (0.5, false), (5.0, false), (5.0, false)], 1);
    // It loses on the second tick, sees it on the third, wins with another command, and sees that on the fourth.
    assert_eq!(pairs(&found), [("yielding", "go"), ("shy", "stop"), ("yielding", "back"), ("yielding", "go")]);
}

fn trace(path: &str) -> Trace {
    let analysis = analyze_path(path);
    assert!(!analysis.has_errors(), "{}", report(&analysis));
    let (_, scenario) = analysis.program.scenarios.iter().next().unwrap();
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    run(&analysis.program, &plan, scenario, &RunOptions::default()).unwrap().trace
}

#[test]
fn the_log_reads_as_the_papers() {
    let trace = trace("examples/labmate/table_1.msd");
    let log: Vec<_> = trace.log.iter().take(3).map(|entry| entry.text.as_str()).collect();
    assert_eq!(
        log,
        [
            "Accepted GO-FRWD from 2 (wander)",
            "Accepted TURN-RIGHT from 1 (avoid: forward)",
            "Rejected GO-FRWD from 2 (wander)",
        ]
    );
}

#[test]
fn a_deadlock_is_named_in_the_log() {
    let trace = trace("examples/labmate/deadlock.msd");
    assert!(trace.log.iter().any(|entry| entry.text == "Accepted STOP from 1 (avoid: deadlock)"), "{:?}", trace.log);
}

#[test]
fn the_six_states_are_passed_through_idle() {
    let trace = trace("examples/labmate/table_1.msd");
    let states = trace.columns.iter().find(|column| column.name == "state").unwrap();
    let mut went: Vec<f64> = states.values.clone();
    went.dedup();
    // idle, forward, idle, right, idle: never from one motion to another.
    assert_eq!(went[..5], [0.0, 1.0, 0.0, 3.0, 0.0]);
    assert!(went.windows(2).all(|pair| pair.contains(&0.0)), "{went:?}");
}
