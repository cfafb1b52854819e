//! What a diagram can do under faults: each "can" is replayed by the interpreter, each "never" is known beforehand.

use lmslc::analysis::modes::{Facts, Fault, Step, Way, fault_table};
use lmslc::base::{Exact, Id};
use lmslc::driver::Analysis;
use lmslc::interp::{Actuators, Inputs, Machine, Reading, Taken};
use lmslc::ir;
use lmslc::plan::{self, Plan};

use crate::support::analyze_texts;

struct Deaf;

impl Actuators for Deaf {
    fn command(&mut self, _action: u32, _arguments: &[f64], _start: bool) {}
}

/// A diagram of the standard library, and its facts for at most so many faults.
fn library(name: &str, up_to: usize) -> (Analysis, Id<ir::Diagram>, Vec<Facts>) {
    let analysis = analyze_texts(&[("main.msd", &format!("import std.behaviors.{name}\n"))]);
    named(analysis, name, up_to)
}

fn named(analysis: Analysis, name: &str, up_to: usize) -> (Analysis, Id<ir::Diagram>, Vec<Facts>) {
    let diagrams = &analysis.program.diagrams;
    let diagram = diagrams.ids().find(|id| diagrams[*id].symbol.name == name).unwrap();
    let table = fault_table(&analysis.program, diagram, up_to);
    (analysis, diagram, table)
}

/// The names of modes.
fn names(analysis: &Analysis, diagram: Id<ir::Diagram>, which: impl Fn(usize) -> bool) -> Vec<&str> {
    let modes = analysis.program.diagrams[diagram].modes.iter();
    modes.filter(|(id, _)| which(id.index())).map(|(_, mode)| mode.symbol.name.as_str()).collect()
}

/// Tells the machine what the steps say, and answers what it did on the last one.
fn replay(analysis: &Analysis, plan: &Plan, steps: &[Step]) -> Taken {
    let sensors: Vec<_> = analysis.program.robots[Id::new(0)].sensors.clone();
    let mut machine = Machine::new(plan, 0);
    let healthy: Vec<_> = sensors.iter().map(|_| Reading { value: 0.0, healthy: true }).collect();
    let mut taken = machine.step(Inputs { readings: &healthy, done: false }, 0, &mut Deaf);
    for step in steps {
        assert_eq!(machine.mode() as usize, step.mode.index(), "{steps:?}");
        let reading = |sensor: &Id<ir::Sensor>| {
            let known = step.moment.readings.iter().find(|(read, _)| read == sensor);
            let fault = step.faults.iter().find(|(failed, _)| failed == sensor).map(|(_, fault)| *fault);
            let stuck = match fault {
                Some(Fault::Stuck(at)) => Some(at),
                Some(Fault::Between(low, high)) => low.between(high),
                Some(Fault::Reported | Fault::Absent) | None => None,
            };
            let value = known.map(|(_, at)| *at).or(stuck).map_or(0.0, Exact::to_f64);
            Reading { value, healthy: fault != Some(Fault::Reported) }
        };
        let readings: Vec<_> = sensors.iter().map(reading).collect();
        let dt = step.moment.dwell - machine.dwell();
        taken = machine.step(Inputs { readings: &readings, done: step.moment.done }, dt, &mut Deaf);
    }
    taken
}

/// Replays every transition that is shown, and answers how many there were.
pub fn replay_all(analysis: &Analysis, diagram: Id<ir::Diagram>, table: &[Facts]) -> usize {
    let plan = plan::build(analysis.checked().unwrap(), diagram, Id::new(0), &[]);
    let mut count = 0;
    for facts in table {
        for (id, mode) in analysis.program.diagrams[diagram].modes.ids().zip(&facts.modes) {
            let Some(trace) = &mode.trace else { continue };
            for (index, exit) in mode.exits.iter().enumerate() {
                let Some(Way::Shown(moments)) = exit else { continue };
                let step = |moment: &lmslc::analysis::modes::Moment| Step {
                    mode: id,
                    faults: facts.faults.clone(),
                    moment: moment.clone(),
                };
                let steps: Vec<_> = trace.iter().cloned().chain(moments.iter().map(step)).collect();
                let transition = plan.modes[id.index()].transitions.start + index as u32;
                assert_eq!(replay(analysis, &plan, &steps), Taken::Transition(transition), "{:?}", facts.faults);
                count += 1;
            }
        }
    }
    count
}

#[test]
fn every_transition_that_is_shown_is_taken_by_the_machine() {
    let on_j5 = "import std.behaviors.obstacle_avoidance
import std.robots.j5
behavior avoidance on j5 extends obstacle_avoidance {}";
    let avoidance = named(analyze_texts(&[("main.msd", on_j5)]), "avoidance", 3);
    for (analysis, diagram, table) in [avoidance, library("obstacle_manipulation", 3)] {
        let healthy = &table[0];
        assert!(healthy.modes.iter().all(|mode| mode.trace.is_some()), "every mode has a trace");
        assert!(replay_all(&analysis, diagram, &table) > 40);
    }
}

#[test]
fn obstacle_manipulation_loses_what_the_paper_says() {
    let (analysis, diagram, table) = library("obstacle_manipulation", 3);
    let row = |faults: &[(&str, Fault)]| {
        let is_of = |facts: &&Facts| {
            facts.faults.len() == faults.len()
                && facts.faults.iter().all(|(sensor, fault)| {
                    faults.contains(&(analysis.program.sensors[*sensor].symbol.name.as_str(), *fault))
                })
        };
        table.iter().find(is_of).unwrap()
    };
    let unreachable = |facts: &Facts| names(&analysis, diagram, |index| !facts.modes[index].reachable);
    let zero = Fault::Stuck(Exact::ZERO);
    assert_eq!(unreachable(row(&[])), [""; 0]);
    // A force of 0 finds collisions still, and no heavy obstacle (eq. 10); the fault may come late, so all is reached.
    let force = row(&[("contact_force", zero)]);
    let forward = names(&analysis, diagram, |_| true).iter().position(|name| *name == "forward").unwrap();
    assert_eq!(force.modes[forward].exits.iter().map(Option::is_some).collect::<Vec<_>>(), [false, true, false]);
    let reported = row(&[("contact_force", Fault::Reported)]);
    assert_eq!(reported.modes[forward].exits.iter().map(Option::is_some).collect::<Vec<_>>(), [false, false, true]);
    assert_eq!(names(&analysis, diagram, |index| reported.modes[index].inhibited), ["push"]);
    // All three at 0 leave no evidence of a collision at all: the robot drives ahead for ever.
    let all = row(&[("contact_force", zero), ("left_wheel_acceleration", zero), ("right_wheel_acceleration", zero)]);
    let traps: Vec<_> =
        all.traps.iter().map(|trap| names(&analysis, diagram, |index| trap.contains(&Id::new(index as u32)))).collect();
    assert_eq!(traps, [["forward"]]);
    assert!(reported.traps.is_empty());
}

const CART: &str = "
    robot cart {
        sensor x: 1 in 0 .. 10 fails any
        sensor y: 1 in 0 .. 10 fails 3, absent
        action halt()
    }
    behavior b on cart {
        entry a
        mode a { halt()  1: x > 5 -> c  2: x <= 5 and y > 2 -> d  3: after 10 s -> again }
        mode c { halt()  1: x < 3 -> a  2: after 2 s and y > 9 -> d }
        mode d { halt()  1: after 1 s and x < 3 -> a }
    }";

#[test]
fn a_sensor_stuck_at_an_unknown_reading_keeps_it() {
    let (analysis, diagram, table) = named(analyze_texts(&[("b.msd", CART)]), "b", 1);
    assert!(replay_all(&analysis, diagram, &table) > 20);
    let three_to_five = Fault::Between(Exact::new(3, 1, 0), Exact::new(5, 1, 0));
    let stuck = table.iter().find(|facts| facts.faults.iter().any(|(_, fault)| *fault == three_to_five)).unwrap();
    assert_eq!(stuck.modes.iter().map(|mode| mode.reachable).collect::<Vec<_>>(), [true; 3], "it may strike late");
    let exits: Vec<Vec<bool>> =
        stuck.modes.iter().map(|mode| mode.exits.iter().map(Option::is_some).collect()).collect();
    assert_eq!(exits, [vec![false, true, true], vec![false, true], vec![false]]);
    assert_eq!(stuck.traps.len(), 1, "`d` is not left while `x` stands between 3 and 5");
}

#[test]
fn a_failed_sensor_stays_so() {
    let text = "
        robot cart {
            sensor x: 1 in 0 .. 10 fails 3
            optional sensor y: 1 in 0 .. 10 fails 7
            action halt()
        }
        behavior b on cart {
            entry end
            mode a requires y else lost { halt()  1: x > 5 -> late }
            mode lost { halt()  1: y >= 5 and not after 1 s -> late  2: after 1 s -> late }
            mode late { halt()  1: after 1 s and y >= 5 -> end  2: y >= 5 -> end }
            mode end { halt()  1: after 1 s -> a }
        }";
    let (_, _, table) = named(analyze_texts(&[("b.msd", text)]), "b", 1);
    let reported = table.iter().find(|facts| facts.faults == [(Id::new(1), Fault::Reported)]).unwrap();
    let live = |mode: usize| reported.modes[mode].exits.iter().map(Option::is_some).collect::<Vec<_>>();
    assert_eq!(live(1), [true, false], "`lost` is entered with `y` failed, which reads 7 from then on");
    assert_eq!(live(2), [true, true], "`y` may read less for a second, and then fail");
}
