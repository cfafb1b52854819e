//! Text to syntax tree. The text is scanned once for its layout, cut into declarations, and each is parsed by the
//! grammar; a broken one is cut further, so that one fault costs one member and gives one finding.

mod depth;
mod expressions;
mod fusion;
mod grammar;
mod layout;
mod memo;
mod message;
mod modes;
mod phrases;
mod pieces;
mod recovery;
mod robots;
mod scan;
#[cfg(test)]
#[allow(clippy::indexing_slicing, reason = "tests")]
mod tests;
mod tree;
mod trials;

use super::ast::{File, FileKind, Item};
use crate::base::{FileId, Span};
use crate::diag::{self, Diagnostic, rules};
use grammar::{Match, Parts};
pub(super) use grammar::{Pair, Rule};
use layout::Layout;
pub use memo::Memo;
use recovery::Recovery;
use scan::Scan;
pub use scan::{Kind as TokenKind, Token};
use tree::Tree;

/// The words that cannot be names.
pub const KEYWORDS: &[&str] = &[
    "action",
    "activity",
    "after",
    "again",
    "always",
    "and",
    "arbiter",
    "behavior",
    "client",
    "contributor",
    "decide",
    "detractor",
    "done",
    "else",
    "emergency",
    "entry",
    "event",
    "expect",
    "extends",
    "fail",
    "fault",
    "final",
    "flag",
    "goal",
    "import",
    "in",
    "interface",
    "is",
    "logical",
    "mode",
    "network",
    "never",
    "not",
    "on",
    "or",
    "output",
    "place",
    "property",
    "provides",
    "requires",
    "robot",
    "rule",
    "runs",
    "scenario",
    "sense",
    "sensor",
    "team",
    "variable",
    "world",
];

/// The tokens of a text of either kind, comments left out. Total, and linear in the text.
pub fn tokens(text: &str) -> Vec<Token> {
    Scan::new(text).tokens
}

/// Whether a text is a name, and no keyword.
pub fn is_name(text: &str) -> bool {
    let is_word = matches!(&*Scan::new(text).tokens, [token] if token.kind == scan::Kind::Word && token.end as usize == text.len());
    is_word && text != "_" && KEYWORDS.binary_search(&text).is_err()
}

/// The kind of file that a text without a name is written for: that of its first declaration that belongs in one kind.
pub fn kind_of(text: &str) -> FileKind {
    let scan = Scan::new(text);
    let layout = Layout::new(text, &scan);
    let first = layout.declarations().into_iter().map(|piece| layout.word(piece.start)).find(|word| *word != "import");
    if matches!(first, Some("variable" | "network")) { FileKind::Fusion } else { FileKind::Modes }
}

/// Parses a file of either kind. Total: any text gives a tree and findings. Linear in the text.
///
/// Raises LM0101, LM0102, LM0103, LM0104 and, for options that are said twice, LM0310.
pub fn parse(file: FileId, kind: FileKind, text: &str) -> (File, Vec<Diagnostic>) {
    parse_again(&mut Memo::default(), file, kind, text)
}

/// As [`parse`], where parts of the text may have been parsed before.
pub fn parse_again(memo: &mut Memo, file: FileId, kind: FileKind, text: &str) -> (File, Vec<Diagnostic>) {
    let scan = Scan::new(text);
    let layout = Layout::new(text, &scan);
    let tree = Tree { file, text, scan: &scan, base: 0, diagnostics: Vec::new() };
    let mut recovery = Recovery { tree, layout: &layout, memo };
    recovery
        .tree
        .diagnostics
        .extend(layout.faults.iter().filter_map(|&fault| message::brace_fault(&layout, file, fault)));
    let mut items = Vec::new();
    for piece in layout.declarations() {
        let item = recovery.declaration(&piece);
        recovery.tree.diagnostics.extend(wrong_kind(kind, &item));
        items.push(item);
    }
    let mut diagnostics = recovery.tree.diagnostics;
    diag::sort(&mut diagnostics);
    (File { kind, items, span: Span::new(file, 0, text.len() as u32) }, diagnostics)
}

/// What the grammar matches of a text that parses: each declaration with the place where its text begins.
pub(super) fn declarations(text: &str) -> Vec<(usize, Match)> {
    let scan = Scan::new(text);
    let layout = Layout::new(text, &scan);
    let matched = |piece: std::ops::Range<usize>| {
        let (first, last) = (layout.tokens.get(piece.start)?, layout.tokens.get(piece.end.checked_sub(1)?)?);
        let (start, end) = (first.start as usize, last.end as usize);
        Some((start, grammar::run(Rule::only_declaration, text.get(start..end)?).ok()?))
    };
    layout.declarations().into_iter().filter_map(matched).collect()
}

impl Tree<'_> {
    fn declaration(&mut self, pair: Pair<'_>) -> Option<Item> {
        let item = Parts::of(pair).next()?;
        match item.as_rule() {
            Rule::import => {
                let span = self.span(&item);
                let path = self.path(Parts::of(item).take(Rule::path)?);
                Some(Item::Import(super::ast::Import { path, span }))
            }
            Rule::variable => self.variable(item).map(Item::Variable),
            Rule::network => self.network(item).map(Item::Network),
            Rule::interface => self.interface(item).map(Item::Interface),
            Rule::robot => self.robot(item).map(Item::Robot),
            Rule::diagram => self.diagram(item).map(Item::Diagram),
            Rule::arbiter => self.arbiter(item).map(Item::Arbiter),
            Rule::team => self.team(item).map(Item::Team),
            Rule::world => self.world(item).map(Item::World),
            Rule::scenario => self.scenario(item).map(Item::Scenario),
            _ => self.property(item).map(Item::Property),
        }
    }
}

/// The finding for a declaration that belongs in the other kind of file.
fn wrong_kind(kind: FileKind, item: &Item) -> Option<Diagnostic> {
    let (belongs, what, name) = match item {
        Item::Variable(node) => (FileKind::Fusion, "variable", &node.name),
        Item::Network(node) => (FileKind::Fusion, "network", &node.name),
        Item::Interface(node) => (FileKind::Modes, "interface", &node.name),
        Item::Robot(node) => (FileKind::Modes, "robot", &node.name),
        Item::Diagram(node) => (FileKind::Modes, node.layer.keyword(), &node.name),
        Item::Arbiter(node) => (FileKind::Modes, "arbiter", &node.name),
        Item::Team(node) => (FileKind::Modes, "team", &node.name),
        Item::World(node) => (FileKind::Modes, "world", &node.name),
        Item::Scenario(node) => (FileKind::Modes, "scenario", &node.name),
        Item::Property(node) => (FileKind::Modes, "property", &node.name),
        Item::Import(_) | Item::Error(_) => return None,
    };
    if belongs == kind {
        return None;
    }
    let (here, there) = match kind {
        FileKind::Fusion => (".fsfn", ".msd"),
        FileKind::Modes => (".msd", ".fsfn"),
    };
    let message = format!("{what} `{}` stands in a `{here}` file", name.text);
    let help = format!("move it to a `{there}` file and `import` that");
    Some(Diagnostic::new(&rules::WRONG_FILE_KIND, name.span, message).help(help))
}
