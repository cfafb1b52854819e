//! What stands between whoever commands a robot and its body: actions that are others, and the robot's own behavior.

use super::random::{Purpose, Stream};
use super::simulation::Driver;
use crate::base::Id;
use crate::interp::{Actuators, Inputs, Machine, Reading};
use crate::ir::{self, BodyArgument, SensorSource};
use crate::plan::Plan;

/// The commands of a robot on their way to its body.
#[derive(Debug)]
pub(super) struct Drive<'a> {
    /// The robot's own behavior, if it has one.
    machine: Option<Machine<'a>>,
    actions: Vec<Route<'a>>,
    /// What is being carried out: an action, and its arguments.
    command: Option<(u32, Vec<f64>)>,
    /// Where its sensors tell of it, by their places.
    told: Vec<(usize, Told)>,
}

/// Where an action goes.
#[derive(Debug)]
struct Route<'a> {
    /// The action that it is, if another, with its arguments.
    same_as: Option<(u32, &'a [BodyArgument])>,
    /// Whether it is for the robot's own behavior.
    is_driven: bool,
}

/// What a sensor tells of the robot itself.
#[derive(Debug)]
enum Told {
    State,
    Command,
    /// For each action the place of the argument among its own.
    Argument(Vec<Option<usize>>),
}

impl<'a> Drive<'a> {
    /// That of a robot before its first tick.
    pub(super) fn new(program: &'a ir::Program, robot: &'a ir::Robot, plan: &'a Plan, seed: u64) -> Self {
        let action = |id: Id<ir::Action>| &program.actions[id];
        let place = |id: Id<ir::Action>| robot.actions.iter().position(|own| *own == id).unwrap_or_default() as u32;
        let routes = robot.actions.iter().map(|&id| Route {
            same_as: action(id).same_as.as_ref().map(|(other, arguments)| (place(*other), arguments.as_slice())),
            is_driven: robot.drive.is_some() && action(id).is_driven(),
        });
        let argument = |number: u32| {
            let name = robot.drive.as_ref().and_then(|drive| drive.parameters.get(number as usize));
            let of = |id: &Id<ir::Action>| {
                action(*id).parameters.iter().position(|parameter| Some(&parameter.symbol.name) == name)
            };
            robot.actions.iter().map(of).collect()
        };
        let told = robot.sensors.iter().enumerate().filter_map(|(place, &id)| {
            let told = match program.sensors[id].source? {
                SensorSource::State => Told::State,
                SensorSource::Command => Told::Command,
                SensorSource::Argument(number) => Told::Argument(argument(number)),
                _ => return None,
            };
            Some((place, told))
        });
        Self {
            machine: plan.drive.as_ref().map(|plan| Machine::new(plan, Stream::new(seed, Purpose::Drive).seed())),
            actions: routes.collect(),
            command: None,
            told: told.collect(),
        }
    }

    /// Notes whether what the robot was told is completed, and lets its sensors tell of it.
    pub(super) fn begin(&mut self, done: bool, readings: &mut [Reading]) {
        if done {
            self.command = None;
        }
        self.tell(readings);
    }

    /// Lets the robot's own behavior carry out what it has been told on this tick.
    pub(super) fn step(&mut self, done: bool, readings: &mut [Reading], dt: u64, driver: &mut Driver<'_>) {
        self.tell(readings);
        let Some(mut machine) = self.machine.take() else { return };
        driver.given = false;
        machine.step(Inputs { readings, done }, dt, &mut self.over(driver));
        let has_moved = machine.has_moved();
        self.machine = Some(machine);
        if has_moved && !driver.given {
            driver.body.forget_done();
        }
    }

    fn tell(&self, readings: &mut [Reading]) {
        for (place, told) in &self.told {
            let value = match (told, &self.command) {
                (Told::State, _) => self.machine.as_ref().map_or(0.0, |machine| f64::from(machine.mode())),
                (Told::Command, Some((action, _))) => f64::from(action + 1),
                (Told::Argument(places), Some((action, arguments))) => {
                    let place = places.get(*action as usize).copied().flatten();
                    place.and_then(|place| arguments.get(place)).copied().unwrap_or(0.0)
                }
                (Told::Command | Told::Argument(_), None) => 0.0,
            };
            if let Some(reading) = readings.get_mut(*place) {
                *reading = Reading { value, healthy: true };
            }
        }
    }

    /// Hands commands to where they go.
    pub(super) fn over<'d, 'r>(&'d mut self, driver: &'d mut Driver<'r>) -> Commands<'d, 'a, 'r> {
        Commands { drive: self, driver }
    }
}

/// What a machine commands a robot by.
pub(super) struct Commands<'d, 'a, 'r> {
    drive: &'d mut Drive<'a>,
    driver: &'d mut Driver<'r>,
}

impl Actuators for Commands<'_, '_, '_> {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        let Some(route) = self.drive.actions.get(action as usize) else { return };
        if let Some((other, meant)) = route.same_as {
            let arguments: Vec<f64> = meant.iter().map(|argument| argument_of(*argument, arguments)).collect();
            return self.command(other, &arguments, start);
        }
        if route.is_driven {
            self.drive.command = Some((action, arguments.to_vec()));
            self.driver.given = true;
        } else {
            self.driver.command(action, arguments, start);
        }
    }
}

/// An argument of one command as it follows from those of another; 0 where there is none, or none that is finite.
pub(super) fn argument_of(argument: BodyArgument, given: &[f64]) -> f64 {
    let value = match argument {
        BodyArgument::Constant(value) => value,
        BodyArgument::Parameter(place) => given.get(place as usize).copied().unwrap_or(0.0),
        BodyArgument::Negated(place) => -given.get(place as usize).copied().unwrap_or(0.0),
    };
    if value.is_finite() { value } else { 0.0 }
}
