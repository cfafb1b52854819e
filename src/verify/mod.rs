//! Properties: proved for every run, or refuted by one that the machine is seen to take.
//!
//! Imports: analysis, base, diag, interp, ir, plan, sim
//! Crates: –

mod layers;
mod message;
mod play;
mod scenario;
mod search;
mod told;

pub use scenario::{Counterexample, Replay, time, written};
pub use told::{Number, Stretch, Told, readings};

use std::sync::atomic::{AtomicBool, Ordering};

use crate::analysis::modes::{Proof, Prover, Stimulus};
use crate::base::{FileId, Id};
use crate::diag::Diagnostic;
use crate::ir::{self, Claim, Platform};
use crate::plan::{self, Checked, Plan};
use play::{Played, play, simplify};
use search::{Found, search};
use told::Cues;

/// What became of the properties of a program.
#[derive(Debug, Default)]
pub struct Verified {
    /// A finding for every property that is not proved.
    pub findings: Vec<Diagnostic>,
    /// How many are proved.
    pub proved: usize,
    /// Scenarios that show those that are refuted, as far as the simulator can.
    pub counterexamples: Vec<Counterexample>,
}

/// Ticks of these lengths are tried where time counts, in tenths of the longest: timers round up to them differently.
const TENTHS: [u64; 4] = [10, 9, 7, 3];

/// Proves or refutes the properties that the files that matter declare, with at most so many sensors failed at a time.
///
/// Ticks are at most as long as those of the scenarios that run the behavior, and at most 10 ms where none is longer.
/// Those that are left when `stop` is set are not looked at.
pub fn properties(
    checked: Checked<'_>,
    faults: usize,
    matters: impl Fn(FileId) -> bool,
    stop: &AtomicBool,
) -> Verified {
    let program = checked.program();
    let mut verified = Verified::default();
    let mut properties: Vec<_> =
        program.properties.iter().filter(|(_, property)| matters(property.span.file)).collect();
    properties.sort_by_key(|(_, property)| property.diagram);
    for of_one in properties.chunk_by(|(_, one), (_, next)| one.diagram == next.diagram) {
        let Some((_, first)) = of_one.first() else { continue };
        let tick = longest_tick(program, first.diagram);
        let prover = Prover::new(program, &program.diagrams[first.diagram], faults, tick);
        let has_layers = program.diagrams[first.diagram].modes.values().any(|mode| mode.runs.is_some());
        for (id, property) in of_one {
            if stop.load(Ordering::Relaxed) {
                return verified;
            }
            let proof =
                if has_layers { layers::prove(program, property, faults, tick) } else { prover.prove(property.claim) };
            match proof {
                Proof::Proved => verified.proved += 1,
                Proof::Open { reason, provable, stimuli } => {
                    let subject = Subject { checked, id: *id, property, tick, provable };
                    match refute(&subject, &stimuli) {
                        Some(refuted) => {
                            verified.findings.push(message::refuted(&subject, &refuted));
                            verified.counterexamples.extend(refuted.counterexample.ok());
                        }
                        None => verified.findings.push(message::undecided(&subject, &reason)),
                    }
                }
            }
        }
    }
    verified
}

/// The longest tick of the scenarios that run a diagram, at least that of a scenario which does not say; nanoseconds.
fn longest_tick(program: &ir::Program, diagram: Id<ir::Diagram>) -> u64 {
    let of_diagram = program.scenarios.values().filter(|scenario| scenario.diagram == diagram);
    of_diagram.map(|scenario| scenario.tick).fold(ir::Scenario::DEFAULT_TICK, u64::max)
}

/// A property that is not proved.
struct Subject<'a> {
    checked: Checked<'a>,
    id: Id<ir::Property>,
    property: &'a ir::Property,
    /// The longest tick, in nanoseconds.
    tick: u64,
    /// The time in which a response is proved, in nanoseconds.
    provable: Option<u64>,
}

/// A run that refutes a property.
struct Refuted {
    plan: Plan,
    /// The length of its ticks, in nanoseconds.
    tick: u64,
    played: Played,
    /// Whether the diagram looks at each sensor of the robot.
    matters: Vec<bool>,
    /// The scenario that shows it; or why there is none.
    counterexample: Result<Counterexample, &'static str>,
}

/// A run that refutes a claim, and the length of its ticks.
fn find(plan: &Plan, claim: Claim, longest_tick: u64, cues: &Cues) -> Option<(u64, Vec<Stretch>)> {
    let tried = if matches!(claim, Claim::LeadsTo(_)) { &TENTHS[..] } else { &TENTHS[..1] };
    for tenths in tried {
        let tick = (longest_tick * tenths / 10).max(1);
        match search(plan, claim, tick, cues) {
            Found::Run(run) => return Some((tick, run)),
            Found::Nothing => {}
            Found::TooMuch => return None,
        }
    }
    None
}

fn refute(subject: &Subject<'_>, stimuli: &[Vec<Stimulus>]) -> Option<Refuted> {
    let Subject { checked, id, property, .. } = *subject;
    let program = checked.program();
    let diagram = &program.diagrams[property.diagram];
    let plan = plan::build_alone(checked, property.diagram, &property.claim.conditions());
    let cues = Cues::new(program, diagram, stimuli)?;
    let (tick, found) = find(&plan, property.claim, subject.tick, &cues)?;
    let played = play(&plan, property.claim, tick, &found)?;
    let played = simplify(&plan, property.claim, tick, &cues, played);
    let counterexample = match diagram.platform {
        Platform::Interface(_) => Err("the behavior is written on an interface"),
        Platform::Robot(robot) if program.robots[robot].body.is_none() => Err("its robot has no body"),
        Platform::Robot(robot) => {
            let claim = Some(property.claim);
            let (diagram, forced) = (property.diagram, &cues.matters[..]);
            let replay = Replay { checked, diagram, robot, tick, forced, claim };
            scenario::counterexample(&replay, id, &played.stretches)
        }
    };
    Some(Refuted { plan, tick, played, matters: cues.matters, counterexample })
}
