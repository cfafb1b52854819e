//! `lmslc check`

use clap::{Args, ValueEnum};

use super::flags::AnalysisFlags;
use super::terminal::{Terminal, exit_code};
use super::{counterexamples, files::Disk, fix, watch};
use crate::driver::{Analysis, Options};
use crate::report;

/// Report everything that is wrong or doubtful in files.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc check .
  lmslc check behaviors/ --watch
  lmslc check patrol.msd --deny warnings --faults 2
  lmslc check patrol.msd --fix")]
pub(super) struct Check {
    /// Files, folders, or `-` for standard input
    #[arg(required = true)]
    files: Vec<String>,
    /// How to report
    #[arg(long, value_name = "FORMAT", default_value = "human")]
    format: Format,
    /// Change the files where that cannot change behavior, then report what is left
    #[arg(long)]
    fix: bool,
    /// Check again whenever a file that is read changes, or one appears that would be
    #[arg(short, long, conflicts_with = "fix")]
    watch: bool,
    /// Write a scenario into a folder for each refuted property, which `lmslc run` then shows
    #[arg(long, value_name = "DIR")]
    counterexamples: Option<String>,
    #[command(flatten)]
    flags: AnalysisFlags,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    /// With the source, for people
    Human,
    /// One line each: path:line:column: severity[code]: message
    Short,
    /// One JSON object a line
    Json,
    /// SARIF 2.1.0, for code scanning
    Sarif,
    /// Workflow commands, for annotations on GitHub
    Github,
}

impl Check {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        if self.watch {
            watch::refuse(&self.files, matches!(self.format, Format::Human | Format::Short), terminal)?;
            self.flags.apply(&mut Options::default(), terminal)?;
            watch::rounds(terminal, |disk| {
                self.round(&disk.analyze(&self.files, Some(&self.flags), terminal)?, terminal)
            });
        }
        let analysis = if self.fix {
            fix::fix(&self.files, Some(&self.flags), terminal)?
        } else {
            Disk::default().analyze(&self.files, Some(&self.flags), terminal)?
        };
        self.round(&analysis, terminal)
    }

    /// Reports what was found.
    fn round(&self, analysis: &Analysis, terminal: &Terminal) -> Result<u8, u8> {
        match self.format {
            Format::Human => {
                terminal.findings(analysis);
                if terminal.worth_saying(analysis).is_empty() {
                    let count = analysis.roots.len();
                    let files = if count == 1 { "file" } else { "files" };
                    let known = match analysis.findings.as_slice() {
                        [] => "nothing found".to_owned(),
                        known => format!("nothing found; {} with --verbose", report::summary(known)),
                    };
                    let proved = match analysis.proved {
                        0 => String::new(),
                        1 => ", 1 property proved".to_owned(),
                        count => format!(", {count} properties proved"),
                    };
                    terminal.note(&format!("{count} {files} checked: {known}{proved}"));
                }
            }
            Format::Short => Terminal::print(&report::short(&terminal.worth_saying(analysis), &analysis.sources)),
            Format::Sarif => Terminal::print(&report::sarif(&analysis.findings, &analysis.sources)),
            Format::Github => Terminal::print(&report::github(&terminal.worth_saying(analysis), &analysis.sources)),
            Format::Json => Terminal::print(&report::json(&analysis.findings, &analysis.sources)),
        }
        if let Some(folder) = &self.counterexamples {
            counterexamples::write(analysis, folder, terminal)?;
        }
        Ok(exit_code(analysis))
    }
}
