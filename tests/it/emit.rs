//! Emitted Rust does what the interpreter does, bit for bit, and keeps what is promised of it.

use std::collections::BTreeSet;
use std::convert::Infallible;
use std::path::Path;
use std::sync::LazyLock;

use lmslc::base::{Sources, Span};
use lmslc::driver::{Analysis, NotCompiled};
use lmslc::emit::{Float, LINTS, Options};
use lmslc::plan::{Code, Input};
use lmslc::sema;
use lmslc::syntax::{ast::FileKind, parse};

use crate::emit_harness::{
    Case, SINGLE, Tick, Trials, compile, expect_of_machine, expect_of_network, run, says_the_same, write_crate,
};
use crate::emit_programs::{Random, program};
use crate::support::{analyze_path, analyze_texts, clean, fences, files_below, root};

/// Every file of the library and the examples that something can be emitted of, and random programs.
static CASES: LazyLock<Vec<Case>> = LazyLock::new(|| cases(&Options::default(), 0..45));

fn cases(options: &Options, seeds: impl IntoIterator<Item = u64>) -> Vec<Case> {
    let files = [files_below("stdlib", &["msd", "fsfn"]), files_below("examples", &["msd", "fsfn"])].concat();
    let mut known = BTreeSet::new();
    // Scenarios apart, some files are of one behavior.
    let mut is_new = |case: &Case| known.insert(case.code.split_once('\n').unwrap().1.to_owned());
    let files = files.into_iter().flat_map(|path| {
        let analysis = analyze_path(&path);
        let robots: Vec<_> = match analysis.plans(None) {
            Err(NotCompiled::Ambiguous(_, robots)) => robots.into_iter().map(Some).collect(),
            _ => vec![None],
        };
        let options = robots.into_iter().map(|robot| Options { robot, ..options.clone() });
        let options = options.filter(|options| analysis.rust(options).is_ok());
        options.map(|options| Case::new(&path, &analysis, &options)).collect::<Vec<_>>()
    });
    let random = seeds.into_iter().map(|seed| {
        let (fusion, modes) = program(seed);
        Case::new(&format!("Random program {seed}."), &only_lowered(&fusion, &modes), options)
    });
    files.chain(random).filter(|case| is_new(case)).collect()
}

/// A `b.msd` that imports an `n.fsfn`, without the checks, which take their time where terms are smooth.
pub fn only_lowered(fusion: &str, modes: &str) -> Analysis {
    let mut sources = Sources::default();
    let [b, n] = [("b.msd", modes), ("n.fsfn", fusion)].map(|(path, text)| sources.add(path, text));
    let (modes, mut findings) = parse(b, FileKind::Modes, modes);
    let (fusion, faults) = parse(n, FileKind::Fusion, fusion);
    findings.extend(faults);
    let import = sema::Import { file: n, span: Span::new(b, 0, 8) };
    let unit = |file, tree, imports| sema::Unit { file, tree, imports, faults: Vec::new() };
    let units = vec![unit(b, modes, vec![import]), unit(n, fusion, Vec::new())];
    let sema::Lowered { program, diagnostics: lowering, uses } = sema::lower(&units, &sources);
    findings.extend(lowering);
    Analysis { roots: vec![b], sources, units, program, uses, findings, proved: 0, counterexamples: Vec::new() }
}

/// What is tried in each plan of some cases: the words that tell it to a process, and what the interpreter does.
struct Trial<'a> {
    words: Vec<u64>,
    expected: Vec<(&'a Case, Vec<Tick>)>,
}

impl<'a> Trial<'a> {
    fn new(cases: &'a [Case], trials: fn(&Code, &[Input]) -> Trials) -> Self {
        let (mut random, mut words, mut expected) = (Random(11), Vec::new(), Vec::new());
        for case in cases {
            for plan in &case.networks {
                let trials = trials(&plan.code, &plan.inputs);
                expected.push((case, expect_of_network(plan, &trials, 300, &mut random, &mut words)));
            }
            for plan in &case.diagrams {
                let trials = trials(&plan.code, &plan.inputs);
                expected.push((case, expect_of_machine(plan, &trials, 1500, &mut random, &mut words)));
            }
        }
        Self { words, expected }
    }

    /// Compiles the crate in a folder with some flags and runs it; what the interpreter does on every tick of a case, and
    /// what it answers.
    fn answers(&self, folder: &Path, flags: &[&str]) -> impl Iterator<Item = (&'a Case, Vec<(&Tick, String)>)> {
        let library = ["lib.rs", "--crate-type", "lib", "--crate-name", "emitted"];
        compile("rustc", folder, &[&library, flags].concat()).unwrap_or_else(|complaint| panic!("{complaint}"));
        let runner = ["main.rs", "--crate-name", "runner", "--extern", "emitted=libemitted.rlib"];
        compile("rustc", folder, &[&runner, flags].concat()).unwrap_or_else(|complaint| panic!("{complaint}"));
        let lines = run(&folder.join("runner"), &self.words);
        assert_eq!(
            lines.len(),
            self.expected.iter().map(|(_, ticks)| ticks.len()).sum::<usize>(),
            "a line for every tick"
        );
        let mut lines = lines.into_iter();
        self.expected.iter().map(move |(case, ticks)| (*case, ticks.iter().zip(lines.by_ref()).collect()))
    }
}

/// What the kernel has a name for.
fn kernel_functions() -> Vec<String> {
    let kernel = std::fs::read_to_string(root().join("src/kernel.rs")).unwrap();
    let functions = kernel.split("#[cfg(test)]").next().unwrap().split("\npub fn ").skip(1);
    functions.map(|rest| rest.split(['(', '<']).next().unwrap().to_owned()).collect()
}

/// Compares what emitted code does with what the interpreter does; how many ticks there were, how many of them different,
/// and how many in which a timer ran.
fn compare(cases: &[Case], flags: &[&str]) -> [usize; 3] {
    let folder = tempfile::tempdir().unwrap();
    write_crate(cases, folder.path());
    let trial = Trial::new(cases, Trials::critical);
    let (mut distinct, mut count, mut timed) = (BTreeSet::new(), 0, 0);
    for (case, ticks) in trial.answers(folder.path(), flags) {
        for (Tick { line, dwell, .. }, answer) in ticks {
            let (answer, state) = answer.split_once('|').unwrap_or((&answer, ""));
            assert_eq!(answer, *line, "{}\n{state}\n{}", case.title, case.code);
            count += 1;
            distinct.insert((&case.title, line));
            // What runs inside has a time of its own.
            if state.matches("Machine {").count() > 1 {
                continue;
            }
            // The time in the mode, not what a stopwatch says.
            let state = state.replace("running: true, elapsed", "").replace("running: false, elapsed", "");
            let elapsed = state.split_once("elapsed: ").map(|(_, rest)| rest.split([' ', ',']).next().unwrap());
            if let (Some(elapsed), &Some(dwell)) = (elapsed, dwell) {
                let elapsed: u64 = elapsed.parse().unwrap();
                let narrow = elapsed == u64::from(u32::MAX) && dwell > elapsed;
                assert!(narrow || elapsed == dwell, "{}: {state} after {dwell} ns", case.title);
                timed += 1;
            }
        }
    }
    [count, distinct.len(), timed]
}

#[test]
fn emitted_code_agrees_with_the_interpreter_to_the_last_bit() {
    assert!(CASES.len() >= 90, "{}", CASES.len());
    // Checked arithmetic would stop at an overflow.
    let [count, distinct, timed] = compare(&CASES, &["-Copt-level=0", "-Coverflow-checks=on", "-Cdebuginfo=0"]);
    // The programs do something: modes change, events set and clear, commands have arguments, timers run.
    assert!(count > 80_000 && distinct > 30_000 && timed > 10_000, "{count} {distinct} {timed}");
    // All of the kernel is used; slabs are written out as polynomials.
    let code = CASES.iter().map(|case| case.code.as_str()).collect::<Vec<_>>().concat();
    for name in kernel_functions().iter().filter(|name| *name != "slab") {
        assert!(code.contains(&format!("kernel::{name}")) || code.contains(&format!("fn {name}")), "{name}");
    }
}

#[test]
fn optimized_code_agrees_with_the_interpreter_to_the_last_bit() {
    // All files, and some random programs.
    let [count, distinct, timed] = compare(&CASES[..75], &["-Copt-level=3", "-Cdebuginfo=0"]);
    assert!(count > 50_000 && distinct > 15_000 && timed > 5_000, "{count} {distinct} {timed}");
}

#[test]
fn single_precision_agrees_but_for_rounding() {
    // Those of even numbers have no outputs, of which some jump.
    let cases = cases(&Options { float: Float::F32, ..Options::default() }, (0..50).step_by(4));
    let folder = tempfile::tempdir().unwrap();
    write_crate(&cases, folder.path());
    let (mut count, mut rounded) = (0, 0);
    let trial = Trial::new(&cases, Trials::single);
    for (case, ticks) in trial.answers(folder.path(), &["-Copt-level=0", "-Cdebuginfo=0"]) {
        // What rounding has decided once may be remembered.
        for (Tick { line, .. }, answer) in ticks.into_iter().take_while(|(tick, _)| !tick.is_close) {
            let (answer, _) = answer.split_once('|').unwrap_or((&answer, ""));
            assert!(says_the_same(answer, line, SINGLE), "{}\n{answer}\n{line}\n{}", case.title, case.code);
            rounded += u64::from(answer != line.as_str());
            count += 1;
        }
    }
    assert!(count > 10_000 && rounded > 1_000, "{rounded} of {count}");
}

#[test]
fn clippy_finds_nothing_but_what_is_named() {
    for name in LINTS.iter().flat_map(|(_, names)| *names) {
        assert!(CASES.iter().any(|case| case.code.contains(&format!("{name},"))), "{name} is not left out");
    }
    let folder = tempfile::tempdir().unwrap();
    write_crate(&CASES, folder.path());
    if std::process::Command::new("clippy-driver").arg("--version").output().is_ok() {
        let flags = ["lib.rs", "--crate-type", "lib", "--crate-name", "emitted", "--emit", "metadata"];
        compile("clippy-driver", folder.path(), &flags).unwrap_or_else(|complaint| panic!("{complaint}"));
    }
}

/// A program for the bare machine that runs cases on numbers nobody knows, and in which a panic is a function that
/// is not there. What smooth shapes call in `libm`, which is not ours, is imitated.
fn write_bare(cases: &[Case], folder: &Path) {
    let of_libm = ["exp(x: f64)", "pow(x: f64, _: f64)", "fabs(x: f64)", "cos(x: f64)", "sqrt(x: f64)"];
    let of_libm = of_libm.map(|name| format!("#[inline(never)] pub fn {name} -> f64 {{ core::hint::black_box(x) }}\n"));
    std::fs::write(folder.join("libm.rs"), format!("#![no_std]\n{}", of_libm.concat())).unwrap();
    write_crate(cases, folder);
    let mut text = "#![no_std]
        #![no_main]
        extern crate emitted;
        use core::{convert::Infallible, hint::black_box};
        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo) -> ! {
            unsafe extern \"C\" { safe fn this_code_can_panic() -> !; }
            this_code_can_panic()
        }
        fn any<T>() -> T { unsafe { black_box(core::mem::MaybeUninit::<T>::zeroed()).assume_init() } }\n"
        .to_owned();
    let mut calls = String::new();
    for (number, case) in cases.iter().enumerate() {
        for (index, driver) in case.bare_drivers(&format!("emitted::case_{number}")).into_iter().enumerate() {
            calls += &format!("case_{number}_{index}();\n");
            text += &format!("#[inline(never)] fn case_{number}_{index}() {{ {driver} }}\n");
        }
    }
    text += &format!(
        "#[unsafe(no_mangle)] pub extern \"C\" fn _start() -> ! {{
            #[cfg(deliberate)] black_box(1 / any::<u32>());
            {calls} loop {{ black_box(0); }}
        }}"
    );
    std::fs::write(folder.join("bare.rs"), text).unwrap();
}

#[test]
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn no_path_panics() {
    let folder = tempfile::tempdir().unwrap();
    // Random ones are large; one of them has an arbiter whose ties chance decides.
    let by_chance = CASES.iter().find(|case| case.code.contains("kernel::any_choice")).unwrap();
    write_bare(&[&CASES[..40], std::slice::from_ref(by_chance)].concat(), folder.path());
    for level in ["z", "3"] {
        let level = format!("-Copt-level={level}");
        let compile = |arguments: &[&str]| {
            let flags = [level.as_str(), "-Coverflow-checks=on", "-Cpanic=abort", "-Ccodegen-units=1"];
            compile("rustc", folder.path(), &[arguments, &flags].concat())
        };
        for [file, name] in [["libm.rs", "libm"], ["lib.rs", "emitted"]] {
            compile(&[file, "--crate-type=lib", "--crate-name", name])
                .unwrap_or_else(|complaint| panic!("{complaint}"));
        }
        let emitted = ["bare.rs", "--extern=emitted=libemitted.rlib", "-Ldependency=.", "-Aunused"];
        let program = [emitted.as_slice(), &["-Clink-arg=-nostartfiles", "-Clink-arg=-lc"]].concat();
        compile(&program).unwrap_or_else(|complaint| panic!("{complaint}"));
        // A division by what may be 0 is found.
        let complaint = compile(&[program.as_slice(), &["--cfg=deliberate"]].concat()).unwrap_err();
        assert!(complaint.contains("this_code_can_panic"), "{complaint}");
    }
}

/// Every name here is a keyword, is ours, or is another one in Rust's spelling.
const NAMES: (&str, &str) = (
    "variable type: 1 in 0 .. 10 { fn = ramp(6, 4)  Self = ramp(4, 6)  self = triangle(4, 5, 6) }
     network kernel(match: type, crate: type, left: type, left_fn: type) {
         event memory hysteresis 0.1 { contributor (fn, _, _, _) detractor (Self, _, _, _) }
         event Memory confirm 10 ms { contributor (self, self, fn, fn) detractor (_, _, Self, Self) }
         event left_fn { contributor (_, _, fn, -) (_, fn, Self, -) detractor (_, _, _, fn) }
         event dt_ns { contributor rule not match is fn and not crate is any of {fn, Self} }
     }
     network Outputs(memory: type, fn: type, output_s: type) {
         event move hold 10 ms { contributor (fn, _, _) }
         output Output: 1 in 0 .. 1 default hold { fn = triangle(0, 0, 1)  Self = triangle(0, 1, 1)  area = ramp(0, 1) }
         output memory: 1 default 1 = takagi_sugeno
         rule memory is fn and fn is self => Output is fn and memory = memory - 2 * output_s
         rule fn is fn => Output is Self
         rule output_s is Self => Output is area
     }",
    "import n
     robot Robot {
         sensor inputs: 1 in 0 .. 10
         sensor failed: 1 in 0 .. 10
         sensor done_: 1 in 0 .. 10
         sensor elapsed: 1 in 0 .. 10
         action loop(self: 1, start: 1, move: 1) -> done
         action step()
         action Step()
     }
     behavior super on Robot {
         sense state = kernel(inputs, failed, done_, elapsed)
         sense kernel(inputs, failed, elapsed, done_)
         sense Outputs(inputs, failed, elapsed)
         sense inputs = Outputs(failed, elapsed, done_)
         flag random = state.memory or kernel.dt_ns
         flag dt = elapsed > 3 and not rising(random)
         entry none
         mode none { loop(random(1, 2), random(1, 2), 3)  1: after 1 s and dt -> Self  2: latched(dt) -> None }
         mode Self { step()  1: after 10 s or held(dt, 1 s) or state.left_fn -> none }
         mode None { Step()  1: count(random) >= 2 -> None_ }
         mode None_ { loop(1, 2, 3)  1: kernel.Memory or done -> self }
         mode self { step()  1: failed(failed) -> speed }
         mode speed {
             loop(random(1, 2), Outputs.Output, inputs.memory)
             on exit { loop(inputs.Output, 1, 2) }
             1: Outputs.move -> self
             2: inputs.move -> none
         }
     }
     behavior idle on Robot {
         entry rest
         mode rest { decide (failed(inputs)) { (set) => nothing  (clear) => nothing } }
     }
     behavior Command on Robot { entry Proposal  mode Proposal { step() } }
     arbiter give on Robot {
         emergency elapsed > 9 -> Step()
         client seed = idle priority 1
         client next = Command priority 2 when inputs > 5 else 3
         client state = Command priority 4
     }
     arbiter nothing_asked on Robot { client levels = idle priority 1 }",
);

#[test]
fn any_name_any_float_and_serde_compile() {
    let folder = tempfile::tempdir().unwrap();
    let f32s = Options { float: Float::F32, ..Options::default() };
    let serde = Options { serde: Some("state".to_owned()), ..Options::default() };
    let names = analyze_texts(&[("b.msd", NAMES.1), ("n.fsfn", NAMES.0)]);
    let random = (0..8).map(program).collect::<Vec<_>>();
    let random = random.iter().map(|(fusion, modes)| only_lowered(fusion, modes));
    let analyses: Vec<_> = random.chain([names, analyze_path("stdlib/behaviors/obstacle_manipulation.msd")]).collect();
    let mut library =
        "//! Emitted.\n#![no_std]\n#![forbid(unsafe_code)]\n#![deny(warnings, missing_docs)]\n".to_owned();
    for (number, analysis) in analyses.iter().enumerate() {
        for (kind, options) in [("plain", &Options::default()), ("single", &f32s), ("saved", &serde)] {
            let code = analysis.rust(options).unwrap_or_else(|_| panic!("{}", crate::support::report(analysis)));
            assert!(kind != "single" || !code.contains("f64"), "{code}");
            assert_eq!(kind == "saved", code.contains("feature = \"state\""));
            std::fs::write(folder.path().join(format!("{kind}_{number}.rs")), code).unwrap();
            library += &format!("/// {kind}\npub mod {kind}_{number};\n");
        }
    }
    std::fs::write(folder.path().join("lib.rs"), library).unwrap();
    // The real one needs no more of the code than these do: that its derives may stand where they stand.
    let serde = "use proc_macro::TokenStream;
        #[proc_macro_derive(Serialize)] pub fn serialize(_: TokenStream) -> TokenStream { TokenStream::new() }
        #[proc_macro_derive(Deserialize)] pub fn deserialize(_: TokenStream) -> TokenStream { TokenStream::new() }";
    std::fs::write(folder.path().join("serde.rs"), format!("extern crate proc_macro; {serde}")).unwrap();
    let compile = |flags: &[&str]| compile("rustc", folder.path(), flags).unwrap_or_else(|text| panic!("{text}"));
    compile(&["serde.rs", "--crate-type", "proc-macro", "--crate-name", "serde"]);
    let features = ["--check-cfg=cfg(feature, values(\"state\"))", "--cfg=feature=\"state\""];
    let library = ["lib.rs", "--crate-type", "lib", "--extern", "serde=libserde.so", "--emit", "metadata"];
    for edition in ["2021", "2024"] {
        compile(&[library.as_slice(), &features, &["--edition", edition]].concat());
    }
}

#[test]
fn code_tells_nothing_of_the_machine_and_is_the_same_every_time() {
    let texts = [("/home/me/robots/b.msd", NAMES.1), ("/home/me/robots/n.fsfn", NAMES.0)];
    let code = analyze_texts(&texts).rust(&Options::default()).unwrap();
    assert!(code.starts_with(&format!("// @generated by lmslc {} from b.msd\n", env!("CARGO_PKG_VERSION"))), "{code}");
    assert!(!code.contains("/home") && code.contains("(b.msd:"), "{code}");
    for _ in 0..3 {
        assert_eq!(analyze_texts(&texts).rust(&Options::default()).unwrap(), code);
    }
}

/// With `UPDATE_EMITTED=1` the files are rewritten instead.
#[test]
fn emitted_files_are_what_is_emitted() {
    for (source, kept) in [
        ("stdlib/networks/obstacle_id.fsfn", "tests/emitted/obstacle_id.rs"),
        ("stdlib/behaviors/obstacle_manipulation.msd", "tests/emitted/obstacle_manipulation.rs"),
        ("stdlib/networks/navigator.fsfn", "tests/emitted/navigator.rs"),
        ("benches/emit/switching.msd", "benches/emit/switching.rs"),
    ] {
        let code = analyze_path(source).rust(&Options::default()).unwrap();
        if std::env::var("UPDATE_EMITTED").is_ok() {
            std::fs::write(root().join(kept), code).unwrap();
        } else {
            let now = std::fs::read_to_string(root().join(kept)).unwrap_or_default();
            assert!(now == code, "{kept} is out of date; UPDATE_EMITTED=1 cargo test rewrites it");
        }
    }
}

mod manipulation {
    include!("../emitted/obstacle_manipulation.rs");
}

use manipulation::obstacle_manipulation::{Failed, Inputs, Machine, Mode, Robot, State};

/// A robot that notes what it is asked for and cannot do one of it.
#[derive(Default)]
struct Broken {
    cannot: &'static str,
    asked: Vec<&'static str>,
}

impl Broken {
    fn ask(&mut self, action: &'static str) -> Result<(), &'static str> {
        self.asked.push(action);
        if action == self.cannot { Err(action) } else { Ok(()) }
    }
}

impl Robot for Broken {
    type Error = &'static str;

    fn halt(&mut self) -> Result<(), &'static str> {
        self.ask("halt")
    }

    fn drive(&mut self, _speed: f64) -> Result<(), &'static str> {
        self.ask("drive")
    }

    fn arc(&mut self, _speed: f64, _radius: f64) -> Result<(), &'static str> {
        self.ask("arc")
    }

    fn turn(&mut self, _angle: f64, _start: bool) -> Result<(), &'static str> {
        self.ask("turn")
    }
}

const QUIET: Inputs = Inputs {
    left_wheel_acceleration: 0.0,
    right_wheel_acceleration: 0.0,
    contact_force: 0.0,
    failed: Failed { left_wheel_acceleration: false, right_wheel_acceleration: false, contact_force: false },
    done: false,
};

#[test]
fn an_error_is_told_and_the_machine_goes_on() {
    let mut robot = Broken { cannot: "drive", ..Broken::default() };
    let mut machine = Machine::new(1);
    assert_eq!(machine.mode(), None);
    assert_eq!(machine.step(&QUIET, 0, &mut robot), Ok(Mode::Init));
    assert_eq!(machine.step(&QUIET, 2_000_000_000, &mut robot), Err("drive"));
    assert_eq!(machine.mode(), Some(Mode::Forward));
    assert_eq!(machine.step(&Inputs { contact_force: 115.0, ..QUIET }, 0, &mut robot), Ok(Mode::Push));
    assert_eq!(robot.asked, ["halt", "drive", "arc"]);
    assert_eq!(Mode::BackUp.name(), "back_up");
}

#[test]
fn every_command_of_a_tick_is_given_whatever_fails() {
    let text = "robot r { action a() action b() action c() action d() }
        behavior x on r {
            entry first
            mode first { a()  on exit { b() }  1: after 1 s -> second }
            final mode second { c()  on enter { d() } }
        }";
    let code = clean("x.msd", text).rust(&Options::default()).unwrap();
    let body = code.split("Some(State::First").nth(1).unwrap().split("Some(State").next().unwrap();
    assert!(body.contains("return robot.b().and(self.enter_second(robot));"), "{code}");
    assert!(code.contains("robot.d().and(robot.c())?;"), "{code}");
}

/// What a robot without errors need not unwrap.
struct Deaf;

impl Robot for Deaf {
    type Error = Infallible;

    fn halt(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn drive(&mut self, _speed: f64) -> Result<(), Infallible> {
        Ok(())
    }

    fn arc(&mut self, _speed: f64, _radius: f64) -> Result<(), Infallible> {
        Ok(())
    }

    fn turn(&mut self, _angle: f64, _start: bool) -> Result<(), Infallible> {
        Ok(())
    }
}

#[test]
fn a_state_is_small_and_a_copy_of_it_goes_on_alike() {
    assert_eq!((size_of::<Option<State>>(), size_of::<Machine>()), (16, 24));
    let mut machine = Machine::new(3);
    let mut tick = |machine: &mut Machine, done| {
        let Ok(mode) = machine.step(&Inputs { contact_force: 300.0, done, ..QUIET }, 500_000_000, &mut Deaf);
        mode
    };
    for _ in 0..10 {
        tick(&mut machine, false);
    }
    assert_eq!(machine.mode(), Some(Mode::RandomTurn));
    let mut copy = machine;
    let way = |machine: &mut Machine, tick: &mut dyn FnMut(&mut Machine, bool) -> Mode| {
        (0..50).map(|index| (tick(machine, index % 3 == 0), machine.state)).collect::<Vec<_>>()
    };
    assert_eq!(way(&mut machine, &mut tick), way(&mut copy, &mut tick));
    // Without random numbers and with short timers, 8 bytes do.
    let analysis = analyze_path("examples/j5/characterization.msd");
    let code = analysis.rust(&Options::default()).unwrap();
    assert!(code.contains("elapsed: u32") && code.contains("pub const fn new() -> Self"), "{code}");
}

#[test]
fn what_is_written_on_an_interface_is_compiled_for_a_robot_that_is_known() {
    let text = "interface base { sensor range: m in 0 m .. 9 m  action go() }
        behavior b on base { entry a  mode a { go()  1: range < 1 m -> again } }\n";
    let robot = |name: &str, fails| {
        format!("robot {name} provides base {{ sensor range: m in 0 m .. 5 m fails {fails} m  action go() }}\n")
    };
    let rust = |texts: &[&str], robot: Option<&str>| {
        let options = Options { robot: robot.map(str::to_owned), ..Options::default() };
        analyze_texts(&[("b.msd", &texts.concat())]).rust(&options)
    };
    let (one, two) = (robot("one", 1), robot("two", 2));
    assert!(rust(&[text], None).unwrap().contains("self.range, !self.failed.range, 0.0, 9.0, 0.0"));
    assert!(rust(&[text, &one], None).unwrap().contains("self.range, !self.failed.range, 0.0, 5.0, 1.0"));
    let both = [text, one.as_str(), two.as_str()];
    let names = vec!["one".to_owned(), "two".to_owned()];
    assert_eq!(rust(&both, None), Err(NotCompiled::Ambiguous("b".to_owned(), names)));
    assert!(rust(&both, Some("two")).unwrap().contains("self.range, !self.failed.range, 0.0, 5.0, 2.0"));
    assert_eq!(rust(&both, Some("three")), Err(NotCompiled::NotWrittenFor("b".to_owned())));
    assert_eq!(rust(&["robot r { action a() }"], None), Err(NotCompiled::Nothing));
    assert_eq!(rust(&["mode"], None), Err(NotCompiled::Errors));
}

/// The guide shows the files of the example, which `.ci/run` builds and runs.
#[test]
fn the_guide_shows_the_example() {
    let guide = std::fs::read_to_string(root().join("docs/embedding.md")).unwrap();
    let shown: Vec<_> = fences(&guide).into_iter().filter(|fence| fence.file.is_some()).collect();
    assert_eq!(shown.len(), 4);
    for fence in shown {
        let path = root().join("examples/embed").join(fence.file.unwrap());
        assert!(std::fs::read_to_string(&path).unwrap() == fence.text, "{} is shown otherwise", path.display());
    }
}
