//! A rule without which the flag would always be the same.

use super::redundant::Written;
use super::{Subject, degree};
use crate::base::Fraction;
use crate::diag::{Diagnostic, rules};

pub(super) fn never_decisive(subject: &Subject<'_>, group: &Written, reasons: &[usize]) -> Diagnostic {
    let (rule, name) = (group.rules[0], subject.name());
    let message = format!("this {} rule of `{name}` never makes a difference", subject.side(rule));
    let mut diagnostic = Diagnostic::new(&rules::RULE_NEVER_DECISIVE, group.span, message);
    for &reason in reasons {
        let span = subject.rule(reason).span;
        let does = if subject.contributes(reason) { "speaks for it there" } else { "speaks against it there" };
        if diagnostic.labels.len() <= 3 && diagnostic.labels.iter().all(|label| label.span != span) {
            diagnostic = diagnostic.label(span, does);
        }
    }
    diagnostic.note(instance(subject, rule)).help("take it out, or correct it")
}

/// What happens where the rule is the strongest of its side.
fn instance(subject: &Subject<'_>, rule: usize) -> String {
    let side = subject.side(rule);
    let Some(witness) = subject.rule_facts(rule).strongest.witness() else {
        return format!("some other {side} rule is always at least as strong");
    };
    let mut strengths = subject.strengths(witness);
    let own = std::mem::replace(&mut strengths[rule], Fraction::ZERO);
    let (contributor, detractor) = subject.sides(&strengths);
    let place = format!("it is the strongest {side} rule for instance at {}", subject.at(witness));
    if contributor > detractor {
        format!("{place}; but other rules set the flag there without it")
    } else {
        format!("{place}; but there it is {}, and the detractor is {}", degree(&own), degree(&detractor))
    }
}
