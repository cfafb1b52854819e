//! The outermost terms hold the ends of the range.

use super::support::{Cut, Interval, support};
use crate::base::Exact;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Shape, Term, Variable};
use crate::membership::{Membership, in_units};

/// Reports outermost terms that are 0 at their end of the range, and takes holes that are nothing else out of `gaps`.
pub(super) fn check(variable: &Variable, gaps: &mut Vec<Interval>, findings: &mut Vec<Diagnostic>) {
    let (lowest, highest) = outermost(variable);
    for (term, end) in [(lowest, variable.range.0), (highest, variable.range.1)] {
        let holds = |&(from, to): &Interval| from <= Cut::before(end) && Cut::after(end) <= to;
        let is_end = |gap: &Interval| *gap == (Cut::before(end), Cut::after(end));
        // A wider hole is more than the term's foot on the end.
        let is_wide = gaps.iter().any(|gap| holds(gap) && !is_end(gap));
        if let Some(term) = term
            && !is_wide
            && !support(&term.shape, variable.range).iter().any(holds)
        {
            gaps.retain(|gap| !is_end(gap));
            findings.push(vanishes(term, variable, end));
        }
    }
}

/// The terms whose peaks lie below, and above, those of all others.
fn outermost(variable: &Variable) -> (Option<&Term>, Option<&Term>) {
    let (pi, range) = in_units(variable.range);
    let peaks: Vec<_> = variable.terms.iter().map(|term| Membership::new(&term.shape, pi).low.peak(&range)).collect();
    let others = |term: usize| peaks.iter().enumerate().filter(move |(other, _)| *other != term).map(|(_, peak)| peak);
    let is_lowest = |&term: &usize| others(term).all(|other| peaks[term].1 < other.0);
    let is_highest = |&term: &usize| others(term).all(|other| other.1 < peaks[term].0);
    let terms = if peaks.len() < 2 { 0..0 } else { 0..peaks.len() };
    let term = |found: Option<usize>| found.map(|term| &variable.terms[term]);
    (term(terms.clone().find(is_lowest)), term(terms.clone().find(is_highest)))
}

fn vanishes(term: &Term, variable: &Variable, end: Exact) -> Diagnostic {
    let (name, shown) = (&term.symbol.name, variable.unit.show(end.to_f64()));
    let message = format!("`{name}` is 0 at {shown}, the end of the range that it is nearest to");
    Diagnostic::new(&rules::TERM_VANISHES_AT_END, term.shape_span, message)
        .note("there no rule that names it fires, although no other term lies further out")
        .help_maybe(held(&term.shape, variable, end))
}

/// The shape with full degree up to the end.
fn held(shape: &Shape, variable: &Variable, end: Exact) -> Option<String> {
    let corners = match *shape {
        Shape::Triangle([_, c, d]) | Shape::Trapezoid([_, _, c, d]) if end == variable.range.0 => [end, end, c, d],
        Shape::Triangle([a, b, _]) | Shape::Trapezoid([a, b, _, _]) => [a, b, end, end],
        _ => return None,
    };
    let shown = corners.map(|corner| variable.unit.show(corner.to_f64()));
    Some(format!("let it reach the end: `trapezoid({})`", shown.join(", ")))
}
