//! What a network remembers from one tick to the next.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::graph::Graph;
use super::names::{Scope, plain};
use super::network::Network;
use super::{Emission, layout};
use crate::plan::{Event, Step};

/// What an event remembers.
#[derive(Default)]
pub(super) struct EventMemory {
    pub(super) hysteresis: Option<f64>,
    pub(super) confirm: Option<u64>,
    pub(super) hold: Option<u64>,
}

impl EventMemory {
    /// Goes back from an event's flag to its strengths.
    pub(super) fn new(event: &Event, graph: &Graph<'_>) -> Self {
        let mut memory = Self::default();
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

    pub(super) fn is_kept(&self) -> bool {
        self.hysteresis.is_some() || self.uses_time()
    }

    pub(super) fn uses_time(&self) -> bool {
        self.confirm.is_some() || self.hold.is_some()
    }
}

/// What is kept from one tick to the next.
pub(super) fn declared(emission: Emission<'_>, network: &Network<'_>) -> Option<TokenStream> {
    if !network.remembers() {
        return None;
    }
    let (float, blank) = (emission.float(), layout::blank());
    let mut of: Vec<(String, Ident, TokenStream, TokenStream)> = Vec::new();
    for (event, Fields { was_set, confirm, hold }) in network.events.iter().zip(fields(network)) {
        let name = plain(event);
        if let Some(field) = was_set {
            of.push((format!("Whether the rules set `{name}` before."), field, quote! { bool }, quote! { false }));
        }
        for (what, field) in [("confirm", confirm), ("hold", hold)] {
            let stopped = quote! { kernel::Stopwatch { running: false, elapsed: 0 } };
            let doc = format!("The stopwatch of `{name}`'s `{what}`.");
            of.extend(field.map(|field| (doc, field, quote! { kernel::Stopwatch }, stopped)));
        }
    }
    for (output, held) in network.outputs.iter().zip(&network.held) {
        let doc = format!("What `{}` was when a rule fired last.", plain(output));
        of.extend(
            held.iter().map(|(field, first)| (doc.clone(), field.clone(), quote! { #float }, emission.number(*first))),
        );
    }
    let fields = of.iter().map(|(doc, field, kind, _)| {
        let doc = layout::doc(&[doc]);
        quote! { #doc pub #field: #kind }
    });
    let initial = of.iter().map(|(_, field, _, first)| quote! { #field: #first });
    let (derives, default) = if network.holds() {
        let default = quote! {
            #blank
            impl Default for Memory {
                fn default() -> Self {
                    Self::new()
                }
            }
        };
        (emission.derives(&["Debug", "Clone", "Copy", "PartialEq"]), Some(default))
    } else {
        (emission.derives(&["Debug", "Clone", "Copy", "PartialEq", "Eq", "Default"]), None)
    };
    let whose = match (network.events_remember(), network.holds()) {
        (true, true) => "events and outputs",
        (true, false) => "events",
        (false, _) => "outputs",
    };
    let doc = layout::doc(&[&format!("What {whose} remember from one tick to the next.")]);
    Some(quote! {
        #blank
        #doc
        #derives
        pub struct Memory { #(#fields),* }
        #default
        #blank
        impl Memory {
            /// Before the first tick.
            #[must_use]
            pub const fn new() -> Self {
                Self { #(#initial),* }
            }
        }
    })
}

/// The fields of an event's memory.
pub(super) struct Fields {
    pub(super) was_set: Option<Ident>,
    pub(super) confirm: Option<Ident>,
    pub(super) hold: Option<Ident>,
}

pub(super) fn fields(network: &Network<'_>) -> Vec<Fields> {
    let mut scope = Scope::new(&[]);
    let events = network.events.iter().zip(&network.memories).map(|(event, memory)| {
        let mut field = |what: &str, is_kept: bool| is_kept.then(|| scope.snake(&format!("{}_{what}", plain(event))));
        Fields {
            was_set: field("set", memory.hysteresis.is_some()),
            confirm: field("confirm", memory.confirm.is_some()),
            hold: field("hold", memory.hold.is_some()),
        }
    });
    events.collect()
}
