//! A rule that is 0 for all readings.

use super::redundant::Written;
use super::{Subject, listed};
use crate::analysis::support::support;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Clause, Variable};

pub(super) fn found(subject: &Subject<'_>, group: &Written, findings: &mut Vec<Diagnostic>) {
    let Some(input) = group.rules.iter().find_map(|&rule| subject.model.silent_input(subject.index, rule)) else {
        return;
    };
    let clauses = group.rules.iter().flat_map(|&rule| &subject.rule(rule).clauses);
    let clauses: Vec<_> = clauses.filter(|clause| clause.input as usize == input).collect();
    let variable = &subject.program.variables[subject.network.inputs[input].variable];
    let is_reported = (subject.matters)(&variable.symbol) && clauses.iter().any(|clause| is_outside(clause, variable));
    if !is_reported {
        findings.push(never_fires(subject, group, input, &clauses, variable));
    }
}

/// Whether the terms of a cell lie outside the range, which was reported where they are declared.
fn is_outside(clause: &Clause, variable: &Variable) -> bool {
    let is_outside = |term: u32| support(&variable.terms[term as usize].shape, variable.range).is_empty();
    clause.any_of.iter().all(|literal| !literal.negated && is_outside(literal.term))
}

fn never_fires(
    subject: &Subject<'_>,
    group: &Written,
    input: usize,
    clauses: &[&Clause],
    variable: &Variable,
) -> Diagnostic {
    let message = format!("this {} rule of `{}` never fires", subject.side(group.rules[0]), subject.name());
    let cell = |clause: &&Clause| {
        let terms = clause.any_of.iter().map(|literal| {
            let not = if literal.negated { "not " } else { "" };
            format!("{not}`{}`", variable.terms[literal.term as usize].symbol.name)
        });
        listed(terms.collect(), "or")
    };
    let cells = clauses.iter().map(cell).collect();
    let [low, high] = [variable.range.0, variable.range.1].map(|end| variable.unit.show(end.to_f64()));
    Diagnostic::new(&rules::RULE_NEVER_FIRES, group.span, message)
        .here(format!("{} is never {}", subject.input(input), listed(cells, "and")))
        .label(variable.symbol.span, format!("for readings from {low} to {high}"))
        .note("a rule is as strong as the smallest degree in it")
        .help("correct the terms, or take the rule out")
}
