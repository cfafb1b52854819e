//! How much noise an event stands at given readings.

use super::faults::FaultSet;
use super::model::Model;
use super::sensor::Cell;
use super::witness::{Reading, Witness};
use crate::base::Fraction;

impl Model {
    /// For each input, the smallest change of its reading alone that changes whether an event is set: any larger one may
    /// do so, none smaller does. `None` where no reading of the input does, or where smooth
    /// terms leave it open. The witness must be complete, and possible
    /// under the failures.
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
        let is_set = |degrees: &[Vec<Fraction>]| {
            let (contributor, detractor) = event.sides(degrees);
            contributor > detractor
        };
        let now = is_set(degrees);
        let others = degrees.iter().enumerate().filter(|(other, _)| *other != input);
        let constants: Vec<&Fraction> = others.flat_map(|(_, degrees)| degrees).chain([&Fraction::ONE]).collect();
        let mut nearest: Option<Fraction> = None;
        let mut moved = degrees.to_vec();
        for cell in &self.inputs[input].sensors[states[input]].cells {
            for (from, to) in cell.stretches(&constants) {
                moved[input] = cell.degrees_at(&from.halfway(&to));
                if is_set(&moved) != now {
                    let ends = [cell.reading(&from), cell.reading(&to)];
                    let distance = distance(ends, reading)?;
                    if nearest.as_ref().is_none_or(|nearest| distance < *nearest) {
                        nearest = Some(distance);
                    }
                }
            }
        }
        nearest
    }
}

/// How far a reading is from a stretch of readings between two ends.
fn distance([from, to]: [Option<Fraction>; 2], reading: &Fraction) -> Option<Fraction> {
    let (from, to) = (from?, to?);
    let zero = Fraction::ZERO;
    Some((&from - reading).max(reading - &to).max(zero))
}

impl Cell {
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
