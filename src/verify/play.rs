//! Plays a run that refutes a property tick by tick, and makes it plainer as long as it still does.

use super::search::{Monitor, Unheard};
use super::told::{Cues, Number, Stretch, readings};
use crate::interp::{Inputs, Machine, Taken};
use crate::ir::Claim;
use crate::plan::Plan;

/// A run that was played.
pub(super) struct Played {
    /// What was told, up to the tick that refutes.
    pub(super) stretches: Vec<Stretch>,
    /// The ticks on which something changed, and the one that refutes.
    pub(super) moments: Vec<Moment>,
    /// When the cause was that found no effect in time, in nanoseconds.
    pub(super) since: Option<u64>,
}

/// A tick on which something changed.
pub(super) struct Moment {
    /// Nanoseconds since the first.
    pub(super) time: u64,
    /// The position of its stretch.
    pub(super) stretch: usize,
    pub(super) taken: Taken,
    /// The mode after it.
    pub(super) mode: u32,
}

/// Plays a run on the machine; `None` where it does not refute the claim.
pub(super) fn play(plan: &Plan, claim: Claim, tick: u64, stretches: &[Stretch]) -> Option<Played> {
    let mut machine = Machine::new(plan, 0);
    let mut monitor = Monitor::default();
    let mut moments = Vec::new();
    let mut time = 0;
    for (index, stretch) in stretches.iter().enumerate() {
        let readings = readings(&stretch.told);
        for number in 0..stretch.ticks {
            let dt = if (index, number) == (0, 0) { 0 } else { tick };
            time += dt;
            let since = monitor.since;
            let taken = machine.step(Inputs { readings: &readings, done: stretch.done }, dt, &mut Unheard);
            let refuted = monitor.sees(claim, plan, &machine, time);
            if number == 0 || taken != Taken::Stayed || refuted || monitor.since != since {
                moments.push(Moment { time, stretch: index, taken, mode: machine.mode() });
            }
            if refuted {
                let mut stretches = stretches[..=index].to_vec();
                stretches[index].ticks = number + 1;
                return Some(Played { stretches, moments, since: monitor.since });
            }
        }
    }
    None
}

/// Rounded numbers are tried in runs of at most so many ticks.
const MOST_TICKS: u64 = 1 << 14;

/// Lets readings stay as they were before, or be rounder, wherever the run still refutes the claim.
pub(super) fn simplify(plan: &Plan, claim: Claim, tick: u64, cues: &Cues, mut found: Played) -> Played {
    let mut index = 0;
    while index < found.stretches.len() {
        for sensor in 0..cues.rest.len() {
            let ticks: u64 = found.stretches.iter().map(|stretch| stretch.ticks).sum();
            let before = index.checked_sub(1).map_or(&cues.rest, |before| &found.stretches[before].told)[sensor];
            let now = found.stretches.get(index).and_then(|stretch| stretch.told[sensor]);
            let rounder = now.into_iter().flat_map(|number| rounder(number, plan, sensor));
            let choices = std::iter::once(before).chain(rounder.map(Some));
            for choice in choices.take_while(|choice| *choice != now && ticks <= MOST_TICKS) {
                let mut stretches = found.stretches.clone();
                stretches[index].told[sensor] = choice;
                if let Some(played) = play(plan, claim, tick, &stretches) {
                    found = played;
                    break;
                }
            }
        }
        index += 1;
    }
    let merged = merge(&found.stretches);
    play(plan, claim, tick, &merged).unwrap_or(found)
}

/// The same number with fewer digits, the fewest first.
fn rounder(number: Number, plan: &Plan, sensor: usize) -> Vec<Number> {
    let unit = &plan.inputs[sensor].unit;
    let size = number.written.abs().log10().floor();
    let rounded = |digits: i32| {
        // Powers of ten are exact, their inverses are not.
        let power = digits - 1 - size as i32;
        let step = 10_f64.powi(power.abs());
        let written = number.written;
        Number::new(if power < 0 { (written / step).round() * step } else { (written * step).round() / step }, unit)
    };
    if size.is_finite() { (1..=4).filter_map(rounded).collect() } else { Vec::new() }
}

/// Stretches that tell the same are one.
fn merge(stretches: &[Stretch]) -> Vec<Stretch> {
    let mut merged: Vec<Stretch> = Vec::new();
    for stretch in stretches {
        match merged.last_mut() {
            Some(last) if (&last.told, last.done) == (&stretch.told, stretch.done) => last.ticks += stretch.ticks,
            _ => merged.push(stretch.clone()),
        }
    }
    merged
}
