//! Whether a condition on its own can hold and can fail, whatever is read, whatever has failed, in whatever mode.

use std::collections::BTreeSet;

use super::faults::{Fault, FaultSet};
use super::formula::{Atom, Formula};
use super::ticks::{Scene, feasible};
use crate::base::Id;
use crate::ir::{Diagram, Expr, Mode, Op, Program};

/// What a condition can be; a `false` is proved.
pub(in crate::analysis) struct Outcomes {
    pub(in crate::analysis) can_hold: bool,
    pub(in crate::analysis) can_fail: bool,
}

/// More sensors that may have failed are not looked into.
const MOST_SENSORS: usize = 6;

/// Conditions that are looked at apart from the transitions of a diagram.
pub(in crate::analysis) struct Conditions<'a>(Scene<'a>);

impl<'a> Conditions<'a> {
    pub(in crate::analysis) fn new(program: &'a Program, diagram: &'a Diagram) -> Self {
        Self(Scene::new(program, diagram))
    }

    /// `None` where the condition is broken, depends on the time in a mode, or has too many cases to look into.
    pub(in crate::analysis) fn outcomes(&self, condition: Id<Expr>) -> Option<Outcomes> {
        let scene = &self.0;
        let formula = Formula::of(scene.program, scene.diagram, &[condition])?;
        if formula.atoms.iter().any(|atom| matches!(atom, Atom::After(_) | Atom::Count(..))) {
            return None;
        }
        let mut outcomes = Outcomes { can_hold: false, can_fail: false };
        for faults in reported(&formula)? {
            let ticks = feasible(scene, &formula, &faults)?;
            let possible = ticks.iter().map(|tick| tick.truth).filter(|truth| is_in_one_mode(scene, &formula, *truth));
            for values in possible.filter_map(|truth| formula.values(truth)) {
                let holds = values[formula.roots[0]];
                outcomes.can_hold |= holds;
                outcomes.can_fail |= !holds;
            }
        }
        Some(outcomes)
    }
}

/// Every set of reported failures that the formula can tell.
fn reported(formula: &Formula) -> Option<Vec<FaultSet>> {
    let failed = |atom: &Atom| match atom {
        Atom::Failed(sensor) => Some(*sensor),
        _ => None,
    };
    let sensors: BTreeSet<_> = formula.atoms.iter().filter_map(failed).collect();
    let mut sets = vec![FaultSet::new()];
    if sensors.len() > MOST_SENSORS {
        return None;
    }
    for sensor in sensors {
        let with: Vec<_> = sets.iter().map(|set| [set.as_slice(), &[(sensor, Fault::Reported)]].concat()).collect();
        sets.extend(with);
    }
    Some(sets)
}

/// Whether there is a mode in which the modes that the formula names are as the truth says.
fn is_in_one_mode(scene: &Scene<'_>, formula: &Formula, truth: u64) -> bool {
    let named = |atom: &Atom| match atom {
        Atom::Open(id) => match scene.program.exprs[*id].op {
            Op::InMode(mode) => Some(mode),
            _ => None,
        },
        _ => None,
    };
    let named = formula.atoms.iter().enumerate().filter_map(|(bit, atom)| Some((named(atom)?, truth >> bit & 1 == 1)));
    let named: Vec<(Id<Mode>, bool)> = named.collect();
    named.is_empty() || scene.diagram.modes.ids().any(|mode| named.iter().all(|(other, is)| (mode == *other) == *is))
}
