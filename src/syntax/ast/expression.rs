//! Conditions, commands and linear expressions.

use super::{Name, Number, Path, Quantity};
use crate::base::Span;

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
