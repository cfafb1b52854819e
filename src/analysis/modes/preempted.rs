//! Transitions of inner layers that an outer layer always forestalls.

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use super::dwell::{Moment, Stay, Way};
use super::examined::{Examined, examine};
use super::flat::{Flat, Leaf, flatten};
use super::formula::{Atom, Formula, Operand};
use super::fusion::Fusion;
use super::ticks::Scene;
use crate::base::{Exact, Id, Span};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode, Program, Sensor};

/// What is known of diagrams and of the diagrams that their modes run, each looked at once.
pub(in crate::analysis) struct Layers<'a> {
    program: &'a Program,
    fusion: Rc<Fusion>,
    alone: HashMap<Id<Diagram>, Rc<Alone>>,
    flats: HashMap<Id<Diagram>, Option<Rc<Flat>>>,
    taken: HashMap<Place, Option<Rc<Taken>>>,
}

/// An innermost mode of a diagram, by the modes around it and itself.
type Place = (Id<Diagram>, Vec<Id<Mode>>);

/// What can happen in each mode of a diagram where nothing runs around it; `None` where there is too much to look into.
type Alone = Vec<Option<Rc<Stay>>>;

/// The transitions of an innermost mode that are taken, by layer and position.
type Taken = BTreeSet<(usize, usize)>;

impl<'a> Layers<'a> {
    pub(in crate::analysis) fn new(program: &'a Program) -> Self {
        let (alone, flats, taken) = Default::default();
        Self { program, fusion: Rc::default(), alone, flats, taken }
    }

    /// A diagram to look at by itself.
    pub(in crate::analysis) fn scene(&self, diagram: Id<Diagram>) -> Scene<'a> {
        Scene::sharing(self.program, &self.program.diagrams[diagram], &self.fusion)
    }

    /// Notes what was found of a diagram by itself.
    pub(in crate::analysis) fn note(&mut self, diagram: Id<Diagram>, examined: &[Option<Examined>]) {
        let stays = examined.iter().map(|examined| Some(Rc::clone(&examined.as_ref()?.stay)));
        self.alone.insert(diagram, Rc::new(stays.collect()));
    }

    fn alone(&mut self, diagram: Id<Diagram>) -> Rc<Alone> {
        if !self.alone.contains_key(&diagram) {
            let scene = self.scene(diagram);
            let examined: Vec<_> = scene.diagram.modes.values().map(|mode| examine(&scene, mode)).collect();
            self.note(diagram, &examined);
        }
        Rc::clone(&self.alone[&diagram])
    }

    /// Warns of transitions inside the modes of a diagram that are taken where the inner diagram runs by itself, and
    /// never here: whenever they could be, the diagram leaves the mode around them. Costs the sum of the layers where
    /// what shows a transition by itself shows it here too.
    pub(in crate::analysis) fn check(&mut self, id: Id<Diagram>, findings: &mut Vec<Diagnostic>) {
        let diagram = &self.program.diagrams[id];
        let mut open = self.open(id);
        let Some(flat) = (!open.is_empty()).then(|| self.flat(id)).flatten() else { return };
        let scene = Scene::sharing(&flat.program, &flat.program.diagrams[flat.diagram], &self.fusion);
        let mut dead = BTreeSet::new();
        for (leaf, mode) in flat.leaves.iter().zip(scene.diagram.modes.values()) {
            let Some((&outer, inner)) = leaf.path.split_first() else { continue };
            let Some(run) = diagram.modes[outer].runs else { continue };
            let inner_exits = leaf.exits.iter().zip(&mode.transitions).filter(|((depth, _), _)| *depth > 0);
            let asked: Vec<_> = inner_exits.filter(|(_, exit)| open.contains(&(outer, exit.span))).collect();
            let Some(here) = (!asked.is_empty()).then(|| self.taken_in(&scene, id, leaf, mode)) else { continue };
            for (&(depth, index), exit) in asked {
                let is_in = |taken: &Taken, depth| index.is_some_and(|index| taken.contains(&(depth, index)));
                if here.as_ref().is_none_or(|here| is_in(here, depth)) {
                    open.remove(&(outer, exit.span));
                } else if self.taken(run.diagram, inner).is_some_and(|before| is_in(&before, depth - 1)) {
                    dead.insert((outer, exit.span));
                }
            }
        }
        for (mode, transition) in dead.intersection(&open) {
            findings.extend(preempted(self.program, diagram, *mode, *transition));
        }
    }

    /// The transitions inside the modes of a diagram that are taken by themselves, each with the mode around it, but for
    /// those that are taken here on the same ticks.
    fn open(&mut self, id: Id<Diagram>) -> BTreeSet<(Id<Mode>, Span)> {
        let program = self.program;
        let (mut all, mut shown): (BTreeSet<_>, BTreeSet<_>) = Default::default();
        for outer in program.diagrams[id].modes.ids() {
            let mut waiting: Vec<(Id<Diagram>, Id<Mode>, Vec<Around>)> = vec![(id, outer, Vec::new())];
            while let Some((diagram, mode, mut around)) = waiting.pop() {
                let diagram = &program.diagrams[diagram];
                let Mode { transitions, is_final, runs: Some(run), .. } = &diagram.modes[mode] else { continue };
                let Some(conditions) = Formula::new(program, diagram, transitions) else { continue };
                around.push(Around { mode, is_final: *is_final, conditions: Rc::new(conditions) });
                let alone = self.alone(run.diagram);
                for ((id, mode), stay) in program.diagrams[run.diagram].modes.iter().zip(alone.iter()) {
                    let exits = mode.transitions.iter().zip(stay.iter().flat_map(|stay| &stay.exits));
                    for (exit, way) in exits.filter_map(|(exit, known)| Some((exit, known.taken.as_ref()?))) {
                        all.insert((outer, exit.span));
                        if is_let_be(program, &around, (id, mode), way) {
                            shown.insert((outer, exit.span));
                        }
                    }
                    waiting.push((run.diagram, id, around.clone()));
                }
            }
        }
        &all - &shown
    }

    fn flat(&mut self, diagram: Id<Diagram>) -> Option<Rc<Flat>> {
        let program = self.program;
        self.flats.entry(diagram).or_insert_with(|| flatten(program, diagram, &[]).map(Rc::new)).clone()
    }

    /// The transitions that are taken in an innermost mode of a diagram; `None` where there is too much to look into.
    fn taken(&mut self, diagram: Id<Diagram>, path: &[Id<Mode>]) -> Option<Rc<Taken>> {
        if let [mode] = path {
            let alone = self.alone(diagram);
            let exits = alone[mode.index()].as_ref()?.exits.iter().enumerate();
            return Some(Rc::new(
                exits.filter(|(_, exit)| exit.taken.is_some()).map(|(index, _)| (0, index)).collect(),
            ));
        }
        if let Some(known) = self.taken.get(&(diagram, path.to_vec())) {
            return known.clone();
        }
        let flat = self.flat(diagram)?;
        let scene = Scene::sharing(&flat.program, &flat.program.diagrams[flat.diagram], &self.fusion);
        let leaves = flat.leaves.iter().zip(scene.diagram.modes.values());
        let (leaf, mode) = leaves.into_iter().find(|(leaf, _)| leaf.path == path)?;
        self.taken_in(&scene, diagram, leaf, mode)
    }

    fn taken_in(&mut self, scene: &Scene<'_>, diagram: Id<Diagram>, leaf: &Leaf, mode: &Mode) -> Option<Rc<Taken>> {
        let taken = || {
            let examined = examine(scene, mode)?;
            let exits = leaf.exits.iter().zip(&examined.stay.exits).filter(|(_, exit)| exit.taken.is_some());
            Some(Rc::new(exits.filter_map(|((depth, index), _)| Some((*depth, (*index)?))).collect()))
        };
        self.taken.entry((diagram, leaf.path.clone())).or_insert_with(taken).clone()
    }
}

/// A mode around others, with the conditions on which it is left.
#[derive(Clone)]
struct Around {
    mode: Id<Mode>,
    is_final: bool,
    conditions: Rc<Formula>,
}

/// Whether what shows a transition of a mode by itself leaves the modes around it, from the outermost on, be.
fn is_let_be(program: &Program, around: &[Around], (id, mode): (Id<Mode>, &Mode), way: &Way) -> bool {
    let Way::Shown(moments) = way else { return false };
    let path: Vec<_> = around.iter().map(|around| around.mode).chain([id]).collect();
    around.iter().enumerate().all(|(depth, Around { conditions, .. })| {
        let is_done = around.get(depth + 1).map_or(mode.is_final, |inner| inner.is_final);
        moments.iter().all(|moment| holds_none(program, conditions, &path[depth..], is_done, moment))
    })
}

/// Whether no condition on which a mode is left holds at a moment inside, nothing having failed, where that is known: what
/// it remembers may be anything. `path` leads inward from the mode, as far as it is known.
fn holds_none(program: &Program, conditions: &Formula, path: &[Id<Mode>], is_done: bool, moment: &Moment) -> bool {
    // A diagram on an interface names the sensors of the robot as its own.
    let name = |sensor: Id<Sensor>| &program.sensors[sensor].symbol.name;
    let read = |sensor: Id<Sensor>| {
        let mut readings = moment.readings.iter();
        readings.find(|(read, _)| *read == sensor || name(*read) == name(sensor)).map(|(_, at)| *at)
    };
    let values = conditions.known(|atom, values| match &conditions.atoms[atom] {
        Atom::Compare(comparison, left, Operand::Number(right)) => Some(comparison.holds(read(*left)?, *right)),
        Atom::Compare(comparison, left, Operand::Sensor(right)) => Some(comparison.holds(read(*left)?, read(*right)?)),
        Atom::Failed(_) => Some(false),
        Atom::After(duration) => Some(*duration <= moment.dwell),
        Atom::Past(past, of) => {
            let may_be = |now: &bool| values[*of].is_none_or(|value| value == *now);
            [false, true].iter().filter(|now| may_be(now)).all(|now| past.allows(false, *now)).then_some(false)
        }
        Atom::Count(comparison, _, number) => Some(comparison.holds(Exact::ZERO, *number)),
        Atom::Inside(inside) => {
            let is_along = inside.iter().zip(path).all(|(step, mode)| step == mode);
            if is_along { (inside.len() <= path.len()).then_some(true) } else { Some(false) }
        }
        Atom::Done => Some(is_done),
        _ => None,
    });
    conditions.roots.iter().all(|root| values[*root] == Some(false))
}

fn preempted(program: &Program, diagram: &Diagram, mode: Id<Mode>, transition: Span) -> Option<Diagnostic> {
    let mode = &diagram.modes[mode];
    let run = mode.runs?;
    let (outer, inner) = (&diagram.symbol.name, &program.diagrams[run.diagram].symbol.name);
    let message =
        format!("a transition within `{inner}` is never taken here: `{outer}` leaves `{}` first", mode.symbol.name);
    Some(
        Diagnostic::new(&rules::PREEMPTED, run.span, message)
            .label(transition, "never taken here, though it is where nothing runs around it")
            .note("on every tick outer layers choose before inner ones")
            .help("let the outer transition wait for something that leaves room, or leave the inner one out"),
    )
}
