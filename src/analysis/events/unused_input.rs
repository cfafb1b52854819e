//! An input of a network that no rule names.

use crate::diag::{Diagnostic, rules};
use crate::ir::{Consequent, Network, NetworkInput};

pub(super) fn check(network: &Network, findings: &mut Vec<Diagnostic>) {
    let rules = network.events.iter().flat_map(|event| event.contributor.iter().chain(&event.detractor));
    let cases = network.outputs.iter().flat_map(|output| &output.rules).flat_map(|rule| &rule.cases);
    let values = network.outputs.iter().flat_map(|output| &output.rules).flat_map(|rule| match &rule.consequent {
        Consequent::Linear(linear) => linear.factors.as_slice(),
        Consequent::Term(_) => &[],
    });
    let rules = rules.chain(cases);
    let named: Vec<u32> = rules
        .flat_map(|rule| &rule.clauses)
        .map(|clause| clause.input)
        .chain(values.map(|(input, _)| *input))
        .collect();
    let is_empty = network.events.is_empty() && network.outputs.is_empty();
    for (position, input) in (0..).zip(&network.inputs).filter(|_| !is_empty) {
        if !named.contains(&position) {
            findings.push(unused_input(network, input));
        }
    }
}

fn unused_input(network: &Network, input: &NetworkInput) -> Diagnostic {
    let message = format!("no rule of `{}` names its input `{}`", network.symbol.name, input.symbol.name);
    Diagnostic::new(&rules::UNUSED_INPUT, input.symbol.span, message)
        .note("whatever senses through the network needs a sensor for each of its inputs")
        .help("take it out, or say in a rule what it is for")
}
