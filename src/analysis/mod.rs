//! What can be said of the program without running it: one file a check.
//!
//! Everything is decided exactly, in rational arithmetic, but for `timing`: bodies and speeds are doubles.
//!
//! Imports: base, diag, ir, membership
//! Crates: batsat, petgraph

mod arbiters;
mod breakpoints;
mod commands;
mod coverage;
mod decisions;
mod duplicate_terms;
mod durations;
mod events;
mod exits;
mod expectations;
mod failures;
mod fault_table;
pub mod modes;
pub mod network;
mod outputs;
mod priorities;
mod reachability;
mod requirements;
mod silent;
mod support;
pub mod timing;
mod vanishing_end;

pub use fault_table::{EventRow, Failed, FaultRow, FaultTable, ModesRow, RuleRows, fault_table};

use crate::base::{FileId, Id};
use crate::diag::Diagnostic;
use crate::ir::{Network, Program, Sense, Sensor, Symbol};
use modes::Layers;

/// A network, and the sensors that feed its inputs.
type Source = (Id<Network>, Vec<Id<Sensor>>);

/// What a sense of a diagram looks at.
fn source(sense: &Sense) -> Source {
    (sense.network, sense.inputs.clone())
}

/// Every finding about what the files that matter declare, with up to so many failed sensors, in no particular order.
/// Linear in the size of the program, and in the cases of each mode.
pub fn run(program: &Program, faults: usize, matters: impl Fn(FileId) -> bool) -> Vec<Diagnostic> {
    let mut findings = Vec::new();
    durations::check(program, &matters, &mut findings);
    expectations::check(program, &matters, &mut findings);
    let matters = |symbol: &Symbol| matters(symbol.span.file);
    for variable in program.variables.values().filter(|variable| matters(&variable.symbol)) {
        breakpoints::check(&variable.terms, &variable.unit, &mut findings);
        // What a broken term would have held is unknown; it was reported.
        let in_order = variable.terms.iter().all(|term| breakpoints::in_order(&term.shape));
        if in_order && !variable.incomplete && !variable.terms.is_empty() {
            coverage::check(variable, &mut findings);
            duplicate_terms::check(variable, &mut findings);
        }
    }
    for (id, _) in program.networks.iter().filter(|(_, network)| matters(&network.symbol)) {
        events::check(program, id, &matters, &mut findings);
        outputs::check(program, id, faults, &mut findings);
    }
    let mut layers = Layers::new(program);
    let (mut noise, mut losses) = (events::Noise::default(), failures::Losses::default());
    for (id, diagram) in program.diagrams.iter().filter(|(_, diagram)| matters(&diagram.symbol)) {
        timing::check(program, id, &mut findings);
        if let Some(arbiter) = &diagram.arbiter {
            if !diagram.incomplete {
                arbiters::check(program, arbiter, &mut findings);
            }
            continue;
        }
        priorities::check(diagram, &mut findings);
        exits::check(diagram, &mut findings);
        requirements::check(diagram, program, &mut findings);
        commands::check(diagram, program, &mut findings);
        decisions::check(diagram, &mut findings);
        reachability::check(diagram, &mut findings);
        silent::check(diagram, program, &mut findings);
        let scene = layers.scene(id);
        if scene.is_whole() {
            let examined = modes::check(&scene, &mut findings);
            failures::check(&scene, &examined, (&mut losses, faults), matters, &mut findings);
            layers.note(id, &examined);
            layers.check(id, &mut findings);
        }
        noise.check(program, diagram, &mut findings);
        outputs::check_senses(program, diagram, &mut findings);
    }
    for (id, _) in program.networks.iter().filter(|(_, network)| matters(&network.symbol)) {
        failures::check_network(program, id, faults, &mut findings);
    }
    for robot in program.robots.values().filter(|robot| matters(&robot.symbol)) {
        failures::check_robot(program, robot, &mut findings);
    }
    findings
}
