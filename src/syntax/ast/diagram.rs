//! Mode switching diagrams: behaviors, activities, goals.

use super::{Argument, Call, Doc, Expr, Name, Number, Row};
use crate::base::Span;

/// `behavior b on r extends c { ... }`, or an `activity` or a `goal`
#[derive(Debug, Clone, PartialEq)]
pub struct Diagram {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its layer.
    pub layer: Layer,
    /// Its name.
    pub name: Name,
    /// The robot or interface it is written on.
    pub on: Option<Name>,
    /// The diagram whose modes it takes over.
    pub extends: Option<Name>,
    /// What stands in its braces.
    pub items: Vec<DiagramItem>,
    /// The whole declaration.
    pub span: Span,
}

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

impl Layer {
    /// The keyword that declares it.
    pub const fn keyword(self) -> &'static str {
        match self {
            Self::Behavior => "behavior",
            Self::Activity => "activity",
            Self::Goal => "goal",
        }
    }
}

/// What may stand in a diagram.
#[derive(Debug, Clone, PartialEq)]
pub enum DiagramItem {
    /// `sense network(...)`
    Sense(Sense),
    /// `entry m`
    Entry {
        /// The mode.
        mode: Name,
        /// The whole line.
        span: Span,
    },
    /// `flag f = ...`
    Flag(Flag),
    /// `mode m { ... }`
    Mode(Mode),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// `sense obstacle_id(left_wheel_acceleration, ...)`
#[derive(Debug, Clone, PartialEq)]
pub struct Sense {
    /// `alias =` in front of the network, where one network is sensed twice.
    pub alias: Option<Name>,
    /// The network.
    pub network: Name,
    /// What feeds its inputs, in order or by name.
    pub arguments: Vec<Argument>,
    /// The whole line.
    pub span: Span,
}

/// `flag low_battery = battery < 11 V`
#[derive(Debug, Clone, PartialEq)]
pub struct Flag {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// When it is set.
    pub condition: Expr,
    /// The whole declaration.
    pub span: Span,
}

/// `mode push requires contact_force else stop { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// `final`, if the mode has no way out on purpose.
    pub is_final: Option<Span>,
    /// Its name.
    pub name: Name,
    /// `= diagram`, the diagram that runs inside it.
    pub child: Option<Child>,
    /// The sensors it cannot do without.
    pub requires: Vec<Name>,
    /// Where the machine goes when one of them fails.
    pub otherwise: Option<Name>,
    /// What stands in its braces; empty where there are none.
    pub items: Vec<ModeItem>,
    /// The whole declaration.
    pub span: Span,
}

/// `= obstacle_avoidance resume`
#[derive(Debug, Clone, PartialEq)]
pub struct Child {
    /// The diagram.
    pub diagram: Name,
    /// `resume`, if it goes on where it was.
    pub resume: Option<Span>,
}

/// What may stand in a mode.
#[derive(Debug, Clone, PartialEq)]
pub enum ModeItem {
    /// A command given on every tick.
    Action(Call),
    /// `on enter { ... }`
    OnEnter(Vec<Call>, Span),
    /// `on exit { ... }`
    OnExit(Vec<Call>, Span),
    /// `decide (...) { ... }`
    Decide(Decide),
    /// `1: condition -> target`
    Transition(Transition),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// `1: heavy_obstacle -> stop`
#[derive(Debug, Clone, PartialEq)]
pub struct Transition {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its priority, 1 the highest.
    pub priority: Number,
    /// When it is set.
    pub condition: Expr,
    /// Where it leads.
    pub target: Target,
    /// The whole line.
    pub span: Span,
}

/// Where a transition leads.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// Another mode.
    Mode(Name),
    /// `again`: the mode itself, with its timers restarted
    Again(Span),
}

/// `decide (right, left) { (close, far) => turn_left(10 deg) ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Decide {
    /// What is looked at.
    pub subjects: Vec<Expr>,
    /// The rows in order.
    pub rows: Vec<DecideRow>,
    /// All of it.
    pub span: Span,
}

/// `(close, far) => turn_left(10 deg)`
#[derive(Debug, Clone, PartialEq)]
pub struct DecideRow {
    /// The cells.
    pub row: Row,
    /// A command, `either(...)` of commands, or `nothing`.
    pub command: Expr,
    /// Both.
    pub span: Span,
}
