//! `_` where it is not the same as leaving the input out.

use super::{HEALTHY, Subject, degree};
use crate::analysis::network::{Verdict, Witness};
use crate::base::Fraction;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Clause, Literal, Rule};

/// Comparing an event with another one takes too long where it names more inputs or has more rules.
const MOST_INPUTS: usize = 4;
const MOST_RULES: usize = 1 << 5;

pub(super) fn check(subject: &Subject<'_>, needless: &[usize], findings: &mut Vec<Diagnostic>) {
    let inputs = subject.named_inputs();
    if subject.has_hysteresis() || inputs.len() > MOST_INPUTS || subject.rule_count() > MOST_RULES {
        return;
    }
    for input in inputs.into_iter().filter(|input| !needless.contains(input)) {
        let terms = subject.program.variables[subject.network.inputs[input].variable].terms.len();
        let is_any = |of: usize, literals: &[Literal]| {
            of == input && literals.len() == terms.max(2) && literals.iter().all(|literal| !literal.negated)
        };
        let names_any = |clause: &Clause| is_any(clause.input as usize, &clause.any_of);
        let mut rules = subject.event.contributor.iter().chain(&subject.event.detractor);
        let Some(rule) = rules.find(|rule| rule.clauses.iter().any(names_any)) else { continue };
        if let Verdict::Possible(witness) =
            subject.model.difference_without(subject.index, subject.network_facts, is_any)
        {
            findings.push(weak_any(subject, input, rule, &witness));
        }
    }
}

fn weak_any(subject: &Subject<'_>, input: usize, rule: &Rule, witness: &Witness) -> Diagnostic {
    let message = format!("`_` for {} limits the rules of `{}`", subject.input(input), subject.name());
    let (contributor, detractor) = subject.sides(&subject.strengths(witness));
    let (now, then) = if contributor > detractor { ("set", "clear") } else { ("clear", "set") };
    let best = subject.model.largest_degree(input, &HEALTHY, witness).unwrap_or(Fraction::ZERO);
    let place = subject.at(witness);
    Diagnostic::new(&rules::WEAK_ANY, rule.span, message)
        .note("`_` is the largest degree of all terms, and may be below 1; `-` leaves the input out")
        .note(format!(
            "for instance at {place}, `_` is {}: the flag is {now}, and with `-` would be {then}",
            degree(&best)
        ))
        .help("write `-` where the input does not matter")
}
