//! What failed sensors do to a program, in the words of the fault table and of the checker.

use lmslc::analysis::fault_table;
use lmslc::driver::{Analysis, Files, Options, analyze};

use crate::support::{Memory, Repository, analyze_path, analyze_texts, doubts, report};

/// The sentences of a program's fault table.
fn sentences(analysis: &Analysis, up_to: usize) -> Vec<String> {
    assert!(!analysis.has_errors(), "{}", report(analysis));
    fault_table(&analysis.program, &analysis.roots, up_to).summary
}

/// The sentences of networks over three sensors of two kinds.
fn of_networks(networks: &str, up_to: usize) -> Vec<String> {
    let text = format!(
        "variable distance: m in 0 .. 5 fails 5 {{ near = ramp(1, 0.5)  far = ramp(0.5, 1) }}
         variable touch: 1 in 0 .. 1 fails 0, 1 {{ no = ramp(0.6, 0.4)  yes = ramp(0.4, 0.6) }}
         {networks}"
    );
    sentences(&analyze_texts(&[("n.fsfn", &text)]), up_to)
}

#[test]
fn what_the_paper_says_of_obstacle_id() {
    let analysis = analyze_path("stdlib/behaviors/obstacle_manipulation.msd");
    assert_eq!(
        sentences(&analysis, 3),
        [
            "`heavy_obstacle` depends on `contact_force` alone and implies `forward_collision`.",
            "With `contact_force` failed at 0 N, `forward_collision` is found by `left_wheel_acceleration` and \
             `right_wheel_acceleration` alone; `heavy_obstacle` can never be set; `obstacle_manipulation` never leaves \
             `forward` and `push`, leaves `push` only when a timer ends, and never gets to `stop` if it starts so.",
            "With `left_wheel_acceleration` and `right_wheel_acceleration` failed at 0 m/s^2, `forward_collision` is \
             found by `contact_force` alone.",
            "With `contact_force` failed at 0 N, and `left_wheel_acceleration` or `right_wheel_acceleration` failed at \
             0 m/s^2, `forward_collision` can never be set; `obstacle_manipulation` never leaves `forward`, and never \
             gets to `push` if it starts so.",
        ]
    );
}

#[test]
fn an_event_found_by_either_of_two_sensors() {
    let either = "network n(a: distance, b: distance) {
        event close { contributor (near, _) (_, near) detractor (far, far) }
    }";
    assert_eq!(
        of_networks(either, 2),
        [
            "With `a` failed at 5 m, `close` is found by `b` alone.",
            "With `b` failed at 5 m, `close` is found by `a` alone.",
            "With `a` and `b` failed at 5 m, `close` can never be set.",
        ]
    );
}

#[test]
fn an_event_that_needs_both_of_two_sensors() {
    let both = "network n(a: distance, b: distance) {
        event close { contributor (near, near) detractor (far, _) (_, far) }
    }";
    // Of larger sets nothing is said that smaller ones do already.
    assert_eq!(of_networks(both, 2), ["With `a` or `b` failed at 5 m, `close` can never be set."]);
}

#[test]
fn an_event_that_a_failure_sets() {
    let touched = "network n(a: distance, b: touch) {
        event blocked { contributor (near, -) (-, yes) detractor (far, no) }
        event free    { contributor (far, no) detractor (near, -) (-, yes) }
    }";
    assert_eq!(
        of_networks(touched, 1),
        [
            "`blocked` is never set together with `free`.",
            "With `a` failed at 5 m, `blocked` is found by `b` alone; `free` is found by `b` alone.",
            "With `b` failed at 0, `blocked` is found by `a` alone; `free` is found by `a` alone.",
            "With `b` failed at 1, `blocked` is always set; `free` can never be set.",
        ]
    );
}

#[test]
fn a_sensor_that_an_event_names_for_nothing() {
    let named = "network n(a: distance, b: distance) {
        event close { contributor (near, _) detractor (far, _) }
        event also  { contributor (near, -) detractor (far, -) }
    }";
    let said = of_networks(named, 1);
    assert_eq!(said[0], "`close` depends on `a` alone and implies `also`.");
    assert_eq!(said[1], "`also` implies `close`.");
    assert_eq!(said[2], "With `a` failed at 5 m, `close` can never be set; `also` can never be set.");
    assert_eq!(said.len(), 3);
}

const CART: &str = "
    robot cart {
        sensor front: m in 0 .. 5 fails 5, any
        sensor rear:  m in 0 .. 5 fails 0
        action halt()
        action drive(speed: m/s)
    }
    behavior shuttle on cart {
        entry ahead
        mode ahead { drive(1 m/s)   1: front < 1 m -> back  2: failed(front) -> limp }
        mode back  { drive(-1 m/s)  1: after 1 s and rear < 1 m -> ahead  2: after 9 s -> ahead }
        mode limp  { drive(0.1 m/s) 1: not failed(front) -> ahead }
    }";

/// Sensors that only conditions compare fail too, and stuck anywhere is told for the readings that matter.
#[test]
fn sensors_that_no_network_is_fed_with() {
    let analysis = analyze_texts(&[("cart.msd", CART)]);
    assert_eq!(
        sentences(&analysis, 1),
        ["With `front` stuck between 1 m and 5 m, `shuttle` never leaves `ahead`, and never gets to `back` if it \
             starts so."]
    );
    let rows = fault_table(&analysis.program, &analysis.roots, 1).rows;
    let failed: Vec<Vec<_>> =
        rows.iter().map(|row| row.failed.iter().map(|one| one.sensor.as_str()).collect()).collect();
    assert_eq!(failed, [vec![], vec!["front"], vec!["front"], vec!["rear"]]);
}

/// A row is about a failure that is known, and about one that is not.
#[test]
fn a_mode_for_a_failure_is_reached_with_it_alone() {
    let analysis = analyze_texts(&[("cart.msd", CART)]);
    let rows = fault_table(&analysis.program, &analysis.roots, 1).rows;
    let unreachable: Vec<_> = rows.iter().map(|row| row.modes[0].unreachable.join(" ")).collect();
    assert_eq!(unreachable, ["limp", "", "", "limp"]);
}

/// What the checker doubts with at most so many failed sensors.
fn doubtful(files: &dyn Files, path: &str, faults: usize) -> Vec<(&'static str, String)> {
    let options = Options { faults, ..Options::default() };
    let analysis = analyze(files, &[path.to_owned()], &options);
    doubts(&analysis).iter().map(|finding| (finding.rule.name, finding.message.clone())).collect()
}

#[test]
fn more_failed_sensors_are_looked_at_when_asked() {
    let text = Repository.read("stdlib/behaviors/obstacle_avoidance.msd").unwrap();
    let text = text.replace("std.interfaces.alert_base", "std.robots.j5").replace("alert_base", "j5");
    let files = Memory::new(&[("avoidance.msd", &text)]);
    let doubtful = |faults| doubtful(&files, "avoidance.msd", faults);
    assert_eq!(doubtful(1), []);
    let caught = "the machine can never leave `forward` with `contact_force` failed at 0 N, and \
        `left_wheel_acceleration` or `right_wheel_acceleration` failed at 0 m/s^2";
    let found = doubtful(2);
    assert!(found.contains(&("trapped-by-failure", caught.to_owned())), "{found:?}");
    // Larger sets say nothing that smaller ones do not.
    assert_eq!(doubtful(3), found);
}

/// A comment that explains a finding about failures is no idle one where failures are not looked at.
#[test]
fn nothing_is_said_of_failures_when_none_is_asked_for() {
    assert_eq!(doubtful(&Repository, "stdlib/behaviors/obstacle_manipulation.msd", 0), []);
}
