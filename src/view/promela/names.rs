//! Identifiers for what has a name, or only a text.

use std::collections::{HashMap, HashSet};

/// What an identifier is of; each has a prefix, a suffix or words that keep it from being a keyword.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    /// A diagram, its layer before its name.
    Process,
    /// A mode to be in.
    Mode,
    /// Something that is true or false on a tick.
    Flag,
    /// A sensor that can fail.
    Sensor,
    /// A way in which sensors fail.
    Fault,
    /// A transition.
    Exit,
}

/// Identifiers that each mean one thing, in the order in which they were needed.
#[derive(Default)]
pub(super) struct Names {
    all: Vec<(Kind, String, String)>,
    known: HashMap<(Kind, String), usize>,
    taken: HashSet<String>,
}

/// Longer texts are cut.
const MOST_LETTERS: usize = 48;

impl Names {
    /// The identifier of a text, the same for the same text.
    pub(super) fn of(&mut self, kind: Kind, text: &str) -> String {
        match self.known.get(&(kind, text.to_owned())) {
            Some(known) => self.all[*known].2.clone(),
            None => self.fresh(kind, text),
        }
    }

    /// An identifier of its own.
    pub(super) fn fresh(&mut self, kind: Kind, text: &str) -> String {
        let words = words(text);
        let mut name = match kind {
            Kind::Mode => format!("in_{words}"),
            Kind::Flag => format!("is_{words}"),
            Kind::Sensor => format!("{words}_is"),
            Kind::Process | Kind::Fault | Kind::Exit => words,
        };
        while !self.taken.insert(name.clone()) {
            name.push('_');
        }
        self.known.insert((kind, text.to_owned()), self.all.len());
        self.all.push((kind, text.to_owned(), name.clone()));
        name
    }

    /// The identifier of a text, or of one like it where that `is_taken` for what only looks alike.
    pub(super) fn distinct(&mut self, kind: Kind, text: &str, is_taken: impl Fn(&String) -> bool) -> String {
        let mut text = text.to_owned();
        let mut name = self.of(kind, &text);
        while is_taken(&name) {
            text.push('\'');
            name = self.of(kind, &text);
        }
        name
    }

    /// The texts of a kind with their identifiers.
    pub(super) fn all(&self, wanted: Kind) -> Vec<(&str, &str)> {
        let of_kind = self.all.iter().filter(|(kind, ..)| *kind == wanted);
        of_kind.map(|(_, text, name)| (text.as_str(), name.as_str())).collect()
    }
}

/// A text as a part of an identifier.
fn words(text: &str) -> String {
    let signs = [("<=", " le "), (">=", " ge "), ("==", " eq "), ("!=", " ne "), ("<", " lt "), (">", " gt ")];
    let text = signs.iter().fold(text.replace('-', " minus "), |text, (sign, word)| text.replace(sign, word));
    let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').filter(|word| !word.is_empty());
    words.collect::<Vec<_>>().join("_").chars().take(MOST_LETTERS).collect()
}
