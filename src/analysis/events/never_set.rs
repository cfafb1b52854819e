//! An event that no readings set.

use super::{Question, Subject};
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let never = !subject.facts.set.is_possible();
    // Without a rule that speaks for it, it was reported.
    if never && !subject.event.contributor.is_empty() {
        findings.push(never_set(subject));
    }
    never
}

fn never_set(subject: &Subject<'_>) -> Diagnostic {
    let diagnostic = Diagnostic::new(
        &rules::EVENT_NEVER_SET,
        subject.event.symbol.span,
        format!("`{}` can never be set", subject.name()),
    )
    .here("no readings make its contributor larger than its detractor");
    subject
        .with_proof(diagnostic, Question::Set, "below the contributor and above the detractor")
        .help("correct the rules, or take the event out")
}
