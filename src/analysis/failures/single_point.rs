//! Events of several sensors that can never be set again once some of these have failed.

use super::events::LostEvent;
use super::words::{failed, list};
use crate::diag::{Diagnostic, rules};

pub(super) fn single_point(lost: &LostEvent<'_>) -> Diagnostic {
    let LostEvent { event, asked, sets } = lost;
    let message = format!("`{}` can never be set with {}", event.symbol.name, failed(sets));
    let mut names: Vec<_> = sets.iter().flatten().map(|failed| failed.name).collect();
    names.sort_unstable();
    names.dedup();
    let help = format!("let some rule for it do without {}", list(names, "or"));
    let place = asked.unwrap_or(event.symbol.span);
    let diagnostic = Diagnostic::new(&rules::SINGLE_POINT_OF_FAILURE, place, message);
    match asked {
        None => diagnostic.here("no rule for it can win then").help(help),
        Some(_) => diagnostic
            .here("never holds then")
            .label(event.symbol.span, "no rule for it can win then")
            .help(format!("{help}, or say by `failed(...)` what this mode does once the failure is known")),
    }
}
