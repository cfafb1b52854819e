//! The module of a diagram: its types. What a tick does stands in `step.rs`.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::network;
use super::wiring::{Says, Wiring};
use super::{Emission, arbiter, kernel_text, layout, lints, step};
use crate::plan::{Action, Grouping, Step, Ties};

/// The module of a diagram.
pub(super) fn module(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let (plan, name) = (wiring.plan, &wiring.module);
    let kind = if plan.arbiter.is_some() { "Arbiter" } else { "Behavior" };
    let place = format!("{kind} `{}` on `{}`, {}.", plan.name, plan.robot, emission.places.place(plan.origin.span));
    let (doc, allowed, blank) = (layout::doc(&[&plan.origin.doc, &place]), lints::of_diagram(), layout::blank());
    let (inputs, robot) = (inputs(emission, wiring), robot(emission, wiring));
    let (state, machine) = (state(emission, wiring), machine(emission, wiring));
    let adapters = match plan.arbiter {
        Some(_) => arbiter::proposals(emission, wiring),
        None => wiring.adapters(emission),
    };
    let kernel = kernel_text::import(&quote! { #inputs #machine });
    quote! {
        #blank
        #doc
        #allowed
        pub mod #name {
            #kernel
            #inputs
            #robot
            #adapters
            #state
            #machine
        }
    }
}

fn inputs(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let (float, blank) = (emission.float(), layout::blank());
    let plain = emission.derives(&["Debug", "Clone", "Copy", "PartialEq"]);
    let names = |used: &BTreeSet<u32>| -> Vec<(u32, Ident)> {
        used.iter().map(|&input| (input, wiring.sensors[input as usize].clone())).collect()
    };
    let readings = names(&wiring.read).into_iter().map(|(input, name)| {
        let input = &wiring.plan.inputs[input as usize];
        let doc = layout::doc(&[&input.origin.doc, &network::about(input)]);
        quote! { #doc pub #name: #float, }
    });
    let safe = names(&wiring.read).into_iter().map(|(input, name)| {
        let input = &wiring.plan.inputs[input as usize];
        let value = emission.sanitized(&quote! { self.#name }, &quote! { !self.failed.#name }, input);
        quote! { #[inline] fn #name(&self) -> #float { #value } }
    });
    let logical = wiring.grouped.iter().filter_map(|&node| {
        let name = wiring.reading(node)?;
        let of = wiring.graph.operands(node).into_iter().filter_map(|member| wiring.reading(member).cloned());
        let Step::Group { how, .. } = wiring.graph.code.steps[node] else { return None };
        let value = grouped(emission, how, &quote! { #(self.#of()),* });
        Some(quote! { #[inline] fn #name(&self) -> #float { #value } })
    });
    let weighed = wiring.senses.iter().filter_map(|sense| {
        let (name, network) = (sense.method.as_ref()?, &sense.network.module);
        let averaged = wiring.averages(sense);
        let averaged = quote! { #(, #averaged: #float)* };
        let readings = sense.readings.iter().filter_map(|&node| match wiring.averaged(node) {
            Some(name) => Some(quote! { #name }),
            None => wiring.reading(node).map(|name| quote! { self.#name() }),
        });
        let memory = sense.remembers().then(|| quote! { , memory: &mut super::#network::Memory });
        let readings = quote! { #(#readings),* };
        Some(match sense.says {
            Says::Events => {
                let (dt, told) = memory.is_some().then(|| (quote! { , dt_ns: u64 }, quote! { memory, dt_ns })).unzip();
                let events = quote! { super::#network::weigh(#readings).events(#told) };
                quote! { #[inline] fn #name(&self #averaged #memory #dt) -> super::#network::Events { #events } }
            }
            Says::Outputs => {
                let told = memory.is_some().then(|| quote! { , memory });
                let outputs = quote! { super::#network::infer(#readings #told) };
                quote! { #[inline] fn #name(&self #averaged #memory) -> super::#network::Outputs { #outputs } }
            }
        })
    });
    let methods: Vec<_> = safe.chain(logical).chain(weighed).chain(wiring.told()).collect();
    let safe = (!methods.is_empty()).then(|| {
        let methods = layout::apart(&methods);
        quote! {
            #blank
            /// Readings made safe, and what networks say of them.
            impl Inputs { #methods }
        }
    });
    let health = names(&wiring.watched);
    let failed = (!health.is_empty()).then(|| {
        quote! {
            /// Which sensors are known to have failed.
            pub failed: Failed,
        }
    });
    let done = wiring.uses_done.then(|| {
        quote! {
            /// Whether the action of the active mode had reported completion by the end of the tick before.
            pub done: bool,
        }
    });
    let failures = (!health.is_empty()).then(|| {
        let derives = emission.derives(&["Debug", "Clone", "Copy", "PartialEq", "Eq", "Default"]);
        let fields = health.iter().map(|(input, name)| {
            let doc = layout::doc(&[&format!("Whether `{}` has.", wiring.plan.inputs[*input as usize].name)]);
            quote! { #doc pub #name: bool }
        });
        quote! {
            #blank
            /// The sensors that are known to have failed; by default none.
            #derives
            pub struct Failed { #(#fields),* }
        }
    });
    quote! {
        #blank
        /// What the machine is told on one tick. A reading that is not finite is taken as that of a failed sensor; one
        /// outside its range as the nearer end.
        #plain
        pub struct Inputs { #(#readings)* #failed #done }
        #safe
        #failures
    }
}

/// One reading of several.
pub(super) fn grouped(emission: Emission<'_>, how: Grouping, readings: &TokenStream) -> TokenStream {
    let readings = quote! { &[#readings] };
    match how {
        Grouping::Minimum => quote! { kernel::smallest_reading(#readings) },
        Grouping::Maximum => quote! { kernel::largest_reading(#readings) },
        Grouping::Mean => quote! { kernel::mean_reading(#readings) },
        Grouping::Median => quote! { kernel::median_reading(#readings) },
        Grouping::Widest { beyond, first, spacing } => {
            let [beyond, first, spacing] = [beyond, first, spacing].map(|number| emission.number(number));
            quote! { kernel::widest_opening(#readings, #beyond, #first, #spacing) }
        }
    }
}

fn robot(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let (blank, float) = (layout::blank(), emission.float());
    let methods = wiring.actions.iter().map(|(action, names)| {
        let Action { name, origin, parameters, reports_done } = &wiring.plan.actions[*action as usize];
        let units = parameters.iter().zip(&names.parameters).map(|((_, unit), name)| {
            let unit = unit.dimension.si_unit();
            if unit == "1" { format!("`{name}` is a plain number") } else { format!("`{name}` is in {unit}") }
        });
        let mut notes: Vec<_> = units.collect();
        if *reports_done {
            notes.push("`start` is true on the tick that gives the command, and false while it goes on".to_owned());
        }
        let notes = if notes.is_empty() { String::new() } else { notes.join("; ") + "." };
        let place = format!("Action `{name}`, {}.", emission.places.place(origin.span));
        let doc = layout::doc(&[&origin.doc, &notes, &place]);
        let (name, parameters) = (&names.method, &names.parameters);
        let start = reports_done.then(|| quote! { start: bool });
        quote! { #doc fn #name(&mut self, #(#parameters: #float,)* #start) -> Result<(), Self::Error>; }
    });
    let (who, how) = if wiring.plan.arbiter.is_some() {
        ("arbiter", "At most one command is given on a tick.")
    } else {
        ("behavior", "Every command of a tick is given on that tick, also where one before it has failed.")
    };
    let doc = layout::doc(&[&format!("What the {who} asks of `{}`. Numbers are in SI units.", wiring.plan.robot), how]);
    quote! {
        #blank
        #doc
        pub trait Robot {
            /// What can go wrong with an action; `core::convert::Infallible` where nothing can.
            type Error;
            #(#methods)*
        }
    }
}

fn state(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let blank = layout::blank();
    let modes: Vec<_> = wiring.plan.modes.iter().zip(&wiring.modes).collect();
    let documented = modes.iter().map(|(mode, parts)| {
        let place = format!("Mode `{}`, {}.", mode.name, emission.places.place(mode.origin.span));
        let (doc, variant) = (layout::doc(&[&mode.origin.doc, &place]), &parts.variant);
        quote! { #doc #variant }
    });
    let variants: Vec<_> = modes.iter().map(|(_, parts)| &parts.variant).collect();
    let names = modes.iter().map(|(mode, _)| &mode.name);
    let states = modes.iter().map(|(mode, parts)| {
        let fields = wiring.fields_of(parts, emission).into_iter().map(|field| {
            let (doc, name, kind) = (layout::doc(&[&field.doc]), field.name, field.kind);
            quote! { #doc #name: #kind }
        });
        let fields: Vec<_> = fields.collect();
        let (doc, variant) = (layout::doc(&[&format!("In `{}`.", mode.name)]), &parts.variant);
        if fields.is_empty() {
            quote! { #doc #variant }
        } else {
            quote! { #doc #variant { #(#fields),* } }
        }
    });
    let [modes, active] = if wiring.plan.arbiter.is_some() {
        ["Who can have the robot.", "Who has the robot."]
    } else {
        ["The modes.", "The active mode, and what it remembers since it was entered."]
    };
    let [modes, active] = [modes, active].map(|text| layout::doc(&[text]));
    let (mode, state) = (
        emission.derives(&["Debug", "Clone", "Copy", "PartialEq", "Eq", "Hash"]),
        emission.derives(&["Debug", "Clone", "Copy", "PartialEq"]),
    );
    quote! {
        #blank
        #modes
        #mode
        pub enum Mode { #(#documented),* }
        #blank
        impl Mode {
            /// The name in the source.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self { #(Self::#variants => #names),* }
            }
        }
        #blank
        #active
        #state
        pub enum State { #(#states),* }
        #blank
        impl State {
            /// The mode alone.
            #[must_use]
            pub const fn mode(&self) -> Mode {
                match self { #(Self::#variants { .. } => Mode::#variants),* }
            }
        }
    }
}

fn machine(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let blank = layout::blank();
    let fields = wiring.fields(emission);
    let declared = fields.iter().map(|field| {
        let (doc, name, kind) = (layout::doc(&[&field.doc]), &field.name, &field.kind);
        quote! { #doc pub #name: #kind }
    });
    let initial = fields.iter().map(|field| {
        let (name, initial) = (&field.name, field.initial.iter());
        quote! { #name #(: #initial)* }
    });
    let is_drawn_from = wiring.plan.arbiter.as_ref().is_none_or(|arbiter| arbiter.ties == Ties::Random);
    let random = (wiring.draws && is_drawn_from).then(|| {
        quote! {
            /// The state of the stream of random numbers.
            pub random: u64,
        }
    });
    let (seed, seeded) =
        (wiring.draws.then(|| quote! { seed: u64 }), random.as_ref().map(|_| quote! { random: seed, }));
    let before = "A machine before its first tick.";
    let doc = layout::doc(&[&if wiring.draws {
        format!("{before} Everything random follows from `seed`.")
    } else {
        before.to_owned()
    }]);
    let derives = emission.derives(&["Debug", "Clone", "Copy", "PartialEq"]);
    let default = (!wiring.draws).then(|| {
        quote! {
            #blank
            impl Default for Machine {
                fn default() -> Self {
                    Self::new()
                }
            }
        }
    });
    let step = match &wiring.plan.arbiter {
        Some(arbiter) => arbiter::step(emission, wiring, arbiter),
        None => step::methods(emission, wiring),
    };
    let seeds = wiring.seeded_clients();
    let constant = seeds.is_none().then(|| quote! { const });
    quote! {
        #blank
        /// The behavior being run. It is plain data: a copy is a saved state, and assigning it restores it.
        #derives
        pub struct Machine {
            /// The active mode and what it remembers; `None` before the first tick.
            pub state: Option<State>,
            #random
            #(#declared),*
        }
        #default
        #blank
        impl Machine {
            #doc
            #[must_use]
            pub #constant fn new(#seed) -> Self {
                #seeds
                Self { state: None, #seeded #(#initial),* }
            }
            #blank
            /// The active mode; `None` before the first tick.
            #[must_use]
            pub const fn mode(&self) -> Option<Mode> {
                match &self.state {
                    Some(state) => Some(state.mode()),
                    None => None,
                }
            }
            #step
        }
    }
}
