//! Every reading belongs to some term, and every term to some reading.

use super::breakpoints;
use super::support::{Interval, gaps, support};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Term, Variable};

pub(super) fn check(variable: &Variable, findings: &mut Vec<Diagnostic>) {
    // A broken term was reported; what it would have covered is unknown.
    if variable.incomplete
        || variable.terms.is_empty()
        || !variable.terms.iter().all(|term| breakpoints::in_order(&term.shape))
    {
        return;
    }
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
    let gaps = gaps(covered, variable.range);
    // A misplaced term may be what is missing there.
    if !gaps.is_empty() && !misplaced {
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
    Diagnostic::new(&rules::RANGE_NOT_COVERED, variable.symbol.span, message)
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
