//! The commands, and how they are written.

use super::Refusal;
use crate::base::{Dimension, Quantity, Unit, read_quantity};
use crate::diag;

/// A command as it was typed; its names are not looked up yet.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Command {
    Set { sensor: String, value: String },
    Fail(String),
    Heal(String),
    Done,
    Step(Length),
    Undo,
    Show,
    Why,
    Degrees(Option<String>),
    Watch(Option<String>),
    Unwatch(String),
    Save(String),
    Load(String),
    Help,
    Quit,
}

/// How long a step is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Length {
    Ticks(u64),
    Nanoseconds(u64),
}

/// What a command takes behind its word.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Takes {
    /// The name of a sensor.
    Sensor,
    /// The name of something that can be watched.
    Watchable,
    /// The name of a sensed network.
    Network,
    /// Anything else, or nothing.
    Other,
}

/// A command and what to say of it.
#[derive(Debug, Clone, Copy)]
pub struct Usage {
    /// Its word.
    pub word: &'static str,
    /// What stands behind it.
    pub arguments: &'static str,
    /// What it does.
    pub does: &'static str,
    /// What its arguments begin with.
    pub takes: Takes,
}

const fn usage(word: &'static str, arguments: &'static str, does: &'static str, takes: Takes) -> Usage {
    Usage { word, arguments, does, takes }
}

/// Every command.
pub const COMMANDS: &[Usage] = &[
    usage("set", "SENSOR = VALUE", "lets a sensor read a value from now on, as in `set force = 0.1 kN`", Takes::Sensor),
    usage("fail", "SENSOR", "reports a sensor as failed", Takes::Sensor),
    usage("heal", "SENSOR", "lets a failed sensor read again", Takes::Sensor),
    usage("done", "", "lets the action of the mode be complete on the next tick", Takes::Other),
    usage("step", "[TICKS | TIME]", "runs one tick, so many, or a time, as in `step 2 s`", Takes::Other),
    usage("undo", "", "takes the last command back that changed something", Takes::Other),
    usage("show", "", "shows the mode, its commands and what the sensors say", Takes::Other),
    usage("why", "", "says why the last transition was taken, and why none was since", Takes::Other),
    usage("degrees", "[NETWORK]", "shows degrees of membership, strengths and events as bars", Takes::Network),
    usage(
        "watch",
        "[NAME | CONDITION]",
        "shows it after every step, as in `watch force > 50 N and after 2 s`",
        Takes::Watchable,
    ),
    usage("unwatch", "NAME | CONDITION", "shows it no more", Takes::Watchable),
    usage("save", "FILE.msd", "writes the session as a scenario for `lmslc run`", Takes::Other),
    usage("load", "FILE", "starts again with the readings of a trace of `lmslc run --trace`", Takes::Other),
    usage("help", "", "shows this list", Takes::Other),
    usage("quit", "", "ends the session", Takes::Other),
];

/// Reads a line; `None` for an empty one and for a comment.
pub(super) fn parse(line: &str) -> Result<Option<Command>, Refusal> {
    let line = line.split("//").next().unwrap_or_default().trim();
    let (word, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    let rest = rest.trim();
    if word.is_empty() {
        return Ok(None);
    }
    let Some(usage) = COMMANDS.iter().find(|usage| usage.word == word) else {
        let near = diag::did_you_mean(word, COMMANDS.iter().map(|usage| usage.word));
        let help = near.unwrap_or_else(|| "`help` lists the commands".to_owned());
        return Err(Refusal::new(format!("there is no command `{word}`")).help(help));
    };
    let form = || {
        let form = format!("{word} {}", usage.arguments);
        Refusal::new(format!("`{line}` is not understood")).help(format!("write `{}`", form.trim_end()))
    };
    let text = rest.to_owned();
    let one = || if rest.is_empty() { Err(form()) } else { Ok(rest.to_owned()) };
    let some = (!rest.is_empty()).then(|| rest.to_owned());
    Ok(Some(match word {
        "set" => {
            let (sensor, value) =
                rest.split_once('=').or_else(|| rest.split_once(char::is_whitespace)).ok_or_else(form)?;
            Command::Set { sensor: sensor.trim().to_owned(), value: value.trim().to_owned() }
        }
        "fail" => Command::Fail(one()?),
        "heal" => Command::Heal(one()?),
        "step" => Command::Step(length(&text).ok_or_else(form)?),
        "degrees" => Command::Degrees(some),
        "watch" => Command::Watch(some),
        "unwatch" => Command::Unwatch(one()?),
        "save" => Command::Save(one()?),
        "load" => Command::Load(one()?),
        _ if some.is_some() => return Err(form()),
        "done" => Command::Done,
        "undo" => Command::Undo,
        "show" => Command::Show,
        "why" => Command::Why,
        "help" => Command::Help,
        _ => Command::Quit,
    }))
}

fn length(text: &str) -> Option<Length> {
    if text.is_empty() {
        return Some(Length::Ticks(1));
    }
    if let Ok(ticks) = text.parse::<u64>() {
        return (ticks > 0).then_some(Length::Ticks(ticks));
    }
    let has_unit = text.ends_with(|last: char| last.is_ascii_alphabetic());
    let seconds = has_unit.then(|| Unit::parse("s")).flatten().and_then(|unit| read_quantity(text, &unit))?;
    Quantity::new(seconds, Dimension::TIME).to_nanoseconds().filter(|time| *time > 0).map(Length::Nanoseconds)
}

/// What `help` answers.
pub(super) fn help() -> String {
    let form = |usage: &Usage| format!("{} {}", usage.word, usage.arguments);
    let width = COMMANDS.iter().map(|usage| form(usage).len()).max().unwrap_or(0);
    COMMANDS.iter().fold(String::new(), |out, usage| out + &format!("  {:width$}  {}\n", form(usage), usage.does))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_counted_or_timed() {
        let step = |text: &str| parse(text).map(|command| command.unwrap());
        assert_eq!(step("step"), Ok(Command::Step(Length::Ticks(1))));
        assert_eq!(step(" step 20 // ticks"), Ok(Command::Step(Length::Ticks(20))));
        assert_eq!(step("step 1.5s"), Ok(Command::Step(Length::Nanoseconds(1_500_000_000))));
        for wrong in ["step 0", "step -1", "step 1.5", "step 0 s", "step 2 N", "step soon", "step 1e99 s"] {
            assert!(step(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn every_listed_command_is_read() {
        for usage in COMMANDS {
            let sample = match usage.word {
                "set" => "force = 1 N",
                "step" | "done" | "undo" | "show" | "why" | "help" | "quit" => "",
                _ => "x",
            };
            let read = parse(&format!("{} {sample}", usage.word)).unwrap().unwrap();
            assert_eq!(read == Command::Quit, usage.word == "quit", "{}", usage.word);
        }
    }
}
