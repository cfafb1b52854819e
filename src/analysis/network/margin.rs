//! What one reading decides while the others stay: how much noise an event stands, and which number it waits for.

use super::faults::FaultSet;
use super::model::{EventModel, Model};
use super::sensor::Cell;
use super::witness::{Reading, Witness};
use crate::base::Fraction;

/// A comparison of one input with one number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Comparison {
    /// The number.
    pub reading: Reading,
    /// Whether it holds above the number, and not below.
    pub above: bool,
    /// Whether it holds at the number itself.
    pub inclusive: bool,
}

impl Model {
    /// The comparison that an event equals, healthy and without memory, if all that it depends on is one input.
    pub fn comparison(&self, event: usize, input: usize) -> Option<Comparison> {
        let states = vec![0; self.inputs.len()];
        let anywhere = Witness { readings: vec![None; self.inputs.len()] };
        let degrees = self.degrees(&states, &self.complete_in(&states, &anywhere));
        let mut stretches = self.stretches(self.events.get(event)?, &states, &degrees, input);
        stretches.sort_by(|one, other| one.ends.cmp(&other.ends));
        let mut changes = stretches.windows(2).filter(|pair| pair[0].is_set != pair[1].is_set);
        let (Some([below, above]), None) = (changes.next(), changes.next()) else { return None };
        let at_number = if below.ends[0] == below.ends[1] { below } else { above };
        let reading = Reading { fraction: below.ends[1].clone()?, pi: self.inputs[input].pi };
        Some(Comparison { reading, above: above.is_set, inclusive: at_number.is_set })
    }

    /// For each input, the smallest change of its reading alone that changes whether an event is set: any larger one may
    /// do so, none smaller does. `None` where no reading of the input does, or where smooth terms leave it open. The
    /// witness must be complete, and possible under the failures.
    pub fn margins(&self, event: usize, faults: &FaultSet, at: &Witness) -> Vec<Option<Reading>> {
        let states = self.states(faults);
        let degrees = self.degrees(&states, at);
        let margin = |(input, reading): (usize, &Option<Reading>)| {
            let reading = &reading.as_ref()?.fraction;
            let distance = self.margin(event, &states, &degrees, input, reading)?;
            Some(Reading { fraction: distance, pi: self.inputs[input].pi })
        };
        at.readings.iter().enumerate().map(margin).collect()
    }

    fn margin(
        &self,
        event: usize,
        states: &[usize],
        degrees: &[Vec<Fraction>],
        input: usize,
        reading: &Fraction,
    ) -> Option<Fraction> {
        let event = self.events.get(event).filter(|_| self.loose.is_none())?;
        let now = event.is_set(degrees);
        let other = self.stretches(event, states, degrees, input).into_iter().filter(|stretch| stretch.is_set != now);
        other.filter_map(|stretch| distance(stretch.ends, reading)).min()
    }

    /// What an event is while one input moves and the others stay.
    fn stretches(&self, event: &EventModel, states: &[usize], degrees: &[Vec<Fraction>], input: usize) -> Vec<Stretch> {
        let others = degrees.iter().enumerate().filter(|(other, _)| *other != input);
        let constants: Vec<&Fraction> = others.flat_map(|(_, degrees)| degrees).chain([&Fraction::ONE]).collect();
        let mut moved = degrees.to_vec();
        let mut stretches = Vec::new();
        for cell in &self.inputs[input].sensors[states[input]].cells {
            for (from, to) in cell.stretches(&constants) {
                moved[input] = cell.degrees_at(&from.halfway(&to));
                let ends = [cell.reading(&from), cell.reading(&to)];
                stretches.push(Stretch { ends, is_set: event.is_set(&moved) });
            }
        }
        stretches
    }
}

/// Readings between two ends, or one reading, at all of which an event has one status.
struct Stretch {
    ends: [Option<Fraction>; 2],
    is_set: bool,
}

/// How far a reading is from a stretch of readings between two ends.
fn distance([from, to]: [Option<Fraction>; 2], reading: &Fraction) -> Option<Fraction> {
    let (from, to) = (from?, to?);
    let zero = Fraction::ZERO;
    Some((&from - reading).max(reading - &to).max(zero))
}

impl Cell {
    /// Its degrees in its middle.
    pub(super) fn middle(&self) -> Vec<Fraction> {
        self.degrees_at(&Fraction::new(1, 2))
    }

    /// Its degrees at a share of it.
    fn degrees_at(&self, share: &Fraction) -> Vec<Fraction> {
        self.degrees.iter().map(|(from, to)| from + &(&(to - from) * share)).collect()
    }

    /// The stretches of it, as shares, over which its literals keep their order among each other and among some
    /// constants, and the points between them.
    fn stretches(&self, constants: &[&Fraction]) -> Vec<(Fraction, Fraction)> {
        if self.is_point() {
            return vec![(Fraction::ZERO, Fraction::ZERO)];
        }
        let mut cuts = vec![Fraction::ZERO, Fraction::ONE];
        for (position, (from, to)) in self.degrees.iter().enumerate() {
            let lines = self.degrees[..position].iter().map(|(from, to)| (from, to));
            for (other_from, other_to) in lines.chain(constants.iter().map(|&constant| (constant, constant))) {
                let gap = other_from - from;
                let share = gap.over(&(&(to - from) - &(other_to - other_from)));
                cuts.extend(share.filter(|share| Fraction::ZERO < *share && *share < Fraction::ONE));
            }
        }
        cuts.sort_unstable();
        cuts.dedup();
        let points = cuts[1..cuts.len() - 1].iter().map(|cut| (cut.clone(), cut.clone()));
        let open = cuts.windows(2).map(|pair| (pair[0].clone(), pair[1].clone()));
        open.chain(points).collect()
    }
}
