//! What one writes who knows the network and the machine and wants them fast, on the same readings and to the same bits.

use crate::manipulation::{self, Failed};
use crate::obstacle_id::Inputs;
use crate::switching;
use crate::{Commands, TICK, TURN};
use lmslc::kernel::draw;

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

/// The events of `obstacle_id`: whether something was hit, and whether it is heavy.
#[inline]
pub fn obstacle_id(inputs: &Inputs) -> [bool; 2] {
    weigh(clamp(inputs.left, -4.0, 4.0), clamp(inputs.right, -4.0, 4.0), clamp(inputs.force, 0.0, 400.0))
}

#[inline]
fn weigh(left: f64, right: f64, force: f64) -> [bool; 2] {
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
    [contributor > least(low, against), heavy > least(any, most(low, med))]
}

fn sense(inputs: &manipulation::Inputs) -> [bool; 2] {
    let Failed { left_wheel_acceleration, right_wheel_acceleration, contact_force } = inputs.failed;
    let safe = |x: f64, failed: bool, low, high| if failed { 0.0 } else { clamp(x, low, high) };
    weigh(
        safe(inputs.left_wheel_acceleration, left_wheel_acceleration, -4.0, 4.0),
        safe(inputs.right_wheel_acceleration, right_wheel_acceleration, -4.0, 4.0),
        safe(inputs.contact_force, contact_force, 0.0, 400.0),
    )
}

/// A mode with what it remembers: nanoseconds, or the angle of a turn.
#[derive(Clone, Copy)]
enum Mode<Angle> {
    Init(u32),
    Forward,
    Stop(u32),
    BackUp(u32),
    Turn(Angle),
    Push(u32),
}

/// `obstacle_manipulation`
pub struct Manipulation {
    mode: Mode<f64>,
    random: u64,
}

impl Manipulation {
    pub fn new(seed: u64, robot: &mut Commands) -> Self {
        robot.halt();
        Self { mode: Mode::Init(0), random: seed }
    }

    pub fn step(&mut self, inputs: &manipulation::Inputs, robot: &mut Commands) {
        match &mut self.mode {
            Mode::Init(elapsed) => {
                *elapsed = elapsed.saturating_add(TICK);
                if *elapsed >= 2_000_000_000 { self.forward(robot) } else { robot.halt() }
            }
            Mode::Forward => {
                let [hit, heavy] = sense(inputs);
                if heavy || hit && inputs.failed.contact_force {
                    self.stop(robot);
                } else if hit {
                    self.mode = Mode::Push(0);
                    robot.arc(0.26, 1.0);
                } else {
                    robot.drive(0.26);
                }
            }
            Mode::Stop(elapsed) => {
                *elapsed = elapsed.saturating_add(TICK);
                if *elapsed >= 500_000_000 {
                    self.mode = Mode::BackUp(0);
                    robot.drive(-0.2);
                } else {
                    robot.halt();
                }
            }
            Mode::BackUp(elapsed) => {
                *elapsed = elapsed.saturating_add(TICK);
                if *elapsed >= 1_500_000_000 {
                    let angle = draw(&mut self.random, -TURN, TURN);
                    self.mode = Mode::Turn(angle);
                    robot.turn(angle, true);
                } else {
                    robot.drive(-0.2);
                }
            }
            Mode::Turn(angle) => {
                if inputs.done {
                    self.forward(robot);
                } else {
                    robot.turn(*angle, false);
                }
            }
            Mode::Push(elapsed) => {
                *elapsed = elapsed.saturating_add(TICK);
                if inputs.failed.contact_force || sense(inputs)[1] {
                    self.stop(robot);
                } else if *elapsed >= 4_000_000_000 {
                    self.forward(robot);
                } else {
                    robot.arc(0.26, 1.0);
                }
            }
        }
    }

    fn forward(&mut self, robot: &mut Commands) {
        self.mode = Mode::Forward;
        robot.drive(0.26);
    }

    fn stop(&mut self, robot: &mut Commands) {
        self.mode = Mode::Stop(0);
        robot.halt();
    }
}

/// `switching`
pub struct Switching(Mode<()>);

/// Whether a reading that counts is above a threshold: those that are not finite do not.
#[inline]
pub fn above(inputs: &switching::Inputs, threshold: f64) -> bool {
    !inputs.failed.force && inputs.force > threshold && inputs.force < f64::INFINITY
}

impl Switching {
    pub fn new(robot: &mut Commands) -> Self {
        robot.halt();
        Self(Mode::Init(0))
    }

    pub fn step(&mut self, inputs: &switching::Inputs, robot: &mut Commands) {
        match &mut self.0 {
            Mode::Init(elapsed) => {
                *elapsed = elapsed.saturating_add(TICK);
                if *elapsed >= 2_000_000_000 { self.forward(robot) } else { robot.halt() }
            }
            Mode::Forward => {
                if above(inputs, 150.0) {
                    self.stop(robot);
                } else if above(inputs, 60.0) {
                    self.0 = Mode::Push(0);
                    robot.arc(0.26, 1.0);
                } else {
                    robot.drive(0.26);
                }
            }
            Mode::Stop(elapsed) => {
                *elapsed = elapsed.saturating_add(TICK);
                if *elapsed >= 500_000_000 {
                    self.0 = Mode::BackUp(0);
                    robot.drive(-0.2);
                } else {
                    robot.halt();
                }
            }
            Mode::BackUp(elapsed) => {
                *elapsed = elapsed.saturating_add(TICK);
                if *elapsed >= 1_500_000_000 {
                    self.0 = Mode::Turn(());
                    robot.turn(TURN, true);
                } else {
                    robot.drive(-0.2);
                }
            }
            Mode::Turn(()) => {
                if inputs.done {
                    self.forward(robot);
                } else {
                    robot.turn(TURN, false);
                }
            }
            Mode::Push(elapsed) => {
                *elapsed = elapsed.saturating_add(TICK);
                if inputs.failed.force || above(inputs, 150.0) {
                    self.stop(robot);
                } else if *elapsed >= 4_000_000_000 {
                    self.forward(robot);
                } else {
                    robot.arc(0.26, 1.0);
                }
            }
        }
    }

    fn forward(&mut self, robot: &mut Commands) {
        self.0 = Mode::Forward;
        robot.drive(0.26);
    }

    fn stop(&mut self, robot: &mut Commands) {
        self.0 = Mode::Stop(0);
        robot.halt();
    }
}
