//! The command line: arguments, files, the terminal, exit codes. One subcommand a file.
//!
//! Imports: analysis, base, diag, driver, emit, interp, ir, lsp, plan, repl, report, sim, trace, view
//! Crates: clap, clap_complete, clap_mangen, indicatif, rayon, reedline, serde, similar, terminal_size, toml
#![expect(clippy::disallowed_methods, reason = "this room is the one that touches the world")]

mod build;
mod check;
mod completions;
mod config;
mod counterexamples;
mod eval;
mod explain;
mod faults;
mod files;
mod fix;
mod flags;
mod fmt;
mod graph;
mod lsp;
mod new;
mod progress;
mod repl;
mod run;
mod script;
mod terminal;
mod test;
mod watch;

pub use script::build;

use std::process::ExitCode;

use clap::{Parser, Subcommand, ValueEnum};
use terminal::Terminal;

use crate::diag::Severity;

/// Nothing was found.
const CLEAN: u8 = 0;
/// Findings, or expectations that were not met.
const FINDINGS: u8 = 1;
/// Wrong arguments, or files that cannot be read.
const USAGE: u8 = 2;
/// A fault of the compiler; a panic exits with it too.
const INTERNAL: u8 = 101;

#[derive(Parser)]
#[command(
    name = "lmslc",
    version,
    about = "Compiles robot behavior written as text: modes with prioritized exits, fed by fuzzy sensor fusion.",
    after_help = "Exit codes: 0 clean, 1 findings or failed expectations, 2 wrong arguments or files, 101 a bug in lmslc, 130 interrupted.\n\
                  Human text goes to standard error, machine formats and results to standard output.",
    max_term_width = 100
)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// When to color: `auto` colors a terminal unless NO_COLOR is set, and everything where CLICOLOR_FORCE is
    #[arg(long, global = true, value_name = "WHEN", default_value = "auto")]
    color: When,
    /// Print nothing but what was asked for: no warnings, no summary
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Also print what is only worth knowing
    #[arg(short, long, global = true, conflicts_with = "quiet")]
    verbose: bool,
}

impl Arguments {
    /// The least severity that people are shown.
    fn least(&self) -> Severity {
        match (self.quiet, self.verbose) {
            (true, _) => Severity::Error,
            (false, false) => Severity::Warning,
            (false, true) => Severity::Info,
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum When {
    Auto,
    Always,
    Never,
}

#[derive(Subcommand)]
enum Command {
    /// Make a project that checks, runs and tests at once
    New(new::New),
    /// Report everything that is wrong or doubtful in files
    Check(check::Check),
    /// Compile behaviors and networks to code, or to what other tools read
    Build(build::Build),
    /// Run a scenario in the simulator and print its timeline of modes
    Run(run::Run),
    /// Run every scenario and report each expectation
    Test(test::Test),
    /// Evaluate a network on given readings
    Eval(eval::Eval),
    /// Drive a behavior by hand: set sensors, fail them, step, and ask why
    Repl(repl::Repl),
    /// Show what is left of every event under each set of failed sensors
    Faults(faults::Faults),
    /// Lay files out in the one canonical way
    Fmt(fmt::Fmt),
    /// Draw mode switching diagrams, or networks
    Graph(graph::Graph),
    /// Serve an editor: the language server, over standard input and output
    Lsp(lsp::Lsp),
    /// Explain a diagnostic, by its code or its name
    Explain(explain::Explain),
    /// Print what a shell needs to complete commands, flags and files
    Completions(completions::Completions),
    /// Print the manual, for `man -l -`
    Man,
}

/// Parses the process's arguments, does what they say, and answers the exit code.
pub fn main() -> ExitCode {
    let arguments = Arguments::parse();
    let terminal = Terminal::new(arguments.color, arguments.least());
    let code = match arguments.command {
        Command::New(new) => new.execute(&terminal),
        Command::Check(check) => check.execute(&terminal),
        Command::Run(run) => run.execute(&terminal),
        Command::Test(test) => test.execute(&terminal),
        Command::Eval(eval) => eval.execute(&terminal),
        Command::Repl(repl) => repl.execute(&terminal),
        Command::Faults(faults) => faults.execute(&terminal),
        Command::Build(build) => build.execute(&terminal),
        Command::Fmt(fmt) => fmt.execute(&terminal),
        Command::Graph(graph) => graph.execute(&terminal),
        Command::Lsp(_) => Ok(lsp::serve(&terminal)),
        Command::Explain(explain) => Ok(explain.execute(&terminal)),
        Command::Completions(completions) => Ok(completions.execute()),
        Command::Man => Ok(completions::man()),
    };
    // Whether a command came to its end or was cut short, its answer is an exit code.
    ExitCode::from(code.unwrap_or_else(|code| code))
}
