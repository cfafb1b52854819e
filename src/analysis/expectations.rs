//! Expectations that no run can miss, and windows that no tick of a run lies in.

use std::collections::{BTreeMap, HashMap};

use super::modes::{Conditions, Outcomes};
use crate::base::{FileId, Span, show_time};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Expectation, ExpectationKind, Program, Scenario, Window};

pub(super) fn check(program: &Program, matters: impl Fn(FileId) -> bool, findings: &mut Vec<Diagnostic>) {
    let scenarios = || program.scenarios.values().filter(|scenario| matters(scenario.symbol.span.file));
    let mut known = HashMap::new();
    for scenario in scenarios() {
        let new = || Conditions::new(program, &program.diagrams[scenario.diagram]);
        let conditions = known.entry(scenario.diagram).or_insert_with(new);
        for expectation in &scenario.expectations {
            findings.extend(judge(&program.diagrams[scenario.diagram], conditions, scenario, expectation));
        }
    }
    // A fault that is taken over strikes if it does in any of the scenarios that have it.
    let mut idle: BTreeMap<Span, Option<&Scenario>> = BTreeMap::new();
    for scenario in scenarios() {
        for fault in &scenario.faults {
            let known = idle.entry(fault.span).or_insert(Some(scenario));
            *known = known.filter(|_| !has_tick(scenario, fault.window));
        }
    }
    let idle = idle.into_iter().filter_map(|(span, scenario)| Some((span, scenario?)));
    findings.extend(idle.filter(|(span, _)| matters(span.file)).map(|(span, scenario)| idle_fault(span, scenario)));
}

fn judge(
    diagram: &Diagram,
    conditions: &Conditions<'_>,
    scenario: &Scenario,
    expectation: &Expectation,
) -> Option<Diagnostic> {
    let is_empty = |window: &Window| !has_tick(scenario, *window);
    match &expectation.kind {
        ExpectationKind::Never(_, window) | ExpectationKind::Always(_, window) if is_empty(window) => {
            let finding = never_fails(expectation, "no tick of the run lies in this window");
            Some(finding.label(scenario.symbol.span, ends(scenario)))
        }
        ExpectationKind::Within(_, window) | ExpectationKind::Transition { window, .. } if is_empty(window) => {
            Some(never_met(expectation, scenario))
        }
        ExpectationKind::Never(condition, _) => match conditions.outcomes(*condition)? {
            Outcomes { can_hold: false, .. } => Some(never_fails(expectation, "nothing makes this true")),
            _ => None,
        },
        ExpectationKind::Within(condition, _) | ExpectationKind::Always(condition, _) => {
            match conditions.outcomes(*condition)? {
                Outcomes { can_fail: false, .. } => Some(never_fails(expectation, "this holds whatever is read")),
                _ => None,
            }
        }
        ExpectationKind::Modes(modes) => match modes.as_slice() {
            [only] if diagram.entry == Some(*only) => Some(entry_alone(expectation, diagram)),
            _ => None,
        },
        // A property is judged by itself.
        ExpectationKind::Transition { .. } | ExpectationKind::Claim(_) => None,
    }
}

/// Whether a tick of the run lies in a window.
fn has_tick(scenario: &Scenario, window: Window) -> bool {
    let first = window.from.div_ceil(scenario.tick).saturating_mul(scenario.tick);
    first <= window.to.min(scenario.duration)
}

fn ends(scenario: &Scenario) -> String {
    format!("has a tick every {}, and ends after {}", show_time(scenario.tick), show_time(scenario.duration))
}

fn never_fails(expectation: &Expectation, why: &str) -> Diagnostic {
    let message = format!("`expect {}` can never fail", expectation.text);
    Diagnostic::new(&rules::NEVER_FAILS, expectation.span, message).here(why)
}

fn entry_alone(expectation: &Expectation, diagram: &Diagram) -> Diagnostic {
    let note = format!("a run of `{}` enters it on the first tick", diagram.symbol.name);
    never_fails(expectation, "every run begins like this").note(note).help("name the modes that follow")
}

fn never_met(expectation: &Expectation, scenario: &Scenario) -> Diagnostic {
    let message = format!("`expect {}` can never be met", expectation.text);
    Diagnostic::new(&rules::WINDOW_OUTSIDE_RUN, expectation.span, message)
        .here("no tick of the run lies in this window")
        .label(scenario.symbol.span, ends(scenario))
        .help("move the window into the run, or make the run longer")
}

fn idle_fault(span: Span, scenario: &Scenario) -> Diagnostic {
    Diagnostic::new(&rules::WINDOW_OUTSIDE_RUN, span, format!("this fault never strikes in `{}`", scenario.symbol.name))
        .here("no tick of the run lies in its time")
        .label(scenario.symbol.span, ends(scenario))
        .help("let it begin within the run, or make the run longer")
}
