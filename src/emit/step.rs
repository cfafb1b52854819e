//! What a diagram does on a tick.

use std::ops::Range;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::block::Block;
use super::expression::{self, Expression};
use super::graph::part;
use super::kept::is_narrow;
use super::modes::ModeParts;
use super::names::plain;
use super::table::Table;
use super::wiring::Wiring;
use super::{Emission, layout, lints};
use crate::plan::{Mode, Real, Step, Transition};

/// The methods that run a diagram: `step`, and one that enters each mode that something leads to.
pub(super) fn methods(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let blank = layout::blank();
    let mut always = Block::new(emission, wiring, None);
    always.remember();
    let entry = &wiring.modes[wiring.plan.entry as usize];
    let mut first = always.branch();
    let entered = first.enter(&wiring.plan.modes[wiring.plan.entry as usize], entry);
    let first = match first.statements {
        bound if bound.is_empty() => quote! { #entered, },
        bound => quote! { { #bound #entered } },
    };
    let arms = wiring.plan.modes.iter().zip(&wiring.modes).map(|(mode, parts)| {
        let (pattern, body) = (pattern(emission, wiring, parts), arm(&always, mode, parts));
        quote! { Some(#pattern) => { #body } }
    });
    let arms: Vec<_> = arms.collect();
    let always = always.statements;
    let narrow = wiring.modes.iter().any(|mode| mode.timer.is_some_and(is_narrow));
    let narrow = narrow.then(|| quote! { let dt = u32::try_from(dt_ns).unwrap_or(u32::MAX); });
    let body = quote! {
        #always
        #narrow
        match &mut self.state {
            None => #first
            #(#arms)*
        }
    };
    let used = layout::words(&body);
    let [inputs, dt_ns] =
        ["inputs", "dt_ns"].map(|name| format_ident!("{}{name}", if used.contains(name) { "" } else { "_" }));
    let name = &wiring.plan.modes[wiring.plan.entry as usize].name;
    let doc = layout::doc(&[
        &format!("One tick, `dt_ns` nanoseconds after the one before; the first one enters `{name}`."),
        "# Errors",
        "The first error of an action. The machine has moved, and every other action of the tick has been called.",
    ]);
    let enters = enters(emission, wiring);
    let as_inner = as_inner(emission, wiring);
    quote! {
        #blank
        #doc
        pub fn step<R: Robot>(
            &mut self,
            #inputs: &Inputs,
            #dt_ns: u64,
            robot: &mut R,
        ) -> Result<Mode, R::Error> {
            #body
        }
        #as_inner
        #enters
    }
}

/// The methods for a diagram that runs inside another.
fn as_inner(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let blank = layout::blank();
    let ends = wiring.plan.modes.iter().zip(&wiring.modes).filter(|(mode, _)| mode.is_final);
    let ends = ends.map(|(_, parts)| {
        let (variant, rest) = (&parts.variant, parts.rest());
        quote! { Some(State::#variant #rest) }
    });
    let ends: Vec<_> = ends.collect();
    let ended = if ends.is_empty() {
        quote! { false }
    } else {
        quote! { matches!(self.state, #(#ends)|*) }
    };
    let ended = wiring.role.is_inner.then(|| {
        quote! {
            #blank
            /// Whether it is in a mode without a way out.
            #[must_use]
            pub const fn has_ended(&self) -> bool { #ended }
        }
    });
    let leave = (wiring.role.is_inner && wiring.has_exits()).then(|| leave(emission, wiring));
    let resume = wiring.role.is_resumed.then(|| resume(emission, wiring));
    quote! { #ended #leave #resume }
}

/// The method that gives the last commands, when what is around takes over.
fn leave(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let blank = layout::blank();
    let own = wiring.plan.modes.iter().any(|mode| !mode.on_exit.is_empty());
    let mut always = Block::new(emission, wiring, None);
    if own {
        always.remember();
    }
    let arms = wiring.plan.modes.iter().zip(&wiring.modes).filter_map(|(mode, parts)| {
        let mut block = Block { mode: Some(parts), ..always.branch() };
        block.bind(wiring.given(&mode.on_exit));
        let last = calls(&block, &mode.on_exit, Time::Leaving);
        let calls: Vec<_> = wiring.leave_inner(parts).into_iter().chain(last).collect();
        let (variant, statements) = (&parts.variant, block.statements);
        let calls = (!calls.is_empty()).then(|| chain(&calls))?;
        let body = quote! { #statements #calls };
        let used = layout::words(&body);
        let fields = wiring.fields_of(parts, emission).into_iter().map(|field| field.name);
        let fields: Vec<_> = fields.filter(|name| used.contains(&plain(name))).collect();
        let rest = if fields.is_empty() { parts.rest() } else { Some(quote! { { #(#fields,)* .. } }) };
        Some(quote! { Some(State::#variant #rest) => { #body } })
    });
    let (arms, always) = (arms.collect::<Vec<_>>(), always.statements);
    let body = quote! {
        #always
        match &mut self.state {
            #(#arms)*
            _ => Ok(()),
        }
    };
    let (dt_ns, inputs) = at_once(&body);
    let allowed = (!always.is_empty()).then(lints::of_remembering);
    quote! {
        #blank
        /// Gives the last commands of the active mode; no time has passed since the tick before.
        ///
        /// # Errors
        /// The first error of an action; every other action has been called.
        #allowed
        pub fn leave<R: Robot>(&mut self, #inputs: &Inputs, robot: &mut R) -> Result<(), R::Error> {
            #dt_ns
            #body
        }
    }
}

/// What a method needs that takes no time: the length of its tick, if it asks for it, and how it calls its inputs.
fn at_once(body: &TokenStream) -> (Option<TokenStream>, Ident) {
    let used = layout::words(body);
    let dt_ns = used.contains("dt_ns").then(|| quote! { let dt_ns = 0; });
    (dt_ns, format_ident!("{}inputs", if used.contains("inputs") { "" } else { "_" }))
}

/// The method that takes it up again in the mode in which it was.
fn resume(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let blank = layout::blank();
    let plan = wiring.plan;
    let mut always = Block::new(emission, wiring, None);
    always.remember();
    let (entered, all) = (wiring.entered(), plan.modes.iter().zip(&wiring.modes).zip(0..));
    let arms = all.filter(|(_, position)| entered.contains(position)).map(|((mode, parts), position)| {
        let mut block = always.branch();
        let entered = block.enter(mode, parts);
        let (statements, variant) = (block.statements, &parts.variant);
        let first = (position == plan.entry).then(|| quote! { None | });
        quote! { #first Some(Mode::#variant) => { #statements #entered } }
    });
    let (arms, always) = (arms.collect::<Vec<_>>(), always.statements.clone());
    // Nothing leads to these.
    let others = (entered.len() < plan.modes.len()).then(|| quote! { Some(mode) => Ok(mode), });
    let body = quote! {
        #always
        match self.mode() { #(#arms)* #others }
    };
    let (dt_ns, inputs) = at_once(&body);
    let allowed = (!always.is_empty()).then(lints::of_remembering);
    quote! {
        #blank
        /// Enters the mode in which it was; no time has passed since the tick before.
        ///
        /// # Errors
        /// As for `step`.
        #allowed
        pub fn resume<R: Robot>(&mut self, #inputs: &Inputs, robot: &mut R) -> Result<Mode, R::Error> {
            #dt_ns
            #body
        }
    }
}

/// The state of a mode as a pattern.
fn pattern(emission: Emission<'_>, wiring: &Wiring<'_>, parts: &ModeParts) -> TokenStream {
    let variant = &parts.variant;
    let fields: Vec<_> = wiring.fields_of(parts, emission).into_iter().map(|field| field.name).collect();
    if fields.is_empty() {
        quote! { State::#variant }
    } else {
        quote! { State::#variant { #(#fields),* } }
    }
}

/// What is done in a mode: its exits by priority, then its commands.
fn arm(always: &Block<'_>, mode: &Mode, parts: &ModeParts) -> TokenStream {
    let Block { emission, wiring, .. } = *always;
    let mut block = Block { mode: Some(parts), ..always.branch() };
    let (plan, places) = (wiring.plan, emission.places);
    if let Some(longest) = parts.timer {
        let dt = format_ident!("{}", if is_narrow(longest) { "dt" } else { "dt_ns" });
        block.statements.extend(quote! { *elapsed = elapsed.saturating_add(#dt); });
    }
    for &node in parts.kept.keys() {
        block.keep(node);
    }
    let failed = |mode: &Mode| -> Vec<Expression> {
        let names = part(&plan.required, &mode.required).iter().map(|&input| &wiring.sensors[input as usize]);
        names.map(|name| Expression::whole(quote! { inputs.failed.#name })).collect()
    };
    let leave = |block: &Block<'_>, target: u32| {
        let mut block = block.branch();
        block.bind(wiring.given(&mode.on_exit));
        let enter = block.enter(&plan.modes[target as usize], &wiring.modes[target as usize]);
        let last = calls(&block, &mode.on_exit, Time::Leaving);
        let calls: Vec<_> = wiring.leave_inner(parts).into_iter().chain(last).chain([enter]).collect();
        let (statements, calls) = (block.statements, chain(&calls));
        quote! { #statements return #calls; }
    };
    let holds = |target: u32| failed(&plan.modes[target as usize]).iter().map(expression::not).collect::<Vec<_>>();
    if let (Some(otherwise), false) = (mode.otherwise, mode.required.is_empty()) {
        let missing = expression::any(&failed(mode));
        let condition = expression::all(&[vec![missing], holds(otherwise)].concat()).tokens();
        let remark = layout::comment(&format!("without what it requires: {}", plan.modes[otherwise as usize].name));
        let leave = leave(&block, otherwise);
        block.statements.extend(quote! { #remark if #condition { #leave } });
    }
    for Transition { condition, target, span, .. } in part(&plan.transitions, &mode.transitions) {
        let remark = layout::comment(&format!("{} ({})", places.text(*span), places.place(*span)));
        let Some(condition) = wiring.graph.bool(*condition) else { continue };
        block.statements.extend(remark);
        block.bind([condition]);
        let condition = expression::all(&[vec![block.value(condition)], holds(*target)].concat()).tokens();
        let leave = leave(&block, *target);
        block.statements.extend(quote! { if #condition { #leave } });
    }
    block.bind(wiring.given(&mode.actions));
    let fitting = block.fit(mode, parts);
    block.statements.extend(fitting);
    let commands = calls(&block, &mode.actions, Time::Staying).into_iter();
    let commands = commands.chain(block.decide(mode, parts, Time::Deciding)).chain(wiring.step_inner(parts));
    let act = act(parts, &commands.collect::<Vec<_>>());
    let statements = block.statements;
    quote! { #statements #act }
}

impl Block<'_> {
    /// Statements for a branch, which knows what has been computed before it.
    fn branch(&self) -> Self {
        let Self { emission, wiring, mode, .. } = *self;
        Self { mode, bound: self.bound.clone(), ..Block::new(emission, wiring, None) }
    }

    /// The call that enters a mode, with the outputs and the row that it needs.
    fn enter(&mut self, mode: &Mode, parts: &ModeParts) -> TokenStream {
        self.bind(parts.given.keys().copied());
        let row = parts.table.as_ref().map(|table| {
            let (row, fitting) = (&table.row, self.fitting(mode));
            self.statements.extend(quote! { let #row = #fitting; });
            quote! { #row, }
        });
        let (enter, given) = (&parts.enter, parts.given.keys().map(|&node| self.value(node).tokens()));
        let inputs = parts.inner.as_ref().map(|_| quote! { inputs, });
        quote! { self.#enter(#row #(#given,)* #inputs robot) }
    }

    /// Statements for the row that fits while a mode lasts, and for what it draws when it begins to.
    fn fit(&mut self, mode: &Mode, parts: &ModeParts) -> TokenStream {
        let Some(Table { row, begins, before }) = &parts.table else { return TokenStream::new() };
        let of_rows = super::table::rows(self.wiring.plan, mode).iter().map(|row| &row.calls);
        self.bind(of_rows.flat_map(|calls| self.wiring.given(calls)).collect::<Vec<_>>());
        let fitting = self.fitting(mode);
        let draws = self.drawn_by_rows(mode, parts).into_iter().map(|(position, draws)| {
            let draws = draws.into_iter().map(|(name, drawn)| quote! { *#name = #drawn; });
            let position = super::table::number(position);
            quote! { if #begins && #row == #position { #(#draws)* } }
        });
        let draws: Vec<_> = draws.collect();
        let before = before.as_ref().map(|before| {
            quote! {
                let #begins = core::mem::replace(#before, #row) != #row;
            }
        });
        quote! { let #row = #fitting; #before #(#draws)* }
    }
}

/// When commands are given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Time {
    Entering,
    Staying,
    Leaving,
    /// By the decision table of a mode that goes on.
    Deciding,
    /// By an emergency, once the robot may have changed hands.
    Arbitrating,
}

/// The calls of commands.
pub(super) fn calls(block: &Block<'_>, calls: &Range<u32>, time: Time) -> Vec<TokenStream> {
    let (wiring, plan) = (block.wiring, block.wiring.plan);
    let calls = part(&plan.calls, calls).iter().map(|call| {
        let arguments = part(&plan.arguments, &call.arguments).iter();
        let arguments = arguments.map(|&real| argument(block, real, time));
        let start = plan.actions[call.action as usize].reports_done.then(|| {
            match (time, block.mode.and_then(|mode| mode.table.as_ref())) {
                (Time::Deciding, Some(Table { begins, .. })) => quote! { #begins },
                (Time::Arbitrating, _) => quote! { changed },
                _ => {
                    let starts = time != Time::Staying;
                    quote! { #starts }
                }
            }
        });
        let method = &wiring.actions[&call.action].method;
        quote! { robot.#method(#(#arguments,)* #start) }
    });
    calls.collect()
}

/// A constant, an output, or a number that was drawn.
fn argument(block: &Block<'_>, real: Real, time: Time) -> TokenStream {
    let wiring = block.wiring;
    if let Some(node) = wiring.graph.real(real) {
        return match (&wiring.graph.code.steps[node], block.mode.and_then(|mode| mode.given.get(&node))) {
            (Step::Constant { value, .. }, _) => block.emission.number(*value),
            (_, Some(name)) if time == Time::Entering => quote! { #name },
            _ => block.value(node).tokens(),
        };
    }
    let name = wiring.modes.iter().find_map(|mode| mode.drawn.get(&real));
    if time == Time::Entering {
        quote! { #name }
    } else {
        quote! { *#name }
    }
}

/// Calls one after the other, whatever they answer; the answer is the first error, or the last answer.
fn chain(calls: &[TokenStream]) -> TokenStream {
    let (first, rest) = calls.split_first().unzip();
    let rest = rest.into_iter().flatten();
    quote! { #first #(.and(#rest))* }
}

/// The end of a tick: commands, and the mode they were given in.
fn act(parts: &ModeParts, calls: &[TokenStream]) -> TokenStream {
    let variant = &parts.variant;
    if calls.is_empty() {
        return quote! { Ok(Mode::#variant) };
    }
    let calls = chain(calls);
    quote! {
        #calls?;
        Ok(Mode::#variant)
    }
}

/// The methods that enter modes.
fn enters(emission: Emission<'_>, wiring: &Wiring<'_>) -> TokenStream {
    let plan = wiring.plan;
    let blank = layout::blank();
    let methods = wiring.entered().into_iter().map(|target| {
        let (mode, parts) = (&plan.modes[target as usize], &wiring.modes[target as usize]);
        let draws = part(&plan.draws, &mode.draws).iter().filter_map(|draw| {
            let name = parts.drawn.get(&draw.to)?;
            let [low, high] = [draw.low, draw.high].map(|value| emission.number(value));
            Some(quote! { let #name = kernel::draw(&mut self.random, #low, #high); })
        });
        let block = Block::new(emission, wiring, Some(parts));
        let commands = [&mode.on_enter, &mode.actions].map(|span| calls(&block, span, Time::Entering));
        let (begun, begin) = wiring.begin_inner(parts).unzip();
        let decided = block.decide(mode, parts, Time::Entering).into_iter().chain(begin).collect();
        let commands = [commands.concat(), decided].concat();
        let inputs = parts.inner.as_ref().map(|_| quote! { inputs: &Inputs, });
        let row = parts.table.as_ref().map(|table| {
            let (row, kind) = (&table.row, super::table::kind(parts.rows));
            quote! { #row: #kind, }
        });
        let drawn = block.drawn_by_rows(mode, parts).into_iter().flat_map(|(position, draws)| {
            let row = parts.table.as_ref().map(|table| &table.row);
            let (position, zero) = (super::table::number(position), emission.number(0.0));
            let draw = move |(name, drawn): (Ident, TokenStream)| {
                quote! { let #name = if #row == #position { #drawn } else { #zero }; }
            };
            draws.into_iter().map(draw).collect::<Vec<_>>()
        });
        let drawn: Vec<_> = drawn.collect();
        let robot = format_ident!("{}", if commands.is_empty() { "_robot" } else { "robot" });
        let (enter, state) = (&parts.enter, first_state(emission, wiring, parts));
        let (restarts, float) = (wiring.restarts(), emission.float());
        let given = parts.given.values();
        // What runs inside gives its first commands before it is put into the state.
        let enters = if begun.as_ref().is_some_and(|begun| !begun.is_empty()) {
            let (commands, variant) = (chain(&commands), &parts.variant);
            quote! {
                #begun
                let begun = #commands;
                self.state = Some(#state);
                begun?;
                Ok(Mode::#variant)
            }
        } else {
            let act = act(parts, &commands);
            quote! {
                self.state = Some(#state);
                #act
            }
        };
        quote! {
            #blank
            fn #enter<R: Robot>(&mut self, #row #(#given: #float,)* #inputs #robot: &mut R) -> Result<Mode, R::Error> {
                #(#draws)*
                #(#drawn)*
                #restarts
                #enters
            }
        }
    });
    methods.collect()
}

fn first_state(emission: Emission<'_>, wiring: &Wiring<'_>, parts: &ModeParts) -> TokenStream {
    let variant = &parts.variant;
    let fields: Vec<_> = wiring
        .fields_of(parts, emission)
        .into_iter()
        .map(|field| {
            let (name, initial) = (field.name, field.initial.into_iter());
            quote! { #name #(: #initial)* }
        })
        .collect();
    if fields.is_empty() {
        quote! { State::#variant }
    } else {
        quote! { State::#variant { #(#fields),* } }
    }
}
