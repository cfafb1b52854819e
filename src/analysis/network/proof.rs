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
        let (event, states) = (self.proving(event, question)?, self.states(faults));
        let levels = event.levels(&states);
        let mut problems = Vec::new();
        for condition in question.conditions(event) {
            for level in levels.iter().filter(|level| condition.levels.hold(level)) {
                let problem = Problem::new(event, &states, level);
                let assumptions = problem.assumptions(event, level, &condition);
                problems.push((problem, assumptions));
            }
        }
        let mut never = |inputs: &[usize], rules: &[usize]| {
            problems.iter_mut().all(|(problem, assumptions)| {
                let inputs = inputs.iter().map(|&position| problem.inputs_hold[position]);
                let kept = inputs.chain(rules.iter().map(|&rule| problem.rules_hold[rule]));
                let all: Vec<Proposition> = kept.chain(assumptions.iter().copied()).collect();
                !problem.solver.holds(&all)
            })
        };
        let mut inputs: Vec<usize> = (0..event.uses.len()).collect();
        let mut rules: Vec<usize> = (0..event.rules).collect();
        if !never(&inputs, &rules) {
            return None;
        }
        for rule in 0..event.rules {
            let fewer: Vec<_> = rules.iter().copied().filter(|&kept| kept != rule).collect();
            if never(&inputs, &fewer) {
                rules = fewer;
            }
        }
        for position in 0..event.uses.len() {
            let fewer: Vec<_> = inputs.iter().copied().filter(|&kept| kept != position).collect();
            if never(&fewer, &rules) {
                inputs = fewer;
            }
        }
        let inputs = inputs.into_iter().map(|position| event.uses[position].input).collect();
        let holds = |value: &&super::model::Level| {
            question.conditions(event).iter().any(|condition| condition.levels.hold(value))
        };
        let mut levels: Vec<_> = levels.iter().filter(holds).map(|level| level.value.clone()).collect();
        levels.sort_unstable();
        Some(Proof { inputs, rules, levels })
    }
}
