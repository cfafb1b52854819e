//! How long an effect can keep its cause waiting.

use std::collections::BTreeSet;

use petgraph::algo::kosaraju_scc;
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::visit::EdgeRef;

use super::product::{Node, Product};
use crate::base::Id;
use crate::ir::Mode;

/// The bits of what is watched.
const CAUSE: u64 = 1;
const EFFECT: u64 = 2;

/// How long it can take.
pub(super) enum Longest {
    /// On no tick later than this is the effect still missing, in nanoseconds after the cause.
    Within(u64),
    /// The machine may stay in these modes for ever, and the effect never come.
    Endless(BTreeSet<Id<Mode>>),
}

/// Latest times, in nanoseconds after the cause.
#[derive(Clone, Copy)]
struct Latest {
    /// Of the tick that entered the mode; below 0 where that was before the cause.
    entry: i128,
    /// Of the tick itself.
    tick: i128,
}

impl Latest {
    fn or(self, other: Option<Self>) -> Self {
        let other = other.unwrap_or(self);
        Self { entry: self.entry.max(other.entry), tick: self.tick.max(other.tick) }
    }
}

/// The longest time for which the effect is missing, over every way through a graph that has been explored.
///
/// A tick finds a mode before its next threshold, and comes no later than the longest tick after the one before. What
/// can follow itself takes no longer than the mode it is in; if it leaves modes, or no threshold follows, there is no
/// end. Everything else is a longest path.
pub(super) fn longest(product: &Product<'_, '_>, longest_tick: u64) -> Longest {
    let is_waiting = |node: &Node| node.holds & EFFECT == 0;
    let mut graph = DiGraph::<(), usize>::new();
    product.nodes.iter().for_each(|_| {
        graph.add_node(());
    });
    for (from, edges) in product.edges.iter().enumerate().filter(|(from, _)| is_waiting(&product.nodes[*from])) {
        for edge in edges.iter().filter(|edge| is_waiting(&product.nodes[edge.to])) {
            graph.add_edge(NodeIndex::new(from), NodeIndex::new(edge.to), edge.passed);
        }
    }
    let begin = |node: &Node| {
        let asks = node.holds & CAUSE != 0 && is_waiting(node);
        asks.then(|| Latest { entry: -i128::from(product.earliest(node)), tick: 0 })
    };
    let mut latest: Vec<Option<Latest>> = product.nodes.iter().map(begin).collect();
    let groups = kosaraju_scc(&graph);
    let mut group_of = vec![0; product.nodes.len()];
    for (index, group) in groups.iter().enumerate() {
        for node in group {
            group_of[node.index()] = index;
        }
    }
    let mut longest = 0;
    for (index, group) in groups.iter().enumerate().rev() {
        let arrival = group.iter().filter_map(|node| latest[node.index()]).reduce(|one, other| one.or(Some(other)));
        let Some(arrival) = arrival else { continue };
        let successors = group.iter().flat_map(|from| graph.neighbors(*from));
        let mut inner = successors.filter(|to| group_of[to.index()] == index).peekable();
        if inner.peek().is_some() {
            let moves = inner.any(|to| product.nodes[to.index()].entered);
            let modes = group.iter().map(|node| product.nodes[node.index()].mode);
            let first = &product.nodes[group[0].index()];
            let Some(until) = product.until(first.mode, first.state.0).filter(|_| !moves) else {
                return Longest::Endless(modes.collect());
            };
            for node in group {
                let tick = arrival.entry + i128::from(until) - 1;
                latest[node.index()] = Some(Latest { entry: arrival.entry, tick });
            }
        }
        for from in group {
            let (node, Some(here)) = (&product.nodes[from.index()], latest[from.index()]) else { continue };
            longest = longest.max(here.tick);
            for edge in graph.edges(*from) {
                let until = product.until(node.mode, *edge.weight()).map(|until| here.entry + i128::from(until) - 1);
                let next = here.tick + i128::from(longest_tick);
                let tick = until.map_or(next, |until| until.min(next));
                let to = edge.target().index();
                let entry = if product.nodes[to].entered { tick } else { here.entry };
                latest[to] = Some(Latest { entry, tick }.or(latest[to]));
            }
        }
    }
    Longest::Within(u64::try_from(longest).unwrap_or(u64::MAX))
}
