//! Numbers and units to exact SI.

use super::{Lower, invalid};
use crate::base::{Dimension, Exact, Quantity, Span, UNITS, Unit, find_unit};
use crate::diag::{self, Diagnostic};
use crate::syntax::ast;

impl Lower<'_> {
    /// A unit as a declaration names it.
    pub(super) fn unit(&mut self, unit: &ast::Unit) -> Option<Unit> {
        let mut text = String::new();
        let mut scale = Exact::ONE;
        let mut dimension = Dimension::NONE;
        for factor in &unit.factors {
            let Some(known) = find_unit(&factor.name.text) else {
                self.report(unknown_unit(&factor.name));
                return None;
            };
            text.push_str(if factor.power < 0 {
                if text.is_empty() { "1/" } else { "/" }
            } else if text.is_empty() {
                ""
            } else {
                "*"
            });
            text.push_str(known.name);
            if factor.power.unsigned_abs() > 1 {
                text += &format!("^{}", factor.power.unsigned_abs());
            }
            let power = i8::try_from(factor.power).ok();
            let scaled = known.scale().power(factor.power.clamp(-64, 64)).and_then(|factor| scale.times(factor));
            match (scaled, power.and_then(|power| dimension.times(known.dimension, power))) {
                (Some(scaled), Some(times)) => (scale, dimension) = (scaled, times),
                _ => {
                    self.report(too_long(unit.span, "this unit"));
                    return None;
                }
            }
        }
        Some(Unit { text, scale, dimension })
    }

    /// A literal without a unit.
    pub(super) fn number(&mut self, number: &ast::Number) -> Option<Exact> {
        let value = Exact::parse(&number.text);
        if value.is_none() {
            self.report(too_long(number.span, "this number"));
        }
        value
    }

    /// A whole number of at least `least`.
    pub(super) fn whole(&mut self, number: &ast::Number, least: u64, what: &str) -> Option<u64> {
        let value = self.number(number)?;
        let whole = value.to_integer().and_then(|whole| u64::try_from(whole).ok()).filter(|&whole| whole >= least);
        if whole.is_none() {
            let message = format!("{what} is a whole number from {least}, not {}", number.text);
            self.report(invalid(number.span, message));
        }
        whole
    }

    /// A quantity with its own unit, in SI. A plain number has no dimension.
    pub(super) fn quantity(&mut self, quantity: &ast::Quantity) -> Option<Quantity> {
        let number = self.number(&quantity.number)?;
        let Some(unit) = &quantity.unit else { return Some(Quantity::new(number, Dimension::NONE)) };
        let unit = self.unit(unit)?;
        let Some(value) = number.times(unit.scale) else {
            self.report(too_long(quantity.span, "this quantity"));
            return None;
        };
        Some(Quantity::new(value, unit.dimension))
    }

    /// A quantity inside a declaration that names its unit: a plain number takes it.
    pub(super) fn quantity_in(&mut self, quantity: &ast::Quantity, unit: &Unit) -> Option<Exact> {
        if quantity.unit.is_some() {
            return self.quantity_of(quantity, unit.dimension, Some(unit));
        }
        let value = self.number(&quantity.number)?.times(unit.scale);
        if value.is_none() {
            self.report(too_long(quantity.span, "this quantity"));
        }
        value
    }

    /// A quantity of a dimension. `unit` is what to suggest where the unit is left out.
    pub(super) fn quantity_of(
        &mut self,
        quantity: &ast::Quantity,
        dimension: Dimension,
        unit: Option<&Unit>,
    ) -> Option<Exact> {
        let found = self.quantity(quantity)?;
        if found.dimension == dimension {
            return Some(found.value);
        }
        self.report(if quantity.unit.is_none() {
            missing_unit(quantity.span, &quantity.number.text, dimension, unit)
        } else {
            mismatch(quantity.span, found.dimension, dimension)
        });
        None
    }

    /// The same, above 0.
    pub(super) fn positive(&mut self, quantity: &ast::Quantity, dimension: Dimension, what: &str) -> Option<f64> {
        let value = self.quantity_of(quantity, dimension, None)?;
        if value <= Exact::ZERO {
            self.report(invalid(quantity.span, format!("{what} must be above 0")));
            return None;
        }
        Some(value.to_f64())
    }

    /// A time of at least 0 in whole nanoseconds.
    pub(super) fn nanoseconds(&mut self, quantity: &ast::Quantity) -> Option<u64> {
        let value = self.quantity_of(quantity, Dimension::TIME, None)?;
        let nanoseconds = Quantity::new(value, Dimension::TIME).to_nanoseconds();
        if nanoseconds.is_none() {
            self.report(if value.is_negative() {
                invalid(quantity.span, "a time cannot be negative")
            } else {
                invalid(quantity.span, "this time is not a whole number of nanoseconds, or too long to count in them")
            });
        }
        nanoseconds
    }

    /// A time above 0 in whole nanoseconds.
    pub(super) fn positive_nanoseconds(&mut self, quantity: &ast::Quantity, what: &str) -> Option<u64> {
        let nanoseconds = self.nanoseconds(quantity)?;
        if nanoseconds == 0 {
            self.report(invalid(quantity.span, format!("{what} must be above 0")));
            return None;
        }
        Some(nanoseconds)
    }

    /// `low .. high` inside a declaration that names its unit.
    pub(super) fn range_in(&mut self, range: &ast::Range, unit: &Unit) -> Option<(Exact, Exact)> {
        let (low, high) = (self.quantity_in(&range.low, unit), self.quantity_in(&range.high, unit));
        let (low, high) = (low?, high?);
        if low >= high {
            self.report(empty_range(range.span));
            return None;
        }
        Some((low, high))
    }
}

pub(super) fn empty_range(span: Span) -> Diagnostic {
    Diagnostic::new(&diag::rules::EMPTY_RANGE, span, "the lower end of this range is not below its upper end")
        .help("write the smaller number first")
}

pub(super) fn mismatch(span: Span, found: Dimension, wanted: Dimension) -> Diagnostic {
    Diagnostic::new(&diag::rules::DIMENSION_MISMATCH, span, format!("this is {found}, but {wanted} is needed"))
}

fn missing_unit(span: Span, number: &str, dimension: Dimension, unit: Option<&Unit>) -> Diagnostic {
    let example = unit.map_or_else(|| example_unit(dimension), |unit| unit.text.clone());
    Diagnostic::new(&diag::rules::MISSING_UNIT, span, format!("`{number}` needs a unit"))
        .here(format!("{dimension} is needed here"))
        .help(format!("write `{number} {example}`, or another unit of the same dimension"))
}

/// A unit that newcomers know for a dimension.
fn example_unit(dimension: Dimension) -> String {
    let known = UNITS.iter().find(|unit| unit.dimension == dimension && unit.scale() == Exact::ONE);
    match dimension {
        Dimension::ANGLE => "deg".to_owned(),
        _ => known.map_or_else(|| dimension.si_unit(), |unit| unit.name.to_owned()),
    }
}

/// What people write for a unit, in lower case, and what to write instead.
const ALIASES: &[(&str, &str)] = &[
    ("sec", "`s`"),
    ("second", "`s`"),
    ("seconds", "`s`"),
    ("msec", "`ms`"),
    ("millisecond", "`ms`"),
    ("milliseconds", "`ms`"),
    ("minute", "`min`"),
    ("minutes", "`min`"),
    ("hour", "`h`"),
    ("hours", "`h`"),
    ("meter", "`m`"),
    ("meters", "`m`"),
    ("metre", "`m`"),
    ("metres", "`m`"),
    ("centimeter", "`cm`"),
    ("centimeters", "`cm`"),
    ("inches", "`inch`"),
    ("feet", "`ft`"),
    ("degree", "`deg`"),
    ("degrees", "`deg`"),
    ("radian", "`rad`"),
    ("radians", "`rad`"),
    ("turns", "`turn`"),
    ("kilogram", "`kg`"),
    ("kilograms", "`kg`"),
    ("kilo", "`kg`"),
    ("kgs", "`kg`"),
    ("newton", "`N`"),
    ("newtons", "`N`"),
    ("nm", "`N*m`"),
    ("volt", "`V`"),
    ("volts", "`V`"),
    ("percent", "`%`"),
    ("hertz", "`Hz`"),
    ("mps", "`m/s`"),
    ("kph", "`km/h`"),
    ("kmh", "`km/h`"),
    ("mph", "the speed in `m/s`; 1 mile per hour is 0.44704 m/s"),
    ("knots", "the speed in `m/s`; 1 knot is 1852 m/h"),
];

fn unknown_unit(name: &ast::Name) -> Diagnostic {
    let alias = ALIASES.iter().find(|(alias, _)| *alias == name.text.to_lowercase());
    let near = alias
        .map(|(_, unit)| format!("write {unit}"))
        .or_else(|| diag::did_you_mean(&name.text, UNITS.iter().map(|unit| unit.name)));
    Diagnostic::new(&diag::rules::UNKNOWN_UNIT, name.span, format!("`{}` is not a unit", name.text))
        .help_maybe(near)
        .note("units are spelled as in SI: `cm/s`, `m/s^2`, `deg`, `N`, `%`; `lmslc explain LM0302` lists them")
}

pub(super) fn too_long(span: Span, what: &str) -> Diagnostic {
    Diagnostic::new(&diag::rules::NUMBER_TOO_LONG, span, format!("{what} cannot be kept exactly"))
        .note("numbers are fractions of 128-bit integers, so that no rounding happens before the end")
        .help("write fewer digits, or another unit")
}
