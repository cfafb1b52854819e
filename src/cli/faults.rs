//! `lmslc faults`

use clap::{Args, ValueEnum};

use super::files;
use super::terminal::{Terminal, exit_code};
use crate::{analysis, report};

/// Show what is left of every event under each set of failed sensors.
#[derive(Args)]
#[command(after_help = "\
Sensors fail as their `fails` says; a network on its own by the `fails` of its variables.

Examples:
  lmslc faults stdlib/behaviors/obstacle_manipulation.msd
  lmslc faults stdlib/behaviors/obstacle_manipulation.msd --faults 3 --format html > faults.html")]
pub(super) struct Faults {
    /// The file that holds behaviors or networks, or `-` for standard input
    file: String,
    /// The most sensors that fail together
    #[arg(long = "faults", value_name = "K", default_value_t = 1)]
    up_to: usize,
    /// How to report
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    format: Format,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// For people
    Human,
    /// One JSON object
    Json,
    /// A table in Markdown
    Markdown,
    /// A page of its own
    Html,
}

impl Faults {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        let analysis = files::look(std::slice::from_ref(&self.file), terminal)?;
        if analysis.checked().is_none() {
            return Err(exit_code(&analysis));
        }
        let progress = terminal.progress(0, "looking at every set of failed sensors");
        let table = analysis::fault_table(&analysis.program, &analysis.roots, self.up_to);
        drop(progress);
        if table.rows.iter().all(|row| row.events.is_empty() && row.modes.is_empty()) {
            return Err(terminal.fail(&format!("`{}` holds no behavior or network with an event", self.file), None));
        }
        Terminal::print(&match self.format {
            Format::Human => report::faults(&table, Terminal::width(), terminal.color_out),
            Format::Json => report::faults_json(&table, &self.file),
            Format::Markdown => report::faults_markdown(&table),
            Format::Html => report::faults_html(&table, &self.file),
        });
        Ok(super::CLEAN)
    }
}
