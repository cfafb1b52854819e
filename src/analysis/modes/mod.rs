//! What the modes of a diagram can do: which exits are taken, and where they lead.
//!
//! A claim that something never happens holds for all readings and all failures. Only then is there a warning.

mod always_true;
mod changes;
mod cycles;
mod dwell;
mod examined;
mod facts;
mod fault_sets;
mod faults;
mod flat;
mod formula;
mod fusion;
mod guards;
mod inhibited;
mod intermittent;
mod known;
mod left_at_once;
mod machine;
mod masked;
mod never_true;
mod one_tick;
mod oscillation;
mod outcomes;
mod preempted;
mod product;
mod properties;
mod repeated;
mod response;
mod steady;
mod stimuli;
mod swapping;
mod ticks;
mod timers;
mod traps;

pub(super) use changes::{Change, Changes, changes};
pub use dwell::{Clock, Moment, Way};
pub(super) use examined::Examined;
pub use facts::{Facts, ModeFacts, Step, fault_table};
pub(super) use faults::groups_within;
pub use faults::{Fault, FaultSet};
pub use flat::{Flat, Leaf, flatten};
pub(super) use formula::parts;
pub use formula::{Atom, Formula, Node, Operand, Past};
pub use machine::{Case, Guards, Machine, machine};
pub(super) use outcomes::{Conditions, Outcomes};
pub(super) use preempted::Layers;
pub use properties::{Proof, Prover};
pub use stimuli::Stimulus;
pub(super) use ticks::Scene;

use crate::base::Id;
use crate::diag::Diagnostic;
use crate::ir::{Diagram, Mode, Program, Transition};
use examined::examine;
use fusion::Readings;

/// A transition with what is known of its mode.
struct Subject<'a> {
    scene: &'a Scene<'a>,
    program: &'a Program,
    diagram: &'a Diagram,
    mode: &'a Mode,
    examined: &'a Examined,
    /// Its position in the mode.
    index: usize,
}

impl<'a> Subject<'a> {
    fn transition(&self) -> &'a Transition {
        &self.mode.transitions[self.index]
    }

    /// What can happen to it.
    fn exit(&self) -> &'a dwell::Exit {
        &self.examined.stay.exits[self.index]
    }

    fn condition_span(&self, transition: &Transition) -> crate::base::Span {
        self.program.exprs[transition.condition].span
    }

    /// As messages name where it leads.
    fn to(&self) -> String {
        target_name(self.diagram, self.transition())
    }
}

/// Readings as messages show them.
fn named_readings(program: &Program, readings: &Readings) -> String {
    let shown = readings.iter().map(|(sensor, at)| {
        let sensor = &program.sensors[*sensor];
        format!("`{}` at {}", sensor.symbol.name, sensor.unit.show(at.to_f64()))
    });
    shown.collect::<Vec<_>>().join(", ")
}

fn target_name(diagram: &Diagram, transition: &Transition) -> String {
    match transition.target {
        Some(target) if !transition.again => format!("`{}`", diagram.modes[target].symbol.name),
        _ => "`again`".to_owned(),
    }
}

/// Warns of what never happens in a diagram, and of what never ends; answers what is known of each mode. Each mode costs
/// the number of feasible ticks of its own conditions, each diagram the number of its transitions.
pub(super) fn check(scene: &Scene<'_>, findings: &mut Vec<Diagnostic>) -> Vec<Option<Examined>> {
    let Scene { program, diagram, .. } = *scene;
    let modes: Vec<_> = diagram.modes.values().map(|mode| examine(scene, mode)).collect();
    for (mode, examined) in diagram.modes.values().zip(&modes) {
        let Some(examined) = examined else { continue };
        let found = findings.len();
        // One finding for a transition, the one that says most, from the top: an exit that always fires hides the rest.
        for index in 0..mode.transitions.len() {
            let subject = Subject { scene, program, diagram, mode, examined, index };
            if always_true::check(&subject, findings) {
                break;
            }
            let _ = repeated::check(&subject, findings)
                || never_true::check(&subject, findings)
                || timers::check(&subject, findings)
                || inhibited::check(&subject, findings)
                || masked::check(&subject, findings);
        }
        if findings.len() == found {
            left_at_once::check(program, mode, examined, findings);
        }
    }
    guards::check(diagram, &modes, findings);
    traps::check(diagram, &modes, findings);
    one_tick::check(scene, &modes, findings);
    oscillation::check(scene, &modes, findings);
    swapping::check(scene, &modes, findings);
    intermittent::check(scene, &modes, findings);
    modes
}

/// The modes a mode can lead to, whatever has failed; all that are written where nothing is known of it.
fn successors(mode: &Mode, examined: Option<&Examined>) -> Vec<Id<Mode>> {
    let is_live = |index: usize| examined.is_none_or(|examined| examined.stay.exits[index].taken.is_some());
    let exits = mode.transitions.iter().enumerate().filter(|(index, _)| is_live(*index));
    exits.filter_map(|(_, transition)| transition.target).chain(mode.otherwise).collect()
}
