//! The readings at which a membership function is above 0, exactly.

use crate::base::Exact;
use crate::ir::{Part, Shape};

/// A cut between readings: just before a number, or just after it. Cuts order as they lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Cut {
    pub(super) at: Exact,
    pub(super) after: bool,
}

impl Cut {
    pub(super) fn before(at: Exact) -> Self {
        Self { at, after: false }
    }

    pub(super) fn after(at: Exact) -> Self {
        Self { at, after: true }
    }
}

/// The readings between two cuts; none if the first does not lie before the second.
pub(super) type Interval = (Cut, Cut);

/// The intervals of `range` on which `shape`, whose corners ascend, is above 0. They may touch.
pub(super) fn support(shape: &Shape, range: (Exact, Exact)) -> Vec<Interval> {
    let (low, high) = (Cut::before(range.0), Cut::after(range.1));
    let hill = |a: Exact, b: Exact, c: Exact, d: Exact| {
        let start = if a == b { Cut::before(a) } else { Cut::after(a) };
        let end = if c == d { Cut::after(d) } else { Cut::before(d) };
        vec![(start, end)]
    };
    let intervals = match shape {
        &Shape::Triangle([a, b, c]) => hill(a, b, b, c),
        &Shape::Trapezoid([a, b, c, d]) | &Shape::RiseAndFall([a, b, c, d]) => hill(a, b, c, d),
        &Shape::Ramp { zero_at, one_at } if zero_at < one_at => vec![(Cut::after(zero_at), high)],
        &Shape::Ramp { zero_at, .. } => vec![(low, Cut::before(zero_at))],
        &Shape::Rectangle([from, to]) => vec![(Cut::before(from), Cut::after(to))],
        &Shape::Singleton(at) => vec![(Cut::before(at), Cut::after(at))],
        Shape::Points(points) => along(points, low, high),
        Shape::Gaussian(_) | Shape::Gaussian2(_) | Shape::Bell(_) | Shape::Sigmoid(_) => vec![(low, high)],
        &Shape::Rise([a, b]) => vec![(if a == b { Cut::before(a) } else { Cut::after(a) }, high)],
        &Shape::Fall([c, d]) => vec![(low, if c == d { Cut::after(d) } else { Cut::before(d) })],
        &Shape::Cosine([center, width]) => wave(center, width).unwrap_or_else(|| vec![(low, high)]),
        Shape::Built(parts) => return built(parts, range),
    };
    let clipped = intervals.into_iter().map(|(from, to)| (from.max(low), to.min(high)));
    clipped.filter(|(from, to)| from < to).collect()
}

/// `None` where a number cannot be kept.
fn wave(center: Exact, width: Exact) -> Option<Vec<Interval>> {
    let half = width.over(Exact::new(2, 1, 0))?;
    Some(vec![(Cut::after(center.minus(half)?), Cut::before(center.plus(half)?))])
}

/// Where a complement or a minimum takes part, no reading is left out, so that nothing wrong is said of gaps.
fn built(parts: &[Part], range: (Exact, Exact)) -> Vec<Interval> {
    let mut intervals: Vec<Vec<Interval>> = Vec::with_capacity(parts.len());
    for part in parts {
        intervals.push(match part {
            Part::Shape(shape) => support(shape, range),
            Part::Not(_) | Part::All(_) => vec![(Cut::before(range.0), Cut::after(range.1))],
            Part::Very(of) | Part::Somewhat(of) => intervals[*of as usize].clone(),
            Part::Any(of) => of.iter().flat_map(|of| intervals[*of as usize].clone()).collect(),
        });
    }
    intervals.pop().unwrap_or_default()
}

fn along(points: &[(Exact, Exact)], low: Cut, high: Cut) -> Vec<Interval> {
    let mut intervals = Vec::new();
    let (Some(&(first, start)), Some(&(last, end))) = (points.first(), points.last()) else { return intervals };
    if start > Exact::ZERO {
        intervals.push((low, Cut::after(first)));
    }
    for pair in points.windows(2) {
        let &[(from, before), (to, after)] = pair else { continue };
        if before > Exact::ZERO || after > Exact::ZERO {
            // At a step the larger degree counts, so the reading itself is in if either side is.
            let from = if before > Exact::ZERO || from == to { Cut::before(from) } else { Cut::after(from) };
            let to = if after > Exact::ZERO || from.at == to { Cut::after(to) } else { Cut::before(to) };
            intervals.push((from, to));
        }
    }
    if end > Exact::ZERO {
        intervals.push((Cut::before(last), high));
    }
    intervals
}

/// What of `range` no interval holds, in order.
pub(super) fn gaps(mut intervals: Vec<Interval>, range: (Exact, Exact)) -> Vec<Interval> {
    intervals.sort_unstable();
    let mut gaps = Vec::new();
    let mut covered = Cut::before(range.0);
    for (from, to) in intervals {
        if from > covered {
            gaps.push((covered, from));
        }
        covered = covered.max(to);
    }
    let end = Cut::after(range.1);
    if covered < end {
        gaps.push((covered, end));
    }
    gaps
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> Exact {
        Exact::parse(text).unwrap()
    }

    fn triangle(corners: [&str; 3]) -> Shape {
        Shape::Triangle(corners.map(number))
    }

    #[test]
    fn a_hole_of_one_reading_is_a_gap() {
        let range = (number("0"), number("10"));
        let near = support(&triangle(["0", "5", "7"]), range);
        let far = support(&Shape::Ramp { zero_at: number("7"), one_at: number("8") }, range);
        let found = gaps([near, far].concat(), range);
        let point = |text| (Cut::before(number(text)), Cut::after(number(text)));
        assert_eq!(found, [point("0"), point("7")]);
    }

    #[test]
    fn steps_hold_their_corner() {
        let range = (number("0"), number("10"));
        assert_eq!(gaps(support(&triangle(["0", "0", "10"]), range), range).len(), 1);
        let down = Shape::Points(vec![(number("4"), number("1")), (number("4"), number("0"))]);
        assert_eq!(gaps(support(&down, range), range), [(Cut::after(number("4")), Cut::after(number("10")))]);
        assert!(support(&triangle(["11", "12", "13"]), range).is_empty());
    }
}
