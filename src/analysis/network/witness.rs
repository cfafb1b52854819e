//! Readings that show that something can happen.

use super::model::{EventModel, Level, Model};
use super::slices;
use crate::base::Fraction;

/// One reading for each input of a network.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Witness {
    /// In the order of the inputs; none for a sensor that gives no reading.
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
    /// The readings for one pattern of each input that an event uses, at a level. The other inputs read what they may.
    pub(super) fn witness(&self, event: &EventModel, states: &[usize], level: &Level, patterns: &[usize]) -> Witness {
        let mut readings = self.anything(states);
        for (named, &pattern) in event.uses.iter().zip(patterns) {
            let (state, input) = (states[named.input], &self.inputs[named.input]);
            let choices: Vec<_> = named.choices.iter().map(|choice| choice.literals.as_slice()).collect();
            let wanted = &named.slices[state].at(&level.height, level.is_gap)[pattern];
            let fraction = slices::reading(&input.sensors[state], &choices, &level.value, wanted);
            readings[named.input] = fraction.map(|fraction| Reading { fraction, pi: input.pi });
        }
        Witness { readings }
    }

    /// The middle of what every input can read.
    pub(super) fn anything(&self, states: &[usize]) -> Vec<Option<Reading>> {
        let middle = |(input, &state): (&super::model::Input, &usize)| {
            let cells = &input.sensors[state].cells;
            let (low, _) = cells.first()?.ends.as_ref()?;
            let (_, high) = cells.last()?.ends.as_ref()?;
            Some(Reading { fraction: low.halfway(high), pi: input.pi })
        };
        self.inputs.iter().zip(states).map(middle).collect()
    }
}
