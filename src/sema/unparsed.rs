//! Text that could not be parsed. What it would have declared is not known, and must not be reported as missing.

use std::collections::HashSet;

use super::Unit;
use crate::base::{FileId, Sources, Span};
use crate::syntax::ast;

/// How many words at the start of a broken declaration may be the name it declares: `final mode parked`.
const WORDS: usize = 3;

/// The faults of syntax of all files, and the names that broken declarations may have declared.
pub(super) struct Unparsed<'a> {
    /// By file and place.
    faults: Vec<(FileId, u32)>,
    names: HashSet<&'a str>,
    sources: &'a Sources,
}

impl<'a> Unparsed<'a> {
    /// Linear in the size of the broken text.
    pub(super) fn collect(units: &[Unit], sources: &'a Sources) -> Self {
        let mut faults: Vec<_> =
            units.iter().flat_map(|unit| &unit.faults).map(|fault| (fault.file, fault.start)).collect();
        faults.sort_unstable();
        let mut unparsed = Self { faults, names: HashSet::new(), sources };
        for item in units.iter().flat_map(|unit| &unit.tree.items) {
            unparsed.item(item);
        }
        unparsed
    }

    fn item(&mut self, item: &ast::Item) {
        let broken: Vec<Span> = match item {
            ast::Item::Error(span) => vec![*span],
            ast::Item::Network(network) => pick(&network.items, |item| match item {
                ast::NetworkItem::Error(span) => Some(*span),
                _ => None,
            }),
            ast::Item::Robot(robot) => robot_items(&robot.items),
            ast::Item::Interface(interface) => robot_items(&interface.items),
            ast::Item::Diagram(diagram) => pick(&diagram.items, |item| match item {
                ast::DiagramItem::Error(span) => Some(*span),
                _ => None,
            }),
            _ => Vec::new(),
        };
        for span in broken {
            self.names.extend(self.words(span).take(WORDS));
        }
    }

    fn words(&self, span: Span) -> impl Iterator<Item = &'a str> + use<'a> {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        self.sources.slice(span).split(move |c| !is_word(c)).filter(|word| !word.is_empty())
    }

    /// The word that a broken piece of text begins with.
    pub(super) fn first_word(&self, span: Span) -> &'a str {
        self.words(span).next().unwrap_or("")
    }

    /// Whether a name is unknown because of a fault of syntax: its own, or one in what may have declared it.
    pub(super) fn explains(&self, name: Span) -> bool {
        self.may_declare(self.sources.slice(name)) || self.touches(name)
    }

    /// Whether a broken declaration may have declared that name.
    pub(super) fn may_declare(&self, name: &str) -> bool {
        self.names.contains(name)
    }

    /// Whether there is a fault of syntax in a place.
    pub(super) fn touches(&self, place: Span) -> bool {
        let first = self.faults.partition_point(|fault| *fault < (place.file, place.start));
        self.faults.get(first).is_some_and(|&(file, start)| file == place.file && start <= place.end)
    }
}

fn pick<T>(items: &[T], broken: impl Fn(&T) -> Option<Span>) -> Vec<Span> {
    items.iter().filter_map(broken).collect()
}

fn robot_items(items: &[ast::RobotItem]) -> Vec<Span> {
    pick(items, |item| match item {
        ast::RobotItem::Error(span) => Some(*span),
        _ => None,
    })
}
