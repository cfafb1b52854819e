//! Events of several sensors that stay set for ever once some of these have failed.

use super::events::LostEvent;
use super::words::failed;
use crate::diag::{Diagnostic, rules};

pub(super) fn stuck_event(lost: &LostEvent<'_>) -> Diagnostic {
    let LostEvent { event, asked, sets } = lost;
    let message = format!("`{}` is always set with {}", event.symbol.name, failed(sets));
    let help = "let some rule against it outweigh those for it that are left";
    let place = asked.unwrap_or(event.symbol.span);
    let diagnostic = Diagnostic::new(&rules::EVENT_STUCK_SET, place, message);
    match asked {
        None => diagnostic.here("the rules for it always win then").help(help),
        Some(_) => diagnostic
            .here("always holds then")
            .label(event.symbol.span, "the rules for it always win then")
            .help(format!("{help}, or say by `failed(...)` what this mode does once the failure is known")),
    }
}
