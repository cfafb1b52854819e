//! The engine for many inputs: one propositional problem for each level, kept between questions.

use std::cmp::Ordering;

use super::engine::{Engine, Found};
use super::model::{EventModel, Level};
use super::question::{Condition, Rules};
use super::solver::{Proposition, Solver};
use crate::base::Fraction;

/// An event's rules against every level.
pub(super) struct Sat<'a> {
    event: &'a EventModel,
    states: &'a [usize],
    levels: &'a [Level],
    problems: Vec<Option<Problem>>,
    /// What answered questions before; it may answer others.
    seen: Vec<(Found, Vec<Ordering>)>,
}

/// What can be at one level.
pub(super) struct Problem {
    pub(super) solver: Solver,
    /// By input in use: it has one of its patterns.
    pub(super) inputs_hold: Vec<Proposition>,
    /// By rule: its strength is the smallest of its clauses.
    pub(super) rules_hold: Vec<Proposition>,
    /// By input in use: which pattern it has.
    pub(super) patterns: Vec<Vec<Proposition>>,
    /// By rule: not below, and above.
    rules: Vec<Compared>,
    contributors: Compared,
    detractors: Compared,
}

/// How something compares to the level.
#[derive(Clone, Copy)]
struct Compared {
    reaches: Proposition,
    above: Proposition,
}

impl<'a> Sat<'a> {
    pub(super) fn new(event: &'a EventModel, states: &'a [usize], levels: &'a [Level]) -> Self {
        let problems = levels.iter().map(|_| None).collect();
        Self { event, states, levels, problems, seen: Vec::new() }
    }
}

impl Engine for Sat<'_> {
    fn find(&mut self, condition: &Condition) -> Option<Found> {
        let meets =
            |(found, signs): &&(Found, Vec<Ordering>)| condition.met(self.event, &self.levels[found.level], signs);
        if let Some((found, _)) = self.seen.iter().find(meets) {
            return Some(found.clone());
        }
        for (index, level) in self.levels.iter().enumerate() {
            if condition.levels.hold(level) {
                let problem = self.problems[index].get_or_insert_with(|| {
                    let mut problem = Problem::new(self.event, self.states, level);
                    problem.settle();
                    problem
                });
                let assumptions = problem.assumptions(self.event, level, condition);
                if problem.solver.holds(&assumptions) {
                    let found = Found { level: index, patterns: problem.chosen() };
                    self.seen.push((found.clone(), problem.signs()));
                    return Some(found);
                }
            }
        }
        None
    }
}

impl Problem {
    /// Nothing is known yet of inputs and rules; each can be assumed to hold.
    pub(super) fn new(event: &EventModel, states: &[usize], level: &Level) -> Self {
        let mut solver = Solver::default();
        let compared = |solver: &mut Solver| {
            let compared = Compared { reaches: solver.proposition(), above: solver.proposition() };
            solver.demand([!compared.above, compared.reaches]);
            compared
        };
        let rules: Vec<_> = (0..event.rules).map(|_| compared(&mut solver)).collect();
        let inputs_hold: Vec<_> = event.uses.iter().map(|_| solver.proposition()).collect();
        let rules_hold: Vec<_> = rules.iter().map(|_| solver.proposition()).collect();
        let mut clauses: Vec<Vec<Compared>> = vec![Vec::new(); event.rules];
        let mut patterns = Vec::with_capacity(event.uses.len());
        for (named, &holds) in event.uses.iter().zip(&inputs_hold) {
            let choices: Vec<_> = named.choices.iter().map(|_| compared(&mut solver)).collect();
            for (choice, &compared) in named.choices.iter().zip(&choices) {
                choice.rules.iter().for_each(|&rule| clauses[rule].push(compared));
            }
            let signs = named.patterns(states, level);
            let chosen: Vec<_> = signs.iter().map(|_| solver.proposition()).collect();
            solver.demand(chosen.iter().copied().chain([!holds]));
            for (&chosen, signs) in chosen.iter().zip(signs) {
                for (sign, choice) in signs.iter().zip(&choices) {
                    solver.demand([!chosen, if sign.is_ge() { choice.reaches } else { !choice.reaches }]);
                    solver.demand([!chosen, if sign.is_gt() { choice.above } else { !choice.above }]);
                }
            }
            patterns.push(chosen);
        }
        for ((rule, clauses), &holds) in rules.iter().zip(&clauses).zip(&rules_hold) {
            // Without clauses a rule's strength is 1, which is above every level but 1.
            let above_nothing = clauses.is_empty() && level.value == Fraction::ONE;
            both_ways(&mut solver, holds, rule.reaches, clauses.iter().map(|clause| clause.reaches));
            if above_nothing {
                solver.demand([!holds, !rule.above]);
            } else {
                both_ways(&mut solver, holds, rule.above, clauses.iter().map(|clause| clause.above));
            }
        }
        let mut side = |rules: &[Compared]| {
            let side = Compared { reaches: solver.proposition(), above: solver.proposition() };
            solver.demand(rules.iter().map(|rule| rule.reaches).chain([!side.reaches]));
            solver.demand(rules.iter().map(|rule| rule.above).chain([!side.above]));
            side
        };
        let (contributors, detractors) = rules.split_at(event.contributors);
        let (contributors, detractors) = (side(contributors), side(detractors));
        Self { solver, inputs_hold, rules_hold, patterns, rules, contributors, detractors }
    }

    /// All inputs and rules hold from now on.
    pub(super) fn settle(&mut self) {
        for &holds in self.inputs_hold.iter().chain(&self.rules_hold) {
            self.solver.demand([holds]);
        }
    }

    /// What a condition demands at the level.
    pub(super) fn assumptions(&self, event: &EventModel, level: &Level, condition: &Condition) -> Vec<Proposition> {
        let some = |rules: Rules| match rules {
            Rules::One(rule) => self.rules[rule],
            Rules::Contributors => self.contributors,
            _ => self.detractors,
        };
        let above = condition.some_above.map(|rules| some(rules).above);
        let reaching = condition.reached(level).iter().map(|&rules| some(rules).reaches);
        let below = condition.below.into_iter().flat_map(|rules| rules.of(event)).map(|rule| !self.rules[rule].reaches);
        let none = condition.none_above.into_iter().flat_map(|rules| rules.of(event));
        let none_above = none.map(|rule| !self.rules[rule].above);
        above.into_iter().chain(reaching).chain(below).chain(none_above).collect()
    }

    pub(super) fn chosen(&self) -> Vec<usize> {
        let chosen = |patterns: &Vec<Proposition>| patterns.iter().position(|&pattern| self.solver.value(pattern));
        self.patterns.iter().map(|patterns| chosen(patterns).unwrap_or(0)).collect()
    }

    fn signs(&self) -> Vec<Ordering> {
        let sign = |rule: &Compared| match (self.solver.value(rule.above), self.solver.value(rule.reaches)) {
            (true, _) => Ordering::Greater,
            (false, true) => Ordering::Equal,
            (false, false) => Ordering::Less,
        };
        self.rules.iter().map(sign).collect()
    }
}

/// Demands that, where something is assumed, `whole` holds exactly where all parts do.
fn both_ways(
    solver: &mut Solver,
    assumed: Proposition,
    whole: Proposition,
    parts: impl Iterator<Item = Proposition> + Clone,
) {
    for part in parts.clone() {
        solver.demand([!assumed, !whole, part]);
    }
    solver.demand(parts.map(|part| !part).chain([!assumed, whole]));
}
