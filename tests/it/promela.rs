//! The model for Spin: what our own exploration calls live is what Spin executes.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use lmslc::analysis::modes::{Machine, fault_table, machine};
use lmslc::base::Id;
use lmslc::driver::{Analysis, Options, analyze};
use lmslc::ir::Diagram;
use lmslc::view;

use crate::random_modes::{CART, FUSION, Random};
use crate::support::{Repository, analyze_path, analyze_texts, fences, files_below, report, root};

/// Answers whether Spin and a C compiler are there, and says so if not.
fn has_spin() -> bool {
    let missing = ["spin", "cc"].into_iter().find(|tool| Command::new(tool).arg("--version").output().is_err());
    if let Some(tool) = missing {
        eprintln!("skipped: `{tool}` is not installed");
    }
    missing.is_none()
}

fn run(folder: &Path, program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).current_dir(folder).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{program}: {text}{}", String::from_utf8_lossy(&output.stderr));
    text
}

/// What Spin reports of a model.
fn explore(model: &str, flags: &[&str]) -> String {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("model.pml"), model).unwrap();
    run(folder.path(), "spin", &["-a", "-o3", "model.pml"]);
    run(folder.path(), "cc", &["-O0", "-w", "-o", "pan", "pan.c"]);
    let report = run(folder.path(), "./pan", &[&["-m1000000"], flags].concat());
    assert!(!report.contains("max search depth too small"), "{report}");
    report
}

/// For each labelled statement of a model, in order, whether Spin executes it.
fn executed(model: &str) -> Vec<bool> {
    assert!(model.lines().count() < 1 << 15, "Spin counts lines in 16 bits");
    let report = explore(model, &[]);
    assert!(report.contains("errors: 0"), "{report}");
    let missed = report.lines().filter_map(|line| line.trim().strip_prefix("model.pml:"));
    let missed: BTreeSet<usize> = missed.map(|line| line.split(',').next().unwrap().parse().unwrap()).collect();
    let is_labelled = |line: &str| {
        let labelled = line.split_once("-> ").and_then(|(_, statement)| statement.split_once(": mode = "));
        labelled.is_some_and(|(label, _)| !label.contains(' '))
    };
    model.lines().zip(1..).filter(|(line, _)| is_labelled(line)).map(|(_, line)| !missed.contains(&line)).collect()
}

/// Holds Spin against the fault tables of all diagrams but those with too many cases; answers how many exits are dead,
/// and how many live.
fn agree(analysis: &Analysis, up_to: usize) -> [usize; 2] {
    assert!(!analysis.has_errors(), "{}", report(analysis));
    let program = &analysis.program;
    let machines: Vec<Machine> = program.diagrams.ids().filter_map(|id| machine(program, id, up_to).ok()).collect();
    assert!(machines.len() + 2 >= program.diagrams.len(), "{} of {} left", machines.len(), program.diagrams.len());
    let executed = executed(&view::promela(program, &analysis.sources, &machines).unwrap());
    let mut statements = executed.iter();
    let mut counts = [0; 2];
    for machine in &machines {
        let diagram = &program.diagrams[machine.diagram];
        let table = fault_table(program, machine.diagram, up_to);
        for (mode, transition) in
            diagram.modes.iter().flat_map(|(id, mode)| (0..mode.transitions.len()).map(move |index| (id, index)))
        {
            for facts in &table {
                let known = &facts.modes[mode.index()];
                let is_live = known.reachable && known.exits[transition].is_some();
                let names = (&diagram.symbol.name, &diagram.modes[mode].symbol.name);
                assert_eq!(statements.next(), Some(&is_live), "{names:?} {transition} {:?}", facts.faults);
                counts[usize::from(is_live)] += 1;
            }
        }
    }
    assert!(statements.next().is_none());
    counts
}

#[test]
fn spin_executes_what_is_live_in_the_library_and_the_examples() {
    if !has_spin() {
        return;
    }
    let files = [files_below("stdlib", &["msd"]), files_below("examples", &["msd"])].concat();
    let analysis = analyze(&Repository, &files, &Options::default());
    let [dead, live] = agree(&analysis, 2);
    assert!(dead > 50 && live > 150, "{dead} dead, {live} live");
}

#[test]
fn spin_executes_what_is_live_in_random_diagrams() {
    if !has_spin() {
        return;
    }
    let mut random = Random { state: 2007, recalls: true };
    let mut analysis = |cart: &str, count: usize| {
        let behaviors: String = (0..count).map(|index| random.behavior(&format!("b{index}"))).collect();
        analyze_texts(&[("b.msd", &format!("{cart}{behaviors}")), ("n.fsfn", FUSION)])
    };
    let [mut dead, mut live] = [0; 2];
    for _ in 0..4 {
        let [no, yes] = agree(&analysis(CART, 10), 2);
        dead += no;
        live += yes;
    }
    assert!(dead > 1000 && live > 1000, "{dead} dead, {live} live");
    agree(&analysis(&CART.replace("fails 3", "fails any").replace("fails 7", "fails 7, absent"), 4), 1);
}

fn obstacle_manipulation(up_to: usize) -> String {
    let analysis = analyze_path("stdlib/behaviors/obstacle_manipulation.msd");
    let is_it = |id: &Id<Diagram>| analysis.program.diagrams[*id].symbol.name == "obstacle_manipulation";
    let id = analysis.program.diagrams.ids().find(is_it).unwrap();
    let machine = machine(&analysis.program, id, up_to).unwrap();
    view::promela(&analysis.program, &analysis.sources, &[machine]).unwrap()
}

#[test]
fn spin_says_what_the_page_on_it_shows() {
    if !has_spin() {
        return;
    }
    let page = std::fs::read_to_string(root().join("docs/spin.md")).unwrap();
    let fences = fences(&page);
    let shown = fences.iter().find(|fence| fence.text.starts_with("unreached")).unwrap();
    let report = explore(&obstacle_manipulation(0), &[]);
    assert!(report.contains(&shown.text), "{report}");
    let property = fences.iter().find(|fence| fence.text.starts_with("ltl")).unwrap();
    let report = explore(&(obstacle_manipulation(1) + &property.text), &["-a"]);
    assert!(report.contains("errors: 1"), "{report}");
}

#[test]
fn the_model_of_a_diagram_can_be_read() {
    insta::assert_snapshot!(obstacle_manipulation(0));
}

#[test]
fn everything_that_a_condition_looks_at_is_in_the_model() {
    let analysis = analyze_texts(&[
        (
            "b.msd",
            "import n
             robot cart {
                 sensor x: 1 in 0 .. 10 fails 3
                 optional sensor y: 1 in 0 .. 10 fails absent
                 action turn(angle: rad) -> done
             }
             behavior b on cart {
                 sense n(x, y)
                 flag near = x > 0.0000001 and y < 0.0000002
                 entry run
                 mode init requires y else run {
                     turn(1 rad)
                     1: near and (done or not after 2 s) -> run
                     2: near and count(some) > 1 -> again
                     3: falling(near) or held(y < 0.0000001, 1 s) -> run
                     4: latched(late) and after 5 s and x <= y // both */
                     -> run
                 }
                 mode run { turn(1 rad)  1: not failed(y) and rising(some) -> init  2: x != 5 -> init }
             }",
        ),
        ("n.fsfn", FUSION),
    ]);
    assert!(!analysis.has_errors(), "{}", report(&analysis));
    let machine = machine(&analysis.program, Id::new(0), 1).unwrap();
    insta::assert_snapshot!(view::promela(&analysis.program, &analysis.sources, &[machine]).unwrap());
}
