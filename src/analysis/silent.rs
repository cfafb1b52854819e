//! Modes that run a diagram which never commands anything.

use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Program};

pub(super) fn check(diagram: &Diagram, program: &Program, findings: &mut Vec<Diagnostic>) {
    for mode in diagram.modes.values() {
        let Some(run) = mode.runs.filter(|run| is_silent(program, run.diagram)) else { continue };
        let inner = &program.diagrams[run.diagram];
        let message = format!("`{}` never gives a command", inner.symbol.name);
        let diagnostic = Diagnostic::new(&rules::SILENT_LAYER, run.span, message);
        findings.push(
            diagnostic
                .label(inner.symbol.span, "none of its modes calls an action")
                .help(format!("call an action in it, or run something else in `{}`", mode.symbol.name)),
        );
    }
}

/// Whether nothing in a diagram, or inside it, calls an action. Layers are three at most.
fn is_silent(program: &Program, diagram: Id<Diagram>) -> bool {
    let diagram = &program.diagrams[diagram];
    let is_silent = |run: crate::ir::Run| is_silent(program, run.diagram);
    !diagram.incomplete
        && diagram.modes.values().all(|mode| mode.commands().next().is_none() && mode.runs.is_none_or(is_silent))
}
