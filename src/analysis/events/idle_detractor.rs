//! A detractor rule where nothing would set the flag anyway.

use super::Subject;
use super::redundant::Written;
use crate::diag::{Diagnostic, rules};

pub(super) fn idle(subject: &Subject<'_>, group: &Written) -> Diagnostic {
    let message = format!("without this detractor rule `{}` would be set for the same readings", subject.name());
    Diagnostic::new(&rules::IDLE_DETRACTOR, group.span, message)
        .note("it may still be worth reading: it says what the event is not")
}
