//! Time and accuracy: what repeated reading trades, and how far robots go before they react, computed and driven.

use lmslc::analysis::timing::{Reaction, reactions};
use lmslc::driver::Analysis;
use lmslc::interp::{Actuators, Inputs, Machine, Reading};
use lmslc::ir::{Body, Placement};
use lmslc::kernel::Window;
use lmslc::plan;
use lmslc::sim::{Run, RunOptions, run};
use lmslc::trace::Signal;

use crate::support::{analyze_texts, clean, doubts, report};

#[test]
fn a_window_holds_the_last_readings_one_a_period() {
    let (mut window, mut kept) = (Window::default(), [0.0; 3]);
    let mut observe = |reading, usable, dt| window.observe(&mut kept, reading, usable, dt, 60);
    // From the first one on; a reading between two is none of them.
    let means = [(1.0, 0), (9.0, 59), (3.0, 1), (9.0, 30), (5.0, 30)].map(|(reading, dt)| observe(reading, true, dt));
    assert_eq!(means, [1.0, 1.0, 2.0, 2.0, 3.0]);
    // The oldest makes room. What comes late does not move those after it, and of periods that pass at once one counts.
    let means = [(7.0, 100), (7.0, 20), (11.0, 600)].map(|(reading, dt)| observe(reading, true, dt));
    assert_eq!(means, [5.0, 19.0 / 3.0, 25.0 / 3.0]);
    // A sensor that is known to have failed is read as it fails, at once, and the window begins anew after it.
    assert_eq!([observe(10.0, false, 5), observe(2.0, true, 1), observe(4.0, true, 60)], [10.0, 2.0, 3.0]);
}

/// A robot in front of a wall that reads the distance in several ways.
const EXACT: &str = "
    robot scout {
        body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6  tracking_noise 0 m/s^2 }
        sensor ahead: m in 10 cm .. 5 m  fails 5 m  = ring.range  accuracy 2.5 cm  period 60 ms
        logical exact = ahead within 1 cm
        logical soon  = ahead within 200 ms
        action stop()            = body.stop()
        action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
    }
    world facing_a_wall { wall (3 m, -4 m) -> (3 m, 4 m) }
    ";

fn values(run: &Run, signal: Signal) -> &[f64] {
    &run.trace.column(signal).unwrap().values
}

fn drive(analysis: &Analysis, scenario: usize, x: f64, seed: u64) -> Run {
    let checked = analysis.checked().unwrap_or_else(|| panic!("{}", report(analysis)));
    let mut scenario = analysis.program.scenarios.values().nth(scenario).unwrap().clone();
    let plan = plan::build_scenario(checked, &scenario);
    scenario.start = Placement::At { x, y: 0.0, heading: 0.0 };
    run(&analysis.program, &plan, &scenario, &RunOptions { seed: Some(seed), ..RunOptions::default() }).unwrap()
}

#[test]
fn repeated_reading_trades_time_for_tolerance() {
    let text = format!(
        "{EXACT}
        behavior look on scout {{
            entry go
            mode go {{ stop()  1: ahead < 20 cm or exact < 20 cm or soon < 20 cm -> near }}
            final mode near {{ stop() }}
        }}
        scenario resting runs look on scout in facing_a_wall {{ duration 60 s  tick 20 ms }}"
    );
    let analysis = clean("look.msd", &text);
    let counts: Vec<_> = analysis.program.sensors.values().filter_map(|sensor| sensor.group.as_ref()).collect();
    // (2.5 / 1)² is 6.25; three readings of 60 ms fit in 200 ms.
    assert_eq!(counts.iter().map(|group| group.readings[0]).collect::<Vec<_>>(), [7, 3]);
    let resting = drive(&analysis, 0, 1.0, 3);
    let spread = |signal| {
        let readings: Vec<f64> = values(&resting, signal)[100..].to_vec();
        // 1.75 m from the front of the robot to the wall.
        (readings.iter().map(|reading| (reading - 1.75).powi(2)).sum::<f64>() / readings.len() as f64).sqrt()
    };
    let [one, exact, soon] = [Signal::Reading(0), Signal::Logical(0), Signal::Logical(1)].map(spread);
    // Errors as likely up to 2.5 cm deviate by 2.5 / √3, and a mean of n by that over √n. A thousand readings tell a
    // deviation to about 3 in 100; means that overlap tell less.
    let expected = 0.025 / 3.0_f64.sqrt();
    assert!((one / expected - 1.0).abs() < 0.1, "{one}");
    assert!((exact / (expected / 7.0_f64.sqrt()) - 1.0).abs() < 0.3, "{exact}");
    assert!((soon / (expected / 3.0_f64.sqrt()) - 1.0).abs() < 0.2, "{soon}");
    // Most are within what was asked for: of a sum of seven such errors, 92 in 100.
    let inside = values(&resting, Signal::Logical(0)).iter().filter(|reading| (*reading - 1.75).abs() <= 0.01).count();
    let share = inside as f64 / values(&resting, Signal::Logical(0)).len() as f64;
    assert!(share > 0.85, "{share}");
}

#[derive(Default)]
struct Unheard;

impl Actuators for Unheard {
    fn command(&mut self, _action: u32, _arguments: &[f64], _start: bool) {}
}

#[test]
fn a_known_failure_is_read_at_once() {
    let text = format!(
        "{EXACT}
        behavior look on scout {{
            entry go
            mode go {{ stop()  1: exact < 1 m -> near }}
            final mode near {{ stop() }}
        }}"
    );
    let analysis = clean("look.msd", &text);
    let (diagram, robot) = (lmslc::base::Id::new(0), lmslc::base::Id::new(0));
    let plan = plan::build(analysis.checked().unwrap(), diagram, robot, &[]);
    let mut machine = Machine::new(&plan, 1);
    let mut read = |value, healthy| {
        machine.step(Inputs { readings: &[Reading { value, healthy }], done: false }, 60_000_000, &mut Unheard);
        machine.value(plan.logical[0].value)
    };
    assert_eq!([read(2.0, true), read(3.0, true), read(2.0, false)], [2.0, 2.5, 5.0]);
    // What is no number counts as failed, what is out of range is clamped.
    assert_eq!([read(4.0, true), read(9.0, true), read(f64::NAN, true), read(2.0, true)], [4.0, 4.5, 5.0, 2.0]);
}

/// How far a robot has come, since it passed the place where a condition begins, when it is told otherwise, and when it
/// stands: at most, over many places to start from.
fn furthest(analysis: &Analysis, scenario: usize, begins: f64, half: f64, seeds: u64) -> (f64, f64) {
    let (mut late, mut gone) = (f64::MIN, f64::MIN);
    for start in 0..20 {
        for seed in 0..seeds {
            let run = drive(analysis, scenario, f64::from(start) * 0.0043, seed);
            let change = run.trace.changes.iter().find(|change| change.time > 1_000_000_000).unwrap();
            let place = values(&run, Signal::X(0));
            let at = run.trace.times.iter().position(|time| *time == change.time).unwrap();
            late = late.max(place[at] + half + begins - 3.0);
            let stands = run.trace.times.iter().position(|time| *time >= change.time + 1_000_000_000);
            gone = gone.max(place[stands.unwrap_or(place.len() - 1)] + half + begins - 3.0);
        }
    }
    (late, gone)
}

fn only(analysis: &Analysis, diagram: usize) -> Reaction {
    let found = reactions(&analysis.program, lmslc::base::Id::new(diagram as u32));
    assert_eq!(found.len(), 1, "{found:?}");
    found[0].clone()
}

#[test]
fn what_is_computed_is_what_is_driven() {
    // A reading, a mean of seven, a mean of three, and a condition that waits.
    for (condition, accuracy) in [("ahead", 0), ("exact", 25), ("soon", 0), ("held", 0)] {
        let text = EXACT.replace("accuracy 2.5 cm", &format!("accuracy {} mm", accuracy.max(1)));
        let text = if accuracy == 0 { text.replace("logical exact = ahead within 1 cm\n", "") } else { text };
        let condition = match condition {
            "held" => "held(ahead < 1 m, 130 ms)".to_owned(),
            sensor => format!("{sensor} < 1 m"),
        };
        let text = format!(
            "{text}
            behavior go on scout {{
                entry onward
                mode onward {{ drive(0.4 m/s)  1: {condition} -> near }}
                final mode near {{ stop() }}
            }}
            scenario at_a_wall runs go on scout in facing_a_wall {{ duration 8 s  tick 20 ms }}"
        );
        let analysis = analyze_texts(&[("go.msd", &text)]);
        assert!(doubts(&analysis).is_empty(), "{}", report(&analysis));
        let reaction = only(&analysis, 0);
        let (late, gone) = furthest(&analysis, 0, reaction.begins, 0.25, 2);
        // Steps of 4.3 mm and a tick of 8 mm leave some of it out, and errors are seldom all on one side.
        let slack = 0.012 + 2.0 * reaction.accuracy;
        assert!(late <= reaction.late + 1e-6 && late > reaction.late - slack, "{condition}: {late} {reaction:?}");
        // The lag coasts on for ever; after a second all but a thousandth is done.
        let whole = reaction.late + reaction.stop;
        assert!(gone <= whole + 1e-3 && gone > whole - slack - 5e-3, "{condition}: {gone} {reaction:?}");
    }
}

#[test]
fn labmate_stands_before_a_wall() {
    let text = "
        import std.behaviors.collision_avoidance
        import std.behaviors.simple_navigation
        import std.robots.labmate
        world facing_a_wall { wall (3 m, -4 m) -> (3 m, 4 m) }
        arbiter wandering on labmate {
            client avoid  = collision_avoidance priority 1
            client wander = simple_navigation   priority 9
        }
        scenario at_a_wall runs wandering on labmate in facing_a_wall { duration 10 s  tick 20 ms }";
    let mut analysis = clean("go.msd", text);
    for robot in analysis.program.robots.iter().map(|(id, _)| id).collect::<Vec<_>>() {
        let Some(Body::DifferentialDrive(body)) = &mut analysis.program.robots[robot].body else { continue };
        body.tracking_noise = 0.0;
    }
    let arbiter = analysis.program.diagrams.iter().find(|(_, diagram)| diagram.arbiter.is_some()).unwrap().0;
    let forward = reactions(&analysis.program, arbiter).into_iter().find(|reaction| reaction.speed > 0.0).unwrap();
    assert_eq!((forward.speed, forward.begins, forward.wait), (0.3, 0.45, 60_000_000));
    // 2.5 cm, 60 ms at 0.3 m/s; then 1 m/s² down to a stand, if it were told to go backward.
    assert!((forward.late - 0.043).abs() < 1e-12, "{forward:?}");
    assert!((forward.stop - 0.045).abs() < 1e-12, "{forward:?}");
    let told = "at 0.3 m/s it may go 0.043 m before it is told otherwise, as `front` tells up to 60 ms late, and is off by \
                0.025 m; then it takes 0.045 m at least to stand";
    assert_eq!(forward.told(&analysis.program), told);
    let (late, gone) = furthest(&analysis, 0, forward.begins, 0.405, 2);
    assert!(late <= forward.late + 1e-6 && late > forward.late - 0.025, "{late}");
    // It turns away: the lag of 0.15 s takes it 1.1 cm farther.
    assert!(gone > late + forward.stop && gone <= forward.late + forward.stop + 0.15 * 0.15 / 2.0 + 1e-3, "{gone}");
}

#[test]
fn a_robot_that_is_warned_of_arrives() {
    let page = std::fs::read_to_string(crate::support::root().join("docs/errors/LM0701.md")).unwrap();
    let example = page.split("```msd").nth(1).unwrap().split("```").next().unwrap();
    let text = format!(
        "{example}
        world facing_a_wall {{ wall (3 m, -4 m) -> (3 m, 4 m) }}
        scenario at_a_wall runs run on runner in facing_a_wall {{ duration 4 s  tick 10 ms }}"
    );
    let analysis = analyze_texts(&[("run.msd", &text)]);
    let codes: Vec<_> = doubts(&analysis).into_iter().map(|finding| finding.rule.code).collect();
    assert_eq!(codes, ["LM0701"], "{}", report(&analysis));
    let ends = (0..20).map(|start| {
        let run = drive(&analysis, 0, f64::from(start) * 0.01, 1);
        values(&run, Signal::X(0)).iter().copied().fold(f64::MIN, f64::max)
    });
    // At the wall, with half a length of 0.25 m, or less than a tick of 15 mm before it, from which it comes back.
    let ends: Vec<f64> = ends.collect();
    assert!(ends.iter().any(|end| *end > 2.735), "{ends:?}");
}
