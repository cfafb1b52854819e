//! A body of one of the kinds: what it is told, and how it moves.

use super::car_like::CarLike;
use super::differential_drive::DifferentialDrive;
use super::world::World;
use crate::ir;

/// What a body is told to do.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Command {
    /// Stand still.
    Stop,
    /// Drive.
    Velocity {
        /// m/s, forward.
        speed: f64,
        /// rad/s, to the left.
        turn_rate: f64,
    },
    /// Turn in place by an angle in rad, to the left.
    Rotate(f64),
    /// Drive straight on.
    Travel {
        /// m, above 0, or 0 to go on and on.
        distance: f64,
        /// m/s, forward.
        speed: f64,
    },
    /// Drive with steered wheels.
    Steer {
        /// m/s, forward.
        speed: f64,
        /// rad, to the left.
        angle: f64,
    },
}

/// A body in motion.
#[derive(Debug, Clone)]
pub(super) enum Body<'a> {
    DifferentialDrive(DifferentialDrive<'a>),
    CarLike(CarLike<'a>),
}

impl<'a> Body<'a> {
    /// A body at rest.
    pub(super) fn new(parameters: &'a ir::Body, seed: u64) -> Self {
        match parameters {
            ir::Body::DifferentialDrive(body) => Self::DifferentialDrive(DifferentialDrive::new(body, seed)),
            ir::Body::CarLike(body) => Self::CarLike(CarLike::new(body)),
        }
    }

    /// Takes a command. What is under way goes on, unless `start` or another angle or distance says it is another.
    pub(super) fn command(&mut self, command: Command, start: bool) {
        match self {
            Self::DifferentialDrive(body) => body.command(command, start),
            Self::CarLike(body) => body.command(command),
        }
    }

    /// Forgets that a command was completed: another mode has begun.
    pub(super) fn forget_done(&mut self) {
        if let Self::DifferentialDrive(body) = self {
            body.forget_done();
        }
    }

    /// Whether the command has been completed; no command of a car ever is.
    pub(super) fn done(&self) -> bool {
        self.wheels().is_some_and(DifferentialDrive::done)
    }

    /// The body, if its wheels and its wedge can be measured.
    pub(super) fn wheels(&self) -> Option<&DifferentialDrive<'a>> {
        match self {
            Self::DifferentialDrive(body) => Some(body),
            Self::CarLike(_) => None,
        }
    }

    /// Moves for one tick of `tick` seconds in `substeps` equal steps.
    pub(super) fn advance(&mut self, world: &mut World, tick: f64, substeps: u64) {
        match self {
            Self::DifferentialDrive(body) => body.advance(world, tick, substeps),
            Self::CarLike(body) => body.advance(world, tick, substeps),
        }
    }
}
