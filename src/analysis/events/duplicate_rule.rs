//! A rule that stands twice on one side of an event.

use super::Subject;
use super::redundant::Written;
use crate::diag::{Diagnostic, rules};

pub(super) fn duplicate(subject: &Subject<'_>, group: &Written, other: usize) -> Diagnostic {
    let message = format!("this {} rule of `{}` is there already", subject.side(other), subject.name());
    Diagnostic::new(&rules::DUPLICATE_RULE, group.span, message)
        .label(subject.rule(other).span, "the same rule")
        .note("a side is as strong as its strongest rule, so a second one adds nothing")
        .help("take it out, or correct what should be different")
}
