//! How fast commands make a robot drive.

use std::collections::BTreeSet;

use crate::base::{Id, Span};
use crate::ir::{
    Action, Argument, BodyArgument, BodyCommandKind, Call, Diagram, Expr, Mode, Op, Program, Robot, Sensor,
    SensorSource,
};

/// What a command makes of a body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion {
    /// m/s, forward; 0 where it is not known.
    pub(super) speed: f64,
    /// Whether it drives straight on until it is told otherwise.
    pub(super) goes_on: bool,
    /// Whether it is known not to steer while it drives.
    pub(super) is_straight: bool,
    /// The command.
    pub(super) span: Span,
}

/// What some commands of a diagram make of the body of a robot that it runs on.
pub(super) fn motions<'a>(program: &Program, robot: &Robot, calls: impl Iterator<Item = &'a Call>) -> Vec<Motion> {
    let of_call = |call: &Call| {
        let given = call.arguments.iter().map(|argument| value(argument, &|_| None)).collect();
        of_action(program, robot, call.action, given, call.span)
    };
    calls.flat_map(of_call).collect()
}

/// A number that is known beforehand; the end of a range that lies farther from 0.
fn value(argument: &Argument, told: &dyn Fn(Id<Sensor>) -> Option<f64>) -> Option<f64> {
    match argument {
        Argument::Constant(value) => Some(value.to_f64()),
        Argument::Random { low, high } => {
            let (low, high) = (low.to_f64(), high.to_f64());
            Some(if low.abs() > high.abs() { low } else { high })
        }
        Argument::Reading(sensor) => told(*sensor),
        Argument::Output { .. } => None,
    }
}

/// What an action makes of the body, with arguments that may be unknown.
fn of_action(
    program: &Program,
    robot: &Robot,
    action: Id<Action>,
    mut given: Vec<Option<f64>>,
    span: Span,
) -> Vec<Motion> {
    let name = &program.actions[action].symbol.name;
    let Some(mut place) = robot.actions.iter().position(|own| program.actions[*own].symbol.name == *name) else {
        return Vec::new();
    };
    // Aliases lead to no circle.
    while let Some((other, meant)) = &program.actions[robot.actions[place]].same_as {
        given = meant.iter().map(|argument| passed(*argument, &given)).collect();
        let Some(next) = robot.actions.iter().position(|own| own == other) else { return Vec::new() };
        place = next;
    }
    let action = &program.actions[robot.actions[place]];
    let Some(command) = &action.command else { return driven(program, robot, place, &given, span) };
    let argument = |place: usize| passed(*command.arguments.get(place)?, &given);
    let still = Motion { speed: 0.0, goes_on: false, is_straight: true, span };
    let unknown = Motion { is_straight: false, ..still };
    vec![match command.kind {
        BodyCommandKind::Plan | BodyCommandKind::NextWaypoint => return Vec::new(),
        BodyCommandKind::Stop | BodyCommandKind::Rotate => still,
        BodyCommandKind::Arc => unknown,
        BodyCommandKind::Velocity | BodyCommandKind::Steer => match (argument(0), argument(1)) {
            (Some(speed), Some(0.0)) => Motion { speed, goes_on: true, ..still },
            _ => unknown,
        },
        BodyCommandKind::Travel => match (argument(0), argument(1)) {
            (Some(distance), Some(speed)) => {
                Motion { speed: if distance < 0.0 { -speed } else { speed }, goes_on: distance == 0.0, ..still }
            }
            _ => unknown,
        },
    }]
}

fn passed(argument: BodyArgument, given: &[Option<f64>]) -> Option<f64> {
    match argument {
        BodyArgument::Constant(value) => Some(value),
        BodyArgument::Parameter(place) => *given.get(place as usize)?,
        BodyArgument::Negated(place) => Some(-(*given.get(place as usize)?)?),
    }
}

/// What the robot's own behavior makes of an action, by its place, that it is told from its entry on.
fn driven(program: &Program, robot: &Robot, place: usize, given: &[Option<f64>], span: Span) -> Vec<Motion> {
    let Some(drive) = &robot.drive else { return Vec::new() };
    let Some(diagram) = drive.diagram.map(|diagram| &program.diagrams[diagram]) else { return Vec::new() };
    let Some(entry) = diagram.entry else { return Vec::new() };
    let parameters = &program.actions[robot.actions[place]].parameters;
    let told = |sensor: Id<Sensor>| match program.sensors[sensor].source? {
        SensorSource::Command => Some((place + 1) as f64),
        SensorSource::Argument(number) => {
            let name = drive.parameters.get(number as usize)?;
            let argument = parameters.iter().position(|parameter| parameter.symbol.name == *name);
            argument.map_or(Some(0.0), |argument| *given.get(argument)?)
        }
        _ => None,
    };
    let mut reached = BTreeSet::from([entry]);
    let (mut waiting, mut motions) = (vec![entry], Vec::new());
    while let Some(mode) = waiting.pop() {
        let mode = &diagram.modes[mode];
        let mut stays = true;
        for exit in &mode.transitions {
            let holds = holds(program, diagram, exit.condition, &told);
            if holds != Some(false) {
                waiting.extend(exit.target.filter(|target| reached.insert(*target)));
            }
            if holds == Some(true) {
                stays = false;
                break;
            }
        }
        if stays {
            for call in commands(program, diagram, mode, &told) {
                let given = call.arguments.iter().map(|argument| value(argument, &told)).collect();
                // What carries out commands gives none to itself.
                if program.actions[call.action].command.is_some() {
                    motions.extend(of_action(program, robot, call.action, given, span));
                }
            }
        }
    }
    motions
}

/// What a mode commands while it lasts, of what its table can choose.
fn commands<'a>(
    program: &'a Program,
    diagram: &'a Diagram,
    mode: &'a Mode,
    told: &'a dyn Fn(Id<Sensor>) -> Option<f64>,
) -> impl Iterator<Item = &'a Call> {
    let rows = mode.decision.iter().flat_map(|table| &table.rows);
    let rows = rows.filter(move |row| holds(program, diagram, row.condition, told) != Some(false));
    mode.actions.iter().chain(rows.flat_map(|row| &row.commands))
}

/// Whether a condition holds by what the sensors tell; `None` where that is not known.
fn holds(
    program: &Program,
    diagram: &Diagram,
    condition: Id<Expr>,
    told: &dyn Fn(Id<Sensor>) -> Option<f64>,
) -> Option<bool> {
    let number = |id: Id<Expr>| match &program.exprs[id].op {
        Op::Number(value) => Some(value.to_f64()),
        Op::Sensor(sensor) => told(*sensor),
        _ => None,
    };
    let mut known: Vec<(Id<Expr>, Option<bool>)> = Vec::new();
    let value = |known: &[(Id<Expr>, Option<bool>)], of: Id<Expr>| {
        known.iter().find(|(id, _)| *id == of).and_then(|(_, value)| *value)
    };
    // A flag uses only earlier ones, so that all come before what uses them.
    let flags = diagram.flags.values().map(|flag| flag.condition);
    for root in flags.chain([condition]) {
        for id in crate::analysis::modes::parts(program, root) {
            let all = |of: &[Id<Expr>], ends: bool| {
                let of: Vec<_> = of.iter().map(|of| value(&known, *of)).collect();
                if of.contains(&Some(ends)) {
                    Some(ends)
                } else {
                    of.into_iter().collect::<Option<Vec<_>>>().map(|_| !ends)
                }
            };
            let holds = match &program.exprs[id].op {
                Op::Not(of) => value(&known, *of).map(|of| !of),
                Op::And(of) => all(of, false),
                Op::Or(of) => all(of, true),
                Op::Flag(flag) => value(&known, diagram.flags[*flag].condition),
                Op::Compare(comparison, left, right) => {
                    number(*left).zip(number(*right)).map(|(left, right)| comparison.holds(left, right))
                }
                _ => None,
            };
            known.push((id, holds));
        }
    }
    value(&known, condition)
}
