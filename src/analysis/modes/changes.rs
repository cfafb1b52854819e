//! What failed sensors change in a diagram: the exits that are no longer taken, and those that only now are.

use std::collections::{BTreeMap, BTreeSet};

use super::examined::Examined;
use super::fault_sets::fault_sets;
use super::faults::{Fault, FaultSet};
use super::known::Known;
use super::ticks::{Scene, is_fused_alike};
use crate::base::Id;
use crate::ir::{Mode, Sensor};

/// The exits of a mode that can be taken; that one cannot is proved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::analysis) struct Exits {
    /// Of each transition whether it can be taken.
    pub(in crate::analysis) live: Vec<bool>,
    /// Where the machine goes at once because a required sensor has failed; no transition is then tried.
    pub(in crate::analysis) otherwise: Option<Id<Mode>>,
}

/// A set of failed sensors that changes something.
pub(in crate::analysis) struct Change {
    pub(in crate::analysis) faults: FaultSet,
    /// The modes whose exits change, with those they have then.
    pub(in crate::analysis) modes: BTreeMap<Id<Mode>, Exits>,
}

/// What failed sensors change in a diagram.
pub(in crate::analysis) struct Changes {
    /// The exits of every mode while nothing has failed.
    pub(in crate::analysis) healthy: Vec<Exits>,
    /// What changes under each set of failed sensors that changes something, smallest sets first.
    pub(in crate::analysis) under: Vec<Change>,
}

/// A sensor that is compared with very many numbers is not looked at as stuck between them.
const MOST_STRETCHES: usize = 64;

/// What every set of at most `up_to` failed sensors changes, given what is known of some or all modes; without the sets
/// of which nothing is wanted of any mode that they have to do with. Each other set costs the modes that it has to do with.
pub(in crate::analysis) fn changes(
    scene: &Scene<'_>,
    examined: &[Option<Examined>],
    up_to: usize,
    is_wanted: impl Fn(&FaultSet, Id<Mode>) -> bool,
) -> Changes {
    let modes = scene.diagram.modes.iter();
    let known = |(id, mode): (Id<Mode>, _)| Known::new(scene, mode, examined.get(id.index()).and_then(Option::as_ref));
    let mut known: Vec<_> = modes.map(known).collect();
    let mut of_sensor: BTreeMap<Id<Sensor>, Vec<Id<Mode>>> = BTreeMap::new();
    for (mode, known) in scene.diagram.modes.ids().zip(&known) {
        for sensor in known.iter().flat_map(|known| &known.concerning) {
            of_sensor.entry(*sensor).or_default().push(mode);
        }
    }
    let conditions: Vec<_> = known.iter().flatten().map(|known| (&*known.formula, &known.concerning)).collect();
    let sets = fault_sets(scene, &conditions, up_to, MOST_STRETCHES);
    let nothing = FaultSet::new();
    let modes = scene.diagram.modes.values().zip(&mut known);
    let healthy: Vec<_> = modes.map(|(mode, known)| exits(scene, mode, known.as_mut(), &nothing)).collect();
    let mut fused_alike = BTreeMap::new();
    let mut under = Vec::new();
    for faults in sets.into_iter().skip(1) {
        let touched: BTreeSet<_> = faults.iter().flat_map(|(sensor, _)| &of_sensor[sensor]).copied().collect();
        if !touched.iter().any(|mode| is_wanted(&faults, *mode)) {
            continue;
        }
        let mut modes = BTreeMap::new();
        for mode in touched {
            let Some(known) = &mut known[mode.index()] else { continue };
            let seen = known.seen(scene, &faults);
            if !is_untouched(scene, known, &seen, &mut fused_alike) {
                modes.insert(mode, exits(scene, &scene.diagram.modes[mode], Some(known), &seen));
            }
        }
        modes.retain(|mode, exits| *exits != healthy[mode.index()]);
        if !modes.is_empty() {
            under.push(Change { faults, modes });
        }
    }
    Changes { healthy, under }
}

fn exits(scene: &Scene<'_>, mode: &Mode, known: Option<&mut Known<'_>>, faults: &FaultSet) -> Exits {
    match known.and_then(|known| known.stay(scene, faults)) {
        Some(stay) => {
            Exits { live: stay.exits.iter().map(|exit| exit.taken.is_some()).collect(), otherwise: stay.lost }
        }
        None => Exits { live: vec![true; mode.transitions.len()], otherwise: mode.otherwise },
    }
}

/// Events under some faults, and whether they can be set together as ever.
type FusedAlike = BTreeMap<(Vec<(u32, u32)>, FaultSet), bool>;

/// Whether some faults are seen to leave a mode as it is.
fn is_untouched(scene: &Scene<'_>, known: &mut Known<'_>, faults: &FaultSet, fused_alike: &mut FusedAlike) -> bool {
    match (faults.as_slice(), &known.fuses) {
        ([], _) => true,
        ([(_, how)], Some(events)) if *how != Fault::Reported => {
            let alike = || is_fused_alike(scene, events, faults);
            *fused_alike.entry((events.clone(), faults.clone())).or_insert_with(alike)
        }
        ([_], _) => known.is_like_healthy(scene, faults),
        // Under fewer of them the machine may have stayed longer.
        _ => false,
    }
}

impl Exits {
    /// Where a mode leads then.
    pub(in crate::analysis) fn targets<'e>(&'e self, mode: &'e Mode) -> impl Iterator<Item = Id<Mode>> + 'e {
        let live = mode.transitions.iter().zip(&self.live).filter(|(_, live)| **live);
        live.filter_map(|(transition, _)| transition.target).chain(self.otherwise)
    }
}

impl Change {
    /// The exits that are no longer taken, of modes in which the machine stays to try them: each its mode and its
    /// position there.
    pub(in crate::analysis) fn lost(&self, healthy: &[Exits]) -> Vec<(Id<Mode>, usize)> {
        let stays = self.modes.iter().filter(|(_, exits)| exits.otherwise.is_none());
        let lost = stays.flat_map(|(mode, now)| {
            let exits = healthy[mode.index()].live.iter().zip(&now.live).enumerate();
            exits.filter(|(_, (was, is))| **was && !**is).map(|(index, _)| (*mode, index))
        });
        lost.collect()
    }
}

impl Changes {
    /// The exits of a mode under a change.
    pub(in crate::analysis) fn exits<'c>(&'c self, change: &'c Change, mode: Id<Mode>) -> &'c Exits {
        change.modes.get(&mode).unwrap_or_else(|| &self.healthy[mode.index()])
    }
}
