//! Events that imply, equal or exclude each other.

use crate::analysis::network::{Model, NetworkFacts, Relation};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Event, Network};

pub(super) fn check(network: &Network, model: &Model, facts: &NetworkFacts, findings: &mut Vec<Diagnostic>) {
    let relations = model.relations(facts);
    let implies = |one: usize, other: usize| relations.contains(&Relation::Implies(one, other));
    let excludes = |one: usize, other: usize| relations.contains(&Relation::Excludes(one.min(other), one.max(other)));
    let equals = |one: usize, other: usize| implies(one, other) && implies(other, one);
    // What follows from other relations is not said again: not of the later of two equal events, nor by way of a third.
    let is_first = |event: usize| !(0..event).any(|earlier| equals(earlier, event));
    let others =
        |one: usize, other: usize| (0..network.events.len()).filter(move |third| ![one, other].contains(third));
    let implied = |one, other| {
        others(one, other)
            .any(|third| implies(one, third) && implies(third, other) && !equals(one, third) && !equals(third, other))
    };
    let excluded = |one, other| {
        others(one, other).any(|third| {
            implies(one, third) && !equals(one, third) && excludes(third, other)
                || implies(other, third) && !equals(other, third) && excludes(one, third)
        })
    };
    // A flag with memory lags behind its rules, and says nothing of another one.
    let remembers = |event: &Event| !event.hysteresis.is_zero() || event.hold > 0 || event.confirm > 0;
    for relation in &relations {
        let (Relation::Implies(one, other) | Relation::Excludes(one, other)) = *relation;
        let (first, second) = (&network.events[one], &network.events[other]);
        if remembers(first) || remembers(second) {
            continue;
        }
        match relation {
            Relation::Implies(..) if equals(one, other) => {
                if one < other && is_first(one) {
                    findings.push(related(second, first, "is always set together with"));
                }
            }
            _ if !is_first(one) || !is_first(other) => {}
            Relation::Implies(..) if implied(one, other) => {}
            Relation::Excludes(..) if excluded(one, other) => {}
            Relation::Implies(..) => findings.push(related(first, second, "is only ever set together with")),
            Relation::Excludes(..) => findings.push(related(second, first, "is never set together with")),
        }
    }
}

fn related(event: &Event, other: &Event, how: &str) -> Diagnostic {
    let message = format!("`{}` {how} `{}`", event.symbol.name, other.symbol.name);
    Diagnostic::new(&rules::RELATED_EVENTS, event.symbol.span, message).label(other.symbol.span, "the other event")
}
