//! Modes from which the machine never gets to a safe one again once some sensors have failed.

use std::slice::from_ref;

use super::words::list;
use super::{Family, Subject};
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) {
    // Where the machine is caught, that says more.
    let families = subject.families(|effect| match effect.traps.as_slice() {
        [] => from_ref(&effect.unsafe_modes),
        _ => &[],
    });
    findings.extend(families.iter().map(|family| no_safe_mode(subject, family)));
}

fn no_safe_mode(subject: &Subject<'_>, family: &Family<'_>) -> Diagnostic {
    let modes = &subject.diagram.modes;
    let names = family.modes.iter().map(|mode| modes[*mode].symbol.name.as_str());
    let message = format!("no safe mode can be reached any more from {}", list(names, "or"));
    let place = family.exits.first().map(|(mode, _)| modes[*mode].symbol.span).unwrap_or_default();
    subject
        .finding(&rules::NO_SAFE_MODE, family, place, &message)
        .note("safe are the entry and the `final` modes")
        .help("add a way to one of them that does without the sensor")
}
