//! The walls of a world, and an index of where they run.
//!
//! The index is an R-tree that is packed once. Its nodes are wide, so that a few walls are hardly more than a list.

use nalgebra::Vector2;
use rstar::{AABB, ParentNode, RStarInsertionStrategy, RTree, RTreeObject, RTreeParams};

use super::geometry::Rectangle;

/// Straight walls, in the order they were declared.
#[derive(Debug, Clone)]
pub(super) struct Walls {
    lines: Vec<Rectangle>,
    index: RTree<Segment, Nodes>,
}

/// A straight wall in the index.
#[derive(Debug, Clone, Copy)]
pub(super) struct Segment {
    /// Its ends, m.
    pub(super) ends: [Vector2<f64>; 2],
    /// Its position among the walls.
    position: usize,
}

/// A node of the index.
pub(super) type Node = ParentNode<Segment>;

/// How large nodes are.
#[derive(Debug, Clone)]
struct Nodes;

impl RTreeParams for Nodes {
    const MIN_SIZE: usize = 6;
    const MAX_SIZE: usize = 16;
    const REINSERTION_COUNT: usize = 3;
    type DefaultInsertionStrategy = RStarInsertionStrategy;
}

impl RTreeObject for Segment {
    type Envelope = AABB<[f64; 2]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_corners(self.ends[0].into(), self.ends[1].into())
    }
}

impl Walls {
    /// Walls between two ends each, m; a wall without length is none. `n log n` in their number.
    pub(super) fn new(ends: impl IntoIterator<Item = [Vector2<f64>; 2]>) -> Self {
        let ends: Vec<_> = ends.into_iter().filter(|[from, to]| from != to).collect();
        let lines = ends.iter().map(|[from, to]| Rectangle::line(*from, *to)).collect();
        let segments = ends.into_iter().enumerate().map(|(position, ends)| Segment { ends, position });
        Self { lines, index: RTree::bulk_load_with_params(segments.collect()) }
    }

    /// All of them.
    pub(super) fn lines(&self) -> &[Rectangle] {
        &self.lines
    }

    /// The wall at a position.
    pub(super) fn line(&self, position: usize) -> &Rectangle {
        &self.lines[position]
    }

    /// The node that holds all of them.
    pub(super) fn root(&self) -> &Node {
        self.index.root()
    }

    /// Puts into `found` the positions of all walls within `reach` (m) of a place, in order; a few others may be among
    /// them. Logarithmic in the number of walls.
    pub(super) fn near(&self, place: Vector2<f64>, reach: f64, found: &mut Vec<usize>) {
        let corner = Vector2::repeat(reach);
        let around = AABB::from_corners((place - corner).into(), (place + corner).into());
        found.clear();
        found.extend(self.index.locate_in_envelope_intersecting(around).map(|segment| segment.position));
        found.sort_unstable();
    }
}
