//! How fast emitted code is, beside the same written by hand: `cargo bench --bench emit`.
#![expect(clippy::disallowed_methods, clippy::print_stdout, reason = "ratios are measured by a clock of our own")]

use std::convert::Infallible;
use std::time::Instant;

use divan::{Bencher, black_box};
use lmslc::kernel::{draw, next_random};

mod emitted {
    include!("../tests/emitted/obstacle_manipulation.rs");
}

use emitted::obstacle_id::{self, Inputs};
use emitted::obstacle_manipulation::{self as machine, Failed, Robot};

/// What one writes who knows the network and wants it fast, on the same readings and to the same bits.
mod by_hand {
    use super::{Failed, Infallible, Inputs, Robot, draw, machine};

    fn least(a: f64, b: f64) -> f64 {
        if b < a { b } else { a }
    }

    fn most(a: f64, b: f64) -> f64 {
        if b > a { b } else { a }
    }

    fn unit(x: f64) -> f64 {
        most(0.0, least(1.0, x))
    }

    fn clamp(x: f64, low: f64, high: f64) -> f64 {
        if x.is_finite() { most(least(x, high), low) } else { 0.0 }
    }

    pub struct Events {
        pub forward_collision: bool,
        pub heavy_obstacle: bool,
    }

    pub fn evaluate(inputs: &Inputs) -> Events {
        weigh(clamp(inputs.left, -4.0, 4.0), clamp(inputs.right, -4.0, 4.0), clamp(inputs.force, 0.0, 400.0))
    }

    #[inline]
    pub fn weigh(left: f64, right: f64, force: f64) -> Events {
        let [left_neg, right_neg] = [left, right].map(|x| unit(-x));
        let [left_zero, right_zero] = [left, right].map(|x| most(0.0, least(x + 1.0, 1.0 - x)));
        let [left_pos, right_pos] = [left, right].map(unit);
        let low = unit((force - 80.0) / -60.0);
        let med = most(0.0, least((force - 20.0) / 95.0, (190.0 - force) / 75.0));
        let high = unit((force - 150.0) / 60.0);
        let left_any = most(left_zero, most(left_neg, left_pos));
        let right_any = most(right_zero, most(right_neg, right_pos));
        let any = least(left_any, right_any);
        let heavy = least(any, high);
        let with_med = most(most(least(left_any, right_neg), least(left_zero, right_zero)), least(left_neg, right_any));
        let contributor = most(most(heavy, least(med, with_med)), least(low, least(left_neg, right_neg)));
        let against = most(
            most(least(most(left_neg, left_zero), right_pos), least(left_zero, right_zero)),
            least(left_pos, right_any),
        );
        Events {
            forward_collision: contributor > least(low, against),
            heavy_obstacle: heavy > least(any, most(low, med)),
        }
    }

    #[derive(Clone, Copy)]
    pub enum Mode {
        Init(u32),
        Forward,
        Stop(u32),
        BackUp(u32),
        RandomTurn(f64),
        Push(u32),
    }

    pub struct Machine {
        pub mode: Mode,
        pub random: u64,
    }

    impl Machine {
        pub fn step<R: Robot<Error = Infallible>>(&mut self, inputs: &machine::Inputs, dt_ns: u64, robot: &mut R) {
            let dt = u32::try_from(dt_ns).unwrap_or(u32::MAX);
            match &mut self.mode {
                Mode::Init(elapsed) => {
                    *elapsed = elapsed.saturating_add(dt);
                    if *elapsed >= 2_000_000_000 { self.forward(robot) } else { ok(robot.halt()) }
                }
                Mode::Forward => {
                    let events = sense(inputs);
                    if events.heavy_obstacle || events.forward_collision && inputs.failed.contact_force {
                        self.stop(robot);
                    } else if events.forward_collision {
                        self.mode = Mode::Push(0);
                        ok(robot.arc(0.26, 1.0));
                    } else {
                        ok(robot.drive(0.26));
                    }
                }
                Mode::Stop(elapsed) => {
                    *elapsed = elapsed.saturating_add(dt);
                    if *elapsed >= 500_000_000 {
                        self.mode = Mode::BackUp(0);
                        ok(robot.drive(-0.2));
                    } else {
                        ok(robot.halt());
                    }
                }
                Mode::BackUp(elapsed) => {
                    *elapsed = elapsed.saturating_add(dt);
                    if *elapsed >= 1_500_000_000 {
                        let end = 2.0 * std::f64::consts::PI / 3.0;
                        let angle = draw(&mut self.random, -end, end);
                        self.mode = Mode::RandomTurn(angle);
                        ok(robot.turn(angle, true));
                    } else {
                        ok(robot.drive(-0.2));
                    }
                }
                Mode::RandomTurn(angle) => {
                    if inputs.done {
                        self.forward(robot);
                    } else {
                        ok(robot.turn(*angle, false));
                    }
                }
                Mode::Push(elapsed) => {
                    *elapsed = elapsed.saturating_add(dt);
                    if inputs.failed.contact_force || sense(inputs).heavy_obstacle {
                        self.stop(robot);
                    } else if *elapsed >= 4_000_000_000 {
                        self.forward(robot);
                    } else {
                        ok(robot.arc(0.26, 1.0));
                    }
                }
            }
        }

        fn forward<R: Robot<Error = Infallible>>(&mut self, robot: &mut R) {
            self.mode = Mode::Forward;
            ok(robot.drive(0.26));
        }

        fn stop<R: Robot<Error = Infallible>>(&mut self, robot: &mut R) {
            self.mode = Mode::Stop(0);
            ok(robot.halt());
        }
    }

    fn sense(inputs: &machine::Inputs) -> Events {
        let Failed { left_wheel_acceleration, right_wheel_acceleration, contact_force } = inputs.failed;
        let safe = |x: f64, failed: bool, low, high| if failed { 0.0 } else { clamp(x, low, high) };
        weigh(
            safe(inputs.left_wheel_acceleration, left_wheel_acceleration, -4.0, 4.0),
            safe(inputs.right_wheel_acceleration, right_wheel_acceleration, -4.0, 4.0),
            safe(inputs.contact_force, contact_force, 0.0, 400.0),
        )
    }

    fn ok(result: Result<(), Infallible>) {
        let Ok(()) = result;
    }
}

/// A robot that adds up what it is asked for.
struct Sum(f64);

impl Robot for Sum {
    type Error = Infallible;

    fn halt(&mut self) -> Result<(), Infallible> {
        self.0 += 1.0;
        Ok(())
    }

    fn drive(&mut self, speed: f64) -> Result<(), Infallible> {
        self.0 += speed;
        Ok(())
    }

    fn arc(&mut self, speed: f64, radius: f64) -> Result<(), Infallible> {
        self.0 += speed * radius;
        Ok(())
    }

    fn turn(&mut self, angle: f64, start: bool) -> Result<(), Infallible> {
        self.0 += if start { angle } else { 0.5 * angle };
        Ok(())
    }
}

const COUNT: usize = 4096;

fn readings() -> Vec<Inputs> {
    let mut seed = 1;
    let mut reading = || Inputs {
        left: draw(&mut seed, -1.5, 1.5),
        right: draw(&mut seed, -1.5, 1.5),
        force: draw(&mut seed, 0.0, 250.0),
    };
    (0..COUNT).map(|_| reading()).collect()
}

/// Readings that lead through all modes: mostly quiet, with collisions, some of them heavy, and turns that end.
fn ticks() -> Vec<machine::Inputs> {
    let mut seed = 2;
    let reading = |index: usize| {
        let force = if index % 60 < 50 { 5.0 } else { draw(&mut seed, 60.0, 260.0) };
        machine::Inputs {
            left_wheel_acceleration: draw(&mut seed, -0.3, 0.3),
            right_wheel_acceleration: draw(&mut seed, -0.3, 0.3),
            contact_force: force,
            failed: Failed { contact_force: next_random(&mut seed).is_multiple_of(100), ..Failed::default() },
            done: next_random(&mut seed).is_multiple_of(20),
        }
    };
    (0..COUNT).map(reading).collect()
}

const TICK: u64 = 100_000_000;

#[inline(never)]
fn network_emitted(readings: &[Inputs]) -> u32 {
    let set = |reading: &Inputs| {
        let events = obstacle_id::evaluate(reading);
        u32::from(events.forward_collision) + 2 * u32::from(events.heavy_obstacle)
    };
    readings.iter().map(set).fold(0, |sum, set| sum * 3 % 1_000_003 + set)
}

#[inline(never)]
fn network_by_hand(readings: &[Inputs]) -> u32 {
    let set = |reading: &Inputs| {
        let events = by_hand::evaluate(reading);
        u32::from(events.forward_collision) + 2 * u32::from(events.heavy_obstacle)
    };
    readings.iter().map(set).fold(0, |sum, set| sum * 3 % 1_000_003 + set)
}

#[inline(never)]
fn machine_emitted(ticks: &[machine::Inputs]) -> f64 {
    let state = Some(machine::State::Init { elapsed: 0 });
    let (mut machine, mut robot) = (machine::Machine { state, random: 7 }, Sum(0.0));
    for tick in ticks {
        let Ok(_) = machine.step(tick, TICK, &mut robot);
    }
    robot.0
}

#[inline(never)]
fn machine_by_hand(ticks: &[machine::Inputs]) -> f64 {
    let (mut machine, mut robot) = (by_hand::Machine { mode: by_hand::Mode::Init(0), random: 7 }, Sum(0.0));
    for tick in ticks {
        machine.step(tick, TICK, &mut robot);
    }
    robot.0
}

#[divan::bench]
fn obstacle_id_emitted(bencher: Bencher<'_, '_>) {
    let readings = readings();
    bencher.counter(COUNT).bench(|| network_emitted(black_box(&readings)));
}

#[divan::bench]
fn obstacle_id_by_hand(bencher: Bencher<'_, '_>) {
    let readings = readings();
    bencher.counter(COUNT).bench(|| network_by_hand(black_box(&readings)));
}

#[divan::bench]
fn manipulation_emitted(bencher: Bencher<'_, '_>) {
    let ticks = ticks();
    bencher.counter(COUNT).bench(|| machine_emitted(black_box(&ticks)));
}

#[divan::bench]
fn manipulation_by_hand(bencher: Bencher<'_, '_>) {
    let ticks = ticks();
    bencher.counter(COUNT).bench(|| machine_by_hand(black_box(&ticks)));
}

/// The fastest of many turns each, taken alternately: nanoseconds for one of `COUNT`.
fn fastest<I: ?Sized, T>(input: &I, one: fn(&I) -> T, other: fn(&I) -> T) -> [f64; 2] {
    let mut best = [f64::INFINITY; 2];
    for _ in 0..2_000 {
        for (best, run) in best.iter_mut().zip([one, other]) {
            let start = Instant::now();
            black_box(run(black_box(input)));
            *best = best.min(start.elapsed().as_secs_f64() * 1e9 / COUNT as f64);
        }
    }
    best
}

fn main() {
    let (readings, ticks) = (readings(), ticks());
    assert_eq!(network_emitted(&readings), network_by_hand(&readings), "both see the same events");
    assert_eq!(machine_emitted(&ticks).to_bits(), machine_by_hand(&ticks).to_bits(), "both give the same commands");
    divan::main();
    if std::env::args().any(|argument| argument == "--bench") {
        let figures = [
            ("obstacle_id", fastest(readings.as_slice(), network_emitted, network_by_hand)),
            ("obstacle_manipulation", fastest(ticks.as_slice(), machine_emitted, machine_by_hand)),
        ];
        for (name, [emitted, by_hand]) in figures {
            let ratio = emitted / by_hand;
            println!("{name}: emitted {emitted:.2} ns, by hand {by_hand:.2} ns, ratio {ratio:.3}");
        }
    }
}
