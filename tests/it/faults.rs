//! The fault table derives what the paper says of its network, and more.

use std::process::Command;

use lmslc::analysis::{EventRow, FaultTable, fault_table};
use serde_json::Value;

use crate::support::{analyze_path, root};

const MANIPULATION: &str = "stdlib/behaviors/obstacle_manipulation.msd";

fn table(path: &str, up_to: usize) -> FaultTable {
    let analysis = analyze_path(path);
    fault_table(&analysis.program, &analysis.roots, up_to)
}

fn event<'t>(table: &'t FaultTable, failed: &[&str], name: &str) -> &'t EventRow {
    let is_it = |row: &&lmslc::analysis::FaultRow| {
        row.failed.iter().map(|failed| failed.sensor.as_str()).eq(failed.iter().copied())
    };
    let row = table.rows.iter().find(is_it).unwrap();
    row.events.iter().find(|event| event.name == format!("obstacle_id.{name}")).unwrap()
}

fn rules(rules: &[[&str; 3]]) -> Vec<Vec<String>> {
    rules.iter().map(|rule| rule.map(str::to_owned).to_vec()).collect()
}

fn rules_of(event: &EventRow) -> &lmslc::analysis::RuleRows {
    event.rules.as_ref().unwrap()
}

const LEFT: &str = "left_wheel_acceleration";
const RIGHT: &str = "right_wheel_acceleration";
const FORCE: &str = "contact_force";

/// Born & Wright 2007, eq. 10: with force failed at 0, (1,1,1) alone speaks for a collision, and the detractor is whole.
#[test]
fn without_force_collisions_are_found_from_acceleration_alone() {
    let table = table(MANIPULATION, 3);
    let collision = event(&table, &[FORCE], "forward_collision");
    assert_eq!(rules_of(collision).contributor, rules(&[["neg", "neg", "low"]]));
    assert_eq!(rules_of(collision).detractor, rules_of(event(&table, &[], "forward_collision")).detractor);
    assert_eq!(rules_of(collision).masked, (15, 0));
    assert!(collision.can_set && collision.can_clear);
    let heavy = event(&table, &[FORCE], "heavy_obstacle");
    assert!(rules_of(heavy).contributor.is_empty() && !heavy.can_set, "nothing can be called heavy");
}

/// Eqs. 11 and 12: with both accelerations failed at 0, force alone decides.
#[test]
fn without_accelerations_collisions_are_found_from_force_alone() {
    let table = table(MANIPULATION, 3);
    let collision = event(&table, &[LEFT, RIGHT], "forward_collision");
    assert_eq!(rules_of(collision).contributor, rules(&[["zero", "zero", "high"], ["zero", "zero", "med"]]));
    assert_eq!(rules_of(collision).detractor, rules(&[["zero", "zero", "low"]]));
    assert!(collision.can_set && event(&table, &[LEFT, RIGHT], "heavy_obstacle").can_set);
}

/// The paper stops before this one.
#[test]
fn without_force_and_one_acceleration_nothing_is_found() {
    let table = table(MANIPULATION, 3);
    for failed in [&[LEFT, FORCE][..], &[RIGHT, FORCE], &[LEFT, RIGHT, FORCE]] {
        assert!(!event(&table, failed, "forward_collision").can_set, "{failed:?}");
    }
    assert_eq!(table.rows.len(), 8);
}

/// A heavy obstacle is a collision too, whatever has failed.
#[test]
fn no_reading_is_heavy_without_being_a_collision() {
    for row in table(MANIPULATION, 3).rows {
        let heavy_alone = row.valuations.iter().any(|set| set.as_slice() == ["heavy_obstacle"]);
        assert!(!heavy_alone && row.valuations.contains(&Vec::new()), "{:?}", row.failed);
    }
}

#[test]
fn modes_are_lost_with_the_sensors_that_lead_to_them() {
    let table = table(MANIPULATION, 3);
    let modes = |failed: &[&str]| {
        let is_it = |row: &&lmslc::analysis::FaultRow| {
            row.failed.iter().map(|failed| failed.sensor.as_str()).eq(failed.iter().copied())
        };
        table.rows.iter().find(is_it).unwrap().modes[0].clone()
    };
    let nothing_failed = modes(&[]);
    assert_eq!(nothing_failed.reachable, ["init", "forward", "stop", "back_up", "random_turn", "push"]);
    assert!(nothing_failed.traps.is_empty() && nothing_failed.inhibited.is_empty());
    assert_eq!(modes(&[FORCE]).inhibited, ["push"]);
    assert!(modes(&[FORCE]).reachable.contains(&"push".to_owned()), "the fault is silent");
    let blind = modes(&[LEFT, RIGHT, FORCE]);
    assert!(blind.reachable.contains(&"forward".to_owned()), "sensors may fail at any time");
}

fn answer(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_lmslc")).args(arguments).current_dir(root()).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_table_is_one_json_object() {
    let json: Value = serde_json::from_str(&answer(&["faults", MANIPULATION, "--format", "json"])).unwrap();
    assert_eq!((&json["schema"], &json["file"]), (&Value::from(1), &Value::from(MANIPULATION)));
    let rows = json["faults"].as_array().unwrap();
    assert_eq!(rows.len(), 4);
    assert_eq!(rows[0]["failed"], serde_json::json!({}));
    assert_eq!(rows[3]["failed"], serde_json::json!({ "contact_force": 0.0 }));
    let collision = &rows[3]["events"]["obstacle_id.forward_collision"];
    assert_eq!(collision["can_set"], true);
    assert_eq!(collision["contributor"], serde_json::json!([["neg", "neg", "low"]]));
    assert_eq!(collision["masked"], serde_json::json!({ "contributor": 15, "detractor": 0 }));
    assert!(collision["witness_set"][LEFT].as_f64().unwrap() < 0.0);
    let modes = &rows[3]["modes"]["obstacle_manipulation"];
    assert_eq!(modes["inhibited"], serde_json::json!(["push"]));
    assert_eq!(modes["unreachable"], serde_json::json!([]));
    assert_eq!(rows[3]["valuations"], serde_json::json!([["forward_collision"], []]));
}

#[test]
fn the_table_is_shown_to_people_too() {
    insta::assert_snapshot!(answer(&["faults", MANIPULATION]));
    let markdown = answer(&["faults", MANIPULATION, "--format", "markdown"]);
    let (sentences, table) = markdown.split_once("\n\n").unwrap();
    assert!(sentences.lines().count() == 2 && sentences.lines().all(|line| line.starts_with("- ")), "{markdown}");
    assert_eq!(table.lines().count(), 6, "{markdown}");
    assert!(table.lines().all(|line| line.matches('|').count() == 5), "{markdown}");
    let html = answer(&["faults", "stdlib/networks/obstacle_id.fsfn", "--format", "html"]);
    let sentence = "<li><code>heavy_obstacle</code> depends on <code>force</code> alone and implies \
        <code>forward_collision</code>.</li>";
    assert!(html.contains(sentence), "{html}");
    assert!(html.starts_with("<!doctype html>") && html.contains("obstacle_id.heavy_obstacle"));
}
