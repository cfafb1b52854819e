//! Modes to which transitions lead, of which none is ever taken.

use super::{Examined, successors};
use crate::analysis::reachability::{Graph, written};
use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode};

pub(super) fn check(diagram: &Diagram, modes: &[Option<Examined>], findings: &mut Vec<Diagnostic>) {
    let (Some(entry), false) = (diagram.entry, diagram.incomplete) else { return };
    let drawn = Graph::new(diagram, |mode| written(&diagram.modes[mode])).reached([entry]);
    let live = Graph::new(diagram, |mode| successors(&diagram.modes[mode], modes[mode.index()].as_ref()));
    let reached = live.reached([entry]);
    for (target, mode) in diagram.modes.iter().filter(|(id, _)| drawn[id.index()] && !reached[id.index()]) {
        // Modes behind this one are out of reach for the same reason; they are not reported one by one.
        let dead = ways_in(diagram, target, &reached);
        if !dead.is_empty() {
            findings.push(unreachable_by_guards(mode, &dead));
        }
    }
}

/// The transitions to a mode, from modes that are reached.
fn ways_in(diagram: &Diagram, target: Id<Mode>, reached: &[bool]) -> Vec<crate::base::Span> {
    let from = diagram.modes.iter().filter(|(id, _)| reached[id.index()]);
    let transitions = from.flat_map(|(_, mode)| &mode.transitions);
    transitions.filter(|transition| transition.target == Some(target)).map(|transition| transition.span).collect()
}

fn unreachable_by_guards(mode: &Mode, dead: &[crate::base::Span]) -> Diagnostic {
    let message = format!("no transition to `{}` is ever taken", mode.symbol.name);
    let mut diagnostic =
        Diagnostic::new(&rules::UNREACHABLE_BY_GUARDS, mode.symbol.span, message).here("the machine never gets here");
    for span in dead.iter().take(3) {
        diagnostic = diagnostic.label(*span, "never taken");
    }
    diagnostic.help("see what keeps the transition from being taken")
}
