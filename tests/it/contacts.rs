//! Contacts that follow from a robot's own conditions: what is written on the robot sees through them, what is written on
//! an interface runs on what they read.

use lmslc::driver::Analysis;
use lmslc::interp::{Actuators, Inputs, Machine, Reading};
use lmslc::kernel::next_random;
use lmslc::plan::{self, Plan};

use crate::support::{analyze_texts, report};

const ROBOT: &str = "
import std.networks.obstacle_id

interface moving {
    action halt()
    action go(speed: m/s)
}
interface feeling extends moving {
    sensor blocked: contact fails clear
}

robot pusher provides feeling {
    sensor left: m/s^2 in -4 .. 4 fails 0
    sensor right: m/s^2 in -4 .. 4 fails 0
    sensor force: N in 0 .. 400 fails 0
    sensor bumper[2]: contact fails set
    sensor front: m in 0 .. 3 fails 3
    sense obstacle_id(left, right, force)
    logical touched = any(bumper)
    logical blocked = forward_collision or touched and not front > 0.5 m or failed(front)
    logical heavy = heavy_obstacle
    action halt()
    action go(speed: m/s)
}
";

/// What `blocked` stands for.
const CONDITION: &str = "(forward_collision or touched and not front > 0.5 m or failed(front))";

const MODES: &str = "
    entry roll

    mode roll {
        go(0.2 m/s)
        1: blocked -> rest
    }
    mode rest {
        halt()
        1: not blocked -> roll
    }
    ";

fn analyze(behavior: &str) -> Analysis {
    analyze_texts(&[("b.msd", &format!("{ROBOT}{behavior}"))])
}

fn plan(analysis: &Analysis) -> Plan {
    let checked = analysis.checked().unwrap_or_else(|| panic!("{}", report(analysis)));
    let (diagrams, robots) = (analysis.program.diagrams.ids(), analysis.program.robots.ids());
    let (diagram, robot) = (diagrams.last().unwrap(), robots.last().unwrap());
    plan::build(checked, diagram, robot, &[])
}

struct Idle;

impl Actuators for Idle {
    fn command(&mut self, _action: u32, _arguments: &[f64], _start: bool) {}
}

/// The mode after each of many ticks with readings by chance, of sensors that fail and heal by chance.
fn modes(plan: &Plan) -> Vec<u32> {
    let (mut machine, mut state) = (Machine::new(plan, 1), 7);
    let mut chance = |of: u64| next_random(&mut state) % of;
    let mut tick = || {
        let readings: Vec<_> = plan
            .inputs
            .iter()
            .map(|input| {
                let value = input.low + (input.high - input.low) * chance(5) as f64 / 4.0;
                Reading { value, healthy: chance(8) > 0 }
            })
            .collect();
        machine.step(Inputs { readings: &readings, done: false }, 10_000_000, &mut Idle);
        machine.mode()
    };
    (0..2000).map(|_| tick()).collect()
}

#[test]
fn on_an_interface_a_contact_reads_what_its_condition_says() {
    let on_interface = plan(&analyze(&format!("behavior b on feeling {{{MODES}}}")));
    let on_robot = plan(&analyze(&format!("behavior b on pusher {{{MODES}}}")));
    let sense = "sense obstacle_id(left, right, force)";
    let spelled = MODES.replace("blocked", CONDITION);
    let spelled = plan(&analyze(&format!("behavior b on pusher {{{sense} {spelled}}}")));
    let modes = [modes(&on_interface), modes(&on_robot), modes(&spelled)];
    assert!(modes[0] == modes[2] && modes[1] == modes[2]);
    for mode in [0, 1] {
        assert!(modes[0].iter().filter(|known| **known == mode).count() > 200, "{mode} is hardly ever entered");
    }
}

#[test]
fn a_contact_is_recorded_where_it_is_asked_for() {
    let names = |plan: &Plan| -> Vec<String> { plan.logical.iter().map(|logical| logical.name.clone()).collect() };
    let asking = plan(&analyze(&format!("behavior b on feeling {{{MODES}}}")));
    assert_eq!(names(&asking), ["touched", "blocked"]);
    assert_eq!(asking.events[0].name, "obstacle_id.forward_collision");
    let other = "behavior b on feeling { entry roll mode roll { go(0.2 m/s) 1: after 1 s -> again } }";
    let other = plan(&analyze(other));
    assert_eq!((names(&other), other.events.len()), (vec!["touched".to_owned()], 0));
}

#[test]
fn what_is_written_on_the_robot_sees_through_its_contacts() {
    let findings = |text: &str| -> Vec<(&str, String)> {
        let analysis = analyze(text);
        let of_modes = |finding: &&lmslc::diag::Diagnostic| finding.rule.code.starts_with("LM06");
        analysis.findings.iter().filter(of_modes).map(|of| (of.rule.code, of.message.clone())).collect()
    };
    let modes = "
        entry roll
        mode roll { go(0.2 m/s) 1: blocked and heavy -> rest }
        mode rest { halt() 1: after 1 s -> roll }";
    let named = findings(&format!("behavior b on pusher {{{modes}}}"));
    let sense = "sense obstacle_id(left, right, force)";
    let spelled = modes.replace("blocked", CONDITION).replace("heavy", "heavy_obstacle");
    let spelled = findings(&format!("behavior b on pusher {{{sense} {spelled}}}"));
    assert_eq!(named, spelled);
    // A force stuck at 0 N closes the way out of `roll`.
    assert!(named.iter().any(|(_, message)| message.contains("`roll`") && message.contains("force")), "{named:?}");
}

#[test]
fn a_contact_has_failed_once_a_sensor_it_looks_at_has() {
    let looks = "behavior b on feeling {
        entry roll
        mode roll { go(0.2 m/s) 1: failed(blocked) -> rest }
        mode rest requires blocked { halt() 1: not failed(blocked) -> roll }
    }";
    let plan = plan(&analyze(looks));
    let blocked = &plan.logical[1];
    let looked_at: Vec<_> = blocked.of.iter().map(|&input| plan.inputs[input as usize].name.as_str()).collect();
    assert_eq!(looked_at, ["left", "right", "force", "bumper[0]", "bumper[1]", "front"]);
    assert_eq!(plan.required, blocked.of);
}

#[test]
fn properties_and_expectations_name_contacts_that_the_behavior_does_not() {
    let analysis = analyze(
        "behavior b on pusher { entry roll mode roll { go(0.2 m/s) 1: touched -> rest } mode rest { halt() 1: not touched -> roll } }
         property p: always blocked or front > 0.5 m or not touched",
    );
    assert!(analysis.checked().is_some(), "{}", report(&analysis));
    assert_eq!(analysis.proved, 1, "{}", report(&analysis));
}
