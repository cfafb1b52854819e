//! The piecewise-linear form of a membership function, with its one-sided limits.

use crate::base::{Exact, Fraction};
use crate::ir::Shape;

/// A membership function as corners in ascending order, linear in between and constant outside. Corners at one
/// reading are a step, at which the largest degree counts.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    corners: Vec<(Fraction, Fraction)>,
    negated: bool,
}

/// The degrees just before a reading, at it, and just after it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Limits {
    pub(super) before: Fraction,
    pub(super) at: Fraction,
    pub(super) after: Fraction,
}

impl Curve {
    /// The curve of a shape whose corners ascend, or of its complement, with readings in units of `π^pi`.
    pub(super) fn new(shape: &Shape, negated: bool, pi: i8) -> Self {
        let corner = |at: Exact, degree: i128| (at.to_fraction(pi), Fraction::from(degree));
        let corners = match *shape {
            Shape::Triangle([a, b, c]) => vec![corner(a, 0), corner(b, 1), corner(c, 0)],
            Shape::Trapezoid([a, b, c, d]) => vec![corner(a, 0), corner(b, 1), corner(c, 1), corner(d, 0)],
            Shape::Ramp { zero_at, one_at } if zero_at < one_at => vec![corner(zero_at, 0), corner(one_at, 1)],
            Shape::Ramp { zero_at, one_at } => vec![corner(one_at, 1), corner(zero_at, 0)],
            Shape::Rectangle([a, b]) => vec![corner(a, 0), corner(a, 1), corner(b, 1), corner(b, 0)],
            Shape::Singleton(at) => vec![corner(at, 0), corner(at, 1), corner(at, 0)],
            Shape::Points(ref points) => {
                points.iter().map(|(at, degree)| (at.to_fraction(pi), degree.to_fraction(0))).collect()
            }
        };
        Self { corners, negated }
    }

    /// The readings at which it may bend or step.
    pub(super) fn bends(&self) -> impl Iterator<Item = &Fraction> {
        self.corners.iter().map(|(at, _)| at)
    }

    /// Its degrees around a reading.
    pub(super) fn around(&self, reading: &Fraction) -> Limits {
        let Limits { before, at, after } = self.plain(reading);
        if self.negated {
            let complement = |degree| &Fraction::ONE - &degree;
            Limits { before: complement(before), at: complement(at), after: complement(after) }
        } else {
            Limits { before, at, after }
        }
    }

    /// Its degree without a reading: no reading belongs to any set, so a complement holds.
    pub(super) fn without_reading(&self) -> Fraction {
        if self.negated { Fraction::ONE } else { Fraction::ZERO }
    }

    fn plain(&self, reading: &Fraction) -> Limits {
        let start = self.corners.partition_point(|(at, _)| at < reading);
        let end = self.corners.partition_point(|(at, _)| at <= reading);
        let (below, here, above) = (&self.corners[..start], &self.corners[start..end], &self.corners[end..]);
        if let (Some((_, before)), Some((_, after))) = (here.first(), here.last()) {
            let at = here.iter().map(|(_, degree)| degree).max().unwrap_or(before).clone();
            return Limits { before: before.clone(), at, after: after.clone() };
        }
        let degree = match (below.last(), above.first()) {
            (Some((from, start)), Some((to, end))) => {
                let share = (reading - from).over(&(to - from)).unwrap_or(Fraction::ZERO);
                start + &(&(end - start) * &share)
            }
            (Some((_, degree)), None) | (None, Some((_, degree))) => degree.clone(),
            (None, None) => Fraction::ZERO,
        };
        Limits { before: degree.clone(), at: degree.clone(), after: degree }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn around(shape: &Shape, negated: bool, reading: i128) -> [f64; 3] {
        let limits = Curve::new(shape, negated, 0).around(&Fraction::from(reading));
        [limits.before.to_f64(), limits.at.to_f64(), limits.after.to_f64()]
    }

    #[test]
    fn steps_have_limits_and_the_larger_degree() {
        let number = |value| Exact::new(value, 1, 0);
        let step = Shape::Triangle([number(0), number(0), number(4)]);
        assert_eq!([-1, 0, 1].map(|at| around(&step, false, at)), [[0.0; 3], [0.0, 1.0, 1.0], [0.75; 3]]);
        assert_eq!(around(&step, true, 0), [1.0, 0.0, 0.0]);
        assert_eq!(around(&Shape::Singleton(number(2)), false, 2), [0.0, 1.0, 0.0]);
        let ramp = Shape::Ramp { zero_at: number(4), one_at: number(0) };
        assert_eq!([-1, 1, 5].map(|at| around(&ramp, false, at)[1]), [1.0, 0.75, 0.0]);
    }
}
