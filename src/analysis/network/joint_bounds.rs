//! Bounds between degrees and the level of an event, as propositions.

use super::linear::Inequality;
use super::model::Model;
use super::solver::{Proposition, Solver};
use crate::base::Fraction;

/// On which side of its event's level a degree lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Above,
    Below,
}

/// A degree on one side of its event's level: strictly where the event is to be set, else possibly at it.
#[derive(Debug, Clone)]
pub(super) struct Bound {
    pub(super) event: usize,
    pub(super) side: Side,
    pub(super) when_set: bool,
    /// The input and its literal; none for a constant.
    pub(super) literal: Option<(usize, usize)>,
    pub(super) constant: Fraction,
    pub(super) proposition: Proposition,
}

/// The propositions about cells, levels and bounds.
pub(super) struct Bounds {
    /// By input and cell: its reading is there.
    pub(super) cells: Vec<Vec<Proposition>>,
    pub(super) all: Vec<Bound>,
    /// By event, in ascending order: heights, whether the level is below each, and whether it is not above it.
    levels: Vec<Vec<(Fraction, Proposition, Proposition)>>,
    /// By input, cell and literal: the ends of what its degree can be, and whether it is one number.
    degrees: Vec<Vec<Vec<(Fraction, Fraction)>>>,
}

impl Bounds {
    pub(super) fn new(model: &Model, states: &[usize], solver: &mut Solver) -> Self {
        let sensors: Vec<_> = model.inputs.iter().zip(states).map(|(input, &state)| &input.sensors[state]).collect();
        let cells = sensors.iter().map(|sensor| {
            let cells: Vec<_> = sensor.cells.iter().map(|_| solver.proposition()).collect();
            solver.demand(cells.iter().copied());
            cells
        });
        let cells = cells.collect();
        let degrees = sensors.iter().map(|sensor| sensor.cells.iter().map(|cell| cell.degrees.clone()).collect());
        let levels = model.events.iter().enumerate().map(|(position, event)| {
            let mut heights = vec![Fraction::ZERO, Fraction::ONE];
            for named in event.uses.iter().chain(&model.loose(position).uses) {
                let literals: Vec<_> = named.choices.iter().flat_map(|choice| &choice.literals).collect();
                for cell in &sensors[named.input].cells {
                    let ends = literals.iter().map(|&&literal| &cell.degrees[literal]);
                    heights.extend(ends.flat_map(|(from, to)| [from.clone(), to.clone()]));
                }
            }
            heights.sort_unstable();
            heights.dedup();
            let mut below_next = None;
            let heights = heights.into_iter().rev().map(|height| {
                let (below, not_above) = (solver.proposition(), solver.proposition());
                solver.demand([!below, not_above]);
                match below_next {
                    Some(next) => solver.demand([!not_above, next]),
                    None => solver.demand([not_above]),
                }
                below_next = Some(below);
                (height, below, not_above)
            });
            let mut heights: Vec<_> = heights.collect();
            heights.reverse();
            if let Some((_, below, _)) = heights.first() {
                solver.demand([!*below]);
            }
            heights
        });
        let levels = levels.collect();
        Self { cells, all: Vec::new(), levels, degrees: degrees.collect() }
    }

    /// The bound of a literal; the same one whenever asked.
    pub(super) fn literal(
        &mut self,
        solver: &mut Solver,
        event: usize,
        side: Side,
        when_set: bool,
        (input, literal): (usize, usize),
    ) -> Proposition {
        let known = self.all.iter().find(|bound| {
            bound.literal == Some((input, literal))
                && bound.event == event
                && bound.side == side
                && bound.when_set == when_set
        });
        if let Some(known) = known {
            return known.proposition;
        }
        let proposition = solver.proposition();
        for (&cell, degrees) in self.cells[input].iter().zip(&self.degrees[input]) {
            let (from, to) = &degrees[literal];
            let end = if (side == Side::Above) == (from < to) { to } else { from };
            // Inside a cell, a degree that changes never comes to its end.
            let consequence = self.consequence(event, side, when_set || from != to, end);
            solver.demand([!proposition, !cell].into_iter().chain([consequence]));
        }
        let literal = Some((input, literal));
        self.all.push(Bound { event, side, when_set, literal, constant: Fraction::ZERO, proposition });
        proposition
    }

    /// The bound of a number.
    pub(super) fn constant(
        &mut self,
        solver: &mut Solver,
        event: usize,
        side: Side,
        when_set: bool,
        constant: Fraction,
    ) -> Proposition {
        let proposition = solver.proposition();
        let consequence = self.consequence(event, side, when_set, &constant);
        solver.demand([!proposition, consequence]);
        self.all.push(Bound { event, side, when_set, literal: None, constant, proposition });
        proposition
    }

    /// What a degree's being on one side of the level says of the level.
    fn consequence(&self, event: usize, side: Side, strict: bool, degree: &Fraction) -> Proposition {
        let heights = &self.levels[event];
        let position = heights.partition_point(|(height, ..)| height < degree).min(heights.len() - 1);
        let (_, below, not_above) = heights[position];
        match (side, strict) {
            (Side::Above, true) => below,
            (Side::Above, false) => not_above,
            (Side::Below, true) => !not_above,
            (Side::Below, false) => !below,
        }
    }

    /// The cell that an input is in, in the model found last.
    pub(super) fn chosen(&self, solver: &Solver, input: usize) -> usize {
        self.cells[input].iter().position(|&cell| solver.value(cell)).unwrap_or(0)
    }

    /// How many unknowns there are: a place in its cell for each input, then a level for each event.
    pub(super) fn unknowns(&self) -> usize {
        self.cells.len() + self.levels.len()
    }

    pub(super) fn level(&self, event: usize) -> usize {
        self.cells.len() + event
    }

    /// What holds of the unknowns in any case: places lie strictly between 0 and 1, levels between both or at them.
    pub(super) fn domains(&self) -> Vec<Inequality> {
        let both = |unknown| {
            let strict = unknown < self.cells.len();
            let low = Inequality {
                factors: vec![(unknown, Fraction::ONE)],
                constant: Fraction::ZERO,
                strict,
                because: Vec::new(),
            };
            let high = Inequality {
                factors: vec![(unknown, Fraction::from(-1))],
                constant: Fraction::ONE,
                strict,
                because: Vec::new(),
            };
            [low, high]
        };
        (0..self.unknowns()).flat_map(both).collect()
    }
}
