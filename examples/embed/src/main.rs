//! A robot of one's own, run by a compiled behavior. The motors, the wall and the battery are imitated here.

/// What the build script made of `patrol.msd`.
mod behavior {
    include!(concat!(env!("OUT_DIR"), "/patrol.rs"));
}

use std::convert::Infallible;

use behavior::patrol::{Failed, Inputs, Machine, Mode, Robot};

/// Two wheels; in place of registers, what they last did.
#[derive(Default)]
struct Rover {
    /// m/s
    speed: f64,
    /// rad that are left to turn.
    to_turn: f64,
}

impl Robot for Rover {
    // Nothing can go wrong here. A bus that can time out would name its error.
    type Error = Infallible;

    fn halt(&mut self) -> Result<(), Infallible> {
        (self.speed, self.to_turn) = (0.0, 0.0);
        Ok(())
    }

    fn drive(&mut self, speed: f64) -> Result<(), Infallible> {
        self.speed = speed;
        Ok(())
    }

    fn turn(&mut self, angle: f64, start: bool) -> Result<(), Infallible> {
        // The command is given again on every tick; only the first one starts a turn.
        if start {
            (self.speed, self.to_turn) = (0.0, angle);
        }
        Ok(())
    }
}

/// The length of a tick: 20 ms.
const TICK_NS: u64 = 20_000_000;

fn main() {
    let mut rover = Rover::default();
    let mut machine = Machine::new(1);
    let (mut wall, mut seconds, mut before) = (2.0, 0.0, None);
    while before != Some(Mode::Parked) {
        // A real loop reads its sensors here. A range finder that reports an error is `failed`.
        let inputs = Inputs {
            left_range: wall,
            right_range: wall + 0.1,
            battery: 12.0 - seconds / 20.0,
            failed: Failed::default(),
            done: rover.to_turn == 0.0,
        };
        let Ok(mode) = machine.step(&inputs, TICK_NS, &mut rover);
        if before != Some(mode) {
            println!("{seconds:5.2} s  {}", mode.name());
            before = Some(mode);
        }
        // A real loop waits for its next tick here.
        seconds += 0.02;
        wall -= rover.speed * 0.02;
        if rover.to_turn > 0.0 {
            rover.to_turn = (rover.to_turn - 0.02).max(0.0);
            wall = 3.0;
        }
    }
}
