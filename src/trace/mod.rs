//! The record of a run: what was read, decided and done on every tick; and what many runs went through.
//!
//! Imports: base
//! Crates: –

mod measures;

use std::fmt;

pub use measures::Measures;

use crate::base::Span;

/// A recorded run. All columns have one value for each tick.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trace {
    /// The scenario that was run.
    pub scenario: String,
    /// The behavior that ran.
    pub behavior: String,
    /// The robot it ran on.
    pub robot: String,
    /// The seed of everything random.
    pub seed: u64,
    /// Nanoseconds since the first tick, one for each tick.
    pub times: Vec<u64>,
    /// The names of the behavior's modes.
    pub modes: Vec<String>,
    /// The position in `modes` of the mode that acted, one for each tick.
    pub mode: Vec<u32>,
    /// Of a diagram with layers: every place it was in, as `explore.forward`.
    pub places: Vec<String>,
    /// The position in `places` of where it was, one for each tick; none without layers.
    pub place: Vec<u32>,
    /// Everything that was recorded beside time and mode.
    pub columns: Vec<Column>,
    /// The changes of mode, the entry first.
    pub changes: Vec<ModeChange>,
    /// The changes inside a mode that stayed, between positions in `places`.
    pub inner: Vec<ModeChange>,
    /// What became of what the clients of an arbiter proposed, whenever that changed (Sobh §5).
    pub log: Vec<LogEntry>,
    /// What moved: the robot first, then the boxes. Their poses are columns.
    pub bodies: Vec<Footprint>,
    /// Where range sensors met something, to the nearest 5 cm, m; each place once.
    pub hits: Vec<[f64; 2]>,
    /// Walls that stood, as lines through corners in m.
    pub walls: Vec<Vec<[f64; 2]>>,
    /// The goal, m.
    pub goal: Option<[f64; 2]>,
}

/// A line of an arbiter's log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LogEntry {
    /// Nanoseconds since the first tick.
    pub time: u64,
    /// `Accepted GO-FRWD from 2 (wander)`
    pub text: String,
}

/// One recorded quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Its name, as in a file's header: `contact_force`, `obstacle_id.heavy_obstacle.contributor`, `box1.x`.
    pub name: String,
    /// The SI unit of its values; `1` for degrees and flags.
    pub unit: String,
    /// What it is.
    pub signal: Signal,
    /// One value for each tick; flags are 0 and 1.
    pub values: Vec<f64>,
}

/// What a column records. Numbers are positions: of a sensor or a logical sensor of the robot, an event of the plan, a named flag of the
/// plan, an entry of [`Trace::bodies`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Signal {
    /// What the sensor read, before it was made safe.
    Reading(u32),
    /// What a logical sensor of the robot read, from readings made safe.
    Logical(u32),
    /// The strength of what speaks for an event.
    Contributor(u32),
    /// The strength of what speaks against an event.
    Detractor(u32),
    /// The flag of an event.
    Event(u32),
    /// A named flag.
    Flag(u32),
    /// m
    X(u32),
    /// m
    Y(u32),
    /// rad
    Heading(u32),
}

impl Signal {
    /// Whether it is part of the pose of a body.
    pub const fn is_pose(self) -> bool {
        matches!(self, Self::X(_) | Self::Y(_) | Self::Heading(_))
    }

    /// Whether it is true or false: the flag of an event, or a named flag.
    pub const fn is_flag(self) -> bool {
        matches!(self, Self::Event(_) | Self::Flag(_))
    }
}

/// The outline of something that moves: a rectangle around its pose.
#[derive(Debug, Clone, PartialEq)]
pub struct Footprint {
    /// `robot`, or the box's name.
    pub name: String,
    /// kg
    pub mass: f64,
    /// m along its heading.
    pub length: f64,
    /// m across its heading.
    pub width: f64,
}

/// A mode that was entered, and why.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeChange {
    /// Nanoseconds since the first tick.
    pub time: u64,
    /// The mode that was left; `None` for the entry.
    pub from: Option<u32>,
    /// The mode that was entered.
    pub to: u32,
    /// The priority of the transition; `None` for the entry, and where a required sensor failed.
    pub priority: Option<u32>,
    /// The condition as written; what failed, where a required sensor did.
    pub condition: String,
    /// The numbers that decided.
    pub evidence: Vec<Evidence>,
}

/// A number that decided a change of mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Evidence {
    /// What it is the number of.
    pub name: String,
    /// The number with its unit, for people.
    pub text: String,
}

impl fmt::Display for Evidence {
    /// `left_wheel_acceleration -1.71 m/s^2`, but `forward_collision: contributor 0.93 > detractor 0.00`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let is_number = self.text.starts_with(|first: char| first.is_ascii_digit() || "+-.".contains(first));
        write!(f, "{}{} {}", self.name, if is_number { "" } else { ":" }, self.text)
    }
}

impl Trace {
    /// The column that records `signal`.
    pub fn column(&self, signal: Signal) -> Option<&Column> {
        self.columns.iter().find(|column| column.signal == signal)
    }

    /// The changes of mode with the name of what was entered, those inside a mode too, by time.
    pub fn entered(&self) -> Vec<(&ModeChange, &str)> {
        let outer = self.changes.iter().map(|change| (change, name(&self.modes, change.to)));
        let inner = self.inner.iter().map(|change| (change, name(&self.places, change.to)));
        let mut entered: Vec<_> = outer.chain(inner).collect();
        entered.sort_by_key(|(change, _)| change.time);
        entered
    }

    /// The name of where it was on a tick, from the outermost mode inward; empty for a tick that was not.
    pub fn at(&self, tick: usize) -> &str {
        let (names, numbers) =
            if self.place.is_empty() { (&self.modes, &self.mode) } else { (&self.places, &self.place) };
        numbers.get(tick).map_or("", |&number| name(names, number))
    }

    /// The columns of events and named flags, with the shortest name that tells each from the others: the event's
    /// alone where no other event or flag has it, else with its network. Costs the square of their number.
    pub fn flags(&self) -> Vec<(&str, &Column)> {
        let flags: Vec<&Column> = self.columns.iter().filter(|column| column.signal.is_flag()).collect();
        let alone = |name: &str| flags.iter().filter(|other| short(other) == name).count() == 1;
        flags.iter().map(|&column| (if alone(short(column)) { short(column) } else { &*column.name }, column)).collect()
    }
}

/// A name by its position; empty for a position that is none.
fn name(names: &[String], number: u32) -> &str {
    names.get(number as usize).map_or("", String::as_str)
}

/// What stands behind the last dot.
fn short(column: &Column) -> &str {
    column.name.rsplit('.').next().unwrap_or_default()
}

/// What some runs went through, and what none of them did.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Coverage {
    /// The behaviors, in the order of their declarations.
    pub behaviors: Vec<BehaviorCoverage>,
    /// The networks, in the order of their declarations.
    pub networks: Vec<NetworkCoverage>,
}

/// What runs went through of a behavior.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BehaviorCoverage {
    /// Its name.
    pub name: String,
    /// How many of the runs were of it.
    pub scenarios: usize,
    /// Its modes: covered if entered.
    pub modes: Vec<Part>,
    /// Its transitions, and the ways out of modes whose required sensors fail: covered if taken.
    pub transitions: Vec<Part>,
}

/// What runs went through of a network.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NetworkCoverage {
    /// Its name.
    pub name: String,
    /// How many of the runs sensed it.
    pub scenarios: usize,
    /// Its rules: covered if they gave their side its strength on some tick, above 0.
    pub rules: Vec<Part>,
}

/// Something that runs may go through.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Part {
    /// The mode it is or leaves, or the event it speaks for or against.
    pub of: String,
    /// As written, on one line.
    pub text: String,
    /// Where it stands.
    pub span: Span,
    /// Whether some run went through it.
    pub covered: bool,
}

/// Nanoseconds as the nearest number of seconds.
pub fn seconds(nanoseconds: u64) -> f64 {
    nanoseconds as f64 / 1e9
}
