//! Scenarios that test nothing, and times that do not fit their ticks.

use lmslc::diag::Severity;

use crate::support::{analyze_texts, report};

/// The codes found in a scenario with these lines, of the warnings.
fn found(lines: &str) -> Vec<&'static str> {
    let text = format!(
        "import std.behaviors.obstacle_manipulation
         import std.robots.j5
         scenario it runs obstacle_manipulation on j5 {{ {lines} }}"
    );
    let analysis = analyze_texts(&[("it.msd", &text)]);
    assert!(!analysis.has_errors(), "{}", report(&analysis));
    let told = analysis.findings.iter().filter(|finding| finding.severity == Severity::Warning);
    told.map(|finding| finding.rule.code).collect()
}

#[test]
fn an_expectation_that_no_run_can_miss() {
    let expected = [
        ("modes init", true),
        ("modes init, forward", false),
        ("modes forward", false),
        ("never push and stop", true),
        ("never push and not push", true),
        ("never push and heavy_obstacle", false),
        ("always not (init and forward) or push", true),
        ("always init or forward or push or stop or back_up or random_turn", true),
        ("always init or forward or push or stop or back_up", false),
        ("never heavy_obstacle and not forward_collision", true),
        ("never forward_collision and not heavy_obstacle", false),
        ("never heavy_obstacle and contact_force < 20 N", true),
        ("never heavy_obstacle", false),
        ("contact_force >= 0 N", true),
        ("contact_force > 0 N", false),
        ("never rising(heavy_obstacle) and not heavy_obstacle", true),
        ("never latched(heavy_obstacle) and not heavy_obstacle", false),
        ("never failed(contact_force) and contact_force > 0 N", true),
        ("never failed(contact_force)", false),
        ("never after 0 s and after 1 s", false),
    ];
    for (expectation, never_fails) in expected {
        let codes: &[&str] = if never_fails { &["LM0806"] } else { &[] };
        assert_eq!(found(&format!("duration 4 s  expect {expectation}")), codes, "{expectation}");
    }
    // What a fault of the scenario alone makes true is what it is there to show.
    assert!(found("duration 4 s  fault contact_force = 0 N from 0 s  expect never heavy_obstacle").is_empty());
}

#[test]
fn a_window_without_a_tick() {
    let cases = [
        ("expect never push within 5 s .. 6 s", "LM0806"),
        ("expect always forward after 4.001 s", "LM0806"),
        ("expect always forward after 4 s", ""),
        ("expect never push within 1.001 s .. 1.009 s", "LM0806"),
        ("expect never push within 1.001 s .. 1.01 s", ""),
        ("expect push within 5 s .. 6 s", "LM0807"),
        ("expect forward -> push within 5 s .. 6 s", "LM0807"),
        ("expect forward -> push within 3 s .. 6 s", ""),
        ("fault contact_force = 0 N from 5 s", "LM0807"),
        ("fail contact_force from 1 s to 2 s", ""),
        ("fail contact_force from 1.001 s to 1.002 s", "LM0807"),
    ];
    for (line, code) in cases {
        let codes: Vec<_> = Some(code).filter(|code| !code.is_empty()).into_iter().collect();
        assert_eq!(found(&format!("duration 4 s  {line}")), codes, "{line}");
    }
}

#[test]
fn a_fault_that_is_taken_over_need_strike_only_once() {
    let long = "scenario longer extends it { duration 9 s";
    let faulted = "duration 4 s  fault contact_force = 0 N from 5 s";
    assert_eq!(found(faulted), ["LM0807"]);
    assert!(found(&format!("{faulted} }} {long}")).is_empty());
}

/// The codes found in a behavior with this condition, and the label on its scenario.
fn timed(condition: &str, tick: &str) -> Vec<(&'static str, String)> {
    let text = format!(
        "import std.robots.j5
         behavior b on j5 {{
             entry a
             mode a {{ halt()  1: contact_force > 9 N and {condition} -> b }}
             mode b {{ halt()  1: after 1 s -> a }}
         }}
         scenario it runs b {{ duration 1 s {tick} }}"
    );
    let analysis = analyze_texts(&[("it.msd", &text)]);
    assert!(!analysis.has_errors(), "{}", report(&analysis));
    let label = |labels: &[lmslc::diag::Label]| labels[0].message.clone();
    analysis.findings.iter().map(|finding| (finding.rule.code, label(&finding.labels))).collect()
}

#[test]
fn times_beside_ticks() {
    let (below, between) = ("has passed by the next tick", "has passed on the tick at 20 ms");
    assert_eq!(timed("after 5 ms", ""), [("LM0314", below.to_owned())]);
    assert_eq!(timed("held(contact_force > 20 N, 5 ms)", ""), [("LM0314", below.to_owned())]);
    assert_eq!(timed("after 5 ms", "tick 5 ms"), []);
    assert_eq!(timed("after 0 s", ""), []);
    assert_eq!(timed("after 15 ms", ""), [("LM0315", between.to_owned())]);
    assert_eq!(timed("after 20 ms", ""), []);
    assert_eq!(
        timed("after 90 ms", "tick 30 ms"),
        [
            ("LM0315", "has passed on the tick at 1.02 s".to_owned()),
            ("LM0315", "the last tick is at 990 ms".to_owned()),
        ]
    );
}
