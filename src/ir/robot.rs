//! Interfaces and robots: sensors, actions, bodies.

use super::{Expr, FailReading, Sense, Symbol};
use crate::base::{Exact, Id, Unit};

/// What a behavior may ask of a robot.
#[derive(Debug, Clone)]
pub struct Interface {
    /// Its name.
    pub symbol: Symbol,
    /// What it takes over.
    pub extends: Option<Id<Self>>,
    /// The sensors it promises, those of what it extends first.
    pub sensors: Vec<Id<Sensor>>,
    /// The actions it promises, in the same order.
    pub actions: Vec<Id<Action>>,
}

/// A robot.
#[derive(Debug, Clone)]
pub struct Robot {
    /// Its name.
    pub symbol: Symbol,
    /// The interfaces it keeps, with those that they extend.
    pub provides: Vec<Id<Interface>>,
    /// Its body; a robot without one can be compiled for but not simulated.
    pub body: Option<Body>,
    /// Its sensors in order, those of an array one by one.
    pub sensors: Vec<Id<Sensor>>,
    /// Its logical sensors: those of sensors in order, then contacts of its own conditions.
    pub logical: Vec<Id<Sensor>>,
    /// The networks that the conditions of its contacts look at.
    pub senses: Vec<Sense>,
    /// Its actions in order.
    pub actions: Vec<Id<Action>>,
    /// What carries out the actions that are neither its body's nor others of its own.
    pub drive: Option<Drive>,
}

/// A behavior of the robot itself, which carries out its commands (Sobh §4, fig. 6). It runs beneath whatever else
/// commands the robot, and sees on every tick what it is told.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Drive {
    /// The behavior; `None` where it was broken.
    pub diagram: Option<Id<super::Diagram>>,
    /// The names of its modes: the states of the robot, in the numbers of its sensor `state`.
    pub states: Vec<String>,
    /// The names of the parameters of its commands, each once, as its sensors `command.name` tell them.
    pub parameters: Vec<String>,
}

impl BodyCommandKind {
    /// Whether it is for the body to carry out, and not for its planner.
    pub const fn moves(self) -> bool {
        !matches!(self, Self::Plan | Self::NextWaypoint)
    }
}

impl Action {
    /// Whether it is for the robot's drive to carry out, if the robot has one.
    pub fn is_driven(&self) -> bool {
        self.command.is_none() && self.same_as.is_none()
    }
}

impl Sensor {
    /// Whether it tells of the machine itself, so that it cannot fail.
    pub fn is_inner(&self) -> bool {
        self.source.is_some_and(SensorSource::is_inner)
    }

    /// The sensors that measure what it follows from; `None` for one that measures itself.
    pub fn members(&self) -> Option<&[Id<Self>]> {
        self.group.as_ref().map(|group| &group.of).or(self.kept.as_ref().map(|kept| &kept.of)).map(Vec::as_slice)
    }
}

impl Robot {
    /// Its sensors, logical ones last.
    pub fn all_sensors(&self) -> Vec<Id<Sensor>> {
        [self.sensors.as_slice(), &self.logical].concat()
    }
}

/// A body the simulator knows.
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// Two driven wheels on one axle.
    DifferentialDrive(DifferentialDrive),
    /// Driven wheels and steered ones.
    CarLike(CarLike),
}

impl Body {
    /// kg, above 0.
    pub const fn mass(&self) -> f64 {
        match self {
            Self::DifferentialDrive(body) => body.mass,
            Self::CarLike(body) => body.mass,
        }
    }

    /// m along its heading and across it, above 0.
    pub const fn size(&self) -> [f64; 2] {
        match self {
            Self::DifferentialDrive(body) => [body.length, body.width],
            Self::CarLike(body) => [body.length, body.width],
        }
    }
}

/// The parameters of a differential-drive body, in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct DifferentialDrive {
    /// kg, above 0.
    pub mass: f64,
    /// m along its heading, above 0.
    pub length: f64,
    /// m across its heading, above 0.
    pub width: f64,
    /// m between the wheels, above 0.
    pub track: f64,
    /// Friction coefficient of wheels and of boxes on the floor, above 0.
    pub traction: f64,
    /// s, time constant with which the wheels follow a commanded speed, above 0.
    pub lag: f64,
    /// m/s², the largest acceleration the wheels are driven with, above 0.
    pub acceleration_limit: f64,
    /// s over which the speed lost in an impact is spread, above 0.
    pub impact_time: f64,
    /// m/s², standard deviation of each wheel's acceleration from imperfect tracking, at least 0.
    pub tracking_noise: f64,
}

/// The parameters of a car-like body (Khatoon and Ibraheem 2012, section 2.2), in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct CarLike {
    /// kg, above 0.
    pub mass: f64,
    /// m along its heading, above 0.
    pub length: f64,
    /// m across its heading, above 0.
    pub width: f64,
    /// s in which it turns by the angle it steers by, above 0.
    pub cycle: f64,
    /// m/s, the fastest it drives either way, above 0.
    pub speed_limit: f64,
    /// rad, the farthest it steers to either side, above 0.
    pub steering_limit: f64,
}

/// A sensor of a robot or an interface, or a logical one, which follows from others.
#[derive(Debug, Clone)]
pub struct Sensor {
    /// Its name; that of an array and an index in brackets for an element.
    pub symbol: Symbol,
    /// Whether the robot can do without it.
    pub optional: bool,
    /// The unit of its numbers as written.
    pub unit: Unit,
    /// Whether it tells touch from no touch, as 1 and 0, and nothing else.
    pub is_contact: bool,
    /// What it follows from; `None` for one that measures.
    pub group: Option<Group>,
    /// What it is set by, if it is a contact that follows from a condition.
    pub kept: Option<Kept>,
    /// The readings it can give, in SI: lower end, upper end.
    pub range: (Exact, Exact),
    /// How it fails, the likeliest way first.
    pub fails: Vec<FailReading>,
    /// Where its body provides it.
    pub source: Option<SensorSource>,
    /// Standard deviation of its noise, in SI.
    pub noise: f64,
    /// Accuracy, in SI; 0 if not declared.
    pub accuracy: Exact,
    /// Nanoseconds between readings; 0 for a reading every tick.
    pub period: u64,
    /// rad across the beam of a range sensor; 0 for a line.
    pub beam: f64,
}

/// Several sensors as one (Sobh §3.2).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Group {
    /// How one reading follows from theirs.
    pub how: Grouping,
    /// Sensors that measure, each once.
    pub of: Vec<Id<Sensor>>,
    /// How many readings of each it takes the mean of (Sobh §3.4), in the same order; 1 where the last one is enough.
    pub readings: Vec<u32>,
}

/// A condition as a contact: an intelligent sensor (Sobh §3.2).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Kept {
    /// When it is set: events in it are of [`Robot::senses`], and it looks at one tick only.
    pub condition: Id<Expr>,
    /// The sensors that it looks at, by itself or through networks and groups: sensors that measure, each once.
    pub of: Vec<Id<Sensor>>,
}

/// How one reading follows from several, with numbers of some kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Grouping<N = Exact> {
    /// The smallest; of contacts, whether all are touched.
    Minimum,
    /// The largest; of contacts, whether any is touched.
    Maximum,
    /// The arithmetic mean.
    Mean,
    /// The one in the middle, or halfway between the two in the middle.
    Median,
    /// Of neighboring beams of a ring, the bearing of the widest opening.
    Widest {
        /// The reading from which a beam is open, m.
        beyond: N,
        /// The bearing of the first beam, rad above -π up to π.
        first: N,
        /// Between two beams, rad.
        spacing: N,
    },
}

impl<N> Grouping<N> {
    /// The same with other numbers.
    pub fn map<M>(self, number: impl Fn(N) -> M) -> Grouping<M> {
        match self {
            Self::Minimum => Grouping::Minimum,
            Self::Maximum => Grouping::Maximum,
            Self::Mean => Grouping::Mean,
            Self::Median => Grouping::Median,
            Self::Widest { beyond, first, spacing } => {
                Grouping::Widest { beyond: number(beyond), first: number(first), spacing: number(spacing) }
            }
        }
    }
}

/// The places where a body can be measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SensorSource {
    /// `wheel.left.acceleration`, m/s².
    LeftWheelAcceleration,
    /// `wheel.right.acceleration`, m/s².
    RightWheelAcceleration,
    /// `wheel.left.speed`, m/s.
    LeftWheelSpeed,
    /// `wheel.right.speed`, m/s.
    RightWheelSpeed,
    /// `wedge.force`, N.
    WedgeForce,
    /// `ring.range`, m from the hull to the nearest thing within a beam. The beams of a ring stand evenly around the
    /// robot, counted to the left from just left of its heading; a single one looks ahead.
    Range {
        /// Which beam, from 0.
        beam: u32,
        /// Of how many.
        of: u32,
    },
    /// `bumper.front`, a contact: something touches the front half of the hull.
    FrontBumper,
    /// `bumper.back`, a contact: something touches the back half of the hull.
    BackBumper,
    /// `pose.x`, m.
    X,
    /// `pose.y`, m.
    Y,
    /// `pose.heading`, rad from -π to π, to the left of the x axis.
    Heading,
    /// `planner.distance`, m from the middle of the robot to the temporary goal.
    WaypointDistance,
    /// `planner.bearing`, rad from -π to π, to the left of the robot's heading.
    WaypointBearing,
    /// `goal.distance`, m from the middle of the robot to the world's goal.
    GoalDistance,
    /// `goal.bearing`, rad from -π to π, to the left of the robot's heading.
    GoalBearing,
    /// Of a client: whether its command was executed on the tick before.
    Won,
    /// Of a client: whether another's command was executed instead of its own on the tick before.
    Lost,
    /// The mode of the robot's drive on the tick before, by its number.
    State,
    /// The command that the robot is carrying out, by its number among the robot's actions from 1 on; 0 for none.
    Command,
    /// An argument of that command, by its number in [`Drive::parameters`]; 0 where it has none of that name.
    Argument(u32),
}

impl SensorSource {
    /// Whether it tells of the machine itself, so that nothing can fail.
    pub const fn is_inner(self) -> bool {
        matches!(self, Self::Won | Self::Lost | Self::State | Self::Command | Self::Argument(_))
    }
}

/// An action of a robot or an interface.
#[derive(Debug, Clone)]
pub struct Action {
    /// Its name.
    pub symbol: Symbol,
    /// Its parameters in order.
    pub parameters: Vec<Parameter>,
    /// Whether it reports completion.
    pub reports_done: bool,
    /// How the body keeps it.
    pub command: Option<BodyCommand>,
    /// The action of the same robot that keeps it, with its arguments.
    pub same_as: Option<(Id<Action>, Vec<BodyArgument>)>,
}

/// A parameter of an action.
#[derive(Debug, Clone)]
pub struct Parameter {
    /// Its name.
    pub symbol: Symbol,
    /// Its unit as written.
    pub unit: Unit,
}

/// A command of a body with its arguments.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyCommand {
    /// Which.
    pub kind: BodyCommandKind,
    /// Its arguments in order.
    pub arguments: Vec<BodyArgument>,
}

/// The commands of a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BodyCommandKind {
    /// `body.stop()`
    Stop,
    /// `body.velocity(speed m/s, turn_rate rad/s)`
    Velocity,
    /// `body.arc(speed m/s, radius m)`, to the left for a positive radius
    Arc,
    /// `body.rotate(angle rad)`, to the left for a positive angle; reports completion
    Rotate,
    /// `body.travel(distance m, speed m/s)`, backward for a negative speed; reports completion, but goes on and on for a
    /// distance of 0
    Travel,
    /// `body.steer(speed m/s, angle rad)`, to the left for a positive angle
    Steer,
    /// `planner.plan()`, from where the robot is to its goal
    Plan,
    /// `planner.next()`, the next temporary goal
    NextWaypoint,
}

/// An argument of a body's command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BodyArgument {
    /// The action's parameter at that position.
    Parameter(u32),
    /// The same with the other sign.
    Negated(u32),
    /// A number in SI.
    Constant(f64),
}
