//! Sensors of robots that do not say how they fail.

use std::collections::BTreeSet;

use super::looks::View;
use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{FailReading, Program, Robot, Sensor};

/// Warns of the sensors of a robot that a diagram looks at, if neither they nor the variables they feed say how they
/// fail.
pub(in crate::analysis) fn check_robot(program: &Program, robot: &Robot, findings: &mut Vec<Diagnostic>) {
    let says_nothing = |sensor: &Id<Sensor>| {
        let sensor = &program.sensors[*sensor];
        sensor.fails.is_empty() && !sensor.is_inner()
    };
    let mut silent: BTreeSet<_> = robot.sensors.iter().copied().filter(says_nothing).collect();
    let fed = || {
        program.diagrams.values().flat_map(|diagram| &diagram.senses).flat_map(|sense| {
            let inputs = &program.networks[sense.network].inputs;
            sense
                .inputs
                .iter()
                .zip(inputs)
                .flat_map(|(sensor, input)| program.members(*sensor).into_iter().map(|sensor| (sensor, input.variable)))
                .map(|(sensor, variable)| (sensor, program.variables[variable].fails.as_slice()))
        })
    };
    for (sensor, fails) in fed() {
        if !fails.is_empty() {
            silent.remove(&sensor);
        }
    }
    if silent.is_empty() {
        return;
    }
    let mut used: BTreeSet<_> = fed().map(|(sensor, _): (_, &[FailReading])| sensor).collect();
    for diagram in program.diagrams.values() {
        let views = View::of_modes(program, diagram);
        let looks = views.iter().flat_map(|view| view.exits.iter().chain(&view.rows));
        used.extend(looks.flat_map(|looks| &looks.compared).flat_map(|sensor| program.members(*sensor)));
    }
    // The elements of an array are declared in one place.
    let mut found: Vec<_> = silent.intersection(&used).map(|sensor| &program.sensors[*sensor]).collect();
    found.dedup_by_key(|sensor| sensor.symbol.span);
    findings.extend(found.into_iter().map(sensor_without_fails));
}

fn sensor_without_fails(sensor: &Sensor) -> Diagnostic {
    let name = sensor.symbol.name.split('[').next().unwrap_or_default();
    let message = format!("`{name}` does not say how it fails");
    let (low, high) = sensor.range;
    let reading = sensor.unit.show(crate::base::Exact::ZERO.clamp(low, high).to_f64());
    Diagnostic::new(&rules::SENSOR_WITHOUT_FAILS, sensor.symbol.span, message)
        .here("a behavior depends on it")
        .note(format!(
            "once it is known to have failed, the machine reads {reading}; silent failures are not looked at"
        ))
        .help("write what it reads when it fails, such as `fails 0` or `fails any`")
}
