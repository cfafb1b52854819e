//! Modes that the machine cannot leave, though they are not final.

use super::{Examined, successors};
use crate::analysis::reachability::{Graph, is_in};
use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode};

pub(super) fn check(diagram: &Diagram, modes: &[Option<Examined>], findings: &mut Vec<Diagnostic>) {
    let (Some(entry), false) = (diagram.entry, diagram.incomplete) else { return };
    let graph = Graph::new(diagram, |mode| successors(&diagram.modes[mode], modes[mode.index()].as_ref()));
    let reached = graph.reached([entry]);
    for group in graph.groups() {
        let ends = group.iter().all(|mode| graph.successors(*mode).all(|target| is_in(&group, target)));
        if ends && reached[group[0].index()] && is_trap(diagram, &group, &reached) {
            findings.push(trap(diagram, &group));
        }
    }
}

/// Whether modes that nothing leaves were not meant to be the last. A mode without transitions says so or was
/// reported. Several modes may go on for ever among themselves, and so may the only one of a diagram; but not where
/// a way out was written, to a mode that is reached.
fn is_trap(diagram: &Diagram, group: &[Id<Mode>], reached: &[bool]) -> bool {
    let mut targets = group.iter().flat_map(|mode| &diagram.modes[*mode].transitions).filter_map(|exit| exit.target);
    match group {
        [mode] if targets.clone().all(|target| target == *mode) => targets.next().is_some() && diagram.modes.len() > 1,
        _ => targets.any(|target| !is_in(group, target) && reached[target.index()]),
    }
}

fn trap(diagram: &Diagram, group: &[Id<Mode>]) -> Diagnostic {
    let modes: Vec<&Mode> = group.iter().map(|mode| &diagram.modes[*mode]).collect();
    let names: Vec<_> = modes.iter().take(5).map(|mode| format!("`{}`", mode.symbol.name)).collect();
    let more = if modes.len() > 5 { format!(" and {} more", modes.len() - 5) } else { String::new() };
    let message = format!("the machine can never leave {}{more}", names.join(", "));
    let mut diagnostic = Diagnostic::new(&rules::TRAP, modes[0].symbol.span, message);
    let leaves = |target: Option<Id<Mode>>| target.is_some_and(|target| !is_in(group, target));
    for transition in modes.iter().flat_map(|mode| &mode.transitions).filter(|exit| leaves(exit.target)).take(3) {
        diagnostic = diagnostic.label(transition.span, "never taken");
    }
    diagnostic
        .note("a mode that the robot is meant to stay in is marked `final`, and has no transitions")
        .help("add a transition that leads on, or correct the one that never does")
}
