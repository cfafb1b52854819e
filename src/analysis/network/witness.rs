//! Readings that show that something can happen.

use std::collections::HashMap;

use super::engine::Found;
use super::faults::FaultSet;
use super::model::{EventModel, Level, Model};
use super::slices;
use crate::base::Fraction;

/// Readings of a network's inputs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Witness {
    /// In the order of the inputs; none for a sensor that gives no reading, or one that does not matter.
    pub readings: Vec<Option<Reading>>,
}

/// An exact reading in SI: a fraction times a power of π.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Reading {
    /// The fraction.
    pub fraction: Fraction,
    /// The power of π.
    pub pi: i8,
}

impl Reading {
    /// The nearest `f64`, in SI.
    pub fn to_f64(&self) -> f64 {
        self.fraction.to_f64_times_pi(self.pi)
    }
}

impl Model {
    /// A witness with a reading for each input that can give one under some failures: where it does not matter, the
    /// middle of what there can be.
    pub fn complete(&self, faults: &FaultSet, witness: &Witness) -> Witness {
        self.complete_in(&self.states(faults), witness)
    }

    pub(super) fn complete_in(&self, states: &[usize], witness: &Witness) -> Witness {
        let readings = self.inputs.iter().zip(states).zip(&witness.readings).map(|((input, &state), reading)| {
            let cells = &input.sensors[state].cells;
            let (low, _) = cells.first()?.ends.as_ref()?;
            let (_, high) = cells.last()?.ends.as_ref()?;
            reading.clone().or_else(|| Some(Reading { fraction: low.halfway(high), pi: input.pi }))
        });
        Witness { readings: readings.collect() }
    }
}

/// The readings for patterns at the levels of an event, each found once.
pub(super) struct Readings<'a> {
    model: &'a Model,
    event: &'a EventModel,
    states: &'a [usize],
    levels: &'a [Level],
    /// By level, input in use and pattern.
    known: HashMap<[usize; 3], Option<Reading>>,
}

impl<'a> Readings<'a> {
    pub(super) fn new(model: &'a Model, event: &'a EventModel, states: &'a [usize], levels: &'a [Level]) -> Self {
        Self { model, event, states, levels, known: HashMap::new() }
    }

    /// The readings for what an engine found. Only the inputs that the event uses matter.
    pub(super) fn witness(&mut self, found: &Found) -> Witness {
        let mut readings = vec![None; self.model.inputs.len()];
        let level = &self.levels[found.level];
        for (position, (named, &pattern)) in self.event.uses.iter().zip(&found.patterns).enumerate() {
            let reading = self.known.entry([found.level, position, pattern]).or_insert_with(|| {
                let input = &self.model.inputs[named.input];
                let choices: Vec<_> = named.choices.iter().map(|choice| choice.literals.as_slice()).collect();
                let wanted = &named.patterns(self.states, level)[pattern];
                let sensor = &input.sensors[self.states[named.input]];
                let fraction = slices::reading(sensor, &choices, &level.value, wanted)?;
                Some(Reading { fraction, pi: input.pi })
            });
            readings[named.input].clone_from(reading);
        }
        Witness { readings }
    }
}
