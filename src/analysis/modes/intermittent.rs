//! Two modes that a failure which comes and goes drives to and fro.

use std::collections::BTreeSet;

use super::dwell::Gates;
use super::examined::reported;
use super::faults::{Fault, FaultSet};
use super::formula::Formula;
use super::fusion::Readings;
use super::ticks::{Scene, Tick, decided};
use super::{Examined, named_readings};
use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Mode, Sensor, Transition};

/// More readings than this are not tried.
const MOST_READINGS: usize = 1 << 6;

/// A mode that is left as soon as a sensor is known to have failed, for one that leads back as soon as it has not.
struct Flicker<'a> {
    left: &'a Mode,
    entered: &'a Mode,
    back: &'a Transition,
    sensor: Id<Sensor>,
    /// What the sensors read that have not failed.
    readings: Readings,
}

/// Tells of pairs of modes that follow each other at once, at readings that stay, whenever one sensor fails or recovers.
pub(super) fn check(scene: &Scene<'_>, modes: &[Option<Examined>], findings: &mut Vec<Diagnostic>) {
    for (id, entered) in scene.diagram.modes.iter() {
        let mut known = BTreeSet::new();
        for back in &entered.transitions {
            let Some(target) = back.target.filter(|target| *target != id && known.insert(*target)) else { continue };
            let left = &scene.diagram.modes[target];
            let leads_here = left.transitions.iter().any(|exit| exit.target == Some(id)) || left.otherwise == Some(id);
            let (true, Some(examined), Some(_)) = (leads_here, &modes[target.index()], &modes[id.index()]) else {
                continue;
            };
            let sensors = reported(scene, left, &examined.formula);
            let flicker =
                sensors.into_iter().find_map(|sensor| flicker(scene, [(target, left), (id, entered)], sensor));
            findings.extend(flicker.map(|flicker| intermittent(scene, &flicker)));
        }
    }
}

fn flicker<'a>(scene: &Scene<'a>, pair: [(Id<Mode>, &'a Mode); 2], sensor: Id<Sensor>) -> Option<Flicker<'a>> {
    let [(left_id, left), (entered_id, entered)] = pair;
    let formula = Formula::new(scene.program, scene.diagram, left.transitions.iter().chain(&entered.transitions))?;
    if formula.looks_back() {
        return None;
    }
    let leads = |tick: &Tick, faults: &FaultSet| {
        let values = formula.values(tick.truth)?;
        let (of_left, of_entered) = formula.roots.split_at(left.transitions.len());
        let exit = |mode: &'a Mode, roots: &[usize]| {
            let open = Gates::new(scene, mode, faults).open;
            let mut exits = mode.transitions.iter().zip(roots.iter().zip(open));
            exits.find(|(_, (root, open))| values[**root] && *open).map(|(exit, _)| exit)
        };
        let lost = Gates::new(scene, left, faults).lost;
        let from_left = lost.or_else(|| exit(left, of_left)?.target);
        Some((from_left, exit(entered, of_entered)))
    };
    let healthy = FaultSet::new();
    for tick in decided(scene, &formula, &healthy)?.into_iter().take(MOST_READINGS) {
        let Some(readings) = &tick.readings else { continue };
        let Some((stays, Some(back))) = leads(&tick, &healthy) else { continue };
        if back.target != Some(left_id) || stays == Some(entered_id) {
            continue;
        }
        // The same readings, and the sensor known to have failed.
        let others = readings.iter().filter(|(other, _)| *other != sensor);
        let mut faults: FaultSet = others.clone().map(|(other, at)| (*other, Fault::Stuck(*at))).collect();
        faults.push((sensor, Fault::Reported));
        faults.sort_unstable();
        let failed = decided(scene, &formula, &faults)?.into_iter().find(|tick| tick.readings.is_some());
        let Some((from_left, from_entered)) = failed.and_then(|tick| leads(&tick, &faults)) else { continue };
        if from_left == Some(entered_id) && from_entered.is_none() {
            let readings = others.copied().collect();
            return Some(Flicker { left, entered, back, sensor, readings });
        }
    }
    None
}

fn intermittent(scene: &Scene<'_>, flicker: &Flicker<'_>) -> Diagnostic {
    let sensor = &scene.program.sensors[flicker.sensor].symbol.name;
    let (left, entered) = (&flicker.left.symbol, &flicker.entered.symbol);
    let message =
        format!("a failure of `{sensor}` that comes and goes drives `{}` and `{}` to and fro", left.name, entered.name);
    let diagnostic = Diagnostic::new(&rules::INTERMITTENT_FAILURE, flicker.back.span, message)
        .here(format!("taken as soon as `{sensor}` has recovered"))
        .label(left.span, format!("left as soon as `{sensor}` is known to have failed"));
    let diagnostic = match &flicker.readings {
        readings if readings.is_empty() => diagnostic,
        readings => diagnostic.note(format!("with {}", named_readings(scene.program, readings))),
    };
    diagnostic.help(format!("let the way back wait, as in `held(not failed({sensor}), 2 s)`"))
}
