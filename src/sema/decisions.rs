//! Decision tables.

use super::conditions::Scene;
use super::crisp::{Subject, Values};
use super::{Lower, counted, given, invalid, missing_part};
use crate::base::{Id, Span};
use crate::diag::{self, Diagnostic};
use crate::ir::{self, Op};
use crate::syntax::ast;

impl Lower<'_> {
    /// A decision table; `None` where it is broken, which was reported.
    pub(super) fn decision(
        &mut self,
        tree: &ast::Decide,
        actions: &[Id<ir::Action>],
        scene: &Scene,
    ) -> Option<ir::Decision> {
        let mut columns: Vec<Option<(Subject, Values)>> = Vec::new();
        for (place, subject) in tree.subjects.iter().enumerate() {
            let column = self.looked_at(subject, scene);
            let written = |of: &ast::Expr| self.on_one_line(of.span);
            let is_same = |before: usize| match (&columns[before], &column) {
                (Some((before @ Subject::Reading(..), _)), Some(now @ Subject::Reading(..))) => before == now,
                _ => written(&tree.subjects[before]) == written(subject),
            };
            if let Some(first) = (0..place).find(|before| is_same(*before)) {
                let diagnostic = super::said_twice(subject.span, tree.subjects[first].span, "this column");
                self.report(diagnostic);
                columns.push(None);
                continue;
            }
            columns.push(column.and_then(|of| Some((of, self.values(of, scene, subject.span)?))));
        }
        let rows: Vec<_> = tree.rows.iter().map(|row| self.decision_row(row, &columns, actions, scene)).collect();
        let columns = columns.into_iter().collect::<Option<Vec<_>>>()?;
        let span = tree.subjects.first()?.span.to(tree.subjects.last()?.span);
        if rows.is_empty() {
            self.report(missing_part(span, "this table has no rows").help("write `(...) => command` for every case"));
            return None;
        }
        let columns = columns.into_iter().zip(&tree.subjects).map(|((_, values), subject)| ir::Column {
            text: self.on_one_line(subject.span),
            values: values.names,
            possible: values.possible,
            span: subject.span,
        });
        Some(ir::Decision { columns: columns.collect(), rows: rows.into_iter().collect::<Option<_>>()?, span })
    }

    fn decision_row(
        &mut self,
        tree: &ast::DecideRow,
        columns: &[Option<(Subject, Values)>],
        actions: &[Id<ir::Action>],
        scene: &Scene,
    ) -> Option<ir::DecisionRow> {
        let commands = self.commands(&tree.command, actions, scene);
        let (count, wanted) = (tree.row.cells.len(), columns.len());
        if count != wanted {
            let message = format!("this table has {}, {}", counted(wanted, "column"), given(count));
            self.report(Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, tree.row.span, message));
            return None;
        }
        let (mut cells, mut conditions) = (Vec::new(), Vec::new());
        for (cell, column) in tree.row.cells.iter().zip(columns) {
            let Some((subject, values)) = column else {
                cells.push(None);
                continue;
            };
            let fitting = self.fitting(cell, *subject, values, scene);
            if let Some(fitting) = fitting.as_ref().filter(|fitting| fitting.len() < values.names.len()) {
                let of: Vec<_> = fitting.iter().map(|&value| values.conditions[value as usize]).collect();
                conditions.push(match of.as_slice() {
                    [one] => *one,
                    _ => self.truth(Op::Or(of), cell.span),
                });
            }
            cells.push(fitting);
        }
        let condition = match conditions.as_slice() {
            [one] => *one,
            _ => self.truth(Op::And(conditions), tree.row.span),
        };
        Some(ir::DecisionRow {
            cells: cells.into_iter().collect::<Option<_>>()?,
            condition,
            commands: commands?,
            span: tree.row.span,
        })
    }

    /// The values of a column that fit a cell, ascending.
    fn fitting(&mut self, cell: &ast::Cell, subject: Subject, values: &Values, scene: &Scene) -> Option<Vec<u32>> {
        let names = match &cell.kind {
            ast::CellKind::Any | ast::CellKind::Omitted => return Some((0..values.names.len() as u32).collect()),
            ast::CellKind::Term(name) => std::slice::from_ref(name),
            ast::CellKind::AnyOf(names) => names,
        };
        let place = |lower: &mut Self, name: &ast::Name| match subject {
            Subject::Reading(_, variable) => lower.term_of(name, variable),
            Subject::Doing(_, doing) => lower.doing_named(name, doing, scene),
            Subject::Condition(_) => {
                let place = values.names.iter().position(|known| *known == name.text);
                if place.is_none() {
                    let diagnostic =
                        invalid(name.span, format!("a condition is `set` or `clear`, not `{}`", name.text));
                    lower.report(diagnostic);
                }
                place
            }
        };
        let places: Vec<_> = names.iter().map(|name| place(self, name)).collect();
        let mut places = places.into_iter().map(|place| Some(place? as u32)).collect::<Option<Vec<_>>>()?;
        places.sort_unstable();
        places.dedup();
        Some(places)
    }

    /// A command, `either(...)` of several, or `nothing`.
    fn commands(&mut self, tree: &ast::Expr, actions: &[Id<ir::Action>], scene: &Scene) -> Option<Vec<ir::Call>> {
        match &tree.kind {
            ast::ExprKind::Path(path) if is(path, "nothing") => Some(Vec::new()),
            ast::ExprKind::Call(call) if is(&call.path, "either") => {
                if call.arguments.len() < 2 {
                    let message = format!("`either` takes 2 commands or more, {}", given(call.arguments.len()));
                    self.report(Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, call.span, message));
                    return None;
                }
                let commands = call.arguments.iter().map(|argument| self.command_of(&argument.value, actions, scene));
                commands.collect::<Vec<_>>().into_iter().collect()
            }
            _ => Some(vec![self.command_of(tree, actions, scene)?]),
        }
    }

    fn command_of(&mut self, tree: &ast::Expr, actions: &[Id<ir::Action>], scene: &Scene) -> Option<ir::Call> {
        if let ast::ExprKind::Call(call) = &tree.kind {
            return self.call(call, actions, scene);
        }
        self.report(not_a_command(tree.span, self.sources.slice(tree.span)));
        None
    }
}

fn is(path: &ast::Path, word: &str) -> bool {
    path.segments.iter().map(|name| name.text.as_str()).eq([word])
}

fn not_a_command(span: Span, written: &str) -> Diagnostic {
    invalid(span, format!("`{written}` is no command"))
        .help("write an action with its arguments, `either(...)` of several, or `nothing`")
}
