//! One mode under everything that may have failed.

use std::collections::BTreeSet;
use std::rc::Rc;

use super::dwell::{Case, Stay, stay};
use super::faults::{Fault, FaultSet, fails_of_variables, groups_within};
use super::formula::{Atom, Formula, Operand};
use super::ticks::Scene;
use crate::base::Id;
use crate::ir::{FailReading, Mode, Sensor};

/// A mode under every set of failed sensors that could give it readings or flags it has not otherwise, each failing
/// and recovering on any tick. What never happens then never happens.
pub(in crate::analysis) struct Examined {
    pub(super) formula: Rc<Formula>,
    pub(super) cases: Vec<(FaultSet, Rc<Case>)>,
    pub(super) stay: Rc<Stay>,
}

/// More sets of failed sensors are not looked into.
const MOST_CASES: usize = 1 << 8;

/// Whether nothing in a mode was broken. Of two transitions with one priority nothing says which comes first.
pub(super) fn is_whole(mode: &Mode) -> bool {
    let is_ordered = mode.transitions.is_sorted_by(|one, next| one.priority < next.priority);
    !mode.incomplete && is_ordered && mode.transitions.iter().all(|transition| transition.target.is_some())
}

/// `None` where the mode is broken, or has too many cases to look into.
pub(super) fn examine(scene: &Scene<'_>, mode: &Mode) -> Option<Examined> {
    if !is_whole(mode) {
        return None;
    }
    let formula = Formula::new(scene.program, scene.diagram, &mode.transitions)?;
    let sets = fault_sets(scene, mode, &formula, usize::MAX)?;
    let case = |faults| Case::new(scene, mode, &formula, faults).map(Rc::new);
    let cases: Vec<_> = sets.iter().map(case).collect::<Option<_>>()?;
    let stay = Rc::new(stay(&formula, &cases, &BTreeSet::new())?);
    Some(Examined { formula: Rc::new(formula), cases: sets.into_iter().zip(cases).collect(), stay })
}

/// Every set of at most `most` faults that adds to what can happen, smallest first. A sensor stuck at some reading reads
/// what it could have read anyway; only a failure that is reported, or takes all degrees of membership away, adds.
pub(super) fn fault_sets(scene: &Scene<'_>, mode: &Mode, formula: &Formula, most: usize) -> Option<Vec<FaultSet>> {
    let reported = reported(scene, mode, formula);
    let absent = feeding(scene, formula).into_iter().filter(|sensor| can_be_absent(scene, *sensor));
    let single: BTreeSet<_> = reported
        .into_iter()
        .map(|sensor| (sensor, Fault::Reported))
        .chain(absent.map(|sensor| (sensor, Fault::Absent)))
        .collect();
    let mut sets = vec![FaultSet::new()];
    for (sensor, fault) in single {
        let is_extended = |set: &&FaultSet| set.len() < most && set.last().is_none_or(|(last, _)| *last != sensor);
        let others: Vec<_> = sets.iter().filter(is_extended).collect();
        let with = others.into_iter().map(|set| [set.as_slice(), &[(sensor, fault)]].concat());
        sets = with.collect::<Vec<_>>().into_iter().chain(sets).collect();
        if sets.len() > MOST_CASES {
            return None;
        }
    }
    sets.sort_by_key(Vec::len);
    Some(sets)
}

/// The sensors whose reported failure the mode can tell, or that inhibit it or where it leads.
pub(super) fn reported(scene: &Scene<'_>, mode: &Mode, formula: &Formula) -> BTreeSet<Id<Sensor>> {
    let targets = mode.transitions.iter().filter_map(|transition| transition.target).chain(mode.otherwise);
    let required = targets.flat_map(|target| &scene.diagram.modes[target].requires).chain(&mode.requires);
    let told = formula.atoms.iter().filter_map(|atom| match atom {
        Atom::Failed(sensor) => Some(*sensor),
        _ => None,
    });
    let mut sensors = required.map(|(sensor, _)| *sensor).chain(told).collect();
    let groups = groups_within(scene.program, scene.diagram, &sensors);
    sensors.extend(groups);
    sensors
}

/// The sensors of the formula's events.
fn feeding(scene: &Scene<'_>, formula: &Formula) -> BTreeSet<Id<Sensor>> {
    let senses = formula.atoms.iter().filter_map(|atom| match atom {
        Atom::Event { sense, .. } => Some(*sense),
        _ => None,
    });
    senses.flat_map(|sense| &scene.diagram.senses[sense as usize].inputs).copied().collect()
}

/// Every sensor whose failing changes what can happen in the mode.
pub(super) fn concerning(scene: &Scene<'_>, mode: &Mode, formula: &Formula) -> BTreeSet<Id<Sensor>> {
    let mut sensors = reported(scene, mode, formula);
    sensors.extend(feeding(scene, formula));
    for atom in &formula.atoms {
        match atom {
            Atom::Compare(_, left, Operand::Sensor(right)) => sensors.extend([*left, *right]),
            Atom::Compare(_, sensor, Operand::Number(_)) => {
                sensors.insert(*sensor);
            }
            _ => {}
        }
    }
    sensors
}

fn can_be_absent(scene: &Scene<'_>, sensor: Id<Sensor>) -> bool {
    let own = scene.program.sensors[sensor].fails.iter();
    own.chain(fails_of_variables(scene.program, scene.diagram, sensor)).any(|fail| *fail == FailReading::Absent)
}
