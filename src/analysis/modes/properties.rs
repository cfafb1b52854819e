//! Properties of a diagram: proved for everything that it can do, or left open.

use super::product::{Product, TooLarge};
use super::response::{Longest, longest};
use super::stimuli::{Stimulus, stimuli};
use super::ticks::Scene;
use crate::base::Id;
use crate::ir::{Claim, Diagram, Mode, Program};

/// What is known of a property.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Proof {
    /// It holds on every run.
    Proved,
    /// It may not hold.
    Open {
        /// What stands against it, for people.
        reason: String,
        /// The shortest time in nanoseconds for which a response is proved, where there is one.
        provable: Option<u64>,
        /// What to try, by mode: one of every kind of tick that the property and the mode's transitions can tell apart.
        stimuli: Vec<Vec<Stimulus>>,
    },
}

/// Proves properties of one diagram.
pub struct Prover<'a> {
    scene: Scene<'a>,
    faults: usize,
    longest_tick: u64,
}

impl<'a> Prover<'a> {
    /// For a diagram without errors, whose sensors fail and recover on any tick, at most `faults` of them at a time, and
    /// whose ticks are at most `longest_tick` nanoseconds long.
    pub fn new(program: &'a Program, diagram: &'a Diagram, faults: usize, longest_tick: u64) -> Self {
        Self { scene: Scene::new(program, diagram), faults, longest_tick }
    }

    /// Whether a property of the diagram holds on every run. Costs at most the number of kinds of ticks of each mode for
    /// every state of its timers and counters, and the number of ways between these.
    pub fn prove(&self, claim: Claim) -> Proof {
        let watched = claim.conditions();
        let against = match (Product::new(&self.scene, &watched, self.faults, self.longest_tick), claim) {
            (Err(TooLarge), _) => Some(too_large()),
            (Ok(mut product), Claim::Never(_)) => self.come_about(&mut product, |holds| holds != 0),
            (Ok(mut product), Claim::Always(_)) => self.come_about(&mut product, |holds| holds == 0),
            (Ok(mut product), Claim::LeadsTo(response)) => self.come_late(&mut product, response.within),
        };
        let Some((reason, provable)) = against else { return Proof::Proved };
        Proof::Open { reason, provable, stimuli: stimuli(&self.scene, &watched, self.faults) }
    }

    /// What stands against the claim that something is never so.
    fn come_about(&self, product: &mut Product<'_, '_>, is_against: impl Fn(u64) -> bool) -> Option<Against> {
        match product.explore(|node| is_against(node.holds)) {
            Ok(None) => None,
            Ok(Some(node)) => {
                let mode = self.name(product.nodes[node].mode);
                Some((
                    format!(
                        "it cannot be excluded in {mode}: of the past, only timers, counters and the mode are followed"
                    ),
                    None,
                ))
            }
            Err(TooLarge) => Some(too_large()),
        }
    }

    /// What stands against the claim that an effect is never late.
    fn come_late(&self, product: &mut Product<'_, '_>, within: u64) -> Option<Against> {
        let Ok(_) = product.explore(|_| false) else { return Some(too_large()) };
        match longest(product, self.longest_tick) {
            Longest::Within(time) if time < within => None,
            Longest::Within(time) => {
                // In whole milliseconds, for people.
                let provable = (time / 1_000_000 + 1) * 1_000_000;
                Some((format!("it cannot be excluded that it takes {} s", provable as f64 / 1e9), Some(provable)))
            }
            Longest::Endless(modes) => {
                let modes: Vec<_> = modes.into_iter().take(5).map(|mode| self.name(mode)).collect();
                Some((format!("it cannot be excluded that the machine stays in {} for ever", modes.join(", ")), None))
            }
        }
    }

    fn name(&self, mode: Id<Mode>) -> String {
        format!("`{}`", self.scene.diagram.modes[mode].symbol.name)
    }
}

/// The reason, and the time that can be proved.
type Against = (String, Option<u64>);

fn too_large() -> Against {
    ("the behavior has too many cases to look into".to_owned(), None)
}
