//! Conditions of a diagram, with names of conditions written out.

use std::collections::HashMap;

use crate::base::Id;
use crate::ir::{Diagram, Expr, Op, Program};
use crate::view::sign;

/// The texts of conditions that were asked for, and of their parts.
pub(super) struct Conditions<'a> {
    program: &'a Program,
    diagram: &'a Diagram,
    known: HashMap<Id<Expr>, String>,
}

impl<'a> Conditions<'a> {
    pub(super) fn new(program: &'a Program, diagram: &'a Diagram) -> Self {
        Self { program, diagram, known: HashMap::new() }
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
            Op::Flag(flag) => vec![self.diagram.flags[*flag].condition],
            Op::Count(of) | Op::Rising(of) | Op::Falling(of) | Op::Held(of, _) | Op::Latched(of) | Op::Not(of) => {
                vec![*of]
            }
            Op::Compare(_, left, right) => vec![*left, *right],
            Op::And(of) | Op::Or(of) => of.clone(),
            _ => Vec::new(),
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
                let sense = &self.diagram.senses[*sense as usize];
                let event = &self.program.networks[sense.network].events[*event as usize];
                format!("{}.{}", sense.symbol.name, event.symbol.name)
            }
            Op::Flag(flag) => known(&self.diagram.flags[*flag].condition).to_owned(),
            Op::InMode(mode) => format!("mode is {}", self.diagram.modes[*mode].symbol.name),
            Op::Inside(path) => self.program.inside(self.diagram, path),
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
