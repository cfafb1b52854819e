//! From which distance on conditions can react to what comes nearer.

use crate::base::{Exact, Id, Span};
use crate::ir::{Argument, Comparison, Diagram, Expr, Mode, Op, Part, Program, Robot, Sensor, Shape};

/// A sensor that a condition looks at.
#[derive(Debug, Clone, Copy)]
pub(super) struct Look {
    pub(super) sensor: Id<Sensor>,
    /// The largest reading, m, below which the condition can begin to hold as the reading falls.
    pub(super) at: f64,
    /// Nanoseconds for which it waits then.
    pub(super) delay: u64,
    /// The condition.
    pub(super) span: Span,
}

/// The looks that can end what a mode commands: those of its exits, of the rows that command something, and of what its
/// commands are given.
pub(super) fn looks_of_mode(program: &Program, diagram: &Diagram, mode: &Mode) -> Vec<Look> {
    let rows = mode.decision.iter().flat_map(|table| &table.rows).filter(|row| !row.commands.is_empty());
    let exits = mode.transitions.iter().map(|exit| exit.condition);
    let conditions = exits.chain(rows.map(|row| row.condition));
    let mut found: Vec<_> = conditions.flat_map(|condition| looks(program, diagram, condition)).collect();
    for call in mode.commands() {
        for argument in &call.arguments {
            match *argument {
                Argument::Output { sense, .. } => found.extend(fed(program, diagram, sense, 0, call.span)),
                Argument::Reading(sensor) => found.push(anywhere(program, sensor, call.span)),
                Argument::Constant(_) | Argument::Random { .. } => {}
            }
        }
    }
    found
}

/// Those of what carries out a robot's commands.
pub(super) fn looks_of_robot(program: &Program, robot: &Robot) -> Vec<Look> {
    let Some(drive) = robot.drive.as_ref().and_then(|drive| drive.diagram) else { return Vec::new() };
    let drive = &program.diagrams[drive];
    drive.modes.values().flat_map(|mode| looks_of_mode(program, drive, mode)).collect()
}

/// What a condition looks at when it begins to hold.
pub(super) fn looks(program: &Program, diagram: &Diagram, condition: Id<Expr>) -> Vec<Look> {
    let mut found = Vec::new();
    // What has yet to be looked into, whether it is to hold, and for how long.
    let mut waiting = vec![(condition, true, 0_u64)];
    while let Some((id, holds, delay)) = waiting.pop() {
        let span = program.exprs[id].span;
        match &program.exprs[id].op {
            Op::Not(of) => waiting.push((*of, !holds, delay)),
            Op::And(of) | Op::Or(of) => waiting.extend(of.iter().map(|of| (*of, holds, delay))),
            Op::Flag(flag) => waiting.push((diagram.flags[*flag].condition, holds, delay)),
            // It ceases as soon as what lasts does.
            Op::Held(of, time) => waiting.push((*of, holds, delay.saturating_add(if holds { *time } else { 0 }))),
            Op::Rising(of) | Op::Falling(of) | Op::Latched(of) | Op::Count(of) => {
                waiting.extend([(*of, true, delay), (*of, false, delay)]);
            }
            Op::Event { sense, event } => {
                let network = &program.networks[diagram.senses[*sense as usize].network];
                let event = &network.events[*event as usize];
                let waits = if holds { event.confirm } else { event.hold };
                found.extend(fed(program, diagram, *sense, delay.saturating_add(waits), span));
            }
            Op::Compare(comparison, left, right) => match (&program.exprs[*left].op, &program.exprs[*right].op) {
                (Op::Sensor(sensor), Op::Number(at)) if begins(*comparison, holds) => {
                    found.push(Look { sensor: *sensor, at: at.to_f64(), delay, span });
                }
                (Op::Number(at), Op::Sensor(sensor)) if begins(*comparison, !holds) => {
                    found.push(Look { sensor: *sensor, at: at.to_f64(), delay, span });
                }
                (Op::Sensor(_), Op::Number(_)) | (Op::Number(_), Op::Sensor(_)) => {}
                (one, other) => {
                    for side in [one, other] {
                        if let Op::Sensor(sensor) = side {
                            found.push(anywhere(program, *sensor, span));
                        }
                    }
                    waiting.extend([(*left, holds, delay), (*right, holds, delay)]);
                }
            },
            Op::Error
            | Op::Unknown
            | Op::Number(_)
            | Op::Sensor(_)
            | Op::Failed(_)
            | Op::InMode(_)
            | Op::Inside(_)
            | Op::After(_)
            | Op::Done => {}
        }
    }
    found
}

/// Whether a comparison of a reading with a number can come to hold, or to cease, as the reading falls.
fn begins(comparison: Comparison, holds: bool) -> bool {
    match comparison {
        Comparison::Less | Comparison::LessOrEqual => holds,
        Comparison::Greater | Comparison::GreaterOrEqual => !holds,
        Comparison::Equal | Comparison::NotEqual => true,
    }
}

/// A sensor that is looked at wherever its reading falls.
fn anywhere(program: &Program, sensor: Id<Sensor>, span: Span) -> Look {
    Look { sensor, at: program.sensors[sensor].range.1.to_f64(), delay: 0, span }
}

/// What feeds a network: nothing in it changes above the last bend of a variable's sets.
fn fed(program: &Program, diagram: &Diagram, sense: u32, delay: u64, span: Span) -> Vec<Look> {
    let sense = &diagram.senses[sense as usize];
    let inputs = sense.inputs.iter().zip(&program.networks[sense.network].inputs);
    let looks = inputs.map(|(&sensor, input)| {
        let variable = &program.variables[input.variable];
        let bends = variable.terms.iter().map(|term| last_bend(&term.shape));
        let at = bends.collect::<Option<Vec<_>>>().and_then(|bends| bends.into_iter().max());
        let end = program.sensors[sensor].range.1;
        Look { sensor, at: at.map_or(end, |at| at.min(end)).to_f64(), delay, span }
    });
    looks.collect()
}

/// The largest reading at which a set bends; `None` for one that has no last bend.
fn last_bend(shape: &Shape) -> Option<Exact> {
    let last = |corners: &[Exact]| corners.iter().copied().max();
    match shape {
        Shape::Triangle(of) => last(of),
        Shape::Trapezoid(of) | Shape::RiseAndFall(of) => last(of),
        Shape::Ramp { zero_at, one_at } => last(&[*zero_at, *one_at]),
        Shape::Rectangle(of) | Shape::Rise(of) | Shape::Fall(of) => last(of),
        Shape::Singleton(at) => Some(*at),
        Shape::Points(points) => points.iter().map(|(at, _)| *at).max(),
        Shape::Gaussian(_) | Shape::Gaussian2(_) | Shape::Bell(_) | Shape::Sigmoid(_) | Shape::Cosine(_) => None,
        Shape::Built(parts) => {
            let bends = parts.iter().filter_map(|part| match part {
                Part::Shape(Shape::Built(_)) => Some(None),
                Part::Shape(shape) => Some(last_bend(shape)),
                Part::Not(_) | Part::Very(_) | Part::Somewhat(_) | Part::All(_) | Part::Any(_) => None,
            });
            bends.collect::<Option<Vec<_>>>()?.into_iter().max()
        }
    }
}
