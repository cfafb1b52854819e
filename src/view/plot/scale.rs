//! From quantities to px: axes with round numbers, and curves no finer than the eye.

use std::fmt::Write;

use crate::view::svg::Px;

/// A linear map from a quantity to px.
#[derive(Clone, Copy)]
pub(in crate::view) struct Scale {
    pub(in crate::view) low: f64,
    pub(in crate::view) high: f64,
    /// Where `low` is, px.
    pub(in crate::view) from: f64,
    /// Where `high` is, px.
    pub(in crate::view) to: f64,
}

impl Scale {
    pub(in crate::view) fn px(&self, value: f64) -> f64 {
        self.from + (value - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    /// Round numbers from `low` to `high`, about `count` of them, with the decimals they need.
    pub(in crate::view) fn ticks(&self, count: f64) -> Vec<(f64, String)> {
        let step = round_step((self.high - self.low) / count);
        let decimals = (-step.log10().floor()).clamp(0.0, 12.0) as usize;
        let (first, last) = ((self.low / step - 1e-9).ceil() as i64, (self.high / step + 1e-9).floor() as i64);
        let shown = |value: f64| format!("{value:.decimals$}").replace('-', "−");
        // Adding zero turns −0 into 0.
        (first..=last.min(first + 100)).map(|tick| tick as f64 * step + 0.0).map(|tick| (tick, shown(tick))).collect()
    }
}

/// The ends of an axis for some values: round, not equal, and with 0 between or at them. Values that are not finite
/// do not count.
pub(super) fn limits(values: impl Iterator<Item = f64>, count: f64) -> (f64, f64) {
    let finite = values.filter(|value| value.is_finite());
    let (low, high) = finite.fold((0.0_f64, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    if low == high {
        return (0.0, 1.0);
    }
    let step = round_step((high - low) / count);
    // What lies on a round number has it for its end, in spite of rounding.
    ((low / step + 1e-9).floor() * step, (high / step - 1e-9).ceil() * step)
}

/// 1, 2 or 5 times a power of ten, not below `at_least`.
fn round_step(at_least: f64) -> f64 {
    if !(at_least.is_finite() && at_least > 1e-300) {
        return 1.0;
    }
    let power = 10_f64.powf(at_least.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * power >= at_least * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

/// Path data through points in px, ascending in x. A point that is not finite interrupts the curve. Of the points in
/// every `bucket` px the first, the lowest, the highest and the last are kept in their order (M4: Jugel et al. 2014),
/// so that a spike of one tick stays and nothing moves by more than a bucket.
pub(super) fn curve(points: impl Iterator<Item = (f64, f64)>, bucket: f64) -> String {
    let mut curve = Curve::default();
    let mut held: Option<Held> = None;
    for (x, y) in points {
        if !(x.is_finite() && y.is_finite()) {
            curve.add_all(held.take());
            curve.interrupt();
            continue;
        }
        let at = (x / bucket).floor();
        match &mut held {
            Some(held) if held.at == at => held.take((x, y)),
            _ => curve.add_all(held.replace(Held::new(at, (x, y)))),
        }
    }
    curve.add_all(held);
    curve.interrupt();
    curve.data
}

/// The corners of a curve that keeps its value until it changes.
pub(super) fn steps(points: impl Iterator<Item = (f64, f64)>) -> impl Iterator<Item = (f64, f64)> {
    let mut before: Option<f64> = None;
    let mut points = points.peekable();
    std::iter::from_fn(move || {
        let (x, y) = points.next()?;
        let corner = before.filter(|&before| before != y).map(|before| (x, before));
        let wanted = corner.is_some() || before.is_none() || points.peek().is_none();
        before = Some(y);
        Some(corner.into_iter().chain(wanted.then_some((x, y))))
    })
    .flatten()
}

/// The points of one bucket that are kept, each with its place in the order.
struct Held {
    at: f64,
    count: u32,
    first: (f64, f64),
    lowest: (u32, (f64, f64)),
    highest: (u32, (f64, f64)),
    last: (f64, f64),
}

impl Held {
    fn new(at: f64, point: (f64, f64)) -> Self {
        Self { at, count: 0, first: point, lowest: (0, point), highest: (0, point), last: point }
    }

    fn take(&mut self, point: (f64, f64)) {
        self.count += 1;
        self.last = point;
        if point.1 < self.lowest.1.1 {
            self.lowest = (self.count, point);
        }
        if point.1 > self.highest.1.1 {
            self.highest = (self.count, point);
        }
    }

    /// What is kept, in order; a point may stand there twice.
    fn kept(self) -> [(f64, f64); 4] {
        let (one, other) =
            if self.lowest.0 < self.highest.0 { (self.lowest, self.highest) } else { (self.highest, self.lowest) };
        [self.first, one.1, other.1, self.last]
    }
}

/// Path data under way. The last two points wait, because a level stretch needs only its ends.
#[derive(Default)]
struct Curve {
    data: String,
    written: bool,
    start: Option<(f64, f64)>,
    end: Option<(f64, f64)>,
}

impl Curve {
    fn add_all(&mut self, held: Option<Held>) {
        let mut before = None;
        for point in held.into_iter().flat_map(Held::kept) {
            if before.replace(point) != Some(point) {
                self.add(point);
            }
        }
    }

    fn add(&mut self, point: (f64, f64)) {
        let level = |other: (f64, f64)| (other.1 - point.1).abs() < 0.05;
        match (self.start, self.end) {
            (None, _) => self.start = Some(point),
            (Some(start), Some(end)) if !(level(start) && level(end)) => {
                self.write(start);
                self.start = Some(end);
                self.end = Some(point);
            }
            (Some(_), _) => self.end = Some(point),
        }
    }

    fn interrupt(&mut self) {
        let alone = self.end.is_none() && !self.written;
        let waiting = [self.start.take(), self.end.take()];
        waiting.into_iter().flatten().for_each(|point| self.write(point));
        if alone && self.written {
            // A point without neighbors would be invisible.
            self.data.push_str("h3");
        }
        self.written = false;
    }

    fn write(&mut self, (x, y): (f64, f64)) {
        let letter = if self.written { 'L' } else { 'M' };
        let _ = write!(self.data, "{letter}{} {}", Px(x), Px(y));
        self.written = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_have_round_numbers() {
        let scale = |low, high| Scale { low, high, from: 0.0, to: 100.0 };
        let ticks = |low, high| scale(low, high).ticks(4.0).into_iter().map(|(_, text)| text).collect::<Vec<_>>();
        assert_eq!(ticks(-3.0, 1.0), ["−3", "−2", "−1", "0", "1"]);
        assert_eq!(ticks(0.0, 1.0), ["0.0", "0.5", "1.0"]);
        assert_eq!(ticks(0.0, 240.0), ["0", "100", "200"]);
        assert_eq!(limits([-2.6, 0.4, f64::NAN].into_iter(), 4.0), (-3.0, 1.0));
        assert_eq!(limits([5.0, 5.0].into_iter(), 4.0), (0.0, 6.0));
        assert_eq!(limits([0.0].into_iter(), 4.0), (0.0, 1.0));
        assert!(scale(0.0, 1e-320).ticks(4.0).len() < 200);
    }

    #[test]
    fn a_spike_of_one_tick_stays() {
        let points = (0..60_000).map(|tick| (f64::from(tick) / 100.0, if tick == 30_051 { 99.0 } else { 0.0 }));
        assert_eq!(curve(points, 1.0), "M0 0L300 0L300.5 99L301 0L600 0");
    }

    #[test]
    fn curves_are_short_where_they_are_level_and_break_where_nothing_is_known() {
        let level = (0..1000).map(|x| (f64::from(x), 5.0));
        assert_eq!(curve(level, 1.0), "M0 5L999 5");
        let broken = [(0.0, 1.0), (1.0, 2.0), (2.0, f64::NAN), (3.0, 4.0), (4.0, f64::NAN)];
        assert_eq!(curve(broken.into_iter(), 1.0), "M0 1L1 2M3 4h3");
        assert_eq!(curve([(3.0, 4.0)].into_iter(), 1.0), "M3 4h3");
        let mut gaps = [(0.0, f64::NAN), (1.0, f64::NAN)].into_iter();
        assert_eq!(curve(gaps.by_ref(), 1.0), "");
    }

    #[test]
    fn a_flicker_within_a_bucket_ends_where_it_ends() {
        let values = [0.0, 5.0, 9.0, 0.0, 0.0, 5.0];
        let points = (0..600).map(|x| (f64::from(x) / 100.0, values[(x as usize).min(4)]));
        assert_eq!(curve(steps(points), 1.0), "M0 0L0 9L0 0L6 0");
    }

    #[test]
    fn steps_have_square_corners() {
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 1.0), (3.0, 1.0), (4.0, 1.0)];
        let corners: Vec<_> = steps(points.into_iter()).collect();
        assert_eq!(corners, [(0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (4.0, 1.0)]);
    }
}
