//! Where one sensor can read while events have some statuses together, whatever the others read.
//!
//! The search of `joint` is asked again and again. Each answer leaves linear inequalities of which all unknowns are
//! eliminated but the place of the sensor in its cell: a stretch of readings. It is then excluded.

use super::joined::{Fed, Feeds};
use super::joint::Search;
use super::model::Model;
use super::witness::Witness;
use crate::analysis::support::{Cut, Interval};
use crate::base::{Exact, Fraction, Id};
use crate::ir::{Program, Sensor};

/// Readings, each sensor once.
type Readings = Vec<(Id<Sensor>, Exact)>;

/// The statuses that events can have together, by what one sensor reads.
pub(in crate::analysis) struct Sweep {
    sensor: Id<Sensor>,
    stretches: Vec<Stretch>,
}

/// Readings of the sensor that is swept at all of which the events can have the same statuses.
struct Stretch {
    set: Vec<bool>,
    readings: Interval,
    /// Readings of the other sensors that do it, where the swept one is at the start, inside and at the end of the
    /// stretch. Between two of these all lie on straight lines.
    others: [(Exact, Readings); 3],
}

/// More stretches than this are not looked into.
const MOST_STRETCHES: usize = 1 << 8;

impl Sweep {
    /// Sweeps the sensor at a position among the feeds. `None` where it gives no reading, where some term is smooth, where
    /// a variable is broken, and where there is too much to look into or a number cannot be kept.
    pub(in crate::analysis) fn new(program: &Program, events: &[Fed<'_>], feeds: &Feeds, swept: usize) -> Option<Self> {
        let model = Model::joined(program, events, feeds)?;
        if model.is_smooth() || feeds[swept].1.is_none() {
            return None;
        }
        let states = vec![0; feeds.len()];
        let mut search = Search::over(&model, &states);
        let order: Vec<_> = (0..search.unknowns()).filter(|unknown| *unknown != swept).chain([swept]).collect();
        let mut stretches = Vec::new();
        while let Some((set, left)) = search.next(&order) {
            let (from, to) = left.last()?;
            let at = |place: &Fraction| {
                let readings = readings(feeds, &search.witness(&left.values_at(place)))?;
                let (swept, others): (Vec<_>, _) =
                    readings.into_iter().partition(|(sensor, _)| *sensor == feeds[swept].0);
                Some((swept.first()?.1, others))
            };
            let others = [at(&from.0)?, at(&from.0.halfway(&to.0))?, at(&to.0)?];
            let cell = search.chosen(swept);
            // A cell of one reading holds it, wherever its place lies.
            let is_point = others[0].0 == others[2].0;
            let readings = (
                Cut { at: others[0].0, after: from.1 && !is_point },
                Cut { at: others[2].0, after: !to.1 || is_point },
            );
            search.exclude(&set, (swept, cell), (&from, &to));
            stretches.push(Stretch { set, readings, others });
            if stretches.len() > MOST_STRETCHES {
                return None;
            }
        }
        Some(Self { sensor: feeds[swept].0, stretches })
    }

    /// The statuses that the events can have together while the swept sensor reads within an interval, each once, with
    /// readings that do it; `None` where a number cannot be kept.
    pub(in crate::analysis) fn within(&self, interval: &Interval) -> Vec<(&[bool], Option<Readings>)> {
        let mut found: Vec<(&[bool], Option<Readings>)> = Vec::new();
        for stretch in &self.stretches {
            let both = (stretch.readings.0.max(interval.0), stretch.readings.1.min(interval.1));
            if both.0 < both.1 && found.iter().all(|(set, _)| *set != stretch.set) {
                found.push((&stretch.set, stretch.at(self.sensor, &both)));
            }
        }
        found.sort_by_key(|(set, _)| *set);
        found
    }
}

impl Stretch {
    /// Readings of all sensors where the swept one reads somewhere between cuts that lie in the stretch.
    fn at(&self, swept: Id<Sensor>, (from, to): &Interval) -> Option<Readings> {
        let is_within = |at: Exact| *from <= Cut::before(at) && Cut::after(at) <= *to;
        let [start, inside, end] = &self.others;
        let (at, others) = if is_within(inside.0) {
            inside.clone()
        } else {
            let at = if from.at == to.at { from.at } else { from.at.between(to.at)? };
            let (low, high) = if at < inside.0 { (start, inside) } else { (inside, end) };
            let share = at.minus(low.0)?.over(high.0.minus(low.0)?)?;
            let on_line = |low: Exact, high: Exact| low.plus(high.minus(low)?.times(share)?);
            let ends = low.1.iter().zip(&high.1);
            let others = ends.map(|((sensor, low), (_, high))| Some((*sensor, on_line(*low, *high)?)));
            (at, others.collect::<Option<_>>()?)
        };
        let mut readings: Readings = others;
        readings.push((swept, at));
        Some(readings)
    }
}

/// A witness by its sensors; those that give no reading have none. `None` where a number cannot be kept.
pub(in crate::analysis) fn readings(feeds: &Feeds, witness: &Witness) -> Option<Readings> {
    let read = feeds.iter().zip(&witness.readings).filter_map(|((sensor, _), read)| Some((*sensor, read.as_ref()?)));
    read.map(|(sensor, read)| Some((sensor, Exact::from_fraction(&read.fraction, read.pi)?))).collect()
}
