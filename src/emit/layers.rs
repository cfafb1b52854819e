//! Diagrams that run inside the modes of another: how they are told, asked and kept.

use std::collections::BTreeMap;
use std::rc::Rc;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::Emission;
use super::kept::Field;
use super::layout;
use super::modes::ModeParts;
use super::names::{Scope, plain};
use super::wiring::{ActionNames, Wiring};
use crate::plan::{Mode, Plan, Run};

/// What runs inside a mode.
#[derive(Clone)]
pub(super) struct Inner {
    /// Its position in [`crate::plan::Plan::inner`].
    pub(super) position: usize,
    /// The field of its machine: of the state of the mode or, where it is resumed, of the machine around it.
    pub(super) field: Ident,
    pub(super) resumes: bool,
}

/// How a diagram is run by those around it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Role {
    pub(super) is_inner: bool,
    pub(super) is_resumed: bool,
}

impl Role {
    /// The role of a diagram among all that are emitted.
    pub(super) fn of(plan: &Plan, all: &[&Plan]) -> Self {
        let runs = all.iter().flat_map(|outer| outer.modes.iter().filter_map(|mode| Some((*outer, mode.runs?))));
        let runs = runs.filter(|(outer, run)| is_same(&outer.inner[run.inner as usize], plan)).map(|(_, run)| run);
        runs.fold(Self::default(), |role, run| Self { is_inner: true, is_resumed: role.is_resumed || run.resumes })
    }
}

/// Whether two plans are of one diagram on one robot.
pub(super) fn is_same(one: &Plan, other: &Plan) -> bool {
    (one.position, &one.robot) == (other.position, &other.robot)
}

/// How a diagram is reached from one around it.
pub(super) struct Door {
    /// The method of the outer readings that tells its own.
    told: Ident,
    /// What asks the outer robot for its actions.
    adapter: Ident,
}

impl Inner {
    /// What runs inside a mode and is kept while another one is active.
    pub(super) fn resumed(mode: &Mode, fields: &mut Scope) -> Option<Self> {
        let Run { inner, resumes } = mode.runs.filter(|run| run.resumes)?;
        Some(Self { position: inner as usize, field: fields.snake(&mode.name), resumes })
    }

    /// What runs inside a mode and starts anew with it.
    pub(super) fn restarted(mode: &Mode, wiring: &Wiring<'_>, locals: &mut Scope) -> Option<Self> {
        let Run { inner, resumes } = mode.runs.filter(|run| !run.resumes)?;
        let position = inner as usize;
        Some(Self { position, field: locals.snake(&plain(&wiring.inner[position].module)), resumes })
    }

    /// The machine, from within the arm of its mode.
    fn place(&self) -> TokenStream {
        let field = &self.field;
        if self.resumes {
            quote! { self.#field }
        } else {
            quote! { #field }
        }
    }
}

/// The names by which inner diagrams are reached.
pub(super) fn doors(inner: &[Rc<Wiring<'_>>], fields: &mut Scope) -> Vec<Door> {
    let mut adapters =
        Scope::new(&["Inputs", "Failed", "Robot", "Mode", "State", "Machine", "R", "Command", "Proposal"]);
    let door = |inner: &Rc<Wiring<'_>>| {
        let name = plain(&inner.module);
        Door { told: fields.snake(&name), adapter: adapters.camel(&name) }
    };
    inner.iter().map(door).collect()
}

impl Wiring<'_> {
    /// Whether leaving it gives commands, its own or those of what runs inside it.
    pub(super) fn has_exits(&self) -> bool {
        let own = self.plan.modes.iter().any(|mode| !mode.on_exit.is_empty());
        own || self.inner.iter().any(|inner| inner.has_exits())
    }

    /// The methods of the readings that tell inner diagrams theirs.
    pub(super) fn told(&self) -> Vec<TokenStream> {
        let told = self.doors.iter().zip(&self.inner).map(|(door, inner)| {
            let (told, module) = (&door.told, &inner.module);
            let fields = |names: BTreeMap<u32, &Ident>, place: &TokenStream, of_client: fn(&Ident) -> TokenStream| {
                let fields = names.into_iter().map(|(input, name)| {
                    let own = &self.sensors[input as usize];
                    let value =
                        self.outcome(input).map_or_else(|| quote! { #place.#own }, |outcome| of_client(&outcome));
                    quote! { #name: #value }
                });
                fields.collect::<Vec<_>>()
            };
            let readings =
                fields(inner.asked(), &quote! { self }, |outcome| quote! { if #outcome { 1.0 } else { 0.0 } });
            let failed = fields(inner.watched(), &quote! { self.failed }, |_| quote! { false });
            let failed = (!failed.is_empty()).then(|| quote! { failed: super::#module::Failed { #(#failed),* }, });
            let (given, done) = inner.uses_done.then(|| (quote! { , done: bool }, quote! { done })).unzip();
            let outcomes = inner.read.iter().filter_map(|&input| self.outcome(input));
            let outcomes: Vec<_> = outcomes.collect();
            quote! {
                #[inline]
                fn #told(&self #given #(, #outcomes: bool)*) -> super::#module::Inputs {
                    super::#module::Inputs { #(#readings,)* #failed #done }
                }
            }
        });
        told.collect()
    }

    /// What an arbiter tells its clients in the place of a reading: whether they won, or lost.
    pub(super) fn outcome(&self, input: u32) -> Option<Ident> {
        let arbiter = self.plan.arbiter.as_ref()?;
        let outcomes = [(arbiter.won, "won"), (arbiter.lost, "lost")];
        outcomes.iter().find(|(of, _)| *of == Some(input)).map(|(_, name)| format_ident!("{name}"))
    }

    /// The readings of a client, told whether it had the robot, and whether it lost.
    pub(super) fn tell_client(
        &self,
        position: usize,
        done: &TokenStream,
        won: &TokenStream,
        lost: Option<&TokenStream>,
    ) -> TokenStream {
        let (inner, told) = (&self.inner[position], &self.doors[position].told);
        let done = inner.uses_done.then_some(done);
        let outcomes = inner.read.iter().filter_map(|&input| self.outcome(input));
        let outcomes = outcomes.filter_map(|outcome| if outcome == "won" { Some(won) } else { lost });
        let arguments = done.into_iter().chain(outcomes);
        quote! { inputs.#told(#(#arguments),*) }
    }

    /// What is read for it and for what runs inside it, by input.
    pub(super) fn asked(&self) -> BTreeMap<u32, &Ident> {
        self.read.iter().map(|&input| (input, &self.sensors[input as usize])).collect()
    }

    /// The sensors whose health is told.
    pub(super) fn watched(&self) -> BTreeMap<u32, &Ident> {
        self.watched.iter().map(|&input| (input, &self.sensors[input as usize])).collect()
    }

    /// What passes the commands of inner diagrams on.
    pub(super) fn adapters(&self, emission: Emission<'_>) -> TokenStream {
        let (blank, float) = (layout::blank(), emission.float());
        let adapters = self.doors.iter().zip(&self.inner).map(|(door, inner)| {
            let (adapter, module) = (&door.adapter, &inner.module);
            let methods = inner.actions.iter().map(|(action, names)| {
                let ActionNames { method, parameters } = names;
                let own = &self.actions[action].method;
                let declared = &self.plan.actions[*action as usize];
                let (start, started) =
                    declared.reports_done.then(|| (quote! { start: bool }, quote! { start })).unzip();
                quote! {
                    #[inline]
                    fn #method(&mut self, #(#parameters: #float,)* #start) -> Result<(), R::Error> {
                        self.0.#own(#(#parameters,)* #started)
                    }
                }
            });
            let doc = layout::doc(&[&format!("The robot, as `{}` asks it.", plain(module))]);
            quote! {
                #blank
                #doc
                struct #adapter<'r, R>(&'r mut R);
                #blank
                impl<R: Robot> super::#module::Robot for #adapter<'_, R> {
                    type Error = R::Error;
                    #(#methods)*
                }
            }
        });
        quote! { #(#adapters)* }
    }

    /// The field of the machine of what runs inside a mode and is resumed.
    pub(super) fn resumed(&self) -> Vec<Field> {
        let modes = self.plan.modes.iter().zip(&self.modes);
        let resumed = modes.filter_map(|(mode, parts)| {
            let inner = parts.inner.as_ref().filter(|inner| inner.resumes)?;
            let doc = format!("What runs inside `{}`, as it was left.", mode.name);
            Some(self.field_of_inner(inner, doc))
        });
        resumed.collect()
    }

    /// The field of the machine of what runs inside a mode; in a state it begins as what it is.
    pub(super) fn field_of_inner(&self, inner: &Inner, doc: String) -> Field {
        let wiring = &self.inner[inner.position];
        let module = &wiring.module;
        let seed = wiring.draws.then(|| quote! { 0 });
        let initial = inner.resumes.then(|| quote! { super::#module::Machine::new(#seed) });
        Field { doc, name: inner.field.clone(), kind: quote! { super::#module::Machine }, initial }
    }

    /// The call of a method of what runs inside the mode whose arm this is.
    fn call_inner(
        &self,
        inner: &Inner,
        place: &TokenStream,
        method: &str,
        done: &TokenStream,
        dt: &TokenStream,
    ) -> TokenStream {
        let (door, wiring) = (&self.doors[inner.position], &self.inner[inner.position]);
        let (told, adapter, method) = (&door.told, &door.adapter, format_ident!("{method}"));
        let done = wiring.uses_done.then_some(done);
        quote! { #place.#method(&inputs.#told(#done), #dt &mut #adapter(&mut *robot)) }
    }

    /// One tick of what runs inside a mode that goes on.
    pub(super) fn step_inner(&self, parts: &ModeParts) -> Option<TokenStream> {
        let inner = parts.inner.as_ref()?;
        Some(self.call_inner(inner, &inner.place(), "step", &quote! { inputs.done }, &quote! { dt_ns, }))
    }

    /// The last commands of what runs inside a mode that is left.
    pub(super) fn leave_inner(&self, parts: &ModeParts) -> Option<TokenStream> {
        let inner = parts.inner.as_ref().filter(|inner| self.inner[inner.position].has_exits())?;
        Some(self.call_inner(inner, &inner.place(), "leave", &quote! { inputs.done }, &TokenStream::new()))
    }

    /// The first tick of what runs inside a mode that is entered: a statement before its commands, and a call behind.
    pub(super) fn begin_inner(&self, parts: &ModeParts) -> Option<(TokenStream, TokenStream)> {
        let inner = parts.inner.as_ref()?;
        let (field, wiring) = (&inner.field, &self.inner[inner.position]);
        let module = &wiring.module;
        let seed = wiring.draws.then(|| quote! { kernel::next_random(&mut self.random) });
        let new = quote! { super::#module::Machine::new(#seed) };
        let (clear, zero) = (quote! { false }, quote! { 0, });
        if !inner.resumes {
            return Some((
                quote! { let mut #field = #new; },
                self.call_inner(inner, &quote! { #field }, "step", &clear, &zero),
            ));
        }
        let place = inner.place();
        let step = self.call_inner(inner, &place, "step", &clear, &zero);
        let resume = self.call_inner(inner, &place, "resume", &clear, &TokenStream::new());
        Some((TokenStream::new(), quote! { if #place.state.is_none() { #place = #new; #step } else { #resume } }))
    }

    /// Whether what runs inside the active mode has come to its end; `mode` is the one whose arm asks.
    pub(super) fn has_ended(&self, mode: Option<&ModeParts>) -> TokenStream {
        if let Some(parts) = mode {
            return match parts.inner.as_ref() {
                Some(inner) => {
                    let place = inner.place();
                    quote! { #place.has_ended() }
                }
                None => quote! { false },
            };
        }
        let ends = self.modes.iter().filter_map(|parts| {
            let (inner, variant) = (parts.inner.as_ref()?, &parts.variant);
            let (field, place) = (&inner.field, inner.place());
            let rest = if inner.resumes { parts.rest() } else { Some(quote! { { #field, .. } }) };
            Some(quote! { Some(State::#variant #rest) => #place.has_ended() })
        });
        quote! { match &self.state { #(#ends,)* _ => false } }
    }

    /// Whether it is in the first mode of a path, what runs inside that in the next, and so on inward; `active` is the
    /// mode whose arm asks.
    pub(super) fn is_inside(&self, active: Option<&ModeParts>, path: &[u32]) -> TokenStream {
        let Some((&first, deeper)) = path.split_first() else { return quote! { true } };
        let Some(active) = active else { return self.is_in(&quote! { self }, &quote! { State }, path) };
        let parts = &self.modes[first as usize];
        match parts.inner.as_ref().filter(|_| parts.variant == active.variant) {
            Some(inner) => self.inner[inner.position].is_in_of_module(&inner.place(), deeper),
            None => quote! { false },
        }
    }

    fn is_in_of_module(&self, owner: &TokenStream, path: &[u32]) -> TokenStream {
        let module = &self.module;
        self.is_in(owner, &quote! { super::#module::State }, path)
    }

    fn is_in(&self, owner: &TokenStream, state: &TokenStream, path: &[u32]) -> TokenStream {
        let Some((&first, deeper)) = path.split_first() else { return quote! { true } };
        let parts = &self.modes[first as usize];
        let (variant, rest) = (&parts.variant, parts.rest());
        let Some(inner) = parts.inner.as_ref().filter(|_| !deeper.is_empty()) else {
            return quote! { matches!(&#owner.state, Some(#state::#variant #rest)) };
        };
        let (field, wiring) = (&inner.field, &self.inner[inner.position]);
        if inner.resumes {
            let deeper = wiring.is_in_of_module(&quote! { #owner.#field }, deeper);
            quote! { (matches!(&#owner.state, Some(#state::#variant #rest)) && #deeper) }
        } else {
            let deeper = wiring.is_in_of_module(&quote! { #field }, deeper);
            quote! { matches!(&#owner.state, Some(#state::#variant { #field, .. }) if #deeper) }
        }
    }
}
