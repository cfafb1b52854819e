//! The generated parser, and a walk over what it yields.

use pest::Parser;

/// The parser generated from `grammar/`.
#[derive(pest_derive::Parser)]
#[grammar = "grammar/common.pest"]
#[grammar = "grammar/fsfn.pest"]
#[grammar = "grammar/msd.pest"]
struct Grammar;

pub type Error = pest::error::Error<Rule>;

/// What the grammar matched of a text. It holds places in the text and not the text, so it is the match of that text
/// wherever it stands.
#[derive(Debug)]
pub struct Match {
    /// Each in front of its parts.
    nodes: Vec<Node>,
}

#[derive(Debug)]
struct Node {
    rule: Rule,
    start: u32,
    /// The end of its last token.
    end: u32,
    /// The node behind its parts.
    next: u32,
}

/// Matches all of `text` against one of the `only_...` rules.
pub fn run(rule: Rule, text: &str) -> Result<Match, Box<Error>> {
    let pairs = Grammar::parse(rule, text)?;
    let mut nodes: Vec<Node> = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    let mut last_end = 0;
    for token in pairs.tokens() {
        match token {
            pest::Token::Start { rule, pos } => {
                open.push(nodes.len());
                nodes.push(Node { rule, start: pos.pos() as u32, end: 0, next: 0 });
            }
            pest::Token::End { pos, .. } => {
                let next = nodes.len() as u32;
                let Some((at, node)) = open.pop().and_then(|at| Some((at, nodes.get_mut(at)?))) else { break };
                // A node that ends in an optional part also covers the space in front of it.
                if next as usize == at + 1 {
                    last_end = pos.pos() as u32;
                }
                (node.end, node.next) = (last_end, next);
            }
        }
        // Behind the first node only the end of the text is matched.
        if open.is_empty() {
            break;
        }
    }
    if nodes.is_empty() { Err(Box::new(nothing_matched(text))) } else { Ok(Match { nodes }) }
}

fn nothing_matched(text: &str) -> Error {
    let variant = pest::error::ErrorVariant::ParsingError { positives: Vec::new(), negatives: Vec::new() };
    Error::new_from_pos(variant, pest::Position::from_start(text))
}

impl Match {
    /// All nodes: their rules, and where they stand in the text that was matched.
    #[cfg(test)]
    pub fn nodes(&self) -> impl Iterator<Item = (Rule, std::ops::Range<usize>)> {
        self.nodes.iter().map(|node| (node.rule, node.start as usize..node.end as usize))
    }

    /// The node that holds all others, in the text that was matched.
    pub fn root<'i>(&'i self, text: &'i str) -> Option<Pair<'i>> {
        Pairs { nodes: &self.nodes, text, at: 0, end: self.nodes.len() }.next()
    }
}

/// A node in its text.
#[derive(Clone, Copy)]
pub struct Pair<'i> {
    nodes: &'i [Node],
    text: &'i str,
    at: usize,
    node: &'i Node,
}

impl<'i> Pair<'i> {
    pub fn as_rule(&self) -> Rule {
        self.node.rule
    }

    /// Its first byte.
    pub fn start(&self) -> usize {
        self.node.start as usize
    }

    /// The end of its last token.
    pub fn end(&self) -> usize {
        self.node.end as usize
    }

    pub fn as_str(&self) -> &'i str {
        self.text.get(self.start()..self.end()).unwrap_or("")
    }

    pub fn into_inner(self) -> Pairs<'i> {
        Pairs { nodes: self.nodes, text: self.text, at: self.at + 1, end: self.node.next as usize }
    }
}

/// The parts of a node, in order.
#[derive(Clone)]
pub struct Pairs<'i> {
    nodes: &'i [Node],
    text: &'i str,
    at: usize,
    end: usize,
}

impl<'i> Iterator for Pairs<'i> {
    type Item = Pair<'i>;

    fn next(&mut self) -> Option<Pair<'i>> {
        let at = self.at;
        let node = self.nodes.get(at).filter(|_| at < self.end)?;
        self.at = node.next as usize;
        Some(Pair { nodes: self.nodes, text: self.text, at, node })
    }
}

/// The children of a node in order, where marks and keywords can be passed over.
pub struct Parts<'i>(std::iter::Peekable<Pairs<'i>>);

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
