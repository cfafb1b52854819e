//! Arbiters and teams.

use super::{Call, Doc, Expr, Name, Number, Path};
use crate::base::Span;

/// `arbiter navigation on labmate { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Arbiter {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The robot.
    pub on: Option<Name>,
    /// What stands in its braces.
    pub items: Vec<ArbiterItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in an arbiter.
#[derive(Debug, Clone, PartialEq)]
pub enum ArbiterItem {
    /// `emergency condition -> command`
    Emergency {
        /// When.
        condition: Expr,
        /// What.
        command: Call,
        /// The whole line.
        span: Span,
    },
    /// `client avoid = collision_avoidance priority 1 when ... else 3`
    Client(Client),
    /// `ties in_order` or `ties random`
    Ties {
        /// The word.
        order: Name,
        /// The whole line.
        span: Span,
    },
    /// Text that is none of these; its faults were reported.
    Error(Span),
}

/// A client of an arbiter.
#[derive(Debug, Clone, PartialEq)]
pub struct Client {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// The diagram it runs.
    pub diagram: Name,
    /// Its priorities: each holds when its condition does, the last one otherwise.
    pub priorities: Vec<ClientPriority>,
    /// The whole line.
    pub span: Span,
}

/// `1 when state is forward`, or `3`
#[derive(Debug, Clone, PartialEq)]
pub struct ClientPriority {
    /// 1 to 10, 1 the highest.
    pub priority: Number,
    /// When it holds; always, if nothing is written.
    pub when: Option<Expr>,
}

/// `team pushers { ... }`
#[derive(Debug, Clone, PartialEq)]
pub struct Team {
    /// Its doc comment.
    pub doc: Option<Doc>,
    /// Its name.
    pub name: Name,
    /// What stands in its braces.
    pub items: Vec<TeamItem>,
    /// The whole declaration.
    pub span: Span,
}

/// What may stand in a team.
#[derive(Debug, Clone, PartialEq)]
pub enum TeamItem {
    /// `robot a = j5 runs clear_area`
    Member {
        /// The member's name.
        name: Name,
        /// Its kind of robot.
        robot: Name,
        /// What it runs.
        runs: Name,
        /// The whole line.
        span: Span,
    },
    /// `a.partner_pushing = b.mode is clear`
    Link {
        /// The flag that is set.
        flag: Path,
        /// When.
        condition: Expr,
        /// The whole line.
        span: Span,
    },
    /// Text that is none of these; its faults were reported.
    Error(Span),
}
