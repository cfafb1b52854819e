//! A global planner (Khatoon and Ibraheem 2012, section 1.1): the shortest way on the map that is known, as temporary goals.
//!
//! It knows the walls of the world, and neither its boxes nor which of its doors are shut. What range sensors have seen
//! since is on the map when it is asked again.

use std::collections::VecDeque;

use nalgebra::Vector2;
use pathfinding::prelude::astar;

use crate::ir;

/// The most cells along one side of the map.
const MOST_CELLS: f64 = 256.0;
/// How many cells lie within the radius of the robot, where there is room for that.
const CELLS_WITHIN: f64 = 3.0;
/// Nearer to an obstacle than this many radiuses, a way costs more.
const WIDE: f64 = 4.0;
/// What the way along an obstacle costs more, as a factor.
const COST: f64 = 8.0;
/// What it costs to go from one cell to the next, in whole numbers.
const UNIT: f64 = 100.0;

/// What a robot is asked to plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Request {
    /// `planner.plan()`
    Plan,
    /// `planner.next()`
    Next,
}

/// A map of cells, and the way that was planned last.
#[derive(Debug)]
pub(super) struct Planner {
    low: Vector2<f64>,
    /// m along a side of a cell.
    cell: f64,
    columns: usize,
    rows: usize,
    /// How far each cell is from what stands on the map, m, to within a few percent.
    clearance: Vec<f64>,
    /// Cells that are nearer to something than those around them know.
    nearer: VecDeque<usize>,
    goal: Vector2<f64>,
    /// m around the middle of the robot.
    radius: f64,
    /// Temporary goals, m.
    way: VecDeque<Vector2<f64>>,
    /// The temporary goal that is aimed at.
    waypoint: Option<Vector2<f64>>,
}

impl Planner {
    /// A planner for a robot of that radius (m), before it is asked; `None` in a world without a goal.
    pub(super) fn new(scenario: &ir::Scenario, start: Vector2<f64>, radius: f64) -> Option<Self> {
        let goal = Vector2::from(scenario.goal?);
        let known = scenario.walls.iter().filter(|wall| !wall.is_door);
        let corners = known.clone().flat_map(|wall| &wall.corners).map(|corner| Vector2::from(*corner));
        let ends = corners.chain([goal, start]);
        let (low, high) = ends.fold((goal, goal), |(low, high), at| (low.inf(&at), high.sup(&at)));
        let margin = Vector2::repeat(WIDE * radius);
        let (low, high) = (low - margin, high + margin);
        let extent = high - low;
        let cell = (extent.max() / MOST_CELLS).max(radius / CELLS_WITHIN);
        let [columns, rows] = [extent.x, extent.y].map(|side| (side / cell).ceil() as usize + 1);
        let clearance = vec![f64::INFINITY; columns * rows];
        let (nearer, way, waypoint) = Default::default();
        let mut planner = Self { low, cell, columns, rows, clearance, nearer, goal, radius, way, waypoint };
        for ends in known.flat_map(|wall| wall.corners.windows(2)) {
            let [from, to] = [ends[0], ends[1]].map(Vector2::from);
            planner.line(from, to).into_iter().for_each(|cell| planner.occupy(cell));
        }
        Some(planner)
    }

    /// How exactly a place must be known to be put on the map, m.
    pub(super) fn exactness(&self) -> f64 {
        self.radius
    }

    /// Puts a place where something stands on the map.
    pub(super) fn learn(&mut self, place: Vector2<f64>) {
        if let Some(cell) = self.cell_at(place) {
            self.occupy(cell);
        }
    }

    fn occupy(&mut self, cell: usize) {
        if self.clearance[cell] > 0.0 {
            self.clearance[cell] = 0.0;
            self.nearer.push_back(cell);
        }
    }

    /// Does what it is asked, from where the robot is.
    pub(super) fn obey(&mut self, request: Request, robot: Vector2<f64>) {
        match request {
            Request::Plan => {
                self.spread();
                self.way = self.plan(robot).into();
                self.waypoint = self.way.front().copied();
            }
            // The last one is the goal.
            Request::Next => self.waypoint = self.way.pop_front().or(self.waypoint),
        }
    }

    /// The temporary goal, m; `None` before the first plan, and where there is no way.
    pub(super) fn waypoint(&self) -> Option<Vector2<f64>> {
        self.waypoint
    }

    /// The places at which the shortest way bends, and the goal; none where there is no way.
    fn plan(&self, robot: Vector2<f64>) -> Vec<Vector2<f64>> {
        let (Some(start), Some(goal)) = (self.cell_at(robot), self.cell_at(self.goal)) else { return Vec::new() };
        let clearance = &self.clearance;
        // Where the robot stands there is room for it, and where its goal is let there be.
        let is_free = |cell: usize| clearance[cell] > self.radius || cell == goal || self.is_near(cell, start);
        let successors = |&cell: &usize| {
            let costs = self.neighbors(cell).filter(|(next, _)| is_free(*next)).map(|(next, length)| {
                let narrow = (1.0 - clearance[next] / (WIDE * self.radius)).max(0.0);
                (next, (length * (1.0 + COST * narrow * narrow) * UNIT) as u32)
            });
            costs.collect::<Vec<_>>()
        };
        let left = |cell: &usize| (self.length(*cell, goal) * UNIT) as u32;
        let Some((cells, _)) = astar(&start, successors, left, |cell| *cell == goal) else { return Vec::new() };
        let mut way = self.pulled(&cells);
        way.pop();
        way.push(self.goal);
        way
    }

    /// The cells of a way at which it must bend to stay as far from everything as it is.
    fn pulled(&self, cells: &[usize]) -> Vec<Vector2<f64>> {
        let clearance = &self.clearance;
        let mut way = Vec::new();
        let mut from = 0;
        while from + 1 < cells.len() {
            let mut least = f64::INFINITY;
            let mut to = from + 1;
            for (place, &cell) in cells.iter().enumerate().skip(from + 1) {
                least = least.min(clearance[cell]);
                let line = self.line(self.middle(cells[from]), self.middle(cell));
                let room = least.min(clearance[cells[from]]).min(WIDE * self.radius) - self.cell;
                if line.into_iter().all(|cell| clearance[cell] >= room) {
                    to = place;
                }
            }
            way.push(self.middle(cells[to]));
            from = to;
        }
        way
    }

    /// Tells the cells around what has been put on the map.
    fn spread(&mut self) {
        while let Some(cell) = self.nearer.pop_front() {
            for (next, length) in self.neighbors(cell) {
                let through = self.clearance[cell] + length * self.cell;
                if through < self.clearance[next] {
                    self.clearance[next] = through;
                    self.nearer.push_back(next);
                }
            }
        }
    }

    /// The cells around one, with how far they are in cells.
    fn neighbors(&self, cell: usize) -> impl Iterator<Item = (usize, f64)> + use<> {
        let (columns, rows) = (self.columns, self.rows);
        let (column, row) = (cell % columns, cell / columns);
        let around = (-1..=1_isize).flat_map(|down| (-1..=1_isize).map(move |right| (right, down)));
        around.filter(|&step| step != (0, 0)).filter_map(move |(right, down)| {
            let (column, row) = (column.checked_add_signed(right)?, row.checked_add_signed(down)?);
            let length = ((right * right + down * down) as f64).sqrt();
            (column < columns && row < rows).then_some((row * columns + column, length))
        })
    }

    /// Between two cells, in cells.
    fn length(&self, one: usize, other: usize) -> f64 {
        (self.middle(one) - self.middle(other)).norm() / self.cell
    }

    fn is_near(&self, cell: usize, start: usize) -> bool {
        self.clearance[cell] > 0.0 && self.length(cell, start) * self.cell <= self.radius
    }

    /// The cells that a line goes through.
    fn line(&self, from: Vector2<f64>, to: Vector2<f64>) -> Vec<usize> {
        let steps = ((to - from).norm() / self.cell * 2.0).ceil().max(1.0);
        let places = (0..=steps as usize).map(|step| from + (to - from) * (step as f64 / steps));
        let mut cells: Vec<usize> = places.filter_map(|place| self.cell_at(place)).collect();
        cells.dedup();
        cells
    }

    fn cell_at(&self, place: Vector2<f64>) -> Option<usize> {
        let [column, row] = [place.x - self.low.x, place.y - self.low.y].map(|along| (along / self.cell).floor());
        let is_inside = column >= 0.0 && row >= 0.0 && column < self.columns as f64 && row < self.rows as f64;
        is_inside.then(|| row as usize * self.columns + column as usize)
    }

    fn middle(&self, cell: usize) -> Vector2<f64> {
        let (column, row) = (cell % self.columns, cell / self.columns);
        self.low + Vector2::new(column as f64 + 0.5, row as f64 + 0.5) * self.cell
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Span;
    use crate::sim::fixture::scenario;

    fn wall(corners: &[[f64; 2]], is_door: bool) -> ir::Wall {
        ir::Wall { corners: corners.to_vec(), is_door, span: Span::default() }
    }

    /// Two rooms side by side, a door between them that is shut, and a gap at the far end.
    fn rooms() -> Planner {
        let walls = vec![
            wall(&[[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0], [0.0, 0.0]], false),
            wall(&[[10.0, 0.0], [10.0, 4.0]], false),
            wall(&[[10.0, 4.0], [10.0, 6.0]], true),
            wall(&[[10.0, 6.0], [10.0, 16.0]], false),
        ];
        let scenario = ir::Scenario { walls, goal: Some([15.0, 5.0]), ..scenario() };
        Planner::new(&scenario, Vector2::new(5.0, 5.0), 0.5).unwrap()
    }

    /// The way from a place to the goal, m.
    fn length(planner: &mut Planner, from: Vector2<f64>) -> f64 {
        planner.spread();
        let mut way = vec![from];
        way.extend(planner.plan(from));
        way.windows(2).map(|ends| (ends[1] - ends[0]).norm()).sum()
    }

    #[test]
    fn a_way_leads_through_the_door_until_that_is_seen_to_be_shut() {
        let mut planner = rooms();
        let start = Vector2::new(5.0, 5.0);
        assert!(length(&mut planner, start) < 10.5, "{}", length(&mut planner, start));
        for along in 0..40 {
            planner.learn(Vector2::new(10.0, 4.0 + f64::from(along) * 0.05));
        }
        // Around the end of the wall, from 5 to 16 m and back.
        let around = length(&mut planner, start);
        assert!((24.0..29.0).contains(&around), "{around}");
        planner.obey(Request::Plan, start);
        let first = planner.waypoint().unwrap();
        assert!(first.y > 12.0 && first.x < 11.0, "{first}");
    }

    #[test]
    fn a_way_keeps_away_from_walls_and_ends_at_the_goal() {
        let mut planner = rooms();
        planner.spread();
        let way = planner.plan(Vector2::new(5.0, 12.0));
        assert_eq!(way.last(), Some(&Vector2::new(15.0, 5.0)));
        let cells: Vec<usize> = way.windows(2).flat_map(|ends| planner.line(ends[0], ends[1])).collect();
        assert!(cells.iter().all(|cell| planner.clearance[*cell] > 0.5));
    }

    #[test]
    fn temporary_goals_come_one_after_another_and_the_last_is_the_goal() {
        let mut planner = rooms();
        assert_eq!(planner.waypoint(), None);
        planner.obey(Request::Plan, Vector2::new(5.0, 18.0));
        let mut seen = Vec::new();
        for _ in 0..10 {
            planner.obey(Request::Next, Vector2::new(5.0, 18.0));
            seen.extend(planner.waypoint());
        }
        assert_eq!(seen.len(), 10);
        assert_eq!(seen.last(), Some(&Vector2::new(15.0, 5.0)));
    }

    #[test]
    fn without_a_way_there_is_no_temporary_goal() {
        let mut planner = rooms();
        for along in 0..400 {
            planner.learn(Vector2::new(10.0, f64::from(along) * 0.05));
        }
        planner.obey(Request::Plan, Vector2::new(5.0, 5.0));
        assert_eq!(planner.waypoint(), None);
    }
}
