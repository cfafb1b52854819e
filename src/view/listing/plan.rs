//! Plans: the steps in their order, with the numbered places that they read and write.

use std::ops::Range;

use super::Lines;
use crate::plan::{Call, Code, Input, NetworkPlan, Plan, Step, Value};

/// What is run and compiled, step by step. `reals` and `bools` are numbered apart.
pub fn plans(networks: &[NetworkPlan], diagrams: &[Plan]) -> String {
    let mut lines = Lines::default();
    for network in networks {
        lines.head(format_args!("network {}", network.name));
        inputs(&mut lines, &network.inputs);
        lines.add(1, "evaluate");
        steps(&mut lines, 2, &network.code, 0..network.code.steps.len() as u32);
        for event in &network.events {
            let (contributor, detractor) = (event.contributor, event.detractor);
            lines
                .add(1, format_args!("event {}: bool {}, reals {contributor} and {detractor}", event.name, event.flag));
        }
        for output in &network.outputs {
            lines.add(1, format_args!("output {}: real {}, fired bool {}", output.name, output.value, output.fired));
        }
    }
    for plan in diagrams {
        diagram(&mut lines, plan);
    }
    lines.0
}

fn inputs(lines: &mut Lines, inputs: &[Input]) {
    for (index, input) in inputs.iter().enumerate() {
        let Input { name, low, high, fail, .. } = input;
        lines.add(1, format_args!("input {index} {name} in {low} .. {high} fails {fail}"));
    }
}

fn diagram(lines: &mut Lines, plan: &Plan) {
    lines.head(format_args!("behavior {} on {}", plan.name, plan.robot));
    inputs(lines, &plan.inputs);
    for (when, of) in [("before the first tick", &plan.constants), ("on every tick", &plan.fuse)] {
        lines.add(1, when);
        steps(lines, 2, &plan.code, of.clone());
    }
    for logical in &plan.logical {
        match logical.value {
            Value::Truth(value) => lines.add(1, format_args!("logical {}: bool {value}", logical.name)),
            Value::Number(value) => lines.add(1, format_args!("logical {}: real {value}", logical.name)),
        }
    }
    for event in &plan.events {
        let (contributor, detractor) = (event.contributor, event.detractor);
        lines.add(1, format_args!("event {}: bool {}, reals {contributor} and {detractor}", event.name, event.flag));
    }
    for (index, mode) in plan.modes.iter().enumerate() {
        let entry = if index == plan.entry as usize { ", the entry" } else { "" };
        lines.add(1, format_args!("mode {index} {}{entry}", mode.name));
        for input in &plan.required[span(&mode.required)] {
            lines.add(2, format_args!("requires input {input}"));
        }
        if let Some(otherwise) = mode.otherwise {
            lines.add(2, format_args!("else mode {otherwise}"));
        }
        for draw in &plan.draws[span(&mode.draws)] {
            lines.add(2, format_args!("draws real {} from {} to {}", draw.to, draw.low, draw.high));
        }
        for (when, of) in [("", &mode.actions), ("on enter ", &mode.on_enter), ("on exit ", &mode.on_exit)] {
            for call in &plan.calls[span(of)] {
                lines.add(2, format_args!("{when}{}", command(plan, call)));
            }
        }
        for row in &plan.rows[span(&mode.rows)] {
            let commands: Vec<_> = plan.calls[span(&row.calls)].iter().map(|call| command(plan, call)).collect();
            let commands = if commands.is_empty() { "nothing".to_owned() } else { commands.join(" or ") };
            lines.add(2, format_args!("bool {} => {commands}", row.condition));
            steps(lines, 3, &plan.code, row.steps.clone());
        }
        for transition in &plan.transitions[span(&mode.transitions)] {
            let (priority, target) = (transition.priority, &plan.modes[transition.target as usize].name);
            lines.add(2, format_args!("{priority}: bool {} -> {target}", transition.condition));
            steps(lines, 3, &plan.code, transition.steps.clone());
        }
    }
}

fn command(plan: &Plan, call: &Call) -> String {
    let arguments = plan.arguments[span(&call.arguments)].iter().map(|real| format!("real {real}"));
    format!("{}({})", plan.actions[call.action as usize].name, arguments.collect::<Vec<_>>().join(", "))
}

fn steps(lines: &mut Lines, depth: usize, code: &Code, of: Range<u32>) {
    for (index, step) in of.clone().zip(&code.steps[span(&of)]) {
        let list = match step {
            Step::Group { of, .. } | Step::Minimum { of, .. } | Step::Maximum { of, .. } => {
                format!(" of reals {:?}", &code.real_lists[span(of)])
            }
            Step::All { of, .. } | Step::Any { of, .. } => format!(" of bools {:?}", &code.bool_lists[span(of)]),
            _ => String::new(),
        };
        lines.add(depth, format_args!("{index}: {step:?}{list}"));
    }
}

fn span(range: &Range<u32>) -> Range<usize> {
    range.start as usize..range.end as usize
}
