//! Conditions: what they may name, and what they mean.

use std::collections::HashMap;

use super::{Lower, invalid, not_supported};
use crate::base::{Dimension, Exact, Id, Span, Unit};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Comparison, Expr, Op, Type};
use crate::syntax::ast;

/// What conditions can look at beside what is named: each function with what it takes.
pub const FUNCTIONS: &[(&str, &[&str])] = &[
    ("failed", &["sensor"]),
    ("rising", &["condition"]),
    ("falling", &["condition"]),
    ("held", &["condition", "time"]),
    ("latched", &["condition"]),
    ("count", &["condition"]),
];

/// What a condition can name.
#[derive(Default)]
pub(super) struct Scene {
    pub(super) sensors: Vec<Id<ir::Sensor>>,
    /// The sensed networks by name.
    pub(super) senses: HashMap<String, u32>,
    /// The events of all sensed networks by name; several where networks share a name.
    pub(super) events: HashMap<String, Vec<(u32, u32)>>,
    /// The outputs of all sensed networks by name, in the same way.
    pub(super) outputs: HashMap<String, Vec<(u32, u32)>>,
    /// The inputs of all sensed networks: the name, the sense, the sensor, the variable.
    pub(super) inputs: Vec<(String, u32, Id<ir::Sensor>, Id<ir::Variable>)>,
    /// What the robot's sensors `state` and `command` can be, by number; empty for a robot without a drive.
    pub(super) states: Vec<String>,
    pub(super) commands: Vec<String>,
    /// The named flags; `None` for one that is broken and was reported.
    pub(super) flags: HashMap<String, Option<Id<ir::Flag>>>,
    /// The network of each sense, for what it has besides events.
    pub(super) sense_networks: Vec<Id<ir::Network>>,
    /// Where each sense, each flag and each mode is declared.
    pub(super) sense_places: Vec<Span>,
    pub(super) flag_places: Vec<Span>,
    pub(super) mode_places: Vec<Span>,
    /// The modes, where a condition may name them.
    pub(super) modes: HashMap<String, Id<ir::Mode>>,
    /// The modes that run a diagram, with what they run where that is not broken.
    pub(super) runs: HashMap<String, (Id<ir::Mode>, Option<Id<ir::Diagram>>)>,
    /// The interface the behavior is written on, if it is one.
    pub(super) interface: Option<String>,
    /// Whether some sensed network is broken: then a name that is not known may be one of its events.
    pub(super) incomplete: bool,
    /// Whether something that feeds a sensed network is broken: then a name that is not known may be one of its inputs.
    pub(super) unfed: bool,
    /// Whether the actions of the mode can report completion; `None` outside of a mode.
    pub(super) reports_done: Option<bool>,
}

impl Scene {
    pub(super) fn names(&self) -> impl Iterator<Item = &str> + Clone {
        self.events.keys().chain(self.flags.keys()).chain(self.modes.keys()).map(String::as_str)
    }
}

fn of_interface(interface: &str) -> String {
    format!("a behavior on an interface reads the sensors that `{interface}` lists, whatever else a robot has")
}

/// What a simple name can mean.
#[derive(Clone, Copy)]
enum Meaning {
    Flag,
    /// An event of the network that is sensed in this place.
    Event(u32),
    Sensor,
    Mode,
}

/// An operand of a comparison: a literal waits for the other side to know its unit.
enum Operand<'e> {
    Literal(&'e ast::Quantity),
    Value(Id<Expr>),
}

impl Lower<'_> {
    /// What is said of a diagram from outside: it may also name the modes.
    pub(super) fn watched_scene(&self, id: Id<ir::Diagram>, sensors: Vec<Id<ir::Sensor>>) -> Scene {
        let diagram = &self.program.diagrams[id];
        let (states, commands) = self.doings(diagram.platform);
        let incomplete = self.poison.diagrams.contains(&id);
        let mut scene = Scene { sensors, states, commands, incomplete, ..Scene::default() };
        for name in self.poison.flags.get(&id).into_iter().flatten() {
            scene.flags.insert(name.clone(), None);
        }
        for (id, mode) in diagram.modes.iter() {
            scene.modes.insert(mode.symbol.name.clone(), id);
            scene.mode_places.push(mode.symbol.span);
            scene.runs.extend(mode.runs.map(|run| (mode.symbol.name.clone(), (id, Some(run.diagram)))));
        }
        for (id, flag) in diagram.flags.iter() {
            scene.flag_places.push(flag.symbol.span);
            let is_it = |sensor: &Id<ir::Sensor>| self.program.sensors[*sensor].symbol.span == flag.symbol.span;
            if !scene.sensors.iter().any(is_it) {
                scene.flags.insert(flag.symbol.name.clone(), Some(id));
            }
        }
        for (position, sense) in diagram.senses.iter().enumerate() {
            if self.is_taken_in(diagram.platform, sense) {
                continue;
            }
            scene.senses.insert(sense.symbol.name.clone(), position as u32);
            scene.sense_places.push(sense.symbol.span);
            scene.sense_networks.push(sense.network);
            scene.inputs.extend(self.scene_inputs(position as u32, sense));
            scene.unfed |= sense.inputs.len() < self.program.networks[sense.network].inputs.len();
            for (event, declared) in self.program.networks[sense.network].events.iter().enumerate() {
                let place = (position as u32, event as u32);
                scene.events.entry(declared.symbol.name.clone()).or_default().push(place);
            }
        }
        scene
    }

    /// The states of a robot with a drive, and its commands with `nothing` in front.
    pub(super) fn doings(&self, platform: ir::Platform) -> (Vec<String>, Vec<String>) {
        let ir::Platform::Robot(robot) = platform else { return Default::default() };
        let robot = &self.program.robots[robot];
        let Some(drive) = &robot.drive else { return Default::default() };
        let actions = robot.actions.iter().map(|&id| self.program.actions[id].symbol.name.clone());
        (drive.states.clone(), std::iter::once("nothing".to_owned()).chain(actions).collect())
    }

    /// The inputs of a sensed network as conditions name them.
    pub(super) fn scene_inputs(
        &self,
        position: u32,
        sense: &ir::Sense,
    ) -> Vec<(String, u32, Id<ir::Sensor>, Id<ir::Variable>)> {
        let inputs = self.program.networks[sense.network].inputs.iter().zip(&sense.inputs);
        inputs.map(|(input, &sensor)| (input.symbol.name.clone(), position, sensor, input.variable)).collect()
    }

    /// A condition; poison where it is broken, which was reported.
    pub(super) fn condition(&mut self, tree: &ast::Expr, scene: &Scene) -> Id<Expr> {
        let id = self.expr(tree, scene);
        match self.program.exprs[id].ty {
            Type::Bool | Type::Error => id,
            Type::Quantity(_) => {
                self.report(not_a_condition(tree.span, &self.program, &self.program.exprs[id].op));
                self.poisoned(tree.span)
            }
        }
    }

    fn poisoned(&mut self, span: Span) -> Id<Expr> {
        self.program.exprs.add(Expr { op: Op::Error, ty: Type::Error, span })
    }

    pub(super) fn truth(&mut self, op: Op, span: Span) -> Id<Expr> {
        self.program.exprs.add(Expr { op, ty: Type::Bool, span })
    }

    fn expr(&mut self, tree: &ast::Expr, scene: &Scene) -> Id<Expr> {
        let span = tree.span;
        let op = match &tree.kind {
            ast::ExprKind::Path(path) => return self.path(path, scene),
            ast::ExprKind::Not(operand) => Some(Op::Not(self.condition(operand, scene))),
            ast::ExprKind::And(operands) => Some(Op::And(self.conditions(operands, scene))),
            ast::ExprKind::Or(operands) => Some(Op::Or(self.conditions(operands, scene))),
            ast::ExprKind::Compare(op, left, right) => self.compare(*op, left, right, span, scene),
            ast::ExprKind::After(duration) => self.nanoseconds(duration).map(Op::After),
            ast::ExprKind::Done => {
                if scene.reports_done == Some(false) {
                    self.report(done_never_reported(span));
                }
                Some(Op::Done)
            }
            ast::ExprKind::Call(call) => return self.history(call, scene),
            ast::ExprKind::Quantity(quantity) => {
                let message = "this is a quantity, not a condition";
                let written = self.sources.slice(span);
                let help = (self.quantity(quantity).is_some_and(|found| found.dimension == Dimension::TIME))
                    .then(|| format!("write `after {written}` for the time since the mode was entered"));
                self.report(Diagnostic::new(&diag::rules::NOT_A_CONDITION, span, message).help_maybe(help));
                None
            }
            ast::ExprKind::Index(path, indices) => {
                return match self.one_indexed(path, indices, span, &scene.sensors) {
                    Some(sensor) => self.reading(sensor, span, scene),
                    None => self.poisoned(span),
                };
            }
            ast::ExprKind::Is(subject, terms) => self.is_term(subject, terms, span, scene),
            ast::ExprKind::Negate(_) | ast::ExprKind::Sum(_) | ast::ExprKind::Product(_) => {
                self.later(span, "arithmetic in a condition")
            }
        };
        match op {
            Some(op) => self.truth(op, span),
            None => self.poisoned(span),
        }
    }

    fn later(&mut self, span: Span, what: &str) -> Option<Op> {
        self.report(not_supported(span, what));
        None
    }

    fn conditions(&mut self, trees: &[ast::Expr], scene: &Scene) -> Vec<Id<Expr>> {
        trees.iter().map(|tree| self.condition(tree, scene)).collect()
    }

    fn path(&mut self, path: &ast::Path, scene: &Scene) -> Id<Expr> {
        if let [first, _] = path.segments.as_slice()
            && let Some(sensor) = self.argument_told(path, &scene.sensors)
        {
            self.reads(first, sensor);
            return self.reading(sensor, path.span, scene);
        }
        let op = match path.segments.as_slice() {
            [name] => self.simple_name(name, scene),
            [sense, event] => self.qualified_name(sense, event, scene),
            _ => {
                let message = "no flag or sensor has a name of this form";
                self.report(Diagnostic::new(&diag::rules::UNKNOWN_NAME, path.span, message));
                None
            }
        };
        match op {
            Some(Op::Sensor(sensor)) => self.reading(sensor, path.span, scene),
            Some(op) => self.truth(op, path.span),
            None => self.poisoned(path.span),
        }
    }

    /// What a sensor reads; of a contact, whether it is set.
    fn reading(&mut self, sensor: Id<ir::Sensor>, span: Span, scene: &Scene) -> Id<Expr> {
        let ir::Sensor { symbol, unit, is_contact, .. } = &self.program.sensors[sensor];
        // A contact of the robot's own condition stands among the flags of what is written on the robot.
        if let Some(flag) = scene.flag_places.iter().position(|place| *place == symbol.span) {
            return self.truth(Op::Flag(Id::new(flag as u32)), span);
        }
        let (ty, is_contact) = (Type::Quantity(unit.dimension), *is_contact);
        let reading = self.program.exprs.add(Expr { op: Op::Sensor(sensor), ty, span });
        if !is_contact {
            return reading;
        }
        let half = self.program.exprs.add(Expr { op: Op::Number(Exact::new(1, 2, 0)), ty, span });
        self.truth(Op::Compare(Comparison::Greater, reading, half), span)
    }

    /// A flag, an event, a sensor or a mode; reports a name that is none of them, or more than one.
    fn simple_name(&mut self, name: &ast::Name, scene: &Scene) -> Option<Op> {
        let mut found = Vec::new();
        if let Some(flag) = scene.flags.get(&name.text) {
            found.push((Meaning::Flag, Op::Flag((*flag)?)));
        }
        for &(sense, event) in scene.events.get(&name.text).into_iter().flatten() {
            found.push((Meaning::Event(sense), Op::Event { sense, event }));
        }
        if let Some(sensor) = self.find_sensor(name, &scene.sensors) {
            if self.poison.sensors.contains(&sensor) {
                return None;
            }
            found.push((Meaning::Sensor, Op::Sensor(sensor)));
        }
        if let Some(&mode) = scene.modes.get(&name.text) {
            found.push((Meaning::Mode, Op::InMode(mode)));
        }
        if found.len() > 1 {
            let meanings: Vec<_> = found.iter().map(|(meaning, _)| *meaning).collect();
            self.report(ambiguous(name, &meanings, scene));
            return None;
        }
        if found.is_empty() && !self.program.elements(&name.text, &scene.sensors).is_empty() {
            self.sensor_named(name, &scene.sensors);
            return None;
        }
        if found.is_empty() && !scene.incomplete {
            let sensors = self.sensor_names(&scene.sensors);
            let known = scene.names().chain(sensors.iter().map(String::as_str));
            let diagnostic = self.unknown(name, "flag, event or sensor", known);
            let elsewhere = self.event_elsewhere(name).or_else(|| scene.interface.as_deref().map(of_interface));
            let is_near = diagnostic.help.as_ref().is_some_and(|help| help.starts_with("did"));
            self.report(if is_near { diagnostic } else { diagnostic.help_maybe(elsewhere) });
        }
        let op = found.pop().map(|(_, op)| op)?;
        self.note_read(name.span, &op, scene);
        Some(op)
    }

    /// Notes that a name reads something.
    fn note_read(&mut self, name: Span, op: &Op, scene: &Scene) {
        let declared = match op {
            Op::Flag(flag) => scene.flag_places.get(flag.index()).copied(),
            Op::Event { sense, event } => {
                self.read.extend(scene.sense_places.get(*sense as usize));
                let network = scene.sense_networks.get(*sense as usize).map(|&network| &self.program.networks[network]);
                network.and_then(|network| network.events.get(*event as usize)).map(|event| event.symbol.span)
            }
            Op::Sensor(sensor) => {
                let sensor = &self.program.sensors[*sensor];
                (!sensor.is_inner()).then_some(sensor.symbol.span)
            }
            Op::InMode(mode) => scene.mode_places.get(mode.index()).copied(),
            _ => None,
        };
        if let Some(declared) = declared {
            self.read.insert(declared);
            self.refers(name, declared);
        }
    }

    /// Where a network has an event of that name that the behavior does not sense.
    fn event_elsewhere(&self, name: &ast::Name) -> Option<String> {
        let has = |network: &&ir::Network| network.events.iter().any(|event| event.symbol.name == name.text);
        let network = self.program.networks.values().find(has)?;
        let (event, network) = (&name.text, &network.symbol.name);
        Some(format!("`{event}` is an event of the network `{network}`; write `sense {network}(...)` in the behavior"))
    }

    fn qualified_name(&mut self, sense: &ast::Name, event: &ast::Name, scene: &Scene) -> Option<Op> {
        let Some(&position) = scene.senses.get(&sense.text) else {
            if !scene.incomplete {
                self.report(self.unknown(sense, "sensed network", scene.senses.keys().map(String::as_str)));
            }
            return None;
        };
        self.refers(sense.span, scene.sense_places[position as usize]);
        let found = scene.events.get(&event.text).into_iter().flatten().find(|(sense, _)| *sense == position);
        if found.is_none() {
            let known = scene.events.iter().filter(|(_, of)| of.iter().any(|(sense, _)| *sense == position));
            let what = format!("event of `{}`", sense.text);
            self.report(self.unknown(event, &what, known.map(|(name, _)| name.as_str())));
        }
        let op = found.map(|&(sense, event)| Op::Event { sense, event })?;
        self.note_read(event.span, &op, scene);
        Some(op)
    }

    /// `failed`, `rising`, `falling`, `held`, `latched` and `count`.
    fn history(&mut self, call: &ast::Call, scene: &Scene) -> Id<Expr> {
        let function = call.path.segments.first().map_or("", |name| name.text.as_str());
        let known = FUNCTIONS.iter().find(|(known, _)| *known == function && call.path.segments.len() == 1);
        let Some(count) = known.map(|(_, parameters)| parameters.len()) else {
            let help = diag::did_you_mean(function, FUNCTIONS.iter().map(|(known, _)| *known));
            let message = format!("conditions have no function `{function}`");
            self.report(Diagnostic::new(&diag::rules::UNKNOWN_NAME, call.path.span, message).help_maybe(help));
            return self.poisoned(call.span);
        };
        if call.arguments.len() != count || call.arguments.iter().any(|argument| argument.name.is_some()) {
            let form = if count == 2 { "held(flag, 200 ms)".to_owned() } else { format!("{function}(...)") };
            let message = format!("`{function}` takes {count} plain argument{}", if count == 1 { "" } else { "s" });
            let diagnostic = Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, call.span, message);
            self.report(diagnostic.help(format!("write `{form}`")));
            return self.poisoned(call.span);
        }
        let arguments: Vec<_> = call.arguments.iter().map(|argument| &argument.value).collect();
        let op = match (function, arguments.as_slice()) {
            ("failed", [sensor]) => self.failed(sensor, call.span, scene),
            ("held", [of, duration]) => {
                let of = self.condition(of, scene);
                self.duration_argument(duration).map(|duration| Op::Held(of, duration))
            }
            ("rising", [of]) => Some(Op::Rising(self.condition(of, scene))),
            ("falling", [of]) => Some(Op::Falling(self.condition(of, scene))),
            ("latched", [of]) => Some(Op::Latched(self.condition(of, scene))),
            ("count", [of]) => Some(Op::Count(self.condition(of, scene))),
            _ => None,
        };
        match op {
            Some(op @ Op::Count(_)) => {
                let ty = Type::Quantity(Dimension::NONE);
                self.program.exprs.add(Expr { op, ty, span: call.span })
            }
            Some(op) => self.truth(op, call.span),
            None => self.poisoned(call.span),
        }
    }

    /// Whether a sensor has failed: of several, whether one of them has.
    fn failed(&mut self, tree: &ast::Expr, span: Span, scene: &Scene) -> Option<Op> {
        if let ast::ExprKind::Path(path) = &tree.kind
            && let [name] = path.segments.as_slice()
            && self.find_sensor(name, &scene.sensors).is_none()
            && (scene.flags.contains_key(&name.text) || scene.events.contains_key(&name.text))
        {
            let message = format!("`{}` is a flag, not a sensor", name.text);
            self.report(Diagnostic::new(&diag::rules::WRONG_KIND, name.span, message));
            return None;
        }
        if !matches!(tree.kind, ast::ExprKind::Path(_) | ast::ExprKind::Index(..)) {
            let message = "`failed` takes the name of a sensor";
            self.report(Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, tree.span, message));
            return None;
        }
        let meant = self.measuring(tree, &scene.sensors)?;
        if let [sensor] = meant.as_slice() {
            return Some(Op::Failed(*sensor));
        }
        Some(Op::Or(meant.into_iter().map(|sensor| self.truth(Op::Failed(sensor), span)).collect()))
    }

    fn duration_argument(&mut self, tree: &ast::Expr) -> Option<u64> {
        if let ast::ExprKind::Quantity(quantity) = &tree.kind {
            return self.nanoseconds(quantity);
        }
        self.report(Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, tree.span, "`held` takes a time, such as `200 ms`"));
        None
    }

    fn compare(
        &mut self,
        op: ast::CompareOp,
        left: &ast::Expr,
        right: &ast::Expr,
        span: Span,
        scene: &Scene,
    ) -> Option<Op> {
        let comparison = match op {
            ast::CompareOp::Less => Comparison::Less,
            ast::CompareOp::LessOrEqual => Comparison::LessOrEqual,
            ast::CompareOp::Greater => Comparison::Greater,
            ast::CompareOp::GreaterOrEqual => Comparison::GreaterOrEqual,
            ast::CompareOp::Equal => Comparison::Equal,
            ast::CompareOp::NotEqual => Comparison::NotEqual,
        };
        let (left, right) = (self.operand(left, scene), self.operand(right, scene));
        let (left, right) = match (left, right) {
            (Operand::Value(left), Operand::Value(right)) => (Some(left), Some(right)),
            (Operand::Value(left), Operand::Literal(right)) => (Some(left), self.literal_beside(right, left)),
            (Operand::Literal(left), Operand::Value(right)) => (self.literal_beside(left, right), Some(right)),
            (Operand::Literal(left), Operand::Literal(right)) => {
                let dimension = self.quantity(left)?.dimension;
                (self.literal(left, dimension, None), self.literal(right, dimension, None))
            }
        };
        let (left, right) = (left?, right?);
        match (self.program.exprs[left].ty, self.program.exprs[right].ty) {
            (Type::Quantity(a), Type::Quantity(b)) if a == b => Some(Op::Compare(comparison, left, right)),
            (Type::Quantity(a), Type::Quantity(b)) => {
                let message = format!("{a} is compared with {b}");
                self.report(Diagnostic::new(&diag::rules::DIMENSION_MISMATCH, span, message));
                None
            }
            (Type::Error, _) | (_, Type::Error) => None,
            (Type::Bool, _) | (_, Type::Bool) => {
                let message = "something true or false is compared as a quantity";
                let diagnostic = Diagnostic::new(&diag::rules::DIMENSION_MISMATCH, span, message);
                self.report(diagnostic.help("write the flag itself, or `not` in front of it"));
                None
            }
        }
    }

    fn operand<'e>(&mut self, tree: &'e ast::Expr, scene: &Scene) -> Operand<'e> {
        match &tree.kind {
            ast::ExprKind::Quantity(quantity) => Operand::Literal(quantity),
            _ => Operand::Value(self.expr(tree, scene)),
        }
    }

    fn literal(&mut self, tree: &ast::Quantity, dimension: Dimension, unit: Option<&Unit>) -> Option<Id<Expr>> {
        let value = self.quantity_of(tree, dimension, unit)?;
        let ty = Type::Quantity(dimension);
        Some(self.program.exprs.add(Expr { op: Op::Number(value), ty, span: tree.span }))
    }

    /// A literal that is compared with something.
    fn literal_beside(&mut self, tree: &ast::Quantity, other: Id<Expr>) -> Option<Id<Expr>> {
        let Expr { op, ty, .. } = self.program.exprs[other].clone();
        let Type::Quantity(dimension) = ty else {
            // Reported as a comparison of the wrong types, or already.
            let ty = Type::Quantity(Dimension::NONE);
            return Some(self.program.exprs.add(Expr { op: Op::Number(Exact::ZERO), ty, span: tree.span }));
        };
        let sensor = match op {
            Op::Sensor(sensor) => Some(self.program.sensors[sensor].clone()),
            _ => None,
        };
        let id = self.literal(tree, dimension, sensor.as_ref().map(|sensor| &sensor.unit))?;
        let Op::Number(value) = self.program.exprs[id].op else { return Some(id) };
        if let Some(sensor) = sensor
            && (value < sensor.range.0 || value > sensor.range.1)
        {
            self.report(outside_range(tree.span, value, &sensor));
        }
        if matches!(op, Op::Count(_)) && value.to_integer().is_none_or(|value| value < 0) {
            let message = format!("a count is a whole number from 0, not {}", tree.number.text);
            self.report(invalid(tree.span, message));
        }
        Some(id)
    }
}

fn ambiguous(name: &ast::Name, meanings: &[Meaning], scene: &Scene) -> Diagnostic {
    let network = |place: u32| {
        let found = scene.senses.iter().find(|(_, known)| **known == place);
        found.map_or("", |(name, _)| name.as_str())
    };
    let shown = meanings.iter().map(|meaning| match meaning {
        Meaning::Flag => "the flag".to_owned(),
        Meaning::Event(sense) => format!("the event of `{}`", network(*sense)),
        Meaning::Sensor => "the sensor".to_owned(),
        Meaning::Mode => "the mode".to_owned(),
    });
    let message = format!("`{}` could mean {}", name.text, shown.collect::<Vec<_>>().join(" or "));
    let qualified = meanings.iter().filter_map(|meaning| match meaning {
        Meaning::Event(sense) => Some(format!("`{}.{}`", network(*sense), name.text)),
        Meaning::Flag | Meaning::Sensor | Meaning::Mode => None,
    });
    let qualified: Vec<_> = qualified.collect();
    let help = match (qualified.len() == meanings.len(), qualified.is_empty()) {
        (true, _) => format!("write {}", qualified.join(" or ")),
        (false, true) => "rename one of them".to_owned(),
        (false, false) => format!("write {} for the event, or rename one of them", qualified.join(" or ")),
    };
    Diagnostic::new(&diag::rules::AMBIGUOUS_NAME, name.span, message).help(help)
}

fn not_a_condition(span: Span, program: &ir::Program, op: &Op) -> Diagnostic {
    let diagnostic = Diagnostic::new(&diag::rules::NOT_A_CONDITION, span, "this is a quantity, not a condition");
    match op {
        Op::Count(_) => diagnostic.help("compare it, as in `count(flag) >= 3`"),
        Op::Sensor(sensor) => {
            let ir::Sensor { symbol, unit, range, .. } = &program.sensors[*sensor];
            let middle = unit.show(f64::midpoint(range.0.to_f64(), range.1.to_f64()));
            diagnostic.help(format!("compare it, as in `{} > {middle}`", symbol.name))
        }
        _ => diagnostic,
    }
}

fn done_never_reported(span: Span) -> Diagnostic {
    Diagnostic::new(&diag::rules::DONE_NEVER_REPORTED, span, "no action of this mode reports completion")
        .note("`done` holds when an action declared with `-> done` has completed")
        .help("call such an action in the mode, or leave it with `after`")
}

fn outside_range(span: Span, value: Exact, sensor: &ir::Sensor) -> Diagnostic {
    let shown = |value: Exact| sensor.unit.show(value.to_f64());
    let message = format!("{} lies outside the range of `{}`", shown(value), sensor.symbol.name);
    Diagnostic::new(&diag::rules::OUTSIDE_RANGE, span, message)
        .label(sensor.symbol.span, format!("its range is {} .. {}", shown(sensor.range.0), shown(sensor.range.1)))
        .note("readings are clamped to their range, so this comparison never changes")
}
