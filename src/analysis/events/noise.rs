//! A flag that the noise of its sensors changes while the robot is at rest.

use std::collections::HashMap;

use super::at_rest::rest;
use super::{HEALTHY, whole};
use crate::analysis::network::{Feed, Model, Reading};
use crate::analysis::{Source, source};
use crate::base::{Exact, Id};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Event, Program, Sense, Sensor};

/// What noise does to networks, each looked at once over the same sensors.
#[derive(Default)]
pub(in crate::analysis) struct Noise {
    known: HashMap<Source, Vec<Flip>>,
}

/// The position of an event, and a sensor whose noise changes it; how much of a change does it.
struct Flip(usize, Id<Sensor>, Reading);

impl Noise {
    pub(in crate::analysis) fn check(&mut self, program: &Program, diagram: &Diagram, findings: &mut Vec<Diagnostic>) {
        for sense in &diagram.senses {
            let flips = self.known.entry(source(sense)).or_insert_with(|| flips(program, sense));
            findings.extend(flips.iter().map(|flip| noise_above_margin(program, sense, flip)));
        }
    }
}

fn flips(program: &Program, sense: &Sense) -> Vec<Flip> {
    let network = &program.networks[sense.network];
    let sensors: Vec<_> = sense.inputs.iter().map(|&sensor| &program.sensors[sensor]).collect();
    let is_noisy = sensors.iter().any(|sensor| sensor.noise > 0.0);
    let can_rest = |sensor: &&Sensor| sensor.range.0 <= Exact::ZERO && sensor.range.1 >= Exact::ZERO;
    let is_whole = sensors.len() == network.inputs.len() && whole(program, network);
    if !is_noisy || !is_whole || !sensors.iter().all(can_rest) {
        return Vec::new();
    }
    let feeds: Vec<_> = sensors.iter().map(|sensor| Feed { range: sensor.range, fails: Vec::new() }).collect();
    let Some(model) = Model::fed_by(program, network, &feeds) else { return Vec::new() };
    let of_event = |(index, event): (usize, &Event)| {
        let is_large = event.contributor.len() + event.detractor.len() > super::MOST_RULES;
        let remembers = !event.hysteresis.is_zero() || event.hold > 0 || event.confirm > 0;
        let rest = rest(program, network, event).filter(|_| !remembers && !is_large);
        let margins = rest.map(|rest| model.margins(index, &HEALTHY, &model.complete(&HEALTHY, &rest)));
        let flip = |(&id, margin): (&Id<Sensor>, Option<Reading>)| {
            // A sensor that feeds several inputs changes them together, which the margins of each do not tell.
            let feeds_one = sense.inputs.iter().filter(|other| **other == id).count() == 1;
            let margin = margin.filter(|margin| feeds_one && margin.to_f64() < program.sensors[id].noise);
            Some(Flip(index, id, margin?))
        };
        sense.inputs.iter().zip(margins.into_iter().flatten()).filter_map(flip).collect::<Vec<_>>()
    };
    network.events.iter().enumerate().flat_map(of_event).collect()
}

fn noise_above_margin(program: &Program, sense: &Sense, Flip(event, sensor, margin): &Flip) -> Diagnostic {
    let (event, sensor) = (&program.networks[sense.network].events[*event], &program.sensors[*sensor]);
    let (name, sensor_name) = (&event.symbol.name, &sensor.symbol.name);
    let (noise, margin) = (sensor.unit.show(sensor.noise), sensor.unit.show(margin.to_f64()));
    let message = format!("the noise of `{sensor_name}` changes `{name}` while the robot is at rest");
    Diagnostic::new(&rules::NOISE_ABOVE_MARGIN, sense.symbol.span, message)
        .label(event.symbol.span, format!("a change of {margin} may do it while all readings are 0"))
        .label(sensor.symbol.span, format!("its noise has a standard deviation of {noise}"))
        .note("an event without `hysteresis`, `hold` or `confirm` follows every reading")
        .help("give the event `hysteresis` or `confirm`, or let its terms begin further away from rest")
}
