//! The module of a network: readings in, strengths, events and outputs out.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::graph::Graph;
use super::memory::{self, EventMemory, Fields, fields};
use super::names::{Scope, plain};
use super::{Emission, columns, inference, kernel_text, layout, lints, outputs};
use crate::plan::{Input, NetworkPlan, Step};

/// A network and the names of its parts.
pub(super) struct Network<'a> {
    pub(super) plan: &'a NetworkPlan,
    pub(super) module: Ident,
    pub(super) events: Vec<Ident>,
    pub(super) outputs: Vec<Ident>,
    pub(super) inputs: Vec<Ident>,
    pub(super) memories: Vec<EventMemory>,
    /// Where each output that holds its last value keeps it, and what that is at first.
    pub(super) held: Vec<Option<(Ident, f64)>>,
}

impl<'a> Network<'a> {
    pub(super) fn new(plan: &'a NetworkPlan, module: Ident) -> Self {
        let (mut inputs, mut events) = (Scope::new(&[]), Scope::new(&["memory", "dt_ns"]));
        let (mut outputs, mut held) = (Scope::new(&[]), Scope::new(&[]));
        let graph = Graph::new(&plan.code);
        let outputs: Vec<_> = plan.outputs.iter().map(|output| outputs.snake(&output.name)).collect();
        let held = plan.outputs.iter().zip(&outputs).map(|(output, name)| {
            match graph.code.steps[graph.real(output.value)?] {
                Step::Keep { kept, .. } => {
                    let first = plan.code.kept.get(kept as usize).copied().unwrap_or_default();
                    Some((held.snake(&format!("{}_held", plain(name))), first))
                }
                _ => None,
            }
        });
        Self {
            held: held.collect(),
            outputs,
            plan,
            module,
            events: plan.events.iter().map(|event| events.snake(&event.name)).collect(),
            inputs: plan.inputs.iter().map(|input| inputs.snake(&input.name)).collect(),
            memories: plan.events.iter().map(|event| EventMemory::new(event, &graph)).collect(),
        }
    }

    /// Whether anything depends on more than the readings of one tick.
    pub(super) fn remembers(&self) -> bool {
        self.events_remember() || self.holds()
    }

    /// Whether an event does.
    pub(super) fn events_remember(&self) -> bool {
        self.memories.iter().any(EventMemory::is_kept)
    }

    /// Whether an output does.
    pub(super) fn holds(&self) -> bool {
        self.held.iter().any(Option::is_some)
    }

    /// Whether it has events, or at least nothing else.
    pub(super) fn has_events(&self) -> bool {
        !self.events.is_empty() || self.outputs.is_empty()
    }

    /// Whether it has outputs.
    pub(super) fn has_outputs(&self) -> bool {
        !self.outputs.is_empty()
    }
}

/// The module of a network.
pub(super) fn module(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let Network { plan, module, .. } = network;
    let place = format!("Network `{}`, {}.", plan.name, emission.places.place(plan.origin.span));
    let (doc, allowed, blank) = (layout::doc(&[&plan.origin.doc, &place]), lints::of_network(), layout::blank());
    let inputs = inputs(emission, network);
    let events = network.has_events().then(|| {
        let (types, strengths) = (event_types(emission, network), inference::strengths(emission, network));
        let events = events(emission, network);
        quote! { #types #strengths #events }
    });
    let outputs = network.has_outputs().then(|| {
        let (types, infer) = (outputs::types(emission, network), outputs::infer(emission, network));
        quote! { #types #infer }
    });
    let (memory, evaluate) = (memory::declared(emission, network), evaluate(emission, network));
    let columns = columns::evaluate(emission, network);
    let kernel = kernel_text::import(&quote! { #events #outputs #memory #evaluate #columns });
    quote! {
        #blank
        #doc
        #allowed
        pub mod #module {
            #kernel
            #inputs
            #events
            #outputs
            #memory
            #evaluate
            #columns
        }
    }
}

/// What the documentation of a reading says of it.
pub(super) fn about(input: &Input) -> String {
    let unit = input.unit.dimension.si_unit();
    let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
    let Input { low, high, fail, .. } = input;
    if input.unit.text == "contact" {
        return format!("1 where it is set, 0 where it is clear; {fail} where it has failed.");
    }
    format!("{low} to {high}{unit}; {fail}{unit} where it has failed.")
}

fn inputs(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let (float, blank) = (emission.float(), layout::blank());
    let inputs = network.plan.inputs.iter().zip(&network.inputs).map(|(input, name)| {
        let doc = layout::doc(&[&input.origin.doc, &about(input)]);
        quote! { #doc pub #name: #float }
    });
    let plain = emission.derives(&["Debug", "Clone", "Copy", "PartialEq"]);
    quote! {
        #blank
        /// Readings. One that is not finite counts as failed; one outside its range is taken as the nearer end.
        #plain
        pub struct Inputs { #(#inputs),* }
    }
}

fn event_types(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let (float, blank) = (emission.float(), layout::blank());
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

/// The method that weighs strengths.
fn events(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let Network { events, memories, .. } = network;
    let blank = layout::blank();
    let mut statements = TokenStream::new();
    for ((event, memory), Fields { was_set, confirm, hold }) in events.iter().zip(memories).zip(fields(network)) {
        let strength = quote! { self.#event.contributor, self.#event.detractor };
        statements.extend(match memory.hysteresis.map(|hysteresis| emission.number(hysteresis)) {
            None => quote! { let #event = kernel::outweighs(#strength); },
            Some(hysteresis) => quote! {
                let #event = kernel::outweighs_with_hysteresis(#strength, #hysteresis, memory.#was_set);
                memory.#was_set = #event;
            },
        });
        if let Some(duration) = memory.confirm.map(layout::nanoseconds) {
            statements.extend(quote! {
                let #event = kernel::Stopwatch::lasts(&mut memory.#confirm, #event, dt_ns, #duration);
            });
        }
        if let Some(duration) = memory.hold.map(layout::nanoseconds) {
            statements.extend(quote! { let #event = kernel::hold(&mut memory.#hold, #event, dt_ns, #duration); });
        }
    }
    let (doc, parameters, must_use) = if network.events_remember() {
        let dt = format_ident!("{}", if memories.iter().any(EventMemory::uses_time) { "dt_ns" } else { "_dt_ns" });
        let doc = "The events that these strengths set, `dt_ns` nanoseconds after the ones before.";
        (doc, quote! { , memory: &mut Memory, #dt: u64 }, None)
    } else {
        ("The events that these strengths set.", TokenStream::new(), Some(quote! { #[must_use] }))
    };
    let doc = layout::doc(&[doc]);
    quote! {
        #blank
        impl Strengths {
            #doc
            #must_use
            #[inline]
            pub fn events(&self #parameters) -> Events {
                #statements
                Events { #(#events),* }
            }
        }
    }
}

/// The function from readings to what the network says.
fn evaluate(emission: Emission<'_>, network: &Network<'_>) -> TokenStream {
    let (blank, safe) = (layout::blank(), inference::safe(emission, network, &inference::field(network)));
    let told = network.events_remember().then(|| quote! { memory, dt_ns });
    let holding = network.holds().then(|| quote! { , memory });
    let events = quote! { strengths(inputs).events(#told) };
    let outputs = quote! { infer(#safe #holding) };
    let (what, kind, value) = match (network.has_events(), network.has_outputs()) {
        (true, false) => ("events that readings set", quote! { Events }, events),
        (false, _) => ("outputs for readings", quote! { Outputs }, outputs),
        (true, true) => {
            ("events that readings set, and the outputs", quote! { (Events, Outputs) }, quote! { (#events, #outputs) })
        }
    };
    let (after, parameters, must_use) = if network.remembers() {
        let dt = format_ident!("{}", if network.events_remember() { "dt_ns" } else { "_dt_ns" });
        (", `dt_ns` nanoseconds after the ones before", quote! { , memory: &mut Memory, #dt: u64 }, None)
    } else {
        ("", TokenStream::new(), Some(quote! { #[must_use] }))
    };
    let doc = layout::doc(&[&format!("The {what}{after}.")]);
    quote! {
        #blank
        #doc
        #must_use
        #[inline]
        pub fn evaluate(inputs: &Inputs #parameters) -> #kind {
            #value
        }
    }
}
