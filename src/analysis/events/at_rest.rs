//! A flag that the least noise changes while the robot is at rest.

use super::{HEALTHY, Subject};
use crate::analysis::network::{Reading, Witness};
use crate::base::{Dimension, Exact, Fraction};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Event, Network, Program};

/// What is 0 for a robot that stands still and touches nothing. Where a distance or a voltage rests, nobody knows.
const ZERO_AT_REST: [Dimension; 6] = [
    Dimension::SPEED,
    Dimension::ACCELERATION,
    Dimension::TURN_RATE,
    Dimension::of([0, 0, -2, 0, 0, 1]),
    Dimension::FORCE,
    Dimension::of([2, 1, -2, 0, 0, 0]),
];

pub(super) fn check(subject: &Subject<'_>, findings: &mut Vec<Diagnostic>) {
    if subject.has_memory() || subject.is_large() {
        return;
    }
    let Some(rest) = rest(subject.program, subject.network, subject.event) else { return };
    let margins = subject.model.margins(subject.index, &HEALTHY, &subject.model.complete(&HEALTHY, &rest));
    let is_zero = |reading: &Option<Reading>| reading.as_ref().is_some_and(|margin| margin.fraction.is_zero());
    let unsteady: Vec<_> = (0..margins.len()).filter(|&input| is_zero(&margins[input])).collect();
    if !unsteady.is_empty() {
        findings.push(flickers(subject, &unsteady, &rest));
    }
}

/// The readings of the inputs that an event names while the robot stands still and touches nothing: all are 0. `None`
/// where one of them need not be.
pub(super) fn rest(program: &Program, network: &Network, event: &Event) -> Option<Witness> {
    let mut readings = vec![None; network.inputs.len()];
    for clause in event.contributor.iter().chain(&event.detractor).flat_map(|rule| &rule.clauses) {
        let variable = &program.variables[network.inputs[clause.input as usize].variable];
        let (low, high) = variable.range;
        if !ZERO_AT_REST.contains(&variable.unit.dimension) || low > Exact::ZERO || high < Exact::ZERO {
            return None;
        }
        readings[clause.input as usize] = Some(Reading { fraction: Fraction::ZERO, pi: 0 });
    }
    Some(Witness { readings })
}

fn flickers(subject: &Subject<'_>, unsteady: &[usize], rest: &Witness) -> Diagnostic {
    let message = format!("the least noise changes `{}` while the robot is at rest", subject.name());
    Diagnostic::new(&rules::UNSTEADY_AT_REST, subject.event.symbol.span, message)
        .note(format!(
            "at rest means {}; any other reading of {} may do it",
            subject.at(rest),
            subject.inputs(unsteady)
        ))
        .help("let the terms begin a little away from rest, or give the event `hysteresis`")
}
