//! The conditions of transitions as one formula over atoms: what is the same is one node, flags are inlined.

use std::collections::{BTreeSet, HashMap};
use std::hash::Hash;

use crate::base::{Exact, Id};
use crate::ir::{Comparison, Diagram, Expr, Flag, Op, Program, Sensor, Transition};

/// Something that is true or false on a tick, and not made of other such things.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Atom {
    /// An event without memory, a function of the readings.
    Event {
        /// The position of the sense in its diagram.
        sense: u32,
        /// The position of the event in its network.
        event: u32,
    },
    /// A sensor beside a number or another sensor.
    Compare(Comparison, Id<Sensor>, Operand),
    /// A sensor is known to have failed.
    Failed(Id<Sensor>),
    /// Nanoseconds in the mode.
    After(u64),
    /// The rising edges of a node beside a number.
    Count(Comparison, usize, Exact),
    /// A look at the past of a node.
    Past(Past, usize),
    /// The action has reported completion.
    Done,
    /// An event with a memory of its own, or something nothing is known of.
    Open(Id<Expr>),
}

/// What a sensor is compared with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Operand {
    /// In SI.
    Number(Exact),
    /// What it reads.
    Sensor(Id<Sensor>),
}

/// How a node is looked at in the past.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Past {
    /// True now and false on the tick before.
    Rising,
    /// False now and true on the tick before.
    Falling,
    /// True for that many nanoseconds.
    Held(u64),
    /// True on some tick since the mode was entered.
    Latched,
}

impl Past {
    /// Whether the past can say `claimed` while the node is `now`.
    fn allows(self, claimed: bool, now: bool) -> bool {
        match self {
            Self::Held(0) => claimed == now,
            Self::Rising | Self::Held(_) => now || !claimed,
            Self::Falling => !now || !claimed,
            Self::Latched => claimed || !now,
        }
    }

    /// What it says once the node has been `now` for long.
    fn settled(self, now: bool) -> bool {
        match self {
            Self::Rising | Self::Falling => false,
            Self::Held(_) | Self::Latched => now,
        }
    }
}

/// A condition or a part of one. Its parts are named by their positions in [`Formula::nodes`].
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Node {
    /// Always the same.
    Constant(bool),
    /// A position in [`Formula::atoms`].
    Atom(usize),
    /// Negation.
    Not(usize),
    /// Conjunction.
    All(Vec<usize>),
    /// Disjunction.
    Any(Vec<usize>),
}

/// Conditions over atoms. A set of true atoms is a `u64`, a bit for each.
#[derive(Debug, Default)]
pub struct Formula {
    /// Each once. A look at the past stands behind the atoms of what it looks at.
    pub atoms: Vec<Atom>,
    /// Each once, parts before what they are part of.
    pub nodes: Vec<Node>,
    /// The node of each condition.
    pub roots: Vec<usize>,
    known_atoms: HashMap<Atom, usize>,
    known_nodes: HashMap<Node, usize>,
}

/// More atoms than this are not looked into.
const MOST_ATOMS: usize = 64;

impl Formula {
    /// The conditions of some transitions. `None` where one is broken, which was reported, or has too many atoms.
    pub(super) fn new<'a>(
        program: &Program,
        diagram: &Diagram,
        transitions: impl IntoIterator<Item = &'a Transition>,
    ) -> Option<Self> {
        Self::of(program, diagram, transitions.into_iter().map(|transition| transition.condition).collect())
    }

    /// Some conditions, as `new`.
    pub(super) fn of(program: &Program, diagram: &Diagram, roots: Vec<Id<Expr>>) -> Option<Self> {
        let mut formula = Self::default();
        let mut flags = HashMap::new();
        for flag in flags_of(program, diagram, &roots) {
            let node = formula.condition(program, diagram, diagram.flags[flag].condition, &flags)?;
            flags.insert(flag, node);
        }
        for root in roots {
            let node = formula.condition(program, diagram, root, &flags)?;
            formula.roots.push(node);
        }
        (formula.atoms.len() <= MOST_ATOMS).then_some(formula)
    }

    fn condition(
        &mut self,
        program: &Program,
        diagram: &Diagram,
        root: Id<Expr>,
        flags: &HashMap<Id<Flag>, usize>,
    ) -> Option<usize> {
        let mut nodes: HashMap<Id<Expr>, usize> = HashMap::new();
        for id in parts(program, root) {
            let node = match &program.exprs[id].op {
                // Operands of comparisons are read where the comparison stands.
                Op::Number(_) | Op::Sensor(_) | Op::Count(_) => continue,
                Op::Error => return None,
                Op::Flag(flag) => *flags.get(flag)?,
                Op::Not(of) => self.node(Node::Not(nodes[of])),
                Op::And(of) => self.node(Node::All(sorted(of.iter().map(|of| nodes[of])))),
                Op::Or(of) => self.node(Node::Any(sorted(of.iter().map(|of| nodes[of])))),
                &Op::Compare(comparison, left, right) => {
                    self.comparison(program, id, (comparison, left, right), &nodes)
                }
                &Op::Event { sense, event } => self.event(program, diagram, id, sense, event),
                Op::Failed(sensor) => self.atom(Atom::Failed(*sensor)),
                Op::After(0) => self.node(Node::Constant(true)),
                Op::After(duration) => self.atom(Atom::After(*duration)),
                Op::Done => self.atom(Atom::Done),
                Op::Rising(of) => self.atom(Atom::Past(Past::Rising, nodes[of])),
                Op::Falling(of) => self.atom(Atom::Past(Past::Falling, nodes[of])),
                Op::Held(of, duration) => self.atom(Atom::Past(Past::Held(*duration), nodes[of])),
                Op::Latched(of) => self.atom(Atom::Past(Past::Latched, nodes[of])),
                Op::InMode(_) => self.atom(Atom::Open(id)),
            };
            nodes.insert(id, node);
        }
        nodes.get(&root).copied()
    }

    fn comparison(
        &mut self,
        program: &Program,
        id: Id<Expr>,
        (comparison, left, right): (Comparison, Id<Expr>, Id<Expr>),
        nodes: &HashMap<Id<Expr>, usize>,
    ) -> usize {
        // A number outside the range has been reported; what else it leads to would only repeat that.
        let outside = |sensor: Id<Sensor>, number: Exact| {
            let (low, high) = program.sensors[sensor].range;
            number < low || high < number
        };
        let atom = match (&program.exprs[left].op, &program.exprs[right].op) {
            (Op::Sensor(sensor), Op::Number(number)) | (Op::Number(number), Op::Sensor(sensor))
                if outside(*sensor, *number) =>
            {
                Atom::Open(id)
            }
            (Op::Number(left), Op::Number(right)) => {
                return self.node(Node::Constant(compare(comparison, *left, *right)));
            }
            (Op::Sensor(sensor), Op::Number(number)) => Atom::Compare(comparison, *sensor, Operand::Number(*number)),
            (Op::Number(number), Op::Sensor(sensor)) => {
                Atom::Compare(mirrored(comparison), *sensor, Operand::Number(*number))
            }
            (Op::Sensor(left), Op::Sensor(right)) => Atom::Compare(comparison, *left, Operand::Sensor(*right)),
            (Op::Count(of), Op::Number(number)) => Atom::Count(comparison, nodes[of], *number),
            (Op::Number(number), Op::Count(of)) => Atom::Count(mirrored(comparison), nodes[of], *number),
            _ => Atom::Open(id),
        };
        self.atom(atom)
    }

    fn event(&mut self, program: &Program, diagram: &Diagram, id: Id<Expr>, sense: u32, event: u32) -> usize {
        let network = &program.networks[diagram.senses[sense as usize].network];
        let declared = &network.events[event as usize];
        let remembers = declared.hold > 0 || declared.confirm > 0 || !declared.hysteresis.is_zero();
        self.atom(if remembers { Atom::Open(id) } else { Atom::Event { sense, event } })
    }

    fn atom(&mut self, atom: Atom) -> usize {
        let next = self.atoms.len();
        let index = *self.known_atoms.entry(atom.clone()).or_insert(next);
        if index == next {
            self.atoms.push(atom);
        }
        self.node(Node::Atom(index))
    }

    fn node(&mut self, node: Node) -> usize {
        let next = self.nodes.len();
        let index = *self.known_nodes.entry(node.clone()).or_insert(next);
        if index == next {
            self.nodes.push(node);
        }
        index
    }

    /// The value of every node where these atoms are true; `None` where the past contradicts the present.
    pub(super) fn values(&self, truth: u64) -> Option<Vec<bool>> {
        let mut values = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            values.push(match node {
                Node::Constant(value) => *value,
                Node::Atom(atom) => {
                    let claimed = truth >> atom & 1 == 1;
                    if let Atom::Past(past, of) = self.atoms[*atom]
                        && !past.allows(claimed, values[of])
                    {
                        return None;
                    }
                    claimed
                }
                Node::Not(of) => !values[*of],
                Node::All(of) => of.iter().all(|of| values[*of]),
                Node::Any(of) => of.iter().any(|of| values[*of]),
            });
        }
        Some(values)
    }

    /// Whether something depends on readings of the past.
    pub(super) fn looks_back(&self) -> bool {
        self.atoms.iter().any(|atom| matches!(atom, Atom::Past(..) | Atom::Open(_) | Atom::Count(..)))
    }

    /// The value of every node after so many nanoseconds in a mode, once the readings have been the same for long.
    pub(super) fn settled(&self, truth: u64, dwell: u64) -> Vec<bool> {
        let mut values = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            values.push(match node {
                Node::Constant(value) => *value,
                Node::Atom(atom) => match self.atoms[*atom] {
                    Atom::Past(past, of) => past.settled(values[of]),
                    Atom::Count(comparison, _, number) => compare(comparison, Exact::ZERO, number),
                    Atom::After(duration) => duration <= dwell,
                    Atom::Done => false,
                    _ => truth >> atom & 1 == 1,
                },
                Node::Not(of) => !values[*of],
                Node::All(of) => of.iter().all(|of| values[*of]),
                Node::Any(of) => of.iter().any(|of| values[*of]),
            });
        }
        values
    }
}

/// An expression and what it is made of, operands first; flags are not entered.
pub(in crate::analysis) fn parts(program: &Program, root: Id<Expr>) -> Vec<Id<Expr>> {
    let mut found = vec![root];
    let mut next = 0;
    while let Some(&id) = found.get(next) {
        next += 1;
        match &program.exprs[id].op {
            Op::Count(of) | Op::Rising(of) | Op::Falling(of) | Op::Held(of, _) | Op::Latched(of) | Op::Not(of) => {
                found.push(*of);
            }
            Op::Compare(_, left, right) => found.extend([*left, *right]),
            Op::And(of) | Op::Or(of) => found.extend(of),
            Op::Error
            | Op::Number(_)
            | Op::Sensor(_)
            | Op::Failed(_)
            | Op::Event { .. }
            | Op::Flag(_)
            | Op::InMode(_)
            | Op::After(_)
            | Op::Done => {}
        }
    }
    found.sort_unstable();
    found
}

/// The flags that conditions name, and those that these name, in order.
fn flags_of(program: &Program, diagram: &Diagram, conditions: &[Id<Expr>]) -> BTreeSet<Id<Flag>> {
    let mut flags = BTreeSet::new();
    let mut waiting = conditions.to_vec();
    while let Some(condition) = waiting.pop() {
        for id in parts(program, condition) {
            if let Op::Flag(flag) = program.exprs[id].op
                && flags.insert(flag)
            {
                waiting.push(diagram.flags[flag].condition);
            }
        }
    }
    flags
}

fn sorted(nodes: impl Iterator<Item = usize>) -> Vec<usize> {
    nodes.collect::<BTreeSet<_>>().into_iter().collect()
}

/// The comparison with its sides exchanged.
fn mirrored(comparison: Comparison) -> Comparison {
    match comparison {
        Comparison::Less => Comparison::Greater,
        Comparison::LessOrEqual => Comparison::GreaterOrEqual,
        Comparison::Greater => Comparison::Less,
        Comparison::GreaterOrEqual => Comparison::LessOrEqual,
        Comparison::Equal | Comparison::NotEqual => comparison,
    }
}

pub(super) fn compare(comparison: Comparison, left: Exact, right: Exact) -> bool {
    match comparison {
        Comparison::Less => left < right,
        Comparison::LessOrEqual => left <= right,
        Comparison::Greater => left > right,
        Comparison::GreaterOrEqual => left >= right,
        Comparison::Equal => left == right,
        Comparison::NotEqual => left != right,
    }
}
