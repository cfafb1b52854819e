//! The numeric meaning of one tick: membership, strength, memory, time and chance, each written once.
//!
//! Plain functions over plain numbers that import nothing of ours, so that the same text can be compiled here and
//! included in emitted code.
//!
//! Imports: –
//! Crates: libm

/// A reading made safe: the fail reading where the sensor is known to have failed or the number is not finite, else
/// the number clamped to its range. `low <= high`; never NaN if `fail` is not.
#[inline]
pub fn sanitize(reading: f64, healthy: bool, low: f64, high: f64, fail: f64) -> f64 {
    if healthy && reading.is_finite() { maximum(minimum(reading, high), low) } else { fail }
}

/// Degree of membership (LMSL eq. 1) of a line from 0 at `zero_at` to 1 at `one_at`, in either direction, clamped.
/// The corners differ. Exact at both corners.
#[inline]
pub fn ramp(x: f64, zero_at: f64, one_at: f64) -> f64 {
    // In this order a degree of -0 becomes 0.
    maximum(0.0, minimum(1.0, (x - zero_at) / (one_at - zero_at)))
}

/// Degree of membership of a triangle from `a` over `b` to `c`; `a <= b <= c`. Equal corners are steps with the larger
/// degree at the corner. No flank is above 1 on its own side of `b`, rounded or not.
#[inline]
pub fn triangle(x: f64, a: f64, b: f64, c: f64) -> f64 {
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
