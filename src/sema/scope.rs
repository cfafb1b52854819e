//! What each file can name: its own declarations and those of the files it imports.

use std::collections::{HashMap, HashSet};

use super::{Lower, Unit, duplicate};
use crate::base::{FileId, Id, Sources, Span};
use crate::diag::{self, Diagnostic, Edit, Fix};
use crate::ir;
use crate::syntax::ast;

/// An import that led to a file.
#[derive(Debug, Clone, Copy)]
pub struct Import {
    /// The file it led to.
    pub file: FileId,
    /// Where it is written.
    pub span: Span,
}

/// What a top-level name stands for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Declared<'a> {
    Variable(&'a ast::Variable),
    Network(&'a ast::Network),
    Interface(&'a ast::Interface),
    Robot(&'a ast::Robot),
    Diagram(&'a ast::Diagram),
    Arbiter(&'a ast::Arbiter),
    World(&'a ast::World),
    Scenario(&'a ast::Scenario),
    Property(&'a ast::Property),
    /// Something whose meaning is not implemented yet.
    Later(&'static str),
}

impl Declared<'_> {
    fn kind(self) -> &'static str {
        match self {
            Self::Variable(_) => "variable",
            Self::Network(_) => "network",
            Self::Interface(_) => "interface",
            Self::Robot(_) => "robot",
            Self::Diagram(diagram) => diagram.layer.keyword(),
            Self::Arbiter(_) => "arbiter",
            Self::World(_) => "world",
            Self::Scenario(_) => "scenario",
            Self::Property(_) => "property",
            Self::Later(kind) => kind,
        }
    }
}

#[derive(Debug, Clone, Copy)]
struct Entry<'a> {
    declared: Declared<'a>,
    span: Span,
}

/// The names each file can use, and the ids of what has been lowered. A declaration is known by the place of its name.
pub(super) struct Scopes<'a> {
    files: HashMap<FileId, HashMap<&'a str, Entry<'a>>>,
    /// Which file has used a name of which.
    used: HashSet<(FileId, FileId)>,
    /// Files with an import that led nowhere.
    incomplete: HashSet<FileId>,
    /// The diagrams that each file declares or, where it declares none, those of its imports; in the order of the text.
    pub(super) choices: HashMap<FileId, Vec<&'a ast::Diagram>>,
    /// The properties that each file declares or imports, in the order of the text.
    claims: HashMap<FileId, Vec<&'a ast::Property>>,
    pub(super) variables: HashMap<Span, Id<ir::Variable>>,
    pub(super) networks: HashMap<Span, Id<ir::Network>>,
    pub(super) interfaces: HashMap<Span, Id<ir::Interface>>,
    pub(super) robots: HashMap<Span, Id<ir::Robot>>,
    pub(super) diagrams: HashMap<Span, Id<ir::Diagram>>,
    pub(super) worlds: HashMap<Span, Id<ir::World>>,
    pub(super) properties: HashMap<Span, Id<ir::Property>>,
    /// For the scenarios of a file that run a diagram: the properties of it that the file declares or imports.
    pub(super) monitored: HashMap<(FileId, Id<ir::Diagram>), Vec<Id<ir::Property>>>,
}

impl<'a> Scopes<'a> {
    /// Collects the declarations of every file, then brings imported ones into scope. An import reaches a file's own
    /// declarations only, not what that file imports.
    pub(super) fn collect(units: &'a [Unit], diagnostics: &mut Vec<Diagnostic>) -> Self {
        let own: HashMap<FileId, HashMap<&str, Entry<'_>>> =
            units.iter().map(|unit| (unit.file, own_names(&unit.tree, diagnostics))).collect();
        let mut files = own.clone();
        for unit in units {
            let Some(scope) = files.get_mut(&unit.file) else { continue };
            for import in &unit.imports {
                let Some(imported) = own.get(&import.file) else { continue };
                let mut entries: Vec<_> = imported.iter().collect();
                entries.sort_by_key(|(_, entry)| entry.span);
                for (name, entry) in entries {
                    match scope.get(name) {
                        Some(present) if present.span != entry.span => {
                            diagnostics.push(clash(name, import.span, present.span, entry.span));
                        }
                        _ => {
                            scope.insert(name, *entry);
                        }
                    }
                }
            }
        }
        let imports = |unit: &Unit| unit.tree.items.iter().filter(|item| matches!(item, ast::Item::Import(_))).count();
        let incomplete = units.iter().filter(|unit| unit.imports.len() < imports(unit)).map(|unit| unit.file).collect();
        let (mut choices, mut claims) = (HashMap::new(), HashMap::new());
        for (file, scope) in &files {
            choices.insert(*file, diagrams(*file, scope));
            claims.insert(*file, properties(scope));
        }
        Self {
            files,
            choices,
            claims,
            used: HashSet::new(),
            incomplete,
            variables: HashMap::new(),
            networks: HashMap::new(),
            interfaces: HashMap::new(),
            robots: HashMap::new(),
            diagrams: HashMap::new(),
            worlds: HashMap::new(),
            properties: HashMap::new(),
            monitored: HashMap::new(),
        }
    }
}

fn own_names<'a>(tree: &'a ast::File, diagnostics: &mut Vec<Diagnostic>) -> HashMap<&'a str, Entry<'a>> {
    let mut scope: HashMap<&str, Entry<'_>> = HashMap::new();
    for item in &tree.items {
        let (name, declared) = match item {
            ast::Item::Variable(item) => (&item.name, Declared::Variable(item)),
            ast::Item::Network(item) => (&item.name, Declared::Network(item)),
            ast::Item::Interface(item) => (&item.name, Declared::Interface(item)),
            ast::Item::Robot(item) => (&item.name, Declared::Robot(item)),
            ast::Item::Diagram(item) => (&item.name, Declared::Diagram(item)),
            ast::Item::World(item) => (&item.name, Declared::World(item)),
            ast::Item::Scenario(item) => (&item.name, Declared::Scenario(item)),
            ast::Item::Arbiter(item) => (&item.name, Declared::Arbiter(item)),
            ast::Item::Team(item) => (&item.name, Declared::Later("team")),
            ast::Item::Property(item) => (&item.name, Declared::Property(item)),
            ast::Item::Import(_) | ast::Item::Error(_) => continue,
        };
        match scope.get(name.text.as_str()) {
            Some(first) => diagnostics.push(duplicate(name, first.span, "the name")),
            None => {
                scope.insert(&name.text, Entry { declared, span: name.span });
            }
        }
    }
    scope
}

fn diagrams<'a>(file: FileId, scope: &HashMap<&str, Entry<'a>>) -> Vec<&'a ast::Diagram> {
    let diagrams = scope.values().filter_map(|entry| match entry.declared {
        Declared::Diagram(diagram) => Some(diagram),
        _ => None,
    });
    let is_own = |diagram: &&ast::Diagram| diagram.name.span.file == file;
    let (own, imported): (Vec<_>, Vec<_>) = diagrams.partition(is_own);
    let mut found = if own.is_empty() { imported } else { own };
    found.sort_by_key(|diagram| diagram.name.span);
    found
}

fn properties<'a>(scope: &HashMap<&str, Entry<'a>>) -> Vec<&'a ast::Property> {
    let properties = scope.values().filter_map(|entry| match entry.declared {
        Declared::Property(property) => Some(property),
        _ => None,
    });
    let mut found: Vec<_> = properties.collect();
    found.sort_by_key(|property| property.name.span);
    found
}

fn clash(name: &str, import: Span, first: Span, second: Span) -> Diagnostic {
    Diagnostic::new(&diag::rules::NAME_CLASH, import, format!("this import brings a second `{name}` into scope"))
        .label(first, format!("`{name}` is declared here"))
        .label(second, "and here")
        .note("a name means one thing in a file")
        .help("rename one of them, or leave out the import")
}

fn with_article(kind: &str) -> String {
    let article = if kind.starts_with(['a', 'e', 'i', 'o']) { "an" } else { "a" };
    format!("{article} {kind}")
}

fn unused_import(import: Import, sources: &Sources) -> Diagnostic {
    let message = format!("nothing of `{}` is used in this file", sources.path(import.file));
    Diagnostic::new(&diag::rules::UNUSED_IMPORT, import.span, message)
        .note("an import brings in what the file itself declares, not what that file imports")
        .help("remove it")
        .fix(Fix { message: "remove the import".to_owned(), edits: vec![Edit::remove(import.span, sources)] })
}

impl<'a> Lower<'a> {
    /// Reports the imports of which no name was looked up; to be called when all has been.
    pub(super) fn unused_imports(&mut self) {
        for unit in self.units {
            for &import in &unit.imports {
                if !self.scopes.used.contains(&(unit.file, import.file)) {
                    self.report(unused_import(import, self.sources));
                }
            }
        }
    }

    /// What a name stands for in the file it is written in; reports one that stands for nothing.
    fn look_up(&mut self, name: &ast::Name, what: &str) -> Option<Declared<'a>> {
        let scope = self.scopes.files.get(&name.span.file)?;
        if let Some(entry) = scope.get(name.text.as_str()) {
            let Entry { declared, span } = *entry;
            self.scopes.used.insert((name.span.file, span.file));
            self.refers(name.span, span);
            return Some(declared);
        }
        if self.lacks_imports(name.span.file) {
            return None;
        }
        let fitting = scope.iter().filter(|(_, entry)| entry.declared.kind() == what).map(|(name, _)| *name);
        let mut diagnostic = self.unknown(name, what, fitting);
        let elsewhere = self.scopes.files.values().filter_map(|scope| scope.get(name.text.as_str()));
        let elsewhere = elsewhere.min_by_key(|entry| entry.span);
        let is_near = diagnostic.help.as_ref().is_some_and(|help| help.starts_with("did"));
        if let (Some(entry), false) = (elsewhere, is_near) {
            diagnostic = diagnostic
                .label(entry.span, "one of this name is declared here, in a file that this one does not import")
                .help_maybe(self.import_for(name.span.file, entry.span.file));
        }
        self.report(diagnostic);
        None
    }

    /// Finds what scenarios monitor; to be called when all properties have been lowered.
    pub(super) fn monitors(&mut self) {
        for (file, claims) in &self.scopes.claims {
            for claim in claims {
                let Some(&id) = self.scopes.properties.get(&claim.name.span) else { continue };
                let of_scenarios = (*file, self.program.properties[id].diagram);
                self.scopes.monitored.entry(of_scenarios).or_default().push(id);
            }
        }
    }

    /// Whether an import of a file led nowhere: it may have been the one that declares what is missing.
    pub(super) fn lacks_imports(&self, file: FileId) -> bool {
        self.scopes.incomplete.contains(&file)
    }

    /// Notes that something of a file is used in another, though its name is not written there.
    pub(super) fn uses(&mut self, file: FileId, of: FileId) {
        self.scopes.used.insert((file, of));
    }

    /// The import that brings a file's declarations into another one, where it is of the library or beside it.
    fn import_for(&self, into: FileId, from: FileId) -> Option<String> {
        let (into, from) = (self.sources.path(into), self.sources.path(from));
        let (stem, _) = from.rsplit_once('.')?;
        let folder = |path: &str| path.rsplit_once('/').map_or("", |(folder, _)| folder).to_owned();
        let name = match stem.starts_with("std/") {
            true => Some(stem.replace('/', ".")),
            false if folder(into) == folder(from) => stem.rsplit('/').next().map(str::to_owned),
            false => None,
        };
        name.map(|name| format!("write `import {name}`"))
    }

    fn wrong_kind(&mut self, name: &ast::Name, declared: Declared<'a>, wanted: &str) {
        // What is not implemented yet was reported where it is declared.
        if !matches!(declared, Declared::Later(_)) {
            let (is, wanted) = (with_article(declared.kind()), with_article(wanted));
            let message = format!("`{}` is {is}, not {wanted}", name.text);
            self.report(Diagnostic::new(&diag::rules::WRONG_KIND, name.span, message));
        }
    }

    pub(super) fn find_variable(&mut self, name: &ast::Name) -> Option<Id<ir::Variable>> {
        match self.look_up(name, "variable")? {
            Declared::Variable(variable) => {
                self.read.insert(variable.name.span);
                self.scopes.variables.get(&variable.name.span).copied()
            }
            other => {
                self.wrong_kind(name, other, "variable");
                None
            }
        }
    }

    pub(super) fn find_network(&mut self, name: &ast::Name) -> Option<Id<ir::Network>> {
        match self.look_up(name, "network")? {
            Declared::Network(network) => self.scopes.networks.get(&network.name.span).copied(),
            other => {
                self.wrong_kind(name, other, "network");
                None
            }
        }
    }

    pub(super) fn find_interface(&mut self, name: &ast::Name) -> Option<Id<ir::Interface>> {
        let interface = self.find_interface_tree(name)?;
        self.scopes.interfaces.get(&interface.name.span).copied()
    }

    /// The tree of an interface, for those that extend it.
    pub(super) fn find_interface_tree(&mut self, name: &ast::Name) -> Option<&'a ast::Interface> {
        match self.look_up(name, "interface")? {
            Declared::Interface(interface) => Some(interface),
            other => {
                self.wrong_kind(name, other, "interface");
                None
            }
        }
    }

    pub(super) fn find_robot(&mut self, name: &ast::Name) -> Option<Id<ir::Robot>> {
        match self.look_up(name, "robot")? {
            Declared::Robot(robot) => self.scopes.robots.get(&robot.name.span).copied(),
            other => {
                self.wrong_kind(name, other, "robot");
                None
            }
        }
    }

    pub(super) fn find_platform(&mut self, name: &ast::Name) -> Option<ir::Platform> {
        match self.look_up(name, "robot")? {
            Declared::Robot(robot) => self.scopes.robots.get(&robot.name.span).copied().map(ir::Platform::Robot),
            Declared::Interface(interface) => {
                self.scopes.interfaces.get(&interface.name.span).copied().map(ir::Platform::Interface)
            }
            other => {
                self.wrong_kind(name, other, "robot or an interface");
                None
            }
        }
    }

    pub(super) fn find_world(&mut self, name: &ast::Name) -> Option<Id<ir::World>> {
        match self.look_up(name, "world")? {
            Declared::World(world) => self.scopes.worlds.get(&world.name.span).copied(),
            other => {
                self.wrong_kind(name, other, "world");
                None
            }
        }
    }

    /// The tree of a diagram, for those that extend it.
    pub(super) fn find_diagram_tree(&mut self, name: &ast::Name) -> Option<&'a ast::Diagram> {
        match self.look_up(name, "behavior")? {
            Declared::Diagram(diagram) => Some(diagram),
            other => {
                self.wrong_kind(name, other, "behavior");
                None
            }
        }
    }

    /// The tree of a diagram without a report.
    pub(super) fn find_diagram_tree_silently(&self, name: &ast::Name) -> Option<&'a ast::Diagram> {
        match self.scopes.files.get(&name.span.file)?.get(name.text.as_str())?.declared {
            Declared::Diagram(diagram) => Some(diagram),
            _ => None,
        }
    }

    pub(super) fn find_diagram(&mut self, name: &ast::Name) -> Option<Id<ir::Diagram>> {
        let diagram = self.find_diagram_tree(name)?;
        self.scopes.diagrams.get(&diagram.name.span).copied()
    }

    /// What a scenario can run: a diagram, or an arbiter.
    pub(super) fn find_runnable(&mut self, name: &ast::Name) -> Option<Id<ir::Diagram>> {
        match self.look_up(name, "behavior")? {
            Declared::Diagram(diagram) => self.scopes.diagrams.get(&diagram.name.span).copied(),
            Declared::Arbiter(arbiter) => self.scopes.diagrams.get(&arbiter.name.span).copied(),
            other => {
                self.wrong_kind(name, other, "behavior or an arbiter");
                None
            }
        }
    }

    /// The tree of a scenario, for those that extend it.
    pub(super) fn find_scenario_tree(&mut self, name: &ast::Name) -> Option<&'a ast::Scenario> {
        match self.look_up(name, "scenario")? {
            Declared::Scenario(scenario) => Some(scenario),
            other => {
                self.wrong_kind(name, other, "scenario");
                None
            }
        }
    }
}
