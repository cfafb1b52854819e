//! A run of a scenario: sense, decide, move, on every tick.

use std::fmt;

use nalgebra::Vector2;

use super::differential_drive::{Command, DifferentialDrive};
use super::expect::{Verdict, judge};
use super::geometry::Rectangle;
use super::random::{Purpose, Stream};
use super::record::Recorder;
use super::sensing::Sensing;
use super::world::{World, overlap};
use crate::base::Span;
use crate::interp::{Actuators, Inputs, Machine, Taken};
use crate::ir::{self, BodyArgument, BodyCommand, BodyCommandKind, Placement};
use crate::plan::Plan;
use crate::trace::{Footprint, Trace};

/// The longest step of the physics, ns.
const LONGEST_SUBSTEP: u64 = 1_000_000;

/// What a caller may change about a scenario.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunOptions {
    /// The seed of everything random, instead of the scenario's.
    pub seed: Option<u64>,
    /// Faults in addition to the scenario's; of two faults of one sensor the later one counts, and these come last.
    pub faults: Vec<ir::Fault>,
}

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// What happened.
    pub trace: Trace,
    /// What became of the scenario's expectations, in order.
    pub verdicts: Vec<Verdict>,
}

/// Why a scenario cannot be run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RunError {
    /// Its robot has no body.
    NoBody,
    /// Two things stand in one place at the start.
    Overlap {
        /// The name of one: a box's, or `robot`.
        what: String,
        /// The name of the other: a box's, or `a wall`.
        with: String,
        /// Where the one that is declared later stands.
        span: Span,
    },
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoBody => f.write_str("the robot has no body"),
            Self::Overlap { what, with, .. } => write!(f, "{what} and {with} stand in one place at the start"),
        }
    }
}

impl std::error::Error for RunError {}

/// Runs a scenario by the plan of its diagram on its robot. The run is a function of what it is given: the same seed
/// gives the same run. Linear in the scenario's duration and, where nothing touches, in its boxes and walls.
///
/// # Errors
///
/// [`RunError`] where there is nothing to move, or where things overlap at the start.
pub fn run(program: &ir::Program, plan: &Plan, scenario: &ir::Scenario, options: &RunOptions) -> Result<Run, RunError> {
    let robot = &program.robots[scenario.robot];
    let Some(ir::Body::DifferentialDrive(parameters)) = &robot.body else { return Err(RunError::NoBody) };
    let mut world = build(parameters, scenario)?;
    let seed = options.seed.unwrap_or(scenario.seed);
    let ranges: Vec<(f64, f64)> = plan.inputs.iter().map(|input| (input.low, input.high)).collect();
    let faults = scenario.faults.iter().chain(&options.faults);
    let mut sensing = Sensing::new(program, robot, &ranges, faults, seed);
    let mut machine = Machine::new(plan, Stream::new(seed, Purpose::Machine).seed());
    let commands = robot.actions.iter().map(|&action| program.actions[action].command.as_ref()).collect();
    let body = DifferentialDrive::new(parameters, seed);
    let mut driver = Driver { commands, body, given: false };

    let tick = scenario.tick.max(1);
    let ticks = scenario.duration / tick + 1;
    let substeps = tick.div_ceil(LONGEST_SUBSTEP);
    let bodies = footprints(parameters, scenario);
    let mut recorder = Recorder::new(plan, scenario, bodies, seed, ticks as usize);
    for number in 0..ticks {
        let time = number * tick;
        let dt = if number == 0 { 0 } else { tick };
        let readings = sensing.read(&driver.body, time);
        let dwell = machine.dwell() + dt;
        driver.given = false;
        let taken = machine.step(Inputs { readings, done: driver.body.done() }, dt, &mut driver);
        if taken != Taken::Stayed && !driver.given {
            driver.body.forget_done();
        }
        recorder.tick(time, readings, &machine, taken, dwell, &world);
        if number + 1 < ticks {
            driver.body.advance(&mut world, tick as f64 / 1e9, substeps);
        }
    }
    let (trace, held) = recorder.finish();
    let verdicts = judge(scenario, &trace, &held);
    Ok(Run { trace, verdicts })
}

/// Hands the machine's commands on to the body. A body does what it was last told.
struct Driver<'a> {
    /// How the body keeps each action of the plan.
    commands: Vec<Option<&'a BodyCommand>>,
    body: DifferentialDrive<'a>,
    /// Whether a command was given on this tick.
    given: bool,
}

impl Actuators for Driver<'_> {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        let Some(&Some(BodyCommand { kind, arguments: meant })) = self.commands.get(action as usize) else { return };
        let argument = |position: usize| {
            let value = match meant.get(position) {
                Some(BodyArgument::Constant(value)) => *value,
                Some(BodyArgument::Parameter(parameter)) => arguments.get(*parameter as usize).copied().unwrap_or(0.0),
                None => 0.0,
            };
            if value.is_finite() { value } else { 0.0 }
        };
        let command = match kind {
            BodyCommandKind::Stop => Command::Stop,
            BodyCommandKind::Velocity => Command::Velocity { speed: argument(0), turn_rate: argument(1) },
            BodyCommandKind::Arc => {
                let turn_rate = argument(0) / argument(1);
                // An arc without a radius has no direction to turn to.
                let turn_rate = if turn_rate.is_finite() { turn_rate } else { 0.0 };
                Command::Velocity { speed: argument(0), turn_rate }
            }
            BodyCommandKind::Rotate => Command::Rotate(argument(0)),
        };
        self.body.command(command, start);
        self.given = true;
    }
}

fn footprints(body: &ir::DifferentialDrive, scenario: &ir::Scenario) -> Vec<Footprint> {
    let robot = Footprint { name: "robot".to_owned(), mass: body.mass, length: body.length, width: body.width };
    let boxes = scenario.boxes.iter().map(|one| Footprint {
        name: one.name.clone(),
        mass: one.mass,
        length: one.length,
        width: one.width,
    });
    std::iter::once(robot).chain(boxes).collect()
}

/// The world at the start.
fn build(body: &ir::DifferentialDrive, scenario: &ir::Scenario) -> Result<World, RunError> {
    let (x, y, heading) = match scenario.start {
        Placement::At { x, y, heading } => (x, y, heading),
        Placement::Ahead(_) => (0.0, 0.0, 0.0),
    };
    let robot = Rectangle::new(Vector2::new(x, y), heading, body.length, body.width);
    let mut world = World::new(robot, heading);
    for wall in &scenario.walls {
        for ends in wall.corners.windows(2) {
            let line = Rectangle::line(ends[0].into(), ends[1].into());
            if overlap(&robot, &line).is_some() {
                return Err(collision("robot", "a wall", wall.span));
            }
            world.add_wall(line);
        }
    }
    for (index, one) in scenario.boxes.iter().enumerate() {
        let shape = match one.place {
            Placement::At { x, y, heading } => Rectangle::new(Vector2::new(x, y), heading, one.length, one.width),
            Placement::Ahead(floor) => {
                let distance = robot.half.x + floor + before(&scenario.boxes, index, floor) + one.length / 2.0;
                Rectangle::new(robot.middle() + robot.ahead() * distance, heading, one.length, one.width)
            }
        };
        if overlap(&robot, &shape).is_some() {
            return Err(collision(&one.name, "robot", one.span));
        }
        if let Some((other, _)) =
            scenario.boxes.iter().zip(world.boxes()).find(|(_, other)| overlap(other, &shape).is_some())
        {
            return Err(collision(&one.name, &other.name, one.span));
        }
        if world.walls().iter().any(|wall| overlap(wall, &shape).is_some()) {
            return Err(collision(&one.name, "a wall", one.span));
        }
        world.add_box(shape, one.mass);
    }
    Ok(world)
}

/// The lengths of the boxes ahead of the robot that stand before a box behind `floor` metres of free floor, m. At
/// equal distances the box that is declared first stands first.
fn before(boxes: &[ir::BoxBody], index: usize, floor: f64) -> f64 {
    let stands_before = |other: usize, distance: f64| distance < floor || (distance == floor && other < index);
    let lengths = boxes.iter().enumerate().filter_map(|(other, one)| match one.place {
        Placement::Ahead(distance) if stands_before(other, distance) => Some(one.length),
        Placement::Ahead(_) | Placement::At { .. } => None,
    });
    lengths.sum()
}

fn collision(what: &str, with: &str, span: Span) -> RunError {
    RunError::Overlap { what: what.to_owned(), with: with.to_owned(), span }
}

#[cfg(test)]
mod tests {
    use super::super::fixture::{J5, MODES, manipulation, plan, program};
    use super::*;
    use crate::trace::Signal;

    fn values(trace: &Trace, signal: Signal) -> &[f64] {
        &trace.column(signal).unwrap().values
    }

    /// When a mode was entered first, s.
    fn entered(trace: &Trace, mode: &str) -> f64 {
        let mode = MODES.iter().position(|name| *name == mode).unwrap() as u32;
        trace.changes.iter().find(|change| change.to == mode).unwrap().time as f64 / 1e9
    }

    #[test]
    fn manipulation_runs_as_in_the_paper() {
        let quiet = ir::DifferentialDrive { tracking_noise: 0.0, ..J5 };
        let trace = run(&program(quiet), &plan(), &manipulation(), &RunOptions::default()).unwrap().trace;
        let went: Vec<&str> = trace.changes.iter().map(|change| MODES[change.to as usize]).collect();
        assert_eq!(went, MODES);
        // 2 s of waiting, 0.75 m at 0.26 m/s, the lag, and at most two ticks until it is read and acted on.
        let first = 2.0 + 0.75 / 0.26 + J5.lag;
        assert!((first..first + 0.02).contains(&entered(&trace, "push")), "{}", entered(&trace, "push"));
        // The paper's "approximately the 8 second mark".
        assert!((7.5..8.5).contains(&entered(&trace, "stop")), "{}", entered(&trace, "stop"));
        let force = values(&trace, Signal::Reading(2));
        let at = |seconds: f64| (seconds * 100.0) as usize;
        assert_eq!(force[at(4.5)], 0.0);
        // μ m g of 30 kg, then μ M g of the robot.
        assert!((force[at(6.5)] - 117.68).abs() < 0.01, "{}", force[at(6.5)]);
        assert!((force[at(7.75)] - 231.44).abs() < 0.01, "{}", force[at(7.75)]);
        // 0.26 m/s · 30/89 in 0.05 s.
        let spike = values(&trace, Signal::Reading(0))[at(5.0)..at(5.2)].iter().copied().fold(0.0, f64::min);
        assert!((spike + 1.753).abs() < 0.01, "{spike}");
    }
}
