//! What an event does not need of what it names, decided by comparing it with another event like it.

use super::event::Verdict;
use super::faults::FaultSet;
use super::joint::Valuation;
use super::model::{Clause, EventModel, Input, Model};

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
    /// Whether an event depends on one input: whether it can be set or not by that input alone. `Never` where it does
    /// not, although its rules may name it; a witness ends with the input's other reading.
    pub fn dependence(&self, event: usize, input: usize, faults: &FaultSet) -> Verdict {
        let Some(original) = self.inputs.get(input) else { return Verdict::Never };
        let mut inputs = self.inputs.clone();
        inputs.push(original.clone());
        let other = self.inputs.len();
        let renamed = |clause: Clause| (if clause.0 == input { other } else { clause.0 }, clause.1);
        let Some(pair) = self.beside(event, inputs, |clause| Some(renamed(clause))) else { return Verdict::Never };
        let mut twin_faults = faults.clone();
        let same = faults.iter().filter(|fault| fault.input == input);
        twin_faults.extend(same.map(|fault| super::Fault { input: other, ..*fault }).collect::<Vec<_>>());
        pair.differing(&twin_faults)
    }

    /// The inputs that can be left out of an event's rules without changing it, together: the event equals the one whose
    /// rules do not name them. As many as can be, the last ones first.
    pub fn needless_inputs(&self, event: usize, faults: &FaultSet) -> Vec<usize> {
        let mut needless: Vec<usize> = Vec::new();
        let uses = self.events.get(event).into_iter().flat_map(|event| event.uses.iter().rev());
        for candidate in uses.map(|named| named.input) {
            let left_out = |clause: Clause| (clause.0 != candidate && !needless.contains(&clause.0)).then_some(clause);
            let pair = self.beside(event, self.inputs.clone(), left_out);
            if pair.is_some_and(|pair| pair.differing(faults) == Verdict::Never) {
                needless.push(candidate);
            }
        }
        needless.reverse();
        needless
    }

    /// An event beside the one whose clauses are mapped.
    fn beside(&self, event: usize, inputs: Vec<Input>, map: impl Fn(Clause) -> Option<Clause>) -> Option<Self> {
        let pair = |event: &EventModel| {
            let other = EventModel::of_clauses(mapped(event, &map), event.contributors, &inputs);
            vec![event.clone(), other]
        };
        let (events, loose) = (pair(self.events.get(event)?), self.loose.as_ref().map(|loose| pair(&loose[event])));
        Some(Self::of_events(inputs, events, loose))
    }

    /// Whether the model's two events can differ.
    fn differing(&self, faults: &FaultSet) -> Verdict {
        let valuations = self.valuations(&self.facts_under(faults)).into_iter();
        let differing = valuations.filter(|valuation| valuation.set.first() != valuation.set.last());
        let verdicts = differing.map(|found| found.witness.map_or(Verdict::Unknown, Verdict::Possible));
        verdicts.max_by_key(|verdict| verdict.witness().is_some()).unwrap_or(Verdict::Never)
    }
}

fn mapped(event: &EventModel, map: impl Fn(Clause) -> Option<Clause>) -> Vec<Vec<Clause>> {
    let rules = event.clauses().into_iter();
    rules
        .map(|rule| rule.into_iter().filter_map(|(input, literals)| map((input, literals.to_vec()))).collect())
        .collect()
}
