//! The standard library and the examples are clean, and every scenario meets its expectations.

use lmslc::sim::{self, Run, RunOptions};
use lmslc::{plan, report};

use crate::support::{analyze_path, doubts, files_below, report as findings};

fn run_file(path: &str, options: &RunOptions) -> Vec<(String, Run)> {
    let analysis = analyze_path(path);
    assert!(doubts(&analysis).is_empty(), "{}", findings(&analysis));
    let checked = analysis.checked().unwrap();
    let own = analysis.program.scenarios.values().filter(|s| analysis.roots.contains(&s.symbol.span.file));
    own.map(|scenario| {
        let plan = plan::build_scenario(checked, scenario);
        (scenario.symbol.name.clone(), sim::run(&analysis.program, &plan, scenario, options).unwrap())
    })
    .collect()
}

#[test]
fn the_library_and_the_examples_are_clean() {
    let files = [files_below("stdlib", &["msd", "fsfn"]), files_below("examples", &["msd", "fsfn"])].concat();
    assert!(files.len() > 10);
    for path in files {
        let analysis = analyze_path(&path);
        assert!(doubts(&analysis).is_empty(), "{}", findings(&analysis));
    }
}

#[test]
fn the_embedded_library_is_the_one_on_disk() {
    let embedded: Vec<_> = lmslc::driver::LIBRARY.iter().map(|(path, _)| (*path).to_owned()).collect();
    let on_disk: Vec<_> =
        files_below("stdlib", &["msd", "fsfn"]).into_iter().map(|path| path.replacen("stdlib", "std", 1)).collect();
    assert_eq!(embedded, on_disk);
}

#[test]
fn every_scenario_meets_its_expectations() {
    let mut count = 0;
    for path in files_below("examples", &["msd"]) {
        for (name, run) in run_file(&path, &RunOptions::default()) {
            assert!(!run.verdicts.is_empty(), "{path}: {name} expects nothing");
            for verdict in &run.verdicts {
                assert!(verdict.passed, "{path}: {name}: {}: {}", verdict.text, verdict.seen);
            }
            count += 1;
        }
    }
    assert!(count >= 16, "only {count} scenarios ran");
}

#[test]
fn a_heavier_first_box_fails_the_right_expectation() {
    let text = std::fs::read_to_string(crate::support::root().join("examples/j5/manipulation.msd")).unwrap();
    let text = text.replace("light mass 30 kg", "light mass 90 kg");
    let analysis = crate::support::clean("manipulation.msd", &text);
    let scenario = &analysis.program.scenarios[lmslc::base::Id::new(0)];
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    let run = sim::run(&analysis.program, &plan, scenario, &RunOptions::default()).unwrap();
    let failed: Vec<_> = run.verdicts.iter().filter(|verdict| !verdict.passed).map(|v| v.text.as_str()).collect();
    assert!(failed.contains(&"modes init, forward, push, stop, back_up"), "{failed:?}");
    assert!(failed.contains(&"never heavy_obstacle before 7.5 s"), "{failed:?}");
    assert!(!failed.contains(&"init -> forward within 1.9 s .. 2.1 s"), "{failed:?}");
}

fn trace(seed: Option<u64>) -> Vec<u8> {
    let options = RunOptions { seed, ..RunOptions::default() };
    let mut bytes = Vec::new();
    for (_, run) in run_file("examples/j5/manipulation.msd", &options) {
        report::trace_csv(&run.trace, &mut bytes).unwrap();
    }
    bytes
}

#[test]
fn one_seed_is_one_run_byte_for_byte() {
    assert_eq!(trace(Some(5)), trace(Some(5)));
    assert_ne!(trace(Some(5)), trace(Some(6)));
    assert_eq!(trace(None), trace(Some(1)), "the file says seed 1");
}

/// Figure 8: force is linear in mass up to the slip limit and flat from there; spikes grow with every mass.
#[test]
fn collisions_are_characterized_as_in_figure_8() {
    let runs = run_file("examples/j5/characterization.msd", &RunOptions::default());
    let mut measured: Vec<(f64, f64, f64)> = Vec::new();
    for (name, run) in &runs {
        let mass: f64 = name.strip_prefix("mass_").unwrap().parse().unwrap();
        let column = |name: &str| &run.trace.columns.iter().find(|column| column.name == name).unwrap().values;
        let steady = &column("contact_force")[500..];
        let force = steady.iter().sum::<f64>() / steady.len() as f64;
        let spike = column("left_wheel_acceleration")[350..450].iter().copied().fold(f64::INFINITY, f64::min);
        measured.push((mass, force, spike));
    }
    // Friction of 0.4 on boxes and wheels alike, 59 kg of robot; the mean of 200 readings with a deviation of 2 N has
    // one of 0.14 N, so 1 N is seven of them.
    for &(mass, force, _) in &measured {
        let expected = 0.4 * 9.80665 * mass.min(59.0);
        assert!((force - expected).abs() < 1.0, "{mass} kg: {force} N, expected {expected} N");
    }
    let spikes: Vec<f64> = measured.iter().map(|&(_, _, spike)| spike).collect();
    assert!(spikes.windows(2).all(|pair| pair[1] < pair[0]), "spikes grow with mass: {spikes:?}");
}
