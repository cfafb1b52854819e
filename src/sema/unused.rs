//! Declarations that nothing reads, though something should where they stand.
//!
//! A file offers what it declares to others, so most of it is not judged by what the file does with it itself: a
//! variable only beside a network, its terms beside a network that takes it, a sensor beside what runs on its robot.

use super::Lower;
use super::diagrams::sense_name;
use super::sensors::declared_name;
use crate::base::{Id, Sources};
use crate::diag::{Diagnostic, Edit, Fix, rules};
use crate::ir::{self, FailReading, Platform};
use crate::syntax::ast;

impl Lower<'_> {
    fn is_read(&self, symbol: &ir::Symbol) -> bool {
        self.read.contains(&symbol.span)
    }

    /// Reports what nothing reads; to be called when all has been lowered.
    pub(super) fn unused(&mut self) {
        let mut found = Vec::new();
        for item in self.units.iter().flat_map(|unit| &unit.tree.items) {
            match item {
                ast::Item::Diagram(diagram) => self.unused_in_diagram(diagram, &mut found),
                ast::Item::Robot(robot) => self.unused_in_robot(robot, &mut found),
                _ => {}
            }
        }
        for variable in self.program.variables.values() {
            self.unused_in_variable(variable, &mut found);
        }
        for output in self.program.networks.values().flat_map(|network| &network.outputs) {
            let unread = output.terms.iter().filter(|term| !self.is_read(&term.symbol));
            found.extend(unread.map(|term| unused_output_term(&term.symbol, &output.symbol.name)));
        }
        for (id, robot) in self.program.robots.iter() {
            self.unused_sensors(id, robot, &mut found);
        }
        self.diagnostics.extend(found);
    }

    fn unused_in_diagram(&self, tree: &ast::Diagram, found: &mut Vec<Diagnostic>) {
        for item in &tree.items {
            match item {
                ast::DiagramItem::Flag(flag) if !self.read.contains(&flag.name.span) => {
                    found.push(unused_flag(flag, self.sources));
                }
                ast::DiagramItem::Sense(sense) if !self.read.contains(&sense_name(sense).span) => {
                    let fix = self.is_without_effect(tree, sense).then(|| remove_sense(sense, self.sources));
                    found.push(unused_sense(sense, &tree.name.text, fix));
                }
                _ => {}
            }
        }
    }

    fn unused_in_robot(&self, tree: &ast::Robot, found: &mut Vec<Diagnostic>) {
        for item in &tree.items {
            if let ast::RobotItem::Sense(sense) = item
                && !self.read.contains(&sense_name(sense).span)
            {
                found.push(unused_sense(sense, &tree.name.text, None));
            }
        }
    }

    /// Whether a sense that nothing reads can go: a sensor that does not say how it fails takes the word of what it
    /// feeds.
    fn is_without_effect(&self, tree: &ast::Diagram, sense: &ast::Sense) -> bool {
        let diagram = self.scopes.diagrams.get(&tree.name.span).map(|&id| &self.program.diagrams[id]);
        let name = sense_name(sense).span;
        let sense = diagram.and_then(|diagram| diagram.senses.iter().find(|sense| sense.symbol.span == name));
        let says = |fails: &[FailReading]| fails.iter().any(|fail| matches!(fail, FailReading::Value(_)));
        sense.is_some_and(|sense| sense.inputs.iter().all(|&sensor| says(&self.program.sensors[sensor].fails)))
    }

    fn unused_in_variable(&self, variable: &ir::Variable, found: &mut Vec<Diagnostic>) {
        let beside = |network: &&ir::Network| network.symbol.span.file == variable.symbol.span.file;
        let takes = |network: &ir::Network| {
            network.inputs.iter().any(|input| self.program.variables[input.variable].symbol == variable.symbol)
        };
        let mut networks = self.program.networks.values().filter(beside).peekable();
        if networks.peek().is_none() {
            return;
        }
        if !self.is_read(&variable.symbol) {
            found.push(unused_variable(&variable.symbol));
        } else if networks.any(takes) {
            let unread = variable.terms.iter().filter(|term| !self.is_read(&term.symbol));
            found.extend(unread.map(|term| unused_term(&term.symbol, &variable.symbol.name)));
        }
    }

    fn unused_sensors(&self, id: Id<ir::Robot>, robot: &ir::Robot, found: &mut Vec<Diagnostic>) {
        let file = robot.symbol.span.file;
        let diagrams = self.program.diagrams.values();
        // What the robot itself runs is part of it.
        let drive =
            robot.drive.as_ref().and_then(|drive| drive.diagram).map(|drive| &self.program.diagrams[drive].symbol);
        let runs = diagrams.filter(|diagram| diagram.platform == Platform::Robot(id)).map(|diagram| &diagram.symbol);
        let runs = runs.filter(|symbol| Some(*symbol) != drive);
        let scenarios = self.program.scenarios.values();
        let tries = scenarios.filter(|scenario| scenario.robot == id).map(|scenario| &scenario.symbol);
        if !runs.chain(tries).any(|symbol| symbol.span.file == file) {
            return;
        }
        let promised = robot.provides.iter().flat_map(|&interface| &self.program.interfaces[interface].sensors);
        let promised: Vec<_> =
            promised.map(|&sensor| declared_name(&self.program.sensors[sensor].symbol.name)).collect();
        let sensors = robot.all_sensors();
        let sensors = sensors.iter().map(|&sensor| &self.program.sensors[sensor]).filter(|sensor| !sensor.is_inner());
        let symbols = sensors.map(|sensor| &sensor.symbol);
        let unread = symbols.filter(|symbol| !self.is_read(symbol) && !promised.contains(&declared_name(&symbol.name)));
        let mut unread: Vec<_> = unread.collect();
        unread.dedup_by_key(|symbol| symbol.span);
        found.extend(unread.into_iter().map(unused_sensor));
    }
}

fn unused_flag(flag: &ast::Flag, sources: &Sources) -> Diagnostic {
    let edits = flag.doc.iter().map(|doc| doc.span).chain([flag.span]);
    let fix =
        Fix { message: "remove the flag".to_owned(), edits: edits.map(|span| Edit::remove(span, sources)).collect() };
    Diagnostic::new(&rules::UNUSED_FLAG, flag.name.span, format!("nothing reads the flag `{}`", flag.name.text))
        .here("never read")
        .help("read it in a condition, or remove it")
        .fix(fix)
}

fn unused_sense(sense: &ast::Sense, diagram: &str, fix: Option<Fix>) -> Diagnostic {
    let message = format!("nothing in `{diagram}` reads an event or an output of `{}`", sense_name(sense).text);
    let diagnostic = Diagnostic::new(&rules::UNUSED_SENSE, sense.span, message)
        .here("never read")
        .help("read one of its events in a condition, give an output to an action, or remove it");
    Diagnostic { fix, ..diagnostic }
}

fn remove_sense(sense: &ast::Sense, sources: &Sources) -> Fix {
    Fix { message: "remove the sense".to_owned(), edits: vec![Edit::remove(sense.span, sources)] }
}

fn unused_variable(variable: &ir::Symbol) -> Diagnostic {
    Diagnostic::new(
        &rules::UNUSED_VARIABLE,
        variable.span,
        format!("no network takes the variable `{}`", variable.name),
    )
    .help("give it to an input of a network, or remove it")
}

fn unused_term(term: &ir::Symbol, variable: &str) -> Diagnostic {
    let message = format!("no rule names the term `{}` of `{variable}`", term.name);
    Diagnostic::new(&rules::UNUSED_TERM, term.span, message)
        .here("never named")
        .note("`_` names all terms of a variable")
        .help("name it in a rule for or against an event, or remove it")
}

fn unused_output_term(term: &ir::Symbol, output: &str) -> Diagnostic {
    let message = format!("no rule names the term `{}` of `{output}`", term.name);
    Diagnostic::new(&rules::UNUSED_TERM, term.span, message)
        .here("never named")
        .help("set the output to it in a rule, or remove it")
}

fn unused_sensor(sensor: &ir::Symbol) -> Diagnostic {
    let name = declared_name(&sensor.name);
    Diagnostic::new(&rules::UNUSED_SENSOR, sensor.span, format!("nothing reads the sensor `{name}`"))
        .here("never read")
        .help("read it in a condition or feed it to a network, or remove it")
}
