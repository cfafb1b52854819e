//! The syntax tree: a file as it was written, in source order, with a span on every node.
//!
//! The tree holds the whole language of both file kinds. Broken parts are `Error` items; everything around them is kept.

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

// Fuzzy sensor fusion

/// `variable contact: N in 0 .. 400 fails 0 N { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The unit of its corners.
    pub unit: Unit,
    /// The readings it is defined for.
    pub range: Option<Range>,
    /// How a sensor that feeds it fails, if nothing else is said.
    pub fails: Vec<FailReading>,
    /// Its fuzzy sets.
    pub terms: Vec<Term>,
    /// The whole declaration.
    pub span: Span,
}

/// `low = ramp(80, 20)`
#[derive(Debug, Clone, PartialEq)]
pub struct Term {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// Its membership function.
    pub shape: Shape,
    /// All of it.
    pub span: Span,
}

/// A membership function.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// What it is.
    pub kind: ShapeKind,
    /// Where it stands.
    pub span: Span,
}

/// The ways to write a membership function.
#[derive(Debug, Clone, PartialEq)]
pub enum ShapeKind {
    /// `triangle(a, b, c)` and the other named shapes
    Function {
        /// The shape's name.
        function: Name,
        /// Its parameters.
        parameters: Vec<Quantity>,
    },
    /// `points((x, y), ...)`
    Points(Vec<(Quantity, Quantity)>),
    /// Another term of the variable.
    Term(Name),
    /// `not t`
    Not(Box<Shape>),
    /// `very t`, `somewhat t`
    Hedge(Name, Box<Shape>),
    /// `a and b`
    And(Vec<Shape>),
    /// `a or b`
    Or(Vec<Shape>),
}

/// One way a sensor can fail, after `fails`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FailReading {
    /// Stuck at a reading.
    Value(Quantity),
    /// `any`: stuck at an unknown reading in range.
    Any(Span),
    /// `absent`: every degree of membership is 0.
    Absent(Span),
    /// `set`, for a contact.
    Set(Span),
    /// `clear`, for a contact.
    Clear(Span),
}

/// `network obstacle_id(left: acceleration, ...) using { ... } { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Network {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// Its inputs in order.
    pub inputs: Vec<NetworkInput>,
    /// `using { and product, ... }`
    pub settings: Vec<Setting>,
    /// What stands in its braces.
    pub items: Vec<NetworkItem>,
    /// The whole declaration.
    pub span: Span,
}

/// `left: acceleration`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NetworkInput {
    /// The input's name in the network.
    pub name: Name,
    /// The variable whose terms it takes.
    pub variable: Name,
}

/// One choice of a `using` block: `and product`, `defuzzify centroid midpoints 200`.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// What is chosen: `and`, `or`, `implication`, `aggregation`, `defuzzify`.
    pub key: Name,
    /// The choice and its options, as written.
    pub values: Vec<SettingValue>,
    /// All of it.
    pub span: Span,
}

/// A word or a number of a [`Setting`].
#[derive(Debug, Clone, PartialEq)]
pub enum SettingValue {
    /// A word.
    Name(Name),
    /// A number.
    Number(Number),
}

/// What may stand in a network.
#[derive(Debug, Clone, PartialEq)]
pub enum NetworkItem {
    /// `event e { ... }`
    Event(Event),
    /// `output y: unit { ... }`
    Output(Output),
    /// `rule ... => ...`
    Rule(OutputRule),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// `event hit over (left, right) hysteresis 0.1 hold 200 ms { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The inputs its rows name, all of the network's if not written.
    pub over: Option<Vec<Name>>,
    /// `hysteresis`, as often as it was written.
    pub hysteresis: Vec<Quantity>,
    /// `hold`, as often as it was written.
    pub hold: Vec<Quantity>,
    /// `confirm`, as often as it was written.
    pub confirm: Vec<Quantity>,
    /// The `contributor` and `detractor` blocks in order.
    pub sides: Vec<EventSide>,
    /// The whole declaration.
    pub span: Span,
}

/// One block of inference rules of an event.
#[derive(Debug, Clone, PartialEq)]
pub struct EventSide {
    /// Whether the rules speak for the event or against it.
    pub kind: SideKind,
    /// The keyword, for messages.
    pub keyword: Span,
    /// The rules.
    pub rules: Vec<EventRule>,
}

/// Whether a rule speaks for an event or against it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SideKind {
    /// For it.
    Contributor,
    /// Against it.
    Detractor,
}

/// An inference rule of an event, in either form.
#[derive(Debug, Clone, PartialEq)]
pub enum EventRule {
    /// `(neg, _, {low, med})`
    Row(Row),
    /// `rule left is neg and force is low`
    Words {
        /// The condition after `rule`.
        antecedent: Expr,
        /// The whole rule.
        span: Span,
    },
}

/// `(neg, _, {low, med}, -)`
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// The cells in order.
    pub cells: Vec<Cell>,
    /// With the parentheses.
    pub span: Span,
}

/// One cell of a row.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// What it says.
    pub kind: CellKind,
    /// Where it stands.
    pub span: Span,
}

/// What a cell of a rule says of its variable.
#[derive(Debug, Clone, PartialEq)]
pub enum CellKind {
    /// One term.
    Term(Name),
    /// `{a, b}`: the maximum over some terms
    AnyOf(Vec<Name>),
    /// `_`: the maximum over all terms
    Any,
    /// `-`: the variable is left out
    Omitted,
}

/// `output steering: deg in -40 .. 40 default hold { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The unit of its corners.
    pub unit: Unit,
    /// The values it may take.
    pub range: Option<Range>,
    /// What it is when no rule fires.
    pub default: Option<OutputDefault>,
    /// How its value is made.
    pub body: OutputBody,
    /// The whole declaration.
    pub span: Span,
}

/// What an output is when no rule fires.
#[derive(Debug, Clone, PartialEq)]
pub enum OutputDefault {
    /// A fixed value.
    Value(Quantity),
    /// Its last value.
    Hold(Span),
}

/// How an output's value is made.
#[derive(Debug, Clone, PartialEq)]
pub enum OutputBody {
    /// From fuzzy sets.
    Terms(Vec<Term>),
    /// `= takagi_sugeno`: from linear expressions
    TakagiSugeno(Span),
}

/// `rule gate is left and obstacle is near => steering is left weight 0.8`
#[derive(Debug, Clone, PartialEq)]
pub struct OutputRule {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// The condition.
    pub antecedent: Expr,
    /// What it sets, at least one.
    pub consequents: Vec<Consequent>,
    /// Its weight, 1 if not written.
    pub weight: Option<Number>,
    /// The whole rule.
    pub span: Span,
}

/// `steering is left`, or `speed = 0.5 * distance + 0.1 m/s`
#[derive(Debug, Clone, PartialEq)]
pub struct Consequent {
    /// The output.
    pub output: Name,
    /// What it becomes.
    pub value: ConsequentValue,
}

/// What a rule makes of an output.
#[derive(Debug, Clone, PartialEq)]
pub enum ConsequentValue {
    /// `is term`
    Term(Name),
    /// `= linear expression`
    Linear(Expr),
}

// Expressions

/// A condition, a command's argument, or a linear expression.
#[derive(Debug, Clone, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
}

/// The forms of an expression. Chains of `and`, `or`, `+` and `*` are flat, so a tree is only as deep as its
/// parentheses, which the parser limits.
#[derive(Debug, Clone, PartialEq)]
pub enum ExprKind {
    /// A flag, sensor, network output, parameter or enumerated state.
    Path(Path),
    /// `sonar[3]`, `sonar[21..23, 0]`
    Index(Path, Vec<IndexRange>),
    /// `26 cm/s`
    Quantity(Quantity),
    /// `not a`
    Not(Box<Expr>),
    /// `a and b and c`
    And(Vec<Expr>),
    /// `a or b or c`
    Or(Vec<Expr>),
    /// `a < b`
    Compare(CompareOp, Box<Expr>, Box<Expr>),
    /// `x is t`, `x is any of {a, b}`, `explore.mode is stop`
    Is(Box<Expr>, Vec<Name>),
    /// `after 2 s`
    After(Quantity),
    /// `done`
    Done,
    /// `failed(s)`, `count(f)`, `random(a, b)`, `either(...)` and commands
    Call(Call),
    /// `-a`
    Negate(Box<Expr>),
    /// `a + b - c`
    Sum(Vec<(Sign, Expr)>),
    /// `a * b / c`
    Product(Vec<(Factor, Expr)>),
}

/// The sign of a term of a sum.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Sign {
    /// `+`
    #[default]
    Plus,
    /// `-`
    Minus,
}

/// The side of a fraction a factor stands on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Factor {
    /// `*`
    #[default]
    Times,
    /// `/`
    Over,
}

/// A comparison.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CompareOp {
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

/// `3` or `21..23` in an index list, both ends included.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct IndexRange {
    /// The first index.
    pub first: Number,
    /// The last index, if a range.
    pub last: Option<Number>,
}

/// `arc(26 cm/s, radius: 1 m)`
#[derive(Debug, Clone, PartialEq)]
pub struct Call {
    /// What is called.
    pub path: Path,
    /// The arguments in order.
    pub arguments: Vec<Argument>,
    /// All of it.
    pub span: Span,
}

/// `26 cm/s` or `radius: 1 m`
#[derive(Debug, Clone, PartialEq)]
pub struct Argument {
    /// The parameter's name, if written.
    pub name: Option<Name>,
    /// The value.
    pub value: Expr,
}

// Robots and interfaces

/// `interface mobile_base { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Interface {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
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
    /// `logical front = min(...)`
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
}

/// `logical front = min(sonar[21, 22, 23])`
#[derive(Debug, Clone, PartialEq)]
pub struct Logical {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// How it follows from sensors.
    pub value: Expr,
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

// Mode switching diagrams

/// `behavior b on r extends c { ... }`, or an `activity` or a `goal`
#[derive(Debug, Clone, PartialEq)]
pub struct Diagram {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its layer.
    pub layer: Layer,
    /// Its name.
    pub name: Name,
    /// The robot or interface it is written on.
    pub on: Option<Name>,
    /// The diagram whose modes it takes over.
    pub extends: Option<Name>,
    /// What stands in its braces.
    pub items: Vec<DiagramItem>,
    /// The whole declaration.
    pub span: Span,
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

impl Layer {
    /// The keyword that declares it.
    pub const fn keyword(self) -> &'static str {
        match self {
            Self::Behavior => "behavior",
            Self::Activity => "activity",
            Self::Goal => "goal",
        }
    }
}

/// What may stand in a diagram.
#[derive(Debug, Clone, PartialEq)]
pub enum DiagramItem {
    /// `sense network(...)`
    Sense(Sense),
    /// `entry m`
    Entry {
        /// The mode.
        mode: Name,
        /// The whole line.
        span: Span,
    },
    /// `flag f = ...`
    Flag(Flag),
    /// `mode m { ... }`
    Mode(Mode),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// `sense obstacle_id(left_wheel_acceleration, ...)`
#[derive(Debug, Clone, PartialEq)]
pub struct Sense {
    /// `alias =` in front of the network, where one network is sensed twice.
    pub alias: Option<Name>,
    /// The network.
    pub network: Name,
    /// What feeds its inputs, in order or by name.
    pub arguments: Vec<Argument>,
    /// The whole line.
    pub span: Span,
}

/// `flag low_battery = battery < 11 V`
#[derive(Debug, Clone, PartialEq)]
pub struct Flag {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// When it is set.
    pub condition: Expr,
    /// The whole declaration.
    pub span: Span,
}

/// `mode push requires contact_force else stop { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// `final`, if the mode has no way out on purpose.
    pub is_final: Option<Span>,
    /// Its name.
    pub name: Name,
    /// `= diagram`, the diagram that runs inside it.
    pub child: Option<Child>,
    /// The sensors it cannot do without.
    pub requires: Vec<Name>,
    /// Where the machine goes when one of them fails.
    pub otherwise: Option<Name>,
    /// What stands in its braces; empty where there are none.
    pub items: Vec<ModeItem>,
    /// The whole declaration.
    pub span: Span,
}

/// `= obstacle_avoidance resume`
#[derive(Debug, Clone, PartialEq)]
pub struct Child {
    /// The diagram.
    pub diagram: Name,
    /// `resume`, if it goes on where it was.
    pub resume: Option<Span>,
}

/// What may stand in a mode.
#[derive(Debug, Clone, PartialEq)]
pub enum ModeItem {
    /// A command given on every tick.
    Action(Call),
    /// `on enter { ... }`
    OnEnter(Vec<Call>, Span),
    /// `on exit { ... }`
    OnExit(Vec<Call>, Span),
    /// `decide (...) { ... }`
    Decide(Decide),
    /// `1: condition -> target`
    Transition(Transition),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// `1: heavy_obstacle -> stop`
#[derive(Debug, Clone, PartialEq)]
pub struct Transition {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its priority, 1 the highest.
    pub priority: Number,
    /// When it is set.
    pub condition: Expr,
    /// Where it leads.
    pub target: Target,
    /// The whole line.
    pub span: Span,
}

/// Where a transition leads.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// Another mode.
    Mode(Name),
    /// `again`: the mode itself, with its timers restarted
    Again(Span),
}

/// `decide (right, left) { (close, far) => turn_left(10 deg) ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Decide {
    /// What is looked at.
    pub subjects: Vec<Expr>,
    /// The rows in order.
    pub rows: Vec<DecideRow>,
    /// All of it.
    pub span: Span,
}

/// `(close, far) => turn_left(10 deg)`
#[derive(Debug, Clone, PartialEq)]
pub struct DecideRow {
    /// The cells.
    pub row: Row,
    /// A command, `either(...)` of commands, or `nothing`.
    pub command: Expr,
    /// Both.
    pub span: Span,
}

// Arbiters, teams

/// `arbiter navigation on labmate { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Arbiter {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The robot.
    pub on: Option<Name>,
    /// What stands in its braces.
    pub items: Vec<ArbiterItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in an arbiter.
#[derive(Debug, Clone, PartialEq)]
pub enum ArbiterItem {
    /// `emergency condition -> command`
    Emergency {
        /// When.
        condition: Expr,
        /// What.
        command: Call,
        /// The whole line.
        span: Span,
    },
    /// `client avoid = collision_avoidance priority 1 when ... else 3`
    Client(Client),
    /// `ties in_order` or `ties random`
    Ties {
        /// The word.
        order: Name,
        /// The whole line.
        span: Span,
    },
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// A client of an arbiter.
#[derive(Debug, Clone, PartialEq)]
pub struct Client {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The diagram it runs.
    pub diagram: Name,
    /// Its priorities: each holds when its condition does, the last one otherwise.
    pub priorities: Vec<ClientPriority>,
    /// The whole line.
    pub span: Span,
}

/// `1 when state is forward`, or `3`
#[derive(Debug, Clone, PartialEq)]
pub struct ClientPriority {
    /// 1 to 10, 1 the highest.
    pub priority: Number,
    /// When it holds; always, if nothing is written.
    pub when: Option<Expr>,
}

/// `team pushers { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Team {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// What stands in its braces.
    pub items: Vec<TeamItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in a team.
#[derive(Debug, Clone, PartialEq)]
pub enum TeamItem {
    /// `robot a = j5 runs clear_area`
    Member {
        /// The member's name.
        name: Name,
        /// Its kind of robot.
        robot: Name,
        /// What it runs.
        runs: Name,
        /// The whole line.
        span: Span,
    },
    /// `a.partner_pushing = b.mode is clear`
    Link {
        /// The flag that is set.
        flag: Path,
        /// When.
        condition: Expr,
        /// The whole line.
        span: Span,
    },
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

// Worlds, scenarios, properties

/// `(x, y)`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Point {
    /// Along the world's x axis.
    pub x: Quantity,
    /// Along the world's y axis.
    pub y: Quantity,
    /// With the parentheses.
    pub span: Span,
}

/// `world hallway { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct World {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// What stands in it.
    pub items: Vec<WorldItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in a world.
#[derive(Debug, Clone, PartialEq)]
pub enum WorldItem {
    /// `wall (0 m, 0 m) -> (12 m, 0 m) -> ...`
    Wall {
        /// Its corners, at least two.
        points: Vec<Point>,
        /// The whole line.
        span: Span,
    },
    /// `door at (8 m, 2 m) width 0.9 m heading 0 deg open`
    Door {
        /// Its middle.
        at: Point,
        /// Its width.
        width: Quantity,
        /// The direction along it.
        heading: Option<Quantity>,
        /// Whether it is open.
        open: bool,
        /// The whole line.
        span: Span,
    },
    /// `box mass 30 kg size (0.4 m, 0.6 m) at (3 m, 1 m) heading 0 deg`
    Box(BoxItem),
    /// `goal (11 m, 1 m)`
    Goal(Point),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// A box that can be pushed.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxItem {
    /// Its name, if it has one: `box crate mass ...`
    pub name: Option<Name>,
    /// Its mass.
    pub mass: Quantity,
    /// Its length along its heading and its width across it.
    pub size: (Quantity, Quantity),
    /// Where its middle is, or how far ahead of the robot its near face is.
    pub place: PlaceAt,
    /// The whole item.
    pub span: Span,
}

/// Where something is placed.
#[derive(Debug, Clone, PartialEq)]
pub enum PlaceAt {
    /// `at (x, y) heading h`
    Point {
        /// Its middle.
        at: Point,
        /// The direction it faces, 0 if not written.
        heading: Option<Quantity>,
    },
    /// `at 0.75 m ahead`: free floor between the robot and it
    Ahead(Quantity),
}

/// `scenario s runs b on r in w extends t { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// What is run.
    pub runs: Option<Name>,
    /// The robot it runs on.
    pub on: Option<Name>,
    /// The world it runs in.
    pub within: Option<Name>,
    /// The scenario it varies.
    pub extends: Option<Name>,
    /// What stands in its braces.
    pub items: Vec<ScenarioItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in a scenario.
#[derive(Debug, Clone, PartialEq)]
pub enum ScenarioItem {
    /// `duration 10 s`
    Duration(Quantity, Span),
    /// `tick 10 ms`
    Tick(Quantity, Span),
    /// `seed 1`
    Seed(Number, Span),
    /// `place robot at (0 m, 0 m) heading 0 deg`
    PlaceRobot {
        /// Which robot of a team; the only one if not written.
        robot: Option<Name>,
        /// Where.
        place: PlaceAt,
        /// The whole line.
        span: Span,
    },
    /// `place box ...`
    PlaceBox(BoxItem),
    /// `fault s = 0 N from 0 s to 3 s`: it reads wrong, silently
    Fault {
        /// The sensor.
        sensor: SensorRef,
        /// What it reads.
        reading: FailReading,
        /// When.
        window: FaultWindow,
        /// The whole line.
        span: Span,
    },
    /// `fail s from 1 s`: it is also reported as failed
    Fail {
        /// The sensor.
        sensor: SensorRef,
        /// When.
        window: FaultWindow,
        /// The whole line.
        span: Span,
    },
    /// `expect ...`
    Expect(Expect),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// `contact_force` or `sonar[3]`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SensorRef {
    /// The sensor, or a team member's sensor.
    pub path: Path,
    /// Which of an array.
    pub indices: Vec<IndexRange>,
}

/// `from 0 s to 3 s`, either end left out
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FaultWindow {
    /// The start of the run if not written.
    pub from: Option<Quantity>,
    /// The end of the run if not written.
    pub to: Option<Quantity>,
}

/// `expect forward -> push within 4.5 s .. 5.5 s`
#[derive(Debug, Clone, PartialEq)]
pub struct Expect {
    /// What is expected.
    pub kind: ExpectKind,
    /// The whole line; its text names the expectation in reports.
    pub span: Span,
}

/// What a scenario can expect.
#[derive(Debug, Clone, PartialEq)]
pub enum ExpectKind {
    /// `expect modes a, b, c`: the modes in order, from the start
    Modes(Vec<Name>),
    /// `expect a -> b within t1 .. t2`
    Transition {
        /// The mode that is left.
        from: Name,
        /// The mode that is entered.
        to: Name,
        /// When; at any time if not written.
        within: Option<Range>,
    },
    /// `expect condition within t1 .. t2`: true on some tick
    Within {
        /// The condition.
        condition: Expr,
        /// When; at any time if not written.
        window: Option<Range>,
    },
    /// `expect never condition before t`
    Never {
        /// The condition.
        condition: Expr,
        /// `before t`, `after t` or `within t1 .. t2`; the whole run if not written.
        window: ExpectWindow,
    },
    /// `expect always condition after t`
    Always {
        /// The condition.
        condition: Expr,
        /// When it must hold.
        window: ExpectWindow,
    },
}

/// The part of a run an expectation speaks of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ExpectWindow {
    /// All of it.
    Whole,
    /// `before t`
    Before(Quantity),
    /// `after t`
    After(Quantity),
    /// `within t1 .. t2`
    Within(Range),
}

/// `property no_blind_push: never push and failed(contact_force)`
#[derive(Debug, Clone, PartialEq)]
pub struct Property {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// What it claims.
    pub kind: PropertyKind,
    /// The whole declaration.
    pub span: Span,
}

/// What a property can claim.
#[derive(Debug, Clone, PartialEq)]
pub enum PropertyKind {
    /// `never c`
    Never(Expr),
    /// `always c`
    Always(Expr),
    /// `p leads to q within t`
    LeadsTo {
        /// The cause.
        cause: Expr,
        /// The effect.
        effect: Expr,
        /// The longest time between them.
        within: Option<Quantity>,
    },
}
