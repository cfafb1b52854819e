//! What failures do to the modes of a behavior, in words.

use super::summary::{Told, add_smallest};
use crate::analysis::failures::{Effect, View, effects, in_words, joined, list};
use crate::analysis::modes::{self, Changes, Fault, FaultSet, Scene};
use crate::base::Id;
use crate::ir::{Diagram, Mode, Program};

/// What failures that nobody reports do, each with the smallest sets of failed sensors that do it.
pub(super) fn under_failures<'a>(program: &'a Program, diagram: &'a Diagram, up_to: usize, told: &mut Told<'a>) {
    let scene = Scene::new(program, diagram);
    let mut changes = modes::changes(&scene, &[], up_to, |_, _| true);
    changes.under.retain(|change| change.faults.iter().all(|(_, how)| *how != Fault::Reported));
    let effects = effects(diagram, &changes);
    let mut says = Told::default();
    let mut say = |known: Known<'_>, before: &str, after: &str| {
        for (modes, sets) in known {
            let modes = list(modes.iter().map(|mode| diagram.modes[*mode].symbol.name.as_str()), "and");
            says.tell(sets.iter().map(|set| in_words(program, set)).collect(), format!("{before} {modes}{after}"));
        }
    };
    say(traps(&effects), "never leaves", "");
    say(timed(program, diagram, &changes), "leaves", " only when a timer ends");
    say(missed(&effects), "never gets to", " if it starts so");
    for (sets, predicates) in says.groups() {
        told.tell(sets, format!("`{}` {}", diagram.symbol.name, joined(&predicates, ", and ")));
    }
}

type Known<'e> = Vec<(Vec<Id<Mode>>, Vec<&'e FaultSet>)>;

fn traps(effects: &[Effect]) -> Known<'_> {
    let mut known = Vec::new();
    for effect in effects {
        for trap in &effect.traps {
            add_smallest(&mut known, trap.modes.clone(), &effect.faults);
        }
    }
    known
}

fn missed(effects: &[Effect]) -> Known<'_> {
    let mut known = Vec::new();
    for effect in effects {
        for missed in &effect.missed {
            add_smallest(&mut known, missed.modes.clone(), &effect.faults);
        }
    }
    known
}

/// The modes that could be left for what a sensor reads, and then only end with time.
fn timed<'c>(program: &Program, diagram: &Diagram, changes: &'c Changes) -> Known<'c> {
    let views = View::of_modes(program, diagram);
    let mut known = Vec::new();
    for change in &changes.under {
        for (mode, now) in &change.modes {
            let view = &views[mode.index()];
            let left = |live: &[bool]| {
                view.exits.iter().zip(live).filter(|(_, live)| **live).map(|(looks, _)| looks).collect::<Vec<_>>()
            };
            let (before, now) = (left(&changes.healthy[mode.index()].live), left(&now.live));
            if before.len() > now.len() && !now.is_empty() && now.iter().all(|looks| looks.is_timer()) {
                add_smallest(&mut known, vec![*mode], &change.faults);
            }
        }
    }
    known
}
