//! Inputs that the rules of an event name, and on which it does not depend.

use super::Subject;
use crate::diag::{Diagnostic, rules};

/// The inputs that the event could do without.
pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> Vec<usize> {
    // With hysteresis it matters by how much a side is larger.
    if subject.has_hysteresis() {
        return Vec::new();
    }
    let needless = subject.model.needless_inputs(subject.index, subject.network_facts);
    if !needless.is_empty() {
        findings.push(needless_inputs(subject, &needless));
    }
    needless
}

fn needless_inputs(subject: &Subject<'_>, needless: &[usize]) -> Diagnostic {
    let (name, inputs) = (subject.name(), subject.inputs(needless));
    let message = format!("`{name}` does not depend on {inputs}, which its rules name");
    Diagnostic::new(&rules::NEEDLESS_INPUT, subject.event.symbol.span, message)
        .note("without it in the rules the flag would be the same; named in them, a failed sensor can change the flag")
        .help("write `-` in its cells, or name the other inputs with `over`")
}
