//! Which findings count, and how much.

use std::collections::BTreeMap;

use super::{Diagnostic, Rule, Severity, Suppressions};

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
    overrides: BTreeMap<&'static str, Level>,
    deny_warnings: bool,
}

impl Levels {
    /// Sets the level of a rule; the later word counts. Answers false for a rule that is an error by nature.
    pub fn set(&mut self, rule: &Rule, level: Level) -> bool {
        set(&mut self.rules, rule, level)
    }

    /// As `set`, over what has been set and over the suppressions in the sources.
    pub fn set_over_all(&mut self, rule: &Rule, level: Level) -> bool {
        set(&mut self.overrides, rule, level)
    }

    /// Makes errors of all warnings that remain.
    pub fn deny_warnings(&mut self) {
        self.deny_warnings = true;
    }

    /// Gives each finding its severity and drops those that are allowed or suppressed.
    pub fn apply(&self, findings: &mut Vec<Diagnostic>, suppressions: &Suppressions) {
        findings.retain_mut(|finding| {
            let code = finding.rule.code;
            let level = match self.overrides.get(code) {
                None if suppressions.cover(finding) => Some(&Level::Allow),
                None => self.rules.get(code),
                over_all => over_all,
            };
            match level {
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

fn set(levels: &mut BTreeMap<&'static str, Level>, rule: &Rule, level: Level) -> bool {
    if rule.level != Severity::Error {
        levels.insert(rule.code, level);
    }
    rule.level != Severity::Error || level == Level::Deny
}
