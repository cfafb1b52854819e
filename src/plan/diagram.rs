//! The plan of a diagram on a robot.

use super::builder::{Builder, EventSlots, Names, reachable};
use super::parts::Parts;
use super::platform::{Platform, logical};
use super::{Bool, Checked, Event, Flag, Output, Plan, Real, Sense, origin};
use crate::base::Id;
use crate::ir;

/// The plan of a scenario: its diagram on its robot, watching the conditions of its expectations in order.
pub fn build_scenario(checked: Checked<'_>, scenario: &ir::Scenario) -> Plan {
    let watched: Vec<_> = scenario
        .expectations
        .iter()
        .flat_map(|expectation| match expectation.kind {
            ir::ExpectationKind::Within(condition, _)
            | ir::ExpectationKind::Never(condition, _)
            | ir::ExpectationKind::Always(condition, _) => vec![condition],
            ir::ExpectationKind::Claim(claim) => claim.conditions(),
            ir::ExpectationKind::Modes(_) | ir::ExpectationKind::Transition { .. } => Vec::new(),
        })
        .collect();
    let drive = checked.program.robots[scenario.robot].drive.as_ref().and_then(|drive| drive.diagram);
    let drive = drive.map(|drive| Box::new(build(checked, drive, scenario.robot, &[])));
    Plan { drive, ..build(checked, scenario.diagram, scenario.robot, &watched) }
}

/// The plan of a diagram on what it is written on, watching some conditions: a robot, or one that has what the interface
/// promises and nothing else. Linear in their size.
pub fn build_alone(checked: Checked<'_>, diagram: Id<ir::Diagram>, watched: &[Id<ir::Expr>]) -> Plan {
    build_on(checked, diagram, checked.program.diagrams[diagram].platform, watched)
}

/// The plan of a diagram on a robot that it is written for, watching some conditions. Linear in their size.
pub fn build(checked: Checked<'_>, diagram: Id<ir::Diagram>, robot: Id<ir::Robot>, watched: &[Id<ir::Expr>]) -> Plan {
    build_on(checked, diagram, ir::Platform::Robot(robot), watched)
}

/// The same on a robot, or on the interface it is written on: then the sensors are as the interface promises them.
pub fn build_on(checked: Checked<'_>, diagram: Id<ir::Diagram>, on: ir::Platform, watched: &[Id<ir::Expr>]) -> Plan {
    let program = checked.program;
    let position = diagram.index() as u32;
    let diagram = &program.diagrams[diagram];
    let logical = logical(program, diagram, on, watched);
    let platform = Platform::new(program, on, &logical);
    let mut builder = Builder::new(program);
    let groups = platform.logical.iter().map_while(|&sensor| platform.lower_group(sensor, &mut builder));
    let mut logical: Vec<_> = groups.collect();

    let (mut senses, mut events, mut strengths) = (Vec::new(), Vec::new(), Vec::new());
    let (mut event_flags, mut outputs): (Vec<Vec<Bool>>, Vec<Output>) = (Vec::new(), Vec::new());
    let mut output_values: Vec<Vec<Real>> = Vec::new();
    for sense in diagram.senses.iter().chain(platform.senses) {
        let readings = sense.inputs.iter().map(|&sensor| builder.sensor(sensor, platform, &logical));
        let readings: Vec<Real> = readings.collect();
        let slots = builder.events(sense.network, &readings);
        event_flags.push(slots.iter().map(|slots| slots.flag).collect());
        let declared = &program.networks[sense.network].events;
        let first = events.len() as u32;
        for (event, slots) in declared.iter().zip(slots) {
            let EventSlots { contributor, detractor, flag, strengths: of_rules } = slots;
            let name = format!("{}.{}", sense.symbol.name, event.symbol.name);
            events.push(Event { name, origin: origin(&event.symbol), contributor, detractor, flag });
            strengths.push(of_rules);
        }
        let computed = builder.outputs(sense.network, &readings);
        output_values.push(computed.iter().map(|output| output.value).collect());
        let first_output = outputs.len() as u32;
        outputs.extend(computed.into_iter().map(|output| {
            let name = format!("{}.{}", sense.symbol.name, output.name);
            Output { name, ..output }
        }));
        senses.push(Sense {
            name: sense.symbol.name.clone(),
            network: sense.network.index() as u32,
            readings,
            events: first..events.len() as u32,
            outputs: first_output..outputs.len() as u32,
        });
    }
    let of_robot = &event_flags[diagram.senses.len()..];
    for &contact in &platform.logical[logical.len()..] {
        let names = Names { platform, logical: &logical, events: of_robot, outputs: &[], flags: &[] };
        let contact = platform.lower_contact(contact, &mut builder, &names);
        logical.extend(contact);
    }
    let mut flags: Vec<Bool> = Vec::new();
    for flag in diagram.flags.values() {
        let names = Names { platform, logical: &logical, events: &event_flags, outputs: &output_values, flags: &flags };
        let value = builder.expr(flag.condition, &names);
        flags.push(value);
    }
    let names = Names { platform, logical: &logical, events: &event_flags, outputs: &output_values, flags: &flags };
    // What commands are given is read on every tick.
    for call in diagram.modes.values().flat_map(ir::Mode::commands) {
        for argument in &call.arguments {
            if let ir::Argument::Reading(sensor) = argument {
                builder.sensor(*sensor, platform, &logical);
            }
        }
    }
    // What remembers must run on every tick, whichever mode is active.
    let of_flags = diagram.flags.values().map(|flag| flag.condition);
    let of_modes = diagram.modes.values().flat_map(|mode| &mode.transitions).map(|transition| transition.condition);
    let of_arbiter = diagram.arbiter.iter().flat_map(ir::Arbiter::conditions);
    let mut remembered: Vec<(Bool, String)> = Vec::new();
    for id in of_flags.chain(of_modes).chain(of_arbiter).flat_map(|condition| reachable(program, condition)) {
        if let Some(operand) = remembers(&program.exprs[id].op) {
            builder.expr(id, &names);
            let operand = (builder.expr(operand, &names), checked.on_one_line(program.exprs[operand].span));
            if remembered.iter().all(|(known, _)| *known != operand.0) {
                remembered.push(operand);
            }
        }
    }
    let fuse = 0..builder.position();

    let mut parts = Parts::new(platform, checked, diagram);
    let arbiter = diagram.arbiter.as_ref().map(|arbiter| parts.arbiter(arbiter, on, &mut builder, &names));
    let fuse = if arbiter.is_some() { 0..builder.position() } else { fuse };
    let modes = diagram.modes.iter().map(|(id, mode)| parts.mode(id, mode, &mut builder, &names)).collect();

    let inner = parts.inner.iter().map(|inner| build_on(checked, *inner, on, &[])).collect();

    builder.begin_watch();
    let start = builder.position();
    let watched = watched.iter().map(|&condition| builder.expr(condition, &names)).collect();
    let watch = start..builder.position();
    let constants = builder.finish();
    Plan {
        position,
        name: diagram.symbol.name.clone(),
        origin: origin(&diagram.symbol),
        robot: platform.name.to_owned(),
        inputs: platform.inputs(diagram),
        logical,
        actions: platform.actions.iter().map(|&action| platform.lower_action(&program.actions[action])).collect(),
        code: builder.code,
        fuse,
        watch,
        senses,
        events,
        strengths,
        outputs,
        flags: diagram
            .flags
            .values()
            .zip(&flags)
            .map(|(flag, &value)| Flag { name: flag.symbol.name.clone(), origin: origin(&flag.symbol), value })
            .collect(),
        remembered,
        watched,
        modes,
        transitions: parts.transitions,
        rows: parts.rows,
        calls: parts.calls,
        arguments: parts.arguments,
        draws: parts.draws,
        required: parts.required,
        constants,
        entry: diagram.entry.map_or(0, |entry| entry.index() as u32),
        inner,
        arbiter,
        drive: None,
    }
}

/// What an operation with a memory of its own looks back at.
fn remembers(op: &ir::Op) -> Option<Id<ir::Expr>> {
    match *op {
        ir::Op::Rising(of) | ir::Op::Falling(of) | ir::Op::Held(of, _) | ir::Op::Latched(of) | ir::Op::Count(of) => {
            Some(of)
        }
        _ => None,
    }
}
