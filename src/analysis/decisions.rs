//! Decision tables: in every case one row, and only one.

use std::collections::HashSet;

use crate::diag::{Diagnostic, rules};
use crate::ir::{Column, Decision, DecisionRow, Diagram};

pub(super) fn check(diagram: &Diagram, findings: &mut Vec<Diagnostic>) {
    let own = diagram.modes.values().filter(|mode| !mode.inherited);
    for table in own.filter_map(|mode| mode.decision.as_ref()) {
        let rows: Vec<usize> = (0..table.rows.len()).collect();
        findings.extend(Missing { table, complete: HashSet::new() }.of(&rows, 0).map(|case| incomplete(table, &case)));
        for (index, second) in table.rows.iter().enumerate() {
            let both = table.rows[..index].iter().find_map(|first| Some((first, common(table, first, second)?)));
            findings.extend(both.map(|(first, case)| overlap(table, first, second, &case)));
            findings.extend(impossible(table, second).map(|(column, cell)| never_chosen(second, column, cell)));
        }
    }
}

/// A case: for each column the position of a value, or none where any will do.
type Case = Vec<Option<u32>>;

/// The search for a case that no row fits.
struct Missing<'t> {
    table: &'t Decision,
    /// From which column on which rows leave no case out.
    complete: HashSet<(usize, Vec<usize>)>,
}

impl Missing<'_> {
    /// The values, from a column on, that none of these rows fits.
    fn of(&mut self, rows: &[usize], column: usize) -> Option<Case> {
        let table = self.table;
        if rows.is_empty() {
            return Some(vec![None; table.columns.len() - column]);
        }
        if column == table.columns.len() || self.complete.contains(&(column, rows.to_vec())) {
            return None;
        }
        for value in possible(&table.columns[column]) {
            let fits = |row: &&usize| table.rows[**row].cells[column].contains(&value);
            let rows: Vec<usize> = rows.iter().filter(fits).copied().collect();
            if let Some(rest) = self.of(&rows, column + 1) {
                return Some([vec![Some(value)], rest].concat());
            }
        }
        self.complete.insert((column, rows.to_vec()));
        None
    }
}

/// The values that a column can have.
fn possible(column: &Column) -> impl Iterator<Item = u32> {
    column.possible.iter().zip(0..).filter(|(possible, _)| **possible).map(|(_, value)| value)
}

/// A case that two rows fit, with the values that every fitting case has.
fn common(table: &Decision, first: &DecisionRow, second: &DecisionRow) -> Option<Case> {
    let columns = table.columns.iter().zip(first.cells.iter().zip(&second.cells));
    let value = |(column, (first, second)): (&Column, (&Vec<u32>, &Vec<u32>))| {
        let mut both = possible(column).filter(|value| first.contains(value) && second.contains(value));
        let value = both.next()?;
        Some((both.count() + 1 < possible(column).count()).then_some(value))
    };
    columns.map(value).collect()
}

/// The first column of a row of which no reading fits.
fn impossible<'t>(table: &'t Decision, row: &DecisionRow) -> Option<(&'t Column, u32)> {
    let columns = table.columns.iter().zip(&row.cells);
    let mut columns = columns.filter(|(column, cell)| !possible(column).any(|value| cell.contains(&value)));
    columns.find_map(|(column, cell)| Some((column, *cell.first()?)))
}

/// A case as a row.
fn shown(table: &Decision, case: &Case) -> String {
    let cells = table.columns.iter().zip(case);
    let cells = cells.map(|(column, value)| value.map_or("_", |value| column.values[value as usize].as_str()));
    format!("({})", cells.collect::<Vec<_>>().join(", "))
}

fn incomplete(table: &Decision, case: &Case) -> Diagnostic {
    let row = shown(table, case);
    Diagnostic::new(&rules::DECISION_INCOMPLETE, table.span, format!("no row says what to do at {row}"))
        .help(format!("write `{row} => nothing`, or a command"))
}

fn overlap(table: &Decision, first: &DecisionRow, second: &DecisionRow, case: &Case) -> Diagnostic {
    let message = format!("two rows fit {}", shown(table, case));
    Diagnostic::new(&rules::DECISION_OVERLAP, second.span, message)
        .label(first.span, "this one does already")
        .note("the rows of a table stand in no order: each case has one")
}

fn never_chosen(row: &DecisionRow, column: &Column, cell: u32) -> Diagnostic {
    let value = &column.values[cell as usize];
    let message = format!("no reading of `{}` is `{value}`, so this row is never chosen", column.text);
    Diagnostic::new(&rules::ROW_NEVER_CHOSEN, row.span, message)
        .note("a reading is the term whose degree is highest, the first of those that are equal")
        .help("remove the row, or change the membership functions")
}
