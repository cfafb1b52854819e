//! Syntax trees to the typed program: names to ids, units to SI, types checked.
//!
//! Imports: base, diag, ir, membership, syntax
//! Crates: –

mod arbiters;
mod bodies;
mod conditions;
mod contacts;
mod crisp;
mod decisions;
mod diagrams;
mod doors;
mod extends;
mod fusion;
mod groups;
mod inference;
mod interfaces;
mod layers;
mod linear;
mod modes;
mod openings;
mod outputs;
mod properties;
mod quantities;
mod robots;
mod rules;
mod scenarios;
mod scope;
mod sensors;
mod shapes;
mod unparsed;
mod unused;
mod windows;
mod worlds;

pub use conditions::FUNCTIONS;
pub use scope::Import;
pub use shapes::shapes;

use std::cell::Cell;
use std::collections::{HashMap, HashSet};

use crate::base::{FileId, Id, Sources, Span};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Program, Symbol};
use crate::syntax::ast;
use scope::Scopes;
use unparsed::Unparsed;

/// A parsed file with what its imports resolved to.
#[derive(Debug, Clone)]
pub struct Unit {
    /// Which file.
    pub file: FileId,
    /// Its syntax tree.
    pub tree: ast::File,
    /// The files it imports; imports that led nowhere are left out.
    pub imports: Vec<Import>,
    /// Where its text could not be parsed.
    pub faults: Vec<Span>,
}

/// What lowering gives.
#[derive(Debug)]
pub struct Lowered {
    /// What the files declare.
    pub program: Program,
    /// What was wrong, or is not used.
    pub diagnostics: Vec<Diagnostic>,
    /// Every name that was understood, with the name where what it means is declared, sorted. A declaration that replaces
    /// another one, or keeps its promise, names it too; an import names the start of its file.
    pub uses: Vec<(Span, Span)>,
}

/// Lowers all files of a compilation together. Total: what is broken is reported and left out, or stands in the program
/// as poison. Linear in the size of the files.
pub fn lower(units: &[Unit], sources: &Sources) -> Lowered {
    let mut diagnostics = Vec::new();
    let scopes = Scopes::collect(units, &mut diagnostics);
    let mut lower = Lower {
        units,
        sources,
        scopes,
        unparsed: Unparsed::collect(units, sources),
        program: Program::default(),
        poison: Poison::default(),
        read: HashSet::new(),
        uses: Vec::new(),
        within: Span::default(),
        comparisons: Cell::new(MOST_COMPARISONS),
        diagnostics,
    };
    for phase in [Phase::Variables, Phase::Networks, Phase::Interfaces, Phase::Robots, Phase::Worlds] {
        lower.declarations(phase);
    }
    for layer in [ast::Layer::Behavior, ast::Layer::Activity, ast::Layer::Goal] {
        lower.declarations(Phase::Diagrams(layer));
    }
    lower.drives();
    lower.declarations(Phase::Arbiters);
    lower.declarations(Phase::Properties);
    lower.monitors();
    lower.declarations(Phase::Scenarios);
    lower.unused_imports();
    lower.unused();
    lower
        .uses
        .extend(units.iter().flat_map(|unit| &unit.imports).map(|import| (import.span, Span::new(import.file, 0, 0))));
    lower.uses.sort_unstable();
    lower.uses.dedup();
    Lowered { program: lower.program, diagnostics: lower.diagnostics, uses: lower.uses }
}

/// The most names that are compared for suggestions in one compilation, so that its cost stays linear.
const MOST_COMPARISONS: usize = 200_000;

/// Declarations are lowered in an order in which each finds what it names.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Phase {
    Variables,
    Networks,
    Interfaces,
    Robots,
    Worlds,
    /// Of one layer: outer ones name inner ones.
    Diagrams(ast::Layer),
    Arbiters,
    Properties,
    Scenarios,
}

/// What lowering has so far. The program only grows; diagnostics are collected.
struct Lower<'a> {
    units: &'a [Unit],
    sources: &'a Sources,
    scopes: Scopes<'a>,
    unparsed: Unparsed<'a>,
    program: Program,
    poison: Poison,
    /// The names of the declarations that something reads.
    read: HashSet<Span>,
    /// See [`Lowered::uses`].
    uses: Vec<(Span, Span)>,
    /// The declaration that is being lowered.
    within: Span,
    /// How many more names may be compared for a suggestion.
    comparisons: Cell<usize>,
    diagnostics: Vec<Diagnostic>,
}

/// What was declared wrongly and reported. It is in the program so that names resolve, and nothing about its use is
/// reported again.
#[derive(Default)]
struct Poison {
    sensors: HashSet<Id<ir::Sensor>>,
    actions: HashSet<Id<ir::Action>>,
    /// Robots without the body they should have.
    robots: HashSet<Id<ir::Robot>>,
    /// Diagrams that sense a broken network: a name that is not known may be one of its events.
    diagrams: HashSet<Id<ir::Diagram>>,
    /// The flags of a diagram that have no meaning, because they need each other in a circle.
    flags: HashMap<Id<ir::Diagram>, Vec<String>>,
}

impl<'a> Lower<'a> {
    fn declarations(&mut self, phase: Phase) {
        let units = self.units;
        for unit in units {
            for item in &unit.tree.items {
                self.within = item.span();
                match (phase, item) {
                    (Phase::Variables, ast::Item::Variable(variable)) => self.variable(variable),
                    (Phase::Networks, ast::Item::Network(network)) => self.network(network),
                    (Phase::Interfaces, ast::Item::Interface(interface)) => self.interface(interface),
                    (Phase::Robots, ast::Item::Robot(robot)) => self.robot(robot),
                    (Phase::Worlds, ast::Item::World(world)) => self.world(world),
                    (Phase::Diagrams(layer), ast::Item::Diagram(diagram)) if diagram.layer == layer => {
                        self.diagram(diagram);
                    }
                    (Phase::Properties, ast::Item::Property(property)) => self.property(property),
                    (Phase::Scenarios, ast::Item::Scenario(scenario)) => self.scenario(scenario),
                    (Phase::Arbiters, ast::Item::Arbiter(arbiter)) => self.arbiter(arbiter),
                    (Phase::Variables, ast::Item::Team(ast::Team { name, .. })) => {
                        self.report(not_supported(name.span, "a team"));
                    }
                    _ => {}
                }
            }
        }
    }

    fn report(&mut self, diagnostic: Diagnostic) {
        let is_unknown = diagnostic.rule == &diag::rules::UNKNOWN_NAME;
        if !is_unknown || !self.unparsed.explains(diagnostic.span()) {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Notes that a name means what is declared elsewhere. What a declaration takes over from another is lowered with it
    /// once more; there it means what it means in the other.
    fn refers(&mut self, name: Span, to: Span) {
        let within = self.within;
        if name.file == within.file && within.start <= name.start && name.end <= within.end {
            self.uses.push((name, to));
        }
    }

    /// The finding for a name that is not among the candidates. A file with thousands of unknown names among thousands
    /// of known ones gets suggestions for the first ones only.
    fn unknown<'s>(
        &self,
        name: &ast::Name,
        what: &str,
        candidates: impl IntoIterator<Item = &'s str, IntoIter: Clone>,
    ) -> Diagnostic {
        let candidates = candidates.into_iter();
        // The upper bound counts what a filter leaves out too: looking at it costs as much.
        let room = self.comparisons.get().checked_sub(candidates.size_hint().1.unwrap_or(usize::MAX));
        self.comparisons.set(room.unwrap_or(0));
        let near = || diag::did_you_mean(&name.text, candidates.clone()).or_else(|| known(candidates.clone()));
        let help = room.and_then(|_| near());
        let message = format!("no {what} is named `{}`", name.text);
        Diagnostic::new(&diag::rules::UNKNOWN_NAME, name.span, message).help_maybe(help)
    }

    /// The text of a declaration or an item.
    fn on_one_line(&self, span: Span) -> String {
        self.sources.slice(span).split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// Reports a second thing where there may be one; keeps the first.
    fn once<T>(&mut self, kept: &mut Option<(T, Span)>, value: T, span: Span, what: &str) {
        match kept {
            None => *kept = Some((value, span)),
            Some((_, first)) => {
                let first = *first;
                self.report(said_twice(span, first, what));
            }
        }
    }
}

fn symbol(name: &ast::Name, doc: Option<&ast::Doc>) -> Symbol {
    let doc = doc.map(|doc| doc.lines.join("\n")).unwrap_or_default();
    Symbol { name: name.text.clone(), span: name.span, doc }
}

/// The help line that names all candidates, where they are few.
fn known<'s>(candidates: impl Iterator<Item = &'s str>) -> Option<String> {
    const FEW: usize = 8;
    let mut names: Vec<_> = candidates.take(FEW + 1).map(|name| format!("`{name}`")).collect();
    names.sort_unstable();
    (1..=FEW).contains(&names.len()).then(|| format!("known are: {}", names.join(", ")))
}

/// `1 argument`, `3 arguments`.
fn counted(count: usize, what: &str) -> String {
    format!("{count} {what}{}", if count == 1 { "" } else { "s" })
}

/// `1 is given`, `3 are given`.
fn given(count: usize) -> String {
    format!("{count} {} given", if count == 1 { "is" } else { "are" })
}

/// The position of a name among symbols.
fn position<'s>(name: &str, symbols: impl IntoIterator<Item = &'s Symbol>) -> Option<usize> {
    symbols.into_iter().position(|symbol| symbol.name == name)
}

/// What is named so among the sensors or actions of a robot or interface.
fn named<'s, T>(name: &str, ids: &[Id<T>], symbol: impl Fn(Id<T>) -> &'s Symbol) -> Option<Id<T>> {
    ids.iter().copied().find(|&id| symbol(id).name == name)
}

fn duplicate(name: &ast::Name, first: Span, what: &str) -> Diagnostic {
    let message = format!("{what} `{}` is declared twice", name.text);
    Diagnostic::new(&diag::rules::DUPLICATE_NAME, name.span, message)
        .here("declared again here")
        .label(first, "first declared here")
        .help("rename one of them")
}

fn said_twice(span: Span, first: Span, what: &str) -> Diagnostic {
    Diagnostic::new(&diag::rules::TWICE, span, format!("{what} is given twice"))
        .here("given again here")
        .label(first, "first given here")
        .help("keep one of them")
}

fn missing_part(span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(&diag::rules::MISSING_PART, span, message)
}

fn invalid(span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(&diag::rules::INVALID_VALUE, span, message)
}

fn not_supported(span: Span, what: &str) -> Diagnostic {
    let message = format!("{what} cannot be compiled by this version");
    Diagnostic::new(&diag::rules::NOT_SUPPORTED, span, message)
        .note("the text is part of the language and was read; its meaning is not implemented yet")
}

/// Adds a symbol's name to those seen, or reports that it stands there already.
fn claim(seen: &mut HashMap<String, Span>, name: &ast::Name, what: &str, diagnostics: &mut Vec<Diagnostic>) -> bool {
    if let Some(&first) = seen.get(&name.text) {
        diagnostics.push(duplicate(name, first, what));
        return false;
    }
    seen.insert(name.text.clone(), name.span);
    true
}

/// A fail reading as the IR has it; `None` where it is not a quantity's.
fn fail_reading(kind: &ast::FailReading) -> Option<ir::FailReading> {
    match kind {
        ast::FailReading::Any(_) => Some(ir::FailReading::Any),
        ast::FailReading::Absent(_) => Some(ir::FailReading::Absent),
        ast::FailReading::Value(_) | ast::FailReading::Set(_) | ast::FailReading::Clear(_) => None,
    }
}
