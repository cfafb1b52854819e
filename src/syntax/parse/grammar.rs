//! The generated parser, and a walk over what it yields.

use pest::Parser;
use pest::iterators::Pairs;

/// The parser generated from `grammar/`.
#[derive(pest_derive::Parser)]
#[grammar = "grammar/common.pest"]
#[grammar = "grammar/fsfn.pest"]
#[grammar = "grammar/msd.pest"]
struct Grammar;

pub type Pair<'i> = pest::iterators::Pair<'i, Rule>;
pub type Error = pest::error::Error<Rule>;

/// Matches all of `text` against one of the `only_...` rules.
pub fn run(rule: Rule, text: &str) -> Result<Pair<'_>, Box<Error>> {
    match Grammar::parse(rule, text) {
        Ok(mut pairs) => pairs.next().ok_or_else(|| Box::new(nothing_matched(text))),
        Err(error) => Err(Box::new(error)),
    }
}

fn nothing_matched(text: &str) -> Error {
    let variant = pest::error::ErrorVariant::ParsingError { positives: Vec::new(), negatives: Vec::new() };
    Error::new_from_pos(variant, pest::Position::from_start(text))
}

/// The children of a node in order, where marks and keywords can be passed over.
pub struct Parts<'i>(std::iter::Peekable<Pairs<'i, Rule>>);

impl<'i> Parts<'i> {
    pub fn of(pair: Pair<'i>) -> Self {
        Self(pair.into_inner().peekable())
    }

    /// The next child that is not a mark or a keyword.
    pub fn next(&mut self) -> Option<Pair<'i>> {
        self.pass_marks();
        self.0.next()
    }

    /// The next child that is not a mark or a keyword, if it is a `rule`.
    pub fn take(&mut self, rule: Rule) -> Option<Pair<'i>> {
        self.pass_marks();
        self.0.next_if(|pair| pair.as_rule() == rule)
    }

    /// All children from here on that are a `rule`, up to the first that is neither that nor a mark.
    pub fn take_all(&mut self, rule: Rule) -> impl Iterator<Item = Pair<'i>> {
        std::iter::from_fn(move || self.take(rule))
    }

    fn pass_marks(&mut self) {
        while self.0.next_if(|pair| super::phrases::is_token(pair.as_rule())).is_some() {}
    }
}

/// The end of the last token of a node: a node that ends in an optional part also covers the space in front of it.
pub fn end(pair: &Pair<'_>) -> usize {
    let mut last = pair.clone();
    while let Some(child) = last.clone().into_inner().next_back() {
        last = child;
    }
    last.as_span().end()
}
