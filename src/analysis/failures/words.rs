//! Sets of failed sensors in words.

use std::collections::BTreeMap;

use crate::analysis::modes::Fault;
use crate::base::{Exact, Unit};

/// A failed sensor, or a failed input of a network on its own.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::analysis) struct Failed<'a> {
    pub(in crate::analysis) name: &'a str,
    pub(in crate::analysis) unit: &'a Unit,
    /// What it could read, in SI: lower end, upper end.
    pub(in crate::analysis) range: (Exact, Exact),
    pub(in crate::analysis) how: Fault,
}

/// More alternatives, or names of a list, than this are counted.
const MOST_SHOWN: usize = 6;

/// What sets of failed sensors have in common, and what each has besides: "`a` failed at 0 N, and `b` or `c` failed at
/// 1 m". The sets are different, and none holds another one.
pub(in crate::analysis) fn failed(sets: &[Vec<Failed<'_>>]) -> String {
    let Some(first) = sets.first() else { return String::new() };
    let common: Vec<_> = first.iter().filter(|failed| sets.iter().all(|set| set.contains(failed))).cloned().collect();
    let rests: Vec<Vec<_>> =
        sets.iter().map(|set| set.iter().filter(|failed| !common.contains(failed)).cloned().collect()).collect();
    let together = |failed: &[Failed<'_>]| by_state(failed, "and");
    let alternatives = match rests.as_slice() {
        [_] => String::new(),
        rests if rests.iter().all(|rest| rest.len() == 1) => by_state(&rests.concat(), "or"),
        rests => {
            let alternatives: Vec<_> = rests.iter().map(|rest| together(rest)).collect();
            joined(&alternatives, ", or ")
        }
    };
    match (common.is_empty(), alternatives.is_empty()) {
        (true, _) => alternatives,
        (_, true) => together(&common),
        _ => format!("{}, and {alternatives}", together(&common)),
    }
}

/// Names in backticks: "`a`, `b` and `c`".
pub(in crate::analysis) fn list<'n>(names: impl IntoIterator<Item = &'n str>, last: &str) -> String {
    let names: Vec<_> = names.into_iter().map(|name| format!("`{name}`")).collect();
    joined(&names, &format!(" {last} "))
}

/// Texts with commas, and something else before the last one.
pub(in crate::analysis) fn joined(texts: &[String], last: &str) -> String {
    match texts {
        [] => String::new(),
        [text] => text.clone(),
        texts if texts.len() > MOST_SHOWN => {
            format!("{}{last}{} others", texts[..MOST_SHOWN].join(", "), texts.len() - MOST_SHOWN)
        }
        [texts @ .., text] => format!("{}{last}{text}", texts.join(", ")),
    }
}

/// Sensors with what is wrong with them, those with which the same is wrong told together.
fn by_state(failed: &[Failed<'_>], last: &str) -> String {
    let mut states: Vec<(&str, Vec<&Failed<'_>>)> = Vec::new();
    for failed in failed {
        match states.iter_mut().find(|(name, _)| *name == failed.name) {
            Some((_, known)) => known.push(failed),
            None => states.push((failed.name, vec![failed])),
        }
    }
    let mut groups: Vec<(String, Vec<&str>)> = Vec::new();
    for (name, of_sensor) in states {
        let state = state(&of_sensor);
        match groups.iter_mut().find(|(known, _)| *known == state) {
            Some((_, names)) => names.push(name),
            None => groups.push((state, vec![name])),
        }
    }
    let groups: Vec<_> = groups.into_iter().map(|(state, names)| format!("{} {state}", list(names, last))).collect();
    joined(&groups, &format!(" {last} "))
}

/// What may be wrong with one sensor. Readings that touch are told as one stretch.
fn state(failed: &[&Failed<'_>]) -> String {
    let Some(Failed { unit, range, .. }) = failed.first() else { return String::new() };
    let mut stretches: BTreeMap<(Exact, Exact), bool> = BTreeMap::new();
    let mut words = Vec::new();
    for failed in failed {
        match failed.how {
            Fault::Stuck(at) => drop(stretches.insert((at, at), true)),
            Fault::Between(from, to) => drop(stretches.insert((from, to), false)),
            Fault::Absent => words.push("absent".to_owned()),
            Fault::Reported => words.push("known to have failed".to_owned()),
        }
    }
    let mut merged: Vec<(Exact, Exact, bool)> = Vec::new();
    for ((from, to), closed) in stretches {
        match merged.last_mut() {
            Some(last) if last.1 == from && (last.2 || closed) => (last.1, last.2) = (to, closed),
            _ => merged.push((from, to, closed)),
        }
    }
    let show = |at: Exact| unit.show(at.to_f64());
    let (points, stretches): (Vec<_>, Vec<_>) = merged.into_iter().partition(|(from, to, _)| from == to);
    if !points.is_empty() {
        let points: Vec<_> = points.into_iter().map(|(at, _, _)| show(at)).collect();
        words.insert(0, format!("failed at {}", joined(&points, " or ")));
    }
    words.extend(stretches.into_iter().map(|(from, to, _)| {
        let is_whole = (from, to) == *range;
        if is_whole { "stuck anywhere".to_owned() } else { format!("stuck between {} and {}", show(from), show(to)) }
    }));
    joined(&words, " or ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(number: i128) -> Exact {
        Exact::new(number, 1, 0)
    }

    fn told(sets: &[&[(&'static str, Fault)]]) -> String {
        let unit = Unit::parse("m").unwrap();
        let range = (number(0), number(10));
        let of = |&(name, how): &(&'static str, Fault)| Failed { name, unit: &unit, range, how };
        failed(&sets.iter().map(|set| set.iter().map(of).collect()).collect::<Vec<_>>())
    }

    const AT_0: Fault = Fault::Stuck(Exact::ZERO);

    #[test]
    fn what_sets_share_is_told_once() {
        assert_eq!(told(&[&[("a", AT_0)]]), "`a` failed at 0 m");
        assert_eq!(told(&[&[("a", AT_0), ("b", AT_0)]]), "`a` and `b` failed at 0 m");
        assert_eq!(told(&[&[("a", AT_0), ("b", Fault::Absent)]]), "`a` failed at 0 m and `b` absent");
        assert_eq!(told(&[&[("a", AT_0)], &[("b", AT_0)], &[("c", AT_0)]]), "`a`, `b` or `c` failed at 0 m");
        let with_c: [&[_]; 2] = [&[("a", AT_0), ("c", Fault::Reported)], &[("b", AT_0), ("c", Fault::Reported)]];
        assert_eq!(told(&with_c), "`c` known to have failed, and `a` or `b` failed at 0 m");
        let pairs: [&[_]; 2] = [&[("a", AT_0), ("b", AT_0)], &[("c", AT_0), ("d", AT_0)]];
        assert_eq!(told(&pairs), "`a` and `b` failed at 0 m, or `c` and `d` failed at 0 m");
    }

    #[test]
    fn stretches_that_touch_are_one() {
        let between = |from, to| Fault::Between(number(from), number(to));
        let at = |reading| Fault::Stuck(number(reading));
        let stuck = |ways: &[Fault]| {
            let sets: Vec<_> = ways.iter().map(|how| [("a", *how)]).collect();
            told(&sets.iter().map(<[_; 1]>::as_slice).collect::<Vec<_>>())
        };
        assert_eq!(stuck(&[at(0), between(0, 3), at(3), between(3, 10), at(10)]), "`a` stuck anywhere");
        assert_eq!(stuck(&[at(0), between(0, 3), at(3)]), "`a` stuck between 0 m and 3 m");
        assert_eq!(
            stuck(&[between(0, 3), between(3, 5)]),
            "`a` stuck between 0 m and 3 m or stuck between 3 m and 5 m"
        );
        assert_eq!(stuck(&[at(0), at(5), Fault::Absent]), "`a` failed at 0 m or 5 m or absent");
    }

    #[test]
    fn long_lists_are_cut() {
        let names = ["a", "b", "c", "d", "e", "f", "g", "h"];
        assert_eq!(list(names, "and"), "`a`, `b`, `c`, `d`, `e`, `f` and 2 others");
        assert_eq!(list(["a", "b"], "or"), "`a` or `b`");
    }
}
