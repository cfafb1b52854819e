//! The user's names as Rust spells them, each once in its scope.

use std::collections::HashSet;

use proc_macro2::{Ident, Span};

/// The words that Rust keeps for itself, in any edition.
const KEYWORDS: &[&str] = &[
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "do", "dyn", "else", "enum",
    "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop", "macro", "match", "mod", "move",
    "mut", "override", "priv", "pub", "ref", "return", "static", "struct", "trait", "true", "try", "type", "typeof",
    "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// The keywords that cannot be escaped.
const NEVER_NAMES: &[&str] = &["self", "Self", "super", "crate"];

/// Names that are seen together. A name that is taken gets the first free number behind it, from 2 on.
#[derive(Debug, Clone)]
pub(super) struct Scope {
    taken: HashSet<String>,
}

impl Scope {
    /// A scope in which some names are ours.
    pub(super) fn new(ours: &[&str]) -> Self {
        Self { taken: ours.iter().chain(NEVER_NAMES).map(|&name| name.to_owned()).collect() }
    }

    /// A new name for a value, a field, a function or a module.
    pub(super) fn snake(&mut self, name: &str) -> Ident {
        let name = self.free(&snake(name), "_");
        if KEYWORDS.contains(&name.as_str()) {
            Ident::new_raw(&name, Span::call_site())
        } else {
            Ident::new(&name, Span::call_site())
        }
    }

    /// A new name for a variant.
    pub(super) fn camel(&mut self, name: &str) -> Ident {
        Ident::new(&self.free(&camel(name), ""), Span::call_site())
    }

    fn free(&mut self, name: &str, joint: &str) -> String {
        let numbered = (2_u64..).map(|number| format!("{name}{joint}{number}"));
        let free = std::iter::once(name.to_owned()).chain(numbered).find(|name| !self.taken.contains(name));
        let free = free.unwrap_or_default();
        self.taken.insert(free.clone());
        free
    }
}

/// A name as it is written in texts.
pub(super) fn plain(name: &Ident) -> String {
    name.to_string().trim_start_matches("r#").to_owned()
}

/// A word of the language, in `snake_case` without underscores at its ends or two in a row.
fn snake(name: &str) -> String {
    let mut spelled = String::new();
    let mut before = '_';
    for letter in name.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }) {
        if letter.is_ascii_uppercase() && !before.is_ascii_uppercase() && before != '_' {
            spelled.push('_');
        }
        if letter != '_' || before != '_' {
            spelled.push(letter.to_ascii_lowercase());
        }
        before = letter;
    }
    let spelled = spelled.trim_end_matches('_');
    if spelled.starts_with(|first: char| first.is_ascii_alphabetic()) {
        spelled.to_owned()
    } else {
        format!("n{spelled}")
    }
}

fn camel(name: &str) -> String {
    let snake = snake(name);
    let parts = snake.split('_').map(|part| {
        let (first, rest) = part.split_at_checked(1).unwrap_or_default();
        first.to_ascii_uppercase() + rest
    });
    parts.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_spelled_as_rust_does() {
        let spelled = ["obstacle_id", "heavyBox", "GPS_fix", "_x", "_1", "a__b_", "__"].map(snake);
        assert_eq!(spelled, ["obstacle_id", "heavy_box", "gps_fix", "x", "n1", "a_b", "n"]);
        assert_eq!(["back_up", "heavyBox", "m1_2", "_1"].map(camel), ["BackUp", "HeavyBox", "M12", "N1"]);
    }

    #[test]
    fn names_that_are_taken_are_numbered() {
        let mut scope = Scope::new(&["inputs"]);
        let names = ["move", "inputs", "a", "A", "self", "inputs_2"].map(|name| scope.snake(name).to_string());
        assert_eq!(names, ["r#move", "inputs_2", "a", "a_2", "self_2", "inputs_2_2"]);
        let mut scope = Scope::new(&[]);
        assert_eq!(["m1_2", "m12", "self"].map(|name| scope.camel(name).to_string()), ["M12", "M122", "Self2"]);
    }
}
