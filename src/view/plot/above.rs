//! The run from above, to scale (LMSL fig. 10): where the robot went and what it moved.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::scale::Scale;
use super::sheet::{Panel, Sheet};
use crate::trace::{Footprint, Signal, Trace};
use crate::view::svg::{Anchor, Px, Svg, width_of};

/// The lowest and the highest view, px.
const HEIGHT: (f64, f64) = (150.0, 400.0);
/// What stays free around everything, px.
const MARGIN: f64 = 16.0;
/// A robot drawn smaller than this is a speck, px: a ring shows where it started, and dots where the mode changed.
const SPECK: f64 = 12.0;
/// The radius of that ring, px.
const RING: f64 = 5.0;
/// The radius of a dot, px.
const DOT: f64 = 2.8;
/// The most changes of mode that are shown with an outline and a name; more have dots.
const OUTLINES: usize = 12;
/// The most dots.
const DOTS: usize = 200;
/// The most points of a path.
const POINTS: usize = 4000;

#[derive(Clone, Copy)]
struct Pose {
    x: f64,
    y: f64,
    heading: f64,
}

impl Pose {
    /// A point of the body in the world, m: `ahead` of its center and to its `left`.
    fn point(&self, ahead: f64, left: f64) -> [f64; 2] {
        let (sin, cos) = self.heading.sin_cos();
        [self.x + ahead * cos - left * sin, self.y + ahead * sin + left * cos]
    }

    fn corners(&self, body: &Footprint) -> [[f64; 2]; 4] {
        let (ahead, left) = (body.length / 2.0, body.width / 2.0);
        [(ahead, left), (ahead, -left), (-ahead, -left), (-ahead, left)].map(|(ahead, left)| self.point(ahead, left))
    }

    fn is_near(&self, other: &Self) -> bool {
        (self.x - other.x).hypot(self.y - other.y) < 0.02 && (self.heading - other.heading).abs() < 0.05
    }
}

/// A body and its known poses with the ticks they belong to.
struct Track<'a> {
    body: &'a Footprint,
    poses: Vec<(usize, Pose)>,
}

impl<'a> Track<'a> {
    fn new(trace: &'a Trace, number: usize, body: &'a Footprint) -> Option<Self> {
        let of = |signal: fn(u32) -> Signal| trace.column(signal(number as u32));
        let (x, y, heading) = (of(Signal::X)?, of(Signal::Y)?, of(Signal::Heading)?);
        let values = x.values.iter().zip(&y.values).zip(&heading.values).enumerate();
        let poses = values.map(|(tick, ((&x, &y), &heading))| (tick, Pose { x, y, heading }));
        let known = poses.filter(|(_, pose)| pose.x.is_finite() && pose.y.is_finite() && pose.heading.is_finite());
        let track = Self { body, poses: known.collect() };
        (!track.poses.is_empty()).then_some(track)
    }

    fn ends(&self) -> Option<(Pose, Pose)> {
        Some((self.poses.first()?.1, self.poses.last()?.1))
    }

    /// The poses in which the mode changed, without those at the start, at the end, and near one another.
    fn at_changes(&self, trace: &'a Trace) -> Vec<(Pose, &'a str)> {
        let Some((start, end)) = self.ends() else { return Vec::new() };
        let mut seen = vec![start, end];
        let mut found = Vec::new();
        for change in &trace.changes {
            let tick = trace.times.partition_point(|&time| time < change.time);
            let at = self.poses.partition_point(|&(known, _)| known < tick);
            let (Some(&(_, pose)), Some(mode)) = (self.poses.get(at), trace.modes.get(change.to as usize)) else {
                continue;
            };
            if found.len() < DOTS && !seen.iter().any(|other| other.is_near(&pose)) {
                seen.push(pose);
                found.push((pose, mode.as_str()));
            }
        }
        found
    }
}

/// Meters to px, the same for both directions.
struct View {
    x: Scale,
    y: Scale,
}

impl View {
    /// Fits `low` to `high` into a panel, centered.
    fn new(low: [f64; 2], high: [f64; 2], panel: &Panel) -> Self {
        let (wide, tall) = (panel.right - panel.left - 2.0 * MARGIN, panel.height() - 2.0 * MARGIN);
        let meter = (wide / (high[0] - low[0])).min(tall / (high[1] - low[1]));
        let fit = |low: f64, high: f64, from: f64, to: f64| {
            let (center, half) = (f64::midpoint(low, high), (to - from).abs() / meter / 2.0);
            Scale { low: center - half, high: center + half, from, to }
        };
        Self { x: fit(low[0], high[0], panel.left, panel.right), y: fit(low[1], high[1], panel.bottom, panel.top) }
    }

    fn at(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        (self.x.px(x), self.y.px(y))
    }

    /// A length in px.
    fn px(&self, meters: f64) -> f64 {
        self.x.px(meters) - self.x.px(0.0)
    }

    /// Path data through points, leaving out those less than `apart` px from the one before.
    fn line(&self, points: impl Iterator<Item = [f64; 2]>, apart: f64) -> String {
        let mut data = String::new();
        let mut before: Option<(f64, f64)> = None;
        for (x, y) in points.map(|point| self.at(point)).filter(|(x, y)| x.is_finite() && y.is_finite()) {
            if before.is_none_or(|before| (x - before.0).hypot(y - before.1) >= apart) {
                let letter = if before.is_none() { 'M' } else { 'L' };
                let _ = write!(data, "{letter}{} {}", Px(x), Px(y));
                before = Some((x, y));
            }
        }
        data
    }

    fn outline(&self, body: &Footprint, pose: Pose) -> String {
        self.line(pose.corners(body).into_iter(), 0.0) + "Z"
    }

    fn is_speck(&self, body: &Footprint) -> bool {
        self.px(body.length.max(body.width)) < SPECK
    }
}

/// Draws the view from above, where the trace says where anything was.
pub(super) fn draw(svg: &mut Svg, sheet: &mut Sheet, trace: &Trace) {
    let track = |number| trace.bodies.get(number).and_then(|body| Track::new(trace, number, body));
    let robot = track(0);
    let boxes: Vec<Track<'_>> = (1..trace.bodies.len()).filter_map(track).collect();
    let changes = robot.as_ref().map_or_else(Vec::new, |robot| robot.at_changes(trace));
    let Some((low, high)) = bounds(trace, robot.as_ref(), &boxes, &changes) else { return };

    let width = sheet.time.to - sheet.time.from;
    let height = (high[1] - low[1]) / (high[0] - low[0]) * (width - 2.0 * MARGIN) + 2.0 * MARGIN;
    let panel = sheet.panel(svg, height.clamp(HEIGHT.0, HEIGHT.1), 6.0);
    let view = View::new(low, high, &panel);
    for (value, _) in view.x.ticks(10.0) {
        let x = view.x.px(value);
        svg.line("grid", (x, panel.top), (x, panel.bottom));
    }
    panel.vertical_axis(svg, view.y, (panel.height() / 36.0).max(2.0), "y (m)");
    panel.horizontal_axis(svg, view.x, 10.0, "x (m)");

    if !trace.hits.is_empty() {
        // One for each cell of 2 px, as wide as a speck: more would show nothing more.
        let cells: BTreeSet<_> = trace
            .hits
            .iter()
            .map(|&hit| view.at(hit))
            .map(|(x, y)| ((x / 2.0).round() as i64, (y / 2.0).round() as i64))
            .collect();
        svg.shape("hit", &specks(cells.into_iter().map(|(x, y)| (x as f64 * 2.0, y as f64 * 2.0))));
    }
    for wall in &trace.walls {
        svg.shape("wall", &view.line(wall.iter().copied(), 0.0));
    }
    if let Some(goal) = trace.goal.filter(|goal| goal.iter().all(|coordinate| coordinate.is_finite())) {
        svg.shape("goal", &cross(view.at(goal)));
    }
    for (start, track) in boxes.iter().filter_map(|track| Some((track.ends()?.0, track))) {
        svg.shape("was", &view.outline(track.body, start));
    }
    if let Some(robot) = &robot {
        draw_robot(svg, &view, robot, &changes);
    }
    for (end, track) in boxes.iter().filter_map(|track| Some((track.ends()?.1, track))) {
        svg.shape("box", &view.outline(track.body, end));
        let (x, y) = view.at([end.x, end.y]);
        // On a box too small for its label the label would hide it.
        let size = view.px(track.body.length.min(track.body.width));
        let y = if size < 40.0 { y - view.px(track.body.length.max(track.body.width)) / 2.0 - 9.0 } else { y };
        // The mass is what tells boxes apart; the name is there for who points at it.
        svg.raw(format_args!("<g><title>{}</title>", super::svg::Escaped(&track.body.name)));
        svg.text("halo", (x, y + 4.0), Anchor::Middle, &format!("{} kg", track.body.mass));
        svg.raw("</g>");
    }
    let is_speck = robot.as_ref().is_some_and(|robot| view.is_speck(robot.body));
    legend(svg, &panel, trace, robot.as_ref().map(|_| is_speck), !boxes.is_empty(), changes.len());
    panel.frame(svg);
    sheet.skip(40.0);
}

fn draw_robot(svg: &mut Svg, view: &View, robot: &Track<'_>, changes: &[(Pose, &str)]) {
    let Some((start, end)) = robot.ends() else { return };
    let body = robot.body;
    let is_speck = view.is_speck(body);
    let at_start = if is_speck { ring(view.at([start.x, start.y]), RING) } else { view.outline(body, start) };
    svg.shape("start", &at_start);
    let named = if changes.len() <= OUTLINES { changes } else { &[] };
    for (pose, _) in named.iter().filter(|_| !is_speck) {
        svg.shape("then", &view.outline(body, *pose));
    }
    svg.shape("robot", &view.outline(body, end));
    svg.shape("arrow", &(arrow(view, body, end) + "Z"));
    let positions = || robot.poses.iter().map(|(_, pose)| [pose.x, pose.y]);
    let mut apart = 0.5;
    let mut path = view.line(positions(), apart);
    while path.matches('L').count() > POINTS {
        apart *= 2.0;
        path = view.line(positions(), apart);
    }
    svg.shape("path", &path);
    for (pose, _) in changes {
        svg.shape("dot", &ring(view.at([pose.x, pose.y]), DOT));
    }
    let mut labels: Vec<(f64, f64, f64)> = Vec::new();
    for (pose, mode) in named {
        let (x, y) = view.at([pose.x, pose.y]);
        let width = width_of(mode);
        let collides = |&(left, baseline, wide): &(f64, f64, f64)| {
            (baseline - y).abs() < 13.0 && x < left + wide && left < x + width
        };
        if !labels.iter().any(collides) {
            svg.text("halo", (x - 2.0, y - 7.0), Anchor::Start, mode);
            labels.push((x, y, width));
        }
    }
}

/// The tip of a body at its front, to tell front from back.
fn arrow(view: &View, body: &Footprint, pose: Pose) -> String {
    let (ahead, size) = (body.length / 2.0, body.width.min(body.length) * 0.16);
    let points = [(ahead, 0.0), (ahead - size, size * 0.6), (ahead - size, -size * 0.6)];
    view.line(points.into_iter().map(|(ahead, left)| pose.point(ahead, left)), 0.0)
}

fn ring((x, y): (f64, f64), radius: f64) -> String {
    let (left, radius, across) = (Px(x - radius), Px(radius), Px(2.0 * radius));
    format!("M{left} {}a{radius} {radius} 0 1 0 {across} 0a{radius} {radius} 0 1 0 -{across} 0", Px(y))
}

/// Points, which the line's round ends make visible.
fn specks(points: impl Iterator<Item = (f64, f64)>) -> String {
    points.map(|(x, y)| format!("M{} {}h0", Px(x), Px(y))).collect::<Vec<_>>().concat()
}

fn cross((x, y): (f64, f64)) -> String {
    let (x, y, left, top) = (Px(x), Px(y), Px(x - 6.0), Px(y - 6.0));
    format!("M{left} {y}h12M{x} {top}v12M{} {y}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0", Px(left.0 + 2.0))
}

/// The corners of what must be seen, m; `None` where there is nothing. Never empty in either direction.
fn bounds(
    trace: &Trace,
    robot: Option<&Track<'_>>,
    boxes: &[Track<'_>],
    changes: &[(Pose, &str)],
) -> Option<([f64; 2], [f64; 2])> {
    let outlines = robot.into_iter().chain(boxes).filter_map(|track| {
        let (start, end) = track.ends()?;
        Some([start, end].map(|pose| pose.corners(track.body)))
    });
    let between = robot.into_iter().flat_map(|robot| changes.iter().map(|(pose, _)| pose.corners(robot.body)));
    let path = robot.into_iter().flat_map(|robot| robot.poses.iter().map(|(_, pose)| [pose.x, pose.y]));
    let points = outlines.flatten().chain(between).flatten().chain(path);
    let points = points.chain(trace.walls.iter().flatten().copied()).chain(trace.goal);
    let mut corners: Option<([f64; 2], [f64; 2])> = None;
    for [x, y] in points.filter(|[x, y]| x.is_finite() && y.is_finite()) {
        let (low, high) = corners.get_or_insert(([x, y], [x, y]));
        (*low, *high) = ([low[0].min(x), low[1].min(y)], [high[0].max(x), high[1].max(y)]);
    }
    let (low, high) = corners?;
    let widen = |low: f64, high: f64| if high - low < 0.1 { (low - 0.5, high + 0.5) } else { (low, high) };
    let ((left, right), (bottom, top)) = (widen(low[0], high[0]), widen(low[1], high[1]));
    Some(([left, bottom], [right, top]))
}

/// `robot` says whether it is a speck, where there is one.
fn legend(svg: &mut Svg, panel: &Panel, trace: &Trace, robot: Option<bool>, boxes: bool, changes: usize) {
    let is_speck = robot == Some(true);
    let entries = [
        (robot.is_some(), "path", "path of the robot"),
        (robot.is_some(), "start", "robot at the start"),
        (changes > 0, if changes > OUTLINES || is_speck { "dot" } else { "then" }, "where the mode changed"),
        (robot.is_some(), "robot", "robot at the end"),
        (boxes, "was", "box at the start"),
        (boxes, "box", "box at the end"),
        (!trace.walls.is_empty(), "wall", "wall"),
        (!trace.hits.is_empty(), "hit", "seen by range sensors"),
        (trace.goal.is_some(), "goal", "goal"),
    ];
    let shown = entries.into_iter().filter(|(is_there, ..)| *is_there);
    for (line, (_, class, name)) in shown.enumerate() {
        let (x, y) = panel.legend(line);
        let sample = match class {
            "path" | "wall" => format!("M{x:.1} {y:.1}h18"),
            "goal" => cross((x + 9.0, y)),
            "dot" => ring((x + 9.0, y), DOT),
            "start" if is_speck => ring((x + 9.0, y), RING),
            "hit" => specks([4.0, 9.0, 14.0].into_iter().map(|along| (x + along, y))),
            _ => format!("M{:.1} {:.1}h18v9h-18Z", x, y - 4.5),
        };
        svg.shape(class, &sample);
        panel.legend_name(svg, line, "", name);
    }
}
