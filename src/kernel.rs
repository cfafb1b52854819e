//! The numeric meaning of one tick: membership, strength, memory, time and chance, each written once.
//!
//! Plain functions over plain numbers that import nothing of ours, so that the same text can be compiled here and
//! included in emitted code. That is also why it is one file.
//!
//! Imports: –
//! Crates: libm

/// A reading made safe: the fail reading where the sensor is known to have failed or the number is not finite, else
/// the number clamped to its range. `low <= high`; never NaN if `fail` is not.
#[inline]
pub fn sanitize(reading: f64, healthy: bool, low: f64, high: f64, fail: f64) -> f64 {
    if is_usable(reading, healthy) { maximum(minimum(reading, high), low) } else { fail }
}

/// Whether a reading is one: a number, of a sensor that is not known to have failed.
#[inline]
pub fn is_usable(reading: f64, healthy: bool) -> bool {
    healthy && reading.is_finite()
}

/// Degree of membership (LMSL eq. 1) of a line from 0 at `zero_at` to 1 at `one_at`, in either direction, clamped.
/// The corners differ. Exact at both corners.
#[inline]
pub fn ramp(x: f64, zero_at: f64, one_at: f64) -> f64 {
    // In this order a degree of -0 becomes 0.
    maximum(0.0, minimum(1.0, (x - zero_at) / (one_at - zero_at)))
}

/// Degree of membership of a triangle from `a` over `b` to `c`; `a <= b <= c`. Equal corners are steps with the larger
/// degree at the corner. No flank is above 1 on its own side of `b`, rounded or not. Where both are equally wide, the
/// smaller distance is divided once, which rounds to the same.
#[inline]
pub fn triangle(x: f64, a: f64, b: f64, c: f64) -> f64 {
    if a < b && b - a == c - b {
        return maximum(0.0, minimum(x - a, c - x) / (b - a));
    }
    let rising = if a < b { (x - a) / (b - a) } else { rectangle(x, b, c) };
    let falling = if b < c { (c - x) / (c - b) } else { rectangle(x, a, b) };
    maximum(0.0, minimum(rising, falling))
}

/// Degree of membership of a trapezoid: 0 at `a`, 1 from `b` to `c`, 0 at `d`; `a <= b <= c <= d`. Equal corners are
/// steps with the larger degree at the corner. Both flanks are computed wherever `x` lies: two divisions side by side
/// cost less than a branch that readings make hard to predict.
#[inline]
pub fn trapezoid(x: f64, a: f64, b: f64, c: f64, d: f64) -> f64 {
    let rising = if a < b { (x - a) / (b - a) } else { rectangle(x, b, d) };
    let falling = if c < d { (d - x) / (d - c) } else { rectangle(x, a, c) };
    maximum(0.0, minimum(1.0, minimum(rising, falling)))
}

/// Degree of membership of the closed interval from `low` to `high`.
#[inline]
pub fn rectangle(x: f64, low: f64, high: f64) -> f64 {
    if low <= x && x <= high { 1.0 } else { 0.0 }
}

/// Degree of membership of one reading.
#[inline]
pub fn singleton(x: f64, at: f64) -> f64 {
    rectangle(x, at, at)
}

/// Degree of membership along `points` of readings and degrees, ascending, linear in between and constant outside.
/// Two points at one reading are a step with the larger degree at it. 0 without points.
#[inline]
pub fn points(x: f64, points: &[(f64, f64)]) -> f64 {
    let mut before: Option<(f64, f64)> = None;
    for &(at, degree) in points {
        if x < at {
            return match before {
                Some((from, start)) if x > from => start + (degree - start) * ((x - from) / (at - from)),
                Some((_, start)) => start,
                None => degree,
            };
        }
        before = Some(match before {
            Some((from, start)) if x == at && from == at => (at, if start > degree { start } else { degree }),
            _ => (at, degree),
        });
    }
    before.map_or(0.0, |(_, degree)| degree)
}

/// Degree of membership of a bell around `mean`; `deviation > 0`.
#[inline]
pub fn gaussian(x: f64, mean: f64, deviation: f64) -> f64 {
    let distance = (x - mean) / deviation;
    libm::exp(-0.5 * distance * distance)
}

/// Degree of membership that is 1 from `low` to `high`, with a bell's flank on either side; `low <= high`.
#[inline]
pub fn gaussian2(x: f64, low: f64, below: f64, high: f64, above: f64) -> f64 {
    if x < low {
        gaussian(x, low, below)
    } else if x > high {
        gaussian(x, high, above)
    } else {
        1.0
    }
}

/// Degree of membership of the generalized bell, 1/2 at `center ± width`; `width > 0`, `slope > 0`.
#[inline]
pub fn bell(x: f64, center: f64, width: f64, slope: f64) -> f64 {
    1.0 / (1.0 + libm::pow(libm::fabs((x - center) / width), 2.0 * slope))
}

/// Degree of membership of the logistic curve, 1/2 at `inflection`.
#[inline]
pub fn sigmoid(x: f64, inflection: f64, slope: f64) -> f64 {
    1.0 / (1.0 + libm::exp(-slope * (x - inflection)))
}

/// Degree of membership that rises from 0 at `a` to 1 at `b` along two parabolas; `a <= b`.
#[inline]
pub fn rise(x: f64, a: f64, b: f64) -> f64 {
    if x >= b {
        1.0
    } else if x <= a {
        0.0
    } else if x - a < b - x {
        let share = (x - a) / (b - a);
        2.0 * share * share
    } else {
        let share = (b - x) / (b - a);
        1.0 - 2.0 * share * share
    }
}

/// Degree of membership that falls from 1 at `a` to 0 at `b` along two parabolas; `a <= b`.
#[inline]
pub fn fall(x: f64, a: f64, b: f64) -> f64 {
    rise(-x, -b, -a)
}

/// Degree of membership that rises from `a` to `b` and falls from `c` to `d`; `a <= b <= c <= d`.
#[inline]
pub fn rise_and_fall(x: f64, a: f64, b: f64, c: f64, d: f64) -> f64 {
    if x < b { rise(x, a, b) } else { fall(x, c, d) }
}

/// Degree of membership of one wave of a cosine, 0 at `center ± width / 2`; `width > 0`.
#[inline]
pub fn cosine(x: f64, center: f64, width: f64) -> f64 {
    let distance = libm::fabs(x - center) / width;
    if distance >= 0.5 { 0.0 } else { 0.5 * (1.0 + libm::cos(core::f64::consts::TAU * distance)) }
}

/// The hedge `very`.
#[inline]
pub fn very(degree: f64) -> f64 {
    degree * degree
}

/// The hedge `somewhat`.
#[inline]
pub fn somewhat(degree: f64) -> f64 {
    libm::sqrt(degree)
}

/// The fuzzy AND (LMSL §3.2): the smaller degree.
#[inline]
pub fn minimum(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

/// The fuzzy OR (LMSL §3.2): the larger degree.
#[inline]
pub fn maximum(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// The smallest reading of a group.
#[inline]
pub fn smallest_reading(readings: &[f64]) -> f64 {
    readings.iter().copied().reduce(minimum).unwrap_or(0.0)
}

/// The largest reading of a group.
#[inline]
pub fn largest_reading(readings: &[f64]) -> f64 {
    readings.iter().copied().reduce(maximum).unwrap_or(0.0)
}

/// The arithmetic mean of a group; rounding does not take it beyond its readings.
#[inline]
pub fn mean_reading(readings: &[f64]) -> f64 {
    let total = readings.iter().fold(0.0, |total, reading| total + reading);
    let quotient = total / readings.len() as f64;
    maximum(minimum(quotient, largest_reading(readings)), smallest_reading(readings))
}

/// The reading in the middle of a group, or halfway between the two in the middle.
#[inline]
pub fn median_reading(readings: &[f64]) -> f64 {
    let lower = readings.len().saturating_sub(1) / 2;
    f64::midpoint(ranked(readings, lower), ranked(readings, readings.len() / 2))
}

/// The reading that as many readings of a group are below as `rank` says.
#[inline]
fn ranked(readings: &[f64], rank: usize) -> f64 {
    let is_ranked = |at: &f64| {
        let (below, up_to) = readings.iter().fold((0_usize, 0_usize), |(below, up_to), reading| {
            (below.wrapping_add(usize::from(reading < at)), up_to.wrapping_add(usize::from(reading <= at)))
        });
        below <= rank && rank < up_to
    };
    readings.iter().copied().find(is_ranked).unwrap_or(0.0)
}

/// The bearing of the middle of the widest opening among neighboring beams, rad from -π to π: the most of them in a row
/// that each read `beyond` or more, or as much as any does. Of two that are as wide it is the one nearer to straight
/// ahead, which is at 0. The first beam is at `first` (rad, from -π to π), each other `spacing` (rad) to the left of the
/// one before; a whole ring has no ends, and where all of it is open nothing is as good as straight ahead.
#[inline]
pub fn widest_opening(readings: &[f64], beyond: f64, first: f64, spacing: f64) -> f64 {
    let open = minimum(beyond, largest_reading(readings));
    let of = readings.len() as f64;
    let is_ring = spacing * (of + 0.5) > core::f64::consts::TAU;
    let (rounds, mut place) = if is_ring { (2, -of) } else { (1, 0.0) };
    let (mut run, mut widest, mut bearing) = (0.0, 0.0, 0.0);
    for _ in 0..rounds {
        for reading in readings {
            run = if *reading >= open { minimum(run + 1.0, of) } else { 0.0 };
            let middle = within_half_a_turn(first + spacing * (place - (run - 1.0) / 2.0));
            let middle = if is_ring && run >= of { 0.0 } else { middle };
            let nearer = maximum(bearing, -bearing) - maximum(middle, -middle);
            // Rounding makes no bearing nearer.
            if run > widest || run >= widest && nearer > spacing / 8.0 {
                (widest, bearing) = (run, middle);
            }
            place += 1.0;
        }
    }
    bearing
}

/// An angle of less than one and a half turns as the same one from -π to π, rad.
#[inline]
fn within_half_a_turn(angle: f64) -> f64 {
    if angle > core::f64::consts::PI {
        angle - core::f64::consts::TAU
    } else if angle < -core::f64::consts::PI {
        angle + core::f64::consts::TAU
    } else {
        angle
    }
}

/// The t-norm `product`.
#[inline]
pub fn product(a: f64, b: f64) -> f64 {
    a * b
}

/// The t-norm of Łukasiewicz: `a + b - 1`, at least 0.
#[inline]
pub fn bounded_difference(a: f64, b: f64) -> f64 {
    maximum(a + b - 1.0, 0.0)
}

/// The drastic t-norm: the smaller degree where the other is 1, else 0.
#[inline]
pub fn drastic_product(a: f64, b: f64) -> f64 {
    if maximum(a, b) >= 1.0 { minimum(a, b) } else { 0.0 }
}

/// The t-norm of Einstein.
#[inline]
pub fn einstein_product(a: f64, b: f64) -> f64 {
    a * b / (2.0 - (a + b - a * b))
}

/// The t-norm of Hamacher.
#[inline]
pub fn hamacher_product(a: f64, b: f64) -> f64 {
    let either = a + b - a * b;
    if either > 0.0 { a * b / either } else { 0.0 }
}

/// The nilpotent minimum: the smaller degree where both sum to more than 1, else 0.
#[inline]
pub fn nilpotent_minimum(a: f64, b: f64) -> f64 {
    if a + b > 1.0 { minimum(a, b) } else { 0.0 }
}

/// The probabilistic sum `a + b - a b`.
#[inline]
pub fn probabilistic_sum(a: f64, b: f64) -> f64 {
    minimum(a + b - a * b, 1.0)
}

/// The s-norm of Łukasiewicz: `a + b`, at most 1.
#[inline]
pub fn bounded_sum(a: f64, b: f64) -> f64 {
    minimum(a + b, 1.0)
}

/// The drastic s-norm: the larger degree where the other is 0, else 1.
#[inline]
pub fn drastic_sum(a: f64, b: f64) -> f64 {
    if minimum(a, b) <= 0.0 { maximum(a, b) } else { 1.0 }
}

/// The s-norm of Einstein.
#[inline]
pub fn einstein_sum(a: f64, b: f64) -> f64 {
    minimum((a + b) / (1.0 + a * b), 1.0)
}

/// The s-norm of Hamacher.
#[inline]
pub fn hamacher_sum(a: f64, b: f64) -> f64 {
    let both = 1.0 - a * b;
    if both > 0.0 { minimum((a + b - 2.0 * a * b) / both, 1.0) } else { 1.0 }
}

/// The nilpotent maximum: the larger degree where both sum to less than 1, else 1.
#[inline]
pub fn nilpotent_maximum(a: f64, b: f64) -> f64 {
    if a + b < 1.0 { maximum(a, b) } else { 1.0 }
}

/// The aggregation `sum`.
#[inline]
pub fn sum(a: f64, b: f64) -> f64 {
    a + b
}

/// Whether a rule of this strength sets its output. A strength so small that areas could be rounded to 0 is none.
#[inline]
pub fn fires(strength: f64) -> bool {
    strength >= 1e-30
}

/// A number kept between `low` and `high`; `low <= high`.
#[inline]
pub fn limit(x: f64, low: f64, high: f64) -> f64 {
    maximum(minimum(x, high), low)
}

/// A mean from the sum of weights and the sum of weighted numbers; 0 without any weight.
#[inline]
pub fn weighted_mean(weights: f64, weighted: f64) -> f64 {
    if weights > 0.0 { weighted / weights } else { 0.0 }
}

/// How far a strength reaches into what lies above the degree `floor` and is `thickness` high.
#[inline]
pub fn reach(strength: f64, floor: f64, thickness: f64) -> f64 {
    minimum(maximum(strength - floor, 0.0), thickness)
}

/// What a set holds between two degrees while it is clipped at `strength`: its area, and its moment about the point to
/// which `moment` belongs. Both are polynomials in how far the strength reaches into the slab, which begins at the
/// degree `floor` and is `thickness` high: the width of a piecewise-linear set at a degree is linear in the degree, so
/// its area is a quadratic and its moment a cubic, without constant terms.
#[inline]
pub fn slab(strength: f64, floor: f64, thickness: f64, area: (f64, f64), moment: (f64, f64, f64)) -> (f64, f64) {
    let height = reach(strength, floor, thickness);
    (height * (area.0 + height * area.1), height * (moment.0 + height * (moment.1 + height * moment.2)))
}

/// The degree of what some sets come to at a share of a stretch, each with a strength.
fn joined(
    share: f64,
    strengths: &[f64],
    lines: &[(f64, f64)],
    imply: fn(f64, f64) -> f64,
    join: fn(f64, f64) -> f64,
) -> f64 {
    let mut degree = 0.0;
    for (&strength, &(start, end)) in strengths.iter().zip(lines) {
        degree = join(degree, imply(strength, start + (end - start) * share));
    }
    degree
}

/// The share of a stretch, above `after`, up to which what some sets come to is surely linear: where one reaches a
/// strength, or two cross, as they are or scaled by their strengths.
fn next_bend(after: f64, strengths: &[f64], lines: &[(f64, f64)]) -> f64 {
    let mut next = 1.0;
    for (strength, &(start, end)) in strengths.iter().zip(lines) {
        for (other, &(other_start, other_end)) in strengths.iter().zip(lines) {
            let (before, behind) = (start - other_start, end - other_end);
            let (scaled_before, scaled_behind) =
                (strength * start - other * other_start, strength * end - other * other_end);
            let reached = (other - start) / (end - start);
            let crossed = before / (before - behind);
            let scaled = scaled_before / (scaled_before - scaled_behind);
            // What is not a number is never between.
            for share in [reached, crossed, scaled] {
                if share > after && share < next {
                    next = share;
                }
            }
        }
    }
    next
}

/// Follows what some sets come to, each with a strength, from left to right. `stretches` are those of the range on which
/// every set is linear: where each begins and ends, and the degrees of every set just inside its ends. Tells every linear
/// piece of it: its ends, and its degrees at its start, in its middle and at its end. Exact; at most three bends for
/// every pair of sets on each stretch.
fn outline<'a>(
    stretches: impl Iterator<Item = (f64, f64, &'a [(f64, f64)])>,
    strengths: &[f64],
    imply: fn(f64, f64) -> f64,
    join: fn(f64, f64) -> f64,
    mut piece: impl FnMut((f64, f64), (f64, f64, f64)),
) {
    for (from, to, lines) in stretches {
        let (mut share, mut x) = (0.0, from);
        while share < 1.0 {
            let next = next_bend(share, strengths, lines);
            let end = if next < 1.0 { from + (to - from) * next } else { to };
            // From inside, where a bend too near to an end to be told from it does not show.
            let degree = |part| joined(share + part * (next - share), strengths, lines, imply, join);
            let (before, behind) = (degree(0.25), degree(0.75));
            let at_end = |near: f64, far: f64| maximum(near + 0.5 * (near - far), 0.0);
            piece((x, end), (at_end(before, behind), 0.5 * (before + behind), at_end(behind, before)));
            (share, x) = (next, end);
        }
    }
}

/// The center of the area of what some sets come to, each with a strength: for what is no polynomial in the strengths.
pub fn outline_centroid<'a>(
    stretches: impl Iterator<Item = (f64, f64, &'a [(f64, f64)])> + Clone,
    strengths: &[f64],
    imply: fn(f64, f64) -> f64,
    join: fn(f64, f64) -> f64,
) -> f64 {
    let (mut area, mut moment) = (0.0, 0.0);
    outline(stretches, strengths, imply, join, |(from, to), (start, _, end)| {
        let width = to - from;
        area += 0.5 * width * (start + end);
        moment += width * (0.5 * from * (start + end) + width * (start + 2.0 * end) / 6.0);
    });
    weighted_mean(area, moment)
}

/// The smallest number that halves the area of what some sets come to, each with a strength.
pub fn bisector<'a>(
    stretches: impl Iterator<Item = (f64, f64, &'a [(f64, f64)])> + Clone,
    strengths: &[f64],
    imply: fn(f64, f64) -> f64,
    join: fn(f64, f64) -> f64,
) -> f64 {
    let mut area = 0.0;
    outline(stretches.clone(), strengths, imply, join, |(from, to), (start, _, end)| {
        area += 0.5 * (to - from) * (start + end);
    });
    let (mut left, mut at) = (0.5 * area, 0.0);
    outline(stretches, strengths, imply, join, |(from, to), (start, _, end)| {
        let (width, piece) = (to - from, 0.5 * (to - from) * (start + end));
        if left > 0.0 && piece > 0.0 {
            // `start t + slope t² / 2 = left`, in the form that does not cancel.
            let slope = (end - start) / width;
            let root = libm::sqrt(maximum(start * start + 2.0 * slope * left, 0.0));
            at = if left < piece { from + 2.0 * left / (start + root) } else { to };
        }
        left -= piece;
    });
    at
}

/// The smallest, the largest and the mean number at which what some sets come to, each with a strength, has its largest
/// degree. The mean is taken over the stretches that have it, and over single numbers only where there is no stretch.
pub fn maxima<'a>(
    stretches: impl Iterator<Item = (f64, f64, &'a [(f64, f64)])> + Clone,
    strengths: &[f64],
    imply: fn(f64, f64) -> f64,
    join: fn(f64, f64) -> f64,
) -> (f64, f64, f64) {
    let mut top = 0.0;
    outline(stretches.clone(), strengths, imply, join, |_, (start, middle, end)| {
        top = maximum(top, maximum(middle, maximum(start, end)));
    });
    // What is meant to be the largest degree may lie below it by rounding.
    let level = top - top * 1e-12;
    let (mut smallest, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
    let (mut width, mut moment) = (0.0, 0.0);
    outline(stretches, strengths, imply, join, |(from, to), (start, middle, end)| {
        let is_flat = middle >= level;
        if is_flat {
            width += to - from;
            moment += 0.5 * (to - from) * (from + to);
        }
        if is_flat || start >= level {
            smallest = minimum(smallest, from);
            largest = maximum(largest, from);
        }
        if is_flat || end >= level {
            smallest = minimum(smallest, to);
            largest = maximum(largest, to);
        }
    });
    let middle = if width > 0.0 { moment / width } else { 0.5 * (smallest + largest) };
    (smallest, largest, middle)
}

/// The center of the area of what some sets come to, each with a strength, from their degrees in the middle of equal
/// parts of the range from `low` to `high`: for each part those of all sets.
pub fn midpoints<'a>(
    parts: impl ExactSizeIterator<Item = &'a [f64]>,
    strengths: &[f64],
    imply: fn(f64, f64) -> f64,
    join: fn(f64, f64) -> f64,
    low: f64,
    high: f64,
) -> f64 {
    let width = (high - low) / parts.len() as f64;
    let (mut area, mut moment, mut position) = (0.0, 0.0, 0.5);
    for degrees in parts {
        let mut degree = 0.0;
        for (&strength, &of_set) in strengths.iter().zip(degrees) {
            degree = join(degree, imply(strength, of_set));
        }
        area += degree;
        moment += degree * (low + position * width);
        position += 1.0;
    }
    weighted_mean(area, moment)
}

/// Whether an event's rules call for its flag: the contributor outweighs the detractor strictly, so a tie does not.
#[inline]
pub fn outweighs(contributor: f64, detractor: f64) -> bool {
    contributor > detractor
}

/// The same with hysteresis above 0: set above `detractor + hysteresis`, cleared below `detractor - hysteresis`,
/// `before` in between.
#[inline]
pub fn outweighs_with_hysteresis(contributor: f64, detractor: f64, hysteresis: f64, before: bool) -> bool {
    if contributor > detractor + hysteresis {
        true
    } else if contributor < detractor - hysteresis {
        false
    } else {
        before
    }
}

/// The mean of the last readings of a sensor (Sobh §3.4), which are kept beside it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Window {
    /// How many readings are kept, from the first place on.
    pub held: usize,
    /// The place of the next one.
    pub next: usize,
    /// Nanoseconds until it is due.
    pub left: u64,
    /// The mean of those that are kept.
    pub mean: f64,
}

impl Window {
    /// Lets `dt` nanoseconds pass, and keeps `reading` in the place of the oldest where one is due: the first at once, and
    /// from then on one every `period` nanoseconds, above 0. Answers the mean of all that are kept. A reading that is not
    /// usable is answered as it is, and empties the window. Linear in the length of `readings` where one is due.
    #[inline]
    pub fn observe(&mut self, readings: &mut [f64], reading: f64, usable: bool, dt: u64, period: u64) -> f64 {
        if !usable {
            *self = Self { held: 0, next: 0, left: 0, mean: reading };
            return reading;
        }
        if dt < self.left {
            self.left = self.left.wrapping_sub(dt);
            return self.mean;
        }
        let late = if self.held == 0 { 0 } else { dt.wrapping_sub(self.left) };
        self.left = period.wrapping_sub(late.checked_rem(period).unwrap_or(0));
        if let Some(place) = readings.get_mut(self.next) {
            *place = reading;
        }
        self.held = readings.len().min(self.held.saturating_add(1));
        self.next = self.next.saturating_add(1).checked_rem(readings.len()).unwrap_or(0);
        self.mean = mean_reading(readings.get(..self.held).unwrap_or_default());
        self.mean
    }
}

/// The memory of something that is timed while it lasts: nanoseconds since it began, or not begun.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Stopwatch {
    /// Whether it is running.
    pub running: bool,
    /// Nanoseconds since it began, saturating.
    pub elapsed: u64,
}

impl Stopwatch {
    /// Lets `dt` nanoseconds pass, then starts it afresh or stops it as `on` says; answers whether it is running and
    /// has run for at least `duration`.
    #[inline]
    pub fn lasts(&mut self, on: bool, dt: u64, duration: u64) -> bool {
        self.elapsed = if on && self.running { self.elapsed.saturating_add(dt) } else { 0 };
        self.running = on;
        on && self.elapsed >= duration
    }
}

/// Keeps a flag set for at least `duration` nanoseconds once it sets. `stopwatch` runs from the tick it set.
#[inline]
pub fn hold(stopwatch: &mut Stopwatch, wanted: bool, dt: u64, duration: u64) -> bool {
    if stopwatch.running {
        stopwatch.elapsed = stopwatch.elapsed.saturating_add(dt);
        stopwatch.running = wanted || stopwatch.elapsed < duration;
    } else if wanted {
        *stopwatch = Stopwatch { running: true, elapsed: 0 };
    }
    stopwatch.running
}

/// The next number of a seeded stream (SplitMix64: Steele, Lea and Flood 2014).
#[inline]
pub fn next_random(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// A number from `low` to `high` (both finite, `low <= high`) from the stream, with 53 random bits.
#[inline]
pub fn draw(state: &mut u64, low: f64, high: f64) -> f64 {
    let fraction = (next_random(state) >> 11) as f64 / 9_007_199_254_740_992.0;
    let drawn = low + (high - low) * fraction;
    if drawn > high { high } else { drawn }
}

/// The place of the smallest priority among those that propose something; of several the first.
#[inline]
pub fn first_choice(levels: &[Option<u32>]) -> Option<usize> {
    let best = levels.iter().flatten().min();
    let mut places = (0..levels.len()).zip(levels);
    places.find(|(_, level)| level.is_some() && level.as_ref() == best).map(|(place, _)| place)
}

/// The same, of several one by chance; a number is drawn only where there are several.
#[inline]
pub fn any_choice(levels: &[Option<u32>], random: &mut u64) -> Option<usize> {
    let best = levels.iter().flatten().min();
    let places = (0..levels.len()).zip(levels).filter(|(_, level)| level.is_some() && level.as_ref() == best);
    let count = places.clone().fold(0.0, |count, _| count + 1.0);
    let drawn = if count > 1.0 { draw(random, 0.0, count) } else { 0.0 };
    let (mut chosen, mut before) = (None, 0.0);
    for (place, _) in places {
        if before <= drawn {
            chosen = Some(place);
        }
        before += 1.0;
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_are_exact_at_their_corners() {
        assert_eq!([-1.5, -1.0, -0.25, 0.0, 0.5].map(|x| ramp(x, 0.0, -1.0)), [1.0, 1.0, 0.25, 0.0, 0.0]);
        let med = |x| triangle(x, 20.0, 115.0, 190.0);
        assert_eq!([20.0, 67.5, 115.0, 152.5, 190.0].map(med), [0.0, 0.5, 1.0, 0.5, 0.0]);
        assert_eq!([-1.0, 0.0, 1.0, 2.0].map(|x| triangle(x, 0.0, 0.0, 2.0)), [0.0, 1.0, 0.5, 0.0]);
        assert_eq!([0.9, 1.0, 2.0, 2.1].map(|x| trapezoid(x, 1.0, 1.0, 2.0, 2.0)), [0.0, 1.0, 1.0, 0.0]);
        assert_eq!([0.9, 1.0, 1.1].map(|x| singleton(x, 1.0)), [0.0, 1.0, 0.0]);
    }

    #[test]
    fn smooth_shapes_have_their_landmarks() {
        let close = |a: f64, b: f64| (a - b).abs() < 1e-15;
        assert!(close(gaussian(3.0, 1.0, 2.0), (-0.5_f64).exp()) && gaussian(1.0, 1.0, 2.0) == 1.0);
        assert_eq!([0.0, 1.5, 2.0].map(|x| gaussian2(x, 0.0, 1.0, 2.0, 3.0)), [1.0; 3]);
        assert!(close(gaussian2(-1.0, 0.0, 1.0, 2.0, 3.0), gaussian2(5.0, 0.0, 1.0, 2.0, 3.0)));
        assert_eq!([-1.0, 1.0, 3.0].map(|x| bell(x, 1.0, 2.0, 3.5)), [0.5, 1.0, 0.5]);
        assert!(sigmoid(1.0, 1.0, -4.0) == 0.5 && sigmoid(9.0, 1.0, -4.0) < 1e-13 && sigmoid(9.0, 1.0, 4.0) < 1.0);
        assert_eq!([-1.0, 0.0, 1.0, 2.0, 3.0, 4.0].map(|x| rise(x, 0.0, 4.0)), [0.0, 0.0, 0.125, 0.5, 0.875, 1.0]);
        assert_eq!([0.0, 1.0, 2.0, 3.0, 4.0].map(|x| fall(x, 0.0, 4.0)), [1.0, 0.875, 0.5, 0.125, 0.0]);
        assert_eq!([1.0, 2.0].map(|x| (rise(x, 1.0, 1.0), fall(x, 1.0, 1.0))), [(1.0, 1.0), (1.0, 0.0)]);
        assert_eq!([1.0, 2.5, 5.0].map(|x| rise_and_fall(x, 0.0, 2.0, 3.0, 7.0)), [0.5, 1.0, 0.5]);
        assert_eq!([0.0, 1.0, 2.0].map(|x| cosine(x, 1.0, 2.0)), [0.0, 1.0, 0.0]);
        assert!(close(cosine(1.5, 1.0, 2.0), 0.5) && cosine(9.0, 1.0, 2.0) == 0.0);
    }

    #[test]
    fn triangles_and_trapezoids_are_the_line_that_their_flank_says() {
        let by_cases = |x: f64, [a, b, c, d]: [f64; 4]| {
            if x < b {
                if x <= a { 0.0 } else { (x - a) / (b - a) }
            } else if x > c {
                if x >= d { 0.0 } else { (d - x) / (d - c) }
            } else {
                1.0
            }
        };
        let mut seed = 3;
        for _ in 0..20_000 {
            let mut corners = [0; 4].map(|_| (draw(&mut seed, -3.0, 3.0) * 3.0).round() / 3.0);
            corners.sort_by(f64::total_cmp);
            let [a, b, c, d] = corners;
            let beside = corners.map(f64::next_up).into_iter().chain(corners.map(f64::next_down));
            for x in corners.into_iter().chain(beside).chain([draw(&mut seed, -4.0, 4.0), -0.0]) {
                let degree = trapezoid(x, a, b, c, d);
                assert_eq!(degree.to_bits(), by_cases(x, corners).to_bits(), "{x} in {corners:?}");
                assert_eq!(triangle(x, a, b, d).to_bits(), trapezoid(x, a, b, b, d).to_bits(), "{x} in {corners:?}");
            }
        }
    }

    #[test]
    fn points_step_with_the_larger_degree() {
        let at = |x| points(x, &[(0.0, 0.25), (1.0, 0.5), (1.0, 1.0), (2.0, 0.0)]);
        assert_eq!([-1.0, 0.0, 0.5, 1.0, 1.5, 2.0, 3.0].map(at), [0.25, 0.25, 0.375, 1.0, 0.5, 0.0, 0.0]);
        let down = |x| points(x, &[(0.0, 1.0), (1.0, 1.0), (1.0, 0.0)]);
        assert_eq!([0.5, 1.0, 1.5].map(down), [1.0, 1.0, 0.0]);
        assert_eq!(points(1.0, &[]), 0.0);
    }

    #[test]
    fn no_reading_passes_unsafe() {
        let safe = |reading, healthy| sanitize(reading, healthy, -4.0, 4.0, 0.5);
        assert_eq!(safe(f64::NAN, true), 0.5);
        assert_eq!(safe(f64::INFINITY, true), 0.5);
        assert_eq!(safe(1.0, false), 0.5);
        assert_eq!(safe(7.0, true), 4.0);
        assert_eq!(safe(-7.0, true), -4.0);
        assert_eq!(safe(3.0, true), 3.0);
    }

    #[test]
    fn a_clipped_triangle_is_a_polynomial_in_its_strength() {
        // From 0 over 1 to 2, about 1: at the degree u it is 2 (1 - u) wide.
        let half = slab(0.5, 0.0, 1.0, (2.0, -1.0), (0.0, 0.0, 0.0));
        assert_eq!(half, (0.75, 0.0));
        assert_eq!(slab(2.0, 0.0, 1.0, (2.0, -1.0), (0.0, 0.0, 0.0)).0, 1.0);
        // Above the degree 1/2 it is as wide as a triangle of half the size.
        assert_eq!([0.25, 0.5, 1.0].map(|s| slab(s, 0.5, 0.5, (1.0, -1.0), (0.0, 0.0, 0.0)).0), [0.0, 0.0, 0.25]);
        assert_eq!((weighted_mean(0.0, 0.0), weighted_mean(2.0, 3.0), limit(f64::MAX, -1.0, 1.0)), (0.0, 1.5, 1.0));
    }

    #[test]
    fn outlines_bend_where_sets_cross_and_are_clipped() {
        let stretches = || [(0.0, 4.0, [(1.0, 0.0), (0.0, 1.0)].as_slice())].into_iter();
        let clipped = maxima(stretches(), &[0.75, 0.75], minimum, maximum);
        assert_eq!(clipped, (0.0, 4.0, 2.0));
        assert_eq!(maxima(stretches(), &[0.5, 1.0], product, maximum), (4.0, 4.0, 4.0));
        let middle = |strengths| bisector(stretches(), strengths, minimum, maximum);
        assert_eq!([middle(&[1.0, 1.0]), middle(&[0.25, 0.25])], [2.0, 2.0]);
        // Two triangles of which one covers the other's half: 1 to 0, and half of 0 to 1, cross at 8/3.
        let center = outline_centroid(stretches(), &[1.0, 0.5], product, maximum);
        let area = 0.5 * (8.0 / 3.0) * (1.0 + 1.0 / 3.0) + 0.5 * (4.0 / 3.0) * (1.0 / 3.0 + 0.5);
        let moment =
            (8.0_f64 / 3.0).powi(2) / 2.0 - (8.0_f64 / 3.0).powi(3) / 12.0 + (64.0 - (8.0_f64 / 3.0).powi(3)) / 24.0;
        assert!((center - moment / area).abs() < 1e-15);
    }

    #[test]
    fn a_flag_is_held_from_the_tick_it_set() {
        let mut stopwatch = Stopwatch::default();
        let wanted = [true, false, false, false, true];
        let held = wanted.map(|wanted| hold(&mut stopwatch, wanted, 10, 20));
        assert_eq!(held, [true, true, false, false, true]);
    }

    #[test]
    fn a_stream_stays_in_its_interval_and_replays() {
        let draws = |mut state: u64| (0..1000).map(|_| draw(&mut state, -2.0, 2.0)).collect::<Vec<_>>();
        assert_eq!(draws(7), draws(7));
        assert_ne!(draws(7), draws(8));
        assert!(draws(7).iter().all(|drawn| (-2.0..=2.0).contains(drawn)));
        assert!(draws(7).iter().any(|drawn| *drawn < -1.9) && draws(7).iter().any(|drawn| *drawn > 1.9));
    }
}
