//! Which rules an event can do without, and why.

use super::engine::{Method, engine};
use super::faults::FaultSet;
use super::implication::at_most;
use super::model::{EventModel, Model};
use super::question::{Question, Rules};

impl Model {
    /// The groups of rules that can be left out of an event after some others are, one after another: what is asked of
    /// each of their rules is then never so. As many as can be, the first ones first; each group is of one side.
    pub fn needless_rules(
        &self,
        event: usize,
        faults: &FaultSet,
        question: fn(usize) -> Question,
        left_out: &[usize],
        groups: &[Vec<usize>],
    ) -> Vec<usize> {
        let (Some(event), states) = (self.events.get(event), self.states(faults)) else { return Vec::new() };
        let mut left_out = left_out.to_vec();
        let mut needless = Vec::new();
        for (position, group) in groups.iter().enumerate() {
            let before = left_out.len();
            // Its side only ever gets weaker, so what all of a group change, one of them changes after those before it.
            let is_needless = group.iter().all(|&rule| {
                let (smaller, kept) = event.without(&left_out);
                left_out.push(rule);
                kept.binary_search(&rule).is_ok_and(|rule| smaller.is_never(&states, question(rule)))
            });
            if is_needless {
                needless.push(position);
            } else {
                left_out.truncate(before);
            }
        }
        needless
    }

    /// Other rules that suffice to see that the answer about a rule is never, once some rules are left out.
    pub fn reasons(
        &self,
        event: usize,
        faults: &FaultSet,
        question: fn(usize) -> Question,
        rule: usize,
        left_out: &[usize],
    ) -> Vec<usize> {
        let reasons = || {
            let (smaller, kept) = self.events.get(event)?.without(left_out);
            let proof = smaller.proof(&self.states(faults), question(kept.binary_search(&rule).ok()?))?;
            Some(proof.rules.into_iter().map(|index| kept[index]).filter(|&other| other != rule).collect())
        };
        reasons().unwrap_or_default()
    }

    /// For each rule of an event, the others of its side that are nowhere weaker by their form: each of their cells is
    /// at least as wide. Quadratic in the number of rules.
    pub fn wider_rules(&self, event: usize) -> Vec<Vec<usize>> {
        let Some(event) = self.events.get(event) else { return Vec::new() };
        let clauses = event.clauses();
        let wider = |rule: usize| {
            let side = Rules::Beside(rule).of(event);
            side.filter(|&other| at_most(&clauses[rule], &clauses[other])).collect()
        };
        (0..event.rules).map(wider).collect()
    }
}

impl EventModel {
    /// The event without some rules, and the positions of those that are left.
    pub(super) fn without(&self, rules: &[usize]) -> (Self, Vec<usize>) {
        let kept: Vec<usize> = (0..self.rules).filter(|rule| !rules.contains(rule)).collect();
        let renumbered =
            |old: &[usize]| old.iter().filter_map(|rule| kept.binary_search(rule).ok()).collect::<Vec<_>>();
        let mut smaller = self.clone();
        for choice in smaller.uses.iter_mut().flat_map(|named| &mut named.choices) {
            choice.rules = renumbered(&choice.rules);
        }
        smaller.unconditional = renumbered(&self.unconditional);
        smaller.contributors = kept.partition_point(|&rule| rule < self.contributors);
        smaller.rules = kept.len();
        (smaller, kept)
    }

    fn is_never(&self, states: &[usize], question: Question) -> bool {
        let levels = self.levels(states);
        let mut engine = engine(Method::Fitting, self, states, &levels);
        question.conditions(self).iter().all(|condition| engine.find(condition).is_none())
    }
}
