//! A transition whose condition holds only while its target is inhibited.

use super::Subject;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let (Some(target), false) = (subject.transition().target, subject.exit().taken.is_some()) else { return false };
    let alone = subject.exit().masks.contains(&0);
    let Some(&(_, required)) = subject.diagram.modes[target].requires.first().filter(|_| alone) else { return false };
    let message = format!("{} is inhibited whenever the condition of this transition holds", subject.to());
    findings.push(
        Diagnostic::new(&rules::ALWAYS_INHIBITED, subject.transition().span, message)
            .here("never taken")
            .label(required, "required here")
            .note("a mode cannot be entered while a sensor it requires is known to have failed")
            .help("lead to a mode that does without the sensor"),
    );
    true
}
