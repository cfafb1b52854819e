//! What commands can name.

use super::Refusal;
use super::command::{COMMANDS, Takes};
use crate::diag;
use crate::plan::Plan;

/// The names of a diagram that commands take.
#[derive(Debug, Clone)]
pub struct Names {
    sensors: Vec<String>,
    networks: Vec<String>,
    watchable: Vec<String>,
}

/// Something to be shown after every step, by its position in the plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Watched {
    Input(usize),
    Event(usize),
    Flag(usize),
    Output(usize),
}

impl Names {
    pub(super) fn new(plan: &Plan) -> Self {
        Self {
            sensors: plan.inputs.iter().map(|input| input.name.clone()).collect(),
            networks: plan.senses.iter().map(|sense| sense.name.clone()).collect(),
            watchable: watchable(plan).into_iter().map(|(name, _)| name.to_owned()).collect(),
        }
    }

    /// The words that can stand where a line ends, and where the one that they complete begins in it, in bytes.
    pub fn complete(&self, line: &str) -> (usize, Vec<&str>) {
        let start = line.rfind([' ', '=']).map_or(0, |space| space + 1);
        let begun = line.get(start..).unwrap_or_default();
        let before = line.get(..start).unwrap_or_default().trim();
        let known: Vec<&str> = match before {
            "" => COMMANDS.iter().map(|usage| usage.word).collect(),
            word => self.behind(word).iter().map(String::as_str).collect(),
        };
        (start, known.into_iter().filter(|known| known.starts_with(begun)).collect())
    }

    /// Whether a word is one that some command takes.
    pub fn knows(&self, word: &str) -> bool {
        [&self.sensors, &self.networks, &self.watchable].into_iter().flatten().any(|known| known == word)
    }

    fn behind(&self, word: &str) -> &[String] {
        match COMMANDS.iter().find(|usage| usage.word == word).map(|usage| usage.takes) {
            Some(Takes::Sensor) => &self.sensors,
            Some(Takes::Network) => &self.networks,
            Some(Takes::Watchable) => &self.watchable,
            Some(Takes::Other) | None => &[],
        }
    }

    pub(super) fn sensor(&self, name: &str) -> Result<usize, Refusal> {
        find(name, &self.sensors, "sensor")
    }

    pub(super) fn network(&self, name: &str) -> Result<usize, Refusal> {
        find(name, &self.networks, "sensed network")
    }

    pub(super) fn watched(&self, name: &str, plan: &Plan) -> Result<Watched, Refusal> {
        let position = find(name, &self.watchable, "sensor, event, flag or output")?;
        Ok(watchable(plan)[position].1)
    }
}

fn find(name: &str, known: &[String], what: &str) -> Result<usize, Refusal> {
    known.iter().position(|known| known == name).ok_or_else(|| {
        let near = diag::did_you_mean(name, known.iter().map(String::as_str));
        let all = || format!("known are: {}", known.join(", "));
        let refusal = Refusal::new(format!("there is no {what} `{name}`"));
        if known.is_empty() { refusal } else { refusal.help(near.unwrap_or_else(all)) }
    })
}

/// What can be watched, under the shortest name that tells it from the others: events and outputs without their network
/// where nothing else is named so.
fn watchable(plan: &Plan) -> Vec<(&str, Watched)> {
    let inputs = plan.inputs.iter().enumerate().map(|(index, input)| (input.name.as_str(), Watched::Input(index)));
    let flags = plan.flags.iter().enumerate().map(|(index, flag)| (flag.name.as_str(), Watched::Flag(index)));
    let events = plan.events.iter().enumerate().map(|(index, event)| (event.name.as_str(), Watched::Event(index)));
    let outputs = plan.outputs.iter().enumerate().map(|(index, of)| (of.name.as_str(), Watched::Output(index)));
    let all: Vec<(&str, Watched)> = inputs.chain(flags).chain(events).chain(outputs).collect();
    let alone = |name: &str| all.iter().filter(|(other, _)| short(other) == name).count() == 1;
    all.iter().map(|&(name, watched)| (if alone(short(name)) { short(name) } else { name }, watched)).collect()
}

/// What stands behind the last dot.
fn short(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or(name)
}
