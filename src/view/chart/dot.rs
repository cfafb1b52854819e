//! For Graphviz.

use std::fmt::{self, Display, Write};

use super::{Arrow, Chart, ModeBox};

/// A diagram as a graph in the DOT language.
pub fn dot(chart: &Chart) -> String {
    let mut text = format!("digraph {} {{\n", Quoted(&chart.name));
    text += "    node [shape=box, style=rounded, fontname=\"Helvetica\"];\n    edge [fontname=\"Helvetica\", fontsize=11];\n";
    text += "    \"(entry)\" [shape=point, width=0.12];\n";
    for ModeBox { name, commands, requires, is_final, is_lost, .. } in &chart.modes {
        let required = (!requires.is_empty()).then(|| format!("requires {}", requires.join(", ")));
        let lines: Vec<_> = [name].into_iter().chain(&required).chain(commands).map(String::as_str).collect();
        let style = if requires.is_empty() { "" } else { ", style=\"rounded,dashed\"" };
        let border = if *is_final { ", peripheries=2" } else { "" };
        let gray = if *is_lost { GRAY } else { "" };
        let _ = writeln!(text, "    {} [label={}{style}{border}{gray}];", Quoted(name), Quoted(&lines.join("\n")));
    }
    if let Some(entry) = chart.entry {
        let _ = writeln!(text, "    \"(entry)\" -> {};", Quoted(&chart.modes[entry].name));
    }
    for Arrow { from, to, priority, condition, is_lost, .. } in &chart.arrows {
        let [from, to] = [from, to].map(|mode| &chart.modes[*mode].name);
        let label = priority.map_or_else(|| condition.clone(), |priority| format!("{priority}: {condition}"));
        let style = if priority.is_none() { ", style=dashed" } else { "" };
        let gray = if *is_lost { GRAY } else { "" };
        let _ = writeln!(text, "    {} -> {} [label={}{style}{gray}];", Quoted(from), Quoted(to), Quoted(&label));
    }
    text + "}\n"
}

/// What failed sensors take away.
const GRAY: &str = ", color=gray70, fontcolor=gray60";

/// A string of the language.
struct Quoted<'a>(&'a str);

impl Display for Quoted<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "\"{}\"", self.0.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', "\\n"))
    }
}
