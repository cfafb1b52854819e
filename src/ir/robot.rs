//! Interfaces and robots: sensors, actions, bodies.

use super::{FailReading, Symbol};
use crate::base::{Exact, Id, Unit};

/// What a behavior may ask of a robot.
#[derive(Debug, Clone)]
pub struct Interface {
    /// Its name.
    pub symbol: Symbol,
    /// The sensors it promises.
    pub sensors: Vec<Id<Sensor>>,
    /// The actions it promises.
    pub actions: Vec<Id<Action>>,
}

/// A robot.
#[derive(Debug, Clone)]
pub struct Robot {
    /// Its name.
    pub symbol: Symbol,
    /// The interfaces it keeps.
    pub provides: Vec<Id<Interface>>,
    /// Its body; a robot without one can be compiled for but not simulated.
    pub body: Option<Body>,
    /// Its sensors in order.
    pub sensors: Vec<Id<Sensor>>,
    /// Its actions in order.
    pub actions: Vec<Id<Action>>,
}

/// A body the simulator knows.
#[derive(Debug, Clone, PartialEq)]
pub enum Body {
    /// Two driven wheels on one axle.
    DifferentialDrive(DifferentialDrive),
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

/// A sensor of a robot or an interface.
#[derive(Debug, Clone)]
pub struct Sensor {
    /// Its name.
    pub symbol: Symbol,
    /// Whether the robot can do without it.
    pub optional: bool,
    /// The unit of its numbers as written.
    pub unit: Unit,
    /// The readings it can give, in SI: lower end, upper end.
    pub range: (Exact, Exact),
    /// How it fails, the likeliest way first.
    pub fails: Vec<FailReading>,
    /// Where its body provides it.
    pub source: Option<SensorSource>,
    /// Standard deviation of its noise, in SI.
    pub noise: f64,
    /// Accuracy, in SI; 0 if not declared.
    pub accuracy: f64,
    /// Nanoseconds between readings; 0 for a reading every tick.
    pub period: u64,
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
}

/// An argument of a body's command.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum BodyArgument {
    /// The action's parameter at that position.
    Parameter(u32),
    /// A number in SI.
    Constant(f64),
}
