//! The conditions of transitions as one formula over atoms: what is the same is one node, flags are inlined.

use std::collections::{BTreeSet, HashMap};
use std::hash::Hash;

use crate::base::{Exact, Id};
use crate::ir::{Comparison, Diagram, Expr, Flag, Mode, Op, Program, Sensor, Transition};

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
    /// At the end of the tick: nanoseconds in the mode that the machine is in then.
    Lasted(u64),
    /// At the end of the tick: the machine is in the mode.
    In(Id<Mode>),
    /// At the end of the tick: it is, and was not before.
    Entered(Id<Mode>),
    /// At the end of the tick: it is not, and was before.
    Left(Id<Mode>),
    /// What runs inside a mode is in one of its own, and so on inward.
    Inside(Vec<Id<Mode>>),
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
    pub(super) fn allows(self, claimed: bool, now: bool) -> bool {
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
    /// The node of each transition's condition.
    pub roots: Vec<usize>,
    /// The node of each condition that is watched.
    pub(super) watched: Vec<usize>,
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
        let roots: Vec<_> = transitions.into_iter().map(|transition| transition.condition).collect();
        Self::of(program, diagram, &roots)
    }

    /// Some conditions, as `new`.
    pub(super) fn of(program: &Program, diagram: &Diagram, roots: &[Id<Expr>]) -> Option<Self> {
        Self::of_conditions(program, diagram, roots, &[], &HashMap::new())
    }

    /// The conditions of a mode's transitions, and some that are watched from outside. What these say of other modes than
    /// those the machine can be in at the end of a tick is settled.
    pub(super) fn watching(program: &Program, diagram: &Diagram, mode: Id<Mode>, watched: &[Id<Expr>]) -> Option<Self> {
        let transitions = &diagram.modes[mode].transitions;
        let roots: Vec<_> = transitions.iter().map(|transition| transition.condition).collect();
        let targets = transitions.iter().filter_map(|transition| transition.target);
        let ends: BTreeSet<_> = targets.chain(diagram.modes[mode].otherwise).chain([mode]).collect();
        let mut settled = HashMap::new();
        for root in watched {
            settle(program, *root, &ends, &mut settled);
        }
        Self::of_conditions(program, diagram, &roots, watched, &settled)
    }

    fn of_conditions(
        program: &Program,
        diagram: &Diagram,
        roots: &[Id<Expr>],
        watched: &[Id<Expr>],
        settled: &HashMap<Id<Expr>, bool>,
    ) -> Option<Self> {
        let mut formula = Self::default();
        let mut flags = HashMap::new();
        for flag in flags_of(program, diagram, &[roots, watched].concat(), settled) {
            let condition = diagram.flags[flag].condition;
            let node = formula.condition(program, diagram, condition, &flags, None)?;
            flags.insert(flag, node);
        }
        for root in roots {
            let node = formula.condition(program, diagram, *root, &flags, None)?;
            formula.roots.push(node);
        }
        for root in watched {
            let node = formula.condition(program, diagram, *root, &flags, Some(settled))?;
            formula.watched.push(node);
        }
        (formula.atoms.len() <= MOST_ATOMS).then_some(formula)
    }

    /// The atoms of which `holds` says so, as bits.
    pub(super) fn truth_of(&self, holds: impl Fn(&Atom) -> bool) -> u64 {
        self.atoms.iter().enumerate().map(|(index, atom)| u64::from(holds(atom)) << index).sum()
    }

    /// Whether an action reports completion where these atoms are true.
    pub(super) fn is_done(&self, truth: u64) -> bool {
        truth & self.truth_of(|atom| *atom == Atom::Done) != 0
    }

    /// What is true or false of one tick alone: without the past, time, and what the machine does.
    pub(super) fn present(&self, program: &Program) -> impl Iterator<Item = Atom> {
        self.atoms.iter().filter_map(|atom| present(program, atom))
    }

    /// Of that, what is looked at in the past.
    pub(super) fn remembered(&self, program: &Program) -> Vec<Atom> {
        let mut waiting = Vec::new();
        let mut found = Vec::new();
        for atom in &self.atoms {
            match atom {
                Atom::Past(_, of) | Atom::Count(_, of, _) => waiting.push(*of),
                Atom::Open(_) => found.extend(present(program, atom)),
                _ => {}
            }
        }
        while let Some(node) = waiting.pop() {
            match &self.nodes[node] {
                Node::Constant(_) => {}
                Node::Atom(atom) => found.extend(present(program, &self.atoms[*atom])),
                Node::Not(of) => waiting.push(*of),
                Node::All(of) | Node::Any(of) => waiting.extend(of),
            }
        }
        found
    }

    /// No condition, but ticks that differ by some atoms; `None` where there are too many.
    pub(super) fn of_atoms(atoms: impl IntoIterator<Item = Atom>) -> Option<Self> {
        let mut formula = Self::default();
        for atom in atoms {
            formula.atom(atom);
        }
        (formula.atoms.len() <= MOST_ATOMS).then_some(formula)
    }

    /// A condition that is looked at before a transition is taken or, where there is something settled, at the end of the
    /// tick.
    fn condition(
        &mut self,
        program: &Program,
        diagram: &Diagram,
        root: Id<Expr>,
        flags: &HashMap<Id<Flag>, usize>,
        at_end: Option<&HashMap<Id<Expr>, bool>>,
    ) -> Option<usize> {
        let is_at_end = at_end.is_some();
        let mode = |of: &Id<Expr>| match program.exprs[*of].op {
            Op::InMode(mode) if is_at_end => Some(mode),
            _ => None,
        };
        let settled = |id: &Id<Expr>| at_end.and_then(|settled| settled.get(id)).copied();
        let mut nodes: HashMap<Id<Expr>, usize> = HashMap::new();
        for id in parts_where(program, root, |id| settled(&id).is_none()) {
            if let Some(value) = settled(&id) {
                let node = self.node(Node::Constant(value));
                nodes.insert(id, node);
                continue;
            }
            let node = match &program.exprs[id].op {
                // Operands of comparisons are read where the comparison stands.
                Op::Number(_) | Op::Sensor(_) | Op::Count(_) => continue,
                Op::Error => return None,
                Op::Flag(flag) => *flags.get(flag)?,
                Op::Not(of) => self.node(Node::Not(nodes[of])),
                Op::And(of) => self.node(Node::All(sorted(of.iter().map(|of| nodes[of])))),
                Op::Or(of) => self.node(Node::Any(sorted(of.iter().map(|of| nodes[of])))),
                // At the end of a tick a counter of its own is looked at.
                Op::Compare(_, left, right)
                    if is_at_end && [left, right].iter().any(|of| matches!(program.exprs[**of].op, Op::Count(_))) =>
                {
                    self.atom(Atom::Open(id))
                }
                &Op::Compare(comparison, left, right) => {
                    self.comparison(program, id, (comparison, left, right), &nodes)
                }
                &Op::Event { sense, event } => self.event(program, diagram, id, sense, event),
                Op::Failed(sensor) => self.atom(Atom::Failed(*sensor)),
                Op::After(0) => self.node(Node::Constant(true)),
                Op::After(duration) if is_at_end => self.atom(Atom::Lasted(*duration)),
                Op::After(duration) => self.atom(Atom::After(*duration)),
                Op::Done => self.atom(Atom::Done),
                Op::Rising(of) => self.atom(mode(of).map_or(Atom::Past(Past::Rising, nodes[of]), Atom::Entered)),
                Op::Falling(of) => self.atom(mode(of).map_or(Atom::Past(Past::Falling, nodes[of]), Atom::Left)),
                Op::Held(of, duration) => self.atom(Atom::Past(Past::Held(*duration), nodes[of])),
                // At the end of a tick a latch of its own is looked at, which that tick has already set.
                Op::Latched(of) if is_at_end => {
                    let earlier = self.atom(Atom::Open(id));
                    self.node(Node::Any(sorted([nodes[of], earlier].into_iter())))
                }
                Op::Latched(of) => self.atom(Atom::Past(Past::Latched, nodes[of])),
                Op::InMode(mode) if is_at_end => self.atom(Atom::In(*mode)),
                Op::InMode(_) | Op::Unknown => self.atom(Atom::Open(id)),
                Op::Inside(path) => self.atom(Atom::Inside(path.clone())),
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
                return self.node(Node::Constant(comparison.holds(*left, *right)));
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
        self.write_values(truth, &mut values).then_some(values)
    }

    /// Writes the value of every node; whether the past agrees with the present.
    pub(super) fn write_values(&self, truth: u64, values: &mut Vec<bool>) -> bool {
        self.claim(truth, values);
        let allows = |(bit, atom): (usize, &Atom)| match atom {
            Atom::Past(past, of) => past.allows(truth >> bit & 1 == 1, values[*of]),
            _ => true,
        };
        self.atoms.iter().enumerate().all(allows)
    }

    /// The value of every node where these atoms are true, whatever they say of the past.
    pub(super) fn claimed(&self, truth: u64) -> Vec<bool> {
        let mut values = Vec::with_capacity(self.nodes.len());
        self.claim(truth, &mut values);
        values
    }

    fn claim(&self, truth: u64, values: &mut Vec<bool>) {
        values.clear();
        for node in &self.nodes {
            values.push(match node {
                Node::Constant(value) => *value,
                Node::Atom(atom) => truth >> atom & 1 == 1,
                Node::Not(of) => !values[*of],
                Node::All(of) => of.iter().all(|of| values[*of]),
                Node::Any(of) => of.iter().any(|of| values[*of]),
            });
        }
    }

    /// What is known of every node where that is known of the atoms, each by its position; an atom is told what is known of
    /// the nodes before it.
    pub(super) fn known(&self, mut of_atom: impl FnMut(usize, &[Option<bool>]) -> Option<bool>) -> Vec<Option<bool>> {
        let mut values: Vec<Option<bool>> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let all = |of: &[usize], otherwise: bool| {
                let decides = of.iter().any(|of| values[*of] == Some(otherwise));
                let is_open = of.iter().any(|of| values[*of].is_none());
                if decides { Some(otherwise) } else { (!is_open).then_some(!otherwise) }
            };
            values.push(match node {
                Node::Constant(value) => Some(*value),
                Node::Atom(atom) => of_atom(*atom, &values),
                Node::Not(of) => values[*of].map(|value| !value),
                Node::All(of) => all(of, false),
                Node::Any(of) => all(of, true),
            });
        }
        values
    }

    /// Whether something depends on readings of the past.
    pub(super) fn looks_back(&self) -> bool {
        self.atoms.iter().any(|atom| matches!(atom, Atom::Past(..) | Atom::Open(_) | Atom::Count(..)))
    }

    /// Whether the past is as these atoms say where the nodes have these values, and nothing that is looked at was ever
    /// true on a tick of the mode before.
    pub(super) fn looks_at_nothing(&self, truth: u64, values: &[bool], is_first: bool) -> bool {
        let is_clear = |(bit, atom): (usize, &Atom)| match atom {
            // The tick before the first one is not known.
            Atom::Past(Past::Falling, _) if is_first => false,
            Atom::Past(_, of) => truth >> bit & 1 == 0 && !values[*of],
            Atom::Count(_, of, _) => !values[*of],
            Atom::Open(_) => false,
            _ => true,
        };
        self.atoms.iter().enumerate().all(is_clear)
    }

    /// The value of every node after so many nanoseconds in a mode, once the readings have been the same for long.
    pub(super) fn settled(&self, truth: u64, dwell: u64) -> Vec<bool> {
        let mut values = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            values.push(match node {
                Node::Constant(value) => *value,
                Node::Atom(atom) => match self.atoms[*atom] {
                    Atom::Past(past, of) => past.settled(values[of]),
                    Atom::Count(comparison, _, number) => comparison.holds(Exact::ZERO, number),
                    Atom::After(duration) => duration <= dwell,
                    Atom::Lasted(_) | Atom::Entered(_) | Atom::Left(_) | Atom::Done => false,
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

/// An atom that readings and failures decide; of an event with a memory what it would be without.
fn present(program: &Program, atom: &Atom) -> Option<Atom> {
    match *atom {
        Atom::Event { .. } | Atom::Compare(..) | Atom::Failed(_) => Some(atom.clone()),
        Atom::Open(id) => match program.exprs[id].op {
            Op::Event { sense, event } => Some(Atom::Event { sense, event }),
            _ => None,
        },
        Atom::After(_)
        | Atom::Count(..)
        | Atom::Past(..)
        | Atom::Done
        | Atom::Inside(_)
        | Atom::Lasted(_)
        | Atom::In(_)
        | Atom::Entered(_)
        | Atom::Left(_) => None,
    }
}

/// Settles what follows from where the machine can be at the end of a tick.
fn settle(program: &Program, root: Id<Expr>, ends: &BTreeSet<Id<Mode>>, settled: &mut HashMap<Id<Expr>, bool>) {
    for id in parts(program, root) {
        let value = |of: &Id<Expr>| settled.get(of).copied();
        let is_mode = |of: &Id<Expr>| matches!(program.exprs[*of].op, Op::InMode(_));
        let found = match &program.exprs[id].op {
            Op::InMode(mode) if !ends.contains(mode) => Some(false),
            // It was not in one of these before either.
            Op::Rising(of) | Op::Falling(of) if value(of) == Some(false) && is_mode(of) => Some(false),
            Op::Not(of) => value(of).map(|value| !value),
            Op::And(of) if of.iter().any(|of| value(of) == Some(false)) => Some(false),
            Op::Or(of) if of.iter().any(|of| value(of) == Some(true)) => Some(true),
            _ => None,
        };
        settled.extend(found.map(|found| (id, found)));
    }
}

/// An expression and what it is made of, operands first; flags are not entered.
pub(in crate::analysis) fn parts(program: &Program, root: Id<Expr>) -> Vec<Id<Expr>> {
    parts_where(program, root, |_| true)
}

/// The same without what is not to be entered.
fn parts_where(program: &Program, root: Id<Expr>, enters: impl Fn(Id<Expr>) -> bool) -> Vec<Id<Expr>> {
    let mut found = vec![root];
    let mut next = 0;
    while let Some(&id) = found.get(next) {
        next += 1;
        if !enters(id) {
            continue;
        }
        match &program.exprs[id].op {
            Op::Count(of) | Op::Rising(of) | Op::Falling(of) | Op::Held(of, _) | Op::Latched(of) | Op::Not(of) => {
                found.push(*of);
            }
            Op::Compare(_, left, right) => found.extend([*left, *right]),
            Op::And(of) | Op::Or(of) => found.extend(of),
            Op::Error
            | Op::Unknown
            | Op::Number(_)
            | Op::Sensor(_)
            | Op::Failed(_)
            | Op::Event { .. }
            | Op::Flag(_)
            | Op::InMode(_)
            | Op::Inside(_)
            | Op::After(_)
            | Op::Done => {}
        }
    }
    found.sort_unstable();
    found
}

/// The flags that conditions name where they are not settled, and those that these name, in order.
fn flags_of(
    program: &Program,
    diagram: &Diagram,
    conditions: &[Id<Expr>],
    settled: &HashMap<Id<Expr>, bool>,
) -> BTreeSet<Id<Flag>> {
    let mut flags = BTreeSet::new();
    let mut waiting = conditions.to_vec();
    while let Some(condition) = waiting.pop() {
        for id in parts_where(program, condition, |id| !settled.contains_key(&id)) {
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
