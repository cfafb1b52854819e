//! Fractions that never overflow: 128-bit integers while they fit, arbitrarily long ones where they do not.

use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{CheckedAdd, CheckedDiv, CheckedMul, CheckedSub, Signed, ToPrimitive, Zero};

use super::quantity::{nearest, times_pi};

/// An exact fraction. Every operation and comparison is exact.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Fraction(Form);

/// A number that fits the short form is never kept in the long one, so equal numbers look equal.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Form {
    Short(Ratio<i128>),
    Long(Box<BigRational>),
}

impl Fraction {
    /// Zero.
    pub const ZERO: Self = Self(Form::Short(Ratio::new_raw(0, 1)));
    /// One.
    pub const ONE: Self = Self(Form::Short(Ratio::new_raw(1, 1)));

    /// `numerator / denominator`; a zero denominator counts as one.
    pub fn new(numerator: i128, denominator: i128) -> Self {
        Self(Form::Short(Ratio::new(numerator, if denominator == 0 { 1 } else { denominator })))
    }

    pub(super) fn short(ratio: Ratio<i128>) -> Self {
        Self(Form::Short(ratio))
    }

    pub(super) fn to_short(&self) -> Option<Ratio<i128>> {
        match &self.0 {
            Form::Short(ratio) => Some(*ratio),
            Form::Long(_) => None,
        }
    }

    pub(super) fn long(value: BigRational) -> Self {
        match (value.numer().to_i128(), value.denom().to_i128()) {
            (Some(numerator), Some(denominator)) => Self(Form::Short(Ratio::new_raw(numerator, denominator))),
            _ => Self(Form::Long(Box::new(value))),
        }
    }

    pub(super) fn to_long(&self) -> BigRational {
        match &self.0 {
            Form::Short(ratio) => BigRational::new_raw((*ratio.numer()).into(), (*ratio.denom()).into()),
            Form::Long(long) => (**long).clone(),
        }
    }

    /// True below zero.
    pub fn is_negative(&self) -> bool {
        match &self.0 {
            Form::Short(ratio) => ratio.is_negative(),
            Form::Long(long) => long.is_negative(),
        }
    }

    /// True for zero.
    pub fn is_zero(&self) -> bool {
        matches!(&self.0, Form::Short(ratio) if ratio.is_zero())
    }

    /// The quotient; `None` for a divisor of zero.
    #[must_use]
    pub fn over(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_zero() {
            return None;
        }
        Some(self.apply(divisor, Ratio::checked_div, |a, b| a / b))
    }

    /// The number halfway between two.
    #[must_use]
    pub fn halfway(&self, other: &Self) -> Self {
        &(self + other) * &Self::new(1, 2)
    }

    /// The nearest `f64`.
    pub fn to_f64(&self) -> f64 {
        self.to_f64_times_pi(0)
    }

    /// The nearest `f64` to this number of `π^power`.
    pub fn to_f64_times_pi(&self, power: i8) -> f64 {
        let short = self.to_short().filter(|_| power == 0).and_then(|short| nearest(&short));
        short.unwrap_or_else(|| times_pi(self.to_long(), power).to_f64().unwrap_or(f64::NAN))
    }

    fn apply(
        &self,
        other: &Self,
        short: impl Fn(&Ratio<i128>, &Ratio<i128>) -> Option<Ratio<i128>>,
        long: impl Fn(BigRational, BigRational) -> BigRational,
    ) -> Self {
        if let (Form::Short(a), Form::Short(b)) = (&self.0, &other.0)
            && let Some(result) = short(a, b).filter(|result| *result.numer() != i128::MIN)
        {
            return Self(Form::Short(result));
        }
        Self::long(long(self.to_long(), other.to_long()))
    }
}

impl Add for &Fraction {
    type Output = Fraction;
    fn add(self, other: Self) -> Fraction {
        self.apply(other, Ratio::checked_add, |a, b| a + b)
    }
}

impl Sub for &Fraction {
    type Output = Fraction;
    fn sub(self, other: Self) -> Fraction {
        self.apply(other, Ratio::checked_sub, |a, b| a - b)
    }
}

impl Mul for &Fraction {
    type Output = Fraction;
    fn mul(self, other: Self) -> Fraction {
        self.apply(other, Ratio::checked_mul, |a, b| a * b)
    }
}

impl Neg for &Fraction {
    type Output = Fraction;
    fn neg(self) -> Fraction {
        &Fraction::ZERO - self
    }
}

impl From<i128> for Fraction {
    fn from(whole: i128) -> Self {
        Self::new(whole, 1)
    }
}

impl PartialOrd for Fraction {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Fraction {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Form::Short(a), Form::Short(b)) => {
                let left = a.numer().checked_mul(b.denom());
                let right = b.numer().checked_mul(a.denom());
                match (left, right) {
                    (Some(left), Some(right)) => left.cmp(&right),
                    _ => long_cross(a, b).cmp(&long_cross(b, a)),
                }
            }
            _ => self.to_long().cmp(&other.to_long()),
        }
    }
}

fn long_cross(a: &Ratio<i128>, b: &Ratio<i128>) -> BigInt {
    BigInt::from(*a.numer()) * BigInt::from(*b.denom())
}

impl fmt::Display for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Form::Short(ratio) => ratio.fmt(f),
            Form::Long(long) => long.fmt(f),
        }
    }
}

impl fmt::Debug for Fraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_stays_exact() {
        let large = Fraction::from(i128::MAX);
        let square = &large * &large;
        assert!(square > large);
        assert_eq!(square.over(&large), Some(large.clone()));
        assert_eq!(&(&square + &Fraction::ONE) - &square, Fraction::ONE);
        let (third, more) = (Fraction::new(1, 3), Fraction::new(i128::MAX / 3 + 1, i128::MAX));
        assert!(third < more);
        assert_eq!(&Fraction::from(i128::MIN + 1) - &Fraction::ONE, -&(&large + &Fraction::ONE));
    }

    #[test]
    fn nothing_is_divided_by_zero() {
        assert_eq!(Fraction::ONE.over(&Fraction::ZERO), None);
        assert_eq!(Fraction::ONE.over(&Fraction::from(-4)), Some(Fraction::new(-1, 4)));
        assert_eq!(Fraction::ZERO.halfway(&Fraction::ONE).to_f64(), 0.5);
    }
}
