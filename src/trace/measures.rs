//! How good a way a run was: what navigation is compared by (Khatoon and Ibraheem 2012, section 5).

use super::{Signal, Trace, seconds};

/// What a run's way is measured by, up to where it reached the goal, or else to its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measures {
    /// Whether the robot's middle came within its own length of the goal; `None` without a goal.
    pub reached: Option<bool>,
    /// How far it drove, m.
    pub path_length: f64,
    /// How near its outline came to any wall or box, m, at least 0; `None` where there is none.
    pub clearance: Option<f64>,
    /// The integral of its squared turn rate, rad²/s: the less, the smoother.
    pub smoothness: f64,
    /// How long it took, s.
    pub time: f64,
}

type Point = [f64; 2];
type Segment = [Point; 2];

impl Trace {
    /// Measures the way of the robot. Linear in ticks times walls and boxes.
    pub fn measures(&self) -> Measures {
        let poses = self.poses(0);
        let length = self.bodies.first().map_or(0.0, |robot| robot.length);
        let arrival = self.goal.map(|goal| poses.iter().position(|&[x, y, _]| distance([x, y], goal) <= length));
        let way = arrival.flatten().map_or(poses.as_slice(), |last| poses.get(..=last).unwrap_or_default());
        let driven = |pair: &[[f64; 3]]| match pair {
            [[x, y, _], [to_x, to_y, _]] => distance([*x, *y], [*to_x, *to_y]),
            _ => 0.0,
        };
        let turned = |(pair, times): (&[[f64; 3]], &[u64])| match (pair, times) {
            ([[_, _, from], [_, _, to]], [start, end]) if end > start => (to - from).powi(2) / seconds(end - start),
            _ => 0.0,
        };
        Measures {
            reached: arrival.map(|arrival| arrival.is_some()),
            path_length: total(way.windows(2).map(driven)),
            clearance: self.clearance(way),
            smoothness: total(way.windows(2).zip(self.times.windows(2)).map(turned)),
            time: way.len().checked_sub(1).and_then(|last| self.times.get(last)).map_or(0.0, |&time| seconds(time)),
        }
    }

    /// The pose of a body on every tick: x and y in m, heading in rad.
    fn poses(&self, body: u32) -> Vec<[f64; 3]> {
        let values = |signal| self.column(signal).map_or(&[][..], |column| column.values.as_slice());
        let (x, y) = (values(Signal::X(body)), values(Signal::Y(body)));
        x.iter().zip(y).zip(values(Signal::Heading(body))).map(|((&x, &y), &heading)| [x, y, heading]).collect()
    }

    /// The least distance between the robot and anything else on a way, m.
    fn clearance(&self, way: &[[f64; 3]]) -> Option<f64> {
        let [robot, boxes @ ..] = self.bodies.as_slice() else { return None };
        let sides = |pose, length: f64, width: f64| outline(pose, [length / 2.0, width / 2.0]);
        let radius = robot.length.hypot(robot.width) / 2.0;
        let ends =
            |corners: &Vec<Point>| corners.windows(2).filter_map(|ends| ends.try_into().ok()).collect::<Vec<Segment>>();
        let walls: Vec<Segment> = self.walls.iter().flat_map(ends).collect();
        let tracks: Vec<_> = boxes.iter().zip(1..).map(|(one, body)| (one, self.poses(body))).collect();
        let mut least = None;
        for (tick, &pose) in way.iter().enumerate() {
            let hull = sides(pose, robot.length, robot.width);
            let of_boxes =
                tracks.iter().filter_map(|(one, poses)| Some(sides(*poses.get(tick)?, one.length, one.width)));
            for side in walls.iter().copied().chain(of_boxes.flatten()) {
                let nearest = least.unwrap_or(f64::INFINITY);
                if to_segment([pose[0], pose[1]], side) - radius < nearest {
                    least = Some(hull.iter().map(|own| between(*own, side)).fold(nearest, f64::min));
                }
            }
        }
        least
    }
}

/// The sides of a rectangle of those half lengths around a pose.
fn outline([x, y, heading]: [f64; 3], [ahead, left]: [f64; 2]) -> [Segment; 4] {
    let (sin, cos) = heading.sin_cos();
    let corner = |along: f64, across: f64| [x + along * cos - across * sin, y + along * sin + across * cos];
    let corners = [corner(ahead, left), corner(-ahead, left), corner(-ahead, -left), corner(ahead, -left)];
    [[corners[0], corners[1]], [corners[1], corners[2]], [corners[2], corners[3]], [corners[3], corners[0]]]
}

/// A sum that is 0, and not -0, of nothing.
fn total(of: impl Iterator<Item = f64>) -> f64 {
    of.fold(0.0, |sum, part| sum + part)
}

fn distance(from: Point, to: Point) -> f64 {
    (to[0] - from[0]).hypot(to[1] - from[1])
}

/// On which side of a line a point is: above 0 to its left.
fn side([from, to]: Segment, point: Point) -> f64 {
    (to[0] - from[0]) * (point[1] - from[1]) - (to[1] - from[1]) * (point[0] - from[0])
}

fn to_segment(point: Point, [from, to]: Segment) -> f64 {
    let along = [to[0] - from[0], to[1] - from[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    let share = ((point[0] - from[0]) * along[0] + (point[1] - from[1]) * along[1]) / square;
    // A segment without length has no share.
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    distance(point, [from[0] + along[0] * share, from[1] + along[1] * share])
}

fn between(one: Segment, other: Segment) -> f64 {
    let crosses = |line, [from, to]: Segment| side(line, from) * side(line, to) < 0.0;
    let least =
        [to_segment(one[0], other), to_segment(one[1], other), to_segment(other[0], one), to_segment(other[1], one)]
            .into_iter()
            .fold(f64::INFINITY, f64::min);
    if crosses(one, other) && crosses(other, one) { 0.0 } else { least }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use super::*;
    use crate::trace::{Column, Footprint};

    /// A robot of 2 m by 1 m on its way, a tick a second.
    fn trace(poses: &[[f64; 3]]) -> Trace {
        let column = |place: usize, signal| Column {
            name: String::new(),
            unit: String::new(),
            signal,
            values: poses.iter().map(|pose| pose[place]).collect(),
        };
        Trace {
            times: (0..poses.len() as u64).map(|tick| tick * 1_000_000_000).collect(),
            columns: vec![column(0, Signal::X(0)), column(1, Signal::Y(0)), column(2, Signal::Heading(0))],
            bodies: vec![Footprint { name: "robot".to_owned(), mass: 1.0, length: 2.0, width: 1.0 }],
            ..Trace::default()
        }
    }

    #[test]
    fn a_way_is_measured_to_where_it_reached_the_goal() {
        let poses = [[0.0, 0.0, 0.0], [3.0, 4.0, 0.5], [3.0, 6.0, 1.5], [3.0, 9.0, 1.5]];
        let to_the_end = trace(&poses).measures();
        assert_eq!((to_the_end.reached, to_the_end.path_length, to_the_end.time), (None, 10.0, 3.0));
        assert_eq!((to_the_end.smoothness, to_the_end.clearance), (1.25, None));
        // On the second tick it is 2 m away, as long as it is.
        let reached = Trace { goal: Some([3.0, 8.0]), ..trace(&poses) }.measures();
        assert_eq!((reached.reached, reached.path_length, reached.time), (Some(true), 7.0, 2.0));
        let missed = Trace { goal: Some([90.0, 8.0]), ..trace(&poses) }.measures();
        assert_eq!(missed, Measures { reached: Some(false), ..to_the_end });
    }

    #[test]
    fn clearance_is_from_outline_to_outline() {
        let with = |walls: &[Segment], pose| {
            Trace { walls: walls.iter().map(|ends| ends.to_vec()).collect(), ..trace(&[pose]) }.measures().clearance
        };
        let wall = [[3.0, -9.0], [3.0, 9.0]];
        assert_eq!(with(&[wall], [0.0, 0.0, 0.0]), Some(2.0));
        let turned = with(&[wall], [0.0, 0.0, FRAC_PI_2]).unwrap();
        assert!((turned - 2.5).abs() < 1e-12, "{turned}");
        // The corner at (1, 0.5), and the nearer of two.
        assert_eq!(with(&[wall, [[2.0, 1.5], [5.0, 9.0]]], [0.0, 0.0, 0.0]), Some(2.0_f64.sqrt()));
        assert_eq!(with(&[[[-9.0, 0.1], [9.0, 0.1]]], [0.0, 0.0, 0.0]), Some(0.0));
        // In line with a side, and a point.
        assert_eq!(with(&[[[1.5, 0.5], [9.0, 0.5]]], [0.0, 0.0, 0.0]), Some(0.5));
        assert_eq!(with(&[[[2.5, 0.0], [2.5, 0.0]]], [0.0, 0.0, 0.0]), Some(1.5));
    }

    #[test]
    fn nothing_recorded_is_nothing_measured() {
        let nothing = Measures { reached: None, path_length: 0.0, clearance: None, smoothness: 0.0, time: 0.0 };
        assert_eq!(Trace::default().measures(), nothing);
    }
}
