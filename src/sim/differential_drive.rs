//! A body on two driven wheels: how it follows commands, and what its load does to it.
//!
//! The wheels follow a commanded speed with a first-order lag, an acceleration limit, and a disturbance of tracking.
//! Pushing boxes of mass m takes μ m g, and the wheels can give μ M g: the load caps the acceleration at
//! μ g (M - m) / (M + m), which slows the body to a stop where the wheels slip. On meeting an additional mass dm the
//! speed drops by v dm / (M + m), spread over the impact time.

use super::body::Command;
use super::random::{Purpose, Stream};
use super::world::{Load, Moved, World};
use crate::ir;

/// Standard gravity, m/s².
pub(super) const GRAVITY: f64 = 9.806_65;
/// The fastest turn in place, rad/s: 45 degrees a second.
const TURN_RATE: f64 = std::f64::consts::FRAC_PI_4;
/// A turn is complete within this of its angle, rad, and when what it would still coast is below it too: together
/// below half a degree.
const TURN_TOLERANCE: f64 = 0.2 * std::f64::consts::PI / 180.0;
/// A stretch of travel is complete within this of its end, m, and when what it would still coast is below it too.
const TRAVEL_TOLERANCE: f64 = 0.002;
/// How long a disturbance of tracking lasts, s.
const DISTURBANCE_TIME: f64 = 0.02;
/// Speeds up to this are lost at once when the way is blocked, m/s; faster ones over the impact time.
const CREEP: f64 = 0.02;

/// A differential-drive body in motion. Wheels are left and right.
#[derive(Debug, Clone)]
pub(super) struct DifferentialDrive<'a> {
    parameters: &'a ir::DifferentialDrive,
    command: Command,
    /// rad turned or m driven in the direction of the command, since it was given.
    progress: f64,
    done: bool,
    /// m/s over ground.
    speeds: [f64; 2],
    /// m/s, averaged over the last tick: what an encoder would tell.
    accelerations: [f64; 2],
    /// m/s² of the disturbance.
    disturbance: [f64; 2],
    /// s for which the impact under way goes on.
    impact_left: f64,
    /// m/s² that it takes from the wheels.
    impact_rates: [f64; 2],
    load: Load,
    direction: f64,
    noise: Stream,
}

impl<'a> DifferentialDrive<'a> {
    /// A body at rest.
    pub(super) fn new(parameters: &'a ir::DifferentialDrive, seed: u64) -> Self {
        Self {
            parameters,
            command: Command::Stop,
            progress: 0.0,
            done: false,
            speeds: [0.0; 2],
            accelerations: [0.0; 2],
            disturbance: [0.0; 2],
            impact_left: 0.0,
            impact_rates: [0.0; 2],
            load: Load::NONE,
            direction: 0.0,
            noise: Stream::new(seed, Purpose::Tracking),
        }
    }

    /// Takes a command. What is under way goes on, unless `start` or another angle or distance says it is another.
    pub(super) fn command(&mut self, command: Command, start: bool) {
        if start || command != self.command {
            self.progress = 0.0;
            self.done = false;
        }
        self.command = command;
    }

    /// Forgets that a command was completed: another mode has begun.
    pub(super) fn forget_done(&mut self) {
        self.done = false;
    }

    /// Whether the command has been completed; only turns in place and travels of some length ever are.
    pub(super) fn done(&self) -> bool {
        self.done
    }

    /// Speeds of the left and the right wheel, m/s.
    pub(super) fn speeds(&self) -> [f64; 2] {
        self.speeds
    }

    /// Accelerations of the left and the right wheel, averaged over the last tick, m/s².
    pub(super) fn accelerations(&self) -> [f64; 2] {
        self.accelerations
    }

    /// The force on the wedge, N: what the load takes, at most what the wheels can give.
    pub(super) fn wedge_force(&self) -> f64 {
        let ir::DifferentialDrive { mass, traction, .. } = *self.parameters;
        if self.direction > 0.0 { traction * GRAVITY * self.load.mass.min(mass) } else { 0.0 }
    }

    /// Moves for one tick of `tick` seconds in `substeps` equal steps.
    pub(super) fn advance(&mut self, world: &mut World, tick: f64, substeps: u64) {
        let before = self.speeds;
        let dt = tick / substeps as f64;
        let pace = Pace::new(self.parameters, dt);
        for _ in 0..substeps {
            self.step(world, dt, &pace);
        }
        self.accelerations = [0, 1].map(|wheel| (self.speeds[wheel] - before[wheel]) / tick);
    }

    fn step(&mut self, world: &mut World, dt: f64, pace: &Pace) {
        let target = self.target();
        self.direction = self.way();
        self.load = world.load(self.direction);
        if self.load.added > 0.0 {
            self.meet();
        }
        let driven = self.drive(target, dt, pace);
        if self.impact_left > 0.0 {
            let time = dt.min(self.impact_left);
            for wheel in 0..2 {
                self.speeds[wheel] += self.disturbance[wheel] * dt - self.impact_rates[wheel] * time;
            }
            self.impact_left = if self.impact_left - time < 1e-9 { 0.0 } else { self.impact_left - time };
        } else {
            self.follow(target, driven, dt);
        }
        let [left, right] = self.speeds;
        let turn = (right - left) / self.parameters.track * dt;
        let moved = world.advance(mean(self.speeds) * dt, turn);
        if moved.drive_blocked {
            self.lose([mean(self.speeds); 2]);
        }
        if moved.turn_blocked {
            let half = (right - left) / 2.0;
            self.lose([-half, half]);
        }
        self.make_progress(&moved);
    }

    /// The way it drives: 1, -1, or 0 for a body that neither drives nor is told to.
    fn way(&self) -> f64 {
        let speed = mean(self.speeds);
        if speed.abs() > CREEP {
            return speed.signum();
        }
        let told = mean(self.target());
        if told == 0.0 { 0.0 } else { told.signum() }
    }

    /// Commanded speeds of the wheels, m/s.
    fn target(&self) -> [f64; 2] {
        let (speed, turn_rate) = match self.command {
            // A body without steered wheels is never told to steer.
            Command::Stop | Command::Steer { .. } => (0.0, 0.0),
            Command::Velocity { speed, turn_rate } => (speed, turn_rate),
            Command::Rotate(_) | Command::Travel { .. } if self.done => (0.0, 0.0),
            Command::Rotate(angle) => {
                let ir::DifferentialDrive { lag, acceleration_limit, track, .. } = *self.parameters;
                // Through the lag, a rate of 1/(4 lag) for each rad that is left is the fastest without overshoot;
                // the acceleration limit may ask for a longer slope.
                let slope = (0.25 / lag).min(acceleration_limit / (track * TURN_RATE));
                (0.0, ((angle - self.progress) * slope).clamp(-TURN_RATE, TURN_RATE))
            }
            Command::Travel { distance: 0.0, speed } => (speed, 0.0),
            Command::Travel { distance, speed } => {
                let ir::DifferentialDrive { lag, acceleration_limit, .. } = *self.parameters;
                let left = distance - self.progress;
                // The same through the lag; half the limit leaves the lag room to follow.
                let fastest = (0.25 / lag * left.abs()).min((acceleration_limit * left.abs()).sqrt());
                (speed.abs().min(fastest) * left.signum() * speed.signum(), 0.0)
            }
        };
        let across = turn_rate * self.parameters.track / 2.0;
        [speed - across, speed + across]
    }

    /// The accelerations the wheels are driven with, disturbance included, m/s².
    fn drive(&mut self, target: [f64; 2], dt: f64, pace: &Pace) -> [f64; 2] {
        let limit = self.parameters.acceleration_limit;
        if target == [0.0; 2] {
            self.disturbance = [0.0; 2];
        } else if pace.disturbance > 0.0 {
            for disturbance in &mut self.disturbance {
                *disturbance = *disturbance * pace.kept + self.noise.normal() * pace.disturbance;
            }
        }
        [0, 1].map(|wheel| {
            let wanted = (target[wheel] - self.speeds[wheel]) * pace.followed / dt;
            wanted.clamp(-limit, limit) + self.disturbance[wheel]
        })
    }

    /// Speeds up or slows down as far as the load lets it.
    fn follow(&mut self, target: [f64; 2], driven: [f64; 2], dt: f64) {
        let cap = self.cap();
        let excess = (mean(driven) * self.direction - cap).max(0.0) * self.direction;
        let before = mean(self.speeds);
        for (speed, driven) in self.speeds.iter_mut().zip(driven) {
            *speed += (driven - excess) * dt;
        }
        if cap < 0.0 && mean(target) * self.direction > 0.0 {
            // The wheels slip: the body comes to rest on the arc it was on, and stays.
            let after = mean(self.speeds);
            if after * self.direction <= 0.0 {
                self.speeds = [0.0; 2];
            } else {
                let across = (self.speeds[1] - self.speeds[0]) / 2.0 * (after / before).clamp(0.0, 1.0);
                self.speeds = [after - across, after + across];
            }
        }
    }

    /// The largest acceleration with this load, m/s².
    fn cap(&self) -> f64 {
        let ir::DifferentialDrive { mass, traction, .. } = *self.parameters;
        let load = self.load.mass;
        if load == 0.0 {
            f64::INFINITY
        } else if load.is_finite() {
            traction * GRAVITY * (mass - load) / (mass + load)
        } else {
            -traction * GRAVITY
        }
    }

    /// Begins an impact with what has been added to the load.
    fn meet(&mut self) {
        let Load { mass, added } = self.load;
        let share = if added.is_finite() { added / (self.parameters.mass + mass) } else { 1.0 };
        let lost = mean(self.speeds) * share;
        let time = self.parameters.impact_time;
        self.impact_rates = self.impact_rates.map(|rate| (rate * self.impact_left + lost) / time);
        self.impact_left = time;
    }

    /// Takes speed from the wheels because the way is blocked.
    fn lose(&mut self, lost: [f64; 2]) {
        if lost.iter().all(|lost| lost.abs() <= CREEP) {
            for (speed, lost) in self.speeds.iter_mut().zip(lost) {
                *speed -= lost;
            }
        } else if self.impact_left == 0.0 {
            self.impact_left = self.parameters.impact_time;
            self.impact_rates = lost.map(|lost| lost / self.impact_left);
        }
    }

    /// Counts what a turn in place has turned or a travel has driven, and whether that completes it.
    fn make_progress(&mut self, moved: &Moved) {
        let [left, right] = self.speeds;
        let (end, step, rate, tolerance) = match self.command {
            Command::Rotate(angle) => (angle, moved.turned, (right - left) / self.parameters.track, TURN_TOLERANCE),
            Command::Travel { distance, speed } if distance != 0.0 => {
                (distance, moved.drove * speed.signum(), mean(self.speeds), TRAVEL_TOLERANCE)
            }
            Command::Stop | Command::Velocity { .. } | Command::Travel { .. } | Command::Steer { .. } => return,
        };
        if !self.done {
            self.progress += step;
            let coast = rate * self.parameters.lag;
            self.done = (end - self.progress).abs() <= tolerance && coast.abs() <= tolerance;
        }
    }
}

/// What depends on the length of a step alone.
struct Pace {
    /// The share of a difference in speed that the lag makes up for in one step.
    followed: f64,
    /// The share of a disturbance that is left after one step.
    kept: f64,
    /// Standard deviation of what is new in a disturbance after one step, m/s².
    disturbance: f64,
}

impl Pace {
    fn new(parameters: &ir::DifferentialDrive, dt: f64) -> Self {
        let ir::DifferentialDrive { lag, tracking_noise, .. } = *parameters;
        let kept = (-dt / DISTURBANCE_TIME).exp();
        // The lag fights the disturbance: of an Ornstein-Uhlenbeck process with time constant T it leaves an
        // acceleration with the share 1 / (1 + T / lag) of the variance. That is made up for.
        let deviation = tracking_noise * (1.0 + DISTURBANCE_TIME / lag).sqrt();
        Self { followed: -(-dt / lag).exp_m1(), kept, disturbance: deviation * (1.0 - kept * kept).sqrt() }
    }
}

fn mean([left, right]: [f64; 2]) -> f64 {
    f64::midpoint(left, right)
}

#[cfg(test)]
mod tests {
    use nalgebra::Vector2;

    use super::*;
    use crate::sim::fixture::J5;
    use crate::sim::geometry::Rectangle;
    use crate::sim::walls::Walls;

    const QUIET: ir::DifferentialDrive = ir::DifferentialDrive { tracking_noise: 0.0, ..J5 };

    fn world() -> World {
        world_with(&[])
    }

    fn world_with(walls: &[[Vector2<f64>; 2]]) -> World {
        let robot = Rectangle::new(Vector2::zeros(), 0.0, J5.length, J5.width);
        World::new(robot, 0.0, Walls::new(walls.iter().copied()))
    }

    /// Ticks of 10 ms in steps of 1 ms; what `seen` says after each.
    fn ticks<T>(
        body: &mut DifferentialDrive<'_>,
        world: &mut World,
        count: usize,
        seen: impl Fn(&DifferentialDrive<'_>) -> T,
    ) -> Vec<T> {
        let tick = |_| {
            body.advance(world, 0.01, 10);
            seen(body)
        };
        (0..count).map(tick).collect()
    }

    /// The steady force (N) and the sharpest spike (m/s²) of driving into a box of `mass` kg at 0.26 m/s.
    fn collide(mass: f64) -> (f64, f64) {
        let (mut world, mut body) = (world(), DifferentialDrive::new(&QUIET, 1));
        world.add_box(Rectangle::new(Vector2::new(1.45, 0.0), 0.0, 0.4, 0.6), mass);
        body.command(Command::Velocity { speed: 0.26, turn_rate: 0.0 }, true);
        let seen = ticks(&mut body, &mut world, 500, |body| (body.wedge_force(), body.accelerations()));
        assert!(seen.iter().all(|(_, [left, right])| (left - right).abs() < 1e-9));
        let spike = seen.iter().map(|(_, accelerations)| accelerations[0]).fold(0.0, f64::min);
        (seen[499].0, spike)
    }

    #[test]
    fn collisions_are_as_the_characterization_found_them() {
        let mut before = 0.0;
        for mass in (1..=12).map(|tens| f64::from(tens) * 10.0) {
            let (force, spike) = collide(mass);
            // Linear up to the robot's own mass, where the wheels slip; a sum of two roundings.
            assert!((force - 0.4 * GRAVITY * mass.min(59.0)).abs() < 1e-9, "{mass}: {force}");
            // The speed at 0.75 m falls short of 0.26 m/s by less than exp(-2.7 / 0.15) of it.
            let analytic = -0.26 * mass / (59.0 + mass) / 0.05;
            assert!((spike - analytic).abs() < 1e-5, "{mass}: {spike} {analytic}");
            assert!(spike < before, "{mass}");
            before = spike;
        }
    }

    #[test]
    fn a_light_load_lets_the_speed_recover_and_a_heavy_one_stops_it() {
        for (mass, expected) in [(30.0, 0.26), (90.0, 0.0)] {
            let (mut world, mut body) = (world(), DifferentialDrive::new(&QUIET, 1));
            world.add_box(Rectangle::new(Vector2::new(0.8, 0.0), 0.0, 0.4, 0.6), mass);
            body.command(Command::Velocity { speed: 0.26, turn_rate: 0.0 }, true);
            ticks(&mut body, &mut world, 400, |_| ());
            assert!((mean(body.speeds()) - expected).abs() < 1e-6, "{mass}: {:?}", body.speeds());
        }
    }

    #[test]
    fn a_wall_stops_the_body_and_takes_all_the_wheels_can_give() {
        let mut world = world_with(&[[Vector2::new(1.0, -1.0), Vector2::new(1.0, 1.0)]]);
        let mut body = DifferentialDrive::new(&QUIET, 1);
        body.command(Command::Velocity { speed: 0.26, turn_rate: 0.0 }, true);
        ticks(&mut body, &mut world, 400, |_| ());
        assert_eq!(body.wedge_force(), 0.4 * GRAVITY * 59.0);
        assert!(body.speeds().iter().all(|speed| speed.abs() < 0.01), "{:?}", body.speeds());
        // Within a step of the wall.
        assert!((world.robot().middle().x - 0.5).abs() < 0.001);
        body.command(Command::Velocity { speed: -0.2, turn_rate: 0.0 }, true);
        ticks(&mut body, &mut world, 100, |_| ());
        assert_eq!(body.wedge_force(), 0.0);
        assert!(world.robot().middle().x < 0.4);
    }

    #[test]
    fn turns_in_place_end_within_half_a_degree_and_say_so() {
        for (seed, degrees) in [90.0_f64, -120.0, 5.0, 0.0, 180.0, -33.3, 720.0].into_iter().enumerate() {
            for parameters in [QUIET, J5] {
                let (mut world, mut body) = (world(), DifferentialDrive::new(&parameters, seed as u64));
                body.command(Command::Rotate(degrees.to_radians()), true);
                let mut count = 0;
                while !body.done() {
                    body.advance(&mut world, 0.01, 10);
                    body.command(Command::Rotate(degrees.to_radians()), false);
                    count += 1;
                    assert!(count < 3000, "{degrees}");
                }
                // Not faster than the turn rate allows, and not much slower: speeding up and slowing down take 3 s.
                let seconds = f64::from(count) / 100.0;
                assert!((degrees.abs() / 45.0 - 0.2..degrees.abs() / 45.0 + 4.0).contains(&seconds), "{seconds}");
                ticks(&mut body, &mut world, 100, |_| ());
                assert!((world.heading().to_degrees() - degrees).abs() < 0.5, "{}", world.heading().to_degrees());
            }
        }
    }

    #[test]
    fn travels_end_within_half_a_centimetre_and_say_so() {
        for (seed, (distance, speed)) in [(1.0, 0.26), (0.5, -0.4), (0.01, 1.0), (3.0, 2.0)].into_iter().enumerate() {
            for parameters in [QUIET, J5] {
                let (mut world, mut body) = (world(), DifferentialDrive::new(&parameters, seed as u64));
                let command = Command::Travel { distance, speed };
                body.command(command, true);
                let mut count = 0;
                while !body.done() {
                    body.advance(&mut world, 0.01, 10);
                    body.command(command, false);
                    count += 1;
                    assert!(count < 2000, "{distance}");
                }
                // Not faster than the speed allows, and not much slower.
                let seconds = f64::from(count) / 100.0;
                assert!((distance / speed.abs()..distance / speed.abs() + 6.0).contains(&seconds), "{seconds}");
                ticks(&mut body, &mut world, 100, |_| ());
                let off = world.robot().middle().norm() - distance;
                assert!(off.abs() < 0.005 && world.robot().middle().x * speed > 0.0, "{off}");
            }
        }
    }

    #[test]
    fn a_travel_of_no_length_goes_on_and_one_that_is_blocked_is_not_done() {
        let mut body = DifferentialDrive::new(&QUIET, 1);
        body.command(Command::Travel { distance: 0.0, speed: 0.3 }, true);
        let mut world = world();
        let done = ticks(&mut body, &mut world, 6000, |body| body.done);
        assert!(!done.contains(&true) && world.robot().middle().x > 17.9);
        let mut world = world_with(&[[Vector2::new(1.0, -1.0), Vector2::new(1.0, 1.0)]]);
        let mut body = DifferentialDrive::new(&QUIET, 1);
        body.command(Command::Travel { distance: 1.0, speed: 0.3 }, true);
        assert!(!ticks(&mut body, &mut world, 2000, |body| body.done).contains(&true));
    }

    #[test]
    fn a_turn_begins_anew_only_when_it_is_started() {
        let (mut world, mut body) = (world(), DifferentialDrive::new(&QUIET, 1));
        for (start, expected) in [(true, 1.0), (false, 1.0), (true, 2.0)] {
            body.command(Command::Rotate(1.0), start);
            assert_eq!(body.done(), !start);
            ticks(&mut body, &mut world, 500, |_| ());
            assert!(body.done());
            assert!((world.heading() - expected).abs() < 0.02, "{}", world.heading());
        }
    }

    #[test]
    fn an_arc_is_a_circle_of_its_radius() {
        let parameters = ir::DifferentialDrive { lag: 1e-6, acceleration_limit: 1e6, ..QUIET };
        let (mut world, mut body) = (world(), DifferentialDrive::new(&parameters, 1));
        body.command(Command::Velocity { speed: 0.5, turn_rate: 0.25 }, true);
        ticks(&mut body, &mut world, 400, |_| ());
        // One rad on a radius of 2 m to the left. A chord of 0.5 mm for each arc is short by 1e-9 of its length.
        let end = Vector2::new(2.0 * 1.0_f64.sin(), 2.0 - 2.0 * 1.0_f64.cos());
        assert!((world.robot().middle() - end).norm() < 1e-6, "{}", world.robot().middle());
        assert!((world.heading() - 1.0).abs() < 1e-9);
    }

    #[test]
    fn speed_follows_with_the_lag_and_within_the_limit() {
        let (mut world, mut body) = (world(), DifferentialDrive::new(&QUIET, 1));
        body.command(Command::Velocity { speed: 0.1, turn_rate: 0.0 }, true);
        let speeds = ticks(&mut body, &mut world, 15, |body| body.speeds()[0]);
        // Below 0.15 m/s the lag asks for less than the limit: 0.1 (1 - 1/e) after one time constant.
        assert!((speeds[14] - 0.1 * (1.0 - (-1.0_f64).exp())).abs() < 1e-9, "{}", speeds[14]);
        body.command(Command::Velocity { speed: -5.0, turn_rate: 0.0 }, true);
        let accelerations = ticks(&mut body, &mut world, 10, |body| body.accelerations()[0]);
        assert!(accelerations.iter().all(|acceleration| (acceleration + 1.0).abs() < 1e-9));
    }

    #[test]
    fn tracking_noise_is_as_large_as_declared_and_only_there_while_driving() {
        let (mut world, mut body) = (world(), DifferentialDrive::new(&J5, 1));
        let still = ticks(&mut body, &mut world, 100, |body| body.accelerations().map(f64::abs));
        assert!(still.iter().all(|seen| *seen == [0.0; 2]));
        body.command(Command::Velocity { speed: 0.26, turn_rate: 0.0 }, true);
        ticks(&mut body, &mut world, 200, |_| ());
        let mut squares = [0.0; 2];
        for _ in 0..20_000 {
            // Single steps, because an average over several is smaller.
            body.advance(&mut world, 0.001, 1);
            for (sum, acceleration) in squares.iter_mut().zip(body.accelerations()) {
                *sum += acceleration * acceleration / 20_000.0;
            }
        }
        // 20 s hold 500 independent stretches of twice the disturbance time: the deviation is known to 1 in sqrt(1000),
        // and four times that is allowed.
        for square in squares {
            assert!((square.sqrt() / 0.2 - 1.0).abs() < 0.13, "{}", square.sqrt());
        }
    }
}
