//! Emitted code as a process that is fed with readings: what the tests of emitted code share.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use lmslc::driver::{Analysis, Plans};
use lmslc::emit::Options;
use lmslc::interp::{Actuators, Evaluator, Inputs, Machine, Reading};
use lmslc::plan::{self, NetworkPlan, Plan, Step};
use quote::ToTokens;

use crate::emit_programs::Random;

/// Everything that one program emits, and the plans that it was emitted from.
#[derive(Clone)]
pub struct Case {
    pub title: String,
    pub code: String,
    pub networks: Vec<NetworkPlan>,
    pub diagrams: Vec<Plan>,
}

impl Case {
    /// What is compiled of an analysis without errors.
    pub fn new(title: &str, analysis: &Analysis, options: &Options) -> Self {
        let code = analysis.rust(options).unwrap();
        let Plans { networks, diagrams } = analysis.plans(options.robot.as_deref()).unwrap();
        Self { title: title.to_owned(), code, networks, diagrams }
    }

    /// Bodies of functions that run each plan on unknown numbers, without `std`.
    pub fn bare_drivers(&self, path: &str) -> Vec<String> {
        let networks = self.networks.iter().map(|plan| {
            let (name, remembers) = (&plan.name, interface(&self.code, &plan.name).fields.contains_key("Memory"));
            let columns = interface(&self.code, &plan.name).functions.get("evaluate_columns").map(|columns| {
                let given = columns.iter().map(|(_, kind)| {
                    if kind.contains("mut") { "&mut any::<[_; 7]>(), " } else { "&any::<[_; 9]>(), " }
                });
                format!("{path}::{name}::evaluate_columns({});", given.collect::<Vec<_>>().concat())
            });
            let columns = columns.unwrap_or_default();
            let memory =
                if remembers { format!(", &mut any::<{path}::{name}::Memory>(), any()") } else { String::new() };
            format!("black_box({path}::{name}::evaluate(&any::<{path}::{name}::Inputs>(){memory})); {columns}")
        });
        let diagrams = self.diagrams.iter().map(|plan| {
            let path = format!("{path}::{}", plan.name);
            let interface = interface(&self.code, &plan.name);
            let actions = interface.actions.iter().map(|action| {
                let parameters = &interface.functions[action];
                let declared = parameters.iter().map(|(name, kind)| format!("{name}: {kind}, "));
                let names = parameters.iter().map(|(name, _)| format!("{name}, "));
                format!(
                    "fn {action}(&mut self, {}) -> Result<(), u8> {{ black_box(({})); any() }}",
                    declared.collect::<Vec<_>>().concat(),
                    names.collect::<Vec<_>>().concat()
                )
            });
            let actions = actions.collect::<Vec<_>>().concat();
            format!(
                "struct Any; impl {path}::Robot for Any {{ type Error = u8; {actions} }}
                let mut machine = any::<{path}::Machine>();
                black_box(machine.step(&any(), any(), &mut Any));
                black_box(machine);"
            )
        });
        networks.chain(diagrams).collect()
    }
}

/// What emitted code offers, read from its text.
#[derive(Default)]
struct Interface {
    /// The fields of each struct.
    fields: BTreeMap<String, Vec<String>>,
    /// The parameters of each function, and of each action.
    functions: BTreeMap<String, Vec<(String, String)>>,
    actions: Vec<String>,
}

fn interface(code: &str, module: &str) -> Interface {
    let file = syn::parse_file(code).unwrap();
    let module = file.items.iter().find_map(|item| match item {
        syn::Item::Mod(found) if found.ident == module => found.content.as_ref(),
        _ => None,
    });
    let mut interface = Interface::default();
    let mut function = |signature: &syn::Signature| {
        let parameters = signature.inputs.iter().filter_map(|input| match input {
            syn::FnArg::Typed(input) => {
                Some((input.pat.to_token_stream().to_string(), input.ty.to_token_stream().to_string()))
            }
            syn::FnArg::Receiver(_) => None,
        });
        interface.functions.insert(signature.ident.to_string(), parameters.collect());
    };
    for item in &module.unwrap().1 {
        match item {
            syn::Item::Struct(declared) => {
                let fields = declared.fields.iter().filter_map(|field| Some(field.ident.as_ref()?.to_string()));
                interface.fields.insert(declared.ident.to_string(), fields.collect());
            }
            syn::Item::Fn(free) => function(&free.sig),
            syn::Item::Impl(methods) if methods.self_ty.to_token_stream().to_string() == "Machine" => {
                for item in &methods.items {
                    if let syn::ImplItem::Fn(method) = item {
                        function(&method.sig);
                    }
                }
            }
            syn::Item::Trait(robot) => {
                for item in &robot.items {
                    if let syn::TraitItem::Fn(method) = item {
                        function(&method.sig);
                        interface.actions.push(method.sig.ident.to_string());
                    }
                }
            }
            _ => {}
        }
    }
    interface
}

/// A driver for a network: readings in, one line a reading out.
fn drive_network(path: &str, code: &str, plan: &NetworkPlan) -> String {
    let interface = interface(code, &plan.name);
    let remembers = interface.fields.contains_key("Memory");
    let inputs =
        plan.inputs.iter().map(|input| format!("{}: words.float() as _, ", input.name)).collect::<Vec<_>>().concat();
    let (memory, extra) = if remembers {
        (format!("let mut memory = {path}::Memory::new();"), ", &mut memory, dt")
    } else {
        (String::new(), "")
    };
    let lines = plan.events.iter().map(|event| {
        let name = &event.name;
        format!(
            "write!(line, \" {{}} {{}} {{}}\", events.{name}, bits(strengths.{name}.contributor), bits(strengths.{name}.detractor)).unwrap();\n"
        )
    });
    let outputs = plan.outputs.iter().map(|output| {
        let name = &output.name;
        format!("write!(line, \" {{}} {{}}\", outputs.{name}.fired, bits(outputs.{name}.value)).unwrap();\n")
    });
    let lines = lines.chain(outputs).collect::<Vec<_>>().concat();
    let columns =
        if interface.functions.contains_key("evaluate_columns") { compare_columns(path, plan) } else { String::new() };
    let strengths = if plan.events.is_empty() { "()".to_owned() } else { format!("{path}::strengths(&inputs)") };
    let said = match (plan.events.is_empty(), plan.outputs.is_empty()) {
        (false, true) => "events",
        (true, _) => "outputs",
        (false, false) => "(events, outputs)",
    };
    format!(
        "{memory}
        let mut told = Vec::new();
        for _ in 0..words.next() {{
            let dt = words.next();
            let _ = dt;
            let inputs = {path}::Inputs {{ {inputs} }};
            let strengths = {strengths};
            let {said} = {path}::evaluate(&inputs{extra});
            let _ = (&strengths, &{said});
            let mut line = String::new();
            {lines}
            println!(\"{{line}}\");
            told.push(inputs);
        }}
        {columns}"
    )
}

/// What asserts that columns say what `evaluate` says of each of the readings `told`.
fn compare_columns(path: &str, plan: &NetworkPlan) -> String {
    let inputs =
        plan.inputs.iter().map(|input| format!("&told.iter().map(|row| row.{}).collect::<Vec<_>>(), ", input.name));
    let events = plan.events.iter().map(|event| format!("event_{}", event.name));
    let outputs =
        plan.outputs.iter().flat_map(|output| ["value", "fired"].map(|part| format!("{part}_{}", output.name)));
    let columns: Vec<_> = events.chain(outputs).collect();
    let declared = columns.iter().map(|column| format!("let mut {column} = vec![Default::default(); told.len()];"));
    let given = columns.iter().map(|column| format!("&mut {column}, "));
    let said = match (plan.events.is_empty(), plan.outputs.is_empty()) {
        (false, true) => "events",
        (true, _) => "outputs",
        (false, false) => "(events, outputs)",
    };
    let events = plan.events.iter().map(|event| format!("assert_eq!(event_{0}[row], events.{0});", event.name));
    let outputs = plan.outputs.iter().map(|output| {
        format!(
            "assert_eq!(value_{0}[row].to_bits(), outputs.{0}.value.to_bits());
            assert_eq!(fired_{0}[row], outputs.{0}.fired);",
            output.name
        )
    });
    format!(
        "{} {path}::evaluate_columns({} {});
        for (row, inputs) in told.iter().enumerate() {{
            let {said} = {path}::evaluate(inputs);
            {} {}
        }}",
        declared.collect::<Vec<_>>().concat(),
        inputs.collect::<Vec<_>>().concat(),
        given.collect::<Vec<_>>().concat(),
        events.collect::<Vec<_>>().concat(),
        outputs.collect::<Vec<_>>().concat(),
    )
}

/// A driver for a machine: readings in, one line a tick out.
fn drive_machine(path: &str, code: &str, plan: &Plan) -> String {
    let interface = interface(code, &plan.name);
    let fields = |name: &str| interface.fields.get(name).cloned().unwrap_or_default();
    // Of `sonar[3]` the field is `sonar_3`.
    let field_of = |name: &str| name.replace(['[', '.'], "_").replace(']', "");
    let position = |name: &str| plan.inputs.iter().position(|input| field_of(&input.name) == name).unwrap();
    let mut inputs = String::new();
    for field in fields("Inputs") {
        match field.as_str() {
            "failed" => {
                let failed = fields("Failed").into_iter().map(|name| format!("{name}: failed[{}], ", position(&name)));
                write!(inputs, "failed: {path}::Failed {{ {} }}, ", failed.collect::<Vec<_>>().concat()).unwrap();
            }
            "done" => inputs += "done, ",
            name => write!(inputs, "{name}: readings[{}] as _, ", position(name)).unwrap(),
        }
    }
    let actions = interface.actions.iter().map(|action| {
        let parameters = &interface.functions[action];
        let declared = parameters.iter().map(|(name, kind)| format!("{name}: {kind}, ")).collect::<Vec<_>>().concat();
        let shown = parameters.iter().map(|(name, kind)| match kind.as_str() {
            "bool" => format!("write!(self.0, \" {{}}\", {name}).unwrap();"),
            _ => format!("write!(self.0, \" {{}}\", bits({name})).unwrap();"),
        });
        format!(
            "fn {action}(&mut self, {declared}) -> Result<(), Infallible> {{
                write!(self.0, \" {action}\").unwrap(); {} Ok(())
            }}",
            shown.collect::<Vec<_>>().concat()
        )
    });
    let actions = actions.collect::<Vec<_>>().concat();
    let seed = if interface.functions["new"].is_empty() { "" } else { "7" };
    let sensors = plan.inputs.len();
    format!(
        "struct Log(String);
        impl {path}::Robot for Log {{
            type Error = Infallible;
            {actions}
        }}
        let mut machine = {path}::Machine::new({seed});
        for _ in 0..words.next() {{
            let (dt, done) = (words.next(), words.next() == 1);
            let _ = done;
            let readings: [f64; {sensors}] = std::array::from_fn(|_| words.float());
            let failed: [bool; {sensors}] = std::array::from_fn(|_| words.next() == 1);
            let _ = (readings, failed);
            let inputs = {path}::Inputs {{ {inputs} }};
            // A tick that is taken back leaves no trace.
            let saved = machine;
            let Ok(_) = machine.step(&inputs, dt / 2 + 1, &mut Log(String::new()));
            machine = saved;
            let mut log = Log(String::new());
            let Ok(mode) = machine.step(&inputs, dt, &mut log);
            assert_eq!(machine.mode(), Some(mode));
            println!(\"{{}}{{}}|{{machine:?}}\", mode.name(), log.0);
        }}"
    )
}

/// Cases as one crate, and a process that runs them.
pub fn write_crate(cases: &[Case], folder: &Path) {
    let mut library =
        "//! Emitted.\n#![no_std]\n#![forbid(unsafe_code)]\n#![deny(warnings, clippy::pedantic, missing_docs)]\n"
            .to_owned();
    let mut runner = "#![allow(warnings)]
        use std::{convert::Infallible, fmt::Write as _, io::Read as _};
        struct Words(std::vec::IntoIter<u8>);
        impl Words {
            fn next(&mut self) -> u64 { u64::from_le_bytes(std::array::from_fn(|_| self.0.next().unwrap())) }
            fn float(&mut self) -> f64 { f64::from_bits(self.next()) }
        }
        fn bits(number: impl Into<f64>) -> String { format!(\"{:#x}\", number.into().to_bits()) }
        fn main() {
            let mut bytes = Vec::new();
            std::io::stdin().read_to_end(&mut bytes).unwrap();
            let words = &mut Words(bytes.into_iter());\n"
        .to_owned();
    let mut drivers = String::new();
    for (number, case) in cases.iter().enumerate() {
        let module = format!("case_{number}");
        writeln!(library, "/// `{}`\npub mod {module};", case.title).unwrap();
        std::fs::write(folder.join(format!("{module}.rs")), &case.code).unwrap();
        let path = |name: &str| format!("emitted::{module}::{name}");
        let networks = case.networks.iter().map(|plan| drive_network(&path(&plan.name), &case.code, plan));
        let diagrams = case.diagrams.iter().map(|plan| drive_machine(&path(&plan.name), &case.code, plan));
        for (index, driver) in networks.chain(diagrams).enumerate() {
            writeln!(runner, "{module}_{index}(words);").unwrap();
            writeln!(drivers, "fn {module}_{index}(words: &mut Words) {{\n{driver}\n}}").unwrap();
        }
    }
    std::fs::write(folder.join("lib.rs"), library).unwrap();
    std::fs::write(folder.join("main.rs"), format!("{runner}}}\n{drivers}")).unwrap();
}

/// Runs a compiler in a folder; its complaint if it fails.
pub fn compile(compiler: &str, folder: &Path, arguments: &[&str]) -> Result<(), String> {
    let beside = std::env::current_exe().unwrap().parent().unwrap().to_owned();
    let own = folder.join("liblibm.rlib");
    let libm = format!("libm={}", if own.exists() { own } else { libm(&beside) }.display());
    let beside = format!("dependency={}", beside.display());
    let mut command = Command::new(compiler);
    if !arguments.contains(&"--edition") {
        command.args(["--edition", "2024"]);
    }
    let command = command.current_dir(folder).args(["--cap-lints", "forbid", "--extern", &libm, "-L", &beside]);
    let output = command.args(arguments).output().unwrap();
    if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&output.stderr).into_owned()) }
}

/// What smooth shapes are computed by, as it was compiled for us.
fn libm(beside: &Path) -> PathBuf {
    let libm = std::fs::read_dir(beside).unwrap().map(|entry| entry.unwrap().path()).filter(|path| {
        let name = path.file_name().unwrap().to_string_lossy();
        name.starts_with("liblibm-") && name.ends_with(".rlib")
    });
    libm.max_by_key(|path| std::fs::metadata(path).unwrap().modified().unwrap()).unwrap()
}

/// Feeds a process with words and answers its lines.
pub fn run(program: &Path, words: &[u64]) -> Vec<String> {
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let mut child = Command::new(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    let writer = std::thread::spawn(move || stdin.write_all(&bytes).unwrap());
    let output = child.wait_with_output().unwrap();
    writer.join().unwrap();
    assert!(output.status.success());
    String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect()
}

/// Readings and times to try in a plan.
pub struct Trials {
    values: Vec<f64>,
    times: Vec<u64>,
    /// Whether readings are such that single precision holds them exactly.
    is_single: bool,
}

/// Where a shape turns.
fn landmarks(shape: &plan::Shape, code: &plan::Code) -> Vec<f64> {
    use plan::Shape;
    match shape {
        Shape::Ramp { zero_at, one_at } => vec![*zero_at, *one_at],
        Shape::Triangle(of) => of.to_vec(),
        Shape::Rectangle(of) | Shape::Rise(of) | Shape::Fall(of) => of.to_vec(),
        Shape::Trapezoid(of) | Shape::RiseAndFall(of) => of.to_vec(),
        Shape::Points(of) => code.points[of.start as usize..of.end as usize].iter().map(|(at, _)| *at).collect(),
        Shape::Gaussian2([low, _, high, _]) => vec![*low, *high],
        Shape::Singleton(at)
        | Shape::Gaussian([at, _])
        | Shape::Bell([at, ..])
        | Shape::Sigmoid([at, _])
        | Shape::Cosine([at, _]) => vec![*at],
    }
}

impl Trials {
    /// Readings and times at which something changes, and those beside them.
    pub fn critical(code: &plan::Code, inputs: &[plan::Input]) -> Self {
        let mut corners: Vec<f64> = vec![0.0, -0.0];
        let mut times = vec![0, 1, 10_000_000, 10_000_000, 10_000_000, 30_000_000, u64::from(u32::MAX)];
        for step in &code.steps {
            match step {
                Step::Degree { shape, .. } => corners.extend(landmarks(shape, code)),
                Step::Constant { value, .. } => corners.push(*value),
                Step::After { duration, .. } | Step::Lasts { duration, .. } | Step::Hold { duration, .. } => {
                    times.extend([*duration, duration.saturating_sub(1)]);
                }
                Step::Average { period, .. } => times.extend([*period, period - 1, period / 2]),
                _ => {}
            }
        }
        corners.extend(inputs.iter().flat_map(|input| [input.low, input.high, input.fail]));
        corners.sort_by(f64::total_cmp);
        corners.dedup();
        let between: Vec<_> = corners.windows(2).map(|pair| f64::midpoint(pair[0], pair[1])).collect();
        let beside: Vec<_> = corners.iter().flat_map(|corner| [corner.next_up(), corner.next_down()]).collect();
        let beyond = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, f64::MIN_POSITIVE, 1e9, -1e9];
        Self { values: [corners, between, beside, beyond.to_vec()].concat(), times, is_single: false }
    }

    /// Readings that are the same number in single precision, and the same times. None is as near to where something
    /// changes as the rounding of that place.
    pub fn single(code: &plan::Code, inputs: &[plan::Input]) -> Self {
        let values = [vec![f64::NAN, f64::INFINITY], vec![-1e9, 1e9]].concat();
        Self { values, is_single: true, ..Self::critical(code, inputs) }
    }

    fn reading(&self, input: &plan::Input, random: &mut Random) -> f64 {
        let drawn = lmslc::kernel::draw(&mut random.0, input.low - 0.5, input.high + 0.5);
        match self.is_single {
            true if random.chance(12) => random.one_of(&self.values),
            true => f64::from(drawn as f32),
            false if random.chance(2) => random.one_of(&self.values),
            false => drawn,
        }
    }

    fn dt(&self, random: &mut Random) -> u64 {
        if random.chance(200) { u64::MAX - random.below(2) } else { random.one_of(&self.times) }
    }
}

/// What the interpreter does on a tick.
pub struct Tick {
    /// The events of a network and their strengths; or the mode of a machine and its commands.
    pub line: String,
    /// Whether an event lies so near to a tie, or to its hysteresis, or an output's rules so near to 0, that rounding
    /// decides.
    pub is_close: bool,
    /// How long a machine has been in its mode.
    pub dwell: Option<u64>,
}

/// How far single precision may be off in a strength or an argument: far above its 6e-8 of readings below 12 over flanks
/// of a quarter, also where a root makes it larger.
pub const SINGLE: f64 = 1e-4;

fn is_close(code: &plan::Code, [contributor, detractor]: [f64; 2]) -> bool {
    let hystereses = code.steps.iter().filter_map(|step| match step {
        Step::OutweighsWithHysteresis { hysteresis, .. } => Some(*hysteresis),
        _ => None,
    });
    let ahead = contributor - detractor;
    let is_certain = ahead == 0.0 && (contributor == 0.0 || contributor == 1.0);
    !is_certain && hystereses.chain([0.0]).any(|hysteresis| (ahead.abs() - hysteresis).abs() < 2.0 * SINGLE)
}

fn bits(number: f64) -> String {
    format!("{:#x}", number.to_bits())
}

/// Words for a network, and what the interpreter answers.
pub fn expect_of_network(
    plan: &NetworkPlan,
    trials: &Trials,
    ticks: u64,
    random: &mut Random,
    words: &mut Vec<u64>,
) -> Vec<Tick> {
    let mut evaluator = Evaluator::new(plan);
    words.push(ticks);
    let mut readings: Vec<f64> = plan.inputs.iter().map(|input| input.low).collect();
    let ticks = (0..ticks).map(|_| {
        let dt = trials.dt(random);
        for (reading, input) in readings.iter_mut().zip(&plan.inputs) {
            if !random.chance(3) {
                *reading = trials.reading(input, random);
            }
        }
        words.push(dt);
        words.extend(readings.iter().map(|reading| reading.to_bits()));
        let told: Vec<_> = readings.iter().map(|&value| Reading { value, healthy: true }).collect();
        evaluator.evaluate(&told, dt);
        let strengths = |event: &plan::Event| [event.contributor, event.detractor].map(|real| evaluator.real(real));
        let events = plan.events.iter().map(|event| {
            let [contributor, detractor] = strengths(event).map(bits);
            format!(" {} {contributor} {detractor}", evaluator.bool(event.flag))
        });
        let outputs = plan
            .outputs
            .iter()
            .map(|output| format!(" {} {}", evaluator.bool(output.fired), bits(evaluator.real(output.value))));
        let is_close = plan.events.iter().any(|event| is_close(&plan.code, strengths(event)));
        let is_weak = |output: &plan::Output| output.strengths.iter().all(|&strength| evaluator.real(strength) < 0.05);
        let is_close = is_close || plan.outputs.iter().any(is_weak);
        Tick { line: events.chain(outputs).collect(), is_close, dwell: None }
    });
    ticks.collect()
}

struct Log<'p>(&'p Plan, String);

impl Actuators for Log<'_> {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        let action = &self.0.actions[action as usize];
        write!(self.1, " {}", action.name).unwrap();
        for &argument in arguments {
            write!(self.1, " {}", bits(argument)).unwrap();
        }
        if action.reports_done {
            write!(self.1, " {start}").unwrap();
        }
    }
}

/// Words for a machine, and what the interpreter does with them.
pub fn expect_of_machine(
    plan: &Plan,
    trials: &Trials,
    ticks: u64,
    random: &mut Random,
    words: &mut Vec<u64>,
) -> Vec<Tick> {
    let mut machine = Machine::new(plan, 7);
    words.push(ticks);
    let mut readings: Vec<_> = plan.inputs.iter().map(|input| Reading { value: input.low, healthy: true }).collect();
    let ticks = (0..ticks).map(|_| {
        let (dt, done) = (trials.dt(random), random.chance(5));
        for (reading, input) in readings.iter_mut().zip(&plan.inputs) {
            if random.chance(3) {
                reading.value = trials.reading(input, random);
                reading.healthy = !random.chance(6);
            }
        }
        words.extend([dt, u64::from(done)]);
        words.extend(readings.iter().map(|reading| reading.value.to_bits()));
        words.extend(readings.iter().map(|reading| u64::from(!reading.healthy)));
        let mut log = Log(plan, String::new());
        machine.step(Inputs { readings: &readings, done }, dt, &mut log);
        let mode = &plan.modes[machine.mode() as usize].name;
        let strengths = |event: &plan::Event| [event.contributor, event.detractor].map(|real| machine.real(real));
        let is_close = plan.events.iter().any(|event| is_close(&plan.code, strengths(event)));
        Tick { line: format!("{mode}{}", log.1), is_close, dwell: Some(machine.dwell()) }
    });
    ticks.collect()
}

/// Whether two lines say the same, numbers with some tolerance.
pub fn says_the_same(one: &str, other: &str, tolerance: f64) -> bool {
    let number =
        |word: &str| word.strip_prefix("0x").map(|bits| f64::from_bits(u64::from_str_radix(bits, 16).unwrap()));
    let same = |(one, other): (&str, &str)| match (number(one), number(other)) {
        (Some(one), Some(other)) => (one - other).abs() <= tolerance,
        _ => one == other,
    };
    one.split(' ').count() == other.split(' ').count() && one.split(' ').zip(other.split(' ')).all(same)
}
