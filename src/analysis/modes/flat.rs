//! A diagram with layers as one without: its modes are the innermost ones, and each tries what is around it first.
//!
//! Whatever the layers can do the flat diagram can do too. What is known of outer timers is that they have run as long
//! as the inner ones at least; of outer counters and latches nothing is.

use std::collections::HashMap;
use std::rc::Rc;

use super::formula::parts;
use crate::base::{Arena, Id, Span};
use crate::ir::{Diagram, Expr, Mode, Op, Program, Sense, Sensor, Transition, Type};

/// A flat diagram, in a program of its own.
pub struct Flat {
    /// The program, with the flat diagram and its conditions added.
    pub program: Program,
    /// The flat diagram.
    pub diagram: Id<Diagram>,
    /// Its modes.
    pub leaves: Vec<Leaf>,
    /// What is watched.
    pub watched: Vec<Id<Expr>>,
}

/// A mode of a flat diagram.
pub struct Leaf {
    /// The modes it stands for, the outermost first.
    pub path: Vec<Id<Mode>>,
    /// For each of its transitions the layer it is of, from 0 inward, and its position in the mode of that layer; `None`
    /// where it is the way out of a mode whose required sensor has failed.
    pub exits: Vec<Origin>,
}

/// The layer that a transition is of, and its position there.
pub type Origin = (usize, Option<usize>);

/// More modes than this are not looked into.
const MOST_LEAVES: usize = 1 << 12;

/// A diagram as a flat one, with some conditions that are watched from outside. `None` where something is broken, or where
/// there are too many modes.
pub fn flatten(program: &Program, diagram: Id<Diagram>, watched: &[Id<Expr>]) -> Option<Flat> {
    let paths = paths(program, diagram)?;
    let mut flattening = Flattening {
        program,
        outer: diagram,
        paths: &paths,
        flat: program.clone(),
        senses: Vec::new(),
        entered: HashMap::new(),
    };
    let (mut modes, mut exits): (Arena<Mode>, Vec<_>) = Default::default();
    for path in &paths {
        let (mode, from) = flattening.leaf(path)?;
        modes.add(mode);
        exits.push(from);
    }
    let watched: Vec<_> = watched.iter().map(|&condition| flattening.watched(condition)).collect::<Option<_>>()?;
    let outer = &program.diagrams[diagram];
    let entry = flattening.enters(vec![outer.entry?])?.first().copied();
    let Flattening { mut flat, senses, .. } = flattening;
    let flat_diagram = Diagram { senses, flags: Arena::default(), modes, entry, ..outer.clone() };
    let diagram = flat.diagrams.add(flat_diagram);
    let leaves = paths.into_iter().zip(exits).map(|(path, exits)| Leaf { path, exits }).collect();
    Some(Flat { program: flat, diagram, leaves, watched })
}

/// The innermost modes, each by the modes around it and itself.
fn paths(program: &Program, diagram: Id<Diagram>) -> Option<Vec<Vec<Id<Mode>>>> {
    let mut waiting: Vec<(Vec<Id<Mode>>, Id<Diagram>)> = vec![(Vec::new(), diagram)];
    let mut paths = Vec::new();
    while let Some((path, diagram)) = waiting.pop() {
        let diagram = &program.diagrams[diagram];
        if diagram.incomplete || diagram.arbiter.is_some() {
            return None;
        }
        for (id, mode) in diagram.modes.iter() {
            let path = [path.as_slice(), &[id]].concat();
            match mode.runs {
                Some(run) => waiting.push((path, run.diagram)),
                None => paths.push(path),
            }
        }
        if paths.len() > MOST_LEAVES {
            return None;
        }
    }
    paths.sort_unstable();
    Some(paths)
}

struct Flattening<'a> {
    program: &'a Program,
    outer: Id<Diagram>,
    paths: &'a [Vec<Id<Mode>>],
    flat: Program,
    senses: Vec<Sense>,
    /// What `enters` has found.
    entered: HashMap<Vec<Id<Mode>>, Rc<Vec<Id<Mode>>>>,
}

/// Where a condition stands: the modes around it, and the layer it is of. Without modes it is watched from outside.
struct Place<'p> {
    path: &'p [Id<Mode>],
    depth: usize,
    senses: Vec<u32>,
    flags: Vec<Id<Expr>>,
}

impl Place<'_> {
    /// Whether it is of the innermost layer.
    fn is_innermost(&self) -> bool {
        self.depth + 1 == self.path.len()
    }
}

impl<'a> Flattening<'a> {
    /// The mode of some layer, and the diagram that is of.
    fn layers(&self, path: &[Id<Mode>]) -> Vec<(Id<Diagram>, &'a Mode)> {
        let mut diagram = Some(self.outer);
        let layer = |&mode: &Id<Mode>| {
            let own = diagram?;
            let mode = &self.program.diagrams[own].modes[mode];
            diagram = mode.runs.map(|run| run.diagram);
            Some((own, mode))
        };
        path.iter().map_while(layer).collect()
    }

    /// The innermost modes that can become active when the last mode of a path is entered, the first of them if it is
    /// entered for the first time.
    fn enters(&mut self, path: Vec<Id<Mode>>) -> Option<Rc<Vec<Id<Mode>>>> {
        if let Some(known) = self.entered.get(&path) {
            return Some(Rc::clone(known));
        }
        let (mut fresh, mut resumed) = (path.clone(), None);
        while let Some(run) = self.layers(&fresh).last()?.1.runs {
            if run.resumes && resumed.is_none() {
                resumed = Some(fresh.clone());
            }
            fresh.push(self.program.diagrams[run.diagram].entry?);
        }
        let first = Id::new(self.paths.binary_search(&fresh).ok()? as u32);
        let is_beneath = |(leaf, path): &(Id<Mode>, &Vec<Id<Mode>>)| {
            *leaf != first && resumed.as_ref().is_some_and(|around| path.starts_with(around))
        };
        let others = self.paths.iter().enumerate().map(|(leaf, path)| (Id::new(leaf as u32), path)).filter(is_beneath);
        let entered = Rc::new(std::iter::once(first).chain(others.map(|(leaf, _)| leaf)).collect());
        self.entered.insert(path, Rc::clone(&entered));
        Some(entered)
    }

    /// A mode, and where its transitions come from.
    fn leaf(&mut self, path: &[Id<Mode>]) -> Option<(Mode, Vec<Origin>)> {
        let layers = self.layers(path);
        let (_, innermost) = *layers.last()?;
        let (mut transitions, mut from) = (Vec::new(), Vec::new());
        for (depth, &(diagram, mode)) in layers.iter().enumerate() {
            let place = self.place(path, depth, diagram)?;
            let inside = |target: Id<Mode>| [&path[..depth], &[target]].concat();
            if let Some(otherwise) = mode.otherwise.filter(|_| !mode.requires.is_empty()) {
                let failed = self.lacks_sensor(mode);
                let condition = self.entering(diagram, otherwise, failed);
                transitions.push(Self::exit(condition, *self.enters(inside(otherwise))?.first()?, mode.symbol.span));
                from.push((depth, None));
            }
            for (index, transition) in mode.transitions.iter().enumerate() {
                let condition = self.condition(&place, transition.condition)?;
                let condition = self.entering(diagram, transition.target?, condition);
                let targets = self.enters(inside(transition.target?))?;
                let (first, others) = targets.split_first()?;
                for other in others {
                    let open = self.truth(Op::Unknown, transition.span);
                    let both = self.truth(Op::And(vec![condition, open]), transition.span);
                    transitions.push(Self::exit(both, *other, transition.span));
                    from.push((depth, Some(index)));
                }
                transitions.push(Self::exit(condition, *first, transition.span));
                from.push((depth, Some(index)));
            }
        }
        for (transition, priority) in transitions.iter_mut().zip(1..) {
            transition.priority = priority;
        }
        let mut symbol = innermost.symbol.clone();
        symbol.name = layers.iter().map(|(_, mode)| mode.symbol.name.as_str()).collect::<Vec<_>>().join(".");
        let requires = innermost.requires.iter().map(|(sensor, span)| (self.sensor(*sensor), *span)).collect();
        let incomplete = layers.iter().any(|(_, mode)| mode.incomplete);
        Some((Mode { symbol, requires, otherwise: None, transitions, incomplete, ..innermost.clone() }, from))
    }

    /// A condition on which a mode is entered, which one that runs a diagram and lacks a sensor is not. Of innermost modes
    /// the flat ones say what they require.
    fn entering(&mut self, diagram: Id<Diagram>, target: Id<Mode>, condition: Id<Expr>) -> Id<Expr> {
        let program = self.program;
        let mode = &program.diagrams[diagram].modes[target];
        if mode.runs.is_none() || mode.requires.is_empty() {
            return condition;
        }
        let span = self.flat.exprs[condition].span;
        let lacks = self.lacks_sensor(mode);
        let has = self.truth(Op::Not(lacks), span);
        self.truth(Op::And(vec![condition, has]), span)
    }

    /// Whether some sensor that a mode requires has failed.
    fn lacks_sensor(&mut self, mode: &Mode) -> Id<Expr> {
        let failed: Vec<_> = mode.requires.iter().map(|(sensor, span)| (self.sensor(*sensor), *span)).collect();
        let failed = failed.into_iter().map(|(sensor, span)| self.truth(Op::Failed(sensor), span)).collect();
        self.truth(Op::Or(failed), mode.symbol.span)
    }

    fn exit(condition: Id<Expr>, target: Id<Mode>, span: Span) -> Transition {
        Transition { priority: 0, priority_span: span, condition, target: Some(target), again: false, span }
    }

    fn truth(&mut self, op: Op, span: Span) -> Id<Expr> {
        self.flat.exprs.add(Expr { op, ty: Type::Bool, span })
    }

    /// Always true, or never.
    fn constant(&mut self, value: bool, span: Span) -> Id<Expr> {
        self.truth(if value { Op::And(Vec::new()) } else { Op::Or(Vec::new()) }, span)
    }

    /// The sensor of the outermost diagram's platform that an inner one means.
    fn sensor(&self, sensor: Id<Sensor>) -> Id<Sensor> {
        let program = self.program;
        let name = &program.sensors[sensor].symbol.name;
        let mut own = program.sensors_of(program.diagrams[self.outer].platform).into_iter();
        own.find(|own| *own == sensor || program.sensors[*own].symbol.name == *name).unwrap_or(sensor)
    }

    fn place<'p>(&mut self, path: &'p [Id<Mode>], depth: usize, diagram: Id<Diagram>) -> Option<Place<'p>> {
        let of = &self.program.diagrams[diagram];
        let senses = of.senses.iter().map(|sense| {
            let inputs: Vec<_> = sense.inputs.iter().map(|sensor| self.sensor(*sensor)).collect();
            let same = |known: &Sense| known.network == sense.network && known.inputs == inputs;
            let known = self.senses.iter().position(same);
            known.unwrap_or_else(|| {
                self.senses.push(Sense { inputs, ..sense.clone() });
                self.senses.len() - 1
            }) as u32
        });
        let senses = senses.collect();
        let mut place = Place { path, depth, senses, flags: Vec::with_capacity(of.flags.len()) };
        for flag in of.flags.values() {
            let condition = self.condition(&place, flag.condition)?;
            place.flags.push(condition);
        }
        Some(place)
    }

    fn watched(&mut self, condition: Id<Expr>) -> Option<Id<Expr>> {
        let place = self.place(&[], 0, self.outer)?;
        self.condition(&place, condition)
    }

    /// A condition as it stands in some place.
    fn condition(&mut self, place: &Place<'_>, root: Id<Expr>) -> Option<Id<Expr>> {
        let mut known: HashMap<Id<Expr>, Id<Expr>> = HashMap::new();
        for id in parts(self.program, root) {
            let expr = &self.program.exprs[id];
            let span = expr.span;
            let counts = |of: &Id<Expr>| matches!(self.program.exprs[*of].op, Op::Count(_));
            let of = |of: &Id<Expr>| known.get(of).copied();
            let all = |ids: &[Id<Expr>]| ids.iter().map(of).collect::<Option<Vec<_>>>();
            let here = place.path.get(place.depth..).unwrap_or_default();
            let op = match &expr.op {
                Op::Flag(flag) => {
                    known.insert(id, *place.flags.get(flag.index())?);
                    continue;
                }
                Op::Sensor(sensor) => Op::Sensor(self.sensor(*sensor)),
                Op::Failed(sensor) => Op::Failed(self.sensor(*sensor)),
                Op::Event { sense, event } => Op::Event { sense: *place.senses.get(*sense as usize)?, event: *event },
                Op::InMode(mode) => Op::Or(self.within(&[*mode], span)),
                Op::Inside(path) if place.path.is_empty() => Op::Or(self.within(path, span)),
                Op::Inside(path) => {
                    known.insert(id, self.constant(here.starts_with(path), span));
                    continue;
                }
                Op::After(duration) if !place.is_innermost() => {
                    Op::Or(vec![self.truth(Op::After(*duration), span), self.truth(Op::Unknown, span)])
                }
                Op::Done if place.path.is_empty() => Op::Unknown,
                Op::Done if !place.is_innermost() => {
                    let inner = self.layers(place.path).get(place.depth + 1).is_some_and(|(_, mode)| mode.is_final);
                    known.insert(id, self.constant(inner, span));
                    continue;
                }
                Op::Compare(_, left, right) if !place.is_innermost() && (counts(left) || counts(right)) => Op::Unknown,
                Op::Latched(latched) if !place.is_innermost() => {
                    Op::Or(vec![of(latched)?, self.truth(Op::Unknown, span)])
                }
                Op::Latched(latched) => Op::Latched(of(latched)?),
                Op::Count(counted) => Op::Count(of(counted)?),
                Op::Rising(looked) => Op::Rising(of(looked)?),
                Op::Falling(looked) => Op::Falling(of(looked)?),
                Op::Held(looked, duration) => Op::Held(of(looked)?, *duration),
                Op::Compare(comparison, left, right) => Op::Compare(*comparison, of(left)?, of(right)?),
                Op::Not(negated) => Op::Not(of(negated)?),
                Op::And(ids) => Op::And(all(ids)?),
                Op::Or(ids) => Op::Or(all(ids)?),
                Op::Number(number) => Op::Number(*number),
                Op::Error | Op::Unknown | Op::After(_) | Op::Done => expr.op.clone(),
            };
            let mapped = self.flat.exprs.add(Expr { op, ..expr.clone() });
            known.insert(id, mapped);
        }
        known.get(&root).copied()
    }

    /// The innermost modes within a path.
    fn within(&mut self, path: &[Id<Mode>], span: Span) -> Vec<Id<Expr>> {
        let paths = self.paths.iter().enumerate();
        let within = paths.filter(|(_, leaf)| leaf.starts_with(path)).map(|(leaf, _)| Id::new(leaf as u32));
        within.map(|leaf| self.truth(Op::InMode(leaf), span)).collect()
    }
}
