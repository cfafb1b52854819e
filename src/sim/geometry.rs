//! Rectangles in the plane, and how deep two of them overlap.

use nalgebra::{Isometry2, Vector2};

/// A rectangle around its pose. Without thickness it is a line: a wall.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rectangle {
    /// Where its middle is, and where it heads.
    pub(super) pose: Isometry2<f64>,
    /// Half its length along its heading and half its width across, m.
    pub(super) half: Vector2<f64>,
}

/// Two rectangles that overlap or nearly touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact {
    /// Unit vector along which the second leaves the first by the shortest way.
    pub(super) normal: Vector2<f64>,
    /// How far they overlap along it, m; below 0 for a gap.
    pub(super) depth: f64,
}

impl Rectangle {
    /// A rectangle of `length` along its `heading` and `width` across, m and rad.
    pub(super) fn new(middle: Vector2<f64>, heading: f64, length: f64, width: f64) -> Self {
        Self { pose: Isometry2::new(middle, heading), half: Vector2::new(length, width) / 2.0 }
    }

    /// The line between two points, m.
    pub(super) fn line(from: Vector2<f64>, to: Vector2<f64>) -> Self {
        let along = to - from;
        Self::new((from + to) / 2.0, along.y.atan2(along.x), along.norm(), 0.0)
    }

    /// Its middle, m.
    pub(super) fn middle(&self) -> Vector2<f64> {
        self.pose.translation.vector
    }

    /// Unit vector of its heading.
    pub(super) fn ahead(&self) -> Vector2<f64> {
        Vector2::new(self.pose.rotation.re, self.pose.rotation.im)
    }

    /// Unit vector to the left of its heading.
    pub(super) fn left(&self) -> Vector2<f64> {
        Vector2::new(-self.pose.rotation.im, self.pose.rotation.re)
    }

    /// The radius of the circle around it, m.
    pub(super) fn radius(&self) -> f64 {
        self.half.norm()
    }

    /// Moves it without turning it.
    pub(super) fn shift(&mut self, by: Vector2<f64>) {
        self.pose.translation.vector += by;
    }

    /// Half its extent along a unit vector, m.
    fn reach(&self, along: Vector2<f64>) -> f64 {
        self.half.x * self.ahead().dot(&along).abs() + self.half.y * self.left().dot(&along).abs()
    }
}

/// How `second` overlaps `first`, by the theorem of separating axes: two convex outlines are apart exactly where they
/// are apart along the normal of one of their edges. `None` where the gap is `margin` (m) or more.
pub(super) fn contact(first: &Rectangle, second: &Rectangle, margin: f64) -> Option<Contact> {
    let between = second.middle() - first.middle();
    let circles = first.radius() + second.radius() + margin;
    if between.norm_squared() >= circles * circles {
        return None;
    }
    let mut least = Contact { normal: Vector2::zeros(), depth: f64::INFINITY };
    // Across the second one first: for a long wall, that is the axis which tells them apart.
    for axis in [second.left(), second.ahead(), first.ahead(), first.left()] {
        let distance = between.dot(&axis);
        let depth = first.reach(axis) + second.reach(axis) - distance.abs();
        if depth <= -margin {
            return None;
        }
        if depth < least.depth {
            least = Contact { normal: if distance < 0.0 { -axis } else { axis }, depth };
        }
    }
    Some(least)
}

/// A lower bound of the distance between two rectangles, m: how far the axes along their edges hold them apart; below 0
/// where they overlap.
pub(super) fn gap(first: &Rectangle, second: &Rectangle) -> f64 {
    let between = second.middle() - first.middle();
    let apart = |axis| between.dot(&axis).abs() - first.reach(axis) - second.reach(axis);
    [second.left(), second.ahead(), first.ahead(), first.left()].map(apart).into_iter().fold(f64::MIN, f64::max)
}

/// How far `second` must move along the unit vector `way` to leave `first`, m; 0 where they do not overlap.
pub(super) fn way_out(first: &Rectangle, second: &Rectangle, way: Vector2<f64>) -> f64 {
    let between = second.middle() - first.middle();
    let mut least = f64::INFINITY;
    for axis in [second.left(), second.ahead(), first.ahead(), first.left()] {
        let slope = way.dot(&axis);
        // Along a way at right angles to the axis nothing is ever left.
        if slope.abs() > 1e-9 {
            let depth = first.reach(axis) + second.reach(axis) - between.dot(&axis) * slope.signum();
            least = least.min(depth / slope.abs());
        }
    }
    if least.is_finite() { least.max(0.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_4;

    use super::*;

    fn square(x: f64, y: f64, heading: f64) -> Rectangle {
        Rectangle::new(Vector2::new(x, y), heading, 2.0, 2.0)
    }

    #[test]
    fn the_shortest_way_out_is_across_the_nearest_edge() {
        let found = contact(&square(0.0, 0.0, 0.0), &square(1.9, 0.3, 0.0), 0.0).unwrap();
        assert_eq!(found.normal, Vector2::new(1.0, 0.0));
        // One subtraction of numbers near 2 rounds by less than 1e-15.
        assert!((found.depth - 0.1).abs() < 1e-15);
        let found = contact(&square(0.0, 0.0, 0.0), &square(-0.3, -1.9, 0.0), 0.0).unwrap();
        assert_eq!(found.normal, Vector2::new(0.0, -1.0));
    }

    #[test]
    fn a_gap_within_the_margin_is_a_contact_of_negative_depth() {
        let (first, second) = (square(0.0, 0.0, 0.0), square(2.5, 0.0, 0.0));
        assert_eq!(contact(&first, &second, 0.0), None);
        assert_eq!(contact(&first, &second, 0.5), None);
        assert_eq!(contact(&first, &second, 0.6).map(|found| found.depth), Some(-0.5));
    }

    #[test]
    fn corners_near_each_other_do_not_touch() {
        // The corner of the turned square reaches sqrt(2) from its middle: 1 + 1.414 > 2.4, but only on its own axis.
        let turned = square(2.4, 0.0, FRAC_PI_4);
        assert!(contact(&square(0.0, 0.0, 0.0), &turned, 0.0).is_some());
        assert!(contact(&square(0.0, 1.5, 0.0), &square(2.0, -0.3, FRAC_PI_4), 0.0).is_none());
    }

    #[test]
    fn the_way_out_along_a_direction_ends_in_touch() {
        let first = square(0.0, 0.0, 0.3);
        for step in 0..32 {
            let mut second = square(0.8, -0.4, f64::from(step) * 0.2);
            let angle = f64::from(step) * 0.7;
            let way = Vector2::new(angle.cos(), angle.sin());
            second.shift(way * way_out(&first, &second, way));
            // Distances of about 3 m round to 1e-15; a slope of at least 1e-9 could magnify that, these do not.
            let depth = contact(&first, &second, 1e-6).unwrap().depth;
            assert!(depth.abs() < 1e-12, "{step}: {depth}");
        }
    }

    #[test]
    fn a_line_has_no_thickness() {
        let wall = Rectangle::line(Vector2::new(1.5, -5.0), Vector2::new(1.5, 5.0));
        let found = contact(&square(0.6, 0.0, 0.0), &wall, 0.0).unwrap();
        assert!((found.depth - 0.1).abs() < 1e-12 && (found.normal.x - 1.0).abs() < 1e-12);
        assert!(contact(&square(0.4, 0.0, 0.0), &wall, 0.0).is_none());
    }
}
