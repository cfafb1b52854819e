//! What is computed: steps in order over numbered places, with all their numbers.

use std::ops::Range;

use crate::ir;
pub use crate::ir::{Aggregation, Comparison, Implication, SNorm, TNorm, Ties};

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
    /// Modes inside each other, the outermost first; steps hold spans of it.
    pub paths: Vec<u32>,
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
    /// How many windows of readings there are.
    pub windows: u32,
    /// How many readings all of them keep.
    pub readings: u32,
    /// How many stopwatches there are.
    pub stopwatches: u32,
    /// How many counters of the active mode there are.
    pub counters: u32,
    /// How many latches of the active mode there are.
    pub latches: u32,
}

/// How one reading follows from several; `kernel` does it.
pub type Grouping = ir::Grouping<f64>;

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
    /// `kernel::Window`: the mean of the last readings of an input.
    Average {
        /// The input.
        input: u32,
        /// What it reads.
        of: Real,
        /// Nanoseconds between two readings.
        period: u64,
        /// The window.
        window: u32,
        /// The places of the readings that are kept.
        readings: Range<u32>,
        /// Where it goes.
        to: Real,
    },
    /// One reading from several, a list of [`Code::real_lists`].
    Group {
        /// How.
        how: Grouping,
        /// The list.
        of: Range<u32>,
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
    /// Whether the machine is in a mode, what runs inside it in another, and so on inward.
    Inside {
        /// The modes, a list of [`Code::paths`].
        path: Range<u32>,
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
