//! Many readings of a network at once: a table in, a table out.

use std::fmt;

use crate::diag::nearest;
use crate::interp::Columns;
use crate::plan::NetworkPlan;

/// Why a table of readings cannot be evaluated.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableError {
    /// The line of the table, from 1.
    pub line: u64,
    /// One line that states a fact about the table.
    pub message: String,
    /// What to change.
    pub help: Option<String>,
}

impl fmt::Display for TableError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)?;
        self.help.iter().try_for_each(|help| write!(f, "; {help}"))
    }
}

impl std::error::Error for TableError {}

fn error(line: u64, message: impl Into<String>, help: Option<String>) -> TableError {
    TableError { line, message: message.into(), help }
}

/// Evaluates a CSV table: a header with the names of the network's inputs in any order, then one reading of each in
/// SI on every line. The answer has the same columns, followed for each event by its flag (`true` or `false`), its
/// contributor and its detractor, and for each output by its value in SI and whether a rule fired, all numbers with full
/// precision. The lines are `dt` nanoseconds apart for events that remember. `nan` and `inf` are readings too, unusable ones.
///
/// # Errors
/// The first thing in the table that is not a reading of this network.
pub fn eval_csv(plan: &NetworkPlan, text: &str, dt: u64) -> Result<String, TableError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|wrong| unreadable(text, &wrong))?.clone();
    let inputs = columns(plan, &header)?;

    let mut writer = csv::Writer::from_writer(Vec::new());
    let events = plan.events.iter().flat_map(|event| ["", ".contributor", ".detractor"].map(|part| (event, part)));
    let named = events.map(|(event, part)| format!("{}{part}", event.name));
    let outputs = plan.outputs.iter().flat_map(|output| ["", ".fired"].map(|part| format!("{}{part}", output.name)));
    write(&mut writer, header.iter().map(str::to_owned).chain(named).chain(outputs))?;

    let mut block = Block { columns: Columns::new(plan), readings: vec![Vec::new(); plan.inputs.len()], dt };
    for record in reader.records() {
        let record = record.map_err(|wrong| unreadable(text, &wrong))?;
        for (&input, field) in inputs.iter().zip(&record) {
            let value = number(field).ok_or_else(|| not_a_number(plan, input, field, line(text, record.position())))?;
            if let Some(column) = block.readings.get_mut(input) {
                column.push(value);
            }
        }
        if block.rows() == Columns::BLOCK {
            block.write(plan, &inputs, &mut writer)?;
        }
    }
    block.write(plan, &inputs, &mut writer)?;
    let bytes = writer.into_inner().map_err(|wrong| error(1, wrong.to_string(), None))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Rows that are evaluated together.
struct Block<'p> {
    columns: Columns<'p>,
    readings: Vec<Vec<f64>>,
    dt: u64,
}

impl Block<'_> {
    fn rows(&self) -> usize {
        self.readings.first().map_or(0, Vec::len)
    }

    /// Evaluates the rows and writes their lines, with the inputs in the order of the table.
    fn write(
        &mut self,
        plan: &NetworkPlan,
        inputs: &[usize],
        writer: &mut csv::Writer<Vec<u8>>,
    ) -> Result<(), TableError> {
        self.columns.evaluate(&self.readings, self.dt);
        let columns = &self.columns;
        for row in 0..self.rows() {
            let readings = inputs.iter().map(|&input| format!("{:?}", self.readings[input][row]));
            let events = plan.events.iter().flat_map(|event| {
                let strengths = [event.contributor, event.detractor].map(|real| columns.reals(real)[row]);
                [
                    columns.bools(event.flag)[row].to_string(),
                    format!("{:?}", strengths[0]),
                    format!("{:?}", strengths[1]),
                ]
            });
            let outputs = plan.outputs.iter().flat_map(|output| {
                [format!("{:?}", columns.reals(output.value)[row]), columns.bools(output.fired)[row].to_string()]
            });
            write(writer, readings.chain(events).chain(outputs))?;
        }
        self.readings.iter_mut().for_each(Vec::clear);
        Ok(())
    }
}

/// The input that each column of the header names.
fn columns(plan: &NetworkPlan, header: &csv::StringRecord) -> Result<Vec<usize>, TableError> {
    let names = || plan.inputs.iter().map(|input| input.name.as_str());
    let mut inputs = Vec::new();
    for name in header {
        let Some(input) = names().position(|input| input == name) else {
            let message = format!("`{name}` is not an input of `{}`", plan.name);
            let help = nearest(name, names()).map(|near| format!("did you mean `{near}`?"));
            return Err(error(1, message, help.or_else(|| Some(format!("its inputs are {}", list(names()))))));
        };
        if inputs.contains(&input) {
            return Err(error(1, format!("there are two columns `{name}`"), None));
        }
        inputs.push(input);
    }
    let missing = names().enumerate().filter(|(input, _)| !inputs.contains(input)).map(|(_, name)| name);
    let missing = list(missing);
    if missing.is_empty() { Ok(inputs) } else { Err(error(1, format!("there is no column for {missing}"), None)) }
}

fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

fn number(field: &str) -> Option<f64> {
    field.parse().ok()
}

fn not_a_number(plan: &NetworkPlan, input: usize, field: &str, line: u64) -> TableError {
    let name = plan.inputs.get(input).map_or("", |input| &input.name);
    let message = match field {
        "" => format!("there is no reading for `{name}`"),
        _ => format!("`{field}` for `{name}` is not a number"),
    };
    error(line, message, Some("readings are plain numbers in SI units".to_owned()))
}

/// The line on which a record begins: the reader's position may lie before empty lines that it skips.
fn line(text: &str, position: Option<&csv::Position>) -> u64 {
    let byte = position.map_or(0, |position| position.byte() as usize);
    let empty = text.get(byte..).map_or(0, |rest| rest.len() - rest.trim_start_matches(['\r', '\n']).len());
    let before = text.get(..byte + empty).unwrap_or(text);
    before.bytes().filter(|&byte| byte == b'\n').count() as u64 + 1
}

fn unreadable(text: &str, wrong: &csv::Error) -> TableError {
    let line = line(text, wrong.position());
    let message = match wrong.kind() {
        csv::ErrorKind::UnequalLengths { expected_len, len, .. } => {
            let values = if *len == 1 { "value" } else { "values" };
            format!("{len} {values} where the header has {expected_len} columns")
        }
        _ => "the table cannot be read".to_owned(),
    };
    error(line, message, None)
}

/// Writing to memory has no way to fail, but the writer cannot know.
fn write(
    writer: &mut csv::Writer<Vec<u8>>,
    fields: impl IntoIterator<Item = impl AsRef<[u8]>>,
) -> Result<(), TableError> {
    writer.write_record(fields).map_err(|wrong| unreadable("", &wrong))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interp::{Evaluator, Reading};
    use crate::report::samples;

    #[test]
    fn a_table_goes_in_and_a_table_comes_out() {
        let table = "force, left\n118,-0.75\n0,1e-1\nnan,-9\n";
        insta::assert_snapshot!(eval_csv(&samples::network(), table, 0).unwrap(), @r#"
        force,left,forward_collision,forward_collision.contributor,forward_collision.detractor
        118.0,-0.75,true,0.59,0.25
        0.0,0.1,false,0.0,1.0
        NaN,-9.0,true,1.0,0.0
        "#);
        assert_eq!(
            eval_csv(&samples::network(), "left,force\n", 0).unwrap(),
            "left,force,forward_collision,forward_collision.contributor,forward_collision.detractor\n"
        );
    }

    #[test]
    fn the_table_and_the_single_evaluation_agree() {
        let plan = samples::network();
        let out = eval_csv(&plan, "left,force\n-0.7123456789,118.2\n", 0).unwrap();
        let mut evaluator = Evaluator::new(&plan);
        evaluator.evaluate(&[-0.712_345_678_9, 118.2].map(|value| Reading { value, healthy: true }), 0);
        let (contributor, detractor) = (plan.events[0].contributor, plan.events[0].detractor);
        let (contributor, detractor) = (evaluator.real(contributor), evaluator.real(detractor));
        assert!(out.ends_with(&format!(",{contributor:?},{detractor:?}\n")), "{out}");
    }

    #[test]
    fn a_wrong_table_is_told_where_and_why() {
        let wrong = |table: &str| eval_csv(&samples::network(), table, 0).unwrap_err().to_string();
        insta::assert_snapshot!([
            "left,forse\n",
            "left,force,velocity\n",
            "left,force,left\n",
            "left\n-1\n",
            "",
            "left,force\n1,2\n-0.5 m,3\n",
            "left,force\n1,\n",
            "left,force\n1,2\n\n1\n",
        ].map(wrong).join("\n"), @r#"
        line 1: `forse` is not an input of `obstacle_id`; did you mean `force`?
        line 1: `velocity` is not an input of `obstacle_id`; its inputs are `left`, `force`
        line 1: there are two columns `left`
        line 1: there is no column for `force`
        line 1: there is no column for `left`, `force`
        line 3: `-0.5 m` for `left` is not a number; readings are plain numbers in SI units
        line 2: there is no reading for `force`; readings are plain numbers in SI units
        line 4: 1 value where the header has 2 columns
        "#);
    }
}
