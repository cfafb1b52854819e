//! Arbiters: clients that never have their say, or that have it by chance.

use crate::diag::{Diagnostic, rules};
use crate::ir::{Arbiter, Client, Diagram, Program, Ties};

pub(super) fn check(program: &Program, arbiter: &Arbiter, findings: &mut Vec<Diagnostic>) {
    let in_order = arbiter.ties == Some(Ties::InOrder);
    for (index, client) in arbiter.clients.iter().enumerate() {
        let others = || arbiter.clients[..index].iter();
        if arbiter.ties.is_none()
            && let Some(other) = others().find(|other| shared(client, other).is_some())
        {
            findings.push(tie(other, client));
        }
        let all = arbiter.clients.iter().enumerate();
        let before = all.filter(|(other, _)| *other != index).find(|(place, other)| {
            let (highest, lowest) = (levels(client).min(), levels(other).max());
            let wins = lowest < highest || in_order && lowest == highest && *place < index;
            wins && always_proposes(&program.diagrams[other.diagram])
        });
        findings.extend(before.map(|(_, other)| never_wins(client, other)));
    }
}

/// The priorities that a client can have.
fn levels(client: &Client) -> impl Iterator<Item = u32> {
    client.priorities.iter().map(|(level, _)| *level)
}

/// A priority that two clients can have.
fn shared(one: &Client, other: &Client) -> Option<u32> {
    levels(one).find(|level| levels(other).any(|of_other| of_other == *level))
}

/// Whether a diagram gives a command on every tick, whatever its mode.
fn always_proposes(diagram: &Diagram) -> bool {
    diagram.modes.values().all(|mode| {
        let decides = mode.decision.as_ref().is_some_and(|table| table.rows.iter().all(|row| !row.commands.is_empty()));
        decides || !mode.actions.is_empty()
    })
}

fn tie(first: &Client, second: &Client) -> Diagnostic {
    let (one, other) = (&first.symbol.name, &second.symbol.name);
    let level = shared(second, first).unwrap_or_default();
    let message = format!("nothing says who wins of `{one}` and `{other}` at priority {level}");
    Diagnostic::new(&rules::TIE_WITHOUT_ORDER, second.symbol.span, message)
        .label(first.symbol.span, "the other one")
        .note("the first in the text wins, until you say so")
        .help("write `ties in_order` or `ties random`, or give them priorities of their own")
}

fn never_wins(client: &Client, other: &Client) -> Diagnostic {
    let (name, winner) = (&client.symbol.name, &other.symbol.name);
    Diagnostic::new(&rules::CLIENT_NEVER_WINS, client.symbol.span, format!("`{name}` never wins"))
        .label(other.symbol.span, format!("`{winner}` proposes a command on every tick, at a higher priority"))
        .help(format!("give `{name}` a smaller number, or let `{winner}` propose `nothing` sometimes"))
}
