//! A diagram with all that can be true on a tick, for what explores it in a way of its own.

use std::collections::BTreeSet;

use super::dwell::Clock;
use super::facts::Table;
use super::faults::FaultSet;
use super::formula::Formula;
use super::ticks::{Scene, decided};
use crate::base::Id;
use crate::ir::{Diagram, Mode, Program};

/// What the analysis of a diagram starts from. Where it arrives is left out.
#[derive(Debug)]
pub struct Machine {
    /// The diagram.
    pub diagram: Id<Diagram>,
    /// What fails together, each set once, smallest first.
    pub faults: Vec<FaultSet>,
    /// What the transitions of each mode ask, by its id.
    pub modes: Vec<Guards>,
}

/// What the transitions of a mode ask, and what the answers can be.
#[derive(Debug)]
pub struct Guards {
    /// Their conditions, in order.
    pub formula: Formula,
    /// The timers and counters in them.
    pub clock: Clock,
    /// One for each set of those failures that make a difference to the mode.
    pub cases: Vec<Case>,
}

/// What can be true under some failures.
#[derive(Debug)]
pub struct Case {
    /// What has failed, of what makes a difference to the mode.
    pub faults: FaultSet,
    /// The atoms of the formula that are true together on a tick, a bit for each, in ascending order. Timers and
    /// counters, the past, completion and what is open are left out: they count as false.
    pub valuations: Vec<u64>,
}

/// The machine of a diagram, for every set of at most `up_to` failed sensors.
///
/// # Errors
/// A mode with more cases than are looked into.
pub fn machine(program: &Program, diagram: Id<Diagram>, up_to: usize) -> Result<Machine, Id<Mode>> {
    let scene = Scene::new(program, &program.diagrams[diagram]);
    let table = Table::new(&scene);
    let faults = table.fault_sets(up_to);
    let modes = scene.diagram.modes.ids().zip(table.formulas).map(|(mode, conditions)| {
        let (formula, sensors) = conditions.ok_or(mode)?;
        let own = |faults: &FaultSet| -> FaultSet {
            faults.iter().filter(|(sensor, _)| sensors.contains(sensor)).copied().collect()
        };
        let sets: BTreeSet<_> = faults.iter().map(own).collect();
        let cases = sets.into_iter().map(|faults| Case::new(&scene, &formula, faults)).collect::<Option<_>>();
        let (clock, cases) = Clock::new(&formula).zip(cases).ok_or(mode)?;
        Ok(Guards { formula, clock, cases })
    });
    Ok(Machine { diagram, modes: modes.collect::<Result<_, _>>()?, faults })
}

impl Case {
    fn new(scene: &Scene<'_>, formula: &Formula, faults: FaultSet) -> Option<Self> {
        let valuations: BTreeSet<_> = decided(scene, formula, &faults)?.into_iter().map(|tick| tick.truth).collect();
        Some(Self { faults, valuations: valuations.into_iter().collect() })
    }
}
