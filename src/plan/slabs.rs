//! Piecewise-linear sets as polynomials in the strengths that clip them, exact until they are rounded once.

use super::{Real, Slab};
use crate::base::Fraction;
use crate::membership::Curve;

/// A range with its middle, in units of `π^pi`.
pub(super) struct Domain {
    pub(super) range: (Fraction, Fraction),
    pub(super) middle: Fraction,
    pub(super) pi: i8,
}

/// A polynomial's factors for τ and τ², and for τ, τ² and τ³.
#[derive(Clone)]
struct Held {
    area: [Fraction; 2],
    moment: [Fraction; 3],
}

const NOTHING: Held =
    Held { area: [Fraction::ZERO, Fraction::ZERO], moment: [Fraction::ZERO, Fraction::ZERO, Fraction::ZERO] };

impl Held {
    fn add(&mut self, area: [Fraction; 2], moment: [Fraction; 3]) {
        self.area.iter_mut().zip(area).for_each(|(sum, more)| *sum = &*sum + &more);
        self.moment.iter_mut().zip(moment).for_each(|(sum, more)| *sum = &*sum + &more);
    }

    fn rounded(&self, strength: Real, floor: &Fraction, thickness: &Fraction, sign: i128, pi: i8) -> Slab {
        let number = |factor: &Fraction, powers: i8| (factor * &Fraction::from(sign)).to_f64_times_pi(powers * pi);
        let ([a, b], [c, d, e]) = (&self.area, &self.moment);
        Slab {
            strength,
            floor: floor.to_f64(),
            thickness: thickness.to_f64(),
            area: (number(a, 1), number(b, 1)),
            moment: (number(c, 2), number(d, 2), number(e, 2)),
        }
    }
}

/// What a set holds while it is clipped at a strength, times `sign`.
///
/// At the degrees between two heights of its corners, a piece of it reaches from where its line has the degree to an
/// end: with the degree `floor + τ` that is at `p + q τ`, so the width is linear in τ, and what lies below the strength
/// is the integral of the width.
pub(super) fn clipped(set: &Curve, domain: &Domain, strength: Real, sign: i128) -> Vec<Slab> {
    let shifted = |(x, degree): &(Fraction, Fraction)| (x - &domain.middle, degree.clone());
    let pieces: Vec<_> = set.pieces(&domain.range).iter().map(|ends| [shifted(&ends[0]), shifted(&ends[1])]).collect();
    let degrees = pieces.iter().flatten().map(|(_, degree)| degree.clone());
    let mut heights: Vec<_> = degrees.chain([Fraction::ZERO]).collect();
    heights.sort_unstable();
    heights.dedup();
    let between = |heights: &[Fraction]| {
        let (floor, ceiling) = (&heights[0], &heights[1]);
        let mut held = NOTHING;
        for [start, end] in &pieces {
            let (least, most) = (start.1.clone().min(end.1.clone()), start.1.clone().max(end.1.clone()));
            if least >= *ceiling {
                held.add(
                    [&end.0 - &start.0, Fraction::ZERO],
                    [half_squares(&start.0, &end.0), Fraction::ZERO, Fraction::ZERO],
                );
            } else if most >= *ceiling
                && let Some(q) = (&end.0 - &start.0).over(&(&end.1 - &start.1))
            {
                let p = &start.0 + &(&q * &(floor - &start.1));
                let linear =
                    [&q * &Fraction::new(1, 2), &(&p * &q) * &Fraction::new(1, 2), &(&q * &q) * &Fraction::new(1, 6)];
                let [area, moment, cubic] = linear;
                if end.1 > start.1 {
                    held.add([&end.0 - &p, -&area], [half_squares(&p, &end.0), -&moment, -&cubic]);
                } else {
                    held.add([&p - &start.0, area], [half_squares(&start.0, &p), moment, cubic]);
                }
            }
        }
        held.rounded(strength, floor, &(ceiling - floor), sign, domain.pi)
    };
    heights.windows(2).map(between).collect()
}

/// What a set holds while it is scaled by a strength.
pub(super) fn scaled(set: &Curve, domain: &Domain, strength: Real) -> Slab {
    let mut held = NOTHING;
    for [(from, start), (to, end)] in set.pieces(&domain.range) {
        let (from, width) = (&from - &domain.middle, &to - &from);
        let both = &start + &end;
        let area = &(&width * &both) * &Fraction::new(1, 2);
        let further = &(&width * &(&both + &end)) * &Fraction::new(1, 6);
        let moment = &(&from * &area) + &(&width * &further);
        held.add([area, Fraction::ZERO], [moment, Fraction::ZERO, Fraction::ZERO]);
    }
    held.rounded(strength, &Fraction::ZERO, &Fraction::ONE, 1, domain.pi)
}

/// The integral of x between two numbers.
fn half_squares(from: &Fraction, to: &Fraction) -> Fraction {
    &(&(to * to) - &(from * from)) * &Fraction::new(1, 2)
}
