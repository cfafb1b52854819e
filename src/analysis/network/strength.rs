//! The exact strengths of rules at given readings.

use super::faults::FaultSet;
use super::model::{EventModel, Model};
use super::sensor::Sensor;
use super::witness::Witness;
use crate::base::Fraction;

impl Sensor {
    /// The degree of every literal at a reading that the sensor can give; without one, at any.
    fn degrees(&self, reading: Option<&Fraction>) -> Vec<Fraction> {
        let holds = |ends: &Option<(Fraction, Fraction)>| match (reading, ends) {
            (Some(reading), Some((from, to))) => from == reading || from < reading && reading < to,
            _ => true,
        };
        let Some(cell) = self.cells.iter().find(|cell| holds(&cell.ends)) else { return Vec::new() };
        let share =
            reading.zip(cell.ends.as_ref()).and_then(|(reading, (from, to))| (reading - from).over(&(to - from)));
        let share = share.unwrap_or(Fraction::ZERO);
        cell.degrees.iter().map(|(from, to)| from + &(&(to - from) * &share)).collect()
    }
}

impl Model {
    /// The degrees of every input's literals at some readings.
    pub(super) fn degrees(&self, states: &[usize], witness: &Witness) -> Vec<Vec<Fraction>> {
        let inputs = self.inputs.iter().zip(states).zip(&witness.readings);
        inputs
            .map(|((input, &state), reading)| {
                input.sensors[state].degrees(reading.as_ref().map(|reading| &reading.fraction))
            })
            .collect()
    }

    /// Which events are set at some readings; `None` where smooth terms leave it open.
    pub(super) fn flags(&self, states: &[usize], witness: &Witness) -> Option<Vec<bool>> {
        let degrees = self.degrees(states, witness);
        let set = |events: &Vec<EventModel>| events.iter().map(|event| event.is_set(&degrees)).collect::<Vec<_>>();
        let flags = set(&self.events);
        let is_sure = self.loose.as_ref().is_none_or(|loose| set(loose) == flags);
        is_sure.then_some(flags)
    }

    /// How strong each rule of an event is at some readings, a reading for each input that can give one.
    pub fn strengths(&self, event: usize, faults: &FaultSet, witness: &Witness) -> Vec<Fraction> {
        let degrees = self.degrees(&self.states(faults), witness);
        self.events.get(event).map_or_else(Vec::new, |event| event.strengths(&degrees))
    }

    /// The largest degree at some readings, a reading for each input that can give one, of those terms of an input that
    /// rules name.
    pub fn largest_degree(&self, input: usize, faults: &FaultSet, witness: &Witness) -> Option<Fraction> {
        let degrees = self.degrees(&self.states(faults), witness);
        let named = self.inputs.get(input)?.columns.literals.iter().zip(degrees.get(input)?);
        named.filter(|(literal, _)| !literal.negated).map(|(_, degree)| degree.clone()).max()
    }
}

impl EventModel {
    /// How strong each rule is, given every literal's degree.
    pub(super) fn strengths(&self, degrees: &[Vec<Fraction>]) -> Vec<Fraction> {
        let mut strengths = vec![Fraction::ONE; self.rules];
        for named in &self.uses {
            for choice in &named.choices {
                let of = choice.literals.iter().filter_map(|&literal| degrees[named.input].get(literal));
                let degree = of.max().unwrap_or(&Fraction::ZERO);
                for &rule in &choice.rules {
                    if *degree < strengths[rule] {
                        strengths[rule] = degree.clone();
                    }
                }
            }
        }
        strengths
    }

    /// Whether the contributor outweighs the detractor, given every literal's degree.
    pub(super) fn is_set(&self, degrees: &[Vec<Fraction>]) -> bool {
        let (contributor, detractor) = self.sides(degrees);
        contributor > detractor
    }

    /// How strong the contributor and the detractor are.
    fn sides(&self, degrees: &[Vec<Fraction>]) -> (Fraction, Fraction) {
        let strengths = self.strengths(degrees);
        let (contributors, detractors) = strengths.split_at(self.contributors);
        let strongest = |rules: &[Fraction]| rules.iter().max().cloned().unwrap_or(Fraction::ZERO);
        (strongest(contributors), strongest(detractors))
    }
}
