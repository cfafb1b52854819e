//! What a diagram runs on, as its plan names it.

use std::collections::HashSet;

use super::builder::{Builder, Names, reachable};
use super::{Action, Input, Logical, Origin, Value, input, origin};
use crate::base::Id;
use crate::ir;

/// Where the reading of a sensor comes from.
pub(super) enum Feed {
    /// An input of the plan.
    Input(u32),
    /// A logical sensor of the plan.
    Logical(u32),
}

/// What a diagram runs on. What the diagram names on an interface is found on a robot by name; a checked robot has it.
#[derive(Clone, Copy)]
pub(super) struct Platform<'a> {
    pub(super) program: &'a ir::Program,
    pub(super) name: &'a str,
    pub(super) sensors: &'a [Id<ir::Sensor>],
    /// Its logical sensors, contacts that follow from conditions last.
    pub(super) logical: &'a [Id<ir::Sensor>],
    /// The networks that these contacts look at.
    pub(super) senses: &'a [ir::Sense],
    pub(super) actions: &'a [Id<ir::Action>],
    /// The interfaces a robot keeps; their doc comments stand in for those that the robot does not repeat.
    provides: &'a [Id<ir::Interface>],
}

impl<'a> Platform<'a> {
    pub(super) fn new(program: &'a ir::Program, platform: ir::Platform, logical: &'a [Id<ir::Sensor>]) -> Self {
        match platform {
            ir::Platform::Robot(robot) => {
                let ir::Robot { symbol, provides, sensors, senses, actions, .. } = &program.robots[robot];
                let has_contacts = logical.last().is_some_and(|last| program.sensors[*last].kept.is_some());
                let senses = if has_contacts { senses.as_slice() } else { &[] };
                Self { program, name: &symbol.name, sensors, logical, senses, actions, provides }
            }
            ir::Platform::Interface(interface) => {
                let ir::Interface { symbol, sensors, actions, .. } = &program.interfaces[interface];
                Self { program, name: &symbol.name, sensors, logical, senses: &[], actions, provides: &[] }
            }
        }
    }

    pub(super) fn feed(&self, sensor: Id<ir::Sensor>) -> Feed {
        let name = &self.program.sensors[sensor].symbol.name;
        let is_it = |&own: &Id<ir::Sensor>| own == sensor || self.program.sensors[own].symbol.name == *name;
        match self.logical.iter().position(is_it) {
            Some(place) => Feed::Logical(place as u32),
            None => Feed::Input(self.sensors.iter().position(is_it).unwrap_or_default() as u32),
        }
    }

    /// The inputs that a sensor reads.
    pub(super) fn inputs_of(&self, sensor: Id<ir::Sensor>) -> Vec<u32> {
        match self.feed(sensor) {
            Feed::Input(input) => vec![input],
            Feed::Logical(place) => {
                let members = self.program.members(self.logical[place as usize]);
                members.into_iter().flat_map(|member| self.inputs_of(member)).collect()
            }
        }
    }

    pub(super) fn lower_group(&self, sensor: Id<ir::Sensor>, builder: &mut Builder<'_>) -> Option<Logical> {
        let how = self.program.sensors[sensor].group.as_ref()?.how;
        let of = self.inputs_of(sensor);
        let readings = self.program.sensors[sensor].group.iter().flat_map(|group| group.of.iter().zip(&group.readings));
        let members = readings.zip(&of);
        let members = members
            .map(|((&member, &count), &input)| builder.average(input, count, self.program.sensors[member].period));
        let members: Vec<_> = members.collect();
        let value = Value::Number(builder.group(how, &members));
        Some(self.lower_logical(sensor, of, value))
    }

    pub(super) fn lower_contact(
        &self,
        sensor: Id<ir::Sensor>,
        builder: &mut Builder<'_>,
        names: &Names<'_>,
    ) -> Option<Logical> {
        let condition = self.program.sensors[sensor].kept.as_ref()?.condition;
        let value = Value::Truth(builder.expr(condition, names));
        Some(self.lower_logical(sensor, self.inputs_of(sensor), value))
    }

    fn lower_logical(&self, sensor: Id<ir::Sensor>, of: Vec<u32>, value: Value) -> Logical {
        let ir::Sensor { symbol, unit, .. } = &self.program.sensors[sensor];
        Logical { name: symbol.name.clone(), origin: origin(symbol), unit: unit.clone(), of, value }
    }

    pub(super) fn action(&self, action: Id<ir::Action>) -> u32 {
        let name = &self.program.actions[action].symbol.name;
        let place = |&own: &Id<ir::Action>| own == action || self.program.actions[own].symbol.name == *name;
        self.actions.iter().position(place).unwrap_or_default() as u32
    }

    pub(super) fn lower_action(&self, action: &ir::Action) -> Action {
        let promised = self.provides.iter().flat_map(|&interface| &self.program.interfaces[interface].actions);
        let promised = promised.map(|&action| &self.program.actions[action].symbol);
        let parameters = action.parameters.iter();
        Action {
            name: action.symbol.name.clone(),
            origin: documented(&action.symbol, promised),
            parameters: parameters.map(|parameter| (parameter.symbol.name.clone(), parameter.unit.clone())).collect(),
            reports_done: action.reports_done,
        }
    }

    /// The sensors; one that does not say how it fails takes the word of a variable it feeds, by itself or in a group.
    pub(super) fn inputs(&self, diagram: &ir::Diagram) -> Vec<Input> {
        let fed = diagram.senses.iter().chain(self.senses).flat_map(|sense| {
            let inputs = sense.inputs.iter().zip(&self.program.networks[sense.network].inputs);
            inputs.map(|(&fed, input)| (self.inputs_of(fed), self.program.variables[input.variable].fails.as_slice()))
        });
        let fed: Vec<_> = fed.collect();
        let feeds = |place: u32| fed.iter().filter(move |(places, _)| places.contains(&place)).map(|(_, fails)| *fails);
        let promised = self.provides.iter().flat_map(|&interface| &self.program.interfaces[interface].sensors);
        let promised = promised.map(|&sensor| &self.program.sensors[sensor].symbol);
        let sensors = self.sensors.iter().map(|&id| &self.program.sensors[id]);
        sensors
            .zip(0..)
            .map(|(sensor, place)| {
                let fails: Vec<_> = std::iter::once(sensor.fails.as_slice()).chain(feeds(place)).collect();
                let input = input(&sensor.symbol, &sensor.unit, sensor.range, &fails);
                Input { origin: documented(&sensor.symbol, promised.clone()), ..input }
            })
            .collect()
    }
}

/// The logical sensors of what a diagram runs on: groups, then of the contacts that follow from conditions those that the
/// diagram or what is watched asks for. What is written on the robot has taken in their conditions, and asks for none.
pub(super) fn logical(
    program: &ir::Program,
    diagram: &ir::Diagram,
    on: ir::Platform,
    watched: &[Id<ir::Expr>],
) -> Vec<Id<ir::Sensor>> {
    let ir::Platform::Robot(robot) = on else { return Vec::new() };
    let name = |sensor: Id<ir::Sensor>| program.sensors[sensor].symbol.name.as_str();
    let sensor = |id: Id<ir::Expr>| match program.exprs[id].op {
        ir::Op::Sensor(sensor) | ir::Op::Failed(sensor) => Some(name(sensor)),
        _ => None,
    };
    let conditions = diagram.conditions().chain(watched.iter().copied());
    let required = diagram.modes.values().flat_map(|mode| &mode.requires).map(|(sensor, _)| name(*sensor));
    let asked = conditions.flat_map(|condition| reachable(program, condition)).filter_map(sensor);
    let asked: HashSet<&str> = asked.chain(required).collect();
    let all = program.robots[robot].logical.iter().copied();
    all.filter(|&sensor| program.sensors[sensor].group.is_some() || asked.contains(name(sensor))).collect()
}

/// Where something stands, with the doc comment of what promised it where it has none of its own.
fn documented<'a>(symbol: &ir::Symbol, mut promised: impl Iterator<Item = &'a ir::Symbol>) -> Origin {
    let mut origin = origin(symbol);
    if origin.doc.is_empty()
        && let Some(promised) = promised.find(|promised| promised.name == symbol.name)
    {
        origin.doc.clone_from(&promised.doc);
    }
    origin
}
