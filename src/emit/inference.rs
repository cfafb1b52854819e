//! Degrees of membership, and what rules make of them.

use std::collections::{BTreeSet, HashMap};

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::formula::{self, Formula};
use super::graph::{Graph, Node};
use super::names::{Scope, plain};
use super::network::Network;
use super::{Emission, layout, outputs};
use crate::plan::{Real, Step};

/// The functions that weigh readings.
pub(super) fn strengths(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let Network { plan, events, .. } = network;
    let blank = layout::blank();
    let safe = safe(emission, network, &field(network));
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
    let parameters = inference.parameters(emission);
    let docs = layout::doc(&["The strengths of safe readings."]);
    quote! {
        #blank
        /// How strongly the rules speak for and against each event.
        #[must_use]
        #[inline(always)]
        pub fn strengths(inputs: &Inputs) -> Strengths {
            weigh(#safe)
        }
        #blank
        #docs
        #[inline(always)]
        pub(super) fn weigh(#parameters) -> Strengths {
            #degrees
            #(#weighed)*
            Strengths { #(#events),* }
        }
    }
}

/// The readings made safe, as arguments; `reading` is that of an input.
pub(super) fn safe(
    emission: Emission<'_>,
    network: &Network<'_>,
    reading: &impl Fn(usize) -> TokenStream,
) -> TokenStream {
    let inputs = network.plan.inputs.iter().enumerate();
    let safe = inputs.map(|(index, input)| emission.sanitized(&reading(index), &quote! { true }, input));
    quote! { #(#safe),* }
}

/// The field of an input.
pub(super) fn field(network: &Network<'_>) -> impl Fn(usize) -> TokenStream {
    |index| {
        let name = &network.inputs[index];
        quote! { inputs.#name }
    }
}

/// The rules of one side as the steps that their minima are taken over, factored.
pub(super) fn factored(rules: &[Real], graph: &Graph<'_>) -> Formula {
    let rules = rules.iter().filter_map(|&rule| graph.real(rule)).map(|rule| match &graph.code.steps[rule] {
        Step::Minimum { of, .. } => graph.real_list(of).iter().filter_map(|&real| graph.real(real)).collect(),
        _ => vec![rule],
    });
    formula::factored(&rules.collect::<Vec<_>>())
}

/// The degrees of a network and the names they are computed under.
pub(super) struct Inference<'a> {
    pub(super) graph: Graph<'a>,
    /// The term of each degree, by step: the position of its input and its name.
    terms: HashMap<Node, (usize, &'a str)>,
    inputs: &'a [Ident],
    pub(super) scope: Scope,
    pub(super) names: HashMap<Node, Ident>,
    /// The inputs that were looked at.
    pub(super) read: BTreeSet<usize>,
}

impl<'a> Inference<'a> {
    pub(super) fn new(network: &'a Network<'a>) -> Self {
        let Network { plan, inputs, events, outputs, .. } = network;
        let graph = Graph::new(&plan.code);
        let mut terms = HashMap::new();
        for (input, degrees) in plan.degrees.iter().enumerate() {
            for (name, real) in degrees {
                if let Some(node) = graph.real(*real) {
                    terms.insert(node, (input, name.as_str()));
                }
            }
        }
        // Degrees are looked at until the last event is weighed and the last output is known.
        let ours: Vec<String> = inputs.iter().chain(events).chain(outputs).map(plain).collect();
        let scope = Scope::new(&ours.iter().map(String::as_str).collect::<Vec<_>>());
        Self { graph, terms, inputs, scope, names: HashMap::new(), read: BTreeSet::new() }
    }

    /// The inputs as parameters. One that no rule looks at is taken all the same.
    pub(super) fn parameters(&self, emission: Emission<'_>) -> TokenStream {
        let float = emission.float();
        let names = self.inputs.iter().enumerate();
        let names =
            names.map(
                |(index, name)| {
                    if self.read.contains(&index) { name.clone() } else { format_ident!("_{}", plain(name)) }
                },
            );
        quote! { #(#names: #float),* }
    }

    /// A statement for each degree that is used, and for each strength that is made of them.
    pub(super) fn degrees(&mut self, emission: Emission<'_>, used: &BTreeSet<Node>) -> TokenStream {
        let mut statements = TokenStream::new();
        for node in self.graph.needed(used.iter().copied(), &self.names.keys().copied().collect()) {
            if let Step::Read { input, .. } = self.graph.code.steps[node] {
                self.names.insert(node, self.inputs[input as usize].clone());
                self.read.insert(input as usize);
            } else {
                let (name, value) = (self.name(node), self.operation(emission, node));
                statements.extend(self.named(node, &name, &value));
            }
        }
        statements
    }

    /// A statement that gives the value of a step a name.
    pub(super) fn named(&mut self, node: Node, name: &str, value: &TokenStream) -> TokenStream {
        let name = self.scope.snake(name);
        let statement = quote! { let #name = #value; };
        self.names.insert(node, name);
        statement
    }

    /// A step of degrees or strengths whose operands have names.
    pub(super) fn operation(&self, emission: Emission<'_>, node: Node) -> TokenStream {
        match &self.graph.code.steps[node] {
            Step::Degree { of, shape, .. } => emission.degree(&self.operand(*of), shape, &self.graph),
            Step::Complement { of, .. } => {
                let degree = self.operand(*of);
                quote! { 1.0 - #degree }
            }
            Step::Very { of, .. } => self.call("very", &[*of]),
            Step::Somewhat { of, .. } => self.call("somewhat", &[*of]),
            Step::TNorm { norm, left, right, .. } => self.call(outputs::t_norm(*norm), &[*left, *right]),
            Step::SNorm { norm, left, right, .. } => self.call(outputs::s_norm(*norm), &[*left, *right]),
            Step::Weigh { of, weight, .. } => {
                let (of, weight) = (self.operand(*of), emission.number(*weight));
                quote! { kernel::product(#of, #weight) }
            }
            step @ (Step::Minimum { of, .. } | Step::Maximum { of, .. }) => {
                let of = self.graph.real_list(of).iter().filter_map(|&real| self.graph.real(real));
                let of = of.map(Formula::Value).collect();
                let is_minimum = matches!(step, Step::Minimum { .. });
                let formula = if is_minimum { Formula::Minimum(of) } else { Formula::Maximum(of) };
                formula.tokens(&|node| self.value(node))
            }
            _ => TokenStream::new(),
        }
    }

    fn call(&self, function: &str, of: &[Real]) -> TokenStream {
        let (function, of) = (format_ident!("{function}"), of.iter().map(|&of| self.operand(of)));
        quote! { kernel::#function(#(#of),*) }
    }

    /// `left_neg`, `left_not_neg`, `left_neg_or_zero`, `left_any`; `antecedent` for what is said of several inputs.
    fn name(&self, node: Node) -> String {
        /// A name of more letters says less than none.
        const LONG: usize = 40;
        if self.inputs_of(node).len() > 1 {
            return "antecedent".to_owned();
        }
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

    /// The input that a degree is of, the first of several.
    pub(super) fn input(&self, node: Node) -> usize {
        let mut node = node;
        while let Some(&operand) = self.graph.operands(node).first() {
            node = operand;
        }
        match self.graph.code.steps[node] {
            Step::Read { input, .. } => input as usize,
            _ => 0,
        }
    }

    fn inputs_of(&self, node: Node) -> BTreeSet<u32> {
        let needed = self.graph.needed([node], &BTreeSet::new()).into_iter();
        let read = needed.filter_map(|node| match self.graph.code.steps[node] {
            Step::Read { input, .. } => Some(input),
            _ => None,
        });
        read.collect()
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

    pub(super) fn operand(&self, real: Real) -> TokenStream {
        self.graph.real(real).map(|node| self.value(node)).unwrap_or_default()
    }

    pub(super) fn value(&self, node: Node) -> TokenStream {
        let name = self.names.get(&node);
        quote! { #name }
    }
}
