//! What stands in a world, and what happens where the robot meets it.
//!
//! The contact model is quasi-static: boxes have no momentum and move only while they are pushed. The floor's friction
//! keeps the heading of a box, so boxes are shifted and never turned. While the middle of a box is in front of the
//! robot, the box moves along the normal of the robot's front face only: there is no friction along the wedge, so on an
//! arc a box slides sideways along it. Past the edge of the wedge, and at the robot's other sides, a box is pushed out
//! by the shortest way, which lets it slide off the corner. A box that is pushed pushes what it touches. What meets a
//! wall slides along it, or stays where it is; a step that would leave two things in one place is not made at all.

use nalgebra::Vector2;

use super::geometry::{Contact, Rectangle, contact, way_out};

/// Overlaps up to this are none, m: far above the rounding of positions in a world of kilometres.
pub(super) const SLOP: f64 = 1e-6;
/// Gaps below this are a touch, m: far below what a robot drives between two steps.
const TOUCH: f64 = 1e-5;
/// What has touched is only let go behind a gap of this, m, so that noise does not make one impact many.
const LET_GO: f64 = 1e-3;
/// What touches within 60 degrees of the way the robot drives is in its way: the cosine of that angle.
const IN_THE_WAY: f64 = 0.5;

/// A box on the floor.
#[derive(Debug, Clone)]
struct Crate {
    shape: Rectangle,
    /// kg
    mass: f64,
    /// Whether it is part of the robot's load.
    held: bool,
}

/// The robot, the boxes and the walls.
#[derive(Debug, Clone)]
pub(super) struct World {
    robot: Rectangle,
    /// The robot's heading in rad, counted on over full turns.
    heading: f64,
    boxes: Vec<Crate>,
    walls: Vec<Rectangle>,
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
    /// The angle the robot turned, rad.
    pub(super) turned: f64,
    /// Whether something kept it from driving on.
    pub(super) drive_blocked: bool,
    /// Whether something kept it from turning on.
    pub(super) turn_blocked: bool,
}

impl World {
    /// A world with a robot; `heading` in rad.
    pub(super) fn new(robot: Rectangle, heading: f64) -> Self {
        Self {
            robot,
            heading,
            boxes: Vec::new(),
            walls: Vec::new(),
            longest_step: robot.half.min() / 2.0,
            direction: 0.0,
            against_wall: false,
            moved: Vec::new(),
            undo: Vec::new(),
            reached: Vec::new(),
        }
    }

    /// Adds a box of `mass` kg.
    pub(super) fn add_box(&mut self, shape: Rectangle, mass: f64) {
        self.longest_step = self.longest_step.min(shape.half.min() / 2.0);
        self.boxes.push(Crate { shape, mass, held: false });
        // Enough for every box once, so that steps rarely allocate.
        self.moved.reserve(self.boxes.len());
        self.undo.reserve(self.boxes.len());
        self.reached.reserve(self.boxes.len());
    }

    /// Adds a straight wall.
    pub(super) fn add_wall(&mut self, line: Rectangle) {
        self.walls.push(line);
    }

    /// The robot's outline.
    pub(super) fn robot(&self) -> &Rectangle {
        &self.robot
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
    pub(super) fn walls(&self) -> &[Rectangle] {
        &self.walls
    }

    /// What stands in the way of a robot that drives forward (1), backward (-1) or not at all (0): the boxes it
    /// touches, the boxes they touch, and so on. Linear in the boxes where nothing touches, else at most quadratic.
    pub(super) fn load(&mut self, direction: f64) -> Load {
        if direction != self.direction {
            self.direction = direction;
            self.against_wall = false;
            self.boxes.iter_mut().for_each(|one| one.held = false);
        }
        if direction == 0.0 {
            return Load::NONE;
        }
        let way = self.robot.ahead() * direction;
        let mut load = Load::NONE;
        self.reached.clear();
        let mut wall = self.wall_in_the_way(&self.robot, way);
        let mut next = 0;
        self.reach(None, way);
        while let Some(&index) = self.reached.get(next) {
            self.reach(Some(index), way);
            wall |= self.wall_in_the_way(&self.boxes[index].shape, way);
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

    fn wall_in_the_way(&self, shape: &Rectangle, way: Vector2<f64>) -> bool {
        let margin = if self.against_wall { LET_GO } else { TOUCH };
        let meets = |wall| contact(shape, wall, margin).is_some_and(|found| found.normal.dot(&way) > IN_THE_WAY);
        self.walls.iter().any(meets)
    }

    /// Drives the robot `forward` (m) on an arc on which it turns left by `turn` (rad), with all that this moves.
    pub(super) fn advance(&mut self, forward: f64, turn: f64) -> Moved {
        let farthest = forward.abs() + turn.abs() * self.robot.radius();
        let steps = (farthest / self.longest_step).ceil().clamp(1.0, 1e6);
        let mut moved = Moved { turned: 0.0, drive_blocked: false, turn_blocked: false };
        for _ in 0..steps as u32 {
            let (forward, turn) = (forward / steps, turn / steps);
            let (mut drove, mut turned) = (self.attempt(forward, turn), true);
            if drove.is_none() {
                drove = self.attempt(forward, 0.0);
                turned = drove.is_none() && self.attempt(0.0, turn).is_some();
            }
            moved.turned += if turned { turn } else { 0.0 };
            moved.turn_blocked |= !turned;
            // Sliding along a wall that is not in the way costs this much at most.
            let least = forward.abs() * (1.0 - IN_THE_WAY * IN_THE_WAY);
            moved.drive_blocked |= drove.is_none_or(|drove| drove < least);
        }
        moved
    }

    /// Makes a step if it leaves nothing in one place with something else. How far the robot then got in the
    /// direction of `forward`, m.
    fn attempt(&mut self, forward: f64, turn: f64) -> Option<f64> {
        let before = self.robot;
        let middle = self.heading + turn / 2.0;
        let way = Vector2::new(middle.cos(), middle.sin());
        let heading = self.heading + turn;
        self.robot = Rectangle::new(before.middle() + way * forward, heading, 0.0, 0.0);
        self.robot.half = before.half;
        self.undo.clear();
        self.moved.clear();
        if self.leave_walls() && self.push_boxes() {
            self.heading = heading;
            return Some((self.robot.middle() - before.middle()).dot(&way) * forward.signum());
        }
        self.robot = before;
        while let Some((index, place)) = self.undo.pop() {
            self.boxes[index].shape.pose.translation.vector = place;
        }
        None
    }

    /// Slides the robot out of the walls it has run into. Whether that was possible.
    fn leave_walls(&mut self) -> bool {
        // Twice round settles a corner of two walls; what needs more is wedged in.
        for _ in 0..3 {
            let mut free = true;
            for wall in &self.walls {
                if let Some(Contact { normal, depth }) = overlap(wall, &self.robot) {
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
            for wall in 0..self.walls.len() {
                if let Some(Contact { normal, depth }) = overlap(&self.walls[wall], &self.boxes[mover].shape) {
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
