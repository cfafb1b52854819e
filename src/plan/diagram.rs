//! The plan of a diagram on a robot.

use std::ops::Range;

use super::builder::{Builder, EventSlots, Names, reachable};
use super::{
    Action, Bool, Call, Checked, Draw, Event, Evidence, Flag, Input, Mode, Origin, Output, Part, Plan, Real, Sense,
    Transition, Value, input, origin,
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
    build(checked, scenario.diagram, scenario.robot, &watched)
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
pub fn build_on(
    checked: Checked<'_>,
    diagram: Id<ir::Diagram>,
    platform: ir::Platform,
    watched: &[Id<ir::Expr>],
) -> Plan {
    let program = checked.program;
    let diagram = &program.diagrams[diagram];
    let platform = Platform::new(program, platform);
    let input_of = |sensor| platform.input(sensor);
    let mut builder = Builder::new(program);

    let (mut senses, mut events, mut strengths) = (Vec::new(), Vec::new(), Vec::new());
    let (mut event_flags, mut outputs): (Vec<Vec<Bool>>, Vec<Output>) = (Vec::new(), Vec::new());
    let mut output_values: Vec<Vec<Real>> = Vec::new();
    for sense in &diagram.senses {
        let readings: Vec<Real> = sense.inputs.iter().map(|&sensor| builder.read(platform.input(sensor))).collect();
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
    let mut flags: Vec<Bool> = Vec::new();
    for flag in diagram.flags.values() {
        let names = Names { input: &input_of, events: &event_flags, outputs: &output_values, flags: &flags };
        let value = builder.expr(flag.condition, &names);
        flags.push(value);
    }
    let names = Names { input: &input_of, events: &event_flags, outputs: &output_values, flags: &flags };
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
    let modes = diagram.modes.iter().map(|(id, mode)| parts.mode(id, mode, &mut builder, &names)).collect();

    builder.begin_watch();
    let start = builder.position();
    let watched = watched.iter().map(|&condition| builder.expr(condition, &names)).collect();
    let watch = start..builder.position();
    let constants = builder.finish();
    Plan {
        name: diagram.symbol.name.clone(),
        origin: origin(&diagram.symbol),
        robot: platform.name.to_owned(),
        inputs: platform.inputs(diagram),
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
        calls: parts.calls,
        arguments: parts.arguments,
        draws: parts.draws,
        required: parts.required,
        constants,
        entry: diagram.entry.map_or(0, |entry| entry.index() as u32),
    }
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

/// What a diagram runs on. What the diagram names on an interface is found on a robot by name; a checked robot has it.
#[derive(Clone, Copy)]
struct Platform<'a> {
    program: &'a ir::Program,
    name: &'a str,
    sensors: &'a [Id<ir::Sensor>],
    actions: &'a [Id<ir::Action>],
    /// The interfaces a robot keeps; their doc comments stand in for those that the robot does not repeat.
    provides: &'a [Id<ir::Interface>],
}

impl<'a> Platform<'a> {
    fn new(program: &'a ir::Program, platform: ir::Platform) -> Self {
        match platform {
            ir::Platform::Robot(robot) => {
                let ir::Robot { symbol, provides, sensors, actions, .. } = &program.robots[robot];
                Self { program, name: &symbol.name, sensors, actions, provides }
            }
            ir::Platform::Interface(interface) => {
                let ir::Interface { symbol, sensors, actions } = &program.interfaces[interface];
                Self { program, name: &symbol.name, sensors, actions, provides: &[] }
            }
        }
    }

    fn input(&self, sensor: Id<ir::Sensor>) -> u32 {
        let name = &self.program.sensors[sensor].symbol.name;
        let place = |&own: &Id<ir::Sensor>| own == sensor || self.program.sensors[own].symbol.name == *name;
        self.sensors.iter().position(place).unwrap_or_default() as u32
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

    /// The sensors; one that does not say how it fails takes the word of a variable it feeds.
    fn inputs(&self, diagram: &ir::Diagram) -> Vec<Input> {
        let feeds = |sensor: Id<ir::Sensor>| -> Vec<&[ir::FailReading]> {
            let fed = diagram.senses.iter().flat_map(|sense| {
                let inputs = &self.program.networks[sense.network].inputs;
                sense.inputs.iter().zip(inputs).filter(move |(fed, _)| **fed == sensor).map(|(_, input)| input.variable)
            });
            fed.map(|variable| self.program.variables[variable].fails.as_slice()).collect()
        };
        let promised = self.provides.iter().flat_map(|&interface| &self.program.interfaces[interface].sensors);
        let promised = promised.map(|&sensor| &self.program.sensors[sensor].symbol);
        let sensors = self.sensors.iter().map(|&id| (id, &self.program.sensors[id]));
        sensors
            .map(|(id, sensor)| {
                let fails = [vec![sensor.fails.as_slice()], feeds(id)].concat();
                let input = input(&sensor.symbol, &sensor.unit, sensor.range, &fails);
                Input { origin: documented(&sensor.symbol, promised.clone()), ..input }
            })
            .collect()
    }
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
            calls: Vec::new(),
            arguments: Vec::new(),
            draws: Vec::new(),
            required: Vec::new(),
        }
    }

    fn mode(&mut self, id: Id<ir::Mode>, mode: &ir::Mode, builder: &mut Builder<'_>, names: &Names<'_>) -> Mode {
        let draws = self.draws.len() as u32;
        let on_enter = self.calls(&mode.on_enter, builder, names);
        let actions = self.calls(&mode.actions, builder, names);
        let on_exit = self.calls(&mode.on_exit, builder, names);
        let draws = draws..self.draws.len() as u32;
        let required = self.required.len() as u32;
        self.required.extend(mode.requires.iter().map(|&(sensor, _)| self.platform.input(sensor)));
        let transitions = self.transitions.len() as u32;
        for transition in &mode.transitions {
            let transition = self.transition(id, transition, builder, names);
            self.transitions.push(transition);
        }
        Mode {
            name: mode.symbol.name.clone(),
            origin: origin(&mode.symbol),
            transitions: transitions..self.transitions.len() as u32,
            actions,
            on_enter,
            on_exit,
            draws,
            required: required..self.required.len() as u32,
            otherwise: mode.otherwise.map(|mode| mode.index() as u32),
        }
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
        let mut seen = std::collections::HashSet::new();
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
            ir::Op::Sensor(sensor) | ir::Op::Failed(sensor) => vec![Evidence::Input(self.platform.input(*sensor))],
            ir::Op::Event { sense, event } => vec![self.event(*sense, *event)],
            ir::Op::After(_) => vec![Evidence::Dwell],
            _ => Vec::new(),
        }
    }

    /// An event by its position among those of all networks.
    fn event(&self, sense: u32, event: u32) -> Evidence {
        let before = self.diagram.senses.iter().take(sense as usize);
        let before = before.map(|sense| self.platform.program.networks[sense.network].events.len());
        Evidence::Event(before.sum::<usize>() as u32 + event)
    }

    /// The numbers a condition looks at, through named flags and events, each once.
    fn evidence(&self, condition: Id<ir::Expr>) -> Vec<Evidence> {
        let mut evidence = Vec::new();
        let mut add = |item| {
            if !evidence.contains(&item) {
                evidence.push(item);
            }
        };
        let mut waiting = vec![condition];
        let mut seen = std::collections::HashSet::new();
        while let Some(root) = waiting.pop() {
            for id in reachable(self.platform.program, root) {
                let op = &self.platform.program.exprs[id].op;
                self.looks_at(op).into_iter().for_each(&mut add);
                match op {
                    ir::Op::Event { sense, .. } => {
                        for &sensor in &self.diagram.senses[*sense as usize].inputs {
                            add(Evidence::Input(self.platform.input(sensor)));
                        }
                    }
                    ir::Op::Flag(flag) if seen.insert(*flag) => {
                        waiting.push(self.diagram.flags[*flag].condition);
                    }
                    _ => {}
                }
            }
        }
        evidence
    }
}
