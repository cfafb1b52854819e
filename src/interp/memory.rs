//! The memory of a running plan, and the meaning of each step.

use std::ops::Range;

use super::Reading;
use crate::kernel::{self, Stopwatch, Window};
use crate::plan::{Aggregation, Bool, Code, Find, Grouping, Implication, Input, Real, SNorm, Shape, Step, TNorm};

/// What is known of `ROWS` ticks that follow each other; of one where a machine runs.
#[derive(Debug, Clone)]
pub(super) struct Memory<const ROWS: usize> {
    reals: Vec<[f64; ROWS]>,
    bools: Vec<[bool; ROWS]>,
    memories: Vec<bool>,
    windows: Vec<Window>,
    /// The readings that the windows keep.
    readings: Vec<f64>,
    stopwatches: Vec<Stopwatch>,
    counters: Vec<u32>,
    latches: Vec<bool>,
    kept: Vec<f64>,
    /// The strengths of the sets that are being defuzzified, or the readings that are being grouped.
    strengths: Vec<f64>,
    /// Nanoseconds since the active mode was entered.
    pub(super) dwell: u64,
}

/// What a tick is told.
pub(super) struct Told<'t, Read> {
    /// What an input reads in a row; none for a sensor that is not there.
    pub(super) read: Read,
    /// How many rows there are; what is computed of the others means nothing.
    pub(super) rows: usize,
    /// Whether the action of the active mode has reported completion.
    pub(super) done: bool,
    /// Nanoseconds since the tick before.
    pub(super) dt: u64,
    /// The active mode.
    pub(super) active: u32,
    /// The active modes, from the outermost inward; empty before the first tick, and where nothing asks.
    pub(super) path: &'t [u32],
}

impl<const ROWS: usize> Memory<ROWS> {
    pub(super) fn new(code: &Code) -> Self {
        Self {
            reals: vec![[0.0; ROWS]; code.reals as usize],
            bools: vec![[false; ROWS]; code.bools as usize],
            memories: vec![false; code.memories as usize],
            windows: vec![Window::default(); code.windows as usize],
            readings: vec![0.0; code.readings as usize],
            stopwatches: vec![Stopwatch::default(); code.stopwatches as usize],
            counters: vec![0; code.counters as usize],
            latches: vec![false; code.latches as usize],
            kept: code.kept.clone(),
            strengths: Vec::with_capacity(code.real_lists.len()),
            dwell: 0,
        }
    }

    /// A number in every row.
    pub(super) fn reals(&self, real: Real) -> &[f64; ROWS] {
        &self.reals[real as usize]
    }

    /// A truth value in every row.
    pub(super) fn bools(&self, bool: Bool) -> &[bool; ROWS] {
        &self.bools[bool as usize]
    }

    /// Writes a number for every row from what is known of that row.
    pub(super) fn set_reals(&mut self, real: Real, value: impl Fn(&Self, usize) -> f64) {
        self.reals[real as usize] = std::array::from_fn(|row| value(self, row));
    }

    fn set_bools(&mut self, bool: Bool, value: impl Fn(&Self, usize) -> bool) {
        self.bools[bool as usize] = std::array::from_fn(|row| value(self, row));
    }

    fn real(&self, real: Real, row: usize) -> f64 {
        self.reals[real as usize][row]
    }

    fn bool(&self, bool: Bool, row: usize) -> bool {
        self.bools[bool as usize][row]
    }

    /// Forgets everything but what never changes.
    pub(super) fn restart(&mut self, code: &Code) {
        self.memories.fill(false);
        self.stopwatches.fill(Stopwatch::default());
        self.windows.fill(Window::default());
        self.readings.fill(0.0);
        self.kept.copy_from_slice(&code.kept);
        self.enter_mode();
    }

    /// Restarts what belongs to the active mode.
    pub(super) fn enter_mode(&mut self) {
        self.dwell = 0;
        self.counters.fill(0);
        self.latches.fill(false);
    }

    /// Nanoseconds until the timer of a step expires, 0 where it has; `None` where none is running.
    pub(super) fn left(&self, step: &Step) -> Option<u64> {
        match *step {
            Step::After { duration, .. } => Some(duration.saturating_sub(self.dwell)),
            Step::Lasts { duration, stopwatch, .. } | Step::Hold { duration, stopwatch, .. } => {
                let Stopwatch { running, elapsed } = self.stopwatches[stopwatch as usize];
                running.then(|| duration.saturating_sub(elapsed))
            }
            _ => None,
        }
    }

    /// What is remembered from tick to tick, besides times.
    pub(super) fn past(&self) -> (&[bool], &[bool], &[u32]) {
        (&self.memories, &self.latches, &self.counters)
    }

    /// What windows keep, number by number.
    pub(super) fn kept_readings(&self) -> impl Iterator<Item = u64> {
        let windows = self.windows.iter().flat_map(|of| [of.held as u64, of.next as u64, of.left, of.mean.to_bits()]);
        windows.chain(self.readings.iter().map(|reading| reading.to_bits()))
    }

    /// Runs some steps for every row. What remembers follows the rows in their order.
    pub(super) fn run(
        &mut self,
        code: &Code,
        steps: Range<u32>,
        inputs: &[Input],
        told: &Told<'_, impl Fn(u32, usize) -> Option<Reading>>,
    ) {
        let Told { read, rows, done, dt, active, path: here } = told;
        let (rows, dt) = (0..*rows, *dt);
        for step in &code.steps[range(&steps)] {
            match *step {
                Step::Read { input, to } => {
                    let Input { low, high, fail, .. } = inputs[input as usize];
                    self.set_reals(to, |_, row| match read(input, row) {
                        Some(reading) => kernel::sanitize(reading.value, reading.healthy, low, high, fail),
                        None => fail,
                    });
                }
                Step::Average { input, of, period, window, ref readings, to } => {
                    for row in rows.clone() {
                        let usable =
                            read(input, row).is_some_and(|reading| kernel::is_usable(reading.value, reading.healthy));
                        let (reading, kept) = (self.real(of, row), &mut self.readings[range(readings)]);
                        let window = &mut self.windows[window as usize];
                        self.reals[to as usize][row] = window.observe(kept, reading, usable, dt, period);
                    }
                }
                Step::Group { how, ref of, to } => self.group(how, &code.real_lists[range(of)], to),
                Step::Constant { value, to } => self.set_reals(to, |_, _| value),
                Step::Degree { of, ref shape, to } => {
                    self.reals[to as usize] = degrees(*self.reals(of), shape, &code.points);
                }
                Step::Complement { of, to } => self.set_reals(to, |memory, row| 1.0 - memory.real(of, row)),
                Step::Very { of, to } => self.set_reals(to, |memory, row| kernel::very(memory.real(of, row))),
                Step::Somewhat { of, to } => self.set_reals(to, |memory, row| kernel::somewhat(memory.real(of, row))),
                Step::Minimum { ref of, to } => self.fold(&code.real_lists[range(of)], 1.0, kernel::minimum, to),
                Step::Maximum { ref of, to } => self.fold(&code.real_lists[range(of)], 0.0, kernel::maximum, to),
                Step::TNorm { norm, left, right, to } => {
                    let norm = t_norm(norm);
                    self.set_reals(to, |memory, row| norm(memory.real(left, row), memory.real(right, row)));
                }
                Step::SNorm { norm, left, right, to } => {
                    let norm = s_norm(norm);
                    self.set_reals(to, |memory, row| norm(memory.real(left, row), memory.real(right, row)));
                }
                Step::Weigh { of, weight, to } => {
                    self.set_reals(to, |memory, row| kernel::product(memory.real(of, row), weight));
                }
                Step::Linear { constant, ref factors, to } => self.set_reals(to, |memory, row| {
                    let products = code.factors[range(factors)].iter();
                    products.map(|&(real, factor)| memory.real(real, row) * factor).fold(constant, kernel::sum)
                }),
                Step::Centroid { .. } | Step::Outline { .. } | Step::Midpoints { .. } | Step::Mean { .. } => {
                    rows.clone().for_each(|row| self.defuzzify(code, step, row));
                }
                Step::Limit { of, low, high, to } => {
                    self.set_reals(to, |memory, row| kernel::limit(memory.real(of, row), low, high));
                }
                Step::Fires { of, to } => self.set_bools(to, |memory, row| kernel::fires(memory.real(of, row))),
                Step::Otherwise { fired, of, otherwise, to } => {
                    self.set_reals(
                        to,
                        |memory, row| {
                            if memory.bool(fired, row) { memory.real(of, row) } else { otherwise }
                        },
                    );
                }
                Step::Keep { fired, of, kept, to } => {
                    for row in rows.clone() {
                        if self.bool(fired, row) {
                            self.kept[kept as usize] = self.real(of, row);
                        }
                        self.reals[to as usize][row] = self.kept[kept as usize];
                    }
                }
                Step::Outweighs { contributor, detractor, to } => self.set_bools(to, |memory, row| {
                    kernel::outweighs(memory.real(contributor, row), memory.real(detractor, row))
                }),
                Step::OutweighsWithHysteresis { contributor, detractor, hysteresis, memory, to } => {
                    for row in rows.clone() {
                        let (contributor, detractor) = (self.real(contributor, row), self.real(detractor, row));
                        let before = &mut self.memories[memory as usize];
                        *before = kernel::outweighs_with_hysteresis(contributor, detractor, hysteresis, *before);
                        self.bools[to as usize][row] = *before;
                    }
                }
                Step::Lasts { of, duration, stopwatch, to } => {
                    for row in rows.clone() {
                        let on = self.bool(of, row);
                        self.bools[to as usize][row] = self.stopwatches[stopwatch as usize].lasts(on, dt, duration);
                    }
                }
                Step::Hold { of, duration, stopwatch, to } => {
                    for row in rows.clone() {
                        let wanted = self.bool(of, row);
                        let stopwatch = &mut self.stopwatches[stopwatch as usize];
                        self.bools[to as usize][row] = kernel::hold(stopwatch, wanted, dt, duration);
                    }
                }
                Step::Failed { input, to } => {
                    self.set_bools(to, |_, row| !read(input, row).is_some_and(|reading| reading.healthy));
                }
                Step::Compare { comparison, left, right, to } => {
                    self.set_bools(to, |memory, row| comparison.holds(memory.real(left, row), memory.real(right, row)));
                }
                Step::After { duration, to } => self.set_bools(to, |memory, _| memory.dwell >= duration),
                Step::Done { to } => self.set_bools(to, |_, _| *done),
                Step::Inside { ref path, to } => {
                    self.set_bools(to, |_, _| here.starts_with(&code.paths[range(path)]));
                }
                Step::InMode { mode, to } => self.set_bools(to, |_, _| *active == mode),
                Step::Rising { of, memory, to } => {
                    for row in rows.clone() {
                        let before = self.remember(of, memory, row);
                        self.bools[to as usize][row] = self.bool(of, row) && !before;
                    }
                }
                Step::Falling { of, memory, to } => {
                    for row in rows.clone() {
                        let before = self.remember(of, memory, row);
                        self.bools[to as usize][row] = !self.bool(of, row) && before;
                    }
                }
                Step::Latched { of, latch, to } => {
                    for row in rows.clone() {
                        self.latches[latch as usize] |= self.bool(of, row);
                        self.bools[to as usize][row] = self.latches[latch as usize];
                    }
                }
                Step::Count { of, memory, counter, to } => {
                    for row in rows.clone() {
                        let edge = !self.remember(of, memory, row) && self.bool(of, row);
                        let counter = &mut self.counters[counter as usize];
                        *counter = counter.saturating_add(u32::from(edge));
                        self.reals[to as usize][row] = f64::from(*counter);
                    }
                }
                Step::Not { of, to } => self.set_bools(to, |memory, row| !memory.bool(of, row)),
                Step::All { ref of, to } => self
                    .set_bools(to, |memory, row| code.bool_lists[range(of)].iter().all(|&bool| memory.bool(bool, row))),
                Step::Any { ref of, to } => self
                    .set_bools(to, |memory, row| code.bool_lists[range(of)].iter().any(|&bool| memory.bool(bool, row))),
            }
        }
    }

    /// The smallest or the largest of some numbers; `none` of none.
    fn fold(&mut self, list: &[Real], none: f64, choose: impl Fn(f64, f64) -> f64, to: Real) {
        let [first, rest @ ..] = list else { return self.set_reals(to, |_, _| none) };
        let mut values = *self.reals(*first);
        for real in rest {
            for (value, other) in values.iter_mut().zip(self.reals(*real)) {
                *value = choose(*value, *other);
            }
        }
        self.reals[to as usize] = values;
    }

    /// One reading from several, in every row.
    fn group(&mut self, how: Grouping, list: &[Real], to: Real) {
        let group = |readings: &[f64]| match how {
            Grouping::Minimum => kernel::smallest_reading(readings),
            Grouping::Maximum => kernel::largest_reading(readings),
            Grouping::Mean => kernel::mean_reading(readings),
            Grouping::Median => kernel::median_reading(readings),
            Grouping::Widest { beyond, first, spacing } => kernel::widest_opening(readings, beyond, first, spacing),
        };
        let mut readings = std::mem::take(&mut self.strengths);
        for row in 0..ROWS {
            readings.clear();
            readings.extend(list.iter().map(|&real| self.real(real, row)));
            self.reals[to as usize][row] = group(&readings);
        }
        self.strengths = readings;
    }

    /// A number from sets or numbers, each with a strength.
    fn defuzzify(&mut self, code: &Code, step: &Step, row: usize) {
        let mut of_sets = std::mem::take(&mut self.strengths);
        of_sets.clear();
        let list = |of: &Range<u32>| code.real_lists[range(of)].iter().map(|&real| self.real(real, row));
        if let Step::Outline { strengths, .. } | Step::Midpoints { strengths, .. } = step {
            of_sets.extend(list(strengths));
        }
        let (value, to) = match *step {
            Step::Centroid { ref slabs, center, to } => {
                let held = code.slabs[range(slabs)].iter().map(|slab| {
                    kernel::slab(self.real(slab.strength, row), slab.floor, slab.thickness, slab.area, slab.moment)
                });
                let (area, moment) = held.fold((0.0, 0.0), |sum, slab| (sum.0 + slab.0, sum.1 + slab.1));
                (center + kernel::weighted_mean(area, moment), to)
            }
            Step::Outline { find, implication, aggregation, ref stretches, to, .. } => {
                let stretches = code.stretches[range(stretches)].iter();
                let stretches = stretches.map(|of| (of.from, of.to, &code.points[range(&of.lines)]));
                let (imply, join) = (implied_by(implication), joined_by(aggregation));
                let found = match find {
                    Find::Centroid => kernel::outline_centroid(stretches, &of_sets, imply, join),
                    Find::Bisector => kernel::bisector(stretches, &of_sets, imply, join),
                    Find::SmallestOfMaximum => kernel::maxima(stretches, &of_sets, imply, join).0,
                    Find::LargestOfMaximum => kernel::maxima(stretches, &of_sets, imply, join).1,
                    Find::MeanOfMaximum => kernel::maxima(stretches, &of_sets, imply, join).2,
                };
                (found, to)
            }
            Step::Midpoints { implication, aggregation, ref samples, low, high, to, .. } => {
                let parts = code.samples[range(samples)].chunks_exact(of_sets.len().max(1));
                let (imply, join) = (implied_by(implication), joined_by(aggregation));
                (kernel::midpoints(parts, &of_sets, imply, join, low, high), to)
            }
            Step::Mean { ref weights, ref values, to } => {
                let weighted = list(weights)
                    .zip(list(values))
                    .fold((0.0, 0.0), |sum, (weight, value)| (sum.0 + weight, sum.1 + kernel::product(weight, value)));
                (kernel::weighted_mean(weighted.0, weighted.1), to)
            }
            _ => return,
        };
        self.reals[to as usize][row] = value;
        self.strengths = of_sets;
    }

    /// What a truth value was on the tick before; remembers what it is now.
    fn remember(&mut self, of: Bool, memory: u32, row: usize) -> bool {
        let now = self.bool(of, row);
        std::mem::replace(&mut self.memories[memory as usize], now)
    }
}

/// Degrees of membership. The shape is looked at once, and what it does to all rows is a loop of its own.
fn degrees<const ROWS: usize>(x: [f64; ROWS], shape: &Shape, points: &[(f64, f64)]) -> [f64; ROWS] {
    match *shape {
        Shape::Ramp { zero_at, one_at } => x.map(|x| kernel::ramp(x, zero_at, one_at)),
        Shape::Triangle([a, b, c]) => x.map(|x| kernel::triangle(x, a, b, c)),
        Shape::Trapezoid([a, b, c, d]) => x.map(|x| kernel::trapezoid(x, a, b, c, d)),
        Shape::Rectangle([low, high]) => x.map(|x| kernel::rectangle(x, low, high)),
        Shape::Singleton(at) => x.map(|x| kernel::singleton(x, at)),
        Shape::Points(ref of) => x.map(|x| kernel::points(x, &points[range(of)])),
        Shape::Gaussian([mean, deviation]) => x.map(|x| kernel::gaussian(x, mean, deviation)),
        Shape::Gaussian2([low, below, high, above]) => x.map(|x| kernel::gaussian2(x, low, below, high, above)),
        Shape::Bell([center, width, slope]) => x.map(|x| kernel::bell(x, center, width, slope)),
        Shape::Sigmoid([inflection, slope]) => x.map(|x| kernel::sigmoid(x, inflection, slope)),
        Shape::Rise([a, b]) => x.map(|x| kernel::rise(x, a, b)),
        Shape::Fall([a, b]) => x.map(|x| kernel::fall(x, a, b)),
        Shape::RiseAndFall([a, b, c, d]) => x.map(|x| kernel::rise_and_fall(x, a, b, c, d)),
        Shape::Cosine([center, width]) => x.map(|x| kernel::cosine(x, center, width)),
    }
}

fn t_norm(norm: TNorm) -> fn(f64, f64) -> f64 {
    match norm {
        TNorm::Minimum => kernel::minimum,
        TNorm::Product => kernel::product,
        TNorm::Bounded => kernel::bounded_difference,
        TNorm::Drastic => kernel::drastic_product,
        TNorm::Einstein => kernel::einstein_product,
        TNorm::Hamacher => kernel::hamacher_product,
        TNorm::Nilpotent => kernel::nilpotent_minimum,
    }
}

fn s_norm(norm: SNorm) -> fn(f64, f64) -> f64 {
    match norm {
        SNorm::Maximum => kernel::maximum,
        SNorm::Probabilistic => kernel::probabilistic_sum,
        SNorm::Bounded => kernel::bounded_sum,
        SNorm::Drastic => kernel::drastic_sum,
        SNorm::Einstein => kernel::einstein_sum,
        SNorm::Hamacher => kernel::hamacher_sum,
        SNorm::Nilpotent => kernel::nilpotent_maximum,
    }
}

fn implied_by(implication: Implication) -> fn(f64, f64) -> f64 {
    match implication {
        Implication::Minimum => kernel::minimum,
        Implication::Product => kernel::product,
    }
}

fn joined_by(aggregation: Aggregation) -> fn(f64, f64) -> f64 {
    match aggregation {
        Aggregation::Maximum => kernel::maximum,
        Aggregation::Sum => kernel::sum,
    }
}

fn range(range: &Range<u32>) -> Range<usize> {
    range.start as usize..range.end as usize
}
