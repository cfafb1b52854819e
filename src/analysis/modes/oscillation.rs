//! Modes that follow each other round and round while the readings stay as they are, though none is left by time alone.

use super::cycles::{Cycle, Pace, shortest};
use super::ticks::Scene;
use super::{Examined, named_readings, successors};
use crate::analysis::reachability::Graph;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(scene: &Scene<'_>, modes: &[Option<Examined>], findings: &mut Vec<Diagnostic>) {
    let diagram = scene.diagram;
    let Some(entry) = diagram.entry else { return };
    let graph = Graph::new(diagram, |mode| successors(&diagram.modes[mode], modes[mode.index()].as_ref()));
    let reached = graph.reached([entry]);
    for group in graph.groups().iter().filter(|group| group.len() > 1 && reached[group[0].index()]) {
        if let Ok(Some(cycle)) = shortest(scene, group, Pace::Slower) {
            findings.push(oscillation(scene, &cycle));
        }
    }
}

fn oscillation(scene: &Scene<'_>, cycle: &Cycle<'_>) -> Diagnostic {
    let names = cycle.names(scene.diagram);
    let message = format!("{names} follow each other round and round while the readings stay as they are");
    let places: Vec<_> = cycle.steps.iter().map(|step| step.transition.span).collect();
    let mut diagnostic =
        Diagnostic::new(&rules::OSCILLATION, places[0], message).here("holds sooner or later with these readings");
    for place in places.into_iter().skip(1).take(3) {
        diagnostic = diagnostic.label(place, "and so does this");
    }
    diagnostic.note(format!("it goes on with {}", named_readings(scene.program, &cycle.readings)))
}
