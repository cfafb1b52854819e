//! Readings around which no rule of an event fires.

use super::Subject;
use crate::analysis::network::Witness;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) {
    // Where nothing can speak against an event, nothing fires wherever it is clear.
    if subject.event.detractor.is_empty() || !subject.facts.dead.is_possible() || subject.is_large() {
        return;
    }
    if let Some(witness) = subject.model.dead_region(subject.index, &super::HEALTHY) {
        findings.push(dead_zone(subject, &witness));
    }
}

fn dead_zone(subject: &Subject<'_>, witness: &Witness) -> Diagnostic {
    let message = format!("no rule of `{}` fires around some readings", subject.name());
    let rule = if subject.has_hysteresis() { "the flag then stays as it is" } else { "the flag is then clear" };
    Diagnostic::new(&rules::DEAD_ZONE, subject.event.symbol.span, message)
        .note(format!("for instance at {}, and for all readings near these", subject.at(witness)))
        .note(rule)
}
