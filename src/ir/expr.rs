//! Conditions, operands before what uses them.

use super::{Flag, Mode, Sensor};
use crate::base::{Dimension, Exact, Id, Span};

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
    /// Something that nothing is known of; only within the analysis.
    Unknown,
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
    /// Whether the diagram is in a mode, what runs inside it in another, and so on inward; two modes or more. In the
    /// condition of a transition it is where they were at the end of the tick before.
    Inside(Vec<Id<Mode>>),
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

impl Op {
    /// What it is made of.
    pub fn operands(&self) -> Vec<Id<Expr>> {
        match self {
            Self::Count(of)
            | Self::Rising(of)
            | Self::Falling(of)
            | Self::Held(of, _)
            | Self::Latched(of)
            | Self::Not(of) => vec![*of],
            Self::Compare(_, left, right) => vec![*left, *right],
            Self::And(operands) | Self::Or(operands) => operands.clone(),
            Self::Error
            | Self::Unknown
            | Self::Number(_)
            | Self::Sensor(_)
            | Self::Failed(_)
            | Self::Event { .. }
            | Self::Flag(_)
            | Self::InMode(_)
            | Self::Inside(_)
            | Self::After(_)
            | Self::Done => Vec::new(),
        }
    }
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

impl Comparison {
    /// Whether it holds between two quantities of one unit.
    pub fn holds<T: PartialOrd + Copy>(self, left: T, right: T) -> bool {
        match self {
            Self::Less => left < right,
            Self::LessOrEqual => left <= right,
            Self::Greater => left > right,
            Self::GreaterOrEqual => left >= right,
            Self::Equal => left == right,
            Self::NotEqual => left != right,
        }
    }
}
