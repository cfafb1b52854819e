//! Requests for accuracy or time (Sobh §3.4): how many readings of a sensor a logical one takes the mean of.
//!
//! The mean of n readings, each off by up to a, is taken to be off by a / √n. So a tolerance t takes the least n with
//! a² <= n t², and n readings take n periods.

use super::sensors::{plain, several};
use super::{Lower, invalid, missing_part, symbol};
use crate::base::{Dimension, Exact, Id, Span, Unit, show_time};
use crate::ir;
use crate::syntax::ast;

/// The most readings of which a mean is taken: they are kept, and the exactness grows slowly.
const MOST_READINGS: u32 = 32;

/// What is asked of each reading.
#[derive(Clone, Copy)]
enum Request {
    /// How far it may be off, in SI, above 0.
    Tolerance(Exact),
    /// How long it may take, in nanoseconds.
    Time(u64),
}

impl Lower<'_> {
    /// A logical sensor that reads one other several times.
    pub(super) fn read_again(
        &mut self,
        tree: &ast::Logical,
        within: &ast::Quantity,
        sensors: &[Id<ir::Sensor>],
        groups: &[&str],
    ) -> Option<ir::Sensor> {
        let of = self.member(&tree.value, sensors, groups)?;
        let &[one] = of.as_slice() else {
            let written = self.sources.slice(tree.value.span);
            self.report(several(tree.value.span, written.split('[').next().unwrap_or_default(), written));
            return None;
        };
        let readings = self.counts(Some(within), &of)?;
        let ir::Sensor { unit, range, fails, .. } = self.program.sensors[one].clone();
        let sensor = plain(symbol(&tree.name, tree.doc.as_ref()), false, unit, range);
        Some(ir::Sensor { fails, group: Some(ir::Group { how: ir::Grouping::Minimum, of, readings }), ..sensor })
    }

    /// How many readings of each sensor a request takes; one of each without a request.
    pub(super) fn counts(&mut self, within: Option<&ast::Quantity>, of: &[Id<ir::Sensor>]) -> Option<Vec<u32>> {
        let (Some(within), Some(&first)) = (within, of.first()) else { return Some(vec![1; of.len()]) };
        let first = self.program.sensors[first].clone();
        if first.is_contact {
            let diagnostic = invalid(within.span, "a contact is set or clear, nothing between");
            self.report(diagnostic.help("`held(contact, 200 ms)` is a condition that waits until it has lasted"));
            return None;
        }
        let request = self.request(within, &first)?;
        let unit = within.unit.as_ref().map_or(Some(first.unit.clone()), |unit| self.unit(unit))?;
        of.iter().map(|&id| self.count(request, id, within.span, &unit)).collect()
    }

    fn request(&mut self, within: &ast::Quantity, sensor: &ir::Sensor) -> Option<Request> {
        let found = self.quantity(within)?;
        let is_time = within.unit.is_some() && found.dimension == Dimension::TIME;
        let value = if is_time { found.value } else { self.quantity_in(within, &sensor.unit)? };
        if value <= Exact::ZERO {
            let what = if is_time { "a time" } else { "a tolerance" };
            self.report(invalid(within.span, format!("{what} must be above 0")));
            return None;
        }
        if is_time { self.nanoseconds(within).map(Request::Time) } else { Some(Request::Tolerance(value)) }
    }

    /// How many readings of a sensor a request in some unit takes; reports one that cannot be met.
    fn count(&mut self, request: Request, sensor: Id<ir::Sensor>, within: Span, unit: &Unit) -> Option<u32> {
        let ir::Sensor { symbol, accuracy, period, .. } = self.program.sensors[sensor].clone();
        let name = &symbol.name;
        let lacks = |what: &str, why: &str| {
            let message = format!("`{name}` has no `{what}`, so that nothing says {why}");
            missing_part(within, message).label(symbol.span, "declared here")
        };
        let too_many = |count: String| {
            invalid(within, format!("this takes {count} readings of `{name}`; the most is {MOST_READINGS}"))
        };
        let refused = match request {
            _ if period == 0 => lacks("period", "how long several readings take")
                .help("write the time between two readings at the sensor, such as `period 60 ms`"),
            Request::Tolerance(_) if accuracy.is_zero() => {
                let example = unit.show(unit.scale.to_f64());
                lacks("accuracy", "how many readings reach a tolerance")
                    .help(format!("write how far one reading may be off, such as `accuracy {example}`"))
            }
            Request::Tolerance(tolerance) => {
                let squared = accuracy.over(tolerance).and_then(|ratio| ratio.times(ratio));
                let reaches = |&count: &u32| squared.is_some_and(|squared| squared <= Exact::new(count.into(), 1, 0));
                if let Some(count) = (1..=MOST_READINGS).find(reaches) {
                    return Some(count);
                }
                let accuracy = accuracy.to_f64();
                let least = rounded_up(accuracy / f64::from(MOST_READINGS).sqrt() / unit.scale.to_f64());
                too_many((accuracy / tolerance.to_f64()).powi(2).ceil().to_string())
                    .label(symbol.span, format!("one reading is within {}", unit.show(accuracy)))
                    .note("the mean of n readings is within the accuracy of one, divided by the square root of n")
                    .help(format!("{} is within reach", unit.show(least * unit.scale.to_f64())))
            }
            Request::Time(time) if time < period => {
                invalid(within, format!("no reading of `{name}` fits in {}", show_time(time)))
                    .label(symbol.span, format!("one takes {}", show_time(period)))
            }
            Request::Time(time) => {
                let count = time / period;
                if count <= MOST_READINGS.into() {
                    return u32::try_from(count).ok();
                }
                let most = show_time(period.saturating_mul(MOST_READINGS.into()));
                too_many(count.to_string()).help(format!("ask for {most} or less"))
            }
        };
        self.report(refused);
        None
    }
}

/// A number above 0 with two digits, not below it.
fn rounded_up(number: f64) -> f64 {
    let step = 10_f64.powf(number.log10().floor() - 1.0);
    (number / step).ceil() * step
}
