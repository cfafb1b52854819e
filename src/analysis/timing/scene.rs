//! What a robot can do about an obstacle, from what it looks at and how it drives.

use std::f64::consts::{PI, TAU};

use super::Reaction;
use super::looks::Look;
use super::motions::Motion;
use crate::base::{Id, Span};
use crate::ir::{DifferentialDrive, Mode, Program, Robot, Sensor, SensorSource};

/// The speed of sound in air of 20 °C, m/s.
const SOUND: f64 = 343.0;

/// A robot that is looked at.
pub(super) struct Scene<'a> {
    pub(super) program: &'a Program,
    pub(super) robot: &'a Robot,
    pub(super) body: &'a DifferentialDrive,
    /// The longest tick, in nanoseconds; 0 for ticks that are short.
    pub(super) tick: u64,
}

impl Scene<'_> {
    /// Forward and backward, at the fastest of some commands.
    pub(super) fn reactions(
        &self,
        mode: Option<Id<Mode>>,
        own: &[Motion],
        all: &[Motion],
        looks: &[Look],
        deadline: u64,
    ) -> Vec<Reaction> {
        let way = |sign: f64| {
            let fast = own.iter().filter(|motion| motion.goes_on && motion.speed * sign > 0.0);
            let fastest = fast.max_by(|one, other| one.speed.abs().total_cmp(&other.speed.abs()))?;
            let (speed, bearing) = (fastest.speed.abs(), if sign > 0.0 { 0.0 } else { PI });
            let back = all.iter().map(|motion| -motion.speed * sign).fold(0.0, f64::max);
            let stop = if all.iter().all(|motion| motion.is_straight) { stopping(self.body, speed, back) } else { 0.0 };
            let reactions = looks.iter().flat_map(|look| self.told(look, bearing)).map(|told| {
                let wait = told.wait as f64 / 1e9;
                Reaction {
                    mode,
                    command: fastest.span,
                    speed: fastest.speed,
                    sensor: told.sensor,
                    condition: told.span,
                    begins: told.begins,
                    accuracy: told.accuracy,
                    wait: told.wait,
                    late: told.accuracy + speed * wait,
                    stop,
                }
            });
            let best = reactions.max_by(|one, other| one.left().total_cmp(&other.left()))?;
            // A mode that ends before it gets there does something else.
            let lost = stopping(self.body, speed, 0.0);
            (speed * (deadline as f64 / 1e9) > best.begins + lost).then_some(best)
        };
        [1.0, -1.0].into_iter().filter_map(way).collect()
    }

    /// The sensors behind a look that see that way, and how late each tells.
    fn told(&self, look: &Look, bearing: f64) -> Vec<Told> {
        let Look { sensor, at, delay, span } = *look;
        let name = &self.program.sensors[sensor].symbol.name;
        let own = self.robot.all_sensors().into_iter().find(|own| self.program.sensors[*own].symbol.name == *name);
        let sensor = own.unwrap_or(sensor);
        let members = match &self.program.sensors[sensor].group {
            Some(group) => group.of.iter().copied().zip(group.readings.iter().copied()).collect(),
            None => vec![(sensor, 1)],
        };
        let ahead = members.into_iter().filter(|(member, _)| sees(&self.program.sensors[*member], bearing));
        let told = ahead.map(|(member, count)| {
            let member = &self.program.sensors[member];
            let wait = self.in_ticks(measuring_time(member)).saturating_mul(u64::from(count) + 1) / 2;
            Told {
                sensor,
                begins: at,
                accuracy: member.accuracy.to_f64(),
                wait: wait.saturating_add(if delay > 0 { self.in_ticks(delay) } else { 0 }),
                span,
            }
        });
        told.collect()
    }

    /// A time as long as it is in whole ticks, of which there is one at least.
    fn in_ticks(&self, time: u64) -> u64 {
        if self.tick == 0 { time } else { time.div_ceil(self.tick).max(1).saturating_mul(self.tick) }
    }
}

/// A sensor that tells of an obstacle.
struct Told {
    sensor: Id<Sensor>,
    begins: f64,
    accuracy: f64,
    wait: u64,
    span: Span,
}

/// Nanoseconds between two readings: the sensor's period, or the time that sound takes to the farthest place and back,
/// t_m = 2 y_max / v_sound.
fn measuring_time(sensor: &Sensor) -> u64 {
    if sensor.period > 0 { sensor.period } else { (2.0 * sensor.range.1.to_f64() / SOUND * 1e9).ceil() as u64 }
}

/// Whether a sensor is a range sensor whose beam covers a bearing.
fn sees(sensor: &Sensor, bearing: f64) -> bool {
    /// The edges of beams that meet are not parted by rounding.
    const ROUNDING: f64 = 1e-9;
    let Some(SensorSource::Range { beam, of }) = sensor.source else { return false };
    let own = if of > 1 { (f64::from(beam) + 0.5) * TAU / f64::from(of) } else { 0.0 };
    let beside = (own - bearing).rem_euclid(TAU);
    beside.min(TAU - beside) <= sensor.beam / 2.0 + ROUNDING
}

/// The way from a speed to a stand while a speed of `back` the other way is commanded, m: at the acceleration limit as
/// long as the lag asks for more, then along the lag.
fn stopping(body: &DifferentialDrive, speed: f64, back: f64) -> f64 {
    let (limit, lag) = (body.acceleration_limit, body.lag);
    let along = (limit * lag - back).clamp(0.0, speed);
    let braking = (speed * speed - along * along) / (2.0 * limit);
    let coasting = if back > 0.0 { along - back * (along / back).ln_1p() } else { along };
    braking + coasting * lag
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_robot_stands_after_braking_and_coasting() {
        let body = DifferentialDrive {
            mass: 1.0,
            length: 1.0,
            width: 1.0,
            track: 1.0,
            traction: 1.0,
            lag: 0.2,
            acceleration_limit: 1.0,
            impact_time: 0.1,
            tracking_noise: 0.0,
        };
        // Below 0.2 m/s the lag alone; above, from there at 1 m/s².
        let way = |speed, back| stopping(&body, speed, back);
        assert!((way(0.1, 0.0) - 0.02).abs() < 1e-12);
        assert!((way(1.0, 0.0) - ((1.0 - 0.04) / 2.0 + 0.04)).abs() < 1e-12);
        assert!((way(1.0, 5.0) - 0.5).abs() < 1e-12);
        // In small steps, as the body does.
        let (mut speed, mut gone): (f64, f64) = (0.5, 0.0);
        while speed > 0.0 {
            gone += speed * 1e-6;
            speed -= ((speed + 0.1) / 0.2).min(1.0) * 1e-6;
        }
        assert!((way(0.5, 0.1) - gone).abs() < 1e-5, "{gone}");
    }
}
