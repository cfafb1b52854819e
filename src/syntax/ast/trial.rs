//! Worlds, scenarios and properties.

use super::{Doc, Expr, FailReading, IndexRange, Name, Number, Path, Quantity, Range};
use crate::base::Span;

/// `(x, y)`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Point {
    /// Along the world's x axis.
    pub x: Quantity,
    /// Along the world's y axis.
    pub y: Quantity,
    /// With the parentheses.
    pub span: Span,
}

/// `world hallway { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct World {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// What stands in it.
    pub items: Vec<WorldItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in a world.
#[derive(Debug, Clone, PartialEq)]
pub enum WorldItem {
    /// `wall (0 m, 0 m) -> (12 m, 0 m) -> ...`
    Wall {
        /// Its corners, at least two.
        points: Vec<Point>,
        /// The whole line.
        span: Span,
    },
    /// `door at (8 m, 2 m) width 0.9 m heading 0 deg open`
    Door {
        /// Its middle.
        at: Point,
        /// Its width.
        width: Quantity,
        /// The direction along it.
        heading: Option<Quantity>,
        /// Whether it is open.
        open: bool,
        /// The whole line.
        span: Span,
    },
    /// `box mass 30 kg size (0.4 m, 0.6 m) at (3 m, 1 m) heading 0 deg`
    Box(BoxItem),
    /// `goal (11 m, 1 m)`
    Goal(Point),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// A box that can be pushed.
#[derive(Debug, Clone, PartialEq)]
pub struct BoxItem {
    /// Its name, if it has one: `box crate mass ...`
    pub name: Option<Name>,
    /// Its mass.
    pub mass: Quantity,
    /// Its length along its heading and its width across it.
    pub size: (Quantity, Quantity),
    /// Where its middle is, or how far ahead of the robot its near face is.
    pub place: PlaceAt,
    /// The whole item.
    pub span: Span,
}

/// Where something is placed.
#[derive(Debug, Clone, PartialEq)]
pub enum PlaceAt {
    /// `at (x, y) heading h`
    Point {
        /// Its middle.
        at: Point,
        /// The direction it faces, 0 if not written.
        heading: Option<Quantity>,
    },
    /// `at 0.75 m ahead`: free floor between the robot and it
    Ahead(Quantity),
}

/// `scenario s runs b on r in w extends t { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// What is run.
    pub runs: Option<Name>,
    /// The robot it runs on.
    pub on: Option<Name>,
    /// The world it runs in.
    pub within: Option<Name>,
    /// The scenario it varies.
    pub extends: Option<Name>,
    /// What stands in its braces.
    pub items: Vec<ScenarioItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in a scenario.
#[derive(Debug, Clone, PartialEq)]
pub enum ScenarioItem {
    /// `duration 10 s`
    Duration(Quantity, Span),
    /// `tick 10 ms`
    Tick(Quantity, Span),
    /// `seed 1`
    Seed(Number, Span),
    /// `place robot at (0 m, 0 m) heading 0 deg`
    PlaceRobot {
        /// Which robot of a team; the only one if not written.
        robot: Option<Name>,
        /// Where.
        place: PlaceAt,
        /// The whole line.
        span: Span,
    },
    /// `place box ...`
    PlaceBox(BoxItem),
    /// `fault s = 0 N from 0 s to 3 s`: it reads wrong, silently
    Fault {
        /// The sensor.
        sensor: SensorRef,
        /// What it reads.
        reading: FailReading,
        /// When.
        window: FaultWindow,
        /// The whole line.
        span: Span,
    },
    /// `fail s from 1 s`: it is also reported as failed
    Fail {
        /// The sensor.
        sensor: SensorRef,
        /// When.
        window: FaultWindow,
        /// The whole line.
        span: Span,
    },
    /// `expect ...`
    Expect(Expect),
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// `contact_force` or `sonar[3]`
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SensorRef {
    /// The sensor, or a team member's sensor.
    pub path: Path,
    /// Which of an array.
    pub indices: Vec<IndexRange>,
}

/// `from 0 s to 3 s`, either end left out
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FaultWindow {
    /// The start of the run if not written.
    pub from: Option<Quantity>,
    /// The end of the run if not written.
    pub to: Option<Quantity>,
}

/// `expect forward -> push within 4.5 s .. 5.5 s`
#[derive(Debug, Clone, PartialEq)]
pub struct Expect {
    /// What is expected.
    pub kind: ExpectKind,
    /// The whole line; its text names the expectation in reports.
    pub span: Span,
}

/// What a scenario can expect.
#[derive(Debug, Clone, PartialEq)]
pub enum ExpectKind {
    /// `expect modes a, b, c`: the modes in order, from the start
    Modes(Vec<Name>),
    /// `expect a -> b within t1 .. t2`
    Transition {
        /// The mode that is left.
        from: Name,
        /// The mode that is entered.
        to: Name,
        /// When; at any time if not written.
        within: Option<Range>,
    },
    /// `expect condition within t1 .. t2`: true on some tick
    Within {
        /// The condition.
        condition: Expr,
        /// When; at any time if not written.
        window: Option<Range>,
    },
    /// `expect never condition before t`
    Never {
        /// The condition.
        condition: Expr,
        /// `before t`, `after t` or `within t1 .. t2`; the whole run if not written.
        window: ExpectWindow,
    },
    /// `expect always condition after t`
    Always {
        /// The condition.
        condition: Expr,
        /// When it must hold.
        window: ExpectWindow,
    },
}

/// The part of a run an expectation speaks of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ExpectWindow {
    /// All of it.
    Whole,
    /// `before t`
    Before(Quantity),
    /// `after t`
    After(Quantity),
    /// `within t1 .. t2`
    Within(Range),
}

/// `property no_blind_push of obstacle_manipulation: never push and failed(contact_force)`
#[derive(Debug, Clone, PartialEq)]
pub struct Property {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The behavior it speaks of, where that is written.
    pub of: Option<Name>,
    /// What it claims.
    pub kind: PropertyKind,
    /// The whole declaration.
    pub span: Span,
}

/// What a property can claim.
#[derive(Debug, Clone, PartialEq)]
pub enum PropertyKind {
    /// `never c`
    Never(Expr),
    /// `always c`
    Always(Expr),
    /// `p leads to q within t`
    LeadsTo {
        /// The cause.
        cause: Expr,
        /// The effect.
        effect: Expr,
        /// The longest time between them.
        within: Option<Quantity>,
    },
}
