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
                while sensor.period > 0 && self.due[index] <= time {
                    self.due[index] += sensor.period;
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
