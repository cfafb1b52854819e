//! Modes that no path of transitions leads to.

use petgraph::graph::DiGraph;
use petgraph::visit::{Dfs, Walker};

use crate::diag::{Diagnostic, rules};
use crate::ir::{Diagram, Mode};

pub(super) fn check(diagram: &Diagram, findings: &mut Vec<Diagnostic>) {
    // What was left out may have held the way to a mode.
    let (Some(entry), false) = (diagram.entry, diagram.incomplete) else { return };
    let mut graph = DiGraph::<(), ()>::with_capacity(diagram.modes.len(), diagram.modes.len());
    let nodes: Vec<_> = diagram.modes.ids().map(|_| graph.add_node(())).collect();
    for (id, mode) in diagram.modes.iter() {
        // A target that does not exist was reported; the mode it was meant for would be reported as unreachable too.
        if mode.transitions.iter().any(|transition| transition.target.is_none()) {
            return;
        }
        let targets = mode.transitions.iter().filter_map(|transition| transition.target).chain(mode.otherwise);
        for target in targets {
            graph.add_edge(nodes[id.index()], nodes[target.index()], ());
        }
    }
    let mut reached = vec![false; nodes.len()];
    for node in Dfs::new(&graph, nodes[entry.index()]).iter(&graph) {
        reached[node.index()] = true;
    }
    let unreachable = diagram.modes.iter().filter(|(id, mode)| !reached[id.index()] && !mode.inherited);
    findings.extend(unreachable.map(|(_, mode)| unreachable_mode(mode, &diagram.modes[entry])));
}

fn unreachable_mode(mode: &Mode, entry: &Mode) -> Diagnostic {
    let message = format!("no path of transitions leads to `{}`", mode.symbol.name);
    Diagnostic::new(&rules::UNREACHABLE_MODE, mode.symbol.span, message)
        .label(entry.symbol.span, "the machine starts here")
        .help("add a transition to it, or take the mode out")
}
