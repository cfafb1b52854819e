//! How events are like each other, and what an event does not need of what it names.

use std::collections::BTreeSet;

use super::NetworkFacts;
use super::event::{EventFacts, Verdict};
use super::faults::FaultSet;
use super::joint;
use super::model::{Clause, EventModel, Input, Model};
use super::witness::Witness;
use crate::ir::Literal;

/// What can be said of two events, by their positions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Relation {
    /// Wherever the first is set, the second is.
    Implies(usize, usize),
    /// They are never set together.
    Excludes(usize, usize),
}

/// Pairs of events with more rules than this together are not compared.
const MOST_RULES: usize = 1 << 7;

/// So many readings at which a rule decides are tried before it is proved that an event does not depend on an input.
const MOST_WITNESSES: usize = 1 << 4;

impl Model {
    /// The implications and exclusions between events that can be set and can be clear, sorted. Of events with very many
    /// rules only those are found that the form of their rules shows.
    pub fn relations(&self, facts: &NetworkFacts) -> Vec<Relation> {
        let varies = |event: &usize| facts.events[*event].set.is_possible() && facts.events[*event].clear.is_possible();
        let varying: Vec<usize> = (0..self.events.len()).filter(varies).collect();
        if varying.len() < 2 {
            return Vec::new();
        }
        let states = self.states(&facts.faults);
        let flags = |witness: &Witness| self.flags(&states, &self.complete_in(&states, witness));
        let witnesses = facts.events.iter().flat_map(|event| event.witnesses());
        let seen: BTreeSet<Vec<bool>> = witnesses.filter_map(flags).collect();
        let excluded = |one: usize, other: usize, other_is_set: bool| {
            let is_seen = || seen.iter().any(|set| set[one] && set[other] == other_is_set);
            let by_form = || !other_is_set && self.implications.contains(&(one, other));
            !is_seen() && (by_form() || self.are_excluded(&states, one, other, other_is_set))
        };
        let mut relations = Vec::new();
        for &one in &varying {
            for &other in varying.iter().filter(|&&other| other != one) {
                if excluded(one, other, false) {
                    relations.push(Relation::Implies(one, other));
                }
                if one < other && excluded(one, other, true) {
                    relations.push(Relation::Excludes(one, other));
                }
            }
        }
        relations.sort_unstable();
        relations
    }

    /// Whether one event is never set while another one is, or is not. `false` proves nothing.
    fn are_excluded(&self, states: &[usize], one: usize, other: usize, other_is_set: bool) -> bool {
        let (first, second) = (&self.events[one], &self.events[other]);
        let shares_input = first.uses.iter().any(|named| second.uses.iter().any(|used| used.input == named.input));
        let pair = |events: &Vec<EventModel>| vec![events[one].clone(), events[other].clone()];
        // Inputs are independent of each other.
        shares_input && first.rules + second.rules <= MOST_RULES && {
            let pair = Self::of_events(self.inputs.clone(), pair(&self.events), self.loose.as_ref().map(pair));
            joint::verdict_of(&pair, states, &[(0, true), (1, other_is_set)]) == Verdict::Never
        }
    }

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
        pair.differing(&pair.states(&twin_faults))
    }

    /// The inputs that can be left out of an event's rules without changing it, together: the event equals the one whose
    /// rules do not name them. As many as can be, the last ones first. None of an event with very many rules.
    pub fn needless_inputs(&self, event: usize, facts: &NetworkFacts) -> Vec<usize> {
        let Some(known) = self.events.get(event).filter(|event| event.rules <= MOST_RULES) else { return Vec::new() };
        let mut needless: Vec<usize> = Vec::new();
        for candidate in known.uses.iter().rev().map(|named| named.input) {
            let is_left_out = |input, _: &[Literal]| input == candidate || needless.contains(&input);
            if !self.flips(event, facts, candidate)
                && self.difference_without(event, facts, is_left_out) == Verdict::Never
            {
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

    /// Whether an event is known to depend on an input: at some known readings another one of it changes the flag.
    fn flips(&self, event: usize, facts: &NetworkFacts, input: usize) -> bool {
        let states = self.states(&facts.faults);
        let known = &self.events[event];
        let rules = facts.events[event].contributor.iter().chain(&facts.events[event].detractor);
        let mut decisive = rules.filter_map(|rule| rule.decisive.witness()).take(MOST_WITNESSES);
        decisive.any(|witness| {
            let mut degrees = self.degrees(&states, &self.complete_in(&states, witness));
            let now = known.is_set(&degrees);
            self.inputs[input].sensors[states[input]].cells.iter().any(|cell| {
                degrees[input] = cell.middle();
                known.is_set(&degrees) != now
            })
        })
    }

    /// Whether an event would be another at some readings if some cells of its rules, each an input and the terms of
    /// which the largest degree counts, were left out.
    pub fn difference_without(
        &self,
        event: usize,
        facts: &NetworkFacts,
        is_left_out: impl Fn(usize, &[Literal]) -> bool,
    ) -> Verdict {
        let kept = |(input, literals): Clause| {
            let named: Vec<_> = literals.iter().map(|&literal| self.inputs[input].columns.literals[literal]).collect();
            (!is_left_out(input, &named)).then_some((input, literals))
        };
        let Some(pair) = self.beside(event, self.inputs.clone(), kept) else { return Verdict::Never };
        let states = self.states(&facts.faults);
        let differ =
            |witness: &Witness| matches!(pair.flags(&states, witness).as_deref(), Some([one, other]) if one != other);
        let mut known = facts.events[event].witnesses().map(|witness| self.complete_in(&states, witness));
        known.find(differ).map_or_else(|| pair.differing(&states), Verdict::Possible)
    }

    /// Whether the model's two events can differ.
    fn differing(&self, states: &[usize]) -> Verdict {
        let either = [[(0, true), (1, false)], [(0, false), (1, true)]];
        let verdicts = either.map(|statuses| joint::verdict_of(self, states, &statuses));
        let [one, other] = verdicts;
        if one.witness().is_some() || other == Verdict::Never { one } else { other }
    }
}

impl EventFacts {
    /// All readings that show that something can happen.
    fn witnesses(&self) -> impl Iterator<Item = &Witness> {
        let rules = self.contributor.iter().chain(&self.detractor);
        let of_rules = rules.flat_map(|rule| [&rule.fires, &rule.strongest, &rule.decisive]);
        [&self.set, &self.clear, &self.tie, &self.dead].into_iter().chain(of_rules).filter_map(Verdict::witness)
    }
}

fn mapped(event: &EventModel, map: impl Fn(Clause) -> Option<Clause>) -> Vec<Vec<Clause>> {
    let rules = event.clauses().into_iter();
    rules
        .map(|rule| rule.into_iter().filter_map(|(input, literals)| map((input, literals.to_vec()))).collect())
        .collect()
}
