//! The patterns of an input at every level: how its cells in rules compare to the level.
//!
//! Which patterns there are changes only at heights: 0, 1, degrees at the ends of cells, and degrees at which two
//! literals cross. Between neighbouring heights, in a gap, one level stands for all.

use std::cmp::Ordering;

use super::sensor::Sensor;
use crate::base::Fraction;

/// How each choice of literals compares to a level.
pub(super) type Pattern = Vec<Ordering>;

/// What an event sees of one input in one state.
#[derive(Debug, Clone)]
pub(super) struct Slices {
    /// In ascending order, from 0 to 1.
    pub(super) heights: Vec<Fraction>,
    /// The patterns at each height and, in between, in each gap.
    pub(super) patterns: Vec<Vec<Pattern>>,
}

impl Slices {
    /// The slices of a sensor for choices of its literals, each standing for the largest degree among them.
    pub(super) fn new(sensor: &Sensor, choices: &[&[usize]]) -> Self {
        let mut literals: Vec<usize> = choices.concat();
        literals.sort_unstable();
        literals.dedup();
        let heights = heights(sensor, &literals);
        let gaps = heights.windows(2).map(|pair| pair[0].halfway(&pair[1]));
        let mut levels = Vec::with_capacity(2 * heights.len());
        for (height, gap) in heights.iter().zip(gaps.map(Some).chain([None])) {
            levels.push(height.clone());
            levels.extend(gap);
        }
        let patterns = levels.iter().map(|level| patterns(sensor, choices, level)).collect();
        Self { heights, patterns }
    }

    /// The patterns at a level that is one of the heights, or just above it.
    pub(super) fn at(&self, height: &Fraction, is_gap: bool) -> &[Pattern] {
        let position = match self.heights.binary_search(height) {
            Ok(position) => 2 * position + usize::from(is_gap),
            Err(after) => (2 * after).saturating_sub(1),
        };
        self.patterns.get(position).map_or(&[], Vec::as_slice)
    }
}

fn heights(sensor: &Sensor, literals: &[usize]) -> Vec<Fraction> {
    let mut heights = vec![Fraction::ZERO, Fraction::ONE];
    for cell in &sensor.cells {
        for (position, &literal) in literals.iter().enumerate() {
            let one = &cell.degrees[literal];
            heights.extend([one.0.clone(), one.1.clone()]);
            if !cell.is_point() {
                heights.extend(literals[..position].iter().filter_map(|&other| crossing(one, &cell.degrees[other])));
            }
        }
    }
    heights.sort_unstable();
    heights.dedup();
    heights
}

/// The degree at which two lines over the same cell cross inside it.
fn crossing(one: &(Fraction, Fraction), other: &(Fraction, Fraction)) -> Option<Fraction> {
    let (before, after) = (one.0.cmp(&other.0), one.1.cmp(&other.1));
    if before == after || before.is_eq() || after.is_eq() {
        return None;
    }
    let (at_start, at_end) = (&other.0 - &one.0, &one.1 - &other.1);
    let share = at_start.over(&(&at_start + &at_end))?;
    Some(&one.0 + &(&(&one.1 - &one.0) * &share))
}

fn patterns(sensor: &Sensor, choices: &[&[usize]], level: &Fraction) -> Vec<Pattern> {
    let mut found: Vec<Pattern> = Vec::new();
    for_each_piece(sensor, choices, level, |pattern, _, _| {
        if !found.contains(&pattern) {
            found.push(pattern);
        }
    });
    found
}

/// The reading with a pattern at a level, as far from readings with another one as it can be; `None` where the sensor
/// gives none. Answers nothing useful for a pattern that does not occur at the level.
pub(super) fn reading(sensor: &Sensor, choices: &[&[usize]], level: &Fraction, wanted: &Pattern) -> Option<Fraction> {
    let mut best: Option<(Fraction, Fraction)> = None;
    for_each_piece(sensor, choices, level, |pattern, from, to| {
        if let (Some(from), Some(to)) = (from, to)
            && pattern == *wanted
            && best.as_ref().is_none_or(|best| &to - &from > &best.1 - &best.0)
        {
            best = Some((from, to));
        }
    });
    best.map(|(from, to)| from.halfway(&to))
}

fn for_each_piece(
    sensor: &Sensor,
    choices: &[&[usize]],
    level: &Fraction,
    mut visit: impl FnMut(Pattern, Option<Fraction>, Option<Fraction>),
) {
    let literals = choices.concat();
    let nothing = Fraction::ZERO.cmp(level);
    for cell in &sensor.cells {
        for piece in cell.pieces(&literals, level) {
            let mut signs = piece.signs.iter().copied();
            let largest = |choice: &&[usize]| signs.by_ref().take(choice.len()).fold(nothing, Ordering::max);
            let pattern = choices.iter().map(largest).collect();
            visit(pattern, cell.reading(&piece.share.0), cell.reading(&piece.share.1));
        }
    }
}
