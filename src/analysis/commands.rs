//! Commands that another command of the same mode overrides on the same tick.

use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Action, Call, Diagram, Platform, Program, Robot};

pub(super) fn check(diagram: &Diagram, program: &Program, findings: &mut Vec<Diagnostic>) {
    for mode in diagram.modes.values().filter(|mode| !mode.inherited) {
        // On the tick that enters a mode, its commands of every tick follow those on entry.
        let entering = mode.on_enter.iter().chain(&mode.actions);
        // Whatever a table chooses comes last; one row that gives a command is enough to say so.
        let decided = mode.decision.iter().flat_map(|table| &table.rows).find_map(|row| row.commands.first());
        for calls in [entering.chain(decided).collect::<Vec<&Call>>(), mode.on_exit.iter().collect()] {
            let mut to_body = calls.into_iter().filter(|call| moves_body(program, diagram, call.action));
            let Some(mut call) = to_body.next() else { continue };
            for later in to_body {
                findings.push(overridden(program, call, later));
                call = later;
            }
        }
    }
}

/// Whether an action is kept by a command of the body, on whatever robot the diagram runs.
fn moves_body(program: &Program, diagram: &Diagram, action: Id<Action>) -> bool {
    let action = &program.actions[action];
    let moves = |action: &Action| action.command.as_ref().is_some_and(|command| command.kind.moves());
    let keeps = |robot: &Robot| {
        let mut own = robot.actions.iter().map(|own| &program.actions[*own]);
        own.any(|own| own.symbol.name == action.symbol.name && moves(own))
    };
    match diagram.platform {
        Platform::Robot(_) => moves(action),
        Platform::Interface(interface) => {
            let mut robots = program.robots.values().filter(|robot| robot.provides.contains(&interface)).peekable();
            robots.peek().is_some() && robots.all(keeps)
        }
    }
}

fn overridden(program: &Program, call: &Call, later: &Call) -> Diagnostic {
    let [name, by] = [call, later].map(|call| &program.actions[call.action].symbol.name);
    Diagnostic::new(&rules::COMMAND_OVERRIDDEN, call.span, format!("`{name}` is overridden by `{by}` on the same tick"))
        .here("never carried out")
        .label(later.span, "given after it, to the same body")
        .note("a body does what it was last told on a tick, and the commands of a mode are given on every tick")
        .help("keep one of them, or give each a mode of its own")
}
