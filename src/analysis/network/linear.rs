//! Linear inequalities in exact fractions, decided by eliminating one unknown after another (Fourier and Motzkin).
//!
//! Made for inequalities with at most two unknowns each, which elimination keeps so.

use std::collections::HashMap;

use crate::base::Fraction;

/// A sum of multiples of unknowns and a constant, above 0, or at least 0.
#[derive(Debug, Clone)]
pub(super) struct Inequality {
    /// By unknown, ascending; no factor is 0.
    pub(super) factors: Vec<(usize, Fraction)>,
    pub(super) constant: Fraction,
    pub(super) strict: bool,
    /// What it follows from, ascending.
    pub(super) because: Vec<usize>,
}

impl Inequality {
    /// The sum of two of them, weighted so that an unknown falls out: `positive` has a positive factor of it, `negative`
    /// a negative one.
    fn without(unknown: usize, positive: &Self, negative: &Self) -> Self {
        let (up, down) = (negative.factor(unknown), positive.factor(unknown));
        let (up, down) = (-&up, down);
        let mut factors: Vec<(usize, Fraction)> = Vec::new();
        let scaled = |of: &Self, by: &Fraction| {
            of.factors.iter().map(|(unknown, factor)| (*unknown, factor * by)).collect::<Vec<_>>()
        };
        for (other, factor) in scaled(positive, &up).into_iter().chain(scaled(negative, &down)) {
            match factors.iter_mut().find(|(known, _)| *known == other) {
                Some((_, sum)) => *sum = &*sum + &factor,
                None => factors.push((other, factor)),
            }
        }
        factors.retain(|(_, factor)| !factor.is_zero());
        factors.sort_unstable_by_key(|(unknown, _)| *unknown);
        let mut because = [positive.because.as_slice(), &negative.because].concat();
        because.sort_unstable();
        because.dedup();
        let constant = &(&positive.constant * &up) + &(&negative.constant * &down);
        Self { factors, constant, strict: positive.strict || negative.strict, because }
    }

    fn factor(&self, unknown: usize) -> Fraction {
        let found = self.factors.iter().find(|(known, _)| *known == unknown);
        found.map_or(Fraction::ZERO, |(_, factor)| factor.clone())
    }

    /// Divided by the size of its first factor.
    fn normal(mut self) -> Self {
        if let Some((_, first)) = self.factors.first() {
            let size = if first.is_negative() { -first } else { first.clone() };
            let divided = |number: &Fraction| number.over(&size).unwrap_or(Fraction::ZERO);
            self.constant = divided(&self.constant);
            self.factors = self.factors.iter().map(|(unknown, factor)| (*unknown, divided(factor))).collect();
        }
        self
    }

    fn is_false(&self) -> bool {
        self.factors.is_empty() && (self.constant.is_negative() || self.strict && self.constant.is_zero())
    }

    /// The bound it sets on an unknown when all others in it are known.
    fn bound(&self, unknown: usize, values: &[Fraction]) -> Fraction {
        let others = self.factors.iter().filter(|(other, _)| *other != unknown);
        let rest = others.fold(self.constant.clone(), |sum, (other, factor)| &sum + &(factor * &values[*other]));
        (-&rest).over(&self.factor(unknown)).unwrap_or(Fraction::ZERO)
    }
}

/// Inequalities that can be met, with every unknown eliminated after the other.
pub(super) struct Eliminated {
    /// In the order of elimination: an unknown, and what bounds it from below and from above once those after it are
    /// known.
    bounds: Vec<(usize, Vec<Inequality>, Vec<Inequality>)>,
}

/// Eliminates the unknowns in some order, each once; or says why nothing meets the inequalities: what some that contradict
/// each other follow from. Every unknown must be bounded on both sides.
pub(super) fn eliminate(
    order: impl IntoIterator<Item = usize>,
    inequalities: Vec<Inequality>,
) -> Result<Eliminated, Vec<usize>> {
    let mut rest = tightest(inequalities)?;
    let mut bounds = Vec::new();
    for unknown in order {
        let (bounding, others): (Vec<_>, Vec<_>) =
            rest.into_iter().partition(|inequality| !inequality.factor(unknown).is_zero());
        let (upper, lower): (Vec<_>, Vec<_>) =
            bounding.into_iter().partition(|inequality| inequality.factor(unknown).is_negative());
        let pairs = lower.iter().flat_map(|lower| upper.iter().map(move |upper| (lower, upper)));
        let combined = pairs.map(|(lower, upper)| Inequality::without(unknown, lower, upper));
        rest = tightest(combined.chain(others))?;
        bounds.push((unknown, lower, upper));
    }
    Ok(Eliminated { bounds })
}

impl Eliminated {
    /// Values that meet all, each halfway between its bounds.
    pub(super) fn values(&self) -> Vec<Fraction> {
        self.values_with(None)
    }

    /// The same for a value of the last unknown at one of its bounds or between them; at a bound that leaves the value
    /// out, the limit.
    pub(super) fn values_at(&self, last: &Fraction) -> Vec<Fraction> {
        self.values_with(Some(last))
    }

    fn values_with(&self, last: Option<&Fraction>) -> Vec<Fraction> {
        let mut values = vec![Fraction::ZERO; self.bounds.len()];
        for (later, (unknown, lower, upper)) in self.bounds.iter().rev().enumerate() {
            if let Some(last) = last.filter(|_| later == 0) {
                values[*unknown] = last.clone();
                continue;
            }
            let low = lower.iter().map(|inequality| inequality.bound(*unknown, &values)).max();
            let high = upper.iter().map(|inequality| inequality.bound(*unknown, &values)).min();
            values[*unknown] = match (low, high) {
                (Some(low), Some(high)) => low.halfway(&high),
                (Some(one), None) | (None, Some(one)) => one,
                (None, None) => Fraction::ZERO,
            };
        }
        values
    }

    /// The bounds of the last unknown, each with whether it leaves the value out.
    pub(super) fn last(&self) -> Option<((Fraction, bool), (Fraction, bool))> {
        let (unknown, lower, upper) = self.bounds.last()?;
        let bound = |inequality: &Inequality| (inequality.bound(*unknown, &[]), inequality.strict);
        let low = lower.iter().map(bound).max()?;
        let high = upper.iter().map(bound).min_by(|one, other| (&one.0, other.1).cmp(&(&other.0, one.1)))?;
        Some((low, high))
    }
}

/// The inequalities without those that a parallel one makes needless.
fn tightest(inequalities: impl IntoIterator<Item = Inequality>) -> Result<Vec<Inequality>, Vec<usize>> {
    let mut kept: Vec<Inequality> = Vec::new();
    let mut positions: HashMap<Vec<(usize, Fraction)>, usize> = HashMap::new();
    for inequality in inequalities {
        if inequality.is_false() {
            return Err(inequality.because);
        }
        if inequality.factors.is_empty() {
            continue;
        }
        let inequality = inequality.normal();
        let position = *positions.entry(inequality.factors.clone()).or_insert(kept.len());
        match kept.get_mut(position) {
            None => kept.push(inequality),
            Some(known) => {
                if (&inequality.constant, known.strict) < (&known.constant, inequality.strict) {
                    *known = inequality;
                }
            }
        }
    }
    Ok(kept)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inequality(factors: &[(usize, i128)], constant: i128, strict: bool, because: usize) -> Inequality {
        let factors = factors.iter().map(|&(unknown, factor)| (unknown, Fraction::from(factor))).collect();
        Inequality { factors, constant: Fraction::from(constant), strict, because: vec![because] }
    }

    #[test]
    fn a_point_is_found_or_a_contradiction() {
        // 0 < x, x + y <= 4, y > 2 x, y <= 3
        let mut system = vec![
            inequality(&[(0, 1)], 0, true, 0),
            inequality(&[(0, -1), (1, -1)], 4, false, 1),
            inequality(&[(0, -2), (1, 1)], 0, true, 2),
            inequality(&[(1, -1)], 3, false, 3),
        ];
        let values = eliminate(0..2, system.clone()).unwrap().values();
        for inequality in &system {
            let sum = inequality.factors.iter().map(|(unknown, factor)| &values[*unknown] * factor);
            let sum = sum.fold(inequality.constant.clone(), |sum, part| &sum + &part);
            let met = if inequality.strict { sum > Fraction::ZERO } else { sum >= Fraction::ZERO };
            assert!(met, "{values:?}");
        }
        // x >= 4/3 touches y > 2 x and x + y <= 4 in one point that the strict one leaves out.
        system.push(inequality(&[(0, 3)], -4, false, 4));
        assert_eq!(eliminate(0..2, system).err().unwrap(), [1, 2, 4]);
    }
}
