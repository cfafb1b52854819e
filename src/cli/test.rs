//! `lmslc test`

use clap::Args;
use rayon::prelude::*;

use super::files::Disk;
use super::run::{Format, WRITE_ONE, outcome, scenarios};
use super::terminal::{Terminal, exit_code, listed};
use super::watch;
use crate::ir::Scenario;
use crate::sim::{self, RunOptions};
use crate::{plan, report};

/// Run every scenario and report each expectation.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc test examples
  lmslc test examples --filter mass --format json
  lmslc test examples/j5/manipulation.msd --coverage")]
pub(super) struct Test {
    /// Files, folders, or `-` for standard input
    #[arg(required = true)]
    files: Vec<String>,
    /// Run only scenarios whose name contains this
    #[arg(long, value_name = "TEXT", default_value = "")]
    filter: String,
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
        let progress = terminal.progress(chosen.len(), "scenarios run");
        let run = |scenario: &&Scenario| {
            let plan = plan::build_scenario(checked, scenario);
            let run = sim::run(&analysis.program, &plan, scenario, &RunOptions::default());
            progress.advance();
            run
        };
        let runs: Vec<_> = chosen.par_iter().map(run).collect();
        drop(progress);
        let (mut passed, mut failed) = (0, 0);
        for (scenario, run) in chosen.iter().zip(&runs) {
            let path = analysis.sources.path(scenario.symbol.span.file);
            match run {
                Ok(run) => {
                    let outcome = outcome(run);
                    let met = outcome.passed();
                    *if met { &mut passed } else { &mut failed } += 1;
                    Terminal::print(&match self.format {
                        Format::Json => report::run(&outcome),
                        Format::Human if met => line("ok", path, scenario, outcome.expectations.len(), terminal),
                        Format::Human => {
                            let line = line("FAILED", path, scenario, outcome.expectations.len(), terminal);
                            line + &report::timeline(&outcome, Terminal::width(), terminal.color_out)
                        }
                    });
                }
                Err(error) => {
                    failed += 1;
                    terminal.fail(&format!("{path}: `{}` cannot be run: {error}", scenario.symbol.name), None);
                }
            }
        }
        if self.coverage {
            let runs =
                chosen.iter().copied().zip(&runs).filter_map(|(scenario, run)| Some((scenario, run.as_ref().ok()?)));
            let runs: Vec<_> = runs.collect();
            let coverage = sim::coverage(&analysis.program, &analysis.sources, &analysis.roots, &runs);
            Terminal::print(&match self.format {
                Format::Human => report::coverage(&coverage, &analysis.sources, terminal.color_out),
                Format::Json => report::coverage_json(&coverage, &analysis.sources),
            });
        }
        terminal.note(&format!("{passed} passed, {failed} failed"));
        Ok(if failed == 0 { super::CLEAN } else { super::FINDINGS })
    }
}

fn line(word: &str, path: &str, scenario: &Scenario, expectations: usize, terminal: &Terminal) -> String {
    let (color, plain) = match (terminal.color_out, word) {
        (false, _) => ("", ""),
        (true, "ok") => ("\x1b[32m", "\x1b[0m"),
        (true, _) => ("\x1b[1;31m", "\x1b[0m"),
    };
    let name = &scenario.symbol.name;
    format!(
        "{color}{word:6}{plain} {path}: {name} ({expectations} expectation{})\n",
        if expectations == 1 { "" } else { "s" }
    )
}
