//! Continuous outputs of networks, and how they are inferred.

use super::{Clause, Rule, Symbol, Term};
use crate::base::{Exact, Span, Unit};

/// What `and`, `or`, implication, aggregation and defuzzification are in the output rules of a network.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Inference {
    /// What `and` is.
    pub and: TNorm,
    /// What `or` is.
    pub or: SNorm,
    /// What a rule's strength makes of the set that it names.
    pub implication: Implication,
    /// How the sets of several rules become one.
    pub aggregation: Aggregation,
    /// How a set becomes a number.
    pub defuzzifier: Defuzzifier,
}

/// A triangular norm: how strong two statements are together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum TNorm {
    /// The smaller one.
    #[default]
    Minimum,
    /// `a b`
    Product,
    /// `a + b - 1`, at least 0 (Łukasiewicz).
    Bounded,
    /// The smaller one where the other is 1, else 0.
    Drastic,
    /// `a b / (2 - (a + b - a b))`
    Einstein,
    /// `a b / (a + b - a b)`
    Hamacher,
    /// The smaller one where `a + b > 1`, else 0.
    Nilpotent,
}

/// A triangular conorm: how strong one statement or another is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Hash)]
pub enum SNorm {
    /// The larger one.
    #[default]
    Maximum,
    /// `a + b - a b`
    Probabilistic,
    /// `a + b`, at most 1 (Łukasiewicz).
    Bounded,
    /// The larger one where the other is 0, else 1.
    Drastic,
    /// `(a + b) / (1 + a b)`
    Einstein,
    /// `(a + b - 2 a b) / (1 - a b)`
    Hamacher,
    /// The larger one where `a + b < 1`, else 1.
    Nilpotent,
}

/// What a rule's strength makes of the set that it names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Implication {
    /// It clips it.
    #[default]
    Minimum,
    /// It scales it.
    Product,
}

/// How the sets of several rules become one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Aggregation {
    /// The largest degree counts.
    #[default]
    Maximum,
    /// Degrees are added.
    Sum,
}

/// How a set becomes a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Defuzzifier {
    /// The center of its area, exactly.
    #[default]
    Centroid,
    /// The center of its area, from its degrees in the middle of so many equal parts of the range.
    Midpoints(u32),
    /// Where its area is halved.
    Bisector,
    /// The smallest value of the largest degree.
    SmallestOfMaximum,
    /// The largest value of the largest degree.
    LargestOfMaximum,
    /// The mean of the values of the largest degree.
    MeanOfMaximum,
    /// The mean of where the sets are largest, weighted by the strengths of their rules.
    WeightedAverage,
}

/// The t-norms, and how they are written.
pub const T_NORMS: &[(&str, TNorm)] = &[
    ("min", TNorm::Minimum),
    ("product", TNorm::Product),
    ("bounded_difference", TNorm::Bounded),
    ("drastic_product", TNorm::Drastic),
    ("einstein_product", TNorm::Einstein),
    ("hamacher_product", TNorm::Hamacher),
    ("nilpotent_minimum", TNorm::Nilpotent),
];

/// The s-norms, and how they are written.
pub const S_NORMS: &[(&str, SNorm)] = &[
    ("max", SNorm::Maximum),
    ("probabilistic_sum", SNorm::Probabilistic),
    ("bounded_sum", SNorm::Bounded),
    ("drastic_sum", SNorm::Drastic),
    ("einstein_sum", SNorm::Einstein),
    ("hamacher_sum", SNorm::Hamacher),
    ("nilpotent_maximum", SNorm::Nilpotent),
];

/// The implications, and how they are written.
pub const IMPLICATIONS: &[(&str, Implication)] = &[("min", Implication::Minimum), ("product", Implication::Product)];

/// The aggregations, and how they are written.
pub const AGGREGATIONS: &[(&str, Aggregation)] = &[("max", Aggregation::Maximum), ("sum", Aggregation::Sum)];

/// The defuzzifiers, and how they are written; behind the centroid may stand a number of midpoints.
pub const DEFUZZIFIERS: &[(&str, Defuzzifier)] = &[
    ("centroid", Defuzzifier::Centroid),
    ("bisector", Defuzzifier::Bisector),
    ("smallest_of_maximum", Defuzzifier::SmallestOfMaximum),
    ("largest_of_maximum", Defuzzifier::LargestOfMaximum),
    ("mean_of_maximum", Defuzzifier::MeanOfMaximum),
    ("weighted_average", Defuzzifier::WeightedAverage),
];

/// A continuous output.
#[derive(Debug, Clone)]
pub struct Output {
    /// Its name.
    pub symbol: Symbol,
    /// Its unit as written.
    pub unit: Unit,
    /// The values it may take, in SI; an output with sets has one.
    pub range: Option<(Exact, Exact)>,
    /// What it is when no rule fires.
    pub default: Option<Rest>,
    /// Its fuzzy sets; none for one that is made of linear expressions (Takagi and Sugeno).
    pub terms: Vec<Term>,
    /// Its rules in order.
    pub rules: Vec<OutputRule>,
}

/// What an output is when no rule fires.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Rest {
    /// A value, in SI.
    Value(Exact),
    /// What it was when a rule fired last.
    Last,
}

/// A rule that sets an output.
#[derive(Debug, Clone)]
pub struct OutputRule {
    /// When it fires; operands stand before what uses them, the last is the whole.
    pub antecedent: Vec<Statement>,
    /// The simple rules that it stands for under minimum and maximum.
    pub cases: Vec<Rule>,
    /// The factor of its strength, above 0 and at most 1.
    pub weight: Exact,
    /// What it sets.
    pub consequent: Consequent,
    /// The whole rule.
    pub span: Span,
}

/// A part of an antecedent, made of earlier ones.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Statement {
    /// An input is some term: the largest of their degrees.
    Is(Clause),
    /// `1 - strength`
    Not(u32),
    /// `and`
    All(Vec<u32>),
    /// `or`
    Any(Vec<u32>),
}

/// What a rule sets its output to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Consequent {
    /// A set, by its position among the output's terms.
    Term(u32),
    /// A linear expression of the inputs.
    Linear(Linear),
}

/// A constant and a multiple of each of some inputs, in SI.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Linear {
    /// The constant.
    pub constant: Exact,
    /// Positions of inputs in their network, ascending, with their factors.
    pub factors: Vec<(u32, Exact)>,
}
