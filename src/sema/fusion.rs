//! Variables, networks and their events.

use std::collections::HashMap;

use super::quantities::mismatch;
use super::{Lower, claim, fail_reading, missing_part, symbol};
use crate::base::{Exact, Unit};
use crate::diag::{self, Diagnostic};
use crate::ir;
use crate::syntax::ast;

impl Lower<'_> {
    pub(super) fn variable(&mut self, tree: &ast::Variable) {
        let Some(unit) = self.unit(&tree.unit) else { return };
        let range = match &tree.range {
            Some(range) => self.range_in(range, &unit),
            None => {
                self.report(missing_range(&tree.name, "variable", &unit));
                None
            }
        };
        let Some(range) = range else { return };
        let fails = self.fail_readings(&tree.fails, &unit, range);
        let terms = self.declared_terms(&tree.terms, &unit);
        let incomplete = self.unparsed.touches(tree.span);
        if tree.terms.is_empty() && !incomplete {
            let diagnostic = missing_part(tree.name.span, format!("variable `{}` has no term", tree.name.text));
            self.report(diagnostic.help("write a line such as `low = ramp(80, 20)` for each fuzzy set"));
        }
        let symbol = symbol(&tree.name, tree.doc.as_ref());
        let id = self.program.variables.add(ir::Variable { symbol, unit, range, fails, terms, incomplete });
        self.scopes.variables.insert(tree.name.span, id);
    }

    /// The ways to fail of a sensor or variable, each within its range.
    pub(super) fn fail_readings(
        &mut self,
        trees: &[ast::FailReading],
        unit: &Unit,
        range: (Exact, Exact),
    ) -> Vec<ir::FailReading> {
        let mut readings = Vec::new();
        for tree in trees {
            match tree {
                ast::FailReading::Value(quantity) => {
                    let Some(value) = self.quantity_in(quantity, unit) else { continue };
                    if value < range.0 || value > range.1 {
                        let shown = |end: Exact| unit.show(end.to_f64());
                        let message = format!(
                            "this fail reading lies outside the range {} .. {}",
                            shown(range.0),
                            shown(range.1)
                        );
                        let rule = &diag::rules::FAIL_READING_OUTSIDE_RANGE;
                        self.report(Diagnostic::new(rule, quantity.span, message));
                    } else {
                        readings.push(ir::FailReading::Value(value));
                    }
                }
                ast::FailReading::Set(span) | ast::FailReading::Clear(span) => {
                    self.report(super::invalid(*span, "only a contact fails set or clear; this sensor gives a number"));
                }
                other => readings.extend(fail_reading(other)),
            }
        }
        readings
    }

    pub(super) fn network(&mut self, tree: &ast::Network) {
        let reported = self.diagnostics.len();
        let mut seen = HashMap::new();
        let mut inputs = Vec::new();
        let mut sound = true;
        for input in &tree.inputs {
            let first = claim(&mut seen, &input.name, "input", &mut self.diagnostics);
            match self.find_variable(&input.variable) {
                Some(variable) if first => {
                    inputs.push(ir::NetworkInput { symbol: symbol(&input.name, None), variable });
                }
                _ => sound = false,
            }
        }
        let inference = self.inference(&tree.settings);
        // Without all of its inputs every row of the network would be reported; one fault is one diagnostic.
        if !sound {
            return;
        }
        let symbol = symbol(&tree.name, tree.doc.as_ref());
        let (events, outputs) = (Vec::new(), Vec::new());
        let mut network = ir::Network { symbol, inputs, events, inference, outputs, incomplete: false };
        let (mut seen, mut broken) = (HashMap::new(), Vec::new());
        for item in &tree.items {
            match item {
                ast::NetworkItem::Event(event) => {
                    let first = claim(&mut seen, &event.name, "event", &mut self.diagnostics);
                    let event = self.event(event, &network);
                    if first {
                        network.events.push(event);
                    }
                }
                ast::NetworkItem::Output(output) => {
                    let first = claim(&mut seen, &output.name, "output", &mut self.diagnostics);
                    match self.output(output) {
                        Some(output) if first => network.outputs.push(output),
                        _ => broken.push(output.name.text.as_str()),
                    }
                }
                ast::NetworkItem::Rule(_) | ast::NetworkItem::Error(_) => {}
            }
        }
        for item in &tree.items {
            if let ast::NetworkItem::Rule(rule) = item {
                self.output_rule(rule, &mut network, &broken);
            }
        }
        network.incomplete = self.unparsed.touches(tree.span) || self.diagnostics.len() > reported;
        if !network.incomplete {
            self.outputs_without_rules(&network);
            if network.outputs.is_empty() {
                self.idle_inference(&tree.settings);
            }
            network.incomplete = self.diagnostics.len() > reported;
        }
        let id = self.program.networks.add(network);
        self.scopes.networks.insert(tree.name.span, id);
    }

    fn event(&mut self, tree: &ast::Event, network: &ir::Network) -> ir::Event {
        let over = self.event_inputs(tree, network);
        let mut sides = (Vec::new(), Vec::new());
        for side in &tree.sides {
            let rules = match side.kind {
                ast::SideKind::Contributor => &mut sides.0,
                ast::SideKind::Detractor => &mut sides.1,
            };
            for rule in &side.rules {
                rules.extend(self.event_rule(rule, network, &over));
            }
        }
        let is_broken = self.unparsed.touches(tree.span);
        if !is_broken
            && !tree.sides.iter().any(|side| side.kind == ast::SideKind::Contributor && !side.rules.is_empty())
        {
            let message = format!("no rule contributes to `{}`", tree.name.text);
            let diagnostic = Diagnostic::new(&diag::rules::NO_CONTRIBUTOR, tree.name.span, message);
            self.report(diagnostic.note("an event is set when its contributor outweighs its detractor"));
        }
        let hysteresis = self.option(&tree.hysteresis, "`hysteresis`", |lower, quantity| {
            let value = lower.quantity_in(quantity, &Unit::one())?;
            if value < Exact::ZERO || value > Exact::ONE {
                lower.report(super::invalid(quantity.span, "a hysteresis is between 0 and 1"));
                return None;
            }
            Some(value)
        });
        ir::Event {
            symbol: symbol(&tree.name, tree.doc.as_ref()),
            contributor: sides.0,
            detractor: sides.1,
            hysteresis: hysteresis.unwrap_or(Exact::ZERO),
            hold: self.option(&tree.hold, "`hold`", Self::nanoseconds).unwrap_or(0),
            confirm: self.option(&tree.confirm, "`confirm`", Self::nanoseconds).unwrap_or(0),
        }
    }

    /// An option that may be written once.
    fn option<T>(
        &mut self,
        written: &[ast::Quantity],
        what: &str,
        lower: impl Fn(&mut Self, &ast::Quantity) -> Option<T>,
    ) -> Option<T> {
        let first = written.first()?;
        if let Some(second) = written.get(1) {
            self.report(super::said_twice(second.span, first.span, what));
        }
        lower(self, first)
    }

    /// The inputs that the rows of an event name, in order.
    fn event_inputs(&mut self, tree: &ast::Event, network: &ir::Network) -> Vec<u32> {
        let Some(over) = &tree.over else { return (0..network.inputs.len() as u32).collect() };
        let mut inputs = Vec::new();
        for name in over {
            match super::position(&name.text, network.inputs.iter().map(|input| &input.symbol)) {
                Some(input) if inputs.contains(&(input as u32)) => {
                    self.report(super::invalid(name.span, format!("`{}` is named twice", name.text)));
                }
                Some(input) => {
                    self.refers(name.span, network.inputs[input].symbol.span);
                    inputs.push(input as u32);
                }
                None => {
                    let known = network.inputs.iter().map(|input| input.symbol.name.as_str());
                    self.report(self.unknown(name, "input of this network", known));
                }
            }
        }
        inputs
    }

    /// Checks that a network's input can be fed by something of a unit.
    pub(super) fn check_feed(&mut self, span: crate::base::Span, input: &ir::NetworkInput, fed: &Unit) -> bool {
        let variable = &self.program.variables[input.variable];
        let wanted = variable.unit.dimension;
        if wanted != fed.dimension {
            let (input, variable) = (&input.symbol.name, &variable.symbol.name);
            let diagnostic = mismatch(span, fed.dimension, wanted)
                .note(format!("it feeds the input `{input}`, which takes the variable `{variable}`"));
            self.report(diagnostic);
            return false;
        }
        true
    }
}

pub(super) fn missing_range(name: &ast::Name, what: &str, unit: &Unit) -> Diagnostic {
    missing_part(name.span, format!("{what} `{}` has no range", name.text))
        .note("a reading outside its range is clamped to it, so the range must be known")
        .help(format!("write `{}: {} in 0 .. 10` with its own ends", name.text, unit.text))
}
