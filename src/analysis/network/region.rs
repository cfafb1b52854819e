//! What holds around some readings, and not only at them.

use super::faults::FaultSet;
use super::model::{EventModel, Level, Model};
use super::question::Question;
use super::sat::Problem;
use super::solver::Proposition;
use super::witness::{Readings, Witness};

impl Model {
    /// Readings around which both sides of an event without some of its rules are equally strong, above 0, however each
    /// changes a little; `None` where the sides only cross. They are as strong as they can be there.
    ///
    /// They are equal there because one number limits both. Either it is constant, then all inputs are in stretches of
    /// readings at that level; or it is a degree of one input, which then passes every level of a gap, while the other
    /// inputs are in stretches.
    pub fn tie_region(&self, event: usize, faults: &FaultSet, left_out: &[usize]) -> Option<Witness> {
        let (event, _) = self.events.get(event)?.without(left_out);
        self.region(&event, faults, Question::Tie)
    }

    /// Readings around which no rule of an event fires, however each changes a little.
    pub fn dead_region(&self, event: usize, faults: &FaultSet) -> Option<Witness> {
        self.region(self.events.get(event)?, faults, Question::Dead)
    }

    fn region(&self, event: &EventModel, faults: &FaultSet, question: Question) -> Option<Witness> {
        let states = self.states(faults);
        let mut levels = event.levels(&states);
        levels.sort_unstable_by(|one, other| other.value.cmp(&one.value));
        for condition in question.conditions(event) {
            for level in levels.iter().filter(|level| condition.levels.hold(level)) {
                let mut problem = Problem::new(event, &states, level);
                problem.settle();
                keep_to_regions(&mut problem, event, &states, level);
                let assumptions = problem.assumptions(event, level, &condition);
                if problem.solver.holds(&assumptions) {
                    return Some(Readings::new(self, event).witness(&states, level, &problem.chosen()));
                }
            }
        }
        None
    }
}

/// Demands that every input has a pattern that it keeps in some stretch of readings; in a gap, one input may also have
/// one that moves with the level.
fn keep_to_regions(problem: &mut Problem, event: &EventModel, states: &[usize], level: &Level) {
    let mut moving: Vec<Proposition> = Vec::new();
    for (position, named) in event.uses.iter().enumerate() {
        let wide = named.slices[states[named.input]].wide_at(&level.height, level.is_gap);
        let moves = problem.solver.proposition();
        for ((pattern, &wide), &chosen) in
            named.patterns(states, level).iter().zip(wide).zip(&problem.patterns[position])
        {
            // Inside a gap, only a degree that passes the level is equal to it.
            let passes = level.is_gap && pattern.iter().any(|sign| sign.is_eq());
            match (wide, passes) {
                (true, _) => {}
                (false, true) => problem.solver.demand([!chosen, moves]),
                (false, false) => problem.solver.demand([!chosen]),
            }
        }
        for &other in &moving {
            problem.solver.demand([!moves, !other]);
        }
        moving.push(moves);
    }
}
