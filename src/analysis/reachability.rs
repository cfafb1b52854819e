//! Modes that no path of transitions leads to, and islands of modes that lead only to each other.

use petgraph::algo::kosaraju_scc;
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::visit::{Dfs, IntoNeighbors, NodeCount, Reversed, Visitable, Walker};

use crate::base::Id;
use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode};

/// Modes and where they lead; the node of a mode has its index.
pub(super) struct Graph(DiGraph<(), ()>);

impl Graph {
    pub(super) fn new<Modes>(diagram: &Diagram, successors: impl Fn(Id<Mode>) -> Modes) -> Self
    where
        Modes: IntoIterator<Item = Id<Mode>>,
    {
        let mut graph = DiGraph::with_capacity(diagram.modes.len(), diagram.modes.len());
        diagram.modes.ids().for_each(|_| {
            graph.add_node(());
        });
        for mode in diagram.modes.ids() {
            for target in successors(mode) {
                graph.add_edge(NodeIndex::new(mode.index()), NodeIndex::new(target.index()), ());
            }
        }
        Self(graph)
    }

    /// For each mode whether a path leads to it from one of some modes.
    pub(super) fn reached(&self, from: impl IntoIterator<Item = Id<Mode>>) -> Vec<bool> {
        walked(&self.0, from)
    }

    /// For each mode whether a path leads from it to one of some modes.
    pub(super) fn leading_to(&self, to: impl IntoIterator<Item = Id<Mode>>) -> Vec<bool> {
        walked(Reversed(&self.0), to)
    }

    /// The modes that lead to each other, in sorted groups; a mode on its own is a group.
    pub(super) fn groups(&self) -> Vec<Vec<Id<Mode>>> {
        let of_group = |group: Vec<NodeIndex>| {
            let mut modes: Vec<_> = group.into_iter().map(|node| Id::new(node.index() as u32)).collect();
            modes.sort_unstable();
            modes
        };
        kosaraju_scc(&self.0).into_iter().map(of_group).collect()
    }

    /// Where a mode leads.
    pub(super) fn successors(&self, mode: Id<Mode>) -> impl Iterator<Item = Id<Mode>> {
        self.0.neighbors(NodeIndex::new(mode.index())).map(|node| Id::new(node.index() as u32))
    }
}

fn walked<G>(graph: G, from: impl IntoIterator<Item = Id<Mode>>) -> Vec<bool>
where
    G: IntoNeighbors<NodeId = NodeIndex> + Visitable<NodeId = NodeIndex> + NodeCount,
{
    let mut walked = vec![false; graph.node_count()];
    let stack = from.into_iter().map(|mode| NodeIndex::new(mode.index())).collect();
    let walk = Dfs::from_parts(stack, graph.visit_map());
    for node in walk.iter(graph) {
        walked[node.index()] = true;
    }
    walked
}

/// Whether a sorted group holds a mode.
pub(super) fn is_in(group: &[Id<Mode>], mode: Id<Mode>) -> bool {
    group.binary_search(&mode).is_ok()
}

pub(super) fn check(diagram: &Diagram, findings: &mut Vec<Diagnostic>) {
    // What was left out may have held the way to a mode.
    let (Some(entry), false) = (diagram.entry, diagram.incomplete) else { return };
    // A target that does not exist was reported; the mode it was meant for would be reported as unreachable too.
    if diagram.modes.values().flat_map(|mode| &mode.transitions).any(|transition| transition.target.is_none()) {
        return;
    }
    let graph = Graph::new(diagram, |mode| written(&diagram.modes[mode]));
    let mut reported = graph.reached([entry]);
    for group in graph.groups().iter().filter(|group| group.len() > 1) {
        let leads_in = |mode: Id<Mode>| !is_in(group, mode) && graph.successors(mode).any(|to| is_in(group, to));
        let judged_elsewhere = group.iter().all(|&mode| diagram.modes[mode].inherited);
        if !reported[group[0].index()] && !judged_elsewhere && !diagram.modes.ids().any(leads_in) {
            findings.push(island(diagram, group, &diagram.modes[entry]));
            for mode in group {
                reported[mode.index()] = true;
            }
        }
    }
    let unreachable = diagram.modes.iter().filter(|(id, mode)| !reported[id.index()] && !mode.inherited);
    findings.extend(unreachable.map(|(_, mode)| unreachable_mode(mode, &diagram.modes[entry])));
}

/// Where a mode leads as written.
pub(super) fn written(mode: &Mode) -> Vec<Id<Mode>> {
    mode.transitions.iter().filter_map(|transition| transition.target).chain(mode.otherwise).collect()
}

fn unreachable_mode(mode: &Mode, entry: &Mode) -> Diagnostic {
    let message = format!("no path of transitions leads to `{}`", mode.symbol.name);
    Diagnostic::new(&rules::UNREACHABLE_MODE, mode.symbol.span, message)
        .label(entry.symbol.span, "the machine starts here")
        .help("add a transition to it, or take the mode out")
}

fn island(diagram: &Diagram, group: &[Id<Mode>], entry: &Mode) -> Diagnostic {
    let names: Vec<_> = group.iter().map(|mode| format!("`{}`", diagram.modes[*mode].symbol.name)).collect();
    let message = format!("{} lead only to each other, and nothing leads to them", names.join(", "));
    let mut places = group.iter().map(|mode| diagram.modes[*mode].symbol.span);
    let mut diagnostic = Diagnostic::new(&rules::ISLAND_OF_MODES, places.next().unwrap_or_default(), message);
    for place in places.take(2) {
        diagnostic = diagnostic.label(place, "also out of reach");
    }
    diagnostic
        .label(entry.symbol.span, "the machine starts here")
        .help("add a transition to one of them, or take them out")
}
