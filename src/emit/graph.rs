//! Which steps a value needs.

use std::collections::{BTreeSet, HashMap};
use std::ops::Range;

use crate::plan::{Bool, Code, Real, Step};

/// The position of a step: every step computes one value, from those of steps before it.
pub(super) type Node = usize;

/// A span of one of a plan's lists.
pub(super) fn part<'a, T>(list: &'a [T], span: &Range<u32>) -> &'a [T] {
    list.get(span.start as usize..span.end as usize).unwrap_or_default()
}

/// The steps of a plan, found by what they compute.
pub(super) struct Graph<'a> {
    pub(super) code: &'a Code,
    reals: Vec<Option<Node>>,
    bools: Vec<Option<Node>>,
    /// Steps whose values are computed elsewhere, and from what.
    elsewhere: HashMap<Node, Vec<Node>>,
}

impl<'a> Graph<'a> {
    pub(super) fn new(code: &'a Code) -> Self {
        let (reals, bools) = (vec![None; code.reals as usize], vec![None; code.bools as usize]);
        let mut graph = Self { code, reals, bools, elsewhere: HashMap::new() };
        for (node, step) in code.steps.iter().enumerate() {
            let place = match result(step) {
                Value::Real(real) => graph.reals.get_mut(real as usize),
                Value::Bool(bool) => graph.bools.get_mut(bool as usize),
            };
            if let Some(place) = place {
                *place = Some(node);
            }
        }
        graph
    }

    /// From here on a step counts as computed from these.
    pub(super) fn compute_from(&mut self, node: Node, operands: Vec<Node>) {
        self.elsewhere.insert(node, operands);
    }

    /// What computes a number; `None` for one that is drawn.
    pub(super) fn real(&self, real: Real) -> Option<Node> {
        self.reals.get(real as usize).copied().flatten()
    }

    /// What computes a truth value.
    pub(super) fn bool(&self, bool: Bool) -> Option<Node> {
        self.bools.get(bool as usize).copied().flatten()
    }

    /// A list of numbers.
    pub(super) fn real_list(&self, of: &Range<u32>) -> &'a [Real] {
        part(&self.code.real_lists, of)
    }

    /// A list of truth values.
    pub(super) fn bool_list(&self, of: &Range<u32>) -> &'a [Bool] {
        part(&self.code.bool_lists, of)
    }

    /// What a step reads.
    pub(super) fn operands(&self, node: Node) -> Vec<Node> {
        if let Some(operands) = self.elsewhere.get(&node) {
            return operands.clone();
        }
        let (mut reals, mut bools): (Vec<Real>, Vec<Bool>) = (Vec::new(), Vec::new());
        match &self.code.steps[node] {
            Step::Read { .. }
            | Step::Constant { .. }
            | Step::Failed { .. }
            | Step::After { .. }
            | Step::Done { .. }
            | Step::InMode { .. }
            | Step::Inside { .. } => {}
            Step::Average { of, .. }
            | Step::Degree { of, .. }
            | Step::Complement { of, .. }
            | Step::Very { of, .. }
            | Step::Somewhat { of, .. }
            | Step::Weigh { of, .. }
            | Step::Limit { of, .. }
            | Step::Fires { of, .. } => reals.push(*of),
            Step::Group { of, .. } | Step::Minimum { of, .. } | Step::Maximum { of, .. } => {
                reals.extend(self.real_list(of));
            }
            Step::Linear { factors, .. } => {
                reals.extend(part(&self.code.factors, factors).iter().map(|(real, _)| *real));
            }
            Step::Centroid { slabs, .. } => {
                reals.extend(part(&self.code.slabs, slabs).iter().map(|slab| slab.strength));
            }
            Step::Outline { strengths, .. } | Step::Midpoints { strengths, .. } => {
                reals.extend(self.real_list(strengths));
            }
            Step::Mean { weights, values, .. } => {
                reals.extend(self.real_list(weights).iter().chain(self.real_list(values)));
            }
            Step::Otherwise { fired, of, .. } | Step::Keep { fired, of, .. } => {
                reals.push(*of);
                bools.push(*fired);
            }
            Step::Outweighs { contributor, detractor, .. }
            | Step::OutweighsWithHysteresis { contributor, detractor, .. } => reals.extend([contributor, detractor]),
            Step::Compare { left, right, .. } | Step::TNorm { left, right, .. } | Step::SNorm { left, right, .. } => {
                reals.extend([left, right]);
            }
            Step::Lasts { of, .. }
            | Step::Hold { of, .. }
            | Step::Rising { of, .. }
            | Step::Falling { of, .. }
            | Step::Latched { of, .. }
            | Step::Count { of, .. }
            | Step::Not { of, .. } => bools.push(*of),
            Step::All { of, .. } | Step::Any { of, .. } => bools.extend(self.bool_list(of)),
        }
        let reals = reals.into_iter().filter_map(|real| self.real(real));
        reals.chain(bools.into_iter().filter_map(|bool| self.bool(bool))).collect()
    }

    /// Some steps and all that they are computed from, in order; what `known` holds is left out.
    pub(super) fn needed(&self, roots: impl IntoIterator<Item = Node>, known: &BTreeSet<Node>) -> BTreeSet<Node> {
        let mut needed = BTreeSet::new();
        let mut waiting: Vec<_> = roots.into_iter().collect();
        while let Some(node) = waiting.pop() {
            if !known.contains(&node) && needed.insert(node) {
                waiting.extend(self.operands(node));
            }
        }
        needed
    }
}

enum Value {
    Real(Real),
    Bool(Bool),
}

fn result(step: &Step) -> Value {
    match *step {
        Step::Read { to, .. }
        | Step::Average { to, .. }
        | Step::Group { to, .. }
        | Step::Constant { to, .. }
        | Step::Degree { to, .. }
        | Step::Complement { to, .. }
        | Step::Very { to, .. }
        | Step::Somewhat { to, .. }
        | Step::Minimum { to, .. }
        | Step::Maximum { to, .. }
        | Step::TNorm { to, .. }
        | Step::SNorm { to, .. }
        | Step::Weigh { to, .. }
        | Step::Linear { to, .. }
        | Step::Centroid { to, .. }
        | Step::Outline { to, .. }
        | Step::Midpoints { to, .. }
        | Step::Mean { to, .. }
        | Step::Limit { to, .. }
        | Step::Otherwise { to, .. }
        | Step::Keep { to, .. }
        | Step::Count { to, .. } => Value::Real(to),
        Step::Fires { to, .. }
        | Step::Outweighs { to, .. }
        | Step::OutweighsWithHysteresis { to, .. }
        | Step::Lasts { to, .. }
        | Step::Hold { to, .. }
        | Step::Failed { to, .. }
        | Step::Compare { to, .. }
        | Step::After { to, .. }
        | Step::Done { to, .. }
        | Step::InMode { to, .. }
        | Step::Inside { to, .. }
        | Step::Rising { to, .. }
        | Step::Falling { to, .. }
        | Step::Latched { to, .. }
        | Step::Not { to, .. }
        | Step::All { to, .. }
        | Step::Any { to, .. } => Value::Bool(to),
    }
}
