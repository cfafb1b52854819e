//! What can be written at a place.

use lsp_types::{CompletionItem, CompletionItemKind, Documentation};

use super::known::Known;
use super::place::{List, Place};
use crate::base::{FileId, Id, UNITS};
use crate::driver::LIBRARY;
use crate::ir::{Diagram, Network, Platform, Program, Robot, Symbol, Term};
use crate::sema;

/// Everything that fits at a byte of a file; the client leaves out what does not begin as the word that stands there.
/// `beside` gives the files that an import can name.
pub(super) fn completion(
    known: &Known,
    file: FileId,
    byte: usize,
    beside: &dyn Fn() -> Vec<String>,
) -> Vec<CompletionItem> {
    let Some(place) = Place::new(known.text(file), byte) else { return Vec::new() };
    let here = Here { known, program: &known.analysis.program, file, place };
    let mut items = here.items(beside);
    items.sort_by(|a, b| a.label.cmp(&b.label));
    items.dedup_by(|a, b| a.label == b.label);
    items
}

struct Here<'a> {
    known: &'a Known,
    program: &'a Program,
    file: FileId,
    place: Place<'a>,
}

fn item(label: impl Into<String>, kind: CompletionItemKind) -> CompletionItem {
    CompletionItem { label: label.into(), kind: Some(kind), ..CompletionItem::default() }
}

fn named(symbol: &Symbol, kind: CompletionItemKind) -> CompletionItem {
    let documentation = (!symbol.doc.is_empty()).then(|| Documentation::String(symbol.doc.clone()));
    CompletionItem { documentation, ..item(&symbol.name, kind) }
}

fn words(words: &[&str]) -> Vec<CompletionItem> {
    words.iter().map(|word| item(*word, CompletionItemKind::KEYWORD)).collect()
}

fn detailed(item: CompletionItem, detail: impl Into<String>) -> CompletionItem {
    CompletionItem { detail: Some(detail.into()), ..item }
}

fn units() -> Vec<CompletionItem> {
    UNITS.iter().map(|unit| detailed(item(unit.name, CompletionItemKind::UNIT), unit.meaning)).collect()
}

fn terms(terms: &[Term]) -> impl Iterator<Item = CompletionItem> {
    terms.iter().map(|term| named(&term.symbol, CompletionItemKind::ENUM_MEMBER))
}

/// The words a line can begin with, by what it stands in.
fn beginnings(keyword: &str) -> &'static [&'static str] {
    match keyword {
        "network" => &["event", "output", "rule"],
        "event" => &["contributor", "detractor", "rule"],
        "interface" => &["action", "optional", "sensor"],
        "robot" => &["action", "body", "logical", "optional", "sense", "sensor"],
        "body" => &["acceleration_limit", "impact_time", "lag", "mass", "size", "track", "tracking_noise", "traction"],
        "behavior" | "activity" | "goal" => &["entry", "final", "flag", "mode", "sense"],
        "mode" => &["decide", "on"],
        "world" => &["box", "door", "goal", "wall"],
        "scenario" => &["duration", "expect", "fail", "fault", "place", "seed", "tick"],
        _ => &[],
    }
}

impl Here<'_> {
    fn items(&self, beside: &dyn Fn() -> Vec<String>) -> Vec<CompletionItem> {
        let place = &self.place;
        let line = place.line();
        let block = place.block().map_or("", |block| block.keyword);
        let first = line.first().copied().unwrap_or("");
        if first == "import" {
            return Self::imports(&line, beside);
        }
        if place.is_behind_number() {
            return units();
        }
        if let Some(list) = place.list().filter(|_| !line.contains(&"rule")) {
            return self.in_list(list, block, first);
        }
        match (place.back(0), block) {
            ("", _) | (_, "") if line.is_empty() => self.outermost(),
            ("=>", "decide") => [self.actions(block), words(&["either", "nothing"])].concat(),
            ("->", "robot" | "interface") => words(&["done"]),
            ("->", _) => [self.modes(), words(&["again"])].concat(),
            ("else" | "entry", _) => self.modes(),
            ("=", "activity" | "goal") if line.contains(&"mode") => self.diagrams(),
            ("requires" | "fault" | "fail", _) => self.sensors(),
            (",", "behavior" | "activity" | "goal") if line.contains(&"requires") => self.sensors(),
            ("sense", _) => self.networks(),
            ("extends", _) if first == "scenario" => self.scenarios(),
            ("extends" | "runs" | "of", "") => self.diagrams(),
            ("on", "") => self.platforms(),
            ("in", "") if first == "scenario" => self.worlds(),
            ("provides", _) => self.interfaces(),
            (":", "") if first == "variable" => units(),
            (":", "robot" | "interface" | "network") => units(),
            ("modes" | ",", "scenario") if line.contains(&"modes") => self.modes(),
            (".", _) => self.members(&self.path(1)),
            ("is", _) if place.back(1) == "mode" && place.back(2) == "." => self.modes_inside(&self.path(3)),
            (_, "event" | "network") if line.contains(&"rule") => self.in_words(&line),
            ("=" | "not" | "very" | "somewhat" | "and" | "or", "variable" | "output") => self.shapes(),
            (before, _) if Self::is_condition(&line, before) => self.conditions(),
            _ if line.is_empty() => [words(beginnings(block)), self.actions(block)].concat(),
            ("final", _) => words(&["mode"]),
            ("expect", _) => [words(&["always", "modes", "never"]), self.conditions()].concat(),
            _ => Vec::new(),
        }
    }

    /// Whether a condition, or an operand of one, is due.
    fn is_condition(line: &[&str], before: &str) -> bool {
        let named = line.contains(&"flag") || line.contains(&"logical");
        let starts = line.len() == 2 && before == ":" || named && before == "=";
        let first = line.first().copied().unwrap_or("");
        let says = ["never", "always", "to"].contains(&before) || first == "property" && before == ":";
        let goes_on = ["and", "or", "not", "<", "<=", ">", ">=", "==", "!="].contains(&before);
        starts || says || goes_on
    }

    /// The files whose declarations can be named here.
    fn sees(&self, symbol: &Symbol) -> bool {
        let units = self.known.analysis.units.iter();
        let own = units.filter(|unit| unit.file == self.file);
        symbol.span.file == self.file
            || own.flat_map(|unit| &unit.imports).any(|import| import.file == symbol.span.file)
    }

    fn seen<'s>(&self, symbols: impl Iterator<Item = &'s Symbol>, kind: CompletionItemKind) -> Vec<CompletionItem> {
        symbols.filter(|symbol| self.sees(symbol)).map(|symbol| named(symbol, kind)).collect()
    }

    fn networks(&self) -> Vec<CompletionItem> {
        self.seen(self.program.networks.values().map(|network| &network.symbol), CompletionItemKind::MODULE)
    }

    fn diagrams(&self) -> Vec<CompletionItem> {
        self.seen(self.program.diagrams.values().map(|diagram| &diagram.symbol), CompletionItemKind::CLASS)
    }

    fn scenarios(&self) -> Vec<CompletionItem> {
        self.seen(self.program.scenarios.values().map(|scenario| &scenario.symbol), CompletionItemKind::CLASS)
    }

    fn worlds(&self) -> Vec<CompletionItem> {
        self.seen(self.program.worlds.values().map(|world| &world.symbol), CompletionItemKind::CLASS)
    }

    fn interfaces(&self) -> Vec<CompletionItem> {
        self.seen(self.program.interfaces.values().map(|interface| &interface.symbol), CompletionItemKind::INTERFACE)
    }

    fn platforms(&self) -> Vec<CompletionItem> {
        let robots = self.seen(self.program.robots.values().map(|robot| &robot.symbol), CompletionItemKind::CLASS);
        [robots, self.interfaces()].concat()
    }

    fn variables(&self) -> Vec<CompletionItem> {
        self.seen(self.program.variables.values().map(|variable| &variable.symbol), CompletionItemKind::TYPE_PARAMETER)
    }

    fn outermost(&self) -> Vec<CompletionItem> {
        let unit = self.known.analysis.units.iter().find(|unit| unit.file == self.file);
        match unit.map(|unit| unit.tree.kind) {
            Some(crate::syntax::ast::FileKind::Fusion) => words(&["import", "network", "variable"]),
            _ => words(&[
                "activity",
                "arbiter",
                "behavior",
                "goal",
                "import",
                "interface",
                "property",
                "robot",
                "scenario",
                "world",
            ]),
        }
    }

    /// The next part of the names of files that go on as the line does.
    fn imports(line: &[&str], beside: &dyn Fn() -> Vec<String>) -> Vec<CompletionItem> {
        let written: String = line.iter().skip(1).copied().collect();
        let library = LIBRARY.iter().filter_map(|(path, _)| Some(path.rsplit_once('.')?.0.replace('/', ".")));
        let all = library.chain(beside());
        let rest = all.filter_map(|name| name.strip_prefix(&written).map(str::to_owned));
        let next = rest.filter_map(|rest| Some(rest.split('.').next()?.to_owned()));
        next.map(|next| item(next, CompletionItemKind::MODULE)).collect()
    }

    /// The diagram that is being written, or that is spoken of.
    fn diagram(&self) -> Option<Id<Diagram>> {
        let block = self.place.declaration();
        let own = |symbol: &Symbol, name: &str| symbol.span.file == self.file && symbol.name == name;
        match block {
            Some(block) if block.keyword == "scenario" => {
                let scenarios = self.program.scenarios.values();
                let mut known =
                    scenarios.filter(|scenario| own(&scenario.symbol, block.name)).map(|scenario| scenario.diagram);
                // One that is half written is not there; what it runs is what stands behind `runs`.
                known.next_back().or_else(|| self.only_diagram())
            }
            Some(block) => {
                let mut diagrams = self.program.diagrams.iter();
                diagrams.find(|(_, diagram)| own(&diagram.symbol, block.name)).map(|(id, _)| id)
            }
            None => self.only_diagram(),
        }
    }

    /// What a property or scenario speaks of where it does not say so: the last diagram that can be named.
    fn only_diagram(&self) -> Option<Id<Diagram>> {
        let own = |diagram: &Diagram| diagram.symbol.span.file == self.file;
        let diagrams: Vec<_> = self.program.diagrams.iter().filter(|(_, diagram)| self.sees(&diagram.symbol)).collect();
        let last = diagrams.iter().rev().find(|(_, diagram)| own(diagram)).or(diagrams.last());
        last.map(|(id, _)| *id)
    }

    fn modes(&self) -> Vec<CompletionItem> {
        let Some(id) = self.diagram() else { return Vec::new() };
        let modes = self.program.diagrams[id].modes.values();
        modes.map(|mode| named(&mode.symbol, CompletionItemKind::ENUM_MEMBER)).collect()
    }

    /// The robot that is being written.
    fn robot(&self) -> Option<Id<Robot>> {
        let block = self.place.declaration().filter(|block| block.keyword == "robot")?;
        let own = |symbol: &Symbol| symbol.span.file == self.file && symbol.name == block.name;
        self.program.robots.iter().find(|(_, robot)| own(&robot.symbol)).map(|(id, _)| id)
    }

    fn sensors(&self) -> Vec<CompletionItem> {
        let of_diagram = || self.diagram().map(|id| self.program.diagrams[id].platform);
        let Some(platform) = self.robot().map(Platform::Robot).or_else(of_diagram) else { return Vec::new() };
        let sensors = self.program.sensors_of(platform).into_iter().map(|id| &self.program.sensors[id]);
        sensors.map(|sensor| detailed(named(&sensor.symbol, CompletionItemKind::FIELD), &sensor.unit.text)).collect()
    }

    /// What can be called in a mode.
    fn actions(&self, block: &str) -> Vec<CompletionItem> {
        let Some(id) = self.diagram().filter(|_| ["mode", "enter", "exit", "decide"].contains(&block)) else {
            return Vec::new();
        };
        let actions = self.program.actions_of(self.program.diagrams[id].platform).iter();
        let actions = actions.map(|&id| &self.program.actions[id]);
        actions
            .map(|action| detailed(named(&action.symbol, CompletionItemKind::METHOD), super::signature::form(action)))
            .collect()
    }

    /// The names with dots between them that end that many words before the place.
    fn path(&self, back: usize) -> Vec<&str> {
        let mut path = vec![self.place.back(back)];
        while self.place.back(back + 2 * path.len() - 1) == "." {
            path.push(self.place.back(back + 2 * path.len()));
        }
        path.reverse();
        path
    }

    /// The diagram that runs inside a mode, named by the modes around it and itself.
    fn inside(&self, path: &[&str]) -> Option<&Diagram> {
        path.iter().try_fold(&self.program.diagrams[self.diagram()?], |diagram, name| {
            let mode = diagram.modes.values().find(|mode| mode.symbol.name == *name)?;
            Some(&self.program.diagrams[mode.runs?.diagram])
        })
    }

    fn modes_inside(&self, path: &[&str]) -> Vec<CompletionItem> {
        let modes = self.inside(path).into_iter().flat_map(|diagram| diagram.modes.values());
        modes.map(|mode| named(&mode.symbol, CompletionItemKind::ENUM_MEMBER)).collect()
    }

    /// The modes of a diagram that run others.
    fn outer_modes(diagram: &Diagram) -> impl Iterator<Item = CompletionItem> {
        let outer = diagram.modes.values().filter(|mode| mode.runs.is_some());
        outer.map(|mode| detailed(named(&mode.symbol, CompletionItemKind::MODULE), "its modes"))
    }

    /// What stands behind the dot of a mode that runs a diagram, or of a network.
    fn members(&self, path: &[&str]) -> Vec<CompletionItem> {
        if let Some(inside) = self.inside(path) {
            return words(&["mode"]).into_iter().chain(Self::outer_modes(inside)).collect();
        }
        let ([sense], Some(id)) = (path, self.diagram()) else { return Vec::new() };
        let senses = self.program.diagrams[id].senses.iter().filter(|known| known.symbol.name == *sense);
        senses.flat_map(|sense| self.events(sense.network)).collect()
    }

    fn events(&self, network: Id<Network>) -> Vec<CompletionItem> {
        let network = &self.program.networks[network];
        let events = network.events.iter().map(|event| named(&event.symbol, CompletionItemKind::EVENT));
        events.map(|event| detailed(event, format!("event of {}", network.symbol.name))).collect()
    }

    /// Flags, events and sensors; modes where something is said of a behavior from outside.
    fn conditions(&self) -> Vec<CompletionItem> {
        let mut items = words(&["after", "done", "not"]);
        let functions = sema::FUNCTIONS.iter();
        items.extend(functions.map(|(name, takes)| {
            detailed(item(*name, CompletionItemKind::FUNCTION), format!("({})", takes.join(", ")))
        }));
        if let Some(id) = self.robot() {
            items.extend(self.program.robots[id].senses.iter().flat_map(|sense| self.events(sense.network)));
        } else if let Some(id) = self.diagram() {
            let diagram = &self.program.diagrams[id];
            items.extend(diagram.flags.values().map(|flag| named(&flag.symbol, CompletionItemKind::VARIABLE)));
            items.extend(diagram.senses.iter().flat_map(|sense| self.events(sense.network)));
            items.extend(Self::outer_modes(diagram));
        }
        items.extend(self.sensors());
        if self.place.declaration().is_none_or(|block| block.keyword == "scenario") {
            items.extend(self.modes());
        }
        items
    }

    fn in_list(&self, list: List<'_>, block: &str, first: &str) -> Vec<CompletionItem> {
        let behind_colon = self.place.back(0) == ":";
        match (first, list.head, block) {
            (_, "failed", _) => self.sensors(),
            (_, "decide", "mode") => [self.conditions(), self.sensed()].concat(),
            (_, "either", "decide") => self.actions(block),
            // The row before may end in a word.
            (_, "" | "nothing", "decide") => self.decided(&self.place.column(list.position)),
            (_, head, _) if sema::FUNCTIONS.iter().any(|(name, _)| *name == head) => self.conditions(),
            (_, "contributor" | "detractor" | "", "event") => self.cell(list.position),
            (_, "over", "network" | "event") => self.inputs(),
            ("sense", head, _) => {
                let networks = self.program.networks.values().filter(|network| network.symbol.name == head);
                let inputs = networks.flat_map(|network| &network.inputs);
                let inputs = inputs.map(|input| item(format!("{}: ", input.symbol.name), CompletionItemKind::PROPERTY));
                if behind_colon { self.sensors() } else { self.sensors().into_iter().chain(inputs).collect() }
            }
            ("network", _, _) if behind_colon => self.variables(),
            (_, _, "robot" | "interface") if behind_colon => units(),
            (_, "" | "and" | "or" | "not", "mode") => self.conditions(),
            (_, head, "mode" | "enter" | "exit" | "decide") if !behind_colon => self.parameters(head),
            (_, _, "mode") => words(&["random"]),
            (_, _, "variable" | "network") => Vec::new(),
            _ if first != "variable" => self.conditions(),
            _ => Vec::new(),
        }
    }

    /// The inputs of the networks that a behavior senses.
    fn sensed(&self) -> Vec<CompletionItem> {
        let Some(id) = self.diagram() else { return Vec::new() };
        let senses = self.program.diagrams[id].senses.iter();
        let inputs = senses.flat_map(|sense| &self.program.networks[sense.network].inputs);
        inputs.map(|input| named(&input.symbol, CompletionItemKind::PROPERTY)).collect()
    }

    /// What a cell can be in a column of a decision table: terms of what feeds a network, else `set` and `clear`.
    fn decided(&self, column: &[&str]) -> Vec<CompletionItem> {
        let (Some(id), any) = (self.diagram(), words(&["_"])) else { return Vec::new() };
        let ([name] | [_, ".", name]) = column else { return [words(&["clear", "set"]), any].concat() };
        let fed = self.program.diagrams[id].senses.iter().flat_map(|sense| {
            let inputs = self.program.networks[sense.network].inputs.iter();
            inputs.zip(sense.inputs.iter().map(|&sensor| &self.program.sensors[sensor].symbol.name))
        });
        let mut meant = fed.filter(|(input, sensor)| input.symbol.name == **name || *sensor == name);
        match meant.next() {
            Some((input, _)) => terms(&self.program.variables[input.variable].terms).chain(any).collect(),
            None => [words(&["clear", "set"]), any].concat(),
        }
    }

    /// The parameters of an action, by their names.
    fn parameters(&self, action: &str) -> Vec<CompletionItem> {
        let Some(id) = self.diagram() else { return Vec::new() };
        let actions = self.program.actions_of(self.program.diagrams[id].platform).iter();
        let actions = actions.map(|&id| &self.program.actions[id]).filter(|known| known.symbol.name == action);
        let parameters = actions.flat_map(|action| &action.parameters).map(|parameter| {
            let named = item(format!("{}: ", parameter.symbol.name), CompletionItemKind::PROPERTY);
            detailed(named, &parameter.unit.text)
        });
        parameters.chain(words(&["random"])).collect()
    }

    /// The network that is being written.
    fn network(&self) -> Option<&Network> {
        let name = self.place.declaration()?.name;
        let mut networks = self.program.networks.values();
        networks.find(|network| network.symbol.span.file == self.file && network.symbol.name == name)
    }

    fn inputs(&self) -> Vec<CompletionItem> {
        let inputs = self.network().into_iter().flat_map(|network| &network.inputs);
        inputs
            .map(|input| {
                let variable = &self.program.variables[input.variable].symbol.name;
                detailed(named(&input.symbol, CompletionItemKind::FIELD), variable)
            })
            .collect()
    }

    /// The terms of the variable that a cell of a row is about.
    fn cell(&self, position: usize) -> Vec<CompletionItem> {
        let Some(network) = self.network() else { return Vec::new() };
        let Some(input) = self.over(network, position) else { return Vec::new() };
        let variable = &self.program.variables[network.inputs[input].variable];
        let of = |item| detailed(item, format!("term of {}", variable.symbol.name));
        let any = detailed(item("_", CompletionItemKind::KEYWORD), "any term");
        terms(&variable.terms).map(of).chain([any]).collect()
    }

    /// The input that a cell is about, where the event may name only some in `over (...)`.
    fn over(&self, network: &Network, position: usize) -> Option<usize> {
        let event = self.place.block()?.name;
        let units = self.known.analysis.units.iter().filter(|unit| unit.file == self.file);
        let over = units.flat_map(|unit| &unit.tree.items).find_map(|item| {
            let crate::syntax::ast::Item::Network(tree) = item else { return None };
            tree.items.iter().find_map(|item| match item {
                crate::syntax::ast::NetworkItem::Event(tree) if tree.name.text == event => tree.over.as_ref(),
                _ => None,
            })
        });
        match over {
            Some(over) => {
                let name = over.get(position)?;
                network.inputs.iter().position(|input| input.symbol.name == name.text)
            }
            None => Some(position).filter(|position| *position < network.inputs.len()),
        }
    }

    /// A rule in words: an input, `is`, or a term of the input before it.
    fn in_words(&self, line: &[&str]) -> Vec<CompletionItem> {
        let is = line.iter().rposition(|word| ["is", "rule", "and", "or", "not", "=>"].contains(word));
        let Some(at) = is else { return Vec::new() };
        if line.get(at) != Some(&"is") {
            if at + 1 < line.len() && line.last() != Some(&"(") {
                return words(&["is"]);
            }
            if line.get(at) == Some(&"=>") || line.contains(&"=>") {
                let outputs = self.network().into_iter().flat_map(|network| &network.outputs);
                return outputs.map(|output| named(&output.symbol, CompletionItemKind::FIELD)).collect();
            }
            return [self.inputs(), words(&["not"])].concat();
        }
        let subject = at.checked_sub(1).and_then(|at| line.get(at)).copied().unwrap_or("");
        let Some(network) = self.network() else { return Vec::new() };
        let input = network.inputs.iter().find(|input| input.symbol.name == subject);
        let of_input = input.map(|input| self.program.variables[input.variable].terms.as_slice());
        let output = network.outputs.iter().find(|output| output.symbol.name == subject);
        let of_output = output.map(|output| output.terms.as_slice());
        terms(of_input.or(of_output).unwrap_or_default()).chain(words(&["any of {"])).collect()
    }

    /// Shapes, the other terms of the variable, and what makes a term of them.
    fn shapes(&self) -> Vec<CompletionItem> {
        let shapes = sema::shapes().map(|(name, form)| detailed(item(name, CompletionItemKind::FUNCTION), form));
        let own = |symbol: &Symbol| {
            symbol.span.file == self.file && self.place.declaration().is_some_and(|block| block.name == symbol.name)
        };
        let variables = self.program.variables.values().filter(|variable| own(&variable.symbol));
        let others = variables.flat_map(|variable| terms(&variable.terms));
        shapes.chain(others).chain(words(&["not", "somewhat", "very"])).collect()
    }
}
