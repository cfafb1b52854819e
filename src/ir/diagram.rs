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
    /// What chooses among clients, if it is an arbiter: its modes are then who has the robot.
    pub arbiter: Option<Arbiter>,
    /// Whether something in it or in one of its modes was broken, reported and left out.
    pub incomplete: bool,
}

impl Diagram {
    /// Every condition in it.
    pub fn conditions(&self) -> impl Iterator<Item = Id<Expr>> {
        let of_modes = self.modes.values().flat_map(|mode| {
            let rows = mode.decision.iter().flat_map(|table| &table.rows).map(|row| row.condition);
            rows.chain(mode.transitions.iter().map(|transition| transition.condition))
        });
        let of_arbiter = self.arbiter.iter().flat_map(Arbiter::conditions);
        self.flags.values().map(|flag| flag.condition).chain(of_modes).chain(of_arbiter)
    }
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
    /// What runs inside it, in an activity or a goal; `None` where that was broken and reported.
    pub runs: Option<Run>,
    /// The sensors without which it is inhibited, and where each was written.
    pub requires: Vec<(Id<Sensor>, Span)>,
    /// Where the machine goes when one of them fails while the mode is active.
    pub otherwise: Option<Id<Mode>>,
    /// Commands given on every tick.
    pub actions: Vec<Call>,
    /// The table that chooses a command on every tick, if it has one.
    pub decision: Option<Decision>,
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

/// A diagram that runs inside a mode of another (LMSL fig. 3).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Run {
    /// The diagram, of a lower layer.
    pub diagram: Id<Diagram>,
    /// Whether it goes on where it was when its mode is entered again, and does not start anew.
    pub resumes: bool,
    /// Where its name stands.
    pub span: Span,
}

/// A priority multiplexer (Sobh §3.2, §3.3). The modes of its diagram are [`Arbiter::NOBODY`], [`Arbiter::EMERGENCY`],
/// and its clients in order.
#[derive(Debug, Clone)]
pub struct Arbiter {
    /// What bypasses the clients, in order.
    pub emergencies: Vec<Emergency>,
    /// Who proposes commands, in order.
    pub clients: Vec<Client>,
    /// Who wins of clients with one priority; `None` where nothing was said, then the first.
    pub ties: Option<Ties>,
}

impl Arbiter {
    /// The mode in which no command is given.
    pub const NOBODY: Id<Mode> = Id::new(0);
    /// The mode in which an emergency has the robot.
    pub const EMERGENCY: Id<Mode> = Id::new(1);
    /// How many modes stand before those of the clients.
    pub const OTHERS: u32 = 2;

    /// When there are emergencies, and on what priorities depend.
    pub fn conditions(&self) -> impl Iterator<Item = Id<Expr>> {
        let priorities = self.clients.iter().flat_map(|client| &client.priorities);
        let emergencies = self.emergencies.iter().map(|emergency| emergency.condition);
        emergencies.chain(priorities.filter_map(|(_, when)| *when))
    }
}

/// A command that goes straight to the body.
#[derive(Debug, Clone)]
pub struct Emergency {
    /// When.
    pub condition: Id<Expr>,
    /// What.
    pub command: Call,
    /// The whole line.
    pub span: Span,
}

/// A client of an arbiter.
#[derive(Debug, Clone)]
pub struct Client {
    /// Its name.
    pub symbol: Symbol,
    /// What it runs.
    pub diagram: Id<Diagram>,
    /// Its priorities, 1 to 10, 1 the highest: the first whose condition holds, or that has none.
    pub priorities: Vec<(u32, Option<Id<Expr>>)>,
    /// The whole line.
    pub span: Span,
}

/// Who wins of clients with one priority.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ties {
    /// The first in the text.
    InOrder,
    /// One of them by chance.
    Random,
}

/// A decision table (Sobh §4, Table 1): on every tick the command of the one row that fits.
#[derive(Debug, Clone)]
pub struct Decision {
    /// What it looks at.
    pub columns: Vec<Column>,
    /// Its rows in order.
    pub rows: Vec<DecisionRow>,
    /// What it looks at, where that stands.
    pub span: Span,
}

/// Something a decision table looks at; it has one of some values on every tick.
#[derive(Debug, Clone)]
pub struct Column {
    /// As written.
    pub text: String,
    /// The names of its values: terms, or `set` and `clear`.
    pub values: Vec<String>,
    /// Whether some reading gives it each of these.
    pub possible: Vec<bool>,
    /// Where it stands.
    pub span: Span,
}

/// A row of a decision table.
#[derive(Debug, Clone)]
pub struct DecisionRow {
    /// For each column the positions of the values that fit, ascending.
    pub cells: Vec<Vec<u32>>,
    /// Whether all columns fit.
    pub condition: Id<Expr>,
    /// Its command, one of several by chance, or none.
    pub commands: Vec<Call>,
    /// Where its cells stand.
    pub span: Span,
}

impl Mode {
    /// Every command it can give.
    pub fn commands(&self) -> impl Iterator<Item = &Call> {
        self.on_enter.iter().chain(self.lasting()).chain(&self.on_exit)
    }

    /// Every command it can give while it lasts.
    pub fn lasting(&self) -> impl Iterator<Item = &Call> {
        let decided = self.decision.iter().flat_map(|table| &table.rows).flat_map(|row| &row.commands);
        self.actions.iter().chain(decided)
    }
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
    /// What a sensor reads.
    Reading(Id<Sensor>),
}
