//! Why something never happens: the inputs and rules that suffice to see it.

use super::faults::FaultSet;
use super::model::{EventModel, Model};
use super::question::Question;
use super::sat::Problem;
use super::solver::Proposition;
use crate::base::Fraction;

/// What proves that the answer to a question about an event is never. Without any one of the inputs and rules the proof
/// fails; any other input may read anything at all, also under more failures, and any other rule may have any strength.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Proof {
    /// Positions of inputs in the network, ascending.
    pub inputs: Vec<usize>,
    /// Rules of the event, contributors first, ascending.
    pub rules: Vec<usize>,
    /// The degrees at which it was looked, ascending; each stands for itself, or for all up to the nearest ones at which
    /// some term's comparison changes.
    pub levels: Vec<Fraction>,
}

impl Model {
    /// The event in which a question's never is one for sure; `None` where smooth terms leave no such thing.
    fn proving(&self, event: usize, question: Question) -> Option<&EventModel> {
        let sure = self.events.get(event)?;
        match question {
            _ if self.loose.is_none() => Some(sure),
            Question::Set => Some(self.loose(event)),
            Question::Fires(rule) if rule < sure.contributors => Some(self.loose(event)),
            Question::Clear | Question::Fires(_) => Some(sure),
            Question::Tie | Question::Dead | Question::Strongest(_) | Question::Decisive(_) => None,
        }
    }

    /// The proof that something never happens under some failures, or `None` if it does.
    pub fn proof(&self, event: usize, faults: &FaultSet, question: Question) -> Option<Proof> {
        self.proving(event, question)?.proof(&self.states(faults), question)
    }
}

impl EventModel {
    /// The proof that something never happens in some states of the inputs, or `None` if it does.
    pub(super) fn proof(&self, states: &[usize], question: Question) -> Option<Proof> {
        let levels = self.levels(states);
        let mut obstacles = Vec::new();
        for condition in question.conditions(self) {
            for level in levels.iter().filter(|level| condition.levels.hold(level)) {
                let problem = Problem::new(self, states, level);
                let demanded = problem.assumptions(self, level, &condition);
                obstacles.push(Obstacle { problem, demanded, because: Vec::new() });
            }
        }
        let all: Vec<usize> = (0..self.uses.len() + self.rules).collect();
        if !obstacles.iter_mut().all(|obstacle| obstacle.holds_by(&all)) {
            return None;
        }
        let mut kept: Vec<usize> = all;
        kept.retain(|premise| obstacles.iter().any(|obstacle| obstacle.because.contains(premise)));
        // Rules go first: an input without rules is no reason at all.
        let (inputs, rules): (Vec<usize>, Vec<usize>) = kept.iter().partition(|premise| **premise < self.uses.len());
        for candidate in rules.into_iter().chain(inputs) {
            let fewer: Vec<_> = kept.iter().copied().filter(|&premise| premise != candidate).collect();
            let mut concerned = obstacles.iter_mut().filter(|obstacle| obstacle.because.contains(&candidate));
            if concerned.all(|obstacle| obstacle.holds_by(&fewer)) {
                kept = fewer;
            }
        }
        let (inputs, rules): (Vec<usize>, Vec<usize>) = kept.iter().partition(|premise| **premise < self.uses.len());
        let inputs = inputs.into_iter().map(|position| self.uses[position].input).collect();
        let rules = rules.into_iter().map(|premise| premise - self.uses.len()).collect();
        let is_asked = |level: &&super::model::Level| {
            question.conditions(self).iter().any(|condition| condition.levels.hold(level))
        };
        let mut levels: Vec<_> = levels.iter().filter(is_asked).map(|level| level.value.clone()).collect();
        levels.sort_unstable();
        Some(Proof { inputs, rules, levels })
    }
}

/// One way in which something might happen, and does not.
struct Obstacle {
    problem: Problem,
    demanded: Vec<Proposition>,
    /// What was needed to see that it does not: positions of inputs in use, then rules, counted on.
    because: Vec<usize>,
}

impl Obstacle {
    /// Whether these premises suffice to see that it does not happen.
    fn holds_by(&mut self, premises: &[usize]) -> bool {
        let Problem { solver, inputs_hold, rules_hold, .. } = &mut self.problem;
        let holds = |premise: usize| {
            inputs_hold.get(premise).copied().unwrap_or_else(|| rules_hold[premise - inputs_hold.len()])
        };
        let assumed: Vec<_> = premises.iter().map(|&premise| holds(premise)).chain(self.demanded.clone()).collect();
        if solver.holds(&assumed) {
            return false;
        }
        self.because = premises.iter().copied().filter(|&premise| solver.blames(holds(premise))).collect();
        true
    }
}
