//! A transition whose condition always holds hides those below it.

use super::Subject;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let below = subject.mode.transitions.get(subject.index + 1);
    let is_inhibited = |target| !subject.diagram.modes[target].requires.is_empty();
    let always = subject.exit().holds && !subject.exit().fails;
    match below {
        Some(_) if always && !subject.transition().target.is_some_and(is_inhibited) => {
            findings.push(always_true(subject));
            true
        }
        _ => false,
    }
}

fn always_true(subject: &Subject<'_>) -> Diagnostic {
    let transition = subject.transition();
    let below = &subject.mode.transitions[subject.index + 1..];
    let message = format!("the condition of the transition to {} always holds", subject.to());
    let mut diagnostic = Diagnostic::new(&rules::CONDITION_ALWAYS_TRUE, subject.condition_span(transition), message)
        .here("true on every tick")
        .note("the transition of the highest priority whose condition holds is taken");
    for hidden in below.iter().take(3) {
        diagnostic = diagnostic.label(hidden.span, "never tried");
    }
    diagnostic.help("give it the lowest priority, or a condition that can fail")
}
