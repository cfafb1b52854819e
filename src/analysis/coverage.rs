//! Every reading belongs to some term, and every term to some reading.

use super::support::{Cut, Interval, gaps, support};
use super::vanishing_end;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Term, Variable};

pub(super) fn check(variable: &Variable, findings: &mut Vec<Diagnostic>) {
    let mut covered = Vec::new();
    let mut misplaced = false;
    for term in &variable.terms {
        let intervals = support(&term.shape, variable.range);
        if intervals.is_empty() {
            findings.push(outside(term, variable));
            misplaced = true;
        }
        covered.extend(intervals);
    }
    // A misplaced term may be what is missing there.
    if misplaced {
        return;
    }
    let mut gaps = gaps(covered, variable.range);
    vanishing_end::check(variable, &mut gaps, findings);
    if !gaps.is_empty() {
        findings.push(not_covered(variable, &gaps));
    }
}

fn shown_range(variable: &Variable) -> String {
    let (low, high) = variable.range;
    format!("{} .. {}", variable.unit.show(low.to_f64()), variable.unit.show(high.to_f64()))
}

fn outside(term: &Term, variable: &Variable) -> Diagnostic {
    let message = format!("`{}` is 0 for every reading of `{}`", term.symbol.name, variable.symbol.name);
    Diagnostic::new(&rules::TERM_OUTSIDE_RANGE, term.shape_span, message).note(format!(
        "the range of `{}` is {}",
        variable.symbol.name,
        shown_range(variable)
    ))
}

fn not_covered(variable: &Variable, gaps: &[Interval]) -> Diagnostic {
    let shown: Vec<_> = gaps.iter().map(|gap| show_gap(variable, *gap)).collect();
    let message = format!("no term of `{}` holds {}", variable.symbol.name, shown.join(" and "));
    let diagnostic = Diagnostic::new(&rules::RANGE_NOT_COVERED, variable.symbol.span, message);
    let beside = |&(from, to): &Interval| {
        let ends = |cut: Cut, ends_at: fn(&Interval) -> Cut| {
            let mut terms = variable.terms.iter();
            terms.find(|term| support(&term.shape, variable.range).iter().map(ends_at).any(|end| end == cut))
        };
        let before = ends(from, |interval| interval.1).map(|term| (term, "ends there"));
        let after = ends(to, |interval| interval.0).map(|term| (term, "begins there"));
        before.into_iter().chain(after)
    };
    let labels = gaps.iter().flat_map(beside).take(3);
    labels
        .fold(diagnostic, |diagnostic, (term, does)| diagnostic.label(term.shape_span, does))
        .note(format!(
            "its range is {}; where every degree is 0, no rule that names the variable fires",
            shown_range(variable)
        ))
        .help("widen a term, or narrow the range")
}

fn show_gap(variable: &Variable, (from, to): Interval) -> String {
    let show = |value: crate::base::Exact| variable.unit.show(value.to_f64());
    if from.at == to.at { show(from.at) } else { format!("{} to {}", show(from.at), show(to.at)) }
}
