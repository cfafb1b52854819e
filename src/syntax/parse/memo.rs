//! What the grammar made of texts, kept for the next time they come.

use std::collections::HashMap;
use std::rc::Rc;

use super::grammar::{self, Error, Match, Rule};

type Matched = Rc<Result<Match, Box<Error>>>;
type Texts = HashMap<Rule, HashMap<Box<str>, Matched>>;

/// What the grammar made of the pieces of files, by their texts. It is asked nothing twice, so where most of a file
/// stands as before, most of the work is done; and what comes out is the same, wherever the pieces have moved.
#[derive(Debug, Default)]
pub struct Memo {
    recent: Texts,
    older: Texts,
}

impl Memo {
    /// Forgets what was not asked for since this was called before.
    pub fn forget_unused(&mut self) {
        self.older = std::mem::take(&mut self.recent);
    }

    pub(super) fn run(&mut self, rule: Rule, text: &str) -> Matched {
        if let Some(matched) = self.recent.get(&rule).and_then(|texts| texts.get(text)) {
            return Rc::clone(matched);
        }
        let older = self.older.get_mut(&rule).and_then(|texts| texts.remove_entry(text));
        let (text, matched) = older.unwrap_or_else(|| (text.into(), Rc::new(grammar::run(rule, text))));
        self.recent.entry(rule).or_default().insert(text, Rc::clone(&matched));
        matched
    }
}
