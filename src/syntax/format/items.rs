//! A file as items that each begin on a line of their own, with all their tokens, and with the comments at these.

use crate::syntax::parse::{Pair, Rule, declarations};

/// A token with the comments around it.
pub struct Token<'t> {
    pub text: &'t str,
    pub rule: Rule,
    /// What it is a part of.
    pub parent: Rule,
    /// Comments on lines of their own in front of it.
    pub before: Vec<Note<'t>>,
    /// Whether an empty line stands in front of it, behind those comments.
    pub blank_before: bool,
    /// A comment behind it on its line.
    pub after: Option<&'t str>,
    /// Where it begins in the text, and the line that is.
    start: usize,
    line: usize,
}

/// A comment on a line of its own.
pub struct Note<'t> {
    pub text: &'t str,
    /// Whether an empty line stands in front of it.
    pub blank_before: bool,
}

/// Something that begins on a line of its own.
pub struct Item<'t> {
    pub kind: Rule,
    /// All but what its block holds.
    pub tokens: Vec<Token<'t>>,
    /// Always at its end.
    pub block: Option<Block<'t>>,
}

/// Items that belong to another one.
pub struct Block<'t> {
    pub items: Vec<Item<'t>>,
    /// The closing brace; none for the rules of a side.
    pub close: Option<Token<'t>>,
    /// Whether the author wrote all of it on the line of what it belongs to.
    pub on_one_line: bool,
}

/// All of a file.
pub struct File<'t> {
    pub items: Vec<Item<'t>>,
    /// Comments behind everything.
    pub tail: Vec<Note<'t>>,
}

/// The items of a text that parses.
pub fn file(text: &str) -> File<'_> {
    let matched = declarations(text);
    let mut tokens = Vec::new();
    let mut declarations = Vec::new();
    for (base, matched) in &matched {
        let text = text.get(*base..).unwrap_or("");
        if let Some(declaration) = matched.root(text) {
            leaves(declaration, declaration.as_rule(), (*base, text), &mut tokens);
            declarations.push(declaration);
        }
    }
    let tail = attach_comments(text, &mut tokens);
    let mut tokens = tokens.into_iter();
    let items = declarations.into_iter().map(|declaration| item(declaration, &mut tokens)).collect();
    File { items, tail }
}

/// Whether a node is one token.
fn is_token(pair: &Pair<'_>) -> bool {
    matches!(pair.as_rule(), Rule::unit | Rule::path) || pair.into_inner().next().is_none()
}

/// Adds the tokens of a node, given the text that was matched and where that begins.
fn leaves<'t>(pair: Pair<'_>, parent: Rule, (base, text): (usize, &'t str), tokens: &mut Vec<Token<'t>>) {
    let rule = pair.as_rule();
    if is_token(&pair) {
        let (start, text) = (base + pair.start(), text.get(pair.start()..pair.end()).unwrap_or(""));
        let (before, blank_before, after, line) = (Vec::new(), false, None, 0);
        tokens.push(Token { text, rule, parent, before, blank_before, after, start, line });
        return;
    }
    for part in pair.into_inner() {
        leaves(part, rule, (base, text), tokens);
    }
}

/// Gives each token the comments in the space in front of it, and the one before it that behind it; answers what stands
/// behind the last one.
fn attach_comments<'t>(text: &'t str, tokens: &mut [Token<'t>]) -> Vec<Note<'t>> {
    let (mut at, mut line) = (0, 0);
    for index in 0..=tokens.len() {
        let start = tokens.get(index).map_or(text.len(), |token| token.start);
        let gap = text.get(at..start).unwrap_or_default();
        line += gap.matches('\n').count();
        let mut lines = gap.split('\n').map(str::trim).peekable();
        let behind = if index > 0 { lines.next().filter(|first| !first.is_empty()) } else { None };
        let (mut notes, mut blank_before) = (Vec::new(), false);
        while let Some(text) = lines.next() {
            if !text.is_empty() {
                notes.push(Note { text, blank_before });
                blank_before = false;
            } else if lines.peek().is_some() {
                blank_before = true;
            }
        }
        if let Some(last) = index.checked_sub(1).and_then(|last| tokens.get_mut(last)) {
            last.after = behind;
        }
        let Some(token) = tokens.get_mut(index) else { return notes };
        at = start + token.text.len();
        (token.before, token.blank_before, token.line) = (notes, blank_before, line);
    }
    Vec::new()
}

fn item<'t>(pair: Pair<'_>, tokens: &mut impl Iterator<Item = Token<'t>>) -> Item<'t> {
    let mut pair = pair;
    while is_wrapper(pair.as_rule())
        && let Some(inner) = pair.into_inner().next()
    {
        pair = inner;
    }
    let mut item = Item { kind: pair.as_rule(), tokens: Vec::new(), block: None };
    collect(pair, &mut item, tokens);
    item
}

/// Adds the tokens of a node to an item: in front of its block, or in it.
fn collect<'t>(pair: Pair<'_>, to: &mut Item<'t>, tokens: &mut impl Iterator<Item = Token<'t>>) {
    if is_token(&pair) {
        to.tokens.extend(tokens.next());
        return;
    }
    let rule = pair.as_rule();
    for part in pair.into_inner() {
        match &mut to.block {
            Some(block) if part.as_rule() == Rule::close_brace => block.close = tokens.next(),
            Some(block) => block.items.push(item(part, tokens)),
            None => {
                let opens = part.as_rule() == Rule::open_brace && holds_items(rule) || part.as_rule() == Rule::side;
                collect(part, to, tokens);
                if opens {
                    to.block = Some(Block { items: Vec::new(), close: None, on_one_line: false });
                }
            }
        }
    }
    if let (Some(block), Some(opened)) = (&mut to.block, to.tokens.last()) {
        block.on_one_line = block.last_line() == Some(opened.line);
    }
}

impl Block<'_> {
    /// The line on which it ends.
    fn last_line(&self) -> Option<usize> {
        let last = self.items.last();
        let inside = || match last?.block.as_ref() {
            Some(block) => block.last_line(),
            None => last?.tokens.last().map(|token| token.line),
        };
        self.close.as_ref().map(|close| close.line).or_else(inside)
    }
}

impl Item<'_> {
    /// The line on which it begins.
    pub fn line(&self) -> Option<usize> {
        self.tokens.first().map(|token| token.line)
    }

    /// Whether an empty line stands in front of it or of its comments.
    pub fn is_set_off(&self) -> bool {
        self.tokens
            .first()
            .is_some_and(|token| token.before.first().map_or(token.blank_before, |note| note.blank_before))
    }
}

/// What only says what else may stand there.
fn is_wrapper(rule: Rule) -> bool {
    matches!(
        rule,
        Rule::declaration
            | Rule::network_item
            | Rule::event_rule
            | Rule::robot_item
            | Rule::diagram_item
            | Rule::mode_item
            | Rule::arbiter_item
            | Rule::team_item
            | Rule::world_item
            | Rule::scenario_item
    )
}

/// Whether the braces of a rule hold items; those of others hold lists of names.
fn holds_items(rule: Rule) -> bool {
    matches!(
        rule,
        Rule::terms
            | Rule::network
            | Rule::event
            | Rule::robot_block
            | Rule::body
            | Rule::diagram
            | Rule::mode_block
            | Rule::commands
            | Rule::decide
            | Rule::arbiter
            | Rule::team
            | Rule::world
            | Rule::scenario
    )
}
