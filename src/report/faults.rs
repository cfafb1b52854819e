//! The fault table: what is left of a machine under every set of failed sensors.

use std::fmt::Write;

use serde::Serialize;
use serde::ser::{SerializeMap, Serializer};

use super::json::{SCHEMA, to_line};
use super::paint::{Paint, wrap};
use crate::analysis::{EventRow, FaultRow, FaultTable, ModesRow, RuleRows};
use crate::ir::FailReading;

/// Renders the table as one JSON object on one line.
pub fn faults_json(table: &FaultTable, file: &str) -> String {
    let faults = table.rows.iter().map(Row).collect();
    to_line(&Table { schema: SCHEMA, file, faults })
}

#[derive(Serialize)]
struct Table<'a> {
    schema: u32,
    file: &'a str,
    faults: Vec<Row<'a>>,
}

struct Row<'a>(&'a FaultRow);

#[derive(Serialize)]
#[serde(untagged)]
enum Failed {
    Value(f64),
    Word(&'static str),
}

#[derive(Serialize)]
struct Event<'a> {
    can_set: bool,
    can_clear: bool,
    contributor: Option<&'a [Vec<String>]>,
    detractor: Option<&'a [Vec<String>]>,
    masked: Option<Masked>,
    witness_set: Option<Members<'a, f64>>,
}

#[derive(Serialize)]
struct Modes<'a> {
    reachable: &'a [String],
    unreachable: &'a [String],
    traps: &'a [String],
    inhibited: &'a [String],
}

#[derive(Serialize)]
struct Masked {
    contributor: usize,
    detractor: usize,
}

/// An object whose members stand in the order in which they are declared.
struct Members<'a, T>(Vec<(&'a str, T)>);

impl<T: Serialize> Serialize for Members<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let failed = self.0.failed.iter().map(|failed| {
            let how = match failed.reading {
                FailReading::Value(value) => Failed::Value(value.to_f64()),
                FailReading::Any => Failed::Word("any"),
                FailReading::Absent => Failed::Word("absent"),
            };
            (failed.sensor.as_str(), how)
        });
        let events = self.0.events.iter().map(|event| (event.name.as_str(), to_event(event)));
        let mut map = serializer.serialize_map(Some(4))?;
        map.serialize_entry("failed", &Members(failed.collect()))?;
        map.serialize_entry("events", &Members(events.collect()))?;
        map.serialize_entry("valuations", &self.0.valuations)?;
        let modes = self.0.modes.iter().map(|ModesRow { diagram, reachable, unreachable, traps, inhibited }| {
            (diagram.as_str(), Modes { reachable, unreachable, traps, inhibited })
        });
        map.serialize_entry("modes", &Members(modes.collect()))?;
        map.end()
    }
}

fn to_event(event: &EventRow) -> Event<'_> {
    let witness = event.witness_set.as_ref();
    Event {
        can_set: event.can_set,
        can_clear: event.can_clear,
        contributor: event.rules.as_ref().map(|rules| rules.contributor.as_slice()),
        detractor: event.rules.as_ref().map(|rules| rules.detractor.as_slice()),
        masked: event.rules.as_ref().map(|rules| Masked { contributor: rules.masked.0, detractor: rules.masked.1 }),
        witness_set: witness
            .map(|readings| Members(readings.iter().map(|(name, value)| (name.as_str(), *value)).collect())),
    }
}

/// Renders the table for people: for each set of failed sensors what every event can still do, the rules that are left
/// and what becomes of the modes; then all of it in sentences, in lines of at most `width` characters. `color` adds ANSI
/// escapes.
pub fn faults(table: &FaultTable, width: usize, color: bool) -> String {
    let paint = Paint { color };
    let mut out = String::new();
    for row in &table.rows {
        let _ = writeln!(out, "{}", paint.bold(&title(row)));
        for event in &row.events {
            let (word, bad) = ability(event);
            let word = if bad { paint.bad(word) } else { paint.good(word) };
            let _ = writeln!(out, "  {}  {word}", event.name);
            let _ = writeln!(out, "    for      {}", contributors(event, 8));
            let _ = writeln!(out, "    against  {}", detractors(event, 8));
        }
        for modes in &row.modes {
            let lines = mode_lines(modes);
            let lost =
                if lines.is_empty() { "every mode can be reached and left".to_owned() } else { lines.join("; ") };
            let _ = writeln!(out, "  {}  {lost}", modes.diagram);
        }
        out.push('\n');
    }
    if !table.summary.is_empty() {
        let _ = writeln!(out, "{}", paint.bold("in words"));
    }
    for sentence in &table.summary {
        let clauses: Vec<_> = sentence.split("; ").map(str::to_owned).collect();
        let _ = writeln!(out, "  {}", wrap(&clauses, width.saturating_sub(4)).join("\n    "));
    }
    out
}

/// What a behavior loses.
fn mode_lines(modes: &ModesRow) -> Vec<String> {
    let lists = [
        ("never reached", &modes.unreachable),
        ("never left", &modes.traps),
        ("inhibited once reported", &modes.inhibited),
    ];
    let lists = lists.iter().filter(|(_, names)| !names.is_empty());
    lists.map(|(what, names)| format!("{what}: {}", names.join(", "))).collect()
}

/// Renders the table as Markdown: the sentences, then one row for each set of failed sensors.
pub fn faults_markdown(table: &FaultTable) -> String {
    let names: Vec<_> = table.rows.first().map_or(&[][..], |row| &row.events).iter().map(|event| &event.name).collect();
    let heads: Vec<_> = names.iter().map(|name| format!(" {name} |")).collect();
    let mut out = String::new();
    for sentence in &table.summary {
        let _ = writeln!(out, "- {sentence}");
    }
    if !out.is_empty() {
        out.push('\n');
    }
    let _ = write!(out, "| failed |{} modes |\n|---|{}---|\n", heads.concat(), "---|".repeat(names.len()));
    for row in &table.rows {
        let _ = write!(out, "| {} |", title(row));
        for event in &row.events {
            let rules = contributors(event, 4);
            let _ = write!(out, " {}; for it: {rules} |", ability(event).0);
        }
        let modes: Vec<_> = row.modes.iter().flat_map(mode_lines).collect();
        let _ = writeln!(out, " {} |", modes.join("; "));
    }
    out
}

/// Renders the table as a page of its own: the sentences, then one row for each set of failed sensors.
pub fn faults_html(table: &FaultTable, file: &str) -> String {
    let cell = |text: &str| text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
    let mut rows = String::new();
    for row in &table.rows {
        let events: Vec<_> = row
            .events
            .iter()
            .map(|event| {
                let (word, bad) = ability(event);
                let class = if bad { "bad" } else { "good" };
                let rules = cell(&contributors(event, 4));
                format!("<td class=\"{class}\">{word}<br><small>{rules}</small></td>")
            })
            .collect();
        let modes = row.modes.iter().flat_map(mode_lines).map(|line| cell(&line)).collect::<Vec<_>>().join("<br>");
        let _ = writeln!(rows, "<tr><th>{}</th>{}<td>{modes}</td></tr>", cell(&title(row)), events.concat());
    }
    let names = table.rows.first().map_or(&[][..], |row| &row.events).iter();
    let heads = names.map(|event| format!("<th>{}</th>", cell(&event.name))).collect::<Vec<_>>().concat();
    let mut items = String::new();
    for sentence in &table.summary {
        // Every second backtick ends a name.
        let sentence = cell(sentence);
        let parts: Vec<_> = sentence.split('`').collect();
        let marked: Vec<_> = parts.chunks(2).map(|pair| pair.join("<code>")).collect();
        let _ = writeln!(items, "<li>{}</li>", marked.join("</code>"));
    }
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<title>Fault table of {0}</title>\n<style>\n\
         body {{ font: 15px/1.4 system-ui, sans-serif; margin: 2rem; color: #1b1b1b; background: #fff }}\n\
         table {{ border-collapse: collapse }}\n\
         th, td {{ border: 1px solid #ccc; padding: .4rem .6rem; text-align: left; vertical-align: top }}\n\
         .bad {{ background: #fde7e3 }} .good {{ background: #e8f4ea }} small {{ color: #555 }}\n\
         </style>\n<h1>Fault table of {0}</h1>\n<ul>\n{items}</ul>\n<table>\n<tr><th>failed</th>{heads}<th>modes</th></tr>\n{rows}</table>\n</html>\n",
        cell(file)
    )
}

fn title(row: &FaultRow) -> String {
    let failed: Vec<_> = row
        .failed
        .iter()
        .map(|failed| match failed.reading {
            FailReading::Value(value) => format!("{} = {}", failed.sensor, failed.unit.show(value.to_f64())),
            FailReading::Any => format!("{} stuck anywhere", failed.sensor),
            FailReading::Absent => format!("{} absent", failed.sensor),
        })
        .collect();
    if failed.is_empty() { "nothing failed".to_owned() } else { failed.join(", ") }
}

/// What an event can still do, and whether something is lost.
fn ability(event: &EventRow) -> (&'static str, bool) {
    match (event.can_set, event.can_clear) {
        (true, true) => ("can set and clear", false),
        (true, false) => ("is always set", true),
        (false, true) => ("can never be set", true),
        (false, false) => ("has no reading", true),
    }
}

fn contributors(event: &EventRow, most: usize) -> String {
    let list = |rules: &RuleRows| rule_list(&rules.contributor, rules.masked.0, most);
    event.rules.as_ref().map_or_else(too_many, list)
}

fn detractors(event: &EventRow, most: usize) -> String {
    let list = |rules: &RuleRows| rule_list(&rules.detractor, rules.masked.1, most);
    event.rules.as_ref().map_or_else(too_many, list)
}

fn too_many() -> String {
    "more rules than can be listed".to_owned()
}

fn rule_list(rules: &[Vec<String>], masked: usize, most: usize) -> String {
    let shown: Vec<_> = rules.iter().take(most).map(|rule| format!("({})", rule.join(", "))).collect();
    let more = rules.len().saturating_sub(most);
    let mut text = if shown.is_empty() { "no rule is left".to_owned() } else { shown.join(" ") };
    if more > 0 {
        let _ = write!(text, " and {more} more");
    }
    if masked > 0 {
        let _ = write!(text, "; {masked} masked");
    }
    text
}
