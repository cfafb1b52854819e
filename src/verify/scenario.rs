//! A run as a scenario that the simulator goes through in the same way: it forces every reading that matters.

use std::fmt::Write;

use super::told::{Number, Stretch};
use crate::base::{Id, Span, Unit};
use crate::ir::{self, Claim, ExpectationKind, FaultReading, Window};
use crate::plan::{self, Checked};
use crate::sim::{self, Run, RunOptions};

/// A scenario that the simulator refutes a property with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Counterexample {
    /// The property.
    pub property: Id<ir::Property>,
    /// The scenario's name.
    pub name: String,
    /// The scenario as text, for the file of the property or one that imports it.
    pub text: String,
}

/// How long an action may take to complete in the simulator, in nanoseconds.
const LONGEST_ACTION: u64 = 60_000_000_000;
/// Longer runs than this many ticks are not simulated.
const LONGEST: u64 = 1 << 16;

/// Why there is none, where the simulated robot does not go along.
const OTHERWISE: &str = "the simulated robot completes its actions at other times";

/// What was run, and how its readings are forced again.
#[derive(Debug, Clone)]
pub struct Replay<'a> {
    /// The program.
    pub checked: Checked<'a>,
    /// What was run.
    pub diagram: Id<ir::Diagram>,
    /// On which robot; it has a body.
    pub robot: Id<ir::Robot>,
    /// Nanoseconds.
    pub tick: u64,
    /// Whether each sensor of the robot is forced.
    pub forced: &'a [bool],
    /// What the run breaks, if it is shown for that.
    pub claim: Option<Claim>,
}

/// The scenario in which the simulator refutes a property, or why there is none.
pub(super) fn counterexample(
    replay: &Replay<'_>,
    property: Id<ir::Property>,
    stretches: &[Stretch],
) -> Result<Counterexample, &'static str> {
    let (stretches, run) = replay.completed(stretches)?;
    if run.verdicts.iter().all(|verdict| verdict.passed) {
        return Err(OTHERWISE);
    }
    let program = replay.checked.program();
    let mut name = format!("{}_refuted", program.properties[property].symbol.name);
    while program.scenarios.values().any(|scenario| scenario.symbol.name == name) {
        name.push('_');
    }
    Ok(Counterexample { property, text: replay.text(&name, &stretches, ""), name })
}

impl Replay<'_> {
    /// The scenario of that name, which expects these modes, the entry mode first; the simulator goes through them and no
    /// others.
    ///
    /// # Errors
    /// Why there is none.
    pub fn scenario(&self, name: &str, modes: &[Id<ir::Mode>], stretches: &[Stretch]) -> Result<String, &'static str> {
        let (stretches, run) = self.completed(stretches)?;
        let end = stretches.iter().map(|stretch| stretch.ticks).sum::<u64>() * self.tick;
        let changes = run.trace.changes.iter().filter(|change| change.time < end);
        if !changes.map(|change| change.to as usize).eq(modes.iter().map(|mode| mode.index())) {
            return Err(OTHERWISE);
        }
        let names = &self.checked.program().diagrams[self.diagram].modes;
        let names: Vec<&str> = modes.iter().map(|&mode| names[mode].symbol.name.as_str()).collect();
        Ok(self.text(name, &stretches, &format!("    expect modes {}\n", names.join(", "))))
    }

    /// What is told, for as long as the simulated robot takes for its actions; and its run.
    fn completed(&self, stretches: &[Stretch]) -> Result<(Vec<Stretch>, Run), &'static str> {
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
        Ok((stretches, run))
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

    fn lowered(&self, stretches: &[Stretch]) -> ir::Scenario {
        let program = self.checked.program();
        let faults = self.windows(stretches).map(|(sensor, number, window)| ir::Fault {
            sensor: program.robots[self.robot].sensors[sensor],
            reading: number.map_or(FaultReading::Reported, |number| FaultReading::Stuck(number.si)),
            window,
            span: Span::default(),
        });
        let expectation = |claim| {
            let kind = ExpectationKind::Claim(claim);
            ir::Expectation { text: String::new(), kind, span: Span::default() }
        };
        ir::Scenario {
            symbol: program.diagrams[self.diagram].symbol.clone(),
            diagram: self.diagram,
            robot: self.robot,
            duration: self.duration(stretches),
            tick: self.tick,
            seed: 1,
            start: ir::Placement::At { x: 0.0, y: 0.0, heading: 0.0 },
            walls: Vec::new(),
            boxes: Vec::new(),
            goal: None,
            faults: faults.collect(),
            expectations: self.claim.map(expectation).into_iter().collect(),
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
        for sensor in (0..self.forced.len()).filter(|sensor| self.forced[*sensor]) {
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

    fn text(&self, name: &str, stretches: &[Stretch], expectation: &str) -> String {
        let program = self.checked.program();
        let diagram = &program.diagrams[self.diagram];
        let on = match diagram.platform {
            ir::Platform::Robot(_) => String::new(),
            ir::Platform::Interface(_) => format!(" on {}", program.robots[self.robot].symbol.name),
        };
        let (diagram, duration, tick) = (&diagram.symbol.name, time(self.duration(stretches)), time(self.tick));
        let mut text = format!("scenario {name} runs {diagram}{on} {{\n    duration {duration}   tick {tick}\n");
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
        text + expectation + "}\n"
    }
}

/// A number as the language writes it.
pub fn written(number: Number, unit: &Unit) -> String {
    match unit.text.as_str() {
        "1" => number.written.to_string(),
        "contact" => unit.show(number.written),
        unit => format!("{} {unit}", number.written),
    }
}

/// Nanoseconds as a quantity of the language, exactly: in seconds, where they are less than one in milliseconds.
pub fn time(nanoseconds: u64) -> String {
    if (1..1_000_000_000).contains(&nanoseconds) && nanoseconds.is_multiple_of(1_000_000) {
        return format!("{} ms", nanoseconds / 1_000_000);
    }
    let (whole, part) = (nanoseconds / 1_000_000_000, format!("{:09}", nanoseconds % 1_000_000_000));
    match part.trim_end_matches('0') {
        "" => format!("{whole} s"),
        part => format!("{whole}.{part} s"),
    }
}
