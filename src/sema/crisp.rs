//! Crisp use of fuzzy variables: `x is term`, and what decision tables look at.
//!
//! A reading is the term whose degree is highest, the first of those that are equal, so it is always exactly one. That
//! makes `is` a comparison with the readings at which two terms cross, known exactly.

use super::conditions::Scene;
use super::{Lower, invalid, not_supported};
use crate::base::{Exact, Id, Span};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Comparison, Expr, Op, Type};
use crate::membership::{Membership, Stretch, highest, in_units};
use crate::syntax::ast;

/// What `is` or a column of a decision table looks at.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Subject {
    /// A reading, by the terms of a variable.
    Reading(Id<ir::Sensor>, Id<ir::Variable>),
    /// What the robot is doing, or was told to.
    Doing(Id<ir::Sensor>, Doing),
    /// A condition.
    Condition(Id<Expr>),
}

/// What a robot with a drive tells of itself.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Doing {
    State,
    Command,
}

impl Doing {
    /// Its values, by number.
    pub(super) fn names(self, scene: &Scene) -> &[String] {
        match self {
            Self::State => &scene.states,
            Self::Command => &scene.commands,
        }
    }
}

/// What a column can be, with the condition of each value.
pub(super) struct Values {
    pub(super) names: Vec<String>,
    pub(super) conditions: Vec<Id<Expr>>,
    pub(super) possible: Vec<bool>,
}

/// What a name means where terms are asked for.
enum Fuzzy {
    /// A sensor, with the variable that it feeds.
    Reading(Id<ir::Sensor>, Id<ir::Variable>),
    /// Nothing that feeds a network.
    Nothing,
    /// Something broken, which was reported.
    Broken,
}

/// The name that an expression is, if it is one.
fn simple(tree: &ast::Expr) -> Option<&ast::Name> {
    match &tree.kind {
        ast::ExprKind::Path(path) if path.segments.len() == 1 => path.segments.first(),
        _ => None,
    }
}

/// What stands before `.mode`, where this has that form.
fn of_another_diagram(tree: &ast::Expr) -> Option<&[ast::Name]> {
    match &tree.kind {
        ast::ExprKind::Path(path) => match path.segments.as_slice() {
            [first @ .., last] if !first.is_empty() && last.text == "mode" => Some(first),
            _ => None,
        },
        _ => None,
    }
}

/// Whether a column of a decision table has this form.
fn is_column(tree: &ast::Expr) -> bool {
    match &tree.kind {
        ast::ExprKind::Path(_) | ast::ExprKind::Index(..) | ast::ExprKind::Is(..) => true,
        ast::ExprKind::Call(call) => {
            matches!(call.path.segments.as_slice(), [name] if name.text == "failed")
        }
        _ => false,
    }
}

fn not_a_column(span: Span, written: &str) -> Diagnostic {
    invalid(span, format!("a column of a decision table cannot be `{written}`"))
        .note("a column is a reading, a flag, an event, a contact, `failed(...)` or `x is term`")
        .help(format!("name it, as in `flag x = {written}`, and write the name here"))
}

fn without_terms(span: Span, written: &str) -> Diagnostic {
    invalid(span, format!("`{written}` feeds no sensed network"))
        .note("a reading has the terms of the variable that it feeds")
        .help("write `sense network(...)` in the behavior, or compare it with a quantity")
}

/// The variables that a sensor feeds, each with its sense.
fn fed_by(sensor: Id<ir::Sensor>, scene: &Scene) -> Vec<(u32, Id<ir::Variable>)> {
    let fed = scene.inputs.iter().filter(|input| input.2 == sensor);
    fed.map(|input| (input.1, input.3)).collect()
}

/// Readings between two ends; `true` where an end belongs to them.
struct Bounds {
    from: (Exact, bool),
    to: (Exact, bool),
}

impl Lower<'_> {
    /// `x is term`, `x is any of {a, b}`.
    pub(super) fn is_term(&mut self, tree: &ast::Expr, terms: &[ast::Name], span: Span, scene: &Scene) -> Option<Op> {
        if let Some(path) = of_another_diagram(tree) {
            return self.inside(path, terms, span, scene);
        }
        if let Some((sensor, doing)) = self.doing(tree, scene) {
            let values = self.values(Subject::Doing(sensor, doing), scene, span)?;
            let places: Vec<_> = terms.iter().map(|name| self.doing_named(name, doing, scene)).collect();
            let places = places.into_iter().collect::<Option<Vec<_>>>()?;
            return Some(Op::Or(places.into_iter().map(|place| values.conditions[place]).collect()));
        }
        let (sensor, variable) = match self.fuzzy(tree, scene) {
            Fuzzy::Reading(sensor, variable) => (sensor, variable),
            Fuzzy::Nothing => {
                self.report_without_terms(tree, scene, "sensor or input");
                return None;
            }
            Fuzzy::Broken => return None,
        };
        let terms: Vec<_> = terms.iter().map(|name| self.term_of(name, variable)).collect();
        let values = self.values(Subject::Reading(sensor, variable), scene, span)?;
        let terms = terms.into_iter().collect::<Option<Vec<_>>>()?;
        Some(Op::Or(terms.into_iter().map(|term| values.conditions[term]).collect()))
    }

    /// What a column of a decision table looks at. Rows are chosen after the transition, so it is nothing that the mode
    /// keeps for itself: neither time nor history, for which flags may stand.
    pub(super) fn looked_at(&mut self, tree: &ast::Expr, scene: &Scene) -> Option<Subject> {
        if !is_column(tree) {
            self.report(not_a_column(tree.span, self.sources.slice(tree.span)));
            return None;
        }
        if let Some((sensor, doing)) = self.doing(tree, scene) {
            return Some(Subject::Doing(sensor, doing));
        }
        match self.fuzzy(tree, scene) {
            Fuzzy::Reading(sensor, variable) => {
                let same = simple(tree).filter(|name| scene.names().any(|known| known == name.text));
                if let Some(name) = same {
                    let message = format!("`{}` could mean a condition or a reading", name.text);
                    let diagnostic = Diagnostic::new(&diag::rules::AMBIGUOUS_NAME, name.span, message);
                    self.report(diagnostic.help("rename one of them, or write `network.input` for the reading"));
                    return None;
                }
                return Some(Subject::Reading(sensor, variable));
            }
            Fuzzy::Nothing => {}
            Fuzzy::Broken => return None,
        }
        let is_condition = match (&tree.kind, simple(tree)) {
            (ast::ExprKind::Index(..), _) => self.is_contact(tree, scene)?,
            (_, Some(name)) if self.find_sensor(name, &scene.sensors).is_some() => self.is_contact(tree, scene)?,
            (_, Some(name)) => {
                let is_array = || !self.program.elements(&name.text, &scene.sensors).is_empty();
                scene.names().any(|known| known == name.text) || is_array()
            }
            (_, None) => true,
        };
        if !is_condition {
            self.report_without_terms(tree, scene, "flag, event, sensor or input");
            return None;
        }
        let condition = self.condition(tree, scene);
        (self.program.exprs[condition].ty == Type::Bool).then_some(Subject::Condition(condition))
    }

    /// Whether a name means a contact; `None` where the sensor is broken.
    fn is_contact(&mut self, tree: &ast::Expr, scene: &Scene) -> Option<bool> {
        let sensor = match &tree.kind {
            ast::ExprKind::Index(path, indices) => self.one_indexed(path, indices, tree.span, &scene.sensors)?,
            _ => self.sensor_named(simple(tree)?, &scene.sensors)?,
        };
        Some(self.program.sensors[sensor].is_contact)
    }

    /// Reports something that has no terms: no reading, or one that feeds no network. Silent where a sense is broken.
    fn report_without_terms(&mut self, tree: &ast::Expr, scene: &Scene, wanted: &str) {
        if scene.incomplete || scene.unfed {
            return;
        }
        if let Some(array) = simple(tree).filter(|name| !self.program.elements(&name.text, &scene.sensors).is_empty()) {
            self.sensor_named(array, &scene.sensors);
            return;
        }
        let sensors = self.sensor_names(&scene.sensors);
        let known = scene.inputs.iter().map(|input| input.0.as_str()).chain(sensors.iter().map(String::as_str));
        let known = known.chain(scene.names());
        let diagnostic = match simple(tree) {
            Some(name) if !known.clone().any(|known| known == name.text) => self.unknown(name, wanted, known),
            _ => without_terms(tree.span, self.sources.slice(tree.span)),
        };
        self.report(diagnostic);
    }

    /// What something that is looked at can be.
    pub(super) fn values(&mut self, subject: Subject, scene: &Scene, span: Span) -> Option<Values> {
        match subject {
            Subject::Doing(sensor, doing) => {
                let names = doing.names(scene).to_vec();
                let is = |place: usize, lower: &mut Self| {
                    lower.compared(sensor, Comparison::Equal, Exact::new(place as i128, 1, 0), span)
                };
                let conditions = (0..names.len()).map(|place| is(place, self)).collect();
                Some(Values { possible: vec![true; names.len()], names, conditions })
            }
            Subject::Condition(condition) => {
                let clear = self.truth(Op::Not(condition), span);
                let names = ["set", "clear"].map(str::to_owned).to_vec();
                Some(Values { names, conditions: vec![condition, clear], possible: vec![true, true] })
            }
            Subject::Reading(sensor, variable) => {
                let stretches = self.stretches(sensor, variable, span)?;
                let possible = stretches.iter().map(|stretches| !stretches.is_empty()).collect();
                let conditions = stretches.iter().map(|stretches| self.within(sensor, stretches, span)).collect();
                let terms = self.program.variables[variable].terms.iter();
                Some(Values { names: terms.map(|term| term.symbol.name.clone()).collect(), conditions, possible })
            }
        }
    }

    /// The sensor that a name means, with the variable that it feeds. An input of a sensed network means the sensor that
    /// feeds it.
    fn fuzzy(&mut self, tree: &ast::Expr, scene: &Scene) -> Fuzzy {
        let (name, of) = match &tree.kind {
            ast::ExprKind::Path(path) => match path.segments.as_slice() {
                [name] => (name, None),
                [network, name] => (name, Some(network)),
                _ => return Fuzzy::Nothing,
            },
            ast::ExprKind::Index(path, indices) => {
                let Some(sensor) = self.one_indexed(path, indices, tree.span, &scene.sensors) else {
                    return Fuzzy::Broken;
                };
                let fed = fed_by(sensor, scene);
                self.read.extend(fed.iter().filter_map(|(sense, _)| scene.sense_places.get(*sense as usize)));
                return match fed.as_slice() {
                    [(_, variable), others @ ..] if others.iter().any(|other| other.1 != *variable) => {
                        let variables = [*variable, others[0].1];
                        self.report(self.ambiguous_reading(tree.span, variables.map(|variable| (sensor, variable))));
                        Fuzzy::Broken
                    }
                    [(_, variable), ..] => Fuzzy::Reading(sensor, *variable),
                    [] => Fuzzy::Nothing,
                };
            }
            _ => return Fuzzy::Nothing,
        };
        let named = |input: &&(String, u32, Id<ir::Sensor>, Id<ir::Variable>)| {
            input.0 == name.text && of.is_none_or(|of| scene.senses.get(&of.text) == Some(&input.1))
        };
        let mut meant: Vec<_> = scene.inputs.iter().filter(named).map(|input| (input.1, input.2, input.3)).collect();
        if let Some(sensor) = self.find_sensor(name, &scene.sensors).filter(|_| of.is_none()) {
            if self.poison.sensors.contains(&sensor) {
                return Fuzzy::Broken;
            }
            meant.extend(fed_by(sensor, scene).into_iter().map(|(sense, variable)| (sense, sensor, variable)));
        }
        let Some(&(sense, sensor, variable)) = meant.first() else { return Fuzzy::Nothing };
        if let Some(other) = meant.iter().find(|other| (other.1, other.2) != (sensor, variable)) {
            self.report(self.ambiguous_reading(tree.span, [(sensor, variable), (other.1, other.2)]));
            return Fuzzy::Broken;
        }
        self.reads(name, sensor);
        self.read.extend(scene.sense_places.get(sense as usize));
        Fuzzy::Reading(sensor, variable)
    }

    /// `state` or `command` of a robot with a drive.
    fn doing(&mut self, tree: &ast::Expr, scene: &Scene) -> Option<(Id<ir::Sensor>, Doing)> {
        let ast::ExprKind::Path(path) = &tree.kind else { return None };
        let [name] = path.segments.as_slice() else { return None };
        let sensor = self.find_sensor(name, &scene.sensors)?;
        let doing = match self.program.sensors[sensor].source {
            Some(ir::SensorSource::State) => Doing::State,
            Some(ir::SensorSource::Command) => Doing::Command,
            _ => return None,
        };
        Some((sensor, doing))
    }

    /// The number of a state or a command.
    pub(super) fn doing_named(&mut self, name: &ast::Name, doing: Doing, scene: &Scene) -> Option<usize> {
        let names = doing.names(scene);
        let place = names.iter().position(|known| *known == name.text);
        if place.is_none() {
            let what = match doing {
                Doing::State => "state of the robot",
                Doing::Command => "command of the robot",
            };
            self.report(self.unknown(name, what, names.iter().map(String::as_str)));
        }
        place
    }

    fn ambiguous_reading(&self, span: Span, meanings: [(Id<ir::Sensor>, Id<ir::Variable>); 2]) -> Diagnostic {
        let [first, second] = meanings.map(|(sensor, variable)| {
            let (sensor, variable) = (&self.program.sensors[sensor], &self.program.variables[variable]);
            format!("`{}` as `{}`", sensor.symbol.name, variable.symbol.name)
        });
        let message = format!("`{}` could mean {first} or {second}", self.sources.slice(span));
        Diagnostic::new(&diag::rules::AMBIGUOUS_NAME, span, message)
            .help("write `network.input`, with the name under which the network is sensed")
    }

    /// The position of a term in a variable; reports one that it has not.
    pub(super) fn term_of(&mut self, name: &ast::Name, variable: Id<ir::Variable>) -> Option<usize> {
        let ir::Variable { symbol, terms, incomplete, .. } = &self.program.variables[variable];
        let Some(place) = super::position(&name.text, terms.iter().map(|term| &term.symbol)) else {
            if !incomplete {
                let known = terms.iter().map(|term| term.symbol.name.as_str());
                self.report(self.unknown(name, &format!("term of `{}`", symbol.name), known));
            }
            return None;
        };
        let declared = terms[place].symbol.span;
        self.read.insert(declared);
        self.refers(name.span, declared);
        Some(place)
    }

    /// For each term of a variable the stretches of a sensor's readings that it is the highest on.
    fn stretches(
        &mut self,
        sensor: Id<ir::Sensor>,
        variable: Id<ir::Variable>,
        span: Span,
    ) -> Option<Vec<Vec<Bounds>>> {
        let range = self.program.sensors[sensor].range;
        let (pi, ends) = in_units(range);
        let terms = &self.program.variables[variable].terms;
        let memberships: Vec<_> = terms.iter().map(|term| Membership::new(&term.shape, pi)).collect();
        if let Some((smooth, _)) = terms.iter().zip(&memberships).find(|(_, membership)| !membership.is_exact()) {
            let (place, name) = (smooth.shape_span, smooth.symbol.name.clone());
            let diagnostic = not_supported(span, "the crisp use of a smooth membership function");
            self.report(diagnostic.label(place, format!("`{name}` is one")));
            return None;
        }
        let curves: Vec<_> = memberships.into_iter().map(|membership| membership.low).collect();
        let bounds = |stretch: &Stretch| {
            let end = |(at, belongs): &(crate::base::Fraction, bool)| Some((Exact::from_fraction(at, pi)?, *belongs));
            Some(Bounds { from: end(&stretch.from)?, to: end(&stretch.to)? })
        };
        let found = highest(&curves, &ends);
        let found = found.iter().map(|of| of.iter().map(bounds).collect::<Option<Vec<_>>>());
        let found = found.collect::<Option<Vec<_>>>();
        if found.is_none() {
            self.report(super::quantities::too_long(span, "a reading at which two terms cross"));
        }
        found
    }

    /// Whether a sensor reads within some stretches of its range.
    fn within(&mut self, sensor: Id<ir::Sensor>, stretches: &[Bounds], span: Span) -> Id<Expr> {
        let (low, high) = self.program.sensors[sensor].range;
        let mut parts = Vec::new();
        for Bounds { from, to } in stretches {
            let mut both = Vec::new();
            if *from != (low, true) {
                let comparison = if from.1 { Comparison::GreaterOrEqual } else { Comparison::Greater };
                both.push(self.compared(sensor, comparison, from.0, span));
            }
            if *to != (high, true) {
                let comparison = if to.1 { Comparison::LessOrEqual } else { Comparison::Less };
                both.push(self.compared(sensor, comparison, to.0, span));
            }
            parts.push(match both.as_slice() {
                [] => self.compared(sensor, Comparison::GreaterOrEqual, low, span),
                [one] => *one,
                _ => self.truth(Op::And(both), span),
            });
        }
        match parts.as_slice() {
            [] => self.compared(sensor, Comparison::Less, low, span),
            [one] => *one,
            _ => self.truth(Op::Or(parts), span),
        }
    }

    fn compared(&mut self, sensor: Id<ir::Sensor>, comparison: Comparison, at: Exact, span: Span) -> Id<Expr> {
        let ty = Type::Quantity(self.program.sensors[sensor].unit.dimension);
        let reading = self.program.exprs.add(Expr { op: Op::Sensor(sensor), ty, span });
        let at = self.program.exprs.add(Expr { op: Op::Number(at), ty, span });
        self.truth(Op::Compare(comparison, reading, at), span)
    }
}
