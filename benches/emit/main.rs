//! How fast emitted code is, beside the same written by hand, in other crates and in the interpreter:
//! `cargo bench --bench emit`. Contenders take turns, the fastest turn of each counts, and all must do the same.
#![expect(clippy::disallowed_methods, clippy::print_stdout, reason = "ratios are measured by a clock of our own")]
#![expect(clippy::unwrap_used, reason = "a bench without its input has nothing to measure")]

mod by_fuzzy_logic_rs;
mod by_hand;
mod by_hand_navigator;
mod by_smlang;
mod by_statig;

use std::convert::Infallible;
use std::hint::black_box;
use std::time::{Duration, Instant};

use lmslc::driver::{Analysis, FileError, Files, Options, analyze};
use lmslc::interp::{Actuators, Evaluator, Inputs, Machine, Reading};
use lmslc::kernel::{draw, next_random};
use lmslc::plan;
use statig::blocking::IntoStateMachineExt;

mod emitted {
    include!("../../tests/emitted/obstacle_manipulation.rs");
}
use emitted::{obstacle_id, obstacle_manipulation as manipulation};

mod emitted_navigator {
    include!("../../tests/emitted/navigator.rs");
}
use emitted_navigator::navigator;

mod emitted_switching {
    include!("switching.rs");
}
use emitted_switching::switching;

/// The length of a tick in nanoseconds.
const TICK: u32 = 100_000_000;
/// A turn of 120 degrees, rounded once.
const TURN: f64 = 2.094_395_102_393_195_7;

/// A robot that sums up what it is asked for, at the price of one addition.
pub struct Commands(u64);

impl Commands {
    #[inline]
    fn add(&mut self, kind: u64, value: f64) {
        self.0 = self.0.wrapping_add(kind.wrapping_add(value.to_bits()));
    }

    #[inline]
    fn halt(&mut self) {
        self.add(1, 0.0);
    }

    #[inline]
    fn drive(&mut self, speed: f64) {
        self.add(2, speed);
    }

    #[inline]
    fn arc(&mut self, speed: f64, radius: f64) {
        self.add(3, speed);
        self.add(4, radius);
    }

    #[inline]
    fn turn(&mut self, angle: f64, start: bool) {
        self.add(5 + u64::from(start), angle);
    }
}

/// The robot as the module of a behavior asks for it.
macro_rules! robot {
    ($module:ident) => {
        impl $module::Robot for Commands {
            type Error = Infallible;

            #[inline]
            fn halt(&mut self) -> Result<(), Infallible> {
                self.halt();
                Ok(())
            }

            #[inline]
            fn drive(&mut self, speed: f64) -> Result<(), Infallible> {
                self.drive(speed);
                Ok(())
            }

            #[inline]
            fn arc(&mut self, speed: f64, radius: f64) -> Result<(), Infallible> {
                self.arc(speed, radius);
                Ok(())
            }

            #[inline]
            fn turn(&mut self, angle: f64, start: bool) -> Result<(), Infallible> {
                self.turn(angle, start);
                Ok(())
            }
        }
    };
}

robot!(manipulation);
robot!(switching);

/// The same for the interpreter.
struct Told<'p> {
    plan: &'p plan::Plan,
    robot: Commands,
}

impl Actuators for Told<'_> {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        match (self.plan.actions[action as usize].name.as_str(), arguments) {
            ("drive", [speed]) => self.robot.drive(*speed),
            ("arc", [speed, radius]) => self.robot.arc(*speed, *radius),
            ("turn", [angle]) => self.robot.turn(*angle, start),
            _ => self.robot.halt(),
        }
    }
}

const COUNT: usize = 4096;

/// The answers of a run, as one number.
type Run<'a, I> = (&'a str, &'a dyn Fn(&[I]) -> u64);

/// Times runs over the same inputs, in turns; prints nanoseconds for one input, and how much the first one takes of them.
fn measure<I>(title: &str, inputs: &[I], runs: &[Run<'_, I>], time: Duration) {
    let mut best = vec![f64::INFINITY; runs.len()];
    let answer = runs[0].1(inputs);
    let start = Instant::now();
    loop {
        for ((name, run), best) in runs.iter().zip(&mut best) {
            let start = Instant::now();
            let same = black_box(run(black_box(inputs))) == answer;
            *best = best.min(start.elapsed().as_secs_f64() * 1e9 / inputs.len() as f64);
            assert!(same, "{title}: {name} does something else");
        }
        if start.elapsed() >= time {
            break;
        }
    }
    println!("{title}");
    for ((name, _), nanoseconds) in runs.iter().zip(&best) {
        println!("  {name:<12} {nanoseconds:7.2} ns  {:6.3}", best[0] / nanoseconds);
    }
}

fn mix(sum: u64, [one, other]: [bool; 2]) -> u64 {
    sum.rotate_left(1) ^ (u64::from(one) + 2 * u64::from(other))
}

fn readings() -> Vec<obstacle_id::Inputs> {
    let mut seed = 1;
    let mut reading = || obstacle_id::Inputs {
        left: draw(&mut seed, -1.5, 1.5),
        right: draw(&mut seed, -1.5, 1.5),
        force: draw(&mut seed, 0.0, 250.0),
    };
    (0..COUNT).map(|_| reading()).collect()
}

#[inline]
fn all<I>(inputs: &[I], evaluate: impl Fn(&I) -> [bool; 2]) -> u64 {
    inputs.iter().fold(0, |sum, reading| mix(sum, evaluate(reading)))
}

/// Each answer decides where the next readings are taken from, so that nothing overlaps.
#[inline]
fn chained<I>(inputs: &[I], evaluate: impl Fn(&I) -> [bool; 2]) -> u64 {
    let (mut sum, mut at) = (0, 0);
    for _ in inputs {
        let [one, other] = evaluate(&inputs[at % COUNT]);
        sum = mix(sum, [one, other]);
        at += 1 + usize::from(one) + usize::from(other);
    }
    sum
}

fn emitted_events(inputs: &obstacle_id::Inputs) -> [bool; 2] {
    let events = obstacle_id::evaluate(inputs);
    [events.forward_collision, events.heavy_obstacle]
}

fn networks(program: &Analysis, time: Duration) {
    let checked = program.checked().unwrap();
    let (id, _) = program.program.networks.iter().find(|(_, network)| network.symbol.name == "obstacle_id").unwrap();
    let plan = plan::build_network(checked, id);
    let interpreted = |inputs: &[obstacle_id::Inputs]| {
        let mut evaluator = Evaluator::new(&plan);
        inputs.iter().fold(0, |sum, inputs| {
            let told = [inputs.left, inputs.right, inputs.force].map(|value| Reading { value, healthy: true });
            evaluator.evaluate(&told, u64::from(TICK));
            mix(sum, [0, 1].map(|event: usize| evaluator.bool(plan.events[event].flag)))
        })
    };
    let readings = readings();
    let runs: [Run<'_, _>; 3] = [
        ("emitted", &|inputs| all(inputs, emitted_events)),
        ("by hand", &|inputs| all(inputs, by_hand::obstacle_id)),
        ("interpreter", &interpreted),
    ];
    measure("obstacle_id", &readings, &runs, time);
    let runs: [Run<'_, _>; 2] = [
        ("emitted", &|inputs| chained(inputs, emitted_events)),
        ("by hand", &|inputs| chained(inputs, by_hand::obstacle_id)),
    ];
    measure("obstacle_id, each after the one before", &readings, &runs, time);
}

fn courses() -> Vec<navigator::Inputs> {
    let mut seed = 3;
    let mut reading = || navigator::Inputs {
        target: draw(&mut seed, -3.2, 3.2),
        gate: draw(&mut seed, -3.2, 3.2),
        obstacle: draw(&mut seed, 0.0, 60.0),
        left: draw(&mut seed, 0.0, 10.0),
        right: draw(&mut seed, 0.0, 10.0),
    };
    (0..COUNT).map(|_| reading()).collect()
}

fn emitted_course(inputs: &navigator::Inputs) -> [f64; 2] {
    let outputs = navigator::evaluate(inputs);
    [outputs.steering.value, outputs.speed.value]
}

fn steered(sum: u64, [steering, speed]: [f64; 2]) -> u64 {
    sum.rotate_left(1) ^ steering.to_bits() ^ speed.to_bits().rotate_left(32)
}

#[inline]
fn driven(inputs: &[navigator::Inputs], evaluate: impl Fn(&navigator::Inputs) -> [f64; 2]) -> u64 {
    inputs.iter().fold(0, |sum, reading| steered(sum, evaluate(reading)))
}

/// Each answer is part of the next reading, so that nothing overlaps.
#[inline]
fn driven_on(inputs: &[navigator::Inputs], evaluate: impl Fn(&navigator::Inputs) -> [f64; 2]) -> u64 {
    let mut answer = [0.0, 0.0];
    inputs.iter().fold(0, |sum, reading| {
        let [steering, speed] = answer;
        let reading = navigator::Inputs { target: reading.target - steering, left: reading.left + speed, ..*reading };
        answer = evaluate(&reading);
        steered(sum, answer)
    })
}

fn navigators(program: &Analysis, time: Duration) {
    let checked = program.checked().unwrap();
    let (id, _) = program.program.networks.iter().find(|(_, network)| network.symbol.name == "navigator").unwrap();
    let plan = plan::build_network(checked, id);
    let interpreted = |inputs: &[navigator::Inputs]| {
        let mut evaluator = Evaluator::new(&plan);
        inputs.iter().fold(0, |sum, inputs| {
            let told = [inputs.target, inputs.gate, inputs.obstacle, inputs.left, inputs.right];
            evaluator.evaluate(&told.map(|value| Reading { value, healthy: true }), u64::from(TICK));
            steered(sum, [0, 1].map(|output: usize| evaluator.real(plan.outputs[output].value)))
        })
    };
    let courses = courses();
    let runs: [Run<'_, _>; 3] = [
        ("emitted", &|inputs| driven(inputs, emitted_course)),
        ("by hand", &|inputs| driven(inputs, by_hand_navigator::navigator)),
        ("interpreter", &interpreted),
    ];
    measure("navigator", &courses, &runs, time);
    let runs: [Run<'_, _>; 2] = [
        ("emitted", &|inputs| driven_on(inputs, emitted_course)),
        ("by hand", &|inputs| driven_on(inputs, by_hand_navigator::navigator)),
    ];
    measure("navigator, each after the one before", &courses, &runs, time);
}

/// A library that samples does something near, and is measured alone.
fn sampled(program: &Analysis, time: Duration) {
    let network = program.program.networks.values().find(|network| network.symbol.name == "navigator").unwrap();
    let system = by_fuzzy_logic_rs::network(&program.program, network);
    let evaluate = |inputs: &navigator::Inputs| {
        let answer =
            system.compute_outputs(vec![inputs.target, inputs.gate, inputs.obstacle, inputs.left, inputs.right]);
        [answer[0], answer[1]]
    };
    // It takes a reading at the very end of its range for one outside of it.
    let courses: Vec<_> =
        courses().into_iter().filter(|inputs| inputs.target.abs() < 3.1 && inputs.gate.abs() < 3.1).collect();
    let off = courses.iter().map(|inputs| (emitted_course(inputs)[0] - evaluate(inputs)[0]).abs()).sum::<f64>();
    assert!(off / (courses.len() as f64) < 0.01, "{}: another network", off / courses.len() as f64);
    measure("navigator in a library", &courses, &[("fuzzy-logic_rs", &|inputs| driven(inputs, evaluate))], time);
}

/// Columns against rows: the answers of all rows are left in memory by both.
fn columns(time: Duration) {
    let (readings, courses) = (readings(), courses());
    let [left, right, force] = [0, 1, 2]
        .map(|column: usize| readings.iter().map(|row| [row.left, row.right, row.force][column]).collect::<Vec<_>>());
    let rows = |readings: &[obstacle_id::Inputs]| {
        let (mut forward_collision, mut heavy_obstacle) = ([false; COUNT], [false; COUNT]);
        for ((row, forward_collision), heavy_obstacle) in
            readings.iter().zip(&mut forward_collision).zip(&mut heavy_obstacle)
        {
            let events = obstacle_id::evaluate(row);
            (*forward_collision, *heavy_obstacle) = (events.forward_collision, events.heavy_obstacle);
        }
        black_box((&forward_collision, &heavy_obstacle));
        forward_collision.iter().zip(&heavy_obstacle).fold(0, |sum, (one, other)| mix(sum, [*one, *other]))
    };
    let in_columns = |_: &[obstacle_id::Inputs]| {
        let (mut forward_collision, mut heavy_obstacle) = ([false; COUNT], [false; COUNT]);
        obstacle_id::evaluate_columns(&left, &right, &force, &mut forward_collision, &mut heavy_obstacle);
        black_box((&forward_collision, &heavy_obstacle));
        forward_collision.iter().zip(&heavy_obstacle).fold(0, |sum, (one, other)| mix(sum, [*one, *other]))
    };
    let runs: [Run<'_, _>; 2] = [("columns", &in_columns), ("rows", &rows)];
    measure("obstacle_id, many readings", &readings, &runs, time);

    let [target, gate, obstacle, left, right] = [0, 1, 2, 3, 4].map(|column: usize| {
        let row = |row: &navigator::Inputs| [row.target, row.gate, row.obstacle, row.left, row.right][column];
        courses.iter().map(row).collect::<Vec<_>>()
    });
    let in_columns = |_: &[navigator::Inputs]| {
        let (mut steering, mut speed, mut fired) = (vec![0.0; COUNT], vec![0.0; COUNT], [[false; COUNT]; 2]);
        let [one, other] = &mut fired;
        navigator::evaluate_columns(&target, &gate, &obstacle, &left, &right, &mut steering, one, &mut speed, other);
        steering.iter().zip(&speed).fold(0, |sum, (steering, speed)| steered(sum, [*steering, *speed]))
    };
    let runs: [Run<'_, _>; 2] = [("columns", &in_columns), ("rows", &|inputs| driven(inputs, emitted_course))];
    measure("navigator, many readings", &courses, &runs, time);
}

/// Readings that lead through all modes: mostly quiet, with collisions, some of them heavy, and turns that end.
fn manipulation_ticks() -> Vec<manipulation::Inputs> {
    let mut seed = 2;
    let reading = |index: usize| {
        let contact_force = if index % 60 < 50 { 5.0 } else { draw(&mut seed, 60.0, 260.0) };
        manipulation::Inputs {
            left_wheel_acceleration: draw(&mut seed, -0.3, 0.3),
            right_wheel_acceleration: draw(&mut seed, -0.3, 0.3),
            contact_force,
            failed: manipulation::Failed {
                contact_force: next_random(&mut seed).is_multiple_of(100),
                ..manipulation::Failed::default()
            },
            done: next_random(&mut seed).is_multiple_of(20),
        }
    };
    (0..COUNT).map(reading).collect()
}

const SEED: u64 = 7;

#[inline(never)]
fn manipulation_emitted(ticks: &[manipulation::Inputs]) -> u64 {
    let (mut machine, mut robot) = (manipulation::Machine::new(SEED), Commands(0));
    let Ok(_) = machine.step(&ticks[0], 0, &mut robot);
    for tick in ticks {
        let Ok(_) = machine.step(tick, u64::from(TICK), &mut robot);
    }
    robot.0
}

#[inline(never)]
fn manipulation_by_hand(ticks: &[manipulation::Inputs]) -> u64 {
    let mut robot = Commands(0);
    let mut machine = by_hand::Manipulation::new(SEED, &mut robot);
    for tick in ticks {
        machine.step(tick, &mut robot);
    }
    robot.0
}

fn machines(program: &Analysis, time: Duration) {
    let (id, diagram) =
        program.program.diagrams.iter().find(|(_, diagram)| diagram.symbol.name == "obstacle_manipulation").unwrap();
    let plan = plan::build_on(program.checked().unwrap(), id, diagram.platform, &[]);
    let interpreted = |ticks: &[manipulation::Inputs]| {
        let (mut machine, mut told) = (Machine::new(&plan, SEED), Told { plan: &plan, robot: Commands(0) });
        let mut tick = |inputs: &manipulation::Inputs, dt: u32| {
            let manipulation::Failed { left_wheel_acceleration, right_wheel_acceleration, contact_force } =
                inputs.failed;
            let readings = [
                (inputs.left_wheel_acceleration, left_wheel_acceleration),
                (inputs.right_wheel_acceleration, right_wheel_acceleration),
                (inputs.contact_force, contact_force),
            ];
            let readings = readings.map(|(value, failed)| Reading { value, healthy: !failed });
            machine.step(Inputs { readings: &readings, done: inputs.done }, u64::from(dt), &mut told);
        };
        tick(&ticks[0], 0);
        for inputs in ticks {
            tick(inputs, TICK);
        }
        told.robot.0
    };
    let runs: [Run<'_, _>; 3] =
        [("emitted", &manipulation_emitted), ("by hand", &manipulation_by_hand), ("interpreter", &interpreted)];
    measure("obstacle_manipulation", &manipulation_ticks(), &runs, time);
}

/// Readings that never end the way ahead, or such that lead through all modes.
fn switching_ticks(is_busy: bool) -> Vec<switching::Inputs> {
    let mut seed = 3;
    let reading = |index: usize| switching::Inputs {
        force: draw(&mut seed, 0.0, if is_busy && index % 40 < 4 { 260.0 } else { 50.0 }),
        failed: switching::Failed { force: is_busy && next_random(&mut seed).is_multiple_of(100) },
        done: next_random(&mut seed).is_multiple_of(4),
    };
    (0..COUNT).map(reading).collect()
}

#[inline(never)]
fn switching_emitted(ticks: &[switching::Inputs]) -> u64 {
    let (mut machine, mut robot) = (switching::Machine::new(), Commands(0));
    let Ok(_) = machine.step(&ticks[0], 0, &mut robot);
    for tick in ticks {
        let Ok(_) = machine.step(tick, u64::from(TICK), &mut robot);
    }
    robot.0
}

#[inline(never)]
fn switching_by_hand(ticks: &[switching::Inputs]) -> u64 {
    let mut robot = Commands(0);
    let mut machine = by_hand::Switching::new(&mut robot);
    for tick in ticks {
        machine.step(tick, &mut robot);
    }
    robot.0
}

#[inline(never)]
fn switching_by_statig(ticks: &[switching::Inputs]) -> u64 {
    let mut robot = Commands(0);
    let mut machine = by_statig::Switching.uninitialized_state_machine().init_with_context(&mut robot);
    for tick in ticks {
        machine.handle_with_context(tick, &mut robot);
    }
    robot.0
}

#[inline(never)]
fn switching_by_smlang(ticks: &[switching::Inputs]) -> u64 {
    let mut robot = Commands(0);
    robot.halt();
    let mut machine = by_smlang::StateMachine::new(by_smlang::Context { robot: &mut robot, elapsed: 0 });
    for tick in ticks {
        let elapsed = &mut machine.context_mut().elapsed;
        *elapsed = elapsed.saturating_add(TICK);
        machine.process_event(by_smlang::Events::Tick(tick)).unwrap();
    }
    robot.0
}

/// The library alone.
struct Library;

impl Files for Library {
    fn read(&self, _path: &str) -> Result<String, FileError> {
        Ok("import std.behaviors.obstacle_manipulation\nimport std.networks.navigator\n".to_owned())
    }
}

fn main() {
    // Only a turn each, to see that they agree.
    let is_test = std::env::args().any(|argument| argument == "--test");
    let time = Duration::from_millis(if is_test { 0 } else { 1500 });
    let program = analyze(&Library, &["main.msd".to_owned()], &Options::default());
    networks(&program, time);
    navigators(&program, time);
    sampled(&program, time);
    columns(time);
    machines(&program, time);
    println!("switching has {} bytes of state", size_of::<switching::Machine>());
    let runs: [Run<'_, _>; 4] = [
        ("emitted", &switching_emitted),
        ("by hand", &switching_by_hand),
        ("statig", &switching_by_statig),
        ("smlang", &switching_by_smlang),
    ];
    measure("switching, calm", &switching_ticks(false), &runs, time);
    measure("switching, busy", &switching_ticks(true), &runs, time);
}
