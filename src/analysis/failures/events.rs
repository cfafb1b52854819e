//! Events that some failed sensors take away, though other sensors have a say in them.

use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use super::looks::View;
use super::single_point::single_point;
use super::stuck_event::stuck_event;
use super::words::Failed;
use crate::analysis::modes::Fault as How;
use crate::analysis::network::{Fault, FaultSet, Feed, Model};
use crate::analysis::{Source, source};
use crate::base::{Exact, Id, Span};
use crate::diag::Diagnostic;
use crate::ir::{self, Diagram, FailReading, Network, Program, Sense};

/// An event with the sets of failed sensors that take away what was asked for. None of them needs all the sensors that
/// the rules of the event name, and none holds another one.
pub(super) struct LostEvent<'a> {
    pub(super) event: &'a ir::Event,
    /// The condition that asks for it; none for an event of a network on its own.
    pub(super) asked: Option<Span>,
    pub(super) sets: Vec<Vec<Failed<'a>>>,
}

/// Whether an event can still do something under some failures.
type Ability = fn(&Model, usize, &FaultSet) -> bool;
type Message = fn(&LostEvent<'_>) -> Diagnostic;

/// What failures take from the events of networks, each looked at once over the same sensors.
#[derive(Default)]
pub(in crate::analysis) struct Losses {
    known: HashMap<Source, Rc<Vec<Lost>>>,
}

/// For each of `LOSSES` the smallest sets of failures that take it from an event.
type Lost = [Vec<FaultSet>; LOSSES.len()];

impl Losses {
    /// For each event of a sensed network what at most `up_to` failures take away, but do not from the network on its own.
    fn of(&mut self, program: &Program, sense: &Sense, up_to: usize) -> Rc<Vec<Lost>> {
        Rc::clone(self.known.entry(source(sense)).or_insert_with(|| Rc::new(lost(program, sense, up_to))))
    }
}

fn lost(program: &Program, sense: &Sense, up_to: usize) -> Vec<Lost> {
    let network = &program.networks[sense.network];
    let inputs = sense.inputs.iter().zip(&network.inputs);
    let feeds: Vec<_> = inputs.map(|(sensor, input)| feed(program, *sensor, Some(input.variable))).collect();
    let Some(model) = Model::fed_by(program, network, &feeds) else { return Vec::new() };
    let fails_alone = network.inputs.iter().any(|input| !program.variables[input.variable].fails.is_empty());
    let alone = fails_alone.then(|| Model::new(program, sense.network)).flatten();
    let of_event = |(index, event): (usize, &ir::Event)| {
        LOSSES.map(|(ability, _)| {
            let of = |model| minimal(model, event, index, up_to, ability);
            let told_there = alone.as_ref().map_or_else(Vec::new, of);
            of(&model).into_iter().filter(|set| !told_there.contains(set)).collect()
        })
    };
    network.events.iter().enumerate().map(of_event).collect()
}

/// What can be lost of an event, and how it is told.
const LOSSES: [(Ability, Message); 2] = [(Model::can_set, single_point), (Model::can_clear, stuck_event)];

/// What a sensor can read, and how it fails, or the variable that it feeds.
pub(in crate::analysis) fn feed(program: &Program, sensor: Id<ir::Sensor>, variable: Option<Id<ir::Variable>>) -> Feed {
    let sensor = &program.sensors[sensor];
    let of_variable = variable.map(|variable| &program.variables[variable].fails);
    let fails = of_variable.filter(|_| sensor.fails.is_empty()).unwrap_or(&sensor.fails);
    Feed { range: sensor.range, fails: fails.clone() }
}

/// Looks at the events of a sensed network that the diagram's own modes ask for, without what is true of the network on
/// its own.
pub(super) fn check_sense(
    (program, diagram, views): (&Program, &Diagram, &[View]),
    (position, sense): (u32, &Sense),
    (losses, up_to): (&mut Losses, usize),
    findings: &mut Vec<Diagnostic>,
) {
    let network = &program.networks[sense.network];
    // A mode with the first condition that asks for an event.
    let asks = |event| {
        let own = diagram.modes.values().zip(views).filter(|(mode, _)| !mode.inherited);
        own.filter_map(move |(mode, view)| {
            let exit = view.exits.iter().position(|looks| looks.events.contains(&(position, event)))?;
            Some((view, program.exprs[mode.transitions[exit].condition].span))
        })
    };
    let asked: Vec<_> = (0..).zip(&network.events).filter(|(event, _)| asks(*event).next().is_some()).collect();
    if asked.is_empty() {
        return;
    }
    let losses = losses.of(program, sense, up_to);
    let failed = |fault: &Fault| {
        let ir::Sensor { symbol, unit, range, .. } = &program.sensors[sense.inputs[fault.input]];
        Failed { name: &symbol.name, unit, range: *range, how: how(fault.reading, *range) }
    };
    for (index, event) in asked {
        // A mode that says what to do about the failure does not count.
        let unanswered = |set: &FaultSet| {
            let is_answered = |view: &View| set.iter().any(|fault| view.answers.contains(&sense.inputs[fault.input]));
            asks(index).find(|(view, _)| !is_answered(view)).map(|(_, span)| span)
        };
        for (sets, (_, told)) in losses.get(index as usize).into_iter().flatten().zip(LOSSES) {
            let lost: Vec<_> = sets.iter().filter_map(|set| Some((unanswered(set)?, set))).collect();
            let Some(&(asked, _)) = lost.first() else { continue };
            let sets = lost.iter().map(|(_, set)| set.iter().map(failed).collect()).collect();
            findings.push(told(&LostEvent { event, asked: Some(asked), sets }));
        }
    }
}

/// Looks at the events of a network on its own, whose inputs fail as their variables say.
pub(in crate::analysis) fn check_network(
    program: &Program,
    id: Id<Network>,
    up_to: usize,
    findings: &mut Vec<Diagnostic>,
) {
    let network = &program.networks[id];
    let Some(model) = Model::new(program, id) else { return };
    let failed = |fault: &Fault| {
        let input = &network.inputs[fault.input];
        let ir::Variable { unit, range, .. } = &program.variables[input.variable];
        Failed { name: &input.symbol.name, unit, range: *range, how: how(fault.reading, *range) }
    };
    for (index, event) in network.events.iter().enumerate() {
        for (ability, told) in LOSSES {
            let sets = minimal(&model, event, index, up_to, ability);
            let sets: Vec<_> = sets.iter().map(|set| set.iter().map(failed).collect()).collect();
            if !sets.is_empty() {
                findings.push(told(&LostEvent { event, asked: None, sets }));
            }
        }
    }
}

/// The smallest sets of failures that take an ability from an event, of those that leave some input that the rules
/// name.
fn minimal(model: &Model, event: &ir::Event, index: usize, up_to: usize, ability: Ability) -> Vec<FaultSet> {
    let named = named_inputs(event);
    let mut minimal: Vec<FaultSet> = Vec::new();
    if named.len() < 2 || !ability(model, index, &FaultSet::new()) {
        return minimal;
    }
    // What no rule names does not matter, and stuck anywhere an input can be what it could be.
    let matters = |set: &FaultSet| {
        let all = set.iter().all(|fault| named.contains(&fault.input) && fault.reading != FailReading::Any);
        all && set.len() < named.len()
    };
    for set in model.fault_sets(up_to).into_iter().skip(1).filter(matters) {
        let holds_one = minimal.iter().any(|known| known.iter().all(|fault| set.contains(fault)));
        if !holds_one && !ability(model, index, &set) {
            minimal.push(set);
        }
    }
    minimal
}

/// The inputs that the rules of an event name.
pub(in crate::analysis) fn named_inputs(event: &ir::Event) -> BTreeSet<usize> {
    let rules = event.contributor.iter().chain(&event.detractor);
    rules.flat_map(|rule| &rule.clauses).map(|clause| clause.input as usize).collect()
}

/// How a sensor with such readings has failed.
pub(in crate::analysis) fn how(reading: FailReading, range: (Exact, Exact)) -> How {
    match reading {
        FailReading::Value(at) => How::Stuck(at),
        FailReading::Any => How::Between(range.0, range.1),
        FailReading::Absent => How::Absent,
    }
}
