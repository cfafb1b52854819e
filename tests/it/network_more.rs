//! What the network checker says beyond verdicts: proofs, needless inputs, margins, surviving rules.

use lmslc::analysis::network::{EventFacts, Fault, Model, Question, Reading, Relation, Verdict};
use lmslc::base::{Exact, Id};
use lmslc::ir::FailReading;

use crate::golden_reader::{read, with_every_failure};
use crate::network::{Replay, numbers, random, replayable};

const FORWARD_COLLISION: usize = 0;
const HEAVY_OBSTACLE: usize = 1;
const FORCE: usize = 2;

fn obstacle_id() -> Model {
    Model::new(&with_every_failure(&read("obstacle_id.json")[0]), Id::new(0)).unwrap()
}

fn force_stuck_at_zero() -> Vec<Fault> {
    vec![Fault { input: FORCE, reading: FailReading::Value(Exact::ZERO) }]
}

#[test]
fn a_heavy_obstacle_is_a_matter_of_force_alone() {
    let model = obstacle_id();
    assert_eq!(model.needless_inputs(HEAVY_OBSTACLE, &model.facts(0)[0]), [0, 1]);
    assert_eq!(model.dependence(HEAVY_OBSTACLE, 0, &Vec::new()), Verdict::Never);
    assert!(model.dependence(HEAVY_OBSTACLE, FORCE, &Vec::new()).witness().is_some());
    assert!(model.needless_inputs(FORWARD_COLLISION, &model.facts(0)[0]).is_empty());
    assert!(model.dependence(FORWARD_COLLISION, 0, &Vec::new()).witness().is_some());
}

#[test]
fn events_imply_each_other() {
    let model = obstacle_id();
    assert_eq!(model.relations(&model.facts(0)[0]), [Relation::Implies(HEAVY_OBSTACLE, FORWARD_COLLISION)]);
}

#[test]
fn without_force_nothing_is_heavy_and_the_proof_says_why() {
    let model = obstacle_id();
    let proof = model.proof(HEAVY_OBSTACLE, &force_stuck_at_zero(), Question::Set).unwrap();
    // Nine rules name the force as high, which it is not; nothing else matters.
    assert_eq!(proof.inputs, [FORCE]);
    assert_eq!(proof.rules, [0, 1, 2, 3, 4, 5, 6, 7, 8]);
    assert_eq!(model.proof(HEAVY_OBSTACLE, &Vec::new(), Question::Set), None);
}

/// Every question about an event with its verdict.
fn questions(event: &EventFacts) -> Vec<(Question, &Verdict)> {
    let rules = event.contributor.iter().chain(&event.detractor).enumerate();
    let of_rules = rules.flat_map(|(rule, facts)| {
        [
            (Question::Fires(rule), &facts.fires),
            (Question::Strongest(rule), &facts.strongest),
            (Question::Decisive(rule), &facts.decisive),
        ]
    });
    let of_event = [(Question::Set, &event.set), (Question::Clear, &event.clear)];
    let of_event = of_event.into_iter().chain([(Question::Tie, &event.tie), (Question::Dead, &event.dead)]);
    of_event.chain(of_rules).collect()
}

#[test]
fn every_never_has_a_proof_that_more_failures_keep() {
    for seed in 0..15 {
        let model = Model::new(&random(seed), Id::new(0)).unwrap();
        let all = model.facts(2);
        for (facts, position) in all.iter().flat_map(|facts| (0..facts.events.len()).map(move |event| (facts, event))) {
            for (index, (question, verdict)) in questions(&facts.events[position]).into_iter().enumerate() {
                let proof = model.proof(position, &facts.faults, question);
                assert_eq!(proof.is_some(), *verdict == Verdict::Never, "{seed} {question:?}");
                let Some(proof) = proof else { continue };
                // Inputs that a proof leaves out may fail in any way.
                let grown = all.iter().filter(|more| facts.faults.iter().all(|fault| more.faults.contains(fault)));
                for more in grown {
                    let mut new = more.faults.iter().filter(|fault| !facts.faults.contains(fault));
                    if new.all(|fault| !proof.inputs.contains(&fault.input)) {
                        let (_, still) = questions(&more.events[position])[index];
                        assert_eq!(*still, Verdict::Never, "{seed} {question:?} {:?}", more.faults);
                    }
                }
            }
        }
    }
}

#[test]
fn the_rules_that_a_failure_leaves_are_those_of_the_paper() {
    let survivors = obstacle_id().survivors(FORWARD_COLLISION, &force_stuck_at_zero()).unwrap();
    let terms = |rules: &[Vec<(usize, lmslc::ir::Literal)>]| -> Vec<Vec<u32>> {
        rules.iter().map(|rule| rule.iter().map(|(_, literal)| literal.term).collect()).collect()
    };
    // Without force only its low term is left (neg, zero, pos are 0, 1, 2).
    assert_eq!(terms(&survivors.contributor), [[0, 0, 0]]);
    let against = [[0, 2, 0], [1, 1, 0], [1, 2, 0], [2, 0, 0], [2, 1, 0], [2, 2, 0]];
    assert_eq!(terms(&survivors.detractor), against);
}

#[test]
fn writing_rules_out_changes_no_event() {
    for seed in 0..40 {
        let model = Model::new(&random(seed), Id::new(0)).unwrap();
        let expanded = model.expanded().unwrap();
        for (written, expanded) in model.facts(1).iter().zip(expanded.facts(1)) {
            for (written, expanded) in written.events.iter().zip(&expanded.events) {
                let of =
                    |event: &EventFacts| [&event.set, &event.clear, &event.tie, &event.dead].map(Verdict::is_possible);
                assert_eq!(of(written), of(expanded), "{seed}");
            }
        }
    }
}

#[test]
fn a_flag_flips_beyond_its_margin_and_not_before() {
    let mut flipped = 0;
    for seed in 0..60 {
        let program = random(seed);
        let (model, sources) = (Model::new(&program, Id::new(0)).unwrap(), lmslc::base::Sources::default());
        let plan = replayable(&program, &sources);
        let facts = &model.facts(0)[0];
        for (event, known) in facts.events.iter().enumerate() {
            let Some(witness) = known.set.witness() else { continue };
            let at = model.complete(&Vec::new(), witness);
            let readings = numbers(&plan, &model, &Vec::new(), witness).unwrap();
            for (input, margin) in model.margins(event, &Vec::new(), &at).iter().enumerate() {
                let margin = margin.as_ref().map(Reading::to_f64);
                let set_after = |change: f64| {
                    let mut moved = readings.clone();
                    moved[input] = (moved[input] + change).clamp(0.0, 10.0);
                    let replay = &Replay::all(&plan, &moved)[event];
                    replay.set || replay.margin().abs() < 1e-9
                };
                let largest = margin.map_or(10.0, |margin| margin * 0.999);
                for step in -50_i32..=50 {
                    let change = largest * f64::from(step) / 50.0;
                    assert!(set_after(change), "{seed}: event {event}, input {input} by {change}");
                }
                if let Some(margin) = margin {
                    let clear_after = |change: f64| {
                        let mut moved = readings.clone();
                        moved[input] += change;
                        let replay = &Replay::all(&plan, &moved)[event];
                        !replay.set || replay.margin().abs() < 1e-5
                    };
                    assert!(
                        clear_after(margin + 1e-7)
                            || clear_after(-margin - 1e-7)
                            || clear_after(margin)
                            || clear_after(-margin),
                        "{seed}"
                    );
                    flipped += 1;
                }
            }
        }
    }
    assert!(flipped > 50, "{flipped}");
}
