//! Fuzzy variables, networks, and their rules as minima of maxima.

use super::{Inference, Output, Symbol};
use crate::base::{Exact, Id, Span, Unit};

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

/// A membership function with exact numbers in SI. Equal corners are steps; the degree at a step is the larger one.
/// Outside its corners a function keeps its outermost degree.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
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
    /// Linear between the points, in ascending order of readings. Without points it is one that was broken and reported.
    Points(Vec<(Exact, Exact)>),
    /// A bell around a mean, with a standard deviation above 0.
    Gaussian([Exact; 2]),
    /// 1 between two means, a bell's flank on either side: mean and deviation below, mean and deviation above.
    Gaussian2([Exact; 4]),
    /// The generalized bell: its center, its width at degree 1/2 to one side, above 0, and its slope, above 0.
    Bell([Exact; 3]),
    /// The logistic curve: where it is 1/2, and its slope there times 4, in 1/SI; it falls where that is below 0.
    Sigmoid([Exact; 2]),
    /// Two parabolas from 0 at the first corner to 1 at the second.
    Rise([Exact; 2]),
    /// Two parabolas from 1 at the first corner to 0 at the second.
    Fall([Exact; 2]),
    /// A rise between the first two corners and a fall between the last two.
    RiseAndFall([Exact; 4]),
    /// One wave of a cosine: its center, and its whole width, above 0.
    Cosine([Exact; 2]),
    /// Built from other shapes: the last part is what it is.
    Built(Vec<Part>),
}

/// A part of a shape, built from earlier ones.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Part {
    /// A shape that is not built itself.
    Shape(Shape),
    /// `1 - degree`
    Not(u32),
    /// `degree²`
    Very(u32),
    /// `√degree`
    Somewhat(u32),
    /// The smallest degree.
    All(Vec<u32>),
    /// The largest degree.
    Any(Vec<u32>),
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
    /// How its outputs are inferred.
    pub inference: Inference,
    /// Its continuous outputs in order.
    pub outputs: Vec<Output>,
    /// Whether something in it was broken, reported and left out; then nothing can be said of what it lacks.
    pub incomplete: bool,
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
