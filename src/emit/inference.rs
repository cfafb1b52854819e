//! Degrees of membership, and what rules make of them.

use std::collections::{BTreeSet, HashMap};

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::formula::{self, Formula};
use super::graph::{Graph, Node};
use super::names::{Scope, plain};
use super::network::Network;
use super::{Emission, layout};
use crate::plan::{Real, Step};

/// The functions that weigh readings.
pub(super) fn strengths(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let Network { plan, inputs, events, .. } = network;
    let (float, blank) = (emission.float(), layout::blank());
    let safe = plan
        .inputs
        .iter()
        .zip(inputs)
        .map(|(input, name)| emission.sanitized(&quote! { inputs.#name }, &quote! { true }, input));
    let mut inference = Inference::new(network);
    let graph = &inference.graph;
    let sides: Vec<[Formula; 2]> = plan
        .strengths
        .iter()
        .map(|(contributor, detractor)| {
            [contributor, detractor].map(|rules| factored(rules, graph).sorted(&|node| (inference.input(node), node)))
        })
        .collect();
    let used: BTreeSet<Node> = sides.iter().flatten().flat_map(Formula::values).collect();
    let degrees = inference.degrees(emission, &used);
    let value = |node: Node| inference.value(node);
    let weighed = plan.events.iter().zip(events).zip(&plan.rules).zip(&sides).map(|(((event, name), rules), sides)| {
        let [contributor, detractor] = sides.each_ref().map(|side| side.tokens(&value));
        let place = emission.places.place(event.origin.span);
        let heading = layout::comment(&format!("event {}, {place}", event.name));
        let rules = [("contributor", &rules.0), ("detractor", &rules.1)].map(|(side, rules)| {
            // One in words may be several.
            let mut rules = rules.clone();
            rules.dedup();
            let rules = rules.into_iter().map(|rule| {
                let (text, line) = (emission.places.text(rule), emission.places.line(rule));
                layout::comment(&format!("    {line}: {text}"))
            });
            let heading = layout::comment(&format!("  {side}"));
            quote! { #heading #(#rules)* }
        });
        quote! {
            #blank
            #heading
            #(#rules)*
            let #name = Strength { contributor: #contributor, detractor: #detractor };
        }
    });
    let weighed: Vec<_> = weighed.collect();
    // An input that no rule looks at is taken all the same.
    let read = inference.read;
    let parameters = inputs
        .iter()
        .enumerate()
        .map(|(index, name)| if read.contains(&index) { name.clone() } else { format_ident!("_{}", plain(name)) });
    let docs = layout::doc(&["The strengths of safe readings."]);
    quote! {
        #blank
        /// How strongly the rules speak for and against each event.
        #[must_use]
        #[inline(always)]
        pub fn strengths(inputs: &Inputs) -> Strengths {
            weigh(#(#safe),*)
        }
        #blank
        #docs
        #[inline(always)]
        pub(super) fn weigh(#(#parameters: #float),*) -> Strengths {
            #degrees
            #(#weighed)*
            Strengths { #(#events),* }
        }
    }
}

/// The rules of one side as the steps that their minima are taken over, factored.
fn factored(rules: &[Real], graph: &Graph<'_>) -> Formula {
    let rules = rules.iter().filter_map(|&rule| graph.real(rule)).map(|rule| match &graph.code.steps[rule] {
        Step::Minimum { of, .. } => graph.real_list(of).iter().filter_map(|&real| graph.real(real)).collect(),
        _ => vec![rule],
    });
    formula::factored(&rules.collect::<Vec<_>>())
}

/// The degrees of a network and the names they are computed under.
struct Inference<'a> {
    graph: Graph<'a>,
    /// The term of each degree, by step: the position of its input and its name.
    terms: HashMap<Node, (usize, &'a str)>,
    inputs: &'a [Ident],
    scope: Scope,
    names: HashMap<Node, Ident>,
    /// The inputs that were looked at.
    read: BTreeSet<usize>,
}

impl<'a> Inference<'a> {
    fn new(network: &'a Network<'a>) -> Self {
        let Network { plan, inputs, events, .. } = network;
        let graph = Graph::new(&plan.code);
        let mut terms = HashMap::new();
        for (input, degrees) in plan.degrees.iter().enumerate() {
            for (name, real) in degrees {
                if let Some(node) = graph.real(*real) {
                    terms.insert(node, (input, name.as_str()));
                }
            }
        }
        // Degrees are looked at until the last event is weighed.
        let ours: Vec<String> = inputs.iter().chain(events).map(plain).collect();
        let scope = Scope::new(&ours.iter().map(String::as_str).collect::<Vec<_>>());
        Self { graph, terms, inputs, scope, names: HashMap::new(), read: BTreeSet::new() }
    }

    /// A statement for each degree that is used, and for each maximum of degrees.
    fn degrees(&mut self, emission: Emission<'_>, used: &BTreeSet<Node>) -> TokenStream {
        let mut statements = TokenStream::new();
        for node in self.graph.needed(used.iter().copied(), &BTreeSet::new()) {
            let (name, value) = match &self.graph.code.steps[node] {
                Step::Read { input, .. } => {
                    self.names.insert(node, self.inputs[*input as usize].clone());
                    self.read.insert(*input as usize);
                    continue;
                }
                Step::Degree { of, shape, .. } => {
                    (self.name(node), emission.degree(&self.operand(*of), shape, &self.graph))
                }
                Step::Complement { of, .. } => {
                    let degree = self.operand(*of);
                    (self.name(node), quote! { 1.0 - #degree })
                }
                Step::Very { of, .. } => {
                    let degree = self.operand(*of);
                    (self.name(node), quote! { kernel::very(#degree) })
                }
                Step::Somewhat { of, .. } => {
                    let degree = self.operand(*of);
                    (self.name(node), quote! { kernel::somewhat(#degree) })
                }
                step @ (Step::Minimum { of, .. } | Step::Maximum { of, .. }) => {
                    let of = self.graph.real_list(of).iter().filter_map(|&real| self.graph.real(real));
                    let of = of.map(Formula::Value).collect();
                    let is_minimum = matches!(step, Step::Minimum { .. });
                    let formula = if is_minimum { Formula::Minimum(of) } else { Formula::Maximum(of) };
                    (self.name(node), formula.tokens(&|node| self.value(node)))
                }
                _ => continue,
            };
            let name = self.scope.snake(&name);
            statements.extend(quote! { let #name = #value; });
            self.names.insert(node, name);
        }
        statements
    }

    /// `left_neg`, `left_not_neg`, `left_neg_or_zero`, `left_any`.
    fn name(&self, node: Node) -> String {
        /// A name of more letters says less than none.
        const LONG: usize = 40;
        let input = self.input(node);
        let name = self.inputs.get(input).map(plain).unwrap_or_default();
        let all: BTreeSet<Node> =
            self.terms.iter().filter(|(_, term)| term.0 == input).map(|(term, _)| *term).collect();
        let is_any = matches!(self.graph.code.steps[node], Step::Maximum { .. })
            && all.len() > 1
            && all == self.graph.operands(node).into_iter().collect();
        let term = if is_any && !self.terms.contains_key(&node) { "any".to_owned() } else { self.term(node) };
        format!("{name}_{}", if term.len() > LONG { "degree" } else { &term })
    }

    /// The input that a degree is of.
    fn input(&self, node: Node) -> usize {
        let mut node = node;
        while let Some(&operand) = self.graph.operands(node).first() {
            node = operand;
        }
        match self.graph.code.steps[node] {
            Step::Read { input, .. } => input as usize,
            _ => 0,
        }
    }

    /// What a degree is called beside its input.
    fn term(&self, node: Node) -> String {
        if let Some((_, name)) = self.terms.get(&node) {
            return (*name).to_owned();
        }
        let of: Vec<_> = self.graph.operands(node).into_iter().map(|operand| self.term(operand)).collect();
        match self.graph.code.steps[node] {
            Step::Complement { .. } => format!("not_{}", of.concat()),
            Step::Very { .. } => format!("very_{}", of.concat()),
            Step::Somewhat { .. } => format!("somewhat_{}", of.concat()),
            Step::Maximum { .. } => of.join("_or_"),
            Step::Minimum { .. } => of.join("_and_"),
            _ => "degree".to_owned(),
        }
    }

    fn operand(&self, real: Real) -> TokenStream {
        self.graph.real(real).map(|node| self.value(node)).unwrap_or_default()
    }

    fn value(&self, node: Node) -> TokenStream {
        let name = self.names.get(&node);
        quote! { #name }
    }
}
