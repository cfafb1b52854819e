//! Mode switching diagrams: what they extend, sense and name.

use std::collections::HashMap;

use super::conditions::Scene;
use super::layers::layer;
use super::modes::Owner;
use super::{Lower, claim, counted, given, missing_part, symbol};
use crate::base::{Arena, Id, Span};
use crate::diag::{self, Diagnostic};
use crate::ir;
use crate::syntax::ast;

/// What a diagram consists of once everything it extends has been taken over, in source order, the oldest first.
#[derive(Default)]
struct Parts<'a> {
    on: Option<&'a ast::Name>,
    entry: Option<(&'a ast::Name, Span)>,
    senses: Vec<&'a ast::Sense>,
    flags: Vec<&'a ast::Flag>,
    modes: Vec<&'a ast::Mode>,
}

impl Parts<'_> {
    /// The simple names in its conditions.
    fn names(&self) -> Vec<&str> {
        let mut names = Vec::new();
        self.flags.iter().for_each(|flag| collect_names(&flag.condition, &mut names));
        for item in self.modes.iter().flat_map(|mode| &mode.items) {
            match item {
                ast::ModeItem::Transition(transition) => collect_names(&transition.condition, &mut names),
                ast::ModeItem::Decide(table) => {
                    table.subjects.iter().for_each(|subject| collect_names(subject, &mut names));
                }
                ast::ModeItem::Action(_)
                | ast::ModeItem::OnEnter(..)
                | ast::ModeItem::OnExit(..)
                | ast::ModeItem::Error(_) => {}
            }
        }
        names
    }
}

/// Replaces what has the same name, and answers it, or adds.
fn put<'a, T>(
    parts: &mut Vec<&'a T>,
    places: &mut HashMap<&'a str, usize>,
    name: &'a str,
    part: &'a T,
) -> Option<&'a T> {
    if let Some(&place) = places.get(name) {
        return Some(std::mem::replace(&mut parts[place], part));
    }
    places.insert(name, parts.len());
    parts.push(part);
    None
}

pub(super) fn sense_name(sense: &ast::Sense) -> &ast::Name {
    sense.alias.as_ref().unwrap_or(&sense.network)
}

impl<'a> Lower<'a> {
    pub(super) fn diagram(&mut self, tree: &'a ast::Diagram) {
        let layer = layer(tree.layer);
        let Some(chain) = self.chain(tree, Self::find_diagram_tree) else { return };
        if let [.., base, _] = chain.as_slice()
            && base.layer != tree.layer
        {
            let name = tree.extends.as_ref().unwrap_or(&tree.name);
            let (base, own) = (base.layer.keyword(), tree.layer.keyword());
            let message = format!("`{}` is declared as {base}, and this as {own}", name.text);
            self.report(Diagnostic::new(&diag::rules::WRONG_KIND, name.span, message));
            return;
        }
        let parts = self.parts(&chain);
        let Some(on) = parts.on else {
            // What is extended lacks it too, and that was reported.
            if chain.len() > 1 {
                return;
            }
            return self.report(
                missing_part(tree.name.span, format!("nothing says what `{}` runs on", tree.name.text))
                    .help(format!("write `behavior {} on j5`, or on an interface", tree.name.text)),
            );
        };
        let Some(platform) = self.find_platform(on) else { return };
        let sensors = self.program.sensors_of(platform);
        let owner = Owner { layer, actions: self.program.actions_of(platform).to_vec() };
        let interface = match platform {
            ir::Platform::Robot(_) => None,
            ir::Platform::Interface(id) => Some(self.program.interfaces[id].symbol.name.clone()),
        };
        let (states, commands) = self.doings(platform);
        let mut scene = Scene { sensors, states, commands, interface, ..Scene::default() };
        let mut senses = self.senses(&parts.senses, &mut scene);
        self.broken_items(&chain, &mut scene);
        let runs: Vec<_> = parts.modes.iter().map(|mode| self.run(mode, layer, platform)).collect();
        let outer = parts.modes.iter().zip(&runs).zip(0..).filter(|((mode, _), _)| mode.child.is_some());
        let inner = |run: &Option<ir::Run>| run.as_ref().map(|run| run.diagram);
        scene.runs = outer.map(|((mode, run), place)| (mode.name.text.clone(), (Id::new(place), inner(run)))).collect();
        let mut contacts = Arena::default();
        self.take_in(platform, &parts.names(), &mut senses, &mut contacts);
        scene.flag_places.extend(contacts.values().map(|flag| flag.symbol.span));
        let flags = self.flags(&parts.flags, contacts, &mut scene);
        let modes: HashMap<_, _> = parts
            .modes
            .iter()
            .enumerate()
            .map(|(index, mode)| (mode.name.text.as_str(), (Id::new(index as u32), mode.name.span)))
            .collect();
        let own =
            |mode: &ast::Mode| mode.span.file == tree.span.file && tree.span.range().contains(&mode.span.range().start);
        // On a robot more is known than on the interface that the extended diagram is written on.
        let before = chain.iter().rev().skip(1).find_map(|tree| tree.on.as_ref());
        let is_elsewhere = before.is_some_and(|before| before.text != on.text);
        let lower = |(mode, run): (&&ast::Mode, Option<ir::Run>)| ir::Mode {
            inherited: !is_elsewhere && !own(mode),
            ..self.mode(mode, run, &modes, &owner, &mut scene)
        };
        let lowered: Arena<ir::Mode> = parts.modes.iter().zip(runs).map(lower).collect();
        let broken = |tree: &&'a ast::Diagram| tree.items.iter().any(|item| matches!(item, ast::DiagramItem::Error(_)));
        let incomplete = chain.iter().any(broken) || lowered.values().any(|mode| mode.incomplete);
        let mut diagram = ir::Diagram {
            symbol: symbol(&tree.name, tree.doc.as_ref()),
            layer,
            platform,
            senses,
            flags,
            modes: lowered,
            entry: None,
            arbiter: None,
            incomplete,
        };
        match parts.entry {
            Some((entry, _)) => diagram.entry = self.mode_named(entry, &modes),
            // What is extended lacks it too, and that was reported; or it is in what could not be parsed.
            None if chain.len() > 1 || chain.iter().any(broken) => {}
            None => self.report(missing_entry(tree, &parts.modes)),
        }
        let id = self.program.diagrams.add(diagram);
        if scene.incomplete {
            self.poison.diagrams.insert(id);
        }
        let meaningless = scene.flags.into_iter().filter(|(_, flag)| flag.is_none());
        self.poison.flags.insert(id, meaningless.map(|(name, _)| name).collect());
        self.scopes.diagrams.insert(tree.name.span, id);
    }

    /// Notes that what could not be parsed may have sensed a network.
    fn broken_items(&self, chain: &[&ast::Diagram], scene: &mut Scene) {
        for item in chain.iter().flat_map(|tree| &tree.items) {
            if let ast::DiagramItem::Error(span) = item {
                scene.incomplete |= !matches!(self.unparsed.first_word(*span), "mode" | "final" | "flag" | "entry");
            }
        }
    }

    fn parts(&mut self, chain: &[&'a ast::Diagram]) -> Parts<'a> {
        let mut parts = Parts::default();
        let (mut senses, mut flags, mut modes) = (HashMap::new(), HashMap::new(), HashMap::new());
        for tree in chain {
            parts.on = tree.on.as_ref().or(parts.on);
            let mut entry = None;
            let mut seen = (HashMap::new(), HashMap::new(), HashMap::new());
            for item in &tree.items {
                match item {
                    ast::DiagramItem::Entry { mode, span } => self.once(&mut entry, mode, *span, "the entry"),
                    ast::DiagramItem::Sense(sense) => {
                        let name = sense_name(sense);
                        if claim(&mut seen.0, name, "sensed network", &mut self.diagnostics) {
                            let replaced = put(&mut parts.senses, &mut senses, &name.text, sense);
                            self.replaces(name, replaced.map(sense_name));
                        }
                    }
                    ast::DiagramItem::Flag(flag) => {
                        if claim(&mut seen.1, &flag.name, "flag", &mut self.diagnostics) {
                            let replaced = put(&mut parts.flags, &mut flags, &flag.name.text, flag);
                            self.replaces(&flag.name, replaced.map(|flag| &flag.name));
                        }
                    }
                    ast::DiagramItem::Mode(mode) => {
                        if claim(&mut seen.2, &mode.name, "mode", &mut self.diagnostics) {
                            let replaced = put(&mut parts.modes, &mut modes, &mode.name.text, mode);
                            self.replaces(&mode.name, replaced.map(|mode| &mode.name));
                        }
                    }
                    ast::DiagramItem::Error(_) => {}
                }
            }
            parts.entry = entry.or(parts.entry);
        }
        parts
    }

    /// Notes that a part of a diagram stands in the place of one that is taken over.
    fn replaces(&mut self, name: &ast::Name, replaced: Option<&ast::Name>) {
        if let Some(replaced) = replaced {
            self.refers(name.span, replaced.span);
        }
    }

    pub(super) fn senses(&mut self, trees: &[&ast::Sense], scene: &mut Scene) -> Vec<ir::Sense> {
        let mut senses = Vec::new();
        for tree in trees {
            let Some(network) = self.find_network(&tree.network) else {
                scene.incomplete = true;
                continue;
            };
            let position = senses.len() as u32;
            let name = sense_name(tree);
            scene.senses.insert(name.text.clone(), position);
            scene.sense_places.push(name.span);
            scene.sense_networks.push(network);
            let declared = &self.program.networks[network];
            for (event, declared) in declared.events.iter().enumerate() {
                scene.events.entry(declared.symbol.name.clone()).or_default().push((position, event as u32));
            }
            for (output, declared) in declared.outputs.iter().enumerate() {
                scene.outputs.entry(declared.symbol.name.clone()).or_default().push((position, output as u32));
            }
            // A sense with a broken input keeps its events; the first sensor stands in until it is mended.
            let inputs = self.sense_inputs(tree, network, &scene.sensors);
            scene.unfed |= inputs.is_none();
            let inputs = inputs.unwrap_or_default();
            let sense = ir::Sense { symbol: symbol(name, None), network, inputs };
            scene.inputs.extend(self.scene_inputs(position, &sense));
            senses.push(sense);
        }
        senses
    }

    fn sense_inputs(
        &mut self,
        tree: &ast::Sense,
        network: Id<ir::Network>,
        sensors: &[Id<ir::Sensor>],
    ) -> Option<Vec<Id<ir::Sensor>>> {
        let inputs = self.program.networks[network].inputs.clone();
        let names = inputs.iter().map(|input| &input.symbol);
        let order = self.order_arguments(&tree.arguments, names, tree.network.span, "network")?;
        let mut fed = Vec::new();
        for (argument, input) in order.into_iter().zip(&inputs) {
            let sensor = match &argument.value.kind {
                ast::ExprKind::Path(path) if path.segments.len() == 1 => {
                    self.sensor_named(path.segments.first()?, sensors)
                }
                ast::ExprKind::Index(path, indices) => self.one_indexed(path, indices, argument.value.span, sensors),
                _ => {
                    self.report(super::invalid(argument.value.span, "a network is fed by sensors"));
                    None
                }
            };
            fed.push(sensor.filter(|&sensor| {
                let unit = self.program.sensors[sensor].unit.clone();
                self.check_feed(argument.value.span, input, &unit)
            }));
        }
        fed.into_iter().collect()
    }

    /// Puts arguments into the order of the parameters; reports what does not fit.
    pub(super) fn order_arguments<'t, 's>(
        &mut self,
        arguments: &'t [ast::Argument],
        parameters: impl Iterator<Item = &'s ir::Symbol>,
        span: Span,
        what: &str,
    ) -> Option<Vec<&'t ast::Argument>> {
        let symbols: Vec<_> = parameters.collect();
        let parameters: Vec<_> = symbols.iter().map(|symbol| symbol.name.as_str()).collect();
        let mut placed: Vec<Option<&ast::Argument>> = vec![None; parameters.len()];
        let mut sound = true;
        for (index, argument) in arguments.iter().enumerate() {
            let place = match &argument.name {
                None => Some(index),
                Some(name) => {
                    let place = parameters.iter().position(|parameter| *parameter == name.text);
                    if let Some(place) = place {
                        self.refers(name.span, symbols[place].span);
                    } else {
                        let known = parameters.iter().copied();
                        let place = if what == "network" { "input" } else { "parameter" };
                        self.report(self.unknown(name, &format!("{place} of this {what}"), known));
                        sound = false;
                    }
                    place
                }
            };
            let Some(place) = place else { continue };
            match placed.get_mut(place) {
                Some(slot @ None) => *slot = Some(argument),
                Some(Some(first)) => {
                    let first = first.value.span;
                    self.report(super::said_twice(argument.value.span, first, "this argument"));
                    sound = false;
                }
                // Counted below.
                None => {}
            }
        }
        let complete = sound && arguments.len() == parameters.len();
        if sound && !complete {
            let message =
                format!("this {what} takes {}, {}", counted(parameters.len(), "argument"), given(arguments.len()));
            let mut diagnostic = Diagnostic::new(&diag::rules::WRONG_ARGUMENTS, span, message);
            if !parameters.is_empty() {
                diagnostic = diagnostic.note(format!("it takes: {}", parameters.join(", ")));
            }
            self.report(diagnostic);
        }
        if complete { placed.into_iter().collect() } else { None }
    }

    /// Lowers flags, behind some that there are, so that each stands after those it uses, whatever their order in the text.
    fn flags(&mut self, trees: &[&'a ast::Flag], mut lowered: Arena<ir::Flag>, scene: &mut Scene) -> Arena<ir::Flag> {
        let places: HashMap<&str, usize> =
            trees.iter().enumerate().map(|(index, flag)| (flag.name.text.as_str(), index)).collect();
        let uses: Vec<Vec<usize>> = trees
            .iter()
            .map(|flag| {
                let mut names = Vec::new();
                collect_names(&flag.condition, &mut names);
                names.iter().filter_map(|name| places.get(name).copied()).collect()
            })
            .collect();
        let mut users: Vec<Vec<usize>> = vec![Vec::new(); trees.len()];
        for (user, used) in uses.iter().enumerate() {
            for &used in used {
                users[used].push(user);
            }
        }
        let mut waiting: Vec<usize> = uses.iter().map(Vec::len).collect();
        let mut ready: std::collections::VecDeque<usize> =
            (0..trees.len()).filter(|&flag| waiting[flag] == 0).collect();
        let mut placed = vec![false; trees.len()];
        while let Some(next) = ready.pop_front() {
            let tree = trees[next];
            let condition = self.condition(&tree.condition, scene);
            let id = lowered.add(ir::Flag { symbol: symbol(&tree.name, tree.doc.as_ref()), condition });
            scene.flags.insert(tree.name.text.clone(), Some(id));
            scene.flag_places.push(tree.name.span);
            placed[next] = true;
            for &user in &users[next] {
                waiting[user] -= 1;
                if waiting[user] == 0 {
                    ready.push_back(user);
                }
            }
        }
        for (tree, _) in trees.iter().zip(&placed).filter(|(_, placed)| !**placed) {
            scene.flags.insert(tree.name.text.clone(), None);
        }
        for circle in circles(&uses, &placed) {
            self.report(circular_flags(&circle.iter().map(|&flag| &trees[flag].name).collect::<Vec<_>>()));
        }
        lowered
    }
}

/// Flags that need each other in a circle, among those that could not be placed. Each of these uses one that could not
/// be placed either, so that a walk along them ends in a circle, or where an earlier walk has been.
fn circles(uses: &[Vec<usize>], placed: &[bool]) -> Vec<Vec<usize>> {
    const NEVER: usize = usize::MAX;
    let mut circles = Vec::new();
    // For each flag the start of the walk that came by, and how far along it was.
    let mut seen = vec![(NEVER, 0); placed.len()];
    for start in (0..placed.len()).filter(|&flag| !placed[flag]) {
        let mut path = Vec::new();
        let mut next = Some(start);
        while let Some(flag) = next {
            match seen[flag] {
                (NEVER, _) => {
                    seen[flag] = (start, path.len());
                    path.push(flag);
                    next = uses[flag].iter().copied().find(|&used| !placed[used]);
                }
                (walk, place) => {
                    if walk == start {
                        circles.push(path.split_off(place));
                    }
                    next = None;
                }
            }
        }
    }
    circles
}

fn circular_flags(names: &[&ast::Name]) -> Diagnostic {
    let list: Vec<_> = names.iter().chain(names.first()).map(|name| format!("`{}`", name.text)).collect();
    let span = names.first().map(|name| name.span).unwrap_or_default();
    let diagnostic = match names {
        [one] => Diagnostic::new(&diag::rules::CIRCULAR, span, format!("the flag `{}` needs itself", one.text)),
        _ => Diagnostic::new(&diag::rules::CIRCULAR, span, "flags need each other in a circle")
            .note(format!("the circle: {}", list.join(" needs "))),
    };
    diagnostic
        .help("a flag that looks at its own past reads it through `rising`, `held`, `latched` or `count` of another")
}

/// The simple names in a condition. Recursion is as deep as parentheses, which the parser limits.
pub(super) fn collect_names<'e>(expr: &'e ast::Expr, names: &mut Vec<&'e str>) {
    match &expr.kind {
        ast::ExprKind::Path(path) => {
            if let [name] = path.segments.as_slice() {
                names.push(&name.text);
            }
        }
        ast::ExprKind::Not(inner) | ast::ExprKind::Negate(inner) => collect_names(inner, names),
        ast::ExprKind::And(operands) | ast::ExprKind::Or(operands) => {
            for operand in operands {
                collect_names(operand, names);
            }
        }
        ast::ExprKind::Compare(_, left, right) => {
            collect_names(left, names);
            collect_names(right, names);
        }
        ast::ExprKind::Call(call) => {
            for argument in &call.arguments {
                collect_names(&argument.value, names);
            }
        }
        ast::ExprKind::Sum(terms) => terms.iter().map(|(_, term)| term).for_each(|term| collect_names(term, names)),
        ast::ExprKind::Product(of) => {
            of.iter().map(|(_, factor)| factor).for_each(|factor| collect_names(factor, names));
        }
        // What `is` looks at is a reading.
        ast::ExprKind::Is(..)
        | ast::ExprKind::Index(..)
        | ast::ExprKind::Quantity(_)
        | ast::ExprKind::After(_)
        | ast::ExprKind::Done => {}
    }
}

fn missing_entry(tree: &ast::Diagram, modes: &[&ast::Mode]) -> Diagnostic {
    let help = match modes.first() {
        Some(mode) => format!("write `entry {}`", mode.name.text),
        None => "write a `mode`, and `entry` with its name".to_owned(),
    };
    let message = format!("`{}` does not say in which mode it starts", tree.name.text);
    Diagnostic::new(&diag::rules::MISSING_ENTRY, tree.name.span, message).help(help)
}
