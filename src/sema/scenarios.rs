//! Scenarios: what is run, where, what goes wrong, and what is expected.

use std::collections::HashMap;

use super::conditions::Scene;
use super::diagrams::collect_names;
use super::modes::Modes;
use super::quantities::empty_range;
use super::{Lower, claim, missing_part, not_supported, symbol};
use crate::base::{Id, Span};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Window};
use crate::syntax::ast;

/// What a scenario and those it extends say, the later word standing.
#[derive(Default)]
struct Parts<'a> {
    runs: Option<&'a ast::Name>,
    on: Option<&'a ast::Name>,
    within: Option<&'a ast::Name>,
    duration: Option<(&'a ast::Quantity, Span)>,
    tick: Option<(&'a ast::Quantity, Span)>,
    seed: Option<(&'a ast::Number, Span)>,
    start: Option<(&'a ast::PlaceAt, Span)>,
    boxes: Vec<&'a ast::BoxItem>,
    faults: Vec<&'a ast::ScenarioItem>,
    /// Its own only: a variation is expected to behave differently.
    expectations: Vec<&'a ast::Expect>,
}

impl<'a> Lower<'a> {
    pub(super) fn scenario(&mut self, tree: &'a ast::Scenario) {
        let Some(chain) = self.chain(tree, Self::find_scenario_tree) else { return };
        let parts = self.scenario_parts(&chain);
        let Some(runs) = parts.runs else {
            // What is extended lacks it too, and that was reported.
            if chain.len() > 1 {
                return;
            }
            return self.report(
                missing_part(tree.name.span, format!("`{}` does not say what it runs", tree.name.text))
                    .help(format!("write `scenario {} runs obstacle_manipulation`", tree.name.text)),
            );
        };
        let diagram = self.find_runnable(runs);
        let on = parts.on.map(|on| (on, self.find_robot(on)));
        let world = parts.within.map(|world| self.find_world(world));
        let Some(diagram) = diagram else { return };
        let Some(robot) = self.scenario_robot(tree, diagram, on) else { return };

        let duration = match parts.duration {
            Some((duration, _)) => self.positive_nanoseconds(duration, "a duration"),
            // What is extended lacks it too, and that was reported; or it is in what could not be parsed.
            None if chain.len() > 1 || chain.iter().any(|tree| tree.items.iter().any(is_error)) => None,
            None => {
                let message = format!("`{}` does not say how long it lasts", tree.name.text);
                self.report(missing_part(tree.name.span, message).help("write `duration 10 s`"));
                None
            }
        };
        let tick = match parts.tick {
            Some((tick, _)) => self.positive_nanoseconds(tick, "a tick"),
            None => Some(ir::Scenario::DEFAULT_TICK),
        };
        let seed = parts.seed.map_or(Some(1), |(seed, _)| self.whole(seed, 0, "a seed"));
        let start = match parts.start {
            Some((ast::PlaceAt::Ahead(distance), _)) => {
                self.report(super::invalid(distance.span, "a robot is placed at a point, not ahead of itself"));
                None
            }
            Some((place, _)) => self.placement(place),
            None => Some(ir::Placement::At { x: 0.0, y: 0.0, heading: 0.0 }),
        };
        let (mut walls, mut boxes, mut goal) = (Vec::new(), Vec::new(), None);
        if let Some(Some(world)) = world {
            let world = &self.program.worlds[world];
            (walls, boxes, goal) = (world.walls.clone(), world.boxes.clone(), world.goal);
        }
        for tree in &parts.boxes {
            self.check_box_name(tree, &boxes);
            let lowered = self.box_body(tree, boxes.len());
            boxes.extend(lowered);
        }
        let faults = parts.faults.iter().filter_map(|fault| self.faults(fault, robot)).flatten().collect();
        let mut expectations = self.expectations(&parts.expectations, diagram, robot);
        expectations.extend(self.monitored(tree.name.span.file, diagram));
        // What was wrong has been reported; a scenario with a gap is not run.
        if self.poison.robots.contains(&robot) {
            return;
        }
        let (Some(duration), Some(tick), Some(seed), Some(start)) = (duration, tick, seed, start) else { return };
        self.program.scenarios.add(ir::Scenario {
            symbol: symbol(&tree.name, tree.doc.as_ref()),
            diagram,
            robot,
            duration,
            tick,
            seed,
            start,
            walls,
            boxes,
            goal,
            faults,
            expectations,
        });
    }

    fn scenario_parts(&mut self, chain: &[&'a ast::Scenario]) -> Parts<'a> {
        let mut parts = Parts::default();
        for tree in chain {
            parts.runs = tree.runs.as_ref().or(parts.runs);
            parts.on = tree.on.as_ref().or(parts.on);
            parts.within = tree.within.as_ref().or(parts.within);
            parts.expectations.clear();
            let mut own = Parts::default();
            let mut boxes = HashMap::new();
            for item in &tree.items {
                match item {
                    ast::ScenarioItem::Duration(duration, span) => {
                        self.once(&mut own.duration, duration, *span, "the duration");
                    }
                    ast::ScenarioItem::Tick(tick, span) => self.once(&mut own.tick, tick, *span, "the tick"),
                    ast::ScenarioItem::Seed(seed, span) => self.once(&mut own.seed, seed, *span, "the seed"),
                    ast::ScenarioItem::PlaceRobot { robot: Some(_), span, .. } => {
                        self.report(not_supported(*span, "a robot of a team"));
                    }
                    ast::ScenarioItem::PlaceRobot { robot: None, place, span } => {
                        self.once(&mut own.start, place, *span, "the robot's place");
                    }
                    ast::ScenarioItem::PlaceBox(item) => {
                        if let Some(name) = &item.name
                            && !claim(&mut boxes, name, "box", &mut self.diagnostics)
                        {
                            continue;
                        }
                        let same = |known: &&ast::BoxItem| {
                            item.name.is_some()
                                && known.name.as_ref().map(|name| &name.text)
                                    == item.name.as_ref().map(|name| &name.text)
                        };
                        match parts.boxes.iter_mut().find(|known| same(known)) {
                            Some(known) => *known = item,
                            None => parts.boxes.push(item),
                        }
                    }
                    ast::ScenarioItem::Fault { .. } | ast::ScenarioItem::Fail { .. } => parts.faults.push(item),
                    ast::ScenarioItem::Expect(expect) => parts.expectations.push(expect),
                    ast::ScenarioItem::Error(_) => {}
                }
            }
            parts.duration = own.duration.or(parts.duration);
            parts.tick = own.tick.or(parts.tick);
            parts.seed = own.seed.or(parts.seed);
            parts.start = own.start.or(parts.start);
        }
        parts
    }

    /// Reports a box that is named like one of the scenario's world.
    fn check_box_name(&mut self, tree: &ast::BoxItem, boxes: &[ir::BoxBody]) {
        if let Some(name) = &tree.name
            && let Some(first) = boxes.iter().find(|known| known.name == name.text)
        {
            let diagnostic = super::duplicate(name, first.span, "box");
            self.report(diagnostic);
        }
    }

    /// The robot a scenario runs on: the one it names, or else the one its diagram is written on.
    fn scenario_robot(
        &mut self,
        tree: &ast::Scenario,
        diagram: Id<ir::Diagram>,
        on: Option<(&ast::Name, Option<Id<ir::Robot>>)>,
    ) -> Option<Id<ir::Robot>> {
        match (self.program.diagrams[diagram].platform, on) {
            (ir::Platform::Robot(robot), None) => Some(robot),
            (ir::Platform::Interface(_), None) => {
                let message = format!("`{}` does not say on which robot it runs", tree.name.text);
                self.report(missing_part(tree.name.span, message).help("write `on j5` after what it runs"));
                None
            }
            (platform, Some((name, robot))) => {
                let robot = robot?;
                let fits = match platform {
                    ir::Platform::Robot(wanted) => wanted == robot,
                    ir::Platform::Interface(wanted) => self.program.robots[robot].provides.contains(&wanted),
                };
                if !fits {
                    let diagram = &self.program.diagrams[diagram].symbol.name;
                    let message = format!("`{diagram}` is not written for the robot `{}`", name.text);
                    let note = match platform {
                        ir::Platform::Robot(wanted) => {
                            format!("it is written on `{}`", self.program.robots[wanted].symbol.name)
                        }
                        ir::Platform::Interface(wanted) => {
                            let interface = &self.program.interfaces[wanted].symbol.name;
                            format!("it runs on robots that provide `{interface}`")
                        }
                    };
                    self.report(Diagnostic::new(&diag::rules::WRONG_KIND, name.span, message).note(note));
                }
                fits.then_some(robot)
            }
        }
    }

    /// A fault of every sensor that it names.
    fn faults(&mut self, tree: &ast::ScenarioItem, robot: Id<ir::Robot>) -> Option<Vec<ir::Fault>> {
        let (reference, reading, window_tree, span) = match tree {
            ast::ScenarioItem::Fault { sensor, reading, window, span } => (sensor, Some(reading), window, *span),
            ast::ScenarioItem::Fail { sensor, window, span } => (sensor, None, window, *span),
            _ => return None,
        };
        let [name] = reference.path.segments.as_slice() else {
            self.report(not_supported(reference.path.span, "a sensor of a team's robot"));
            return None;
        };
        let sensors = self.program.robots[robot].all_sensors();
        let meant = match reference.indices.as_slice() {
            [] => self.measuring_named(name, &sensors),
            indices => self.indexed(name, indices, &sensors),
        };
        let meant = meant.filter(|meant| !meant.is_empty())?;
        let follows =
            self.find_sensor(name, &sensors).is_some_and(|sensor| self.program.sensors[sensor].kept.is_some());
        if let (Some(_), true) = (reading, follows) {
            let diagnostic = super::invalid(name.span, format!("what `{}` reads follows from a condition", name.text));
            self.report(diagnostic.help("say what a sensor that it looks at reads, or write `fail` for all of them"));
            return None;
        }
        let ir::Sensor { unit, is_contact, .. } = self.program.sensors[meant[0]].clone();
        let reading = match reading {
            None => ir::FaultReading::Reported,
            Some(ast::FailReading::Any(_)) => ir::FaultReading::StuckSomewhere,
            Some(ast::FailReading::Set(_)) if is_contact => ir::FaultReading::Stuck(1.0),
            Some(ast::FailReading::Clear(_)) if is_contact => ir::FaultReading::Stuck(0.0),
            Some(ast::FailReading::Value(quantity)) if !is_contact => {
                ir::FaultReading::Stuck(self.quantity_in(quantity, &unit)?.to_f64())
            }
            Some(
                ast::FailReading::Absent(span)
                | ast::FailReading::Set(span)
                | ast::FailReading::Clear(span)
                | ast::FailReading::Value(ast::Quantity { span, .. }),
            ) => {
                let reads = if is_contact { "`set`, `clear`" } else { "a quantity" };
                let diagnostic = super::invalid(*span, format!("a faulty sensor reads {reads}, or `any`"));
                self.report(diagnostic.help("write `fail` for a sensor that is known to give nothing"));
                return None;
            }
        };
        let from = window_tree.from.as_ref().map_or(Some(0), |from| self.nanoseconds(from));
        let to = window_tree.to.as_ref().map_or(Some(u64::MAX), |to| self.nanoseconds(to));
        let window = Window { from: from?, to: to? };
        if window.from > window.to {
            let ends = (&window_tree.from, &window_tree.to);
            let span = if let (_, Some(to)) = ends { to.span } else { reference.path.span };
            self.report(empty_range(span));
            return None;
        }
        Some(meant.into_iter().map(|sensor| ir::Fault { sensor, reading, window, span }).collect())
    }

    fn expectations(
        &mut self,
        trees: &[&ast::Expect],
        diagram: Id<ir::Diagram>,
        robot: Id<ir::Robot>,
    ) -> Vec<ir::Expectation> {
        let mut names = Vec::new();
        for tree in trees {
            match &tree.kind {
                ast::ExpectKind::Within { condition, .. }
                | ast::ExpectKind::Never { condition, .. }
                | ast::ExpectKind::Always { condition, .. } => collect_names(condition, &mut names),
                ast::ExpectKind::Modes(_) | ast::ExpectKind::Transition { .. } => {}
            }
        }
        self.take_in_later(diagram, &names);
        let sensors = self.program.robots[robot].all_sensors();
        let scene = self.watched_scene(diagram, sensors);
        let place = |id: Id<ir::Mode>| (id, scene.mode_places[id.index()]);
        let modes: Modes<'_> = scene.modes.iter().map(|(name, &id)| (name.as_str(), place(id))).collect();
        trees.iter().filter_map(|tree| self.expectation(tree, &scene, &modes)).collect()
    }

    fn expectation(&mut self, tree: &ast::Expect, scene: &Scene, modes: &Modes<'_>) -> Option<ir::Expectation> {
        let kind = match &tree.kind {
            ast::ExpectKind::Modes(names) => {
                let found: Vec<_> = names.iter().map(|name| self.mode_named(name, modes)).collect();
                ir::ExpectationKind::Modes(found.into_iter().collect::<Option<_>>()?)
            }
            ast::ExpectKind::Transition { from, to, within } => {
                let (from, to) = (self.mode_named(from, modes), self.mode_named(to, modes));
                let window = self.range_window(within.as_ref());
                ir::ExpectationKind::Transition { from: from?, to: to?, window: window? }
            }
            ast::ExpectKind::Within { condition, window } => {
                let condition = self.condition(condition, scene);
                ir::ExpectationKind::Within(condition, self.range_window(window.as_ref())?)
            }
            ast::ExpectKind::Never { condition, window } => {
                let condition = self.condition(condition, scene);
                ir::ExpectationKind::Never(condition, self.window(window)?)
            }
            ast::ExpectKind::Always { condition, window } => {
                let condition = self.condition(condition, scene);
                ir::ExpectationKind::Always(condition, self.window(window)?)
            }
        };
        let text = self.on_one_line(tree.span).trim_start_matches("expect ").to_owned();
        Some(ir::Expectation { text, kind, span: tree.span })
    }

    fn range_window(&mut self, range: Option<&ast::Range>) -> Option<Window> {
        let Some(range) = range else { return Some(Window::WHOLE) };
        let (from, to) = (self.nanoseconds(&range.low), self.nanoseconds(&range.high));
        let window = Window { from: from?, to: to? };
        if window.from >= window.to {
            self.report(empty_range(range.span));
            return None;
        }
        Some(window)
    }

    fn window(&mut self, window: &ast::ExpectWindow) -> Option<Window> {
        match window {
            ast::ExpectWindow::Whole => Some(Window::WHOLE),
            ast::ExpectWindow::Before(time) => {
                let time = self.positive_nanoseconds(time, "the time after `before`")?;
                Some(Window { from: 0, to: time - 1 })
            }
            ast::ExpectWindow::After(time) => Some(Window { from: self.nanoseconds(time)?, to: u64::MAX }),
            ast::ExpectWindow::Within(range) => self.range_window(Some(range)),
        }
    }
}

fn is_error(item: &ast::ScenarioItem) -> bool {
    matches!(item, ast::ScenarioItem::Error(_))
}
