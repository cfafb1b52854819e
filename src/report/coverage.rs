//! What runs went through, and what none of them did, for people and as JSON.

use serde::Serialize;

use super::json::{SCHEMA, to_line};
use super::paint::Paint;
use super::places::Places;
use crate::base::Sources;
use crate::trace::{Coverage, Part};

/// Renders coverage for people: a line with the counts for each behavior and each network, below it a line for each
/// part that no run went through.
pub fn coverage(coverage: &Coverage, sources: &Sources, color: bool) -> String {
    let (places, paint) = (Places::new(sources), Paint { color });
    let mut text = String::new();
    for behavior in &coverage.behaviors {
        let counts = [count(&behavior.modes, "mode"), count(&behavior.transitions, "transition")].join(", ");
        text += &head(&paint, &behavior.name, behavior.scenarios, &counts);
        if behavior.scenarios > 0 {
            text += &missed(&behavior.modes, "never entered", &places, |part| part.text.clone());
            text += &missed(&behavior.transitions, "never taken", &places, |part| format!("{} {}", part.of, part.text));
        }
    }
    for network in &coverage.networks {
        text += &head(&paint, &network.name, network.scenarios, &count(&network.rules, "rule"));
        if network.scenarios > 0 {
            text += &missed(&network.rules, "never decides", &places, |part| format!("{} {}", part.of, part.text));
        }
    }
    text
}

fn head(paint: &Paint, name: &str, scenarios: usize, counts: &str) -> String {
    let name = paint.bold(name);
    match scenarios {
        0 => format!("coverage of {name}: no scenario runs it\n"),
        1 => format!("coverage of {name}: {counts} in 1 scenario\n"),
        _ => format!("coverage of {name}: {counts} in {scenarios} scenarios\n"),
    }
}

fn covered(parts: &[Part]) -> usize {
    parts.iter().filter(|part| part.covered).count()
}

fn count(parts: &[Part], what: &str) -> String {
    format!("{} of {} {what}{}", covered(parts), parts.len(), if parts.len() == 1 { "" } else { "s" })
}

fn missed(parts: &[Part], why: &str, places: &Places<'_>, name: impl Fn(&Part) -> String) -> String {
    let missed: Vec<_> = parts.iter().filter(|part| !part.covered).map(|part| (name(part), part.span)).collect();
    let width = missed.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
    let line = |(name, span): &(String, crate::base::Span)| {
        let (line, _) = places.position(span.file, span.start);
        format!("  {why:13}  {name:width$}  {}:{line}\n", places.path(span.file))
    };
    missed.iter().map(line).collect()
}

#[derive(Serialize)]
struct Line<'a> {
    schema: u32,
    coverage: Covered<'a>,
}

#[derive(Serialize)]
struct Covered<'a> {
    behaviors: Vec<Behavior<'a>>,
    networks: Vec<Network<'a>>,
}

#[derive(Serialize)]
struct Behavior<'a> {
    name: &'a str,
    scenarios: usize,
    modes: Counted<'a>,
    transitions: Counted<'a>,
}

#[derive(Serialize)]
struct Network<'a> {
    name: &'a str,
    scenarios: usize,
    rules: Counted<'a>,
}

#[derive(Serialize)]
struct Counted<'a> {
    total: usize,
    covered: usize,
    missed: Vec<Missed<'a>>,
}

#[derive(Serialize)]
struct Missed<'a> {
    of: &'a str,
    text: &'a str,
    file: &'a str,
    line: usize,
}

/// Renders coverage as one JSON object on one line. `missed` lists what no run went through: `of` is the mode, or the
/// event of a rule, `text` the part as written, `line` counts from 1.
pub fn coverage_json(coverage: &Coverage, sources: &Sources) -> String {
    let places = Places::new(sources);
    let counted = |parts| counted(parts, &places);
    let behaviors = coverage.behaviors.iter().map(|behavior| Behavior {
        name: &behavior.name,
        scenarios: behavior.scenarios,
        modes: counted(&behavior.modes),
        transitions: counted(&behavior.transitions),
    });
    let networks = coverage.networks.iter().map(|network| Network {
        name: &network.name,
        scenarios: network.scenarios,
        rules: counted(&network.rules),
    });
    let coverage = Covered { behaviors: behaviors.collect(), networks: networks.collect() };
    to_line(&Line { schema: SCHEMA, coverage })
}

fn counted<'a>(parts: &'a [Part], places: &Places<'a>) -> Counted<'a> {
    let missed = parts.iter().filter(|part| !part.covered).map(|part| {
        let (line, _) = places.position(part.span.file, part.span.start);
        Missed { of: &part.of, text: &part.text, file: places.path(part.span.file), line }
    });
    Counted { total: parts.len(), covered: covered(parts), missed: missed.collect() }
}
