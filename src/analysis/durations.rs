//! Times beside the ticks of the scenarios that run them.

use std::collections::{BTreeMap, BTreeSet};

use super::modes::parts;
use crate::base::{FileId, Id, Span, show_time};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Op, Program, Scenario};

/// Judges the times in the conditions of every diagram that some scenario runs, and the durations of scenarios. One
/// finding for each time, beside the first scenario that gives rise to it.
pub(super) fn check(program: &Program, matters: impl Fn(FileId) -> bool, findings: &mut Vec<Diagnostic>) {
    let mut runs: BTreeMap<(Id<Diagram>, u64), &Scenario> = BTreeMap::new();
    for scenario in program.scenarios.values() {
        runs.entry((scenario.diagram, scenario.tick)).or_insert(scenario);
        if !scenario.duration.is_multiple_of(scenario.tick) && matters(scenario.symbol.span.file) {
            findings.push(cut_short(scenario));
        }
    }
    // A time that is taken over stands in several diagrams.
    let mut below: BTreeMap<Span, (u64, &Scenario)> = BTreeMap::new();
    let mut between = below.clone();
    for (&(diagram, tick), scenario) in &runs {
        for (span, duration) in times(program, &program.diagrams[diagram]) {
            if duration < tick {
                below.entry(span).or_insert((duration, scenario));
            } else if !duration.is_multiple_of(tick) {
                between.entry(span).or_insert((duration, scenario));
            }
        }
    }
    between.retain(|span, _| !below.contains_key(span));
    let found = below.iter().map(|(span, (duration, scenario))| below_tick(*span, *duration, scenario));
    let found =
        found.chain(between.iter().map(|(span, (duration, scenario))| between_ticks(*span, *duration, scenario)));
    findings.extend(found.filter(|finding| matters(finding.span().file)));
}

/// The times above 0 in a diagram's conditions, in nanoseconds, with the places of the conditions they stand in.
fn times(program: &Program, diagram: &Diagram) -> BTreeSet<(Span, u64)> {
    let of_transitions = diagram.modes.values().flat_map(|mode| &mode.transitions).map(|exit| exit.condition);
    let of_flags = diagram.flags.values().map(|flag| flag.condition);
    let conditions = of_transitions.chain(of_flags).flat_map(|root| parts(program, root));
    let time = |id| match program.exprs[id].op {
        Op::After(duration) | Op::Held(_, duration) if duration > 0 => Some((program.exprs[id].span, duration)),
        _ => None,
    };
    conditions.filter_map(time).collect()
}

fn below_tick(span: Span, duration: u64, scenario: &Scenario) -> Diagnostic {
    let (tick, name) = (show_time(scenario.tick), &scenario.symbol.name);
    let message = format!("{} is shorter than a tick of `{name}`", show_time(duration));
    Diagnostic::new(&rules::BELOW_TICK, span, message)
        .here("has passed by the next tick")
        .label(scenario.symbol.span, format!("ticks of {tick}"))
        .note("time is looked at once a tick, and a tick is 10 ms where a scenario does not say")
        .help(format!("make it {tick} or longer, or the tick shorter"))
}

fn between_ticks(span: Span, duration: u64, scenario: &Scenario) -> Diagnostic {
    let end = duration.div_ceil(scenario.tick).saturating_mul(scenario.tick);
    let message = format!("{} ends between two ticks of `{}`", show_time(duration), scenario.symbol.name);
    Diagnostic::new(&rules::BETWEEN_TICKS, span, message)
        .here(format!("has passed on the tick at {}", show_time(end)))
        .label(scenario.symbol.span, format!("ticks of {}", show_time(scenario.tick)))
        .note("time is looked at once a tick, and a tick is 10 ms where a scenario does not say")
}

fn cut_short(scenario: &Scenario) -> Diagnostic {
    let (duration, tick) = (scenario.duration, scenario.tick);
    let message = format!("`{}` lasts {}, which ends between two ticks", scenario.symbol.name, show_time(duration));
    Diagnostic::new(&rules::BETWEEN_TICKS, scenario.symbol.span, message)
        .here(format!("the last tick is at {}", show_time(duration - duration % tick)))
        .note(format!("it has a tick every {}", show_time(tick)))
}
