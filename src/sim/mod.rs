//! Tries a plan on a simulated robot: bodies, sensors, worlds, faults, and what a scenario expects.
//!
//! Imports: base, diag, interp, ir, plan, trace
//! Crates: nalgebra, pathfinding, rand_distr, rand_pcg, rstar

mod body;
mod car_like;
mod coverage;
mod differential_drive;
mod drive;
mod expect;
#[cfg(test)]
mod fixture;
mod geometry;
mod planner;
mod random;
mod record;
mod ring;
mod run;
mod sensing;
mod simulation;
mod walls;
mod world;

pub use coverage::coverage;
pub use expect::{Verdict, judge};
pub use record::evidence;
pub use run::{Run, RunError, RunOptions, machine, placements, run};
pub use simulation::Simulation;
