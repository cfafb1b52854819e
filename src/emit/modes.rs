//! What each mode of a diagram owns.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Ident;

use super::graph::{Node, part};
use super::layers::Inner;
use super::names::{Scope, plain};
use super::table::{self, Table};
use super::wiring::Wiring;
use crate::plan::{Mode, Real, Step};

/// The names of a mode, and what it owns.
pub(super) struct ModeParts {
    pub(super) variant: Ident,
    pub(super) enter: Ident,
    /// The longest time that is waited for, where the mode keeps the time.
    pub(super) timer: Option<u64>,
    /// The latches and counters that are its own.
    pub(super) kept: BTreeMap<Node, Ident>,
    /// Every number it draws.
    pub(super) drawn: BTreeMap<Real, Ident>,
    /// Those that it needs after it was entered.
    pub(super) drawn_for_later: BTreeSet<Real>,
    /// How its decision table is named, and how many rows it has.
    pub(super) table: Option<Table>,
    pub(super) rows: usize,
    /// What runs inside it.
    pub(super) inner: Option<Inner>,
    /// The outputs that it needs when it is entered.
    pub(super) given: BTreeMap<Node, Ident>,
}

/// The parts of all modes, whose names are apart from some local ones.
pub(super) fn all(wiring: &Wiring<'_>, locals: &mut Scope) -> Vec<ModeParts> {
    let of_machine: Vec<_> = wiring.plan.modes.iter().map(|mode| Inner::resumed(mode, locals)).collect();
    let mut modes = Modes { variants: Scope::new(&[]), enters: Scope::new(&[]), locals };
    wiring.plan.modes.iter().zip(of_machine).map(|(mode, resumed)| modes.one(mode, resumed, wiring)).collect()
}

/// What modes are named apart by.
struct Modes<'s> {
    variants: Scope,
    enters: Scope,
    locals: &'s Scope,
}

impl Modes<'_> {
    fn one(&mut self, mode: &Mode, resumed: Option<Inner>, wiring: &Wiring<'_>) -> ModeParts {
        let plan = wiring.plan;
        let mut locals = self.locals.clone();
        let needed = &wiring.conditions(&mode.transitions) | &wiring.decisions(mode);
        let (mut timer, mut kept) = (None, BTreeMap::new());
        for &node in needed.iter().filter(|node| !wiring.always.contains(node) && wiring.said(**node).is_none()) {
            if let Step::After { duration, .. } = wiring.graph.code.steps[node]
                && !wiring.keeps_time
            {
                timer = timer.max(Some(duration));
            }
            if let Some(name) = wiring.kept_name(node) {
                kept.insert(node, locals.snake(&name));
            }
        }
        let (mut drawn, mut drawn_for_later) = (BTreeMap::new(), BTreeSet::new());
        let rows = table::rows(plan, mode);
        let draws = std::iter::once(&mode.draws).chain(rows.iter().map(|row| &row.draws));
        let draws: Vec<_> = draws.flat_map(|draws| part(&plan.draws, draws)).collect();
        let is_left = !mode.transitions.is_empty() || mode.otherwise.is_some();
        for pick in rows.iter().filter_map(|row| row.pick) {
            drawn.insert(pick, locals.snake("pick"));
            drawn_for_later.insert(pick);
        }
        let of_rows = rows.iter().map(|row| &row.calls);
        for calls in [&mode.on_enter, &mode.actions, &mode.on_exit].into_iter().chain(of_rows) {
            let later = calls != &mode.on_enter && (calls != &mode.on_exit || is_left);
            for call in part(&plan.calls, calls) {
                let arguments = part(&plan.arguments, &call.arguments).iter();
                for (&real, name) in arguments.zip(&wiring.actions[&call.action].parameters) {
                    if draws.iter().any(|draw| draw.to == real) {
                        drawn.insert(real, locals.snake(&plain(name)));
                        if later {
                            drawn_for_later.insert(real);
                        }
                    }
                }
            }
        }
        let given = [&mode.on_enter, &mode.actions].into_iter().chain(rows.iter().map(|row| &row.calls));
        let given: BTreeSet<Node> = given.flat_map(|calls| wiring.given(calls)).collect();
        let given = given.into_iter().map(|node| (node, locals.snake(&wiring.given_name(node))));
        let given = given.collect();
        let table = (!rows.is_empty()).then(|| Table {
            row: locals.snake("row"),
            begins: locals.snake("begins"),
            before: table::begins(plan, mode).then(|| locals.snake("row_before")),
        });
        let inner = resumed.or_else(|| Inner::restarted(mode, wiring, &mut locals));
        ModeParts {
            inner,
            table,
            rows: rows.len(),
            given,
            variant: self.variants.camel(&mode.name),
            enter: self.enters.snake(&format!("enter_{}", mode.name)),
            timer,
            kept,
            drawn,
            drawn_for_later,
        }
    }
}
