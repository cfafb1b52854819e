//! Where a set is largest.

use super::{Membership, in_units};
use crate::base::{Exact, Fraction};
use crate::ir::Shape;

/// The middle of the values of a range, in SI, at which a set is largest; `None` for a smooth set that is built from
/// others.
pub(crate) fn middle_of_largest(shape: &Shape, range: (Exact, Exact)) -> Option<f64> {
    let (pi, (low, high)) = in_units(range);
    let within = |at: Exact| at.to_fraction(pi).max(low.clone()).min(high.clone());
    let middle = |from: Fraction, to: Fraction| Some(from.halfway(&to).to_f64_times_pi(pi));
    match *shape {
        Shape::Gaussian([at, _]) | Shape::Bell([at, ..]) | Shape::Cosine([at, _]) => middle(within(at), within(at)),
        Shape::Gaussian2([from, _, to, _]) | Shape::RiseAndFall([_, from, to, _]) => middle(within(from), within(to)),
        Shape::Sigmoid([_, slope]) if slope.is_negative() => middle(low.clone(), low),
        Shape::Sigmoid(_) => middle(high.clone(), high),
        Shape::Rise([_, from]) => middle(within(from), high),
        Shape::Fall([to, _]) => middle(low.clone(), within(to)),
        _ => {
            let membership = Membership::new(shape, pi);
            let (from, to) = membership.low.peak(&(low, high));
            membership.is_exact().then(|| middle(from, to)).flatten()
        }
    }
}
