//! For Mermaid, which Markdown pages of many sites draw.

use std::fmt::{self, Display, Write};

use super::{Arrow, Chart};

/// A diagram as a Mermaid state diagram.
pub fn mermaid(chart: &Chart) -> String {
    let mut text = "stateDiagram-v2\n".to_owned();
    let _ = writeln!(text, "    accTitle: {}", chart.name);
    for (index, mode) in chart.modes.iter().enumerate() {
        let required = (!mode.requires.is_empty()).then(|| format!("requires {}", mode.requires.join(", ")));
        let lines: Vec<_> =
            [&mode.name].into_iter().chain(&required).chain(&mode.commands).map(|line| Escaped(line)).collect();
        let lines: Vec<_> = lines.iter().map(Escaped::to_string).collect();
        let _ = writeln!(text, "    state \"{}\" as m{index}", lines.join("<br/>"));
    }
    if let Some(entry) = chart.entry {
        let _ = writeln!(text, "    [*] --> m{entry}");
    }
    for Arrow { from, to, priority, condition, is_lost, .. } in &chart.arrows {
        let priority = priority.map_or_else(String::new, |priority| format!("{priority}#58; "));
        // The language has no way to draw an arrow otherwise.
        let lost = if *is_lost { " (never taken)" } else { "" };
        let _ = writeln!(text, "    m{from} --> m{to}: {priority}{}{lost}", Escaped(condition));
    }
    for (index, _) in chart.modes.iter().enumerate().filter(|(_, mode)| mode.is_final) {
        let _ = writeln!(text, "    m{index} --> [*]");
    }
    let lost = chart.modes.iter().enumerate().filter(|(_, mode)| mode.is_lost).map(|(index, _)| format!("m{index}"));
    let lost: Vec<_> = lost.collect();
    if !lost.is_empty() {
        let _ = writeln!(text, "    classDef lost opacity:0.3\n    class {} lost", lost.join(","));
    }
    text
}

/// Text in which nothing means anything to Mermaid.
struct Escaped<'a>(&'a str);

impl Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for character in self.0.chars() {
            match character {
                '<' | '>' | '"' | '#' | ';' | ':' | '&' | '{' | '}' => write!(f, "#{};", u32::from(character))?,
                other => f.write_char(other)?,
            }
        }
        Ok(())
    }
}
