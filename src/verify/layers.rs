//! Properties over several layers: proved of the layers as one flat machine.

use crate::analysis::modes::{Flat, Proof, Prover, Stimulus, flatten};
use crate::ir::{Claim, Program, Property};

/// As [`Prover::prove`] for a diagram whose modes run others; what to try is by its own modes.
pub(super) fn prove(program: &Program, property: &Property, faults: usize, longest_tick: u64) -> Proof {
    let watched = property.claim.conditions();
    let Some(flat) = flatten(program, property.diagram, &watched) else {
        let reason = "there are too many modes".to_owned();
        return Proof::Open { reason, provable: None, stimuli: Vec::new() };
    };
    let claim = match (property.claim, flat.watched.as_slice()) {
        (Claim::Never(_), &[condition]) => Claim::Never(condition),
        (Claim::Always(_), &[condition]) => Claim::Always(condition),
        (Claim::LeadsTo(response), &[cause, effect]) => {
            Claim::LeadsTo(crate::ir::Response { cause, effect, ..response })
        }
        (claim, _) => claim,
    };
    let prover = Prover::new(&flat.program, &flat.program.diagrams[flat.diagram], faults, longest_tick);
    match prover.prove(claim) {
        Proof::Proved => Proof::Proved,
        Proof::Open { reason, provable, stimuli } => {
            let modes = program.diagrams[property.diagram].modes.len();
            Proof::Open { reason, provable, stimuli: by_outer_mode(&flat, modes, stimuli) }
        }
    }
}

/// What to try in each mode of the outermost diagram: all that is worth it in a mode inside.
fn by_outer_mode(flat: &Flat, modes: usize, stimuli: Vec<Vec<Stimulus>>) -> Vec<Vec<Stimulus>> {
    let mut by_mode: Vec<Vec<Stimulus>> = vec![Vec::new(); modes];
    for (leaf, stimuli) in flat.leaves.iter().zip(stimuli) {
        let Some(outer) = leaf.path.first() else { continue };
        let known = &mut by_mode[outer.index()];
        for stimulus in stimuli {
            if !known.contains(&stimulus) {
                known.push(stimulus);
            }
        }
    }
    by_mode
}
