//! What can happen in a mode under some faults, found once for all that are alike to the mode.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::dwell::{Case, Stay, stay};
use super::examined::{Examined, concerning, is_whole, reported};
use super::faults::{Fault, FaultSet, fail_reading};
use super::formula::{Atom, Formula};
use super::ticks::{Scene, events};
use crate::base::Id;
use crate::ir::{Mode, Sensor};

/// What is known of a mode by now.
pub(super) struct Known<'m> {
    mode: &'m Mode,
    pub(super) formula: Rc<Formula>,
    /// The sensors whose failing changes what can happen.
    pub(super) concerning: BTreeSet<Id<Sensor>>,
    /// Those of which it matters whether the machine knows that they have failed.
    told: BTreeSet<Id<Sensor>>,
    /// Its events, if it compares no sensor.
    pub(super) fuses: Option<Vec<(u32, u32)>>,
    cases: BTreeMap<FaultSet, Option<Rc<Case>>>,
    stays: BTreeMap<FaultSet, Option<Rc<Stay>>>,
}

impl<'m> Known<'m> {
    /// Begins with what the mode was examined for, if it was. `None` where the mode is broken.
    pub(super) fn new(scene: &Scene<'_>, mode: &'m Mode, examined: Option<&Examined>) -> Option<Self> {
        let formula = match examined {
            Some(examined) => Rc::clone(&examined.formula),
            None => {
                let formula = Formula::new(scene.program, scene.diagram, &mode.transitions);
                Rc::new(formula.filter(|_| is_whole(mode))?)
            }
        };
        let (concerning, told) = (concerning(scene, mode, &formula), reported(scene, mode, &formula));
        let compares = formula.atoms.iter().any(|atom| matches!(atom, Atom::Compare(..)));
        let fuses = (!compares).then(|| events(&formula));
        let cases: BTreeMap<_, _> = examined
            .into_iter()
            .flat_map(|examined| &examined.cases)
            .map(|(faults, case)| (faults.clone(), Some(Rc::clone(case))))
            .collect();
        // Examined without failures alone, it is known without failures.
        let healthy = examined.filter(|_| cases.len() == 1).map(|examined| Some(Rc::clone(&examined.stay)));
        let stays = healthy.into_iter().map(|stay| (FaultSet::new(), stay)).collect();
        Some(Self { mode, formula, concerning, told, fuses, cases, stays })
    }

    /// The faults that make a difference to the mode, as it sees them.
    pub(super) fn seen(&self, scene: &Scene<'_>, faults: &FaultSet) -> FaultSet {
        let seen = |&(sensor, fault): &(Id<Sensor>, Fault)| match fault {
            Fault::Reported if !self.told.contains(&sensor) => {
                (sensor, fail_reading(scene.program, scene.diagram, sensor).map_or(fault, Fault::Stuck))
            }
            _ => (sensor, fault),
        };
        faults.iter().filter(|(sensor, _)| self.concerning.contains(sensor)).map(seen).collect()
    }

    /// What can happen under some faults that are seen, each of which may have struck while the machine was in the
    /// mode; `None` where that is too much to look into.
    pub(super) fn stay(&mut self, scene: &Scene<'_>, faults: &FaultSet) -> Option<Rc<Stay>> {
        if let Some(stay) = self.stays.get(faults) {
            return stay.clone();
        }
        let stay = self.stay_after_fewer(scene, faults).map(Rc::new);
        self.stays.insert(faults.clone(), stay.clone());
        stay
    }

    fn stay_after_fewer(&mut self, scene: &Scene<'_>, faults: &FaultSet) -> Option<Stay> {
        let mut before = BTreeSet::new();
        for without in 0..faults.len() {
            let mut fewer = faults.clone();
            fewer.remove(without);
            before.extend(self.stay(scene, &fewer)?.states.iter().cloned());
        }
        let case = self.case(scene, faults)?;
        stay(&self.formula, &[case], &before)
    }

    fn case(&mut self, scene: &Scene<'_>, faults: &FaultSet) -> Option<Rc<Case>> {
        if let Some(case) = self.cases.get(faults) {
            return case.clone();
        }
        let case = Case::new(scene, self.mode, &self.formula, faults).map(Rc::new);
        self.cases.insert(faults.clone(), case.clone());
        case
    }

    /// Whether the same ticks can be as without failures.
    pub(super) fn is_like_healthy(&mut self, scene: &Scene<'_>, faults: &FaultSet) -> bool {
        let healthy = self.case(scene, &FaultSet::new());
        let now = self.case(scene, faults);
        healthy.zip(now).is_some_and(|(healthy, now)| now.is_like(&healthy))
    }
}
