//! Mode switching diagrams as pictures (LMSL fig. 7): boxes for modes, arrows for transitions with their priorities.

mod dot;
mod drawing;
mod layout;
mod mermaid;

pub use dot::dot;
pub use drawing::svg;
pub use mermaid::mermaid;

use crate::analysis::modes::{Facts, ModeFacts};
use crate::base::{Id, Sources, Span};
use crate::ir::Diagram;
use crate::ir::{Call, Mode, Program, Sensor};

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
    /// The commands it gives on every tick; or what runs inside it.
    pub commands: Vec<String>,
    /// What runs inside it.
    pub inner: Option<Chart>,
    /// The sensors without which it is inhibited.
    pub requires: Vec<String>,
    /// Whether it has no way out on purpose.
    pub is_final: bool,
    /// Whether the machine cannot be in it, or is not let in, as far as sensors are taken to have failed.
    pub is_lost: bool,
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
    /// Whether it is never taken, as far as sensors are taken to have failed.
    pub is_lost: bool,
    /// Its position among the transitions of its mode; none for the way out of a mode without what it requires.
    exit: Option<usize>,
}

impl Chart {
    /// What a picture of the diagram shows; transitions without a target are left out.
    pub fn new(program: &Program, sources: &Sources, diagram: Id<Diagram>) -> Self {
        let diagram = &program.diagrams[diagram];
        let sensor = |(sensor, _): &(Id<Sensor>, Span)| program.sensors[*sensor].symbol.name.clone();
        let of_mode = |mode: &Mode| ModeBox {
            name: mode.symbol.name.clone(),
            commands: commands(program, sources, mode),
            inner: mode.runs.map(|run| Self::new(program, sources, run.diagram)),
            requires: mode.requires.iter().map(sensor).collect(),
            is_final: mode.is_final,
            is_lost: false,
        };
        let mut arrows = Vec::new();
        for (id, mode) in diagram.modes.iter() {
            let from = id.index();
            if let Some(otherwise) = mode.otherwise {
                let lost: Vec<_> =
                    mode.requires.iter().map(|required| format!("failed({})", sensor(required))).collect();
                let (to, condition) = (otherwise.index(), lost.join(" or "));
                arrows.push(Arrow { from, to, priority: None, condition, is_lost: false, exit: None });
            }
            arrows.extend(mode.transitions.iter().enumerate().filter_map(|(index, transition)| {
                let condition = on_one_line(sources.slice(program.exprs[transition.condition].span));
                let (to, priority) = (transition.target?.index(), Some(transition.priority));
                Some(Arrow { from, to, priority, condition, is_lost: false, exit: Some(index) })
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

impl Chart {
    /// Marks what is lost under every one of some sets of failed sensors.
    pub fn mark_lost(&mut self, under: &[&Facts]) {
        let modes = |mode: usize| under.iter().map(move |facts| &facts.modes[mode]);
        for (index, mode) in self.modes.iter_mut().enumerate() {
            mode.is_lost = modes(index).all(|mode| !mode.reachable || mode.inhibited);
        }
        for arrow in &mut self.arrows {
            let is_taken = |mode: &ModeFacts| match arrow.exit {
                Some(exit) => mode.exits[exit].is_some(),
                None => mode.inhibited,
            };
            arrow.is_lost = modes(arrow.from).all(|mode| !mode.reachable || !is_taken(mode));
        }
    }
}

/// A part of a source without its line ends and comments.
fn on_one_line(text: &str) -> String {
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(str::split_whitespace).collect::<Vec<_>>().join(" ")
}

/// What a mode does, a line each; of a decision table what it looks at.
fn commands(program: &Program, sources: &Sources, mode: &Mode) -> Vec<String> {
    let runs = mode.runs.iter().map(|run| {
        let resumes = if run.resumes { ", resumed" } else { "" };
        format!("runs {}{resumes}", program.diagrams[run.diagram].symbol.name)
    });
    let decided = mode.decision.iter().map(|table| format!("decide ({})", on_one_line(sources.slice(table.span))));
    mode.actions.iter().map(|call: &Call| on_one_line(sources.slice(call.span))).chain(decided).chain(runs).collect()
}
