//! What sensors can tell the machine, in numbers that a scenario can be written with.

use crate::analysis::modes::Stimulus;
use crate::base::{Exact, Id, Unit};
use crate::interp::Reading;
use crate::ir::{Diagram, Grouping, Program, Sensor};

/// A reading as it is written, and what it is then.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// In the sensor's own unit.
    pub written: f64,
    /// In SI.
    pub si: f64,
}

impl Number {
    /// `None` for a number with more digits than a literal can have.
    pub fn new(written: f64, unit: &Unit) -> Option<Self> {
        let exact = Exact::parse(&written.to_string())?.times(unit.scale)?;
        Some(Self { written, si: exact.to_f64() })
    }

    /// The same for a number in SI, as near as it can be written.
    pub fn exactly(si: Exact, unit: &Unit) -> Option<Self> {
        Self::new(si.over(unit.scale)?.to_f64(), unit)
    }
}

/// What each sensor of a robot says, in order; `None` for one that is known to have failed.
pub type Told = Vec<Option<Number>>;

/// As the machine takes it.
pub fn readings(told: &Told) -> Vec<Reading> {
    let reading = |number: &Option<Number>| match number {
        Some(number) => Reading { value: number.si, healthy: true },
        None => Reading { value: f64::NAN, healthy: false },
    };
    told.iter().map(reading).collect()
}

/// The same for some ticks.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// What the sensors say.
    pub told: Told,
    /// Whether the action of the mode has reported completion.
    pub done: bool,
    /// On how many ticks.
    pub ticks: u64,
}

/// A kind of tick worth trying.
pub(super) struct Cue {
    numbers: Vec<(usize, Number)>,
    failed: Vec<usize>,
    pub(super) done: bool,
}

/// What a robot's sensors can be made to say.
pub(super) struct Cues {
    /// By mode.
    pub(super) of_mode: Vec<Vec<Cue>>,
    /// What they say before anything is tried.
    pub(super) rest: Told,
    /// Whether the diagram looks at each of them.
    pub(super) matters: Vec<bool>,
}

impl Cues {
    /// `None` where a number of a range cannot be written.
    pub(super) fn new(program: &Program, diagram: &Diagram, stimuli: &[Vec<Stimulus>]) -> Option<Self> {
        let sensors = program.measuring(diagram.platform);
        // A logical sensor reads what all of its members read, if it is a reading like theirs.
        let is_opening = |sensor: Id<Sensor>| {
            let group = program.sensors[sensor].group.as_ref();
            group.is_some_and(|group| matches!(group.how, Grouping::Widest { .. }))
        };
        let places = |sensor: Id<Sensor>| {
            program
                .members(sensor)
                .into_iter()
                .filter_map(|sensor| sensors.iter().position(|own| *own == sensor))
                .collect::<Vec<_>>()
        };
        let unit = |sensor: Id<Sensor>| &program.sensors[sensor].unit;
        let cue = |stimulus: &Stimulus| {
            let told = |(sensor, _): &&(Id<Sensor>, Exact)| !stimulus.failed.contains(sensor) && !is_opening(*sensor);
            let read = stimulus.readings.iter().filter(told);
            let number = |(sensor, at): &(Id<Sensor>, Exact)| {
                let number = Number::exactly(*at, unit(*sensor))?;
                Some(places(*sensor).into_iter().map(move |place| (place, number)))
            };
            let numbers: Vec<_> = read.map(number).collect::<Option<_>>()?;
            Some(Cue {
                numbers: numbers.into_iter().flatten().collect(),
                failed: stimulus.failed.iter().flat_map(|sensor| places(*sensor)).collect(),
                done: stimulus.done,
            })
        };
        let rest = |&sensor: &Id<Sensor>| {
            let (low, high) = program.sensors[sensor].range;
            Number::exactly(Exact::ZERO.clamp(low, high), unit(sensor)).map(Some)
        };
        let of_mode: Vec<Vec<Cue>> = stimuli.iter().map(|of_mode| of_mode.iter().filter_map(cue).collect()).collect();
        let required = diagram.modes.values().flat_map(|mode| &mode.requires).flat_map(|(sensor, _)| places(*sensor));
        let mut matters = vec![false; sensors.len()];
        let told = of_mode.iter().flatten();
        let told = told.flat_map(|cue| cue.numbers.iter().map(|(place, _)| *place).chain(cue.failed.iter().copied()));
        told.chain(required).for_each(|place| matters[place] = true);
        Some(Self { of_mode, rest: sensors.iter().map(rest).collect::<Option<_>>()?, matters })
    }

    /// What is told when only what a cue needs changes.
    pub(super) fn apply(&self, now: &Told, cue: &Cue) -> Told {
        let mut told: Told = now.iter().zip(&self.rest).map(|(now, rest)| now.or(*rest)).collect();
        for (place, number) in &cue.numbers {
            told[*place] = Some(*number);
        }
        for place in &cue.failed {
            told[*place] = None;
        }
        told
    }
}
