//! Sensors: what they measure, arrays of them, and what names of them stand for.

use super::fusion::missing_range;
use super::quantities::mismatch;
use super::robots::{join, unknown_path};
use super::{Lower, invalid, named, symbol};
use crate::base::{Dimension, Exact, Id, Span, Unit};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, SensorSource};
use crate::syntax::ast;

/// The places where a body can be measured, and what each gives; `None` for a contact.
const SOURCES: &[(&str, SensorSource, Option<Dimension>)] = &[
    ("wheel.left.acceleration", SensorSource::LeftWheelAcceleration, Some(Dimension::ACCELERATION)),
    ("wheel.right.acceleration", SensorSource::RightWheelAcceleration, Some(Dimension::ACCELERATION)),
    ("wheel.left.speed", SensorSource::LeftWheelSpeed, Some(Dimension::SPEED)),
    ("wheel.right.speed", SensorSource::RightWheelSpeed, Some(Dimension::SPEED)),
    ("wedge.force", SensorSource::WedgeForce, Some(Dimension::FORCE)),
    ("ring.range", SensorSource::Range { beam: 0, of: 1 }, Some(Dimension::LENGTH)),
    ("bumper.front", SensorSource::FrontBumper, None),
    ("bumper.back", SensorSource::BackBumper, None),
    ("pose.x", SensorSource::X, Some(Dimension::LENGTH)),
    ("pose.y", SensorSource::Y, Some(Dimension::LENGTH)),
    ("pose.heading", SensorSource::Heading, Some(Dimension::ANGLE)),
    ("planner.distance", SensorSource::WaypointDistance, Some(Dimension::LENGTH)),
    ("planner.bearing", SensorSource::WaypointBearing, Some(Dimension::ANGLE)),
    ("goal.distance", SensorSource::GoalDistance, Some(Dimension::LENGTH)),
    ("goal.bearing", SensorSource::GoalBearing, Some(Dimension::ANGLE)),
];

/// The most sensors of an array.
const MOST_ELEMENTS: u64 = 1000;

/// What is known of a sensor before its clauses are read.
pub(super) fn plain(symbol: ir::Symbol, optional: bool, unit: Unit, range: (Exact, Exact)) -> ir::Sensor {
    ir::Sensor {
        symbol,
        optional,
        unit,
        is_contact: false,
        group: None,
        kept: None,
        range,
        fails: Vec::new(),
        source: None,
        noise: 0.0,
        accuracy: Exact::ZERO,
        period: 0,
        beam: 0.0,
    }
}

/// What `command.name` can tell, in SI: more than any command asks for, and few enough digits to be kept exactly.
const MOST_ARGUMENT: i128 = 1_000_000;

/// The sensors by which everything on a robot sees who commands it, and what it is doing.
pub(super) fn told(runs: Span, states: usize, commands: usize, parameters: &[ir::Parameter]) -> Vec<ir::Sensor> {
    let inner = |name: String, unit: Unit, range: (i128, i128), source: SensorSource| {
        let symbol = ir::Symbol { name, span: runs, doc: String::new() };
        let range = (Exact::new(range.0, 1, 0), Exact::new(range.1, 1, 0));
        ir::Sensor { source: Some(source), ..plain(symbol, true, unit, range) }
    };
    let contact =
        |name: &str, source| ir::Sensor { is_contact: true, ..inner(name.to_owned(), Unit::contact(), (0, 1), source) };
    let number = |name: &str, most: usize, source| inner(name.to_owned(), Unit::one(), (0, most as i128), source);
    let arguments = parameters.iter().zip(0..).map(|(parameter, number)| {
        let range = (-MOST_ARGUMENT, MOST_ARGUMENT);
        let name = format!("command.{}", parameter.symbol.name);
        inner(name, parameter.unit.clone(), range, SensorSource::Argument(number))
    });
    let told = [
        contact("won", SensorSource::Won),
        contact("lost", SensorSource::Lost),
        number("state", states.saturating_sub(1), SensorSource::State),
        number("command", commands, SensorSource::Command),
    ];
    told.into_iter().chain(arguments).collect()
}

impl Lower<'_> {
    /// Adds a sensor, or the elements of an array; a broken one as poison, so that what names it is not reported too.
    pub(super) fn sensors(&mut self, tree: &ast::Sensor) -> Vec<Id<ir::Sensor>> {
        let count = match &tree.count {
            Some(count) => self.whole(count, 1, "the number of sensors").filter(|&of| {
                if of > MOST_ELEMENTS {
                    self.report(invalid(count.span, format!("an array has at most {MOST_ELEMENTS} sensors")));
                }
                of <= MOST_ELEMENTS
            }),
            None => Some(1),
        };
        let (Some(sensor), Some(of)) = (self.sensor(tree), count) else { return vec![self.broken_sensor(&tree.name)] };
        if tree.count.is_none() {
            return vec![self.program.sensors.add(sensor)];
        }
        let element = |beam: u32| {
            let mut element = sensor.clone();
            element.symbol.name = element_name(&tree.name.text, beam);
            if let Some(SensorSource::Range { .. }) = element.source {
                element.source = Some(SensorSource::Range { beam, of: of as u32 });
            }
            element
        };
        (0..of as u32).map(|beam| self.program.sensors.add(element(beam))).collect()
    }

    pub(super) fn broken_sensor(&mut self, name: &ast::Name) -> Id<ir::Sensor> {
        let id = self.program.sensors.add(plain(symbol(name, None), true, Unit::one(), (Exact::ZERO, Exact::ONE)));
        self.poison.sensors.insert(id);
        id
    }

    fn sensor(&mut self, tree: &ast::Sensor) -> Option<ir::Sensor> {
        let symbol = symbol(&tree.name, tree.doc.as_ref());
        let mut sensor = match &tree.kind {
            ast::SensorKind::Contact(_) => {
                let sensor = plain(symbol, tree.optional, Unit::contact(), (Exact::ZERO, Exact::ONE));
                ir::Sensor { is_contact: true, ..sensor }
            }
            ast::SensorKind::Quantity { unit, range } => {
                let unit = self.unit(unit)?;
                let Some(range) = range else {
                    self.report(missing_range(&tree.name, "sensor", &unit));
                    return None;
                };
                let range = self.range_in(range, &unit)?;
                plain(symbol, tree.optional, unit, range)
            }
        };
        let unit = sensor.unit.clone();
        for clause in &tree.clauses {
            match clause {
                ast::SensorClause::Fails(readings) if sensor.is_contact => {
                    sensor.fails.extend(readings.iter().filter_map(|reading| self.contact_fails(reading)));
                }
                ast::SensorClause::Fails(readings) => {
                    sensor.fails.extend(self.fail_readings(readings, &unit, sensor.range));
                }
                ast::SensorClause::Source(path) => sensor.source = self.source(path, &sensor),
                ast::SensorClause::Period(period) => sensor.period = self.nanoseconds(period)?,
                ast::SensorClause::Beam(beam) => sensor.beam = self.beam(beam)?,
                ast::SensorClause::Noise(of) | ast::SensorClause::Accuracy(of) if sensor.is_contact => {
                    self.report(invalid(of.span, "a contact is set or clear, nothing between"));
                }
                ast::SensorClause::Noise(noise) => sensor.noise = self.spread(noise, &unit, "noise")?.to_f64(),
                ast::SensorClause::Accuracy(accuracy) => sensor.accuracy = self.spread(accuracy, &unit, "accuracy")?,
            }
        }
        Some(sensor)
    }

    fn contact_fails(&mut self, tree: &ast::FailReading) -> Option<ir::FailReading> {
        match tree {
            ast::FailReading::Set(_) => Some(ir::FailReading::Value(Exact::ONE)),
            ast::FailReading::Clear(_) => Some(ir::FailReading::Value(Exact::ZERO)),
            ast::FailReading::Any(_) => Some(ir::FailReading::Any),
            ast::FailReading::Absent(span) | ast::FailReading::Value(ast::Quantity { span, .. }) => {
                self.report(invalid(*span, "a contact fails `set`, `clear` or `any`"));
                None
            }
        }
    }

    fn spread(&mut self, quantity: &ast::Quantity, unit: &Unit, what: &str) -> Option<Exact> {
        let value = self.quantity_in(quantity, unit)?;
        if value < Exact::ZERO {
            self.report(invalid(quantity.span, format!("{what} cannot be negative")));
            return None;
        }
        Some(value)
    }

    /// The width of a beam, below half a turn.
    fn beam(&mut self, tree: &ast::Quantity) -> Option<f64> {
        let value = self.quantity_of(tree, Dimension::ANGLE, None)?;
        let half_turn = Exact::new(1, 1, 1);
        if value < Exact::ZERO || value >= half_turn {
            self.report(invalid(tree.span, "a beam is from 0 to less than 180 deg wide"));
            return None;
        }
        Some(value.to_f64())
    }

    fn source(&mut self, path: &ast::Path, sensor: &ir::Sensor) -> Option<SensorSource> {
        let name = join(path);
        let Some(&(_, source, measures)) = SOURCES.iter().find(|(known, ..)| *known == name) else {
            self.report(unknown_path(path, &name, "a body measures no", SOURCES.iter().map(|(known, ..)| *known)));
            return None;
        };
        match (measures, sensor.is_contact) {
            (None, false) => self.report(
                invalid(path.span, format!("`{name}` is a contact, not a quantity"))
                    .help(format!("write `sensor {}: contact`", sensor.symbol.name)),
            ),
            (Some(_), true) => {
                self.report(invalid(path.span, format!("`{name}` is a quantity, not a contact")));
            }
            (Some(dimension), false) if dimension != sensor.unit.dimension => {
                self.report(mismatch(path.span, dimension, sensor.unit.dimension));
            }
            _ => return Some(source),
        }
        None
    }

    /// The sensors that measure what a name stands for: one, those of an array, those of a logical sensor. Reports a name
    /// that stands for none; `None` then, and where the sensor is broken.
    pub(super) fn measuring_named(
        &mut self,
        name: &ast::Name,
        sensors: &[Id<ir::Sensor>],
    ) -> Option<Vec<Id<ir::Sensor>>> {
        if let Some(&first) = self.program.elements(&name.text, sensors).first() {
            self.reads(name, first);
        } else {
            let sensor = self.sensor_named(name, sensors)?;
            if self.program.sensors[sensor].is_inner() {
                let diagnostic =
                    invalid(name.span, format!("`{}` tells of the robot itself, and cannot fail", name.text));
                self.report(diagnostic.note("only what measures something can fail, be required or be grouped"));
                return None;
            }
        }
        Some(self.program.measuring_named(&name.text, sensors))
    }

    /// The same for an expression, which may also name some elements of an array.
    pub(super) fn measuring(&mut self, tree: &ast::Expr, sensors: &[Id<ir::Sensor>]) -> Option<Vec<Id<ir::Sensor>>> {
        match &tree.kind {
            ast::ExprKind::Path(ast::Path { segments, .. }) if segments.len() == 1 => {
                self.measuring_named(segments.first()?, sensors)
            }
            ast::ExprKind::Index(path, indices) if path.segments.len() == 1 => {
                self.indexed(path.segments.first()?, indices, sensors)
            }
            _ => {
                self.report(invalid(tree.span, "this names no sensor"));
                None
            }
        }
    }

    /// The elements of an array that indices name.
    pub(super) fn indexed(
        &mut self,
        name: &ast::Name,
        indices: &[ast::IndexRange],
        sensors: &[Id<ir::Sensor>],
    ) -> Option<Vec<Id<ir::Sensor>>> {
        let elements = self.program.elements(&name.text, sensors);
        let Some(&first) = elements.first() else {
            let sensor = self.sensor_named(name, sensors)?;
            let declared = self.program.sensors[sensor].symbol.span;
            let message = format!("`{}` is one sensor, not an array", name.text);
            self.report(invalid(name.span, message).label(declared, "declared here").help("leave the index out"));
            return None;
        };
        self.reads(name, first);
        let mut meant = Vec::new();
        for range in indices {
            let ends = [Some(&range.first), range.last.as_ref()];
            let mut places = Vec::new();
            for number in ends.into_iter().flatten() {
                let place = self.whole(number, 0, "an index")?;
                if place >= elements.len() as u64 {
                    let message = format!("`{}` has no element {}", name.text, number.text);
                    let known = format!("its elements are 0 to {}", elements.len() - 1);
                    self.report(Diagnostic::new(&diag::rules::UNKNOWN_NAME, number.span, message).help(known));
                    return None;
                }
                places.push(place as usize);
            }
            let (from, to) = (*places.first()?, *places.last()?);
            if from > to {
                let span = range.first.span.to(range.last.as_ref().map_or(range.first.span, |last| last.span));
                let help = format!("write `{from}..{}, 0..{to}` to go around", elements.len() - 1);
                self.report(invalid(span, "this range of indices goes down").help(help));
                return None;
            }
            meant.extend_from_slice(&elements[from..=to]);
        }
        Some(meant)
    }

    /// The one sensor that a name with indices means.
    pub(super) fn one_indexed(
        &mut self,
        path: &ast::Path,
        indices: &[ast::IndexRange],
        span: Span,
        sensors: &[Id<ir::Sensor>],
    ) -> Option<Id<ir::Sensor>> {
        let [name] = path.segments.as_slice() else {
            self.report(invalid(path.span, "this names no sensor"));
            return None;
        };
        let meant = self.indexed(name, indices, sensors)?;
        if let [one] = meant.as_slice() {
            return Some(*one);
        }
        self.report(several(span, &name.text, self.sources.slice(span)));
        None
    }

    /// The sensor of a name with dots, `command.distance`.
    pub(super) fn argument_told(&self, path: &ast::Path, sensors: &[Id<ir::Sensor>]) -> Option<Id<ir::Sensor>> {
        named(&join(path), sensors, |id| &self.program.sensors[id].symbol)
    }

    /// Notes that a name reads a sensor.
    pub(super) fn reads(&mut self, name: &ast::Name, sensor: Id<ir::Sensor>) {
        let sensor = &self.program.sensors[sensor];
        // What tells of the robot itself is declared nowhere.
        if !sensor.is_inner() {
            let declared = sensor.symbol.span;
            self.read.insert(declared);
            self.refers(name.span, declared);
        }
    }

    /// The sensor of that name, without a report.
    pub(super) fn find_sensor(&self, name: &ast::Name, sensors: &[Id<ir::Sensor>]) -> Option<Id<ir::Sensor>> {
        named(&name.text, sensors, |id| &self.program.sensors[id].symbol)
    }

    /// The sensor of that name; reports one that does not exist, and an array. `None` also for one that is broken.
    pub(super) fn sensor_named(&mut self, name: &ast::Name, sensors: &[Id<ir::Sensor>]) -> Option<Id<ir::Sensor>> {
        let found = self.find_sensor(name, sensors);
        match (found, self.program.elements(&name.text, sensors).first()) {
            (Some(sensor), _) => self.reads(name, sensor),
            (None, Some(&first)) => {
                self.reads(name, first);
                self.report(several(name.span, &name.text, &name.text));
            }
            (None, None) => {
                let diagnostic = self.unknown(name, "sensor", self.sensor_names(sensors).iter().map(String::as_str));
                self.report(diagnostic);
            }
        }
        found.filter(|sensor| !self.poison.sensors.contains(sensor))
    }

    /// The names of sensors as they are declared, an array's once.
    pub(super) fn sensor_names(&self, sensors: &[Id<ir::Sensor>]) -> Vec<String> {
        let names = sensors.iter().map(|&id| &self.program.sensors[id].symbol.name);
        let mut names: Vec<_> = names.map(|name| declared_name(name).to_owned()).collect();
        names.dedup();
        names
    }
}

fn element_name(array: &str, index: u32) -> String {
    format!("{array}[{index}]")
}

/// The name under which a sensor is declared: of an element that of its array.
pub(super) fn declared_name(sensor: &str) -> &str {
    sensor.split('[').next().unwrap_or(sensor)
}

pub(super) fn several(span: Span, array: &str, written: &str) -> Diagnostic {
    invalid(span, format!("`{written}` means several sensors")).help(format!(
        "name one, as in `{array}[0]`, or a logical sensor of the robot, as in `logical nearest = min({written})`"
    ))
}
