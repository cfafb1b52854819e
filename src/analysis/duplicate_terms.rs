//! Terms of one variable differ.

use super::support::support;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Term, Variable};
use crate::membership::{Membership, in_units};

pub(super) fn check(variable: &Variable, findings: &mut Vec<Diagnostic>) {
    let (pi, range) = in_units(variable.range);
    // Terms outside the range are equal there, and were reported.
    let inside = variable.terms.iter().filter(|term| !support(&term.shape, variable.range).is_empty());
    let mut known: Vec<(&Term, Membership)> = Vec::new();
    for term in inside {
        let membership = Membership::new(&term.shape, pi);
        // Bounds of smooth terms can be the same although the terms are not.
        let is_same = |other: &Term, known: &Membership| {
            term.shape == other.shape
                || membership.is_exact() && known.is_exact() && membership.low.equals(&known.low, &range)
        };
        match known.iter().find(|(other, known)| is_same(other, known)) {
            Some((other, _)) => findings.push(duplicate(term, other)),
            None => known.push((term, membership)),
        }
    }
}

fn duplicate(term: &Term, other: &Term) -> Diagnostic {
    let message = format!("`{}` is the same set as `{}`", term.symbol.name, other.symbol.name);
    Diagnostic::new(&rules::DUPLICATE_TERM, term.shape_span, message)
        .label(other.shape_span, "equal over the whole range")
        .note("every reading belongs to both to the same degree, so no rule can tell them apart")
        .help("take one of them out, or correct its corners")
}
