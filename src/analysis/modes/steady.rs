//! What a mode does while the readings stay as they are.

use super::formula::{Atom, Formula, Past};
use crate::base::Exact;

/// The exit that is taken in the end, and the nanoseconds at which a tick may change something, the last of which takes
/// it. They count from the first tick with these readings: `dwell` after the mode was entered, since when nothing was
/// true that its conditions remember, or where it `is_entered`, on whose last tick anything may have been. Only exits
/// that are `open` are tried.
pub(super) fn exit(
    formula: &Formula,
    truth: u64,
    dwell: u64,
    is_entered: bool,
    open: &[bool],
) -> Option<(usize, Vec<u64>)> {
    let start = Known { last: (!is_entered).then_some(false), ever: Some(false), since: 0, may_be_longer: false };
    let mut nodes = vec![start; formula.nodes.len()];
    let (mut time, mut ticks) = (0, Vec::new());
    loop {
        let mut next: Option<u64> = None;
        let mut is_due = |at: u64| {
            if at > time {
                next = Some(next.map_or(at, |next| next.min(at)));
            }
            at <= time
        };
        let values = formula.known(|atom, values| match &formula.atoms[atom] {
            Atom::After(duration) => Some(is_due(duration.saturating_sub(dwell))),
            Atom::Past(past, of) => {
                let (now, last) = (values[*of], nodes[*of].last);
                let node = nodes[*of].then(now, time);
                match past {
                    Past::Rising => both(now, last.map(|last| !last)),
                    Past::Falling => both(now.map(|now| !now), last),
                    Past::Latched => node.ever,
                    Past::Held(_) if now != Some(true) => both(now, None),
                    Past::Held(duration) if is_due(node.since.saturating_add(*duration)) => Some(true),
                    Past::Held(_) => (!node.may_be_longer).then_some(false),
                }
            }
            Atom::Count(comparison, of, number) => {
                let is_none = nodes[*of].then(values[*of], time).ever == Some(false);
                is_none.then(|| comparison.holds(Exact::ZERO, *number))
            }
            Atom::Open(_) => None,
            _ => Some(truth >> atom & 1 == 1),
        });
        let has_changed = ticks.is_empty() || nodes.iter().zip(&values).any(|(node, value)| node.last != *value);
        let decides =
            (0..).zip(formula.roots.iter().zip(open)).find(|(_, (root, open))| **open && values[**root] != Some(false));
        if has_changed || decides.is_some() {
            ticks.push(time);
        }
        if let Some((exit, (root, _))) = decides {
            return values[*root].map(|_| (exit, ticks));
        }
        for (node, value) in nodes.iter_mut().zip(values) {
            *node = node.then(value, time);
        }
        if !has_changed {
            time = next?;
        }
    }
}

/// What is known of a node after some tick.
#[derive(Clone, Copy)]
struct Known {
    last: Option<bool>,
    /// Whether it was true on any tick since the mode was entered.
    ever: Option<bool>,
    /// Where it is true: since when at least.
    since: u64,
    may_be_longer: bool,
}

impl Known {
    /// What is known after the next tick.
    fn then(self, value: Option<bool>, time: u64) -> Self {
        let ever = match (self.ever, value) {
            (Some(true), _) | (_, Some(true)) => Some(true),
            (Some(false), Some(false)) => Some(false),
            _ => None,
        };
        let (since, may_be_longer) =
            if self.last == Some(true) { (self.since, self.may_be_longer) } else { (time, self.last.is_none()) };
        Self { last: value, ever, since, may_be_longer }
    }
}

fn both(one: Option<bool>, other: Option<bool>) -> Option<bool> {
    match (one, other) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}
