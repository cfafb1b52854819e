//! The ordered, flat form that is run or emitted: no maps, no options in the hot path, names only for display.

use std::ops::Range;

use crate::base::Span;
pub use crate::ir::{Aggregation, Comparison, Implication, SNorm, TNorm};

/// A number of the plan's memory.
pub type Real = u32;
/// A truth value of the plan's memory.
pub type Bool = u32;
/// A span of [`Code::steps`].
pub type Steps = Range<u32>;

/// What is computed, and with how much memory.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Code {
    /// All steps; spans of them are run.
    pub steps: Vec<Step>,
    /// The operands of minima and maxima.
    pub real_lists: Vec<Real>,
    /// The operands of conjunctions and disjunctions.
    pub bool_lists: Vec<Bool>,
    /// The points of piecewise-linear shapes.
    pub points: Vec<(f64, f64)>,
    /// What sets hold between two degrees.
    pub slabs: Vec<Slab>,
    /// Stretches of outputs on which their sets are linear.
    pub stretches: Vec<Stretch>,
    /// Degrees of sets in the middle of parts of their ranges, part by part.
    pub samples: Vec<f64>,
    /// Numbers and their factors in linear expressions.
    pub factors: Vec<(Real, f64)>,
    /// What the outputs that keep their last value are before a rule fires.
    pub kept: Vec<f64>,
    /// How many numbers there are.
    pub reals: u32,
    /// How many truth values there are.
    pub bools: u32,
    /// How many truth values remember the tick before.
    pub memories: u32,
    /// How many stopwatches there are.
    pub stopwatches: u32,
    /// How many counters of the active mode there are.
    pub counters: u32,
    /// How many latches of the active mode there are.
    pub latches: u32,
}

/// One operation. It reads what earlier steps wrote, and writes one value.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// A reading made safe.
    Read {
        /// The input.
        input: u32,
        /// Where it goes.
        to: Real,
    },
    /// A fixed number.
    Constant {
        /// The number.
        value: f64,
        /// Where it goes.
        to: Real,
    },
    /// A degree of membership.
    Degree {
        /// The reading.
        of: Real,
        /// The membership function.
        shape: Shape,
        /// Where it goes.
        to: Real,
    },
    /// `1 - degree`
    Complement {
        /// The degree.
        of: Real,
        /// Where it goes.
        to: Real,
    },
    /// `kernel::very`
    Very {
        /// The degree.
        of: Real,
        /// Where it goes.
        to: Real,
    },
    /// `kernel::somewhat`
    Somewhat {
        /// The degree.
        of: Real,
        /// Where it goes.
        to: Real,
    },
    /// The smallest of a list of [`Code::real_lists`]; 1 for an empty one.
    Minimum {
        /// The list.
        of: Range<u32>,
        /// Where it goes.
        to: Real,
    },
    /// The largest of a list of [`Code::real_lists`]; 0 for an empty one.
    Maximum {
        /// The list.
        of: Range<u32>,
        /// Where it goes.
        to: Real,
    },
    /// Two statements together.
    TNorm {
        /// How.
        norm: TNorm,
        /// The strength of one.
        left: Real,
        /// The strength of the other.
        right: Real,
        /// Where it goes.
        to: Real,
    },
    /// One statement or another.
    SNorm {
        /// How.
        norm: SNorm,
        /// The strength of one.
        left: Real,
        /// The strength of the other.
        right: Real,
        /// Where it goes.
        to: Real,
    },
    /// A strength times the weight of its rule.
    Weigh {
        /// The strength.
        of: Real,
        /// The weight.
        weight: f64,
        /// Where it goes.
        to: Real,
    },
    /// A constant plus the products of a span of [`Code::factors`], in their order.
    Linear {
        /// The constant.
        constant: f64,
        /// The products.
        factors: Range<u32>,
        /// Where it goes.
        to: Real,
    },
    /// `center` plus the mean of the sums, in order, of what a span of [`Code::slabs`] holds: the centroid of clipped
    /// sets, where the largest degree counts, as area and moment by inclusion and exclusion; that of clipped or scaled
    /// sets, where degrees are added.
    Centroid {
        /// The slabs.
        slabs: Range<u32>,
        /// What their moments are about.
        center: f64,
        /// Where it goes.
        to: Real,
    },
    /// What is found by following the outline of sets over a span of [`Code::stretches`].
    Outline {
        /// What is found.
        find: Find,
        /// What a strength makes of a set.
        implication: Implication,
        /// How sets become one.
        aggregation: Aggregation,
        /// The stretches.
        stretches: Range<u32>,
        /// The strengths of the sets, a list of [`Code::real_lists`].
        strengths: Range<u32>,
        /// Where it goes.
        to: Real,
    },
    /// `kernel::midpoints` of sets.
    Midpoints {
        /// What a strength makes of a set.
        implication: Implication,
        /// How sets become one.
        aggregation: Aggregation,
        /// The degrees of all sets for each part of the range, a span of [`Code::samples`].
        samples: Range<u32>,
        /// The strengths of the sets, a list of [`Code::real_lists`].
        strengths: Range<u32>,
        /// The lower end of the range.
        low: f64,
        /// The upper end of the range.
        high: f64,
        /// Where it goes.
        to: Real,
    },
    /// The mean of some numbers by some weights: sums in order, from 0.
    Mean {
        /// The weights, a list of [`Code::real_lists`].
        weights: Range<u32>,
        /// The numbers, a list of [`Code::real_lists`].
        values: Range<u32>,
        /// Where it goes.
        to: Real,
    },
    /// `kernel::limit`
    Limit {
        /// The number.
        of: Real,
        /// The least that it can be.
        low: f64,
        /// The most that it can be.
        high: f64,
        /// Where it goes.
        to: Real,
    },
    /// `kernel::fires`
    Fires {
        /// The strength of the strongest rule.
        of: Real,
        /// Where it goes.
        to: Bool,
    },
    /// A number where a rule fired, and a fixed one elsewhere.
    Otherwise {
        /// Whether a rule fired.
        fired: Bool,
        /// The number where it did.
        of: Real,
        /// The number where it did not.
        otherwise: f64,
        /// Where it goes.
        to: Real,
    },
    /// A number where a rule fired, and elsewhere what it was when one fired last.
    Keep {
        /// Whether a rule fired.
        fired: Bool,
        /// The number where it did.
        of: Real,
        /// Where it is kept, by its position in [`Code::kept`].
        kept: u32,
        /// Where it goes.
        to: Real,
    },
    /// Whether the contributor outweighs the detractor.
    Outweighs {
        /// The contributor.
        contributor: Real,
        /// The detractor.
        detractor: Real,
        /// Where it goes.
        to: Bool,
    },
    /// The same with a band of memory.
    OutweighsWithHysteresis {
        /// The contributor.
        contributor: Real,
        /// The detractor.
        detractor: Real,
        /// Half the width of the band.
        hysteresis: f64,
        /// What it was on the tick before.
        memory: u32,
        /// Where it goes.
        to: Bool,
    },
    /// True without a break for some time: `confirm` and `held`.
    Lasts {
        /// What lasts.
        of: Bool,
        /// Nanoseconds.
        duration: u64,
        /// The stopwatch.
        stopwatch: u32,
        /// Where it goes.
        to: Bool,
    },
    /// Kept for some time once it is true: `hold`.
    Hold {
        /// What is kept.
        of: Bool,
        /// Nanoseconds.
        duration: u64,
        /// The stopwatch.
        stopwatch: u32,
        /// Where it goes.
        to: Bool,
    },
    /// Whether an input's sensor is known to have failed.
    Failed {
        /// The input.
        input: u32,
        /// Where it goes.
        to: Bool,
    },
    /// A comparison.
    Compare {
        /// How.
        comparison: Comparison,
        /// The left operand.
        left: Real,
        /// The right operand.
        right: Real,
        /// Where it goes.
        to: Bool,
    },
    /// Whether the mode has been active for that many nanoseconds.
    After {
        /// Nanoseconds.
        duration: u64,
        /// Where it goes.
        to: Bool,
    },
    /// Whether the mode's action has reported completion.
    Done {
        /// Where it goes.
        to: Bool,
    },
    /// Whether the machine is in a mode.
    InMode {
        /// The mode.
        mode: u32,
        /// Where it goes.
        to: Bool,
    },
    /// True now and false on the tick before.
    Rising {
        /// Of what.
        of: Bool,
        /// What it was on the tick before.
        memory: u32,
        /// Where it goes.
        to: Bool,
    },
    /// False now and true on the tick before.
    Falling {
        /// Of what.
        of: Bool,
        /// What it was on the tick before.
        memory: u32,
        /// Where it goes.
        to: Bool,
    },
    /// True on some tick since the mode was entered.
    Latched {
        /// Of what.
        of: Bool,
        /// The latch, cleared when a mode is entered.
        latch: u32,
        /// Where it goes.
        to: Bool,
    },
    /// Rising edges since the mode was entered.
    Count {
        /// Of what.
        of: Bool,
        /// What it was on the tick before.
        memory: u32,
        /// The counter, cleared when a mode is entered.
        counter: u32,
        /// Where it goes.
        to: Real,
    },
    /// Negation.
    Not {
        /// Of what.
        of: Bool,
        /// Where it goes.
        to: Bool,
    },
    /// True where all of a list of [`Code::bool_lists`] are.
    All {
        /// The list.
        of: Range<u32>,
        /// Where it goes.
        to: Bool,
    },
    /// True where any of a list of [`Code::bool_lists`] is.
    Any {
        /// The list.
        of: Range<u32>,
        /// Where it goes.
        to: Bool,
    },
}

/// What is found by following an outline.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Find {
    /// `kernel::outline_centroid`
    Centroid,
    /// `kernel::bisector`
    Bisector,
    /// The first of `kernel::maxima`
    SmallestOfMaximum,
    /// The second of `kernel::maxima`
    LargestOfMaximum,
    /// The third of `kernel::maxima`
    MeanOfMaximum,
}

/// What a set holds between two degrees: the arguments of `kernel::slab`.
#[derive(Debug, Clone, PartialEq)]
pub struct Slab {
    /// The strength that clips the set.
    pub strength: Real,
    /// The degree at which the slab begins.
    pub floor: f64,
    /// How high it is, above 0.
    pub thickness: f64,
    /// The factors of its area.
    pub area: (f64, f64),
    /// The factors of its moment.
    pub moment: (f64, f64, f64),
}

/// A stretch of an output's range on which every set is linear.
#[derive(Debug, Clone, PartialEq)]
pub struct Stretch {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The degrees of every set just inside its ends, a span of [`Code::points`].
    pub lines: Range<u32>,
}

/// A membership function with its numbers in SI.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// `kernel::ramp`
    Ramp {
        /// Where the degree is 0.
        zero_at: f64,
        /// Where the degree is 1.
        one_at: f64,
    },
    /// `kernel::triangle`
    Triangle([f64; 3]),
    /// `kernel::trapezoid`
    Trapezoid([f64; 4]),
    /// `kernel::rectangle`
    Rectangle([f64; 2]),
    /// `kernel::singleton`
    Singleton(f64),
    /// `kernel::points` over a span of [`Code::points`]
    Points(Range<u32>),
    /// `kernel::gaussian`
    Gaussian([f64; 2]),
    /// `kernel::gaussian2`
    Gaussian2([f64; 4]),
    /// `kernel::bell`
    Bell([f64; 3]),
    /// `kernel::sigmoid`
    Sigmoid([f64; 2]),
    /// `kernel::rise`
    Rise([f64; 2]),
    /// `kernel::fall`
    Fall([f64; 2]),
    /// `kernel::rise_and_fall`
    RiseAndFall([f64; 4]),
    /// `kernel::cosine`
    Cosine([f64; 2]),
}

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
    /// The diagram's name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// The robot's name.
    pub robot: String,
    /// The robot's sensors, in its order.
    pub inputs: Vec<Input>,
    /// The robot's actions, in its order.
    pub actions: Vec<Action>,
    /// What is computed.
    pub code: Code,
    /// Sense and fuse: run on every tick before a transition is chosen.
    pub fuse: Steps,
    /// Run on every tick after a transition was chosen: what scenarios watch.
    pub watch: Steps,
    /// The networks it senses through.
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

/// A mode: spans of the plan's lists.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Its name.
    pub name: String,
    /// Where it stands.
    pub origin: Origin,
    /// Its ways out in [`Plan::transitions`].
    pub transitions: Range<u32>,
    /// Its commands of every tick in [`Plan::calls`].
    pub actions: Range<u32>,
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

/// A random number, drawn when its mode is entered.
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
