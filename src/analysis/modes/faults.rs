//! Failed sensors: which, how, and what is then read.

use std::collections::BTreeSet;

use crate::analysis::support::{Cut, Interval};
use crate::base::{Exact, Id};
use crate::ir::{Diagram, FailReading, Platform, Program, Sensor};

/// How a sensor has failed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fault {
    /// The machine knows, and uses the fail reading.
    Reported,
    /// Silently stuck at a reading, in SI.
    Stuck(Exact),
    /// Silently stuck at one unknown reading between these two, in SI.
    Between(Exact, Exact),
    /// Silently without any degree of membership.
    Absent,
}

/// Failed sensors, each once, by their ids.
pub type FaultSet = Vec<(Id<Sensor>, Fault)>;

/// How a sensor has failed, if it has.
pub(super) fn of(faults: &FaultSet, sensor: Id<Sensor>) -> Option<Fault> {
    faults.iter().find(|(failed, _)| *failed == sensor).map(|(_, fault)| *fault)
}

/// Whether a sensor is known to have failed, by itself or with all of a logical sensor.
pub(super) fn is_reported(program: &Program, faults: &FaultSet, sensor: Id<Sensor>) -> bool {
    let concerns = |failed: Id<Sensor>| {
        failed == sensor || program.sensors[failed].group.as_ref().is_some_and(|group| group.of.contains(&sensor))
    };
    faults.iter().any(|(failed, fault)| *fault == Fault::Reported && concerns(*failed))
}

/// The logical sensors all of whose members are among some sensors.
pub(in crate::analysis) fn groups_within(
    program: &Program,
    diagram: &Diagram,
    sensors: &BTreeSet<Id<Sensor>>,
) -> Vec<Id<Sensor>> {
    let is_within = |sensor: &Id<Sensor>| {
        let group = program.sensors[*sensor].group.as_ref();
        group.is_some_and(|group| group.of.iter().all(|member| sensors.contains(member)))
    };
    program.sensors_of(diagram.platform).into_iter().filter(is_within).collect()
}

/// The readings a sensor can give; `None` where it gives no degree at all.
pub(super) fn readings(
    program: &Program,
    diagram: &Diagram,
    sensor: Id<Sensor>,
    faults: &FaultSet,
) -> Option<Interval> {
    let range = program.sensors[sensor].range;
    let whole = (Cut::before(range.0), Cut::after(range.1));
    let point = |at: Exact| (Cut::before(at), Cut::after(at));
    match of(faults, sensor) {
        None => Some(whole),
        Some(Fault::Reported) => Some(fail_reading(program, diagram, sensor).map_or(whole, point)),
        Some(Fault::Stuck(at)) => Some(point(at)),
        Some(Fault::Between(low, high)) => Some((Cut::after(low), Cut::before(high))),
        Some(Fault::Absent) => None,
    }
}

/// What the machine reads for a sensor known to have failed, or for a logical one all of whose sensors are; unknown on
/// an interface, whose robots each say it, and where only some sensors of a logical one say it.
pub(super) fn fail_reading(program: &Program, diagram: &Diagram, sensor: Id<Sensor>) -> Option<Exact> {
    if matches!(diagram.platform, Platform::Interface(_)) {
        return None;
    }
    let says = |fail: &FailReading| matches!(fail, FailReading::Value(_));
    if let Some(group) = &program.sensors[sensor].group {
        let saying = group.of.iter().filter(|member| program.sensors[**member].fails.iter().any(says)).count();
        let mut by_themselves = group.of.iter().flat_map(|&member| fails_of_variables(program, diagram, member));
        let is_told = saying == 0 && by_themselves.next().is_none();
        if saying < group.of.len() && !(is_told && fails_of_variables(program, diagram, sensor).any(says)) {
            return None;
        }
    }
    let own = program.sensors[sensor].fails.iter();
    let stuck = |fail: &FailReading| match fail {
        FailReading::Value(value) => Some(*value),
        FailReading::Any | FailReading::Absent => None,
    };
    let (low, high) = program.sensors[sensor].range;
    own.chain(fails_of_variables(program, diagram, sensor)).find_map(stuck).or(Some(Exact::ZERO.clamp(low, high)))
}

/// What the variables that a sensor feeds say of its failing.
pub(super) fn fails_of_variables<'a>(
    program: &'a Program,
    diagram: &'a Diagram,
    sensor: Id<Sensor>,
) -> impl Iterator<Item = &'a FailReading> {
    diagram.senses.iter().flat_map(move |sense| {
        let inputs = sense.inputs.iter().zip(&program.networks[sense.network].inputs);
        let fed = inputs.filter(move |(fed, _)| **fed == sensor);
        fed.flat_map(|(_, input)| &program.variables[input.variable].fails)
    })
}
