//! Verdicts on networks of `tests/golden`, compared with those of an independent solver.

use std::collections::BTreeSet;

use lmslc::analysis::network::{EventFacts, Model, Verdict};
use lmslc::base::Id;
use serde_json::Value;

use crate::golden_reader::{Case, cases, read, with_every_failure};

/// What is possible, as the golden files write it.
#[derive(Debug, Default, PartialEq, Eq)]
struct Possible {
    /// Set, clear, tie and dead, in the lowest bits.
    event: u8,
    rules: [Vec<u8>; 2],
}

impl Possible {
    fn add(&mut self, facts: &EventFacts) {
        self.event |= code([&facts.set, &facts.clear, &facts.tie, &facts.dead]);
        for (digits, rules) in self.rules.iter_mut().zip([&facts.contributor, &facts.detractor]) {
            digits.resize(rules.len(), 0);
            for (digit, rule) in digits.iter_mut().zip(rules) {
                *digit |= code([&rule.fires, &rule.strongest, &rule.decisive]);
            }
        }
    }

    fn shown(&self) -> (Value, [String; 2]) {
        let status = ["", "a", "n", "s"][usize::from(self.event & 3)];
        let digits = |digits: &Vec<u8>| digits.iter().map(|digit| char::from(b'0' + digit)).collect();
        (serde_json::json!([status, self.event >> 2 & 1, self.event >> 3]), self.rules.each_ref().map(digits))
    }
}

/// A bit for each verdict, the first one lowest.
fn code<'a>(verdicts: impl IntoIterator<Item = &'a Verdict>) -> u8 {
    let bits = verdicts.into_iter().enumerate();
    bits.fold(0, |code, (bit, verdict)| code | u8::from(verdict.is_possible()) << bit)
}

fn compare(case: &Case, net: &Value, answer: &Value) {
    let place = format!("{} {}", net["name"], case.name);
    let declared = net["events"].as_array().unwrap();
    let mut possible: Vec<Possible> = declared.iter().map(|_| Possible::default()).collect();
    let mut valuations = BTreeSet::new();
    for (program, faults) in &case.alternatives {
        let model = Model::new(program, Id::new(0)).unwrap();
        let facts = model.facts(1).into_iter().find(|facts| facts.faults == *faults).unwrap();
        for (possible, facts) in possible.iter_mut().zip(&facts.events) {
            possible.add(facts);
        }
        let word = |set: &Vec<bool>| set.iter().map(|&set| if set { '1' } else { '0' }).collect::<String>();
        valuations.extend(model.valuations(&facts).iter().map(|valuation| word(&valuation.set)));
    }
    assert_eq!(serde_json::json!(valuations), answer["val"], "{place}");
    for (index, (possible, event)) in possible.iter().zip(declared).enumerate() {
        let (event_answer, rules) = possible.shown();
        assert_eq!(event_answer, answer["ev"][index], "{place} {}", event["name"]);
        for (side, digits) in ["con", "det"].into_iter().zip(rules) {
            let key = format!("{}.{side}", event["name"].as_str().unwrap());
            assert_eq!(digits, answer["rules"][&key].as_str().unwrap_or_default(), "{place} {key}");
        }
    }
}

#[test]
fn every_golden_verdict_is_ours() {
    let mut compared = 0;
    for golden in read("golden_public.jsonl") {
        let net = &golden["net"];
        let answers = golden["ans"].as_array().unwrap();
        let cases = cases(net);
        assert_eq!(cases.len(), answers.len(), "{}", net["name"]);
        for (case, answer) in cases.iter().zip(answers) {
            assert_eq!(case.name, answer["fault"].as_str().unwrap(), "{}", net["name"]);
            compare(case, net, answer);
            compared += 1;
        }
    }
    assert_eq!(compared, 727);
}

#[test]
fn a_gap_between_crossings_is_not_overlooked() {
    let case = &cases(&read("gap_counterexample.json")[0])[0];
    let facts = &Model::new(&case.alternatives[0].0, Id::new(0)).unwrap().facts(0)[0];
    assert!(facts.events[0].set.is_possible());
}

#[test]
fn levels_of_two_events_lie_anywhere() {
    let case = &cases(&read("joint_counterexample.json")[0])[0];
    let model = Model::new(&case.alternatives[0].0, Id::new(0)).unwrap();
    let found: Vec<_> = model.valuations(&model.facts(0)[0]).into_iter().map(|valuation| valuation.set).collect();
    assert_eq!(found, [[false, false], [false, true], [true, false], [true, true]]);
}

#[test]
fn a_heavy_obstacle_is_a_collision_whatever_fails() {
    let model = Model::new(&with_every_failure(&read("obstacle_id.json")[0]), Id::new(0)).unwrap();
    let facts = model.facts(3);
    assert_eq!(facts.len(), 216);
    for facts in facts {
        assert!(model.valuations(&facts).iter().all(|valuation| valuation.set != [false, true]));
    }
}
