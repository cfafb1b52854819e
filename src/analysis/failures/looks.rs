//! What the transitions of a diagram look at, and the failures that its modes answer for.

use std::collections::BTreeSet;

use super::events::named_inputs;
use crate::analysis::modes::{self, parts};
use crate::base::Id;
use crate::ir::{Diagram, Expr, Mode, Op, Program, Sensor};

/// What a condition looks at.
#[derive(Debug, Default)]
pub(in crate::analysis) struct Looks {
    /// The sensors that it compares.
    pub(in crate::analysis) compared: BTreeSet<Id<Sensor>>,
    /// The sensors that the rules of its events name.
    pub(in crate::analysis) fused: BTreeSet<Id<Sensor>>,
    /// Its events: the position of the sense in the diagram, and of the event in its network.
    pub(in crate::analysis) events: BTreeSet<(u32, u32)>,
    /// The sensors of which it asks whether they are known to have failed.
    pub(in crate::analysis) failed: BTreeSet<Id<Sensor>>,
    /// Whether it asks for the time in the mode.
    pub(in crate::analysis) times: bool,
}

impl Looks {
    fn at(program: &Program, diagram: &Diagram, condition: Id<Expr>) -> Self {
        let mut looks = Self::default();
        let mut waiting = vec![condition];
        let mut known = BTreeSet::new();
        while let Some(condition) = waiting.pop() {
            for id in parts(program, condition) {
                match program.exprs[id].op {
                    Op::Sensor(sensor) => drop(looks.compared.insert(sensor)),
                    Op::Failed(sensor) => drop(looks.failed.insert(sensor)),
                    Op::Event { sense, event } => drop(looks.events.insert((sense, event))),
                    Op::After(_) => looks.times = true,
                    Op::Flag(flag) if known.insert(flag) => waiting.push(diagram.flags[flag].condition),
                    _ => {}
                }
            }
        }
        for &(sense, event) in &looks.events {
            let sense = &diagram.senses[sense as usize];
            let named = named_inputs(&program.networks[sense.network].events[event as usize]);
            looks.fused.extend(named.iter().filter_map(|input| sense.inputs.get(*input)));
        }
        looks
    }

    /// Whether it waits for a time, and for nothing that any sensor has a say in.
    pub(in crate::analysis) fn is_timer(&self) -> bool {
        self.times && self.compared.is_empty() && self.fused.is_empty() && self.failed.is_empty()
    }
}

/// What a mode looks at.
#[derive(Debug)]
pub(in crate::analysis) struct View {
    /// Of each transition.
    pub(in crate::analysis) exits: Vec<Looks>,
    /// Of each row of the decision table.
    pub(in crate::analysis) rows: Vec<Looks>,
    /// The sensors whose failure the mode says what to do about: it requires them, or asks whether they have failed.
    pub(in crate::analysis) answers: BTreeSet<Id<Sensor>>,
}

impl View {
    /// What the modes of a diagram look at.
    pub(in crate::analysis) fn of_modes(program: &Program, diagram: &Diagram) -> Vec<Self> {
        let of_mode = |mode: &Mode| {
            let conditions = mode.transitions.iter().map(|transition| transition.condition);
            let exits: Vec<_> = conditions.map(|condition| Looks::at(program, diagram, condition)).collect();
            let rows = mode.decision.iter().flat_map(|table| &table.rows);
            let rows: Vec<_> = rows.map(|row| Looks::at(program, diagram, row.condition)).collect();
            let required = mode.requires.iter().map(|(sensor, _)| *sensor);
            let told = exits.iter().chain(&rows).flat_map(|looks| &looks.failed).copied();
            let mut answers: BTreeSet<_> = required.chain(told).collect();
            answers.extend(modes::groups_within(program, diagram, &answers));
            Self { exits, rows, answers }
        };
        diagram.modes.values().map(of_mode).collect()
    }
}
