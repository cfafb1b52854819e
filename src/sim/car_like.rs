//! A body with steered wheels, as Khatoon and Ibraheem 2012 model it (section 2.2).
//!
//! In one control cycle it turns by the angle it steers by (eq. 2) and drives its speed times the cycle, evenly: where
//! the paper lets it turn first and drive then (eqs. 3 and 4), it drives on an arc, which never slips sideways (eq. 1).
//! So a car that stands does not turn. It takes on speeds and angles at once. Boxes that weigh less than it are
//! pushed; others, and walls, stop it.

use super::body::Command;
use super::world::World;
use crate::ir;

/// A car in motion.
#[derive(Debug, Clone)]
pub(super) struct CarLike<'a> {
    parameters: &'a ir::CarLike,
    command: Command,
}

impl<'a> CarLike<'a> {
    /// A car at rest.
    pub(super) const fn new(parameters: &'a ir::CarLike) -> Self {
        Self { parameters, command: Command::Stop }
    }

    /// Takes a command.
    pub(super) const fn command(&mut self, command: Command) {
        self.command = command;
    }

    /// Moves for one tick of `tick` seconds in `substeps` equal steps.
    pub(super) fn advance(&mut self, world: &mut World, tick: f64, substeps: u64) {
        let dt = tick / substeps as f64;
        let (speed, turn_rate) = self.rates();
        if speed == 0.0 {
            return;
        }
        for _ in 0..substeps {
            if world.load(speed.signum()).mass < self.parameters.mass {
                world.advance(speed * dt, turn_rate * dt);
            }
        }
    }

    /// How fast it drives (m/s) and turns to the left (rad/s).
    fn rates(&self) -> (f64, f64) {
        let ir::CarLike { cycle, speed_limit, steering_limit, .. } = *self.parameters;
        let (speed, turn_rate) = match self.command {
            Command::Velocity { speed, turn_rate } => (speed, turn_rate),
            // Backward, wheels to the left lead to the right.
            Command::Steer { speed, angle } => (speed, angle.copysign(angle * speed) / cycle),
            // A car is never told to turn in place or to come to an end.
            Command::Stop | Command::Rotate(_) | Command::Travel { .. } => (0.0, 0.0),
        };
        let most = steering_limit / cycle;
        (speed.clamp(-speed_limit, speed_limit), turn_rate.clamp(-most, most))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use nalgebra::Vector2;

    use super::*;
    use crate::sim::geometry::Rectangle;
    use crate::sim::walls::Walls;

    const CAR: ir::CarLike = ir::CarLike {
        mass: 500.0,
        length: 2.0,
        width: 1.0,
        cycle: 1.0,
        speed_limit: 2.0,
        steering_limit: 40.0 * PI / 180.0,
    };

    fn world(walls: &[[Vector2<f64>; 2]]) -> World {
        World::new(Rectangle::new(Vector2::zeros(), 0.0, CAR.length, CAR.width), 0.0, Walls::new(walls.iter().copied()))
    }

    /// Where it is after so many cycles of a command, and where it heads, in degrees.
    fn after(cycles: u32, command: Command, world: &mut World) -> (Vector2<f64>, f64) {
        let mut car = CarLike::new(&CAR);
        car.command(command);
        (0..cycles).for_each(|_| car.advance(world, CAR.cycle, 1000));
        (world.robot().middle(), world.heading().to_degrees())
    }

    fn steer(speed: f64, degrees: f64) -> Command {
        Command::Steer { speed, angle: degrees.to_radians() }
    }

    #[test]
    fn a_cycle_turns_it_by_the_angle_and_takes_it_as_far_as_its_speed() {
        let (place, heading) = after(1, steer(1.5, 0.0), &mut world(&[]));
        // A thousand additions.
        assert!((place - Vector2::new(1.5, 0.0)).norm() < 1e-12 && heading == 0.0);
        for (speed, degrees, expected) in
            [(1.0, 20.0, 20.0), (1.0, -90.0, -40.0), (9.0, 20.0, 20.0), (-1.0, 20.0, -20.0)]
        {
            let (place, heading) = after(1, steer(speed, degrees), &mut world(&[]));
            assert!((heading - expected).abs() < 1e-9, "{degrees}: {heading}");
            // The chord of the arc it drives, ahead of the heading half way; a chord of each step is short by 1e-8 of it.
            let (angle, driven) = (expected.to_radians(), speed.clamp(-2.0, 2.0));
            let chord = driven * (angle / 2.0).sin() / (angle / 2.0);
            let way = Vector2::new((angle / 2.0).cos(), (angle / 2.0).sin());
            assert!((place - way * chord).norm() < 1e-7, "{degrees}: {place}");
        }
    }

    #[test]
    fn a_car_that_stands_does_not_turn() {
        for command in [steer(0.0, 40.0), Command::Velocity { speed: 0.0, turn_rate: 1.0 }, Command::Stop] {
            assert_eq!(after(3, command, &mut world(&[])), (Vector2::zeros(), 0.0));
        }
    }

    #[test]
    fn nothing_is_passed_and_only_what_is_lighter_is_pushed() {
        let wall = [Vector2::new(10.0, -50.0), Vector2::new(10.0, 50.0)];
        let (place, _) = after(20, steer(2.0, 0.0), &mut world(&[wall]));
        assert!((8.99..9.0 + 1e-6).contains(&place.x), "{place}");
        for (mass, expected) in [(499.0, 40.0), (501.0, 8.5)] {
            let mut world = world(&[]);
            world.add_box(Rectangle::new(Vector2::new(10.0, 0.0), 0.0, 1.0, 1.0), mass);
            let (place, _) = after(20, steer(2.0, 0.0), &mut world);
            assert!((place.x - expected).abs() < 0.01, "{mass}: {place}");
        }
    }
}
