//! The two engines that decide conditions at levels, and the choice between them.

use super::fold::{Fold, MOST_INPUTS};
use super::model::{EventModel, Level};
use super::question::Condition;
use super::sat::Sat;

/// How conditions are decided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Folding where few inputs make few combinations, solving elsewhere.
    Fitting,
    /// Propositional solving, level by level.
    Solving,
}

/// Where a condition holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Found {
    /// The index of the level.
    pub(super) level: usize,
    /// The pattern of each input in use.
    pub(super) patterns: Vec<usize>,
}

/// Decides conditions on the rules of an event.
pub(super) trait Engine {
    /// The first level at which a condition holds, and how; `None` where it holds at none.
    fn find(&mut self, condition: &Condition) -> Option<Found>;
}

/// The most combinations of patterns at one level that are folded.
const MOST_FOLDED: usize = 1 << 16;

/// The engine for an event in some states of its inputs.
pub(super) fn engine<'a>(
    method: Method,
    event: &'a EventModel,
    states: &'a [usize],
    levels: &'a [Level],
) -> Box<dyn Engine + 'a> {
    let folds = method == Method::Fitting
        && event.uses.len() <= MOST_INPUTS
        && levels.iter().all(|level| combinations(event, states, level) <= MOST_FOLDED);
    match event.rules {
        0..=64 if folds => Box::new(Fold::<1>::new(event, states, levels)),
        0..=512 if folds => Box::new(Fold::<8>::new(event, states, levels)),
        _ => Box::new(Sat::new(event, states, levels)),
    }
}

fn combinations(event: &EventModel, states: &[usize], level: &Level) -> usize {
    let patterns = event.uses.iter().map(|named| named.patterns(states, level).len());
    patterns.fold(1, usize::saturating_mul)
}
