//! `lmslc test`

use clap::{Args, ValueEnum};
use rayon::prelude::*;

use super::files::Disk;
use super::run::{WRITE_ONE, outcome, scenarios};
use super::terminal::{Terminal, exit_code, listed};
use super::watch;
use crate::ir::Scenario;
use crate::plan::Checked;
use crate::sim::{self, RunError, RunOptions};
use crate::trace::Measures;
use crate::{plan, report};

/// Run every scenario and report each expectation.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc test examples
  lmslc test examples --filter mass --format json
  lmslc test examples/j5/manipulation.msd --coverage
  lmslc test examples/car --seeds 50 --format markdown")]
pub(super) struct Test {
    /// Files, folders, or `-` for standard input
    #[arg(required = true)]
    files: Vec<String>,
    /// Run only scenarios whose name contains this
    #[arg(long, value_name = "TEXT", default_value = "")]
    filter: String,
    /// How often to run each, every time with the next seed
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..))]
    seeds: u16,
    /// Also list the modes, transitions and rules that no scenario went through
    #[arg(long)]
    coverage: bool,
    /// Test again whenever a file that is read changes, or one appears that would be
    #[arg(short, long)]
    watch: bool,
    /// How to report
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    format: Format,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// A line for each scenario, and the timelines of those that failed
    Human,
    /// One JSON object for each run
    Json,
    /// A table of what the ways are measured by
    Markdown,
}

/// A run and what is kept of it.
struct Tried {
    passed: bool,
    /// For a table.
    measures: Option<Measures>,
    /// What is said of it by itself.
    text: String,
    /// All of it, for what was covered.
    run: Option<sim::Run>,
}

impl Test {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        if self.watch {
            watch::refuse(&self.files, matches!(self.format, Format::Human), terminal)?;
            watch::rounds(terminal, |disk| self.round(disk, terminal));
        }
        self.round(&Disk::default(), terminal)
    }

    /// Runs the scenarios and reports them.
    fn round(&self, disk: &Disk, terminal: &Terminal) -> Result<u8, u8> {
        let analysis = disk.look(&self.files, terminal)?;
        let Some(checked) = analysis.checked() else { return Err(exit_code(&analysis)) };
        let mut chosen = scenarios(&analysis);
        let all: Vec<_> = chosen.iter().map(|scenario| scenario.symbol.name.as_str()).collect();
        chosen.retain(|scenario| scenario.symbol.name.contains(&self.filter));
        if all.is_empty() {
            let message = format!("`{}` holds no scenario to run", self.files.join("`, `"));
            return Err(terminal.fail(&message, Some(WRITE_ONE)));
        }
        if chosen.is_empty() {
            let message = format!("no scenario has `{}` in its name", self.filter);
            return Err(terminal.fail(&message, Some(&format!("there are: {}", listed(all)))));
        }
        let seeds = usize::from(self.seeds);
        let jobs = chosen.iter().flat_map(|scenario| (0..self.seeds.into()).map(|further| (*scenario, further)));
        let jobs: Vec<(&Scenario, u64)> = jobs.collect();
        let progress = terminal.progress(jobs.len(), "scenarios run");
        let tried = |&(scenario, further): &(&Scenario, u64)| {
            let tried = self.attempt(checked, scenario, further, terminal);
            progress.advance();
            tried
        };
        let tried: Vec<_> = jobs.par_iter().map(tried).collect();
        drop(progress);
        let (mut passed, mut failed) = (0, 0);
        let mut rows = Vec::new();
        for (scenario, tried) in chosen.iter().zip(tried.chunks(seeds)) {
            let path = analysis.sources.path(scenario.symbol.span.file);
            if let Some(Err(error)) = tried.first() {
                failed += 1;
                terminal.fail(&format!("{path}: `{}` cannot be run: {error}", scenario.symbol.name), None);
                continue;
            }
            let tried: Vec<_> = tried.iter().flatten().collect();
            let met = tried.iter().filter(|tried| tried.passed).count();
            *if met == seeds { &mut passed } else { &mut failed } += 1;
            match self.format {
                Format::Json => tried.iter().for_each(|tried| Terminal::print(&tried.text)),
                Format::Human => {
                    Terminal::print(&line((met, seeds), path, scenario, terminal));
                    tried.iter().find(|tried| !tried.passed).iter().for_each(|tried| Terminal::print(&tried.text));
                }
                Format::Markdown => rows.push(report::Measured {
                    scenario: &scenario.symbol.name,
                    behavior: &analysis.program.diagrams[scenario.diagram].symbol.name,
                    runs: tried.iter().filter_map(|tried| Some((tried.passed, tried.measures?))).collect(),
                }),
            }
        }
        if matches!(self.format, Format::Markdown) {
            Terminal::print(&report::measures_markdown(&rows));
        }
        if self.coverage {
            let runs = jobs.iter().zip(&tried);
            let runs = runs.filter_map(|((scenario, _), tried)| Some((*scenario, tried.as_ref().ok()?.run.as_ref()?)));
            let runs: Vec<_> = runs.collect();
            let coverage = sim::coverage(&analysis.program, &analysis.sources, &analysis.roots, &runs);
            Terminal::print(&match self.format {
                Format::Human | Format::Markdown => report::coverage(&coverage, &analysis.sources, terminal.color_out),
                Format::Json => report::coverage_json(&coverage, &analysis.sources),
            });
        }
        terminal.note(&format!("{passed} passed, {failed} failed"));
        Ok(if failed == 0 { super::CLEAN } else { super::FINDINGS })
    }

    /// Runs a scenario with its seed, or one of those after it.
    fn attempt(
        &self,
        checked: Checked<'_>,
        scenario: &Scenario,
        further: u64,
        terminal: &Terminal,
    ) -> Result<Tried, RunError> {
        let plan = plan::build_scenario(checked, scenario);
        let options = RunOptions { seed: Some(scenario.seed.wrapping_add(further)), ..RunOptions::default() };
        let run = sim::run(checked.program(), &plan, scenario, &options)?;
        let outcome = outcome(&run);
        let passed = outcome.passed();
        let text = match self.format {
            Format::Json => report::run(&outcome),
            Format::Human if !passed => report::timeline(&outcome, Terminal::width(), terminal.color_out),
            Format::Human | Format::Markdown => String::new(),
        };
        let measures = matches!(self.format, Format::Markdown).then(|| run.trace.measures());
        Ok(Tried { passed, measures, text, run: self.coverage.then_some(run) })
    }
}

/// What became of a scenario: in how many runs, of how many, everything was seen that was expected.
fn line((met, of): (usize, usize), path: &str, scenario: &Scenario, terminal: &Terminal) -> String {
    let word = if met == of { "ok" } else { "FAILED" };
    let (color, plain) = match (terminal.color_out, met == of) {
        (false, _) => ("", ""),
        (true, true) => ("\x1b[32m", "\x1b[0m"),
        (true, false) => ("\x1b[1;31m", "\x1b[0m"),
    };
    let name = &scenario.symbol.name;
    let expectations = match scenario.expectations.len() {
        1 => "1 expectation".to_owned(),
        count => format!("{count} expectations"),
    };
    let seeds = if of == 1 { String::new() } else { format!(", {met} of {of} seeds") };
    format!("{color}{word:6}{plain} {path}: {name} ({expectations}{seeds})\n")
}
