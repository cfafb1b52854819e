//! All that is asked of one event.

use super::engine::{Engine, Method, engine};
use super::faults::FaultSet;
use super::model::{EventModel, Level, Model};
use super::question::Question;
use super::witness::{Readings, Witness};

/// Whether something can happen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// It does at these readings.
    Possible(Witness),
    /// It does at no readings.
    Never,
    /// Smooth membership functions are only known within bounds, which are too wide to say.
    Unknown,
}

impl Verdict {
    /// Whether it is not proved that it never happens.
    pub fn is_possible(&self) -> bool {
        *self != Self::Never
    }

    /// The readings at which it does.
    pub fn witness(&self) -> Option<&Witness> {
        match self {
            Self::Possible(witness) => Some(witness),
            Self::Never | Self::Unknown => None,
        }
    }
}

/// What is known of an event under a set of failed sensors. All of it is about the comparison of its rules; an event
/// with memory lags behind it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EventFacts {
    /// The contributor can outweigh the detractor.
    pub set: Verdict,
    /// The contributor can fail to outweigh the detractor.
    pub clear: Verdict,
    /// Both can be equally strong, above 0.
    pub tie: Verdict,
    /// Both can be 0.
    pub dead: Verdict,
    /// Of every contributor rule.
    pub contributor: Vec<RuleFacts>,
    /// Of every detractor rule.
    pub detractor: Vec<RuleFacts>,
}

impl Model {
    /// Whether it is not proved that an event is never set under some failures. Cheaper than all that is known of it.
    pub fn can_set(&self, event: usize, faults: &FaultSet) -> bool {
        self.can(self.loose.as_ref().unwrap_or(&self.events).get(event), faults, Question::Set)
    }

    /// Whether it is not proved that an event is never clear under some failures.
    pub fn can_clear(&self, event: usize, faults: &FaultSet) -> bool {
        self.can(self.events.get(event), faults, Question::Clear)
    }

    fn can(&self, event: Option<&EventModel>, faults: &FaultSet, question: Question) -> bool {
        let Some(event) = event else { return false };
        let states = self.states(faults);
        let levels = event.levels(&states);
        let mut engine = engine(Method::Fitting, event, &states, &levels);
        question.conditions(event).iter().any(|condition| engine.find(condition).is_some())
    }
}

/// What is known of a rule.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RuleFacts {
    /// Its strength can be above 0; else it is masked.
    pub fires: Verdict,
    /// It can be stronger than every other rule of its side.
    pub strongest: Verdict,
    /// The flag can depend on it: without it, it would be another.
    pub decisive: Verdict,
}

impl Verdict {
    /// What is known for sure: `possible` is right where it finds readings, `never` where it finds none.
    fn between(possible: Self, never: &Self) -> Self {
        match (possible, never) {
            (possible @ Self::Possible(_), _) => possible,
            (_, Self::Never) => Self::Never,
            _ => Self::Unknown,
        }
    }
}

impl Readings<'_> {
    fn decide(&mut self, engine: &mut dyn Engine, states: &[usize], levels: &[Level], question: Question) -> Verdict {
        let found = question.conditions(self.event).iter().find_map(|condition| engine.find(condition));
        found.map_or(Verdict::Never, |found| {
            Verdict::Possible(self.witness(states, &levels[found.level], &found.patterns))
        })
    }

    /// The answer to one question.
    fn answer(&mut self, states: &[usize], question: Question) -> Verdict {
        let levels = self.event.levels(states);
        let mut engine = engine(Method::Fitting, self.event, states, &levels);
        self.decide(engine.as_mut(), states, &levels, question)
    }
}

impl Model {
    /// Whether the flag of an event can be clear under some failures. Without a detractor that is where no rule fires.
    pub fn clear(&self, event: usize, faults: &FaultSet) -> Verdict {
        let states = self.states(faults);
        let sure = Readings::new(self, &self.events[event]).answer(&states, Question::Clear);
        match &self.loose {
            Some(loose) => {
                let possible = Readings::new(self, &loose[event]).answer(&states, Question::Clear);
                Verdict::between(possible, &sure)
            }
            None => sure,
        }
    }
}

impl EventFacts {
    /// What is known for sure, from what holds with every contributor rule as weak and every detractor rule as strong as
    /// can be, and what holds the other way round.
    pub(super) fn between(sure: Self, loose: &Self) -> Self {
        let rules = |sure: Vec<RuleFacts>, loose: &[RuleFacts], speaks_for: bool| -> Vec<RuleFacts> {
            let rule = |(sure, loose): (RuleFacts, &RuleFacts)| RuleFacts {
                fires: if speaks_for {
                    Verdict::between(sure.fires, &loose.fires)
                } else {
                    Verdict::between(loose.fires.clone(), &sure.fires)
                },
                strongest: Verdict::Unknown,
                decisive: Verdict::Unknown,
            };
            sure.into_iter().zip(loose).map(rule).collect()
        };
        Self {
            set: Verdict::between(sure.set, &loose.set),
            clear: Verdict::between(loose.clear.clone(), &sure.clear),
            tie: Verdict::Unknown,
            dead: Verdict::Unknown,
            contributor: rules(sure.contributor, &loose.contributor, true),
            detractor: rules(sure.detractor, &loose.detractor, false),
        }
    }

    pub(super) fn new(readings: &mut Readings<'_>, states: &[usize], method: Method) -> Self {
        let event = readings.event;
        let levels = event.levels(states);
        let mut engine = engine(method, event, states, &levels);
        let mut decide = |question: Question| readings.decide(engine.as_mut(), states, &levels, question);
        let [set, clear, tie, dead] = [Question::Set, Question::Clear, Question::Tie, Question::Dead].map(&mut decide);
        let mut facts = (0..event.rules).map(|rule| RuleFacts {
            fires: decide(Question::Fires(rule)),
            strongest: decide(Question::Strongest(rule)),
            decisive: decide(Question::Decisive(rule)),
        });
        let contributor = facts.by_ref().take(event.contributors).collect();
        let detractor = facts.collect();
        Self { set, clear, tie, dead, contributor, detractor }
    }
}
