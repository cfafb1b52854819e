//! The plan of a diagram on a robot.

use std::collections::HashSet;
use std::ops::Range;

use super::builder::{Builder, EventSlots, Names, reachable};
use super::{
    Action, Arbiter, Bool, Call, Checked, Client, Draw, Emergency, Event, Evidence, Flag, Input, Logical, Mode, Origin,
    Output, Part, Plan, Real, Row, Run, Sense, Transition, Value, input, origin,
};
use crate::base::Id;
use crate::ir;

/// The plan of a scenario: its diagram on its robot, watching the conditions of its expectations in order.
pub fn build_scenario(checked: Checked<'_>, scenario: &ir::Scenario) -> Plan {
    let watched: Vec<_> = scenario
        .expectations
        .iter()
        .flat_map(|expectation| match expectation.kind {
            ir::ExpectationKind::Within(condition, _)
            | ir::ExpectationKind::Never(condition, _)
            | ir::ExpectationKind::Always(condition, _) => vec![condition],
            ir::ExpectationKind::Claim(claim) => claim.conditions(),
            ir::ExpectationKind::Modes(_) | ir::ExpectationKind::Transition { .. } => Vec::new(),
        })
        .collect();
    let drive = checked.program.robots[scenario.robot].drive.as_ref().and_then(|drive| drive.diagram);
    let drive = drive.map(|drive| Box::new(build(checked, drive, scenario.robot, &[])));
    Plan { drive, ..build(checked, scenario.diagram, scenario.robot, &watched) }
}

/// The plan of a diagram on what it is written on, watching some conditions: a robot, or one that has what the interface
/// promises and nothing else. Linear in their size.
pub fn build_alone(checked: Checked<'_>, diagram: Id<ir::Diagram>, watched: &[Id<ir::Expr>]) -> Plan {
    build_on(checked, diagram, checked.program.diagrams[diagram].platform, watched)
}

/// The plan of a diagram on a robot that it is written for, watching some conditions. Linear in their size.
pub fn build(checked: Checked<'_>, diagram: Id<ir::Diagram>, robot: Id<ir::Robot>, watched: &[Id<ir::Expr>]) -> Plan {
    build_on(checked, diagram, ir::Platform::Robot(robot), watched)
}

/// The same on a robot, or on the interface it is written on: then the sensors are as the interface promises them.
pub fn build_on(checked: Checked<'_>, diagram: Id<ir::Diagram>, on: ir::Platform, watched: &[Id<ir::Expr>]) -> Plan {
    let program = checked.program;
    let position = diagram.index() as u32;
    let diagram = &program.diagrams[diagram];
    let logical = logical(program, diagram, on, watched);
    let platform = Platform::new(program, on, &logical);
    let mut builder = Builder::new(program);
    let groups = platform.logical.iter().map_while(|&sensor| platform.lower_group(sensor, &mut builder));
    let mut logical: Vec<_> = groups.collect();

    let (mut senses, mut events, mut strengths) = (Vec::new(), Vec::new(), Vec::new());
    let (mut event_flags, mut outputs): (Vec<Vec<Bool>>, Vec<Output>) = (Vec::new(), Vec::new());
    let mut output_values: Vec<Vec<Real>> = Vec::new();
    for sense in diagram.senses.iter().chain(platform.senses) {
        let readings = sense.inputs.iter().map(|&sensor| builder.sensor(sensor, platform, &logical));
        let readings: Vec<Real> = readings.collect();
        let slots = builder.events(sense.network, &readings);
        event_flags.push(slots.iter().map(|slots| slots.flag).collect());
        let declared = &program.networks[sense.network].events;
        let first = events.len() as u32;
        for (event, slots) in declared.iter().zip(slots) {
            let EventSlots { contributor, detractor, flag, strengths: of_rules } = slots;
            let name = format!("{}.{}", sense.symbol.name, event.symbol.name);
            events.push(Event { name, origin: origin(&event.symbol), contributor, detractor, flag });
            strengths.push(of_rules);
        }
        let computed = builder.outputs(sense.network, &readings);
        output_values.push(computed.iter().map(|output| output.value).collect());
        let first_output = outputs.len() as u32;
        outputs.extend(computed.into_iter().map(|output| {
            let name = format!("{}.{}", sense.symbol.name, output.name);
            Output { name, ..output }
        }));
        senses.push(Sense {
            name: sense.symbol.name.clone(),
            network: sense.network.index() as u32,
            readings,
            events: first..events.len() as u32,
            outputs: first_output..outputs.len() as u32,
        });
    }
    let of_robot = &event_flags[diagram.senses.len()..];
    for &contact in &platform.logical[logical.len()..] {
        let names = Names { platform, logical: &logical, events: of_robot, outputs: &[], flags: &[] };
        let contact = platform.lower_contact(contact, &mut builder, &names);
        logical.extend(contact);
    }
    let mut flags: Vec<Bool> = Vec::new();
    for flag in diagram.flags.values() {
        let names = Names { platform, logical: &logical, events: &event_flags, outputs: &output_values, flags: &flags };
        let value = builder.expr(flag.condition, &names);
        flags.push(value);
    }
    let names = Names { platform, logical: &logical, events: &event_flags, outputs: &output_values, flags: &flags };
    // What commands are given is read on every tick.
    for call in diagram.modes.values().flat_map(ir::Mode::commands) {
        for argument in &call.arguments {
            if let ir::Argument::Reading(sensor) = argument {
                builder.sensor(*sensor, platform, &logical);
            }
        }
    }
    // What remembers must run on every tick, whichever mode is active.
    let of_flags = diagram.flags.values().map(|flag| flag.condition);
    let of_modes = diagram.modes.values().flat_map(|mode| &mode.transitions).map(|transition| transition.condition);
    let mut remembered: Vec<(Bool, String)> = Vec::new();
    for id in of_flags.chain(of_modes).flat_map(|condition| reachable(program, condition)) {
        if let Some(operand) = remembers(&program.exprs[id].op) {
            builder.expr(id, &names);
            let operand = (builder.expr(operand, &names), checked.on_one_line(program.exprs[operand].span));
            if remembered.iter().all(|(known, _)| *known != operand.0) {
                remembered.push(operand);
            }
        }
    }
    let fuse = 0..builder.position();

    let mut parts = Parts::new(platform, checked, diagram);
    let arbiter = diagram.arbiter.as_ref().map(|arbiter| parts.arbiter(arbiter, on, &mut builder, &names));
    let fuse = if arbiter.is_some() { 0..builder.position() } else { fuse };
    let modes = diagram.modes.iter().map(|(id, mode)| parts.mode(id, mode, &mut builder, &names)).collect();

    let runs = diagram.modes.values().filter_map(|mode| mode.runs);
    let inner = distinct(runs.map(|run| run.diagram)).into_iter().map(|inner| build_on(checked, inner, on, &[]));
    let inner = inner.collect();

    builder.begin_watch();
    let start = builder.position();
    let watched = watched.iter().map(|&condition| builder.expr(condition, &names)).collect();
    let watch = start..builder.position();
    let constants = builder.finish();
    Plan {
        position,
        name: diagram.symbol.name.clone(),
        origin: origin(&diagram.symbol),
        robot: platform.name.to_owned(),
        inputs: platform.inputs(diagram),
        logical,
        actions: platform.actions.iter().map(|&action| platform.lower_action(&program.actions[action])).collect(),
        code: builder.code,
        fuse,
        watch,
        senses,
        events,
        strengths,
        outputs,
        flags: diagram
            .flags
            .values()
            .zip(&flags)
            .map(|(flag, &value)| Flag { name: flag.symbol.name.clone(), origin: origin(&flag.symbol), value })
            .collect(),
        remembered,
        watched,
        modes,
        transitions: parts.transitions,
        rows: parts.rows,
        calls: parts.calls,
        arguments: parts.arguments,
        draws: parts.draws,
        required: parts.required,
        constants,
        entry: diagram.entry.map_or(0, |entry| entry.index() as u32),
        inner,
        arbiter,
        drive: None,
    }
}

/// The diagrams that run inside the modes of one, each once.
fn distinct(diagrams: impl Iterator<Item = Id<ir::Diagram>>) -> Vec<Id<ir::Diagram>> {
    let mut known = Vec::new();
    for diagram in diagrams {
        if !known.contains(&diagram) {
            known.push(diagram);
        }
    }
    known
}

/// What an operation with a memory of its own looks back at.
fn remembers(op: &ir::Op) -> Option<Id<ir::Expr>> {
    match *op {
        ir::Op::Rising(of) | ir::Op::Falling(of) | ir::Op::Held(of, _) | ir::Op::Latched(of) | ir::Op::Count(of) => {
            Some(of)
        }
        _ => None,
    }
}

/// Where the reading of a sensor comes from.
pub(super) enum Feed {
    /// An input of the plan.
    Input(u32),
    /// A logical sensor of the plan.
    Logical(u32),
}

/// What a diagram runs on. What the diagram names on an interface is found on a robot by name; a checked robot has it.
#[derive(Clone, Copy)]
pub(super) struct Platform<'a> {
    program: &'a ir::Program,
    name: &'a str,
    sensors: &'a [Id<ir::Sensor>],
    /// Its logical sensors, contacts that follow from conditions last.
    logical: &'a [Id<ir::Sensor>],
    /// The networks that these contacts look at.
    senses: &'a [ir::Sense],
    actions: &'a [Id<ir::Action>],
    /// The interfaces a robot keeps; their doc comments stand in for those that the robot does not repeat.
    provides: &'a [Id<ir::Interface>],
}

impl<'a> Platform<'a> {
    fn new(program: &'a ir::Program, platform: ir::Platform, logical: &'a [Id<ir::Sensor>]) -> Self {
        match platform {
            ir::Platform::Robot(robot) => {
                let ir::Robot { symbol, provides, sensors, senses, actions, .. } = &program.robots[robot];
                let has_contacts = logical.last().is_some_and(|last| program.sensors[*last].kept.is_some());
                let senses = if has_contacts { senses.as_slice() } else { &[] };
                Self { program, name: &symbol.name, sensors, logical, senses, actions, provides }
            }
            ir::Platform::Interface(interface) => {
                let ir::Interface { symbol, sensors, actions, .. } = &program.interfaces[interface];
                Self { program, name: &symbol.name, sensors, logical, senses: &[], actions, provides: &[] }
            }
        }
    }

    pub(super) fn feed(&self, sensor: Id<ir::Sensor>) -> Feed {
        let name = &self.program.sensors[sensor].symbol.name;
        let is_it = |&own: &Id<ir::Sensor>| own == sensor || self.program.sensors[own].symbol.name == *name;
        match self.logical.iter().position(is_it) {
            Some(place) => Feed::Logical(place as u32),
            None => Feed::Input(self.sensors.iter().position(is_it).unwrap_or_default() as u32),
        }
    }

    /// The inputs that a sensor reads.
    fn inputs_of(&self, sensor: Id<ir::Sensor>) -> Vec<u32> {
        match self.feed(sensor) {
            Feed::Input(input) => vec![input],
            Feed::Logical(place) => {
                let members = self.program.members(self.logical[place as usize]);
                members.into_iter().flat_map(|member| self.inputs_of(member)).collect()
            }
        }
    }

    fn lower_group(&self, sensor: Id<ir::Sensor>, builder: &mut Builder<'_>) -> Option<Logical> {
        let how = self.program.sensors[sensor].group.as_ref()?.how;
        let of = self.inputs_of(sensor);
        let readings = self.program.sensors[sensor].group.iter().flat_map(|group| group.of.iter().zip(&group.readings));
        let members = readings.zip(&of);
        let members = members
            .map(|((&member, &count), &input)| builder.average(input, count, self.program.sensors[member].period));
        let members: Vec<_> = members.collect();
        let value = Value::Number(builder.group(how, &members));
        Some(self.lower_logical(sensor, of, value))
    }

    fn lower_contact(&self, sensor: Id<ir::Sensor>, builder: &mut Builder<'_>, names: &Names<'_>) -> Option<Logical> {
        let condition = self.program.sensors[sensor].kept.as_ref()?.condition;
        let value = Value::Truth(builder.expr(condition, names));
        Some(self.lower_logical(sensor, self.inputs_of(sensor), value))
    }

    fn lower_logical(&self, sensor: Id<ir::Sensor>, of: Vec<u32>, value: Value) -> Logical {
        let ir::Sensor { symbol, unit, .. } = &self.program.sensors[sensor];
        Logical { name: symbol.name.clone(), origin: origin(symbol), unit: unit.clone(), of, value }
    }

    fn action(&self, action: Id<ir::Action>) -> u32 {
        let name = &self.program.actions[action].symbol.name;
        let place = |&own: &Id<ir::Action>| own == action || self.program.actions[own].symbol.name == *name;
        self.actions.iter().position(place).unwrap_or_default() as u32
    }

    fn lower_action(&self, action: &ir::Action) -> Action {
        let promised = self.provides.iter().flat_map(|&interface| &self.program.interfaces[interface].actions);
        let promised = promised.map(|&action| &self.program.actions[action].symbol);
        let parameters = action.parameters.iter();
        Action {
            name: action.symbol.name.clone(),
            origin: documented(&action.symbol, promised),
            parameters: parameters.map(|parameter| (parameter.symbol.name.clone(), parameter.unit.clone())).collect(),
            reports_done: action.reports_done,
        }
    }

    /// The sensors; one that does not say how it fails takes the word of a variable it feeds, by itself or in a group.
    fn inputs(&self, diagram: &ir::Diagram) -> Vec<Input> {
        let fed = diagram.senses.iter().chain(self.senses).flat_map(|sense| {
            let inputs = sense.inputs.iter().zip(&self.program.networks[sense.network].inputs);
            inputs.map(|(&fed, input)| (self.inputs_of(fed), self.program.variables[input.variable].fails.as_slice()))
        });
        let fed: Vec<_> = fed.collect();
        let feeds = |place: u32| fed.iter().filter(move |(places, _)| places.contains(&place)).map(|(_, fails)| *fails);
        let promised = self.provides.iter().flat_map(|&interface| &self.program.interfaces[interface].sensors);
        let promised = promised.map(|&sensor| &self.program.sensors[sensor].symbol);
        let sensors = self.sensors.iter().map(|&id| &self.program.sensors[id]);
        sensors
            .zip(0..)
            .map(|(sensor, place)| {
                let fails: Vec<_> = std::iter::once(sensor.fails.as_slice()).chain(feeds(place)).collect();
                let input = input(&sensor.symbol, &sensor.unit, sensor.range, &fails);
                Input { origin: documented(&sensor.symbol, promised.clone()), ..input }
            })
            .collect()
    }
}

/// The logical sensors of what a diagram runs on: groups, then of the contacts that follow from conditions those that the
/// diagram or what is watched asks for. What is written on the robot has taken in their conditions, and asks for none.
fn logical(
    program: &ir::Program,
    diagram: &ir::Diagram,
    on: ir::Platform,
    watched: &[Id<ir::Expr>],
) -> Vec<Id<ir::Sensor>> {
    let ir::Platform::Robot(robot) = on else { return Vec::new() };
    let name = |sensor: Id<ir::Sensor>| program.sensors[sensor].symbol.name.as_str();
    let sensor = |id: Id<ir::Expr>| match program.exprs[id].op {
        ir::Op::Sensor(sensor) | ir::Op::Failed(sensor) => Some(name(sensor)),
        _ => None,
    };
    let conditions = diagram.conditions().chain(watched.iter().copied());
    let required = diagram.modes.values().flat_map(|mode| &mode.requires).map(|(sensor, _)| name(*sensor));
    let asked = conditions.flat_map(|condition| reachable(program, condition)).filter_map(sensor);
    let asked: HashSet<&str> = asked.chain(required).collect();
    let all = program.robots[robot].logical.iter().copied();
    all.filter(|&sensor| program.sensors[sensor].group.is_some() || asked.contains(name(sensor))).collect()
}

/// Where something stands, with the doc comment of what promised it where it has none of its own.
fn documented<'a>(symbol: &ir::Symbol, mut promised: impl Iterator<Item = &'a ir::Symbol>) -> Origin {
    let mut origin = origin(symbol);
    if origin.doc.is_empty()
        && let Some(promised) = promised.find(|promised| promised.name == symbol.name)
    {
        origin.doc.clone_from(&promised.doc);
    }
    origin
}

/// The lists of a plan that its modes share.
struct Parts<'a> {
    platform: Platform<'a>,
    checked: Checked<'a>,
    diagram: &'a ir::Diagram,
    transitions: Vec<Transition>,
    rows: Vec<Row>,
    calls: Vec<Call>,
    arguments: Vec<Real>,
    draws: Vec<Draw>,
    required: Vec<u32>,
}

impl<'a> Parts<'a> {
    fn new(platform: Platform<'a>, checked: Checked<'a>, diagram: &'a ir::Diagram) -> Self {
        Self {
            platform,
            checked,
            diagram,
            transitions: Vec::new(),
            rows: Vec::new(),
            calls: Vec::new(),
            arguments: Vec::new(),
            draws: Vec::new(),
            required: Vec::new(),
        }
    }

    fn arbiter(
        &mut self,
        arbiter: &ir::Arbiter,
        on: ir::Platform,
        builder: &mut Builder<'_>,
        names: &Names<'_>,
    ) -> Arbiter {
        let emergency = |emergency: &ir::Emergency| {
            let condition = builder.expr(emergency.condition, names);
            let text = self.checked.on_one_line(self.platform.program.exprs[emergency.condition].span);
            let call = self.calls(std::slice::from_ref(&emergency.command), builder, names).start;
            Emergency { condition, text, call }
        };
        let emergencies = arbiter.emergencies.iter().map(emergency).collect();
        let client = |client: &ir::Client| Client {
            name: client.symbol.name.clone(),
            plan: Box::new(build_on(self.checked, client.diagram, on, &[])),
            priorities: client
                .priorities
                .iter()
                .map(|&(level, when)| (level, when.map(|when| builder.expr(when, names))))
                .collect(),
        };
        let clients = arbiter.clients.iter().map(client).collect();
        let fed = |source: ir::SensorSource| {
            let is_it = |id: &Id<ir::Sensor>| self.platform.program.sensors[*id].source == Some(source);
            Some(self.platform.sensors.iter().position(is_it)? as u32)
        };
        let (won, lost) = (fed(ir::SensorSource::Won), fed(ir::SensorSource::Lost));
        Arbiter { emergencies, clients, ties: arbiter.ties.unwrap_or(ir::Ties::InOrder), won, lost }
    }

    fn mode(&mut self, id: Id<ir::Mode>, mode: &ir::Mode, builder: &mut Builder<'_>, names: &Names<'_>) -> Mode {
        let draws = self.draws.len() as u32;
        let on_enter = self.calls(&mode.on_enter, builder, names);
        // A table of one row gives its command whatever happens.
        let (always, table) = match mode.decision.as_ref().map(|table| table.rows.as_slice()) {
            Some([row]) if row.commands.len() < 2 => (row.commands.as_slice(), [].as_slice()),
            rows => ([].as_slice(), rows.unwrap_or_default()),
        };
        let actions = self.calls(&[&mode.actions, always].concat(), builder, names);
        let on_exit = self.calls(&mode.on_exit, builder, names);
        let draws = draws..self.draws.len() as u32;
        let rows = self.rows(table, builder, names);
        let required = self.required.len() as u32;
        self.required.extend(mode.requires.iter().flat_map(|&(sensor, _)| self.platform.inputs_of(sensor)));
        let transitions = self.transitions.len() as u32;
        for transition in &mode.transitions {
            let transition = self.transition(id, transition, builder, names);
            self.transitions.push(transition);
        }
        Mode {
            name: mode.symbol.name.clone(),
            origin: origin(&mode.symbol),
            is_final: mode.is_final,
            runs: mode.runs.map(|run| Run { inner: self.inner(run.diagram), resumes: run.resumes }),
            transitions: transitions..self.transitions.len() as u32,
            actions,
            rows,
            on_enter,
            on_exit,
            draws,
            required: required..self.required.len() as u32,
            otherwise: mode.otherwise.map(|mode| mode.index() as u32),
        }
    }

    /// The place of a diagram among those that run inside.
    fn inner(&self, diagram: Id<ir::Diagram>) -> u32 {
        let runs = self.diagram.modes.values().filter_map(|mode| mode.runs);
        let place = distinct(runs.map(|run| run.diagram)).iter().position(|inner| *inner == diagram);
        place.unwrap_or_default() as u32
    }

    fn rows(&mut self, rows: &[ir::DecisionRow], builder: &mut Builder<'_>, names: &Names<'_>) -> Range<u32> {
        let first = self.rows.len() as u32;
        for row in rows {
            builder.begin_part();
            let start = builder.position();
            let condition = builder.expr(row.condition, names);
            let steps = start..builder.position();
            let draws = self.draws.len() as u32;
            let several = row.commands.len() as f64;
            let pick = (row.commands.len() > 1).then(|| builder.new_real());
            self.draws.extend(pick.map(|to| Draw { low: 0.0, high: several, to }));
            let calls = self.calls(&row.commands, builder, names);
            let draws = draws..self.draws.len() as u32;
            self.rows.push(Row { steps, condition, calls, pick, draws, span: row.span });
        }
        first..self.rows.len() as u32
    }

    fn calls(&mut self, calls: &[ir::Call], builder: &mut Builder<'_>, names: &Names<'_>) -> Range<u32> {
        let start = self.calls.len() as u32;
        for call in calls {
            let first = self.arguments.len() as u32;
            for argument in &call.arguments {
                let real = match argument {
                    ir::Argument::Constant(value) => builder.constant(value.to_f64()),
                    ir::Argument::Random { low, high } => {
                        let to = builder.new_real();
                        self.draws.push(Draw { low: low.to_f64(), high: high.to_f64(), to });
                        to
                    }
                    ir::Argument::Reading(sensor) => builder.sensor(*sensor, names.platform, names.logical),
                    ir::Argument::Output { sense, output } => names.outputs[*sense as usize][*output as usize],
                };
                self.arguments.push(real);
            }
            let arguments = first..self.arguments.len() as u32;
            self.calls.push(Call { action: self.platform.action(call.action), arguments });
        }
        start..self.calls.len() as u32
    }

    fn transition(
        &self,
        from: Id<ir::Mode>,
        transition: &ir::Transition,
        builder: &mut Builder<'_>,
        names: &Names<'_>,
    ) -> Transition {
        builder.begin_part();
        let start = builder.position();
        let condition = builder.expr(transition.condition, names);
        let steps = start..builder.position();
        Transition {
            priority: transition.priority,
            steps,
            condition,
            target: transition.target.unwrap_or(from).index() as u32,
            span: transition.span,
            text: self.checked.on_one_line(self.platform.program.exprs[transition.condition].span),
            evidence: self.evidence(transition.condition),
            parts: self.parts(transition.condition, builder, names),
        }
    }

    /// What a condition that has been emitted is made of, through named flags, each part once.
    fn parts(&self, condition: Id<ir::Expr>, builder: &mut Builder<'_>, names: &Names<'_>) -> Vec<Part> {
        let program = self.platform.program;
        let mut parts = Vec::new();
        let mut waiting = vec![(condition, 0)];
        let mut seen = HashSet::new();
        while let Some((id, depth)) = waiting.pop() {
            let expr = &program.exprs[id];
            let (within, evidence) = match &expr.op {
                ir::Op::Flag(flag) => (vec![self.diagram.flags[*flag].condition], Vec::new()),
                ir::Op::And(of) | ir::Op::Or(of) => (of.clone(), Vec::new()),
                ir::Op::Compare(_, left, right) => {
                    let sides = [*left, *right];
                    let looks_at = sides.iter().flat_map(|side| self.looks_at(&program.exprs[*side].op)).collect();
                    let counts = sides.into_iter().filter(|side| matches!(program.exprs[*side].op, ir::Op::Count(_)));
                    (counts.collect(), looks_at)
                }
                ir::Op::Not(of)
                | ir::Op::Rising(of)
                | ir::Op::Falling(of)
                | ir::Op::Held(of, _)
                | ir::Op::Latched(of)
                | ir::Op::Count(of) => (vec![*of], Vec::new()),
                op => (Vec::new(), self.looks_at(op)),
            };
            waiting.extend(within.into_iter().rev().filter(|id| seen.insert(*id)).map(|id| (id, depth + 1)));
            let value = builder.expr(id, names);
            let value = if expr.ty == ir::Type::Bool { Value::Truth(value) } else { Value::Number(value) };
            parts.push(Part { depth, text: self.checked.on_one_line(expr.span), value, evidence });
        }
        parts
    }

    /// The numbers that one operation looks at.
    fn looks_at(&self, op: &ir::Op) -> Vec<Evidence> {
        match op {
            ir::Op::Sensor(sensor) | ir::Op::Failed(sensor) => vec![self.reading(*sensor)],
            ir::Op::Event { sense, event } => vec![self.event(*sense, *event)],
            ir::Op::After(_) => vec![Evidence::Dwell],
            _ => Vec::new(),
        }
    }

    fn reading(&self, sensor: Id<ir::Sensor>) -> Evidence {
        match self.platform.feed(sensor) {
            Feed::Input(input) => Evidence::Input(input),
            Feed::Logical(place) => Evidence::Logical(place),
        }
    }

    /// An event by its position among those of all networks.
    fn event(&self, sense: u32, event: u32) -> Evidence {
        let before = self.senses().take(sense as usize);
        let before = before.map(|sense| self.platform.program.networks[sense.network].events.len());
        Evidence::Event(before.sum::<usize>() as u32 + event)
    }

    /// The networks of the plan.
    fn senses(&self) -> impl Iterator<Item = &ir::Sense> {
        self.diagram.senses.iter().chain(self.platform.senses)
    }

    /// The condition that a contact follows from.
    fn kept(&self, op: &ir::Op) -> Option<Id<ir::Expr>> {
        let ir::Op::Sensor(sensor) = op else { return None };
        let Feed::Logical(place) = self.platform.feed(*sensor) else { return None };
        let sensor = &self.platform.program.sensors[self.platform.logical[place as usize]];
        sensor.kept.as_ref().map(|kept| kept.condition)
    }

    /// The numbers a condition looks at, through named flags, contacts and events, each once.
    fn evidence(&self, condition: Id<ir::Expr>) -> Vec<Evidence> {
        let mut evidence = Vec::new();
        let mut add = |item| {
            if !evidence.contains(&item) {
                evidence.push(item);
            }
        };
        let mut waiting = vec![(condition, 0)];
        let mut seen = HashSet::new();
        while let Some((root, first)) = waiting.pop() {
            for id in reachable(self.platform.program, root) {
                let op = &self.platform.program.exprs[id].op;
                match op {
                    ir::Op::Event { sense, event } => {
                        add(self.event(first + sense, *event));
                        let sensed = self.senses().nth((first + sense) as usize);
                        for &sensor in sensed.iter().flat_map(|sense| &sense.inputs) {
                            add(self.reading(sensor));
                        }
                    }
                    ir::Op::Flag(flag) if seen.insert(*flag) => {
                        waiting.push((self.diagram.flags[*flag].condition, 0));
                    }
                    op => match self.kept(op) {
                        Some(condition) => waiting.push((condition, self.diagram.senses.len() as u32)),
                        None => self.looks_at(op).into_iter().for_each(&mut add),
                    },
                }
            }
        }
        evidence
    }
}
