//! A condition that cannot hold.

use super::Subject;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let exit = subject.exit();
    let never = exit.fails && !exit.holds && !exit.holds_later;
    if never {
        findings.push(never_true(subject));
    }
    never
}

fn never_true(subject: &Subject<'_>) -> Diagnostic {
    let transition = subject.transition();
    let message = format!("the condition of the transition to {} can never hold", subject.to());
    Diagnostic::new(&rules::CONDITION_NEVER_TRUE, subject.condition_span(transition), message)
        .here("no readings make this true, whatever has failed")
        .help("correct the condition, or take the transition out")
}
