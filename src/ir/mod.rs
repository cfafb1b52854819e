//! The types of the checked program: names are ids, numbers are SI, and there is no logic.
//!
//! Imports: base
//! Crates: –

mod trial;

pub use trial::{BoxBody, Expectation, ExpectationKind, Fault, FaultReading, Placement, Scenario, Wall, Window, World};

use crate::base::{Arena, Dimension, Exact, Id, Span, Unit};

/// Everything a compilation declares.
#[derive(Debug, Clone, Default)]
pub struct Program {
    /// Fuzzy variables.
    pub variables: Arena<Variable>,
    /// Fuzzy sensor fusion networks.
    pub networks: Arena<Network>,
    /// Interfaces.
    pub interfaces: Arena<Interface>,
    /// Robots.
    pub robots: Arena<Robot>,
    /// Sensors of all robots and interfaces.
    pub sensors: Arena<Sensor>,
    /// Actions of all robots and interfaces.
    pub actions: Arena<Action>,
    /// Mode switching diagrams.
    pub diagrams: Arena<Diagram>,
    /// Worlds.
    pub worlds: Arena<World>,
    /// Scenarios.
    pub scenarios: Arena<Scenario>,
    /// Conditions, post-order: operands stand before what uses them.
    pub exprs: Arena<Expr>,
}

/// The name and place of a declaration.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Symbol {
    /// As written.
    pub name: String,
    /// Where the name stands.
    pub span: Span,
    /// The text of its doc comment, lines joined by newlines; empty without one.
    pub doc: String,
}

/// A fuzzy variable: readings and the sets they belong to.
#[derive(Debug, Clone)]
pub struct Variable {
    /// Its name.
    pub symbol: Symbol,
    /// The unit of its corners as written.
    pub unit: Unit,
    /// The readings it is defined for, in SI: lower end, upper end.
    pub range: (Exact, Exact),
    /// How a sensor that feeds it fails unless it says so itself.
    pub fails: Vec<FailReading>,
    /// Its fuzzy sets.
    pub terms: Vec<Term>,
    /// Whether some term could not be parsed, which was reported; it is left out.
    pub incomplete: bool,
}

/// A fuzzy set of a variable.
#[derive(Debug, Clone)]
pub struct Term {
    /// Its name.
    pub symbol: Symbol,
    /// Its membership function, in SI.
    pub shape: Shape,
    /// Where the membership function stands.
    pub shape_span: Span,
}

/// A piecewise-linear membership function with exact corners in SI. Equal corners are steps; the degree at a step is
/// the larger one. Outside its corners a function keeps its outermost degree.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Shape {
    /// 0 at `a`, 1 at `b`, 0 at `c`.
    Triangle([Exact; 3]),
    /// 0 at `a`, 1 from `b` to `c`, 0 at `d`.
    Trapezoid([Exact; 4]),
    /// 0 at the first corner and beyond, 1 at the second and beyond, in either direction.
    Ramp {
        /// Where the degree reaches 0.
        zero_at: Exact,
        /// Where the degree reaches 1.
        one_at: Exact,
    },
    /// 1 on the closed interval, 0 elsewhere.
    Rectangle([Exact; 2]),
    /// 1 at one reading, 0 elsewhere.
    Singleton(Exact),
    /// Linear between the points, in ascending order of readings.
    Points(Vec<(Exact, Exact)>),
}

/// One way a sensor can fail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FailReading {
    /// Stuck at a reading, in SI.
    Value(Exact),
    /// Stuck at some unknown reading in range.
    Any,
    /// Every degree of membership is 0.
    Absent,
}

/// A fuzzy sensor fusion network (LMSL §2.2).
#[derive(Debug, Clone)]
pub struct Network {
    /// Its name.
    pub symbol: Symbol,
    /// Its inputs in order.
    pub inputs: Vec<NetworkInput>,
    /// Its events in order.
    pub events: Vec<Event>,
}

/// An input of a network.
#[derive(Debug, Clone)]
pub struct NetworkInput {
    /// Its name in the network.
    pub symbol: Symbol,
    /// The variable whose terms it takes.
    pub variable: Id<Variable>,
}

/// An event of a network: a flag that is set when what speaks for it outweighs what speaks against it.
#[derive(Debug, Clone)]
pub struct Event {
    /// Its name.
    pub symbol: Symbol,
    /// The rules that speak for it.
    pub contributor: Vec<Rule>,
    /// The rules that speak against it.
    pub detractor: Vec<Rule>,
    /// Half the width of the band in which the flag keeps its value; 0 without memory.
    pub hysteresis: Exact,
    /// Nanoseconds the flag stays set at least.
    pub hold: u64,
    /// Nanoseconds the rules must agree before the flag sets.
    pub confirm: u64,
}

/// An inference rule: the minimum over its clauses (LMSL eq. 3).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rule {
    /// What it names, at most what was written; without clauses its strength is 1.
    pub clauses: Vec<Clause>,
    /// Where it stands.
    pub span: Span,
}

/// One cell of a rule: the maximum over some terms of one input.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Clause {
    /// The position of the input in its network.
    pub input: u32,
    /// The terms, ascending and without repetition.
    pub any_of: Vec<Literal>,
}

/// A term of a variable, or its complement.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Literal {
    /// The position of the term in its variable.
    pub term: u32,
    /// Whether `1 - degree` is meant.
    pub negated: bool,
}

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

/// The layer of a diagram, from the inside out (LMSL fig. 3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// Its modes call actions.
    Behavior,
    /// Its modes run behaviors.
    Activity,
    /// Its modes run activities.
    Goal,
}

/// What a diagram is written on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Platform {
    /// One robot.
    Robot(Id<Robot>),
    /// Every robot that keeps an interface.
    Interface(Id<Interface>),
}

/// A mode switching diagram (LMSL §2.1), with what it extends taken over.
#[derive(Debug, Clone)]
pub struct Diagram {
    /// Its name.
    pub symbol: Symbol,
    /// Its layer.
    pub layer: Layer,
    /// What it is written on.
    pub platform: Platform,
    /// The networks it senses through.
    pub senses: Vec<Sense>,
    /// Its named conditions, in an order in which each uses only earlier ones.
    pub flags: Arena<Flag>,
    /// Its modes in source order, those of the extended diagram first.
    pub modes: Arena<Mode>,
    /// The mode it starts in; `None` where that was reported missing.
    pub entry: Option<Id<Mode>>,
    /// Whether something in it or in one of its modes was broken, reported and left out.
    pub incomplete: bool,
}

/// A network bound to sensors.
#[derive(Debug, Clone)]
pub struct Sense {
    /// The network's name, or the alias it is sensed under.
    pub symbol: Symbol,
    /// The network.
    pub network: Id<Network>,
    /// What feeds each of its inputs.
    pub inputs: Vec<Id<Sensor>>,
}

/// A named condition.
#[derive(Debug, Clone)]
pub struct Flag {
    /// Its name.
    pub symbol: Symbol,
    /// When it is set.
    pub condition: Id<Expr>,
}

/// A mode of a diagram.
#[derive(Debug, Clone)]
pub struct Mode {
    /// Its name.
    pub symbol: Symbol,
    /// Whether it has no way out on purpose.
    pub is_final: bool,
    /// The sensors without which it is inhibited, and where each was written.
    pub requires: Vec<(Id<Sensor>, Span)>,
    /// Where the machine goes when one of them fails while the mode is active.
    pub otherwise: Option<Id<Mode>>,
    /// Commands given on every tick.
    pub actions: Vec<Call>,
    /// Commands given once when it is entered.
    pub on_enter: Vec<Call>,
    /// Commands given once when it is left.
    pub on_exit: Vec<Call>,
    /// Its ways out, by priority.
    pub transitions: Vec<Transition>,
    /// Whether something in it was broken, reported and left out; then nothing can be said of what it lacks.
    pub incomplete: bool,
}

/// A way out of a mode.
#[derive(Debug, Clone)]
pub struct Transition {
    /// 1 is the highest.
    pub priority: u32,
    /// Where the priority stands.
    pub priority_span: Span,
    /// When it is set.
    pub condition: Id<Expr>,
    /// Where it leads; `None` where the target was reported unknown.
    pub target: Option<Id<Mode>>,
    /// Whether it re-enters its own mode by `again`.
    pub again: bool,
    /// The whole line.
    pub span: Span,
}

/// A command with its arguments.
#[derive(Debug, Clone)]
pub struct Call {
    /// The action of the diagram's platform.
    pub action: Id<Action>,
    /// Its arguments in the order of the parameters.
    pub arguments: Vec<Argument>,
    /// Where it stands.
    pub span: Span,
}

/// An argument of an action, in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Argument {
    /// A number.
    Constant(Exact),
    /// A number drawn once when the mode is entered, from `low` to `high`.
    Random {
        /// The lower end.
        low: Exact,
        /// The upper end.
        high: Exact,
    },
}

/// A condition or an operand of one.
#[derive(Debug, Clone)]
pub struct Expr {
    /// What it is.
    pub op: Op,
    /// Its type.
    pub ty: Type,
    /// Where it stands.
    pub span: Span,
}

/// The type of an expression.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Type {
    /// True or false.
    Bool,
    /// A number of some dimension.
    Quantity(Dimension),
    /// Poison: something was wrong and has been reported.
    Error,
}

/// The operations of conditions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Op {
    /// Something that was reported as wrong.
    Error,
    /// A number in SI.
    Number(Exact),
    /// The reading of a sensor, in SI.
    Sensor(Id<Sensor>),
    /// Whether a sensor is known to have failed.
    Failed(Id<Sensor>),
    /// An event of the diagram's sense at that position.
    Event {
        /// The position of the sense in its diagram.
        sense: u32,
        /// The position of the event in its network.
        event: u32,
    },
    /// A named condition of the diagram.
    Flag(Id<Flag>),
    /// Whether the diagram is in a mode; only in expectations and properties.
    InMode(Id<Mode>),
    /// Whether the mode has been active for that many nanoseconds.
    After(u64),
    /// Whether the mode's action has reported completion.
    Done,
    /// Rising edges of a condition since the mode was entered.
    Count(Id<Expr>),
    /// True now and false on the tick before.
    Rising(Id<Expr>),
    /// False now and true on the tick before.
    Falling(Id<Expr>),
    /// True without a break for that many nanoseconds.
    Held(Id<Expr>, u64),
    /// True on some tick since the mode was entered.
    Latched(Id<Expr>),
    /// A comparison of two quantities.
    Compare(Comparison, Id<Expr>, Id<Expr>),
    /// Negation.
    Not(Id<Expr>),
    /// Conjunction.
    And(Vec<Id<Expr>>),
    /// Disjunction.
    Or(Vec<Id<Expr>>),
}

/// A comparison of quantities.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
}
