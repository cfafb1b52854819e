//! Interfaces and robots: bodies, sensors, actions.

use super::grammar::{Pair, Parts, Rule};
use super::tree::Tree;
use crate::syntax::ast::{
    Action, ActionParameter, Body, BodyParameter, Interface, Logical, Robot, RobotItem, Sensor, SensorClause,
    SensorKind,
};

impl Tree<'_> {
    pub fn interface(&mut self, pair: Pair<'_>) -> Option<Interface> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.interface_head(parts.take(Rule::interface_head)?)?;
        Some(Interface { items: self.robot_block(parts.take(Rule::robot_block)?)?, span, ..head })
    }

    /// An interface without its items.
    pub fn interface_head(&mut self, pair: Pair<'_>) -> Option<Interface> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        let extends = match parts.take(Rule::extends_clause) {
            Some(clause) => Some(self.clause_name(clause)?),
            None => None,
        };
        Some(Interface { doc: self.doc(span), name, extends, items: Vec::new(), span })
    }

    pub fn robot(&mut self, pair: Pair<'_>) -> Option<Robot> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.robot_head(parts.take(Rule::robot_head)?)?;
        Some(Robot { items: self.robot_block(parts.take(Rule::robot_block)?)?, span, ..head })
    }

    /// A robot without its items.
    pub fn robot_head(&mut self, pair: Pair<'_>) -> Option<Robot> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        let provides = parts.take(Rule::names).map(|names| self.names(names)).unwrap_or_default();
        let runs = match parts.take(Rule::runs_clause) {
            Some(clause) => Some(self.next_name(&mut Parts::of(clause))?),
            None => None,
        };
        Some(Robot { doc: self.doc(span), name, provides, runs, items: Vec::new(), span })
    }

    fn robot_block(&mut self, pair: Pair<'_>) -> Option<Vec<RobotItem>> {
        Parts::of(pair).take_all(Rule::robot_item).map(|item| self.robot_item(item)).collect()
    }

    pub fn robot_item(&mut self, pair: Pair<'_>) -> Option<RobotItem> {
        let item = Parts::of(pair).next()?;
        match item.as_rule() {
            Rule::body => self.body(item).map(RobotItem::Body),
            Rule::sensor => self.sensor(item).map(RobotItem::Sensor),
            Rule::sense => self.sense(item).map(RobotItem::Sense),
            Rule::logical => self.logical(item).map(RobotItem::Logical),
            _ => self.action(item).map(RobotItem::Action),
        }
    }

    fn body(&mut self, pair: Pair<'_>) -> Option<Body> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let kind = self.next_name(&mut parts)?;
        let parameters = parts.take_all(Rule::body_parameter).map(|part| self.body_parameter(part));
        Some(Body { kind, parameters: parameters.collect::<Option<_>>()?, span })
    }

    fn body_parameter(&mut self, pair: Pair<'_>) -> Option<BodyParameter> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        let value = parts.next()?;
        let values = match value.as_rule() {
            Rule::tuple => self.quantities(value)?,
            _ => vec![self.quantity(value)?],
        };
        Some(BodyParameter { name, values, span })
    }

    fn sensor(&mut self, pair: Pair<'_>) -> Option<Sensor> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let optional = parts.take(Rule::optional).is_some();
        let name = self.next_name(&mut parts)?;
        let count = match parts.take(Rule::sensor_count) {
            Some(count) => Some(self.number(&Parts::of(count).take(Rule::unsigned)?)),
            None => None,
        };
        let kind = match parts.take(Rule::contact) {
            Some(contact) => SensorKind::Contact(self.span(&contact)),
            None => SensorKind::Quantity {
                unit: self.unit(parts.take(Rule::unit)?)?,
                range: self.optional_range(&mut parts, Rule::range_clause)?,
            },
        };
        let clauses = parts.take_all(Rule::sensor_clause).map(|clause| self.sensor_clause(clause));
        let clauses = clauses.collect::<Option<_>>()?;
        Some(Sensor { doc: self.doc(span), optional, name, count, kind, clauses, span })
    }

    fn sensor_clause(&mut self, pair: Pair<'_>) -> Option<SensorClause> {
        let clause = Parts::of(pair).next()?;
        match clause.as_rule() {
            Rule::fails_clause => self.fail_readings(clause).map(SensorClause::Fails),
            Rule::source => Some(SensorClause::Source(self.path(Parts::of(clause).take(Rule::path)?))),
            Rule::noise => self.clause_quantity(clause).map(SensorClause::Noise),
            Rule::accuracy => self.clause_quantity(clause).map(SensorClause::Accuracy),
            Rule::beam => self.clause_quantity(clause).map(SensorClause::Beam),
            _ => self.clause_quantity(clause).map(SensorClause::Period),
        }
    }

    fn logical(&mut self, pair: Pair<'_>) -> Option<Logical> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        let value = self.expression(parts.take(Rule::expression)?)?;
        Some(Logical {
            doc: self.doc(span),
            name,
            value,
            within: self.optional_quantity(&mut parts, Rule::request)?,
            span,
        })
    }

    fn action(&mut self, pair: Pair<'_>) -> Option<Action> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let optional = parts.take(Rule::optional).is_some();
        let name = self.next_name(&mut parts)?;
        let mut parameters = Parts::of(parts.take(Rule::parameters)?);
        let parameters = parameters.take_all(Rule::parameter).map(|parameter| self.action_parameter(parameter));
        let parameters = parameters.collect::<Option<_>>()?;
        let done = parts.take(Rule::completion).map(|completion| self.span(&completion));
        let implementation = match parts.take(Rule::call) {
            Some(call) => Some(self.call(call)?),
            None => None,
        };
        Some(Action { doc: self.doc(span), optional, name, parameters, done, implementation, span })
    }

    fn action_parameter(&mut self, pair: Pair<'_>) -> Option<ActionParameter> {
        let mut parts = Parts::of(pair);
        Some(ActionParameter { name: self.next_name(&mut parts)?, unit: self.unit(parts.take(Rule::unit)?)? })
    }
}
