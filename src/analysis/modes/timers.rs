//! A timer that never expires, because the mode never lasts that long.

use super::Subject;
use super::examined::examine;
use crate::base::Span;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let never = !subject.exit().holds && subject.exit().holds_later;
    if never {
        findings.push(if is_restarted(subject) { restarted(subject) } else { never_reached(subject) });
    }
    never
}

/// Whether the time would come if no other transition re-entered the mode.
fn is_restarted(subject: &Subject<'_>) -> bool {
    let mut mode = subject.mode.clone();
    let keeps = |index: &usize| *index == subject.index || !subject.mode.transitions[*index].again;
    let kept: Vec<usize> = (0..mode.transitions.len()).filter(keeps).collect();
    mode.transitions = kept.iter().map(|index| subject.mode.transitions[*index].clone()).collect();
    let exit = kept.iter().position(|index| *index == subject.index);
    exit.zip(examine(subject.scene, &mode)).is_some_and(|(exit, examined)| examined.stay.exits[exit].holds)
}

/// The transitions that can be taken, those that re-enter the mode or the others.
fn taken(subject: &Subject<'_>, again: bool) -> impl Iterator<Item = Span> {
    let exits = subject.mode.transitions.iter().zip(&subject.examined.stay.exits);
    let taken = exits.filter(move |(transition, exit)| exit.taken.is_some() && transition.again == again);
    taken.map(|(transition, _)| subject.condition_span(transition)).take(3)
}

fn never_reached(subject: &Subject<'_>) -> Diagnostic {
    let transition = subject.transition();
    let message = format!("`{}` never lasts until the transition to {}", subject.mode.symbol.name, subject.to());
    let mut diagnostic =
        Diagnostic::new(&rules::TIMER_NEVER_REACHED, subject.condition_span(transition), message)
            .here("never comes true")
            .note("`after` counts from the tick on which the mode was entered; ticks are taken to be shorter than the time between two timers");
    for earlier in taken(subject, false) {
        diagnostic = diagnostic.label(earlier, "leaves the mode before");
    }
    diagnostic.help("make the time shorter than that of the transition that comes first")
}

fn restarted(subject: &Subject<'_>) -> Diagnostic {
    let transition = subject.transition();
    let message = format!("the timer of the transition to {} is always restarted before it ends", subject.to());
    let mut diagnostic =
        Diagnostic::new(&rules::TIMER_RESTARTED, subject.condition_span(transition), message).here("never comes true");
    for earlier in taken(subject, true) {
        diagnostic = diagnostic.label(earlier, "restarts the timer before");
    }
    diagnostic
        .note("`again` enters the mode anew, and `after` counts from the tick on which the mode was entered")
        .help("make the time shorter than that of `again`, or take `again` out")
}
