//! What is worth telling the machine, to see what it does.

use super::examined::fault_sets;
use super::faults::{Fault, FaultSet};
use super::formula::{Atom, Formula};
use super::fusion::Readings;
use super::product::reports_done;
use super::ticks::{Scene, feasible};
use crate::base::Id;
use crate::ir::{Expr, Mode, Sensor};

/// What the machine can be told on a tick.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stimulus {
    /// The sensors that are known to have failed, ascending.
    pub failed: Vec<Id<Sensor>>,
    /// Readings in SI; those of other sensors do not matter.
    pub readings: Readings,
    /// Whether the action of the mode has reported completion.
    pub done: bool,
}

/// By mode one of every kind of tick that its transitions and some watched conditions can tell apart, those without
/// failures first. What is looked at in the past anywhere makes a difference in every mode, unless there are too many
/// kinds then; a mode that has too many of its own has none.
pub(super) fn stimuli(scene: &Scene<'_>, watched: &[Id<Expr>], most_faults: usize) -> Vec<Vec<Stimulus>> {
    let formula = |mode| Formula::watching(scene.program, scene.diagram, mode, watched);
    let formulas: Vec<_> = scene.diagram.modes.ids().map(formula).collect();
    let remembered = formulas.iter().flatten().flat_map(|formula| formula.remembered(scene.program));
    let remembered: Vec<Atom> = remembered.collect();
    let of_mode = |(mode, formula): (&Mode, &Option<Formula>)| {
        let formula = formula.as_ref()?;
        let sets = fault_sets(scene, mode, formula, most_faults)?;
        let own = || formula.present(scene.program);
        let told = told(scene, &sets, own().chain(remembered.iter().cloned())).or_else(|| told(scene, &sets, own()))?;
        let can_complete = reports_done(scene.program, mode) && formula.atoms.contains(&Atom::Done);
        let completes: &[bool] = if can_complete { &[false, true] } else { &[false] };
        let stimuli = told.into_iter().flat_map(|(failed, readings)| {
            completes.iter().map(move |done| Stimulus {
                failed: failed.clone(),
                readings: readings.clone(),
                done: *done,
            })
        });
        Some(stimuli.collect())
    };
    scene.diagram.modes.values().zip(&formulas).map(|mode| of_mode(mode).unwrap_or_default()).collect()
}

/// Failed sensors and readings for every truth of some atoms; `None` where there are too many.
fn told(
    scene: &Scene<'_>,
    sets: &[FaultSet],
    atoms: impl Iterator<Item = Atom>,
) -> Option<Vec<(Vec<Id<Sensor>>, Readings)>> {
    let formula = Formula::of_atoms(atoms)?;
    let mut told = Vec::new();
    for faults in sets {
        let Some(failed) = reported(faults) else { continue };
        let readings = feasible(scene, &formula, faults)?.into_iter().filter_map(|tick| tick.readings);
        told.extend(readings.map(|readings| (failed.clone(), readings)));
    }
    Some(told)
}

/// The failed sensors where the machine knows of all of them; a silent failure reads what a sound sensor can read too,
/// or cannot be shown.
fn reported(faults: &FaultSet) -> Option<Vec<Id<Sensor>>> {
    faults.iter().map(|(sensor, fault)| (*fault == Fault::Reported).then_some(*sensor)).collect()
}
