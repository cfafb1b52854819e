//! Mode switching diagrams.

use super::{Action, Expr, Interface, Network, Robot, Sensor, Symbol};
use crate::base::{Arena, Exact, Id, Span};

/// The layer of a diagram, from the inside out (LMSL fig. 3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Layer {
    /// Its modes call actions.
    Behavior,
    /// Its modes run behaviors.
    Activity,
    /// Its modes run activities.
    Goal,
}

/// What a diagram is written on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Platform {
    /// One robot.
    Robot(Id<Robot>),
    /// Every robot that keeps an interface.
    Interface(Id<Interface>),
}

/// A mode switching diagram (LMSL §2.1), with what it extends taken over.
#[derive(Debug, Clone)]
pub struct Diagram {
    /// Its name.
    pub symbol: Symbol,
    /// Its layer.
    pub layer: Layer,
    /// What it is written on.
    pub platform: Platform,
    /// The networks it senses through.
    pub senses: Vec<Sense>,
    /// Its named conditions, in an order in which each uses only earlier ones.
    pub flags: Arena<Flag>,
    /// Its modes in source order, those of the extended diagram first.
    pub modes: Arena<Mode>,
    /// The mode it starts in; `None` where that was reported missing.
    pub entry: Option<Id<Mode>>,
    /// Whether something in it or in one of its modes was broken, reported and left out.
    pub incomplete: bool,
}

/// A network bound to sensors.
#[derive(Debug, Clone)]
pub struct Sense {
    /// The network's name, or the alias it is sensed under.
    pub symbol: Symbol,
    /// The network.
    pub network: Id<Network>,
    /// What feeds each of its inputs; nothing at all where that was broken and reported.
    pub inputs: Vec<Id<Sensor>>,
}

/// A named condition.
#[derive(Debug, Clone)]
pub struct Flag {
    /// Its name.
    pub symbol: Symbol,
    /// When it is set.
    pub condition: Id<Expr>,
}

/// A mode of a diagram.
#[derive(Debug, Clone)]
pub struct Mode {
    /// Its name.
    pub symbol: Symbol,
    /// Whether it has no way out on purpose.
    pub is_final: bool,
    /// The sensors without which it is inhibited, and where each was written.
    pub requires: Vec<(Id<Sensor>, Span)>,
    /// Where the machine goes when one of them fails while the mode is active.
    pub otherwise: Option<Id<Mode>>,
    /// Commands given on every tick.
    pub actions: Vec<Call>,
    /// Commands given once when it is entered.
    pub on_enter: Vec<Call>,
    /// Commands given once when it is left.
    pub on_exit: Vec<Call>,
    /// Its ways out, by priority.
    pub transitions: Vec<Transition>,
    /// Whether something in it was broken, reported and left out; then nothing can be said of what it lacks.
    pub incomplete: bool,
    /// Whether it was taken over from a diagram that this one extends, and is judged there.
    pub inherited: bool,
}

/// A way out of a mode.
#[derive(Debug, Clone)]
pub struct Transition {
    /// 1 is the highest.
    pub priority: u32,
    /// Where the priority stands.
    pub priority_span: Span,
    /// When it is set.
    pub condition: Id<Expr>,
    /// Where it leads; `None` where the target was reported unknown.
    pub target: Option<Id<Mode>>,
    /// Whether it re-enters its own mode by `again`.
    pub again: bool,
    /// The whole line.
    pub span: Span,
}

/// A command with its arguments.
#[derive(Debug, Clone)]
pub struct Call {
    /// The action of the diagram's platform.
    pub action: Id<Action>,
    /// Its arguments in the order of the parameters.
    pub arguments: Vec<Argument>,
    /// Where it stands.
    pub span: Span,
}

/// An argument of an action, in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Argument {
    /// A number.
    Constant(Exact),
    /// A number drawn once when the mode is entered, from `low` to `high`.
    Random {
        /// The lower end.
        low: Exact,
        /// The upper end.
        high: Exact,
    },
    /// An output of the diagram's sense at that position.
    Output {
        /// The position of the sense in its diagram.
        sense: u32,
        /// The position of the output in its network.
        output: u32,
    },
}
