//! A run as JSON: the modes it went through, the flags that changed, and what became of what was expected.

use serde::Serialize;

use super::json::{SCHEMA, to_line};
use super::measures::InJson;
use crate::trace::{Trace, seconds};

/// A run and what became of what was expected of it.
#[derive(Debug, Clone)]
pub struct Outcome<'a> {
    /// What happened.
    pub trace: &'a Trace,
    /// What was expected, in the order in which it is written.
    pub expectations: Vec<Verdict<'a>>,
}

/// An expectation and whether it was met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Verdict<'a> {
    /// As written, without `expect`.
    pub text: &'a str,
    /// Whether it was met.
    pub passed: bool,
    /// What happened instead, for people; shown where it was not met.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seen: Option<&'a str>,
}

impl Outcome<'_> {
    /// Whether everything that was expected was seen.
    pub fn passed(&self) -> bool {
        self.expectations.iter().all(|verdict| verdict.passed)
    }
}

#[derive(Serialize)]
struct Run<'a> {
    schema: u32,
    scenario: &'a str,
    seed: u64,
    modes: Vec<Entered<'a>>,
    flags: Vec<Changed<'a>>,
    expectations: Vec<Verdict<'a>>,
    measures: InJson,
}

#[derive(Serialize)]
struct Entered<'a> {
    t: f64,
    mode: &'a str,
}

#[derive(Serialize)]
struct Changed<'a> {
    t: f64,
    flag: &'a str,
    set: bool,
}

/// Renders a run as one JSON object on one line. Times `t` are in seconds; a flag has an entry whenever its value
/// changes, beginning from false; `seen` is there where an expectation was not met. Costs a pass over the flags of
/// all ticks, and what [`Trace::measures`] does.
pub fn run(outcome: &Outcome<'_>) -> String {
    let trace = outcome.trace;
    to_line(&Run {
        schema: SCHEMA,
        scenario: &trace.scenario,
        seed: trace.seed,
        modes: trace.entered().into_iter().map(|(change, mode)| Entered { t: seconds(change.time), mode }).collect(),
        flags: flag_changes(trace),
        expectations: outcome.expectations.iter().map(told).collect(),
        measures: trace.measures().into(),
    })
}

/// A verdict with what was seen only where it matters.
fn told<'a>(verdict: &Verdict<'a>) -> Verdict<'a> {
    Verdict { seen: verdict.seen.filter(|_| !verdict.passed), ..*verdict }
}

/// Every change of every flag, by time, then in the order of the columns.
fn flag_changes(trace: &Trace) -> Vec<Changed<'_>> {
    let mut changes = Vec::new();
    for (flag, column) in trace.flags() {
        let mut before = false;
        for (&time, &value) in trace.times.iter().zip(&column.values) {
            let set = value != 0.0;
            if set != before {
                changes.push((time, Changed { t: seconds(time), flag, set }));
            }
            before = set;
        }
    }
    changes.sort_by_key(|&(time, _)| time);
    changes.into_iter().map(|(_, change)| change).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::samples;
    use crate::trace::{Column, Signal};

    #[test]
    fn a_run_is_one_object_on_one_line() {
        let trace = samples::trace();
        let expectations = samples::verdicts();
        insta::assert_snapshot!(run(&Outcome { trace: &trace, expectations }), @r#"{"schema":1,"scenario":"two_obstacles","seed":1,"modes":[{"t":0.0,"mode":"init"},{"t":2.0,"mode":"forward"},{"t":5.0,"mode":"push"},{"t":8.0,"mode":"stop"},{"t":9.5,"mode":"back_up"}],"flags":[{"t":5.0,"flag":"forward_collision","set":true},{"t":5.5,"flag":"forward_collision","set":false},{"t":8.0,"flag":"forward_collision","set":true},{"t":8.0,"flag":"heavy_obstacle","set":true},{"t":8.25,"flag":"forward_collision","set":false}],"expectations":[{"text":"modes init -> forward -> push -> stop -> back_up","passed":true},{"text":"never heavy_obstacle within 0 s .. 9 s","passed":false,"seen":"heavy_obstacle set at 8 s, in mode stop: contributor 1.00 > detractor 0.00"}],"measures":{"reached":null,"path_length":0.0,"clearance":null,"smoothness":0.0,"time":0.0}}"#);
    }

    #[test]
    fn names_stay_long_where_short_ones_are_ambiguous() {
        let column =
            |name: &str, signal| Column { name: name.to_owned(), unit: "1".to_owned(), signal, values: vec![1.0] };
        let columns = vec![
            column("left.hit", Signal::Event(0)),
            column("right.hit", Signal::Event(1)),
            column("right.near", Signal::Event(2)),
            column("far", Signal::Flag(0)),
        ];
        let trace = Trace { times: vec![0], columns, ..Trace::default() };
        let names: Vec<_> = flag_changes(&trace).iter().map(|change| change.flag).collect();
        assert_eq!(names, ["left.hit", "right.hit", "near", "far"]);
    }

    #[test]
    fn nothing_happened_is_an_object_too() {
        let trace = Trace::default();
        let text = run(&Outcome { trace: &trace, expectations: Vec::new() });
        insta::assert_snapshot!(text, @r#"{"schema":1,"scenario":"","seed":0,"modes":[],"flags":[],"expectations":[],"measures":{"reached":null,"path_length":0.0,"clearance":null,"smoothness":0.0,"time":0.0}}"#);
    }
}
