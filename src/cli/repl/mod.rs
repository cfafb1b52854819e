//! `lmslc repl`

mod condition;
mod editor;

use std::io::{BufRead, IsTerminal, Write};
use std::path::Path;

use clap::Args;

use super::counterexamples::imported;
use super::terminal::{Terminal, exit_code, listed};
use super::{files, run};
use crate::base::{Dimension, Id, Quantity, Sources, Unit, read_quantity};
use crate::diag;
use crate::driver::{self, Analysis};
use crate::ir::{self, Platform};
use crate::repl::{Driven, Refusal, Reply, Saved, Session};

/// Drive a behavior by hand: set sensors, fail them, step, and ask why.
#[derive(Args)]
#[command(after_help = "\
`help` lists the commands. From a terminal, Tab completes them. A script on standard input is echoed with its answers;
the exit code is 1 where some command of it could not be carried out.

Examples:
  lmslc repl examples/j5/manipulation.msd
  lmslc repl examples/j5/manipulation.msd < examples/j5/by_hand.repl")]
pub(super) struct Repl {
    /// The file that holds the behavior, or a scenario that runs it
    file: String,
    /// The behavior; may be left out where the file has one
    behavior: Option<String>,
    /// The time from one tick to the next, as in `20ms`; that of the first scenario that runs the behavior, or 10 ms
    #[arg(long, value_name = "TIME")]
    tick: Option<String>,
}

/// A behavior that can be driven.
struct Candidate {
    diagram: Id<ir::Diagram>,
    platform: Platform,
    /// Nanoseconds.
    tick: u64,
}

/// What is driven, as the program has it.
struct Target<'a> {
    analysis: &'a Analysis,
    behavior: &'a str,
    platform: Platform,
}

impl Repl {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        if self.file == "-" {
            return Err(terminal.fail("standard input is read for commands", Some("name a file")));
        }
        let analysis = files::look(std::slice::from_ref(&self.file), terminal)?;
        let Some(checked) = analysis.checked() else { return Err(exit_code(&analysis)) };
        let Candidate { diagram, platform, tick } = self.choose(&analysis, terminal)?;
        let tick = match &self.tick {
            Some(text) => nanoseconds(text)
                .ok_or_else(|| terminal.fail(&format!("`{text}` is no tick"), Some("write a time, as in `20ms`")))?,
            None => tick,
        };
        let behavior = analysis.program.diagrams[diagram].symbol.name.as_str();
        let target = Target { analysis: &analysis, behavior, platform };
        let driven = Driven::new(checked, diagram, platform, tick);
        let mut session = Session::new(&driven, terminal.color_out);
        if std::io::stdin().is_terminal() {
            editor::converse(&mut session, &target, terminal)
        } else {
            script(&mut session, &target, terminal)
        }
    }

    fn choose(&self, analysis: &Analysis, terminal: &Terminal) -> Result<Candidate, u8> {
        let program = &analysis.program;
        let name = |candidate: &Candidate| program.diagrams[candidate.diagram].symbol.name.as_str();
        let mut candidates = candidates(analysis);
        let names: Vec<_> = candidates.iter().map(name).collect();
        let known = format!("name one of: {}", listed(names.iter().copied()));
        let position = match (&self.behavior, names.as_slice()) {
            (_, []) => return Err(terminal.fail(&format!("`{}` holds no behavior", self.file), None)),
            (Some(wanted), _) => names.iter().position(|name| name == wanted).ok_or_else(|| {
                let help = diag::did_you_mean(wanted, names.iter().copied()).unwrap_or(known);
                terminal.fail(&format!("`{}` has no behavior `{wanted}`", self.file), Some(&help))
            })?,
            (None, [_]) => 0,
            (None, _) => {
                let message = format!("`{}` has {} behaviors; which one?", self.file, names.len());
                return Err(terminal.fail(&message, Some(&known)));
            }
        };
        Ok(candidates.swap_remove(position))
    }
}

/// The behaviors that the scenarios of a file run, as the first of them does, then the others that it declares.
fn candidates(analysis: &Analysis) -> Vec<Candidate> {
    let program = &analysis.program;
    let run = run::scenarios(analysis).into_iter().map(|scenario| Candidate {
        diagram: scenario.diagram,
        platform: Platform::Robot(scenario.robot),
        tick: scenario.tick,
    });
    let own = program.diagrams.iter().filter(|(_, diagram)| analysis.roots.contains(&diagram.symbol.span.file));
    let own = own.map(|(id, diagram)| Candidate {
        diagram: id,
        platform: diagram.platform,
        tick: ir::Scenario::DEFAULT_TICK,
    });
    let mut candidates: Vec<Candidate> = Vec::new();
    for candidate in run.chain(own) {
        if candidates.iter().all(|known| known.diagram != candidate.diagram) {
            candidates.push(candidate);
        }
    }
    candidates
}

/// A time above 0.
fn nanoseconds(text: &str) -> Option<u64> {
    let seconds = read_quantity(text, &Unit::parse("s")?)?;
    Quantity::new(seconds, Dimension::TIME).to_nanoseconds().filter(|time| *time > 0)
}

/// Carries out the lines of standard input and shows them with their answers.
fn script(session: &mut Session<'_>, target: &Target<'_>, terminal: &Terminal) -> Result<u8, u8> {
    let mut code = super::CLEAN;
    for line in std::io::stdin().lock().lines() {
        let line = line.map_err(|error| terminal.fail(&format!("standard input cannot be read: {error}"), None))?;
        Terminal::print(&format!("> {line}\n"));
        match carry_out(session, &line, target, terminal) {
            Answer::Done => {}
            Answer::Refused => code = super::FINDINGS,
            Answer::Quit => break,
        }
    }
    Ok(code)
}

/// What became of a line.
enum Answer {
    Done,
    Refused,
    Quit,
}

/// Carries out a line and prints the answer.
fn carry_out(session: &mut Session<'_>, line: &str, target: &Target<'_>, terminal: &Terminal) -> Answer {
    let answer = session.carry_out(line).and_then(|reply| match reply {
        Reply::Text(text) => Ok(Some(text)),
        Reply::Save(saved) => save(&saved, target.analysis).map(Some),
        Reply::Watch(text) => {
            let Target { analysis, behavior, platform } = target;
            condition::plan(analysis, behavior, *platform, &text).map(|plan| Some(session.watch(&text, plan)))
        }
        Reply::Load(path) => files::text_of(&path)
            .map_err(|message| refusal(message, None))
            .and_then(|text| session.load(&text))
            .map(Some),
        Reply::Quit => Ok(None),
    });
    match answer {
        Ok(Some(text)) => {
            Terminal::print(&text);
            Answer::Done
        }
        Ok(None) => Answer::Quit,
        Err(Refusal { message, help }) => {
            let (red, plain) = if terminal.color_out { ("\x1b[1;31m", "\x1b[0m") } else { ("", "") };
            let help = help.map(|help| format!("    = help: {help}\n")).unwrap_or_default();
            Terminal::print(&format!("  {red}error{plain}: {message}\n{help}"));
            Answer::Refused
        }
    }
}

fn refusal(message: String, help: Option<&str>) -> Refusal {
    Refusal { message, help: help.map(str::to_owned) }
}

/// Writes a scenario to a file of its own.
fn save(saved: &Saved, analysis: &Analysis) -> Result<String, Refusal> {
    let Saved { path, text, imports } = saved;
    let folder = Path::new(path).parent().and_then(Path::to_str).filter(|folder| !folder.is_empty()).unwrap_or(".");
    let import = |file| imported(analysis, file, folder).map(|import| format!("import {import}\n"));
    let imports = imports.iter().map(|&file| import(file)).collect::<Result<Vec<_>, _>>();
    let imports = imports.map_err(|error| refusal(error.message, Some(error.help)))?;
    let text = format!("// A session of `lmslc repl`.\n\n{}\n{text}", imports.concat());
    let mut sources = Sources::default();
    let file = sources.add(path.clone(), text.clone());
    let text = driver::format(&sources, file).unwrap_or(text);
    // Nothing that stands there already is lost.
    let file = std::fs::File::create_new(path).and_then(|mut file| file.write_all(text.as_bytes()));
    file.map_err(|error| match error.kind() {
        std::io::ErrorKind::AlreadyExists => refusal(format!("there is a file `{path}` already"), None),
        _ => refusal(format!("`{path}` cannot be written: {error}"), None),
    })?;
    Ok(format!("  written; `lmslc run {path}` replays it\n"))
}
