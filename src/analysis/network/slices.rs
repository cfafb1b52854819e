//! The patterns of an input at every level: how its cells in rules compare to the level.
//!
//! Which patterns there are changes only at heights: 0, 1, degrees at the ends of cells, and degrees at which two
//! literals cross. Between neighbouring heights, in a gap, one level stands for all.

use std::cmp::Ordering;
use std::collections::{HashMap, HashSet};

use super::sensor::{Cell, Sensor};
use crate::base::Fraction;

/// How each choice of literals compares to a level.
pub(super) type Pattern = Vec<Ordering>;

/// What an event sees of one input in one state.
#[derive(Debug, Clone)]
pub(super) struct Slices {
    /// In ascending order, from 0 to 1.
    pub(super) heights: Vec<Fraction>,
    /// The patterns at each height and, in between, in each gap.
    patterns: Vec<Vec<Pattern>>,
    /// Which of them some stretch of readings has, not only single ones.
    wide: Vec<Vec<bool>>,
}

impl Slices {
    /// The slices of a sensor for choices of its literals, each standing for the largest degree among them.
    pub(super) fn new(sensor: &Sensor, choices: &[&[usize]]) -> Self {
        let mut literals: Vec<usize> = choices.concat();
        literals.sort_unstable();
        literals.dedup();
        let heights = heights(sensor, &literals);
        let ranked = Ranked::new(sensor, choices, &heights);
        let levels = heights.iter().enumerate().flat_map(|(index, height)| {
            let next = heights.get(index + 1);
            [Some((2 * index, height.clone())), next.map(|next| (2 * index + 1, height.halfway(next)))]
        });
        let (patterns, wide) = levels.flatten().map(|(rank, level)| ranked.patterns(rank, &level)).unzip();
        Self { heights, patterns, wide }
    }

    /// The patterns at a level that is one of the heights, or just above it.
    pub(super) fn at(&self, height: &Fraction, is_gap: bool) -> &[Pattern] {
        self.patterns.get(self.position(height, is_gap)).map_or(&[], Vec::as_slice)
    }

    /// Which of these patterns some stretch of readings has.
    pub(super) fn wide_at(&self, height: &Fraction, is_gap: bool) -> &[bool] {
        self.wide.get(self.position(height, is_gap)).map_or(&[], Vec::as_slice)
    }

    fn position(&self, height: &Fraction, is_gap: bool) -> usize {
        match self.heights.binary_search(height) {
            Ok(position) => 2 * position + usize::from(is_gap),
            Err(after) => (2 * after).saturating_sub(1),
        }
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

/// The degrees at the ends of each kind of cell as ranks among the heights: most comparisons need no more.
struct Ranked<'a> {
    choices: &'a [&'a [usize]],
    /// A cell of each kind, and for each literal of each choice twice the position of its degrees among the heights.
    cells: Vec<(&'a Cell, Vec<(usize, usize)>)>,
}

impl<'a> Ranked<'a> {
    fn new(sensor: &'a Sensor, choices: &'a [&'a [usize]], heights: &[Fraction]) -> Self {
        let rank = |degree: &Fraction| 2 * heights.binary_search(degree).unwrap_or(0);
        let ends = |cell: &Cell| {
            let literals = choices.iter().copied().flatten();
            literals.map(|&literal| (rank(&cell.degrees[literal].0), rank(&cell.degrees[literal].1))).collect()
        };
        let mut known = HashSet::new();
        let mut cells: Vec<(&Cell, Vec<_>)> = sensor.cells.iter().map(|cell| (cell, ends(cell))).collect();
        cells.retain(|(cell, ends)| known.insert((cell.is_point(), ends.clone())));
        Self { choices, cells }
    }

    /// The patterns at a level with a rank among the heights, even for one of them, odd for a gap.
    fn patterns(&self, rank: usize, level: &Fraction) -> (Vec<Pattern>, Vec<bool>) {
        let (mut found, mut wide): (Vec<Pattern>, Vec<bool>) = Default::default();
        let mut known = HashMap::new();
        let mut add = |pattern: Pattern, is_wide: bool| {
            let position = *known.entry(pattern).or_insert_with_key(|pattern| {
                found.push(pattern.clone());
                wide.push(false);
                found.len() - 1
            });
            wide[position] |= is_wide;
        };
        for (cell, ends) in &self.cells {
            if ends.iter().all(|(from, to)| from.min(to) >= &rank || from.max(to) <= &rank) {
                // Nothing crosses the level inside the cell; one end at most touches it.
                let signs = ends.iter().map(|(from, to)| from.cmp(&rank).then(to.cmp(&rank)));
                add(pattern(self.choices, 0.cmp(&rank), signs), !cell.is_point());
            } else {
                for_each_piece(cell, self.choices, level, |pattern, share| add(pattern, share.0 != share.1));
            }
        }
        (found, wide)
    }
}

/// The reading with a pattern at a level, as far from readings with another one as it can be; `None` where the sensor
/// gives none. Answers nothing useful for a pattern that does not occur at the level.
pub(super) fn reading(sensor: &Sensor, choices: &[&[usize]], level: &Fraction, wanted: &Pattern) -> Option<Fraction> {
    let mut best: Option<(Fraction, Fraction)> = None;
    for cell in &sensor.cells {
        for_each_piece(cell, choices, level, |pattern, share| {
            if pattern != *wanted {
                return;
            }
            if let (Some(from), Some(to)) = (cell.reading(&share.0), cell.reading(&share.1))
                && best.as_ref().is_none_or(|best| &to - &from > &best.1 - &best.0)
            {
                best = Some((from, to));
            }
        });
    }
    best.map(|(from, to)| from.halfway(&to))
}

/// The patterns inside a cell, and the shares of it at which each begins and ends.
fn for_each_piece(
    cell: &Cell,
    choices: &[&[usize]],
    level: &Fraction,
    mut visit: impl FnMut(Pattern, &(Fraction, Fraction)),
) {
    for piece in cell.pieces(&choices.concat(), level) {
        visit(pattern(choices, Fraction::ZERO.cmp(level), piece.signs.iter().copied()), &piece.share);
    }
}

/// How each choice compares to a level, given how each of its literals does, and how 0 does.
fn pattern(choices: &[&[usize]], nothing: Ordering, mut signs: impl Iterator<Item = Ordering>) -> Pattern {
    choices.iter().map(|choice| signs.by_ref().take(choice.len()).fold(nothing, Ordering::max)).collect()
}
