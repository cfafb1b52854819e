//! The conditions of a mode's transitions as expressions over flags.

use super::names::{Kind, Names};
use crate::analysis::modes::{Atom, Guards, Node, Operand, Past};
use crate::base::{Id, Sources};
use crate::ir::{Diagram, Program, Sensor};
use crate::view::sign;

/// A mode's conditions in Promela.
pub(super) struct Expressions {
    /// The variable of each atom; none where it follows from the timers and counters.
    pub(super) flags: Vec<Option<String>>,
    /// Statements that set what the readings leave open.
    pub(super) open: Vec<String>,
    /// The condition of each transition, once they have run.
    pub(super) roots: Vec<String>,
    /// Every variable that is set on a tick.
    pub(super) set: Vec<String>,
}

impl Expressions {
    pub(super) fn new(
        program: &Program,
        sources: &Sources,
        diagram: &Diagram,
        guards: &Guards,
        names: &mut Names,
    ) -> Self {
        let formula = &guards.formula;
        let uses = uses(guards);
        let mut all =
            Self { flags: vec![None; formula.atoms.len()], open: Vec::new(), roots: Vec::new(), set: Vec::new() };
        let mut texts: Vec<String> = Vec::new();
        let mut values: Vec<String> = Vec::new();
        for (index, node) in formula.nodes.iter().enumerate() {
            let joined = |of: &[usize], with: &str| {
                format!("({})", of.iter().map(|of| values[*of].as_str()).collect::<Vec<_>>().join(with))
            };
            let (text, value) = match node {
                Node::Constant(value) => (value.to_string(), value.to_string()),
                Node::Not(of) => (format!("not {}", texts[*of]), format!("!{}", values[*of])),
                Node::All(of) => (format!("condition {index}"), joined(of, " && ")),
                Node::Any(of) => (format!("condition {index}"), joined(of, " || ")),
                Node::Atom(atom) => {
                    let text = text(program, sources, diagram, &formula.atoms[*atom], &texts);
                    let value = timed(guards, &formula.atoms[*atom]).unwrap_or_else(|| {
                        let flag = all.flag(&text, names);
                        all.open.extend(open(&formula.atoms[*atom], &flag, &values));
                        all.flags[*atom] = Some(flag.clone());
                        flag
                    });
                    (text, value)
                }
            };
            // What is needed twice is worked out once, so that the text does not grow with the ways through it.
            let is_short = match node {
                Node::Constant(_) | Node::Atom(_) => true,
                Node::Not(of) => matches!(formula.nodes[*of], Node::Atom(_)),
                Node::All(_) | Node::Any(_) => false,
            };
            let value = if uses[index] > 1 && !is_short {
                let flag = all.flag(&text, names);
                all.open.push(format!("{flag} = {value}"));
                flag
            } else {
                value
            };
            texts.push(text);
            values.push(value);
        }
        all.roots = formula.roots.iter().map(|root| values[*root].clone()).collect();
        all
    }

    /// A variable of its own, also where two numbers look alike.
    fn flag(&mut self, text: &str, names: &mut Names) -> String {
        let flag = names.distinct(Kind::Flag, text, |flag| self.set.contains(flag));
        self.set.push(flag.clone());
        flag
    }
}

/// How often each node is looked at.
fn uses(guards: &Guards) -> Vec<usize> {
    let formula = &guards.formula;
    let parts = formula.nodes.iter().flat_map(|node| match node {
        Node::Not(of) => std::slice::from_ref(of),
        Node::All(of) | Node::Any(of) => of,
        Node::Atom(atom) => match &formula.atoms[*atom] {
            Atom::Past(_, of) => std::slice::from_ref(of),
            _ => &[],
        },
        Node::Constant(_) => &[],
    });
    let mut uses = vec![0; formula.nodes.len()];
    for part in parts.chain(&formula.roots) {
        uses[*part] += 1;
    }
    uses
}

/// As a person would write it.
fn text(program: &Program, sources: &Sources, diagram: &Diagram, atom: &Atom, texts: &[String]) -> String {
    let name = |sensor: &Id<Sensor>| program.sensors[*sensor].symbol.name.as_str();
    match atom {
        Atom::Event { sense, event } => {
            let sense = &diagram.senses[*sense as usize];
            let event = &program.networks[sense.network].events[*event as usize].symbol.name;
            if diagram.senses.len() > 1 { format!("{}.{event}", sense.symbol.name) } else { event.clone() }
        }
        Atom::Compare(comparison, left, Operand::Sensor(right)) => {
            format!("{} {} {}", name(left), sign(*comparison), name(right))
        }
        Atom::Compare(comparison, left, Operand::Number(number)) => {
            let number = program.sensors[*left].unit.show(number.to_f64());
            format!("{} {} {number}", name(left), sign(*comparison))
        }
        Atom::Failed(sensor) => format!("failed({})", name(sensor)),
        Atom::After(duration) | Atom::Lasted(duration) => format!("after {}", seconds(*duration)),
        Atom::In(mode) => diagram.modes[*mode].symbol.name.clone(),
        Atom::Entered(mode) => format!("rising({})", diagram.modes[*mode].symbol.name),
        Atom::Left(mode) => format!("falling({})", diagram.modes[*mode].symbol.name),
        Atom::Count(comparison, of, number) => format!("count({}) {} {number}", texts[*of], sign(*comparison)),
        Atom::Past(Past::Rising, of) => format!("rising({})", texts[*of]),
        Atom::Past(Past::Falling, of) => format!("falling({})", texts[*of]),
        Atom::Past(Past::Held(duration), of) => format!("held({}, {})", texts[*of], seconds(*duration)),
        Atom::Past(Past::Latched, of) => format!("latched({})", texts[*of]),
        Atom::Inside(path) => program.inside(diagram, path),
        Atom::Done => "done".to_owned(),
        Atom::Open(id) => {
            let written = sources.slice(program.exprs[*id].span);
            written.split_whitespace().collect::<Vec<_>>().join(" ").replace("*/", "* /")
        }
    }
}

fn seconds(nanoseconds: u64) -> String {
    format!("{} s", nanoseconds as f64 / 1e9)
}

/// The value of an atom that follows from the timers and counters.
fn timed(guards: &Guards, atom: &Atom) -> Option<String> {
    let clock = &guards.clock;
    match atom {
        Atom::After(duration) => {
            let before = clock.thresholds.iter().filter(|threshold| **threshold < *duration).count();
            Some(format!("(passed > {before})"))
        }
        Atom::Count(comparison, of, number) => {
            let counter = clock.counters.iter().position(|(counted, _)| counted == of)?;
            Some(format!("(counts[{counter}] {} {number})", sign(*comparison)))
        }
        _ => None,
    }
}

/// The statement that sets an atom which readings leave open, as far as the present allows.
fn open(atom: &Atom, flag: &str, values: &[String]) -> Option<String> {
    let (claimed, denied) = match atom {
        Atom::Past(Past::Held(0), of) => return Some(format!("{flag} = {}", values[*of])),
        Atom::Past(Past::Rising | Past::Held(_), of) => {
            (format!("{} -> {flag} = true", values[*of]), "skip".to_owned())
        }
        Atom::Past(Past::Falling, of) => (format!("!{} -> {flag} = true", values[*of]), "skip".to_owned()),
        Atom::Past(Past::Latched, of) => (format!("{flag} = true"), format!("!{}", values[*of])),
        Atom::Done | Atom::Inside(_) | Atom::Open(_) => (format!("{flag} = true"), "skip".to_owned()),
        _ => return None,
    };
    Some(format!("if :: {claimed} :: {denied} fi"))
}
