//! The rules that failures leave, written out in single terms as the paper does (LMSL eqs. 10 to 12).

use super::faults::FaultSet;
use super::model::{Clause, EventModel, Model};
use super::slices::Slices;
use crate::base::Fraction;
use crate::ir::Literal;

/// A rule of single terms: for each input that it names, the term, by input.
pub type SingleRule = Vec<(usize, Literal)>;

/// The single-term rules of an event that can be above 0, sorted and each once.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Survivors {
    /// Those that speak for it.
    pub contributor: Vec<SingleRule>,
    /// Those that speak against it.
    pub detractor: Vec<SingleRule>,
}

/// The most single-term rules that one written rule is expanded to.
const MOST_EXPANDED: usize = 1 << 12;

impl Model {
    /// What failures leave of an event's rules; `None` where its rules stand for too many.
    pub fn survivors(&self, event: usize, faults: &FaultSet) -> Option<Survivors> {
        let states = self.states(faults);
        self.single_rules(event, |rule| self.can_fire(rule, &states))
    }

    /// All of an event's rules written out in single terms; `None` where they stand for too many.
    pub fn written_out(&self, event: usize) -> Option<Survivors> {
        self.single_rules(event, |_| true)
    }

    fn single_rules(&self, position: usize, keep: impl Fn(&[Clause]) -> bool) -> Option<Survivors> {
        let event = self.events.get(position)?;
        let single = |rule: &Vec<(usize, &[usize])>| -> Option<Vec<SingleRule>> {
            let kept = expanded(rule)?.into_iter().filter(|rule| keep(rule));
            let literal = |(input, literals): &Clause| {
                literals
                    .iter()
                    .map(|&literal| (*input, self.inputs[*input].columns.literals[literal]))
                    .collect::<Vec<_>>()
            };
            Some(kept.map(|rule| rule.iter().flat_map(literal).collect()).collect())
        };
        let side = |rules: &[Vec<(usize, &[usize])>]| -> Option<Vec<SingleRule>> {
            let mut all = rules.iter().map(single).collect::<Option<Vec<_>>>()?.concat();
            all.sort_unstable();
            all.dedup();
            Some(all)
        };
        // A rule that may fire survives: its terms count as high as they can be.
        let (loose, clauses) = (self.loose(position).clauses(), event.clauses());
        let (contributors, detractors) = (&loose[..event.contributors], &clauses[event.contributors..]);
        Some(Survivors { contributor: side(contributors)?, detractor: side(detractors)? })
    }

    /// The same network with every rule written out in single terms, in the order of the rules; `None` where one stands
    /// for too many.
    pub fn expanded(&self) -> Option<Self> {
        let event = |event: &EventModel| {
            let rules = event.clauses().iter().map(expanded).collect::<Option<Vec<_>>>()?;
            let contributors = rules.iter().take(event.contributors).map(Vec::len).sum();
            Some(EventModel::of_clauses(rules.concat(), contributors, &self.inputs))
        };
        let all = |events: &Vec<EventModel>| events.iter().map(event).collect::<Option<Vec<_>>>();
        let loose = match &self.loose {
            Some(loose) => Some(all(loose)?),
            None => None,
        };
        Some(Self::of_events(self.inputs.clone(), all(&self.events)?, loose))
    }

    /// Whether all clauses of a rule can be above 0 together. Inputs are independent of each other.
    fn can_fire(&self, rule: &[Clause], states: &[usize]) -> bool {
        let clauses: Vec<_> = rule.iter().map(|(input, literals)| (*input, literals.as_slice())).collect();
        self.silent(&clauses, states).is_none()
    }

    /// The input that keeps a rule of an event from ever firing while all is well: what the rule names of it is never
    /// above 0 together.
    pub fn silent_input(&self, event: usize, rule: usize) -> Option<usize> {
        let clauses = self.events.get(event)?.clauses();
        self.silent(clauses.get(rule)?, &vec![0; self.inputs.len()])
    }

    fn silent(&self, rule: &[(usize, &[usize])], states: &[usize]) -> Option<usize> {
        let is_silent = |&input: &usize| {
            let of_input = rule.iter().filter(|clause| clause.0 == input);
            let choices: Vec<_> = of_input.map(|(_, literals)| *literals).collect();
            let slices = Slices::new(&self.inputs[input].sensors[states[input]], &choices);
            !slices.at(&Fraction::ZERO, false).iter().any(|pattern| pattern.iter().all(|sign| sign.is_gt()))
        };
        rule.iter().map(|(input, _)| *input).find(is_silent)
    }
}

/// The single-term rules that one rule is the largest of.
fn expanded(rule: &Vec<(usize, &[usize])>) -> Option<Vec<Vec<Clause>>> {
    let count = rule.iter().map(|(_, literals)| literals.len()).fold(1, usize::saturating_mul);
    if count > MOST_EXPANDED {
        return None;
    }
    let mut expanded: Vec<Vec<Clause>> = vec![Vec::new()];
    for (input, literals) in rule {
        let longer = |short: &Vec<Clause>| -> Vec<Vec<Clause>> {
            literals.iter().map(|&literal| [short.as_slice(), &[(*input, vec![literal])]].concat()).collect()
        };
        expanded = expanded.iter().flat_map(longer).collect();
    }
    Some(expanded)
}
