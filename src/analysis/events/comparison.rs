//! An event that is a comparison of one input with one number.

use super::Subject;
use crate::diag::{Diagnostic, rules};

pub(super) fn check(subject: &Subject<'_>, needless: &[usize], findings: &mut Vec<Diagnostic>) {
    if subject.has_hysteresis() || subject.is_large() {
        return;
    }
    let mut needed = subject.named_inputs();
    needed.retain(|input| !needless.contains(input));
    let [input] = needed[..] else { return };
    let Some(comparison) = subject.model.comparison(subject.index, input) else { return };
    let operator = match (comparison.above, comparison.inclusive) {
        (true, true) => ">=",
        (true, false) => ">",
        (false, true) => "<=",
        (false, false) => "<",
    };
    let number = subject.show(input, &comparison.reading);
    let message = format!(
        "the rules of `{}` say no more than `{} {operator} {number}`",
        subject.name(),
        subject.network.inputs[input].symbol.name
    );
    findings.push(
        Diagnostic::new(&rules::COMPARISON, subject.event.symbol.span, message)
            .note("whatever else is read, its contributor outweighs its detractor for exactly these readings"),
    );
}
