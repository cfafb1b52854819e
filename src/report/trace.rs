//! A trace as a table for spreadsheets and scripts.

use std::io::{Result, Write};

use serde::Serializer;
use serde::ser::SerializeMap;

use crate::trace::{Column, Trace, seconds};

/// Writes a trace as CSV: a header, then a line a tick with `t` in seconds, the name of the mode, and every column in
/// SI with full precision; flags are 0 and 1.
///
/// # Errors
/// Those of `to`.
pub fn trace_csv(trace: &Trace, to: impl Write) -> Result<()> {
    let mut to = csv::Writer::from_writer(to);
    to.write_field("t")?;
    to.write_field("mode")?;
    for column in &trace.columns {
        to.write_field(&column.name)?;
    }
    to.write_record(None::<&[u8]>)?;
    let mut field = Vec::new();
    for (tick, &time) in trace.times.iter().enumerate() {
        number(&mut to, &mut field, seconds(time))?;
        to.write_field(trace.at(tick))?;
        for column in &trace.columns {
            let value = value(column, tick);
            if column.signal.is_flag() {
                to.write_field(if value == 0.0 { "0" } else { "1" })?;
            } else {
                number(&mut to, &mut field, value)?;
            }
        }
        to.write_record(None::<&[u8]>)?;
    }
    to.flush()
}

/// Writes a trace as JSON, one object a tick with the members `t` (seconds), `mode` and one for every column; flags
/// are true and false, and a number that is not finite is null.
///
/// # Errors
/// Those of `to`.
pub fn trace_jsonl(trace: &Trace, mut to: impl Write) -> Result<()> {
    for (tick, &time) in trace.times.iter().enumerate() {
        let mut line = serde_json::Serializer::new(&mut to);
        let mut object = line.serialize_map(None)?;
        object.serialize_entry("t", &seconds(time))?;
        object.serialize_entry("mode", trace.at(tick))?;
        for column in &trace.columns {
            let value = value(column, tick);
            if column.signal.is_flag() {
                object.serialize_entry(&column.name, &(value != 0.0))?;
            } else {
                object.serialize_entry(&column.name, &value)?;
            }
        }
        object.end()?;
        to.write_all(b"\n")?;
    }
    to.flush()
}

fn number<W: Write>(to: &mut csv::Writer<W>, field: &mut Vec<u8>, number: f64) -> Result<()> {
    field.clear();
    write!(field, "{number:?}")?;
    Ok(to.write_field(&field)?)
}

/// The value on a tick; not a number where the column ends before it.
fn value(column: &Column, tick: usize) -> f64 {
    column.values.get(tick).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::samples;

    fn text(write: impl FnOnce(&mut Vec<u8>) -> Result<()>) -> String {
        let mut bytes = Vec::new();
        write(&mut bytes).unwrap();
        String::from_utf8(bytes).unwrap()
    }

    #[test]
    fn a_tick_is_a_line() {
        let mut trace = samples::trace();
        trace.times.truncate(3);
        trace.columns[1].values[1] = f64::NAN;
        trace.columns[1].name = "odd, \"name\"".to_owned();
        insta::assert_snapshot!(text(|to| trace_csv(&trace, to)), @r#"
        t,mode,left_wheel_acceleration,"odd, ""name""",obstacle_id.forward_collision,obstacle_id.heavy_obstacle
        0.0,init,-0.0,0.0,0,0
        0.25,init,-0.0,NaN,0,0
        0.5,init,-0.0,0.16666666666666666,0,0
        "#);
        insta::assert_snapshot!(text(|to| trace_jsonl(&trace, to)), @r#"
        {"t":0.0,"mode":"init","left_wheel_acceleration":-0.0,"odd, \"name\"":0.0,"obstacle_id.forward_collision":false,"obstacle_id.heavy_obstacle":false}
        {"t":0.25,"mode":"init","left_wheel_acceleration":-0.0,"odd, \"name\"":null,"obstacle_id.forward_collision":false,"obstacle_id.heavy_obstacle":false}
        {"t":0.5,"mode":"init","left_wheel_acceleration":-0.0,"odd, \"name\"":0.16666666666666666,"obstacle_id.forward_collision":false,"obstacle_id.heavy_obstacle":false}
        "#);
    }

    #[test]
    fn numbers_come_back_as_they_were() {
        let trace = samples::trace();
        let table = text(|to| trace_csv(&trace, to));
        let mut reader = csv::Reader::from_reader(table.as_bytes());
        let force = reader.headers().unwrap().iter().position(|name| name == "contact_force").unwrap();
        let forces = reader.records().map(|record| record.unwrap()[force].parse::<f64>().unwrap());
        let recorded = trace.columns.iter().find(|column| column.name == "contact_force").unwrap();
        assert_eq!(forces.collect::<Vec<_>>(), recorded.values);
    }

    #[test]
    fn no_ticks_leave_the_header() {
        assert_eq!(text(|to| trace_csv(&Trace::default(), to)), "t,mode\n");
        assert_eq!(text(|to| trace_jsonl(&Trace::default(), to)), "");
    }
}
