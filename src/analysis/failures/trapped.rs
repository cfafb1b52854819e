//! Modes that the machine could leave, and cannot once some sensors have failed.

use super::words::list;
use super::{Family, Subject};
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) {
    for family in subject.families(|effect| &effect.traps) {
        findings.push(trapped(subject, &family));
    }
}

fn trapped(subject: &Subject<'_>, family: &Family<'_>) -> Diagnostic {
    let modes = &subject.diagram.modes;
    let names = family.modes.iter().map(|mode| modes[*mode].symbol.name.as_str());
    let message = format!("the machine can never leave {}", list(names, "and"));
    let place = family.exits.first().map(|(mode, _)| modes[*mode].symbol.span).unwrap_or_default();
    let mut diagnostic = subject.finding(&rules::TRAPPED_BY_FAILURE, family, place, &message);
    let is_unsafe = |effect: &super::Effect| {
        family.sets.contains(&&effect.faults)
            && family.modes.iter().all(|mode| effect.unsafe_modes.modes.contains(mode))
    };
    if subject.effects.iter().any(is_unsafe) {
        diagnostic = diagnostic.note("neither a `final` mode nor the entry can be reached from there");
    }
    diagnostic.help("give a mode a way out that does without the sensor, such as `after`")
}
