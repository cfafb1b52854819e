//! What is said of properties that are not proved.

use super::scenario::{time, written};
use super::told::Told;
use super::{Refuted, Subject};
use crate::diag::{Diagnostic, rules};
use crate::interp::Taken;
use crate::ir::Claim;

/// The most lines of a run that are shown; of longer ones the end.
const MOST_LINES: usize = 24;

pub(super) fn refuted(subject: &Subject<'_>, refuted: &Refuted) -> Diagnostic {
    let property = subject.property;
    let end = refuted.played.moments.last().map_or(0, |last| last.time);
    let what = match (property.claim, refuted.played.since) {
        (Claim::LeadsTo(_), Some(since)) => {
            format!("nothing answers by {} what held at {}", time(end), time(since))
        }
        (Claim::Always(_), _) => format!("its condition fails at {}", time(end)),
        (Claim::Never(_) | Claim::LeadsTo(_), _) => format!("its condition comes about at {}", time(end)),
    };
    let message = format!("`{}` does not hold: {what}", property.symbol.name);
    let diagnostic = Diagnostic::new(&rules::PROPERTY_REFUTED, property.symbol.span, message);
    let diagnostic = last_move(subject, refuted, diagnostic).note(story(subject, refuted));
    let diagnostic = match subject.provable {
        Some(provable) => diagnostic.note(format!("`within {}` is proved", time(provable))),
        None => diagnostic,
    };
    match &refuted.counterexample {
        Ok(shown) => diagnostic.help(format!("to watch it, add this scenario and run it\n\n{}", shown.text.trim_end())),
        Err(reason) => diagnostic.note(format!("no scenario can show it: {reason}")),
    }
}

/// Adds the place of the last move before the end.
fn last_move(subject: &Subject<'_>, refuted: &Refuted, diagnostic: Diagnostic) -> Diagnostic {
    let modes = &subject.checked.program().diagrams[subject.property.diagram].modes;
    let mode = |index: u32| modes[crate::base::Id::new(index)].symbol.span;
    let last = refuted.played.moments.iter().rev().find(|moment| moment.taken != Taken::Stayed);
    match last.map(|moment| (moment.taken, moment)) {
        Some((Taken::Transition(index), moment)) => {
            let span = refuted.plan.transitions[index as usize].span;
            diagnostic.label(span, format!("taken last, at {}", time(moment.time)))
        }
        Some((Taken::Lost { from, .. }, moment)) => {
            diagnostic.label(mode(from), format!("left at {}, without a sensor it requires", time(moment.time)))
        }
        Some((Taken::Entered | Taken::Stayed | Taken::Handed, moment)) => {
            diagnostic.label(mode(moment.mode), "the machine is here")
        }
        None => diagnostic,
    }
}

/// The run, one line for each tick on which something changes.
fn story(subject: &Subject<'_>, refuted: &Refuted) -> String {
    let Refuted { plan, played, tick, .. } = refuted;
    let name = |mode: u32| format!("`{}`", plan.modes[mode as usize].name);
    let mut lines = Vec::new();
    let mut told: Option<&Told> = None;
    let mut mode = plan.entry;
    for moment in &played.moments {
        let stretch = &played.stretches[moment.stretch];
        let mut changes = changes(refuted, told, &stretch.told);
        if stretch.done {
            changes.push("the action is done".to_owned());
        }
        let place = match moment.taken {
            Taken::Entered => format!("{} is entered", name(moment.mode)),
            Taken::Stayed => format!("in {}", name(moment.mode)),
            Taken::Transition(_) | Taken::Handed | Taken::Lost { .. } => {
                format!("{} -> {}", name(mode), name(moment.mode))
            }
        };
        changes.insert(0, format!("at {}: {place}", time(moment.time)));
        lines.push(changes.join("; "));
        told = Some(&stretch.told);
        mode = moment.mode;
    }
    let skipped = lines.len().saturating_sub(MOST_LINES);
    let first = match skipped {
        0 => format!("a run with ticks of {}:", time(*tick)),
        _ => format!("the end of a run with ticks of {}:", time(*tick)),
    };
    if let (Claim::LeadsTo(_), Some(last)) = (subject.property.claim, lines.last_mut()) {
        last.push_str("; still no answer");
    }
    lines.into_iter().skip(skipped).fold(first, |story, line| story + "\n" + &line)
}

/// What sensors say that they did not say before.
fn changes(refuted: &Refuted, before: Option<&Told>, now: &Told) -> Vec<String> {
    let inputs = refuted.plan.inputs.iter().enumerate();
    let change = |(index, input): (usize, &crate::plan::Input)| {
        let is_new = refuted.matters[index] && before.is_none_or(|before| before[index] != now[index]);
        is_new.then(|| match now[index] {
            Some(number) => format!("`{}` at {}", input.name, written(number, &input.unit)),
            None => format!("`{}` has failed", input.name),
        })
    };
    inputs.filter_map(change).collect()
}

pub(super) fn undecided(subject: &Subject<'_>, reason: &str) -> Diagnostic {
    let message = format!("`{}` is neither proved nor refuted", subject.property.symbol.name);
    let diagnostic = Diagnostic::new(&rules::PROPERTY_UNDECIDED, subject.property.symbol.span, message);
    diagnostic.note(reason).note("no run that breaks it was found either")
}
