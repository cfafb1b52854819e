//! Modes that a machine never gets to if it starts with some sensors failed.

use super::{Family, Subject};
use crate::analysis::modes::Fault;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) {
    // What a failure that is known inhibits or leads away from is meant to be missed.
    let is_silent = |effect: &super::Effect| effect.faults.iter().all(|(_, how)| *how != Fault::Reported);
    let families = subject.families(|effect| if is_silent(effect) { &effect.missed } else { &[] });
    findings.extend(families.iter().filter_map(|family| mode_missed(subject, family)));
}

fn mode_missed(subject: &Subject<'_>, family: &Family<'_>) -> Option<Diagnostic> {
    let mode = &subject.diagram.modes[*family.modes.first()?].symbol;
    let message = format!("the machine never gets to `{}` if it starts", mode.name);
    let (from, _) = family.exits.first()?;
    // A mode taken over stands in another file.
    let place = if subject.diagram.modes[*family.modes.first()?].inherited { *from } else { *family.modes.first()? };
    Some(subject.finding(&rules::MODE_MISSED, family, subject.diagram.modes[place].symbol.span, &message))
}
