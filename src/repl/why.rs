//! Why a transition was taken, and why others were not.

use super::Refusal;
use super::session::{Session, Tick, not_yet};
use crate::interp::{Machine, Taken};
use crate::plan::{Part, Transition, Value};
use crate::sim;
use crate::verify::time;

/// The last change of mode, then why nothing followed.
pub(super) fn why(session: &Session<'_>) -> Result<String, Refusal> {
    let last = session.now.last.as_ref().ok_or_else(not_yet)?;
    let moved = session.now.moved.as_ref();
    let moved = moved.map(|(tick, machine)| tried(session, tick, machine));
    let stayed = (last.taken == Taken::Stayed).then(|| tried(session, last, &session.now.machine));
    Ok(moved.into_iter().chain(stayed).collect())
}

/// What became of each transition of the mode on a tick, with the parts of its condition.
fn tried(session: &Session<'_>, tick: &Tick, machine: &Machine<'_>) -> String {
    let plan = &session.driven.plan;
    let (at, from, to) = (time(tick.time), session.mode(tick.from), session.mode(machine.mode()));
    let range = &plan.modes[tick.from as usize].transitions;
    let transitions = range.clone().zip(&plan.transitions[range.start as usize..range.end as usize]);
    match tick.taken {
        Taken::Entered => return format!("  at {at}: {to} is the mode the machine starts in\n"),
        Taken::Lost { input, .. } => {
            let input = &plan.inputs[input as usize].name;
            return format!("  at {at}: {from} -> {to}, because {from} requires `{input}`, which has failed\n");
        }
        Taken::Handed => return format!("  at {at}: the robot is handed from {from} to {to}\n"),
        Taken::Stayed if range.is_empty() => return format!("  at {at}: {from} has no transitions\n"),
        Taken::Stayed | Taken::Transition(_) => {}
    }
    let mut out = match tick.taken {
        Taken::Stayed => format!("  at {at}: {from} is not left\n"),
        _ => format!("  at {at}: {from} -> {to}\n"),
    };
    for (index, transition) in transitions {
        let Transition { priority, text, target, condition, parts, .. } = transition;
        let fate = match tick.taken {
            Taken::Transition(taken) if index > taken => "not tried",
            _ if machine.bool(*condition) => "holds",
            _ => "does not hold",
        };
        out += &format!("    {priority}: {text} -> {}  {fate}\n", session.mode(*target));
        if fate == "not tried" {
            continue;
        }
        for part in parts {
            out += &line(session, tick, machine, part);
        }
        if let Some(missing) = missing(session, tick, *target).filter(|_| machine.bool(*condition)) {
            let target = session.mode(*target);
            out += &format!("         but {target} is inhibited: it requires `{missing}`, which has failed\n");
        }
    }
    out
}

fn line(session: &Session<'_>, tick: &Tick, machine: &Machine<'_>, part: &Part) -> String {
    let value = match part.value {
        Value::Truth(truth) => if machine.bool(truth) { "yes" } else { "no" }.to_owned(),
        Value::Number(number) => machine.real(number).to_string(),
    };
    let looks_at = part.evidence.iter();
    let looks_at =
        looks_at.map(|&of| sim::evidence(&session.driven.plan, of, &tick.readings, machine, tick.dwell).to_string());
    let looks_at = looks_at.collect::<Vec<_>>().join("; ");
    let (indent, text) = ("  ".repeat(part.depth as usize), &part.text);
    format!("       {indent}{value:3}  {text}  {looks_at}").trim_end().to_owned() + "\n"
}

/// The first sensor that a mode requires and that has failed.
fn missing<'s>(session: &Session<'s>, tick: &Tick, mode: u32) -> Option<&'s str> {
    let plan = &session.driven.plan;
    let required = &plan.modes[mode as usize].required;
    let required = &plan.required[required.start as usize..required.end as usize];
    let failed = required.iter().find(|input| !tick.readings[**input as usize].healthy)?;
    Some(&plan.inputs[*failed as usize].name)
}
