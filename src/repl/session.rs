//! The session: what has been told to the machine, what it did, and what commands make of both.

use super::command::{Command, Length, help, parse};
use super::name::{Names, Watched};
use super::twin::{Plans, Twin};
use super::{Refusal, load, show, why};
use crate::base::{FileId, Id, read_quantity};
use crate::interp::{Actuators, Evaluator, Inputs, Machine, Reading, Taken};
use crate::ir;
use crate::plan::{self, Checked, Input, NetworkPlan, Plan};
use crate::sim;
use crate::syntax::is_name;
use crate::verify::{Number, Replay, Stretch, Told, readings};

/// The most ticks of one step.
const MOST_TICKS: u64 = 1_000_000;
/// The seed of what the machine draws; scenarios that do not say have the same.
const SEED: u64 = 1;

/// What is driven.
#[derive(Debug)]
pub struct Driven<'a> {
    checked: Checked<'a>,
    diagram: Id<ir::Diagram>,
    platform: ir::Platform,
    /// Nanoseconds.
    pub(super) tick: u64,
    pub(super) plan: Plan,
    /// The networks it senses, fed by its sensors.
    pub(super) networks: Vec<NetworkPlan>,
    twins: Plans,
}

impl<'a> Driven<'a> {
    /// A diagram on a robot, or on the interface it is written on, with ticks of so many nanoseconds, above 0.
    pub fn new(checked: Checked<'a>, diagram: Id<ir::Diagram>, platform: ir::Platform, tick: u64) -> Self {
        let plan = plan::build_on(checked, diagram, platform, &[]);
        let program = checked.program();
        let networks = program.diagrams[diagram].senses.iter().map(|sense| {
            let network = plan::build_network(checked, sense.network);
            let fed = sense.inputs.iter().map(|&sensor| &program.sensors[sensor]).zip(network.inputs);
            // A logical sensor is no input of the plan; what it reads has been made safe already.
            let input = |(sensor, input): (&ir::Sensor, Input)| {
                let ir::Sensor { symbol, unit, range, .. } = sensor;
                let own = plan.inputs.iter().find(|own| own.name == symbol.name).cloned();
                let (low, high) = (range.0.to_f64(), range.1.to_f64());
                own.unwrap_or_else(|| Input { name: symbol.name.clone(), unit: unit.clone(), low, high, ..input })
            };
            let inputs = fed.map(input).collect();
            NetworkPlan { name: sense.symbol.name.clone(), inputs, ..network }
        });
        let networks = networks.collect();
        Self { checked, diagram, platform, tick, plan, networks, twins: Plans::default() }
    }
}

/// What a command comes to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Reply {
    /// An answer, in lines; empty where there is nothing to say.
    Text(String),
    /// A scenario is to be written.
    Save(Saved),
    /// What [`Session::watch`] is to watch is to be made of this condition.
    Watch(String),
    /// The text of a trace is to be read from this path and given to [`Session::load`].
    Load(String),
    /// The session is over.
    Quit,
}

/// A session as a scenario.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Saved {
    /// Where it is to be written.
    pub path: String,
    /// The scenario.
    pub text: String,
    /// The files that declare what it names.
    pub imports: Vec<FileId>,
}

/// A diagram being driven by hand.
#[derive(Debug)]
pub struct Session<'d> {
    pub(super) driven: &'d Driven<'d>,
    names: Names,
    pub(super) color: bool,
    pub(super) now: State<'d>,
    /// The command that is being carried out.
    line: String,
    /// Each command that changed something, and the state before it.
    before: Vec<(String, State<'d>)>,
}

/// All that commands change.
#[derive(Debug, Clone)]
pub(super) struct State<'d> {
    pub(super) machine: Machine<'d>,
    pub(super) evaluators: Vec<Evaluator<'d>>,
    /// What each sensor reads while it has not failed.
    pub(super) values: Vec<Number>,
    pub(super) failed: Vec<bool>,
    /// Whether the action of the mode is complete.
    pub(super) done: bool,
    /// What was told so far; nothing before the first tick.
    stretches: Vec<Stretch>,
    /// Nanoseconds from the first tick to the last.
    pub(super) time: u64,
    /// The modes that were entered.
    modes: Vec<u32>,
    /// What the machine commanded on the last tick: actions and their arguments.
    pub(super) commands: Vec<(u32, Vec<f64>)>,
    pub(super) last: Option<Tick>,
    /// The last tick on which a transition was taken, and the machine after it.
    pub(super) moved: Option<(Tick, Machine<'d>)>,
    pub(super) watched: Vec<(String, Watched<'d>)>,
}

/// A tick.
#[derive(Debug, Clone)]
pub(super) struct Tick {
    /// Nanoseconds since the first.
    pub(super) time: u64,
    /// The mode before it.
    pub(super) from: u32,
    pub(super) taken: Taken,
    /// How long that mode had been active, in nanoseconds.
    pub(super) dwell: u64,
    pub(super) readings: Vec<Reading>,
}

/// Does nothing of what the machine commands.
pub(super) struct Nobody;

impl Actuators for Nobody {
    fn command(&mut self, _action: u32, _arguments: &[f64], _start: bool) {}
}

/// Takes down what the machine commands.
struct Heard<'h>(&'h mut Vec<(u32, Vec<f64>)>);

impl Actuators for Heard<'_> {
    fn command(&mut self, action: u32, arguments: &[f64], _start: bool) {
        self.0.push((action, arguments.to_vec()));
    }
}

impl<'d> State<'d> {
    fn new(driven: &'d Driven<'d>) -> Self {
        // A reading of 0, or of the end of the range nearest to it.
        let rest = |input: &Input| {
            let number = number_at(0.0_f64.clamp(input.low, input.high), input);
            number.unwrap_or(Number { written: 0.0, si: 0.0 })
        };
        Self {
            machine: sim::machine(&driven.plan, SEED),
            evaluators: driven.networks.iter().map(Evaluator::new).collect(),
            values: driven.plan.inputs.iter().map(rest).collect(),
            failed: vec![false; driven.plan.inputs.len()],
            done: false,
            stretches: Vec::new(),
            time: 0,
            modes: Vec::new(),
            commands: Vec::new(),
            last: None,
            moved: None,
            watched: Vec::new(),
        }
    }

    /// What the sensors say.
    pub(super) fn told(&self) -> Told {
        self.values.iter().zip(&self.failed).map(|(value, failed)| (!failed).then_some(*value)).collect()
    }

    /// How long the next tick is, in nanoseconds: the first takes no time.
    fn next(&self, driven: &Driven<'_>) -> u64 {
        if self.last.is_some() { driven.tick } else { 0 }
    }

    /// The mode after the next tick, were the action of the mode complete then or not.
    pub(super) fn mode_after(&self, driven: &Driven<'_>, done: bool) -> u32 {
        let mut machine = self.machine.clone();
        let inputs = Inputs { readings: &readings(&self.told()), done };
        machine.step(inputs, self.next(driven), &mut Nobody);
        machine.mode()
    }

    /// One tick; whether the mode changed.
    pub(super) fn step(&mut self, driven: &'d Driven<'d>) -> bool {
        let (told, done) = (self.told(), self.done);
        let dt = self.next(driven);
        let (from, dwell) = (self.machine.mode(), self.machine.dwell() + dt);
        let readings = readings(&told);
        self.time += dt;
        self.commands.clear();
        let taken = self.machine.step(Inputs { readings: &readings, done }, dt, &mut Heard(&mut self.commands));
        for ((evaluator, network), sense) in self.evaluators.iter_mut().zip(&driven.networks).zip(&driven.plan.senses) {
            // What the machine itself made of the readings, so that both see the same.
            let safe = sense.readings.iter().take(network.inputs.len()).map(|&real| self.machine.real(real));
            let safe: Vec<Reading> = safe.map(|value| Reading { value, healthy: true }).collect();
            evaluator.evaluate(&safe, dt);
        }
        for (_, watched) in &mut self.watched {
            if let Watched::Condition(twin) = watched {
                twin.step(Inputs { readings: &readings, done }, dt);
            }
        }
        match self.stretches.last_mut() {
            Some(last) if (&last.told, last.done) == (&told, done) => last.ticks += 1,
            _ => self.stretches.push(Stretch { told, done, ticks: 1 }),
        }
        let tick = Tick { time: self.time, from, taken, dwell, readings };
        let moved = taken != Taken::Stayed;
        if moved {
            self.done = false;
            self.modes.push(self.machine.mode());
            self.moved = Some((tick.clone(), self.machine.clone()));
        }
        self.last = Some(tick);
        moved
    }
}

impl<'d> Session<'d> {
    /// A session before its first tick, in which every sensor reads what is nearest to 0. `color` adds ANSI escapes to
    /// answers.
    pub fn new(driven: &'d Driven<'d>, color: bool) -> Self {
        Self {
            driven,
            names: Names::new(&driven.plan),
            color,
            now: State::new(driven),
            line: String::new(),
            before: Vec::new(),
        }
    }

    /// What commands can name.
    pub fn names(&self) -> &Names {
        &self.names
    }

    /// The active mode and the time, as in `forward 2.5 s`; the name of the diagram before the first tick.
    pub fn place(&self) -> String {
        let Driven { plan, .. } = self.driven;
        match &self.now.last {
            Some(tick) => format!("{} {}", self.mode(self.now.machine.mode()), crate::verify::time(tick.time)),
            None => plan.name.clone(),
        }
    }

    /// Carries a line out. Costs the ticks it runs, and the length of the session where it changes something.
    ///
    /// # Errors
    /// Why it cannot be; nothing has changed then.
    pub fn carry_out(&mut self, line: &str) -> Result<Reply, Refusal> {
        let Some(command) = parse(line)? else { return Ok(Reply::Text(String::new())) };
        line.trim().clone_into(&mut self.line);
        Ok(Reply::Text(match command {
            Command::Set { sensor, value } => self.set(&sensor, &value)?,
            Command::Fail(sensor) => self.fail(&sensor, true)?,
            Command::Heal(sensor) => self.fail(&sensor, false)?,
            Command::Done => self.done()?,
            Command::Step(length) => self.step(length)?,
            Command::Undo => self.undo()?,
            Command::Show => show::state(self),
            Command::Why => why::why(self)?,
            Command::Degrees(network) => self.degrees(network.as_deref())?,
            Command::Watch(None) => show::watched(self),
            Command::Watch(Some(text)) => return self.watch_text(text),
            Command::Unwatch(name) => self.unwatch(&name)?,
            Command::Save(path) => return self.save(&path).map(Reply::Save),
            Command::Load(path) => return Ok(Reply::Load(path)),
            Command::Help => help(),
            Command::Quit => return Ok(Reply::Quit),
        }))
    }

    /// Starts again with the readings of a trace, given as its text. Linear in its size.
    ///
    /// # Errors
    /// Why that is no trace of a run that can be replayed; nothing has changed then.
    pub fn load(&mut self, text: &str) -> Result<String, Refusal> {
        let afresh = |watched: &Watched<'d>| match watched {
            Watched::Condition(twin) => Watched::Condition(Box::new(twin.afresh(SEED))),
            other => other.clone(),
        };
        let watched = self.now.watched.iter().map(|(name, watched)| (name.clone(), afresh(watched))).collect();
        let fresh = State { watched, ..State::new(self.driven) };
        let (state, answer) = load::load(self, fresh, text)?;
        self.change(|now| *now = state);
        Ok(answer)
    }

    /// Watches a condition, given as it was written and as a plan of what is driven that watches it alone. Linear in the
    /// ticks of the session.
    pub fn watch(&mut self, text: &str, plan: Plan) -> String {
        let mut twin = Twin::new(self.driven.twins.keep(plan), SEED);
        twin.follow(&self.now.stretches, self.driven.tick);
        self.add_watched(text, Watched::Condition(Box::new(twin)))
    }

    pub(super) fn mode(&self, mode: u32) -> &'d str {
        &self.driven.plan.modes[mode as usize].name
    }

    /// Changes the state so that it can be undone.
    fn change(&mut self, change: impl FnOnce(&mut State<'d>)) {
        self.before.push((self.line.clone(), self.now.clone()));
        change(&mut self.now);
    }

    fn set(&mut self, sensor: &str, value: &str) -> Result<String, Refusal> {
        let follows = |of: &&plan::Logical| of.name == sensor && matches!(of.value, plan::Value::Truth(_));
        if let Some(contact) = self.driven.plan.logical.iter().find(follows) {
            let of: Vec<_> =
                contact.of.iter().map(|&input| self.driven.plan.inputs[input as usize].name.as_str()).collect();
            let refusal = Refusal::new(format!("what `{sensor}` reads follows from a condition"));
            return Err(refusal.help(format!("set what it looks at: `{}`", of.join("`, `"))));
        }
        let all = self.names.sensor(sensor)?.to_vec();
        let Some(input) = all.first().map(|&index| &self.driven.plan.inputs[index]) else { return Ok(String::new()) };
        let unit = match input.unit.text.as_str() {
            "contact" => "`set` or `clear`".to_owned(),
            "1" => "a plain number".to_owned(),
            text => format!("a number in {text}, or in another unit of the same kind"),
        };
        let refusal =
            || Refusal::new(format!("`{value}` is not a reading of `{sensor}`")).help(format!("write {unit}"));
        let number = read_quantity(value, &input.unit).and_then(|si| Number::exactly(si, &input.unit));
        let number = number.ok_or_else(refusal)?;
        let within = number.si.clamp(input.low, input.high);
        let is_within = within == number.si;
        let number = if is_within { number } else { number_at(within, input).ok_or_else(refusal)? };
        let mut answer = String::new();
        if !is_within {
            let (low, high) = (input.unit.show(input.low), input.unit.show(input.high));
            answer += &format!("  out of range ({low} .. {high}): taken as {}\n", input.unit.show(within));
        }
        if all.iter().any(|&index| self.now.failed[index]) {
            answer += &format!("  `{sensor}` has failed: the machine does not see it before `heal {sensor}`\n");
        }
        self.change(|now| all.iter().for_each(|&index| now.values[index] = number));
        Ok(answer)
    }

    fn fail(&mut self, sensor: &str, failed: bool) -> Result<String, Refusal> {
        let all = self.names.sensor(sensor)?.to_vec();
        if all.iter().all(|&index| self.now.failed[index] == failed) {
            let message = if failed { "has failed already" } else { "has not failed" };
            return Err(Refusal::new(format!("`{sensor}` {message}")));
        }
        self.change(|now| all.iter().for_each(|&index| now.failed[index] = failed));
        Ok(String::new())
    }

    fn done(&mut self) -> Result<String, Refusal> {
        let plan = &self.driven.plan;
        let reports = |(action, _): &(u32, Vec<f64>)| plan.actions[*action as usize].reports_done;
        if self.now.commands.iter().any(reports) {
            self.change(|now| now.done = true);
            return Ok(String::new());
        }
        Err(Refusal::new(match &self.now.last {
            Some(_) => format!("no action of `{}` reports completion", self.mode(self.now.machine.mode())),
            None => "no mode has been entered yet".to_owned(),
        }))
    }

    fn step(&mut self, length: Length) -> Result<String, Refusal> {
        let ticks = match length {
            Length::Ticks(ticks) => ticks,
            // The first tick takes no time.
            Length::Nanoseconds(time) => {
                time.div_ceil(self.driven.tick).saturating_add(u64::from(self.now.last.is_none()))
            }
        };
        if ticks > MOST_TICKS {
            return Err(Refusal::new(format!("that is {ticks} ticks; the most at a time is {MOST_TICKS}")));
        }
        self.before.push((self.line.clone(), self.now.clone()));
        let mut answer = String::new();
        for _ in 0..ticks {
            let before = show::watched_truths(self);
            if self.now.step(self.driven) {
                answer += &show::change(self);
            }
            answer += &show::watched_changes(self, &before);
        }
        answer += &show::place(self);
        answer += &show::watched(self);
        Ok(answer)
    }

    fn undo(&mut self) -> Result<String, Refusal> {
        let (line, before) = self.before.pop().ok_or_else(|| Refusal::new("there is nothing to undo"))?;
        self.now = before;
        Ok(format!("  took `{line}` back\n{}", show::place(self)))
    }

    fn degrees(&self, network: Option<&str>) -> Result<String, Refusal> {
        if self.driven.networks.is_empty() {
            return Err(Refusal::new(format!("`{}` senses no network", self.driven.plan.name)));
        }
        if self.now.last.is_none() {
            return Err(not_yet());
        }
        match network {
            Some(name) => Ok(show::degrees(self, self.names.network(name)?)),
            None => {
                let all: Vec<_> = (0..self.driven.networks.len()).map(|index| show::degrees(self, index)).collect();
                Ok(all.join("\n"))
            }
        }
    }

    fn watch_text(&mut self, text: String) -> Result<Reply, Refusal> {
        if self.now.watched.iter().any(|(known, _)| *known == text) {
            return Err(Refusal::new(format!("`{text}` is watched already")));
        }
        Ok(match self.names.watched(&text, &self.driven.plan)? {
            Some(watched) => Reply::Text(self.add_watched(&text, watched)),
            None => Reply::Watch(text),
        })
    }

    fn add_watched(&mut self, text: &str, watched: Watched<'d>) -> String {
        self.change(|now| now.watched.push((text.to_owned(), watched)));
        show::watched(self)
    }

    fn unwatch(&mut self, name: &str) -> Result<String, Refusal> {
        let position = self.now.watched.iter().position(|(known, _)| known == name);
        let position = position.ok_or_else(|| Refusal::new(format!("`{name}` is not watched")))?;
        self.change(|now| drop(now.watched.remove(position)));
        Ok(String::new())
    }

    /// The session as a scenario that goes through the same modes. Sensors that were never told anything but what they
    /// read at rest are forced too: the simulated robot has readings of its own.
    fn save(&self, path: &str) -> Result<Saved, Refusal> {
        let Driven { checked, diagram, platform, tick, .. } = *self.driven;
        let program = checked.program();
        let name = path.strip_suffix(".msd").and_then(|path| path.rsplit('/').next());
        let name = name.filter(|name| is_name(name)).ok_or_else(|| {
            Refusal::new(format!("`{path}` is no name for a scenario"))
                .help("write a file whose name is a name of the language, as in `save pushed.msd`")
        })?;
        let is_taken = |symbol: &ir::Symbol| symbol.name == name;
        let ir::Program { scenarios, diagrams, robots, properties, worlds, .. } = program;
        if scenarios.values().map(|scenario| &scenario.symbol).any(is_taken)
            || diagrams.values().map(|diagram| &diagram.symbol).any(is_taken)
            || robots.values().map(|robot| &robot.symbol).any(is_taken)
            || properties.values().map(|property| &property.symbol).any(is_taken)
            || worlds.values().map(|world| &world.symbol).any(is_taken)
        {
            return Err(Refusal::new(format!("the program has something named `{name}`")).help("save it under another"));
        }
        let refused = |reason: &str| Refusal::new(format!("no scenario can replay the session: {reason}"));
        if self.now.stretches.is_empty() {
            return Err(not_yet());
        }
        let robot = match platform {
            ir::Platform::Interface(_) => return Err(refused("the behavior is written on an interface")),
            ir::Platform::Robot(robot) if program.robots[robot].body.is_none() => {
                return Err(refused("its robot has no body"));
            }
            ir::Platform::Robot(robot) => robot,
        };
        let modes: Vec<Id<ir::Mode>> = self.now.modes.iter().map(|&mode| Id::new(mode)).collect();
        let forced = vec![true; self.driven.plan.inputs.len()];
        let replay = Replay { checked, diagram, robot, tick, forced: &forced, claim: None };
        let text = replay.scenario(name, &modes, &self.now.stretches).map_err(refused)?;
        let (diagram, robot) = (&program.diagrams[diagram], &program.robots[robot]);
        let mut imports = vec![diagram.symbol.span.file];
        let is_named = matches!(diagram.platform, ir::Platform::Interface(_));
        imports.extend(Some(robot.symbol.span.file).filter(|file| is_named && *file != imports[0]));
        Ok(Saved { path: path.to_owned(), text, imports })
    }
}

/// A number in SI as a reading of a sensor.
pub(super) fn number_at(si: f64, input: &Input) -> Option<Number> {
    Number::new(si / input.unit.scale.to_f64(), &input.unit)
}

pub(super) fn not_yet() -> Refusal {
    Refusal::new("no tick has been run yet").help("`step` runs the first")
}
