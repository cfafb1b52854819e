//! A flag that the noise of its sensors changes while the robot is at rest.

use super::at_rest::rest;
use super::{HEALTHY, whole};
use crate::analysis::network::{Feed, Model, Reading};
use crate::base::{Exact, Id};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Event, Program, Sense, Sensor};

pub(in crate::analysis) fn check(program: &Program, diagram: &Diagram, findings: &mut Vec<Diagnostic>) {
    for sense in &diagram.senses {
        let network = &program.networks[sense.network];
        let sensors: Vec<_> = sense.inputs.iter().map(|&sensor| &program.sensors[sensor]).collect();
        let is_noisy = sensors.iter().any(|sensor| sensor.noise > 0.0);
        let is_whole = sensors.len() == network.inputs.len() && whole(program, network);
        if !is_noisy || !is_whole {
            continue;
        }
        let feeds: Vec<_> = sensors.iter().map(|sensor| Feed { range: sensor.range, fails: Vec::new() }).collect();
        if let Some(model) = Model::fed_by(program, network, &feeds) {
            for (index, event) in network.events.iter().enumerate() {
                check_event(program, sense, &model, (index, event), findings);
            }
        }
    }
}

fn check_event(
    program: &Program,
    sense: &Sense,
    model: &Model,
    (index, event): (usize, &Event),
    findings: &mut Vec<Diagnostic>,
) {
    let network = &program.networks[sense.network];
    let is_large = event.contributor.len() + event.detractor.len() > super::MOST_RULES;
    let remembers = !event.hysteresis.is_zero() || event.hold > 0 || event.confirm > 0;
    let Some(rest) = rest(program, network, event).filter(|_| !remembers && !is_large) else { return };
    let can_rest = |&sensor: &Id<Sensor>| {
        let (low, high) = program.sensors[sensor].range;
        low <= Exact::ZERO && high >= Exact::ZERO
    };
    if !sense.inputs.iter().all(can_rest) {
        return;
    }
    let margins = model.margins(index, &HEALTHY, &model.complete(&HEALTHY, &rest));
    for (id, margin) in sense.inputs.iter().zip(&margins) {
        let sensor = &program.sensors[*id];
        // A sensor that feeds several inputs changes them together, which the margins of each do not tell.
        let feeds_one = sense.inputs.iter().filter(|other| *other == id).count() == 1;
        if let Some(margin) = margin.as_ref().filter(|margin| feeds_one && margin.to_f64() < sensor.noise) {
            findings.push(noise_above_margin(sense, event, sensor, margin));
        }
    }
}

fn noise_above_margin(sense: &Sense, event: &Event, sensor: &Sensor, margin: &Reading) -> Diagnostic {
    let (name, sensor_name) = (&event.symbol.name, &sensor.symbol.name);
    let (noise, margin) = (sensor.unit.show(sensor.noise), sensor.unit.show(margin.to_f64()));
    let message = format!("the noise of `{sensor_name}` changes `{name}` while the robot is at rest");
    Diagnostic::new(&rules::NOISE_ABOVE_MARGIN, sense.symbol.span, message)
        .label(event.symbol.span, format!("a change of {margin} may do it while all readings are 0"))
        .label(sensor.symbol.span, format!("its noise has a standard deviation of {noise}"))
        .note("an event without `hysteresis`, `hold` or `confirm` follows every reading")
        .help("give the event `hysteresis` or `confirm`, or let its terms begin further away from rest")
}
