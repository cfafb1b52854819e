//! What there is to know of a name: its declaration, its comment, its numbers, and what the checker knows.

use lsp_types::{Hover, HoverContents, MarkupContent, MarkupKind};

use super::drawing::drawing;
use super::known::Known;
use super::names::Entity;
use crate::analysis::modes::{ModeFacts, fault_table};
use crate::analysis::network::{EventFacts, RuleFacts, Verdict, analyze};
use crate::analysis::timing;
use crate::base::{Exact, FileId, Id, Span, Unit, show_time};
use crate::diag::{Severity, rules};
use crate::ir::{Diagram, Group, Mode, Network, Program, Sensor, Symbol, Term, Transition};

/// What is known of what stands at a byte of a file.
pub(super) fn hover(known: &Known, file: FileId, byte: usize) -> Option<Hover> {
    let (place, text) = match known.name_at(file, byte).and_then(|name| Some((name, known.entity(name)?))) {
        Some((name, entity)) => (name, of_entity(known, entity)),
        None => of_priority(known, file, byte)?,
    };
    let contents = HoverContents::Markup(MarkupContent { kind: MarkupKind::Markdown, value: text });
    Some(Hover { contents, range: Some(known.range(place)) })
}

/// A text in parts, with a line of its own between them.
#[derive(Default)]
struct Page(Vec<String>);

impl Page {
    fn code(&mut self, text: &str) {
        self.0.push(format!("```lmsl\n{}\n```", text.trim_end()));
    }

    fn drawing(&mut self, text: &str) {
        self.0.push(format!("```text\n{}\n```", text.trim_end_matches('\n')));
    }

    fn text(&mut self, text: impl Into<String>) {
        let text = text.into();
        if !text.is_empty() {
            self.0.push(text);
        }
    }
}

fn of_entity(known: &Known, entity: Entity) -> String {
    let program = &known.analysis.program;
    let symbol = symbol(program, entity);
    let mut page = Page::default();
    page.code(head(known, symbol.span));
    page.text(symbol.doc.as_str());
    match entity {
        Entity::Variable(id) => {
            let variable = &program.variables[id];
            page.drawing(&drawing(&variable.terms, variable.range, &variable.unit));
            page.text(in_si(variable.range, &variable.unit));
        }
        Entity::Term(id, at) => {
            let variable = &program.variables[id];
            page.drawing(&drawing(variable.terms.get(at), variable.range, &variable.unit));
            page.text(format!("a term of `{}`", variable.symbol.name));
        }
        Entity::Input(id, at) => {
            let variable = &program.variables[program.networks[id].inputs[at].variable];
            page.drawing(&drawing(&variable.terms, variable.range, &variable.unit));
            page.text(format!("an input of `{}`", program.networks[id].symbol.name));
        }
        Entity::Output(id, at) => outputs_terms(&mut page, program, id, at, None),
        Entity::OutputTerm(id, at, term) => outputs_terms(&mut page, program, id, at, Some(term)),
        Entity::Network(id) | Entity::Event(id, _) => {
            let network = &program.networks[id];
            let one = if let Entity::Event(_, at) = entity { Some(at) } else { None };
            if one.is_some() {
                page.text(format!("an event of `{}`", network.symbol.name));
            }
            page.text(events(known, id, network, one));
        }
        Entity::Sensor(id) => {
            let sensor = &program.sensors[id];
            if let Some(group) = &sensor.group {
                let of = group.of.iter().map(|&id| format!("`{}`", program.sensors[id].symbol.name));
                let how = format!("{:?}", group.how).to_lowercase();
                page.text(format!("{how} of {}", of.collect::<Vec<_>>().join(", ")));
                page.text(means(program, group));
            }
            if let Some(kept) = &sensor.kept {
                let condition = known.analysis.sources.slice(program.exprs[kept.condition].span);
                page.text(format!("set where `{}`", condition.split_whitespace().collect::<Vec<_>>().join(" ")));
            }
            page.text(in_si(sensor.range, &sensor.unit));
            page.text(if sensor.optional { "A robot can do without it." } else { "" });
        }
        Entity::Parameter(id, _) => page.text(format!("a parameter of `{}`", program.actions[id].symbol.name)),
        Entity::Action(id) if program.actions[id].reports_done => {
            page.text("It reports completion: `done` holds then.");
        }
        Entity::Mode(id, mode) => {
            page.text(mode_facts(known, id, mode));
            page.text(reactions(program, id, Some(mode)));
        }
        Entity::Flag(id, _) | Entity::Sense(id, _) => page.text(format!("of `{}`", program.diagrams[id].symbol.name)),
        Entity::Diagram(id) => {
            let modes = program.diagrams[id].modes.values().map(|mode| format!("`{}`", mode.symbol.name));
            page.text(format!("modes: {}", modes.collect::<Vec<_>>().join(", ")));
            page.text(reactions(program, id, None));
        }
        Entity::Property(id) => page.text(format!("`{}`", program.properties[id].text)),
        Entity::Interface(_) | Entity::Robot(_) | Entity::Action(_) | Entity::World(_) | Entity::Scenario(_) => {}
    }
    page.0.join("\n\n")
}

/// How many readings a logical sensor takes the mean of, and how long they take.
fn means(program: &Program, group: &Group) -> String {
    let several = group.of.iter().zip(&group.readings).filter(|(_, count)| **count > 1);
    let several = several.map(|(&id, &count)| {
        let Sensor { symbol, period, .. } = &program.sensors[id];
        (symbol.name.split('[').next().unwrap_or_default(), count, period.saturating_mul(count.into()))
    });
    let mut several: Vec<_> = several.collect();
    several.dedup();
    let lines = several.into_iter().map(|(name, count, time)| {
        format!("`{name}` is the mean of its last {count} readings, which take {}.", show_time(time))
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// What a mode, or an arbiter, can do about an obstacle in its way.
fn reactions(program: &Program, diagram: Id<Diagram>, mode: Option<Id<Mode>>) -> String {
    let reactions = timing::reactions(program, diagram).into_iter().filter(|reaction| reaction.mode == mode);
    let lines = reactions.map(|reaction| format!("In its way: {}.", reaction.told(program)));
    lines.collect::<Vec<_>>().join("\n\n")
}

fn symbol(program: &Program, entity: Entity) -> &Symbol {
    match entity {
        Entity::Variable(id) => &program.variables[id].symbol,
        Entity::Term(id, at) => &program.variables[id].terms[at].symbol,
        Entity::Network(id) => &program.networks[id].symbol,
        Entity::Input(id, at) => &program.networks[id].inputs[at].symbol,
        Entity::Event(id, at) => &program.networks[id].events[at].symbol,
        Entity::Output(id, at) => &program.networks[id].outputs[at].symbol,
        Entity::OutputTerm(id, at, term) => &program.networks[id].outputs[at].terms[term].symbol,
        Entity::Interface(id) => &program.interfaces[id].symbol,
        Entity::Robot(id) => &program.robots[id].symbol,
        Entity::Sensor(id) => &program.sensors[id].symbol,
        Entity::Action(id) => &program.actions[id].symbol,
        Entity::Parameter(id, at) => &program.actions[id].parameters[at].symbol,
        Entity::Diagram(id) => &program.diagrams[id].symbol,
        Entity::Sense(id, at) => &program.diagrams[id].senses[at].symbol,
        Entity::Flag(id, flag) => &program.diagrams[id].flags[flag].symbol,
        Entity::Mode(id, mode) => &program.diagrams[id].modes[mode].symbol,
        Entity::World(id) => &program.worlds[id].symbol,
        Entity::Scenario(id) => &program.scenarios[id].symbol,
        Entity::Property(id) => &program.properties[id].symbol,
    }
}

/// The line of a declaration up to what stands in its braces, without its comment.
fn head(known: &Known, name: Span) -> &str {
    let text = known.text(name.file);
    let (before, after) = text.split_at(text.floor_char_boundary(name.range().start));
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let end = before.len() + after.find(['\n', '{']).unwrap_or(after.len());
    let line = text.get(start..end).unwrap_or("");
    line.split("//").next().unwrap_or("").trim()
}

/// A range in SI, where it is written in something else.
fn in_si((low, high): (Exact, Exact), unit: &Unit) -> String {
    if unit.scale == Exact::ONE {
        return String::new();
    }
    format!("in SI: {} .. {} {}", low.to_f64(), high.to_f64(), unit.dimension.si_unit())
}

fn outputs_terms(page: &mut Page, program: &Program, id: Id<Network>, at: usize, only: Option<usize>) {
    let output = &program.networks[id].outputs[at];
    if let Some(range) = output.range.filter(|_| !output.terms.is_empty()) {
        let terms = output.terms.iter().enumerate().filter(|(term, _)| only.is_none_or(|only| only == *term));
        let terms: Vec<&Term> = terms.map(|(_, term)| term).collect();
        page.drawing(&drawing(terms, range, &output.unit));
    }
    page.text(format!("an output of `{}`", program.networks[id].symbol.name));
}

/// Whether nothing is broken, so that what is proved holds. A property that is refuted breaks nothing.
fn is_whole(known: &Known) -> bool {
    let errors = known.analysis.findings.iter().filter(|finding| finding.severity == Severity::Error);
    errors.map(|finding| finding.rule).all(|rule| rule == &rules::PROPERTY_REFUTED)
}

/// What is proved of the events of a network while no sensor has failed; nothing in a program with errors.
fn events(known: &Known, id: Id<Network>, network: &Network, only: Option<usize>) -> String {
    if !is_whole(known) {
        return String::new();
    }
    let facts = analyze(&known.analysis.program, id, 0);
    let Some(facts) = facts.first() else { return String::new() };
    let shown = network.events.iter().zip(&facts.events).enumerate();
    let shown = shown.filter(|(at, _)| only.is_none_or(|only| only == *at));
    let lines = shown.map(|(_, (event, facts))| format!("- `{}`: {}", event.symbol.name, event_facts(facts)));
    lines.collect::<Vec<_>>().join("\n")
}

fn event_facts(facts: &EventFacts) -> String {
    let status = match (facts.set.is_possible(), facts.clear.is_possible()) {
        (true, true) => "some readings set it, others do not",
        (false, _) => "never set",
        (_, false) => "always set",
    };
    let rules = [("contributor", &facts.contributor), ("detractor", &facts.detractor)];
    let sides = rules.map(|(side, rules)| format!("{side} {}", rule_facts(rules)));
    format!("{status}; {}", sides.join("; "))
}

fn rule_facts(rules: &[RuleFacts]) -> String {
    let count = |is: &dyn Fn(&RuleFacts) -> bool| rules.iter().filter(|rule| is(rule)).count();
    let decisive = count(&|rule| matches!(rule.decisive, Verdict::Possible(_)));
    let silent = count(&|rule| rule.fires == Verdict::Never);
    let idle = if silent > 0 { format!(", {silent} never fire") } else { String::new() };
    format!("of {} rule{}, {decisive} decisive{idle}", rules.len(), if rules.len() == 1 { "" } else { "s" })
}

/// What is proved of a mode while no sensor has failed.
fn mode_facts(known: &Known, id: Id<Diagram>, mode: Id<Mode>) -> String {
    let diagram = &known.analysis.program.diagrams[id];
    let Some(facts) = facts(known, id, mode) else { return String::new() };
    let reached = match facts.reachable {
        true if diagram.entry == Some(mode) => "The entry",
        true => "Reached",
        false => "Never reached while no sensor has failed",
    };
    let exits = diagram.modes[mode].transitions.iter().zip(&facts.exits);
    let exits = exits.map(|(transition, taken)| {
        let taken = if taken.is_some() { "" } else { ", never taken" };
        format!("- {}: to `{}`{taken}", transition.priority, target(diagram, transition))
    });
    let exits: Vec<_> = exits.collect();
    format!("{reached}; exits while no sensor has failed:\n{}", exits.join("\n"))
}

fn facts(known: &Known, id: Id<Diagram>, mode: Id<Mode>) -> Option<ModeFacts> {
    if !is_whole(known) {
        return None;
    }
    let table = fault_table(&known.analysis.program, id, 0);
    table.first()?.modes.get(mode.index()).cloned()
}

fn target<'a>(diagram: &'a Diagram, transition: &Transition) -> &'a str {
    match transition.target {
        Some(target) if !transition.again => &diagram.modes[target].symbol.name,
        _ => "again",
    }
}

/// What is known of the transition whose priority stands at a byte.
fn of_priority(known: &Known, file: FileId, byte: usize) -> Option<(Span, String)> {
    for (id, diagram) in known.analysis.program.diagrams.iter() {
        for (mode, declared) in diagram.modes.iter().filter(|(_, mode)| !mode.inherited) {
            let touches = |transition: &&Transition| {
                let span = transition.priority_span;
                span.file == file && span.range().start <= byte && byte <= span.range().end
            };
            let Some(at) = declared.transitions.iter().position(|transition| touches(&transition)) else { continue };
            let transition = &declared.transitions[at];
            let taken = facts(known, id, mode).and_then(|facts| facts.exits.get(at).map(Option::is_some));
            let taken = match taken {
                Some(true) => "; it can be taken",
                Some(false) => "; it is never taken while no sensor has failed",
                None => "",
            };
            let (from, to) = (&declared.symbol.name, target(diagram, transition));
            let text = format!("exit {} of `{from}`, to `{to}`{taken}", transition.priority);
            return Some((transition.priority_span, text));
        }
    }
    None
}
