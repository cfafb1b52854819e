//! Decision tables: which row fits, and its command.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::block::Block;
use super::expression;
use super::graph::{Node, part};
use super::modes::ModeParts;
use super::step::{Time, calls};
use super::wiring::Wiring;
use crate::plan::{Mode, Plan, Row};

/// What is known of a mode's table.
#[derive(Debug, Clone)]
pub(super) struct Table {
    /// The row that fits.
    pub(super) row: Ident,
    /// Whether that is another one than on the tick before.
    pub(super) begins: Ident,
    /// The field of the row that fitted on the tick before, where somebody asks whether a row begins to fit.
    pub(super) before: Option<Ident>,
}

/// The rows of a mode's table; none where nothing is ever commanded.
pub(super) fn rows<'p>(plan: &'p Plan, mode: &Mode) -> &'p [Row] {
    let rows = part(&plan.rows, &mode.rows);
    if rows.iter().all(|row| row.calls.is_empty()) { &[] } else { rows }
}

/// Whether it matters on which tick a row begins to fit.
pub(super) fn begins(plan: &Plan, mode: &Mode) -> bool {
    let reports =
        |row: &Row| part(&plan.calls, &row.calls).iter().any(|call| plan.actions[call.action as usize].reports_done);
    rows(plan, mode).iter().any(|row| !row.draws.is_empty() || reports(row))
}

/// What the conditions of a table need.
pub(super) fn conditions(wiring: &Wiring<'_>, mode: &Mode) -> Vec<Node> {
    rows(wiring.plan, mode).iter().filter_map(|row| wiring.graph.bool(row.condition)).collect()
}

impl Block<'_> {
    /// The row of a mode's table that fits.
    pub(super) fn fitting(&mut self, mode: &Mode) -> TokenStream {
        let conditions = conditions(self.wiring, mode);
        self.bind(conditions.iter().copied());
        let last = conditions.len().saturating_sub(1);
        let arms = conditions[..last].iter().zip(0_u32..).map(|(&condition, row)| {
            let (condition, row) = (self.value(condition).tokens(), number(row));
            quote! { if #condition { #row } else }
        });
        let (arms, last) = (arms.collect::<Vec<_>>(), number(last as u32));
        match conditions.as_slice() {
            [first, _] => {
                let second = expression::not(&self.value(*first)).tokens();
                quote! { u8::from(#second) }
            }
            _ if arms.is_empty() => quote! { #last },
            _ => quote! { #(#arms)* { #last } },
        }
    }

    /// The command of the row that fits, if there are rows.
    pub(super) fn decide(&self, mode: &Mode, parts: &ModeParts, time: Time) -> Option<TokenStream> {
        let plan = self.wiring.plan;
        let rows = rows(plan, mode);
        let arms = rows.iter().zip(0_u32..).map(|(row, position)| {
            let calls = calls(self, &row.calls, time);
            let command = match row.pick.and_then(|pick| parts.drawn.get(&pick)) {
                Some(pick) => {
                    let pick = if time == Time::Entering {
                        quote! { #pick }
                    } else {
                        quote! { *#pick }
                    };
                    one_of(self, &calls, &pick)
                }
                None => calls.into_iter().next().unwrap_or_else(|| quote! { Ok(()) }),
            };
            let pattern = number(position);
            let pattern = if position as usize + 1 == rows.len() {
                quote! { _ }
            } else {
                pattern
            };
            (pattern, command)
        });
        let (arms, row) = (arms.collect::<Vec<_>>(), &parts.table.as_ref()?.row);
        Some(match arms.as_slice() {
            [(_, command)] => command.clone(),
            _ => {
                let arms = arms.iter().map(|(pattern, command)| quote! { #pattern => #command });
                quote! { match #row { #(#arms,)* } }
            }
        })
    }

    /// The numbers that a row draws when it begins to fit, by row.
    pub(super) fn drawn_by_rows(&self, mode: &Mode, parts: &ModeParts) -> Vec<(u32, Vec<(Ident, TokenStream)>)> {
        let plan = self.wiring.plan;
        let draws = |row: &Row| {
            let draws = part(&plan.draws, &row.draws).iter().filter_map(|draw| {
                let [low, high] = [draw.low, draw.high].map(|value| self.emission.number(value));
                let drawn = quote! { kernel::draw(&mut self.random, #low, #high) };
                Some((parts.drawn.get(&draw.to)?.clone(), drawn))
            });
            draws.collect::<Vec<_>>()
        };
        let rows = rows(plan, mode).iter().zip(0..).map(|(row, position)| (position, draws(row)));
        rows.filter(|(_, draws)| !draws.is_empty()).collect()
    }
}

/// A row as a number.
pub(super) fn number(row: u32) -> TokenStream {
    let row = proc_macro2::Literal::u32_unsuffixed(row);
    quote! { #row }
}

/// The type of rows.
pub(super) fn kind(rows: usize) -> TokenStream {
    let kind = format_ident!("{}", if rows <= 256 { "u8" } else { "u32" });
    quote! { #kind }
}

/// One of some commands: that at the whole part of a number.
fn one_of(block: &Block<'_>, calls: &[TokenStream], pick: &TokenStream) -> TokenStream {
    let Some((last, before)) = calls.split_last() else { return quote! { Ok(()) } };
    let arms = before.iter().enumerate().map(|(index, call)| {
        let end = block.emission.number((index + 1) as f64);
        quote! { if #pick < #end { #call } else }
    });
    quote! { #(#arms)* { #last } }
}
