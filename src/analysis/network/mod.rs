//! Everything about a network's events under every set of failed sensors, decided exactly.
//!
//! A *level* is a degree between 0 and 1. At one level, all that matters of an input is how each of its terms compares
//! to it; these patterns are finitely many, and they change only at finitely many levels. Inputs are independent of
//! each other, so what the rules of one event can be at one level is the product of what each input can be.

mod columns;
mod engine;
mod event;
mod faults;
mod fold;
mod implication;
mod joined;
mod joint;
mod joint_bounds;
mod likeness;
mod linear;
mod margin;
mod model;
mod proof;
mod question;
mod redundancy;
mod region;
mod sat;
mod sensor;
mod slices;
mod solver;
mod strength;
mod survivors;
mod sweep;
mod witness;

pub use engine::Method;
pub use event::{EventFacts, RuleFacts, Verdict};
pub use faults::{Fault, FaultSet, fault_sets};
pub(super) use joined::{Fed, valuations};
pub use joint::Valuation;
pub use likeness::Relation;
pub use margin::Comparison;
pub use model::{Feed, Model};
pub use proof::Proof;
pub use question::Question;
pub use survivors::{SingleRule, Survivors};
pub(super) use sweep::{Sweep, readings};
pub use witness::{Reading, Witness};

use std::collections::HashMap;
use std::sync::Arc;

use self::witness::Readings;
use crate::base::Id;
use crate::ir::{self, Program};

/// What is known of a network under a set of failed sensors.
#[derive(Debug, Clone)]
pub struct NetworkFacts {
    /// The failures; none for the network as it is meant to be.
    pub faults: FaultSet,
    /// Of each event, in order. Fault sets share what no failure of theirs touches.
    pub events: Vec<Arc<EventFacts>>,
}

/// What is known of a network on its own under every set of at most `up_to` failed sensors, smallest sets first.
/// Nothing where one of its variables is broken, which is reported elsewhere.
pub fn analyze(program: &Program, network: Id<ir::Network>, up_to: usize) -> Vec<NetworkFacts> {
    Model::new(program, network).map_or_else(Vec::new, |model| model.facts(up_to))
}

impl Model {
    /// What is known under every set of at most `up_to` failures, smallest sets first.
    pub fn facts(&self, up_to: usize) -> Vec<NetworkFacts> {
        self.facts_by(Method::Fitting, up_to)
    }

    /// The same by a method of one's choice; every method gives the same verdicts.
    pub fn facts_by(&self, method: Method, up_to: usize) -> Vec<NetworkFacts> {
        let mut known: HashMap<(usize, Vec<usize>), Arc<EventFacts>> = HashMap::new();
        let mut readings: Vec<_> = (0..self.events.len()).map(|event| self.readings(event)).collect();
        let facts = self.fault_sets(up_to).into_iter().map(|faults| {
            let states = self.states(&faults);
            let events = self.events.iter().zip(&mut readings).enumerate().map(|(position, (event, readings))| {
                // What no rule of the event names does not touch it.
                let touching = event.uses.iter().map(|named| states[named.input]).collect();
                let facts = known.entry((position, touching));
                Arc::clone(facts.or_insert_with(|| Arc::new(readings.facts(&states, method))))
            });
            let events = events.collect();
            NetworkFacts { faults, events }
        });
        facts.collect()
    }

    /// What is known under one set of failures.
    pub fn facts_under(&self, faults: &FaultSet) -> NetworkFacts {
        let states = self.states(faults);
        let facts = |event| Arc::new(self.readings(event).facts(&states, Method::Fitting));
        NetworkFacts { faults: faults.clone(), events: (0..self.events.len()).map(facts).collect() }
    }

    fn readings(&self, event: usize) -> Bounded<'_> {
        let loose = self.loose.as_ref().map(|events| Readings::new(self, &events[event]));
        Bounded { sure: Readings::new(self, &self.events[event]), loose }
    }

    /// Which statuses the events can have together under the failures that some facts are about, sorted. An event with
    /// memory can also have a status from before.
    pub fn valuations(&self, facts: &NetworkFacts) -> Vec<Valuation> {
        joint::valuations(self, &self.states(&facts.faults), facts.events.iter().map(Arc::as_ref))
    }
}

/// An event, and the same with the other bounds of its smooth terms.
struct Bounded<'a> {
    sure: Readings<'a>,
    loose: Option<Readings<'a>>,
}

impl Bounded<'_> {
    fn facts(&mut self, states: &[usize], method: Method) -> EventFacts {
        let sure = EventFacts::new(&mut self.sure, states, method);
        match &mut self.loose {
            Some(loose) => EventFacts::between(sure, &EventFacts::new(loose, states, method)),
            None => sure,
        }
    }
}
