//! A run for people: when it entered which mode, by which transition, and on what evidence.

use std::fmt::Write;
use std::slice;

use super::paint::{Paint, wrap};
use super::run::Outcome;
use crate::trace::{ModeChange, seconds};

/// The narrowest column that evidence may be squeezed into; below that it goes on lines of its own.
const EVIDENCE_WIDTH: usize = 44;
/// The longest condition that the evidence of all others makes room for.
const REASON_WIDTH: usize = 36;
/// What stands before the times.
const INDENT: usize = 4;

/// One change of mode as text.
struct Row<'a> {
    time: String,
    mode: &'a str,
    reason: String,
    evidence: Vec<String>,
}

/// Renders a run as a table that fits into `width` columns, followed by what became of the expectations. `color` adds
/// ANSI escapes. Words that are longer than the width are not broken.
pub fn timeline(outcome: &Outcome<'_>, width: usize, color: bool) -> String {
    let trace = outcome.trace;
    let paint = Paint { color };
    let entered = trace.entered();
    let decimals = decimals(&entered.iter().map(|(change, _)| change.time));
    let rows: Vec<Row<'_>> = entered.into_iter().map(|(change, mode)| row(change, mode, decimals)).collect();
    let mut out = String::new();
    let duration = trace.times.last().map_or(0.0, |&time| seconds(time));
    let (scenario, behavior, robot, seed) = (&trace.scenario, &trace.behavior, &trace.robot, trace.seed);
    let _ = writeln!(out, "{}: {behavior} on {robot}, {duration} s, seed {seed}", paint.bold(scenario));

    let time_width = rows.iter().map(|row| row.time.len()).max().unwrap_or(0);
    let mode_width = rows.iter().map(|row| length(row.mode)).max().unwrap_or(0);
    // One long condition must not push the evidence of all others off the terminal.
    let reasons = rows.iter().filter(|row| !row.evidence.is_empty()).map(|row| length(&row.reason));
    let reason_width = reasons.filter(|&length| length <= REASON_WIDTH).max().unwrap_or(0);
    let mode_at = INDENT + time_width + 2;
    let reason_at = mode_at + mode_width + 2;
    let evidence_at = reason_at + reason_width + 2;
    let beside = width >= evidence_at + EVIDENCE_WIDTH;

    for row in &rows {
        let mode = format!("{:mode_width$}", row.mode);
        let _ = write!(out, "{:INDENT$}{:>time_width$}  {}", "", row.time, paint.bold(&mode));
        let mut at = reason_at;
        if !row.reason.is_empty() {
            let indent = format!("\n{:1$}", "", reason_at + 3);
            let lines = wrap(slice::from_ref(&row.reason), width.saturating_sub(reason_at + 3));
            let _ = write!(out, "  {}", lines.join(&indent));
            at += length(&row.reason);
        }
        if beside && at + 2 <= evidence_at {
            list(&mut out, &row.evidence, at, evidence_at, width);
        } else {
            // A condition that runs into the evidence's column has its evidence start on the next line.
            let start = if beside { evidence_at } else { mode_at + 2 };
            list(&mut out, &row.evidence, usize::MAX, start, width);
        }
    }
    out.push_str(&expectations(outcome, &paint, width));
    // Padding of the last column is of no use to anyone.
    out.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
}

/// Writes evidence from column `start` on, wrapped into `width`, the first line after what already reaches to `at`.
fn list(out: &mut String, evidence: &[String], at: usize, start: usize, width: usize) {
    if evidence.is_empty() {
        out.push('\n');
        return;
    }
    for (index, line) in wrap(evidence, width.saturating_sub(start)).iter().enumerate() {
        if index > 0 || at == usize::MAX {
            let _ = write!(out, "\n{:start$}{line}", "");
        } else {
            let _ = write!(out, "{:1$}{line}", "", start - at);
        }
    }
    out.push('\n');
}

fn row<'a>(change: &ModeChange, mode: &'a str, decimals: usize) -> Row<'a> {
    let reason = match change.priority {
        Some(priority) => format!("{priority}: {}", change.condition),
        None => change.condition.clone(),
    };
    Row {
        time: format!("{:.decimals$} s", seconds(change.time)),
        mode,
        reason,
        evidence: change.evidence.iter().map(ToString::to_string).collect(),
    }
}

/// The decimals that tell all times exactly, from two to six.
fn decimals(times: &(impl Iterator<Item = u64> + Clone)) -> usize {
    let exact = |decimals: u32| times.clone().all(|time| time % 10_u64.pow(9 - decimals) == 0);
    (2..6).find(|&decimals| exact(decimals)).unwrap_or(6) as usize
}

fn expectations(outcome: &Outcome<'_>, paint: &Paint, width: usize) -> String {
    let mut out = String::new();
    let start = INDENT + 8 + 10;
    let room = width.saturating_sub(start).max(20);
    for verdict in &outcome.expectations {
        let text = |from: &str| wrap(&[from.to_owned()], room).join(&format!("\n{:start$}", ""));
        if verdict.passed {
            let indent = format!("\n{:1$}", "", INDENT + 8);
            let lines = wrap(&[verdict.text.to_owned()], width.saturating_sub(INDENT + 8).max(20)).join(&indent);
            let _ = writeln!(out, "{:INDENT$}{}      {lines}", "", paint.good("ok"));
        } else {
            let _ = writeln!(out, "{:INDENT$}{}  expected  {}", "", paint.bad("FAILED"), text(verdict.text));
            if let Some(seen) = verdict.seen {
                let _ = writeln!(out, "{:1$}seen      {2}", "", INDENT + 8, text(seen));
            }
        }
    }
    if out.is_empty() { out } else { format!("\n{out}") }
}

fn length(text: &str) -> usize {
    text.chars().count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::samples;
    use crate::trace::Trace;

    #[test]
    fn a_wide_terminal_has_the_evidence_beside() {
        let (trace, expectations) = (samples::trace(), samples::verdicts());
        insta::assert_snapshot!(timeline(&Outcome { trace: &trace, expectations }, 110, false));
    }

    #[test]
    fn a_narrow_terminal_has_the_evidence_below() {
        let (trace, expectations) = (samples::trace(), samples::verdicts());
        let text = timeline(&Outcome { trace: &trace, expectations }, 64, false);
        assert!(text.lines().all(|line| line.chars().count() <= 64), "{text}");
        insta::assert_snapshot!(text);
    }

    #[test]
    fn every_width_holds_every_word() {
        let (trace, expectations) = (samples::trace(), samples::verdicts());
        let outcome = Outcome { trace: &trace, expectations };
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let all = words(&timeline(&outcome, 500, false));
        for width in 0..200 {
            assert_eq!(words(&timeline(&outcome, width, false)), all, "{width}");
        }
    }

    #[test]
    fn times_show_as_many_decimals_as_they_have() {
        let mut trace = samples::trace();
        let outcome = |trace: &'_ Trace| timeline(&Outcome { trace, expectations: Vec::new() }, 200, false);
        assert!(outcome(&trace).contains(" 2.00 s  forward"));
        trace.changes[1].time += 500_000;
        assert!(outcome(&trace).contains(" 2.0005 s  forward"));
    }

    #[test]
    fn color_marks_what_failed() {
        let (trace, expectations) = (samples::trace(), samples::verdicts());
        let text = timeline(&Outcome { trace: &trace, expectations }, 110, true);
        assert!(text.contains("\u{1b}[1;31mFAILED\u{1b}[0m"));
    }
}
