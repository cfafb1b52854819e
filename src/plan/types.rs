//! What is run or emitted, beside its code: flat lists that point into each other, names only for display.

use std::ops::Range;

use super::code::{Bool, Code, Real, Steps, Ties};
use crate::base::Span;

/// Where something stands in the source, and what its doc comment says of it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Origin {
    /// Its name.
    pub span: Span,
    /// Lines joined by newlines; empty without a doc comment.
    pub doc: String,
}

/// A sensor that is read, or an input of a network evaluated on its own. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Input {
    /// Its name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// How to show its numbers.
    pub unit: crate::base::Unit,
    /// The lower end of its range.
    pub low: f64,
    /// The upper end of its range.
    pub high: f64,
    /// What stands in for it when it has failed.
    pub fail: f64,
}

/// A logical sensor of the robot, and where its reading is: of a contact that follows from a condition, whether it is set.
#[derive(Debug, Clone, PartialEq)]
pub struct Logical {
    /// Its name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// How to show its numbers.
    pub unit: crate::base::Unit,
    /// The inputs it follows from.
    pub of: Vec<u32>,
    /// Its reading.
    pub value: Value,
}

/// An event and where its numbers are.
#[derive(Debug, Clone, PartialEq)]
pub struct Event {
    /// `network.event`, or the event's name alone for a network on its own.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// What speaks for it.
    pub contributor: Real,
    /// What speaks against it.
    pub detractor: Real,
    /// Its flag.
    pub flag: Bool,
}

/// A continuous output and where its numbers are.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// `network.output`, or the output's name alone for a network on its own.
    pub name: String,
    /// Where it is declared.
    pub origin: Origin,
    /// How to show its numbers.
    pub unit: crate::base::Unit,
    /// Its value.
    pub value: Real,
    /// Whether a rule fired.
    pub fired: Bool,
    /// The strength of every rule that sets it.
    pub strengths: Vec<Real>,
    /// Its sets that rules name, each with the strength at which it holds; none where it has expressions.
    pub sets: Vec<(String, Real)>,
    /// The rules that set it.
    pub rules: Vec<Span>,
}

/// A named flag and where it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Flag {
    /// Its name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// Its value.
    pub value: Bool,
}

/// A diagram on a robot, ready to run.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Its position in the program.
    pub position: u32,
    /// The diagram's name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// The robot's name.
    pub robot: String,
    /// The robot's sensors, in its order.
    pub inputs: Vec<Input>,
    /// The robot's logical sensors, in its order; of its contacts that follow from conditions those that are looked at.
    pub logical: Vec<Logical>,
    /// The robot's actions, in its order.
    pub actions: Vec<Action>,
    /// What is computed.
    pub code: Code,
    /// Sense and fuse: run on every tick before a transition is chosen.
    pub fuse: Steps,
    /// Run on every tick after a transition was chosen: what scenarios watch.
    pub watch: Steps,
    /// The networks it senses through, its robot's last.
    pub senses: Vec<Sense>,
    /// The events of all networks, in order.
    pub events: Vec<Event>,
    /// The strength of every contributor rule and every detractor rule, for each event.
    pub strengths: Vec<(Vec<Real>, Vec<Real>)>,
    /// The outputs of all networks, in order.
    pub outputs: Vec<Output>,
    /// The named flags, in order.
    pub flags: Vec<Flag>,
    /// What is looked back at by edges, holds, latches and counters, and its text; once for each.
    pub remembered: Vec<(Bool, String)>,
    /// The watched conditions, in the order they were asked for.
    pub watched: Vec<Bool>,
    /// The modes, in the diagram's order.
    pub modes: Vec<Mode>,
    /// The transitions of all modes, by mode and priority.
    pub transitions: Vec<Transition>,
    /// The rows of all decision tables, by mode.
    pub rows: Vec<Row>,
    /// The commands of all modes.
    pub calls: Vec<Call>,
    /// Where the arguments of the commands are.
    pub arguments: Vec<Real>,
    /// The random numbers of all modes.
    pub draws: Vec<Draw>,
    /// The inputs that modes require.
    pub required: Vec<u32>,
    /// Numbers that never change, written before the first tick.
    pub constants: Steps,
    /// The mode the machine starts in.
    pub entry: u32,
    /// The diagrams that run inside its modes, each once.
    pub inner: Vec<Self>,
    /// What chooses among clients, if it is an arbiter; the modes are then who has the robot.
    pub arbiter: Option<Arbiter>,
    /// What carries out the robot's commands, where that is a behavior too; only for a scenario.
    pub drive: Option<Box<Self>>,
}

impl Plan {
    /// What runs inside its modes, or the clients of an arbiter.
    pub fn runs(&self) -> impl Iterator<Item = &Self> {
        self.inner
            .iter()
            .chain(self.arbiter.iter().flat_map(|arbiter| arbiter.clients.iter().map(|client| &*client.plan)))
    }

    /// Whether it, or what it runs, draws random numbers.
    pub fn is_random(&self) -> bool {
        let has_ties = self.arbiter.as_ref().is_some_and(|arbiter| arbiter.ties == Ties::Random);
        has_ties || !self.draws.is_empty() || self.runs().any(Self::is_random)
    }

    /// It and all that it runs, inner ones first.
    pub fn layers(&self) -> Vec<&Self> {
        self.runs().flat_map(Self::layers).chain([self]).collect()
    }
}

/// A priority multiplexer.
#[derive(Debug, Clone, PartialEq)]
pub struct Arbiter {
    /// What bypasses the clients, in order.
    pub emergencies: Vec<Emergency>,
    /// Who proposes commands, in order.
    pub clients: Vec<Client>,
    /// Who wins of clients with one priority.
    pub ties: Ties,
    /// The inputs by which a client sees that it won, or lost.
    pub won: Option<u32>,
    /// See `won`.
    pub lost: Option<u32>,
}

impl Arbiter {
    /// The mode in which no command is given.
    pub const NOBODY: u32 = 0;
    /// The mode in which an emergency has the robot.
    pub const EMERGENCY: u32 = 1;
    /// How many modes stand before those of the clients.
    pub const OTHERS: u32 = crate::ir::Arbiter::OTHERS;

    /// When there are emergencies, and on what priorities depend.
    pub fn conditions(&self) -> impl Iterator<Item = Bool> {
        let priorities = self.clients.iter().flat_map(|client| &client.priorities);
        let emergencies = self.emergencies.iter().map(|emergency| emergency.condition);
        emergencies.chain(priorities.filter_map(|(_, when)| *when))
    }
}

/// A command that goes straight to the body.
#[derive(Debug, Clone, PartialEq)]
pub struct Emergency {
    /// When.
    pub condition: Bool,
    /// As written.
    pub text: String,
    /// What, in [`Plan::calls`].
    pub call: u32,
}

/// A client of an arbiter.
#[derive(Debug, Clone, PartialEq)]
pub struct Client {
    /// Its name.
    pub name: String,
    /// What it runs.
    pub plan: Box<Plan>,
    /// Its priorities: the first whose condition holds, or that has none.
    pub priorities: Vec<(u32, Option<Bool>)>,
}

/// A network bound to inputs.
#[derive(Debug, Clone, PartialEq)]
pub struct Sense {
    /// The network's name, or the one it is sensed under.
    pub name: String,
    /// The network, as [`NetworkPlan::position`].
    pub network: u32,
    /// The readings that feed it.
    pub readings: Vec<Real>,
    /// Its events in [`Plan::events`].
    pub events: Range<u32>,
    /// Its outputs in [`Plan::outputs`].
    pub outputs: Range<u32>,
}

/// An action of the robot.
#[derive(Debug, Clone, PartialEq)]
pub struct Action {
    /// Its name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// Its parameters, for display.
    pub parameters: Vec<(String, crate::base::Unit)>,
    /// Whether it reports completion.
    pub reports_done: bool,
}

/// A diagram that runs inside a mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Run {
    /// The diagram, a position in [`Plan::inner`].
    pub inner: u32,
    /// Whether it goes on where it was when its mode is entered again, and does not start anew.
    pub resumes: bool,
}

/// A mode: spans of the plan's lists.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Its name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// Whether it has no way out on purpose.
    pub is_final: bool,
    /// What runs inside it.
    pub runs: Option<Run>,
    /// Its ways out in [`Plan::transitions`].
    pub transitions: Range<u32>,
    /// Its commands of every tick in [`Plan::calls`].
    pub actions: Range<u32>,
    /// The rows of its decision table in [`Plan::rows`], of which one fits on every tick.
    pub rows: Range<u32>,
    /// Its commands on entry in [`Plan::calls`].
    pub on_enter: Range<u32>,
    /// Its commands on leaving in [`Plan::calls`].
    pub on_exit: Range<u32>,
    /// Its random numbers in [`Plan::draws`].
    pub draws: Range<u32>,
    /// The inputs it requires in [`Plan::required`].
    pub required: Range<u32>,
    /// Where the machine goes when one of them fails.
    pub otherwise: Option<u32>,
}

/// A way out of a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Transition {
    /// Its priority as written.
    pub priority: u32,
    /// What computes its condition, beyond what was fused.
    pub steps: Steps,
    /// Its condition.
    pub condition: Bool,
    /// Where it leads.
    pub target: u32,
    /// Where it stands in the source.
    pub span: Span,
    /// Its condition as written.
    pub text: String,
    /// The numbers its condition looks at.
    pub evidence: Vec<Evidence>,
    /// What its condition is made of, itself first, each before its own parts. Their values are those of the last tick on
    /// which the transition was tried.
    pub parts: Vec<Part>,
}

/// A condition within that of a transition, or a count in one.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Within how many others it is.
    pub depth: u32,
    /// As written.
    pub text: String,
    /// Where it is.
    pub value: Value,
    /// The numbers that it looks at itself.
    pub evidence: Vec<Evidence>,
}

/// Where something is, and what it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// A truth value.
    Truth(Bool),
    /// A plain number.
    Number(Real),
}

/// A number that a condition looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Evidence {
    /// An input.
    Input(u32),
    /// A logical sensor.
    Logical(u32),
    /// An event.
    Event(u32),
    /// The time in the mode.
    Dwell,
}

/// A command.
#[derive(Debug, Clone, PartialEq)]
pub struct Call {
    /// The action, a position in [`Plan::actions`].
    pub action: u32,
    /// Its arguments in [`Plan::arguments`].
    pub arguments: Range<u32>,
}

/// A row of a decision table.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// What computes its condition, beyond what was fused.
    pub steps: Steps,
    /// Whether it fits.
    pub condition: Bool,
    /// Its command in [`Plan::calls`], or those of which one is given.
    pub calls: Range<u32>,
    /// Which of several commands is given: the whole part, drawn when the row begins to fit.
    pub pick: Option<Real>,
    /// Its random numbers in [`Plan::draws`], drawn when it begins to fit.
    pub draws: Range<u32>,
    /// Where its cells stand.
    pub span: Span,
}

/// A random number, drawn when its mode is entered, or when its row begins to fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Draw {
    /// The lower end.
    pub low: f64,
    /// The upper end.
    pub high: f64,
    /// Where it goes.
    pub to: Real,
}

/// A network on its own, ready to evaluate.
#[derive(Debug, Clone, PartialEq)]
pub struct NetworkPlan {
    /// Its position in the program.
    pub position: u32,
    /// The network's name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// Its inputs, in order.
    pub inputs: Vec<Input>,
    /// What is computed.
    pub code: Code,
    /// The degree of every term of every input.
    pub degrees: Vec<Vec<(String, Real)>>,
    /// The strength of every contributor rule and every detractor rule, for each event.
    pub strengths: Vec<(Vec<Real>, Vec<Real>)>,
    /// Where each of these rules stands.
    pub rules: Vec<(Vec<Span>, Vec<Span>)>,
    /// Its events, in order.
    pub events: Vec<Event>,
    /// Its outputs, in order.
    pub outputs: Vec<Output>,
}
