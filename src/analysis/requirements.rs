//! Modes that cannot do without a sensor.

use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Program};

pub(super) fn check(diagram: &Diagram, program: &Program, findings: &mut Vec<Diagnostic>) {
    for (id, mode) in diagram.modes.iter() {
        let Some(&(sensor, span)) = mode.requires.first() else { continue };
        let name = &mode.symbol.name;
        let optional = mode.requires.iter().find(|(sensor, _)| program.sensors[*sensor].optional);
        if let (Some(&(sensor, span)), true) = (optional, diagram.entry == Some(id)) {
            let sensor = &program.sensors[sensor];
            let message = format!("the entry mode `{name}` requires the optional sensor `{}`", sensor.symbol.name);
            findings.push(
                Diagnostic::new(&rules::ENTRY_REQUIRES, span, message)
                    .label(sensor.symbol.span, "declared optional here")
                    .note("a machine must be able to start whatever has failed"),
            );
        } else if mode.otherwise.is_none() && !mode.incomplete {
            let sensor = &program.sensors[sensor].symbol.name;
            let message = format!("`{name}` has nowhere to go when `{sensor}` fails while it is active");
            findings.push(
                Diagnostic::new(&rules::REQUIRES_WITHOUT_ELSE, span, message)
                    .note("`requires` keeps the machine from entering the mode; only `else` makes it leave")
                    .help(format!("write `mode {name} requires {sensor} else ...` with a mode that can do without it")),
            );
        }
    }
}
