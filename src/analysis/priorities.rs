//! Transitions of one mode have different priorities.

use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode, Transition};

pub(super) fn check(diagram: &Diagram, findings: &mut Vec<Diagnostic>) {
    for mode in diagram.modes.values() {
        for pair in mode.transitions.windows(2) {
            if let [first, second] = pair
                && first.priority == second.priority
            {
                findings.push(duplicate_priority(mode, first, second));
            }
        }
    }
}

fn duplicate_priority(mode: &Mode, first: &Transition, second: &Transition) -> Diagnostic {
    let message = format!("two transitions of `{}` have priority {}", mode.symbol.name, first.priority);
    Diagnostic::new(&rules::DUPLICATE_PRIORITY, second.priority_span, message)
        .here("this priority is taken")
        .label(first.priority_span, "first used here")
        .note("when both are set, nothing says which one is taken")
        .help("give each transition of a mode its own number, 1 the highest")
}
