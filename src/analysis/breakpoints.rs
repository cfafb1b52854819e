//! Corners of a membership function ascend.

use crate::base::{Exact, Unit};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Part, Shape, Term};

/// Judges terms of a variable or of an output with that unit.
pub(super) fn check(terms: &[Term], unit: &Unit, findings: &mut Vec<Diagnostic>) {
    for term in terms {
        match &term.shape {
            Shape::Ramp { zero_at, one_at } if zero_at == one_at => findings.push(ramp_without_direction(term)),
            shape => {
                if let Some((before, after)) = descent(shape) {
                    let shown = |value: Exact| unit.show(value.to_f64());
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
        Shape::Trapezoid(corners) | Shape::RiseAndFall(corners) => corners.to_vec(),
        Shape::Rectangle(ends) | Shape::Rise(ends) | Shape::Fall(ends) => ends.to_vec(),
        Shape::Points(points) => points.iter().map(|(at, _)| *at).collect(),
        Shape::Gaussian2([low, _, high, _]) => vec![*low, *high],
        Shape::Built(parts) => return plain(parts).find_map(descent),
        Shape::Ramp { .. }
        | Shape::Singleton(_)
        | Shape::Gaussian(_)
        | Shape::Bell(_)
        | Shape::Sigmoid(_)
        | Shape::Cosine(_) => Vec::new(),
    };
    corners.windows(2).find_map(|pair| match pair {
        &[before, after] if before > after => Some((before, after)),
        _ => None,
    })
}

/// The shapes that another one is built from.
fn plain(parts: &[Part]) -> impl Iterator<Item = &Shape> {
    parts.iter().filter_map(|part| match part {
        Part::Shape(shape) => Some(shape),
        _ => None,
    })
}

/// Whether a shape has corners that ascend, so that it means something.
pub(super) fn in_order(shape: &Shape) -> bool {
    match shape {
        Shape::Ramp { zero_at, one_at } => zero_at != one_at,
        Shape::Built(parts) => plain(parts).all(in_order),
        Shape::Points(points) if points.is_empty() => false,
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
