//! Continuous outputs and their rules.

use std::collections::HashMap;

use super::{Lower, invalid, missing_part, position, said_twice, symbol};
use crate::base::{Exact, Span};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Consequent, Statement};
use crate::syntax::ast;

impl Lower<'_> {
    /// An output without its rules.
    pub(super) fn output(&mut self, tree: &ast::Output) -> Option<ir::Output> {
        let unit = self.unit(&tree.unit)?;
        let range = match &tree.range {
            Some(range) => Some(self.range_in(range, &unit)?),
            None => None,
        };
        let terms = match &tree.body {
            ast::OutputBody::TakagiSugeno(_) => Vec::new(),
            ast::OutputBody::Terms(trees) => {
                let terms = self.declared_terms(trees, &unit);
                let is_whole = !self.unparsed.touches(tree.span);
                if range.is_none() {
                    let diagnostic = missing_part(tree.name.span, format!("output `{}` has no range", tree.name.text));
                    self.report(
                        diagnostic
                            .note("a set is taken as far as the values that the output may have")
                            .help(format!("write `{}: {} in 0 .. 10` with its own ends", tree.name.text, unit.text)),
                    );
                } else if terms.is_empty() && is_whole {
                    let diagnostic = missing_part(tree.name.span, format!("output `{}` has no term", tree.name.text));
                    self.report(diagnostic.help("write a line such as `slow = triangle(0, 1, 2)` for each fuzzy set"));
                }
                (range.is_some() && !terms.is_empty()).then_some(terms)?
            }
        };
        let default = match &tree.default {
            None => None,
            Some(ast::OutputDefault::Hold(_)) => Some(ir::Rest::Last),
            Some(ast::OutputDefault::Value(quantity)) => {
                let value = self.quantity_in(quantity, &unit)?;
                if range.is_some_and(|(low, high)| value < low || value > high) {
                    self.report(invalid(quantity.span, "this value lies outside the range of the output"));
                }
                Some(ir::Rest::Value(value))
            }
        };
        Some(ir::Output {
            symbol: symbol(&tree.name, tree.doc.as_ref()),
            unit,
            range,
            default,
            terms,
            rules: Vec::new(),
        })
    }

    /// Adds a rule to every output that it sets. `broken` are the names of outputs that were reported.
    pub(super) fn output_rule(&mut self, tree: &ast::OutputRule, network: &mut ir::Network, broken: &[&str]) {
        let cases = self.simple_rules(&tree.antecedent, tree.span, network);
        let mut antecedent = Vec::new();
        let whole = cases.as_ref().and_then(|_| self.statement(&tree.antecedent, network, &mut antecedent));
        let weight = self.weight(tree);
        let mut seen = HashMap::new();
        for consequent in &tree.consequents {
            let name = &consequent.output;
            if let Some(first) = seen.insert(&name.text, name.span) {
                self.report(said_twice(name.span, first, "this output"));
                continue;
            }
            if broken.contains(&name.text.as_str()) {
                continue;
            }
            let Some(output) = position(&name.text, network.outputs.iter().map(|output| &output.symbol)) else {
                let known = network.outputs.iter().map(|output| output.symbol.name.as_str());
                self.report(self.unknown(name, "output of this network", known));
                continue;
            };
            self.refers(name.span, network.outputs[output].symbol.span);
            let value = self.consequent(consequent, network, &network.outputs[output]);
            if let (Some(consequent), Some(cases), Some(_), Some(weight)) = (value, &cases, whole, weight) {
                let (antecedent, cases) = (antecedent.clone(), cases.clone());
                let rule = ir::OutputRule { antecedent, cases, weight, consequent, span: tree.span };
                network.outputs[output].rules.push(rule);
            }
        }
    }

    fn weight(&mut self, tree: &ast::OutputRule) -> Option<Exact> {
        let Some(number) = &tree.weight else { return Some(Exact::ONE) };
        let weight = self.number(number)?;
        if weight <= Exact::ZERO || weight > Exact::ONE {
            self.report(invalid(number.span, "a weight is above 0 and at most 1"));
            return None;
        }
        Some(weight)
    }

    /// Adds what a sound condition is made of, and answers its own part.
    fn statement(&mut self, expr: &ast::Expr, network: &ir::Network, parts: &mut Vec<Statement>) -> Option<u32> {
        let mut all = |lower: &mut Self, operands: &[ast::Expr]| {
            operands.iter().map(|operand| lower.statement(operand, network, parts)).collect::<Option<Vec<_>>>()
        };
        let part = match &expr.kind {
            ast::ExprKind::Not(inner) => Statement::Not(self.statement(inner, network, parts)?),
            ast::ExprKind::And(operands) => Statement::All(all(self, operands)?),
            ast::ExprKind::Or(operands) => Statement::Any(all(self, operands)?),
            ast::ExprKind::Is(subject, names) => Statement::Is(self.is(subject, names, network)?),
            _ => return None,
        };
        parts.push(part);
        Some(parts.len() as u32 - 1)
    }

    fn consequent(&mut self, tree: &ast::Consequent, network: &ir::Network, output: &ir::Output) -> Option<Consequent> {
        match &tree.value {
            ast::ConsequentValue::Term(name) if output.terms.is_empty() => {
                self.report(wrong_consequent(name.span, output, "has no terms", "a linear expression, as in `= 0.5`"));
                None
            }
            ast::ConsequentValue::Term(name) => {
                let Some(term) = position(&name.text, output.terms.iter().map(|term| &term.symbol)) else {
                    let known = output.terms.iter().map(|term| term.symbol.name.as_str());
                    let diagnostic = self.unknown(name, &format!("term of `{}`", output.symbol.name), known);
                    self.report(diagnostic.label(output.symbol.span, "the output that the rule sets"));
                    return None;
                };
                self.read.insert(output.terms[term].symbol.span);
                self.refers(name.span, output.terms[term].symbol.span);
                Some(Consequent::Term(term as u32))
            }
            ast::ConsequentValue::Linear(expr) if !output.terms.is_empty() => {
                self.report(wrong_consequent(expr.span, output, "is made of sets", "`is` and one of its terms"));
                None
            }
            ast::ConsequentValue::Linear(expr) => self.linear(expr, network, &output.unit).map(Consequent::Linear),
        }
    }

    /// Reports an output that no rule sets.
    pub(super) fn outputs_without_rules(&mut self, network: &ir::Network) {
        for output in network.outputs.iter().filter(|output| output.rules.is_empty()) {
            let name = &output.symbol.name;
            let diagnostic = missing_part(output.symbol.span, format!("no rule sets the output `{name}`"));
            self.report(diagnostic.help(format!("write `rule input is term => {name} is term`")));
        }
    }
}

fn wrong_consequent(span: Span, output: &ir::Output, but: &str, needed: &str) -> Diagnostic {
    let name = &output.symbol.name;
    Diagnostic::new(&diag::rules::WRONG_KIND, span, format!("the output `{name}` {but}"))
        .label(output.symbol.span, "declared here")
        .help(format!("write {needed}"))
}
