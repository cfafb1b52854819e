//! What stands in a world, and what happens where the robot meets it.
//!
//! The contact model is quasi-static: boxes have no momentum and move only while they are pushed. The floor's friction
//! keeps the heading of a box, so boxes are shifted and never turned. While the middle of a box is in front of the
//! robot, the box moves along the normal of the robot's front face only: there is no friction along the wedge, so on an
//! arc a box slides sideways along it. Past the edge of the wedge, and at the robot's other sides, a box is pushed out
//! by the shortest way, which lets it slide off the corner. A box that is pushed pushes what it touches. What meets a
//! wall slides along it, or stays where it is; a step that would leave two things in one place is not made at all.
//!
//! Nothing but the robot moves of itself. So what stands around it is looked at once, and until it has come as far as
//! the nearest of it, it meets nothing: such steps cost next to nothing, and are the same.

use nalgebra::{Isometry2, Vector2};

use super::geometry::{Contact, Rectangle, contact, gap, way_out};
use super::walls::Walls;

/// Overlaps up to this are none, m: far above the rounding of positions in a world of kilometres.
pub(super) const SLOP: f64 = 1e-6;
/// Gaps below this are a touch, m: far below what a robot drives between two steps.
const TOUCH: f64 = 1e-5;
/// What has touched is only let go behind a gap of this, m, so that noise does not make one impact many.
const LET_GO: f64 = 1e-3;
/// What touches within 60 degrees of the way the robot drives is in its way: the cosine of that angle.
const IN_THE_WAY: f64 = 0.5;
/// How far around the robot walls are looked for at a time, m.
const VICINITY: f64 = 0.25;

/// A box on the floor.
#[derive(Debug, Clone)]
struct Crate {
    shape: Rectangle,
    /// kg
    mass: f64,
    /// Whether it is part of the robot's load.
    held: bool,
}

/// An end of the robot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    Front,
    Back,
}

/// The robot, the boxes and the walls.
#[derive(Debug, Clone)]
pub(super) struct World {
    /// Its heading may lag behind while the robot is free.
    robot: Rectangle,
    /// The robot's heading in rad, counted on over full turns.
    heading: f64,
    /// The radius of the circle around the robot, m.
    radius: f64,
    boxes: Vec<Crate>,
    walls: Walls,
    /// The positions of the walls around the robot, as long as it moves by no more than `vicinity`.
    nearby: Vec<usize>,
    /// How far the robot may move before it can reach a wall that is not nearby, m.
    vicinity: f64,
    /// How far the robot may move before it can touch anything, m; 0 or below while it may be touching something.
    free: f64,
    /// The longest step in which nothing can be passed, m.
    longest_step: f64,
    /// The way the robot was driving when its load was last asked for: 1, -1 or 0.
    direction: f64,
    /// Whether a wall was part of the load.
    against_wall: bool,
    /// Boxes that moved in this step and have not been looked at since.
    moved: Vec<usize>,
    /// Where boxes were before this step moved them.
    undo: Vec<(usize, Vector2<f64>)>,
    /// Boxes the load has reached, for the search.
    reached: Vec<usize>,
    /// Walls around a box, for the search.
    around: Vec<usize>,
}

/// What stands in the robot's way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Load {
    /// kg of boxes; infinite against a wall.
    pub(super) mass: f64,
    /// The part of it that was met in this step.
    pub(super) added: f64,
}

impl Load {
    /// Nothing.
    pub(super) const NONE: Self = Self { mass: 0.0, added: 0.0 };
}

/// What became of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Moved {
    /// How far the robot drove along its heading, m.
    pub(super) drove: f64,
    /// The angle the robot turned, rad.
    pub(super) turned: f64,
    /// Whether something kept it from driving on.
    pub(super) drive_blocked: bool,
    /// Whether something kept it from turning on.
    pub(super) turn_blocked: bool,
}

/// What the robot slides out of instead of pushing it away.
#[derive(Debug, Clone, Copy)]
enum Yields {
    ToWalls,
    ToAll,
}

impl World {
    /// A world with a robot and walls; `heading` in rad.
    pub(super) fn new(robot: Rectangle, heading: f64, walls: Walls) -> Self {
        let mut world = Self {
            robot,
            heading,
            radius: robot.radius(),
            boxes: Vec::new(),
            walls,
            nearby: Vec::new(),
            vicinity: 0.0,
            free: 0.0,
            longest_step: robot.half.min() / 2.0,
            direction: 0.0,
            against_wall: false,
            moved: Vec::new(),
            undo: Vec::new(),
            reached: Vec::new(),
            around: Vec::new(),
        };
        world.look_around(VICINITY);
        world
    }

    /// Adds a box of `mass` kg.
    pub(super) fn add_box(&mut self, shape: Rectangle, mass: f64) {
        self.longest_step = self.longest_step.min(shape.half.min() / 2.0);
        self.free = 0.0;
        self.boxes.push(Crate { shape, mass, held: false });
        // Enough for every box once, so that steps rarely allocate.
        self.moved.reserve(self.boxes.len());
        self.undo.reserve(self.boxes.len());
        self.reached.reserve(self.boxes.len());
    }

    /// The robot's outline.
    pub(super) fn robot(&self) -> Rectangle {
        Rectangle { pose: Isometry2::new(self.robot.middle(), self.heading), half: self.robot.half }
    }

    /// The robot's heading in rad, counted on over full turns.
    pub(super) fn heading(&self) -> f64 {
        self.heading
    }

    /// The outlines of the boxes, in the order they were added.
    pub(super) fn boxes(&self) -> impl Iterator<Item = &Rectangle> {
        self.boxes.iter().map(|one| &one.shape)
    }

    /// The walls, in the order they were added.
    pub(super) fn walls(&self) -> &Walls {
        &self.walls
    }

    /// Whether anything touches that half of the robot.
    pub(super) fn is_touched(&self, end: End) -> bool {
        if self.free > 0.0 {
            return false;
        }
        let quarter = self.robot.half.x / 2.0;
        let mut half = self.robot;
        half.half.x = quarter;
        half.shift(self.robot.ahead() * if end == End::Front { quarter } else { -quarter });
        let walls = self.nearby.iter().map(|&wall| self.walls.line(wall));
        walls.chain(self.boxes()).any(|other| contact(&half, other, TOUCH).is_some())
    }

    /// What stands in the way of a robot that drives forward (1), backward (-1) or not at all (0): the boxes it
    /// touches, the boxes they touch, and so on. Linear in the boxes where nothing touches, else at most quadratic.
    pub(super) fn load(&mut self, direction: f64) -> Load {
        if direction != self.direction {
            self.direction = direction;
            self.against_wall = false;
            self.boxes.iter_mut().for_each(|one| one.held = false);
        }
        if direction == 0.0 || self.free > 0.0 {
            return Load::NONE;
        }
        let way = self.robot.ahead() * direction;
        let mut load = Load::NONE;
        self.reached.clear();
        let mut wall = self.nearby.iter().any(|&wall| self.is_in_the_way(wall, &self.robot, way));
        let mut next = 0;
        self.reach(None, way);
        while let Some(&index) = self.reached.get(next) {
            self.reach(Some(index), way);
            let shape = self.boxes[index].shape;
            self.walls.near(shape.middle(), shape.radius() + LET_GO, &mut self.around);
            wall |= self.around.iter().any(|&wall| self.is_in_the_way(wall, &shape, way));
            next += 1;
        }
        for (index, one) in self.boxes.iter_mut().enumerate() {
            let reached = self.reached.contains(&index);
            if reached {
                load.mass += one.mass;
                load.added += if one.held { 0.0 } else { one.mass };
            }
            one.held = reached;
        }
        if wall {
            load.mass = f64::INFINITY;
            load.added = if self.against_wall { load.added } else { f64::INFINITY };
        }
        self.against_wall = wall;
        load
    }

    /// Adds to the load the boxes that the robot (`None`) or a box of the load touches.
    fn reach(&mut self, from: Option<usize>, way: Vector2<f64>) {
        for (index, one) in self.boxes.iter().enumerate() {
            if from == Some(index) || self.reached.contains(&index) {
                continue;
            }
            let first = from.map_or(&self.robot, |from| &self.boxes[from].shape);
            let margin = if one.held { LET_GO } else { TOUCH };
            if contact(first, &one.shape, margin).is_some_and(|found| found.normal.dot(&way) > IN_THE_WAY) {
                self.reached.push(index);
            }
        }
    }

    fn is_in_the_way(&self, wall: usize, shape: &Rectangle, way: Vector2<f64>) -> bool {
        let margin = if self.against_wall { LET_GO } else { TOUCH };
        contact(shape, self.walls.line(wall), margin).is_some_and(|found| found.normal.dot(&way) > IN_THE_WAY)
    }

    /// Drives the robot `forward` (m) on an arc on which it turns left by `turn` (rad), with all that this moves.
    pub(super) fn advance(&mut self, forward: f64, turn: f64) -> Moved {
        let farthest = forward.abs() + turn.abs() * self.radius;
        if farthest < self.free {
            self.go(forward, turn);
            self.free -= farthest;
            self.vicinity -= farthest;
            return Moved { drove: forward, turned: turn, drive_blocked: false, turn_blocked: false };
        }
        let steps = (farthest / self.longest_step).ceil().clamp(1.0, 1e6);
        let (forward, turn, farthest) = (forward / steps, turn / steps, farthest / steps);
        let mut moved = Moved { drove: 0.0, turned: 0.0, drive_blocked: false, turn_blocked: false };
        for _ in 0..steps as u32 {
            self.robot = self.robot();
            // A step may also slide, by several times its length.
            self.look_around(LET_GO + 16.0 * farthest);
            let (mut drove, mut turned) = (self.attempt(forward, turn, Yields::ToWalls), true);
            if drove.is_none() {
                drove = self.attempt(forward, 0.0, Yields::ToWalls);
                // A robot that turns shoves itself off what it cannot move, so that it never sticks for good.
                turned = turn == 0.0 || self.attempt(0.0, turn, Yields::ToAll).is_some();
            }
            moved.drove += drove.unwrap_or(0.0) * forward.signum();
            moved.turned += if turned { turn } else { 0.0 };
            moved.turn_blocked |= !turned;
            // Sliding along a wall that is not in the way costs this much at most.
            let least = forward.abs() * (1.0 - IN_THE_WAY * IN_THE_WAY);
            moved.drive_blocked |= drove.is_none_or(|drove| drove < least);
            self.find_freedom();
        }
        moved
    }

    /// Finds the walls around the robot, unless it is still `enough` (m) from all others.
    fn look_around(&mut self, enough: f64) {
        if self.vicinity < enough {
            self.vicinity = enough.max(VICINITY);
            self.walls.near(self.robot.middle(), self.radius + self.vicinity, &mut self.nearby);
        }
    }

    /// Finds how far the robot may move before it can touch anything.
    fn find_freedom(&mut self) {
        let walls = self.nearby.iter().map(|&wall| self.walls.line(wall));
        let nearest = walls.chain(self.boxes()).map(|other| gap(&self.robot, other)).fold(self.vicinity, f64::min);
        self.free = nearest - LET_GO;
        if self.free > 0.0 {
            self.against_wall = false;
            self.boxes.iter_mut().for_each(|one| one.held = false);
        }
    }

    /// Moves the robot's middle and its heading, whatever is in its way. The direction it went in.
    fn go(&mut self, forward: f64, turn: f64) -> Vector2<f64> {
        let middle = self.heading + turn / 2.0;
        let way = Vector2::new(middle.cos(), middle.sin());
        self.heading += turn;
        self.robot.shift(way * forward);
        way
    }

    /// Makes a step if it leaves nothing in one place with something else. How far the robot then got in the
    /// direction of `forward`, m.
    fn attempt(&mut self, forward: f64, turn: f64, yields: Yields) -> Option<f64> {
        let (before, heading) = (self.robot, self.heading);
        let way = self.go(forward, turn);
        self.robot = self.robot();
        self.undo.clear();
        self.moved.clear();
        let slid = self.leave_obstacles(yields);
        let shift = self.robot.middle() - before.middle();
        let left = self.vicinity - shift.norm() - turn.abs() * self.radius;
        if slid && left >= 0.0 && self.push_boxes() {
            self.vicinity = left;
            return Some(shift.dot(&way) * forward.signum());
        }
        (self.robot, self.heading) = (before, heading);
        while let Some((index, place)) = self.undo.pop() {
            self.boxes[index].shape.pose.translation.vector = place;
        }
        None
    }

    /// Slides the robot out of what it has run into and yields to. Whether that was possible.
    fn leave_obstacles(&mut self, yields: Yields) -> bool {
        let boxes = match yields {
            Yields::ToWalls => &[],
            Yields::ToAll => self.boxes.as_slice(),
        };
        // A round settles one obstacle, another one its neighbor; between two that almost face each other it takes many.
        // What needs more is wedged in.
        for _ in 0..32 {
            let mut free = true;
            let walls = self.nearby.iter().map(|&wall| self.walls.line(wall));
            for obstacle in walls.chain(boxes.iter().map(|one| &one.shape)) {
                if let Some(Contact { normal, depth }) = overlap(obstacle, &self.robot) {
                    self.robot.shift(normal * depth);
                    free = false;
                }
            }
            if free {
                return true;
            }
        }
        false
    }

    /// Pushes boxes out of the robot, out of each other and out of walls. Whether that was possible.
    fn push_boxes(&mut self) -> bool {
        for index in 0..self.boxes.len() {
            self.leave_robot(index);
        }
        // Each box of a row needs a few rounds; what needs more is squeezed.
        let mut rounds = 8 * (self.boxes.len() + 1);
        while let Some(mover) = self.moved.pop() {
            rounds -= 1;
            if rounds == 0 {
                return false;
            }
            let shape = &self.boxes[mover].shape;
            // Sliding out of one wall may take it into the next.
            self.walls.near(shape.middle(), 2.0 * shape.radius(), &mut self.around);
            for wall in 0..self.around.len() {
                let line = self.walls.line(self.around[wall]);
                if let Some(Contact { normal, depth }) = overlap(line, &self.boxes[mover].shape) {
                    self.shift(mover, normal * depth);
                }
            }
            self.leave_robot(mover);
            for other in 0..self.boxes.len() {
                if other == mover {
                    continue;
                }
                let found = overlap(&self.boxes[mover].shape, &self.boxes[other].shape);
                if let Some(Contact { normal, depth }) = found {
                    self.shift(other, normal * depth);
                }
            }
        }
        true
    }

    /// Pushes a box out of the robot.
    fn leave_robot(&mut self, index: usize) {
        let (robot, shape) = (&self.robot, &self.boxes[index].shape);
        let Some(Contact { normal, depth }) = overlap(robot, shape) else { return };
        let between = shape.middle() - robot.middle();
        let in_front = between.dot(&robot.ahead()) > robot.half.x && between.dot(&robot.left()).abs() < robot.half.y;
        let by = if in_front { robot.ahead() * way_out(robot, shape, robot.ahead()) } else { normal * depth };
        self.shift(index, by);
    }

    fn shift(&mut self, index: usize, by: Vector2<f64>) {
        let shape = &mut self.boxes[index].shape;
        self.undo.push((index, shape.middle()));
        shape.shift(by);
        if !self.moved.contains(&index) {
            self.moved.push(index);
        }
    }
}

/// How two things are in one place; `None` where they are not.
pub(super) fn overlap(first: &Rectangle, second: &Rectangle) -> Option<Contact> {
    contact(first, second, 0.0).filter(|found| found.depth > SLOP)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use crate::sim::random::{Purpose, Stream};

    fn world(walls: &[[[f64; 2]; 2]]) -> World {
        let walls = Walls::new(walls.iter().map(|ends| ends.map(Vector2::from)));
        World::new(Rectangle::new(Vector2::zeros(), 0.0, 1.0, 0.75), 0.0, walls)
    }

    fn cargo(x: f64, y: f64) -> Rectangle {
        Rectangle::new(Vector2::new(x, y), 0.0, 0.4, 0.6)
    }

    fn place(world: &World, index: usize) -> Vector2<f64> {
        world.boxes[index].shape.middle()
    }

    /// The deepest overlap of any two things, m.
    fn deepest(world: &World) -> f64 {
        let solid: Vec<&Rectangle> = std::iter::once(&world.robot).chain(world.boxes()).collect();
        let mut deepest = 0.0_f64;
        for (index, first) in solid.iter().enumerate() {
            let others = solid[index + 1..].iter().copied().chain(world.walls.lines());
            for other in others {
                deepest = deepest.max(contact(first, other, 0.0).map_or(0.0, |found| found.depth));
            }
        }
        deepest
    }

    fn drive(world: &mut World, steps: usize, forward: f64, turn: f64) {
        for _ in 0..steps {
            world.load(forward.signum());
            world.advance(forward, turn);
        }
    }

    #[test]
    fn a_box_is_pushed_straight_ahead() {
        let mut world = world(&[]);
        world.add_box(cargo(1.0, 0.1), 30.0);
        drive(&mut world, 1000, 0.001, 0.0);
        // The robot's front ends at 1.5 m, half the box's length before its middle.
        assert!((place(&world, 0) - Vector2::new(1.7, 0.1)).norm() < 2.0 * SLOP);
        assert_eq!(world.load(1.0).mass, 30.0);
        assert_eq!(world.load(-1.0).mass, 0.0);
    }

    #[test]
    fn a_row_of_boxes_is_one_load() {
        let mut world = world(&[]);
        for (index, mass) in [10.0, 20.0, 40.0].into_iter().enumerate() {
            world.add_box(cargo(0.75 + 0.5 * index as f64, 0.0), mass);
        }
        // Gaps of 0.05, 0.1 and 0.1 m: the masses join one after the other, each once.
        let mut met = Vec::new();
        for _ in 0..300 {
            let load = world.load(1.0);
            if load.added > 0.0 {
                met.push((load.added, load.mass));
            }
            world.advance(0.001, 0.0);
        }
        assert_eq!(met, [(10.0, 10.0), (20.0, 30.0), (40.0, 70.0)]);
    }

    #[test]
    fn on_an_arc_a_box_slides_along_the_wedge_and_off_it() {
        let mut world = world(&[]);
        world.add_box(cargo(0.7, 0.0), 30.0);
        let offset = |world: &World| (place(world, 0) - world.robot.middle()).dot(&world.robot.left());
        let mut before = offset(&world);
        let mut last_touch = 0;
        for step in 0..4000 {
            drive(&mut world, 1, 0.001, 0.001);
            if world.load(1.0).mass > 0.0 {
                last_touch = step;
                // The robot curves to the left, so the box only ever drifts to the right.
                assert!(offset(&world) < before + 1e-9);
                before = offset(&world);
            }
        }
        // It was pushed for more than half a metre, and is left behind long before a full turn.
        assert!((500..1500).contains(&last_touch), "{last_touch}");
    }

    #[test]
    fn a_wall_ahead_stops_the_robot_and_what_it_pushes() {
        let mut world = world(&[[[1.5, -2.0], [1.5, 2.0]]]);
        world.add_box(cargo(0.9, 0.0), 30.0);
        drive(&mut world, 2000, 0.001, 0.0);
        // The last step may have been given up for a wall nearer than its millimetre.
        assert!((0.599..0.6 + SLOP).contains(&world.robot.middle().x), "{}", world.robot.middle().x);
        assert!(world.advance(0.01, 0.0).drive_blocked);
        drive(&mut world, 1000, 0.000_001, 0.0);
        assert_eq!(world.load(1.0).mass, f64::INFINITY);
        assert!(deepest(&world) <= SLOP);
    }

    #[test]
    fn a_robot_slides_along_a_wall_beside_it() {
        let mut world = world(&[[[-5.0, 0.4], [5.0, 0.4]]]);
        drive(&mut world, 200, 0.001, 0.000_5);
        let heading = world.heading();
        drive(&mut world, 1000, 0.001, 0.0);
        assert!(heading > 0.0 && world.robot.middle().x > 1.1);
        assert!(deepest(&world) <= SLOP);
    }

    #[test]
    fn a_robot_turns_itself_off_a_wall_and_off_a_box_before_one() {
        for pinned in [false, true] {
            let at = if pinned { -0.9 } else { -0.5 };
            let mut world = world(&[[[at, -2.0], [at, 2.0]]]);
            if pinned {
                world.add_box(cargo(-0.7, 0.0), 30.0);
            }
            drive(&mut world, 1000, 0.0, PI / 1000.0);
            assert!((world.heading() - PI).abs() < 1e-9, "{pinned}: {}", world.heading());
            assert!(deepest(&world) <= SLOP);
        }
    }

    #[test]
    fn nothing_ever_stands_in_one_place_or_passes_a_wall() {
        for seed in 0..200 {
            let mut stream = Stream::new(seed, Purpose::Tracking);
            let corners = [[-2.0, -2.0], [2.5, -2.0], [2.0, 2.0], [-2.0, 1.8]];
            let mut world = world(&[0, 1, 2, 3].map(|index| [corners[index], corners[(index + 1) % 4]]));
            for _ in 0..12 {
                let middle = Vector2::new(stream.between(-1.7, 1.7), stream.between(-1.5, 1.5));
                let size = [stream.between(0.05, 0.6), stream.between(0.05, 0.6)];
                let shape = Rectangle::new(middle, stream.between(0.0, TAU), size[0], size[1]);
                let free = |other| overlap(other, &shape).is_none();
                if std::iter::once(&world.robot).chain(world.boxes()).chain(world.walls.lines()).all(free) {
                    world.add_box(shape, stream.between(5.0, 120.0));
                }
            }
            for _ in 0..12 {
                // Up to 30 mm a step: many times what robots drive in a millisecond.
                let (forward, turn) = (stream.between(-0.03, 0.03), stream.between(-0.05, 0.05));
                drive(&mut world, 10, forward, turn);
                assert!(deepest(&world) <= SLOP, "seed {seed}: {}", deepest(&world));
            }
            let inside = |place: Vector2<f64>| place.x.abs() < 2.5 && place.y.abs() < 2.0;
            assert!(inside(world.robot.middle()) && world.boxes().all(|shape| inside(shape.middle())), "seed {seed}");
        }
    }
}
