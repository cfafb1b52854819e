//! Where boxes and arrows go, by the layers of Sugiyama, Tagawa and Toda (1981).

use dagre::graph::{Graph, GraphOptions};
use dagre::layout::types::LabelPos;
use dagre::{EdgeLabel, LayoutOptions, NodeLabel, layout};

/// A size or a position, px.
pub(super) type Px2 = (f64, f64);

/// What has to be placed.
pub(super) struct Sizes {
    /// Of each box.
    pub(super) boxes: Vec<Px2>,
    /// Of each arrow: the boxes that it leaves and enters, and the size of its label.
    pub(super) arrows: Vec<(usize, usize, Px2)>,
}

/// Where everything is.
pub(super) struct Places {
    /// The middle of each box.
    pub(super) boxes: Vec<Px2>,
    /// Of each arrow the points that it bends towards, and the middle of its label.
    pub(super) arrows: Vec<(Vec<Px2>, Px2)>,
}

/// Places boxes in layers, from top to bottom, so that few arrows cross and few lead up.
pub(super) fn place(sizes: &Sizes) -> Places {
    let mut graph: Graph<NodeLabel, EdgeLabel> =
        Graph::with_options(GraphOptions { directed: true, multigraph: true, compound: false });
    for (index, &(width, height)) in sizes.boxes.iter().enumerate() {
        graph.set_node(index.to_string(), Some(NodeLabel { width, height, ..NodeLabel::default() }));
    }
    for (index, &(from, to, (width, height))) in sizes.arrows.iter().enumerate() {
        let label = EdgeLabel { width, height, labelpos: LabelPos::Center, ..EdgeLabel::default() };
        graph.set_edge(from.to_string(), to.to_string(), Some(label), Some(&index.to_string()));
    }
    layout(&mut graph, Some(LayoutOptions { nodesep: 44.0, edgesep: 26.0, ranksep: 34.0, ..LayoutOptions::default() }));

    let at = |x: Option<f64>, y: Option<f64>| (x.unwrap_or_default(), y.unwrap_or_default());
    let of_box = |index: usize| graph.node(&index.to_string()).map_or((0.0, 0.0), |node| at(node.x, node.y));
    let of_arrow = |(index, (from, to, _)): (usize, &(usize, usize, Px2))| {
        let placed = graph.edge(&from.to_string(), &to.to_string(), Some(&index.to_string()));
        let points = placed.iter().flat_map(|edge| &edge.points).map(|point| (point.x, point.y)).collect();
        (points, placed.map_or((0.0, 0.0), |edge| at(edge.x, edge.y)))
    };
    Places {
        boxes: (0..sizes.boxes.len()).map(of_box).collect(),
        arrows: sizes.arrows.iter().enumerate().map(of_arrow).collect(),
    }
}
