//! An arbiter: its clients propose, and one of them or an emergency has the robot (Sobh et al. 2000, section 3.3).

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::block::Block;
use super::graph::Node;
use super::kept::Field;
use super::names::{Scope, plain};
use super::step::{self, Time};
use super::wiring::{ActionNames, Wiring};
use super::{Emission, layout};
use crate::plan::{Arbiter, Client, Emergency, Plan, Ties};

/// How a client is named.
pub(super) struct ClientParts {
    /// Its machine, and what it proposes on a tick.
    pub(super) field: Ident,
    /// Where it is kept that it lost, if the client asks for that.
    lost: Option<Ident>,
}

/// The local names that an arbiter uses.
pub(super) const OURS: [&str; 7] = ["seed", "seeds", "levels", "winner", "emergency", "next", "changed"];

/// The names of all clients.
pub(super) fn clients(plan: &Plan, inner: &[Rc<Wiring<'_>>], locals: &mut Scope) -> Vec<ClientParts> {
    let clients = plan.arbiter.iter().flat_map(|arbiter| arbiter.clients.iter().map(|client| (client, arbiter.lost)));
    let parts = clients.zip(inner).map(|((client, lost), wiring)| ClientParts {
        field: locals.snake(&client.name),
        lost: lost.filter(|lost| wiring.read.contains(lost)).map(|_| locals.snake(&format!("{}_lost", client.name))),
    });
    parts.collect()
}

impl Wiring<'_> {
    /// The fields of the machine for its clients.
    pub(super) fn fields_of_clients(&self) -> Vec<Field> {
        let clients = self.clients.iter().zip(&self.inner).flat_map(|(ClientParts { field, lost }, wiring)| {
            let module = &wiring.module;
            // One with random numbers gets a stream of its own.
            let machine = Field {
                doc: format!("The client `{}`.", plain(field)),
                name: field.clone(),
                kind: quote! { super::#module::Machine },
                initial: (!wiring.draws).then(|| quote! { super::#module::Machine::new() }),
            };
            let lost = lost.as_ref().map(|lost| Field {
                doc: format!("Whether another command was executed than that of `{}`.", plain(field)),
                name: lost.clone(),
                kind: quote! { bool },
                initial: Some(quote! { false }),
            });
            std::iter::once(machine).chain(lost)
        });
        clients.collect()
    }

    /// Statements that make the clients with random numbers; every client has a stream, also one that draws nothing.
    pub(super) fn seeded_clients(&self) -> Option<TokenStream> {
        let last = self.clients.iter().zip(&self.inner).rposition(|(_, wiring)| wiring.draws)?;
        let made = self.clients.iter().zip(&self.inner).take(last + 1).map(|(ClientParts { field, .. }, wiring)| {
            let (module, seed) = (&wiring.module, quote! { kernel::next_random(&mut seeds) });
            if wiring.draws {
                quote! { let #field = super::#module::Machine::new(#seed); }
            } else {
                quote! { #seed; }
            }
        });
        Some(quote! { let mut seeds = seed; #(#made)* })
    }
}

/// What a client asks for, and how it is noted and given.
pub(super) fn proposals(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let (blank, float) = (layout::blank(), emission.float());
    let mut variants = Scope::new(&["Self"]);
    let actions = wiring.actions.iter().map(|(&action, names)| {
        let declared = &wiring.plan.actions[action as usize];
        (action, (variants.camel(&declared.name), names, declared.reports_done))
    });
    let actions: BTreeMap<u32, (Ident, &ActionNames, bool)> = actions.collect();
    let start = |reports_done: &bool| reports_done.then(|| quote! { start });
    let asked: BTreeSet<u32> = wiring.inner.iter().flat_map(|inner| inner.actions.keys().copied()).collect();
    let asked = || actions.iter().filter(|(action, _)| asked.contains(action)).map(|(_, parts)| parts);
    let declared = asked().map(|(variant, ActionNames { method, parameters }, reports_done)| {
        let doc = layout::doc(&[&format!("See [`Robot::{method}`].")]);
        let start = start(reports_done).map(|start| quote! { #start: bool });
        let fields = parameters.iter().map(|name| quote! { #name: #float }).chain(start);
        let fields: Vec<_> = fields.collect();
        if fields.is_empty() {
            quote! { #doc #variant }
        } else {
            quote! { #doc #variant { #(#fields),* } }
        }
    });
    let given = asked().map(|(variant, ActionNames { method, parameters }, reports_done)| {
        let fields: Vec<_> = parameters.iter().map(|name| quote! { #name }).chain(start(reports_done)).collect();
        let pattern = (!fields.is_empty()).then(|| quote! { { #(#fields),* } });
        let start = start(reports_done).map(|start| quote! { #start || changed });
        quote! { Some(Command::#variant #pattern) => robot.#method(#(#parameters,)* #start) }
    });
    let given: Vec<_> = given.collect();
    let (robot, given) = if given.is_empty() {
        (format_ident!("_robot"), quote! { Ok(()) })
    } else {
        (format_ident!("robot"), quote! { match self.0 { None => Ok(()), #(#given,)* } })
    };
    let changed = format_ident!("{}changed", if asked().any(|(.., reports_done)| *reports_done) { "" } else { "_" });
    let mut modules = BTreeSet::new();
    let noted = wiring.inner.iter().filter(|inner| modules.insert(&inner.module)).map(|inner| {
        let module = &inner.module;
        let methods = inner.actions.iter().map(|(action, ActionNames { method, parameters })| {
            let (variant, own, reports_done) = &actions[action];
            let start = start(reports_done);
            let declared = start.as_ref().map(|start| quote! { #start: bool });
            let fields = own.parameters.iter().zip(parameters).map(|(own, name)| {
                if own == name {
                    quote! { #own }
                } else {
                    quote! { #own: #name }
                }
            });
            let fields: Vec<_> = fields.chain(start).collect();
            let fields = (!fields.is_empty()).then(|| quote! { { #(#fields),* } });
            quote! {
                #[inline]
                fn #method(&mut self, #(#parameters: #float,)* #declared) -> Result<(), Self::Error> {
                    self.0 = Some(Command::#variant #fields);
                    Ok(())
                }
            }
        });
        quote! {
            #blank
            impl super::#module::Robot for Proposal {
                type Error = core::convert::Infallible;
                #(#methods)*
            }
        }
    });
    let noted: Vec<_> = noted.collect();
    quote! {
        #blank
        /// What a client can ask for.
        #[derive(Clone, Copy)]
        enum Command { #(#declared),* }
        #blank
        /// What a client has asked for on a tick.
        #[derive(Clone, Copy)]
        struct Proposal(Option<Command>);
        #blank
        impl Proposal {
            /// Gives the command; it begins anew where the robot has changed hands.
            #[inline]
            fn give<R: Robot>(self, #changed: bool, #robot: &mut R) -> Result<(), R::Error> {
                #given
            }
        }
        #(#noted)*
    }
}

/// The method that lets all clients propose, and gives a command.
pub(super) fn step(emission: Emission<'_>, wiring: &Wiring<'_>, arbiter: &Arbiter) -> TokenStream {
    let blank = layout::blank();
    let mut block = Block::new(emission, wiring, None);
    block.remember();
    let asked = arbiter.conditions().filter_map(|condition| wiring.graph.bool(condition));
    let given = arbiter.emergencies.iter().flat_map(|emergency| wiring.given(&(emergency.call..emergency.call + 1)));
    block.bind(asked.chain(given).collect::<BTreeSet<Node>>());
    let variant = |mode: usize| &wiring.modes[mode].variant;
    let others = Arbiter::OTHERS as usize;
    let (nobody, emergency) = (variant(Arbiter::NOBODY as usize), variant(Arbiter::EMERGENCY as usize));
    let clients =
        || wiring.clients.iter().enumerate().map(|(place, parts)| (place, &parts.field, variant(others + place)));
    let proposed = clients().map(|(place, field, variant)| {
        let had = quote! { self.state == Some(State::#variant) };
        let lost = wiring.clients[place].lost.as_ref().map(|lost| quote! { self.#lost });
        let told = wiring.tell_client(place, &quote! { inputs.done && #had }, &had, lost.as_ref());
        quote! {
            let mut #field = Proposal(None);
            _ = self.#field.step(&#told, dt_ns, &mut #field);
        }
    });
    let proposed: Vec<_> = proposed.collect();
    let levels = wiring.clients.iter().zip(&arbiter.clients).map(|(ClientParts { field, .. }, client)| {
        let level = level(&block, client);
        quote! { #field.0.and(#level) }
    });
    let levels: Vec<_> = levels.collect();
    let choice = match arbiter.ties {
        Ties::InOrder => quote! { kernel::first_choice(&levels) },
        Ties::Random => quote! { kernel::any_choice(&levels, &mut self.random) },
    };
    let number = Literal::usize_unsuffixed;
    let winners = clients().map(|(place, _, variant)| {
        let place = number(place);
        quote! { Some(#place) => State::#variant }
    });
    let winner = quote! { match winner { #(#winners,)* _ => State::#nobody } };
    let condition = |emergency: &Emergency| Some(block.value(wiring.graph.bool(emergency.condition)?).tokens());
    let conditions: Vec<_> = arbiter.emergencies.iter().filter_map(condition).collect();
    // The first that holds, before anything starts anew.
    let places = (0..conditions.len()).map(number);
    let (emergencies, next) = if conditions.is_empty() {
        (None, winner)
    } else {
        (
            Some(quote! { let emergency = #(if #conditions { Some(#places) } else)* { None }; }),
            quote! { if emergency.is_some() { State::#emergency } else { #winner } },
        )
    };
    let lost = clients().filter_map(|(place, field, variant)| {
        let lost = wiring.clients[place].lost.as_ref()?;
        Some(quote! { self.#lost = #field.0.is_some() && next != State::#variant; })
    });
    let lost: Vec<_> = lost.collect();
    let bypass = arbiter.emergencies.iter().enumerate().map(|(place, Emergency { text, call, .. })| {
        let remark = layout::comment(text);
        let calls = step::calls(&block, &(*call..call + 1), Time::Arbitrating);
        let pattern = if place + 1 == conditions.len() {
            quote! { _ }
        } else {
            let place = number(place);
            quote! { #place }
        };
        quote! { Some(#pattern) => { #remark #(#calls)*?; } }
    });
    let bypass: Vec<_> = bypass.collect();
    let bypass = if bypass.is_empty() {
        quote! { State::#nobody | State::#emergency => {} }
    } else {
        quote! {
            State::#nobody => {}
            State::#emergency => match emergency { #(#bypass)* None => {} },
        }
    };
    let gives = clients().map(|(_, field, variant)| quote! { State::#variant => #field.give(changed, robot)?, });
    let gives: Vec<_> = gives.collect();
    let (restarts, always) = (wiring.restarts(), &block.statements);
    quote! {
        #blank
        /// One tick, `dt_ns` nanoseconds after the one before: every client proposes, and the robot gets one command.
        ///
        /// # Errors
        /// The error of that action. The machine has moved.
        pub fn step<R: Robot>(&mut self, inputs: &Inputs, dt_ns: u64, robot: &mut R) -> Result<Mode, R::Error> {
            #always
            #(#proposed)*
            let levels = [#(#levels),*];
            let winner = #choice;
            #emergencies
            let next = #next;
            let changed = self.state != Some(next);
            if changed {
                self.state = Some(next);
                #restarts
            }
            #(#lost)*
            match next {
                #bypass
                #(#gives)*
            }
            Ok(next.mode())
        }
    }
}

/// The priority of a client: the first whose condition holds, or that has none.
fn level(block: &Block<'_>, client: &Client) -> TokenStream {
    let (mut conditions, mut levels, mut last) = (Vec::new(), Vec::new(), quote! { None });
    for (level, when) in &client.priorities {
        let level = Literal::u32_unsuffixed(*level);
        let Some(when) = when.and_then(|when| block.wiring.graph.bool(when)) else {
            last = quote! { Some(#level) };
            break;
        };
        conditions.push(block.value(when).tokens());
        levels.push(level);
    }
    if conditions.is_empty() {
        last
    } else {
        quote! { #(if #conditions { Some(#levels) } else)* { #last } }
    }
}
