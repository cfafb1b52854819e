//! What an action, a shape, a network or a function takes, while it is being written.

use crate::ir::Action;

/// The parameters of an action with their units: `(speed: m/s, radius: m)`.
pub(super) fn form(action: &Action) -> String {
    let parameters = action.parameters.iter();
    let parameters = parameters.map(|parameter| format!("{}: {}", parameter.symbol.name, parameter.unit.text));
    format!("({})", parameters.collect::<Vec<_>>().join(", "))
}
