//! Readings around which both sides of an event are equally strong.

use super::{HEALTHY, Subject, degree};
use crate::analysis::network::Witness;
use crate::base::Fraction;
use crate::diag::{Diagnostic, rules};

/// Rules that are left out are needless, and no reason for a tie.
pub(super) fn check(subject: &Subject<'_>, left_out: &[usize], findings: &mut Vec<Diagnostic>) {
    // With hysteresis the flag stays as it is where the sides are alike, which is what hysteresis is for.
    if subject.has_hysteresis() || !subject.facts.tie.is_possible() || subject.is_large() {
        return;
    }
    if let Some(witness) = subject.model.tie_region(subject.index, &HEALTHY, left_out) {
        findings.push(tie(subject, &witness));
    }
}

fn tie(subject: &Subject<'_>, witness: &Witness) -> Diagnostic {
    let strengths = subject.strengths(witness);
    let (strongest, _) = subject.sides(&strengths);
    // Rules that hold more than not contradict each other; those that hold little often fade into one another.
    let rule = if strongest > Fraction::new(1, 2) { &rules::TIE } else { &rules::WEAK_TIE };
    let message = format!("both sides of `{}` are equally strong around some readings", subject.name());
    let mut diagnostic = Diagnostic::new(rule, subject.event.symbol.span, message);
    let mut strongest_rules = (0..strengths.len()).filter(|&rule| strengths[rule] == strongest);
    let contributor = strongest_rules.next();
    let detractor = strongest_rules.find(|&rule| !subject.contributes(rule));
    for rule in contributor.into_iter().chain(detractor) {
        diagnostic = diagnostic.label(subject.rule(rule).span, format!("{} there", degree(&strongest)));
    }
    diagnostic
        .note(format!("for instance at {}, and for all readings near these", subject.at(witness)))
        .note("a tie leaves the flag clear")
        .help("let another rule decide there, or leave out of one of the rules what limits both")
}
