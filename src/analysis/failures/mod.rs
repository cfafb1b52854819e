//! What failed sensors do to a program: one check a file.

mod effects;
mod events;
mod looks;
mod missed;
mod single_point;
mod stuck_event;
mod trapped;
mod undeclared;
mod unsafe_modes;
mod words;

pub(super) use effects::{Effect, effects};
pub(super) use events::{Losses, check_network, feed, how, named_inputs};
pub(super) use looks::View;
pub(super) use undeclared::check_robot;
pub(super) use words::{Failed, failed, joined, list};

use self::effects::Loss;
use self::looks::Looks;
use super::modes::{self, Examined, Fault, FaultSet, Scene};
use super::reachability::is_in;
use crate::base::{Id, Span};
use crate::diag::{Diagnostic, Rule};
use crate::ir::{Diagram, Mode, Program, Sensor, Symbol};

/// A diagram with what failures do to it.
struct Subject<'a> {
    program: &'a Program,
    diagram: &'a Diagram,
    views: Vec<View>,
    effects: Vec<Effect>,
}

/// Warns of what a diagram cannot do any more with at most `up_to` failed sensors. Each set of failed sensors costs
/// the modes that have to do with them; where it changes their exits, a walk through the diagram.
pub(super) fn check(
    scene: &Scene<'_>,
    examined: &[Option<Examined>],
    (losses, up_to): (&mut Losses, usize),
    matters: impl Fn(&Symbol) -> bool,
    findings: &mut Vec<Diagnostic>,
) {
    let Scene { program, diagram, .. } = *scene;
    if diagram.incomplete {
        return;
    }
    let views = View::of_modes(program, diagram);
    for sense in (0..).zip(&diagram.senses).filter(|(_, sense)| matters(&program.networks[sense.network].symbol)) {
        events::check_sense((program, diagram, &views), sense, (losses, up_to), findings);
    }
    let can_surprise = |faults: &FaultSet, mode: Id<Mode>| {
        let mut exits = 0..views[mode.index()].exits.len();
        exits.any(|index| is_surprising(diagram, &views, faults, (mode, index)))
    };
    let mut changes = modes::changes(scene, examined, up_to, can_surprise);
    changes.under.retain(|change| {
        let lost = change.lost(&changes.healthy);
        lost.into_iter().any(|exit| is_surprising(diagram, &views, &change.faults, exit))
    });
    let effects = effects(diagram, &changes);
    let subject = Subject { program, diagram, views, effects };
    trapped::check(&subject, findings);
    unsafe_modes::check(&subject, findings);
    missed::check(&subject, findings);
}

/// The same loss under several sets of failed sensors.
struct Family<'s> {
    modes: &'s [Id<Mode>],
    /// The exits that make it worth a finding.
    exits: Vec<(Id<Mode>, usize)>,
    sets: Vec<&'s FaultSet>,
}

impl Subject<'_> {
    /// The losses that are worth a finding, with the smallest sets of failed sensors that each comes with.
    fn families<'s>(&'s self, losses: impl Fn(&'s Effect) -> &'s [Loss]) -> Vec<Family<'s>> {
        let mut known: Vec<(&FaultSet, &Loss)> = Vec::new();
        let mut families: Vec<Family<'s>> = Vec::new();
        for effect in &self.effects {
            for loss in losses(effect) {
                let is_of_fewer = known.iter().any(|(faults, known)| {
                    faults.len() < effect.faults.len()
                        && faults.iter().all(|fault| effect.faults.contains(fault))
                        && known.modes.iter().any(|mode| is_in(&loss.modes, *mode))
                });
                known.push((&effect.faults, loss));
                let is_surprising = |exit: &_| is_surprising(self.diagram, &self.views, &effect.faults, *exit);
                let exits: Vec<_> = loss.exits.iter().copied().filter(is_surprising).collect();
                if is_of_fewer || exits.is_empty() {
                    continue;
                }
                match families.iter_mut().find(|family| family.modes == loss.modes) {
                    Some(family) => family.sets.push(&effect.faults),
                    None => families.push(Family { modes: &loss.modes, exits, sets: vec![&effect.faults] }),
                }
            }
        }
        families
    }

    /// A finding about a family, on one of its modes or exits, with the exits that are lost.
    fn finding(&self, rule: &'static Rule, family: &Family<'_>, place: Span, what: &str) -> Diagnostic {
        let mut diagnostic = Diagnostic::new(rule, place, format!("{what} with {}", self.in_words(&family.sets)));
        for (mode, index) in family.exits.iter().take(3) {
            let span = self.diagram.modes[*mode].transitions[*index].span;
            diagnostic = diagnostic.label(span, "never taken then");
        }
        let silent = |set: &&&FaultSet| set.iter().all(|(_, how)| *how != Fault::Reported);
        if family.sets.iter().any(|set| silent(&set)) {
            diagnostic =
                diagnostic.note("the machine does not know: `failed` and `requires` see only what is reported");
        }
        diagnostic
    }

    /// Sets of failed sensors in words. What is known to have failed is not told where the same fails silently.
    fn in_words(&self, sets: &[&FaultSet]) -> String {
        let is_silent = |set: &FaultSet| set.iter().all(|(_, how)| *how != Fault::Reported);
        let sensors = |set: &FaultSet| set.iter().map(|(sensor, _)| *sensor).collect::<Vec<_>>();
        let is_told = |set: &&&FaultSet| {
            is_silent(set) || !sets.iter().any(|other| is_silent(other) && sensors(other) == sensors(set))
        };
        let told = sets.iter().filter(is_told).map(|set| in_words(self.program, set));
        failed(&told.collect::<Vec<_>>())
    }
}

/// Whether nobody would expect that an exit of one of the diagram's own modes is lost: it looks at a sensor that has not
/// failed, and compares none that has, nor asks whether one has. If the mode says what to do about the failure, the author knew; but once the
/// failure is known it was to be done.
fn is_surprising(diagram: &Diagram, views: &[View], faults: &FaultSet, (mode, index): (Id<Mode>, usize)) -> bool {
    let has_failed = |sensor: &Id<Sensor>| faults.iter().any(|(failed, _)| failed == sensor);
    let View { exits, answers, .. } = &views[mode.index()];
    let Looks { compared, fused, failed, .. } = &exits[index];
    let shows_it = compared.iter().chain(failed).any(has_failed) || compared.iter().chain(fused).all(has_failed);
    let is_answered = |(sensor, how): &(Id<Sensor>, Fault)| *how != Fault::Reported && answers.contains(sensor);
    !shows_it && !faults.iter().any(is_answered) && !diagram.modes[mode].inherited
}

/// Failed sensors as they are told.
pub(super) fn in_words<'a>(program: &'a Program, faults: &FaultSet) -> Vec<Failed<'a>> {
    let told = |&(sensor, how): &(Id<Sensor>, Fault)| {
        let Sensor { symbol, unit, range, .. } = &program.sensors[sensor];
        Failed { name: &symbol.name, unit, range: *range, how }
    };
    faults.iter().map(told).collect()
}
