//! How fast robots are simulated: `cargo bench --bench sim`.
#![expect(clippy::unwrap_used, reason = "a bench without its input has nothing to measure")]

#[path = "../tests/it/random_worlds.rs"]
mod random_worlds;

use divan::{Bencher, counter::ItemsCount};
use lmslc::base::{Id, Span};
use lmslc::ir;
use lmslc::sim::Simulation;
use random_worlds::{Random, TICK, rover, try_worlds};
use rayon::prelude::*;

fn main() {
    divan::main();
}

/// A hall with so many tables of four straight sides each, 1.2 m by 0.8 m, in rows 4 m apart, and a crossing between
/// them.
fn hall(tables: u32) -> (Vec<ir::Wall>, ir::Placement) {
    let wall = |corners: Vec<[f64; 2]>| ir::Wall { corners, is_door: false, span: Span::default() };
    let columns = f64::from(tables).sqrt().ceil() as u32;
    let length = f64::from(columns) * 4.0;
    let mut walls = vec![wall(vec![[0.0, 0.0], [length, 0.0], [length, length], [0.0, length], [0.0, 0.0]])];
    let mut random = Random(7);
    for table in 0..tables {
        let mut place = |number: u32| 4.0 * f64::from(number) + random.between(1.8, 2.2);
        let (x, y) = (place(table % columns), place(table / columns));
        let corners = [[-0.6, -0.4], [0.6, -0.4], [0.6, 0.4], [-0.6, 0.4], [-0.6, -0.4]];
        walls.push(wall(corners.map(|corner| [x + corner[0], y + corner[1]]).to_vec()));
    }
    let crossing = f64::from(columns / 2) * 4.0;
    (walls, ir::Placement::At { x: crossing, y: crossing - 0.5, heading: 0.0 })
}

fn start<'a>(program: &'a ir::Program, (walls, start): (Vec<ir::Wall>, ir::Placement), seed: u64) -> Simulation<'a> {
    let scenario = ir::Scenario { walls, start, ..program.scenarios[Id::new(0)].clone() };
    Simulation::new(program, &scenario, [].iter(), seed).unwrap()
}

/// So many ticks, with something else to do every second if the robot is careless.
fn drive(robot: &mut Simulation<'_>, ticks: u64, mut careless: Option<Random>) -> f64 {
    let mut seen = 0.0;
    for tick in 0..ticks {
        if let Some(random) = careless.as_mut().filter(|_| tick.is_multiple_of(100)) {
            random.command(robot);
        }
        seen += robot.read(tick * TICK)[0].value;
        robot.advance(TICK);
    }
    seen
}

/// A thousand ticks of 10 ms with 24 beams of 15 degrees and contact, on a circle between so many straight walls.
#[divan::bench(args = [20, 2_000])]
fn thousand_ticks(bencher: Bencher, segments: u32) {
    let program = rover();
    let robot = || {
        let mut robot = start(&program, hall((segments - 4) / 4), 1);
        robot.command(3, &[0.3, 0.6], true);
        robot
    };
    let counter = ItemsCount::new(1_000_u32);
    bencher.counter(counter).with_inputs(robot).bench_local_values(|mut robot| drive(&mut robot, 1_000, None));
}

/// The same at random, and so now and then along a wall or against one.
#[divan::bench(args = [20, 2_000])]
fn thousand_careless_ticks(bencher: Bencher, segments: u32) {
    let program = rover();
    let robot = || start(&program, hall((segments - 4) / 4), 1);
    let counter = ItemsCount::new(1_000_u32);
    bencher
        .counter(counter)
        .with_inputs(robot)
        .bench_local_values(|mut robot| drive(&mut robot, 1_000, Some(Random(1))));
}

/// What of a tick the sonars take.
#[divan::bench(args = [20, 2_000], sample_size = 1_000)]
fn sonars_alone(bencher: Bencher, segments: u32) {
    let program = rover();
    let mut robot = start(&program, hall((segments - 4) / 4), 1);
    let mut time = 0;
    bencher.bench_local(|| {
        time += TICK;
        robot.read(time)[0].value
    });
}

/// What of a tick the body takes where nothing is near: ten steps of 1 ms.
#[divan::bench(sample_size = 1_000)]
fn body_alone(bencher: Bencher) {
    let program = rover();
    let mut robot = start(&program, (Vec::new(), ir::Placement::At { x: 0.0, y: 0.0, heading: 0.0 }), 1);
    robot.command(3, &[0.3, 0.1], true);
    bencher.bench_local(|| robot.advance(TICK));
}

/// What of a tick the body takes that is pushed along a wall.
#[divan::bench(sample_size = 1_000)]
fn body_along_a_wall(bencher: Bencher) {
    let program = rover();
    let walls = vec![ir::Wall { corners: vec![[-10.0, 0.0], [1e6, 0.0]], is_door: false, span: Span::default() }];
    let mut robot = start(&program, (walls, ir::Placement::At { x: 0.0, y: 0.6, heading: 0.0 }), 1);
    robot.command(3, &[0.3, -0.01], true);
    (0..1_000).for_each(|_| robot.advance(TICK));
    bencher.bench_local(|| robot.advance(TICK));
}

/// A second of a hundred careless robots, each in a hall of its own with 20 straight walls.
fn second_of_a_fleet(bencher: Bencher, run: impl Fn(&mut [Simulation<'_>]) -> f64 + Sync) {
    let program = rover();
    let fleet = || (0..100).map(|seed| start(&program, hall(4), seed)).collect::<Vec<_>>();
    let bencher = bencher.counter(ItemsCount::new(100_u32)).with_inputs(fleet);
    bencher.bench_local_values(|mut fleet| run(&mut fleet));
}

fn second(robot: &mut Simulation<'_>) -> f64 {
    drive(robot, 100, Some(Random(1)))
}

#[divan::bench(sample_count = 20, sample_size = 1)]
fn second_of_a_fleet_on_one_core(bencher: Bencher) {
    second_of_a_fleet(bencher, |fleet| fleet.iter_mut().map(second).sum());
}

#[divan::bench(sample_count = 20, sample_size = 1)]
fn second_of_a_fleet_on_all_cores(bencher: Bencher) {
    second_of_a_fleet(bencher, |fleet| fleet.par_iter_mut().map(second).sum());
}

/// Ten thousand random worlds, three seconds each; it fails where anything gets into anything else.
#[divan::bench(sample_count = 1, sample_size = 1)]
fn ten_thousand_random_worlds(bencher: Bencher) {
    let program = rover();
    bencher
        .bench_local(|| (0..100).into_par_iter().for_each(|part| try_worlds(&program, part * 100..(part + 1) * 100)));
}

/// What a run among 2,000 walls begins with: their index, and whether anything overlaps.
#[divan::bench]
fn start_in_2_000_walls(bencher: Bencher) {
    let program = rover();
    let walls = hall(499);
    bencher.bench_local(|| start(&program, walls.clone(), 1).done());
}
