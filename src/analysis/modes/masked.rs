//! A transition that is never taken, because a higher one always is.

use std::collections::BTreeSet;

use super::Subject;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) -> bool {
    let is_masked = subject.exit().taken.is_none() && subject.exit().holds;
    if is_masked {
        findings.push(masked(subject));
    }
    is_masked
}

/// The fewest higher transitions of which one can be taken whenever this one could; all that ever do beyond pairs.
fn masking(subject: &Subject<'_>) -> Vec<usize> {
    let masks: BTreeSet<u64> = subject.exit().masks.iter().copied().filter(|mask| *mask != 0).collect();
    let higher = 0..subject.index.min(64);
    let covers = |wanted: u64| masks.iter().all(|mask| mask & wanted != 0);
    if let Some(single) = higher.clone().find(|index| covers(1 << index)) {
        return vec![single];
    }
    let pairs = higher.clone().flat_map(|first| (0..first).map(move |second| (second, first)));
    if let Some((first, second)) = pairs.into_iter().find(|(first, second)| covers(1 << first | 1 << second)) {
        return vec![first, second];
    }
    higher.filter(|index| masks.iter().any(|mask| mask >> index & 1 == 1)).collect()
}

fn masked(subject: &Subject<'_>) -> Diagnostic {
    let transition = subject.transition();
    let message = format!("the transition to {} can never be taken", subject.to());
    let masking = masking(subject);
    let whenever = match masking.len() {
        1 => "holds whenever the lower one does",
        _ => "one of these holds whenever the lower one does",
    };
    let mut diagnostic = Diagnostic::new(&rules::MASKED_TRANSITION, transition.span, message)
        .here("a higher transition is taken instead")
        .note("of the transitions whose conditions hold, the one with the smallest number is taken");
    for index in masking.iter().take(3) {
        diagnostic = diagnostic.label(subject.condition_span(&subject.mode.transitions[*index]), whenever);
    }
    diagnostic.help("give the narrower condition the smaller number")
}
