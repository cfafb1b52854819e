//! What is left of an event, in words.

use std::collections::BTreeSet;

use super::summary::{Told, add_smallest};
use super::{Group, Sensed};
use crate::analysis::failures::{list, named_inputs};
use crate::analysis::network::{NetworkFacts, Relation};
use crate::ir::{Event, FailReading};

/// An event that can be set and can be clear while nothing has failed.
pub(super) struct Subject<'s> {
    group: &'s Group,
    sensed: &'s Sensed<'s>,
    index: usize,
    event: &'s Event,
    /// Whether its network has to be named.
    qualified: bool,
    healthy: &'s NetworkFacts,
    /// The inputs that it does not depend on although its rules name them.
    needless: Vec<usize>,
}

/// What is left of an event.
#[derive(PartialEq)]
enum Left {
    Never,
    Always,
    /// What can decide for it comes from these inputs alone.
    Alone(BTreeSet<usize>),
}

impl<'s> Subject<'s> {
    pub(super) fn new(group: &'s Group, sensed: &'s Sensed<'s>, index: usize, qualified: bool) -> Option<Self> {
        let healthy = sensed.facts.first()?;
        let facts = healthy.events.get(index)?;
        let varies = facts.set.is_possible() && facts.clear.is_possible();
        let event = &sensed.network.events[index];
        let needless = || sensed.model.needless_inputs(index, healthy);
        varies.then(|| Self { group, sensed, index, event, qualified, healthy, needless: needless() })
    }

    /// What it depends on, and what it says of other events, while nothing has failed.
    pub(super) fn always(&self, relations: &[Relation]) -> Option<String> {
        let mut says = Vec::new();
        let needed = named_inputs(self.event).into_iter().filter(|input| !self.needless.contains(input)).collect();
        if !self.needless.is_empty() {
            says.push(format!("depends on {} alone", self.sensors(&needed)));
        }
        let (mut implied, mut excluded) = (Vec::new(), Vec::new());
        for &relation in relations {
            match relation {
                Relation::Implies(one, other) if one == self.index => implied.push(self.name_of(other)),
                Relation::Excludes(one, other) if one == self.index => excluded.push(self.name_of(other)),
                Relation::Implies(..) | Relation::Excludes(..) => {}
            }
        }
        if !implied.is_empty() {
            says.push(format!("implies {}", list(implied.iter().map(String::as_str), "and")));
        }
        if !excluded.is_empty() {
            says.push(format!("is never set together with {}", list(excluded.iter().map(String::as_str), "or")));
        }
        (!says.is_empty()).then(|| format!("`{}` {}.", self.name_of(self.index), says.join(" and ")))
    }

    /// What failures do to it, each with the smallest sets of failed sensors that do it.
    pub(super) fn under_failures(&self, told: &mut Told<'s>) {
        let mut known = Vec::new();
        for facts in self.sensed.facts.iter().skip(1) {
            // Stuck anywhere an input can be what it could be.
            if facts.faults.iter().all(|fault| fault.reading != FailReading::Any)
                && let Some(left) = self.left(facts)
            {
                add_smallest(&mut known, left, &facts.faults);
            }
        }
        for (left, sets) in known {
            let name = self.name_of(self.index);
            let what = match left {
                Left::Never => format!("`{name}` can never be set"),
                Left::Always => format!("`{name}` is always set"),
                Left::Alone(inputs) => format!("`{name}` is found by {} alone", self.sensors(&inputs)),
            };
            let failed = |fault: &_| self.group.failed(self.sensed, fault);
            told.tell(sets.iter().map(|set| set.iter().map(failed).collect()).collect(), what);
        }
    }

    /// What is left of it under some failures, where that is worth saying.
    fn left(&self, facts: &NetworkFacts) -> Option<Left> {
        let event = &facts.events[self.index];
        if !event.set.is_possible() {
            return Some(Left::Never);
        }
        if !event.clear.is_possible() {
            return Some(Left::Always);
        }
        let (before, now) = (self.deciding(self.healthy), self.deciding(facts));
        let kinds = |inputs: &BTreeSet<usize>| {
            inputs.iter().map(|input| self.sensed.network.inputs[*input].variable).collect::<BTreeSet<_>>().len()
        };
        // That some of several sensors are left goes without saying, but not that one is, or only one kind.
        let is_alone = now != before && kinds(&now) == 1 && (now.len() == 1 || kinds(&before) > 1);
        is_alone.then_some(Left::Alone(now))
    }

    /// The inputs of the rules for it that can decide.
    fn deciding(&self, facts: &NetworkFacts) -> BTreeSet<usize> {
        let rules = self.event.contributor.iter().zip(&facts.events[self.index].contributor);
        let deciding = rules.filter(|(_, rule)| rule.fires.is_possible() && rule.decisive.is_possible());
        let inputs = deciding.flat_map(|(rule, _)| &rule.clauses).map(|clause| clause.input as usize);
        let has_failed = |input: &usize| facts.faults.iter().any(|fault| fault.input == *input);
        // What does not matter at any reading may matter beside a sensor without one.
        let some_absent = facts.faults.iter().any(|fault| fault.reading == FailReading::Absent);
        inputs.filter(|input| !has_failed(input) && (some_absent || !self.needless.contains(input))).collect()
    }

    fn sensors(&self, inputs: &BTreeSet<usize>) -> String {
        list(inputs.iter().map(|input| self.group.sensors[self.sensed.inputs[*input]].name.as_str()), "and")
    }

    fn name_of(&self, event: usize) -> String {
        let name = &self.sensed.network.events[event].symbol.name;
        if self.qualified { format!("{}.{name}", self.sensed.name) } else { name.clone() }
    }
}
