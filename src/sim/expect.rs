//! Whether a run was what its scenario expects.

use crate::base::Span;
use crate::ir::{self, ExpectationKind, Window};
use crate::trace::Trace;

/// What became of one expectation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    /// The expectation as written.
    pub text: String,
    /// Whether it was met.
    pub passed: bool,
    /// What was seen, for people: `taken at 8.02 s`.
    pub seen: String,
    /// Where the expectation stands.
    pub span: Span,
}

/// Judges every expectation of a scenario by its trace. `held` says for each expectation that has a condition, in
/// order, on which ticks the condition held. Linear in the ticks for each expectation.
pub fn judge(scenario: &ir::Scenario, trace: &Trace, held: &[Vec<bool>]) -> Vec<Verdict> {
    let mut conditions = held.iter();
    let verdicts = scenario.expectations.iter().map(|expectation| {
        let mut condition = || conditions.next().map_or(&[][..], Vec::as_slice);
        let (passed, seen) = match &expectation.kind {
            ExpectationKind::Modes(expected) => modes(trace, expected),
            ExpectationKind::Transition { from, to, window } => transition(trace, from.index(), to.index(), *window),
            ExpectationKind::Within(_, window) => within(trace, condition(), *window),
            ExpectationKind::Never(_, window) => never(trace, condition(), *window),
            ExpectationKind::Always(_, window) => always(trace, condition(), *window),
        };
        Verdict { text: expectation.text.clone(), passed, seen, span: expectation.span }
    });
    verdicts.collect()
}

fn modes(trace: &Trace, expected: &[crate::base::Id<ir::Mode>]) -> (bool, String) {
    let went = trace.changes.iter().map(|change| change.to as usize);
    let passed = expected.len() <= trace.changes.len() && went.zip(expected).all(|(to, mode)| to == mode.index());
    (passed, path(trace))
}

fn transition(trace: &Trace, from: usize, to: usize, window: Window) -> (bool, String) {
    let is_it = |from_mode: Option<u32>, to_mode: u32| from_mode == Some(from as u32) && to_mode == to as u32;
    let taken = trace.changes.iter().filter(|change| is_it(change.from, change.to)).map(|change| change.time);
    let times: Vec<u64> = taken.collect();
    if let Some(&time) = times.iter().find(|&&time| window.contains(time)) {
        return (true, format!("taken at {}", seconds(time)));
    }
    match times.as_slice() {
        [] => (false, format!("never taken; {}", path(trace))),
        times => {
            let shown: Vec<String> = times.iter().take(3).map(|&time| seconds(time)).collect();
            let more = if times.len() > 3 { format!(" and {} times more", times.len() - 3) } else { String::new() };
            (false, format!("taken at {}{more}", shown.join(", ")))
        }
    }
}

fn within(trace: &Trace, held: &[bool], window: Window) -> (bool, String) {
    if let Some(time) = first(trace, held, window, true) {
        return (true, format!("held at {}", seconds(time)));
    }
    let seen = match first(trace, held, Window::WHOLE, true) {
        Some(time) => format!("not held then; first held at {}", seconds(time)),
        None => "never held".to_owned(),
    };
    (false, seen)
}

fn never(trace: &Trace, held: &[bool], window: Window) -> (bool, String) {
    match first(trace, held, window, true) {
        Some(time) => (false, format!("held at {}", seconds(time))),
        None => (true, "never held".to_owned()),
    }
}

fn always(trace: &Trace, held: &[bool], window: Window) -> (bool, String) {
    match first(trace, held, window, false) {
        Some(time) => (false, format!("did not hold at {}", seconds(time))),
        None => (true, "always held".to_owned()),
    }
}

/// The first tick of the window on which a condition has the wanted value, in nanoseconds.
fn first(trace: &Trace, held: &[bool], window: Window, wanted: bool) -> Option<u64> {
    let ticks = trace.times.iter().zip(held);
    ticks.filter(|&(&time, &held)| held == wanted && window.contains(time)).map(|(&time, _)| time).next()
}

/// The modes a run went through, for people. Long ones are cut.
fn path(trace: &Trace) -> String {
    let names = trace.changes.iter().map(|change| trace.modes.get(change.to as usize).map_or("?", String::as_str));
    let shown: Vec<&str> = names.take(12).collect();
    let more = if trace.changes.len() > shown.len() { ", ..." } else { "" };
    format!("the run went {}{more}", shown.join(", "))
}

/// A time for people, to the millisecond: `8.02 s`.
fn seconds(nanoseconds: u64) -> String {
    format!("{} s", (nanoseconds as f64 / 1e6).round() / 1e3)
}
