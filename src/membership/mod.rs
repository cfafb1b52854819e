//! Membership functions as exact curves: one, or two that a smooth function runs between.
//!
//! Imports: base, ir, kernel
//! Crates: –

mod curve;
mod function;
mod highest;
mod largest;
mod overlap;

pub(crate) use curve::{Curve, Limits, in_units, places};
pub(crate) use function::function;
pub(crate) use highest::{Stretch, highest};
pub(crate) use largest::middle_of_largest;
pub(crate) use overlap::overlaps;

use crate::base::{Exact, Fraction};
use crate::ir::{Part, Shape};
use crate::kernel;

/// Two curves that a membership function runs between. They are the same where it is piecewise linear.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Membership {
    pub(crate) low: Curve,
    pub(crate) high: Curve,
    /// Its degree without a reading.
    pub(crate) absent: Fraction,
}

/// How finely the degrees of smooth functions are told apart: in steps of `1 / STEPS`.
const STEPS: i32 = 32;

impl Membership {
    /// That of a shape whose corners ascend, with readings in units of `π^pi`.
    pub(crate) fn new(shape: &Shape, pi: i8) -> Self {
        let Shape::Built(parts) = shape else { return Self::of_shape(shape, pi) };
        let mut built: Vec<Self> = Vec::with_capacity(parts.len());
        for part in parts {
            let of = |position: &u32| &built[*position as usize];
            let merged = |of: &[u32], pick: fn(Fraction, Fraction) -> Fraction| {
                let mut all = of.iter().map(|position| &built[*position as usize]);
                let first = all.next().cloned();
                first.map(|first| all.fold(first, |merged, other| merged.merged(other, pick)))
            };
            let part = match part {
                Part::Shape(shape) => Some(Self::of_shape(shape, pi)),
                Part::Not(position) => Some(of(position).complement()),
                Part::Very(position) => Some(of(position).hedged(kernel::very, kernel::somewhat)),
                Part::Somewhat(position) => Some(of(position).hedged(kernel::somewhat, kernel::very)),
                Part::All(positions) => merged(positions, Ord::min),
                Part::Any(positions) => merged(positions, Ord::max),
            };
            built.extend(part);
        }
        // No reading belongs to any term of a variable, however the term is built.
        let whole = built.pop().unwrap_or_else(|| Self::exact(Curve::through([])));
        Self { absent: Fraction::ZERO, ..whole }
    }

    /// Whether it is known exactly, and not only within bounds.
    pub(crate) fn is_exact(&self) -> bool {
        self.low == self.high
    }

    fn exact(curve: Curve) -> Self {
        Self { low: curve.clone(), high: curve, absent: Fraction::ZERO }
    }

    fn of_shape(shape: &Shape, pi: i8) -> Self {
        let corner = |at: Exact, degree: i128| (at.to_fraction(pi), Fraction::from(degree));
        let f = Exact::to_f64;
        let (exact, smooth) = match *shape {
            Shape::Triangle([a, b, c]) => (vec![corner(a, 0), corner(b, 1), corner(c, 0)], None),
            Shape::Trapezoid([a, b, c, d]) => (vec![corner(a, 0), corner(b, 1), corner(c, 1), corner(d, 0)], None),
            Shape::Ramp { zero_at, one_at } if zero_at < one_at => (vec![corner(zero_at, 0), corner(one_at, 1)], None),
            Shape::Ramp { zero_at, one_at } => (vec![corner(one_at, 1), corner(zero_at, 0)], None),
            Shape::Rectangle([a, b]) => (vec![corner(a, 0), corner(a, 1), corner(b, 1), corner(b, 0)], None),
            Shape::Singleton(at) => (vec![corner(at, 0), corner(at, 1), corner(at, 0)], None),
            Shape::Points(ref points) => {
                (points.iter().map(|(at, degree)| (at.to_fraction(pi), degree.to_fraction(0))).collect(), None)
            }
            Shape::Gaussian([mean, sd]) => (Vec::new(), Some(gaussian(mean, sd, mean, sd))),
            Shape::Gaussian2([low, below, high, above]) => (Vec::new(), Some(gaussian(low, below, high, above))),
            Shape::Bell([center, width, slope]) => {
                let value = move |x: f64| kernel::bell(x, f(center), f(width), f(slope));
                let away = move |y: f64| f(width) * (1.0 / y - 1.0).powf(0.5 / f(slope));
                (Vec::new(), Some(Smooth::hill(value, (None, center), (center, None), away, away)))
            }
            Shape::Sigmoid([at, slope]) => {
                let value = move |x: f64| kernel::sigmoid(x, f(at), f(slope));
                let place = move |y: f64| f(at) - (1.0 / y - 1.0).ln() / f(slope);
                let flank = Flank { foot: None, head: None, place: Box::new(place) };
                let (rise, fall) = if slope > Exact::ZERO { (Some(flank), None) } else { (None, Some(flank)) };
                (Vec::new(), Some(Smooth { value: Box::new(value), rise, fall }))
            }
            Shape::Rise([a, b]) => (Vec::new(), Some(parabolas(Some([a, b]), None))),
            Shape::Fall([c, d]) => (Vec::new(), Some(parabolas(None, Some([c, d])))),
            Shape::RiseAndFall([a, b, c, d]) => (Vec::new(), Some(parabolas(Some([a, b]), Some([c, d])))),
            Shape::Cosine([center, width]) => {
                let value = move |x: f64| kernel::cosine(x, f(center), f(width));
                let half = width.over(Exact::new(2, 1, 0));
                let feet = half.map(|half| (center.minus(half), center.plus(half))).unwrap_or_default();
                let away = move |y: f64| f(width) * (2.0 * y - 1.0).acos() / core::f64::consts::TAU;
                (Vec::new(), Some(Smooth::hill(value, (feet.0, center), (center, feet.1), away, away)))
            }
            // Only a term is built, not its parts.
            Shape::Built(_) => (Vec::new(), None),
        };
        match smooth {
            Some(smooth) => smooth.bounds(pi),
            None => Self::exact(Curve::through(exact)),
        }
    }

    /// One minus the degree. No reading belongs to a term, so without one a complement holds.
    pub(crate) fn complement(&self) -> Self {
        Self { low: self.high.complement(), high: self.low.complement(), absent: &Fraction::ONE - &self.absent }
    }

    fn merged(&self, other: &Self, pick: fn(Fraction, Fraction) -> Fraction) -> Self {
        let absent = pick(self.absent.clone(), other.absent.clone());
        Self { low: self.low.merged(&other.low, pick), high: self.high.merged(&other.high, pick), absent }
    }

    /// A rising function of the degree, given with its inverse, from 0 at 0 to 1 at 1.
    fn hedged(&self, function: fn(f64) -> f64, inverse: fn(f64) -> f64) -> Self {
        let cuts: Vec<_> = (1..STEPS).map(|step| rounded(inverse(f64::from(step) / f64::from(STEPS)), -FINE)).collect();
        let bound = |side: i128| {
            move |degree: &Fraction| {
                if degree.is_zero() || *degree == Fraction::ONE {
                    return degree.clone();
                }
                // One part in a million to the side is more than any rounding.
                let value = &rounded(function(degree.to_f64()), -FINE) + &Fraction::new(side, 1 << FINE);
                value.max(Fraction::ZERO).min(Fraction::ONE)
            }
        };
        let (low, high) = (self.low.stepped(&cuts, Ord::min, bound(-1)), self.high.stepped(&cuts, Ord::max, bound(1)));
        Self { low, high, absent: self.absent.clone() }
    }
}

/// Degrees are rounded to multiples of two to this negative power.
const FINE: i32 = 20;

/// The nearest multiple of `2^power`.
fn rounded(value: f64, power: i32) -> Fraction {
    let power = power.clamp(-60, 60);
    let count = (value / f64::from(power).exp2()).round() as i128;
    if power < 0 { Fraction::new(count, 1 << -power) } else { Fraction::from(count.saturating_mul(1 << power)) }
}

/// A smooth membership function that rises, and then falls.
struct Smooth {
    value: Box<dyn Fn(f64) -> f64>,
    rise: Option<Flank>,
    fall: Option<Flank>,
}

/// One side of a smooth function, monotone from 0 to 1 or back.
struct Flank {
    /// Where it is 0, and stays so beyond; `None` where it never quite is.
    foot: Option<Exact>,
    /// Where it comes to 1; `None` where it never quite does.
    head: Option<Exact>,
    /// About where it has a degree.
    place: Box<dyn Fn(f64) -> f64>,
}

impl Smooth {
    /// A rise from a foot to a head, and a fall; either is so far from its head at some degree.
    fn hill(
        value: impl Fn(f64) -> f64 + 'static,
        (left, low): (Option<Exact>, Exact),
        (high, right): (Exact, Option<Exact>),
        below: impl Fn(f64) -> f64 + 'static,
        above: impl Fn(f64) -> f64 + 'static,
    ) -> Self {
        let rise = Flank { foot: left, head: Some(low), place: Box::new(move |degree| low.to_f64() - below(degree)) };
        let fall =
            Flank { foot: right, head: Some(high), place: Box::new(move |degree| high.to_f64() + above(degree)) };
        Self { value: Box::new(value), rise: Some(rise), fall: Some(fall) }
    }

    /// Steps below and above it.
    fn bounds(&self, pi: i8) -> Membership {
        let rise = self.rise.as_ref().map(|flank| self.cuts(flank, pi));
        let fall = self.fall.as_ref().map(|flank| self.cuts(flank, pi));
        // As far as the function may be from the degrees at which it is cut, and as rounding may move it.
        let error = rise.iter().chain(&fall).flatten().map(|cut| cut.error).fold(0.0, f64::max);
        let slack =
            Fraction::new(1, 1 << (-(2.0 * error).max(f64::from(-40).exp2()).log2().ceil()).clamp(0.0, 40.0) as u32);
        let band = |step: i32| {
            let low = &Fraction::new(step.into(), STEPS.into()) - &slack;
            let high = &Fraction::new((step + 1).into(), STEPS.into()) + &slack;
            (low.max(Fraction::ZERO), high.min(Fraction::ONE))
        };
        let none = (Fraction::ZERO, Fraction::ZERO);
        let whole = (Fraction::ONE, Fraction::ONE);
        let mut bands = Bands { first: none.clone(), then: Vec::new() };
        if let (Some(flank), Some(cuts)) = (&self.rise, rise) {
            if flank.foot.is_none() {
                bands.first = band(0);
            }
            bands.begin(flank.foot, pi, band(0));
            cuts.into_iter().zip(1..).for_each(|(cut, step)| bands.then.push((cut.at, band(step))));
            bands.begin(flank.head, pi, whole.clone());
        } else {
            let head = self.fall.as_ref().and_then(|flank| flank.head);
            bands.first = if head.is_some() { whole } else { band(STEPS - 1) };
        }
        if let (Some(flank), Some(cuts)) = (&self.fall, fall) {
            bands.begin(flank.head, pi, band(STEPS - 1));
            cuts.into_iter().zip(1..STEPS).rev().for_each(|(cut, step)| bands.then.push((cut.at, band(step - 1))));
            bands.begin(flank.foot, pi, none);
        }
        Membership {
            low: bands.curve(|band| &band.0, Ord::min),
            high: bands.curve(|band| &band.1, Ord::max),
            absent: Fraction::ZERO,
        }
    }

    /// Where a flank has each degree, by degree.
    fn cuts(&self, flank: &Flank, pi: i8) -> Vec<Cut> {
        let unit = core::f64::consts::PI.powi(pi.into());
        let degree = |step: i32| f64::from(step) / f64::from(STEPS);
        let width = ((flank.place)(0.75) - (flank.place)(0.25)).abs() / unit;
        let power = if width > 0.0 { width.log2().floor() as i32 - FINE } else { -60 };
        let ends = [flank.foot, flank.head].map(|end| end.map(|end| end.to_fraction(pi)));
        let (low, high) = match &ends {
            [Some(foot), Some(head)] => (Some(foot.min(head)), Some(foot.max(head))),
            [None, Some(head)] if (flank.place)(0.25) < (flank.place)(0.75) => (None, Some(head)),
            [None, Some(head)] => (Some(head), None),
            _ => (None, None),
        };
        let cut = |step: i32| {
            let place = rounded((flank.place)(degree(step)) / unit, power);
            let place = low.map_or(place.clone(), |low| place.max(low.clone()));
            let at = high.map_or(place.clone(), |high| place.min(high.clone()));
            let error = ((self.value)(at.to_f64_times_pi(pi)) - degree(step)).abs();
            Cut { at, error }
        };
        (1..STEPS).map(cut).collect()
    }
}

/// Where a function has about one of the degrees at which it is cut.
struct Cut {
    at: Fraction,
    /// How far its degree there is from that one.
    error: f64,
}

/// Bounds of a function that hold from one reading to the next.
struct Bands {
    first: (Fraction, Fraction),
    then: Vec<(Fraction, (Fraction, Fraction))>,
}

impl Bands {
    fn begin(&mut self, at: Option<Exact>, pi: i8, band: (Fraction, Fraction)) {
        self.then.extend(at.map(|at| (at.to_fraction(pi), band)));
    }

    /// One bound of them all; where bands meet, that of those that meet.
    fn curve(
        &self,
        side: impl Fn(&(Fraction, Fraction)) -> &Fraction,
        pick: fn(Fraction, Fraction) -> Fraction,
    ) -> Curve {
        let mut knots: Vec<(Fraction, Limits)> = Vec::with_capacity(self.then.len());
        let mut before = side(&self.first).clone();
        for (at, band) in &self.then {
            let after = side(band).clone();
            match knots.last_mut() {
                Some((known, limits)) if known == at => {
                    limits.at = pick(limits.at.clone(), after.clone());
                    limits.after = after.clone();
                }
                _ => knots.push((
                    at.clone(),
                    Limits { at: pick(before.clone(), after.clone()), before, after: after.clone() },
                )),
            }
            before = after;
        }
        Curve::of_knots(knots)
    }
}

fn gaussian(low: Exact, below: Exact, high: Exact, above: Exact) -> Smooth {
    let f = Exact::to_f64;
    let value = move |x: f64| kernel::gaussian2(x, f(low), f(below), f(high), f(above));
    let away = |deviation: Exact| move |degree: f64| f(deviation) * (-2.0 * degree.ln()).sqrt();
    Smooth::hill(value, (None, low), (high, None), away(below), away(above))
}

/// Two parabolas up, two down, or both.
fn parabolas(up: Option<[Exact; 2]>, down: Option<[Exact; 2]>) -> Smooth {
    let f = Exact::to_f64;
    let value = move |x: f64| {
        let rise = up.map_or(1.0, |[a, b]| kernel::rise(x, f(a), f(b)));
        let fall = down.map_or(1.0, |[c, d]| kernel::fall(x, f(c), f(d)));
        kernel::minimum(rise, fall)
    };
    // From its foot, as a share of the way to its head.
    let share = |degree: f64| if degree < 0.5 { (degree / 2.0).sqrt() } else { 1.0 - ((1.0 - degree) / 2.0).sqrt() };
    let flank = |foot: Exact, head: Exact| {
        let place = move |degree: f64| f(foot) + (f(head) - f(foot)) * share(degree);
        Flank { foot: Some(foot), head: Some(head), place: Box::new(place) }
    };
    let rise = up.map(|[a, b]| flank(a, b));
    let fall = down.map(|[c, d]| flank(d, c));
    Smooth { value: Box::new(value), rise, fall }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(text: &str) -> Exact {
        Exact::parse(text).unwrap()
    }

    type Function = Box<dyn Fn(f64) -> f64>;

    /// Smooth shapes, and what they are.
    fn shapes() -> Vec<(Shape, Function)> {
        let (half, one, two, four) = (exact("0.5"), exact("1"), exact("2"), exact("4"));
        let (zero, steep) = (Exact::ZERO, exact("-3.7"));
        vec![
            (Shape::Gaussian([one, half]), Box::new(|x| kernel::gaussian(x, 1.0, 0.5))),
            (Shape::Gaussian2([zero, half, one, two]), Box::new(|x| kernel::gaussian2(x, 0.0, 0.5, 1.0, 2.0))),
            (Shape::Bell([one, two, four]), Box::new(|x| kernel::bell(x, 1.0, 2.0, 4.0))),
            (Shape::Bell([one, two, half]), Box::new(|x| kernel::bell(x, 1.0, 2.0, 0.5))),
            (Shape::Sigmoid([one, steep]), Box::new(|x| kernel::sigmoid(x, 1.0, -3.7))),
            (Shape::Sigmoid([one, four]), Box::new(|x| kernel::sigmoid(x, 1.0, 4.0))),
            (Shape::Rise([zero, two]), Box::new(|x| kernel::rise(x, 0.0, 2.0))),
            (Shape::Fall([one, four]), Box::new(|x| kernel::fall(x, 1.0, 4.0))),
            (Shape::Rise([one, one]), Box::new(|x| kernel::rise(x, 1.0, 1.0))),
            (Shape::RiseAndFall([zero, one, two, four]), Box::new(|x| kernel::rise_and_fall(x, 0.0, 1.0, 2.0, 4.0))),
            (Shape::Cosine([one, four]), Box::new(|x| kernel::cosine(x, 1.0, 4.0))),
        ]
    }

    fn holds_within(shape: &Shape, pi: i8, value: impl Fn(f64) -> f64, width: f64) {
        let membership = Membership::new(shape, pi);
        for step in -640..1280 {
            let reading = Fraction::new(step, 160);
            let degree = value(reading.to_f64_times_pi(pi));
            let (low, high) = (membership.low.around(&reading), membership.high.around(&reading));
            let (low, high) = (low.at.to_f64(), high.at.to_f64());
            // Where a part is piecewise linear, the degree itself is rounded.
            assert!(low - 1e-12 <= degree && degree <= high + 1e-12, "{shape:?} at {step}/160: {low} {degree} {high}");
            assert!(high - low <= width, "{shape:?} at {step}/160: {low} {degree} {high}");
        }
    }

    #[test]
    fn smooth_shapes_stay_within_their_bounds() {
        for (shape, value) in shapes() {
            for pi in [0, 1, -1] {
                // A step has no width.
                let width = if matches!(shape, Shape::Rise([a, b]) if a == b) { 1.0 } else { 2.1 / 32.0 };
                holds_within(&shape, pi, &value, width);
            }
        }
    }

    #[test]
    fn what_is_built_of_them_does_too() {
        for (shape, value) in shapes() {
            let step = matches!(shape, Shape::Rise([a, b]) if a == b);
            let triangle = Shape::Triangle([exact("-1"), exact("0"), exact("3")]);
            let plain = |x: f64| kernel::triangle(x, -1.0, 0.0, 3.0);
            let parts = |last: Part| {
                let not = vec![Part::Shape(shape.clone()), Part::Shape(triangle.clone()), Part::Not(0), last];
                Shape::Built(not)
            };
            let width = if step { 1.0 } else { 0.26 };
            holds_within(&parts(Part::Any(vec![1, 2])), 0, |x| plain(x).max(1.0 - value(x)), width);
            holds_within(&parts(Part::All(vec![1, 2])), 0, |x| plain(x).min(1.0 - value(x)), width);
            holds_within(&parts(Part::Very(2)), 0, |x| kernel::very(1.0 - value(x)), width);
            holds_within(&parts(Part::Somewhat(0)), 0, |x| kernel::somewhat(value(x)), width);
            holds_within(&parts(Part::Somewhat(1)), 0, |x| kernel::somewhat(plain(x)), 0.26);
        }
        let very =
            Shape::Built(vec![Part::Shape(Shape::Ramp { zero_at: Exact::ZERO, one_at: Exact::ONE }), Part::Not(0)]);
        let membership = Membership::new(&very, 0);
        assert_eq!(membership.low, membership.high, "what is linear stays exact");
    }
}
