//! What explains why a transition was taken: the parts of its condition, and the numbers that it looks at.

use std::collections::HashSet;

use super::builder::{Builder, Names, reachable};
use super::parts::Parts;
use super::platform::Feed;
use super::{Evidence, Part, Value};
use crate::base::Id;
use crate::ir;

impl Parts<'_> {
    /// What a condition that has been emitted is made of, through named flags, each part once.
    pub(super) fn parts(&self, condition: Id<ir::Expr>, builder: &mut Builder<'_>, names: &Names<'_>) -> Vec<Part> {
        let program = self.platform.program;
        let mut parts = Vec::new();
        let mut waiting = vec![(condition, 0)];
        let mut seen = HashSet::new();
        while let Some((id, depth)) = waiting.pop() {
            let expr = &program.exprs[id];
            let (within, evidence) = match &expr.op {
                ir::Op::Flag(flag) => (vec![self.diagram.flags[*flag].condition], Vec::new()),
                ir::Op::And(of) | ir::Op::Or(of) => (of.clone(), Vec::new()),
                ir::Op::Compare(_, left, right) => {
                    let sides = [*left, *right];
                    let looks_at = sides.iter().flat_map(|side| self.looks_at(&program.exprs[*side].op)).collect();
                    let counts = sides.into_iter().filter(|side| matches!(program.exprs[*side].op, ir::Op::Count(_)));
                    (counts.collect(), looks_at)
                }
                ir::Op::Not(of)
                | ir::Op::Rising(of)
                | ir::Op::Falling(of)
                | ir::Op::Held(of, _)
                | ir::Op::Latched(of)
                | ir::Op::Count(of) => (vec![*of], Vec::new()),
                op => (Vec::new(), self.looks_at(op)),
            };
            waiting.extend(within.into_iter().rev().filter(|id| seen.insert(*id)).map(|id| (id, depth + 1)));
            let value = builder.expr(id, names);
            let value = if expr.ty == ir::Type::Bool { Value::Truth(value) } else { Value::Number(value) };
            parts.push(Part { depth, text: self.checked.on_one_line(expr.span), value, evidence });
        }
        parts
    }

    /// The numbers that one operation looks at.
    fn looks_at(&self, op: &ir::Op) -> Vec<Evidence> {
        match op {
            ir::Op::Sensor(sensor) | ir::Op::Failed(sensor) => vec![self.reading(*sensor)],
            ir::Op::Event { sense, event } => vec![self.event(*sense, *event)],
            ir::Op::After(_) => vec![Evidence::Dwell],
            _ => Vec::new(),
        }
    }

    fn reading(&self, sensor: Id<ir::Sensor>) -> Evidence {
        match self.platform.feed(sensor) {
            Feed::Input(input) => Evidence::Input(input),
            Feed::Logical(place) => Evidence::Logical(place),
        }
    }

    /// An event by its position among those of all networks.
    fn event(&self, sense: u32, event: u32) -> Evidence {
        let before = self.senses().take(sense as usize);
        let before = before.map(|sense| self.platform.program.networks[sense.network].events.len());
        Evidence::Event(before.sum::<usize>() as u32 + event)
    }

    /// The networks of the plan.
    fn senses(&self) -> impl Iterator<Item = &ir::Sense> {
        self.diagram.senses.iter().chain(self.platform.senses)
    }

    /// The condition that a contact follows from.
    fn kept(&self, op: &ir::Op) -> Option<Id<ir::Expr>> {
        let ir::Op::Sensor(sensor) = op else { return None };
        let Feed::Logical(place) = self.platform.feed(*sensor) else { return None };
        let sensor = &self.platform.program.sensors[self.platform.logical[place as usize]];
        sensor.kept.as_ref().map(|kept| kept.condition)
    }

    /// The numbers a condition looks at, through named flags, contacts and events, each once.
    pub(super) fn evidence(&self, condition: Id<ir::Expr>) -> Vec<Evidence> {
        let mut evidence = Vec::new();
        let mut add = |item| {
            if !evidence.contains(&item) {
                evidence.push(item);
            }
        };
        let mut waiting = vec![(condition, 0)];
        let mut seen = HashSet::new();
        while let Some((root, first)) = waiting.pop() {
            for id in reachable(self.platform.program, root) {
                let op = &self.platform.program.exprs[id].op;
                match op {
                    ir::Op::Event { sense, event } => {
                        add(self.event(first + sense, *event));
                        let sensed = self.senses().nth((first + sense) as usize);
                        for &sensor in sensed.iter().flat_map(|sense| &sense.inputs) {
                            add(self.reading(sensor));
                        }
                    }
                    ir::Op::Flag(flag) if seen.insert(*flag) => {
                        waiting.push((self.diagram.flags[*flag].condition, 0));
                    }
                    op => match self.kept(op) {
                        Some(condition) => waiting.push((condition, self.diagram.senses.len() as u32)),
                        None => self.looks_at(op).into_iter().for_each(&mut add),
                    },
                }
            }
        }
        evidence
    }
}
