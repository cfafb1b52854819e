//! A propositional solver that keeps what it learns between questions.

use std::ops::Not;

use batsat::{BasicSolver, Lit, SolverInterface, lbool};

/// A proposition or its negation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Proposition(Lit);

impl Not for Proposition {
    type Output = Self;
    fn not(self) -> Self {
        Self(!self.0)
    }
}

/// Clauses, and the model or the conflict of the last question.
#[derive(Default)]
pub(super) struct Solver {
    inner: BasicSolver,
    clause: Vec<Lit>,
}

impl Solver {
    /// A new proposition; it is false unless something asks for it.
    pub(super) fn proposition(&mut self) -> Proposition {
        Proposition(Lit::new(self.inner.new_var_default(), true))
    }

    /// Demands that one of these holds.
    pub(super) fn demand(&mut self, one_of: impl IntoIterator<Item = Proposition>) {
        self.clause.clear();
        self.clause.extend(one_of.into_iter().map(|proposition| proposition.0));
        self.inner.add_clause_reuse(&mut self.clause);
    }

    /// Whether all that was demanded can hold together with these.
    pub(super) fn holds(&mut self, assumptions: &[Proposition]) -> bool {
        self.clause.clear();
        self.clause.extend(assumptions.iter().map(|proposition| proposition.0));
        // Without a limit the solver always decides.
        self.inner.solve_limited(&self.clause) == lbool::TRUE
    }

    /// Whether the last question needed a proposition, or its negation, to be answered with no.
    pub(super) fn blames(&self, proposition: Proposition) -> bool {
        self.inner.unsat_core_contains_var(proposition.0.var())
    }

    /// Whether a proposition holds in the model found last.
    pub(super) fn value(&self, proposition: Proposition) -> bool {
        self.inner.value_lit(proposition.0) == lbool::TRUE
    }
}
