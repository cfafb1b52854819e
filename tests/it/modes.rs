//! What modes can and cannot do: each defect is found, by its code and at its place, and nothing else is.

use lmslc::diag::Diagnostic;

use crate::support::{analyze_texts, doubts, report};

const ROBOT: &str = "
    robot cart {
        sensor x: 1 in 0 .. 10 fails 3
        optional sensor y: 1 in 0 .. 10 fails 3
        action halt()
        action turn(angle: rad) -> done
    }
    ";

const FUSION: &str = "
    variable level: 1 in 0 .. 20 {
        low = ramp(6, 4)  mid = triangle(4, 5, 6)  high = trapezoid(4, 6, 12, 14)  over = ramp(12, 14)
    }
    network n(v: level) {
        event full  { contributor (high) detractor ({low, mid}) }
        event empty { contributor (low) detractor ({mid, high}) }
        event stuck { contributor (over) detractor (high) }
    }
    network both(v: level, w: level) {
        event some { contributor (high, _) (_, high) detractor (low, low) }
        event all  { contributor (high, high) detractor (low, _) (_, low) }
    }
    ";

/// The codes of findings about modes in a behavior on the cart, with the text at the primary place.
fn found(behavior: &str) -> Vec<(&'static str, String)> {
    let text = format!("import n\n{ROBOT}\nbehavior b on cart {{\n sense n(x)\n sense both(x, y)\n{behavior}\n}}");
    let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
    assert!(!analysis.has_errors(), "{}", report(&analysis));
    let at = |finding: &Diagnostic| analysis.sources.slice(finding.span()).to_owned();
    // Both networks are sensed whether a test needs them or not, and what failures do has tests of its own.
    let is_told = |finding: &&Diagnostic| finding.rule.name != "unused-sense" && !finding.rule.is_about_faults();
    let told = doubts(&analysis).into_iter().filter(is_told);
    told.map(|finding| (finding.rule.code, at(finding))).collect()
}

#[track_caller]
fn finds(behavior: &str, expected: &[(&str, &str)]) {
    let found = found(behavior);
    let found: Vec<_> = found.iter().map(|(code, text)| (*code, text.as_str())).collect();
    assert_eq!(found, expected);
}

#[test]
fn a_mode_with_no_way_out_and_one_with_no_way_in() {
    finds(
        "entry a  mode a { halt() 1: x > 5 -> b }  mode b { halt() }  mode c { halt() 1: x > 5 -> a }",
        &[("LM0406", "b"), ("LM0404", "c")],
    );
    finds("entry a  mode a { halt() 1: x > 3 -> b }  mode b { halt() 1: after 1 s -> again }", &[("LM0415", "b")]);
    finds("entry a  mode a { halt() 1: after 1 s -> again }", &[]);
}

#[test]
fn a_condition_that_always_holds_hides_what_is_below() {
    finds(
        "entry a
         mode a { halt()  1: x >= 5 or x < 5 -> b  2: y > 5 -> c }
         mode b { halt()  1: x > 5 -> c }
         mode c { halt()  1: after 1 s -> a }",
        &[("LM0410", "x >= 5 or x < 5")],
    );
}

#[test]
fn a_guard_that_a_higher_one_implies_masks_it() {
    finds(
        "entry a
         mode a { halt()  1: x > 2 -> b  2: x > 3 -> c }
         mode b { halt()  1: x < 1 -> c }
         mode c { halt()  1: after 1 s -> a }",
        &[("LM0402", "2: x > 3 -> c")],
    );
    finds(
        "entry a
         mode a { halt()  1: x < 4 -> b  2: x > 2 -> c  3: y > 3 -> b }
         mode b { halt()  1: after 1 s -> a }
         mode c { halt()  1: after 1 s -> a }",
        &[("LM0402", "3: y > 3 -> b")],
    );
}

#[test]
fn events_that_imply_each_other_mask_each_other() {
    finds(
        "entry a
         mode a { halt()  1: some -> b  2: all -> c }
         mode b { halt()  1: after 1 s -> c }
         mode c { halt()  1: after 1 s -> a }",
        &[("LM0402", "2: all -> c")],
    );
    finds(
        "entry a
         mode a { halt()  1: all -> c  2: some -> b }
         mode b { halt()  1: after 1 s -> c }
         mode c { halt()  1: after 1 s -> a }",
        &[],
    );
}

#[test]
fn a_heavy_obstacle_is_a_collision_too() {
    let library = |exits: &str| {
        let text = format!(
            "import std.behaviors.obstacle_manipulation\n
             behavior b extends obstacle_manipulation {{ mode forward {{ drive(26 cm/s) {exits} }} }}"
        );
        let analysis = analyze_texts(&[("b.msd", &text)]);
        let of_modes = analysis.findings.iter().filter(|finding| finding.rule.code.starts_with("LM04"));
        of_modes.map(|finding| finding.rule.name).collect::<Vec<_>>()
    };
    // Push may be inhibited; but then the force is known to have failed, reads 0, and nothing is heavy.
    assert_eq!(library("1: forward_collision -> push  2: heavy_obstacle -> stop"), ["masked-transition"]);
    assert_eq!(
        library("1: forward_collision -> stop  2: heavy_obstacle -> push"),
        ["masked-transition", "unreachable-by-guards"]
    );
    assert_eq!(library("1: heavy_obstacle -> stop  2: forward_collision -> push"), [""; 0]);
}

#[test]
fn a_guard_that_cannot_hold() {
    let modes = |guard: &str| {
        format!("entry a  mode a {{ halt()  1: {guard} -> b  2: y > 9 -> b }}  mode b {{ halt()  1: after 1 s -> a }}")
    };
    for guard in [
        "x > 3 and x < 2",
        "full and empty",
        "stuck",
        "full and x < 5",
        "x > y and y > x",
        "failed(x) and x > 3",
        "rising(full) and not full",
        "latched(full) and not full and full",
        "count(full) < 0",
    ] {
        finds(&modes(guard), &[("LM0409", guard)]);
    }
    for guard in [
        "x > 3 and x <= 3.5",
        "full and x > 5.2",
        "failed(x) and x >= 3",
        "failed(x) and failed(y)",
        "falling(full) and not full",
        "latched(full) and not full",
        "not full and not empty",
        "x == y and x != 0 and y < 9",
        "count(full) >= 3",
    ] {
        finds(&modes(guard), &[]);
    }
}

#[test]
fn one_condition_twice() {
    let modes = |first: &str, second: &str, requires: &str| {
        format!(
            "entry a  mode a {{ halt()  1: {first} -> b  2: {second} -> c }}
             mode b {requires} {{ halt()  1: after 1 s -> c }}  mode c {{ halt()  1: after 1 s -> a }}"
        )
    };
    finds(&modes("x > 3 and full", "full and 3 < x", ""), &[("LM0412", "full and 3 < x")]);
    finds(&modes("x > 3", "x > 3", "requires y else c"), &[]);
}

#[test]
fn a_transition_whose_target_is_inhibited_whenever_it_holds() {
    finds(
        "entry a
         mode a { halt()  1: failed(y) -> b  2: x > 3 -> b }
         mode b requires y else a { halt()  1: after 1 s -> a }",
        &[("LM0418", "1: failed(y) -> b")],
    );
}

#[test]
fn timers_that_never_expire() {
    let modes = |exits: &str| format!("entry a  mode a {{ halt() {exits} }}  mode b {{ halt()  1: after 1 s -> a }}");
    finds(&modes("1: after 5 s -> b  2: after 2 s -> b"), &[("LM0413", "after 5 s")]);
    finds(&modes("1: after 5 s -> b  2: after 2 s and x > 3 -> b"), &[]);
    finds(
        &modes("1: after 5 s -> b  2: after 2 s -> again  3: after 3 s -> b"),
        &[("LM0413", "after 5 s"), ("LM0420", "after 3 s"), ("LM0414", "b")],
    );
    finds(&modes("1: after 5 s -> b  2: after 2 s -> again  3: x > 3 -> b"), &[("LM0420", "after 5 s")]);
    finds(&modes("1: x <= 5 -> again  2: x > 5 -> b  3: after 1 s -> b"), &[("LM0420", "after 1 s")]);
    finds(
        &modes("1: after 2 s -> again  2: after 1 s -> b  3: after 3 s -> b"),
        &[("LM0413", "after 2 s"), ("LM0413", "after 3 s")],
    );
}

#[test]
fn a_mode_always_left_on_its_first_tick() {
    finds(
        "entry a
         mode a { halt()  1: x <= 5 -> b  2: x > 5 -> c }
         mode b { halt()  1: after 1 s -> c }
         mode c { halt()  1: after 1 s -> a }",
        &[("LM0411", "a")],
    );
}

#[test]
fn a_mode_whose_only_way_in_is_masked() {
    finds(
        "entry a
         mode a { halt()  1: x > 2 -> b  2: x > 3 -> c }
         mode b { halt()  1: after 1 s -> a }
         mode c { halt()  1: after 1 s -> d }
         mode d { halt()  1: after 1 s -> a }",
        &[("LM0402", "2: x > 3 -> c"), ("LM0414", "c")],
    );
}

#[test]
fn modes_that_follow_each_other_on_every_tick() {
    finds(
        "entry a
         mode a { halt()  1: x > 1 -> b }
         mode b { halt()  1: x > 9 -> c  2: after 1 s -> a }
         mode c { halt()  1: full -> a }",
        &[("LM0416", "1: x > 1 -> b")],
    );
    finds("entry a  mode a { halt()  1: full -> b }  mode b { halt()  1: not full -> a }", &[]);
    finds(
        "entry a  mode a { halt()  1: full -> b }  mode b { halt()  1: full and y > 3 -> a }",
        &[("LM0416", "1: full -> b")],
    );
}

#[test]
fn conditions_that_are_held_follow_each_other_too() {
    finds(
        "entry a
         mode a { halt()  1: held(x > 5, 1 s) -> b }
         mode b { halt()  1: held(x > 3, 2 s) or rising(full) -> a }",
        &[("LM0416", "1: held(x > 5, 1 s) -> b")],
    );
    finds(
        "entry a
         mode a { halt()  1: rising(x > 5) -> b }
         mode b { halt()  1: held(x > 3, 2 s) -> a }",
        &[],
    );
}

/// The readings with which the modes are said to go round and round.
fn oscillates(modes: &str) -> Option<String> {
    let text = format!("{ROBOT}\nbehavior b on cart {{\n{modes}\n}}");
    let analysis = analyze_texts(&[("b.msd", &text)]);
    assert!(doubts(&analysis).is_empty(), "{}", report(&analysis));
    let found = analysis.findings.into_iter().find(|finding| finding.rule.name == "oscillation");
    found.map(|finding| finding.notes[0].clone())
}

#[test]
fn modes_that_the_same_readings_drive_round_and_round() {
    let modes = |forth: &str, back: &str| {
        format!("entry a  mode a {{ halt() 1: {forth} -> b }}  mode b {{ halt() 1: {back} -> a }}")
    };
    let shown = oscillates(&modes("x > 5 and after 2 s", "x > 8 and after 1 s")).unwrap();
    let reading: f64 = shown.trim_start_matches("it goes on with `x` at ").parse().unwrap();
    assert!(reading > 8.0, "{shown}");
    assert!(oscillates(&modes("x > 5", "x > 3 and after 1 s")).is_some());
    // A mode that time alone ends is meant to end, and what completes may never do.
    assert_eq!(oscillates(&modes("x > 5 and after 2 s", "after 1 s")), None);
    assert_eq!(oscillates(&modes("x > 5 and after 2 s", "x < 3 and after 1 s")), None);
    assert_eq!(oscillates(&modes("x > 5", "count(x > 3) >= 1")), None);
}

#[test]
fn modes_that_noise_drives_to_and_fro() {
    let found = |forth: &str, back: &str| {
        let text = format!(
            "import n
             robot cart {{
                 sensor x: 1 in 0 .. 10 fails 3 noise 0.1
                 sensor y: 1 in 0 .. 10 fails 3
                 action halt()
             }}
             behavior b on cart {{
                 sense n(x)
                 flag near = x < 5
                 entry a
                 mode a {{ halt() 1: {forth} -> b 2: near and full -> b }}
                 mode b {{ halt() 1: {back} -> a }}
             }}"
        );
        let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
        analysis.findings.iter().filter(|finding| finding.rule.code == "LM0419").count()
    };
    for (forth, back) in
        [("near", "not near"), ("x <= 3", "3 < x"), ("full", "not full"), ("near or full", "not near and not full")]
    {
        assert_eq!(found(forth, back), 1, "{forth}, {back}");
    }
    for (forth, back) in [
        ("y < 5", "y >= 5"),
        ("x < y", "x >= y"),
        ("x < 4", "x > 5"),
        ("near", "held(not near, 1 s)"),
        ("near", "not near and after 1 s"),
        ("full", "empty"),
    ] {
        assert_eq!(found(forth, back), 0, "{forth}, {back}");
    }
}

#[test]
fn an_island_of_modes() {
    finds(
        "entry a
         final mode a { halt() }
         mode b { halt()  1: after 1 s -> c }
         mode c { halt()  1: after 1 s -> b  2: x > 3 -> a }",
        &[("LM0417", "b")],
    );
}

#[test]
fn a_way_out_that_is_never_taken_makes_a_trap() {
    finds(
        "entry a
         mode a { halt()  1: x > 3 -> b }
         mode b { halt()  1: x > 4 -> c }
         mode c { halt()  1: x < 2 -> b  2: x > 3 and x < 2 -> a }",
        &[("LM0415", "b"), ("LM0409", "x > 3 and x < 2")],
    );
}

#[test]
fn events_of_different_networks_exclude_each_other_over_shared_sensors() {
    let found = |guard: &str| {
        let networks = "
            variable share: 1 in 0 .. 10 { little = ramp(10, 0)  much = ramp(0, 10) }
            network first(a: share, b: share) { event more_x { contributor rule a is much  detractor rule b is much } }
            network second(a: share, b: share) { event more_y { contributor rule a is much  detractor rule b is much } }";
        let behavior = format!(
            "import n\n{ROBOT}\nbehavior b on cart {{
                sense first(x, y)
                sense second(y, x)
                entry a
                mode a {{ halt()  1: {guard} -> b }}
                mode b {{ halt()  1: after 1 s -> a }}
            }}"
        );
        let analysis = analyze_texts(&[("b.msd", &behavior), ("n.fsfn", networks)]);
        assert!(!analysis.has_errors(), "{}", report(&analysis));
        analysis.findings.iter().map(|finding| finding.rule.name).collect::<Vec<_>>()
    };
    // More of one is less of the other: between the two lies a line, no cell of any grid.
    assert!(found("more_x and more_y").contains(&"condition-never-true"));
    assert!(!found("more_x or more_y").contains(&"condition-never-true"));
    assert!(!found("more_x and x > 4 and y < 4.5").contains(&"condition-never-true"));
    assert!(found("more_x and x < 4 and y > 4.5").contains(&"condition-never-true"));
}
