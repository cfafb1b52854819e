//! The engine for few inputs: every reachable comparison of all rules with a level, folded input by input.

use super::engine::{Engine, Found};
use super::model::{EventModel, Level};
use super::question::{Condition, Rules};
use super::slices::Pattern;
use crate::base::Fraction;

/// The most inputs this engine takes.
pub(super) const MOST_INPUTS: usize = 6;

/// A set of rules in `N` words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Mask<const N: usize>([u64; N]);

impl<const N: usize> Mask<N> {
    const EMPTY: Self = Self([0; N]);

    fn of(rules: impl IntoIterator<Item = usize>) -> Self {
        let mut mask = Self::EMPTY;
        for rule in rules {
            mask.0[rule / 64] |= 1 << (rule % 64);
        }
        mask
    }

    fn with(mut self, other: Self) -> Self {
        for (word, more) in self.0.iter_mut().zip(other.0) {
            *word |= more;
        }
        self
    }

    /// Whether all of these rules are in `other`.
    fn within(self, other: Self) -> bool {
        self.0.iter().zip(other.0).all(|(word, other)| word & !other == 0)
    }
}

/// How all rules compare to a level, and by which pattern of each input.
#[derive(Debug, Clone, Copy)]
struct Reached<const N: usize> {
    below: Mask<N>,
    not_above: Mask<N>,
    patterns: [u32; MOST_INPUTS],
}

/// An event's rules against every level.
pub(super) struct Fold<'a, const N: usize> {
    event: &'a EventModel,
    states: &'a [usize],
    levels: &'a [Level],
    /// The rules that name each choice of each input in use.
    choices: Vec<Vec<Mask<N>>>,
    unconditional: Mask<N>,
    reached: Vec<Option<Vec<Reached<N>>>>,
}

impl<'a, const N: usize> Fold<'a, N> {
    pub(super) fn new(event: &'a EventModel, states: &'a [usize], levels: &'a [Level]) -> Self {
        let choices = event
            .uses
            .iter()
            .map(|named| named.choices.iter().map(|choice| Mask::of(choice.rules.iter().copied())).collect());
        Self {
            event,
            states,
            levels,
            choices: choices.collect(),
            unconditional: Mask::of(event.unconditional.iter().copied()),
            reached: vec![None; levels.len()],
        }
    }

    fn fold(&self, level: &Level) -> Vec<Reached<N>> {
        let not_above = if level.value == Fraction::ONE { self.unconditional } else { Mask::EMPTY };
        let mut reached = vec![Reached { below: Mask::EMPTY, not_above, patterns: [0; MOST_INPUTS] }];
        for (position, (named, choices)) in self.event.uses.iter().zip(&self.choices).enumerate() {
            let patterns = named.patterns(self.states, level);
            let masks: Vec<_> = patterns.iter().map(|pattern| masks(pattern, choices)).collect();
            let mut next = Vec::with_capacity(reached.len() * masks.len());
            for so_far in &reached {
                for (index, &(below, not_above)) in (0..).zip(&masks) {
                    let mut patterns = so_far.patterns;
                    patterns[position] = index;
                    let (below, not_above) = (so_far.below.with(below), so_far.not_above.with(not_above));
                    next.push(Reached { below, not_above, patterns });
                }
            }
            next.sort_unstable_by_key(|reached| (reached.below, reached.not_above));
            next.dedup_by_key(|reached| (reached.below, reached.not_above));
            reached = next;
        }
        reached
    }
}

impl<const N: usize> Engine for Fold<'_, N> {
    fn find(&mut self, condition: &Condition) -> Option<Found> {
        let event = self.event;
        let mask = |rules: Rules| Mask::<N>::of(rules.of(event));
        let mask_or_empty = |rules: Option<Rules>| rules.map_or(Mask::EMPTY, mask);
        let (below, none_above) = (mask_or_empty(condition.below), mask_or_empty(condition.none_above));
        let some_above = condition.some_above.map(mask);
        let some_reach: Vec<_> = condition.some_reach.iter().map(|&rules| mask(rules)).collect();
        for (index, level) in self.levels.iter().enumerate().filter(|(_, level)| condition.levels.hold(level)) {
            if self.reached[index].is_none() {
                self.reached[index] = Some(self.fold(level));
            }
            let some_reach = &some_reach[..condition.reached(level).len()];
            let found = self.reached[index].iter().flatten().find(|reached| {
                below.within(reached.below)
                    && none_above.within(reached.not_above)
                    && some_above.is_none_or(|rules| !rules.within(reached.not_above))
                    && some_reach.iter().all(|rules| !rules.within(reached.below))
            });
            if let Some(found) = found {
                let patterns = found.patterns[..event.uses.len()].iter().map(|&pattern| pattern as usize).collect();
                return Some(Found { level: index, patterns });
            }
        }
        None
    }
}

/// The rules that a pattern keeps below its level, and those that it keeps from being above.
fn masks<const N: usize>(pattern: &Pattern, choices: &[Mask<N>]) -> (Mask<N>, Mask<N>) {
    let mut masks = (Mask::EMPTY, Mask::EMPTY);
    for (sign, &rules) in pattern.iter().zip(choices) {
        if sign.is_lt() {
            masks.0 = masks.0.with(rules);
        }
        if sign.is_le() {
            masks.1 = masks.1.with(rules);
        }
    }
    masks
}
