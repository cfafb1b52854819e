//! The units the language knows.

use super::{Dimension, Exact};

/// One name that may stand in a unit.
#[derive(Debug, Clone, Copy)]
pub struct UnitName {
    /// As it is written.
    pub name: &'static str,
    /// What it stands for, for the reference and for hovers.
    pub meaning: &'static str,
    numerator: i128,
    denominator: i128,
    pi: i8,
    /// What it measures.
    pub dimension: Dimension,
}

impl UnitName {
    /// One of it, in SI units.
    pub fn scale(&self) -> Exact {
        Exact::new(self.numerator, self.denominator, self.pi)
    }
}

/// A unit as a declaration names it, such as `cm/s`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Unit {
    /// As written, for messages.
    pub text: String,
    /// One of it, in SI units.
    pub scale: Exact,
    /// What it measures.
    pub dimension: Dimension,
}

impl Unit {
    /// The unit of a plain number.
    pub fn one() -> Self {
        Self { text: "1".to_owned(), scale: Exact::ONE, dimension: Dimension::NONE }
    }

    /// What a contact tells: 1 and 0 as `set` and `clear`.
    pub fn contact() -> Self {
        Self { text: "contact".to_owned(), ..Self::one() }
    }

    /// A unit written as in the language, such as `cm/s^2`; `None` for one that is not.
    pub fn parse(text: &str) -> Option<Self> {
        let (mut scale, mut dimension) = (Exact::ONE, Dimension::NONE);
        let mut sign = 1;
        for factor in text.split_inclusive(['/', '*']) {
            let name = factor.trim_end_matches(['/', '*']).trim();
            let (name, power) = name.split_once('^').unwrap_or((name, "1"));
            let (known, power) = (find_unit(name)?, sign * power.parse::<i8>().ok()?);
            scale = scale.times(known.scale().power(power.into())?)?;
            dimension = dimension.times(known.dimension, power)?;
            sign = if factor.ends_with('/') { -1 } else { 1 };
        }
        Some(Self { text: text.to_owned(), scale, dimension })
    }

    /// An SI value in this unit, for people to read.
    pub fn show(&self, si: f64) -> String {
        let value = si / self.scale.to_f64();
        let rounded = (value * 1e6).round() / 1e6;
        match self.text.as_str() {
            "1" => format!("{rounded}"),
            "contact" => if value > 0.5 { "set" } else { "clear" }.to_owned(),
            text => format!("{rounded} {text}"),
        }
    }
}

/// Nanoseconds for people to read, in the largest unit of which there is one: `1.5 s`, `20 ms`.
pub fn show_time(nanoseconds: u64) -> String {
    let seconds = nanoseconds as f64 / 1e9;
    let unit = ["s", "ms", "us"].into_iter().filter_map(Unit::parse).find(|unit| seconds >= unit.scale.to_f64());
    unit.map_or_else(|| format!("{nanoseconds} ns"), |unit| unit.show(seconds))
}

const fn unit(name: &'static str, meaning: &'static str, scale: (i128, i128, i8), powers: [i8; 6]) -> UnitName {
    UnitName { name, meaning, numerator: scale.0, denominator: scale.1, pi: scale.2, dimension: Dimension::of(powers) }
}

/// Every unit name, with its exact size.
pub const UNITS: &[UnitName] = &[
    unit("1", "a plain number", (1, 1, 0), [0; 6]),
    unit("%", "a hundredth", (1, 100, 0), [0; 6]),
    unit("m", "metre", (1, 1, 0), [1, 0, 0, 0, 0, 0]),
    unit("km", "kilometre", (1000, 1, 0), [1, 0, 0, 0, 0, 0]),
    unit("cm", "centimetre", (1, 100, 0), [1, 0, 0, 0, 0, 0]),
    unit("mm", "millimetre", (1, 1000, 0), [1, 0, 0, 0, 0, 0]),
    unit("um", "micrometre", (1, 1_000_000, 0), [1, 0, 0, 0, 0, 0]),
    unit("inch", "inch, 25.4 mm", (254, 10_000, 0), [1, 0, 0, 0, 0, 0]),
    unit("ft", "foot, 12 inch", (3048, 10_000, 0), [1, 0, 0, 0, 0, 0]),
    unit("kg", "kilogram", (1, 1, 0), [0, 1, 0, 0, 0, 0]),
    unit("g", "gram", (1, 1000, 0), [0, 1, 0, 0, 0, 0]),
    unit("t", "tonne", (1000, 1, 0), [0, 1, 0, 0, 0, 0]),
    unit("lb", "pound", (45_359_237, 100_000_000, 0), [0, 1, 0, 0, 0, 0]),
    unit("s", "second", (1, 1, 0), [0, 0, 1, 0, 0, 0]),
    unit("ms", "millisecond", (1, 1000, 0), [0, 0, 1, 0, 0, 0]),
    unit("us", "microsecond", (1, 1_000_000, 0), [0, 0, 1, 0, 0, 0]),
    unit("ns", "nanosecond", (1, 1_000_000_000, 0), [0, 0, 1, 0, 0, 0]),
    unit("min", "minute", (60, 1, 0), [0, 0, 1, 0, 0, 0]),
    unit("h", "hour", (3600, 1, 0), [0, 0, 1, 0, 0, 0]),
    unit("Hz", "hertz", (1, 1, 0), [0, 0, -1, 0, 0, 0]),
    unit("kHz", "kilohertz", (1000, 1, 0), [0, 0, -1, 0, 0, 0]),
    unit("rad", "radian", (1, 1, 0), [0, 0, 0, 0, 0, 1]),
    unit("mrad", "milliradian", (1, 1000, 0), [0, 0, 0, 0, 0, 1]),
    unit("deg", "degree, π/180 rad", (1, 180, 1), [0, 0, 0, 0, 0, 1]),
    unit("turn", "full turn, 2π rad", (2, 1, 1), [0, 0, 0, 0, 0, 1]),
    unit("rpm", "turns a minute", (2, 60, 1), [0, 0, -1, 0, 0, 1]),
    unit("N", "newton", (1, 1, 0), [1, 1, -2, 0, 0, 0]),
    unit("kN", "kilonewton", (1000, 1, 0), [1, 1, -2, 0, 0, 0]),
    unit("mN", "millinewton", (1, 1000, 0), [1, 1, -2, 0, 0, 0]),
    unit("Pa", "pascal", (1, 1, 0), [-1, 1, -2, 0, 0, 0]),
    unit("kPa", "kilopascal", (1000, 1, 0), [-1, 1, -2, 0, 0, 0]),
    unit("J", "joule", (1, 1, 0), [2, 1, -2, 0, 0, 0]),
    unit("W", "watt", (1, 1, 0), [2, 1, -3, 0, 0, 0]),
    unit("kW", "kilowatt", (1000, 1, 0), [2, 1, -3, 0, 0, 0]),
    unit("V", "volt", (1, 1, 0), [2, 1, -3, -1, 0, 0]),
    unit("mV", "millivolt", (1, 1000, 0), [2, 1, -3, -1, 0, 0]),
    unit("A", "ampere", (1, 1, 0), [0, 0, 0, 1, 0, 0]),
    unit("mA", "milliampere", (1, 1000, 0), [0, 0, 0, 1, 0, 0]),
    unit("ohm", "ohm", (1, 1, 0), [2, 1, -3, -2, 0, 0]),
    unit("K", "kelvin", (1, 1, 0), [0, 0, 0, 0, 1, 0]),
];

/// The unit of that name.
pub fn find_unit(name: &str) -> Option<&'static UnitName> {
    UNITS.iter().find(|unit| unit.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversions_are_exact() {
        let convert =
            |number: &str, unit: &str| Exact::parse(number).unwrap().times(find_unit(unit).unwrap().scale()).unwrap();
        assert_eq!(convert("26", "cm"), Exact::parse("0.26").unwrap());
        assert_eq!(convert("12", "inch"), convert("1", "ft"));
        assert_eq!(convert("180", "deg"), convert("0.5", "turn"));
        assert_eq!(convert("90", "deg").to_f64(), std::f64::consts::FRAC_PI_2);
        assert_eq!(convert("30", "%"), Exact::parse("0.3").unwrap());
        assert_eq!(convert("58", "ms"), Exact::parse("0.058").unwrap());
    }

    #[test]
    fn no_unit_is_named_twice() {
        for (index, unit) in UNITS.iter().enumerate() {
            assert!(UNITS[index + 1..].iter().all(|other| other.name != unit.name), "{}", unit.name);
        }
    }
}
