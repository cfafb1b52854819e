//! How to look at files: what the flags of a command say of it.

use clap::Args;

use super::terminal::Terminal;
use crate::diag::{self, Level, find_rule, rules};
use crate::driver::Options;

/// The strictest word for a rule counts.
#[derive(Args)]
#[command(next_help_heading = "Levels, over comments in the source and lmsl.toml")]
pub(super) struct AnalysisFlags {
    /// The most sensors that are looked at as failed together
    #[arg(long, value_name = "K", default_value_t = Options::default().faults, help_heading = "Options")]
    faults: usize,
    /// Do not report a rule, by code or name
    #[arg(long, value_name = "RULE")]
    allow: Vec<String>,
    /// Report a rule as a warning
    #[arg(long, value_name = "RULE")]
    warn: Vec<String>,
    /// Report a rule as an error, or every remaining warning with `warnings`
    #[arg(long, value_name = "RULE|warnings")]
    deny: Vec<String>,
}

impl AnalysisFlags {
    /// Sets what the flags say.
    ///
    /// # Errors
    /// The exit code, where a flag is wrong; that has been reported.
    pub(super) fn apply(&self, options: &mut Options, terminal: &Terminal) -> Result<(), u8> {
        options.faults = self.faults;
        for (level, names) in [(Level::Allow, &self.allow), (Level::Warn, &self.warn), (Level::Deny, &self.deny)] {
            for name in names {
                if level == Level::Deny && name == "warnings" {
                    options.levels.deny_warnings();
                    continue;
                }
                let Some(rule) = find_rule(name) else {
                    let known = rules::names().chain((level == Level::Deny).then_some("warnings"));
                    let help = diag::did_you_mean(name, known);
                    let help = help.unwrap_or_else(|| "`lmslc explain` lists all".to_owned());
                    return Err(terminal.fail(&format!("there is no diagnostic `{name}`"), Some(&help)));
                };
                if !options.levels.set_over_all(rule, level) {
                    let help = "a program it is found in has no meaning";
                    return Err(terminal.fail(&format!("`{}` is always an error", rule.name), Some(help)));
                }
            }
        }
        Ok(())
    }
}
