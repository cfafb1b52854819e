//! Diagrams that run inside the modes of others.

use std::collections::BTreeSet;
use std::fmt::Write;

use lmslc::base::Span;
use lmslc::diag::rules;
use lmslc::driver::Analysis;
use lmslc::interp::{Actuators, Inputs, Machine, Reading, Taken};
use lmslc::plan::{self, Plan};

use crate::emit_programs::Random;
use crate::support::{analyze_texts, clean, doubts, report};

const MILLISECOND: u64 = 1_000_000;

const ROBOT: &str = "
    robot cart {
        sensor x: 1 in 0 .. 10 fails 0
        optional sensor y: 1 in 0 .. 10 fails 0
        action say(word: 1)
        action turn(angle: rad) -> done
    }
    ";

/// The plan of a diagram of that name.
fn plan(analysis: &Analysis, name: &str) -> Plan {
    let (id, _) = analysis.program.diagrams.iter().find(|(_, diagram)| diagram.symbol.name == name).unwrap();
    plan::build_alone(analysis.checked().unwrap(), id, &[])
}

#[derive(Default)]
struct Heard(Vec<String>);

impl Actuators for Heard {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        let start = if start { "!" } else { "" };
        self.0.push(format!("{}{start}", arguments.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")));
        assert!(action < 2);
    }
}

/// A machine that is told `x` and `y`, and answers with its place and what it commands.
struct Told<'p>(Machine<'p>);

impl Told<'_> {
    fn tick(&mut self, x: f64, y: f64, done: bool) -> String {
        let readings = [x, y].map(|value| Reading { value, healthy: true });
        let mut heard = Heard::default();
        self.0.step(Inputs { readings: &readings, done }, 10 * MILLISECOND, &mut heard);
        format!("{}: {}", self.0.place(), heard.0.join(", "))
    }
}

const LAYERS: &str = "
    behavior inner on cart {
        entry a
        mode a {
            say(1)
            on enter { say(11) }
            on exit { say(12) }
            1: x > 5 -> b
        }
        mode b {
            say(2)
            on enter { say(21) }
            on exit { say(22) }
            1: after 30 ms -> c
        }
        final mode c { say(3) }
    }
    behavior rest on cart {
        entry r
        mode r {
            say(9)
            1: x > 9 -> again
        }
    }
    activity middle on cart {
        entry m
        mode m = inner {
            on enter { say(101) }
            on exit { say(102) }
            1: y > 5          -> n
            2: m.mode is c    -> n
        }
        mode n = rest { 1: y < 1 -> m }
    }
    goal outer on cart {
        entry o
        mode o = middle resume {
            on exit { say(1002) }
            1: y > 8                       -> p
            2: o.m.mode is b and after 1 s -> p
        }
        mode p = rest { 1: y < 8 -> o }
    }
    ";

fn layers() -> Analysis {
    let analysis = analyze_texts(&[("layers.msd", &format!("{ROBOT}{LAYERS}"))]);
    assert!(analysis.checked().is_some(), "{}", report(&analysis));
    analysis
}

#[test]
fn outer_layers_choose_first_and_what_they_leave_is_dropped() {
    let analysis = layers();
    let plan = plan(&analysis, "middle");
    let mut machine = Told(Machine::new(&plan, 1));
    assert_eq!(machine.tick(0.0, 0.0, false), "m.a: 101!, 11!, 1!");
    assert_eq!(machine.tick(0.0, 0.0, false), "m.a: 1");
    assert_eq!(machine.tick(6.0, 0.0, false), "m.b: 12!, 21!, 2!");
    // Both layers would: the outer one does. The last commands are the innermost first.
    assert_eq!(machine.tick(6.0, 6.0, false), "n.r: 22!, 102!, 9!");
    assert_eq!(machine.0.taken(), Taken::Transition(0));
    // It starts anew, though `x` asks for `b` at once: one transition for all layers on a tick.
    assert_eq!(machine.tick(6.0, 0.0, false), "m.a: 101!, 11!, 1!");
    assert_eq!(machine.tick(6.0, 0.0, false), "m.b: 12!, 21!, 2!");
    // The timer of `b` is its own.
    assert_eq!(machine.tick(0.0, 0.0, false), "m.b: 2");
    assert_eq!(machine.tick(0.0, 0.0, false), "m.b: 2");
    assert_eq!(machine.tick(0.0, 0.0, false), "m.c: 22!, 3!");
    // What an outer layer sees is where the inner one was at the end of the tick before.
    assert_eq!(machine.tick(0.0, 0.0, false), "n.r: 102!, 9!");
}

#[test]
fn what_is_resumed_enters_the_mode_in_which_it_was() {
    let analysis = layers();
    let plan = plan(&analysis, "outer");
    let mut machine = Told(Machine::new(&plan, 1));
    assert_eq!(machine.tick(6.0, 0.0, false), "o.m.a: 101!, 11!, 1!");
    assert_eq!(machine.tick(6.0, 0.0, false), "o.m.b: 12!, 21!, 2!");
    assert_eq!(machine.tick(6.0, 0.0, false), "o.m.b: 2");
    assert_eq!(machine.tick(6.0, 9.0, false), "p.r: 22!, 102!, 1002!, 9!");
    // The activity is resumed and what it runs begins anew, as `m` does not resume it; `y` asks for `n` in vain.
    assert_eq!(machine.tick(6.0, 6.0, false), "o.m.a: 101!, 11!, 1!");
    assert_eq!(machine.tick(6.0, 6.0, false), "o.n.r: 12!, 102!, 9!");
    assert_eq!(machine.tick(6.0, 9.0, false), "p.r: 1002!, 9!");
    assert_eq!(machine.tick(6.0, 0.0, false), "o.n.r: 9!");
}

#[test]
fn a_goal_sees_two_layers_in() {
    let analysis = layers();
    let plan = plan(&analysis, "outer");
    let mut machine = Told(Machine::new(&plan, 1));
    for _ in 0..99 {
        assert!(machine.tick(0.0, 0.0, false).starts_with("o.m.a"));
    }
    assert!(machine.tick(6.0, 0.0, false).starts_with("o.m.b"));
    assert!(machine.tick(6.0, 0.0, false).starts_with("p.r"));
}

#[test]
fn a_mode_is_done_when_what_runs_inside_is_in_a_final_mode() {
    let text = format!(
        "{ROBOT}
        behavior once on cart {{
            entry a
            mode a {{
                turn(1 rad)
                1: done -> b
            }}
            final mode b {{ say(2) }}
        }}
        activity twice on cart {{
            entry first
            mode first = once {{ 1: done -> second }}
            mode second = once {{ 1: done -> third }}
            final mode third = once
        }}"
    );
    let analysis = clean("done.msd", &text);
    let plan = plan(&analysis, "twice");
    let mut machine = Told(Machine::new(&plan, 1));
    let places = [false, true, false, true, false, false].map(|done| machine.tick(0.0, 0.0, done));
    let expected = ["first.a: 1!", "first.b: 2!", "second.a: 1!", "second.b: 2!", "third.a: 1!", "third.a: 1"];
    assert_eq!(places, expected);
}

/// Two behaviors, an activity that runs them and a goal that runs that, with conditions over the same two sensors.
fn random_layers(seed: u64) -> String {
    let mut random = Random(seed);
    let mut text = ROBOT.to_owned();
    let condition = |random: &mut Random, inner: u64| {
        let one = |random: &mut Random| match random.below(7) {
            0 => format!("after {} ms", 30 * (1 + random.below(4))),
            1 if inner > 0 => format!("m{}.mode is m{}", random.below(2), random.below(inner)),
            _ => {
                let (sensor, operator) = (random.one_of(&["x", "y"]), random.one_of(&["<", ">"]));
                format!("{sensor} {operator} {}", 1 + random.below(9))
            }
        };
        let first = one(random);
        match random.below(3) {
            0 => format!("{first} and {}", one(random)),
            1 => format!("not {first}"),
            _ => first,
        }
    };
    for name in ["b0", "b1"] {
        writeln!(text, "behavior {name} on cart {{\n    entry m0").unwrap();
        for mode in 0..3 {
            writeln!(text, "    mode m{mode} {{\n        say({mode})").unwrap();
            for priority in 1..=2 {
                let target = (mode + priority) % 3;
                writeln!(text, "        {priority}: {} -> m{target}", condition(&mut random, 0)).unwrap();
            }
            text += "    }\n";
        }
        text += "}\n";
    }
    let resume = random.one_of(&["", " resume"]);
    writeln!(text, "activity t on cart {{\n    entry m0").unwrap();
    for mode in 0..2 {
        let inner = random.below(2);
        let requires = if mode == 1 { random.one_of(&["", " requires y else m0"]) } else { "" };
        writeln!(text, "    mode m{mode} = b{inner}{resume}{requires} {{").unwrap();
        for priority in 1..=1 + random.below(2) {
            writeln!(text, "        {priority}: {} -> m{}", condition(&mut random, 3), 1 - mode).unwrap();
        }
        text += "    }\n";
    }
    text += "}\n";
    let (around, inside) = (condition(&mut random, 2), condition(&mut random, 2));
    let goal = format!("mode m0 = t{resume} {{ 1: {around} -> m1 }}\n mode m1 = b0 {{ 1: {inside} -> m0 }}");
    text + &format!("goal g on cart {{\n entry m0\n {goal}\n}}\n")
}

/// The transitions that are said to be forestalled: where the outer mode names what it runs, and where they stand.
fn forestalled(analysis: &Analysis) -> BTreeSet<(Span, Span)> {
    let found = analysis.findings.iter().filter(|finding| finding.rule == &rules::PREEMPTED);
    found.map(|finding| (finding.labels[0].span, finding.labels[1].span)).collect()
}

/// The transitions that a machine takes when it is told anything at all: for one inside a mode also that mode.
fn drive(plan: &Plan, seed: u64) -> BTreeSet<(Option<usize>, Span)> {
    let (mut random, mut machine, mut taken) = (Random(seed), Machine::new(plan, 1), BTreeSet::new());
    let mut readings = [0.0; 2].map(|value| Reading { value, healthy: true });
    for _ in 0..6_000 {
        for reading in &mut readings {
            if random.chance(2) {
                reading.value = random.below(11) as f64 * 0.999 + 0.005;
                reading.healthy = random.below(8) > 0;
            }
        }
        let dt = random.one_of(&[10, 10, 5, 3]) * MILLISECOND;
        machine.step(Inputs { readings: &readings, done: false }, dt, &mut Heard::default());
        let exit = |machine: &Machine<'_>| match machine.taken() {
            Taken::Transition(index) => Some(machine.plan().transitions[index as usize].span),
            _ => None,
        };
        taken.extend(exit(&machine).map(|span| (None, span)));
        let insides = std::iter::successors(machine.inner(), |inside| inside.inner());
        taken.extend(insides.filter_map(exit).map(|span| (Some(machine.mode() as usize), span)));
    }
    taken
}

#[test]
fn what_is_forestalled_is_never_taken_and_the_rest_is() {
    let (mut forestalled_count, mut taken_count, mut missing) = (0, 0, Vec::new());
    for seed in 0..100 {
        let text = random_layers(seed);
        let analysis = analyze_texts(&[("t.msd", &text)]);
        let told = forestalled(&analysis);
        let program = &analysis.program;
        for name in ["t", "g"] {
            let outer = program.diagrams.values().find(|diagram| diagram.symbol.name == name).unwrap();
            let runs: Vec<_> = outer.modes.values().map(|mode| mode.runs.unwrap()).collect();
            let of_outer = drive(&plan(&analysis, name), seed + 1000);
            let taken: BTreeSet<_> =
                of_outer.into_iter().filter_map(|(mode, exit)| Some((runs[mode?].span, exit))).collect();
            let wrong: Vec<_> = told.intersection(&taken).collect();
            assert!(wrong.is_empty(), "{seed}: {wrong:?}\n{text}{}", report(&analysis));
            taken_count += taken.len();
            for run in runs.iter().filter(|run| taken.iter().any(|(outer, _)| *outer == run.span)) {
                let name = &program.diagrams[run.diagram].symbol.name;
                let alone = drive(&plan(&analysis, name), seed + 2000).into_iter().map(|(_, exit)| (run.span, exit));
                missing.extend(alone.filter(|exit| !taken.contains(exit) && !told.contains(exit)));
            }
        }
        forestalled_count += told.len();
    }
    assert!(forestalled_count > 200 && taken_count > 800, "{forestalled_count} {taken_count}");
    // What is taken alone, and neither taken nor forestalled inside, is rare, or in a mode that nothing leads to then.
    assert!(missing.len() < taken_count / 8, "{} of {taken_count}", missing.len());
}

#[test]
fn properties_over_layers_are_proved_or_shown() {
    let text = format!(
        "{ROBOT}{LAYERS}
        property apart of outer: never o.m.mode is b and p
        property soon of middle: never m.mode is b and y > 9
        property ends of middle: never n and y < 1
        "
    );
    let analysis = analyze_texts(&[("layers.msd", &text)]);
    let refuted: Vec<_> = analysis.findings.iter().filter(|finding| finding.rule == &rules::PROPERTY_REFUTED).collect();
    let names: Vec<_> = refuted.iter().map(|finding| analysis.sources.slice(finding.span())).collect();
    assert_eq!((analysis.proved, names.len()), (2, 1), "{}", report(&analysis));
    assert!(report(&analysis).contains("ends"), "{}", report(&analysis));
}

#[test]
fn what_cannot_run_inside_is_told() {
    let text = format!(
        "{ROBOT}
        interface other {{ action fly() }}
        behavior bird on other {{
            entry up
            final mode up {{ fly() }}
        }}
        behavior still on cart {{
            entry s
            final mode s {{ say(1) }}
        }}
        activity one on cart {{
            entry a
            mode a = bird {{ 1: x > 1 -> b }}
            mode b = still {{ 1: b.mode is t or c.mode is s or a.b.mode is s -> a }}
            mode c {{ 1: x > 1 -> a }}
            mode d = one {{ 1: x > 1 -> a }}
            mode e = still {{
                say(2)
                1: e.s.mode is s -> a
            }}
        }}
        behavior two on cart extends one {{ }}
        "
    );
    let analysis = analyze_texts(&[("wrong.msd", &text)]);
    insta::assert_snapshot!(report(&analysis));
    assert!(doubts(&analysis).len() > 6);
}
