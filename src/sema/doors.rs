//! Doors: gaps in the walls they lie on, and what closes them.

use super::Lower;
use crate::base::{Dimension, Span};
use crate::diag::{Diagnostic, rules};
use crate::ir;
use crate::syntax::ast;

/// How far a door may be off the line of its wall, and short of its end, m.
const TOLERANCE: f64 = 0.001;

/// A door, in m.
pub(super) struct Door {
    ends: [[f64; 2]; 2],
    width: f64,
    is_open: bool,
    span: Span,
}

impl Lower<'_> {
    pub(super) fn door(
        &mut self,
        at: &ast::Point,
        width: &ast::Quantity,
        heading: Option<&ast::Quantity>,
        is_open: bool,
        span: Span,
    ) -> Option<Door> {
        let middle = self.point(at);
        let width = self.positive(width, Dimension::LENGTH, "a width");
        let heading = match heading {
            Some(heading) => self.quantity_of(heading, Dimension::ANGLE, None)?.to_f64(),
            None => 0.0,
        };
        let ([x, y], width) = (middle?, width?);
        let (along, across) = (heading.cos() * width / 2.0, heading.sin() * width / 2.0);
        Some(Door { ends: [[x - along, y - across], [x + along, y + across]], width, is_open, span })
    }

    /// Cuts a door out of the walls it lies on, and puts a wall in its place unless it is open. Linear in the walls.
    pub(super) fn hang(&mut self, door: &Door, walls: &mut Vec<ir::Wall>) {
        let mut held = 0.0;
        let mut pieces = Vec::with_capacity(walls.len() + 2);
        for wall in walls.iter() {
            held += cut(wall, door, &mut pieces);
        }
        if held < (door.width - TOLERANCE).max(TOLERANCE) {
            return self.report(off_wall(door, held, walls));
        }
        *walls = pieces;
        if !door.is_open {
            walls.push(ir::Wall { corners: door.ends.to_vec(), is_door: true, span: door.span });
        }
    }
}

/// Adds to `pieces` what a door leaves of a wall. How much of the door lay on it, m.
fn cut(wall: &ir::Wall, door: &Door, pieces: &mut Vec<ir::Wall>) -> f64 {
    let (mut held, mut corners) = (0.0, Vec::new());
    corners.extend(wall.corners.first());
    for ends in wall.corners.windows(2) {
        if let Some((from, to)) = shared(ends[0], ends[1], door) {
            let length = distance(ends[0], ends[1]);
            let place =
                |along: f64| [0, 1].map(|axis| ends[0][axis] + (ends[1][axis] - ends[0][axis]) * along / length);
            held += to - from;
            if from > TOLERANCE {
                corners.push(place(from));
            }
            finish(wall, &mut corners, pieces);
            if length - to > TOLERANCE {
                corners.push(place(to));
            }
        }
        corners.push(ends[1]);
    }
    finish(wall, &mut corners, pieces);
    held
}

fn finish(wall: &ir::Wall, corners: &mut Vec<[f64; 2]>, pieces: &mut Vec<ir::Wall>) {
    if corners.len() > 1 {
        pieces.push(ir::Wall { corners: corners.clone(), ..*wall });
    }
    corners.clear();
}

/// The part of a straight wall that a door takes, in m from the first end; `None` where it lies beside the wall.
fn shared(from: [f64; 2], to: [f64; 2], door: &Door) -> Option<(f64, f64)> {
    let length = distance(from, to);
    let way = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    let seen = door.ends.map(|end| {
        let off = [end[0] - from[0], end[1] - from[1]];
        (off[0] * way[0] + off[1] * way[1], off[1] * way[0] - off[0] * way[1])
    });
    // False for a wall without length too.
    let lies_on_it = seen.iter().all(|(_, beside)| beside.abs() <= TOLERANCE);
    if !lies_on_it {
        return None;
    }
    let [one, other] = seen.map(|(along, _)| along.clamp(0.0, length));
    let (first, last) = (one.min(other), one.max(other));
    (last - first > TOLERANCE).then_some((first, last))
}

fn distance(from: [f64; 2], to: [f64; 2]) -> f64 {
    (to[0] - from[0]).hypot(to[1] - from[1])
}

fn off_wall(door: &Door, held: f64, walls: &[ir::Wall]) -> Diagnostic {
    let message = if held > 0.0 {
        "this door is wider than the wall it lies on has room for"
    } else {
        "this door lies on no wall"
    };
    let middle = [0, 1].map(|axis| f64::midpoint(door.ends[0][axis], door.ends[1][axis]));
    let lines = walls.iter().flat_map(|wall| wall.corners.windows(2).map(move |ends| (wall, ends[0], ends[1])));
    let nearest = lines.min_by(|one, other| off(middle, one.1, one.2).total_cmp(&off(middle, other.1, other.2)));
    let diagnostic = Diagnostic::new(&rules::DOOR_OFF_WALL, door.span, message)
        .note("a door is a gap in a wall: the line across its width runs along the wall, within 1 mm");
    let Some((wall, from, to)) = nearest else {
        return diagnostic.help("write the wall without the gap, and the door on it");
    };
    let degrees = (to[1] - from[1]).atan2(to[0] - from[0]).to_degrees();
    let degrees = (degrees * 1e3).round() / 1e3;
    diagnostic.label(wall.span, "the nearest wall").help(if held > 0.0 {
        "make the door narrower, or move it along the wall".to_owned()
    } else {
        format!("put it on this wall, along it: `heading {degrees} deg`")
    })
}

/// The distance of a place from a straight wall, m.
fn off(place: [f64; 2], from: [f64; 2], to: [f64; 2]) -> f64 {
    let (along, off) = ([to[0] - from[0], to[1] - from[1]], [place[0] - from[0], place[1] - from[1]]);
    let share = (along[0] * off[0] + along[1] * off[1]) / (along[0] * along[0] + along[1] * along[1]);
    let share = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) };
    distance(place, [from[0] + along[0] * share, from[1] + along[1] * share])
}
