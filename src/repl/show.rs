//! What is shown of the state.

use super::name::Watched;
use super::session::Session;
use crate::interp::{Reading, Taken};
use crate::plan::{Evidence, Input, Real};
use crate::report::{self, Evaluated};
use crate::sim;
use crate::verify::{readings, time, written};

/// The last change of mode: when, from where to where, and by what.
pub(super) fn change(session: &Session<'_>) -> String {
    let Some((tick, machine)) = &session.now.moved else { return String::new() };
    let (plan, from, to) = (&session.driven.plan, session.mode(tick.from), session.mode(machine.mode()));
    let way = match tick.taken {
        Taken::Entered => format!("{to} is entered"),
        Taken::Transition(index) => {
            let transition = &plan.transitions[index as usize];
            format!("{from} -> {to}  {}: {}", transition.priority, transition.text)
        }
        Taken::Lost { input, .. } => {
            format!("{from} -> {to}  `{}` has failed, which {from} requires", plan.inputs[input as usize].name)
        }
        Taken::Handed => format!("{from} -> {to}"),
        Taken::Stayed => return String::new(),
    };
    format!("  at {}: {way}\n", time(tick.time))
}

/// Where the machine is now.
pub(super) fn place(session: &Session<'_>) -> String {
    match &session.now.last {
        Some(tick) => format!("  at {}: in {}\n", time(tick.time), session.now.machine.place()),
        None => format!("  before the first tick of {}\n", session.driven.plan.name),
    }
}

/// The mode, what it commands, and what the sensors say.
pub(super) fn state(session: &Session<'_>) -> String {
    let (plan, now) = (&session.driven.plan, &session.now);
    let mut out = place(session);
    for (action, arguments) in &now.commands {
        let action = &plan.actions[*action as usize];
        let arguments = action.parameters.iter().zip(arguments).map(|((_, unit), value)| unit.show(*value));
        out += &format!("  commands {}({})\n", action.name, arguments.collect::<Vec<_>>().join(", "));
    }
    if now.done {
        out += "  the action will be done on the next tick\n";
    }
    let width = plan.inputs.iter().map(|input| input.name.chars().count()).max().unwrap_or(0);
    for ((input, value), failed) in plan.inputs.iter().zip(&now.values).zip(&now.failed) {
        let said = if *failed { "failed".to_owned() } else { written(*value, &input.unit) };
        out += &format!("  {:width$}  {said}\n", input.name);
    }
    out
}

/// The degrees, strengths and events of a sensed network on the last tick.
pub(super) fn degrees(session: &Session<'_>, network: usize) -> String {
    let plan = &session.driven.networks[network];
    let all = session.now.last.as_ref().map_or_else(|| readings(&session.now.told()), |tick| tick.readings.clone());
    let inputs = session.driven.plan.inputs.iter();
    let machine = &session.now.machine;
    let reading = |(input, &real): (&Input, &Real)| {
        let place = inputs.clone().position(|own| own.name == input.name);
        place.map_or_else(|| Reading { value: machine.real(real), healthy: true }, |place| all[place])
    };
    let readings: Vec<_> = plan.inputs.iter().zip(&session.driven.plan.senses[network].readings).map(reading).collect();
    report::eval(&Evaluated { plan, evaluator: &session.now.evaluators[network], readings: &readings }, session.color)
}

/// What is watched, a line each.
pub(super) fn watched(session: &Session<'_>) -> String {
    let Some(tick) = &session.now.last else { return String::new() };
    let (plan, machine) = (&session.driven.plan, &session.now.machine);
    let evidence = |of| sim::evidence(plan, of, &tick.readings, machine, tick.dwell).text;
    let yes_no = |holds| if holds { "yes" } else { "no" };
    let said = |watched: &Watched<'_>| match *watched {
        Watched::Input(index) => evidence(Evidence::Input(index as u32)),
        Watched::Logical(index) => evidence(Evidence::Logical(index as u32)),
        Watched::Event(index) => {
            let holds = yes_no(machine.bool(plan.events[index].flag));
            format!("{holds}: {}", evidence(Evidence::Event(index as u32)))
        }
        Watched::Flag(index) => yes_no(machine.bool(plan.flags[index].value)).to_owned(),
        Watched::Output(index) => plan.outputs[index].unit.show(machine.real(plan.outputs[index].value)),
        Watched::Condition(ref twin) => yes_no(twin.holds()).to_owned(),
    };
    let watched = &session.now.watched;
    let width = watched.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    watched.iter().fold(String::new(), |out, (name, watched)| out + &format!("  {name:width$}  {}\n", said(watched)))
}

/// Whether each watched event, flag or condition holds; nothing of what is a number, or before the first tick.
pub(super) fn watched_truths(session: &Session<'_>) -> Vec<Option<bool>> {
    let (plan, machine) = (&session.driven.plan, &session.now.machine);
    let holds = |watched: &Watched<'_>| match *watched {
        Watched::Event(index) => Some(machine.bool(plan.events[index].flag)),
        Watched::Flag(index) => Some(machine.bool(plan.flags[index].value)),
        Watched::Condition(ref twin) => Some(twin.holds()),
        Watched::Input(_) | Watched::Logical(_) | Watched::Output(_) => None,
    };
    session.now.watched.iter().map(|(_, watched)| holds(watched)).collect()
}

/// What is watched and has changed on the last tick.
pub(super) fn watched_changes(session: &Session<'_>, before: &[Option<bool>]) -> String {
    let now = watched_truths(session);
    let at = time(session.now.time);
    let changed = session.now.watched.iter().zip(now.iter().zip(before)).filter(|(_, (now, before))| now != before);
    let line = |name: &str, watched: &Watched<'_>, holds: bool| {
        let change = match (watched, holds) {
            (Watched::Condition(_), true) => "holds",
            (Watched::Condition(_), false) => "holds no more",
            (_, true) => "is set",
            (_, false) => "is cleared",
        };
        format!("  at {at}: {name} {change}\n")
    };
    changed.filter_map(|((name, watched), (now, _))| now.map(|holds| line(name, watched, holds))).collect()
}
