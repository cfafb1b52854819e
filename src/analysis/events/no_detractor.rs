//! An event that nothing speaks against.

use super::Subject;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) {
    if subject.event.detractor.is_empty() {
        let message = format!("no rule speaks against `{}`", subject.name());
        findings.push(
            Diagnostic::new(&rules::NO_DETRACTOR, subject.event.symbol.span, message)
                .note("without a detractor the flag is set as soon as a contributor rule is above 0, however little"),
        );
    }
}
