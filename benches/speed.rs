//! How fast the pipeline is: `cargo bench`.
#![expect(clippy::unwrap_used, reason = "a bench without its input has nothing to measure")]

mod large;

use divan::{Bencher, black_box, counter::ItemsCount};
use lmslc::base::{FileId, Id};
use lmslc::driver::{Analysis, FileError, Files, Options, analyze};
use lmslc::interp::{Actuators, Columns, Evaluator, Inputs, Machine, Reading};
use lmslc::sim::{self, RunOptions, Simulation};
use lmslc::syntax::{ast::FileKind, parse};
use lmslc::{plan, report};

use large::behavior;

fn main() {
    divan::main();
}

struct Text(String);

impl Files for Text {
    fn read(&self, path: &str) -> Result<String, FileError> {
        if path == "main.msd" { Ok(self.0.clone()) } else { Err(FileError::Missing) }
    }
}

fn check(text: &str) -> Analysis {
    analyze(&Text(text.to_owned()), &["main.msd".to_owned()], &Options::default())
}

const MANIPULATION: &str = include_str!("../examples/j5/manipulation.msd");

/// A car among the obstacles of an example.
fn minute_of_the_car() -> String {
    let imports = "import std.behaviors.fuzzy_navigation\nimport std.robots.car\n";
    let worlds = include_str!("../examples/car/worlds.msd");
    let scenario = "scenario minute runs fuzzy_navigation on car in many_obstacles_center {
        duration 1 min
        tick 100 ms
        place robot at (50 m, 10 m) heading 90 deg
        expect never front_bumper or back_bumper
    }";
    [imports, worlds, scenario].concat()
}

#[divan::bench(args = [100, 1_000, 10_000, 100_000], max_time = 3)]
fn parse_lines(bencher: Bencher, lines: usize) {
    let text = behavior(lines);
    bencher.counter(ItemsCount::new(lines)).bench(|| parse(FileId(0), FileKind::Modes, black_box(&text)));
}

#[divan::bench(args = [100, 1_000, 10_000, 100_000], max_time = 3)]
fn check_lines(bencher: Bencher, lines: usize) {
    let text = behavior(lines);
    assert!(!check(&text).has_errors());
    bencher.counter(ItemsCount::new(lines)).bench(|| check(black_box(&text)));
}

/// What an editor waits for: the experiment with everything it imports.
#[divan::bench]
fn check_manipulation() -> Analysis {
    check(black_box(MANIPULATION))
}

#[divan::bench(sample_size = 1_000)]
fn evaluate_obstacle_id(bencher: Bencher) {
    let analysis = check(MANIPULATION);
    let network = analysis.program.networks.ids().next().unwrap();
    let plan = plan::build_network(analysis.checked().unwrap(), network);
    let mut evaluator = Evaluator::new(&plan);
    let readings = [-0.7, -1.0, 118.0].map(|value| Reading { value, healthy: true });
    bencher.bench_local(|| {
        evaluator.evaluate(black_box(&readings), 10_000_000);
        evaluator.bool(plan.events[0].flag)
    });
}

/// A block of readings, each counted.
#[divan::bench]
fn evaluate_obstacle_id_in_columns(bencher: Bencher) {
    let analysis = check(MANIPULATION);
    let network = analysis.program.networks.ids().next().unwrap();
    let plan = plan::build_network(analysis.checked().unwrap(), network);
    let mut columns = Columns::new(&plan);
    let readings = [-0.7, -1.0, 118.0].map(|value| vec![value; Columns::BLOCK]);
    bencher.counter(ItemsCount::new(Columns::BLOCK)).bench_local(|| {
        columns.evaluate(black_box(&readings), 10_000_000);
        columns.bools(plan.events[0].flag)[0]
    });
}

struct Deaf;

impl Actuators for Deaf {
    fn command(&mut self, _action: u32, arguments: &[f64], _start: bool) {
        black_box(arguments);
    }
}

#[divan::bench(sample_size = 1_000)]
fn tick_of_obstacle_manipulation(bencher: Bencher) {
    let analysis = check(MANIPULATION);
    let scenario = &analysis.program.scenarios[Id::new(0)];
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    let mut machine = Machine::new(&plan, 1);
    let readings = [0.0, 0.1, 0.0].map(|value| Reading { value, healthy: true });
    bencher.bench_local(|| machine.step(Inputs { readings: black_box(&readings), done: false }, 10_000_000, &mut Deaf));
}

/// Ten seconds at 10 ms a tick, with noise, contact, trace and expectations: a tenth of it is a simulated second.
#[divan::bench]
fn simulate_ten_seconds(bencher: Bencher) {
    let analysis = check(MANIPULATION);
    let scenario = &analysis.program.scenarios[Id::new(0)];
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    bencher.bench(|| sim::run(&analysis.program, &plan, scenario, &RunOptions::default()).unwrap());
}

/// A minute of the car among obstacles: 600 ticks with 36 beams, the fuzzy navigator, trace and expectations.
#[divan::bench]
fn simulate_a_minute_of_the_car(bencher: Bencher) {
    let analysis = check(&minute_of_the_car());
    let scenario = &analysis.program.scenarios[Id::new(0)];
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    bencher.bench(|| sim::run(&analysis.program, &plan, scenario, &RunOptions::default()).unwrap());
}

/// A way on a map of 100 m by 100 m around seven obstacles.
#[divan::bench]
fn plan_a_way(bencher: Bencher) {
    let analysis = check(&minute_of_the_car());
    let program = &analysis.program;
    let mut car = Simulation::new(program, &program.scenarios[Id::new(0)], [].iter(), 1).unwrap();
    let robot = program.robots.values().find(|robot| robot.symbol.name == "car").unwrap();
    let plan = robot.actions.iter().position(|action| program.actions[*action].symbol.name == "plan").unwrap() as u32;
    bencher.bench_local(|| {
        car.command(plan, &[], true);
        car.advance(1);
    });
}

#[divan::bench(sample_size = 1_000)]
fn tick_of_the_fuzzy_navigator(bencher: Bencher) {
    let analysis = check(&minute_of_the_car());
    let plan = plan::build_scenario(analysis.checked().unwrap(), &analysis.program.scenarios[Id::new(0)]);
    let mut machine = Machine::new(&plan, 1);
    let readings: Vec<_> = plan.inputs.iter().map(|_| Reading { value: 6.0, healthy: true }).collect();
    bencher
        .bench_local(|| machine.step(Inputs { readings: black_box(&readings), done: false }, 100_000_000, &mut Deaf));
}

#[divan::bench]
fn report_a_thousand_findings(bencher: Bencher) {
    let text = behavior(5_000).replace("after 2 s", "after 2");
    let analysis = check(&text);
    assert_eq!(analysis.findings.len(), 1_000);
    bencher.bench(|| report::human(&analysis.findings, &analysis.sources, false));
}
