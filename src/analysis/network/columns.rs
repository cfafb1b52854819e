//! The degrees that the rules name of one input, a column each; two where only bounds of them are known.

use crate::base::Fraction;
use crate::ir::{Literal, Variable};
use crate::membership::{Curve, Membership};

/// Curves by column.
#[derive(Debug, Clone)]
pub(super) struct Columns {
    /// For each column the literal whose degree it is, or bounds.
    pub(super) literals: Vec<Literal>,
    pub(super) curves: Vec<Curve>,
    /// For each column the degree without a reading.
    pub(super) absent: Vec<Fraction>,
    /// For each thing named, the columns of its least and of its greatest degree: one where it is known exactly.
    pub(super) bounds: Vec<(usize, usize)>,
}

impl Columns {
    /// Columns for literals of variables, with readings in units of `π^pi`; `None` where a term does not exist.
    pub(super) fn new<'a>(named: impl IntoIterator<Item = (&'a Variable, Literal)>, pi: i8) -> Option<Self> {
        let mut columns = Self { literals: Vec::new(), curves: Vec::new(), absent: Vec::new(), bounds: Vec::new() };
        for (variable, literal) in named {
            let membership = Membership::new(&variable.terms.get(literal.term as usize)?.shape, pi);
            let membership = if literal.negated { membership.complement() } else { membership };
            let is_exact = membership.is_exact();
            let Membership { low, high, absent } = membership;
            let first = columns.add(literal, low, &absent);
            let last = if is_exact { first } else { columns.add(literal, high, &absent) };
            columns.bounds.push((first, last));
        }
        Some(columns)
    }

    fn add(&mut self, literal: Literal, curve: Curve, absent: &Fraction) -> usize {
        self.literals.push(literal);
        self.curves.push(curve);
        self.absent.push(absent.clone());
        self.curves.len() - 1
    }

    /// Whether some degree is only known within bounds.
    pub(super) fn is_smooth(&self) -> bool {
        self.bounds.iter().any(|(low, high)| low != high)
    }
}
