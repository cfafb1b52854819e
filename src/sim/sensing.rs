//! What sensors say: the truth of the body and its world, accuracy, noise, periods and faults.

use nalgebra::Vector2;

use super::body::Body;
use super::planner::{Planner, Request};
use super::random::{Purpose, Stream};
use super::ring::Ring;
use super::world::{End, World};
use crate::base::Id;
use crate::interp::Reading;
use crate::ir::{self, FaultReading, SensorSource};

/// The sensors of a robot during a run.
#[derive(Debug)]
pub(super) struct Sensing<'a> {
    sensors: Vec<Gauge<'a>>,
    rings: Vec<Ring>,
    /// The instant at which each ring looked around last, in nanoseconds.
    looked: Vec<Option<u64>>,
    goal: Option<Vector2<f64>>,
    planner: Option<Planner>,
    /// Faults in order, with the position of their sensor; readings stuck somewhere have been drawn.
    faults: Vec<(usize, ir::Fault)>,
    noise: Stream,
    readings: Vec<Reading>,
}

/// A sensor.
#[derive(Debug)]
struct Gauge<'a> {
    sensor: &'a ir::Sensor,
    /// The readings it can give, in SI.
    range: (f64, f64),
    /// How far it may be off, in SI.
    accuracy: f64,
    /// Which of the rings it is a beam of; 0 for one that is none.
    ring: usize,
    /// Its last reading, before faults; `None` without a source, or without a goal to find.
    value: Option<f64>,
    /// When it is read again, in nanoseconds.
    due: u64,
}

impl<'a> Sensing<'a> {
    /// The sensors of a scenario's robot in its world, none read yet.
    pub(super) fn new<'f>(
        program: &'a ir::Program,
        scenario: &ir::Scenario,
        world: &World,
        faults: impl Iterator<Item = &'f ir::Fault>,
        seed: u64,
    ) -> Self {
        let robot = &program.robots[scenario.robot];
        let mut rings: Vec<(Ring, Key)> = Vec::new();
        let gauge = |&sensor: &Id<ir::Sensor>| {
            let sensor = &program.sensors[sensor];
            let range = (sensor.range.0.to_f64(), sensor.range.1.to_f64());
            let mut ring = 0;
            if let Some(SensorSource::Range { of, .. }) = sensor.source {
                let key = (of, sensor.beam, range.1);
                ring = rings.iter().position(|(_, known)| *known == key).unwrap_or(rings.len());
                if ring == rings.len() {
                    rings.push((Ring::new(of, sensor.beam, range.1, &world.robot()), key));
                }
            }
            Gauge { sensor, range, accuracy: sensor.accuracy.to_f64(), ring, value: None, due: 0 }
        };
        let sensors: Vec<_> = robot.sensors.iter().map(gauge).collect();
        let is_planned = |gauge: &Gauge<'_>| {
            matches!(gauge.sensor.source, Some(SensorSource::WaypointDistance | SensorSource::WaypointBearing))
        };
        let shape = world.robot();
        let planner = sensors.iter().any(is_planned);
        let planner = planner.then(|| Planner::new(scenario, shape.middle(), shape.half.norm()));
        let mut stream = Stream::new(seed, Purpose::Faults);
        let place = |fault: &ir::Fault| robot.sensors.iter().position(|&sensor| sensor == fault.sensor);
        let faults = faults.filter_map(|fault| Some((place(fault)?, fault.clone()))).map(|(sensor, mut fault)| {
            if fault.reading == FaultReading::StuckSomewhere {
                let (low, high) = sensors[sensor].range;
                fault.reading = FaultReading::Stuck(stream.between(low, high));
            }
            (sensor, fault)
        });
        Self {
            faults: faults.collect(),
            looked: vec![None; rings.len()],
            rings: rings.into_iter().map(|(ring, _)| ring).collect(),
            goal: scenario.goal.map(Vector2::from),
            planner: planner.flatten(),
            noise: Stream::new(seed, Purpose::Sensors),
            readings: vec![Reading { value: f64::NAN, healthy: false }; sensors.len()],
            sensors,
        }
    }

    /// Reads all sensors at `time`, in nanoseconds. A sensor that the body does not provide counts as failed.
    pub(super) fn read(&mut self, body: &Body<'_>, world: &World, time: u64) -> &mut [Reading] {
        for (gauge, reading) in self.sensors.iter_mut().zip(&mut self.readings) {
            let Gauge { sensor, range, accuracy, .. } = *gauge;
            if time >= gauge.due {
                let truth = match sensor.source {
                    Some(SensorSource::Range { beam, .. }) => {
                        let ring = &mut self.rings[gauge.ring];
                        if self.looked[gauge.ring].replace(time) != Some(time) {
                            ring.look(world);
                        }
                        Some(ring.distance(beam))
                    }
                    Some(source) => {
                        let waypoint = self.planner.as_ref().and_then(Planner::waypoint);
                        measure(body, world, [self.goal, waypoint], source)
                    }
                    None => None,
                };
                // Drawn whether or not a fault hides it, so that a fault leaves the noise of other sensors alone.
                let noise = if sensor.noise > 0.0 { self.noise.normal() * sensor.noise } else { 0.0 };
                let error = if accuracy > 0.0 { self.noise.between(-accuracy, accuracy) } else { 0.0 };
                gauge.value = truth.map(|truth| match sensor.source {
                    // Nothing in sight is no distance to err about.
                    Some(SensorSource::Range { .. }) if truth >= range.1 => range.1,
                    Some(SensorSource::Range { .. }) => (truth + noise + error).clamp(range.0, range.1),
                    _ => truth + noise + error,
                });
                // Counted on from when it was due, so that ticks beside the period do not stretch it.
                if let Some(periods) = (time - gauge.due).checked_div(sensor.period) {
                    gauge.due += (periods + 1) * sensor.period;
                }
            }
            *reading = Reading { value: gauge.value.unwrap_or(f64::NAN), healthy: gauge.value.is_some() };
        }
        self.learn(world, time);
        for (sensor, fault) in &self.faults {
            if fault.window.contains(time) {
                self.readings[*sensor] = match fault.reading {
                    FaultReading::Stuck(value) => Reading { value, healthy: true },
                    FaultReading::Reported | FaultReading::StuckSomewhere => {
                        Reading { value: f64::NAN, healthy: false }
                    }
                };
            }
        }
        &mut self.readings
    }
}

impl Sensing<'_> {
    /// Asks the planner.
    pub(super) fn plan(&mut self, request: Request, world: &World) {
        if let Some(planner) = &mut self.planner {
            planner.obey(request, world.robot().middle());
        }
    }

    /// Tells the planner what was seen at `time`, as far as a beam tells where.
    fn learn(&mut self, world: &World, time: u64) {
        let Some(mut planner) = self.planner.take() else { return };
        let exact = planner.exactness();
        let seen =
            self.seen(world, time).filter(|(gauge, distance, _)| distance * (gauge.sensor.beam / 2.0).sin() <= exact);
        seen.for_each(|(_, _, place)| planner.learn(place));
        self.planner = Some(planner);
    }

    /// Where range sensors that were read at `time` met something, as they said, m.
    pub(super) fn hits(&self, world: &World, time: u64) -> impl Iterator<Item = [f64; 2]> {
        self.seen(world, time).map(|(_, _, place)| place.into())
    }

    /// The range sensors that were read at `time` and met something: how far away, and where, m.
    fn seen(&self, world: &World, time: u64) -> impl Iterator<Item = (&Gauge<'_>, f64, Vector2<f64>)> {
        let robot = world.robot();
        let seen = self.sensors.iter().filter(move |gauge| self.looked.get(gauge.ring) == Some(&Some(time)));
        seen.filter_map(move |gauge| {
            let (Some(SensorSource::Range { beam, .. }), Some(value)) = (gauge.sensor.source, gauge.value) else {
                return None;
            };
            let place = robot.middle() + robot.pose.rotation * self.rings.get(gauge.ring)?.place(beam, value);
            (value < gauge.range.1).then_some((gauge, value, place))
        })
    }
}

/// What the beams of one ring have in common: how many there are, and how wide (rad) and far (m) they see.
type Key = (u32, f64, f64);

/// The true value at a place of the body, in SI; `None` where there is no goal or no temporary one, and of
/// wheels that cannot be measured. Ranges are measured a ring at a time.
fn measure(
    body: &Body<'_>,
    world: &World,
    [goal, waypoint]: [Option<Vector2<f64>>; 2],
    source: SensorSource,
) -> Option<f64> {
    let truth = |is_so| f64::from(u8::from(is_so));
    let middle = world.robot().middle();
    let bearing = |place: Vector2<f64>| {
        let way = world.robot().pose.rotation.inverse_transform_vector(&(place - middle));
        way.y.atan2(way.x)
    };
    let value = match source {
        // Told by the drive, and by an arbiter to each of its clients.
        SensorSource::Won
        | SensorSource::Lost
        | SensorSource::State
        | SensorSource::Command
        | SensorSource::Argument(_) => 0.0,
        SensorSource::LeftWheelAcceleration => body.wheels()?.accelerations()[0],
        SensorSource::RightWheelAcceleration => body.wheels()?.accelerations()[1],
        SensorSource::LeftWheelSpeed => body.wheels()?.speeds()[0],
        SensorSource::RightWheelSpeed => body.wheels()?.speeds()[1],
        SensorSource::WedgeForce => body.wheels()?.wedge_force(),
        SensorSource::FrontBumper => truth(world.is_touched(End::Front)),
        SensorSource::BackBumper => truth(world.is_touched(End::Back)),
        SensorSource::X => middle.x,
        SensorSource::Y => middle.y,
        SensorSource::Heading => world.robot().pose.rotation.angle(),
        SensorSource::GoalDistance => (goal? - middle).norm(),
        SensorSource::WaypointDistance => (waypoint? - middle).norm(),
        SensorSource::GoalBearing => bearing(goal?),
        SensorSource::WaypointBearing => bearing(waypoint?),
        SensorSource::Range { .. } => return None,
    };
    Some(value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Span;
    use crate::ir::Window;
    use crate::sim::Simulation;
    use crate::sim::fixture::{J5, program, scenario};

    fn fault(sensor: u32, reading: FaultReading, from: u64, to: u64) -> ir::Fault {
        ir::Fault { sensor: Id::new(sensor), reading, window: Window { from, to }, span: Span::default() }
    }

    /// What a resting robot's sensors read at 0, 1, 2, ... ns.
    fn readings(program: &ir::Program, faults: &[ir::Fault], seed: u64, count: u64) -> Vec<Vec<Reading>> {
        let mut simulation = Simulation::new(program, &scenario(), faults.iter(), seed).unwrap();
        (0..count).map(|time| simulation.read(time).to_vec()).collect()
    }

    fn noisy() -> ir::Program {
        let mut program = program(J5);
        for sensor in 0..3 {
            program.sensors[Id::new(sensor)].noise = 2.0;
        }
        program
    }

    #[test]
    fn noise_is_as_large_as_declared() {
        let readings = readings(&noisy(), &[], 1, 10_000);
        let variance = readings.iter().map(|reading| reading[2].value.powi(2)).sum::<f64>() / 1e4;
        // A mean of 10 000 squares deviates by sqrt(2)/100 of it; four times as much is allowed.
        assert!((variance / 4.0 - 1.0).abs() < 0.06, "{variance}");
        assert!(readings.iter().all(|reading| reading[0].value != reading[1].value));
    }

    #[test]
    fn a_stuck_sensor_is_silent_about_it_and_leaves_the_others_alone() {
        let stuck = [fault(2, FaultReading::Stuck(7.0), 10, 19)];
        let (well, faulty) = (readings(&noisy(), &[], 1, 30), readings(&noisy(), &stuck, 1, 30));
        for (time, (well, faulty)) in well.iter().zip(&faulty).enumerate() {
            assert_eq!(well[..2], faulty[..2]);
            let inside = (10..20).contains(&time);
            let expected = if inside { Reading { value: 7.0, healthy: true } } else { well[2] };
            assert_eq!(faulty[2], expected, "{time}");
        }
    }

    #[test]
    fn a_sensor_stuck_somewhere_reads_one_constant_in_range() {
        let mut seen = Vec::new();
        for seed in 0..20 {
            let stuck = [fault(0, FaultReading::StuckSomewhere, 0, u64::MAX)];
            let readings = readings(&noisy(), &stuck, seed, 5);
            let first = readings[0][0];
            assert!(first.healthy && (-4.0..=4.0).contains(&first.value));
            assert!(readings.iter().all(|reading| reading[0] == first));
            seen.push(first.value);
        }
        assert!(seen.iter().any(|value| *value < 0.0) && seen.iter().any(|value| *value > 0.0));
    }

    #[test]
    fn a_reported_fault_is_known_and_of_two_faults_the_later_counts() {
        let faults = [fault(1, FaultReading::Reported, 0, 20), fault(1, FaultReading::Stuck(1.0), 10, 30)];
        let readings = readings(&noisy(), &faults, 1, 40);
        assert!(!readings[5][1].healthy && readings[5][1].value.is_nan());
        assert_eq!(readings[15][1], Reading { value: 1.0, healthy: true });
        assert!(readings[35][1].healthy && readings[35][1].value != 1.0);
    }

    #[test]
    fn a_sensor_with_a_period_keeps_its_reading() {
        let mut program = noisy();
        program.sensors[Id::new(0)].period = 7;
        let readings = readings(&program, &[], 1, 50);
        for (time, pair) in (1..).zip(readings.windows(2)) {
            assert_eq!(pair[0][0] != pair[1][0], time % 7 == 0, "{time}");
        }
    }

    #[test]
    fn a_sensor_that_the_body_does_not_provide_has_failed() {
        let mut program = noisy();
        program.sensors[Id::new(0)].source = None;
        assert!(!readings(&program, &[], 1, 1)[0][0].healthy);
    }
}
