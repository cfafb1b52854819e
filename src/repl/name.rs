//! What commands can name.

use super::Refusal;
use super::command::{COMMANDS, Takes};
use super::twin::Twin;
use crate::diag;
use crate::plan::Plan;

/// The names of a diagram that commands take.
#[derive(Debug, Clone)]
pub struct Names {
    /// Sensors and logical ones; arrays stand for their elements.
    sensors: Vec<String>,
    /// For each of them, and then for each element of an array, the inputs that it means.
    inputs: Vec<(String, Vec<usize>)>,
    networks: Vec<String>,
    watchable: Vec<String>,
    modes: Vec<String>,
}

/// Something to be shown after every step: by its position in the plan, or a condition of its own.
#[derive(Debug, Clone)]
pub(super) enum Watched<'d> {
    Input(usize),
    Logical(usize),
    Event(usize),
    Flag(usize),
    Output(usize),
    Condition(Box<Twin<'d>>),
}

impl Names {
    pub(super) fn new(plan: &Plan) -> Self {
        let mut inputs: Vec<(String, Vec<usize>)> = Vec::new();
        for (index, input) in plan.inputs.iter().enumerate() {
            let name = input.name.split('[').next().unwrap_or_default();
            match inputs.last_mut() {
                Some((array, of)) if array == name => of.push(index),
                _ => inputs.push((name.to_owned(), vec![index])),
            }
        }
        let of = |of: &[u32]| of.iter().map(|&input| input as usize).collect();
        inputs.extend(plan.logical.iter().map(|logical| (logical.name.clone(), of(&logical.of))));
        let sensors = inputs.iter().map(|(name, _)| name.clone()).collect();
        inputs.extend(plan.inputs.iter().enumerate().map(|(index, input)| (input.name.clone(), vec![index])));
        Self {
            sensors,
            inputs,
            networks: plan.senses.iter().map(|sense| sense.name.clone()).collect(),
            watchable: watchable(plan).into_iter().map(|(name, _)| name.to_owned()).collect(),
            modes: plan.modes.iter().map(|mode| mode.name.clone()).collect(),
        }
    }

    /// The words that can stand where a line ends, and where the one that they complete begins in it, in bytes.
    pub fn complete(&self, line: &str) -> (usize, Vec<&str>) {
        let start = line.trim_end_matches(is_of_name).len();
        let begun = line.get(start..).unwrap_or_default();
        let before = line.get(..start).unwrap_or_default().trim();
        let known: Vec<&str> = match before.split_once(' ') {
            None if before.is_empty() => COMMANDS.iter().map(|usage| usage.word).collect(),
            None => self.behind(before).collect(),
            // Only a condition has names further on.
            Some((word, _)) if word == "watch" => self.behind(word).collect(),
            Some(_) => Vec::new(),
        };
        (start, known.into_iter().filter(|known| known.starts_with(begun)).collect())
    }

    /// Whether a word is one that some command takes.
    pub fn knows(&self, word: &str) -> bool {
        [&self.sensors, &self.networks, &self.watchable, &self.modes].into_iter().flatten().any(|known| known == word)
    }

    fn behind(&self, word: &str) -> impl Iterator<Item = &str> {
        let names: [&[String]; 2] = match COMMANDS.iter().find(|usage| usage.word == word).map(|usage| usage.takes) {
            Some(Takes::Sensor) => [&self.sensors, &[]],
            Some(Takes::Network) => [&self.networks, &[]],
            Some(Takes::Watchable) => [&self.watchable, &self.modes],
            Some(Takes::Other) | None => [&[], &[]],
        };
        names.into_iter().flatten().map(String::as_str)
    }

    /// The inputs that a name means: one, those of an array, or those that a logical sensor follows from.
    pub(super) fn sensor(&self, name: &str) -> Result<&[usize], Refusal> {
        match self.inputs.iter().find(|(known, _)| known == name) {
            Some((_, of)) => Ok(of),
            None => find(name, &self.sensors, "sensor").map(|_| [].as_slice()),
        }
    }

    pub(super) fn network(&self, name: &str) -> Result<usize, Refusal> {
        find(name, &self.networks, "sensed network")
    }

    /// What a text names; `None` where it is a condition, which names more.
    pub(super) fn watched(&self, text: &str, plan: &Plan) -> Result<Option<Watched<'static>>, Refusal> {
        let is_condition =
            !text.chars().all(is_of_name) || text == "done" || self.modes.iter().any(|mode| mode == text);
        if is_condition && self.watchable.iter().all(|known| known != text) {
            return Ok(None);
        }
        let all = [self.watchable.as_slice(), &self.modes].concat();
        let position = find(text, &all, "sensor, event, flag, output or mode")?;
        Ok(watchable(plan).into_iter().nth(position).map(|(_, watched)| watched))
    }
}

fn find(name: &str, known: &[String], what: &str) -> Result<usize, Refusal> {
    known.iter().position(|known| known == name).ok_or_else(|| {
        let near = diag::did_you_mean(name, known.iter().map(String::as_str));
        let all = || format!("known are: `{}`", known.join("`, `"));
        let refusal = Refusal::new(format!("there is no {what} `{name}`"));
        if known.is_empty() { refusal } else { refusal.help(near.unwrap_or_else(all)) }
    })
}

/// What can be watched, under the shortest name that tells it from the others: events and outputs without their network
/// where nothing else is named so.
fn watchable<'p>(plan: &'p Plan) -> Vec<(&'p str, Watched<'static>)> {
    let inputs = plan.inputs.iter().enumerate().map(|(index, input)| (input.name.as_str(), Watched::Input(index)));
    let logical = plan.logical.iter().enumerate().map(|(index, of)| (of.name.as_str(), Watched::Logical(index)));
    let flags = plan.flags.iter().enumerate().map(|(index, flag)| (flag.name.as_str(), Watched::Flag(index)));
    let events = plan.events.iter().enumerate().map(|(index, event)| (event.name.as_str(), Watched::Event(index)));
    let outputs = plan.outputs.iter().enumerate().map(|(index, of)| (of.name.as_str(), Watched::Output(index)));
    let all: Vec<(&str, Watched<'static>)> = inputs.chain(logical).chain(flags).chain(events).chain(outputs).collect();
    let alone = |name: &str| all.iter().filter(|(other, _)| short(other) == name).count() == 1;
    let shortest = |name: &'p str| if alone(short(name)) { short(name) } else { name };
    all.iter().map(|(name, watched)| (shortest(name), watched.clone())).collect()
}

/// Whether a letter can be part of a name, also of one behind another.
pub fn is_of_name(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_' || letter == '.'
}

/// What stands behind the last dot.
fn short(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or(name)
}
