//! Random diagrams with random properties: what was proved is broken by no run, what was refuted by the one that is
//! shown.

use lmslc::base::Id;
use lmslc::diag::rules;
use lmslc::driver::{Analysis, Options, analyze};
use lmslc::interp::{Inputs, Machine, Reading};
use lmslc::ir::{Claim, Property};
use lmslc::plan;
use lmslc::sim::{self, RunOptions};

use crate::random_modes::{CART, Deaf, FUSION, Random};
use crate::support::{Memory, report};

/// The longest tick, in nanoseconds, as the scenario says.
const TICK: u64 = 100_000_000;

impl Random {
    fn watched(&mut self) -> String {
        match self.below(3) {
            0 => self.atom(),
            1 => format!("m{}", self.below(4)),
            _ => {
                let word = self.one_of(&["and", "or", "and not"]);
                format!("m{} {word} ({})", self.below(4), self.atom())
            }
        }
    }

    fn property(&mut self) -> String {
        match self.below(3) {
            0 => format!("never {} and ({})", self.watched(), self.watched()),
            1 => format!("always {} or not ({})", self.watched(), self.watched()),
            _ => {
                let time = 300 * (1 + self.below(5)) + 100 * self.below(2);
                format!("{} leads to {} within {time} ms", self.watched(), self.watched())
            }
        }
    }
}

fn look(text: &str, verify: bool) -> Analysis {
    let files = Memory::new(&[("b.msd", text), ("n.fsfn", FUSION)]);
    analyze(&files, &["b.msd".to_owned()], &Options { verify, ..Options::default() })
}

/// What of a property is seen on each tick.
struct Watch<'a> {
    property: &'a Property,
    since: Option<u64>,
}

impl Watch<'_> {
    fn breaks(&mut self, holds: &[bool], time: u64) -> bool {
        match self.property.claim {
            Claim::Never(_) => holds[0],
            Claim::Always(_) => !holds[0],
            Claim::LeadsTo(response) => {
                if holds[0] && self.since.is_none() {
                    self.since = Some(time);
                }
                if holds[1] {
                    self.since = None;
                }
                self.since.is_some_and(|since| time >= since + response.within)
            }
        }
    }
}

/// Runs a diagram with readings that change now and then, at most one sensor failing, and ticks of any length.
fn is_broken(analysis: &Analysis, property: &Property, random: &mut Random) -> bool {
    let watched = property.claim.conditions();
    let plan = plan::build(analysis.checked().unwrap(), Id::new(0), Id::new(0), &watched);
    for _ in 0..20 {
        let mut machine = Machine::new(&plan, 1);
        let mut readings = [0.0; 2].map(|value| Reading { value, healthy: true });
        let mut watch = Watch { property, since: None };
        let (change, length) = (random.one_of(&[2, 5, 20]), random.one_of(&[TICK, 0]));
        let mut time = 0;
        for tick in 0..300 {
            if random.below(change) == 0 {
                let sensor = random.below(2) as usize;
                readings[sensor].value = random.below(21) as f64 / 2.0;
                readings[sensor].healthy = random.below(3) > 0 || !readings[1 - sensor].healthy;
            }
            let dt = if length == 0 { 1 + random.below(TICK) } else { length };
            let done = tick > 0 && random.below(4) == 0;
            time += if tick == 0 { 0 } else { dt };
            machine.step(Inputs { readings: &readings, done }, if tick == 0 { 0 } else { dt }, &mut Deaf);
            let holds: Vec<_> = plan.watched.iter().map(|watched| machine.bool(*watched)).collect();
            if watch.breaks(&holds, time) {
                return true;
            }
        }
    }
    false
}

#[test]
fn what_is_proved_is_not_broken_and_what_is_refuted_is() {
    let mut random = Random { state: 11, recalls: false };
    let (mut proved, mut refuted, mut open, mut replayed) = (0, 0, 0, 0);
    for number in 0..20 {
        random.recalls = number % 3 == 0;
        let behavior = format!("{CART}{}", random.behavior("b"));
        let properties: Vec<_> = (0..4).map(|index| format!("property p{index}: {}\n", random.property())).collect();
        let scenario = "scenario usual runs b { duration 1 s  tick 100 ms }\n";
        let text = format!("{behavior}\n{}{scenario}", properties.concat());
        let analysis = look(&text, true);
        let of = |rule| {
            let findings = analysis.findings.iter().filter(move |finding| finding.rule == rule);
            findings.map(lmslc::diag::Diagnostic::span).collect::<Vec<_>>()
        };
        let (broken, unknown) = (of(&rules::PROPERTY_REFUTED), of(&rules::PROPERTY_UNDECIDED));
        assert_eq!(analysis.proved + broken.len() + unknown.len(), 4, "{}\n{text}", report(&analysis));
        let shown: String = analysis.counterexamples.iter().map(|shown| shown.text.as_str()).collect();
        let plain = look(&format!("{text}\n{shown}"), false);
        let checked = plain.checked().unwrap_or_else(|| panic!("{}\n{text}\n{shown}", report(&plain)));
        for property in plain.program.properties.values() {
            let span = property.symbol.span;
            if broken.contains(&span) {
                refuted += 1;
            } else if unknown.contains(&span) {
                open += 1;
            } else {
                proved += 1;
                assert!(!is_broken(&plain, property, &mut random), "{}\n{text}", property.text);
            }
        }
        for shown in &analysis.counterexamples {
            let mut scenarios = plain.program.scenarios.values();
            let scenario = scenarios.find(|scenario| scenario.symbol.name == shown.name).unwrap();
            let plan = plan::build_scenario(checked, scenario);
            let run = sim::run(&plain.program, &plan, scenario, &RunOptions::default()).unwrap();
            let name = format!("property {}: ", plain.program.properties[shown.property].symbol.name);
            let verdict = run.verdicts.iter().find(|verdict| verdict.text.starts_with(&name)).unwrap();
            assert!(!verdict.passed, "{name}{}\n{text}\n{}", verdict.seen, shown.text);
            replayed += 1;
        }
    }
    println!("{proved} proved, {refuted} refuted, {open} open, {replayed} replayed");
    assert!(proved > 10, "the properties show nothing");
}
