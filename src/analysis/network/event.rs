//! All that is asked of one event.

use super::engine::{Method, engine};
use super::question::Question;
use super::witness::{Readings, Witness};

/// Whether something can happen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Verdict {
    /// It does at these readings.
    Possible(Witness),
    /// It does at no readings.
    Never,
}

impl Verdict {
    /// Whether it can happen.
    pub fn is_possible(&self) -> bool {
        matches!(self, Self::Possible(_))
    }

    /// The readings at which it does.
    pub fn witness(&self) -> Option<&Witness> {
        match self {
            Self::Possible(witness) => Some(witness),
            Self::Never => None,
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

impl EventFacts {
    pub(super) fn new(readings: &mut Readings<'_>, states: &[usize], method: Method) -> Self {
        let event = readings.event;
        let levels = event.levels(states);
        let mut engine = engine(method, event, states, &levels);
        let mut decide = |question: Question| {
            let found = question.conditions(event).iter().find_map(|condition| engine.find(condition));
            found.map_or(Verdict::Never, |found| {
                Verdict::Possible(readings.witness(states, &levels[found.level], &found.patterns))
            })
        };
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
