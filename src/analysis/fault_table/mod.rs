//! The fault table: what the events and modes of a machine can still do under every set of failed sensors.

mod event_words;
mod mode_words;
mod summary;

use std::collections::BTreeSet;

use super::failures::{self, View, feed, how};
use super::modes::{self, Facts};
use super::network::{self, Fault, FaultSet, Feed, Model, NetworkFacts, SingleRule, Witness};
use crate::base::{FileId, Id, Unit};
use crate::ir::{self, FailReading, Program};

/// One row for each set of failed sensors: none first, smaller sets before larger ones.
#[derive(Debug, Clone, PartialEq)]
pub struct FaultTable {
    /// The rows.
    pub rows: Vec<FaultRow>,
    /// What they say, in sentences. Names stand in backticks.
    pub summary: Vec<String>,
}

/// What is left under one set of failed sensors.
#[derive(Debug, Clone, PartialEq)]
pub struct FaultRow {
    /// The failed sensors, or inputs of a network on its own.
    pub failed: Vec<Failed>,
    /// Every event of every sensed network.
    pub events: Vec<EventRow>,
    /// The events of a network that some readings set together; qualified where there are several networks.
    pub valuations: Vec<Vec<String>>,
    /// What is left of every behavior.
    pub modes: Vec<ModesRow>,
}

/// What is left of a behavior. Its modes are in source order.
#[derive(Debug, Clone, PartialEq)]
pub struct ModesRow {
    /// The behavior's name.
    pub diagram: String,
    /// Modes the machine can be in, whether it knows of the failures or not, and since whenever they are there; the
    /// others are proved out of reach.
    pub reachable: Vec<String>,
    /// The others.
    pub unreachable: Vec<String>,
    /// Modes the machine can reach and never leaves while the sensors stay failed, alone or among each other.
    pub traps: Vec<String>,
    /// Modes that require a failed sensor: they are not entered while it is known to have failed.
    pub inhibited: Vec<String>,
}

/// A failed sensor.
#[derive(Debug, Clone, PartialEq)]
pub struct Failed {
    /// Its name.
    pub sensor: String,
    /// How to show its numbers.
    pub unit: Unit,
    /// What it reads, in SI.
    pub reading: FailReading,
}

/// What an event can still do. Its memory, if it has one, lags behind.
#[derive(Debug, Clone, PartialEq)]
pub struct EventRow {
    /// `network.event`.
    pub name: String,
    /// Some readings set it.
    pub can_set: bool,
    /// Some readings leave it clear.
    pub can_clear: bool,
    /// Its rules in single terms; `None` where they stand for too many to list.
    pub rules: Option<RuleRows>,
    /// Readings in SI that set it, by sensor.
    pub witness_set: Option<Vec<(String, f64)>>,
}

/// The rules of an event that failures leave.
#[derive(Debug, Clone, PartialEq)]
pub struct RuleRows {
    /// The rules for it that can still be above 0: a word for each input of the network, sorted.
    pub contributor: Vec<Vec<String>>,
    /// The rules against it that can still be above 0.
    pub detractor: Vec<Vec<String>>,
    /// How many rules for it, and against it, are always 0.
    pub masked: (usize, usize),
}

/// The fault table of the behaviors of some files, or of their networks where they have no behavior, for every set of
/// at most `up_to` failed sensors.
pub fn fault_table(program: &Program, files: &[FileId], up_to: usize) -> FaultTable {
    let group = Group::of(program, files);
    let models: Vec<_> = group.senses.iter().filter_map(|sense| Sensed::new(program, &group, sense, up_to)).collect();
    let fails = group.sensors.iter().map(|sensor| sensor.feed.fails.as_slice());
    let diagrams: Vec<_> = group.diagrams.iter().map(|&id| (id, modes::fault_table(program, id, up_to))).collect();
    let rows = network::fault_sets(fails, up_to).into_iter().map(|faults| {
        let modes = diagrams.iter().map(|(id, facts)| modes_row(program, &group, *id, facts, &faults)).collect();
        FaultRow { modes, ..row(program, &group, &models, &faults) }
    });
    FaultTable { rows: rows.collect(), summary: summary::summary(program, &group, &models, up_to) }
}

/// The sensors that can fail, and the networks they feed.
struct Group {
    sensors: Vec<Source>,
    senses: Vec<Sense>,
    diagrams: Vec<Id<ir::Diagram>>,
}

struct Source {
    /// `None` for an input of a network on its own.
    sensor: Option<Id<ir::Sensor>>,
    name: String,
    unit: Unit,
    feed: Feed,
}

/// A network and the positions of the sensors that feed its inputs.
struct Sense {
    name: String,
    network: Id<ir::Network>,
    inputs: Vec<usize>,
}

impl Group {
    fn of(program: &Program, files: &[FileId]) -> Self {
        let is_asked = |symbol: &ir::Symbol| files.contains(&symbol.span.file);
        let diagrams = program.diagrams.iter().filter(|(_, of)| is_asked(&of.symbol) && of.arbiter.is_none());
        let diagrams = diagrams.map(|(id, _)| id);
        let mut group = Self { sensors: Vec::new(), senses: Vec::new(), diagrams: diagrams.collect() };
        let diagrams: Vec<_> = group.diagrams.iter().map(|&id| &program.diagrams[id]).collect();
        let mut known = Vec::new();
        for sense in diagrams.iter().flat_map(|diagram| &diagram.senses) {
            let inputs = sense.inputs.iter().zip(&program.networks[sense.network].inputs);
            let inputs = inputs.map(|(&sensor, input)| {
                known.iter().position(|&known| known == sensor).unwrap_or_else(|| {
                    known.push(sensor);
                    group.sensors.push(Source::of_sensor(program, sensor, Some(input.variable)));
                    known.len() - 1
                })
            });
            let inputs = inputs.collect();
            group.add(Sense { name: sense.symbol.name.clone(), network: sense.network, inputs });
        }
        for diagram in &diagrams {
            for sensor in
                looked_at(program, diagram).into_iter().filter(|sensor| !known.contains(sensor)).collect::<Vec<_>>()
            {
                known.push(sensor);
                group.sensors.push(Source::of_sensor(program, sensor, None));
            }
        }
        if diagrams.is_empty() {
            for (id, network) in program.networks.iter().filter(|(_, network)| is_asked(&network.symbol)) {
                let first = group.sensors.len();
                group.sensors.extend(network.inputs.iter().map(|input| Source::of_input(program, input)));
                let inputs = (first..group.sensors.len()).collect();
                group.add(Sense { name: network.symbol.name.clone(), network: id, inputs });
            }
        }
        group
    }

    /// A failed input of a sensed network as it is told.
    fn failed(&self, sensed: &Sensed<'_>, fault: &Fault) -> failures::Failed<'_> {
        let Source { name, unit, feed, .. } = &self.sensors[sensed.inputs[fault.input]];
        failures::Failed { name, unit, range: feed.range, how: how(fault.reading, feed.range) }
    }

    /// Adds a sensed network, once for all behaviors that sense it alike.
    fn add(&mut self, sense: Sense) {
        let is_same = |known: &Sense| known.network == sense.network && known.inputs == sense.inputs;
        if !self.senses.iter().any(is_same) {
            self.senses.push(sense);
        }
    }
}

/// The sensors that the modes of a diagram compare, or whose failure they ask for.
fn looked_at(program: &Program, diagram: &ir::Diagram) -> BTreeSet<Id<ir::Sensor>> {
    let views = View::of_modes(program, diagram).into_iter();
    let sensors = views.flat_map(|view| view.exits.into_iter().flat_map(|looks| looks.compared).chain(view.answers));
    sensors.filter(|&sensor| !program.sensors[sensor].is_inner()).collect()
}

impl Source {
    fn of_sensor(program: &Program, id: Id<ir::Sensor>, variable: Option<Id<ir::Variable>>) -> Self {
        let ir::Sensor { symbol, unit, .. } = &program.sensors[id];
        Self { sensor: Some(id), name: symbol.name.clone(), unit: unit.clone(), feed: feed(program, id, variable) }
    }

    fn of_input(program: &Program, input: &ir::NetworkInput) -> Self {
        let variable = &program.variables[input.variable];
        let feed = Feed { range: variable.range, fails: variable.fails.clone() };
        Self { sensor: None, name: input.symbol.name.clone(), unit: variable.unit.clone(), feed }
    }
}

/// A sensed network with everything that is known of it.
struct Sensed<'a> {
    name: &'a str,
    inputs: &'a [usize],
    network: &'a ir::Network,
    model: Model,
    facts: Vec<NetworkFacts>,
}

impl<'a> Sensed<'a> {
    fn new(program: &'a Program, group: &Group, sense: &'a Sense, up_to: usize) -> Option<Self> {
        let feeds: Vec<_> = sense.inputs.iter().map(|&sensor| group.sensors[sensor].feed.clone()).collect();
        let network = &program.networks[sense.network];
        let model = Model::fed_by(program, &program.networks[sense.network], &feeds)?;
        let facts = model.facts(up_to);
        Some(Self { name: &sense.name, inputs: &sense.inputs, network, model, facts })
    }

    /// The failures of a row as this network sees them.
    fn faults(&self, faults: &FaultSet) -> FaultSet {
        let own = self.inputs.iter().enumerate().filter_map(|(input, sensor)| {
            let fault = faults.iter().find(|fault| fault.input == *sensor)?;
            Some(Fault { input, reading: fault.reading })
        });
        own.collect()
    }
}

fn row(program: &Program, group: &Group, models: &[Sensed<'_>], faults: &FaultSet) -> FaultRow {
    let failed = faults.iter().map(|fault| {
        let Source { name, unit, .. } = &group.sensors[fault.input];
        Failed { sensor: name.clone(), unit: unit.clone(), reading: fault.reading }
    });
    let mut row = FaultRow { failed: failed.collect(), events: Vec::new(), valuations: Vec::new(), modes: Vec::new() };
    for sensed in models {
        let own = sensed.faults(faults);
        let Some(facts) = sensed.facts.iter().find(|facts| facts.faults == own) else { continue };
        for (index, event) in sensed.network.events.iter().enumerate() {
            let words = |rules: &[SingleRule]| {
                let mut words: Vec<_> = rules.iter().map(|rule| in_words(program, sensed.network, rule)).collect();
                words.sort();
                words
            };
            let all = sensed.model.written_out(index);
            let rules = sensed.model.survivors(index, &own).zip(all).map(|(left, all)| RuleRows {
                contributor: words(&left.contributor),
                detractor: words(&left.detractor),
                masked: (all.contributor.len() - left.contributor.len(), all.detractor.len() - left.detractor.len()),
            });
            let of = &facts.events[index];
            row.events.push(EventRow {
                name: format!("{}.{}", sensed.name, event.symbol.name),
                can_set: of.set.is_possible(),
                can_clear: of.clear.is_possible(),
                rules,
                witness_set: of.set.witness().map(|witness| readings(group, sensed, &own, witness)),
            });
        }
        for valuation in sensed.model.valuations(facts) {
            let set = sensed.network.events.iter().zip(valuation.set).filter(|(_, set)| *set);
            let name = |event: &ir::Event| match models {
                [_] => event.symbol.name.clone(),
                _ => format!("{}.{}", sensed.name, event.symbol.name),
            };
            row.valuations.push(set.map(|(event, _)| name(event)).collect());
        }
    }
    row.valuations.sort_by(|one, other| (other.len(), one).cmp(&(one.len(), other)));
    row
}

fn modes_row(program: &Program, group: &Group, id: Id<ir::Diagram>, facts: &[Facts], faults: &FaultSet) -> ModesRow {
    let diagram = &program.diagrams[id];
    let failed: Vec<_> =
        faults.iter().filter_map(|fault| Some((group.sensors[fault.input].sensor?, fault.reading))).collect();
    // Sensors that no condition of the diagram looks at are in none of its sets.
    let is_known = |sensor| facts.iter().any(|facts| facts.faults.iter().any(|(known, _)| *known == sensor));
    let wanted: Vec<_> = failed.iter().copied().filter(|(sensor, _)| is_known(*sensor)).collect();
    // A failure may be known or not.
    let is_it = |(sensor, reading): &(Id<ir::Sensor>, FailReading), (other, fault): &(Id<ir::Sensor>, modes::Fault)| {
        sensor == other
            && match fault {
                modes::Fault::Reported => true,
                modes::Fault::Stuck(at) => [FailReading::Any, FailReading::Value(*at)].contains(reading),
                modes::Fault::Between(..) => *reading == FailReading::Any,
                modes::Fault::Absent => *reading == FailReading::Absent,
            }
    };
    // A sensor stuck anywhere is one set for each stretch of readings that makes a difference.
    let rows: Vec<_> = facts
        .iter()
        .filter(|facts| facts.faults.len() == wanted.len())
        .filter(|facts| wanted.iter().all(|wanted| facts.faults.iter().any(|fault| is_it(wanted, fault))))
        .collect();
    let names = |keep: &dyn Fn(Id<ir::Mode>) -> bool| {
        let kept = diagram.modes.iter().filter(|(id, _)| keep(*id));
        kept.map(|(_, mode)| mode.symbol.name.clone()).collect::<Vec<_>>()
    };
    let reachable = |mode: Id<ir::Mode>| rows.iter().any(|row| row.modes[mode.index()].reachable);
    let trapped = |mode: Id<ir::Mode>| rows.iter().any(|row| row.traps.iter().any(|trap| trap.contains(&mode)));
    let inhibited = |mode: Id<ir::Mode>| {
        let mut required = diagram.modes[mode].requires.iter();
        required.any(|(sensor, _)| failed.iter().any(|(failed, _)| failed == sensor))
    };
    ModesRow {
        diagram: diagram.symbol.name.clone(),
        reachable: names(&reachable),
        unreachable: names(&|mode| !reachable(mode)),
        traps: names(&trapped),
        inhibited: names(&inhibited),
    }
}

fn readings(group: &Group, sensed: &Sensed<'_>, faults: &FaultSet, witness: &Witness) -> Vec<(String, f64)> {
    let complete = sensed.model.complete(faults, witness);
    let named = sensed.inputs.iter().zip(&complete.readings);
    named
        .filter_map(|(&sensor, reading)| Some((group.sensors[sensor].name.clone(), reading.as_ref()?.to_f64())))
        .collect()
}

/// A word for each input: the term, `not term`, or `-` where the rule leaves the input out.
fn in_words(program: &Program, network: &ir::Network, rule: &SingleRule) -> Vec<String> {
    let words = network.inputs.iter().enumerate().map(|(position, input)| {
        let terms = &program.variables[input.variable].terms;
        let literals = rule.iter().filter(|(input, _)| *input == position).map(|(_, literal)| {
            let name = &terms[literal.term as usize].symbol.name;
            if literal.negated { format!("not {name}") } else { name.clone() }
        });
        let words: Vec<_> = literals.collect();
        if words.is_empty() { "-".to_owned() } else { words.join(" and ") }
    });
    words.collect()
}
