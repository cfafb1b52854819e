//! Variables and networks.

use super::grammar::{Pair, Parts, Rule};
use super::tree::Tree;
use crate::syntax::ast::{
    Consequent, ConsequentValue, Event, EventRule, EventSide, Network, NetworkInput, NetworkItem, Output, OutputBody,
    OutputDefault, OutputRule, Setting, SettingValue, Shape, ShapeKind, SideKind, Term, Variable,
};

impl Tree<'_> {
    pub fn variable(&mut self, pair: Pair<'_>) -> Option<Variable> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.variable_head(parts.take(Rule::variable_head)?)?;
        Some(Variable { terms: self.terms(parts.take(Rule::terms)?)?, span, ..head })
    }

    /// A variable without its terms.
    pub fn variable_head(&mut self, pair: Pair<'_>) -> Option<Variable> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        Some(Variable {
            doc: self.doc(span),
            name: self.next_name(&mut parts)?,
            unit: self.unit(parts.take(Rule::unit)?)?,
            range: self.optional_range(&mut parts, Rule::range_clause)?,
            fails: match parts.take(Rule::fails_clause) {
                Some(clause) => self.fail_readings(clause)?,
                None => Vec::new(),
            },
            terms: Vec::new(),
            span,
        })
    }

    fn terms(&mut self, pair: Pair<'_>) -> Option<Vec<Term>> {
        Parts::of(pair).take_all(Rule::term).map(|term| self.term(term)).collect()
    }

    pub fn term(&mut self, pair: Pair<'_>) -> Option<Term> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        Some(Term { doc: self.doc(span), name, shape: self.shape(parts.take(Rule::shape)?)?, span })
    }

    /// `a and b or c`: `or` binds weakest.
    fn shape(&mut self, pair: Pair<'_>) -> Option<Shape> {
        let mut alternatives = Vec::new();
        let mut all = Vec::new();
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::connective if part.as_str() == "or" => {
                    alternatives.push(join(std::mem::take(&mut all), ShapeKind::And)?);
                }
                Rule::connective => {}
                _ => all.push(self.shape_operand(part)?),
            }
        }
        alternatives.push(join(all, ShapeKind::And)?);
        join(alternatives, ShapeKind::Or)
    }

    fn shape_operand(&mut self, pair: Pair<'_>) -> Option<Shape> {
        let mut prefixes = Vec::new();
        let mut parts = pair.into_inner();
        let mut part = parts.next()?;
        while matches!(part.as_rule(), Rule::negation | Rule::hedge) {
            prefixes.push(part);
            part = parts.next()?;
        }
        let mut shape = self.shape_primary(part)?;
        for prefix in prefixes.into_iter().rev() {
            let span = self.span(&prefix).to(shape.span);
            let kind = match prefix.as_rule() {
                Rule::hedge => ShapeKind::Hedge(self.word(&prefix), Box::new(shape)),
                _ => ShapeKind::Not(Box::new(shape)),
            };
            shape = Shape { kind, span };
        }
        Some(shape)
    }

    fn shape_primary(&mut self, pair: Pair<'_>) -> Option<Shape> {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::shape_group => self.shape(Parts::of(pair).take(Rule::shape)?)?.kind,
            Rule::points => {
                let mut parts = Parts::of(pair);
                let corners = parts.take_all(Rule::corner);
                ShapeKind::Points(corners.map(|corner| self.pair_of_quantities(corner)).collect::<Option<_>>()?)
            }
            Rule::function => {
                let mut parts = Parts::of(pair);
                let function = self.next_name(&mut parts)?;
                let parameters = parts.take_all(Rule::quantity).map(|quantity| self.quantity(quantity));
                ShapeKind::Function { function, parameters: parameters.collect::<Option<_>>()? }
            }
            _ => ShapeKind::Term(self.name(&pair)),
        };
        Some(Shape { kind, span })
    }

    pub fn network(&mut self, pair: Pair<'_>) -> Option<Network> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.network_head(parts.take(Rule::network_head)?)?;
        let items = parts.take_all(Rule::network_item).map(|item| self.network_item(item)).collect::<Option<_>>()?;
        Some(Network { items, span, ..head })
    }

    /// A network without its items.
    pub fn network_head(&mut self, pair: Pair<'_>) -> Option<Network> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        let mut inputs = Parts::of(parts.take(Rule::inputs)?);
        let inputs = inputs.take_all(Rule::input).map(|input| self.network_input(input)).collect::<Option<_>>()?;
        let settings = match parts.take(Rule::using) {
            Some(using) => {
                let mut settings = Parts::of(using);
                settings.take_all(Rule::setting).map(|setting| self.setting(setting)).collect::<Option<_>>()?
            }
            None => Vec::new(),
        };
        Some(Network { doc: self.doc(span), name, inputs, settings, items: Vec::new(), span })
    }

    fn network_input(&mut self, pair: Pair<'_>) -> Option<NetworkInput> {
        let mut parts = Parts::of(pair);
        Some(NetworkInput { name: self.next_name(&mut parts)?, variable: self.next_name(&mut parts)? })
    }

    fn setting(&mut self, pair: Pair<'_>) -> Option<Setting> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let key = self.word(&parts.take(Rule::setting_key)?);
        let mut values = Vec::new();
        while let Some(value) = parts.next() {
            values.push(match value.as_rule() {
                Rule::number => SettingValue::Number(self.number(&value)),
                _ => SettingValue::Name(self.name(&value)),
            });
        }
        Some(Setting { key, values, span })
    }

    pub fn network_item(&mut self, pair: Pair<'_>) -> Option<NetworkItem> {
        let item = Parts::of(pair).next()?;
        match item.as_rule() {
            Rule::event => self.event(item).map(NetworkItem::Event),
            Rule::output => self.output(item).map(NetworkItem::Output),
            _ => self.output_rule(item).map(NetworkItem::Rule),
        }
    }

    fn event(&mut self, pair: Pair<'_>) -> Option<Event> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.event_head(parts.take(Rule::event_head)?)?;
        let sides = parts.take_all(Rule::event_side).map(|side| self.event_side(side)).collect::<Option<_>>()?;
        Some(Event { sides, span, ..head })
    }

    /// An event without its rules.
    pub fn event_head(&mut self, pair: Pair<'_>) -> Option<Event> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let mut event = Event {
            doc: self.doc(span),
            name: self.next_name(&mut parts)?,
            over: None,
            hysteresis: Vec::new(),
            hold: Vec::new(),
            confirm: Vec::new(),
            sides: Vec::new(),
            span,
        };
        for option in parts.take_all(Rule::event_option) {
            let option = Parts::of(option).next()?;
            match option.as_rule() {
                Rule::over_clause => {
                    let place = self.span(&option);
                    let names = self.names(Parts::of(option).take(Rule::names)?);
                    self.once(&mut event.over, names, place, "over");
                }
                Rule::hysteresis => event.hysteresis.push(self.clause_quantity(option)?),
                Rule::hold => event.hold.push(self.clause_quantity(option)?),
                _ => event.confirm.push(self.clause_quantity(option)?),
            }
        }
        Some(event)
    }

    fn event_side(&mut self, pair: Pair<'_>) -> Option<EventSide> {
        let mut parts = Parts::of(pair);
        let side = parts.take(Rule::side)?;
        let rules = parts.take_all(Rule::event_rule).map(|rule| self.event_rule(rule)).collect::<Option<_>>()?;
        Some(EventSide { kind: side_kind(side.as_str()), keyword: self.span(&side), rules })
    }

    pub fn event_rule(&mut self, pair: Pair<'_>) -> Option<EventRule> {
        let rule = Parts::of(pair).next()?;
        let span = self.span(&rule);
        match rule.as_rule() {
            Rule::row => self.row(rule).map(EventRule::Row),
            _ => Some(EventRule::Words { antecedent: self.expression(Parts::of(rule).take(Rule::expression)?)?, span }),
        }
    }

    fn output(&mut self, pair: Pair<'_>) -> Option<Output> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.output_head(parts.take(Rule::output_head)?)?;
        let body = parts.next()?;
        let body = match body.as_rule() {
            Rule::terms => OutputBody::Terms(self.terms(body)?),
            _ => OutputBody::TakagiSugeno(self.span(&body)),
        };
        Some(Output { body, span, ..head })
    }

    /// An output without its terms.
    pub fn output_head(&mut self, pair: Pair<'_>) -> Option<Output> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        Some(Output {
            doc: self.doc(span),
            name: self.next_name(&mut parts)?,
            unit: self.unit(parts.take(Rule::unit)?)?,
            range: self.optional_range(&mut parts, Rule::range_clause)?,
            default: match parts.take(Rule::default_clause) {
                Some(clause) => Some(self.output_default(clause)?),
                None => None,
            },
            body: OutputBody::Terms(Vec::new()),
            span,
        })
    }

    fn output_default(&mut self, clause: Pair<'_>) -> Option<OutputDefault> {
        let value = clause.into_inner().nth(1)?;
        match value.as_rule() {
            Rule::kw_hold => Some(OutputDefault::Hold(self.span(&value))),
            _ => self.quantity(value).map(OutputDefault::Value),
        }
    }

    fn output_rule(&mut self, pair: Pair<'_>) -> Option<OutputRule> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let antecedent = self.expression(parts.take(Rule::expression)?)?;
        let consequents = parts.take_all(Rule::consequent).map(|part| self.consequent(part)).collect::<Option<_>>()?;
        let weight = match parts.take(Rule::weight) {
            Some(weight) => Some(self.number(&Parts::of(weight).take(Rule::number)?)),
            None => None,
        };
        Some(OutputRule { doc: self.doc(span), antecedent, consequents, weight, span })
    }

    fn consequent(&mut self, pair: Pair<'_>) -> Option<Consequent> {
        let mut parts = Parts::of(pair);
        let output = self.next_name(&mut parts)?;
        let value = parts.next()?;
        let value = match value.as_rule() {
            Rule::is_term => ConsequentValue::Term(self.clause_name(value)?),
            _ => ConsequentValue::Linear(self.expression(Parts::of(value).take(Rule::sum)?)?),
        };
        Some(Consequent { output, value })
    }
}

pub fn side_kind(keyword: &str) -> SideKind {
    if keyword == "contributor" { SideKind::Contributor } else { SideKind::Detractor }
}

/// One part stays itself; several become a chain.
fn join(mut parts: Vec<Shape>, make: fn(Vec<Shape>) -> ShapeKind) -> Option<Shape> {
    let last = parts.pop()?;
    let Some(first) = parts.first() else { return Some(last) };
    let span = first.span.to(last.span);
    parts.push(last);
    Some(Shape { kind: make(parts), span })
}
