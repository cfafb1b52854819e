//! The sets of faults that the modes of a diagram can tell apart.

use std::collections::BTreeSet;

use super::faults::{Fault, FaultSet, fails_of_variables};
use super::formula::{Atom, Formula, Operand};
use super::ticks::Scene;
use crate::base::{Exact, Id};
use crate::ir::{FailReading, Sensor};

/// A mode's conditions, and the sensors whose failing concerns it.
type Conditions<'f> = (&'f Formula, &'f BTreeSet<Id<Sensor>>);

/// Every set of at most `up_to` faults of the sensors that concern some mode, smallest first. A sensor that can be stuck
/// anywhere is not, if the modes can tell more stretches of its readings apart than `most_stretches`.
pub(super) fn fault_sets(
    scene: &Scene<'_>,
    modes: &[Conditions<'_>],
    up_to: usize,
    most_stretches: usize,
) -> Vec<FaultSet> {
    let sensors: BTreeSet<_> = modes.iter().flat_map(|(_, sensors)| *sensors).copied().collect();
    let mut sets = vec![FaultSet::new()];
    for sensor in sensors {
        let faults = faults(scene, modes, sensor, most_stretches);
        let small: Vec<_> = sets.iter().filter(|set| set.len() < up_to).cloned().collect();
        for set in small {
            sets.extend(faults.iter().map(|fault| [set.as_slice(), &[(sensor, *fault)]].concat()));
        }
    }
    sets.sort_by_key(Vec::len);
    sets
}

/// The ways in which a sensor fails: those it declares, or its variables do, and that it is reported.
fn faults(scene: &Scene<'_>, modes: &[Conditions<'_>], sensor: Id<Sensor>, most_stretches: usize) -> Vec<Fault> {
    if scene.program.sensors[sensor].is_inner() {
        return Vec::new();
    }
    let own = &scene.program.sensors[sensor].fails;
    let of_variables = || fails_of_variables(scene.program, scene.diagram, sensor).copied().collect();
    let declared = if own.is_empty() { of_variables() } else { own.clone() };
    let mut faults = BTreeSet::from([Fault::Reported]);
    for fail in declared {
        match fail {
            FailReading::Value(at) => {
                faults.insert(Fault::Stuck(at));
            }
            FailReading::Any => {
                let stretches = Some(stretches(scene, modes, sensor));
                faults.extend(stretches.filter(|all| all.len() <= most_stretches).into_iter().flatten());
            }
            FailReading::Absent => {
                faults.insert(Fault::Absent);
            }
        }
    }
    faults.into_iter().collect()
}

/// The readings of a sensor one by one where the diagram compares it, and those between.
fn stretches(scene: &Scene<'_>, modes: &[Conditions<'_>], sensor: Id<Sensor>) -> Vec<Fault> {
    let (low, high) = scene.program.sensors[sensor].range;
    let mut cuts = BTreeSet::from([low, high]);
    for atom in modes.iter().flat_map(|(formula, _)| &formula.atoms) {
        if let Atom::Compare(_, compared, Operand::Number(number)) = atom
            && *compared == sensor
        {
            cuts.insert(*number);
        }
    }
    let cuts: Vec<Exact> = cuts.into_iter().filter(|at| low <= *at && *at <= high).collect();
    let between = cuts.windows(2).map(|pair| Fault::Between(pair[0], pair[1]));
    cuts.iter().map(|at| Fault::Stuck(*at)).chain(between).collect()
}
