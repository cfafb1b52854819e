//! Mode switching diagrams as pictures (LMSL fig. 7): boxes for modes, arrows for transitions with their priorities.

mod dot;
mod drawing;
mod layout;
mod mermaid;

pub use dot::dot;
pub use drawing::svg;
pub use mermaid::mermaid;

use crate::base::{Id, Sources, Span};
use crate::ir::{Call, Diagram, Mode, Program, Sensor, Transition};

/// What a picture of a diagram shows, in the words of the source.
#[derive(Debug)]
pub struct Chart {
    /// The diagram's name.
    pub name: String,
    /// Its modes in the order of the diagram.
    pub modes: Vec<ModeBox>,
    /// Its transitions, mode by mode and by priority.
    pub arrows: Vec<Arrow>,
    /// The position of the mode it starts in.
    pub entry: Option<usize>,
}

/// A mode as a box.
#[derive(Debug)]
pub struct ModeBox {
    /// Its name.
    pub name: String,
    /// The commands it gives on every tick.
    pub commands: Vec<String>,
    /// The sensors without which it is inhibited.
    pub requires: Vec<String>,
    /// Whether it has no way out on purpose.
    pub is_final: bool,
}

/// A transition as an arrow.
#[derive(Debug)]
pub struct Arrow {
    /// The position of the mode that it leaves.
    pub from: usize,
    /// The position of the mode that it enters.
    pub to: usize,
    /// 1 is the highest; none where a sensor that the mode requires has failed, which comes before all.
    pub priority: Option<u32>,
    /// Its condition.
    pub condition: String,
}

impl Chart {
    /// What a picture of the diagram shows; transitions without a target are left out.
    pub fn new(program: &Program, sources: &Sources, diagram: Id<Diagram>) -> Self {
        let diagram = &program.diagrams[diagram];
        let sensor = |(sensor, _): &(Id<Sensor>, Span)| program.sensors[*sensor].symbol.name.clone();
        let of_mode = |mode: &Mode| ModeBox {
            name: mode.symbol.name.clone(),
            commands: mode.actions.iter().map(|call: &Call| on_one_line(sources.slice(call.span))).collect(),
            requires: mode.requires.iter().map(sensor).collect(),
            is_final: mode.is_final,
        };
        let mut arrows = Vec::new();
        for (id, mode) in diagram.modes.iter() {
            let from = id.index();
            if let Some(otherwise) = mode.otherwise {
                let lost: Vec<_> =
                    mode.requires.iter().map(|required| format!("failed({})", sensor(required))).collect();
                let (to, condition) = (otherwise.index(), lost.join(" or "));
                arrows.push(Arrow { from, to, priority: None, condition });
            }
            arrows.extend(mode.transitions.iter().filter_map(|transition: &Transition| {
                let condition = on_one_line(sources.slice(program.exprs[transition.condition].span));
                Some(Arrow { from, to: transition.target?.index(), priority: Some(transition.priority), condition })
            }));
        }
        Self {
            name: diagram.symbol.name.clone(),
            modes: diagram.modes.values().map(of_mode).collect(),
            arrows,
            entry: diagram.entry.map(Id::index),
        }
    }
}

/// A part of a source without its line ends and comments.
fn on_one_line(text: &str) -> String {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
}
