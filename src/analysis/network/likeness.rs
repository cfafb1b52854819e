//! What an event does not need of what it names, decided by comparing it with another event like it.

use super::faults::FaultSet;
use super::joint::Valuation;
use super::model::{Clause, EventModel, Model};
use super::witness::Witness;

/// What can be said of two events, by their positions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Relation {
    /// Wherever the first is set, the second is.
    Implies(usize, usize),
    /// They are never set together.
    Excludes(usize, usize),
}

/// The implications and exclusions between events that can be set and can be clear, given all valuations, sorted.
pub fn relations(valuations: &[Valuation]) -> Vec<Relation> {
    let events = valuations.first().map_or(0, |valuation| valuation.set.len());
    let some = |one: (usize, bool), other: (usize, bool)| {
        valuations.iter().any(|valuation| valuation.set[one.0] == one.1 && valuation.set[other.0] == other.1)
    };
    let varies = |event: usize| some((event, true), (event, true)) && some((event, false), (event, false));
    let mut relations = Vec::new();
    for one in (0..events).filter(|&event| varies(event)) {
        for other in (0..events).filter(|&event| event != one && varies(event)) {
            if !some((one, true), (other, false)) {
                relations.push(Relation::Implies(one, other));
            }
            if one < other && !some((one, true), (other, true)) {
                relations.push(Relation::Excludes(one, other));
            }
        }
    }
    relations.sort_unstable();
    relations
}

impl Model {
    /// Readings at which an event is set or not depending on one input alone, or `None`: then the event does not depend
    /// on the input, although its rules may name it. The witness ends with the input's other reading.
    pub fn dependence(&self, event: usize, input: usize, faults: &FaultSet) -> Option<Witness> {
        let (event, original) = (self.events.get(event)?, self.inputs.get(input)?);
        let mut inputs = self.inputs.clone();
        inputs.push(original.clone());
        let other = self.inputs.len();
        let renamed = |clause: Clause| (if clause.0 == input { other } else { clause.0 }, clause.1);
        let twin = EventModel::of_clauses(mapped(event, |clause| Some(renamed(clause))), event.contributors, &inputs);
        let pair = Self::of_events(inputs, vec![event.clone(), twin]);
        let mut twin_faults = faults.clone();
        let same = faults.iter().filter(|fault| fault.input == input);
        twin_faults.extend(same.map(|fault| super::Fault { input: other, ..*fault }).collect::<Vec<_>>());
        pair.differing(&twin_faults)
    }

    /// The inputs that can be left out of an event's rules without changing it, together: the event equals the one whose
    /// rules do not name them. As many as can be, the last ones first.
    pub fn needless_inputs(&self, event: usize, faults: &FaultSet) -> Vec<usize> {
        let Some(event) = self.events.get(event) else { return Vec::new() };
        let mut needless: Vec<usize> = Vec::new();
        for candidate in event.uses.iter().rev().map(|named| named.input) {
            let left_out = |clause: Clause| (clause.0 != candidate && !needless.contains(&clause.0)).then_some(clause);
            let smaller = EventModel::of_clauses(mapped(event, left_out), event.contributors, &self.inputs);
            let pair = Self::of_events(self.inputs.clone(), vec![event.clone(), smaller]);
            if pair.differing(faults).is_none() {
                needless.push(candidate);
            }
        }
        needless.reverse();
        needless
    }

    /// Readings at which the model's two events differ.
    fn differing(&self, faults: &FaultSet) -> Option<Witness> {
        let facts = self.facts_under(faults);
        let valuations = self.valuations(&facts).into_iter();
        valuations.filter(|valuation| valuation.set.first() != valuation.set.last()).map(|found| found.witness).next()
    }
}

fn mapped(event: &EventModel, map: impl Fn(Clause) -> Option<Clause>) -> Vec<Vec<Clause>> {
    let rules = event.clauses().into_iter();
    rules
        .map(|rule| rule.into_iter().filter_map(|(input, literals)| map((input, literals.to_vec()))).collect())
        .collect()
}
