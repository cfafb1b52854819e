//! A mode that some transition always leaves on its first tick.

use super::Examined;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Mode, Program};

pub(super) fn check(program: &Program, mode: &Mode, examined: &Examined, findings: &mut Vec<Diagnostic>) {
    if !examined.stay.lasts && !mode.transitions.is_empty() {
        findings.push(left_at_once(program, mode));
    }
}

fn left_at_once(program: &Program, mode: &Mode) -> Diagnostic {
    let message = format!("`{}` is always left on its first tick", mode.symbol.name);
    let mut diagnostic = Diagnostic::new(&rules::LEFT_AT_ONCE, mode.symbol.span, message)
        .here("lasts for one tick")
        .note("a mode is held for at least one tick; its commands are given on that one only");
    for transition in mode.transitions.iter().take(3) {
        let said = if mode.transitions.len() == 1 { "always holds" } else { "one of these always holds" };
        diagnostic = diagnostic.label(program.exprs[transition.condition].span, said);
    }
    diagnostic.help("leave some readings, or some time, for which the mode is meant to last")
}
