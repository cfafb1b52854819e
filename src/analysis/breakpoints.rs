//! Corners of a membership function ascend.

use crate::base::Exact;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Shape, Term, Variable};

pub(super) fn check(variable: &Variable, findings: &mut Vec<Diagnostic>) {
    for term in &variable.terms {
        match &term.shape {
            Shape::Ramp { zero_at, one_at } if zero_at == one_at => findings.push(ramp_without_direction(term)),
            shape => {
                if let Some((before, after)) = descent(shape) {
                    let shown = |value: Exact| variable.unit.show(value.to_f64());
                    findings.push(out_of_order(term, &shown(before), &shown(after)));
                }
            }
        }
    }
}

/// The first corner that is larger than the next one.
fn descent(shape: &Shape) -> Option<(Exact, Exact)> {
    let corners = match shape {
        Shape::Triangle(corners) => corners.to_vec(),
        Shape::Trapezoid(corners) => corners.to_vec(),
        Shape::Rectangle(ends) => ends.to_vec(),
        Shape::Points(points) => points.iter().map(|(at, _)| *at).collect(),
        Shape::Ramp { .. } | Shape::Singleton(_) => Vec::new(),
    };
    corners.windows(2).find_map(|pair| match pair {
        &[before, after] if before > after => Some((before, after)),
        _ => None,
    })
}

/// Whether a shape has corners that ascend, so that it means something.
pub(super) fn in_order(shape: &Shape) -> bool {
    match shape {
        Shape::Ramp { zero_at, one_at } => zero_at != one_at,
        shape => descent(shape).is_none(),
    }
}

fn out_of_order(term: &Term, before: &str, after: &str) -> Diagnostic {
    let message = format!("the corners of `{}` do not ascend: {before} stands before {after}", term.symbol.name);
    Diagnostic::new(&rules::BREAKPOINTS_OUT_OF_ORDER, term.shape_span, message)
        .help("write the corners from the smallest to the largest; only a `ramp` may fall")
}

fn ramp_without_direction(term: &Term) -> Diagnostic {
    let message = format!("the ramp `{}` has no direction: both corners are equal", term.symbol.name);
    Diagnostic::new(&rules::BREAKPOINTS_OUT_OF_ORDER, term.shape_span, message)
        .help("write `points((x, 0), (x, 1))` for a step up, `points((x, 1), (x, 0))` for a step down")
}
