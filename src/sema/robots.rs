//! Robots: sensors, actions, bodies, and what interfaces were promised.

use std::collections::HashMap;

use super::contacts::sense_in_interface;
use super::groups::is_group;
use super::quantities::mismatch;
use super::sensors::{declared_name, told};
use super::{Lower, claim, counted, given, invalid, missing_part, named, symbol};
use crate::base::{Dimension, Id, Span};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, BodyCommandKind};
use crate::syntax::ast;

/// The commands of bodies with the dimensions of their arguments.
const COMMANDS: &[(&str, BodyCommandKind, &[Dimension])] = &[
    ("body.stop", BodyCommandKind::Stop, &[]),
    ("body.velocity", BodyCommandKind::Velocity, &[Dimension::SPEED, Dimension::TURN_RATE]),
    ("body.arc", BodyCommandKind::Arc, &[Dimension::SPEED, Dimension::LENGTH]),
    ("body.rotate", BodyCommandKind::Rotate, &[Dimension::ANGLE]),
    ("body.travel", BodyCommandKind::Travel, &[Dimension::LENGTH, Dimension::SPEED]),
    ("body.steer", BodyCommandKind::Steer, &[Dimension::SPEED, Dimension::ANGLE]),
    ("planner.plan", BodyCommandKind::Plan, &[]),
    ("planner.next", BodyCommandKind::NextWaypoint, &[]),
];

impl<'a> Lower<'a> {
    pub(super) fn robot(&mut self, tree: &'a ast::Robot) {
        let is_body = |item: &ast::RobotItem| match item {
            ast::RobotItem::Body(_) => true,
            ast::RobotItem::Error(span) => self.unparsed.first_word(*span) == "body",
            _ => false,
        };
        let carrier = match (tree.items.iter().any(is_body), &tree.runs) {
            (false, _) => Carrier::Nothing,
            (true, None) => Carrier::Body,
            (true, Some(_)) => Carrier::Drive,
        };
        let mut members = self.members(&tree.items, carrier);
        self.check_body(&tree.items);
        let drive = tree.runs.as_ref().map(|runs| self.drive(runs, &mut members));
        // A body that is missing where an action needs it, or that is broken, is reported once.
        let needs_body = tree.items.iter().find_map(|item| match item {
            ast::RobotItem::Action(action) => action.implementation.as_ref(),
            _ => None,
        });
        if let (Carrier::Nothing, Some(call)) = (carrier, needs_body) {
            self.report(missing_body(&tree.name, call.span));
        }
        let is_broken = members.body.as_ref().map_or(needs_body.is_some(), |(body, _)| body.is_none());
        let provides: Vec<_> = tree
            .provides
            .iter()
            .filter_map(|name| self.find_interface(name).map(|interface| (interface, name.span)))
            .collect();
        for &(interface, span) in &provides {
            self.check_promise(&tree.name, interface, span, &members);
        }
        let robot = ir::Robot {
            symbol: symbol(&tree.name, tree.doc.as_ref()),
            provides: self.with_extended(provides.into_iter().map(|(interface, _)| interface)),
            body: members.body.and_then(|(body, _)| body),
            sensors: members.sensors,
            logical: members.logical,
            senses: members.senses,
            actions: members.actions,
            drive,
        };
        let id = self.program.robots.add(robot);
        self.scopes.robots.insert(tree.name.span, id);
        if is_broken {
            self.poison.robots.insert(id);
        }
    }

    /// The behavior that carries out a robot's commands, and the sensors by which everything on the robot sees it.
    fn drive(&mut self, runs: &ast::Name, members: &mut Members) -> ir::Drive {
        let tree = self.find_diagram_tree(runs);
        let modes = tree.iter().flat_map(|tree| &tree.items).filter_map(|item| match item {
            ast::DiagramItem::Mode(mode) => Some(mode.name.text.clone()),
            _ => None,
        });
        let states: Vec<_> = modes.collect();
        let commands = members.actions.iter().map(|&id| &self.program.actions[id]).filter(|action| action.is_driven());
        let mut parameters: Vec<ir::Parameter> = Vec::new();
        for parameter in commands.flat_map(|action| &action.parameters) {
            if parameters.iter().all(|known| known.symbol.name != parameter.symbol.name) {
                parameters.push(parameter.clone());
            }
        }
        let told = told(runs.span, states.len(), members.actions.len(), &parameters);
        for inner in &told {
            let own = members.sensors.iter().chain(&members.logical).map(|&id| &self.program.sensors[id].symbol);
            let name = &inner.symbol.name;
            if let Some(clash) = own.clone().find(|own| declared_name(&own.name) == *name) {
                let message = format!("`{name}` is what a robot that runs a behavior tells of itself");
                self.report(invalid(clash.span, message).label(runs.span, "runs it").help("rename the sensor"));
            }
        }
        members.sensors.extend(told.into_iter().map(|sensor| self.program.sensors.add(sensor)));
        let parameters = parameters.into_iter().map(|parameter| parameter.symbol.name).collect();
        ir::Drive { diagram: None, states, parameters }
    }

    /// Finds the behaviors of robots; to be called when all diagrams have been lowered.
    pub(super) fn drives(&mut self) {
        for item in self.units.iter().flat_map(|unit| &unit.tree.items) {
            if let ast::Item::Robot(ast::Robot { name, runs: Some(runs), .. }) = item
                && let Some(&robot) = self.scopes.robots.get(&name.span)
                && let Some(tree) = self.find_diagram_tree_silently(runs)
            {
                let diagram = self.scopes.diagrams.get(&tree.name.span).copied();
                if let Some(misfit) = diagram.and_then(|diagram| self.misfit(diagram, robot, runs)) {
                    self.report(misfit);
                } else if let Some(drive) = &mut self.program.robots[robot].drive {
                    drive.diagram = diagram;
                }
            }
        }
    }

    /// Why a diagram cannot carry out the commands of a robot.
    fn misfit(&self, diagram: Id<ir::Diagram>, robot: Id<ir::Robot>, runs: &ast::Name) -> Option<Diagnostic> {
        let diagram = &self.program.diagrams[diagram];
        if diagram.platform != ir::Platform::Robot(robot) {
            let robot = &self.program.robots[robot].symbol.name;
            let message = format!("`{}` is not written for `{robot}`", runs.text);
            return Some(Diagnostic::new(&diag::rules::WRONG_KIND, runs.span, message));
        }
        let is_driven = |call: &&ir::Call| {
            let action = &self.program.actions[call.action];
            action.same_as.as_ref().map_or(action, |(other, _)| &self.program.actions[*other]).is_driven()
        };
        let call = diagram.modes.values().flat_map(ir::Mode::commands).find(is_driven)?;
        let name = &self.program.actions[call.action].symbol.name;
        let diagnostic = invalid(call.span, format!("`{name}` is for `{}` itself to carry out", runs.text));
        Some(diagnostic.help("call an action that is a command of the body, as in `action brake() = body.stop()`"))
    }

    /// Lets actions of a robot be others of its own.
    fn aliases(&mut self, items: &[ast::RobotItem], actions: &[Id<ir::Action>]) {
        for item in items {
            let ast::RobotItem::Action(ast::Action { name, implementation: Some(call), .. }) = item else { continue };
            let [other] = call.path.segments.as_slice() else { continue };
            let own =
                |name: &ast::Name, lower: &Self| named(&name.text, actions, |id| &lower.program.actions[id].symbol);
            let Some(action) = own(name, self) else { continue };
            let Some(target) = own(other, self).filter(|target| *target != action) else {
                let known = actions.iter().map(|&id| self.program.actions[id].symbol.name.as_str());
                self.report(self.unknown(other, "other action of this robot", known));
                continue;
            };
            self.refers(other.span, self.program.actions[target].symbol.span);
            let (wanted, parameters) =
                (self.program.actions[target].parameters.clone(), self.program.actions[action].parameters.clone());
            if self.program.actions[target].same_as.is_some() {
                let diagnostic = invalid(other.span, format!("`{}` is itself another action", other.text));
                self.report(diagnostic.help("name the action that it is"));
                continue;
            }
            let names = wanted.iter().map(|parameter| &parameter.symbol);
            let Some(order) = self.order_arguments(&call.arguments, names, call.span, "action") else { continue };
            let arguments: Vec<_> = order
                .into_iter()
                .zip(&wanted)
                .map(|(argument, wanted)| self.body_argument(argument, wanted.unit.dimension, &parameters))
                .collect();
            let arguments = arguments.into_iter().collect::<Option<Vec<_>>>();
            self.program.actions[action].same_as = arguments.map(|arguments| (target, arguments));
        }
    }

    pub(super) fn members(&mut self, items: &[ast::RobotItem], carrier: Carrier) -> Members {
        let mut members = Members::default();
        let mut seen = HashMap::new();
        for item in items {
            match item {
                ast::RobotItem::Body(body) => {
                    let lowered = self.body(body);
                    self.once(&mut members.body, lowered, body.span, "the body");
                }
                ast::RobotItem::Sensor(sensor) => {
                    if claim(&mut seen, &sensor.name, "sensor", &mut self.diagnostics) {
                        members.sensors.extend(self.sensors(sensor));
                    }
                }
                ast::RobotItem::Action(action) => {
                    if claim(&mut seen, &action.name, "action", &mut self.diagnostics) {
                        let lowered = self.action(action, carrier);
                        members.actions.push(self.add_action(&action.name, lowered));
                    }
                }
                ast::RobotItem::Sense(_) | ast::RobotItem::Logical(_) | ast::RobotItem::Error(_) => {}
            }
        }
        if matches!(carrier, Carrier::Body | Carrier::Drive) {
            self.aliases(items, &members.actions);
        }
        let groups = items.iter().filter_map(|item| match item {
            ast::RobotItem::Logical(logical) => Some(logical),
            _ => None,
        });
        let names = groups.clone().map(|group| group.name.text.as_str());
        let names: Vec<_> = names.filter(|name| !seen.contains_key(*name)).collect();
        let mut conditions = Vec::new();
        for group in groups {
            if !claim(&mut seen, &group.name, "sensor", &mut self.diagnostics) {
                continue;
            }
            match carrier {
                Carrier::Interface => members.sensors.push(self.logical_in_interface(group)),
                Carrier::Body | Carrier::Drive | Carrier::Nothing if is_group(group) => {
                    members.logical.push(self.logical(group, &members.sensors, &names));
                }
                Carrier::Body | Carrier::Drive | Carrier::Nothing => conditions.push(group),
            }
        }
        let senses = items.iter().filter_map(|item| match item {
            ast::RobotItem::Sense(sense) => Some(sense),
            _ => None,
        });
        match carrier {
            Carrier::Interface => senses.for_each(|sense| self.report(sense_in_interface(sense))),
            Carrier::Body | Carrier::Drive | Carrier::Nothing => {
                let sensors = [members.sensors.as_slice(), &members.logical].concat();
                let (senses, contacts) = self.contacts(&senses.collect::<Vec<_>>(), &conditions, sensors);
                members.senses = senses;
                members.logical.extend(contacts);
            }
        }
        members
    }

    /// Adds an action; a broken one as poison.
    fn add_action(&mut self, name: &ast::Name, action: Option<ir::Action>) -> Id<ir::Action> {
        let broken = action.is_none();
        let id = self.program.actions.add(action.unwrap_or_else(|| ir::Action {
            symbol: symbol(name, None),
            parameters: Vec::new(),
            reports_done: true,
            command: None,
            same_as: None,
        }));
        if broken {
            self.poison.actions.insert(id);
        }
        id
    }

    fn action(&mut self, tree: &ast::Action, carrier: Carrier) -> Option<ir::Action> {
        let mut seen = HashMap::new();
        let mut parameters = Vec::new();
        for parameter in &tree.parameters {
            claim(&mut seen, &parameter.name, "parameter", &mut self.diagnostics);
            parameters.push(ir::Parameter { symbol: symbol(&parameter.name, None), unit: self.unit(&parameter.unit)? });
        }
        let command = match &tree.implementation {
            // Another action of the robot, found when all of them are known.
            Some(call) if call.path.segments.len() == 1 && carrier != Carrier::Interface => None,
            Some(call) => match carrier {
                Carrier::Body | Carrier::Drive => self.command(call, &parameters, tree.done),
                Carrier::Nothing => None,
                Carrier::Interface => {
                    let diagnostic = missing_part(call.span, "there is no body that could carry this out");
                    self.report(diagnostic.help("an interface only promises actions; leave out `= ...`"));
                    None
                }
            },
            None => {
                if carrier == Carrier::Body {
                    self.report(
                        missing_part(tree.name.span, format!("nothing says how the body does `{}`", tree.name.text))
                            .help("write `= body.velocity(...)`, `= body.arc(...)`, `= body.rotate(...)` or `= body.stop()` behind it"),
                    );
                }
                None
            }
        };
        let symbol = symbol(&tree.name, tree.doc.as_ref());
        let same_as = tree.implementation.as_ref().filter(|call| call.path.segments.len() == 1);
        let same_as = same_as.filter(|_| carrier != Carrier::Interface).map(|_| (Id::new(0), Vec::new()));
        Some(ir::Action { symbol, parameters, reports_done: tree.done.is_some(), command, same_as })
    }

    fn command(
        &mut self,
        call: &ast::Call,
        parameters: &[ir::Parameter],
        done: Option<Span>,
    ) -> Option<ir::BodyCommand> {
        let name = join(&call.path);
        let Some(&(_, kind, wanted)) = COMMANDS.iter().find(|(known, ..)| *known == name) else {
            self.report(unknown_path(
                &call.path,
                &name,
                "a body has no command",
                COMMANDS.iter().map(|(name, ..)| *name),
            ));
            return None;
        };
        if let (Some(done), false) = (done, matches!(kind, BodyCommandKind::Rotate | BodyCommandKind::Travel)) {
            let message = format!("`{name}` never reports completion");
            let help = "leave out `-> done`; only `body.rotate` and `body.travel` come to an end";
            self.report(invalid(done, message).help(help));
        }
        if call.arguments.len() != wanted.len() {
            let message =
                format!("`{name}` takes {}, {}", counted(wanted.len(), "argument"), given(call.arguments.len()));
            self.report(Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, call.span, message));
            return None;
        }
        let arguments: Vec<_> = call
            .arguments
            .iter()
            .zip(wanted)
            .map(|(argument, &dimension)| self.body_argument(argument, dimension, parameters))
            .collect();
        Some(ir::BodyCommand { kind, arguments: arguments.into_iter().collect::<Option<_>>()? })
    }

    fn body_argument(
        &mut self,
        argument: &ast::Argument,
        wanted: Dimension,
        parameters: &[ir::Parameter],
    ) -> Option<ir::BodyArgument> {
        match &argument.value.kind {
            ast::ExprKind::Negate(value) if matches!(value.kind, ast::ExprKind::Path(_)) => {
                let argument = ast::Argument { name: None, value: (**value).clone() };
                match self.body_argument(&argument, wanted, parameters)? {
                    ir::BodyArgument::Parameter(parameter) => Some(ir::BodyArgument::Negated(parameter)),
                    other => Some(other),
                }
            }
            ast::ExprKind::Quantity(quantity) => {
                Some(ir::BodyArgument::Constant(self.quantity_of(quantity, wanted, None)?.to_f64()))
            }
            ast::ExprKind::Path(path) if path.segments.len() == 1 => {
                let name = path.segments.first()?;
                let Some(index) = super::position(&name.text, parameters.iter().map(|parameter| &parameter.symbol))
                else {
                    let known = parameters.iter().map(|parameter| parameter.symbol.name.as_str());
                    self.report(self.unknown(name, "parameter of this action", known));
                    return None;
                };
                let found = parameters.get(index)?.unit.dimension;
                self.refers(name.span, parameters.get(index)?.symbol.span);
                if found != wanted {
                    self.report(mismatch(name.span, found, wanted));
                    return None;
                }
                Some(ir::BodyArgument::Parameter(index as u32))
            }
            _ => {
                self.report(invalid(argument.value.span, "a body's command takes quantities and parameters"));
                None
            }
        }
    }

    /// Reports what an interface promises and a robot does not keep.
    fn check_promise(&mut self, robot: &ast::Name, interface: Id<ir::Interface>, span: Span, members: &Members) {
        let promised = &self.program.interfaces[interface];
        let actions = &self.program.actions;
        let sensors = &self.program.sensors;
        let (mut broken, mut names) = (Vec::new(), Vec::new());
        for &action in &promised.actions {
            let wanted = &actions[action];
            let kept = named(&wanted.symbol.name, &members.actions, |id| &actions[id].symbol);
            if let Some(kept) = kept.map(|id| &actions[id]) {
                let parameters = kept.parameters.iter().zip(&wanted.parameters);
                names.push((kept.symbol.span, wanted.symbol.span));
                names.extend(parameters.map(|(kept, wanted)| (kept.symbol.span, wanted.symbol.span)));
            }
            let fits = kept.is_some_and(|id| {
                let kept = &actions[id];
                self.poison.actions.contains(&id)
                    || self.poison.actions.contains(&action)
                    || kept.reports_done == wanted.reports_done
                        && kept.parameters.len() == wanted.parameters.len()
                        && kept.parameters.iter().zip(&wanted.parameters).all(|(kept, wanted)| {
                            kept.symbol.name == wanted.symbol.name && kept.unit.dimension == wanted.unit.dimension
                        })
            });
            let is_lost = kept.is_none() && self.unparsed.may_declare(&wanted.symbol.name);
            if !fits && !is_lost {
                broken.push((&wanted.symbol, "action", kept.map(|kept| actions[kept].symbol.span)));
            }
        }
        for &sensor in &promised.sensors {
            let wanted = &sensors[sensor];
            let declared = declared_name(&wanted.symbol.name);
            let poisoned = |id| self.poison.sensors.contains(&id);
            let kept = [&members.sensors, &members.logical];
            let kept = |name: &str| kept.iter().find_map(|ids| named(name, ids, |id| &sensors[id].symbol));
            // A broken array is one sensor of its name.
            let kept = kept(&wanted.symbol.name).or_else(|| kept(declared).filter(|id| poisoned(*id)));
            names.extend(kept.map(|id| (sensors[id].symbol.span, wanted.symbol.span)));
            let fits = |id: Id<ir::Sensor>| {
                let kept = &sensors[id];
                let same = kept.unit.dimension == wanted.unit.dimension
                    && kept.is_contact == wanted.is_contact
                    && kept.range.0 >= wanted.range.0
                    && kept.range.1 <= wanted.range.1
                    && (wanted.optional || !kept.optional);
                same || poisoned(id) || poisoned(sensor)
            };
            let is_lost = kept.is_none() && (poisoned(sensor) || self.unparsed.may_declare(declared));
            if !kept.is_some_and(fits) && !is_lost {
                broken.push((&wanted.symbol, "sensor", kept.map(|kept| sensors[kept].symbol.span)));
            }
        }
        // Of an array the first element speaks for all.
        broken.dedup_by_key(|(promised, ..)| promised.span);
        names.dedup();
        let diagnostics: Vec<_> = broken
            .into_iter()
            .map(|(symbol, what, kept)| {
                let name = &symbol.name;
                let message = match kept {
                    Some(_) => format!("`{}` has the {what} `{name}` in another form than promised", robot.text),
                    None => format!("`{}` lacks the {what} `{name}`", robot.text),
                };
                Diagnostic::new(&diag::rules::INTERFACE_NOT_KEPT, kept.unwrap_or(span), message)
                    .label(symbol.span, "promised here")
            })
            .collect();
        self.diagnostics.extend(diagnostics);
        for (kept, promised) in names {
            self.refers(kept, promised);
        }
    }
}

/// Who carries out the actions of a list of members.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Carrier {
    /// The robot's body.
    Body,
    /// The robot's body, and a behavior of the robot's.
    Drive,
    /// A robot without a body: its actions are the user's to write.
    Nothing,
    /// The robots that provide the interface.
    Interface,
}

#[derive(Default)]
pub(super) struct Members {
    pub(super) body: Option<(Option<ir::Body>, Span)>,
    pub(super) sensors: Vec<Id<ir::Sensor>>,
    logical: Vec<Id<ir::Sensor>>,
    senses: Vec<ir::Sense>,
    pub(super) actions: Vec<Id<ir::Action>>,
}

fn missing_body(robot: &ast::Name, needed: Span) -> Diagnostic {
    missing_part(robot.span, format!("`{}` has no body", robot.text))
        .label(needed, "there is nothing that could carry this out")
        .help("write `body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }`")
}

pub(super) fn join(path: &ast::Path) -> String {
    path.segments.iter().map(|name| name.text.as_str()).collect::<Vec<_>>().join(".")
}

pub(super) fn unknown_path<'s>(
    path: &ast::Path,
    name: &str,
    what: &str,
    known: impl Iterator<Item = &'s str> + Clone,
) -> Diagnostic {
    // Every part by itself: `body.halt` is as long as `body.arc` is near it.
    let is_near = |candidate: &&str| {
        let (parts, others) = (name.split('.'), candidate.split('.'));
        parts.clone().count() == others.clone().count()
            && parts.zip(others).all(|(part, other)| part == other || diag::nearest(part, [other]).is_some())
    };
    Diagnostic::new(&diag::rules::UNKNOWN_NAME, path.span, format!("{what} `{name}`"))
        .help_maybe(known.clone().find(is_near).map(|candidate| format!("did you mean `{candidate}`?")))
        .note(format!("known are: {}", known.collect::<Vec<_>>().join(", ")))
}
