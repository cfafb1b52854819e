//! Bodies: their kinds, what each is made of, and what it lacks.

use std::collections::HashMap;

use super::robots::join;
use super::{Lower, counted, given, missing_part};
use crate::base::{Dimension, Exact, Span};
use crate::diag::{self, Diagnostic};
use crate::ir;
use crate::syntax::ast;

/// A kind of body.
struct Kind {
    name: &'static str,
    /// Name, dimension, number of values, default.
    parameters: &'static [(&'static str, Dimension, usize, Option<f64>)],
    /// The commands and places of measurement that only others have.
    lacks: &'static [&'static str],
    build: fn(&Value<'_>) -> Option<ir::Body>,
}

/// The values of a parameter, by its name and their places.
type Value<'a> = dyn Fn(&str, usize) -> Option<f64> + 'a;

const KINDS: &[Kind] = &[
    Kind {
        name: "differential_drive",
        parameters: &[
            ("mass", Dimension::MASS, 1, None),
            ("size", Dimension::LENGTH, 2, None),
            ("track", Dimension::LENGTH, 1, None),
            ("traction", Dimension::NONE, 1, None),
            ("lag", Dimension::TIME, 1, Some(0.15)),
            ("acceleration_limit", Dimension::ACCELERATION, 1, Some(2.0)),
            ("impact_time", Dimension::TIME, 1, Some(0.05)),
            ("tracking_noise", Dimension::ACCELERATION, 1, Some(0.2)),
        ],
        lacks: &["body.steer"],
        build: differential_drive,
    },
    Kind {
        name: "car_like",
        parameters: &[
            ("mass", Dimension::MASS, 1, None),
            ("size", Dimension::LENGTH, 2, None),
            ("cycle", Dimension::TIME, 1, Some(1.0)),
            ("speed_limit", Dimension::SPEED, 1, Some(2.0)),
            // 40 degrees.
            ("steering_limit", Dimension::ANGLE, 1, Some(2.0 * std::f64::consts::PI / 9.0)),
        ],
        lacks: &[
            "body.rotate",
            "body.travel",
            "wheel.left.acceleration",
            "wheel.right.acceleration",
            "wheel.left.speed",
            "wheel.right.speed",
            "wedge.force",
        ],
        build: car_like,
    },
];

impl Lower<'_> {
    pub(super) fn body(&mut self, tree: &ast::Body) -> Option<ir::Body> {
        let Some(kind) = kind(tree) else {
            self.report(self.unknown(&tree.kind, "body", KINDS.iter().map(|kind| kind.name)));
            return None;
        };
        let mut read: HashMap<&str, (Vec<f64>, Span)> = HashMap::new();
        let mut sound = true;
        for parameter in &tree.parameters {
            let name = parameter.name.text.as_str();
            let Some(&(_, dimension, count, _)) = kind.parameters.iter().find(|(known, ..)| *known == name) else {
                self.report(self.unknown(
                    &parameter.name,
                    "parameter of this body",
                    kind.parameters.iter().map(|p| p.0),
                ));
                sound = false;
                continue;
            };
            if parameter.values.len() != count {
                let message = format!("`{name}` takes {}, {}", counted(count, "value"), given(parameter.values.len()));
                let help = if count == 2 { "write `size (length, width)`" } else { "write one value" };
                let rule = &diag::rules::WRONG_ARGUMENTS;
                self.report(Diagnostic::new(rule, parameter.span, message).help(help));
                sound = false;
                continue;
            }
            let values: Vec<_> = parameter
                .values
                .iter()
                .map(|value| match name {
                    "tracking_noise" => self.quantity_of(value, dimension, None).map(Exact::to_f64),
                    _ => self.positive(value, dimension, &format!("`{name}`")),
                })
                .collect();
            match values.into_iter().collect::<Option<Vec<_>>>() {
                Some(values) => {
                    if let Some((_, first)) = read.insert(name, (values, parameter.name.span)) {
                        self.report(super::said_twice(parameter.name.span, first, &format!("`{name}`")));
                    }
                }
                None => sound = false,
            }
        }
        let missing: Vec<_> = kind
            .parameters
            .iter()
            .filter(|(name, _, _, default)| default.is_none() && !read.contains_key(name))
            .map(|(name, ..)| format!("`{name}`"))
            .collect();
        if sound && !missing.is_empty() {
            self.report(missing_part(tree.kind.span, format!("the body lacks {}", missing.join(", "))));
            return None;
        }
        let value = |name: &str, index: usize| {
            let default = kind.parameters.iter().find(|(known, ..)| *known == name).and_then(|parameter| parameter.3);
            read.get(name).and_then(|(values, _)| values.get(index).copied()).or(default)
        };
        (kind.build)(&|name, index| value(name, index))
    }

    /// Reports what a body of another kind would do or measure, and this robot's does not.
    pub(super) fn check_body(&mut self, items: &[ast::RobotItem]) {
        let Some(kind) = items.iter().find_map(|item| match item {
            ast::RobotItem::Body(body) => kind(body),
            _ => None,
        }) else {
            return;
        };
        let named = items.iter().flat_map(|item| match item {
            ast::RobotItem::Action(action) => action.implementation.iter().map(|call| &call.path).collect(),
            ast::RobotItem::Sensor(sensor) => sensor.clauses.iter().filter_map(source).collect(),
            _ => Vec::new(),
        });
        for path in named.filter(|path| kind.lacks.contains(&join(path).as_str())) {
            let message = format!("a `{}` body has no `{}`", kind.name, join(path));
            self.report(Diagnostic::new(&diag::rules::UNKNOWN_NAME, path.span, message));
        }
    }
}

fn kind(tree: &ast::Body) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.name == tree.kind.text)
}

fn source(clause: &ast::SensorClause) -> Option<&ast::Path> {
    match clause {
        ast::SensorClause::Source(path) => Some(path),
        _ => None,
    }
}

fn differential_drive(value: &Value<'_>) -> Option<ir::Body> {
    Some(ir::Body::DifferentialDrive(ir::DifferentialDrive {
        mass: value("mass", 0)?,
        length: value("size", 0)?,
        width: value("size", 1)?,
        track: value("track", 0)?,
        traction: value("traction", 0)?,
        lag: value("lag", 0)?,
        acceleration_limit: value("acceleration_limit", 0)?,
        impact_time: value("impact_time", 0)?,
        tracking_noise: value("tracking_noise", 0)?,
    }))
}

fn car_like(value: &Value<'_>) -> Option<ir::Body> {
    Some(ir::Body::CarLike(ir::CarLike {
        mass: value("mass", 0)?,
        length: value("size", 0)?,
        width: value("size", 1)?,
        cycle: value("cycle", 0)?,
        speed_limit: value("speed_limit", 0)?,
        steering_limit: value("steering_limit", 0)?,
    }))
}
