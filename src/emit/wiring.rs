//! What a diagram needs on every tick, what only in one of its modes, and the names of all that.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;

use proc_macro2::Ident;

use super::arbiter::{self, ClientParts};
use super::graph::{Graph, Node, part};
use super::layers::{self, Door, Role};
use super::modes::{self, ModeParts};
use super::names::{Scope, plain};
use super::network::Network;
use super::table;
use crate::plan::{Arbiter, Mode, Plan, Step, Value};

/// A diagram taken apart: what it computes on every tick because it must be remembered, and what each mode computes
/// when it is active.
pub(super) struct Wiring<'a> {
    /// The name of its module.
    pub(super) module: Ident,
    pub(super) plan: &'a Plan,
    pub(super) graph: Graph<'a>,
    /// The fields of all sensors.
    pub(super) sensors: Vec<Ident>,
    /// The fields of all logical sensors.
    pub(super) logical: BTreeMap<Node, Ident>,
    /// The sensors whose readings matter.
    pub(super) read: BTreeSet<u32>,
    /// The logical sensors whose readings matter.
    pub(super) grouped: BTreeSet<Node>,
    /// The sensors whose health matters.
    pub(super) watched: BTreeSet<u32>,
    pub(super) uses_done: bool,
    /// Whether some mode draws a random number.
    pub(super) draws: bool,
    /// The actions that are called.
    pub(super) actions: BTreeMap<u32, ActionNames>,
    pub(super) senses: Vec<Sensed<'a>>,
    /// The event that a step is the flag of: its sense, and its name there.
    pub(super) events: BTreeMap<Node, (usize, Ident)>,
    /// The output that a step is the value of: its sense, and its name there.
    pub(super) outputs: BTreeMap<Node, (usize, Ident)>,
    /// The local names of the steps that have one: named flags, and what is looked back at.
    pub(super) names: HashMap<Node, Ident>,
    /// The text of what is looked back at.
    pub(super) texts: HashMap<Node, &'a str>,
    /// What is computed on every tick.
    pub(super) always: BTreeSet<Node>,
    /// The step whose value on the tick before is kept, and where.
    pub(super) before: BTreeMap<Node, Ident>,
    /// The windows, stopwatches, latches and counters that the machine itself keeps.
    pub(super) kept: BTreeMap<Node, Ident>,
    /// The readings that the windows keep.
    pub(super) windows: BTreeMap<Node, Ident>,
    /// Whether the machine itself keeps the time in the mode.
    pub(super) keeps_time: bool,
    pub(super) modes: Vec<ModeParts>,
    /// How it is run by others.
    pub(super) role: Role,
    /// What runs inside its modes, and how that is reached.
    pub(super) inner: Vec<Rc<Wiring<'a>>>,
    pub(super) doors: Vec<Door>,
    /// Of an arbiter.
    pub(super) clients: Vec<ClientParts>,
}

/// How an action is called.
pub(super) struct ActionNames {
    pub(super) method: Ident,
    pub(super) parameters: Vec<Ident>,
}

/// A network that is sensed through, for its events or for its outputs.
pub(super) struct Sensed<'a> {
    pub(super) name: Ident,
    pub(super) network: &'a Network<'a>,
    pub(super) says: Says,
    /// The field of what the network remembers.
    pub(super) memory: Ident,
    /// What reads the sensors that feed it.
    pub(super) readings: Vec<Node>,
    /// The method of the readings that tells it; `None` where nothing of it matters.
    pub(super) method: Option<Ident>,
}

/// What a network is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Says {
    Events,
    Outputs,
}

impl Sensed<'_> {
    /// Whether what it says depends on more than the readings of one tick.
    pub(super) fn remembers(&self) -> bool {
        match self.says {
            Says::Events => self.network.events_remember(),
            Says::Outputs => self.network.holds(),
        }
    }
}

/// The names that every tick uses; what the user calls so has another name there.
const OURS: [&str; 7] = ["inputs", "dt_ns", "dt", "robot", "elapsed", "state", "random"];

impl<'a> Wiring<'a> {
    pub(super) fn new(
        plan: &'a Plan,
        (module, role): (Ident, Role),
        networks: &HashMap<u32, &'a Network<'a>>,
        inner: Vec<Rc<Self>>,
    ) -> Self {
        let mut graph = Graph::new(&plan.code);
        let mut fields = Scope::new(&["failed", "done"]);
        let ours = plan.arbiter.iter().flat_map(|_| arbiter::OURS);
        let mut locals = Scope::new(&OURS.into_iter().chain(ours).collect::<Vec<_>>());
        let clients = arbiter::clients(plan, &inner, &mut locals);
        let sensors = plan.inputs.iter().map(|input| fields.snake(&input.name)).collect();
        let doors = layers::doors(&inner, &mut fields);
        let required = plan.required.iter().copied();
        let mut wiring = Self {
            module,
            role,
            sensors,
            doors,
            senses: Vec::new(),
            events: BTreeMap::new(),
            outputs: BTreeMap::new(),
            names: HashMap::new(),
            texts: HashMap::new(),
            logical: BTreeMap::new(),
            read: inner.iter().flat_map(|inner| inner.read.iter().copied()).collect(),
            clients,
            grouped: BTreeSet::new(),
            watched: inner.iter().flat_map(|inner| inner.watched.iter().copied()).chain(required).collect(),
            uses_done: inner.iter().any(|inner| inner.uses_done),
            draws: plan.is_random(),
            actions: actions(plan, &inner),
            always: BTreeSet::new(),
            before: BTreeMap::new(),
            kept: BTreeMap::new(),
            windows: BTreeMap::new(),
            keeps_time: false,
            modes: Vec::new(),
            graph: Graph::new(&plan.code),
            inner,
            plan,
        };
        for logical in &plan.logical {
            if let Value::Number(value) = logical.value {
                wiring.logical.extend(graph.real(value).map(|node| (node, fields.snake(&logical.name))));
            }
        }
        for sense in &plan.senses {
            let Some(network) = networks.get(&sense.network) else { continue };
            let readings: Vec<_> = sense.readings.iter().filter_map(|&real| graph.real(real)).collect();
            let memory = locals.snake(&sense.name);
            let mut name = Some(memory.clone());
            if network.has_events() {
                for (event, name) in part(&plan.events, &sense.events).iter().zip(&network.events) {
                    if let Some(node) = graph.bool(event.flag) {
                        graph.compute_from(node, readings.clone());
                        wiring.events.insert(node, (wiring.senses.len(), name.clone()));
                    }
                }
                let (name, memory, readings) =
                    (name.take().unwrap_or(memory.clone()), memory.clone(), readings.clone());
                let says = Says::Events;
                wiring.senses.push(Sensed { name, network, says, memory, readings, method: None });
            }
            if network.has_outputs() {
                for (output, name) in part(&plan.outputs, &sense.outputs).iter().zip(&network.outputs) {
                    if let Some(node) = graph.real(output.value) {
                        graph.compute_from(node, readings.clone());
                        wiring.outputs.insert(node, (wiring.senses.len(), name.clone()));
                    }
                }
                let name = name.unwrap_or_else(|| locals.snake(&format!("{}_outputs", sense.name)));
                let says = Says::Outputs;
                wiring.senses.push(Sensed { name, network, says, memory, readings, method: None });
            }
        }
        wiring.graph = graph;
        let live = wiring.live();
        let said = wiring.events.iter().chain(&wiring.outputs);
        for (_, (sense, _)) in said.filter(|(node, _)| live.contains(node)) {
            let sense = &mut wiring.senses[*sense];
            if sense.method.is_none() {
                sense.method = Some(fields.snake(&plain(&sense.name)));
            }
        }
        wiring.look_at(&live, &mut locals);
        let always = wiring.remembering(&live).into_iter().chain(wiring.arbitrated());
        wiring.always = wiring.graph.needed(always, &BTreeSet::new());
        wiring.keep(&live, &mut locals);
        wiring.modes = modes::all(&wiring, &mut locals);
        wiring
    }

    /// The method of the inputs that reads a sensor, logical or not.
    pub(super) fn reading(&self, node: Node) -> Option<&Ident> {
        match self.graph.code.steps[node] {
            Step::Read { input, .. } => self.sensors.get(input as usize),
            _ => self.logical.get(&node).filter(|_| !self.is_averaged(node)),
        }
    }

    /// Whether a step is a logical sensor that looks at more than the readings of one tick.
    pub(super) fn is_averaged(&self, node: Node) -> bool {
        let is_window = |node: &Node| matches!(self.graph.code.steps[*node], Step::Average { .. });
        match self.graph.code.steps[node] {
            Step::Group { .. } => self.graph.operands(node).iter().any(is_window),
            _ => is_window(&node),
        }
    }

    /// The local name of such a sensor.
    pub(super) fn averaged(&self, node: Node) -> Option<&Ident> {
        self.names.get(&node).or_else(|| self.kept.get(&node)).filter(|_| self.is_averaged(node))
    }

    /// The local names of what feeds a network and looks at more than the readings of one tick, each once.
    pub(super) fn averages(&self, sense: &Sensed<'_>) -> Vec<&Ident> {
        let nodes: BTreeSet<_> = sense.readings.iter().copied().collect();
        nodes.into_iter().filter_map(|node| self.averaged(node)).collect()
    }

    /// What the conditions of some transitions need.
    pub(super) fn conditions(&self, transitions: &std::ops::Range<u32>) -> BTreeSet<Node> {
        let transitions = part(&self.plan.transitions, transitions).iter();
        let conditions = transitions.filter_map(|way| self.graph.bool(way.condition));
        self.graph.needed(conditions, &BTreeSet::new())
    }

    /// What the decision tables need that are looked at in a mode: its own, and those of the modes it leads to, whose
    /// conditions are those of the tick that leaves it.
    pub(super) fn decisions(&self, mode: &Mode) -> BTreeSet<Node> {
        let targets = part(&self.plan.transitions, &mode.transitions).iter().map(|way| way.target);
        let targets = targets.chain(mode.otherwise).map(|target| &self.plan.modes[target as usize]);
        let tables = targets.chain([mode]).flat_map(|mode| table::conditions(self, mode));
        self.graph.needed(tables, &BTreeSet::new())
    }

    /// What an arbiter asks on every tick.
    fn arbitrated(&self) -> impl Iterator<Item = Node> {
        let conditions = self.plan.arbiter.iter().flat_map(Arbiter::conditions);
        conditions.filter_map(|condition| self.graph.bool(condition))
    }

    fn live(&self) -> BTreeSet<Node> {
        let arbitrated = self.graph.needed(self.arbitrated(), &BTreeSet::new());
        let conditions = &self.conditions(&(0..self.plan.transitions.len() as u32)) | &arbitrated;
        let entered = self.entered();
        let commands = self.plan.modes.iter().zip(0..).flat_map(|(mode, position)| {
            let is_left = !mode.transitions.is_empty() || mode.otherwise.is_some();
            let entering = entered.contains(&position).then_some(&mode.on_enter);
            [Some(&mode.actions), entering, is_left.then_some(&mode.on_exit)].into_iter().flatten()
        });
        let emergencies = self.plan.arbiter.iter().flat_map(|arbiter| &arbiter.emergencies);
        let emergencies = emergencies.flat_map(|emergency| self.given(&(emergency.call..emergency.call + 1)));
        let given: BTreeSet<Node> = commands.flat_map(|calls| self.given(calls)).chain(emergencies).collect();
        let rows = self.plan.modes.iter().flat_map(|mode| table::rows(self.plan, mode));
        let decided = rows.flat_map(|row| self.given(&row.calls).into_iter().chain(self.graph.bool(row.condition)));
        let others = self.graph.needed(given.into_iter().chain(decided), &BTreeSet::new());
        conditions.union(&others).copied().collect()
    }

    /// The modes that something leads to.
    pub(super) fn entered(&self) -> BTreeSet<u32> {
        let targets = self.plan.transitions.iter().map(|way| way.target);
        targets.chain(self.plan.modes.iter().filter_map(|mode| mode.otherwise)).chain([self.plan.entry]).collect()
    }

    /// The outputs and readings that some commands are given.
    pub(super) fn given(&self, calls: &std::ops::Range<u32>) -> BTreeSet<Node> {
        let arguments =
            part(&self.plan.calls, calls).iter().flat_map(|call| part(&self.plan.arguments, &call.arguments));
        let nodes = arguments.filter_map(|&real| self.graph.real(real));
        let is_given =
            |node: &Node| self.outputs.contains_key(node) || self.reading(*node).is_some() || self.is_averaged(*node);
        nodes.filter(is_given).collect()
    }

    /// What an output or a reading that a command is given is called.
    pub(super) fn given_name(&self, node: Node) -> String {
        let name = self.outputs.get(&node).map(|(_, name)| name);
        let name = name.or_else(|| self.reading(node)).or_else(|| self.averaged(node));
        name.map(plain).unwrap_or_default()
    }

    /// What a step is said by, if by a network: its sense, and its name there.
    pub(super) fn said(&self, node: Node) -> Option<(&Sensed<'a>, &Ident)> {
        let (sense, name) = self.events.get(&node).or_else(|| self.outputs.get(&node))?;
        Some((self.senses.get(*sense)?, name))
    }

    /// Notes what the live steps ask of the inputs, and names those that are computed once.
    fn look_at(&mut self, live: &BTreeSet<Node>, locals: &mut Scope) {
        for &node in live {
            match self.graph.code.steps[node] {
                Step::Read { input, .. } => {
                    self.read.insert(input);
                    self.watched.insert(input);
                }
                Step::Failed { input, .. } => {
                    self.watched.insert(input);
                }
                Step::Group { .. } if self.is_averaged(node) => {
                    let name = self.logical.get(&node).map(plain).unwrap_or_default();
                    self.names.insert(node, locals.snake(&name));
                }
                Step::Group { .. } => {
                    self.grouped.insert(node);
                }
                // Of what runs inside a mode the machine itself knows whether it has come to its end.
                Step::Done { .. } => self.uses_done |= self.inner.is_empty(),
                Step::InMode { .. } => {
                    self.names.insert(node, locals.snake("in_mode"));
                }
                _ => {}
            }
        }
        let remembered = self.plan.remembered.iter();
        self.texts = remembered.filter_map(|(of, text)| Some((self.graph.bool(*of)?, text.as_str()))).collect();
        let flags = self.plan.flags.iter().map(|flag| (flag.value, flag.name.as_str()));
        let remembered = self.plan.remembered.iter().map(|(of, _)| (*of, "condition"));
        for (bool, name) in flags.chain(remembered) {
            if let Some(node) = self.graph.bool(bool).filter(|node| live.contains(node))
                && !self.names.contains_key(&node)
                && !self.events.contains_key(&node)
            {
                self.names.insert(node, locals.snake(name));
            }
        }
    }

    /// What must be computed on every tick, whichever mode is active, to be right on a later one.
    fn remembering(&self, live: &BTreeSet<Node>) -> Vec<Node> {
        let remembers = |&node: &Node| match self.said(node) {
            Some((sense, _)) => sense.remembers().then_some(node),
            None => match self.graph.code.steps[node] {
                Step::Average { .. }
                | Step::Rising { .. }
                | Step::Falling { .. }
                | Step::Lasts { .. }
                | Step::InMode { .. } => Some(node),
                Step::Count { of, .. } => self.graph.bool(of),
                _ => None,
            },
        };
        live.iter().filter_map(remembers).collect()
    }

    /// Names what is kept from one tick to the next, beside what a mode keeps.
    fn keep(&mut self, live: &BTreeSet<Node>, locals: &mut Scope) {
        for &node in live {
            if self.said(node).is_some() {
                continue;
            }
            let name = self.operand_name(node);
            let always = self.always.contains(&node);
            match self.graph.code.steps[node] {
                Step::Rising { of, .. } | Step::Falling { of, .. } | Step::Count { of, .. } => {
                    let of = self.graph.bool(of).unwrap_or(node);
                    self.before.entry(of).or_insert_with(|| locals.snake(&format!("{name}_before")));
                }
                Step::After { .. } => self.keeps_time |= always,
                Step::Average { .. } => {
                    self.windows.insert(node, locals.snake(&format!("{name}_readings")));
                }
                _ => {}
            }
            if let Some(name) = self.kept_name(node).filter(|_| always) {
                self.kept.insert(node, locals.snake(&name));
            }
        }
    }

    /// What a window, a stopwatch, a latch or a counter is called.
    pub(super) fn kept_name(&self, node: Node) -> Option<String> {
        let what = match self.graph.code.steps[node] {
            Step::Average { .. } => "mean",
            Step::Lasts { .. } => "held",
            Step::Latched { .. } => "latched",
            Step::Count { .. } => "count",
            _ => return None,
        };
        Some(format!("{}_{what}", self.operand_name(node)))
    }

    /// What the first operand of a step is called in names made from it.
    fn operand_name(&self, node: Node) -> String {
        let of = self.graph.operands(node).first().copied();
        let event = |of: &Node| self.events.get(of).map(|(_, name)| name);
        let name = of.and_then(|of| self.names.get(&of).or_else(|| event(&of)).or_else(|| self.reading(of)));
        name.map_or_else(|| "condition".to_owned(), plain)
    }
}

fn actions(plan: &Plan, inner: &[Rc<Wiring<'_>>]) -> BTreeMap<u32, ActionNames> {
    let of_inner = inner.iter().flat_map(|inner| inner.actions.keys().copied());
    let used: BTreeSet<u32> = plan.calls.iter().map(|call| call.action).chain(of_inner).collect();
    let mut methods = Scope::new(&[]);
    let names = used.into_iter().filter_map(|action| {
        let declared = plan.actions.get(action as usize)?;
        let mut scope = Scope::new(&["start"]);
        let parameters = declared.parameters.iter().map(|(name, _)| scope.snake(name)).collect();
        Some((action, ActionNames { method: methods.snake(&declared.name), parameters }))
    });
    names.collect()
}
