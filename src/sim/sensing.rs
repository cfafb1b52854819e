//! What sensors say: the truth of the body, noise, periods and faults.

use super::differential_drive::DifferentialDrive;
use super::random::{Purpose, Stream};
use crate::interp::Reading;
use crate::ir::{self, FaultReading, SensorSource};

/// The sensors of a robot during a run.
#[derive(Debug)]
pub(super) struct Sensing<'a> {
    sensors: Vec<&'a ir::Sensor>,
    /// Faults in order, with the position of their sensor; readings stuck somewhere have been drawn.
    faults: Vec<(usize, ir::Fault)>,
    noise: Stream,
    /// The last reading of each sensor, before faults.
    values: Vec<f64>,
    /// When each sensor is read again, in nanoseconds.
    due: Vec<u64>,
    readings: Vec<Reading>,
}

impl<'a> Sensing<'a> {
    /// The sensors of `robot`, none read yet. `ranges` are the readings each can give, in SI.
    pub(super) fn new<'f>(
        program: &'a ir::Program,
        robot: &ir::Robot,
        ranges: &[(f64, f64)],
        faults: impl Iterator<Item = &'f ir::Fault>,
        seed: u64,
    ) -> Self {
        let mut stream = Stream::new(seed, Purpose::Faults);
        let place = |fault: &ir::Fault| robot.sensors.iter().position(|&sensor| sensor == fault.sensor);
        let faults = faults.filter_map(|fault| Some((place(fault)?, fault.clone()))).map(|(sensor, mut fault)| {
            if fault.reading == FaultReading::StuckSomewhere {
                let (low, high) = ranges.get(sensor).copied().unwrap_or_default();
                fault.reading = FaultReading::Stuck(stream.between(low, high));
            }
            (sensor, fault)
        });
        let count = robot.sensors.len();
        Self {
            faults: faults.collect(),
            sensors: robot.sensors.iter().map(|&sensor| &program.sensors[sensor]).collect(),
            noise: Stream::new(seed, Purpose::Sensors),
            values: vec![f64::NAN; count],
            due: vec![0; count],
            readings: vec![Reading { value: f64::NAN, healthy: false }; count],
        }
    }

    /// Reads all sensors at `time`, in nanoseconds. A sensor that the body does not provide counts as failed.
    pub(super) fn read(&mut self, body: &DifferentialDrive<'_>, time: u64) -> &[Reading] {
        for (index, sensor) in self.sensors.iter().enumerate() {
            if time >= self.due[index] {
                let truth = sensor.source.map_or(f64::NAN, |source| measure(body, source));
                // Drawn whether or not a fault hides it, so that a fault leaves the noise of other sensors alone.
                let noise = if sensor.noise > 0.0 { self.noise.normal() * sensor.noise } else { 0.0 };
                self.values[index] = truth + noise;
                // Counted on from when it was due, so that ticks beside the period do not stretch it.
                if let Some(periods) = (time - self.due[index]).checked_div(sensor.period) {
                    self.due[index] += (periods + 1) * sensor.period;
                }
            }
            self.readings[index] = Reading { value: self.values[index], healthy: sensor.source.is_some() };
        }
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
        &self.readings
    }
}

/// The true value at a place of the body, in SI.
fn measure(body: &DifferentialDrive<'_>, source: SensorSource) -> f64 {
    match source {
        SensorSource::LeftWheelAcceleration => body.accelerations()[0],
        SensorSource::RightWheelAcceleration => body.accelerations()[1],
        SensorSource::LeftWheelSpeed => body.speeds()[0],
        SensorSource::RightWheelSpeed => body.speeds()[1],
        SensorSource::WedgeForce => body.wedge_force(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::{Id, Span};
    use crate::ir::Window;
    use crate::sim::fixture::{J5, program};

    const RANGES: [(f64, f64); 3] = [(-4.0, 4.0), (-4.0, 4.0), (0.0, 400.0)];

    fn fault(sensor: u32, reading: FaultReading, from: u64, to: u64) -> ir::Fault {
        ir::Fault { sensor: Id::new(sensor), reading, window: Window { from, to }, span: Span::default() }
    }

    /// What a resting robot's sensors read at 0, 1, 2, ... ns.
    fn readings(program: &ir::Program, faults: &[ir::Fault], seed: u64, count: u64) -> Vec<Vec<Reading>> {
        let body = DifferentialDrive::new(&J5, seed);
        let robot = &program.robots[Id::new(0)];
        let mut sensing = Sensing::new(program, robot, &RANGES, faults.iter(), seed);
        (0..count).map(|time| sensing.read(&body, time).to_vec()).collect()
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
