//! A timer that never expires, because the mode never lasts that long.

use super::Subject;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let never = !subject.exit().holds && subject.exit().holds_later;
    if never {
        findings.push(never_reached(subject));
    }
    never
}

fn never_reached(subject: &Subject<'_>) -> Diagnostic {
    let transition = subject.transition();
    let message = format!("`{}` never lasts until the transition to {}", subject.mode.symbol.name, subject.to());
    let mut diagnostic =
        Diagnostic::new(&rules::TIMER_NEVER_REACHED, subject.condition_span(transition), message)
            .here("never comes true")
            .note("`after` counts from the tick on which the mode was entered; ticks are taken to be shorter than the time between two timers");
    let taken = |index: &usize| subject.examined.stay.exits[*index].taken.is_some();
    for index in (0..subject.mode.transitions.len()).filter(taken).take(3) {
        let earlier = &subject.mode.transitions[index];
        let does = if earlier.again { "restarts the timer before" } else { "leaves the mode before" };
        diagnostic = diagnostic.label(subject.condition_span(earlier), does);
    }
    diagnostic.help("make the time shorter than that of the transition that comes first")
}
