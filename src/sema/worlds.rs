//! Worlds and what stands in them.

use std::collections::HashMap;

use super::{Lower, claim, symbol};
use crate::base::{Dimension, Exact};
use crate::ir;
use crate::syntax::ast;

impl Lower<'_> {
    pub(super) fn world(&mut self, tree: &ast::World) {
        let mut world = ir::World { symbol: symbol(&tree.name, tree.doc.as_ref()), ..ir::World::default() };
        let mut goal = None;
        let mut boxes = HashMap::new();
        let (mut doors, mut has_all_walls) = (Vec::new(), true);
        for item in &tree.items {
            match item {
                ast::WorldItem::Wall { points, span } => {
                    let corners: Vec<_> = points.iter().map(|point| self.point(point)).collect();
                    let corners = corners.into_iter().collect::<Option<_>>();
                    has_all_walls &= corners.is_some();
                    world.walls.extend(corners.map(|corners| ir::Wall { corners, is_door: false, span: *span }));
                }
                ast::WorldItem::Box(item) => {
                    if let Some(name) = &item.name {
                        claim(&mut boxes, name, "box", &mut self.diagnostics);
                    }
                    let lowered = self.box_body(item, world.boxes.len());
                    world.boxes.extend(lowered);
                }
                ast::WorldItem::Goal(point) => {
                    let lowered = self.point(point);
                    self.once(&mut goal, lowered, point.span, "the goal");
                }
                ast::WorldItem::Door { at, width, heading, open, span } => {
                    doors.extend(self.door(at, width, heading.as_ref(), *open, *span));
                }
                ast::WorldItem::Error(_) => has_all_walls = false,
            }
        }
        // A wall that is missing was reported, and may be a door's.
        if has_all_walls {
            for door in &doors {
                self.hang(door, &mut world.walls);
            }
        }
        world.goal = goal.and_then(|(goal, _)| goal);
        let id = self.program.worlds.add(world);
        self.scopes.worlds.insert(tree.name.span, id);
    }

    pub(super) fn box_body(&mut self, tree: &ast::BoxItem, before: usize) -> Option<ir::BoxBody> {
        let mass = self.positive(&tree.mass, Dimension::MASS, "a mass");
        let length = self.extent(&tree.size.0, "a length");
        let width = self.extent(&tree.size.1, "a width");
        let place = self.placement(&tree.place);
        let name = tree.name.as_ref().map_or_else(|| format!("box{}", before + 1), |name| name.text.clone());
        Some(ir::BoxBody { name, mass: mass?, length: length?, width: width?, place: place?, span: tree.span })
    }

    /// A length of a box: thinner ones would need steps too small to simulate.
    fn extent(&mut self, quantity: &ast::Quantity, what: &str) -> Option<f64> {
        let extent = self.positive(quantity, Dimension::LENGTH, what)?;
        if extent < 0.001 {
            self.report(super::invalid(quantity.span, format!("{what} of a box is at least 1 mm")));
            return None;
        }
        Some(extent)
    }

    pub(super) fn placement(&mut self, tree: &ast::PlaceAt) -> Option<ir::Placement> {
        match tree {
            ast::PlaceAt::Point { at, heading } => {
                let point = self.point(at);
                let heading = match heading {
                    Some(heading) => self.quantity_of(heading, Dimension::ANGLE, None),
                    None => Some(Exact::ZERO),
                };
                let [x, y] = point?;
                Some(ir::Placement::At { x, y, heading: heading?.to_f64() })
            }
            ast::PlaceAt::Ahead(distance) => {
                let ahead = self.quantity_of(distance, Dimension::LENGTH, None)?;
                if ahead.is_negative() {
                    self.report(super::invalid(distance.span, "a distance ahead cannot be negative"));
                    return None;
                }
                Some(ir::Placement::Ahead(ahead.to_f64()))
            }
        }
    }

    pub(super) fn point(&mut self, point: &ast::Point) -> Option<[f64; 2]> {
        let x = self.quantity_of(&point.x, Dimension::LENGTH, None);
        let y = self.quantity_of(&point.y, Dimension::LENGTH, None);
        Some([x?.to_f64(), y?.to_f64()])
    }
}
