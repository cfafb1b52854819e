//! `lmslc eval`

use clap::{Args, ValueEnum};

use super::files;
use super::terminal::{Terminal, exit_code, listed};
use crate::base::{Unit, read_quantity};
use crate::diag;
use crate::interp::{Evaluator, Reading};
use crate::plan::{self, NetworkPlan};
use crate::report::{self, Evaluated};

/// Evaluate a network on given readings.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc eval stdlib/networks/obstacle_id.fsfn obstacle_id left=-1.2 right=-1 force=115
  lmslc eval stdlib/networks/obstacle_id.fsfn obstacle_id --csv readings.csv > events.csv")]
pub(super) struct Eval {
    /// The file that holds the network, or `-` for standard input
    file: String,
    /// The network
    network: String,
    /// Readings, as in `left=-1.2 force=0.1kN`, in the units of the network's variables unless they name another; a
    /// reading may also be `nan`, `inf`, or `failed` for a sensor that is known to have failed
    #[arg(value_name = "NAME=VALUE")]
    readings: Vec<String>,
    /// Evaluate every row of a CSV of readings in SI, `-` for standard input, and print a CSV
    #[arg(long, value_name = "PATH", conflicts_with = "readings")]
    csv: Option<String>,
    /// Milliseconds between the rows of the CSV, for events that remember
    #[arg(long, value_name = "MS", default_value_t = 10, requires = "csv")]
    tick: u64,
    /// How to report
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    format: Format,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// Degrees as bars, for people
    Human,
    /// One JSON object
    Json,
}

impl Eval {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        let analysis = files::look(std::slice::from_ref(&self.file), terminal)?;
        let Some(checked) = analysis.checked() else { return Err(exit_code(&analysis)) };
        let networks = &analysis.program.networks;
        if networks.is_empty() {
            return Err(terminal.fail(&format!("`{}` holds no network", self.file), None));
        }
        let Some((id, _)) = networks.iter().find(|(_, network)| network.symbol.name == self.network) else {
            let names: Vec<_> = networks.values().map(|network| network.symbol.name.as_str()).collect();
            let help = diag::did_you_mean(&self.network, names.iter().copied())
                .unwrap_or_else(|| format!("known are: {}", listed(names.iter().copied())));
            return Err(terminal.fail(&format!("there is no network `{}`", self.network), Some(&help)));
        };
        let plan = plan::build_network(checked, id);
        if let Some(path) = &self.csv {
            let table = files::read(path, terminal)?;
            let answer = report::eval_csv(&plan, &table, self.tick.saturating_mul(1_000_000))
                .map_err(|error| terminal.fail(&format!("`{path}`, {error}"), None))?;
            Terminal::print(&answer);
            return Ok(super::CLEAN);
        }
        let readings = parse_readings(&self.readings, &plan)
            .map_err(|(message, help)| terminal.fail(&message, help.as_deref()))?;
        let mut evaluator = Evaluator::new(&plan);
        evaluator.evaluate(&readings, 0);
        let evaluated = Evaluated { plan: &plan, evaluator: &evaluator, readings: &readings };
        Terminal::print(&match self.format {
            Format::Human => report::eval(&evaluated, terminal.color_out),
            Format::Json => report::eval_json(&evaluated),
        });
        Ok(super::CLEAN)
    }
}

/// Readings in the order of the network's inputs, in SI.
fn parse_readings(texts: &[String], plan: &NetworkPlan) -> Result<Vec<Reading>, (String, Option<String>)> {
    let mut readings: Vec<Option<Reading>> = vec![None; plan.inputs.len()];
    let names = || plan.inputs.iter().map(|input| input.name.as_str());
    for text in texts {
        let Some((name, value)) = text.split_once('=') else {
            return Err((format!("`{text}` is not a reading"), Some("write NAME=VALUE".to_owned())));
        };
        let Some(index) = names().position(|known| known == name) else {
            let help = diag::did_you_mean(name, names()).unwrap_or_else(|| format!("known are: {}", listed(names())));
            return Err((format!("`{}` has no input `{name}`", plan.name), Some(help)));
        };
        if readings[index].is_some() {
            return Err((format!("`{name}` is given twice"), None));
        }
        let value = reading(value, &plan.inputs[index].unit).ok_or_else(|| {
            (
                format!("`{value}` is not a reading of `{name}`"),
                Some(format!("give a number in {}", plan.inputs[index].unit.text)),
            )
        })?;
        readings[index] = Some(value);
    }
    let missing: Vec<_> =
        names().zip(&readings).filter(|(_, reading)| reading.is_none()).map(|(name, _)| name).collect();
    if !missing.is_empty() {
        let help = missing.iter().map(|name| format!("{name}=...")).collect::<Vec<_>>().join(" ");
        return Err((format!("no reading is given for {}", missing.join(", ")), Some(format!("add {help}"))));
    }
    Ok(readings.into_iter().flatten().collect())
}

/// A number in the input's unit; `failed` for a sensor that is known to have failed; `nan` and `inf` as they are.
fn reading(text: &str, unit: &Unit) -> Option<Reading> {
    if text == "failed" {
        return Some(Reading { value: f64::NAN, healthy: false });
    }
    let value = match read_quantity(text, unit) {
        Some(exact) => exact.to_f64(),
        None => text.trim().parse::<f64>().ok().filter(|value| !value.is_finite())?,
    };
    Some(Reading { value, healthy: true })
}
