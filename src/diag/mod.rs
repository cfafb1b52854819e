//! Diagnostics as values: what is wrong, where, why, and what would mend it.
//!
//! Imports: base
//! Crates: strsim

mod fix;
mod levels;
pub mod rules;
mod suppressions;

pub use fix::{Edit, Fix, Fixed, apply_fixes};
pub use levels::{Level, Levels};
pub use rules::{RULES, Rule, find_rule};
pub use suppressions::Suppressions;

use crate::base::Span;

/// How grave a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Worth knowing.
    Info,
    /// Probably not what was meant; the program still has a meaning.
    Warning,
    /// The program has no meaning.
    Error,
}

impl Severity {
    /// As messages and JSON name it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// A place with a few words on it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// What to say of it; may be empty.
    pub message: String,
}

/// One finding. The first label is the primary one: it sits on what the user should edit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Diagnostic {
    /// The rule it belongs to.
    pub rule: &'static Rule,
    /// The rule's level for this run.
    pub severity: Severity,
    /// One line that states a fact about the user's file, in lower case, names in backticks.
    pub message: String,
    /// Places, the primary one first.
    pub labels: Vec<Label>,
    /// The language's rule behind it.
    pub notes: Vec<String>,
    /// The change that would mend it.
    pub help: Option<String>,
    /// That change as edits, where it leaves the program's behavior as it is.
    pub fix: Option<Fix>,
}

impl Diagnostic {
    /// A finding of `rule` at its default level, with its primary label on `span`.
    pub fn new(rule: &'static Rule, span: Span, message: impl Into<String>) -> Self {
        let label = Label { span, message: String::new() };
        let message = message.into();
        Self { rule, severity: rule.level, message, labels: vec![label], notes: Vec::new(), help: None, fix: None }
    }

    /// Says something at the primary place.
    #[must_use]
    pub fn here(mut self, message: impl Into<String>) -> Self {
        if let Some(primary) = self.labels.first_mut() {
            primary.message = message.into();
        }
        self
    }

    /// Adds a secondary place.
    #[must_use]
    pub fn label(mut self, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label { span, message: message.into() });
        self
    }

    /// Adds the language's rule.
    #[must_use]
    pub fn note(mut self, note: impl Into<String>) -> Self {
        self.notes.push(note.into());
        self
    }

    /// Says what to change.
    #[must_use]
    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Says what to change, where there is something to say.
    #[must_use]
    pub fn help_maybe(mut self, help: Option<String>) -> Self {
        self.help = help.or(self.help);
        self
    }

    /// Carries the change out.
    #[must_use]
    pub fn fix(mut self, fix: Fix) -> Self {
        self.fix = Some(fix);
        self
    }

    /// The message with its notes and its help, a line each, for where there is one text only.
    pub fn text(&self) -> String {
        let notes = self.notes.iter().map(|note| format!("\nnote: {note}"));
        let help = self.help.iter().map(|help| format!("\nhelp: {help}"));
        notes.chain(help).fold(self.message.clone(), |text, line| text + &line)
    }

    /// The primary place.
    pub fn span(&self) -> Span {
        self.labels.first().map(|label| label.span).unwrap_or_default()
    }
}

/// Sorts findings by place, then code, and drops repeated ones.
pub fn sort(diagnostics: &mut Vec<Diagnostic>) {
    diagnostics.sort_by(|a, b| (a.span(), a.rule.code, &a.message).cmp(&(b.span(), b.rule.code, &b.message)));
    diagnostics.dedup();
}

/// The candidate most like `name`, where one is like enough to be meant (Damerau-Levenshtein distance at most a
/// third of the name's length, at least one).
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let limit = (name.chars().count() / 3).max(1);
    let distances = candidates
        .into_iter()
        .filter(|&candidate| candidate != name)
        .map(|candidate| (strsim::damerau_levenshtein(&name.to_lowercase(), &candidate.to_lowercase()), candidate));
    distances.filter(|&(distance, _)| distance <= limit).min().map(|(_, candidate)| candidate)
}

/// The help line for a misspelt name, where a candidate is near.
pub fn did_you_mean<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<String> {
    nearest(name, candidates).map(|candidate| format!("did you mean `{candidate}`?"))
}
