//! The scenario that shows a run which refutes a property: it forces every reading that matters.

use std::fmt::Write;

use super::told::{Cues, Number, Stretch};
use crate::base::Unit;
use crate::ir::{self, ExpectationKind, FaultReading, Window};
use crate::plan::{self, Checked};
use crate::sim::{self, Run, RunOptions};

/// A scenario that the simulator refutes a property with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counterexample {
    /// The property.
    pub property: crate::base::Id<ir::Property>,
    /// The scenario's name.
    pub name: String,
    /// The scenario as text, for the file of the property or one that imports it.
    pub text: String,
}

/// How long an action may take to complete in the simulator, in nanoseconds.
const LONGEST_ACTION: u64 = 60_000_000_000;
/// Longer runs than this many ticks are not simulated.
const LONGEST: u64 = 1 << 16;

/// What is to be shown.
pub(super) struct Shown<'a> {
    pub(super) checked: Checked<'a>,
    pub(super) property: crate::base::Id<ir::Property>,
    pub(super) robot: crate::base::Id<ir::Robot>,
    /// Nanoseconds.
    pub(super) tick: u64,
    pub(super) cues: &'a Cues,
}

impl Shown<'_> {
    /// The scenario of a run, or why there is none.
    pub(super) fn scenario(&self, stretches: &[Stretch]) -> Result<Counterexample, &'static str> {
        const OTHERWISE: &str = "the simulated robot completes its actions at other times";
        let mut stretches = stretches.to_vec();
        for index in 0..stretches.len() {
            if stretches[index].done {
                stretches[index].ticks = self.ticks_to_completion(&stretches[..=index]).ok_or(OTHERWISE)?;
            }
        }
        if stretches.iter().map(|stretch| stretch.ticks).sum::<u64>() > LONGEST {
            return Err("it would take too long");
        }
        let run = self.simulate(&stretches).ok_or(OTHERWISE)?;
        if run.verdicts.iter().all(|verdict| verdict.passed) {
            return Err(OTHERWISE);
        }
        let (name, property) = (self.name(), self.property);
        Ok(Counterexample { property, text: self.text(&name, &stretches), name })
    }

    fn simulate(&self, stretches: &[Stretch]) -> Option<Run> {
        let scenario = self.lowered(stretches);
        let plan = plan::build_scenario(self.checked, &scenario);
        sim::run(self.checked.program(), &plan, &scenario, &RunOptions::default()).ok()
    }

    /// For how many ticks the last stretch lasts until an action completes and the mode is left.
    fn ticks_to_completion(&self, stretches: &[Stretch]) -> Option<u64> {
        let before: u64 = stretches[..stretches.len() - 1].iter().map(|stretch| stretch.ticks).sum();
        let mut longest = LONGEST_ACTION >> 5;
        while longest <= LONGEST_ACTION {
            let mut tried = stretches.to_vec();
            tried.last_mut()?.ticks = longest.div_ceil(self.tick);
            let run = self.simulate(&tried)?;
            let left = run.trace.changes.iter().map(|change| change.time / self.tick).find(|tick| *tick >= before);
            if let Some(left) = left {
                return Some(left - before + 1);
            }
            longest <<= 1;
        }
        None
    }

    /// A name that no scenario has.
    fn name(&self) -> String {
        let program = self.checked.program();
        let mut name = format!("{}_refuted", program.properties[self.property].symbol.name);
        while program.scenarios.values().any(|scenario| scenario.symbol.name == name) {
            name.push('_');
        }
        name
    }

    fn lowered(&self, stretches: &[Stretch]) -> ir::Scenario {
        let program = self.checked.program();
        let property = &program.properties[self.property];
        let faults = self.windows(stretches).map(|(sensor, number, window)| ir::Fault {
            sensor: program.robots[self.robot].sensors[sensor],
            reading: number.map_or(FaultReading::Reported, |number| FaultReading::Stuck(number.si)),
            window,
            span: property.span,
        });
        let kind = ExpectationKind::Claim(property.claim);
        ir::Scenario {
            symbol: property.symbol.clone(),
            diagram: property.diagram,
            robot: self.robot,
            duration: self.duration(stretches),
            tick: self.tick,
            seed: 1,
            start: ir::Placement::At { x: 0.0, y: 0.0, heading: 0.0 },
            walls: Vec::new(),
            boxes: Vec::new(),
            goal: None,
            faults: faults.collect(),
            expectations: vec![ir::Expectation { text: String::new(), kind, span: property.span }],
        }
    }

    /// From the first tick to the last, in nanoseconds; a scenario has at least two.
    fn duration(&self, stretches: &[Stretch]) -> u64 {
        let ticks: u64 = stretches.iter().map(|stretch| stretch.ticks).sum();
        (ticks - 1).max(1) * self.tick
    }

    /// What each sensor that matters says when: as long as it says the same, one window.
    fn windows(&self, stretches: &[Stretch]) -> impl Iterator<Item = (usize, Option<Number>, Window)> {
        let mut windows: Vec<(usize, Option<Number>, Window)> = Vec::new();
        for sensor in (0..self.cues.matters.len()).filter(|sensor| self.cues.matters[*sensor]) {
            let mut from = 0;
            for stretch in stretches {
                let (said, to) = (stretch.told[sensor], from + stretch.ticks * self.tick);
                match windows.last_mut() {
                    Some((of, number, window)) if (*of, *number) == (sensor, said) => window.to = to - self.tick,
                    _ => windows.push((sensor, said, Window { from, to: to - self.tick })),
                }
                from = to;
            }
        }
        let ticks: u64 = stretches.iter().map(|stretch| stretch.ticks).sum();
        let last = (ticks - 1) * self.tick;
        windows.into_iter().map(move |(sensor, said, window)| {
            let to = if window.to == last { u64::MAX } else { window.to };
            (sensor, said, Window { to, ..window })
        })
    }

    fn text(&self, name: &str, stretches: &[Stretch]) -> String {
        let program = self.checked.program();
        let diagram = &program.diagrams[program.properties[self.property].diagram].symbol.name;
        let (duration, tick) = (time(self.duration(stretches)), time(self.tick));
        let mut text = format!("scenario {name} runs {diagram} {{\n    duration {duration}   tick {tick}\n");
        for (sensor, said, window) in self.windows(stretches) {
            let sensor = &program.sensors[program.robots[self.robot].sensors[sensor]];
            let said = said.map_or_else(
                || format!("fail {}", sensor.symbol.name),
                |number| format!("fault {} = {}", sensor.symbol.name, written(number, &sensor.unit)),
            );
            let from = if window.from == 0 { String::new() } else { format!(" from {}", time(window.from)) };
            let to = if window.to == u64::MAX { String::new() } else { format!(" to {}", time(window.to)) };
            // Writing to a string does not fail.
            let _ = writeln!(text, "    {said}{from}{to}");
        }
        text + "}\n"
    }
}

/// As the language writes it.
pub(super) fn written(number: Number, unit: &Unit) -> String {
    match unit.text.as_str() {
        "1" => number.written.to_string(),
        unit => format!("{} {unit}", number.written),
    }
}

/// Nanoseconds as a quantity of the language, exactly: in seconds, where they are less than one in milliseconds.
pub(super) fn time(nanoseconds: u64) -> String {
    if (1..1_000_000_000).contains(&nanoseconds) && nanoseconds.is_multiple_of(1_000_000) {
        return format!("{} ms", nanoseconds / 1_000_000);
    }
    let (whole, part) = (nanoseconds / 1_000_000_000, format!("{:09}", nanoseconds % 1_000_000_000));
    match part.trim_end_matches('0') {
        "" => format!("{whole} s"),
        part => format!("{whole}.{part} s"),
    }
}
