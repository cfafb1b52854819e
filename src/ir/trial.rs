//! What tries a behavior: worlds, and scenarios with their faults and expectations.

use super::{Diagram, Expr, Mode, Robot, Sensor, Symbol};
use crate::base::{Id, Span};

/// A place shared by scenarios.
#[derive(Debug, Clone, Default)]
pub struct World {
    /// Its name.
    pub symbol: Symbol,
    /// Its walls.
    pub walls: Vec<Wall>,
    /// The boxes that stand in it.
    pub boxes: Vec<BoxBody>,
    /// Where its goal is, m.
    pub goal: Option<[f64; 2]>,
}

/// A wall: a line through corners, without thickness, that nothing passes.
#[derive(Debug, Clone, PartialEq)]
pub struct Wall {
    /// Its corners in m, at least two.
    pub corners: Vec<[f64; 2]>,
    /// Where it is declared.
    pub span: Span,
}

/// A box that can be pushed, in SI.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxBody {
    /// Its name, or `box1`, `box2`, ... in order.
    pub name: String,
    /// kg, above 0.
    pub mass: f64,
    /// m along its heading, above 0.
    pub length: f64,
    /// m across its heading, above 0.
    pub width: f64,
    /// Where it starts.
    pub place: Placement,
    /// Where it is declared.
    pub span: Span,
}

/// Where something starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Placement {
    /// In the world.
    At {
        /// m
        x: f64,
        /// m
        y: f64,
        /// rad, counterclockwise from the x axis.
        heading: f64,
    },
    /// Straight ahead of the robot, aligned with it, behind this much free floor (m): the distance from the robot's
    /// front to the near face, not counting the length of boxes placed ahead of it before.
    Ahead(f64),
}

/// A run of one diagram on one robot, with what is expected of it. What it extends has been taken over.
#[derive(Debug, Clone)]
pub struct Scenario {
    /// Its name.
    pub symbol: Symbol,
    /// What is run.
    pub diagram: Id<Diagram>,
    /// The robot it runs on.
    pub robot: Id<Robot>,
    /// Nanoseconds from the first tick to the last.
    pub duration: u64,
    /// Nanoseconds between ticks, above 0.
    pub tick: u64,
    /// The seed of everything random.
    pub seed: u64,
    /// Where the robot starts.
    pub start: Placement,
    /// The walls of its world.
    pub walls: Vec<Wall>,
    /// The boxes of its world and its own, in order.
    pub boxes: Vec<BoxBody>,
    /// The goal of its world, m.
    pub goal: Option<[f64; 2]>,
    /// What goes wrong, in order; of two faults of one sensor the later one counts.
    pub faults: Vec<Fault>,
    /// What is expected, in order.
    pub expectations: Vec<Expectation>,
}

/// A sensor that goes wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct Fault {
    /// Which, of the scenario's robot.
    pub sensor: Id<Sensor>,
    /// What it reads.
    pub reading: FaultReading,
    /// When, in nanoseconds of the run.
    pub window: Window,
    /// Where it stands; nowhere for one that was asked for beside the scenario.
    pub span: Span,
}

/// What a faulty sensor reads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum FaultReading {
    /// Silently this, in SI.
    Stuck(f64),
    /// Silently some constant in range, drawn from the seed.
    StuckSomewhere,
    /// It is reported as failed.
    Reported,
}

/// A closed span of a run, in nanoseconds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Window {
    /// The first instant.
    pub from: u64,
    /// The last instant.
    pub to: u64,
}

impl Window {
    /// The whole run.
    pub const WHOLE: Self = Self { from: 0, to: u64::MAX };

    /// Whether an instant lies in it.
    pub const fn contains(self, time: u64) -> bool {
        self.from <= time && time <= self.to
    }
}

/// What a scenario expects.
#[derive(Debug, Clone, PartialEq)]
pub struct Expectation {
    /// As written, without `expect`, on one line.
    pub text: String,
    /// What it means.
    pub kind: ExpectationKind,
    /// Where it stands.
    pub span: Span,
}

/// The meanings of an expectation.
#[derive(Debug, Clone, PartialEq)]
pub enum ExpectationKind {
    /// The run goes through these modes first, in this order; more may follow.
    Modes(Vec<Id<Mode>>),
    /// The transition is taken within the window.
    Transition {
        /// The mode that is left.
        from: Id<Mode>,
        /// The mode that is entered.
        to: Id<Mode>,
        /// When.
        window: Window,
    },
    /// The condition holds on some tick of the window.
    Within(Id<Expr>, Window),
    /// The condition holds on no tick of the window.
    Never(Id<Expr>, Window),
    /// The condition holds on every tick of the window.
    Always(Id<Expr>, Window),
}
