//! What tries a behavior: worlds, scenarios with their faults and expectations, and properties.

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
    /// Whether it is a door that is shut.
    pub is_door: bool,
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
    /// What is expected, in order; then the properties of the diagram that its file declares or imports.
    pub expectations: Vec<Expectation>,
}

impl Scenario {
    /// Nanoseconds between ticks where a scenario does not say.
    pub const DEFAULT_TICK: u64 = 10_000_000;
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
    /// As written, without `expect`, on one line; a property with `property` and its name.
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
    /// The run keeps what a property claims of all.
    Claim(Claim),
}

/// A claim over all runs of a diagram.
#[derive(Debug, Clone)]
pub struct Property {
    /// Its name.
    pub symbol: Symbol,
    /// The diagram it speaks of.
    pub diagram: Id<Diagram>,
    /// What it claims.
    pub claim: Claim,
    /// The claim as written, on one line.
    pub text: String,
    /// The whole declaration.
    pub span: Span,
}

/// What a property claims. Its conditions are those of the end of a tick, as in expectations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Claim {
    /// The condition holds on no tick.
    Never(Id<Expr>),
    /// The condition holds on every tick.
    Always(Id<Expr>),
    /// Every cause is answered by its effect in time.
    LeadsTo(Response),
}

impl Claim {
    /// What it looks at, in order.
    pub fn conditions(self) -> Vec<Id<Expr>> {
        match self {
            Self::Never(condition) | Self::Always(condition) => vec![condition],
            Self::LeadsTo(response) => vec![response.cause, response.effect],
        }
    }
}

/// Each tick on which the cause holds is followed by one on which the effect does, at the latest by the first on which
/// at least `within` has passed: as for `after`, time is seen to have passed on a tick.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Response {
    /// What asks for the effect.
    pub cause: Id<Expr>,
    /// What answers it; on the same tick already, if it holds then.
    pub effect: Id<Expr>,
    /// Nanoseconds, above 0.
    pub within: u64,
}
