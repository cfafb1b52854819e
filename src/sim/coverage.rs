//! What the runs of some scenarios went through, and what none of them did.

use std::collections::{BTreeSet, HashSet};

use super::run::Run;
use crate::base::{FileId, Id, Sources, Span};
use crate::ir::{Diagram, Mode, Network, Program, Rule, Scenario, Sense};
use crate::trace::{BehaviorCoverage, Coverage, NetworkCoverage, Part};

/// The coverage of every behavior that was run and every network it senses, and of those that `files` declare.
/// Linear in the changes of mode of all runs and in the size of what is covered.
pub fn coverage(program: &Program, sources: &Sources, files: &[FileId], runs: &[(&Scenario, &Run)]) -> Coverage {
    let behaviors = program.diagrams.iter().filter_map(|(id, diagram)| {
        let runs: Vec<_> = runs.iter().filter(|(scenario, _)| scenario.diagram == id).collect();
        let is_asked = !runs.is_empty() || files.contains(&diagram.symbol.span.file);
        is_asked.then(|| behavior(sources, diagram, &runs))
    });
    let networks = program.networks.iter().filter_map(|(id, network)| {
        let runs: Vec<_> = runs.iter().filter(|(scenario, _)| senses(program, scenario, id).next().is_some()).collect();
        let is_asked = !runs.is_empty() || files.contains(&network.symbol.span.file);
        is_asked.then(|| rules(program, sources, id, &runs))
    });
    Coverage { behaviors: behaviors.collect(), networks: networks.collect() }
}

fn behavior(sources: &Sources, diagram: &Diagram, runs: &[&(&Scenario, &Run)]) -> BehaviorCoverage {
    let changes = || runs.iter().flat_map(|(_, run)| &run.trace.changes);
    let entered: HashSet<u32> = changes().map(|change| change.to).collect();
    let taken: HashSet<_> = changes().map(|change| (change.from, change.priority)).collect();
    let number = |id: Id<Mode>| id.index() as u32;
    let modes = diagram.modes.iter().map(|(id, mode)| {
        let name = mode.symbol.name.clone();
        Part { of: name.clone(), text: name, span: mode.symbol.span, covered: entered.contains(&number(id)) }
    });
    let transitions = diagram.modes.iter().flat_map(|(id, mode)| {
        let of = || mode.symbol.name.clone();
        let covered = |priority| taken.contains(&(Some(number(id)), priority));
        let exits = mode.transitions.iter().map(move |exit| Part {
            of: of(),
            text: on_one_line(sources, exit.span),
            span: exit.span,
            covered: covered(Some(exit.priority)),
        });
        let otherwise = mode.otherwise.map(|target| Part {
            of: of(),
            text: format!("else -> {}", diagram.modes[target].symbol.name),
            span: mode.symbol.span,
            covered: covered(None),
        });
        exits.chain(otherwise).collect::<Vec<_>>()
    });
    BehaviorCoverage {
        name: diagram.symbol.name.clone(),
        scenarios: runs.len(),
        modes: modes.collect(),
        transitions: transitions.collect(),
    }
}

/// The senses of a scenario's behavior that are of a network, each with the position of its first event in the plan.
fn senses<'a>(
    program: &'a Program,
    scenario: &Scenario,
    network: Id<Network>,
) -> impl Iterator<Item = (usize, &'a Sense)> {
    let mut next = 0;
    let senses = program.diagrams[scenario.diagram].senses.iter().map(move |sense| {
        let first = next;
        next += program.networks[sense.network].events.len();
        (first, sense)
    });
    senses.filter(move |(_, sense)| sense.network == network)
}

fn rules(program: &Program, sources: &Sources, id: Id<Network>, runs: &[&(&Scenario, &Run)]) -> NetworkCoverage {
    let network = &program.networks[id];
    // A rule in words stands for several, all in one place.
    let mut decided: BTreeSet<Span> = BTreeSet::new();
    for (scenario, run) in runs {
        for (first, _) in senses(program, scenario, id) {
            for (event, known) in network.events.iter().zip(run.decided.iter().skip(first)) {
                let sides = [(&event.contributor, &known.0), (&event.detractor, &known.1)];
                let rules = sides.into_iter().flat_map(|(rules, decided)| rules.iter().zip(decided));
                decided.extend(rules.filter(|(_, decided)| **decided).map(|(rule, _)| rule.span));
            }
        }
    }
    let mut known = BTreeSet::new();
    let mut parts = Vec::new();
    for event in &network.events {
        let part = |rule: &Rule| Part {
            of: event.symbol.name.clone(),
            text: on_one_line(sources, rule.span),
            span: rule.span,
            covered: decided.contains(&rule.span),
        };
        let rules = event.contributor.iter().chain(&event.detractor);
        parts.extend(rules.filter(|rule| known.insert(rule.span)).map(part));
    }
    NetworkCoverage { name: network.symbol.name.clone(), scenarios: runs.len(), rules: parts }
}

fn on_one_line(sources: &Sources, span: Span) -> String {
    sources.slice(span).split_whitespace().collect::<Vec<_>>().join(" ").replace(" )", ")")
}
