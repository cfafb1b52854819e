//! What the network checker says, against the interpreter, against itself, and against readings on a grid.

use lmslc::analysis::network::{EventFacts, FaultSet, Method, Model, NetworkFacts, Verdict, Witness};
use lmslc::base::{Exact, Id, Sources};
use lmslc::interp::{Evaluator, Reading};
use lmslc::ir::{Clause, FailReading, Literal, Part, Program, Shape};
use lmslc::plan::{Checked, NetworkPlan, build_network};
use serde_json::{Value, json};

use crate::golden_reader::{cases, fails, program, read, with_every_failure};

/// Differences of degrees below this may be rounding.
const NOISE: f64 = 1e-9;

/// A small seeded generator of whole numbers (SplitMix64).
struct Seeded(u64);

impl Seeded {
    fn below(&mut self, bound: i64) -> i64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        i64::try_from(z >> 33).unwrap() % bound
    }

    fn ascending<const N: usize>(&mut self) -> [i64; N] {
        let mut corners = [0; N].map(|_| self.below(12) - 1);
        corners.sort_unstable();
        corners
    }
}

/// A random network with sets of terms and complements in its rules, and inputs that can fail.
pub fn random(seed: u64) -> Program {
    let mut seeded = Seeded(seed);
    let inputs = 1 + seeded.below(3);
    let mut counts = Vec::new();
    let variables = (0..inputs).map(|input| {
        let count = 1 + seeded.below(3);
        counts.push(count);
        let terms = (0..count).map(|_| match seeded.below(6) {
            0 => json!({"tri": seeded.ascending::<3>()}),
            1 => json!({"trap": seeded.ascending::<4>()}),
            2 => json!({"ramp_up": seeded.ascending::<2>()}),
            3 => json!({"ramp_down": seeded.ascending::<2>()}),
            4 => json!({"crisp": seeded.ascending::<2>()}),
            _ => {
                let degrees = [0; 4].map(|_| format!("{}/4", seeded.below(5)));
                let points: Vec<_> = seeded.ascending::<4>().into_iter().zip(degrees).collect();
                json!({"points": points})
            }
        });
        let terms: Vec<_> = terms.collect();
        json!({"name": format!("v{input}"), "range": [0, 10], "terms": terms})
    });
    let variables: Vec<_> = variables.collect();
    let events = (0..=seeded.below(2)).map(|event| {
        let mut side = || -> Vec<Value> {
            let rule = |seeded: &mut Seeded| {
                let cells = counts.iter().map(|&count| Some(seeded.below(count + 1)).filter(|term| *term < count));
                json!(cells.collect::<Vec<_>>())
            };
            (0..seeded.below(4)).map(|_| rule(&mut seeded)).collect()
        };
        json!({"name": format!("e{event}"), "contributor": side(), "detractor": side()})
    });
    let events: Vec<_> = events.collect();
    let mut program = program(&json!({"name": format!("r{seed}"), "variables": variables, "events": events}));
    for event in &mut program.networks[Id::new(0)].events {
        for clause in event.contributor.iter_mut().chain(&mut event.detractor).flat_map(|rule| &mut rule.clauses) {
            let term = seeded.below(counts[clause.input as usize]) as u32;
            match seeded.below(4) {
                0 => clause.any_of.push(Literal { term, negated: true }),
                1 => clause.any_of.push(Literal { term, negated: false }),
                _ => {}
            }
            clause.any_of.sort_unstable();
            clause.any_of.dedup();
        }
    }
    for input in 0..inputs as usize {
        for reading in [FailReading::Value(Exact::new(i128::from(seeded.below(11)), 1, 0)), FailReading::Absent] {
            fails(&mut program, input, reading);
        }
    }
    program
}

/// A random network with smooth terms, and terms built of them.
fn smooth(seed: u64) -> Program {
    let mut program = random(seed);
    let number = |value: i128, of: i128| Exact::new(value, of, 0);
    let width = |from: Exact, to: Exact| to.minus(from).unwrap().plus(number(1, 4)).unwrap();
    for variable in program.networks[Id::new(0)].inputs.clone().iter().map(|input| input.variable) {
        for (position, term) in program.variables[variable].terms.iter_mut().enumerate() {
            let shape = match term.shape.clone() {
                Shape::Triangle([a, b, c]) => Shape::Gaussian([b, width(a, c)]),
                Shape::Trapezoid(corners) => Shape::RiseAndFall(corners),
                Shape::Ramp { zero_at, one_at } if zero_at < one_at => Shape::Rise([zero_at, one_at]),
                Shape::Ramp { zero_at, .. } => Shape::Sigmoid([zero_at, number(-3, 2)]),
                Shape::Rectangle([a, b]) => Shape::Gaussian2([a, number(1, 2), b, number(1, 4)]),
                Shape::Points(points) => Shape::Bell([points[0].0, number(2, 1), number(3, 2)]),
                shape => shape,
            };
            term.shape = match position {
                0 => shape,
                1 => Shape::Built(vec![Part::Shape(shape), Part::Very(0)]),
                _ => Shape::Built(vec![
                    Part::Shape(shape),
                    Part::Shape(Shape::Cosine([number(5, 1), number(6, 1)])),
                    Part::Not(1),
                    Part::Any(vec![0, 2]),
                ]),
            };
        }
    }
    program
}

/// Random networks and some of those of the golden files, each with its failures.
fn networks() -> impl Iterator<Item = (Program, usize)> {
    let golden = read("golden_public.jsonl").into_iter().step_by(5).flat_map(|golden| {
        cases(&golden["net"]).into_iter().flat_map(|case| case.alternatives).map(|(program, _)| (program, 1))
    });
    golden.chain((0..50).map(|seed| (random(seed), 2))).chain((0..8).map(|seed| (smooth(seed), 0)))
}

/// The plan of a network, to run it.
pub fn replayable(program: &Program, sources: &Sources) -> NetworkPlan {
    build_network(Checked::new(program, sources, &[]).unwrap(), Id::new(0))
}

/// Every verdict about an event, in a fixed order.
fn verdicts(facts: &EventFacts) -> Vec<&Verdict> {
    let rules = facts.contributor.iter().chain(&facts.detractor);
    let rules = rules.flat_map(|rule| [&rule.fires, &rule.strongest, &rule.decisive]);
    [&facts.set, &facts.clear, &facts.tie, &facts.dead].into_iter().chain(rules).collect()
}

fn shape(facts: &NetworkFacts) -> Vec<Vec<bool>> {
    let event = |facts: &EventFacts| verdicts(facts).into_iter().map(Verdict::is_possible).collect();
    facts.events.iter().map(|facts| event(facts)).collect()
}

fn statuses(model: &Model, facts: &NetworkFacts) -> Vec<Vec<bool>> {
    model.valuations(facts).into_iter().map(|valuation| valuation.set).collect()
}

/// The rules of an event at some readings, as the interpreter has them.
pub struct Replay {
    contributors: Vec<f64>,
    detractors: Vec<f64>,
    pub set: bool,
}

fn largest(strengths: impl IntoIterator<Item = f64>) -> f64 {
    strengths.into_iter().fold(0.0, f64::max)
}

fn without(strengths: &[f64], rule: usize) -> f64 {
    largest(strengths.iter().enumerate().filter(|(other, _)| *other != rule).map(|(_, strength)| *strength))
}

impl Replay {
    pub fn all(plan: &NetworkPlan, readings: &[f64]) -> Vec<Self> {
        let readings: Vec<_> = readings.iter().map(|&value| Reading { value, healthy: true }).collect();
        let mut evaluator = Evaluator::new(plan);
        evaluator.evaluate(&readings, 0);
        let events = plan.events.iter().zip(&plan.strengths);
        let replay = |(event, strengths): (&lmslc::plan::Event, &(Vec<u32>, Vec<u32>))| Self {
            contributors: strengths.0.iter().map(|&rule| evaluator.real(rule)).collect(),
            detractors: strengths.1.iter().map(|&rule| evaluator.real(rule)).collect(),
            set: evaluator.bool(event.flag),
        };
        events.map(replay).collect()
    }

    /// How strong each rule is, contributors first.
    pub fn strengths(&self) -> impl Iterator<Item = f64> {
        self.contributors.iter().chain(&self.detractors).copied()
    }

    pub fn margin(&self) -> f64 {
        largest(self.contributors.iter().copied()) - largest(self.detractors.iter().copied())
    }

    /// How far each verdict's claim is from failing, in the order of `verdicts`; a claim that need not be strict is
    /// kept as long as this is not below 0.
    fn slack(&self) -> Vec<f64> {
        let margin = self.margin();
        let (contributor, detractor) =
            (largest(self.contributors.iter().copied()), largest(self.detractors.iter().copied()));
        let mut slack = vec![margin, -margin, -margin.abs(), -contributor.max(detractor)];
        for (rule, &strength) in self.contributors.iter().enumerate() {
            let others = without(&self.contributors, rule);
            slack.extend([strength, strength - others, margin.min(detractor - others)]);
        }
        for (rule, &strength) in self.detractors.iter().enumerate() {
            let others = without(&self.detractors, rule);
            slack.extend([strength, strength - others, (-margin).min(contributor - others)]);
        }
        slack
    }
}

/// The readings of a witness as the interpreter takes them: none where some sensor gives none, or is stuck beyond its
/// range.
pub fn numbers(plan: &NetworkPlan, model: &Model, faults: &FaultSet, witness: &Witness) -> Option<Vec<f64>> {
    let complete = model.complete(faults, witness);
    let numbers = complete.readings.iter().zip(&plan.inputs).map(|(reading, input)| {
        let number = reading.as_ref()?.to_f64();
        (input.low <= number && number <= input.high).then_some(number)
    });
    numbers.collect()
}

#[test]
fn every_witness_replays() {
    let (mut replayed, mut close) = (0, 0);
    for (program, up_to) in networks() {
        let sources = Sources::default();
        let plan = replayable(&program, &sources);
        let model = Model::new(&program, Id::new(0)).unwrap();
        for facts in model.facts(up_to) {
            let place = format!("{} {:?}", program.networks[Id::new(0)].symbol.name, facts.faults);
            for (event, known) in facts.events.iter().enumerate() {
                for (index, verdict) in verdicts(known).into_iter().enumerate() {
                    let Some(readings) = verdict.witness().and_then(|at| numbers(&plan, &model, &facts.faults, at))
                    else {
                        continue;
                    };
                    let slack = Replay::all(&plan, &readings)[event].slack()[index];
                    assert!(slack > -NOISE, "{place}: event {event}, verdict {index} at {readings:?}: {slack}");
                    // Being set, firing, and being the strongest are strict.
                    let strict = index == 0 || index >= 4 && (index - 4) % 3 != 2;
                    close += u32::from(strict && slack < NOISE);
                    replayed += 1;
                }
            }
            for valuation in model.valuations(&facts) {
                let witness = valuation.witness.as_ref();
                let Some(readings) = witness.and_then(|at| numbers(&plan, &model, &facts.faults, at)) else { continue };
                for (replay, set) in Replay::all(&plan, &readings).iter().zip(&valuation.set) {
                    assert!(replay.set == *set || replay.margin().abs() < NOISE, "{place} at {readings:?}");
                }
            }
        }
    }
    assert!(replayed > 5_000, "{replayed}");
    assert_eq!(close, 0);
}

#[test]
fn both_engines_agree() {
    for (program, up_to) in networks().chain([(with_every_failure(&read("obstacle_id.json")[0]), 1)]) {
        let model = Model::new(&program, Id::new(0)).unwrap();
        let solved = model.facts_by(Method::Solving, up_to);
        for (folded, solved) in model.facts(up_to).iter().zip(&solved) {
            let place = &program.networks[Id::new(0)].symbol.name;
            assert_eq!(shape(folded), shape(solved), "{place} {:?}", folded.faults);
        }
    }
}

#[test]
fn readings_on_a_grid_contradict_no_proof() {
    for (seed, program) in (0..60).map(random).chain((0..8).map(smooth)).enumerate() {
        let sources = Sources::default();
        let plan = replayable(&program, &sources);
        let model = Model::new(&program, Id::new(0)).unwrap();
        let facts = &model.facts(0)[0];
        let known = statuses(&model, facts);
        let steps: u32 = if plan.inputs.len() < 3 { 40 } else { 20 };
        let width = f64::from(steps) / 10.0;
        for index in 0..(steps + 1).pow(plan.inputs.len() as u32) {
            let digits = (0..plan.inputs.len() as u32).map(|input| index / (steps + 1).pow(input) % (steps + 1));
            let readings: Vec<_> = digits.map(|digit| f64::from(digit) / width).collect();
            let replays = Replay::all(&plan, &readings);
            for (replay, facts) in replays.iter().zip(&facts.events) {
                for (slack, verdict) in replay.slack().iter().zip(verdicts(facts)) {
                    assert!(*slack <= NOISE || verdict.is_possible(), "{seed} at {readings:?}");
                }
            }
            if replays.iter().all(|replay| replay.margin().abs() > NOISE) {
                let set: Vec<_> = replays.iter().map(|replay| replay.set).collect();
                assert!(known.contains(&set), "{seed} at {readings:?}: {set:?}");
            }
        }
    }
}

#[test]
fn a_stuck_sensor_is_a_range_of_one_reading() {
    for seed in 0..60 {
        let program = random(seed);
        let model = Model::new(&program, Id::new(0)).unwrap();
        for facts in model.facts(1) {
            let [fault] = facts.faults[..] else { continue };
            let FailReading::Value(value) = fault.reading else { continue };
            let mut narrow = program.clone();
            let variable = narrow.networks[Id::new(0)].inputs[fault.input].variable;
            narrow.variables[variable].range = (value, value);
            let narrow = Model::new(&narrow, Id::new(0)).unwrap();
            let same = &narrow.facts(0)[0];
            assert_eq!(shape(same), shape(&facts), "{seed}");
            assert_eq!(statuses(&narrow, same), statuses(&model, &facts), "{seed}");
        }
    }
}

#[test]
fn the_unit_of_a_variable_does_not_matter() {
    for seed in 0..60 {
        let program = random(seed);
        // As if every corner were in degrees.
        let degree = |value: Exact| value.times(Exact::new(1, 180, 1)).unwrap();
        let mut scaled = program.clone();
        for variable in scaled.networks[Id::new(0)].inputs.clone().iter().map(|input| input.variable) {
            let variable = &mut scaled.variables[variable];
            variable.range = (degree(variable.range.0), degree(variable.range.1));
            for term in &mut variable.terms {
                term.shape = match &term.shape {
                    Shape::Triangle(corners) => Shape::Triangle(corners.map(degree)),
                    Shape::Trapezoid(corners) => Shape::Trapezoid(corners.map(degree)),
                    Shape::Ramp { zero_at, one_at } => {
                        Shape::Ramp { zero_at: degree(*zero_at), one_at: degree(*one_at) }
                    }
                    Shape::Rectangle(ends) => Shape::Rectangle(ends.map(degree)),
                    Shape::Singleton(at) => Shape::Singleton(degree(*at)),
                    Shape::Points(points) => Shape::Points(points.iter().map(|(at, y)| (degree(*at), *y)).collect()),
                    smooth => panic!("{smooth:?}"),
                };
            }
        }
        let (one, other) = (Model::new(&program, Id::new(0)).unwrap(), Model::new(&scaled, Id::new(0)).unwrap());
        let (one_facts, other_facts) = (&one.facts(0)[0], &other.facts(0)[0]);
        assert_eq!(shape(one_facts), shape(other_facts), "{seed}");
        assert_eq!(statuses(&one, one_facts), statuses(&other, other_facts), "{seed}");
    }
}

#[test]
fn the_order_of_inputs_and_rules_does_not_matter() {
    for seed in 0..60 {
        let program = random(seed);
        let mut turned = program.clone();
        let network = &mut turned.networks[Id::new(0)];
        let last = network.inputs.len() as u32 - 1;
        network.inputs.reverse();
        for event in &mut network.events {
            event.contributor.reverse();
            event.detractor.reverse();
            for clause in event.contributor.iter_mut().chain(&mut event.detractor).flat_map(|rule| &mut rule.clauses) {
                clause.input = last - clause.input;
            }
        }
        let (one, other) = (Model::new(&program, Id::new(0)).unwrap(), Model::new(&turned, Id::new(0)).unwrap());
        let (one_facts, mut other_facts) = (&one.facts(0)[0], other.facts(0).swap_remove(0));
        assert_eq!(statuses(&one, one_facts), statuses(&other, &other_facts), "{seed}");
        for facts in &mut other_facts.events {
            let mut back = EventFacts::clone(facts);
            back.contributor.reverse();
            back.detractor.reverse();
            *facts = back.into();
        }
        assert_eq!(shape(one_facts), shape(&other_facts), "{seed}");
    }
}

#[test]
fn one_more_contributor_never_makes_an_event_harder_to_set() {
    for seed in 0..60 {
        let program = random(seed);
        let mut more = program.clone();
        for event in &mut more.networks[Id::new(0)].events {
            let mut rule = event.detractor.first().or(event.contributor.first()).cloned().unwrap_or_else(|| {
                let any_of = vec![Literal { term: 0, negated: false }];
                lmslc::ir::Rule { clauses: vec![Clause { input: 0, any_of }], span: lmslc::base::Span::default() }
            });
            rule.clauses.truncate(1);
            event.contributor.push(rule);
        }
        let (less, more) = (Model::new(&program, Id::new(0)).unwrap(), Model::new(&more, Id::new(0)).unwrap());
        for (less, more) in less.facts(1).iter().zip(more.facts(1)) {
            for (less, more) in less.events.iter().zip(&more.events) {
                assert!(!less.set.is_possible() || more.set.is_possible(), "{seed}");
                assert!(less.clear.is_possible() || !more.clear.is_possible(), "{seed}");
            }
        }
    }
}

#[test]
fn both_engines_agree_on_more_rules_than_a_word_holds() {
    for seed in 0..10 {
        let mut program = random(seed);
        for event in &mut program.networks[Id::new(0)].events {
            event.contributor = vec![event.contributor.clone(); 40].concat();
            event.detractor = vec![event.detractor.clone(); 30].concat();
        }
        let model = Model::new(&program, Id::new(0)).unwrap();
        let solved = model.facts_by(Method::Solving, 0);
        assert_eq!(shape(&model.facts(0)[0]), shape(&solved[0]), "{seed}");
    }
}

/// A membership function with its degrees mapped so that their order, and that of their complements, stays.
fn bent(shape: &Shape) -> Shape {
    let number = |value: i128, of: i128| Exact::new(value, of, 0);
    let (zero, one) = (Exact::ZERO, Exact::ONE);
    let corners = match shape {
        Shape::Triangle([a, b, c]) => vec![(*a, zero), (*b, one), (*c, zero)],
        Shape::Trapezoid([a, b, c, d]) => vec![(*a, zero), (*b, one), (*c, one), (*d, zero)],
        Shape::Ramp { zero_at, one_at } if zero_at < one_at => vec![(*zero_at, zero), (*one_at, one)],
        Shape::Ramp { zero_at, one_at } => vec![(*one_at, one), (*zero_at, zero)],
        Shape::Rectangle([a, b]) => vec![(*a, zero), (*a, one), (*b, one), (*b, zero)],
        Shape::Points(points) => points.clone(),
        other => panic!("{other:?}"),
    };
    // Linear from 0 over (1/4, 1/8), (1/2, 1/2) and (3/4, 7/8) to 1.
    let map = [(zero, zero), (number(1, 4), number(1, 8)), (number(1, 2), number(1, 2)), (number(3, 4), number(7, 8))];
    let between = |(x0, y0): (Exact, Exact), (x1, y1): (Exact, Exact), x: Exact| {
        let share = x.minus(x0).unwrap().over(x1.minus(x0).unwrap()).unwrap();
        y1.minus(y0).unwrap().times(share).unwrap().plus(y0).unwrap()
    };
    let bend = |degree: Exact| {
        let stretch = map.iter().rposition(|(from, _)| *from <= degree).unwrap();
        between(map[stretch], map.get(stretch + 1).copied().unwrap_or((one, one)), degree)
    };
    let mut bent = Vec::new();
    for (index, &(at, degree)) in corners.iter().enumerate() {
        bent.push((at, bend(degree)));
        let Some(&(next, then)) = corners.get(index + 1) else { continue };
        let mut inside: Vec<_> =
            map[1..].iter().filter(|(cut, _)| degree.min(then) < *cut && *cut < degree.max(then)).collect();
        if then < degree {
            inside.reverse();
        }
        if at < next {
            bent.extend(inside.iter().map(|(cut, value)| (between((degree, at), (then, next), *cut), *value)));
        }
    }
    Shape::Points(bent)
}

#[test]
fn a_map_of_degrees_that_keeps_their_order_does_not_matter() {
    for seed in 0..60 {
        let program = random(seed);
        let mut mapped = program.clone();
        for variable in mapped.networks[Id::new(0)].inputs.clone().iter().map(|input| input.variable) {
            for term in &mut mapped.variables[variable].terms {
                term.shape = bent(&term.shape);
            }
        }
        let (one, other) = (Model::new(&program, Id::new(0)).unwrap(), Model::new(&mapped, Id::new(0)).unwrap());
        for (one_facts, other_facts) in one.facts(1).iter().zip(other.facts(1)) {
            assert_eq!(shape(one_facts), shape(&other_facts), "{seed}");
            assert_eq!(statuses(&one, one_facts), statuses(&other, &other_facts), "{seed}");
        }
    }
}
