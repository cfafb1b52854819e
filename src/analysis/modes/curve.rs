//! Degrees of membership at single readings, exactly.

use crate::analysis::breakpoints::in_order;
use crate::base::Exact;
use crate::ir::Shape;

/// A membership function as points in ascending order of readings: linear between them, constant outside, and with
/// the largest degree where several share a reading.
#[derive(Debug)]
pub(super) struct Curve(Vec<(Exact, Exact)>);

impl Curve {
    /// `None` for a shape whose corners do not ascend, which was reported.
    pub(super) fn new(shape: &Shape) -> Option<Self> {
        let (zero, one) = (Exact::ZERO, Exact::ONE);
        let points = match shape {
            &Shape::Triangle([a, b, c]) => vec![(a, zero), (b, one), (c, zero)],
            &Shape::Trapezoid([a, b, c, d]) => vec![(a, zero), (b, one), (c, one), (d, zero)],
            &Shape::Ramp { zero_at, one_at } if zero_at < one_at => vec![(zero_at, zero), (one_at, one)],
            &Shape::Ramp { zero_at, one_at } => vec![(one_at, one), (zero_at, zero)],
            &Shape::Rectangle([a, b]) => vec![(a, zero), (a, one), (b, one), (b, zero)],
            &Shape::Singleton(at) => vec![(at, zero), (at, one), (at, zero)],
            Shape::Points(points) => points.clone(),
        };
        in_order(shape).then_some(Self(points))
    }

    /// The readings between which it is linear.
    pub(super) fn corners(&self) -> impl Iterator<Item = Exact> {
        self.0.iter().map(|(at, _)| *at)
    }

    /// The degree at a reading; `None` where it cannot be kept exactly.
    pub(super) fn degree(&self, reading: Exact) -> Option<Exact> {
        if let Some(degree) = self.0.iter().filter(|(at, _)| *at == reading).map(|(_, degree)| *degree).max() {
            return Some(degree);
        }
        let after = self.0.partition_point(|(at, _)| *at < reading);
        match (after.checked_sub(1).and_then(|before| self.0.get(before)), self.0.get(after)) {
            (None, None) => Some(Exact::ZERO),
            (Some((_, degree)), None) | (None, Some((_, degree))) => Some(*degree),
            (Some(&(from, start)), Some(&(to, end))) => {
                let share = reading.minus(from)?.over(to.minus(from)?)?;
                end.minus(start)?.times(share)?.plus(start)
            }
        }
    }

    /// Where it crosses another one strictly between two neighboring corners; `None` where that cannot be kept exactly.
    pub(super) fn crossing(&self, other: &Self, ends: (Exact, Exact)) -> Option<Vec<Exact>> {
        root(ends, |at| self.degree(at)?.minus(other.degree(at)?))
    }

    /// The same for `1 - degree` of the other one.
    pub(super) fn crossing_complement(&self, other: &Self, ends: (Exact, Exact)) -> Option<Vec<Exact>> {
        root(ends, |at| self.degree(at)?.plus(other.degree(at)?)?.minus(Exact::ONE))
    }
}

/// Where a function that is linear strictly between two readings is 0 there, unless it is constant.
fn root((low, high): (Exact, Exact), of: impl Fn(Exact) -> Option<Exact>) -> Option<Vec<Exact>> {
    let from = low.between(high)?;
    let to = from.between(high)?;
    let (start, end) = (of(from)?, of(to)?);
    if start == end {
        return Some(Vec::new());
    }
    let share = start.over(start.minus(end)?)?;
    let at = to.minus(from)?.times(share)?.plus(from)?;
    Some(if low < at && at < high { vec![at] } else { Vec::new() })
}
