//! Statements that compute the steps of a tick.

use std::collections::{BTreeSet, HashMap};

use proc_macro2::TokenStream;
use quote::quote;

use super::expression::{self, Expression};
use super::graph::{Node, part};
use super::modes::ModeParts;
use super::wiring::{Says, Sensed, Wiring};
use super::{Emission, layout};
use crate::plan::Step;

/// Statements of a tick, and what they have computed.
pub(super) struct Block<'w> {
    pub(super) emission: Emission<'w>,
    pub(super) wiring: &'w Wiring<'w>,
    /// The mode they run in; `None` for those that run in all.
    pub(super) mode: Option<&'w ModeParts>,
    pub(super) bound: BTreeSet<Node>,
    pub(super) statements: TokenStream,
}

impl<'w> Block<'w> {
    pub(super) fn new(emission: Emission<'w>, wiring: &'w Wiring<'w>, mode: Option<&'w ModeParts>) -> Self {
        Self { emission, wiring, mode, bound: BTreeSet::new(), statements: TokenStream::new() }
    }

    /// Everything that is computed on every tick, in order.
    pub(super) fn remember(&mut self) {
        if self.wiring.keeps_time {
            self.statements.extend(quote! {
                if self.state.is_some() {
                    self.elapsed = self.elapsed.saturating_add(dt_ns);
                }
            });
        }
        for &node in &self.wiring.always {
            self.bind([node]);
            if self.wiring.kept.contains_key(&node) {
                self.keep(node);
            }
            if let Some(before) = self.wiring.before.get(&node) {
                let now = self.value(node).tokens();
                self.statements.extend(quote! { let #before = core::mem::replace(&mut self.#before, #now); });
            }
        }
    }

    /// Statements for what some steps need and what has a name of its own.
    pub(super) fn bind(&mut self, roots: impl IntoIterator<Item = Node>) {
        let wiring = self.wiring;
        for node in wiring.graph.needed(roots, &self.bound) {
            if self.bound.contains(&node) {
                continue;
            }
            if let Some((sense, _)) = wiring.said(node) {
                self.sense(sense);
            } else if let Some(name) = wiring.names.get(&node)
                && !self.kept_here(node)
            {
                let value = self.expression(node).tokens();
                self.statements.extend(quote! { let #name = #value; });
                self.bound.insert(node);
            }
        }
    }

    /// What a network says.
    fn sense(&mut self, sense: &Sensed<'_>) {
        let Sensed { name, method, memory, says, .. } = sense;
        let averaged = self.wiring.averages(sense);
        let dt = (*says == Says::Events).then(|| quote! { , dt_ns });
        let memory = sense.remembers().then(|| quote! { &mut self.#memory #dt });
        self.statements.extend(quote! { let #name = inputs.#method(#(#averaged,)* #memory); });
        let said = self.wiring.events.keys().chain(self.wiring.outputs.keys());
        let same = said.filter(|&&node| self.wiring.said(node).is_some_and(|(of, _)| of.name == *name));
        self.bound.extend(same);
    }

    /// Whether a step is a stopwatch, a latch or a counter that is kept where these statements run.
    fn kept_here(&self, node: Node) -> bool {
        let kept = self.mode.map_or(&self.wiring.kept, |mode| &mode.kept);
        kept.contains_key(&node)
    }

    /// Brings a window, a stopwatch, a latch or a counter up to this tick.
    pub(super) fn keep(&mut self, node: Node) {
        let wiring = self.wiring;
        self.bind(wiring.graph.operands(node));
        let place = match self.mode {
            None => wiring.kept.get(&node).map(|name| (quote! { self.#name }, name)),
            Some(mode) => mode.kept.get(&node).map(|name| (quote! { *#name }, name)),
        };
        let (Some((place, name)), Some(&operand)) = (place, wiring.graph.operands(node).first()) else { return };
        let of = self.value(operand);
        self.statements.extend(match wiring.graph.code.steps[node] {
            Step::Average { input, period, .. } => {
                let (of, period) = (of.tokens(), layout::nanoseconds(period));
                let (sensor, readings) = (&wiring.sensors[input as usize], wiring.windows.get(&node));
                quote! {
                    let usable = kernel::is_usable(inputs.#sensor, !inputs.failed.#sensor);
                    let #name = kernel::Window::observe(
                        &mut #place, &mut self.#readings, #of, usable, dt_ns, #period,
                    );
                }
            }
            Step::Lasts { duration, .. } => {
                let (of, duration) = (of.tokens(), layout::nanoseconds(duration));
                quote! { let #name = kernel::Stopwatch::lasts(&mut #place, #of, dt_ns, #duration); }
            }
            Step::Latched { .. } => {
                let of = of.tokens();
                quote! { #place |= #of; }
            }
            _ => {
                let edge = self.edge(operand, true).tokens();
                let method = if self.mode.is_some() {
                    quote! { #name }
                } else {
                    quote! { #place }
                };
                quote! { if #edge { #place = #method.saturating_add(1); } }
            }
        });
        if let Some(flag) = wiring.names.get(&node) {
            let value = self.kept_value(node).tokens();
            self.statements.extend(quote! { let #flag = #value; });
        }
        self.bound.insert(node);
    }

    /// What has been kept.
    fn kept_value(&self, node: Node) -> Expression {
        let place = match (self.wiring.kept.get(&node), self.mode.and_then(|mode| mode.kept.get(&node))) {
            (_, Some(name)) => quote! { *#name },
            (Some(name), None) => match self.wiring.graph.code.steps[node] {
                Step::Average { .. } | Step::Lasts { .. } => quote! { #name },
                _ => quote! { self.#name },
            },
            (None, None) => return self.first_value(node),
        };
        match self.wiring.graph.code.steps[node] {
            Step::Count { .. } => Expression::whole(self.emission.counted(&place)),
            _ => Expression::whole(place),
        }
    }

    /// What a latch or a counter of a mode is on the first tick, before any mode.
    fn first_value(&self, node: Node) -> Expression {
        let Some(&operand) = self.wiring.graph.operands(node).first() else {
            return Expression::whole(TokenStream::new());
        };
        let now = self.value(operand);
        match self.wiring.graph.code.steps[node] {
            Step::Count { .. } => {
                let now = now.tokens();
                Expression::whole(self.emission.counted(&quote! { u32::from(#now) }))
            }
            _ => now,
        }
    }

    /// Whether something has just set, or has just cleared.
    fn edge(&self, of: Node, sets: bool) -> Expression {
        let before = self.wiring.before.get(&of);
        let (now, before) = (self.value(of), Expression::whole(quote! { #before }));
        expression::all(&if sets { [now, expression::not(&before)] } else { [expression::not(&now), before] })
    }

    /// The value of a step that has been computed, or that is an expression of such.
    pub(super) fn value(&self, node: Node) -> Expression {
        let wiring = self.wiring;
        if let Some((Sensed { name: sense, says, .. }, name)) = wiring.said(node) {
            let value = (*says == Says::Outputs).then(|| quote! { .value });
            return Expression::whole(quote! { #sense.#name #value });
        }
        match wiring.names.get(&node) {
            Some(name) => Expression::whole(quote! { #name }),
            None => self.expression(node),
        }
    }

    /// A step as an expression of what is bound.
    fn expression(&self, root: Node) -> Expression {
        let graph = &self.wiring.graph;
        let mut values: HashMap<Node, Expression> = HashMap::new();
        for node in graph.needed([root], &self.bound) {
            let operands: Vec<_> = graph
                .operands(node)
                .into_iter()
                .map(|operand| values.get(&operand).cloned().unwrap_or_else(|| self.value(operand)))
                .collect();
            values.insert(node, self.operation(node, &operands));
        }
        values.remove(&root).unwrap_or_else(|| self.kept_value(root))
    }

    fn operation(&self, node: Node, operands: &[Expression]) -> Expression {
        let (wiring, emission) = (self.wiring, self.emission);
        let first = operands.first().map(Expression::tokens).unwrap_or_default();
        let sensor = |input: u32| &wiring.sensors[input as usize];
        Expression::whole(match &wiring.graph.code.steps[node] {
            Step::Group { how, .. } if wiring.is_averaged(node) => {
                let of = operands.iter().map(Expression::tokens);
                super::machine::grouped(emission, *how, &quote! { #(#of),* })
            }
            Step::Read { .. } | Step::Group { .. } => {
                let name = wiring.reading(node);
                quote! { inputs.#name() }
            }
            Step::Constant { value, .. } => emission.number(*value),
            Step::Degree { shape, .. } => emission.degree(&first, shape, &wiring.graph),
            Step::Complement { .. } => quote! { (1.0 - #first) },
            Step::Very { .. } => quote! { kernel::very(#first) },
            Step::Somewhat { .. } => quote! { kernel::somewhat(#first) },
            Step::Failed { input, .. } => {
                let name = sensor(*input);
                quote! { inputs.failed.#name }
            }
            Step::Done { .. } if !wiring.inner.is_empty() => wiring.has_ended(self.mode),
            Step::Done { .. } => quote! { inputs.done },
            Step::Compare { comparison, .. } => match operands {
                [left, right] => return expression::compare(*comparison, left, right),
                _ => TokenStream::new(),
            },
            Step::Not { .. } => return operands.first().map_or_else(|| Expression::whole(first), expression::not),
            Step::All { .. } => return expression::all(operands),
            Step::Any { .. } => return expression::any(operands),
            Step::After { duration: 0, .. } => quote! { true },
            // The first tick, before any mode.
            Step::After { .. } if self.mode.is_none() && !wiring.keeps_time => quote! { false },
            Step::After { duration, .. } => {
                let (place, duration) = (self.elapsed(), layout::nanoseconds(*duration));
                return Expression::comparison(quote! { #place >= #duration });
            }
            Step::Inside { path, .. } => wiring.is_inside(self.mode, part(&wiring.graph.code.paths, path)),
            Step::InMode { mode, .. } => {
                let parts = &wiring.modes[*mode as usize];
                let (variant, rest) = (&parts.variant, parts.rest());
                let first = (*mode == wiring.plan.entry).then(|| quote! { None | });
                quote! { matches!(self.state, #first Some(State::#variant #rest)) }
            }
            Step::Rising { of, .. } | Step::Falling { of, .. } => {
                let sets = matches!(wiring.graph.code.steps[node], Step::Rising { .. });
                let of = wiring.graph.bool(*of);
                return of.map_or_else(|| Expression::whole(first), |of| self.edge(of, sets));
            }
            // What a network computes stands in its module, and what is kept has been bound.
            Step::Minimum { .. }
            | Step::Maximum { .. }
            | Step::Outweighs { .. }
            | Step::OutweighsWithHysteresis { .. }
            | Step::Hold { .. }
            | Step::Average { .. }
            | Step::Lasts { .. }
            | Step::Latched { .. }
            | Step::Count { .. }
            | Step::TNorm { .. }
            | Step::SNorm { .. }
            | Step::Weigh { .. }
            | Step::Linear { .. }
            | Step::Centroid { .. }
            | Step::Outline { .. }
            | Step::Midpoints { .. }
            | Step::Mean { .. }
            | Step::Limit { .. }
            | Step::Fires { .. }
            | Step::Otherwise { .. }
            | Step::Keep { .. } => return self.kept_value(node),
        })
    }

    fn elapsed(&self) -> TokenStream {
        if self.wiring.keeps_time {
            quote! { self.elapsed }
        } else {
            quote! { *elapsed }
        }
    }
}
