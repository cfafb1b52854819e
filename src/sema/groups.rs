//! Logical sensors, which follow from several (Sobh §3.2).

use super::conditions::FUNCTIONS;
use super::openings::WIDEST;
use super::quantities::{mismatch, too_long};
use super::robots::{join, unknown_path};
use super::sensors::plain;
use super::{Lower, invalid, missing_part, symbol};
use crate::base::{Exact, Id};
use crate::ir::{self, Grouping};
use crate::syntax::ast;

/// How readings are grouped otherwise, by the name of the function, and whether that is for contacts.
const GROUPINGS: &[(&str, Grouping, bool)] = &[
    ("min", Grouping::Minimum, false),
    ("max", Grouping::Maximum, false),
    ("mean", Grouping::Mean, false),
    ("median", Grouping::Median, false),
    ("any", Grouping::Maximum, true),
    ("all", Grouping::Minimum, true),
];

/// Whether a logical sensor groups others; else it is a condition.
pub(super) fn is_group(tree: &ast::Logical) -> bool {
    match &tree.value.kind {
        ast::ExprKind::Call(call) => FUNCTIONS.iter().all(|(known, _)| *known != join(&call.path)),
        _ => tree.within.is_some(),
    }
}

impl Lower<'_> {
    /// Adds a logical sensor, which follows from those of `sensors` it names; `groups` are the names of all logical ones.
    pub(super) fn logical(
        &mut self,
        tree: &ast::Logical,
        sensors: &[Id<ir::Sensor>],
        groups: &[&str],
    ) -> Id<ir::Sensor> {
        match self.grouped(tree, sensors, groups) {
            Some(sensor) => self.program.sensors.add(sensor),
            None => self.broken_sensor(&tree.name),
        }
    }

    /// Reports a logical sensor where there are only promises.
    pub(super) fn logical_in_interface(&mut self, tree: &ast::Logical) -> Id<ir::Sensor> {
        let diagnostic = invalid(tree.name.span, "an interface only says what there is, not what it follows from");
        self.report(diagnostic.help("promise a `sensor`; a robot may keep it by a logical one"));
        self.broken_sensor(&tree.name)
    }

    fn grouped(&mut self, tree: &ast::Logical, sensors: &[Id<ir::Sensor>], groups: &[&str]) -> Option<ir::Sensor> {
        let call = match (&tree.value.kind, &tree.within) {
            (ast::ExprKind::Call(call), _) => call,
            (_, Some(within)) => return self.read_again(tree, within, sensors, groups),
            (_, None) => return None,
        };
        let name = join(&call.path);
        if name == WIDEST {
            return self.widest(tree, call, sensors, groups);
        }
        let Some(&(_, how, of_contacts)) = GROUPINGS.iter().find(|(known, ..)| *known == name) else {
            let known = GROUPINGS.iter().map(|(known, ..)| *known).chain([WIDEST]);
            self.report(unknown_path(&call.path, &name, "sensors are not grouped by", known));
            return None;
        };
        let of = self.members_of(call, call.arguments.iter(), sensors, groups)?;
        let first = self.program.sensors[*of.first()?].clone();
        for &id in &of {
            let sensor = &self.program.sensors[id];
            let diagnostic = match (of_contacts, sensor.is_contact) {
                (true, false) => {
                    invalid(call.span, format!("`{name}` is for contacts; `{}` is none", sensor.symbol.name))
                        .help("`min`, `max`, `mean` and `median` group quantities")
                }
                (false, true) => {
                    invalid(call.span, format!("`{name}` is for quantities; `{}` is a contact", sensor.symbol.name))
                        .help("`any` and `all` group contacts")
                }
                _ if sensor.unit.dimension != first.unit.dimension => {
                    mismatch(call.span, sensor.unit.dimension, first.unit.dimension)
                }
                _ => continue,
            };
            self.report(diagnostic);
            return None;
        }
        let of_all = |reading: &dyn Fn(&ir::Sensor) -> Exact| -> Option<Exact> {
            grouped(how, of.iter().map(|&id| reading(&self.program.sensors[id])).collect())
        };
        let range = (of_all(&|sensor| sensor.range.0), of_all(&|sensor| sensor.range.1));
        let (Some(low), Some(high)) = range else {
            self.report(too_long(call.span, "the range of this group"));
            return None;
        };
        let readings = self.counts(tree.within.as_ref(), &of)?;
        let sensor = plain(symbol(&tree.name, tree.doc.as_ref()), false, first.unit, (low, high));
        Some(ir::Sensor {
            is_contact: of_contacts,
            fails: self.group_fails(how, &of),
            group: Some(ir::Group { how, of, readings }),
            ..sensor
        })
    }

    /// The sensors that a member of a group names; reports one that is a group itself.
    pub(super) fn member(
        &mut self,
        tree: &ast::Expr,
        sensors: &[Id<ir::Sensor>],
        groups: &[&str],
    ) -> Option<Vec<Id<ir::Sensor>>> {
        if let ast::ExprKind::Path(path) | ast::ExprKind::Index(path, _) = &tree.kind
            && groups.contains(&join(path).as_str())
        {
            let message = format!("`{}` is a logical sensor", join(path));
            self.report(invalid(path.span, message).help("name the sensors that measure; groups hold no groups"));
            return None;
        }
        self.measuring(tree, sensors)
    }

    /// The sensors that arguments of a group name, each once; `None` where there are none, or something is wrong.
    pub(super) fn members_of<'t>(
        &mut self,
        call: &ast::Call,
        arguments: impl Iterator<Item = &'t ast::Argument>,
        sensors: &[Id<ir::Sensor>],
        groups: &[&str],
    ) -> Option<Vec<Id<ir::Sensor>>> {
        let mut of: Vec<Id<ir::Sensor>> = Vec::new();
        let mut sound = true;
        for argument in arguments {
            if let Some(name) = &argument.name {
                self.report(invalid(name.span, "sensors have no names in a group").help("leave the name out"));
                sound = false;
                continue;
            }
            match self.member(&argument.value, sensors, groups) {
                Some(meant) => {
                    for id in meant {
                        if of.contains(&id) {
                            let sensor = &self.program.sensors[id].symbol.name;
                            let message = format!("`{sensor}` is in this group twice");
                            self.report(invalid(argument.value.span, message));
                            sound = false;
                        } else {
                            of.push(id);
                        }
                    }
                }
                None => sound = false,
            }
        }
        if sound && of.is_empty() {
            self.report(missing_part(call.span, "this group is empty").help("name the sensors it is of"));
        }
        Some(of).filter(|of| sound && !of.is_empty())
    }

    /// How a group reads when all of its sensors have failed, each in its first way, its second and so on, and where it is
    /// stuck because one of them has.
    fn group_fails(&self, how: Grouping, of: &[Id<ir::Sensor>]) -> Vec<ir::FailReading> {
        let value = |fail: &ir::FailReading| match fail {
            ir::FailReading::Value(value) => Some(*value),
            ir::FailReading::Any | ir::FailReading::Absent => None,
        };
        let sensors: Vec<_> = of.iter().map(|&id| &self.program.sensors[id]).collect();
        let values: Vec<Vec<Exact>> =
            sensors.iter().map(|sensor| sensor.fails.iter().filter_map(value).collect()).collect();
        let ways = values.iter().map(Vec::len).max().unwrap_or_default();
        let together = (0..ways).filter_map(|way| {
            let readings = values.iter().map(|values| values.get(way).or(values.last()).copied());
            grouped(how, readings.collect::<Option<_>>()?)
        });
        let mut alone = Vec::new();
        for (place, (sensor, values)) in sensors.iter().zip(&values).enumerate() {
            for &at in values {
                let likes = |&(other, known): &(usize, Exact)| sensors[other].range == sensor.range && known == at;
                if !alone.iter().any(likes) {
                    alone.push((place, at));
                }
            }
        }
        let stuck = alone.into_iter().filter_map(|(stuck, at)| {
            let reading = |end: fn(&ir::Sensor) -> Exact| {
                let of = sensors.iter().enumerate();
                grouped(how, of.map(|(place, sensor)| if place == stuck { at } else { end(sensor) }).collect())
            };
            let (low, high) = (reading(|sensor| sensor.range.0)?, reading(|sensor| sensor.range.1)?);
            (low == high).then_some(low)
        });
        let is_anywhere = sensors.iter().all(|sensor| sensor.fails.contains(&ir::FailReading::Any));
        let mut readings = Vec::new();
        for at in together.chain(stuck).map(ir::FailReading::Value).chain(is_anywhere.then_some(ir::FailReading::Any)) {
            if !readings.contains(&at) {
                readings.push(at);
            }
        }
        readings
    }
}

/// One reading from several; `None` where it cannot be kept exactly, there are none, or it is no reading like theirs.
fn grouped(how: Grouping, mut readings: Vec<Exact>) -> Option<Exact> {
    let mean = |of: &[Exact]| {
        let sum = of.iter().try_fold(Exact::ZERO, |sum, &reading| sum.plus(reading))?;
        sum.over(Exact::new(of.len() as i128, 1, 0))
    };
    readings.sort_unstable();
    match how {
        Grouping::Minimum => readings.first().copied(),
        Grouping::Maximum => readings.last().copied(),
        Grouping::Mean => mean(&readings),
        Grouping::Median => {
            let half = readings.len() / 2;
            mean(if readings.len().is_multiple_of(2) {
                readings.get(half.checked_sub(1)?..=half)?
            } else {
                readings.get(half..=half)?
            })
        }
        Grouping::Widest { .. } => None,
    }
}
