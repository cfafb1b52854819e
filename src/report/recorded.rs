//! A trace read back from the table or the lines that it was written as.

use std::collections::BTreeMap;

use serde::Deserialize;

use super::table::TableError;

/// What a trace says of one tick.
#[derive(Debug, Clone, PartialEq)]
pub struct Recorded {
    /// Nanoseconds since the first tick.
    pub time: u64,
    /// The name of the mode.
    pub mode: String,
    /// Its numbers by the names of their columns, in SI; flags are left out, and what was no number is NaN.
    pub numbers: BTreeMap<String, f64>,
}

/// A member of a line of JSON: a number, null where it was not finite, or a flag.
#[derive(Deserialize)]
#[serde(untagged)]
enum Member {
    Number(f64),
    Flag(#[expect(dead_code, reason = "flags are computed anew")] bool),
    Mode(String),
    NotFinite(()),
}

/// Reads a trace as `trace_csv` or `trace_jsonl` writes it; which of them, its first character says. Linear in its size.
///
/// # Errors
/// The first line that is not of a trace.
pub fn read_trace(text: &str) -> Result<Vec<Recorded>, TableError> {
    if text.trim_start().starts_with('{') { read_lines(text) } else { read_table(text) }
}

fn read_lines(text: &str) -> Result<Vec<Recorded>, TableError> {
    let lines = text.lines().zip(1..).filter(|(line, _)| !line.trim().is_empty());
    let read = |(line, number): (&str, u64)| {
        let members: BTreeMap<String, Member> =
            serde_json::from_str(line).map_err(|error| no_tick(number, &error.to_string()))?;
        let (mut mode, mut numbers) = (None, BTreeMap::new());
        for (name, member) in members {
            match member {
                Member::Mode(text) if name == "mode" => mode = Some(text),
                Member::Number(value) => drop(numbers.insert(name, value)),
                Member::NotFinite(()) => drop(numbers.insert(name, f64::NAN)),
                Member::Flag(_) | Member::Mode(_) => {}
            }
        }
        tick(number, mode, numbers)
    };
    lines.map(read).collect()
}

fn read_table(text: &str) -> Result<Vec<Recorded>, TableError> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let names = reader.headers().map_err(|error| no_tick(1, &error.to_string()))?.clone();
    let read = |(row, number): (csv::Result<csv::StringRecord>, u64)| {
        let row = row.map_err(|error| no_tick(number, &error.to_string()))?;
        let (mut mode, mut numbers) = (None, BTreeMap::new());
        for (name, field) in names.iter().zip(&row) {
            if name == "mode" {
                mode = Some(field.to_owned());
                continue;
            }
            let value = field.parse().map_err(|_| no_tick(number, &format!("`{field}` is no number")))?;
            numbers.insert(name.to_owned(), value);
        }
        tick(number, mode, numbers)
    };
    reader.records().zip(2..).map(read).collect()
}

fn tick(line: u64, mode: Option<String>, mut numbers: BTreeMap<String, f64>) -> Result<Recorded, TableError> {
    let mode = mode.ok_or_else(|| no_tick(line, "there is no `mode`"))?;
    let seconds = numbers.remove("t").filter(|seconds| *seconds >= 0.0);
    let seconds = seconds.ok_or_else(|| no_tick(line, "there is no time `t`"))?;
    Ok(Recorded { time: (seconds * 1e9).round() as u64, mode, numbers })
}

fn no_tick(line: u64, reason: &str) -> TableError {
    let help = "load what `lmslc run --trace` wrote".to_owned();
    TableError { line, message: format!("this is no tick of a trace: {reason}"), help: Some(help) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{samples, trace_csv, trace_jsonl};
    use crate::trace::seconds;

    #[test]
    fn traces_come_back_as_they_were_written() {
        let mut trace = samples::trace();
        trace.columns[1].values[1] = f64::NAN;
        let (mut table, mut lines) = (Vec::new(), Vec::new());
        trace_csv(&trace, &mut table).unwrap();
        trace_jsonl(&trace, &mut lines).unwrap();
        for text in [table, lines] {
            let ticks = read_trace(&String::from_utf8(text).unwrap()).unwrap();
            assert_eq!(ticks.len(), trace.times.len());
            for (index, tick) in ticks.iter().enumerate() {
                assert_eq!(seconds(tick.time), seconds(trace.times[index]));
                assert_eq!(tick.mode, trace.modes[trace.mode[index] as usize]);
                for column in trace.columns.iter().filter(|column| !column.signal.is_flag()) {
                    assert_eq!(tick.numbers[&column.name].to_bits(), column.values[index].to_bits());
                }
            }
        }
    }

    #[test]
    fn what_is_no_trace_says_where() {
        let error = |text: &str| read_trace(text).unwrap_err().to_string();
        insta::assert_snapshot!(
            [
                error("t,mode,force\n0,init,1\n0.01,init,strong\n"),
                error("time,mode\n0,init\n"),
                error("{\"t\":0,\"mode\":\"init\"}\n{\"t\":1}\n"),
                error("{\"t\":\n"),
            ]
            .join("\n")
        );
    }
}
