//! A mode has a way out, or says that it has none.

use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode, Transition};

pub(super) fn check(diagram: &Diagram, findings: &mut Vec<Diagnostic>) {
    for mode in diagram.modes.values() {
        match (mode.is_final, mode.transitions.first()) {
            (false, None) if mode.otherwise.is_none() && !mode.incomplete => findings.push(dead_end(mode)),
            (true, Some(transition)) => findings.push(final_with_exit(mode, transition)),
            _ => {}
        }
    }
}

fn dead_end(mode: &Mode) -> Diagnostic {
    let name = &mode.symbol.name;
    Diagnostic::new(&rules::DEAD_END, mode.symbol.span, format!("no transition leaves `{name}`"))
        .help(format!("write `final mode {name}` if the robot is meant to stay in it, or give it a transition"))
}

fn final_with_exit(mode: &Mode, transition: &Transition) -> Diagnostic {
    let message = format!("the final mode `{}` has a transition", mode.symbol.name);
    Diagnostic::new(&rules::FINAL_WITH_EXIT, transition.span, message)
        .label(mode.symbol.span, "declared final here")
        .help("leave out the transition, or the word `final`")
}
