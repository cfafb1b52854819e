//! What the user sees, and where it goes.

use std::io::{IsTerminal, Write};

use super::When;
use super::progress::Progress;
use crate::base::Sources;
use crate::diag::{Diagnostic, Severity, rules};
use crate::driver::Analysis;
use crate::report;

/// How to talk to the user.
pub(super) struct Terminal {
    /// Whether human text on standard error is colored.
    pub(super) color_err: bool,
    /// Whether human text on standard output is colored.
    pub(super) color_out: bool,
    /// The least severity that people are shown; nothing but errors when quiet.
    least: Severity,
}

impl Terminal {
    pub(super) fn new(color: When, least: Severity) -> Self {
        let is_forced =
            is_set("CLICOLOR_FORCE") && std::env::var_os("CLICOLOR_FORCE").is_some_and(|value| value != "0");
        let is_allowed = !is_set("NO_COLOR");
        let wanted = |is_terminal: bool| match color {
            When::Auto => is_allowed && (is_forced || is_terminal && Self::can_draw()),
            When::Always => true,
            When::Never => false,
        };
        Self {
            color_err: wanted(std::io::stderr().is_terminal()),
            color_out: wanted(std::io::stdout().is_terminal()),
            least,
        }
    }

    /// Whether a terminal can do more than print lines.
    pub(super) fn can_draw() -> bool {
        std::env::var_os("TERM").is_none_or(|term| term != "dumb")
    }

    /// Shows on a terminal how far so many items are, 0 where nobody knows.
    pub(super) fn progress(&self, items: usize, what: &'static str) -> Progress {
        let is_wanted = self.least < Severity::Error && !is_set("NO_COLOR") && !is_set("CI");
        Progress::new(items, what, is_wanted && Self::can_draw() && std::io::stderr().is_terminal())
    }

    /// Columns of the terminal, 100 where the output is none; `COLUMNS` goes before both.
    pub(super) fn width() -> usize {
        let said = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok());
        let seen = || terminal_size::terminal_size_of(std::io::stdout()).map(|(width, _)| usize::from(width.0));
        said.or_else(seen).filter(|columns| *columns > 0).unwrap_or(100)
    }

    /// A result, on standard output. A reader that has gone away is no error of ours.
    pub(super) fn print(text: &str) {
        match std::io::stdout().write_all(text.as_bytes()) {
            Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
                say(&format!("error: standard output cannot be written: {error}\n"));
                std::process::exit(super::USAGE.into());
            }
            _ => {}
        }
    }

    /// A remark, on standard error.
    pub(super) fn note(&self, text: &str) {
        if self.least < Severity::Error {
            say(&format!("{text}\n"));
        }
    }

    /// What keeps the command from being carried out, on standard error.
    pub(super) fn fail(&self, message: &str, help: Option<&str>) -> u8 {
        let (red, plain) = if self.color_err { ("\x1b[1;31m", "\x1b[0m") } else { ("", "") };
        say(&format!("{red}error{plain}: {message}\n"));
        if let Some(help) = help {
            say(&format!("  = help: {help}\n"));
        }
        super::USAGE
    }

    /// Findings that keep the command from being carried out, on standard error.
    pub(super) fn errors(&self, findings: &[Diagnostic], sources: &Sources) {
        say(&format!("{}\n", report::human(findings, sources, self.color_err).trim_end()));
    }

    /// Findings without those that are only worth knowing, unless these are wanted too.
    pub(super) fn worth_saying(&self, analysis: &Analysis) -> Vec<Diagnostic> {
        let least = self.least.min(Severity::Warning);
        analysis.findings.iter().filter(|finding| finding.severity >= least).cloned().collect()
    }

    /// Findings for people, on standard error.
    pub(super) fn findings(&self, analysis: &Analysis) {
        let mut shown = self.worth_saying(analysis);
        shown.retain(|finding| finding.severity >= self.least);
        if !shown.is_empty() {
            say(&report::human(&shown, &analysis.sources, self.color_err));
            self.note(&report::summary(&shown));
        }
    }
}

/// A text on standard error. A reader that has gone away has seen enough.
fn say(text: &str) {
    let _ = std::io::stderr().write_all(text.as_bytes());
}

/// Whether a variable of the environment says something.
fn is_set(name: &str) -> bool {
    std::env::var_os(name).is_some_and(|value| !value.is_empty())
}

/// Names as a message has them.
pub(super) fn listed<'n>(names: impl IntoIterator<Item = &'n str>) -> String {
    names.into_iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// The exit code that findings call for.
pub(super) fn exit_code(analysis: &Analysis) -> u8 {
    let errors = || analysis.findings.iter().filter(|finding| finding.severity == Severity::Error);
    if errors().any(|finding| finding.rule == &rules::INTERNAL) {
        super::INTERNAL
    } else if errors().any(|finding| finding.rule.level == Severity::Error && finding.rule.code.starts_with("LM00")) {
        super::USAGE
    } else if errors().next().is_some() {
        super::FINDINGS
    } else {
        super::CLEAN
    }
}
