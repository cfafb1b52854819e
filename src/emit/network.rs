//! The module of a network: readings in, strengths and events out.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::graph::Graph;
use super::names::{Scope, plain};
use super::{Emission, inference, kernel_text, layout, lints};
use crate::plan::{Event, Input, NetworkPlan, Step};

/// A network and the names of its parts.
pub(super) struct Network<'a> {
    pub(super) plan: &'a NetworkPlan,
    pub(super) module: Ident,
    pub(super) events: Vec<Ident>,
    pub(super) inputs: Vec<Ident>,
    memories: Vec<Memory>,
}

/// What an event remembers.
#[derive(Debug, Default)]
struct Memory {
    hysteresis: Option<f64>,
    confirm: Option<u64>,
    hold: Option<u64>,
}

impl<'a> Network<'a> {
    pub(super) fn new(plan: &'a NetworkPlan, module: Ident) -> Self {
        let (mut inputs, mut events) = (Scope::new(&[]), Scope::new(&["memory", "dt_ns"]));
        let graph = Graph::new(&plan.code);
        Self {
            plan,
            module,
            events: plan.events.iter().map(|event| events.snake(&event.name)).collect(),
            inputs: plan.inputs.iter().map(|input| inputs.snake(&input.name)).collect(),
            memories: plan.events.iter().map(|event| memory(event, &graph)).collect(),
        }
    }

    /// Whether an event depends on more than the readings of one tick.
    pub(super) fn remembers(&self) -> bool {
        self.memories.iter().any(|memory| memory.hysteresis.is_some() || memory.uses_time())
    }
}

impl Memory {
    fn uses_time(&self) -> bool {
        self.confirm.is_some() || self.hold.is_some()
    }
}

/// Goes back from an event's flag to its strengths.
fn memory(event: &Event, graph: &Graph<'_>) -> Memory {
    let mut memory = Memory::default();
    let mut flag = event.flag;
    while let Some(node) = graph.bool(flag) {
        match graph.code.steps[node] {
            Step::Hold { of, duration, .. } => (flag, memory.hold) = (of, Some(duration)),
            Step::Lasts { of, duration, .. } => (flag, memory.confirm) = (of, Some(duration)),
            Step::OutweighsWithHysteresis { hysteresis, .. } => {
                memory.hysteresis = Some(hysteresis);
                break;
            }
            _ => break,
        }
    }
    memory
}

/// The module of a network.
pub(super) fn module(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let Network { plan, module, .. } = network;
    let place = format!("Network `{}`, {}.", plan.name, emission.places.place(plan.origin.span));
    let (doc, allowed, blank) = (layout::doc(&[&plan.origin.doc, &place]), lints::of_network(), layout::blank());
    let types = types(emission, network);
    let strengths = inference::strengths(emission, network);
    let events = events(emission, network);
    let kernel = kernel_text::import(&quote! { #strengths #events });
    quote! {
        #blank
        #doc
        #allowed
        pub mod #module {
            #kernel
            #types
            #strengths
            #events
        }
    }
}

/// What the documentation of a reading says of it.
pub(super) fn about(input: &Input) -> String {
    let unit = input.unit.dimension.si_unit();
    let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
    let Input { low, high, fail, .. } = input;
    format!("{low} to {high}{unit}; {fail}{unit} where it has failed.")
}

fn types(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let (float, blank) = (emission.float(), layout::blank());
    let inputs = network.plan.inputs.iter().zip(&network.inputs).map(|(input, name)| {
        let doc = layout::doc(&[&input.origin.doc, &about(input)]);
        quote! { #doc pub #name: #float }
    });
    let plain = emission.derives(&["Debug", "Clone", "Copy", "PartialEq"]);
    let exact = emission.derives(&["Debug", "Clone", "Copy", "PartialEq", "Eq"]);
    let names = &network.events;
    let docs: Vec<_> = network
        .plan
        .events
        .iter()
        .map(|event| {
            let place = format!("Event `{}`, {}.", event.name, emission.places.place(event.origin.span));
            layout::doc(&[&event.origin.doc, &place])
        })
        .collect();
    quote! {
        #blank
        /// Readings. One that is not finite counts as failed; one outside its range is taken as the nearer end.
        #plain
        pub struct Inputs { #(#inputs),* }
        #blank
        /// Which events are set.
        #exact
        pub struct Events { #(#docs pub #names: bool),* }
        #blank
        /// How strongly the rules speak for and against each event.
        #plain
        pub struct Strengths { #(#docs pub #names: Strength),* }
        #blank
        /// How strongly rules speak for an event and against it, from 0 to 1.
        #plain
        pub struct Strength {
            /// The strength of the strongest rule for it.
            pub contributor: #float,
            /// The strength of the strongest rule against it.
            pub detractor: #float,
        }
    }
}

fn events(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let Network { events, memories, .. } = network;
    let blank = layout::blank();
    let mut scope = Scope::new(&[]);
    let (mut fields, mut initial, mut statements) = (TokenStream::new(), TokenStream::new(), TokenStream::new());
    for (event, memory) in events.iter().zip(memories) {
        let strength = quote! { self.#event.contributor, self.#event.detractor };
        let name = plain(event);
        statements.extend(match memory.hysteresis {
            None => quote! { let #event = kernel::outweighs(#strength); },
            Some(hysteresis) => {
                let (was_set, hysteresis) = (scope.snake(&format!("{name}_set")), emission.number(hysteresis));
                let doc = layout::doc(&[&format!("Whether the rules set `{name}` before.")]);
                fields.extend(quote! { #doc pub #was_set: bool, });
                initial.extend(quote! { #was_set: false, });
                quote! {
                    let #event = kernel::outweighs_with_hysteresis(#strength, #hysteresis, memory.#was_set);
                    memory.#was_set = #event;
                }
            }
        });
        let mut stopwatch = |what: &str, duration: Option<u64>, call: &dyn Fn(&Ident, &TokenStream) -> TokenStream| {
            let Some(duration) = duration else { return };
            let field = scope.snake(&format!("{name}_{what}"));
            let doc = layout::doc(&[&format!("The stopwatch of `{name}`'s `{what}`.")]);
            fields.extend(quote! { #doc pub #field: kernel::Stopwatch, });
            initial.extend(quote! { #field: kernel::Stopwatch { running: false, elapsed: 0 }, });
            let value = call(&field, &layout::nanoseconds(duration));
            statements.extend(quote! { let #event = #value; });
        };
        stopwatch("confirm", memory.confirm, &|field, duration| {
            quote! { kernel::Stopwatch::lasts(&mut memory.#field, #event, dt_ns, #duration) }
        });
        stopwatch("hold", memory.hold, &|field, duration| {
            quote! { kernel::hold(&mut memory.#field, #event, dt_ns, #duration) }
        });
    }
    if !network.remembers() {
        return quote! {
            #blank
            /// The events that readings set.
            #[must_use]
            #[inline]
            pub fn evaluate(inputs: &Inputs) -> Events {
                strengths(inputs).events()
            }
            #blank
            impl Strengths {
                /// The events that these strengths set.
                #[must_use]
                #[inline]
                pub fn events(&self) -> Events {
                    #statements
                    Events { #(#events),* }
                }
            }
        };
    }
    let dt = format_ident!("{}", if memories.iter().any(Memory::uses_time) { "dt_ns" } else { "_dt_ns" });
    let derives = emission.derives(&["Debug", "Clone", "Copy", "PartialEq", "Eq", "Default"]);
    quote! {
        #blank
        /// What events remember from one tick to the next.
        #derives
        pub struct Memory { #fields }
        #blank
        impl Memory {
            /// Before the first tick.
            #[must_use]
            pub const fn new() -> Self {
                Self { #initial }
            }
        }
        #blank
        /// The events that readings set, `dt_ns` nanoseconds after the ones before.
        #[inline]
        pub fn evaluate(inputs: &Inputs, memory: &mut Memory, dt_ns: u64) -> Events {
            strengths(inputs).events(memory, dt_ns)
        }
        #blank
        impl Strengths {
            /// The events that these strengths set, `dt_ns` nanoseconds after the ones before.
            #[inline]
            pub fn events(&self, memory: &mut Memory, #dt: u64) -> Events {
                #statements
                Events { #(#events),* }
            }
        }
    }
}
