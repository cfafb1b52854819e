//! Quantities as people type them: `3`, `-1.2`, `0.1kN`, `100 cm/s^2`.

use super::{Exact, Unit};

/// A number in `unit` where it names none, or in another unit of the same dimension; in SI.
pub fn read_quantity(text: &str, unit: &Unit) -> Option<Exact> {
    let text = text.trim();
    match (unit.text.as_str(), text) {
        ("contact", "set") => return Some(Exact::ONE),
        ("contact", "clear") => return Some(Exact::ZERO),
        _ => {}
    }
    let (number, written) = text.split_at(number_length(text));
    let scale = match written.trim() {
        "" => unit.scale,
        written => Unit::parse(written).filter(|found| found.dimension == unit.dimension)?.scale,
    };
    Exact::parse(number)?.times(scale)
}

/// How many bytes at the front are a decimal number; an `e` belongs to it only before an exponent.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| {
        let rest = text.get(from..).unwrap_or("");
        from + rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len())
    };
    let mantissa = digits(usize::from(text.starts_with(['-', '+'])));
    let Some(exponent) = text.get(mantissa..).and_then(|rest| rest.strip_prefix(['e', 'E'])) else { return mantissa };
    let sign = usize::from(exponent.starts_with(['-', '+']));
    let end = digits(mantissa + 1 + sign);
    if end > mantissa + 1 + sign { end } else { mantissa }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_takes_the_unit_it_names_or_the_one_it_is_for() {
        let si = |text: &str, unit: &str| read_quantity(text, &Unit::parse(unit).unwrap()).map(Exact::to_f64);
        assert_eq!(si("0.1kN", "N"), Some(100.0));
        assert_eq!(si("100 cm/s^2", "m/s^2"), Some(1.0));
        assert_eq!(si("1e2", "N"), Some(100.0));
        assert_eq!(si("1e-2 m", "m"), Some(0.01));
        assert_eq!(si("21", "1"), Some(21.0));
        assert_eq!(si("1", "1"), Some(1.0));
        assert_eq!(si("30 %", "1"), Some(0.3));
        assert_eq!(si("5 V", "N"), None);
        assert_eq!(si("NaN", "N"), None);
        assert_eq!(si("", "N"), None);
    }
}
