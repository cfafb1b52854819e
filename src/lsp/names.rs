//! What is declared where, what each name means, and which places name the same.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::known::Known;
use crate::base::{FileId, Id, Span};
use crate::ir::{
    Action, Diagram, Flag, Interface, Mode, Network, Program, Property, Robot, Scenario, Sensor, Symbol, Variable,
    World,
};

/// Something that is declared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Entity {
    Variable(Id<Variable>),
    /// The term of a variable at that position.
    Term(Id<Variable>, usize),
    Network(Id<Network>),
    Input(Id<Network>, usize),
    Event(Id<Network>, usize),
    Output(Id<Network>, usize),
    /// A set of an output.
    OutputTerm(Id<Network>, usize, usize),
    Interface(Id<Interface>),
    Robot(Id<Robot>),
    Sensor(Id<Sensor>),
    Action(Id<Action>),
    Parameter(Id<Action>, usize),
    Diagram(Id<Diagram>),
    /// A network, where a diagram senses it.
    Sense(Id<Diagram>, usize),
    Flag(Id<Diagram>, Id<Flag>),
    Mode(Id<Diagram>, Id<Mode>),
    World(Id<World>),
    Scenario(Id<Scenario>),
    Property(Id<Property>),
}

/// What is declared, by the place of its name.
pub(super) type Declared = BTreeMap<Span, Entity>;

/// Everything that a program declares. Linear in its size.
pub(super) fn declared(program: &Program) -> Declared {
    let mut declared = Declared::new();
    // What a diagram takes over from another is the other's.
    let mut add = |symbol: &Symbol, entity| {
        declared.entry(symbol.span).or_insert(entity);
    };
    for (id, variable) in program.variables.iter() {
        add(&variable.symbol, Entity::Variable(id));
        variable.terms.iter().enumerate().for_each(|(at, term)| add(&term.symbol, Entity::Term(id, at)));
    }
    for (id, network) in program.networks.iter() {
        add(&network.symbol, Entity::Network(id));
        network.inputs.iter().enumerate().for_each(|(at, input)| add(&input.symbol, Entity::Input(id, at)));
        network.events.iter().enumerate().for_each(|(at, event)| add(&event.symbol, Entity::Event(id, at)));
        for (at, output) in network.outputs.iter().enumerate() {
            add(&output.symbol, Entity::Output(id, at));
            let terms = output.terms.iter().enumerate();
            terms.for_each(|(term, named)| add(&named.symbol, Entity::OutputTerm(id, at, term)));
        }
    }
    program.interfaces.iter().for_each(|(id, interface)| add(&interface.symbol, Entity::Interface(id)));
    program.robots.iter().for_each(|(id, robot)| add(&robot.symbol, Entity::Robot(id)));
    // What tells of the robot itself is declared nowhere.
    let measuring = program.sensors.iter().filter(|(_, sensor)| !sensor.is_inner());
    measuring.for_each(|(id, sensor)| add(&sensor.symbol, Entity::Sensor(id)));
    for (id, action) in program.actions.iter() {
        add(&action.symbol, Entity::Action(id));
        action.parameters.iter().enumerate().for_each(|(at, named)| add(&named.symbol, Entity::Parameter(id, at)));
    }
    for (id, diagram) in program.diagrams.iter() {
        add(&diagram.symbol, Entity::Diagram(id));
        diagram.flags.iter().for_each(|(flag, named)| add(&named.symbol, Entity::Flag(id, flag)));
        let modes = diagram.modes.iter().filter(|(_, mode)| !mode.inherited);
        modes.for_each(|(mode, named)| add(&named.symbol, Entity::Mode(id, mode)));
        diagram.senses.iter().enumerate().for_each(|(at, sense)| add(&sense.symbol, Entity::Sense(id, at)));
    }
    program.worlds.iter().for_each(|(id, world)| add(&world.symbol, Entity::World(id)));
    program.scenarios.iter().for_each(|(id, scenario)| add(&scenario.symbol, Entity::Scenario(id)));
    program.properties.iter().for_each(|(id, property)| add(&property.symbol, Entity::Property(id)));
    declared
}

impl Known {
    /// The name at a byte of a file, or right in front of it: one that means something, or one that is declared.
    pub(super) fn name_at(&self, file: FileId, byte: usize) -> Option<Span> {
        let last = Span::new(file, byte as u32, u32::MAX);
        let uses = &self.analysis.uses;
        let used = uses.get(uses.partition_point(|(name, _)| *name <= last).checked_sub(1)?).map(|(name, _)| *name);
        let declared = self.declared().range(..=last).next_back().map(|(name, _)| *name);
        let touches = |name: &Span| name.file == file && name.range().start <= byte && byte <= name.range().end;
        used.into_iter().chain(declared).filter(touches).max()
    }

    /// Where what a name means is declared; several where a declaration keeps several promises.
    pub(super) fn meanings(&self, name: Span) -> impl Iterator<Item = Span> {
        let uses = &self.analysis.uses;
        let start = uses.partition_point(|(known, _)| *known < name);
        uses.iter().skip(start).take_while(move |(known, _)| *known == name).map(|(_, to)| *to)
    }

    /// What a name means in the end: its own declaration, or the one it leads to.
    pub(super) fn entity(&self, name: Span) -> Option<Entity> {
        let mut name = name;
        // A declaration that names another one is told by itself, but for a network that is sensed by its own name.
        for _ in 0..3 {
            match self.declared().get(&name) {
                None | Some(Entity::Sense(..)) => match self.meanings(name).next() {
                    Some(meaning) => name = meaning,
                    None => break,
                },
                Some(entity) => return Some(*entity),
            }
        }
        self.declared().get(&name).copied()
    }

    /// Every place that names the same: the declarations, those they stand in the place of, and all uses.
    pub(super) fn kin(&self, name: Span) -> BTreeSet<Span> {
        let mut neighbors: HashMap<Span, Vec<Span>> = HashMap::new();
        for &(name, to) in &self.analysis.uses {
            neighbors.entry(name).or_default().push(to);
            neighbors.entry(to).or_default().push(name);
        }
        let (mut kin, mut waiting) = (BTreeSet::from([name]), vec![name]);
        while let Some(next) = waiting.pop() {
            for &neighbor in neighbors.get(&next).into_iter().flatten() {
                if kin.insert(neighbor) {
                    waiting.push(neighbor);
                }
            }
        }
        kin
    }
}
