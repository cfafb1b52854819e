//! Which findings count, and how much.

use std::collections::BTreeMap;

use super::{Diagnostic, Rule, Severity};

/// The level a project gives to a rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Level {
    /// Not reported.
    Allow,
    /// Reported as a warning.
    Warn,
    /// Reported as an error.
    Deny,
}

/// The levels of one run. Rules that are errors by nature keep their level: without them the program has no meaning.
#[derive(Debug, Clone, Default)]
pub struct Levels {
    rules: BTreeMap<&'static str, Level>,
    deny_warnings: bool,
}

impl Levels {
    /// Sets the level of a rule; the later word counts. Answers false for a rule that is an error by nature.
    pub fn set(&mut self, rule: &Rule, level: Level) -> bool {
        if rule.level != Severity::Error {
            self.rules.insert(rule.code, level);
        }
        rule.level != Severity::Error || level == Level::Deny
    }

    /// Makes errors of all warnings.
    pub fn deny_warnings(&mut self) {
        self.deny_warnings = true;
    }

    /// Gives each finding its severity and drops those that are allowed.
    pub fn apply(&self, findings: &mut Vec<Diagnostic>) {
        findings.retain_mut(|finding| {
            match self.rules.get(finding.rule.code) {
                Some(Level::Allow) => return false,
                Some(Level::Warn) => finding.severity = Severity::Warning,
                Some(Level::Deny) => finding.severity = Severity::Error,
                None => {}
            }
            if self.deny_warnings && finding.severity == Severity::Warning {
                finding.severity = Severity::Error;
            }
            true
        });
    }
}
