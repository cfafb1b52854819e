//! Conditions of a diagram, with names of conditions written out.

use std::collections::HashMap;

use crate::base::Id;
use crate::ir::{Diagram, Expr, Op, Program, Robot, Sense};
use crate::view::sign;

/// The texts of conditions that were asked for, and of their parts.
pub(super) struct Conditions<'a> {
    program: &'a Program,
    senses: &'a [Sense],
    /// What has the flags and modes; none for the conditions of a robot.
    diagram: Option<&'a Diagram>,
    known: HashMap<Id<Expr>, String>,
}

impl<'a> Conditions<'a> {
    pub(super) fn new(program: &'a Program, diagram: &'a Diagram) -> Self {
        Self { program, senses: &diagram.senses, diagram: Some(diagram), known: HashMap::new() }
    }

    pub(super) fn of_robot(program: &'a Program, robot: &'a Robot) -> Self {
        Self { program, senses: &robot.senses, diagram: None, known: HashMap::new() }
    }

    pub(super) fn text(&mut self, condition: Id<Expr>) -> String {
        // Operands stand before what uses them, and named conditions may stand anywhere.
        let mut waiting = vec![condition];
        while let Some(&next) = waiting.last() {
            let missing: Vec<_> = self.parts(next).into_iter().filter(|part| !self.known.contains_key(part)).collect();
            if missing.is_empty() {
                let text = self.of(next);
                self.known.insert(next, text);
                waiting.pop();
            } else {
                waiting.extend(missing);
            }
        }
        self.known[&condition].clone()
    }

    fn parts(&self, condition: Id<Expr>) -> Vec<Id<Expr>> {
        match &self.program.exprs[condition].op {
            Op::Flag(flag) => self.diagram.iter().map(|diagram| diagram.flags[*flag].condition).collect(),
            op => op.operands(),
        }
    }

    /// A condition whose parts are known.
    fn of(&self, condition: Id<Expr>) -> String {
        let known = |part: &Id<Expr>| self.known[part].as_str();
        let joined = |of: &[Id<Expr>], word: &str| {
            format!("({})", of.iter().map(known).collect::<Vec<_>>().join(&format!(" {word} ")))
        };
        match &self.program.exprs[condition].op {
            Op::Error | Op::Unknown => "?".to_owned(),
            Op::Number(number) => number.to_string(),
            Op::Sensor(sensor) => self.program.sensors[*sensor].symbol.name.clone(),
            Op::Failed(sensor) => format!("failed({})", self.program.sensors[*sensor].symbol.name),
            Op::Event { sense, event } => {
                let sense = &self.senses[*sense as usize];
                let event = &self.program.networks[sense.network].events[*event as usize];
                format!("{}.{}", sense.symbol.name, event.symbol.name)
            }
            Op::Flag(_) => self.parts(condition).first().map_or("?", known).to_owned(),
            Op::InMode(mode) => {
                let mode = self.diagram.map_or("?", |diagram| &diagram.modes[*mode].symbol.name);
                format!("mode is {mode}")
            }
            Op::Inside(path) => self.diagram.map_or_else(|| "?".to_owned(), |of| self.program.inside(of, path)),
            Op::After(duration) => format!("after {duration} ns"),
            Op::Done => "done".to_owned(),
            Op::Count(of) => format!("count({})", known(of)),
            Op::Rising(of) => format!("rising({})", known(of)),
            Op::Falling(of) => format!("falling({})", known(of)),
            Op::Held(of, duration) => format!("held({}, {duration} ns)", known(of)),
            Op::Latched(of) => format!("latched({})", known(of)),
            Op::Compare(comparison, left, right) => {
                format!("{} {} {}", known(left), sign(*comparison), known(right))
            }
            Op::Not(of) => format!("not {}", known(of)),
            Op::And(of) => joined(of, "and"),
            Op::Or(of) => joined(of, "or"),
        }
    }
}
