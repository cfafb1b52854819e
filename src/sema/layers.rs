//! Layers: diagrams that run inside the modes of others (LMSL fig. 3).

use super::conditions::Scene;
use super::{Lower, missing_part};
use crate::base::{Id, Span};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Layer, Op, Platform};
use crate::syntax::ast;

/// The layer that is written so.
pub(super) const fn layer(layer: ast::Layer) -> Layer {
    match layer {
        ast::Layer::Behavior => Layer::Behavior,
        ast::Layer::Activity => Layer::Activity,
        ast::Layer::Goal => Layer::Goal,
    }
}

/// What a layer's modes run.
const fn inner(layer: Layer) -> &'static str {
    match layer {
        Layer::Behavior => "actions",
        Layer::Activity => "behaviors",
        Layer::Goal => "activities or behaviors",
    }
}

impl Lower<'_> {
    /// What runs inside a mode of a diagram of some layer; reports what cannot.
    pub(super) fn run(&mut self, tree: &ast::Mode, outer: Layer, platform: Platform) -> Option<ir::Run> {
        let note = format!("the modes of {} {} run {}", article(outer), outer.keyword(), inner(outer));
        let Some(child) = &tree.child else {
            if outer != Layer::Behavior && !tree.items.iter().any(|item| matches!(item, ast::ModeItem::Error(_))) {
                let message = format!("nothing runs in the mode `{}`", tree.name.text);
                let help = format!("write `mode {} = name_of_a_behavior`", tree.name.text);
                self.report(missing_part(tree.name.span, message).note(note).help(help));
            }
            return None;
        };
        if outer == Layer::Behavior {
            let message = "a mode of a behavior cannot run a diagram";
            let diagnostic = Diagnostic::new(&diag::rules::WRONG_KIND, child.diagram.span, message);
            self.report(diagnostic.note("a behavior's modes call actions; an activity's modes run behaviors"));
            return None;
        }
        self.commands_beside(tree, &note);
        let inner = self.find_diagram_tree(&child.diagram)?;
        let found = layer(inner.layer);
        if found >= outer {
            let (name, declared) = (&child.diagram.text, inner.name.span);
            let message = format!("{} {} cannot run the {} `{name}`", article(outer), outer.keyword(), found.keyword());
            let diagnostic = Diagnostic::new(&diag::rules::LAYER_INVERTED, child.diagram.span, message);
            self.report(diagnostic.label(declared, format!("declared as {} here", found.keyword())).note(note));
            return None;
        }
        let diagram = self.find_diagram(&child.diagram)?;
        if !self.runs_on(diagram, platform) {
            self.not_written_for(&child.diagram, platform);
            return None;
        }
        Some(ir::Run { diagram, resumes: child.resume.is_some(), span: child.diagram.span })
    }

    /// Reports commands of every tick in a mode that runs a diagram.
    fn commands_beside(&mut self, tree: &ast::Mode, note: &str) {
        for item in &tree.items {
            let span = match item {
                ast::ModeItem::Action(call) => call.span,
                ast::ModeItem::Decide(table) => table.span,
                _ => continue,
            };
            let message = format!("`{}` runs a diagram, which gives the commands", tree.name.text);
            let diagnostic = Diagnostic::new(&diag::rules::WRONG_KIND, span, message).note(note);
            self.report(diagnostic.help("give it once in `on enter { ... }`, or in a behavior that the mode runs"));
        }
    }

    /// Whether a diagram runs on a robot, or on whatever keeps an interface and with it those that this one extends.
    pub(super) fn runs_on(&self, diagram: Id<ir::Diagram>, on: Platform) -> bool {
        match (self.program.diagrams[diagram].platform, on) {
            (Platform::Interface(interface), Platform::Robot(robot)) => {
                self.program.robots[robot].provides.contains(&interface)
            }
            (Platform::Interface(interface), Platform::Interface(on)) => {
                self.with_extended(std::iter::once(on)).contains(&interface)
            }
            (own, on) => own == on,
        }
    }

    pub(super) fn not_written_for(&mut self, name: &ast::Name, on: Platform) {
        let platform = match on {
            Platform::Robot(robot) => &self.program.robots[robot].symbol.name,
            Platform::Interface(interface) => &self.program.interfaces[interface].symbol.name,
        };
        let message = format!("`{}` is not written for `{platform}`", name.text);
        self.report(Diagnostic::new(&diag::rules::WRONG_KIND, name.span, message));
    }

    /// `explore.mode is stop`: where what runs inside a mode is. `path` leads from a mode of the diagram inward.
    pub(super) fn inside(&mut self, path: &[ast::Name], names: &[ast::Name], span: Span, scene: &Scene) -> Option<Op> {
        let (first, deeper) = path.split_first()?;
        let Some(&(mode, inner)) = scene.runs.get(&first.text) else {
            let known = scene.runs.keys().map(String::as_str);
            let diagnostic = self.unknown(first, "mode that runs a diagram", known);
            self.report(diagnostic);
            return None;
        };
        // What is broken was reported.
        let (mut diagram, mut way) = (inner?, vec![mode]);
        for name in deeper {
            let mode = self.mode_of(name, diagram)?;
            let Some(run) = self.program.diagrams[diagram].modes[mode].runs else {
                let message = format!("no diagram runs in the mode `{}`", name.text);
                self.report(Diagnostic::new(&diag::rules::WRONG_KIND, name.span, message));
                return None;
            };
            way.push(mode);
            diagram = run.diagram;
        }
        let ends: Vec<_> = names.iter().map(|name| self.mode_of(name, diagram)).collect();
        let mut any = Vec::with_capacity(ends.len());
        for end in ends {
            let path = way.iter().copied().chain([end?]).collect();
            any.push(self.truth(Op::Inside(path), span));
        }
        Some(Op::Or(any))
    }

    /// The mode of that name in a diagram; reports one that does not exist.
    fn mode_of(&mut self, name: &ast::Name, diagram: Id<ir::Diagram>) -> Option<Id<ir::Mode>> {
        let of = &self.program.diagrams[diagram];
        let Some((id, mode)) = of.modes.iter().find(|(_, mode)| mode.symbol.name == name.text) else {
            let known = of.modes.values().map(|mode| mode.symbol.name.as_str());
            let diagnostic = self.unknown(name, &format!("mode of `{}`", of.symbol.name), known);
            self.report(diagnostic);
            return None;
        };
        let declared = mode.symbol.span;
        self.refers(name.span, declared);
        Some(id)
    }
}

const fn article(layer: Layer) -> &'static str {
    match layer {
        Layer::Activity => "an",
        Layer::Behavior | Layer::Goal => "a",
    }
}
