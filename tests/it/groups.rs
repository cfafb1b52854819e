//! Logical sensors: one reading from several, whoever of them has failed, and what the checker says of it.

use lmslc::base::Id;
use lmslc::interp::{Actuators, Inputs, Machine, Reading};
use lmslc::kernel::{
    largest_reading as largest, mean_reading as mean, median_reading as median, next_random,
    smallest_reading as smallest, widest_opening,
};
use lmslc::plan::{self, Plan};

use crate::support::{analyze_texts, report};

const FUSION: &str = "
    variable distance: m in 0 .. 10 fails 10 { close = ramp(4, 2)  far = ramp(2, 4) }
    network n(ahead: distance) { event blocked { contributor (close) detractor (far) } }
    ";

/// Four sensors that fail at 10, two contacts that fail set.
const ROBOT: &str = "import n
    robot ring {
        sensor range[4]: m in 0 .. 10 fails 10
        sensor bumper[2]: contact fails set
        logical least = min(range)
        logical most = max(range)
        logical average = mean(range)
        logical middle = median(range)
        logical middle_of_three = median(range[3, 0..1])
        logical either = any(bumper)
        logical both = all(bumper)
        action halt()
        action drive(speed: m/s)
    }
    ";

const READS_ALL: &str = "
    entry go
    mode go {
        halt()
        1: least > 1 m and most > 1 m and average > 1 m and middle > 1 m and middle_of_three > 1 m -> away
        2: either and both -> away
    }
    mode away { halt()  1: after 1 s -> go }
    ";

fn build(behavior: &str) -> Plan {
    let text = format!("{ROBOT}\nbehavior b on ring {{\n{behavior}\n}}");
    let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
    let checked = analysis.checked().unwrap_or_else(|| panic!("{}", report(&analysis)));
    plan::build(checked, Id::new(0), Id::new(0), &[])
}

#[derive(Default)]
struct Log(Vec<(u32, Vec<f64>)>);

impl Actuators for Log {
    fn command(&mut self, action: u32, arguments: &[f64], _start: bool) {
        self.0.push((action, arguments.to_vec()));
    }
}

fn readings(values: [f64; 6], failed: &[usize]) -> Vec<Reading> {
    let reading = |(place, value): (usize, f64)| Reading { value, healthy: !failed.contains(&place) };
    values.into_iter().enumerate().map(reading).collect()
}

/// What the logical sensors read, in the robot's order.
fn grouped(plan: &Plan, values: [f64; 6], failed: &[usize]) -> Vec<f64> {
    let mut machine = Machine::new(plan, 1);
    let readings = readings(values, failed);
    machine.step(Inputs { readings: &readings, done: false }, 0, &mut Log::default());
    plan.logical.iter().map(|of| machine.value(of.value)).collect()
}

#[test]
fn several_readings_are_one() {
    let plan = build(READS_ALL);
    let names: Vec<_> = plan.logical.iter().map(|logical| logical.name.as_str()).collect();
    assert_eq!(names, ["least", "most", "average", "middle", "middle_of_three", "either", "both"]);
    assert_eq!(grouped(&plan, [4.0, 1.0, 7.0, 2.0, 1.0, 0.0], &[]), [1.0, 7.0, 3.5, 3.0, 2.0, 1.0, 0.0]);
    assert_eq!(grouped(&plan, [2.0, 2.0, 2.0, 2.0, 1.0, 1.0], &[]), [2.0, 2.0, 2.0, 2.0, 2.0, 1.0, 1.0]);
}

#[test]
fn a_member_that_has_failed_reads_as_it_fails() {
    let plan = build(READS_ALL);
    assert_eq!(grouped(&plan, [4.0, 1.0, 7.0, 2.0, 0.0, 0.0], &[1]), [2.0, 10.0, 5.75, 5.5, 4.0, 0.0, 0.0]);
    assert_eq!(grouped(&plan, [4.0, 1.0, 7.0, 2.0, 0.0, 0.0], &[4]), [1.0, 7.0, 3.5, 3.0, 2.0, 1.0, 0.0]);
    let all = grouped(&plan, [4.0, 1.0, 7.0, 2.0, 0.0, 0.0], &[0, 1, 2, 3, 4, 5]);
    assert_eq!(all, [10.0, 10.0, 10.0, 10.0, 10.0, 1.0, 1.0]);
    // What is no number counts as failed; what is out of range is clamped.
    let odd = grouped(&plan, [f64::NAN, f64::INFINITY, -5.0, 25.0, 0.0, 0.0], &[]);
    assert_eq!(odd[..4], [0.0, 10.0, 7.5, 10.0]);
}

#[test]
fn kernels_group_what_they_are_given() {
    assert_eq!([smallest(&[3.0, -1.0, 2.0]), largest(&[3.0, -1.0, 2.0]), smallest(&[5.0])], [-1.0, 3.0, 5.0]);
    assert_eq!(
        [median(&[5.0]), median(&[9.0, 1.0]), median(&[3.0, 3.0, 1.0]), median(&[4.0, 1.0, 4.0, 2.0])],
        [5.0, 5.0, 3.0, 3.0]
    );
    assert_eq!([mean(&[1.0, 2.0, 6.0]), mean(&[-1.0, 1.0])], [3.0, 0.0]);
    // Rounding and overflow stay among the readings.
    assert_eq!(mean(&[0.1; 3]), 0.1);
    assert_eq!(mean(&[f64::MAX; 4]), f64::MAX);
    let mut state = 3;
    for _ in 0..2000 {
        let count = 1 + next_random(&mut state) % 9;
        let readings: Vec<f64> = (0..count).map(|_| (next_random(&mut state) % 7) as f64 - 3.0).collect();
        let mut sorted = readings.clone();
        sorted.sort_by(f64::total_cmp);
        let half = sorted.len() / 2;
        let middle = if sorted.len() % 2 == 1 { sorted[half] } else { f64::midpoint(sorted[half - 1], sorted[half]) };
        assert_eq!(median(&readings), middle, "{readings:?}");
        assert_eq!([smallest(&readings), largest(&readings)], [sorted[0], sorted[sorted.len() - 1]]);
        let sum: f64 = readings.iter().sum();
        assert!((mean(&readings) - sum / count as f64).abs() < 1e-12, "{readings:?}");
    }
}

/// The widest opening beyond 5 m, in degrees, of a fan of beams 30 degrees apart, or of a ring of 12.
fn opening(readings: &[f64], first: f64) -> f64 {
    let bearing = widest_opening(readings, 5.0, first.to_radians(), 30.0_f64.to_radians());
    (bearing.to_degrees() * 1e6).round() / 1e6
}

#[test]
fn the_widest_opening_is_where_most_neighbors_are_open() {
    let fan = |readings: [f64; 6]| opening(&readings, -75.0);
    assert_eq!(fan([9.0, 9.0, 1.0, 9.0, 1.0, 1.0]), -60.0);
    assert_eq!(fan([1.0, 9.0, 1.0, 5.0, 9.0, 4.9]), 30.0);
    // As wide, the nearer to straight ahead; as near, the first.
    assert_eq!(fan([9.0, 9.0, 1.0, 9.0, 9.0, 1.0]), 30.0);
    assert_eq!(fan([9.0, 9.0, 1.0, 1.0, 9.0, 9.0]), -60.0);
    // All of it, and where nothing is open what is farthest.
    assert_eq!([fan([9.0; 6]), fan([2.0, 3.0, 2.0, 4.0, 1.0, 1.0])], [0.0, 15.0]);
    // Around the back of a ring, whose ends are neighbors.
    let mut ring = [9.0; 12];
    assert_eq!(opening(&ring, 15.0), 0.0);
    ring[10] = 1.0;
    ring[1] = 1.0;
    assert_eq!(opening(&ring, 15.0).abs(), 180.0);
    ring[3] = 1.0;
    ring[7] = 1.0;
    assert_eq!(opening(&ring, 15.0), 165.0);
    assert_eq!(opening(&[], 0.0), 0.0);
}

#[test]
fn a_robot_knows_its_widest_opening_and_a_broken_beam_shuts_none() {
    let text = "robot ring {
            sensor range[12]: m in 0 .. 10 fails 10 = ring.range
            logical gate = widest(range[9..11, 0..2], beyond: 5 m)
            logical around = widest(range, beyond: 5 m)
            action halt()
        }
        behavior b on ring {
            entry go
            mode go { halt()  1: gate > 10 deg or around > 10 deg -> away }
            mode away { halt()  1: after 1 s -> go }
        }";
    let analysis = analyze_texts(&[("b.msd", text)]);
    let checked = analysis.checked().unwrap_or_else(|| panic!("{}", report(&analysis)));
    let plan = plan::build(checked, Id::new(0), Id::new(0), &[]);
    let bearings = |values: [f64; 12], failed: &[usize]| -> Vec<f64> {
        let mut machine = Machine::new(&plan, 1);
        let reading = |(place, value): (usize, f64)| Reading { value, healthy: !failed.contains(&place) };
        let readings: Vec<_> = values.into_iter().enumerate().map(reading).collect();
        machine.step(Inputs { readings: &readings, done: false }, 0, &mut Log::default());
        plan.logical.iter().map(|of| machine.value(of.value).to_degrees().round()).collect()
    };
    // Open at 15, 45 and 75 degrees ahead, and all around but for two.
    let mut values = [9.0; 12];
    (values[10], values[11]) = (1.0, 1.0);
    assert_eq!(bearings(values, &[]), [45.0, 150.0]);
    assert_eq!(bearings(values, &[11]), [30.0, 135.0], "a failed beam reads 10 m");
    assert_eq!(bearings([9.0; 12], &[]), [0.0, 0.0]);
}

#[test]
fn a_group_has_failed_once_one_of_its_sensors_has() {
    let plan = build(
        "entry go
         mode go { halt()  1: failed(least) -> away  2: failed(bumper) -> none }
         mode away requires middle_of_three else none { halt()  1: after 1 h -> go }
         mode none { halt()  1: not failed(range[0, 1]) and not failed(bumper) -> go }",
    );
    let mode_after = |failed: &[usize]| {
        let mut machine = Machine::new(&plan, 1);
        for _ in 0..2 {
            let readings = readings([5.0, 5.0, 5.0, 5.0, 0.0, 0.0], failed);
            machine.step(Inputs { readings: &readings, done: false }, 0, &mut Log::default());
        }
        plan.modes[machine.mode() as usize].name.as_str()
    };
    // The third is not among those that `away` requires.
    assert_eq!(
        [mode_after(&[]), mode_after(&[2]), mode_after(&[2, 3]), mode_after(&[5])],
        ["go", "away", "go", "none"]
    );
}

#[test]
fn a_sensor_of_a_group_takes_the_word_of_the_variable_that_the_group_feeds() {
    let robot = "import n
        robot ring { sensor range[2]: m in 0.5 .. 10  logical least = min(range)  action halt() }
        behavior b on ring { sense n(least)  entry go  mode go { halt()  1: blocked -> away }
            mode away { halt()  1: after 1 s -> go } }";
    let analysis = analyze_texts(&[("b.msd", robot), ("n.fsfn", FUSION)]);
    let plan = plan::build(analysis.checked().unwrap(), Id::new(0), Id::new(0), &[]);
    assert_eq!(plan.inputs.iter().map(|input| input.fail).collect::<Vec<_>>(), [10.0, 10.0]);
}

/// One that has failed at the far end takes nothing from a minimum; all of them leave nothing but the far end.
#[test]
fn what_the_checker_says_of_a_failed_group_is_what_happens() {
    let behavior = "
        sense n(least)
        entry go
        mode go {
            decide (ahead) {
                (close) => halt()
                (far)   => drive(1 m/s)
            }
            1: least is close and bumper[0] -> near
            2: least is far and bumper[0]   -> away
        }
        mode near { halt()  1: after 1 s -> go }
        mode away { halt()  1: after 1 s -> go }";
    let text = format!("{ROBOT}\nbehavior b on ring {{\n{behavior}\n}}");
    let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
    let plan = plan::build(analysis.checked().unwrap(), Id::new(0), Id::new(0), &[]);

    // The checker: which exits of `go` are taken when the group has failed.
    let facts = lmslc::analysis::modes::fault_table(&analysis.program, Id::new(0), 1);
    let least = analysis.program.robots[Id::new(0)].logical[0];
    let exits =
        |row: &lmslc::analysis::modes::Facts| row.modes[0].exits.iter().map(Option::is_some).collect::<Vec<_>>();
    let of_group: Vec<_> = facts.iter().filter(|row| row.faults.iter().any(|(sensor, _)| *sensor == least)).collect();
    assert_eq!(of_group.len(), 2, "reported, and stuck at the far end");
    for row in &of_group {
        assert_eq!(exits(row), [false, true], "{:?}", row.faults);
    }
    assert!(facts.iter().all(|row| {
        row.faults.iter().all(|(sensor, _)| !analysis.program.robots[Id::new(0)].sensors[..4].contains(sensor))
    }));

    // The machine: the rows that are chosen and the exits that are taken, over many readings.
    let seen = |failed: &[usize], reported: bool| {
        let (mut rows, mut modes) = ([false; 2], [false; 3]);
        let mut state = 5;
        for _ in 0..300 {
            let mut machine = Machine::new(&plan, 1);
            for _ in 0..2 {
                let mut values = [0.0; 6].map(|_: f64| (next_random(&mut state) % 11) as f64);
                values[4] = 1.0;
                for &place in failed {
                    values[place] = 10.0;
                }
                let readings = readings(values, if reported { failed } else { &[] });
                let mut log = Log::default();
                machine.step(Inputs { readings: &readings, done: false }, 0, &mut log);
                if machine.mode() == 0 {
                    rows[log.0[0].0 as usize] = true;
                }
                modes[machine.mode() as usize] = true;
            }
        }
        (rows, modes)
    };
    for reported in [false, true] {
        for member in 0..4 {
            assert_eq!(seen(&[member], reported), ([true, true], [true, true, true]), "{member} {reported}");
        }
        assert_eq!(seen(&[0, 1, 2, 3], reported), ([false, true], [true, false, true]), "{reported}");
    }
}
