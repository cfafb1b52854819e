//! Exact quantities: a rational number in SI units, times a whole power of π, with a dimension.
//!
//! Angles are why π is here: 90 deg is π/2 rad exactly, and stays so until it is rounded once to `f64`.

use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};

use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use num_traits::{CheckedAdd, CheckedDiv, CheckedMul, CheckedSub, Signed, ToPrimitive, Zero};

use super::Fraction;

/// An exact number `ratio · π^pi`. Zero has no power of π. Operations answer `None` where the result does not fit
/// a fraction of 128-bit integers; they never round.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Exact {
    ratio: Ratio<i128>,
    pi: i8,
}

/// π to 60 digits, as a fraction over a power of ten.
const PI_DIGITS: &str = "3141592653589793238462643383279502884197169399375105820974944";
const PI_DECIMALS: u32 = 60;

impl Exact {
    /// Zero.
    pub const ZERO: Self = Self { ratio: Ratio::new_raw(0, 1), pi: 0 };
    /// One.
    pub const ONE: Self = Self { ratio: Ratio::new_raw(1, 1), pi: 0 };

    /// `numerator / denominator · π^pi`; a zero denominator counts as one.
    pub fn new(numerator: i128, denominator: i128, pi: i8) -> Self {
        let ratio = Ratio::new(numerator, if denominator == 0 { 1 } else { denominator });
        Self { ratio, pi: if ratio.is_zero() { 0 } else { pi } }
    }

    /// Reads a decimal literal such as `-4`, `0.25` or `1.5e-3`, exactly. `None` where it is not one, or does not fit.
    pub fn parse(text: &str) -> Option<Self> {
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().ok()?),
            None => (text, 0),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: i128 = format!("{whole}{fraction}").parse().ok()?;
        let shift = exponent.checked_sub(i32::try_from(fraction.len()).ok()?)?;
        let power = 10_i128.checked_pow(shift.unsigned_abs())?;
        if shift < 0 { Some(Self::new(digits, power, 0)) } else { Some(Self::new(digits.checked_mul(power)?, 1, 0)) }
    }

    /// The fraction without its power of π.
    pub const fn ratio(self) -> Ratio<i128> {
        self.ratio
    }

    /// The power of π.
    pub const fn pi_power(self) -> i8 {
        self.pi
    }

    /// True for zero.
    pub fn is_zero(self) -> bool {
        self.ratio.is_zero()
    }

    /// True below zero.
    pub fn is_negative(self) -> bool {
        self.ratio.is_negative()
    }

    /// The product.
    #[must_use]
    pub fn times(self, other: Self) -> Option<Self> {
        let ratio = self.ratio.checked_mul(&other.ratio)?;
        Some(Self { ratio, pi: if ratio.is_zero() { 0 } else { self.pi.checked_add(other.pi)? } })
    }

    /// The quotient; `None` also for a divisor of zero.
    #[must_use]
    pub fn over(self, other: Self) -> Option<Self> {
        if other.is_zero() {
            return None;
        }
        let ratio = self.ratio.checked_div(&other.ratio)?;
        Some(Self { ratio, pi: if ratio.is_zero() { 0 } else { self.pi.checked_sub(other.pi)? } })
    }

    /// The sum; `None` also for different powers of π.
    #[must_use]
    pub fn plus(self, other: Self) -> Option<Self> {
        let pi = self.common_pi(other)?;
        let ratio = self.ratio.checked_add(&other.ratio)?;
        Some(Self { ratio, pi: if ratio.is_zero() { 0 } else { pi } })
    }

    /// The difference; `None` also for different powers of π.
    #[must_use]
    pub fn minus(self, other: Self) -> Option<Self> {
        let pi = self.common_pi(other)?;
        let ratio = self.ratio.checked_sub(&other.ratio)?;
        Some(Self { ratio, pi: if ratio.is_zero() { 0 } else { pi } })
    }

    /// The power of π of two numbers; zero has whichever is wanted.
    fn common_pi(self, other: Self) -> Option<i8> {
        match (self.is_zero(), other.is_zero()) {
            (true, _) => Some(other.pi),
            (_, true) => Some(self.pi),
            _ => (self.pi == other.pi).then_some(self.pi),
        }
    }

    /// A number strictly between two: their mean where it can be kept exactly.
    #[must_use]
    pub fn between(self, other: Self) -> Option<Self> {
        let mean = self.plus(other).and_then(|sum| sum.over(Self::new(2, 1, 0)));
        let near = || {
            let ratio = Ratio::approximate_float(f64::midpoint(self.to_f64(), other.to_f64()))?;
            Some(Self { ratio, pi: 0 })
        };
        let (low, high) = (self.min(other), self.max(other));
        mean.or_else(near).filter(|between| low < *between && *between < high)
    }

    /// This number to a whole power.
    #[must_use]
    pub fn power(self, exponent: i32) -> Option<Self> {
        let mut result = Self::ONE;
        for _ in 0..exponent.unsigned_abs() {
            result = result.times(self)?;
        }
        if exponent < 0 { Self::ONE.over(result) } else { Some(result) }
    }

    /// The nearest `f64`: the only rounding a literal ever sees.
    pub fn to_f64(self) -> f64 {
        nearest(&self.ratio).filter(|_| self.pi == 0).unwrap_or_else(|| self.to_big().to_f64().unwrap_or(f64::NAN))
    }

    /// The whole number this is, if it is one.
    pub fn to_integer(self) -> Option<i128> {
        (self.pi == 0 && self.ratio.is_integer()).then(|| self.ratio.to_integer())
    }

    /// Exactly, in units of `π^pi`, where this number is zero or has that power of π; else with π to 60 digits, which
    /// no two literals can tie.
    pub fn to_fraction(self, pi: i8) -> Fraction {
        if self.pi == pi || self.is_zero() {
            return Fraction::short(self.ratio);
        }
        Fraction::long(Self { ratio: self.ratio, pi: self.pi.saturating_sub(pi) }.to_big())
    }

    /// A fraction of `π^pi`; `None` where it is too long to be kept.
    pub fn from_fraction(fraction: &Fraction, pi: i8) -> Option<Self> {
        Some(Self { ratio: fraction.to_short()?, pi: if fraction.is_zero() { 0 } else { pi } })
    }

    /// As an arbitrarily long fraction, π to 60 digits.
    fn to_big(self) -> BigRational {
        times_pi(BigRational::new((*self.ratio.numer()).into(), (*self.ratio.denom()).into()), self.pi)
    }
}

/// The nearest `f64`, where both parts are `f64`s themselves: a division rounds once.
pub(super) fn nearest(ratio: &Ratio<i128>) -> Option<f64> {
    const MOST: u128 = 1 << f64::MANTISSA_DIGITS;
    let (numerator, denominator) = (*ratio.numer(), *ratio.denom());
    let is_kept = numerator.unsigned_abs() <= MOST && denominator.unsigned_abs() <= MOST;
    is_kept.then_some(numerator as f64 / denominator as f64)
}

/// `value · π^power`, π to 60 digits.
pub(super) fn times_pi(mut value: BigRational, power: i8) -> BigRational {
    if power == 0 {
        return value;
    }
    let pi = BigRational::new(
        BigInt::parse_bytes(PI_DIGITS.as_bytes(), 10).unwrap_or_default(),
        BigInt::from(10).pow(PI_DECIMALS),
    );
    for _ in 0..power.unsigned_abs() {
        if power > 0 {
            value *= &pi;
        } else {
            value /= &pi;
        }
    }
    value
}

impl PartialOrd for Exact {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Exact {
    /// Exact for equal powers of π; for different ones π's 60 digits decide, which no two literals can tie.
    fn cmp(&self, other: &Self) -> Ordering {
        if self.pi == other.pi { self.ratio.cmp(&other.ratio) } else { self.to_big().cmp(&other.to_big()) }
    }
}

impl Hash for Exact {
    /// The fraction is in lowest terms, so its parts are enough.
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.ratio.numer(), self.ratio.denom(), self.pi).hash(state);
    }
}

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.to_f64())
    }
}

/// Powers of the base quantities. Angle is a base quantity here, so that radians are not mistaken for plain numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, PartialOrd, Ord)]
pub struct Dimension {
    /// Powers of metre, kilogram, second, ampere, kelvin and radian, in this order.
    pub powers: [i8; 6],
}

const BASE_SYMBOLS: [&str; 6] = ["m", "kg", "s", "A", "K", "rad"];

/// Dimensions that engineers call by name, and the SI units with names of their own.
const NAMED: [(Dimension, &str, Option<&str>); 15] = [
    (Dimension::NONE, "a plain number", None),
    (Dimension::LENGTH, "a length", None),
    (Dimension::MASS, "a mass", None),
    (Dimension::TIME, "a time", None),
    (Dimension::of([0, 0, 0, 1, 0, 0]), "a current", None),
    (Dimension::of([0, 0, 0, 0, 1, 0]), "a temperature", None),
    (Dimension::ANGLE, "an angle", None),
    (Dimension::SPEED, "a speed", None),
    (Dimension::ACCELERATION, "an acceleration", None),
    (Dimension::FORCE, "a force", Some("N")),
    (Dimension::TURN_RATE, "a turn rate", None),
    (Dimension::of([0, 0, -1, 0, 0, 0]), "a frequency", Some("Hz")),
    (Dimension::of([2, 1, -3, -1, 0, 0]), "a voltage", Some("V")),
    (Dimension::of([2, 1, -3, 0, 0, 0]), "a power", Some("W")),
    (Dimension::of([-1, 1, -2, 0, 0, 0]), "a pressure", Some("Pa")),
];

impl Dimension {
    /// A plain number.
    pub const NONE: Self = Self::of([0; 6]);
    /// Length.
    pub const LENGTH: Self = Self::of([1, 0, 0, 0, 0, 0]);
    /// Mass.
    pub const MASS: Self = Self::of([0, 1, 0, 0, 0, 0]);
    /// Time.
    pub const TIME: Self = Self::of([0, 0, 1, 0, 0, 0]);
    /// Angle.
    pub const ANGLE: Self = Self::of([0, 0, 0, 0, 0, 1]);
    /// Speed.
    pub const SPEED: Self = Self::of([1, 0, -1, 0, 0, 0]);
    /// Acceleration.
    pub const ACCELERATION: Self = Self::of([1, 0, -2, 0, 0, 0]);
    /// Force.
    pub const FORCE: Self = Self::of([1, 1, -2, 0, 0, 0]);
    /// Turn rate.
    pub const TURN_RATE: Self = Self::of([0, 0, -1, 0, 0, 1]);

    /// The dimension with these powers of metre, kilogram, second, ampere, kelvin and radian.
    pub const fn of(powers: [i8; 6]) -> Self {
        Self { powers }
    }

    /// The dimension of a product of a value of this dimension and one of `other` to the power `exponent`;
    /// `None` where a power leaves `i8`.
    #[must_use]
    pub fn times(self, other: Self, exponent: i8) -> Option<Self> {
        let mut powers = self.powers;
        for (power, factor) in powers.iter_mut().zip(other.powers) {
            *power = power.checked_add(factor.checked_mul(exponent)?)?;
        }
        Some(Self { powers })
    }

    /// The SI unit of the dimension, such as `N` or `m/s^2`; `1` for a plain number.
    pub fn si_unit(self) -> String {
        if let Some((_, _, Some(symbol))) = NAMED.iter().find(|(dimension, ..)| *dimension == self) {
            return (*symbol).to_owned();
        }
        let part = |sign: i8| {
            let factors = BASE_SYMBOLS.iter().zip(self.powers).filter(|(_, power)| power.signum() == sign);
            let names = factors.map(|(symbol, power)| match power.unsigned_abs() {
                1 => (*symbol).to_owned(),
                power => format!("{symbol}^{power}"),
            });
            names.collect::<Vec<_>>()
        };
        match (part(1).join(" "), part(-1).join("/")) {
            (above, below) if below.is_empty() => {
                if above.is_empty() {
                    "1".to_owned()
                } else {
                    above
                }
            }
            (above, below) => format!("{}/{below}", if above.is_empty() { "1" } else { &above }),
        }
    }
}

impl fmt::Display for Dimension {
    /// In words where there are some: `a speed (m/s)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match NAMED.iter().find(|(dimension, ..)| dimension == self) {
            Some((Self::NONE, name, _)) => f.write_str(name),
            Some((_, name, _)) => write!(f, "{name} ({})", self.si_unit()),
            None => write!(f, "a quantity in {}", self.si_unit()),
        }
    }
}

/// An exact value in SI units with its dimension.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Quantity {
    /// The value in the SI unit of its dimension.
    pub value: Exact,
    /// What it measures.
    pub dimension: Dimension,
}

impl Quantity {
    /// A value in SI units.
    pub const fn new(value: Exact, dimension: Dimension) -> Self {
        Self { value, dimension }
    }

    /// The nearest `f64` in SI units.
    pub fn to_f64(self) -> f64 {
        self.value.to_f64()
    }

    /// A time in whole nanoseconds; `None` for another dimension, below zero, past `u64`, or between two nanoseconds.
    pub fn to_nanoseconds(self) -> Option<u64> {
        let nanoseconds = self.value.times(Exact::new(1_000_000_000, 1, 0))?;
        (self.dimension == Dimension::TIME).then_some(())?;
        u64::try_from(nanoseconds.to_integer()?).ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_round_once() {
        for text in ["0.1", "0.26", "-4", "1e-3", "123456.789", "0.333333333333333333", "2.5e5"] {
            assert_eq!(Exact::parse(text).unwrap().to_f64(), text.parse::<f64>().unwrap(), "{text}");
        }
        assert_eq!(Exact::new(1, 2, 1).to_f64(), std::f64::consts::FRAC_PI_2);
        assert_eq!(Exact::parse("1e99"), None);
        assert_eq!(Exact::parse("1.2.3"), None);
    }

    #[test]
    fn angles_compare_exactly_with_radians() {
        let half_turn = Exact::new(1, 1, 1);
        assert!(Exact::parse("3.14159265358979").unwrap() < half_turn);
        assert!(Exact::parse("3.14159265358980").unwrap() > half_turn);
    }

    #[test]
    fn sums_keep_their_power_of_pi() {
        let (quarter, half) = (Exact::new(1, 2, 1), Exact::new(1, 1, 1));
        assert_eq!(quarter.plus(quarter), Some(half));
        assert_eq!(half.minus(half), Some(Exact::ZERO));
        assert_eq!(half.plus(Exact::ONE), None);
        assert_eq!(Exact::ZERO.between(half), Some(quarter));
        let mixed = half.between(Exact::ONE).unwrap();
        assert!(Exact::ONE < mixed && mixed < half);
        assert_eq!(half.between(half), None);
    }

    #[test]
    fn nanoseconds_are_exact() {
        let seconds = |text| Quantity::new(Exact::parse(text).unwrap(), Dimension::TIME);
        assert_eq!(seconds("0.1").to_nanoseconds(), Some(100_000_000));
        assert_eq!(seconds("-1").to_nanoseconds(), None);
        assert_eq!(seconds("0.0000000001").to_nanoseconds(), None);
    }
}
