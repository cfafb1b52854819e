//! `x is term`: at every reading one term, that of the highest degree, the first of those that are equal.

use lmslc::base::Id;
use lmslc::interp::{Actuators, Inputs, Machine, Reading};
use lmslc::plan::{self, Plan, Step};

use crate::emit::only_lowered;
use crate::emit_programs::Random;
use crate::support::report;

struct Silent;

impl Actuators for Silent {
    fn command(&mut self, _action: u32, _arguments: &[f64], _start: bool) {}
}

/// A behavior with a flag `x is t` for each term, and an event whose contributor is the degree of `t`.
fn build(terms: &[String], low: &str, high: &str) -> Plan {
    let named = |(place, shape): (usize, &String)| format!("t{place} = {shape}\n");
    let declared: String = terms.iter().enumerate().map(named).collect();
    let other = |place| (place + 1) % terms.len();
    let event = |place| format!("event e{place} {{ contributor (t{place}) detractor (t{}) }}\n", other(place));
    let events: String = (0..terms.len()).map(event).collect();
    let fusion = format!("variable v: 1 in 0 .. 10 {{\n{declared}}}\nnetwork n(i: v) {{\n{events}}}");
    let flag = |place| format!("flag is{place} = x is t{place}\n");
    let flags: String = (0..terms.len()).map(flag).collect();
    let modes = format!(
        "import n\nrobot r {{ sensor x: 1 in {low} .. {high} fails 3  action halt() }}
        behavior b on r {{ sense n(x)\n{flags}\nentry go\nmode go {{ halt()  1: is0 -> again }} }}"
    );
    let analysis = only_lowered(&fusion, &modes);
    let checked = analysis.checked().unwrap_or_else(|| panic!("{}", report(&analysis)));
    plan::build(checked, Id::new(0), Id::new(0), &[])
}

/// The terms that a reading is, and the degree of every term.
fn at(plan: &Plan, x: f64) -> (Vec<usize>, Vec<f64>) {
    let mut machine = Machine::new(plan, 1);
    machine.step(Inputs { readings: &[Reading { value: x, healthy: true }], done: false }, 0, &mut Silent);
    let flags = plan.flags.iter().enumerate().filter(|(_, flag)| machine.bool(flag.value));
    let degrees = plan.events.iter().map(|event| machine.real(event.contributor));
    (flags.map(|(place, _)| place).collect(), degrees.collect())
}

#[test]
fn a_tie_goes_to_the_first_term() {
    let plan = build(&["ramp(6, 4)".to_owned(), "ramp(4, 6)".to_owned()], "0", "10");
    assert_eq!(at(&plan, 5.0), (vec![0], vec![0.5, 0.5]));
    assert_eq!(at(&plan, 5.0_f64.next_up()).0, [1]);
    let plan = build(&["ramp(4, 6)".to_owned(), "ramp(6, 4)".to_owned()], "0", "10");
    assert_eq!([at(&plan, 5.0).0, at(&plan, 5.0_f64.next_down()).0], [[0], [1]]);
    // Where no term holds, the first one does.
    let plan = build(&["triangle(2, 3, 4)".to_owned(), "triangle(6, 7, 8)".to_owned()], "0", "10");
    assert_eq!([at(&plan, 5.0).0, at(&plan, 6.0).0, at(&plan, 7.0).0, at(&plan, 9.0).0], [[0], [0], [1], [0]]);
}

/// The first two cross where 1 - x / 3 = x / 7, at 21 / 10; no number in between is nearer.
#[test]
fn thresholds_are_exact() {
    let plan = build(&["ramp(3, 0)".to_owned(), "ramp(0, 7)".to_owned()], "0", "10");
    let crossing = 2.1;
    assert_eq!([at(&plan, crossing).0, at(&plan, f64::next_up(crossing)).0], [[0], [1]]);
}

#[test]
fn every_reading_is_the_one_term_of_the_highest_degree() {
    let (mut several, mut readings) = (0, 0);
    for seed in 0..150 {
        let mut random = Random(seed);
        let terms: Vec<_> = (0..2 + random.below(4)).map(|place| random.shape(place, false)).collect();
        let (low, high) = random.one_of(&[("0", "10"), ("2.5", "7"), ("-3", "12")]);
        let plan = build(&terms, low, high);
        let (low, high) = (plan.inputs[0].low, plan.inputs[0].high);
        let constants = plan.code.steps.iter().filter_map(|step| match step {
            Step::Constant { value, .. } => Some(*value),
            _ => None,
        });
        let quarters = (0..=60).map(|quarter| f64::from(quarter) / 4.0 - 3.0);
        let near = constants.chain(quarters).flat_map(|at| [at, at.next_up(), at.next_down(), at + 0.1]);
        let near: Vec<_> = near.filter(|at| low <= *at && *at <= high).collect();
        let mut chosen = std::collections::BTreeSet::new();
        for x in near {
            let (is, degrees) = at(&plan, x);
            let [term] = is[..] else { panic!("{x} is {is:?} of {terms:?}") };
            let most = degrees.iter().copied().fold(0.0, f64::max);
            // Degrees are quotients of quarters; their rounding is far below.
            assert!(degrees[term] >= most - 1e-12, "{x} is {term}, {degrees:?} of {terms:?}");
            let is_exact = (x * 4.0).fract() == 0.0 && degrees.iter().all(|degree| degree.fract() == 0.0);
            let first = degrees.iter().position(|degree| *degree == most);
            assert!(!is_exact || first == Some(term), "{x} is {term}, {degrees:?} of {terms:?}");
            chosen.insert(term);
            readings += 1;
        }
        several += usize::from(chosen.len() > 1);
    }
    assert!(several > 120 && readings > 10_000, "{several} {readings}");
}
