//! Interfaces and robots.

use super::{Call, Doc, Expr, FailReading, Name, Number, Path, Quantity, Range, Sense, Unit};
use crate::base::Span;

/// `interface mobile_base { ... }`, `interface feeling_base extends mobile_base { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Interface {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The interface that it takes over.
    pub extends: Option<Name>,
    /// What it promises: actions, and sensors.
    pub items: Vec<RobotItem>,
    /// The whole declaration.
    pub span: Span,
}

/// `robot j5 provides mobile_base { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Robot {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The interfaces it keeps.
    pub provides: Vec<Name>,
    /// The behavior that carries out its commands.
    pub runs: Option<Name>,
    /// What it has.
    pub items: Vec<RobotItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in a robot or an interface.
#[derive(Debug, Clone, PartialEq)]
pub enum RobotItem {
    /// `body differential_drive { ... }`
    Body(Body),
    /// `sensor s: unit ...`
    Sensor(Sensor),
    /// `sense n(...)`: a network that its logical sensors look at
    Sense(Sense),
    /// `logical front = min(...)`, `logical blocked = front < 45 cm`
    Logical(Logical),
    /// `action a(...) = ...`
    Action(Action),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// `body differential_drive { mass 59 kg ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// The kind of body.
    pub kind: Name,
    /// Its parameters in order.
    pub parameters: Vec<BodyParameter>,
    /// All of it.
    pub span: Span,
}

/// `size (1 m, 0.75 m)`
#[derive(Debug, Clone, PartialEq)]
pub struct BodyParameter {
    /// The parameter's name.
    pub name: Name,
    /// One value, or several in parentheses.
    pub values: Vec<Quantity>,
    /// All of it.
    pub span: Span,
}

/// `optional sensor contact_force: N in 0 .. 400 fails 0 = wedge.force noise 2`
#[derive(Debug, Clone, PartialEq)]
pub struct Sensor {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Whether the robot can do without it.
    pub optional: bool,
    /// Its name.
    pub name: Name,
    /// `[24]`: how many there are
    pub count: Option<Number>,
    /// What it measures.
    pub kind: SensorKind,
    /// Its clauses in source order.
    pub clauses: Vec<SensorClause>,
    /// The whole declaration.
    pub span: Span,
}

/// What a sensor yields.
#[derive(Debug, Clone, PartialEq)]
pub enum SensorKind {
    /// A quantity in a range.
    Quantity {
        /// The unit of its numbers.
        unit: Unit,
        /// The readings it can give.
        range: Option<Range>,
    },
    /// `contact`: touched or not
    Contact(Span),
}

/// What may follow a sensor's type.
#[derive(Debug, Clone, PartialEq)]
pub enum SensorClause {
    /// `fails 0 N, any`
    Fails(Vec<FailReading>),
    /// `= wheel.left.acceleration`: where the body provides it
    Source(Path),
    /// `noise 0.05`: the standard deviation of its readings
    Noise(Quantity),
    /// `accuracy 2.5 cm`
    Accuracy(Quantity),
    /// `period 60 ms`
    Period(Quantity),
    /// `beam 15 deg`: how wide a range sensor sees
    Beam(Quantity),
}

/// `logical front = min(sonar[21, 22, 23]) within 1 cm`, `logical blocked = front < 45 cm`
#[derive(Debug, Clone, PartialEq)]
pub struct Logical {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// How it follows from sensors: a group of them, or a condition.
    pub value: Expr,
    /// `within 1 cm` or `within 200 ms`: how exact its readings are to be, or how long they may take.
    pub within: Option<Quantity>,
    /// The whole declaration.
    pub span: Span,
}

/// `action turn(angle: deg) -> done = body.rotate(angle)`
#[derive(Debug, Clone, PartialEq)]
pub struct Action {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Whether the robot can do without the actuator.
    pub optional: bool,
    /// Its name.
    pub name: Name,
    /// Its parameters in order.
    pub parameters: Vec<ActionParameter>,
    /// `-> done`, if it reports completion.
    pub done: Option<Span>,
    /// `= command`, the body's commands that keep the promise.
    pub implementation: Option<Call>,
    /// The whole declaration.
    pub span: Span,
}

/// `speed: m/s`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ActionParameter {
    /// The parameter's name.
    pub name: Name,
    /// Its unit.
    pub unit: Unit,
}
