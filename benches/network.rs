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
use lmslc::base::Id;

#[path = "../tests/it/golden_reader.rs"]
#[expect(dead_code, reason = "the tests use the rest of it")]
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
