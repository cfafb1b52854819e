//! What a diagram remembers from one tick to the next, as fields.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::graph::Node;
use super::modes::ModeParts;
use super::names::plain;
use super::wiring::Wiring;
use super::{Emission, table};
use crate::plan::Step;

/// A field of the machine or of one of its states.
pub(super) struct Field {
    pub(super) doc: String,
    pub(super) name: Ident,
    pub(super) kind: TokenStream,
    /// Its first value; without one, the value that has its name.
    pub(super) initial: Option<TokenStream>,
}

impl ModeParts {
    /// What stands behind its variant in a pattern that looks at nothing it keeps.
    pub(super) fn rest(&self) -> Option<TokenStream> {
        let table = self.table.as_ref().is_some_and(|table| table.before.is_some());
        let inner = self.inner.as_ref().is_some_and(|inner| !inner.resumes);
        let keeps = self.timer.is_some() || !self.kept.is_empty() || !self.drawn_for_later.is_empty();
        (keeps || table || inner).then(|| quote! { { .. } })
    }
}

/// Whether a timer that is asked for no longer time can be 32 bits wide.
pub(super) fn is_narrow(longest: u64) -> bool {
    u32::try_from(longest).is_ok()
}

impl Wiring<'_> {
    fn text(&self, of: Node) -> &str {
        self.texts.get(&of).copied().unwrap_or_default()
    }

    /// What the machine itself keeps, beside the active mode and the random numbers.
    pub(super) fn fields(&self, emission: Emission<'_>) -> Vec<Field> {
        let said = self.events.iter().chain(&self.outputs);
        let remembered = said.filter(|(node, _)| self.always.contains(node)).map(|(_, (sense, _))| *sense);
        let remembered: BTreeSet<usize> = remembered.collect();
        let senses = remembered.into_iter().filter_map(|sense| self.senses.get(sense));
        let mut senses: Vec<_> = senses.filter(|sense| sense.remembers()).collect();
        senses.dedup_by_key(|sense| &sense.memory);
        let memories = senses.into_iter().map(|sense| {
            let network = &sense.network.module;
            Field {
                doc: format!("What `{}` remembers.", plain(&sense.memory)),
                name: sense.memory.clone(),
                kind: quote! { super::#network::Memory },
                initial: Some(quote! { super::#network::Memory::new() }),
            }
        });
        let before = self.before.iter().map(|(of, name)| Field {
            doc: format!("Whether `{}` held on the tick before.", self.text(*of)),
            name: name.clone(),
            kind: quote! { bool },
            initial: Some(quote! { false }),
        });
        let kept = self.kept.iter().map(|(node, name)| self.field(*node, name));
        let windows = self.windows.iter().filter_map(|(node, name)| self.readings(*node, name, emission));
        let mut fields: Vec<_> = memories.chain(before).chain(kept).chain(windows).collect();
        if self.keeps_time {
            fields.push(elapsed(u64::MAX));
        }
        fields.extend(self.resumed());
        fields.extend(self.fields_of_clients());
        fields
    }

    /// What starts anew with every mode, of what the machine itself keeps.
    pub(super) fn restarts(&self) -> TokenStream {
        let kept = self.kept.iter().filter_map(|(node, name)| match self.graph.code.steps[*node] {
            Step::Latched { .. } => Some(quote! { self.#name = false; }),
            Step::Count { .. } => Some(quote! { self.#name = 0; }),
            _ => None,
        });
        let elapsed = self.keeps_time.then(|| quote! { self.elapsed = 0; });
        quote! { #(#kept)* #elapsed }
    }

    /// The readings that a window keeps.
    fn readings(&self, node: Node, name: &Ident, emission: Emission<'_>) -> Option<Field> {
        let Step::Average { input, ref readings, .. } = self.graph.code.steps[node] else { return None };
        let (float, zero) = (emission.float(), emission.number(0.0));
        let count = Literal::usize_unsuffixed(readings.len());
        Some(Field {
            doc: format!("The last readings of `{}`.", self.plan.inputs.get(input as usize)?.name),
            name: name.clone(),
            kind: quote! { [#float; #count] },
            initial: Some(quote! { [#zero; #count] }),
        })
    }

    /// A window, a stopwatch, a latch or a counter.
    fn field(&self, node: Node, name: &Ident) -> Field {
        let text = self.graph.operands(node).first().map_or("", |&of| self.text(of));
        let (doc, kind, initial) = match self.graph.code.steps[node] {
            Step::Average { input, .. } => {
                let sensor = self.plan.inputs.get(input as usize).map_or("", |input| &input.name);
                (
                    format!("The mean of the last readings of `{sensor}`."),
                    quote! { kernel::Window },
                    quote! { kernel::Window { held: 0, next: 0, left: 0, mean: 0.0 } },
                )
            }
            Step::Latched { .. } => {
                (format!("Whether `{text}` has held since the mode was entered."), quote! { bool }, quote! { false })
            }
            Step::Count { .. } => {
                (format!("How often `{text}` has set since the mode was entered."), quote! { u32 }, quote! { 0 })
            }
            _ => (
                format!("How long `{text}` has held."),
                quote! { kernel::Stopwatch },
                quote! { kernel::Stopwatch { running: false, elapsed: 0 } },
            ),
        };
        Field { doc, name: name.clone(), kind, initial: Some(initial) }
    }

    /// What a mode keeps while it is active; drawn numbers begin as what they are.
    pub(super) fn fields_of(&self, mode: &ModeParts, emission: Emission<'_>) -> Vec<Field> {
        let float = emission.float();
        let kept = mode.kept.iter().map(|(node, name)| self.field(*node, name));
        let when = if mode.table.is_some() { ", or its row began to fit" } else { "" };
        let drawn = mode.drawn.iter().filter(|(real, _)| mode.drawn_for_later.contains(real)).map(|(_, name)| Field {
            doc: format!("Drawn when the mode was entered{when}."),
            name: name.clone(),
            kind: quote! { #float },
            initial: None,
        });
        let row = mode.table.as_ref().and_then(|table| {
            let (name, row) = (table.before.clone()?, &table.row);
            let doc = "The row of the table that fitted on the tick before.".to_owned();
            Some(Field { doc, name, kind: table::kind(mode.rows), initial: Some(quote! { #row }) })
        });
        let inner = mode.inner.as_ref().filter(|inner| !inner.resumes);
        let inner = inner.map(|inner| self.field_of_inner(inner, "What runs inside.".to_owned()));
        mode.timer.map(elapsed).into_iter().chain(kept).chain(row).chain(drawn).chain(inner).collect()
    }
}

fn elapsed(longest: u64) -> Field {
    let kind = format_ident!("{}", if is_narrow(longest) { "u32" } else { "u64" });
    Field {
        doc: "Nanoseconds since the mode was entered, as far as they are counted.".to_owned(),
        name: format_ident!("elapsed"),
        kind: quote! { #kind },
        initial: Some(quote! { 0 }),
    }
}
