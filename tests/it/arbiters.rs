//! Arbiters: who commands a robot, and what everybody sees of it a tick later.

use lmslc::analysis::modes::{self, Facts, Fault as Failure};
use lmslc::base::Span;
use lmslc::driver::Analysis;
use lmslc::interp::{Actuators, Inputs, Machine, Reading};
use lmslc::ir::{Fault, FaultReading, Window};
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
    faulted(&analysis, &[])
}

/// A run of the first scenario with silent faults: sensors by name, and what they read.
fn faulted(analysis: &Analysis, faults: &[(&str, f64)]) -> Trace {
    let program = &analysis.program;
    let (_, scenario) = program.scenarios.iter().next().unwrap();
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    let sensors = program.robots[scenario.robot].all_sensors();
    let faults = faults.iter().flat_map(|&(name, reading)| {
        let stuck = FaultReading::Stuck(reading);
        let meant = program.measuring_named(name, &sensors).into_iter();
        meant.map(move |sensor| Fault { sensor, reading: stuck, window: Window::WHOLE, span: Span::default() })
    });
    let options = RunOptions { faults: faults.collect(), ..RunOptions::default() };
    run(program, &plan, scenario, &options).unwrap().trace
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

/// What the checker says of `deadlock` with one sensor failed is what happens in a closet: each sonar alone takes nothing
/// away, each side as a whole keeps the deadlock from being seen.
#[test]
fn each_sonar_and_each_side_fail_as_the_checker_says() {
    let analysis = analyze_path("examples/labmate/deadlock.msd");
    let (id, avoidance) =
        analysis.program.diagrams.iter().find(|(_, of)| of.symbol.name == "collision_avoidance").unwrap();
    let entry = avoidance.entry.unwrap();
    let leads = |target: Option<_>| target.is_some_and(|mode| avoidance.modes[mode].symbol.name == "deadlock");
    let exit = avoidance.modes[entry].transitions.iter().position(|exit| leads(exit.target)).unwrap();
    let facts = modes::fault_table(&analysis.program, id, 1);
    let can_stop = |failed: &str| {
        let is_it = |facts: &&Facts| {
            matches!(facts.faults.as_slice(), [(sensor, Failure::Stuck(_))]
            if analysis.program.sensors[*sensor].symbol.name == failed)
        };
        // What is not among the sets of faults makes no difference.
        let found = facts.iter().find(is_it).or_else(|| facts.iter().find(|facts| facts.faults.is_empty()));
        found.unwrap().modes[entry.index()].exits[exit].is_some()
    };
    let stops = |failed: &str| {
        let trace = faulted(&analysis, &[(failed, 10.0)]);
        trace.log.iter().any(|entry| entry.text.ends_with("(avoid: deadlock)"))
    };
    for sonar in 0..24 {
        let sonar = format!("sonar[{sonar}]");
        assert_eq!((can_stop(&sonar), stops(&sonar)), (true, true), "{sonar}");
    }
    for side in ["front", "left", "back", "right"] {
        assert_eq!((can_stop(side), stops(side)), (false, false), "{side}");
    }
}

/// Fig. 6: through `idle` when the command changes, into `faulted` on contact, out of it by RESET, and what only looks is
/// allowed in every state.
#[test]
fn labmate_carries_out_its_commands_by_six_states() {
    let analysis = analyze_path("stdlib/robots/labmate.msd");
    let (id, _) = analysis.program.diagrams.iter().find(|(_, of)| of.symbol.name == "labmate_drive").unwrap();
    let plan = plan::build_alone(analysis.checked().unwrap(), id, &[]);
    let mut machine = Machine::new(&plan, 0);
    let mut went = |command: &str, near: &str, done: bool| {
        let number = plan.actions.iter().position(|action| action.name == command).map_or(0, |place| place + 1);
        let reading = |name: &str| match name {
            "command" => number as f64,
            "command.speed" => -0.2,
            name if name.starts_with("sonar[") => {
                if name == near {
                    0.2
                } else {
                    2.0
                }
            }
            name => f64::from(u8::from(name == near)),
        };
        let readings: Vec<_> =
            plan.inputs.iter().map(|input| Reading { value: reading(&input.name), healthy: true }).collect();
        machine.step(Inputs { readings: &readings, done }, 10_000_000, &mut Commands::default());
        plan.modes[machine.mode() as usize].name.clone()
    };
    let expected = [
        ("", "", "idle"),
        ("go_frwd", "", "forward"),
        ("read_sonar", "", "forward"),
        ("turn_left", "", "idle"),
        ("turn_left", "", "left"),
        ("get_position", "", "left"),
        ("turn_right", "", "idle"),
        ("turn_right", "", "right"),
        ("stop", "", "idle"),
        ("go_bkwd", "", "backward"),
        ("go_bkwd", "front_bumper", "backward"),
        ("go_bkwd", "back_bumper", "faulted"),
        ("read_sonar", "", "faulted"),
        ("go_frwd", "", "faulted"),
        ("reset", "", "idle"),
        ("drive", "", "backward"),
        ("drive", "sonar[0]", "backward"),
        ("drive", "sonar[11]", "idle"),
        ("drive", "sonar[11]", "idle"),
        ("go_bkwd", "sonar[11]", "backward"),
        ("stop", "", "idle"),
        ("go_frwd", "", "forward"),
        ("go_frwd", "front_bumper", "faulted"),
    ];
    for (tick, (command, bumper, state)) in expected.into_iter().enumerate() {
        assert_eq!(went(command, bumper, false), state, "tick {tick}: {command}");
    }
    assert_eq!(went("reset", "", false), "idle");
    assert_eq!(went("turn_left", "", false), "left");
    assert_eq!(went("turn_left", "", true), "idle", "what is completed");
}

/// An action that is another one is that also to the behavior that carries out commands.
#[test]
fn a_drive_may_call_actions_by_their_other_names() {
    let text = format!(
        "{} scenario s runs briefly on cart {{ duration 4 s  expect never speed > 1 cm/s after 3 s  expect speed > 15 cm/s }}",
        ROBOT
            .replace("action brake() = body.stop()", "action brake() = body.stop()  action rest() = brake()")
            .replace("{ brake() ", "{ rest() ")
            .replace("sensor near", "sensor speed: m/s in -1 .. 1  fails 0  = wheel.left.speed  sensor near")
            + "behavior briefly on cart {
                entry start
                mode start { go(0 m)  1: after 2 s -> finish }
                final mode finish { stop() }
            }"
    );
    let analysis = analyze_texts(&[("cart.msd", &text)]);
    assert!(!analysis.has_errors(), "{}", report(&analysis));
    let (_, scenario) = analysis.program.scenarios.iter().next().unwrap();
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    let run = run(&analysis.program, &plan, scenario, &RunOptions::default()).unwrap();
    assert!(run.verdicts.iter().all(|verdict| verdict.passed), "{:?}", run.verdicts);
}
