//! One diagram as a process.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use super::HEALTHY;
use super::names::{Kind, Names};
use crate::analysis::modes::{Fault, FaultSet, Machine};
use crate::base::{Exact, Id, Sources, Span};
use crate::ir::{Diagram, Mode, Program, Sensor};

/// What a process is written from.
pub(super) struct Writer<'a, 'n> {
    pub(super) program: &'a Program,
    pub(super) sources: &'a Sources,
    pub(super) machine: &'a Machine,
    pub(super) diagram: &'a Diagram,
    pub(super) names: &'n mut Names,
    sensors: Sensors,
    pub(super) text: String,
}

/// The variable of each sensor that fails, and the value for each way in which it does.
type Sensors = BTreeMap<Id<Sensor>, (String, BTreeMap<Fault, String>)>;

/// The process of a machine: its name, and its text.
pub(super) fn proctype(program: &Program, sources: &Sources, machine: &Machine, names: &mut Names) -> (String, String) {
    let diagram = &program.diagrams[machine.diagram];
    let layer = diagram.layer.keyword();
    let title = format!("{layer} {}", diagram.symbol.name);
    let name = names.fresh(Kind::Process, &title);
    let sensors = sensors(program, machine, names);
    let mut writer = Writer { program, sources, machine, diagram, names, sensors, text: String::new() };
    _ = writeln!(writer.text, "\n/* {title}, {} */", writer.place(diagram.symbol.span));
    _ = writeln!(writer.text, "proctype {name}() {{");
    if let Some(entry) = diagram.entry {
        let entry = writer.mode(entry);
        _ = writeln!(writer.text, "    mode = {entry};");
    }
    writer.text += "    do\n";
    writer.failures();
    for (mode, guards) in diagram.modes.ids().zip(&machine.modes) {
        writer.ticks(mode, guards);
    }
    writer.text += "    od\n}\n";
    (name, writer.text)
}

fn sensors(program: &Program, machine: &Machine, names: &mut Names) -> Sensors {
    let mut sensors = Sensors::new();
    for &(id, fault) in machine.faults.iter().flatten().collect::<BTreeSet<_>>() {
        let sensor = &program.sensors[id];
        let at = |reading: Exact| sensor.unit.show(reading.to_f64());
        let text = match fault {
            Fault::Reported => "reported".to_owned(),
            Fault::Absent => "absent".to_owned(),
            Fault::Stuck(reading) => format!("stuck at {}", at(reading)),
            Fault::Between(low, high) => format!("stuck between {} and {}", at(low), at(high)),
        };
        let new = || (names.of(Kind::Sensor, &sensor.symbol.name), BTreeMap::new());
        let (_, values) = sensors.entry(id).or_insert_with(new);
        let value = names.distinct(Kind::Fault, &text, |known| values.values().any(|value| value == known));
        values.insert(fault, value);
    }
    sensors
}

impl Writer<'_, '_> {
    pub(super) fn place(&self, span: Span) -> String {
        format!("{}:{}", self.sources.path(span.file), self.sources.position(span.file, span.start).0)
    }

    pub(super) fn mode(&mut self, mode: Id<Mode>) -> String {
        self.names.of(Kind::Mode, &self.diagram.modes[mode].symbol.name)
    }

    /// Sensors fail one after another, at any time, and stay so.
    fn failures(&mut self) {
        let most = self.machine.faults.iter().map(Vec::len).max().unwrap_or(0);
        for (sensor, values) in self.sensors.values() {
            for value in values.values() {
                let (guard, fails) =
                    (format!("failures < {most} && {sensor} == {HEALTHY}"), format!("{sensor} = {value}"));
                _ = writeln!(self.text, "    :: d_step {{ {guard} -> {fails}; failures++ }}");
            }
        }
    }

    /// Whether a sensor is as a set of failed sensors says.
    pub(super) fn state(&self, sensor: Id<Sensor>, faults: &FaultSet) -> String {
        let (variable, values) = &self.sensors[&sensor];
        let fault = faults.iter().find(|(failed, _)| *failed == sensor);
        format!("{variable} == {}", fault.map_or(HEALTHY, |(_, fault)| values[fault].as_str()))
    }

    /// Whether exactly these sensors have failed.
    pub(super) fn failed(&self, faults: &FaultSet) -> String {
        let failed = faults.iter().map(|(sensor, _)| format!(" && {}", self.state(*sensor, faults)));
        format!("failures == {}{}", faults.len(), failed.collect::<String>())
    }

    /// For each sensor that a mode requires and that can be known to have failed, whether that `is` so, as an operator.
    pub(super) fn required(&self, mode: Id<Mode>, is: &str) -> Vec<String> {
        let required = self.diagram.modes[mode].requires.iter();
        required.filter_map(|(sensor, _)| Some(format!("{} {is} reported", self.sensors.get(sensor)?.0))).collect()
    }
}
