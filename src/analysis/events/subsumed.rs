//! A rule that a wider one says already.

use super::Subject;
use super::redundant::Written;
use crate::diag::{Diagnostic, rules};

pub(super) fn subsumed(subject: &Subject<'_>, group: &Written, other: usize) -> Diagnostic {
    let message = format!("a wider {} rule of `{}` says all that this one says", subject.side(other), subject.name());
    Diagnostic::new(&rules::SUBSUMED_RULE, group.span, message)
        .here("never stronger than the wider one")
        .label(subject.rule(other).span, "each of its cells takes these terms too, and more")
        .note("a side is as strong as its strongest rule")
        .help("take it out, or make the wider rule narrower")
}
