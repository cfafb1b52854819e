//! Continuous outputs of a network: the strengths of their sets, and the numbers that come of them.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::defuzzify::{self, Number};
use super::formula::Formula;
use super::graph::{Graph, Node};
use super::inference::{Inference, factored};
use super::names::plain;
use super::network::Network;
use super::{Emission, layout};
use crate::plan::{Output, Real, SNorm, Step, TNorm};

/// The types of outputs.
pub(super) fn types(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let (float, blank) = (emission.float(), layout::blank());
    let plain = emission.derives(&["Debug", "Clone", "Copy", "PartialEq"]);
    let fields = network.plan.outputs.iter().zip(&network.outputs).map(|(output, name)| {
        let unit = output.unit.dimension.si_unit();
        let unit = if unit == "1" { String::new() } else { format!(" in {unit}") };
        let place = format!("Output `{}`{unit}, {}.", output.name, emission.places.place(output.origin.span));
        let doc = layout::doc(&[&output.origin.doc, &place]);
        quote! { #doc pub #name: Output }
    });
    quote! {
        #blank
        /// The outputs.
        #plain
        pub struct Outputs { #(#fields),* }
        #blank
        /// A number for an action to take.
        #plain
        pub struct Output {
            /// The number.
            pub value: #float,
            /// Whether a rule fired; where none did, the number is the output's default.
            pub fired: bool,
        }
    }
}

/// The function that infers outputs from safe readings.
pub(super) fn infer(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let Network { plan, outputs, .. } = network;
    let blank = layout::blank();
    let mut inference = Inference::new(network);
    let memory = network.holds().then(|| inference.scope.snake("memory"));
    let sets: Vec<_> = plan.outputs.iter().map(|output| sets(output, &inference.graph)).collect();
    let used = sets.iter().flatten().flat_map(|set| operands(set.of, &inference.graph));
    let used: BTreeSet<Node> = used.collect();
    let inputs: BTreeSet<Node> = sets.iter().flatten().flat_map(|set| expressed(set.value, &inference.graph)).collect();
    let degrees = inference.degrees(emission, &used.union(&inputs).copied().collect());
    let computed =
        plan.outputs.iter().zip(outputs).zip(&sets).zip(&network.held).map(|(((output, name), sets), held)| {
            let computed = Computed { emission, output, name, sets };
            computed.written(&mut inference, held.as_ref().map(|(field, _)| quote! { #memory.#field }))
        });
    let computed: Vec<_> = computed.collect();
    let values = network.outputs.iter().zip(&computed).map(|(name, Written { fired, .. })| {
        quote! { #name: Output { value: #name, fired: #fired } }
    });
    let values: Vec<_> = values.collect();
    let statements = computed.iter().map(|written| &written.statements);
    let constants = computed.iter().map(|written| &written.constants).filter(|constants| !constants.is_empty());
    let (parameters, memory) = (inference.parameters(emission), memory.iter());
    quote! {
        #(#blank #constants)*
        #blank
        /// The outputs of safe readings.
        #[inline(always)]
        pub(super) fn infer(#parameters #(, #memory: &mut Memory)*) -> Outputs {
            #degrees
            #(#statements)*
            Outputs { #(#values),* }
        }
    }
}

/// A set, or an expression, and how strongly its rules hold.
struct Set {
    /// What its strength is called behind its output.
    name: String,
    of: Node,
    /// Its expression.
    value: Option<Node>,
}

/// What the rules of an output name, each strength once.
fn sets(output: &Output, graph: &Graph<'_>) -> Vec<Set> {
    let mut sets: Vec<Set> = Vec::new();
    let mut add = |name: &str, strength: Real, value: Option<Real>| {
        if let Some(of) = graph.real(strength) {
            sets.push(Set { name: name.to_owned(), of, value: value.and_then(|value| graph.real(value)) });
        }
    };
    for (name, strength) in &output.sets {
        add(name, *strength, None);
    }
    if let (true, Some(Step::Mean { weights, values, .. })) = (output.sets.is_empty(), core(output, graph).step(graph))
    {
        for (&weight, &value) in graph.real_list(weights).iter().zip(graph.real_list(values)) {
            add("rule", weight, Some(value));
        }
    }
    sets
}

/// How the number of an output comes about, from the last step back.
struct Core {
    limit: Option<(f64, f64)>,
    otherwise: Option<f64>,
    of: Option<Node>,
}

impl Core {
    fn step<'a>(&self, graph: &Graph<'a>) -> Option<&'a Step> {
        self.of.map(|node| &graph.code.steps[node])
    }
}

fn core(output: &Output, graph: &Graph<'_>) -> Core {
    let mut core = Core { limit: None, otherwise: None, of: graph.real(output.value) };
    while let Some(step) = core.step(graph) {
        match *step {
            Step::Otherwise { of, otherwise, .. } => {
                core.otherwise = Some(otherwise);
                core.of = graph.real(of);
            }
            Step::Keep { of, .. } => core.of = graph.real(of),
            Step::Limit { of, low, high, .. } => {
                core.limit = Some((low, high));
                core.of = graph.real(of);
            }
            _ => break,
        }
    }
    core
}

/// What a strength is computed from once its operands have names.
fn strength(of: Node, inference: &Inference<'_>) -> Formula {
    let graph = &inference.graph;
    let formula = match &graph.code.steps[of] {
        Step::Maximum { of, .. } => factored(graph.real_list(of), graph),
        Step::Minimum { to, .. } => factored(&[*to], graph),
        _ => Formula::Value(of),
    };
    formula.sorted(&|node| (inference.input(node), node))
}

/// What must have a name before a strength is computed.
fn operands(of: Node, graph: &Graph<'_>) -> Vec<Node> {
    match &graph.code.steps[of] {
        Step::Maximum { of, .. } => factored(graph.real_list(of), graph).values(),
        Step::Minimum { .. } | Step::TNorm { .. } | Step::SNorm { .. } | Step::Weigh { .. } => graph.operands(of),
        _ => vec![of],
    }
}

/// The inputs of an expression.
fn expressed(value: Option<Node>, graph: &Graph<'_>) -> Vec<Node> {
    value.map(|value| graph.operands(value)).unwrap_or_default()
}

/// What binds the value of an output to its name.
struct Written {
    constants: TokenStream,
    statements: TokenStream,
    /// The name of what says whether a rule fired.
    fired: Ident,
}

/// An output being written.
struct Computed<'a> {
    emission: Emission<'a>,
    output: &'a Output,
    name: &'a Ident,
    sets: &'a [Set],
}

impl Computed<'_> {
    fn written(&self, inference: &mut Inference<'_>, held: Option<TokenStream>) -> Written {
        let Self { emission, output, name, sets } = *self;
        let (blank, place) = (layout::blank(), emission.places.place(output.origin.span));
        let heading = layout::comment(&format!("output {}, {place}", output.name));
        let rules = output.rules.iter().map(|&rule| {
            let (text, line) = (emission.places.text(rule), emission.places.line(rule));
            layout::comment(&format!("  {line}: {text}"))
        });
        let mut statements = quote! { #blank #heading #(#rules)* };
        // What this output calls a strength, no other does.
        let names = inference.names.clone();
        for set in sets {
            let value = match strength(set.of, inference) {
                _ if inference.names.contains_key(&set.of) => inference.value(set.of),
                Formula::Value(of) if of == set.of => inference.operation(emission, of),
                formula => formula.tokens(&|node| inference.value(node)),
            };
            statements.extend(inference.named(set.of, &format!("{}_{}", plain(name), set.name), &value));
        }
        let mut strongest: Vec<_> = sets.iter().map(|set| set.of).collect();
        strongest.sort_unstable();
        strongest.dedup();
        let strongest = Formula::Maximum(strongest.into_iter().map(Formula::Value).collect());
        let strongest = strongest.tokens(&|node| inference.value(node));
        let fired = inference.scope.snake(&format!("{}_fired", plain(name)));
        statements.extend(quote! { let #fired = kernel::fires(#strongest); });

        let core = core(output, &inference.graph);
        let Number { constants, statements: before, value } =
            core.of.map(|of| defuzzify::number(emission, inference, name, of)).unwrap_or_default();
        let value = match core.limit {
            Some((low, high)) => {
                let [low, high] = [low, high].map(|end| emission.number(end));
                quote! { kernel::limit(#value, #low, #high) }
            }
            None => value,
        };
        let otherwise = emission.number(core.otherwise.unwrap_or_default());
        inference.names = names;
        statements.extend(before);
        statements.extend(match held {
            Some(held) => quote! { if #fired { #held = #value; } let #name = #held; },
            None => quote! { let #name = if #fired { #value } else { #otherwise }; },
        });
        Written { constants, statements, fired }
    }
}

impl Inference<'_> {
    /// Names for strengths that are computed from those of sets, and the statements that do it.
    pub(super) fn strengths(&mut self, of: &[Real], output: &Ident) -> TokenStream {
        let mut statements = TokenStream::new();
        for node in of.iter().filter_map(|&real| self.graph.real(real)).collect::<BTreeSet<_>>() {
            if self.names.contains_key(&node) {
                continue;
            }
            let prefix = format!("{}_", plain(output));
            let operands = self.graph.operands(node).into_iter().filter_map(|operand| self.names.get(&operand));
            let joined = operands.map(|name| plain(name).trim_start_matches(&prefix).to_owned()).collect::<Vec<_>>();
            let formula = strength(node, self);
            let value = formula.tokens(&|node| self.value(node));
            statements.extend(self.named(node, &format!("{prefix}{}", joined.join("_and_")), &value));
        }
        statements
    }

    /// Whether a strength is sure to be from 0 to 1, however it is rounded.
    pub(super) fn is_degree(&self, node: Node) -> bool {
        let graph = &self.graph;
        graph.needed([node], &BTreeSet::new()).into_iter().all(|node| match &graph.code.steps[node] {
            Step::TNorm { norm, .. } => !matches!(norm, TNorm::Einstein | TNorm::Hamacher),
            Step::SNorm { norm, .. } => !matches!(norm, SNorm::Einstein | SNorm::Hamacher),
            _ => true,
        })
    }
}

/// The kernel's name for a t-norm.
pub(super) fn t_norm(norm: TNorm) -> &'static str {
    match norm {
        TNorm::Minimum => "minimum",
        TNorm::Product => "product",
        TNorm::Bounded => "bounded_difference",
        TNorm::Drastic => "drastic_product",
        TNorm::Einstein => "einstein_product",
        TNorm::Hamacher => "hamacher_product",
        TNorm::Nilpotent => "nilpotent_minimum",
    }
}

/// The kernel's name for an s-norm.
pub(super) fn s_norm(norm: SNorm) -> &'static str {
    match norm {
        SNorm::Maximum => "maximum",
        SNorm::Probabilistic => "probabilistic_sum",
        SNorm::Bounded => "bounded_sum",
        SNorm::Drastic => "drastic_sum",
        SNorm::Einstein => "einstein_sum",
        SNorm::Hamacher => "hamacher_sum",
        SNorm::Nilpotent => "nilpotent_maximum",
    }
}

/// The kernel's functions of these names.
pub(super) fn functions(names: [&str; 2]) -> [TokenStream; 2] {
    names.map(|name| {
        let name = format_ident!("{name}");
        quote! { kernel::#name }
    })
}
