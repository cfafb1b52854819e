//! Contacts that follow from conditions: a robot's own intelligent sensors (Sobh §3.2).

use std::collections::{BTreeSet, HashMap};

use super::conditions::Scene;
use super::diagrams::{collect_names, sense_name};
use super::sensors::plain;
use super::{Lower, claim, invalid, symbol};
use crate::base::{Arena, Exact, Id, Span, Unit};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Op};
use crate::syntax::ast;

impl Lower<'_> {
    /// Adds the contacts of a robot that follow from conditions over its `sensors` and what it senses through networks.
    pub(super) fn contacts(
        &mut self,
        senses: &[&ast::Sense],
        conditions: &[&ast::Logical],
        sensors: Vec<Id<ir::Sensor>>,
    ) -> (Vec<ir::Sense>, Vec<Id<ir::Sensor>>) {
        let mut scene = Scene { sensors, ..Scene::default() };
        let mut seen = HashMap::new();
        let is_first =
            |sense: &&&ast::Sense| claim(&mut seen, sense_name(sense), "sensed network", &mut self.diagnostics);
        let trees: Vec<_> = senses.iter().filter(is_first).copied().collect();
        let senses = self.senses(&trees, &mut scene);
        let names: Vec<_> = conditions.iter().map(|tree| tree.name.text.as_str()).collect();
        let contact = |tree: &&ast::Logical| match self.contact(tree, &names, &senses, &scene) {
            Some(contact) => self.program.sensors.add(contact),
            None => self.broken_sensor(&tree.name),
        };
        let contacts = conditions.iter().map(contact).collect();
        (senses, contacts)
    }

    fn contact(
        &mut self,
        tree: &ast::Logical,
        conditions: &[&str],
        senses: &[ir::Sense],
        scene: &Scene,
    ) -> Option<ir::Sensor> {
        let mut names = Vec::new();
        collect_names(&tree.value, &mut names);
        if let Some(other) = names.iter().find(|name| conditions.contains(name)) {
            let message = format!("`{other}` is a condition itself");
            self.report(invalid(tree.value.span, message).help("name what it looks at"));
            return None;
        }
        let condition = self.condition(&tree.value, scene);
        let mut of = BTreeSet::new();
        let mut waiting = vec![condition];
        while let Some(id) = waiting.pop() {
            let ir::Expr { op, span, .. } = &self.program.exprs[id];
            waiting.extend(op.operands());
            match op {
                Op::Error => return None,
                Op::Sensor(sensor) | Op::Failed(sensor) => of.extend(self.program.members(*sensor)),
                Op::Event { sense, .. } => {
                    let inputs = senses[*sense as usize].inputs.iter();
                    of.extend(inputs.flat_map(|&sensor| self.program.members(sensor)));
                }
                Op::After(_)
                | Op::Done
                | Op::Count(_)
                | Op::Rising(_)
                | Op::Falling(_)
                | Op::Held(..)
                | Op::Latched(_) => {
                    let diagnostic = looks_back(*span, &tree.name);
                    self.report(diagnostic);
                    return None;
                }
                Op::Unknown
                | Op::Number(_)
                | Op::Flag(_)
                | Op::InMode(_)
                | Op::Inside(_)
                | Op::Compare(..)
                | Op::Not(_)
                | Op::And(_)
                | Op::Or(_) => {}
            }
        }
        let range = (Exact::ZERO, Exact::ONE);
        let sensor = plain(symbol(&tree.name, tree.doc.as_ref()), false, Unit::contact(), range);
        let kept = Some(ir::Kept { condition, of: of.into_iter().collect() });
        Some(ir::Sensor { is_contact: true, kept, ..sensor })
    }

    /// Adds the conditions of the contacts that some names mean to a diagram on their robot: as flags, which the checker
    /// sees through, with the networks they look at.
    pub(super) fn take_in(
        &mut self,
        platform: ir::Platform,
        names: &[&str],
        senses: &mut Vec<ir::Sense>,
        flags: &mut Arena<ir::Flag>,
    ) {
        let ir::Platform::Robot(robot) = platform else { return };
        let ir::Robot { logical, senses: of_robot, .. } = self.program.robots[robot].clone();
        for contact in logical {
            let ir::Sensor { symbol, kept: Some(kept), .. } = &self.program.sensors[contact] else { continue };
            let is_known = flags.values().any(|flag| flag.symbol.span == symbol.span);
            if names.contains(&symbol.name.as_str()) && !is_known {
                let (symbol, condition) = (symbol.clone(), kept.condition);
                let condition = self.copy(condition, &of_robot, senses);
                flags.add(ir::Flag { symbol, condition });
            }
        }
    }

    /// The same for what is said of a diagram from outside.
    pub(super) fn take_in_later(&mut self, id: Id<ir::Diagram>, names: &[&str]) {
        let ir::Diagram { platform, senses, flags, .. } = &mut self.program.diagrams[id];
        let (platform, mut senses, mut flags) = (*platform, std::mem::take(senses), std::mem::take(flags));
        self.take_in(platform, names, &mut senses, &mut flags);
        let diagram = &mut self.program.diagrams[id];
        (diagram.senses, diagram.flags) = (senses, flags);
    }

    /// Whether a sense of a diagram is one of its robot's, taken in with a contact.
    pub(super) fn is_taken_in(&self, platform: ir::Platform, sense: &ir::Sense) -> bool {
        let ir::Platform::Robot(robot) = platform else { return false };
        self.program.robots[robot].senses.iter().any(|own| own.symbol.span == sense.symbol.span)
    }

    /// A condition of a robot with what it senses among the senses of a diagram. Recursion is as deep as parentheses,
    /// which the parser limits.
    fn copy(&mut self, id: Id<ir::Expr>, of_robot: &[ir::Sense], senses: &mut Vec<ir::Sense>) -> Id<ir::Expr> {
        let mut expr = self.program.exprs[id].clone();
        match &mut expr.op {
            Op::Event { sense, .. } => {
                let sensed = &of_robot[*sense as usize];
                let is_same = |own: &ir::Sense| own.network == sensed.network && own.inputs == sensed.inputs;
                let place = senses.iter().position(is_same).unwrap_or_else(|| {
                    senses.push(sensed.clone());
                    senses.len() - 1
                });
                *sense = place as u32;
            }
            Op::Compare(_, left, right) => {
                *left = self.copy(*left, of_robot, senses);
                *right = self.copy(*right, of_robot, senses);
            }
            Op::Not(of) => *of = self.copy(*of, of_robot, senses),
            Op::And(of) | Op::Or(of) => of.iter_mut().for_each(|of| *of = self.copy(*of, of_robot, senses)),
            // The others look back, which no contact does, or have no parts.
            _ => {}
        }
        self.program.exprs.add(expr)
    }
}

pub(super) fn sense_in_interface(tree: &ast::Sense) -> Diagnostic {
    invalid(tree.span, "an interface only says what there is, not what it follows from")
        .help("promise a contact; a robot may keep it by a condition over what it senses")
}

fn looks_back(span: Span, contact: &ast::Name) -> Diagnostic {
    let message = format!("the logical sensor `{}` looks back in time", contact.text);
    Diagnostic::new(&diag::rules::LOGICAL_LOOKS_BACK, span, message)
        .note("a sensor tells what is there now; only behaviors remember")
        .help(format!("leave it out here, and look back in the behavior, as in `held({}, 200 ms)`", contact.text))
}
