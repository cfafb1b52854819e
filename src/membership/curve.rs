//! Piecewise-linear functions from readings to degrees, with their one-sided limits.

use crate::base::{Exact, Fraction};

/// Linear between its knots, and constant outside.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Curve {
    /// In ascending order of readings.
    knots: Vec<(Fraction, Limits)>,
}

/// The degrees just before a reading, at it, and just after it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Limits {
    pub(crate) before: Fraction,
    pub(crate) at: Fraction,
    pub(crate) after: Fraction,
}

impl Limits {
    pub(crate) fn flat(degree: &Fraction) -> Self {
        Self { before: degree.clone(), at: degree.clone(), after: degree.clone() }
    }

    fn map(&self, map: impl Fn(&Fraction) -> Fraction) -> Self {
        Self { before: map(&self.before), at: map(&self.at), after: map(&self.after) }
    }
}

/// The power of π in whose units the readings of a range are kept, and the range in these units.
pub(crate) fn in_units((low, high): (Exact, Exact)) -> (i8, (Fraction, Fraction)) {
    let pi = if low.is_zero() { high.pi_power() } else { low.pi_power() };
    (pi, (low.to_fraction(pi), high.to_fraction(pi)))
}

/// The readings of a range between which all of some curves are linear, its ends included, ascending.
pub(crate) fn places<'c>(
    curves: impl IntoIterator<Item = &'c Curve>,
    (low, high): &'c (Fraction, Fraction),
) -> Vec<&'c Fraction> {
    let bends = curves.into_iter().flat_map(Curve::bends).filter(|at| low < *at && *at < high);
    let mut places: Vec<&Fraction> = bends.chain([low, high]).collect();
    places.sort_unstable();
    places.dedup();
    places
}

impl Curve {
    pub(crate) fn of_knots(knots: Vec<(Fraction, Limits)>) -> Self {
        Self { knots }
    }

    /// The curve through corners in ascending order of readings. Corners at one reading are a step, at which the largest
    /// degree counts.
    pub(crate) fn through(corners: impl IntoIterator<Item = (Fraction, Fraction)>) -> Self {
        let mut knots: Vec<(Fraction, Limits)> = Vec::new();
        for (at, degree) in corners {
            match knots.last_mut() {
                Some((known, limits)) if *known == at => {
                    limits.at = limits.at.clone().max(degree.clone());
                    limits.after = degree;
                }
                _ => knots.push((at, Limits::flat(&degree))),
            }
        }
        Self { knots }
    }

    /// The readings at which it may bend or step.
    pub(crate) fn bends(&self) -> impl Iterator<Item = &Fraction> {
        self.knots.iter().map(|(at, _)| at)
    }

    /// Its degrees around a reading.
    pub(crate) fn around(&self, reading: &Fraction) -> Limits {
        let after = match self.knots.binary_search_by(|(at, _)| at.cmp(reading)) {
            Ok(here) => return self.knots[here].1.clone(),
            Err(after) => after,
        };
        Limits::flat(&match (after.checked_sub(1).and_then(|before| self.knots.get(before)), self.knots.get(after)) {
            (Some((from, start)), Some((to, end))) => {
                let share = (reading - from).over(&(to - from)).unwrap_or(Fraction::ZERO);
                &start.after + &(&(&end.before - &start.after) * &share)
            }
            (Some((_, limits)), None) => limits.after.clone(),
            (None, Some((_, limits))) => limits.before.clone(),
            (None, None) => Fraction::ZERO,
        })
    }

    /// Whether it is equal to another one over a range.
    pub(crate) fn equals(&self, other: &Self, range: &(Fraction, Fraction)) -> bool {
        let (low, high) = range;
        self.bends().chain(other.bends()).chain([low, high]).filter(|at| low <= *at && *at <= high).all(|at| {
            let (one, other) = (self.around(at), other.around(at));
            one.at == other.at && (at == low || one.before == other.before) && (at == high || one.after == other.after)
        })
    }

    /// The lowest and the highest reading of a range at which its degree is largest.
    pub(crate) fn peak(&self, range: &(Fraction, Fraction)) -> (Fraction, Fraction) {
        let (low, high) = range;
        let inside = self.bends().chain([low, high]).filter(|at| low <= *at && *at <= high);
        let degrees: Vec<_> = inside.map(|at| (self.around(at).at, at)).collect();
        let largest = degrees.iter().map(|(degree, _)| degree).max();
        let peak = degrees.iter().filter(|(degree, _)| Some(degree) == largest).map(|(_, at)| *at);
        (peak.clone().min().unwrap_or(low).clone(), peak.max().unwrap_or(high).clone())
    }

    /// One minus it.
    pub(crate) fn complement(&self) -> Self {
        let complement = |limits: &Limits| limits.map(|degree| &Fraction::ONE - degree);
        Self { knots: self.knots.iter().map(|(at, limits)| (at.clone(), complement(limits))).collect() }
    }

    /// The larger of two curves at every reading, or the smaller.
    pub(crate) fn merged(&self, other: &Self, pick: fn(Fraction, Fraction) -> Fraction) -> Self {
        let mut places: Vec<&Fraction> = self.bends().chain(other.bends()).collect();
        places.sort_unstable();
        places.dedup();
        let mut knots: Vec<(Fraction, Limits)> = Vec::with_capacity(2 * places.len());
        let mut earlier: Option<(&Fraction, Limits, Limits)> = None;
        for place in places {
            let (one, two) = (self.around(place), other.around(place));
            if let Some((from, before_one, before_two)) = &earlier {
                let (start, end) = (&before_one.after - &before_two.after, &two.before - &one.before);
                // They cross in between where the difference has opposite signs at the ends.
                if !start.is_zero() && !end.is_zero() && start.is_negative() == end.is_negative() {
                    let share = start.over(&(&start + &end)).unwrap_or(Fraction::ZERO);
                    let at = *from + &(&(place - *from) * &share);
                    let degree = &before_one.after + &(&(&one.before - &before_one.after) * &share);
                    knots.push((at, Limits::flat(&degree)));
                }
            }
            let limits = Limits {
                before: pick(one.before.clone(), two.before.clone()),
                at: pick(one.at.clone(), two.at.clone()),
                after: pick(one.after.clone(), two.after.clone()),
            };
            knots.push((place.clone(), limits));
            earlier = Some((place, one, two));
        }
        Self { knots }
    }

    /// Steps that bound a rising function of the degree on one side. `bound` bounds the function's value from that side,
    /// `pick` takes the bound of two, and between `cuts`, which are degrees in ascending order, the bound is constant.
    pub(crate) fn stepped(
        &self,
        cuts: &[Fraction],
        pick: fn(Fraction, Fraction) -> Fraction,
        bound: impl Fn(&Fraction) -> Fraction,
    ) -> Self {
        let mut knots: Vec<(Fraction, Limits)> = Vec::new();
        let mut before = self.knots.first().map_or(Fraction::ZERO, |(_, limits)| bound(&limits.before));
        for (index, (from, limits)) in self.knots.iter().enumerate() {
            let (to, end) = self.knots.get(index + 1).map_or((from, &limits.after), |(to, next)| (to, &next.before));
            let start = &limits.after;
            let mut inside: Vec<_> = cuts.iter().filter(|cut| start.min(end) < *cut && *cut < start.max(end)).collect();
            if end < start {
                inside.reverse();
            }
            let ends: Vec<_> = std::iter::once(start).chain(inside).chain([end]).collect();
            for pair in ends.windows(2) {
                let share = (pair[0] - start).over(&(end - start)).unwrap_or(Fraction::ZERO);
                let after = pick(bound(pair[0]), bound(pair[1]));
                let at = if pair[0] == start { bound(&limits.at) } else { pick(before.clone(), after.clone()) };
                knots.push((from + &(&(to - from) * &share), Limits { before, at, after: after.clone() }));
                before = after;
            }
        }
        Self { knots }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(corners: &[(i128, i128, i128)]) -> Curve {
        Curve::through(corners.iter().map(|&(at, degree, of)| (Fraction::from(at), Fraction::new(degree, of))))
    }

    fn around(curve: &Curve, reading: &Fraction) -> [f64; 3] {
        let limits = curve.around(reading);
        [limits.before.to_f64(), limits.at.to_f64(), limits.after.to_f64()]
    }

    #[test]
    fn steps_have_limits_and_the_larger_degree() {
        let step = curve(&[(0, 0, 1), (0, 1, 1), (4, 0, 1)]);
        assert_eq!([-1, 0, 1].map(|at| around(&step, &Fraction::from(at))), [[0.0; 3], [0.0, 1.0, 1.0], [0.75; 3]]);
        assert_eq!(around(&step.complement(), &Fraction::ZERO), [1.0, 0.0, 0.0]);
        let single = curve(&[(2, 0, 1), (2, 1, 1), (2, 0, 1)]);
        assert_eq!(around(&single, &Fraction::from(2)), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn the_larger_of_two_bends_where_they_cross() {
        let (down, up) = (curve(&[(0, 1, 1), (4, 0, 1)]), curve(&[(0, 0, 1), (4, 1, 1)]));
        let (larger, smaller) = (down.merged(&up, Ord::max), down.merged(&up, Ord::min));
        assert_eq!([0, 1, 2, 3].map(|at| around(&larger, &Fraction::from(at))[1]), [1.0, 0.75, 0.5, 0.75]);
        assert_eq!([0, 1, 2, 3].map(|at| around(&smaller, &Fraction::from(at))[1]), [0.0, 0.25, 0.5, 0.25]);
        assert_eq!(larger, smaller.complement());
    }

    #[test]
    fn steps_bound_a_function_of_the_degree() {
        let hill = curve(&[(0, 0, 1), (4, 1, 1), (4, 1, 2), (8, 0, 1)]);
        let cuts: Vec<_> = (1..8).map(|cut| Fraction::new(cut, 8)).collect();
        let square = |degree: &Fraction| degree * degree;
        let (low, high) = (hill.stepped(&cuts, Ord::min, square), hill.stepped(&cuts, Ord::max, square));
        for eighth in -8..72 {
            let reading = Fraction::new(eighth, 8);
            let [low, here, high] = [&low, &hill, &high].map(|curve| around(curve, &reading));
            for (side, degree) in here.iter().enumerate() {
                let square = degree * degree;
                assert!(low[side] <= square && square <= high[side], "{eighth} {side}");
                assert!(high[side] - low[side] < 0.5, "{eighth} {side}");
            }
        }
    }
}
