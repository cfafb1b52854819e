//! The types of the checked program: names are ids, numbers are SI, and there is no logic.
//!
//! Imports: base
//! Crates: –

mod diagram;
mod expr;
mod fusion;
mod output;
mod robot;
mod trial;

pub use diagram::{
    Arbiter, Argument, Call, Client, Column, Decision, DecisionRow, Diagram, Emergency, Flag, Layer, Mode, Platform,
    Run, Sense, Ties, Transition,
};
pub use expr::{Comparison, Expr, Op, Type};
pub use fusion::{Clause, Event, FailReading, Literal, Network, NetworkInput, Part, Rule, Shape, Term, Variable};
pub use output::{
    AGGREGATIONS, Aggregation, Consequent, DEFUZZIFIERS, Defuzzifier, IMPLICATIONS, Implication, Inference, Linear,
    Output, OutputRule, Rest, S_NORMS, SNorm, Statement, T_NORMS, TNorm,
};
pub use robot::{
    Action, Body, BodyArgument, BodyCommand, BodyCommandKind, CarLike, DifferentialDrive, Drive, Group, Grouping,
    Interface, Kept, Parameter, Robot, Sensor, SensorSource,
};
pub use trial::{
    BoxBody, Claim, Expectation, ExpectationKind, Fault, FaultReading, Placement, Property, Response, Scenario, Wall,
    Window, World,
};

use crate::base::{Arena, Id, Span};

/// Everything a compilation declares.
#[derive(Debug, Clone, Default)]
pub struct Program {
    /// Fuzzy variables.
    pub variables: Arena<Variable>,
    /// Fuzzy sensor fusion networks.
    pub networks: Arena<Network>,
    /// Interfaces.
    pub interfaces: Arena<Interface>,
    /// Robots.
    pub robots: Arena<Robot>,
    /// Sensors of all robots and interfaces.
    pub sensors: Arena<Sensor>,
    /// Actions of all robots and interfaces.
    pub actions: Arena<Action>,
    /// Mode switching diagrams.
    pub diagrams: Arena<Diagram>,
    /// Worlds.
    pub worlds: Arena<World>,
    /// Scenarios.
    pub scenarios: Arena<Scenario>,
    /// Properties.
    pub properties: Arena<Property>,
    /// Conditions, post-order: operands stand before what uses them.
    pub exprs: Arena<Expr>,
}

impl Program {
    /// The sensors that a diagram on a robot or an interface can look at, logical ones last.
    pub fn sensors_of(&self, platform: Platform) -> Vec<Id<Sensor>> {
        match platform {
            Platform::Robot(robot) => self.robots[robot].all_sensors(),
            Platform::Interface(_) => self.measuring(platform).to_vec(),
        }
    }

    /// The same without logical ones.
    pub fn measuring(&self, platform: Platform) -> &[Id<Sensor>] {
        match platform {
            Platform::Robot(robot) => &self.robots[robot].sensors,
            Platform::Interface(interface) => &self.interfaces[interface].sensors,
        }
    }

    /// The elements of an array, among some sensors; none for what is no array. An element is named by its array and its
    /// index in brackets.
    pub fn elements(&self, array: &str, among: &[Id<Sensor>]) -> Vec<Id<Sensor>> {
        let name = |id: &Id<Sensor>| self.sensors[*id].symbol.name.as_str();
        let is_element = |id: &Id<Sensor>| name(id).strip_prefix(array).is_some_and(|index| index.starts_with('['));
        among.iter().copied().filter(is_element).collect()
    }

    /// The sensors that measure what a name stands for, among some: one, the elements of an array, or what a logical
    /// sensor follows from. None for a name that stands for nothing.
    pub fn measuring_named(&self, name: &str, among: &[Id<Sensor>]) -> Vec<Id<Sensor>> {
        match among.iter().find(|id| self.sensors[**id].symbol.name == name) {
            Some(&id) => self.members(id),
            None => self.elements(name, among),
        }
    }

    /// A diagram and all that run inside its modes, each once.
    pub fn layers(&self, diagram: Id<Diagram>) -> Vec<Id<Diagram>> {
        let mut layers = vec![diagram];
        let mut next = 0;
        while let Some(&layer) = layers.get(next) {
            next += 1;
            for run in self.diagrams[layer].modes.values().filter_map(|mode| mode.runs) {
                if !layers.contains(&run.diagram) {
                    layers.push(run.diagram);
                }
            }
        }
        layers
    }

    /// Modes inside each other as a condition names them, the first of a diagram: `explore.mode is stop`.
    pub fn inside(&self, diagram: &Diagram, path: &[Id<Mode>]) -> String {
        let (mut names, mut here) = (Vec::with_capacity(path.len()), Some(diagram));
        for mode in path {
            let Some(mode) = here.map(|diagram| &diagram.modes[*mode]) else { break };
            names.push(mode.symbol.name.as_str());
            here = mode.runs.map(|run| &self.diagrams[run.diagram]);
        }
        let (last, before) = names.split_last().unwrap_or((&"", &[]));
        format!("{}.mode is {last}", before.join("."))
    }

    /// The sensors that measure what a sensor reads: itself, or those that it follows from.
    pub fn members(&self, sensor: Id<Sensor>) -> Vec<Id<Sensor>> {
        self.sensors[sensor].members().map_or_else(|| vec![sensor], <[_]>::to_vec)
    }

    /// The actions that a diagram on a robot or an interface can call.
    pub fn actions_of(&self, platform: Platform) -> &[Id<Action>] {
        match platform {
            Platform::Robot(robot) => &self.robots[robot].actions,
            Platform::Interface(interface) => &self.interfaces[interface].actions,
        }
    }
}

/// The name and place of a declaration.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Symbol {
    /// As written.
    pub name: String,
    /// Where the name stands.
    pub span: Span,
    /// The text of its doc comment, lines joined by newlines; empty without one.
    pub doc: String,
}
