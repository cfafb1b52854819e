//! What an action, a shape, a network or a function takes, while it is being written.

use lsp_types::{Documentation, ParameterInformation, ParameterLabel, SignatureHelp, SignatureInformation};

use super::known::Known;
use super::place::{List, Place};
use crate::base::FileId;
use crate::ir::{Action, Program};
use crate::sema;

/// The parameters of an action with their units: `(speed: m/s, radius: m)`.
pub(super) fn form(action: &Action) -> String {
    let parameters = action.parameters.iter();
    let parameters = parameters.map(|parameter| format!("{}: {}", parameter.symbol.name, parameter.unit.text));
    in_parentheses(parameters)
}

fn in_parentheses(parameters: impl Iterator<Item = String>) -> String {
    format!("({})", parameters.collect::<Vec<_>>().join(", "))
}

/// What the list takes in whose parentheses a byte of a file lies.
pub(super) fn signature(known: &Known, file: FileId, byte: usize) -> Option<SignatureHelp> {
    let place = Place::new(known.text(file), byte)?;
    let list = place.list()?;
    let block = place.block().map_or("", |block| block.keyword);
    let is_sense = place.line().first() == Some(&"sense");
    let (form, doc) = match block {
        "variable" | "output" => (shape(list)?, String::new()),
        _ if is_sense => network(&known.analysis.program, list)?,
        _ => match function(list) {
            Some(form) => (form, String::new()),
            None => action(known, file, &list)?,
        },
    };
    Some(shown(list, &form, doc))
}

fn shape(list: List<'_>) -> Option<String> {
    sema::shapes().find(|(name, _)| *name == list.head).map(|(_, form)| form.to_owned())
}

fn function(list: List<'_>) -> Option<String> {
    if list.head == "random" {
        return Some("(low, high)".to_owned());
    }
    let known = sema::FUNCTIONS.iter().find(|(name, _)| *name == list.head);
    known.map(|(_, takes)| in_parentheses(takes.iter().map(|&parameter| parameter.to_owned())))
}

fn network(program: &Program, list: List<'_>) -> Option<(String, String)> {
    let network = program.networks.values().find(|network| network.symbol.name == list.head)?;
    let inputs = network.inputs.iter();
    let inputs = inputs.map(|input| {
        let variable = &program.variables[input.variable];
        format!("{}: {}", input.symbol.name, variable.unit.text)
    });
    Some((in_parentheses(inputs), network.symbol.doc.clone()))
}

/// The action that is called; one of a robot and its interface have the same form, so that any of that name in sight
/// tells.
fn action(known: &Known, file: FileId, list: &List<'_>) -> Option<(String, String)> {
    let program = &known.analysis.program;
    let called = known.name_at(file, list.head_end).and_then(|name| known.entity(name));
    let called = match called {
        Some(super::names::Entity::Action(id)) => Some(&program.actions[id]),
        _ => program.actions.values().find(|action| action.symbol.name == list.head),
    }?;
    Some((form(called), called.symbol.doc.clone()))
}

fn shown(list: List<'_>, form: &str, doc: String) -> SignatureHelp {
    let inside = form.strip_prefix('(').and_then(|form| form.strip_suffix(')')).unwrap_or(form);
    let parameters = inside.split(", ").filter(|parameter| !parameter.is_empty());
    let parameters = parameters.map(|parameter| ParameterInformation {
        label: ParameterLabel::Simple(parameter.to_owned()),
        documentation: None,
    });
    let signature = SignatureInformation {
        label: format!("{}{form}", list.head),
        documentation: (!doc.is_empty()).then_some(Documentation::String(doc)),
        parameters: Some(parameters.collect()),
        active_parameter: Some(list.position as u32),
    };
    SignatureHelp {
        signatures: vec![signature],
        active_signature: Some(0),
        active_parameter: Some(list.position as u32),
    }
}
