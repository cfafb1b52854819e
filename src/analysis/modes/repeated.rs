//! One condition twice in a mode.

use super::Subject;
use crate::diag::{Diagnostic, rules};
use crate::ir::Transition;

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    if subject.exit().taken.is_some() {
        return false;
    }
    let roots = &subject.examined.formula.roots;
    let earlier = (0..subject.index).find(|earlier| roots[*earlier] == roots[subject.index]);
    if let Some(earlier) = earlier {
        findings.push(said_twice(subject, &subject.mode.transitions[earlier]));
    }
    earlier.is_some()
}

fn said_twice(subject: &Subject<'_>, earlier: &Transition) -> Diagnostic {
    let transition = subject.transition();
    let message = format!("the transition to {} has the condition of a higher one", subject.to());
    Diagnostic::new(&rules::SAME_CONDITION_TWICE, subject.condition_span(transition), message)
        .here("never taken")
        .label(subject.condition_span(earlier), format!("{} comes first", super::target_name(subject.diagram, earlier)))
        .note("of two transitions whose conditions hold, the one with the smaller number is taken")
        .help("change one of the conditions, or take one of the transitions out")
}
