//! Modes: their commands, and their ways out.

use std::collections::HashMap;

use super::conditions::Scene;
use super::quantities::{empty_range, mismatch};
use super::{Lower, given, invalid, named, symbol};
use crate::base::{Exact, Id, Span, Unit};
use crate::diag::{self, Diagnostic};
use crate::ir;
use crate::syntax::ast;

/// The modes of a diagram by name, with the place of each name.
pub(super) type Modes<'t> = HashMap<&'t str, (Id<ir::Mode>, Span)>;

/// The diagram that a mode is of.
pub(super) struct Owner {
    pub(super) layer: ir::Layer,
    pub(super) actions: Vec<Id<ir::Action>>,
}

impl Lower<'_> {
    pub(super) fn mode(
        &mut self,
        tree: &ast::Mode,
        runs: Option<ir::Run>,
        modes: &Modes<'_>,
        owner: &Owner,
        scene: &mut Scene,
    ) -> ir::Mode {
        let actions = &owner.actions;
        let mut mode = ir::Mode {
            symbol: symbol(&tree.name, tree.doc.as_ref()),
            is_final: tree.is_final.is_some(),
            runs,
            requires: Vec::new(),
            otherwise: tree.otherwise.as_ref().and_then(|name| self.mode_named(name, modes)),
            actions: Vec::new(),
            decision: None,
            on_enter: Vec::new(),
            on_exit: Vec::new(),
            transitions: Vec::new(),
            inherited: false,
            incomplete: tree.items.iter().any(|item| matches!(item, ast::ModeItem::Error(_))),
        };
        mode.incomplete |= mode.otherwise.is_none() && tree.otherwise.is_some();
        mode.incomplete |= runs.is_none() && owner.layer != ir::Layer::Behavior;
        if let (Some(otherwise), Some(name)) = (mode.otherwise, &tree.otherwise)
            && modes.get(tree.name.text.as_str()).is_some_and(|own| own.0 == otherwise)
        {
            let diagnostic = invalid(name.span, format!("`{}` would move to itself", tree.name.text));
            self.report(diagnostic.help("name a mode that can do without the sensor"));
        }
        for name in &tree.requires {
            let sensors = self.measuring_named(name, &scene.sensors).unwrap_or_default();
            mode.requires.extend(sensors.into_iter().map(|sensor| (sensor, name.span)));
        }
        let mut decision = None;
        for item in &tree.items {
            match item {
                ast::ModeItem::Action(call) => mode.actions.extend(self.call(call, actions, scene)),
                ast::ModeItem::OnEnter(calls, _) => {
                    mode.on_enter
                        .extend(calls.iter().filter_map(|call| self.call(call, actions, scene)).collect::<Vec<_>>());
                }
                ast::ModeItem::OnExit(calls, _) => {
                    mode.on_exit
                        .extend(calls.iter().filter_map(|call| self.call(call, actions, scene)).collect::<Vec<_>>());
                }
                ast::ModeItem::Decide(decide) => {
                    let lowered = self.decision(decide, actions, scene);
                    mode.incomplete |= lowered.is_none();
                    self.once(&mut decision, lowered, decide.span, "the decision table");
                }
                ast::ModeItem::Transition(_) | ast::ModeItem::Error(_) => {}
            }
        }
        let calls = tree.items.iter().filter(|item| matches!(item, ast::ModeItem::Action(_))).count();
        mode.decision = decision.and_then(|(decision, _)| decision);
        let decided = mode.decision.iter().flat_map(|decision| &decision.rows).flat_map(|row| &row.commands);
        let reports = mode.actions.iter().chain(decided).any(|call| self.program.actions[call.action].reports_done);
        let ends = |run: ir::Run| self.program.diagrams[run.diagram].modes.values().any(|mode| mode.is_final);
        // A broken call was reported; it may be the one that would have reported completion.
        let is_open = mode.actions.len() < calls || mode.incomplete;
        scene.reports_done = Some(if let Some(run) = runs { ends(run) } else { reports || is_open });
        let own = modes.get(tree.name.text.as_str()).map(|own| own.0);
        for item in &tree.items {
            if let ast::ModeItem::Transition(transition) = item {
                match self.transition(transition, own, modes, scene) {
                    Some(transition) => mode.transitions.push(transition),
                    None => mode.incomplete = true,
                }
            }
        }
        scene.reports_done = None;
        mode.transitions.sort_by_key(|transition| transition.priority);
        mode
    }

    fn transition(
        &mut self,
        tree: &ast::Transition,
        own: Option<Id<ir::Mode>>,
        modes: &Modes<'_>,
        scene: &Scene,
    ) -> Option<ir::Transition> {
        let priority = self.whole(&tree.priority, 1, "a priority");
        let condition = self.condition(&tree.condition, scene);
        let (target, again) = match &tree.target {
            ast::Target::Mode(name) => (self.mode_named(name, modes), false),
            ast::Target::Again(_) => (own, true),
        };
        let priority = priority?.try_into().unwrap_or(u32::MAX);
        let priority_span = tree.priority.span;
        Some(ir::Transition { priority, priority_span, condition, target, again, span: tree.span })
    }

    /// The mode of that name; reports one that does not exist.
    pub(super) fn mode_named(&mut self, name: &ast::Name, modes: &Modes<'_>) -> Option<Id<ir::Mode>> {
        let Some(&(found, place)) = modes.get(name.text.as_str()) else {
            self.report(self.unknown(name, "mode", modes.keys().copied()));
            return None;
        };
        self.refers(name.span, place);
        Some(found)
    }

    pub(super) fn call(&mut self, tree: &ast::Call, actions: &[Id<ir::Action>], scene: &Scene) -> Option<ir::Call> {
        let [name] = tree.path.segments.as_slice() else {
            let message = "an action has a simple name";
            self.report(Diagnostic::new(&diag::rules::UNKNOWN_NAME, tree.path.span, message));
            return None;
        };
        let Some(action) = named(&name.text, actions, |id| &self.program.actions[id].symbol) else {
            let known = actions.iter().map(|&id| self.program.actions[id].symbol.name.as_str());
            let diagnostic = self.unknown(name, "action", known);
            self.report(diagnostic);
            return None;
        };
        self.refers(name.span, self.program.actions[action].symbol.span);
        if self.poison.actions.contains(&action) {
            return None;
        }
        let parameters = self.program.actions[action].parameters.clone();
        let names = parameters.iter().map(|parameter| &parameter.symbol);
        let order = self.order_arguments(&tree.arguments, names, tree.span, "action")?;
        let arguments: Vec<_> = order
            .into_iter()
            .zip(&parameters)
            .map(|(argument, parameter)| self.argument(&argument.value, &parameter.unit, scene))
            .collect();
        let arguments = arguments.into_iter().collect::<Option<_>>()?;
        Some(ir::Call { action, arguments, span: tree.span })
    }

    fn argument(&mut self, tree: &ast::Expr, unit: &Unit, scene: &Scene) -> Option<ir::Argument> {
        match &tree.kind {
            ast::ExprKind::Quantity(quantity) => {
                self.quantity_of(quantity, unit.dimension, Some(unit)).map(ir::Argument::Constant)
            }
            ast::ExprKind::Call(call) if call.path.segments.iter().map(|name| name.text.as_str()).eq(["random"]) => {
                self.random(call, unit)
            }
            ast::ExprKind::Path(path) => match self.argument_told(path, &scene.sensors) {
                Some(sensor) => self.reading_argument(sensor, path, unit),
                None => self.output_argument(path, unit, scene),
            },
            _ => {
                let diagnostic = invalid(tree.span, "an action takes quantities");
                self.report(diagnostic.help("write a number with its unit, or `random(low, high)`"));
                None
            }
        }
    }

    /// What a sensor reads, `goal_bearing` or `command.distance`.
    fn reading_argument(&mut self, sensor: Id<ir::Sensor>, path: &ast::Path, unit: &Unit) -> Option<ir::Argument> {
        self.reads(path.segments.first()?, sensor);
        let found = self.program.sensors[sensor].unit.dimension;
        if found != unit.dimension {
            self.report(mismatch(path.span, found, unit.dimension));
            return None;
        }
        Some(ir::Argument::Reading(sensor))
    }

    /// An output of a sensed network, `speed` or `navigator.speed`.
    fn output_argument(&mut self, path: &ast::Path, unit: &Unit, scene: &Scene) -> Option<ir::Argument> {
        let (name, of) = match path.segments.as_slice() {
            [name] => (name, None),
            [network, name] => (name, Some(network)),
            _ => {
                self.report(invalid(path.span, "an output of a network has a name of one or two parts"));
                return None;
            }
        };
        let is_of = |sense: &u32| of.is_none_or(|of| scene.senses.get(&of.text) == Some(sense));
        let found = scene.outputs.get(&name.text).into_iter().flatten().filter(|(sense, _)| is_of(sense));
        let (sense, output) = match found.copied().collect::<Vec<_>>().as_slice() {
            [found] => *found,
            [] => {
                if !scene.incomplete {
                    let known = scene.outputs.iter().filter(|(_, of)| of.iter().any(|(sense, _)| is_of(sense)));
                    let what =
                        of.map_or("output of a sensed network".to_owned(), |of| format!("output of `{}`", of.text));
                    self.report(self.unknown(name, &what, known.map(|(name, _)| name.as_str())));
                }
                return None;
            }
            _ => {
                let message = format!("several sensed networks have an output `{}`", name.text);
                let diagnostic = Diagnostic::new(&diag::rules::AMBIGUOUS_NAME, name.span, message);
                self.report(diagnostic.help(format!("write the network in front, as in `network.{}`", name.text)));
                return None;
            }
        };
        let place = *scene.sense_places.get(sense as usize)?;
        self.read.insert(place);
        if let Some(of) = of {
            self.refers(of.span, place);
        }
        let declared = &self.program.networks[*scene.sense_networks.get(sense as usize)?].outputs[output as usize];
        let (declared, found) = (declared.symbol.span, declared.unit.dimension);
        self.refers(name.span, declared);
        if found != unit.dimension {
            self.report(mismatch(path.span, found, unit.dimension));
            return None;
        }
        Some(ir::Argument::Output { sense, output })
    }

    fn random(&mut self, call: &ast::Call, unit: &Unit) -> Option<ir::Argument> {
        let ends: Vec<Option<Exact>> = call
            .arguments
            .iter()
            .map(|argument| match &argument.value.kind {
                ast::ExprKind::Quantity(quantity) => self.quantity_of(quantity, unit.dimension, Some(unit)),
                _ => {
                    self.report(invalid(argument.value.span, "`random` takes two quantities"));
                    None
                }
            })
            .collect();
        let [low, high] = ends.as_slice() else {
            let message = format!("`random` takes 2 arguments, {}", given(ends.len()));
            self.report(Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, call.span, message));
            return None;
        };
        let (low, high) = ((*low)?, (*high)?);
        if low >= high {
            self.report(empty_range(call.span));
            return None;
        }
        Some(ir::Argument::Random { low, high })
    }
}
