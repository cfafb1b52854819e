//! A diagram driven by hand: commands as values, the state of the session, answers as text.
//!
//! Imports: base, diag, interp, ir, plan, report, sim, syntax, verify
//! Crates: –

mod command;
mod load;
mod name;
mod session;
mod show;
mod twin;
mod why;

pub use command::{COMMANDS, Takes, Usage};
pub use name::{Names, is_of_name};
pub use session::{Driven, Reply, Saved, Session};

/// What keeps a command from being carried out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// One line that states a fact.
    pub message: String,
    /// What to type instead.
    pub help: Option<String>,
}

impl Refusal {
    fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None }
    }

    fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}
