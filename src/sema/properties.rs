//! Properties: of which behavior they speak, and what they claim.

use super::diagrams::collect_names;
use super::{Lower, missing_part, symbol};
use crate::base::{FileId, Id};
use crate::diag::{self, Diagnostic};
use crate::ir;
use crate::syntax::ast;

/// Among more behaviors none is chosen by what a property names.
const FEW: usize = 5;

impl Lower<'_> {
    pub(super) fn property(&mut self, tree: &ast::Property) {
        let Some(diagram) = self.property_diagram(tree) else { return };
        self.take_in_later(diagram, &names(tree));
        let sensors = self.program.sensors_of(self.program.diagrams[diagram].platform);
        let scene = self.watched_scene(diagram, sensors);
        let claim = match &tree.kind {
            ast::PropertyKind::Never(condition) => ir::Claim::Never(self.condition(condition, &scene)),
            ast::PropertyKind::Always(condition) => ir::Claim::Always(self.condition(condition, &scene)),
            ast::PropertyKind::LeadsTo { cause, effect, within } => {
                let (cause, effect) = (self.condition(cause, &scene), self.condition(effect, &scene));
                let Some(within) = within else { return self.report(without_limit(tree)) };
                let Some(within) = self.positive_nanoseconds(within, "the time after `within`") else { return };
                ir::Claim::LeadsTo(ir::Response { cause, effect, within })
            }
        };
        let text = self.on_one_line(tree.span);
        let text = text.split_once(':').map_or("", |(_, claim)| claim).trim_start().to_owned();
        let symbol = symbol(&tree.name, tree.doc.as_ref());
        let id = self.program.properties.add(ir::Property { symbol, diagram, claim, text, span: tree.span });
        self.scopes.properties.insert(tree.name.span, id);
    }

    /// The behavior that a property names; else the only one there is, or the only one that has what it names.
    fn property_diagram(&mut self, tree: &ast::Property) -> Option<Id<ir::Diagram>> {
        if let Some(of) = &tree.of {
            return self.find_diagram(of);
        }
        let file = tree.name.span.file;
        let known = self.scopes.choices.get(&file).cloned().unwrap_or_default();
        let has_all = |diagram: &&ast::Diagram| {
            self.scopes.diagrams.get(&diagram.name.span).is_some_and(|id| self.has_all_names(*id, tree))
        };
        let chosen = match known.as_slice() {
            [] => {
                if !self.lacks_imports(file) {
                    self.report(without_behavior(tree));
                }
                return None;
            }
            [one] => *one,
            several => match several.iter().copied().take(FEW).filter(has_all).collect::<Vec<_>>().as_slice() {
                [one] if several.len() <= FEW => *one,
                fitting => {
                    self.report(ambiguous(tree, if fitting.is_empty() { several } else { fitting }));
                    return None;
                }
            },
        };
        self.uses(file, chosen.name.span.file);
        self.scopes.diagrams.get(&chosen.name.span).copied()
    }

    /// Whether every simple name in the conditions of a property means something in a diagram.
    fn has_all_names(&self, id: Id<ir::Diagram>, tree: &ast::Property) -> bool {
        let sensors = self.program.sensors_of(self.program.diagrams[id].platform);
        let scene = self.watched_scene(id, sensors.clone());
        let sensor = |name: &str| sensors.iter().any(|id| self.program.sensors[*id].symbol.name == name);
        names(tree).into_iter().all(|name| scene.names().any(|known| known == name) || sensor(name))
    }

    /// The properties of a diagram that a file declares or imports, as its scenarios watch them.
    pub(super) fn monitored(&mut self, file: FileId, diagram: Id<ir::Diagram>) -> Vec<ir::Expectation> {
        let monitored = self.scopes.monitored.get(&(file, diagram)).cloned().unwrap_or_default();
        let expectation = |id| {
            let property: &ir::Property = &self.program.properties[id];
            let text = format!("property {}: {}", property.symbol.name, property.text);
            ir::Expectation { text, kind: ir::ExpectationKind::Claim(property.claim), span: property.span }
        };
        let expectations: Vec<_> = monitored.into_iter().map(expectation).collect();
        for expectation in &expectations {
            self.uses(file, expectation.span.file);
        }
        expectations
    }
}

/// The simple names in the conditions of a property.
fn names(tree: &ast::Property) -> Vec<&str> {
    let mut names = Vec::new();
    match &tree.kind {
        ast::PropertyKind::Never(condition) | ast::PropertyKind::Always(condition) => {
            collect_names(condition, &mut names);
        }
        ast::PropertyKind::LeadsTo { cause, effect, .. } => {
            collect_names(cause, &mut names);
            collect_names(effect, &mut names);
        }
    }
    names
}

fn without_behavior(tree: &ast::Property) -> Diagnostic {
    missing_part(tree.name.span, format!("there is no behavior that `{}` could speak of", tree.name.text))
        .note("a property speaks of the behavior its file declares, or of one it imports")
        .help("import the file that declares the behavior")
}

fn without_limit(tree: &ast::Property) -> Diagnostic {
    missing_part(tree.name.span, format!("`{}` does not say in what time", tree.name.text))
        .note("what comes about some day, without a limit, is refuted by no run")
        .help("write `within 10 s` at its end")
}

fn ambiguous(tree: &ast::Property, choice: &[&ast::Diagram]) -> Diagnostic {
    let names: Vec<_> = choice.iter().take(FEW).map(|diagram| format!("`{}`", diagram.name.text)).collect();
    let more = if choice.len() > FEW { ", ..." } else { "" };
    let message = format!("`{}` could speak of {}{more}", tree.name.text, names.join(", "));
    let first = choice.first().map_or("", |diagram| diagram.name.text.as_str());
    Diagnostic::new(&diag::rules::AMBIGUOUS_NAME, tree.name.span, message)
        .help(format!("write `property {} of {first}: ...`", tree.name.text))
}
