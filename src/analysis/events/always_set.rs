//! An event that all readings set.

use super::{Question, Subject};
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let always = !subject.facts.clear.is_possible();
    if always {
        findings.push(always_set(subject));
    }
    always
}

fn always_set(subject: &Subject<'_>) -> Diagnostic {
    let name = subject.name();
    let message = if subject.has_memory() {
        format!("`{name}` is never cleared once it is set")
    } else {
        format!("`{name}` is always set")
    };
    let diagnostic = Diagnostic::new(&rules::EVENT_ALWAYS_SET, subject.event.symbol.span, message)
        .here("all readings make its contributor larger than its detractor");
    let excluded = "at least the contributor and at most the detractor";
    subject.with_proof(diagnostic, Question::Clear, excluded).help("say in a detractor rule what speaks against it")
}
