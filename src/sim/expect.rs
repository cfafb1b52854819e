//! Whether a run was what its scenario expects.

use crate::base::Span;
use crate::ir::{self, Claim, ExpectationKind, Window};
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

/// Judges every expectation of a scenario by its trace. `held` says for each condition of the expectations, in order,
/// on which ticks it held. Linear in the ticks for each expectation.
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
            ExpectationKind::Claim(Claim::Never(_)) => never(trace, condition(), Window::WHOLE),
            ExpectationKind::Claim(Claim::Always(_)) => always(trace, condition(), Window::WHOLE),
            ExpectationKind::Claim(Claim::LeadsTo(response)) => {
                leads_to(trace, condition(), condition(), response.within)
            }
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

/// The earliest cause that is not answered yet decides: it is the first to be late.
fn leads_to(trace: &Trace, cause: &[bool], effect: &[bool], within: u64) -> (bool, String) {
    let mut since = None;
    let mut longest = None;
    for ((&time, &cause), &effect) in trace.times.iter().zip(cause).zip(effect) {
        if cause {
            since = since.or(Some(time));
        }
        let Some(start) = since else { continue };
        if effect {
            longest = longest.max(Some(time - start));
            since = None;
        } else if time - start >= within {
            return (false, format!("nothing by {} answered what held at {}", seconds(time), seconds(start)));
        }
    }
    let seen = match (longest, since) {
        (Some(longest), _) => format!("answered after {} at most", seconds(longest)),
        (None, Some(_)) => "not answered by the end, but not late either".to_owned(),
        (None, None) => "nothing to answer".to_owned(),
    };
    (true, seen)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Id;
    use crate::ir::Expectation;
    use crate::sim::fixture::scenario;
    use crate::trace::ModeChange;

    /// A run of three ticks a second apart: `rest`, then from 1 s on `go`, and at 2 s `go` again.
    fn trace() -> Trace {
        let change = |time, from, to| ModeChange {
            time,
            from,
            to,
            priority: None,
            condition: String::new(),
            evidence: Vec::new(),
        };
        Trace {
            times: vec![0, 1_000_000_000, 2_000_000_000],
            modes: vec!["rest".to_owned(), "go".to_owned()],
            mode: vec![0, 1, 1],
            changes: vec![change(0, None, 0), change(1_000_000_000, Some(0), 1), change(2_000_000_000, Some(1), 1)],
            ..Trace::default()
        }
    }

    fn verdict(kind: ExpectationKind, held: &[bool]) -> (bool, String) {
        let expectation = Expectation { text: "text".to_owned(), kind, span: Span::default() };
        let scenario = ir::Scenario { expectations: vec![expectation], ..scenario() };
        let verdict = judge(&scenario, &trace(), &[held.to_vec()]).remove(0);
        (verdict.passed, verdict.seen)
    }

    const fn window(from: u64, to: u64) -> Window {
        Window { from: from * 1_000_000_000, to: to * 1_000_000_000 }
    }

    #[test]
    fn modes_are_a_beginning_of_the_run() {
        let modes =
            |modes: &[u32]| verdict(ExpectationKind::Modes(modes.iter().map(|&mode| Id::new(mode)).collect()), &[]);
        assert_eq!(modes(&[0, 1]), (true, "the run went rest, go, go".to_owned()));
        assert_eq!(modes(&[0, 1, 1]), (true, "the run went rest, go, go".to_owned()));
        assert_eq!(modes(&[1]), (false, "the run went rest, go, go".to_owned()));
        assert!(!modes(&[0, 1, 1, 0]).0);
    }

    #[test]
    fn a_transition_is_taken_within_its_window() {
        let taken = |from, to, window| {
            verdict(ExpectationKind::Transition { from: Id::new(from), to: Id::new(to), window }, &[])
        };
        assert_eq!(taken(0, 1, window(1, 1)), (true, "taken at 1 s".to_owned()));
        assert_eq!(taken(0, 1, window(2, 3)), (false, "taken at 1 s".to_owned()));
        assert_eq!(taken(1, 1, Window::WHOLE), (true, "taken at 2 s".to_owned()));
        assert_eq!(taken(1, 0, Window::WHOLE), (false, "never taken; the run went rest, go, go".to_owned()));
    }

    #[test]
    fn conditions_are_looked_at_on_the_ticks_of_their_window() {
        use ExpectationKind::{Always, Never, Within};
        let (id, held) = (Id::new(0), [false, true, false]);
        assert_eq!(verdict(Within(id, window(0, 1)), &held), (true, "held at 1 s".to_owned()));
        let late = (false, "not held then; first held at 1 s".to_owned());
        assert_eq!(verdict(Within(id, window(2, 9)), &held), late);
        assert_eq!(verdict(Within(id, Window::WHOLE), &[false; 3]), (false, "never held".to_owned()));
        assert_eq!(verdict(Never(id, window(2, 2)), &held), (true, "never held".to_owned()));
        assert_eq!(verdict(Never(id, window(0, 2)), &held), (false, "held at 1 s".to_owned()));
        assert_eq!(verdict(Always(id, window(1, 1)), &held), (true, "always held".to_owned()));
        assert_eq!(verdict(Always(id, window(1, 2)), &held), (false, "did not hold at 2 s".to_owned()));
    }

    #[test]
    fn every_cause_is_answered_in_time() {
        let answer = |cause: [bool; 3], effect: [bool; 3], within: u64| {
            let response = ir::Response { cause: Id::new(0), effect: Id::new(1), within: within * 1_000_000_000 };
            let kind = ExpectationKind::Claim(Claim::LeadsTo(response));
            let expectation = Expectation { text: String::new(), kind, span: Span::default() };
            let scenario = ir::Scenario { expectations: vec![expectation], ..scenario() };
            let verdict = judge(&scenario, &trace(), &[cause.to_vec(), effect.to_vec()]).remove(0);
            (verdict.passed, verdict.seen)
        };
        let (never, first, last) = ([false; 3], [true, false, false], [false, false, true]);
        assert_eq!(answer(never, never, 1), (true, "nothing to answer".to_owned()));
        assert_eq!(answer([true; 3], [true; 3], 1), (true, "answered after 0 s at most".to_owned()));
        // On the tick of the limit it is still in time.
        assert_eq!(answer(first, last, 2), (true, "answered after 2 s at most".to_owned()));
        assert_eq!(answer(first, last, 1), (false, "nothing by 1 s answered what held at 0 s".to_owned()));
        assert_eq!(answer(first, never, 3), (true, "not answered by the end, but not late either".to_owned()));
        // The earliest cause counts, and one answer is for all.
        assert!(!answer([true; 3], never, 2).0);
        assert!(answer([true, true, false], last, 2).0);
        assert!(!answer([true, true, false], first, 1).0);
    }

    #[test]
    fn conditions_belong_to_the_expectations_that_have_one() {
        let expectation = |kind| Expectation { text: String::new(), kind, span: Span::default() };
        let expectations = vec![
            expectation(ExpectationKind::Never(Id::new(0), Window::WHOLE)),
            expectation(ExpectationKind::Modes(vec![Id::new(0)])),
            expectation(ExpectationKind::Always(Id::new(1), Window::WHOLE)),
        ];
        let scenario = ir::Scenario { expectations, ..scenario() };
        let verdicts = judge(&scenario, &trace(), &[vec![false; 3], vec![true; 3]]);
        assert!(verdicts.iter().all(|verdict| verdict.passed));
    }
}
