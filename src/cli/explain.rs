//! `lmslc explain`

use clap::Args;

use super::terminal::Terminal;
use crate::diag::{self, RULES, find_rule, rules};

/// Explain a diagnostic, by its code or its name.
#[derive(Args)]
pub(super) struct Explain {
    /// A code such as LM0403, or a name such as duplicate-priority; all are listed without one
    rule: Option<String>,
    /// List the diagnostics whose pages speak of this instead
    #[arg(short, long, value_name = "TEXT", conflicts_with = "rule")]
    search: Option<String>,
}

impl Explain {
    pub(super) fn execute(&self, terminal: &Terminal) -> u8 {
        let Some(wanted) = &self.rule else { return self.list(terminal) };
        match find_rule(wanted) {
            Some(rule) => {
                Terminal::print(rule.page);
                super::CLEAN
            }
            None => {
                let near = diag::did_you_mean(wanted, rules::names());
                let spoken_of = (!speaking_of(wanted).is_empty())
                    .then(|| format!("`lmslc explain --search {wanted}` lists those that speak of it"));
                let help = near.or(spoken_of).unwrap_or_else(|| "`lmslc explain` lists all".to_owned());
                terminal.fail(&format!("there is no diagnostic `{wanted}`"), Some(&help))
            }
        }
    }

    /// Lists all diagnostics, or those that speak of what is searched for.
    fn list(&self, terminal: &Terminal) -> u8 {
        let wanted = self.search.as_deref().unwrap_or_default();
        let found = speaking_of(wanted);
        if found.is_empty() {
            return terminal.fail(&format!("no diagnostic speaks of `{wanted}`"), Some("`lmslc explain` lists all"));
        }
        let width = found.iter().map(|rule| rule.name.len()).max().unwrap_or(0);
        let line = |rule: &&diag::Rule| {
            format!("{}  {:width$}  {:7}  {}\n", rule.code, rule.name, rule.level.name(), rule.summary)
        };
        Terminal::print(&found.iter().map(line).collect::<String>());
        super::CLEAN
    }
}

/// The rules whose names or pages hold a text, in whatever case.
fn speaking_of(text: &str) -> Vec<&'static diag::Rule> {
    let wanted = text.to_lowercase();
    let speaks = |rule: &&diag::Rule| format!("{} {}", rule.name, rule.page).to_lowercase().contains(&wanted);
    RULES.iter().copied().filter(speaks).collect()
}
