//! Continuous outputs.

use super::Lines;
use super::fusion::{clause, shape};
use crate::base::Exact;
use crate::ir::{
    AGGREGATIONS, Consequent, DEFUZZIFIERS, Defuzzifier, IMPLICATIONS, Inference, Network, Output, OutputRule, Program,
    Rest, S_NORMS, Statement, T_NORMS,
};

/// What is chosen, and what is not.
pub(super) fn using(inference: Inference) -> String {
    let Inference { and, or, implication, aggregation, defuzzifier } = inference;
    let defuzzifier = match defuzzifier {
        Defuzzifier::Midpoints(parts) => format!("centroid midpoints {parts}"),
        exact => name(DEFUZZIFIERS, exact).to_owned(),
    };
    let (and, or) = (name(T_NORMS, and), name(S_NORMS, or));
    let (implication, aggregation) = (name(IMPLICATIONS, implication), name(AGGREGATIONS, aggregation));
    format!(
        " using {{ and {and}, or {or}, implication {implication}, aggregation {aggregation}, defuzzify {defuzzifier} }}"
    )
}

fn name<T: Copy + PartialEq>(names: &[(&'static str, T)], of: T) -> &'static str {
    names.iter().find(|(_, known)| *known == of).map_or("", |(name, _)| name)
}

pub(super) fn output(lines: &mut Lines, program: &Program, network: &Network, output: &Output) {
    let unit = output.unit.dimension.si_unit();
    let range = output.range.map_or(String::new(), |(low, high)| format!(" in {low} .. {high}"));
    let default = match output.default {
        None => String::new(),
        Some(Rest::Last) => " default hold".to_owned(),
        Some(Rest::Value(value)) => format!(" default {value}"),
    };
    let body = if output.terms.is_empty() { " = takagi_sugeno" } else { "" };
    lines.add(1, format_args!("output {}: {unit}{range}{default}{body}", output.symbol.name));
    for term in &output.terms {
        lines.add(2, format_args!("{} = {}", term.symbol.name, shape(&term.shape)));
    }
    for rule in &output.rules {
        let weight = if rule.weight == Exact::ONE { String::new() } else { format!(" weight {}", rule.weight) };
        let (antecedent, consequent) = (antecedent(program, network, rule), consequent(network, output, rule));
        lines.add(2, format_args!("rule {antecedent} => {consequent}{weight}"));
    }
}

fn antecedent(program: &Program, network: &Network, rule: &OutputRule) -> String {
    let mut texts: Vec<String> = Vec::new();
    for statement in &rule.antecedent {
        let of = |at: &u32| texts[*at as usize].as_str();
        let joined = |of_these: &[u32], word: &str| {
            format!("({})", of_these.iter().map(of).collect::<Vec<_>>().join(&format!(" {word} ")))
        };
        let text = match statement {
            Statement::Is(of) if rule.antecedent.len() > 1 => format!("({})", clause(program, network, of)),
            Statement::Is(of) => clause(program, network, of),
            Statement::Not(at) => format!("not {}", of(at)),
            Statement::All(of_these) => joined(of_these, "and"),
            Statement::Any(of_these) => joined(of_these, "or"),
        };
        texts.push(text);
    }
    texts.pop().unwrap_or_default()
}

fn consequent(network: &Network, output: &Output, rule: &OutputRule) -> String {
    let name = &output.symbol.name;
    match &rule.consequent {
        Consequent::Term(term) => format!("{name} is {}", output.terms[*term as usize].symbol.name),
        Consequent::Linear(linear) => {
            let input = |at: u32| &network.inputs[at as usize].symbol.name;
            let products = linear.factors.iter().map(|(at, factor)| format!(" + {factor} * {}", input(*at)));
            format!("{name} = {}{}", linear.constant, products.collect::<String>())
        }
    }
}
