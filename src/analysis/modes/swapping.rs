//! Two modes that noise alone drives to and fro.

use std::collections::{BTreeSet, HashMap};

use super::dwell::Way;
use super::faults::FaultSet;
use super::formula::{Atom, Formula, Operand};
use super::fusion::Readings;
use super::ticks::{Scene, feasible};
use super::{Examined, named_readings};
use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Mode, Sensor, Transition};

/// Two transitions that lead to and fro.
struct Swap<'a> {
    modes: [&'a Mode; 2],
    exits: [&'a Transition; 2],
    /// Readings that take each of them.
    readings: [Readings; 2],
    noisy: BTreeSet<Id<Sensor>>,
}

/// Warns of pairs of modes of which one leads to the other exactly when the other does not lead back, by noisy
/// readings and nothing else: at the readings between, every tick may take one of the two.
pub(super) fn check(scene: &Scene<'_>, modes: &[Option<Examined>], findings: &mut Vec<Diagnostic>) {
    let at_once = |mode: Id<Mode>, index: usize| {
        let stay = modes[mode.index()].as_ref().map(|examined| &examined.stay);
        stay.is_some_and(|stay| matches!(&stay.exits[index].taken, Some(Way::Shown(path)) if path.len() == 1))
    };
    let mut forth: HashMap<(Id<Mode>, Id<Mode>), &Transition> = HashMap::new();
    for (id, mode) in scene.diagram.modes.iter() {
        let exits = mode.transitions.iter().enumerate().filter(|(index, _)| at_once(id, *index));
        for (_, exit) in exits {
            let Some(target) = exit.target.filter(|target| *target != id) else { continue };
            if let Some(back) = forth.get(&(target, id))
                && let Some(swap) = swap(scene, [(target, back), (id, exit)])
            {
                findings.push(swapping(scene, &swap));
            }
            forth.entry((id, target)).or_insert(exit);
        }
    }
}

fn swap<'a>(scene: &Scene<'a>, pair: [(Id<Mode>, &'a Transition); 2]) -> Option<Swap<'a>> {
    let exits = pair.map(|(_, exit)| exit);
    let formula = Formula::new(scene.program, scene.diagram, exits)?;
    let noisy = noisy(scene, &formula)?;
    let [first, second] = formula.roots[..] else { return None };
    let mut readings = [None, None];
    for tick in feasible(scene, &formula, &FaultSet::new())? {
        let values = formula.values(tick.truth)?;
        if values[first] == values[second] {
            return None;
        }
        let leads = usize::from(values[second]);
        readings[leads] = readings[leads].take().or(tick.readings);
    }
    let [Some(forth), Some(back)] = readings else { return None };
    let modes = pair.map(|(mode, _)| &scene.diagram.modes[mode]);
    Some(Swap { modes, exits, readings: [forth, back], noisy })
}

/// The sensors of a formula; `None` where one of them has no noise, or the formula depends on more than readings.
fn noisy(scene: &Scene<'_>, formula: &Formula) -> Option<BTreeSet<Id<Sensor>>> {
    let mut sensors = BTreeSet::new();
    for atom in &formula.atoms {
        match atom {
            Atom::Event { sense, .. } => sensors.extend(&scene.diagram.senses[*sense as usize].inputs),
            Atom::Compare(_, sensor, Operand::Number(_)) => sensors.extend([*sensor]),
            Atom::Compare(_, left, Operand::Sensor(right)) => sensors.extend([*left, *right]),
            _ => return None,
        }
    }
    let is_noisy = |sensor: &Id<Sensor>| scene.program.sensors[*sensor].noise > 0.0;
    (!sensors.is_empty() && sensors.iter().all(is_noisy)).then_some(sensors)
}

fn swapping(scene: &Scene<'_>, swap: &Swap<'_>) -> Diagnostic {
    let [first, second] = swap.modes.map(|mode| &mode.symbol.name);
    let noise = swap.noisy.iter().map(|sensor| {
        let sensor = &scene.program.sensors[*sensor];
        format!("`{}` has a noise of {}", sensor.symbol.name, sensor.unit.show(sensor.noise))
    });
    let shown = swap.readings.each_ref().map(|readings| named_readings(scene.program, readings));
    let message = format!("noise alone can drive `{first}` and `{second}` to and fro on every tick");
    Diagnostic::new(&rules::SWAPPING_MODES, swap.exits[1].span, message)
        .here("holds whenever the other does not")
        .label(swap.exits[0].span, "the other")
        .note(format!("to `{second}` with {}; to `{first}` with {}", shown[0], shown[1]))
        .note(format!("between them the noise decides: {}", noise.collect::<Vec<_>>().join(", ")))
        .help("leave a gap between the conditions, give the event a `hysteresis`, or let one condition be `held`")
}
