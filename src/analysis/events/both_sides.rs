//! A rule that speaks for an event and against it.

use super::Subject;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Clause, Rule};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let found = findings.len();
    let contributors: Vec<_> = subject.event.contributor.iter().map(|rule| (clauses(rule), rule)).collect();
    for detractor in &subject.event.detractor {
        let said = clauses(detractor);
        if let Some((_, contributor)) = contributors.iter().find(|(other, _)| *other == said) {
            findings.push(on_both_sides(subject, contributor, detractor));
        }
    }
    findings.len() > found
}

/// What a rule says, however it is written.
fn clauses(rule: &Rule) -> Vec<&Clause> {
    let mut clauses: Vec<_> = rule.clauses.iter().collect();
    clauses.sort_unstable();
    clauses.dedup();
    clauses
}

fn on_both_sides(subject: &Subject<'_>, contributor: &Rule, detractor: &Rule) -> Diagnostic {
    let message = format!("the same rule speaks for `{0}` and against it", subject.name());
    Diagnostic::new(&rules::RULE_ON_BOTH_SIDES, detractor.span, message)
        .here("a detractor rule")
        .label(contributor.span, "and a contributor rule")
        .note("on both sides it is equally strong, and a tie leaves the flag clear")
        .help("keep it on the side it belongs to")
}
