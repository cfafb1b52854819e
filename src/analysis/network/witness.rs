//! Readings that show that something can happen.

use std::collections::HashMap;

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

/// The readings for patterns at the levels of an event, each found once for all fault sets.
pub(super) struct Readings<'a> {
    pub(super) model: &'a Model,
    pub(super) event: &'a EventModel,
    known: HashMap<Key, Option<Reading>>,
}

/// The position of an input among those in use, its state, a pattern, and the level at which it has it.
type Key = (usize, usize, usize, Fraction);

impl<'a> Readings<'a> {
    pub(super) fn new(model: &'a Model, event: &'a EventModel) -> Self {
        Self { model, event, known: HashMap::new() }
    }

    /// The readings for one pattern of each input in use at a level. Only these inputs matter.
    pub(super) fn witness(&mut self, states: &[usize], level: &Level, patterns: &[usize]) -> Witness {
        let mut readings = vec![None; self.model.inputs.len()];
        for (position, (named, &pattern)) in self.event.uses.iter().zip(patterns).enumerate() {
            let state = states[named.input];
            let key = (position, state, pattern, level.value.clone());
            let reading = self.known.entry(key).or_insert_with(|| {
                let input = &self.model.inputs[named.input];
                let choices: Vec<_> = named.choices.iter().map(|choice| choice.literals.as_slice()).collect();
                let wanted = &named.patterns(states, level)[pattern];
                let fraction = slices::reading(&input.sensors[state], &choices, &level.value, wanted)?;
                Some(Reading { fraction, pi: input.pi })
            });
            readings[named.input].clone_from(reading);
        }
        Witness { readings }
    }
}
