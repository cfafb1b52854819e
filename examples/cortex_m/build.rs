//! Compiles the behavior, and records what the simulator makes of it: both with `lmslc`, found on the path or where the
//! variable `LMSLC` says.

use std::process::Command;
use std::{env, fs};

/// The scenarios that the firmware goes through, each in the file of its name.
const SCENARIOS: [&str; 2] = ["manipulation", "force_faulted"];

/// The columns of a trace that the firmware reads, and those that it computes too.
const READINGS: [&str; 3] = ["left_wheel_acceleration", "right_wheel_acceleration", "contact_force"];
const STRENGTHS: [&str; 4] = [
    "obstacle_id.forward_collision.contributor",
    "obstacle_id.forward_collision.detractor",
    "obstacle_id.heavy_obstacle.contributor",
    "obstacle_id.heavy_obstacle.detractor",
];

fn main() {
    let lmslc = env::var("LMSLC").unwrap_or("lmslc".to_owned());
    println!("cargo::rerun-if-env-changed=LMSLC");
    // On the path it is no file that cargo could watch, so this script runs every time.
    println!("cargo::rerun-if-changed={lmslc}");
    println!("cargo::rerun-if-changed=../j5");
    let run = |arguments: &[&str]| {
        let status = Command::new(&lmslc).arg("--quiet").args(arguments).status();
        let status = status.unwrap_or_else(|error| panic!("`{lmslc}` cannot be run: {error}"));
        assert!(status.success(), "`{lmslc} {}` failed", arguments.join(" "));
    };
    let folder = env::var("OUT_DIR").unwrap();
    run(&["build", "../j5/manipulation.msd", "--output", &format!("{folder}/behavior.rs")]);
    let runs = SCENARIOS.map(|scenario| {
        let (file, trace) = (format!("../j5/{scenario}.msd"), format!("{folder}/{scenario}.csv"));
        run(&["run", &file, scenario, "--trace", &trace]);
        let ticks = ticks(&fs::read_to_string(trace).unwrap());
        format!("Run {{ scenario: {scenario:?}, ticks: &[\n{ticks}] }},\n")
    });
    fs::write(format!("{folder}/runs.rs"), format!("[\n{}]", runs.concat())).unwrap();
}

/// A trace as Rust, a tick a line. Numbers in a trace are exact, and Rust reads them as they were.
fn ticks(trace: &str) -> String {
    let mut lines = trace.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let column = |name: &str| header.iter().position(|&column| column == name).unwrap();
    let tick = |line: Vec<&str>| {
        let number = |name: &&str| line[column(name)].parse::<f64>().unwrap();
        let time_ns = (number(&"t") * 1e9).round() as u64;
        let (readings, strengths) = (READINGS.each_ref().map(number), STRENGTHS.each_ref().map(number));
        let mode = line[column("mode")];
        format!("Tick {{ time_ns: {time_ns}, readings: {readings:?}, mode: {mode:?}, strengths: {strengths:?} }},\n")
    };
    lines.map(tick).collect()
}
