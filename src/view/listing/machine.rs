//! Robots and diagrams.

use super::Lines;
use super::condition::Conditions;
use super::fusion::fails;
use crate::base::Id;
use crate::ir::{Argument, Call, Diagram, Group, Kept, Platform, Program, Robot, Sense, Sensor};

pub(super) fn robot(lines: &mut Lines, program: &Program, robot: &Robot) {
    let provides: Vec<_> = robot.provides.iter().map(|id| program.interfaces[*id].symbol.name.as_str()).collect();
    let provides = if provides.is_empty() { String::new() } else { format!(" provides {}", provides.join(", ")) };
    lines.head(format_args!("robot {}{provides}", robot.symbol.name));
    for id in &robot.sensors {
        let Sensor { symbol, optional, unit, range: (low, high), fails: ways, noise, period, .. } =
            &program.sensors[*id];
        let optional = if *optional { "optional " } else { "" };
        let unit = unit.dimension.si_unit();
        let noise = if *noise > 0.0 { format!(" noise {noise}") } else { String::new() };
        let period = if *period > 0 { format!(" period {period} ns") } else { String::new() };
        let rest = format!("{}{noise}{period}", fails(ways));
        lines.add(1, format_args!("{optional}sensor {}: {unit} in {low} .. {high}{rest}", symbol.name));
    }
    senses(lines, program, &robot.senses);
    let mut conditions = Conditions::of_robot(program, robot);
    for id in &robot.logical {
        let Sensor { symbol, group, kept, .. } = &program.sensors[*id];
        if let Some(Group { how, of, readings }) = group {
            let of = of.iter().zip(readings).map(|(id, count)| {
                let name = &program.sensors[*id].symbol.name;
                if *count > 1 { format!("mean of {count} {name}") } else { name.clone() }
            });
            let (how, of) = (format!("{how:?}").to_lowercase(), of.collect::<Vec<_>>().join(", "));
            lines.add(1, format_args!("logical {} = {how} of {of}", symbol.name));
        } else if let Some(Kept { condition, .. }) = kept {
            lines.add(1, format_args!("logical {} = {}", symbol.name, conditions.text(*condition)));
        }
    }
    for id in &robot.actions {
        let action = &program.actions[*id];
        let parameters = action.parameters.iter();
        let parameters = parameters.map(|of| format!("{}: {}", of.symbol.name, of.unit.dimension.si_unit()));
        let done = if action.reports_done { " -> done" } else { "" };
        let parameters = parameters.collect::<Vec<_>>().join(", ");
        lines.add(1, format_args!("action {}({parameters}){done}", action.symbol.name));
    }
}

fn sensors(program: &Program, ids: impl Iterator<Item = Id<Sensor>>) -> String {
    ids.map(|id| program.sensors[id].symbol.name.as_str()).collect::<Vec<_>>().join(", ")
}

fn senses(lines: &mut Lines, program: &Program, senses: &[Sense]) {
    for sense in senses {
        let network = &program.networks[sense.network].symbol.name;
        let alias = if *network == sense.symbol.name { String::new() } else { format!("{} = ", sense.symbol.name) };
        lines.add(1, format_args!("sense {alias}{network}({})", sensors(program, sense.inputs.iter().copied())));
    }
}

pub(super) fn diagram(lines: &mut Lines, program: &Program, diagram: &Diagram) {
    let layer = diagram.layer.keyword();
    let platform = match diagram.platform {
        Platform::Robot(robot) => &program.robots[robot].symbol.name,
        Platform::Interface(interface) => &program.interfaces[interface].symbol.name,
    };
    lines.head(format_args!("{layer} {} on {platform}", diagram.symbol.name));
    senses(lines, program, &diagram.senses);
    if let Some(entry) = diagram.entry {
        lines.add(1, format_args!("entry {}", diagram.modes[entry].symbol.name));
    }
    let mut conditions = Conditions::new(program, diagram);
    for mode in diagram.modes.values() {
        let last = if mode.is_final { "final " } else { "" };
        let mut head = format!("{last}mode {}", mode.symbol.name);
        if !mode.requires.is_empty() {
            head += &format!(" requires {}", sensors(program, mode.requires.iter().map(|(sensor, _)| *sensor)));
        }
        if let Some(otherwise) = mode.otherwise {
            head += &format!(" else {}", diagram.modes[otherwise].symbol.name);
        }
        lines.add(1, head);
        for (when, calls) in [("", &mode.actions), ("on enter ", &mode.on_enter), ("on exit ", &mode.on_exit)] {
            for call in calls {
                lines.add(2, format_args!("{when}{}", command(program, diagram, call)));
            }
        }
        for row in mode.decision.iter().flat_map(|table| &table.rows) {
            let commands: Vec<_> = row.commands.iter().map(|call| command(program, diagram, call)).collect();
            let commands = if commands.is_empty() { "nothing".to_owned() } else { commands.join(" or ") };
            lines.add(2, format_args!("{} => {commands}", conditions.text(row.condition)));
        }
        for transition in &mode.transitions {
            let target = match transition.target {
                Some(_) if transition.again => "again",
                Some(target) => &diagram.modes[target].symbol.name,
                None => "?",
            };
            let condition = conditions.text(transition.condition);
            lines.add(2, format_args!("{}: {condition} -> {target}", transition.priority));
        }
    }
}

fn command(program: &Program, diagram: &Diagram, call: &Call) -> String {
    let arguments = call.arguments.iter().map(|argument| match argument {
        Argument::Reading(sensor) => program.sensors[*sensor].symbol.name.clone(),
        Argument::Constant(number) => number.to_string(),
        Argument::Random { low, high } => format!("random({low}, {high})"),
        Argument::Output { sense, output } => {
            let Sense { symbol, network, .. } = &diagram.senses[*sense as usize];
            format!("{}.{}", symbol.name, program.networks[*network].outputs[*output as usize].symbol.name)
        }
    });
    format!("{}({})", program.actions[call.action].symbol.name, arguments.collect::<Vec<_>>().join(", "))
}
