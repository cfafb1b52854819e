//! How long a network's facts take.
#![allow(
    missing_docs,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::disallowed_methods,
    reason = "a bench without its input has nothing to measure"
)]

use std::hint::black_box;

use divan::Bencher;
use lmslc::analysis::network::{Model, analyze};
use lmslc::analysis::run;
use lmslc::base::Id;

#[path = "../tests/it/golden_reader.rs"]
#[expect(dead_code, clippy::panic, clippy::disallowed_methods, reason = "the tests' reader")]
mod golden_reader;

/// Paths of the reader.
mod support {
    use std::path::PathBuf;

    pub fn root() -> PathBuf {
        PathBuf::from(env!("CARGO_MANIFEST_DIR"))
    }
}

fn main() {
    divan::main();
}

/// Every question about Obstacle_ID under all 216 sets of up to three failures.
#[divan::bench]
fn obstacle_id_under_every_failure(bencher: Bencher<'_, '_>) {
    let program = golden_reader::with_every_failure(&golden_reader::read("obstacle_id.json")[0]);
    bencher.bench(|| {
        let facts = analyze(&program, Id::new(0), 3);
        assert_eq!(facts.len(), 216);
        black_box(facts)
    });
}

/// The same, and which events can be set together.
#[divan::bench]
fn obstacle_id_jointly_under_every_failure(bencher: Bencher<'_, '_>) {
    let program = golden_reader::with_every_failure(&golden_reader::read("obstacle_id.json")[0]);
    bencher.bench(|| {
        let model = Model::new(&program, Id::new(0)).unwrap();
        let facts = model.facts(3);
        facts.iter().map(|facts| model.valuations(facts).len()).sum::<usize>()
    });
}

/// Every question about an event of 20 inputs and 200 rules.
#[divan::bench]
fn twenty_inputs_and_two_hundred_rules(bencher: Bencher<'_, '_>) {
    let program = golden_reader::program(&large());
    bencher.bench(|| {
        let facts = analyze(&program, Id::new(0), 0);
        assert_eq!(facts[0].events[0].contributor.len(), 100);
        black_box(facts)
    });
}

/// What an editor waits for: every finding about Obstacle_ID.
#[divan::bench]
fn findings_of_obstacle_id(bencher: Bencher<'_, '_>) {
    let program = golden_reader::program(&golden_reader::read("obstacle_id.json")[0]);
    bencher.bench(|| run(&program, 1, |_| true).len());
}

/// Every finding about a network of 20 inputs and 200 rules.
#[divan::bench]
fn findings_of_two_hundred_rules(bencher: Bencher<'_, '_>) {
    let program = golden_reader::program(&large());
    bencher.bench(|| run(&program, 1, |_| true).len());
}

/// 20 inputs of three overlapping terms each, none with the corners of another; each rule names four of them.
fn large() -> serde_json::Value {
    let variables = (0..20).map(|input| {
        let peak = 40 + input;
        serde_json::json!({
            "name": format!("v{input}"),
            "range": [0, 100],
            "terms": [{"ramp_down": [10, peak]}, {"tri": [10, peak, 90]}, {"ramp_up": [peak, 90]}],
        })
    });
    let rule = |seed: usize| {
        let mut cells = vec![serde_json::Value::Null; 20];
        for cell in 0..4 {
            cells[(seed * 7 + cell * (3 + seed % 4)) % 20] = ((seed / 3 + cell * seed) % 3).into();
        }
        serde_json::Value::Array(cells)
    };
    let (contributor, detractor): (Vec<_>, Vec<_>) = ((0..100).map(rule).collect(), (100..200).map(rule).collect());
    serde_json::json!({
        "name": "large",
        "variables": variables.collect::<Vec<_>>(),
        "events": [{"name": "e", "contributor": contributor, "detractor": detractor}],
    })
}
