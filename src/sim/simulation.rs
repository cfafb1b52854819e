//! A robot in its world: what it senses, what it is told, and how it moves.

use nalgebra::Vector2;

use super::body::{Body, Command};
use super::drive::argument_of;
use super::geometry::Rectangle;
use super::planner::Request;
use super::run::RunError;
use super::sensing::Sensing;
use super::walls::Walls;
use super::world::{World, overlap};
use crate::base::Span;
use crate::interp::{Actuators, Reading};
use crate::ir::{self, BodyArgument, BodyCommand, BodyCommandKind, Placement};

/// The longest step of the physics, ns.
const LONGEST_SUBSTEP: u64 = 1_000_000;

/// A robot in the world of a scenario, moved tick by tick.
#[derive(Debug)]
pub struct Simulation<'a> {
    pub(super) world: World,
    pub(super) sensing: Sensing<'a>,
    pub(super) driver: Driver<'a>,
}

impl<'a> Simulation<'a> {
    /// The start of a scenario, with these faults. Everything random follows from the seed.
    ///
    /// # Errors
    ///
    /// [`RunError`] where there is nothing to move, or where things overlap.
    pub fn new<'f>(
        program: &'a ir::Program,
        scenario: &ir::Scenario,
        faults: impl Iterator<Item = &'f ir::Fault>,
        seed: u64,
    ) -> Result<Self, RunError> {
        let robot = &program.robots[scenario.robot];
        let parameters = robot.body.as_ref().ok_or(RunError::NoBody)?;
        let world = build(parameters, scenario)?;
        let sensing = Sensing::new(program, scenario, &world, faults, seed);
        let commands = robot.actions.iter().map(|&action| program.actions[action].command.as_ref()).collect();
        let driver = Driver { commands, body: Body::new(parameters, seed), given: false, asked: Vec::new() };
        Ok(Self { world, sensing, driver })
    }

    /// Reads the robot's sensors at `time`, in nanoseconds that never go back.
    pub fn read(&mut self, time: u64) -> &[Reading] {
        self.sensing.read(&self.driver.body, &self.world, time)
    }

    /// Tells the robot to do its action of that number with arguments in SI, until it is told otherwise. `start` begins
    /// anew what is under way.
    pub fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        self.driver.command(action, arguments, start);
    }

    /// Whether the last command has been completed.
    pub fn done(&self) -> bool {
        self.driver.body.done()
    }

    /// Moves on by one tick, in nanoseconds above 0.
    pub fn advance(&mut self, tick: u64) {
        for request in self.driver.asked.drain(..) {
            self.sensing.plan(request, &self.world);
        }
        let substeps = tick.div_ceil(LONGEST_SUBSTEP);
        self.driver.body.advance(&mut self.world, tick as f64 / 1e9, substeps);
    }

    /// Where the robot is, and then each box: x and y in m, heading in rad; the robot's is counted on over full turns.
    pub fn poses(&self) -> impl Iterator<Item = [f64; 3]> {
        let pose = |middle: Vector2<f64>, heading| [middle.x, middle.y, heading];
        let boxes = self.world.boxes().map(move |shape| pose(shape.middle(), shape.pose.rotation.angle()));
        std::iter::once(pose(self.world.robot().middle(), self.world.heading())).chain(boxes)
    }
}

/// Hands the machine's commands on to the body. A body does what it was last told.
#[derive(Debug)]
pub(super) struct Driver<'a> {
    /// How the body keeps each action of the plan.
    commands: Vec<Option<&'a BodyCommand>>,
    pub(super) body: Body<'a>,
    /// Whether a command was given on this tick.
    pub(super) given: bool,
    /// What the planner has yet to do.
    asked: Vec<Request>,
}

const fn request(kind: BodyCommandKind) -> Option<Request> {
    match kind {
        BodyCommandKind::Plan => Some(Request::Plan),
        BodyCommandKind::NextWaypoint => Some(Request::Next),
        _ => None,
    }
}

impl Actuators for Driver<'_> {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        let Some(&Some(BodyCommand { kind, arguments: meant })) = self.commands.get(action as usize) else { return };
        let argument = |position: usize| {
            meant.get(position).map_or(0.0, |argument: &BodyArgument| argument_of(*argument, arguments))
        };
        // The planner is asked once, not on every tick of a mode.
        if let (Some(request), true) = (request(*kind), start) {
            self.asked.push(request);
        }
        let command = match kind {
            BodyCommandKind::Plan | BodyCommandKind::NextWaypoint => return,
            BodyCommandKind::Stop => Command::Stop,
            BodyCommandKind::Velocity => Command::Velocity { speed: argument(0), turn_rate: argument(1) },
            BodyCommandKind::Arc => {
                let turn_rate = argument(0) / argument(1);
                // An arc without a radius has no direction to turn to.
                let turn_rate = if turn_rate.is_finite() { turn_rate } else { 0.0 };
                Command::Velocity { speed: argument(0), turn_rate }
            }
            BodyCommandKind::Rotate => Command::Rotate(argument(0)),
            BodyCommandKind::Travel => {
                let (distance, speed) = (argument(0), argument(1));
                Command::Travel { distance: distance.abs(), speed: if distance < 0.0 { -speed } else { speed } }
            }
            BodyCommandKind::Steer => Command::Steer { speed: argument(0), angle: argument(1) },
        };
        self.body.command(command, start);
        self.given = true;
    }
}

/// The world at the start.
pub(super) fn build(body: &ir::Body, scenario: &ir::Scenario) -> Result<World, RunError> {
    let (x, y, heading) = match scenario.start {
        Placement::At { x, y, heading } => (x, y, heading),
        Placement::Ahead(_) => (0.0, 0.0, 0.0),
    };
    let [length, width] = body.size();
    let robot = Rectangle::new(Vector2::new(x, y), heading, length, width);
    let pieces = |wall: &ir::Wall| -> Vec<[Vector2<f64>; 2]> {
        wall.corners.windows(2).map(|ends| [ends[0].into(), ends[1].into()]).collect()
    };
    for wall in &scenario.walls {
        if pieces(wall).iter().any(|[from, to]| overlap(&robot, &Rectangle::line(*from, *to)).is_some()) {
            return Err(collision("robot", "a wall", wall.span));
        }
    }
    let mut world = World::new(robot, heading, Walls::new(scenario.walls.iter().flat_map(pieces)));
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
        if world.walls().lines().iter().any(|wall| overlap(wall, &shape).is_some()) {
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
    use super::*;
    use crate::sim::fixture::{J5, cargo, scenario};

    #[test]
    fn boxes_ahead_stand_behind_as_much_free_floor() {
        let boxes = vec![
            cargo("far", 90.0, Placement::Ahead(1.5)),
            cargo("near", 30.0, Placement::Ahead(0.75)),
            cargo("same", 30.0, Placement::Ahead(1.5)),
        ];
        let quarter = std::f64::consts::FRAC_PI_2;
        let start = Placement::At { x: 1.0, y: 2.0, heading: quarter };
        let world = build(&ir::Body::DifferentialDrive(J5), &ir::Scenario { start, boxes, ..scenario() }).unwrap();
        // The front is at y = 2.5; boxes are 0.4 m long.
        let expected = [2.5 + 1.5 + 0.4 + 0.2, 2.5 + 0.75 + 0.2, 2.5 + 1.5 + 0.8 + 0.2];
        for (shape, y) in world.boxes().zip(expected) {
            assert!((shape.middle() - Vector2::new(1.0, y)).norm() < 1e-12, "{}", shape.middle());
            assert!((shape.pose.rotation.angle() - quarter).abs() < 1e-12);
        }
    }
}
