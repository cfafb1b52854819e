//! The syntax tree: a file as it was written, in source order, with a span on every node.
//!
//! The tree holds the whole language of both file kinds. Broken parts are `Error` items; everything around them is kept.

mod coordination;
mod diagram;
mod expression;
mod fusion;
mod robot;
mod trial;

pub use coordination::{Arbiter, ArbiterItem, Client, ClientPriority, Team, TeamItem};
pub use diagram::{
    Child, Decide, DecideRow, Diagram, DiagramItem, Flag, Layer, Mode, ModeItem, Sense, Target, Transition,
};
pub use expression::{Argument, Call, CompareOp, Expr, ExprKind, Factor, IndexRange, Sign};
pub use fusion::{
    Cell, CellKind, Consequent, ConsequentValue, Event, EventRule, EventSide, FailReading, Network, NetworkInput,
    NetworkItem, Output, OutputBody, OutputDefault, OutputRule, Row, Setting, SettingValue, Shape, ShapeKind, SideKind,
    Term, Variable,
};
pub use robot::{
    Action, ActionParameter, Body, BodyParameter, Interface, Logical, Robot, RobotItem, Sensor, SensorClause,
    SensorKind,
};
pub use trial::{
    BoxItem, Expect, ExpectKind, ExpectWindow, FaultWindow, PlaceAt, Point, Property, PropertyKind, Scenario,
    ScenarioItem, SensorRef, World, WorldItem,
};

use crate::base::Span;

/// A file of either kind.
#[derive(Debug, Clone, PartialEq)]
pub struct File {
    /// Which kind the file's name says it is.
    pub kind: FileKind,
    /// Its declarations in source order.
    pub items: Vec<Item>,
    /// The whole text.
    pub span: Span,
}

/// The two kinds of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// `.fsfn`: variables and networks.
    Fusion,
    /// `.msd`: robots, behaviors and what tries them.
    Modes,
}

/// A declaration at the top level of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// `import a.b`
    Import(Import),
    /// `variable v: unit { ... }`
    Variable(Variable),
    /// `network n(...) { ... }`
    Network(Network),
    /// `interface i { ... }`
    Interface(Interface),
    /// `robot r { ... }`
    Robot(Robot),
    /// `behavior`, `activity` or `goal`
    Diagram(Diagram),
    /// `arbiter a on r { ... }`
    Arbiter(Arbiter),
    /// `team t { ... }`
    Team(Team),
    /// `world w { ... }`
    World(World),
    /// `scenario s { ... }`
    Scenario(Scenario),
    /// `property p: ...`
    Property(Property),
    /// Text that is no declaration; its faults were reported.
    Error(Span),
}

impl Item {
    /// All of it.
    pub fn span(&self) -> Span {
        match self {
            Self::Import(item) => item.span,
            Self::Variable(item) => item.span,
            Self::Network(item) => item.span,
            Self::Interface(item) => item.span,
            Self::Robot(item) => item.span,
            Self::Diagram(item) => item.span,
            Self::Arbiter(item) => item.span,
            Self::Team(item) => item.span,
            Self::World(item) => item.span,
            Self::Scenario(item) => item.span,
            Self::Property(item) => item.span,
            Self::Error(span) => *span,
        }
    }
}

/// An identifier.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Name {
    /// The identifier.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// Names joined by dots: `obstacle_id.heavy_obstacle`, `wheel.left.acceleration`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Path {
    /// The names, at least one.
    pub segments: Vec<Name>,
    /// From the first to the last.
    pub span: Span,
}

/// The `///` lines in front of a declaration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Doc {
    /// The text of each line, without the slashes and one following space.
    pub lines: Vec<String>,
    /// All of them.
    pub span: Span,
}

/// A decimal literal with its sign, as written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Number {
    /// The digits, with sign, point and exponent.
    pub text: String,
    /// Where they stand.
    pub span: Span,
}

/// A unit as written: `cm/s`, `m/s^2`, `1`, `%`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unit {
    /// Its factors; a factor after `/` has a negative power.
    pub factors: Vec<UnitFactor>,
    /// All of it.
    pub span: Span,
}

/// One name of a unit, to a power.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitFactor {
    /// The unit's name.
    pub name: Name,
    /// Its power, never zero unless so written.
    pub power: i32,
}

/// A number with or without a unit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Quantity {
    /// The number.
    pub number: Number,
    /// Its unit, if one was written.
    pub unit: Option<Unit>,
    /// Both.
    pub span: Span,
}

/// `low .. high`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Range {
    /// The lower end.
    pub low: Quantity,
    /// The upper end.
    pub high: Quantity,
    /// Both.
    pub span: Span,
}

/// `import std.robots.j5`
#[derive(Debug, Clone, PartialEq)]
pub struct Import {
    /// What is imported.
    pub path: Path,
    /// The whole line.
    pub span: Span,
}
