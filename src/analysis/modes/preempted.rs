//! Transitions of inner layers that an outer layer always forestalls.

use std::collections::BTreeSet;

use super::examined::{concerning, examine};
use super::flat::{Leaf, flatten};
use super::formula::{Atom, Formula};
use super::ticks::Scene;
use crate::base::{Id, Span};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode, Program};

/// Warns of transitions inside the modes of a diagram that are taken where the inner diagram runs by itself, and never
/// here: whenever they could be, the diagram leaves the mode around them. Only modes whose conditions have to do with
/// the outer ones are looked into, so that it costs the sum of the layers where these mind their own business.
pub(in crate::analysis) fn check(program: &Program, id: Id<Diagram>, findings: &mut Vec<Diagnostic>) {
    let diagram = &program.diagrams[id];
    if diagram.modes.values().all(|mode| mode.runs.is_none()) {
        return;
    }
    let Some(flat) = flatten(program, id, &[]) else { return };
    let scene = Scene::new(&flat.program, &flat.program.diagrams[flat.diagram]);
    // What is taken or not in some mode, by the outer mode and by where it stands.
    let (mut dead, mut live): (BTreeSet<(Id<Mode>, Span)>, BTreeSet<_>) = Default::default();
    let leaves: Vec<_> = flat.leaves.iter().zip(scene.diagram.modes.values()).collect();
    for within in leaves.chunk_by(|(one, _), (next, _)| one.path.first() == next.path.first()) {
        let Some(&outer) = within.first().and_then(|(leaf, _)| leaf.path.first()) else { continue };
        let Some(alone) = diagram.modes[outer].runs.and_then(|run| flatten(program, run.diagram, &[])) else {
            continue;
        };
        let alone_scene = Scene::new(&alone.program, &alone.program.diagrams[alone.diagram]);
        for (leaf, mode) in within {
            let named = |depth: usize, index: usize| {
                let place = leaf.exits.iter().position(|from| *from == (depth, Some(index)))?;
                Some((outer, mode.transitions[place].span))
            };
            if !concern_each_other(&scene, leaf, mode) {
                let inner = leaf.exits.iter().filter(|(depth, _)| *depth > 0);
                live.extend(inner.filter_map(|(depth, index)| named(*depth, (*index)?)));
                continue;
            }
            let before = alone.leaves.iter().zip(alone_scene.diagram.modes.values());
            let mut before = before.filter(|(inner, _)| leaf.path[1..] == inner.path);
            let before = before.next().and_then(|(inner, mode)| taken(&alone_scene, inner, mode));
            let here = before.as_ref().and_then(|_| taken(&scene, leaf, mode));
            for (depth, index) in before.unwrap_or_default() {
                let lives = here.as_ref().is_none_or(|here| here.contains(&(depth + 1, index)));
                if lives { &mut live } else { &mut dead }.extend(named(depth + 1, index));
            }
        }
    }
    for (mode, transition) in dead.difference(&live) {
        findings.extend(preempted(program, diagram, *mode, *transition));
    }
}

/// The transitions of a mode that are taken, by layer and position; `None` where there is too much to look into.
fn taken(scene: &Scene<'_>, leaf: &Leaf, mode: &Mode) -> Option<BTreeSet<(usize, usize)>> {
    let examined = examine(scene, mode)?;
    let exits = leaf.exits.iter().zip(&examined.stay.exits).filter(|(_, exit)| exit.taken.is_some());
    Some(exits.filter_map(|((depth, index), _)| Some((*depth, (*index)?))).collect())
}

/// Whether the outermost conditions of a mode can have to do with the others: they look at the same sensors or at the
/// mode itself, or wait no longer.
fn concern_each_other(scene: &Scene<'_>, leaf: &Leaf, mode: &Mode) -> bool {
    let formula = |is_outer: bool| {
        let exits = mode.transitions.iter().zip(&leaf.exits);
        let exits = exits.filter(|(_, (depth, _))| (*depth == 0) == is_outer).map(|(exit, _)| exit);
        Formula::new(scene.program, scene.diagram, exits)
    };
    let Some((outer, inner)) = formula(true).zip(formula(false)) else { return false };
    let sensors = |formula: &Formula| concerning(scene, mode, formula);
    let times = |formula: &Formula| -> Vec<u64> {
        let time = |atom: &Atom| match atom {
            Atom::After(duration) => Some(*duration),
            _ => None,
        };
        formula.atoms.iter().filter_map(time).collect()
    };
    let settled = outer.claimed(0);
    outer.roots.iter().any(|root| settled[*root])
        || !sensors(&outer).is_disjoint(&sensors(&inner))
        || times(&outer).into_iter().min() <= times(&inner).into_iter().max().filter(|_| !times(&outer).is_empty())
}

fn preempted(program: &Program, diagram: &Diagram, mode: Id<Mode>, transition: Span) -> Option<Diagnostic> {
    let mode = &diagram.modes[mode];
    let run = mode.runs?;
    let (outer, inner) = (&diagram.symbol.name, &program.diagrams[run.diagram].symbol.name);
    let message =
        format!("a transition within `{inner}` is never taken here: `{outer}` leaves `{}` first", mode.symbol.name);
    Some(
        Diagnostic::new(&rules::PREEMPTED, run.span, message)
            .label(transition, "never taken here, though it is where nothing runs around it")
            .note("on every tick outer layers choose before inner ones")
            .help("let the outer transition wait for something that leaves room, or leave the inner one out"),
    )
}
