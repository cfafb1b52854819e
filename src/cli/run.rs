//! `lmslc run`

use clap::{Args, ValueEnum};

use super::files;
use super::terminal::{Terminal, exit_code, listed};
use crate::base::{FileId, Span, Unit, read_quantity};
use crate::diag::{self, Diagnostic, rules};
use crate::driver::Analysis;
use crate::ir::{self, Window};
use crate::sim::{self, RunOptions};
use crate::{plan, report, view};

/// Run a scenario in the simulator and print its timeline of modes.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc run examples/j5/manipulation.msd --plot run.svg
  lmslc run examples/j5/manipulation.msd --fault contact_force=0N@6s --seed 3
  lmslc run examples/j5/preliminary.msd empty_floor --trace run.csv")]
pub(super) struct Run {
    /// The file that holds the scenario, or `-` for standard input
    file: String,
    /// The scenario; may be left out where the file holds one
    scenario: Option<String>,
    /// The seed of everything random, instead of the scenario's
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Make a sensor read wrong from a time on, as in `contact_force=0N@3s`; `any` for some constant in its range,
    /// `failed` to also report it as failed; may be repeated
    #[arg(long = "fault", value_name = "SENSOR=VALUE@TIME")]
    faults: Vec<String>,
    /// Write every tick to a file, as CSV or, where the name ends in .jsonl, as one JSON object a line
    #[arg(long, value_name = "PATH")]
    trace: Option<String>,
    /// Write what became of the proposals of an arbiter's clients, whenever that changed
    #[arg(long, value_name = "PATH")]
    log: Option<String>,
    /// Draw sensors, events, modes and the robot's way as SVG
    #[arg(long, value_name = "PATH")]
    plot: Option<String>,
    /// How to report
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    format: Format,
}

/// How to report a run.
#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// A timeline, for people
    Human,
    /// One JSON object
    Json,
}

impl Run {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        let analysis = files::look(std::slice::from_ref(&self.file), terminal)?;
        let Some(checked) = analysis.checked() else { return Err(exit_code(&analysis)) };
        let scenario = self.choose(&analysis, terminal)?;
        let plan = plan::build_scenario(checked, scenario);
        let mut options = RunOptions { seed: self.seed, faults: Vec::new() };
        for fault in &self.faults {
            let faults = parse_fault(fault, scenario, &analysis.program)
                .map_err(|(message, help)| terminal.fail(&message, help.as_deref()))?;
            options.faults.extend(faults);
        }
        let run = sim::run(&analysis.program, &plan, scenario, &options)
            .map_err(|error| terminal.fail(&format!("`{}` cannot be run: {error}", scenario.symbol.name), None))?;
        if let Some(path) = &self.trace {
            let mut bytes = Vec::new();
            let lines = std::path::Path::new(path).extension().is_some_and(|ending| ending == "jsonl");
            let written = if lines {
                report::trace_jsonl(&run.trace, &mut bytes)
            } else {
                report::trace_csv(&run.trace, &mut bytes)
            };
            written.map_err(|error| terminal.fail(&format!("the trace cannot be written: {error}"), None))?;
            files::write(path, &bytes, terminal)?;
        }
        if let Some(path) = &self.log {
            files::write(path, report::log(&run.trace).as_bytes(), terminal)?;
        }
        if let Some(path) = &self.plot {
            files::write(path, view::plot(&run.trace).as_bytes(), terminal)?;
        }
        let outcome = outcome(&run);
        Terminal::print(&match self.format {
            Format::Human => report::timeline(&outcome, Terminal::width(), terminal.color_out),
            Format::Json => report::run(&outcome),
        });
        Ok(if outcome.passed() { super::CLEAN } else { super::FINDINGS })
    }

    fn choose<'a>(&self, analysis: &'a Analysis, terminal: &Terminal) -> Result<&'a ir::Scenario, u8> {
        let scenarios = scenarios(analysis);
        let names: Vec<_> = scenarios.iter().map(|scenario| scenario.symbol.name.as_str()).collect();
        match (&self.scenario, scenarios.as_slice()) {
            (Some(wanted), _) => {
                scenarios.iter().copied().find(|scenario| scenario.symbol.name == *wanted).ok_or_else(|| {
                    let help = diag::did_you_mean(wanted, names.iter().copied());
                    let help = help.unwrap_or_else(|| format!("the file holds: {}", listed(names.iter().copied())));
                    terminal.fail(&format!("`{}` holds no scenario `{wanted}`", self.file), Some(&help))
                })
            }
            (None, [scenario]) => Ok(scenario),
            (None, []) => {
                terminal.errors(&[no_scenario(analysis, &self.file)], &analysis.sources);
                Err(super::USAGE)
            }
            (None, _) => {
                let message = format!("`{}` holds {} scenarios; which one?", self.file, scenarios.len());
                Err(terminal.fail(&message, Some(&format!("name one of: {}", listed(names)))))
            }
        }
    }
}

/// The scenarios of the files that were asked for, without those of files they import.
pub(super) fn scenarios(analysis: &Analysis) -> Vec<&ir::Scenario> {
    let asked = |file: FileId| analysis.roots.contains(&file);
    analysis.program.scenarios.values().filter(|scenario| asked(scenario.symbol.span.file)).collect()
}

/// A run as reports take it.
pub(super) fn outcome(run: &sim::Run) -> report::Outcome<'_> {
    let expectations = run.verdicts.iter().map(|verdict| report::Verdict {
        text: &verdict.text,
        passed: verdict.passed,
        seen: (!verdict.passed).then_some(verdict.seen.as_str()),
    });
    report::Outcome { trace: &run.trace, expectations: expectations.collect() }
}

/// What to do about a file without scenarios.
pub(super) const WRITE_ONE: &str = "write `scenario name runs behavior { duration 10 s }`, or run a file that has one";

fn no_scenario(analysis: &Analysis, file: &str) -> Diagnostic {
    let root = analysis.roots.first().copied().unwrap_or_default();
    let message = format!("`{file}` holds no scenario to run");
    Diagnostic::new(&rules::NO_SCENARIO, Span::new(root, 0, 0), message).help(WRITE_ONE)
}

/// Reads `SENSOR=VALUE@TIME`, for every sensor that the name stands for. Value and time are in the sensor's unit and in seconds unless they say otherwise.
fn parse_fault(
    text: &str,
    scenario: &ir::Scenario,
    program: &ir::Program,
) -> Result<Vec<ir::Fault>, (String, Option<String>)> {
    let form = || {
        (format!("`{text}` is not a fault"), Some("write SENSOR=VALUE@TIME, as in `contact_force=0N@3s`".to_owned()))
    };
    let (name, rest) = text.split_once('=').ok_or_else(form)?;
    let (value, time) = rest.split_once('@').unwrap_or((rest, "0s"));
    let mut sensors = program.robots[scenario.robot].all_sensors();
    sensors.retain(|&sensor| !program.sensors[sensor].is_inner());
    let meant = program.measuring_named(name, &sensors);
    let Some(&first) = meant.first() else {
        let known = sensors.iter().map(|&sensor| program.sensors[sensor].symbol.name.as_str());
        let mut known: Vec<_> = known.map(|name| name.split('[').next().unwrap_or(name)).collect();
        known.dedup();
        let known = known.into_iter();
        let help =
            diag::did_you_mean(name, known.clone()).unwrap_or_else(|| format!("its sensors are: {}", listed(known)));
        return Err((format!("the robot has no sensor `{name}`"), Some(help)));
    };
    let unit = &program.sensors[first].unit;
    let reading = match value {
        "any" => ir::FaultReading::StuckSomewhere,
        "failed" => ir::FaultReading::Reported,
        value => {
            let value = read_quantity(value, unit).ok_or_else(form)?;
            ir::FaultReading::Stuck(value.to_f64())
        }
    };
    let seconds = Unit::parse("s").and_then(|unit| read_quantity(time, &unit)).ok_or_else(form)?;
    let from = crate::base::Quantity::new(seconds, crate::base::Dimension::TIME).to_nanoseconds().ok_or_else(form)?;
    let window = Window { from, to: u64::MAX };
    Ok(meant.into_iter().map(|sensor| ir::Fault { sensor, reading, window, span: Span::default() }).collect())
}
