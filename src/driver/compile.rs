//! From a checked program to code.

use std::collections::BTreeSet;

use super::Analysis;
use crate::base::Id;
use crate::emit::{self, Options};
use crate::{ir, plan};

/// Why a program without errors is not compiled.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotCompiled {
    /// Some finding is an error.
    Errors,
    /// The files declare no behavior and no network, and no scenario of theirs runs one.
    Nothing,
    /// A behavior is written on an interface that several robots provide: its name, and theirs.
    Ambiguous(String, Vec<String>),
    /// No robot of that name provides what a behavior is written on: the behavior's name.
    NotWrittenFor(String),
}

/// Plans of everything that is compiled together.
#[derive(Debug)]
pub struct Plans {
    /// The networks.
    pub networks: Vec<plan::NetworkPlan>,
    /// The behaviors.
    pub diagrams: Vec<plan::Plan>,
}

impl Analysis {
    /// Rust for the behaviors, arbiters and networks that the roots declare, for what their scenarios run, for the networks
    /// that these sense through, and for what carries out the commands of an arbiter.
    ///
    /// # Errors
    /// Where there is nothing to compile, or no single way to do it.
    pub fn rust(&self, options: &Options) -> Result<String, NotCompiled> {
        let Plans { networks, diagrams } = self.plans(options.robot.as_deref())?;
        let program =
            emit::Program { roots: &self.roots, sources: &self.sources, networks: &networks, diagrams: &diagrams };
        Ok(emit::rust(&program, options))
    }

    /// What `rust` makes code of: on the robot of that name for what is written on an interface.
    ///
    /// # Errors
    /// As for `rust`.
    pub fn plans(&self, robot: Option<&str>) -> Result<Plans, NotCompiled> {
        let checked = self.checked().ok_or(NotCompiled::Errors)?;
        let program = &self.program;
        let is_own = |symbol: &ir::Symbol| self.roots.contains(&symbol.span.file);
        let run: BTreeSet<_> = program
            .scenarios
            .values()
            .filter(|scenario| is_own(&scenario.symbol))
            .map(|scenario| scenario.diagram)
            .collect();
        let chosen = program.diagrams.iter().filter(|(id, diagram)| is_own(&diagram.symbol) || run.contains(id));
        let mut chosen: BTreeSet<_> = chosen.map(|(id, _)| id).collect();
        // What an arbiter asks for is carried out by its robot's own behavior, where there is one.
        let arbiters = chosen.iter().map(|id| &program.diagrams[*id]).filter(|diagram| diagram.arbiter.is_some());
        let drives = arbiters.filter_map(|arbiter| match arbiter.platform {
            ir::Platform::Robot(robot) => program.robots[robot].drive.as_ref()?.diagram,
            ir::Platform::Interface(_) => None,
        });
        chosen.extend(drives.collect::<Vec<_>>());
        let diagrams = chosen
            .into_iter()
            .map(|id| Ok(plan::build_on(checked, id, self.platform(&program.diagrams[id], robot)?, &[])))
            .collect::<Result<Vec<_>, _>>()?;
        let layers = diagrams.iter().flat_map(plan::Plan::layers);
        let sensed: BTreeSet<u32> = layers.flat_map(|diagram| &diagram.senses).map(|sense| sense.network).collect();
        let networks: Vec<_> = program
            .networks
            .iter()
            .filter(|(id, network)| is_own(&network.symbol) || sensed.contains(&(id.index() as u32)))
            .map(|(id, _)| plan::build_network(checked, id))
            .collect();
        if diagrams.is_empty() && networks.is_empty() {
            return Err(NotCompiled::Nothing);
        }
        Ok(Plans { networks, diagrams })
    }

    fn platform(&self, diagram: &ir::Diagram, robot: Option<&str>) -> Result<ir::Platform, NotCompiled> {
        let robots = &self.program.robots;
        let named = |id: &Id<ir::Robot>| robot.is_none_or(|name| robots[*id].symbol.name == name);
        let ir::Platform::Interface(interface) = diagram.platform else { return Ok(diagram.platform) };
        let fits: Vec<_> = robots.ids().filter(|id| robots[*id].provides.contains(&interface)).filter(named).collect();
        match (fits.as_slice(), robot) {
            ([], None) => Ok(diagram.platform),
            ([], Some(_)) => Err(NotCompiled::NotWrittenFor(diagram.symbol.name.clone())),
            (&[only], _) => Ok(ir::Platform::Robot(only)),
            (several, _) => {
                let names = several.iter().map(|&id| robots[id].symbol.name.clone()).collect();
                Err(NotCompiled::Ambiguous(diagram.symbol.name.clone(), names))
            }
        }
    }
}
