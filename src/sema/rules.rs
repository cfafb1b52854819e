//! Inference rules, as rows and in words, to one form: minima over clauses that are maxima over terms.
//!
//! Words may nest `and`, `or` and `not` freely. Minimum and maximum distribute over each other and `1 - x` exchanges
//! them without rounding, so the disjunctive form has bit for bit the strength of what was written.

use super::{Lower, invalid};
use crate::base::Span;
use crate::diag::{self, Diagnostic};
use crate::ir::{Clause, Literal, Network, Rule};
use crate::syntax::ast;

/// The most simple rules one rule in words may stand for.
const MOST_RULES: usize = 4096;

/// A rule's clauses; a rule in words is a disjunction of them.
type Conjunction = Vec<Clause>;

impl Lower<'_> {
    /// The rules of the IR that a written rule stands for; none where it is broken.
    pub(super) fn event_rule(&mut self, rule: &ast::EventRule, network: &Network, over: &[u32]) -> Vec<Rule> {
        match rule {
            ast::EventRule::Row(row) => self.row(row, network, over).into_iter().collect(),
            ast::EventRule::Words { antecedent, span } => {
                self.simple_rules(antecedent, *span, network).unwrap_or_default()
            }
        }
    }

    /// The rules that a rule in words stands for; `None` where it is broken.
    pub(super) fn simple_rules(&mut self, antecedent: &ast::Expr, span: Span, network: &Network) -> Option<Vec<Rule>> {
        let conjunctions = self.words(antecedent, network, false)?;
        if conjunctions.len() > MOST_RULES {
            let message = format!("this rule stands for more than {MOST_RULES} simple ones");
            self.report(invalid(span, message).help("write it as several rules"));
            return None;
        }
        Some(conjunctions.into_iter().map(|clauses| Rule { clauses, span }).collect())
    }

    fn row(&mut self, row: &ast::Row, network: &Network, over: &[u32]) -> Option<Rule> {
        if row.cells.len() != over.len() {
            self.report(row_length(row, network, over));
            return None;
        }
        let mut clauses = Vec::new();
        let mut sound = true;
        for (cell, &input) in row.cells.iter().zip(over) {
            let terms = match &cell.kind {
                ast::CellKind::Omitted => continue,
                ast::CellKind::Any => {
                    let terms = &self.program.variables[network.inputs[input as usize].variable].terms;
                    self.read.extend(terms.iter().map(|term| term.symbol.span));
                    Some((0..terms.len() as u32).collect())
                }
                ast::CellKind::Term(name) => self.terms(std::slice::from_ref(name), network, input),
                ast::CellKind::AnyOf(names) => self.terms(names, network, input),
            };
            match terms {
                Some(terms) => clauses.push(clause(input, &terms, false)),
                None => sound = false,
            }
        }
        sound.then_some(Rule { clauses, span: row.span })
    }

    fn terms(&mut self, names: &[ast::Name], network: &Network, input: u32) -> Option<Vec<u32>> {
        let variable = &self.program.variables[network.inputs[input as usize].variable];
        let (mut terms, mut meant) = (Vec::new(), Vec::new());
        let mut broken = Vec::new();
        let mut sound = true;
        for name in names {
            match super::position(&name.text, variable.terms.iter().map(|term| &term.symbol)) {
                Some(term) => {
                    let declared = variable.terms[term].symbol.span;
                    self.read.insert(declared);
                    meant.push((name.span, declared));
                    terms.push(term as u32);
                }
                // It may be the term that could not be parsed.
                None if variable.incomplete => sound = false,
                None => {
                    sound = false;
                    let known = variable.terms.iter().map(|term| term.symbol.name.as_str());
                    let what = format!("term of `{}`", variable.symbol.name);
                    let diagnostic = self.unknown(name, &what, known);
                    broken.push(diagnostic.label(variable.symbol.span, "the variable of this cell"));
                }
            }
        }
        self.diagnostics.extend(broken);
        for (name, declared) in meant {
            self.refers(name, declared);
        }
        sound.then_some(terms)
    }

    fn words(&mut self, expr: &ast::Expr, network: &Network, negated: bool) -> Option<Vec<Conjunction>> {
        match (&expr.kind, negated) {
            (ast::ExprKind::Not(inner), _) => self.words(inner, network, !negated),
            (ast::ExprKind::And(operands), false) | (ast::ExprKind::Or(operands), true) => {
                let mut all = vec![Vec::new()];
                for operand in self.all_words(operands, network, negated)? {
                    all = all
                        .iter()
                        .flat_map(|left| operand.iter().map(|right| [left.as_slice(), right].concat()))
                        .take(MOST_RULES + 1)
                        .collect();
                }
                Some(all)
            }
            (ast::ExprKind::Or(operands), false) | (ast::ExprKind::And(operands), true) => {
                Some(self.all_words(operands, network, negated)?.into_iter().flatten().collect())
            }
            (ast::ExprKind::Is(subject, names), _) => {
                let is = self.is(subject, names, network)?;
                Some(vec![if negated {
                    is.any_of.iter().map(|literal| clause(is.input, &[literal.term], true)).collect()
                } else {
                    vec![is]
                }])
            }
            _ => {
                self.report(
                    Diagnostic::new(&diag::rules::NOT_A_CONDITION, expr.span, "this is not a statement about an input")
                        .help("write `input is term`, joined by `and`, `or`, `not`"),
                );
                None
            }
        }
    }

    /// All operands, so that each broken one is reported.
    fn all_words(&mut self, operands: &[ast::Expr], network: &Network, negated: bool) -> Option<Vec<Vec<Conjunction>>> {
        let lowered: Vec<_> = operands.iter().map(|operand| self.words(operand, network, negated)).collect();
        lowered.into_iter().collect()
    }

    /// `input is term`, `input is any of {a, b}`
    pub(super) fn is(&mut self, subject: &ast::Expr, names: &[ast::Name], network: &Network) -> Option<Clause> {
        let input = self.subject(subject, network)?;
        Some(clause(input, &self.terms(names, network, input)?, false))
    }

    /// The input of that name; reports what is none.
    pub(super) fn subject(&mut self, subject: &ast::Expr, network: &Network) -> Option<u32> {
        let known = network.inputs.iter().map(|input| input.symbol.name.as_str());
        if let ast::ExprKind::Path(path) = &subject.kind
            && let [name] = path.segments.as_slice()
        {
            let input = super::position(&name.text, network.inputs.iter().map(|input| &input.symbol));
            match input {
                Some(input) => self.refers(name.span, network.inputs[input].symbol.span),
                None => self.report(self.unknown(name, "input of this network", known)),
            }
            return input.map(|input| input as u32);
        }
        self.report(invalid(subject.span, "an input of the network is needed here"));
        None
    }
}

fn clause(input: u32, terms: &[u32], negated: bool) -> Clause {
    let mut any_of: Vec<_> = terms.iter().map(|&term| Literal { term, negated }).collect();
    any_of.sort_unstable();
    any_of.dedup();
    Clause { input, any_of }
}

fn row_length(row: &ast::Row, network: &Network, over: &[u32]) -> Diagnostic {
    let names: Vec<_> = over.iter().map(|&input| network.inputs[input as usize].symbol.name.as_str()).collect();
    let message = format!("this row has {} cells for {} inputs", row.cells.len(), over.len());
    Diagnostic::new(&diag::rules::ROW_LENGTH, row.span, message)
        .note(format!("one cell for each of: {}", names.join(", ")))
        .help("`_` stands for any term, `-` leaves an input out")
}
