//! Arbiters: who commands a robot.

use std::collections::HashMap;

use super::conditions::Scene;
use super::{Lower, claim, invalid, missing_part, symbol};
use crate::base::{Arena, Id, Span};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Arbiter};
use crate::syntax::ast;

/// The modes in which no client has the robot, in the order of [`Arbiter::NOBODY`] and [`Arbiter::EMERGENCY`].
const OTHERS: [(&str, &str); Arbiter::OTHERS as usize] =
    [("nobody", "No client proposes a command."), ("emergency", "An emergency bypasses the clients.")];

impl<'a> Lower<'a> {
    pub(super) fn arbiter(&mut self, tree: &'a ast::Arbiter) {
        let Some(on) = &tree.on else {
            let message = format!("nothing says what `{}` commands", tree.name.text);
            let help = format!("write `arbiter {} on labmate`", tree.name.text);
            return self.report(missing_part(tree.name.span, message).help(help));
        };
        let Some(robot) = self.find_robot(on) else { return };
        let platform = ir::Platform::Robot(robot);
        let (sensors, actions) = (self.program.sensors_of(platform), self.program.actions_of(platform).to_vec());
        let (states, commands) = self.doings(platform);
        let scene = Scene { sensors, states, commands, ..Scene::default() };
        let mut arbiter = Arbiter { emergencies: Vec::new(), clients: Vec::new(), ties: None };
        let (mut ties, mut seen, mut incomplete) = (None, HashMap::new(), false);
        for item in &tree.items {
            match item {
                ast::ArbiterItem::Emergency { condition, command, span } => {
                    let condition = self.condition(condition, &scene);
                    let command = self.call(command, &actions, &scene).filter(|call| self.bypasses(robot, call));
                    incomplete |= command.is_none();
                    arbiter.emergencies.extend(command.map(|command| ir::Emergency {
                        condition,
                        command,
                        span: *span,
                    }));
                }
                ast::ArbiterItem::Client(client) => {
                    if claim(&mut seen, &client.name, "client", &mut self.diagnostics) {
                        let lowered = self.client(client, robot, &scene);
                        incomplete |= lowered.is_none();
                        arbiter.clients.extend(lowered);
                    }
                }
                ast::ArbiterItem::Ties { order, span } => {
                    let word = self.ties(order);
                    self.once(&mut ties, word, *span, "how ties are broken");
                }
                ast::ArbiterItem::Error(_) => incomplete = true,
            }
        }
        arbiter.ties = ties.and_then(|(ties, _)| ties);
        if arbiter.clients.is_empty() && !incomplete {
            let message = format!("`{}` has no clients", tree.name.text);
            self.report(missing_part(tree.name.span, message).help("write `client name = behavior priority 1`"));
        }
        let others = OTHERS.iter().map(|(name, doc)| {
            let name = (*name).to_owned();
            mode(ir::Symbol { name, span: tree.name.span, doc: (*doc).to_owned() })
        });
        let modes: Arena<ir::Mode> =
            others.chain(arbiter.clients.iter().map(|client| mode(client.symbol.clone()))).collect();
        let id = self.program.diagrams.add(ir::Diagram {
            symbol: symbol(&tree.name, tree.doc.as_ref()),
            layer: ir::Layer::Behavior,
            platform,
            senses: Vec::new(),
            flags: Arena::default(),
            modes,
            entry: Some(Arbiter::NOBODY),
            arbiter: Some(arbiter),
            incomplete,
        });
        self.scopes.diagrams.insert(tree.name.span, id);
    }

    fn client(&mut self, tree: &ast::Client, robot: Id<ir::Robot>, scene: &Scene) -> Option<ir::Client> {
        let priorities: Vec<_> = tree.priorities.iter().map(|priority| self.priority(priority, scene)).collect();
        if let Some((name, _)) = OTHERS.iter().find(|(name, _)| *name == tree.name.text) {
            self.report(invalid(tree.name.span, format!("`{name}` has a meaning of its own in an arbiter")));
            return None;
        }
        let diagram = self.find_diagram(&tree.diagram)?;
        if !self.runs_on(diagram, ir::Platform::Robot(robot)) {
            self.not_written_for(&tree.diagram, ir::Platform::Robot(robot));
            return None;
        }
        if let Some((mode, span)) = self.says_more(diagram) {
            let message = format!("`{}` commands more than one thing in `{mode}`", tree.diagram.text);
            let diagnostic = invalid(tree.diagram.span, message).label(span, "this is more than a client can propose");
            self.report(diagnostic.note("on every tick a client proposes one command, or nothing"));
            return None;
        }
        if let Some(unreached) = tree.priorities.iter().position(|priority| priority.when.is_none())
            && unreached + 1 < tree.priorities.len()
        {
            let span = tree.priorities[unreached + 1].priority.span;
            self.report(
                invalid(span, "this priority is never asked for").help("write `when ...` behind the one before"),
            );
        }
        let priorities = priorities.into_iter().collect::<Option<_>>()?;
        Some(ir::Client { symbol: symbol(&tree.name, tree.doc.as_ref()), diagram, priorities, span: tree.span })
    }

    fn priority(&mut self, tree: &ast::ClientPriority, scene: &Scene) -> Option<(u32, Option<Id<ir::Expr>>)> {
        let when = tree.when.as_ref().map(|when| self.condition(when, scene));
        let priority = self.whole(&tree.priority, 1, "a priority")?;
        if priority > 10 {
            self.report(invalid(tree.priority.span, "priorities run from 1, the highest, to 10"));
            return None;
        }
        Some((priority as u32, when))
    }

    fn ties(&mut self, order: &ast::Name) -> Option<ir::Ties> {
        match order.text.as_str() {
            "in_order" => Some(ir::Ties::InOrder),
            "random" => Some(ir::Ties::Random),
            _ => {
                self.report(self.unknown(order, "way to break ties", ["in_order", "random"]));
                None
            }
        }
    }

    /// A mode of a diagram that gives more than one command on a tick, and where.
    fn says_more(&self, diagram: Id<ir::Diagram>) -> Option<(&str, Span)> {
        self.program.diagrams[diagram].modes.values().find_map(|mode| {
            let inner = mode.runs.and_then(|run| self.says_more(run.diagram));
            let decided = mode.decision.as_ref().map(|decision| decision.span);
            let every_tick = mode.actions.iter().map(|call| call.span).chain(decided).skip(1);
            let once = mode.on_enter.iter().chain(&mode.on_exit).map(|call| call.span);
            inner.or_else(|| Some((mode.symbol.name.as_str(), once.chain(every_tick).next()?)))
        })
    }

    /// Whether the command of an emergency goes straight to the body; reports one that does not.
    fn bypasses(&mut self, robot: Id<ir::Robot>, call: &ir::Call) -> bool {
        let action = |id: Id<ir::Action>| &self.program.actions[id];
        let kept = action(call.action).same_as.as_ref().map_or(call.action, |(other, _)| *other);
        let Some(drive) = self.program.robots[robot].drive.as_ref().filter(|_| action(kept).is_driven()) else {
            return true;
        };
        let (name, symbol) = (&action(call.action).symbol.name, &self.program.robots[robot].symbol);
        let drive = drive.diagram.map_or("its drive", |drive| &self.program.diagrams[drive].symbol.name);
        let message = format!("the emergency command `{name}` takes the way of every other command");
        let diagnostic = Diagnostic::new(&diag::rules::EMERGENCY_SHARES_PATH, call.span, message)
            .label(symbol.span, format!("`{drive}` carries it out, when it comes to it"))
            .help("name an action that is a command of the body, as in `action halt() = body.stop()`");
        self.report(diagnostic);
        false
    }
}

/// A mode of an arbiter.
fn mode(symbol: ir::Symbol) -> ir::Mode {
    ir::Mode {
        symbol,
        is_final: true,
        runs: None,
        requires: Vec::new(),
        otherwise: None,
        actions: Vec::new(),
        decision: None,
        on_enter: Vec::new(),
        on_exit: Vec::new(),
        transitions: Vec::new(),
        incomplete: false,
        inherited: false,
    }
}
