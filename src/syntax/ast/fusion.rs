//! Variables, networks and their rules.

use super::{Doc, Expr, Name, Number, Quantity, Range, Unit};
use crate::base::Span;

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
