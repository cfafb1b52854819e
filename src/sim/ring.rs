//! What range sensors see: the nearest thing within a beam.
//!
//! A beam is a cone with its apex on the hull, around its bearing from the middle of the robot. It lies within the cone
//! of the same width around the same bearing whose apex is that middle. So a glance from the middle tells which beams a
//! wall can be in, and a whole ring looks around in one walk through the index, near things first: what is behind them
//! is never looked at.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

use nalgebra::{Isometry2, Vector2};
use rstar::{AABB, RTreeNode};

use super::geometry::Rectangle;
use super::walls::Node;
use super::world::World;

/// How far inside the hull a beam begins, m: what touches the hull is in front of it then.
const INSET: f64 = 1e-5;
/// More than a rough bearing is off, rad.
const ROUGHNESS: f64 = 0.004;

/// Range sensors that stand evenly around a robot; a single one looks ahead.
#[derive(Debug, Clone)]
pub(super) struct Ring {
    beams: Vec<Beam>,
    /// What is farther than this is not seen, m from an apex.
    limit: f64,
    /// Half the width of a beam, rad.
    half_width: f64,
    /// Beams for each rad.
    density: f64,
    /// The bearing of the first beam in beams.
    first: f64,
}

/// A beam as the robot sees it: x is ahead, y is left.
#[derive(Debug, Clone, Copy)]
struct Beam {
    /// Unit vector of its bearing.
    way: Vector2<f64>,
    /// m from the middle of the robot to its apex.
    offset: f64,
    /// Its apex.
    apex: Vector2<f64>,
    /// The normals of its sides, inward.
    sides: [Vector2<f64>; 2],
    /// The distance at which it sees something, or its limit, m from its apex.
    nearest: f64,
}

impl Ring {
    /// A ring of `of` beams, `width` rad wide, that see as far as `limit` m, on a robot with that outline.
    pub(super) fn new(of: u32, width: f64, limit: f64, robot: &Rectangle) -> Self {
        let spacing = TAU / f64::from(of.max(1));
        let first = if of > 1 { 0.5 } else { 0.0 };
        let half_width = width / 2.0;
        let limit = limit + INSET;
        let beam = |beam: u32| {
            let bearing = (f64::from(beam) + first) * spacing;
            let way = unit(bearing);
            let offset = (robot.half.x / way.x.abs()).min(robot.half.y / way.y.abs()) - INSET;
            let left = unit(bearing + half_width - FRAC_PI_2);
            // The sides of a line are exact opposites, so that it cannot miss between them.
            let right = if width == 0.0 { -left } else { unit(bearing - half_width + FRAC_PI_2) };
            Beam { way, offset, apex: way * offset, sides: [left, right], nearest: limit }
        };
        Self { beams: (0..of.max(1)).map(beam).collect(), limit, half_width, density: 1.0 / spacing, first }
    }

    /// The distance from the hull that a beam saw last, m, up to the limit.
    pub(super) fn distance(&self, beam: u32) -> f64 {
        self.beams[beam as usize].nearest - INSET
    }

    /// Where something is that a beam sees so far from the hull, m: x is ahead, y is left.
    pub(super) fn place(&self, beam: u32, distance: f64) -> Vector2<f64> {
        let Beam { way, offset, .. } = self.beams[beam as usize];
        way * (offset + INSET + distance)
    }

    /// Looks around. Linear in what can be seen, and logarithmic in what there is.
    pub(super) fn look(&mut self, world: &World) {
        self.beams.iter_mut().for_each(|beam| beam.nearest = self.limit);
        let view = world.robot().pose;
        for one in world.boxes() {
            self.look_at_box(one, &view);
        }
        let mut waiting = Vec::with_capacity(64);
        waiting.push((0.0, world.walls().root()));
        while let Some((distance, node)) = waiting.pop() {
            // Things that were nearer may have hidden it since it was seen.
            if distance > 0.0 && !self.may_show(&node.envelope(), &view, distance) {
                continue;
            }
            let known = waiting.len();
            for child in node.children() {
                match child {
                    RTreeNode::Leaf(segment) => {
                        let ends = segment.ends.map(|end| seen_from(&view, end));
                        self.look_at(ends);
                    }
                    RTreeNode::Parent(child) => {
                        waiting.push((distance_to(&child.envelope(), &view), child));
                    }
                }
            }
            waiting[known..].sort_unstable_by(|one: &(f64, &Node), other| other.0.total_cmp(&one.0));
        }
    }

    /// Sees the sides of a box.
    fn look_at_box(&mut self, one: &Rectangle, view: &Isometry2<f64>) {
        let [ahead, left] = [one.ahead() * one.half.x, one.left() * one.half.y];
        let corners = [ahead + left, left - ahead, -ahead - left, ahead - left];
        let corners = corners.map(|corner| seen_from(view, one.middle() + corner));
        for corner in 0..4 {
            self.look_at([corners[corner], corners[(corner + 1) % 4]]);
        }
    }

    /// Whether a beam can see something in a bounding box at `distance` m from the middle of the robot.
    fn may_show(&self, around: &AABB<[f64; 2]>, view: &Isometry2<f64>, distance: f64) -> bool {
        let silhouette = silhouette(around, view).map(|corner| view.rotation.inverse_transform_vector(&corner));
        let (first, count) = self.beams_towards(silhouette);
        self.around(first, count).any(|beam| distance < self.beams[beam].nearest + self.beams[beam].offset)
    }

    /// Sees a straight line between two ends.
    fn look_at(&mut self, ends: [Vector2<f64>; 2]) {
        let (first, count) = self.beams_towards(ends);
        for beam in self.around(first, count) {
            self.look_along(beam, ends);
        }
    }

    /// Sees the part of a straight line that lies within a beam.
    fn look_along(&mut self, beam: usize, ends: [Vector2<f64>; 2]) {
        let Beam { way, apex, sides, nearest, .. } = &mut self.beams[beam];
        let along = ends[1] - ends[0];
        let length = along.norm_squared();
        let ends = ends.map(|end| end - *apex);
        let across = ends[0].perp(&along);
        if across * across >= *nearest * *nearest * length {
            return;
        }
        let Some((from, to)) = clip(&ends, sides) else { return };
        let place = ends[0] + along * (-ends[0].dot(&along) / length).clamp(from, to);
        let distance = place.norm();
        // The sides of a line bound what is behind it too.
        if distance < *nearest && place.dot(way) >= 0.0 {
            *nearest = distance;
        }
    }

    /// The beams that anything between two bearings can be in, as the first and how many. It spans less than half a turn.
    fn beams_towards(&self, ends: [Vector2<f64>; 2]) -> (usize, usize) {
        let [one, other] = ends.map(rough_bearing);
        let span = other - one;
        let span = if span > PI {
            span - TAU
        } else if span < -PI {
            span + TAU
        } else {
            span
        };
        // Near half a turn it may be either side.
        if span.abs() > PI - 4.0 * ROUGHNESS {
            return (0, self.beams.len());
        }
        let margin = self.half_width + ROUGHNESS;
        let (right, left) = if span < 0.0 { (one + span, one) } else { (one, one + span) };
        let low = (right - margin) * self.density - self.first;
        let high = (left + margin) * self.density - self.first;
        // Shifted by full turns, so that cutting off is rounding down.
        let of = self.beams.len();
        let turns = (2 * of) as f64;
        let (below, last) = ((low + turns) as u32 as usize, (high + turns) as u32 as usize);
        let mut first = below + 1;
        while first >= of {
            first -= of;
        }
        (first, (last - below).min(of))
    }

    /// The numbers of so many beams from the first.
    fn around(&self, first: usize, count: usize) -> impl Iterator<Item = usize> + use<> {
        let of = self.beams.len();
        (first..first + count).map(move |beam| if beam < of { beam } else { beam - of })
    }
}

fn unit(bearing: f64) -> Vector2<f64> {
    Vector2::new(bearing.cos(), bearing.sin())
}

fn seen_from(view: &Isometry2<f64>, place: Vector2<f64>) -> Vector2<f64> {
    view.rotation.inverse_transform_vector(&(place - view.translation.vector))
}

/// A bearing from -π to π within the roughness (Rajan et al. 2006, eq. 9).
fn rough_bearing(way: Vector2<f64>) -> f64 {
    let (along, across) = (way.x.abs(), way.y.abs());
    let (less, more) = if along < across { (along, across) } else { (across, along) };
    if more == 0.0 {
        return 0.0;
    }
    let slope = less / more;
    let eighth = slope * (FRAC_PI_4 + 0.273 * (1.0 - slope));
    let quarter = if along < across { FRAC_PI_2 - eighth } else { eighth };
    let half = if way.x < 0.0 { PI - quarter } else { quarter };
    half.copysign(way.y)
}

/// The part of a line that lies within both sides, from 0 at its first end to 1 at its second.
fn clip(ends: &[Vector2<f64>; 2], sides: &[Vector2<f64>; 2]) -> Option<(f64, f64)> {
    let (mut from, mut to) = (0.0, 1.0);
    for side in sides {
        let inward = ends.map(|end| side.dot(&end));
        let [starts_outside, ends_outside] = inward.map(|inward| inward < 0.0);
        if starts_outside && ends_outside {
            return None;
        }
        if starts_outside || ends_outside {
            let crossing = inward[0] / (inward[0] - inward[1]);
            if starts_outside && crossing > from {
                from = crossing;
            } else if ends_outside && crossing < to {
                to = crossing;
            }
        }
    }
    (from <= to).then_some((from, to))
}

/// m from the middle of the robot to a bounding box; 0 within it.
fn distance_to(around: &AABB<[f64; 2]>, view: &Isometry2<f64>) -> f64 {
    let middle = view.translation.vector;
    let outside = |axis: usize| (around.lower()[axis] - middle[axis]).max(middle[axis] - around.upper()[axis]).max(0.0);
    Vector2::new(outside(0), outside(1)).norm()
}

/// The outermost corners of a bounding box around which the robot is not, clockwise first, from its middle.
fn silhouette(around: &AABB<[f64; 2]>, view: &Isometry2<f64>) -> [Vector2<f64>; 2] {
    let middle = view.translation.vector;
    let low = Vector2::from(around.lower()) - middle;
    let high = Vector2::from(around.upper()) - middle;
    let pick = |from: f64, to: f64, positive: f64, negative: f64, between: f64| {
        if from > 0.0 {
            positive
        } else if to < 0.0 {
            negative
        } else {
            between
        }
    };
    let near = |from: f64, to: f64| if from > 0.0 { from } else { to };
    let near = Vector2::new(near(low.x, high.x), near(low.y, high.y));
    let clockwise =
        Vector2::new(pick(low.y, high.y, high.x, low.x, near.x), pick(low.x, high.x, low.y, high.y, near.y));
    let counterclockwise =
        Vector2::new(pick(low.y, high.y, low.x, high.x, near.x), pick(low.x, high.x, high.y, low.y, near.y));
    [clockwise, counterclockwise]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sim::random::{Purpose, Stream};
    use crate::sim::walls::Walls;

    fn robot(x: f64, y: f64, heading: f64) -> Rectangle {
        Rectangle::new(Vector2::new(x, y), heading, 0.81, 0.75)
    }

    fn wall(from: [f64; 2], to: [f64; 2]) -> [Vector2<f64>; 2] {
        [from.into(), to.into()]
    }

    /// What a ring of beams reads.
    fn distances(world: &World, of: u32, width: f64, limit: f64) -> Vec<f64> {
        let mut ring = Ring::new(of, width, limit, &world.robot());
        ring.look(world);
        (0..of).map(|beam| ring.distance(beam)).collect()
    }

    /// The nearest place of all lines within a cone from `apex`, by trying places a share of `step` apart.
    fn sampled(lines: &[[Vector2<f64>; 2]], apex: Vector2<f64>, bearing: f64, width: f64, step: f64) -> f64 {
        let way = unit(bearing);
        let mut nearest = f64::INFINITY;
        for [from, to] in lines {
            for place in 0..=(1.0 / step) as u32 {
                let place = from + (to - from) * (f64::from(place) * step) - apex;
                if way.angle(&place) <= width / 2.0 {
                    nearest = nearest.min(place.norm());
                }
            }
        }
        nearest
    }

    #[test]
    fn a_single_line_looks_ahead_from_the_front() {
        let walls = Walls::new([wall([3.0, -1.0], [3.0, 1.0]), wall([-1.0, -1.0], [-1.0, 1.0])]);
        let world = World::new(robot(1.0, 0.5, 0.0), 0.0, walls);
        let seen = distances(&world, 1, 0.0, 10.0);
        // Differences of numbers below 4 round to 1e-15.
        assert!((seen[0] - (2.0 - 0.405)).abs() < 1e-12, "{seen:?}");
        assert_eq!(distances(&world, 1, 0.0, 1.0), [1.0]);
    }

    #[test]
    fn beams_stand_evenly_from_just_left_of_the_heading_and_begin_at_the_hull() {
        let quarter = FRAC_PI_2;
        let walls = Walls::new([wall([-5.0, 4.0], [5.0, 4.0]), wall([3.0, -2.0], [3.0, 5.0])]);
        let world = World::new(robot(0.0, 0.0, quarter), quarter, walls);
        let seen = distances(&world, 4, 0.0, 10.0);
        // Bearings of 45, 135, 225 and 315 degrees leave the hull at its half width, 0.375 m ahead and aside; the robot
        // looks up, so the wall above is ahead and the wall at x = 3 to the right.
        let diagonal = 2.0_f64.sqrt();
        let expected = [(4.0 - 0.375) * diagonal, 10.0, 10.0, (3.0 - 0.375) * diagonal];
        for (seen, expected) in seen.iter().zip(expected) {
            assert!((seen - expected).abs() < 1e-12, "{seen} {expected}");
        }
    }

    #[test]
    fn a_wide_beam_sees_what_stands_at_its_edge_and_not_beyond() {
        let post = |bearing: f64| {
            let foot = Vector2::new(0.405, 0.0) + unit(bearing.to_radians()) * 2.0;
            [foot, foot + unit(bearing.to_radians())]
        };
        for (bearing, seen) in [(7.4, 2.0), (-7.4, 2.0), (7.6, 10.0), (-7.6, 10.0), (180.0, 10.0)] {
            let world = World::new(robot(0.0, 0.0, 0.0), 0.0, Walls::new([post(bearing)]));
            let distance = distances(&world, 1, 15_f64.to_radians(), 10.0)[0];
            // The apex lies 1e-5 m inside the hull.
            assert!((distance - seen).abs() < 1e-5, "{bearing}: {distance}");
        }
    }

    #[test]
    fn what_touches_the_hull_is_seen_at_no_distance() {
        let world = World::new(robot(0.0, 0.0, 0.0), 0.0, Walls::new([wall([0.405 - 1e-6, -3.0], [0.405, 3.0])]));
        for width in [0.0, 0.2, 2.0] {
            assert!(distances(&world, 1, width, 10.0)[0].abs() < 2e-6);
        }
    }

    #[test]
    fn the_index_changes_nothing() {
        for (seed, count) in [3, 24, 25, 300].into_iter().cycle().take(8).enumerate() {
            let mut stream = Stream::new(seed as u64, Purpose::Tracking);
            let mut lines = Vec::new();
            while lines.len() < count {
                let place = Vector2::new(stream.between(-12.0, 12.0), stream.between(-12.0, 12.0));
                let length = if stream.between(0.0, 1.0) < 0.1 { 20.0 } else { 1.0 };
                let ends = [place, place + unit(stream.between(0.0, TAU)) * stream.between(0.0, length)];
                // Off the robot, wherever it turns.
                if distance_from_middle(&ends) > 0.56 {
                    lines.push(ends);
                }
            }
            let heading = stream.between(-PI, PI);
            let world = World::new(robot(0.0, 0.0, heading), heading, Walls::new(lines.iter().copied()));
            let plain = |of, width| {
                let mut ring = Ring::new(of, width, 10.0, &world.robot());
                for ends in &lines {
                    for beam in 0..of as usize {
                        ring.look_along(beam, ends.map(|end| seen_from(&world.robot().pose, end)));
                    }
                }
                (0..of).map(|beam| ring.distance(beam)).collect::<Vec<f64>>()
            };
            for (of, width) in [(1, 0.0), (1, 2.5), (24, 0.0), (24, 0.26), (8, 0.5), (3, 3.0)] {
                assert_eq!(distances(&world, of, width, 10.0), plain(of, width), "{seed}: {of} beams of {width}");
            }
        }
    }

    fn distance_from_middle([from, to]: &[Vector2<f64>; 2]) -> f64 {
        let along = to - from;
        let share = (-from.dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
        (from + along * share).norm()
    }

    #[test]
    fn a_beam_sees_the_nearest_place_of_all_that_is_in_it() {
        for seed in 0..4 {
            let mut stream = Stream::new(seed, Purpose::Tracking);
            let mut boxes = Vec::new();
            for _ in 0..6 {
                let bearing = stream.between(-PI, PI);
                let middle = unit(bearing) * stream.between(1.5, 6.0);
                boxes.push(Rectangle::new(middle, stream.between(0.0, TAU), 0.4, 0.6));
            }
            let mut world = World::new(robot(0.0, 0.0, 0.0), 0.0, Walls::new([]));
            let mut lines = Vec::new();
            for shape in boxes {
                world.add_box(shape, 1.0);
                let [ahead, left] = [shape.ahead() * shape.half.x, shape.left() * shape.half.y];
                let corners = [ahead + left, left - ahead, -ahead - left, ahead - left];
                lines.extend(
                    (0..4).map(|at| [corners[at], corners[(at + 1) % 4]].map(|corner| shape.middle() + corner)),
                );
            }
            for width in [0.2, 2.0] {
                let seen = distances(&world, 24, width, 10.0);
                for (beam, seen) in (0..24).zip(seen) {
                    let bearing = (f64::from(beam) + 0.5) * TAU / 24.0;
                    let way = unit(bearing);
                    let hull = way * (0.405 / way.x.abs()).min(0.375 / way.y.abs());
                    let nearest = sampled(&lines, hull, bearing, width, 5e-3).min(10.0);
                    // Places are 3 mm apart at most, and up to 3 mm of a line may lie within an edge of the beam, which
                    // is at least 1 m away; the apex lies 1e-5 m inside the hull.
                    let beside = sampled(&lines, hull, bearing, width + 6e-3, 5e-3);
                    assert!(seen < nearest + 2e-5 && seen > nearest.min(beside) - 3e-3, "{seed}: {seen} {nearest}");
                }
            }
        }
    }
}
