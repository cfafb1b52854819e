//! The memory of a running plan, and the meaning of each step.

use std::ops::Range;

use super::Inputs;
use crate::kernel::{self, Stopwatch};
use crate::plan::{Aggregation, Bool, Code, Comparison, Find, Implication, Input, Real, SNorm, Shape, Step, TNorm};

#[derive(Debug, Clone)]
pub(super) struct Memory {
    reals: Vec<f64>,
    bools: Vec<bool>,
    memories: Vec<bool>,
    stopwatches: Vec<Stopwatch>,
    counters: Vec<u32>,
    latches: Vec<bool>,
    kept: Vec<f64>,
    /// The strengths of the sets that are being defuzzified.
    strengths: Vec<f64>,
    /// Nanoseconds since the active mode was entered.
    pub(super) dwell: u64,
}

impl Memory {
    pub(super) fn new(code: &Code) -> Self {
        Self {
            reals: vec![0.0; code.reals as usize],
            bools: vec![false; code.bools as usize],
            memories: vec![false; code.memories as usize],
            stopwatches: vec![Stopwatch::default(); code.stopwatches as usize],
            counters: vec![0; code.counters as usize],
            latches: vec![false; code.latches as usize],
            kept: code.kept.clone(),
            strengths: Vec::with_capacity(code.real_lists.len()),
            dwell: 0,
        }
    }

    pub(super) fn real(&self, real: Real) -> f64 {
        self.reals[real as usize]
    }

    pub(super) fn bool(&self, bool: Bool) -> bool {
        self.bools[bool as usize]
    }

    pub(super) fn set_real(&mut self, real: Real, value: f64) {
        self.reals[real as usize] = value;
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

    pub(super) fn run(
        &mut self,
        code: &Code,
        steps: Range<u32>,
        inputs: &[Input],
        told: Inputs<'_>,
        dt: u64,
        active: u32,
    ) {
        for step in &code.steps[range(&steps)] {
            match *step {
                Step::Read { input, to } => {
                    let Input { low, high, fail, .. } = inputs[input as usize];
                    self.reals[to as usize] = match told.readings.get(input as usize) {
                        Some(reading) => kernel::sanitize(reading.value, reading.healthy, low, high, fail),
                        None => fail,
                    };
                }
                Step::Constant { value, to } => self.reals[to as usize] = value,
                Step::Degree { of, ref shape, to } => {
                    self.reals[to as usize] = degree(self.real(of), shape, &code.points);
                }
                Step::Complement { of, to } => self.reals[to as usize] = 1.0 - self.real(of),
                Step::Very { of, to } => self.reals[to as usize] = kernel::very(self.real(of)),
                Step::Somewhat { of, to } => self.reals[to as usize] = kernel::somewhat(self.real(of)),
                Step::Minimum { ref of, to } => {
                    let operands = code.real_lists[range(of)].iter().map(|&real| self.real(real));
                    self.reals[to as usize] = operands.reduce(kernel::minimum).unwrap_or(1.0);
                }
                Step::Maximum { ref of, to } => {
                    let operands = code.real_lists[range(of)].iter().map(|&real| self.real(real));
                    self.reals[to as usize] = operands.reduce(kernel::maximum).unwrap_or(0.0);
                }
                Step::TNorm { norm, left, right, to } => {
                    self.reals[to as usize] = t_norm(norm)(self.real(left), self.real(right));
                }
                Step::SNorm { norm, left, right, to } => {
                    self.reals[to as usize] = s_norm(norm)(self.real(left), self.real(right));
                }
                Step::Weigh { of, weight, to } => self.reals[to as usize] = kernel::product(self.real(of), weight),
                Step::Linear { constant, ref factors, to } => {
                    let products = code.factors[range(factors)].iter().map(|&(real, factor)| self.real(real) * factor);
                    self.reals[to as usize] = products.fold(constant, kernel::sum);
                }
                Step::Centroid { .. } | Step::Outline { .. } | Step::Midpoints { .. } | Step::Mean { .. } => {
                    self.defuzzify(code, step);
                }
                Step::Limit { of, low, high, to } => {
                    self.reals[to as usize] = kernel::limit(self.real(of), low, high);
                }
                Step::Fires { of, to } => self.bools[to as usize] = kernel::fires(self.real(of)),
                Step::Otherwise { fired, of, otherwise, to } => {
                    self.reals[to as usize] = if self.bool(fired) { self.real(of) } else { otherwise };
                }
                Step::Keep { fired, of, kept, to } => {
                    if self.bool(fired) {
                        self.kept[kept as usize] = self.real(of);
                    }
                    self.reals[to as usize] = self.kept[kept as usize];
                }
                Step::Outweighs { contributor, detractor, to } => {
                    self.bools[to as usize] = kernel::outweighs(self.real(contributor), self.real(detractor));
                }
                Step::OutweighsWithHysteresis { contributor, detractor, hysteresis, memory, to } => {
                    let (contributor, detractor) = (self.real(contributor), self.real(detractor));
                    let before = &mut self.memories[memory as usize];
                    *before = kernel::outweighs_with_hysteresis(contributor, detractor, hysteresis, *before);
                    self.bools[to as usize] = *before;
                }
                Step::Lasts { of, duration, stopwatch, to } => {
                    let on = self.bool(of);
                    self.bools[to as usize] = self.stopwatches[stopwatch as usize].lasts(on, dt, duration);
                }
                Step::Hold { of, duration, stopwatch, to } => {
                    let wanted = self.bool(of);
                    let stopwatch = &mut self.stopwatches[stopwatch as usize];
                    self.bools[to as usize] = kernel::hold(stopwatch, wanted, dt, duration);
                }
                Step::Failed { input, to } => {
                    let healthy = told.readings.get(input as usize).is_some_and(|reading| reading.healthy);
                    self.bools[to as usize] = !healthy;
                }
                Step::Compare { comparison, left, right, to } => {
                    self.bools[to as usize] = compare(comparison, self.real(left), self.real(right));
                }
                Step::After { duration, to } => self.bools[to as usize] = self.dwell >= duration,
                Step::Done { to } => self.bools[to as usize] = told.done,
                Step::InMode { mode, to } => self.bools[to as usize] = active == mode,
                Step::Rising { of, memory, to } => {
                    let before = self.remember(of, memory);
                    self.bools[to as usize] = self.bool(of) && !before;
                }
                Step::Falling { of, memory, to } => {
                    let before = self.remember(of, memory);
                    self.bools[to as usize] = !self.bool(of) && before;
                }
                Step::Latched { of, latch, to } => {
                    self.latches[latch as usize] |= self.bool(of);
                    self.bools[to as usize] = self.latches[latch as usize];
                }
                Step::Count { of, memory, counter, to } => {
                    let edge = !self.remember(of, memory) && self.bool(of);
                    let counter = &mut self.counters[counter as usize];
                    *counter = counter.saturating_add(u32::from(edge));
                    self.reals[to as usize] = f64::from(*counter);
                }
                Step::Not { of, to } => self.bools[to as usize] = !self.bool(of),
                Step::All { ref of, to } => {
                    self.bools[to as usize] = code.bool_lists[range(of)].iter().all(|&bool| self.bool(bool));
                }
                Step::Any { ref of, to } => {
                    self.bools[to as usize] = code.bool_lists[range(of)].iter().any(|&bool| self.bool(bool));
                }
            }
        }
    }

    /// A number from sets or numbers, each with a strength.
    fn defuzzify(&mut self, code: &Code, step: &Step) {
        let mut of_sets = std::mem::take(&mut self.strengths);
        of_sets.clear();
        let list = |of: &Range<u32>| code.real_lists[range(of)].iter().map(|&real| self.real(real));
        if let Step::Outline { strengths, .. } | Step::Midpoints { strengths, .. } = step {
            of_sets.extend(list(strengths));
        }
        let (value, to) = match *step {
            Step::Centroid { ref slabs, center, to } => {
                let held = code.slabs[range(slabs)].iter().map(|slab| {
                    kernel::slab(self.real(slab.strength), slab.floor, slab.thickness, slab.area, slab.moment)
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
        self.reals[to as usize] = value;
        self.strengths = of_sets;
    }

    /// What a truth value was on the tick before; remembers what it is now.
    fn remember(&mut self, of: Bool, memory: u32) -> bool {
        let now = self.bool(of);
        std::mem::replace(&mut self.memories[memory as usize], now)
    }
}

fn degree(x: f64, shape: &Shape, points: &[(f64, f64)]) -> f64 {
    match *shape {
        Shape::Ramp { zero_at, one_at } => kernel::ramp(x, zero_at, one_at),
        Shape::Triangle([a, b, c]) => kernel::triangle(x, a, b, c),
        Shape::Trapezoid([a, b, c, d]) => kernel::trapezoid(x, a, b, c, d),
        Shape::Rectangle([low, high]) => kernel::rectangle(x, low, high),
        Shape::Singleton(at) => kernel::singleton(x, at),
        Shape::Points(ref of) => kernel::points(x, &points[range(of)]),
        Shape::Gaussian([mean, deviation]) => kernel::gaussian(x, mean, deviation),
        Shape::Gaussian2([low, below, high, above]) => kernel::gaussian2(x, low, below, high, above),
        Shape::Bell([center, width, slope]) => kernel::bell(x, center, width, slope),
        Shape::Sigmoid([inflection, slope]) => kernel::sigmoid(x, inflection, slope),
        Shape::Rise([a, b]) => kernel::rise(x, a, b),
        Shape::Fall([a, b]) => kernel::fall(x, a, b),
        Shape::RiseAndFall([a, b, c, d]) => kernel::rise_and_fall(x, a, b, c, d),
        Shape::Cosine([center, width]) => kernel::cosine(x, center, width),
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

fn compare(comparison: Comparison, left: f64, right: f64) -> bool {
    match comparison {
        Comparison::Less => left < right,
        Comparison::LessOrEqual => left <= right,
        Comparison::Greater => left > right,
        Comparison::GreaterOrEqual => left >= right,
        Comparison::Equal => left == right,
        Comparison::NotEqual => left != right,
    }
}

fn range(range: &Range<u32>) -> Range<usize> {
    range.start as usize..range.end as usize
}
