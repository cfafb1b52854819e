//! What is found about events, against the interpreter on grids of readings.

use lmslc::analysis::network::{Comparison, Model, Relation};
use lmslc::analysis::run;
use lmslc::base::{Exact, FileId, Id, Sources, Span};
use lmslc::diag::Diagnostic;
use lmslc::ir::{Network, Program};
use lmslc::plan::NetworkPlan;

use crate::network::{Replay, numbers, random, replayable};

/// Differences of degrees below this may be rounding.
const NOISE: f64 = 1e-9;

/// The network of a random program.
const ONLY: Id<Network> = Id::new(0);

/// A random network in which every rule and every event stands in a place of its own.
fn placed(seed: u64) -> Program {
    let mut program = random(seed);
    let mut next = 0;
    let mut place = || {
        next += 1;
        Span::new(FileId(0), next, next + 1)
    };
    for event in &mut program.networks[ONLY].events {
        event.symbol.span = place();
        event.contributor.iter_mut().chain(&mut event.detractor).for_each(|rule| rule.span = place());
    }
    for input in program.networks[ONLY].inputs.clone() {
        let variable = &mut program.variables[input.variable];
        variable.symbol.span = Span::new(FileId(1), 0, 1);
        if seed.is_multiple_of(3) {
            // More terms never hold in a narrow range.
            variable.range = (Exact::new(4, 1, 0), Exact::new(7, 1, 0));
        }
    }
    program
}

/// What is found about the network; what its variables are is judged elsewhere.
fn findings(program: &Program) -> Vec<Diagnostic> {
    run(program, 0, |file| file == FileId(0))
}

/// Where the findings of some rules have their primary places.
fn places(findings: &[Diagnostic], codes: &[&str]) -> Vec<Span> {
    findings.iter().filter(|finding| codes.contains(&finding.rule.code)).map(Diagnostic::span).collect()
}

/// A dense grid of readings, and all events at each of them.
fn grid(program: &Program) -> Vec<(Vec<f64>, Vec<Replay>)> {
    let sources = Sources::default();
    let plan = replayable(program, &sources);
    let inputs = plan.inputs.len() as u32;
    let steps: u32 = if inputs < 3 { 40 } else { 12 };
    let readings = (0..(steps + 1).pow(inputs)).map(|index| {
        let digits = (0..inputs).map(|input| index / (steps + 1).pow(input) % (steps + 1));
        let shares = digits.map(|digit| f64::from(digit) / f64::from(steps)).zip(&plan.inputs);
        shares.map(|(share, input)| input.low + share * (input.high - input.low)).collect::<Vec<_>>()
    });
    readings.map(|readings| (readings.clone(), Replay::all(&plan, &readings))).collect()
}

/// The flags of all events, where none is a matter of rounding.
fn flags(replays: &[Replay]) -> Option<Vec<bool>> {
    let is_sure = |replay: &Replay| replay.margin().abs() > NOISE || replay.margin() == 0.0;
    replays.iter().all(is_sure).then(|| replays.iter().map(|replay| replay.set).collect())
}

#[test]
fn what_is_never_set_or_always_set_is_so_on_a_grid() {
    let mut found = 0;
    for seed in 0..90 {
        let program = placed(seed);
        let findings = findings(&program);
        let (never, always) = (places(&findings, &["LM0506"]), places(&findings, &["LM0507"]));
        for (_, replays) in grid(&program) {
            for (event, replay) in program.networks[ONLY].events.iter().zip(&replays) {
                let place = event.symbol.span;
                assert!(!never.contains(&place) || replay.margin() < NOISE, "{seed}");
                assert!(!always.contains(&place) || replay.margin() > -NOISE, "{seed}");
            }
        }
        found += never.len() + always.len();
    }
    assert!(found > 20, "{found}");
}

#[test]
fn without_the_rules_that_are_reported_every_event_is_the_same() {
    let codes = [("LM0511", 10), ("LM0512", 5), ("LM0513", 50), ("LM0514", 30), ("LM0515", 10)];
    let mut found = [0; 5];
    for seed in 0..240 {
        let program = placed(seed);
        let findings = findings(&program);
        let needless = places(&findings, &codes.map(|(code, _)| code));
        for (count, (code, _)) in found.iter_mut().zip(codes) {
            *count += places(&findings, &[code]).len();
        }
        if needless.is_empty() {
            continue;
        }
        let mut smaller = program.clone();
        for event in &mut smaller.networks[ONLY].events {
            for side in [&mut event.contributor, &mut event.detractor] {
                side.retain(|rule| !needless.contains(&rule.span));
            }
        }
        for ((readings, whole), (_, less)) in grid(&program).iter().zip(grid(&smaller)) {
            if let (Some(whole), Some(less)) = (flags(whole), flags(&less)) {
                assert_eq!(whole, less, "{seed} at {readings:?}");
            }
        }
    }
    for (count, (code, least)) in found.iter().zip(codes) {
        assert!(*count >= least, "{code}: {found:?}");
    }
}

#[test]
fn what_never_fires_is_0_on_a_grid() {
    for seed in 0..300 {
        let program = placed(seed);
        let silent = places(&findings(&program), &["LM0512"]);
        if silent.is_empty() {
            continue;
        }
        for (readings, replays) in grid(&program) {
            for (event, replay) in program.networks[ONLY].events.iter().zip(&replays) {
                for (rule, strength) in event.contributor.iter().chain(&event.detractor).zip(replay.strengths()) {
                    assert!(!silent.contains(&rule.span) || strength == 0.0, "{seed} at {readings:?}");
                }
            }
        }
    }
}

/// Whether all readings near some leave both sides equally strong.
fn is_tie_around(plan: &NetworkPlan, readings: &[f64], event: usize, distance: f64) -> bool {
    let corners = 0..1_u32 << readings.len();
    let is_tie = |corner: u32| {
        // No two inputs are moved alike.
        let moved = readings.iter().enumerate().map(|(input, reading)| {
            let share = distance * (1.0 + 0.37 * input as f64);
            if corner >> input & 1 == 0 { reading + share } else { reading - share }
        });
        let moved: Vec<_> = moved.collect();
        Replay::all(plan, &moved)[event].margin().abs() < NOISE
    };
    corners.clone().all(is_tie)
}

#[test]
fn a_tie_around_readings_is_one_at_all_readings_near_them() {
    let (mut regions, mut none) = (0, 0);
    for seed in 0..60 {
        let (program, sources) = (placed(seed), Sources::default());
        let plan = replayable(&program, &sources);
        let model = Model::new(&program, ONLY).unwrap();
        for event in 0..program.networks[ONLY].events.len() {
            let tie = model.tie_region(event, &Vec::new(), &[]);
            let dead = model.dead_region(event, &Vec::new());
            for (witness, fires) in [(&tie, true), (&dead, false)] {
                let Some(witness) = witness else { continue };
                let readings = numbers(&plan, &model, &Vec::new(), witness).unwrap();
                assert!(is_tie_around(&plan, &readings, event, 1e-6), "{seed} at {readings:?}");
                let strongest = Replay::all(&plan, &readings)[event].strengths().fold(0.0, f64::max);
                assert_eq!(strongest > NOISE, fires, "{seed} at {readings:?}");
                regions += 1;
            }
            // Off the grid, where no corner of a term and no crossing lies.
            for (readings, replays) in grid(&program) {
                let inside = readings.iter().zip(&plan.inputs);
                let inside =
                    inside.map(|(reading, input)| reading * 0.98 + 0.0173 * f64::midpoint(input.low, input.high));
                let readings: Vec<_> = inside.collect();
                if replays[event].margin().abs() < 0.1 && is_tie_around(&plan, &readings, event, 1e-3) {
                    let fires = Replay::all(&plan, &readings)[event].strengths().any(|strength| strength > NOISE);
                    let known = if fires { &tie } else { &dead };
                    assert!(known.is_some(), "{seed} at {readings:?}");
                }
            }
            none += u32::from(tie.is_none());
        }
    }
    assert!(regions > 20 && none > 20, "{regions}, {none}");
}

fn compare(comparison: &Comparison, reading: f64) -> Option<bool> {
    let number = comparison.reading.to_f64();
    ((reading - number).abs() > NOISE).then_some((reading > number) == comparison.above)
}

#[test]
fn an_event_is_the_comparison_that_it_comes_down_to() {
    let (mut needless_inputs, mut comparisons) = (0, 0);
    for seed in 0..90 {
        let program = placed(seed);
        let model = Model::new(&program, ONLY).unwrap();
        let facts = &model.facts(0)[0];
        let grid = grid(&program);
        for (index, event) in program.networks[ONLY].events.iter().enumerate() {
            let needless = model.needless_inputs(index, facts);
            needless_inputs += needless.len();
            let rules = event.contributor.iter().chain(&event.detractor);
            let mut needed: Vec<_> = rules.flat_map(|rule| &rule.clauses).map(|clause| clause.input as usize).collect();
            needed.retain(|input| !needless.contains(input));
            needed.sort_unstable();
            needed.dedup();
            let mut known = std::collections::HashMap::new();
            for (readings, replays) in &grid {
                let replay = &replays[index];
                if replay.margin().abs() > NOISE {
                    let kept: Vec<_> = needed.iter().map(|&input| readings[input].to_bits()).collect();
                    assert_eq!(*known.entry(kept).or_insert(replay.set), replay.set, "{seed} at {readings:?}");
                }
            }
            let [input] = needed[..] else { continue };
            let Some(comparison) = model.comparison(index, input) else { continue };
            comparisons += 1;
            for (readings, replays) in &grid {
                let sure = compare(&comparison, readings[input]).filter(|_| replays[index].margin().abs() > NOISE);
                assert!(sure.is_none_or(|holds| holds == replays[index].set), "{seed} at {readings:?}");
            }
        }
    }
    assert!(needless_inputs > 20 && comparisons > 5, "{needless_inputs}, {comparisons}");
}

#[test]
fn no_reading_contradicts_a_relation() {
    let mut found = 0;
    for seed in 0..200 {
        let program = placed(seed);
        let model = Model::new(&program, ONLY).unwrap();
        let facts = &model.facts(0)[0];
        let relations = model.relations(facts);
        let seen: Vec<_> = grid(&program).iter().filter_map(|(_, replays)| flags(replays)).collect();
        for relation in &relations {
            match *relation {
                Relation::Implies(one, other) => assert!(seen.iter().all(|set| !set[one] || set[other]), "{seed}"),
                Relation::Excludes(one, other) => assert!(seen.iter().all(|set| !set[one] || !set[other]), "{seed}"),
            }
        }
        // Nor is one of them missed: all pairs of statuses that exclude each other are among the relations.
        let valuations = model.valuations(facts);
        let never = |one: usize, other: usize, is_set: bool| {
            valuations.iter().all(|valuation| !(valuation.set[one] && valuation.set[other] == is_set))
        };
        let varies = |event: usize| facts.events[event].set.is_possible() && facts.events[event].clear.is_possible();
        if program.networks[ONLY].events.len() == 2 && varies(0) && varies(1) {
            assert_eq!(relations.contains(&Relation::Implies(0, 1)), never(0, 1, false), "{seed}");
            assert_eq!(relations.contains(&Relation::Implies(1, 0)), never(1, 0, false), "{seed}");
            assert_eq!(relations.contains(&Relation::Excludes(0, 1)), never(0, 1, true), "{seed}");
        }
        found += relations.len();
    }
    assert!(found > 3, "{found}");
}

#[test]
fn leaving_cells_out_makes_the_difference_that_is_shown() {
    let mut found = 0;
    for seed in 0..60 {
        let (program, sources) = (placed(seed), Sources::default());
        let plan = replayable(&program, &sources);
        let model = Model::new(&program, ONLY).unwrap();
        let facts = &model.facts(0)[0];
        for index in 0..program.networks[ONLY].events.len() {
            let lmslc::analysis::network::Verdict::Possible(witness) =
                model.difference_without(index, facts, |input, _| input == 0)
            else {
                continue;
            };
            let mut smaller = program.clone();
            let event = &mut smaller.networks[ONLY].events[index];
            for rule in event.contributor.iter_mut().chain(&mut event.detractor) {
                rule.clauses.retain(|clause| clause.input != 0);
            }
            let smaller = replayable(&smaller, &sources);
            let readings = numbers(&plan, &model, &Vec::new(), &witness).unwrap();
            let (whole, less) = (&Replay::all(&plan, &readings)[index], &Replay::all(&smaller, &readings)[index]);
            let is_close = whole.margin().abs() < NOISE || less.margin().abs() < NOISE;
            assert!(whole.set != less.set || is_close, "{seed} at {readings:?}");
            found += 1;
        }
    }
    assert!(found > 20, "{found}");
}
