//! An input in one state of health: its readings cut into cells on which every degree is linear.

use std::cmp::Ordering;

use super::columns::Columns;
use crate::analysis::support::Interval;
use crate::base::Fraction;
use crate::ir::FailReading;
use crate::membership::places;

/// The cells of an input.
#[derive(Debug, Clone)]
pub(super) struct Sensor {
    pub(super) cells: Vec<Cell>,
}

/// One reading, or the readings strictly between two.
#[derive(Debug, Clone)]
pub(super) struct Cell {
    /// Its ends, equal for one reading; none for a sensor that gives no reading at all.
    pub(super) ends: Option<(Fraction, Fraction)>,
    /// The degree of every literal at either end, or its limit there.
    pub(super) degrees: Vec<(Fraction, Fraction)>,
}

/// A part of a cell on which no literal crosses a level.
pub(super) struct Piece {
    /// Where it begins and ends, as shares of the cell.
    pub(super) share: (Fraction, Fraction),
    /// How each literal asked for compares to the level.
    pub(super) signs: Vec<Ordering>,
}

impl Sensor {
    /// A sensor that can give every reading of a range.
    pub(super) fn healthy(columns: &Columns, range: &(Fraction, Fraction)) -> Self {
        let places = places(&columns.curves, range);
        let around: Vec<Vec<_>> =
            places.iter().map(|at| columns.curves.iter().map(|curve| curve.around(at)).collect()).collect();
        let mut cells = Vec::with_capacity(2 * places.len());
        for (index, (place, here)) in places.iter().zip(&around).enumerate() {
            let degrees = here.iter().map(|limits| (limits.at.clone(), limits.at.clone())).collect();
            cells.push(Cell { ends: Some(((*place).clone(), (*place).clone())), degrees });
            if let (Some(next), Some(there)) = (places.get(index + 1), around.get(index + 1)) {
                let ends = here.iter().zip(there);
                let degrees = ends.map(|(here, there)| (here.after.clone(), there.before.clone())).collect();
                cells.push(Cell { ends: Some(((*place).clone(), (*next).clone())), degrees });
            }
        }
        Self { cells }
    }

    /// A failed sensor. A reading that is unknown but constant may be any one of the range.
    pub(super) fn failed(columns: &Columns, range: &(Fraction, Fraction), fail: FailReading, pi: i8) -> Self {
        match fail {
            FailReading::Any => Self::healthy(columns, range),
            FailReading::Value(value) => {
                let value = value.to_fraction(pi);
                Self::healthy(columns, &(value.clone(), value))
            }
            FailReading::Absent => Self::absent(columns),
        }
    }

    /// A sensor that gives no reading.
    pub(super) fn absent(columns: &Columns) -> Self {
        let degrees = columns.absent.iter().map(|degree| (degree.clone(), degree.clone())).collect();
        Self { cells: vec![Cell { ends: None, degrees }] }
    }

    /// A sensor that gives the readings between two cuts; `None` where there are none.
    pub(super) fn between(columns: &Columns, (from, to): &Interval, pi: i8) -> Option<Self> {
        let mut sensor = Self::healthy(columns, &(from.at.to_fraction(pi), to.at.to_fraction(pi)));
        if from.after {
            sensor.cells.remove(0);
        }
        if !to.after {
            sensor.cells.pop();
        }
        (from < to).then_some(sensor)
    }
}

impl Cell {
    /// Whether it is one reading, or none.
    pub(super) fn is_point(&self) -> bool {
        self.ends.as_ref().is_none_or(|(from, to)| from == to)
    }

    /// The reading at a share of the cell.
    pub(super) fn reading(&self, share: &Fraction) -> Option<Fraction> {
        let (from, to) = self.ends.as_ref()?;
        Some(from + &(&(to - from) * share))
    }

    /// Its parts on which none of these literals crosses the level, in ascending order.
    pub(super) fn pieces(&self, literals: &[usize], level: &Fraction) -> Vec<Piece> {
        let ends: Vec<_> = literals.iter().map(|&literal| &self.degrees[literal]).collect();
        let signs: Vec<_> = ends.iter().map(|(from, to)| (from.cmp(level), to.cmp(level))).collect();
        if self.is_point() {
            let share = (Fraction::ZERO, Fraction::ZERO);
            return vec![Piece { share, signs: signs.iter().map(|(from, _)| *from).collect() }];
        }
        let crossing = |((from, to), (before, after)): (&&(Fraction, Fraction), &(Ordering, Ordering))| {
            (before.is_lt() && after.is_gt() || before.is_gt() && after.is_lt())
                .then(|| (level - from).over(&(to - from)))
                .flatten()
        };
        let crossings: Vec<Option<Fraction>> = ends.iter().zip(&signs).map(crossing).collect();
        let mut cuts: Vec<&Fraction> = crossings.iter().flatten().collect();
        cuts.sort_unstable();
        cuts.dedup();
        let mut pieces = Vec::with_capacity(2 * cuts.len() + 1);
        let mut from = &Fraction::ZERO;
        for to in cuts.into_iter().map(Some).chain([None]) {
            let sign = |((before, after), crossing): (&(Ordering, Ordering), &Option<Fraction>)| match crossing {
                Some(crossing) if crossing <= from => *after,
                Some(_) => *before,
                // Without a crossing inside, one end at most touches the level.
                None => before.then(*after),
            };
            let inside = signs.iter().zip(&crossings).map(sign).collect();
            pieces.push(Piece { share: (from.clone(), to.unwrap_or(&Fraction::ONE).clone()), signs: inside });
            if let Some(cut) = to {
                let sign = |((before, after), crossing): (&(Ordering, Ordering), &Option<Fraction>)| match crossing {
                    Some(crossing) if crossing < cut => *after,
                    Some(crossing) if crossing == cut => Ordering::Equal,
                    Some(_) => *before,
                    None => before.then(*after),
                };
                let at = signs.iter().zip(&crossings).map(sign).collect();
                pieces.push(Piece { share: (cut.clone(), cut.clone()), signs: at });
                from = cut;
            }
        }
        pieces
    }
}
