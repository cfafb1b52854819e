//! What ways are measured by, for comparison: a table in Markdown, and in JSON as a part of a run.

use std::fmt::Write as _;

use serde::Serialize;

use crate::trace::Measures;

/// The runs of one scenario with several seeds.
#[derive(Debug, Clone)]
pub struct Measured<'a> {
    /// The scenario.
    pub scenario: &'a str,
    /// The behavior it runs.
    pub behavior: &'a str,
    /// Of each run whether everything that was expected was seen, and its measures.
    pub runs: Vec<(bool, Measures)>,
}

/// Renders one row for each scenario: in how many runs everything was seen that was expected, and the goal was reached;
/// then the medians of path length, clearance, smoothness and time. `n log n` in the runs.
pub fn measures_markdown(rows: &[Measured<'_>]) -> String {
    let mut out =
        "| scenario | behavior | passed | reached | path (m) | clearance (m) | smoothness (rad²/s) | time (s) |\n\
                   |---|---|---|---|---|---|---|---|\n"
            .to_owned();
    for Measured { scenario, behavior, runs } in rows {
        let count = |held: &dyn Fn(&(bool, Measures)) -> bool| {
            format!("{} of {}", runs.iter().filter(|run| held(run)).count(), runs.len())
        };
        let passed = count(&|(passed, _)| *passed);
        let has_goal = runs.iter().any(|(_, measures)| measures.reached.is_some());
        let reached = if has_goal { count(&|(_, measures)| measures.reached == Some(true)) } else { "–".to_owned() };
        let middle = |digits: usize, of: &dyn Fn(&Measures) -> Option<f64>| {
            let values = runs.iter().filter_map(|(_, measures)| of(measures)).collect();
            median(values).map_or_else(|| "–".to_owned(), |median| format!("{median:.digits$}"))
        };
        let path = middle(1, &|measures| Some(measures.path_length));
        let clearance = middle(2, &|measures| measures.clearance);
        let smoothness = middle(2, &|measures| Some(measures.smoothness));
        let time = middle(1, &|measures| Some(measures.time));
        let _ = writeln!(
            out,
            "| {scenario} | {behavior} | {passed} | {reached} | {path} | {clearance} | {smoothness} | {time} |"
        );
    }
    out
}

/// The number in the middle, or halfway between the two in the middle.
fn median(mut of: Vec<f64>) -> Option<f64> {
    of.sort_by(f64::total_cmp);
    let (low, high) = (of.get(of.len().checked_sub(1)? / 2)?, of.get(of.len() / 2)?);
    Some(f64::midpoint(*low, *high))
}

/// Measures as JSON has them: m, rad²/s and s; `null` for what there is no goal or nothing to be near for.
#[derive(Serialize)]
pub(super) struct InJson {
    reached: Option<bool>,
    path_length: f64,
    clearance: Option<f64>,
    smoothness: f64,
    time: f64,
}

impl From<Measures> for InJson {
    fn from(Measures { reached, path_length, clearance, smoothness, time }: Measures) -> Self {
        Self { reached, path_length, clearance, smoothness, time }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_has_shares_and_medians() {
        let run = |passed, reached, clearance, time| {
            (passed, Measures { reached, path_length: 10.0 * time, clearance, smoothness: 0.126, time })
        };
        let rows = [
            Measured {
                scenario: "blocked",
                behavior: "navigation",
                runs: vec![
                    run(true, Some(true), Some(0.5), 1.0),
                    run(true, Some(false), Some(0.25), 4.0),
                    run(false, Some(false), Some(2.0), 2.0),
                    run(true, Some(false), Some(1.0), 3.0),
                ],
            },
            Measured { scenario: "empty", behavior: "wander", runs: vec![run(true, None, None, 1.0)] },
        ];
        insta::assert_snapshot!(measures_markdown(&rows), @"
        | scenario | behavior | passed | reached | path (m) | clearance (m) | smoothness (rad²/s) | time (s) |
        |---|---|---|---|---|---|---|---|
        | blocked | navigation | 3 of 4 | 1 of 4 | 25.0 | 0.75 | 0.13 | 2.5 |
        | empty | wander | 1 of 1 | – | 10.0 | – | 0.13 | 1.0 |
        ");
    }
}
