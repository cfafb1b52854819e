//! Continuous outputs are what an independent integral of high resolution says, for every choice of inference.

use lmslc::base::Id;
use lmslc::interp::{Actuators, Evaluator, Inputs, Machine, Reading};
use lmslc::plan::{self, NetworkPlan};
use lmslc::report::{self as reports, Evaluated};

use crate::support::{analyze_texts, doubts, report};

/// A set of the tests: its points, ascending.
type Set = Vec<(f64, f64)>;

struct Random(u64);

impl Random {
    fn up_to(&mut self, end: u64) -> u64 {
        lmslc::kernel::next_random(&mut self.0) % end
    }

    fn strength(&mut self) -> f64 {
        self.up_to(1001) as f64 / 1000.0
    }
}

/// The degree of a value, written anew: the step's larger degree at a step.
fn degree(set: &Set, x: f64) -> f64 {
    let (first, last) = (set[0], set[set.len() - 1]);
    if x < first.0 {
        return first.1;
    }
    if x > last.0 {
        return last.1;
    }
    let mut found: f64 = 0.0;
    for pair in set.windows(2) {
        let ((from, start), (to, end)) = (pair[0], pair[1]);
        if from <= x && x <= to {
            found =
                found.max(if to > from { start + (end - start) * (x - from) / (to - from) } else { start.max(end) });
        }
    }
    found
}

/// The integral of a function that is linear but for few kinks and steps, which are found by halving.
fn integral(f: &dyn Fn(f64) -> f64, from: f64, to: f64, depth: u32) -> f64 {
    let width = to - from;
    let at = |share: f64| f(from + share * width);
    // Just inside, so that a step at an end is not seen.
    let (a, b) = (at(1e-9), at(1.0 - 1e-9));
    let line = |share: f64| a + (b - a) * share;
    let is_straight = [0.13, 0.37, 0.5, 0.71, 0.93].iter().all(|&share| (at(share) - line(share)).abs() < 1e-11);
    if is_straight && depth < 40 || depth == 0 {
        return 0.5 * width * (a + b);
    }
    let middle = from + 0.5 * width;
    integral(f, from, middle, depth - 1) + integral(f, middle, to, depth - 1)
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Implied {
    Clipped,
    Scaled,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Joined {
    Largest,
    Added,
}

/// A problem: sets over -10 to 30, each with the strengths of the rules that name it.
struct Problem {
    sets: Vec<Set>,
    rules: Vec<(usize, f64)>,
    implied: Implied,
    joined: Joined,
}

const LOW: f64 = -10.0;
const HIGH: f64 = 30.0;

impl Problem {
    fn at(&self, x: f64) -> f64 {
        let each = self.rules.iter().map(|&(set, strength)| {
            let degree = degree(&self.sets[set], x);
            if self.implied == Implied::Clipped { degree.min(strength) } else { degree * strength }
        });
        if self.joined == Joined::Largest { each.fold(0.0, f64::max) } else { each.sum() }
    }

    /// The range, cut where sets have corners.
    fn cuts(&self) -> Vec<f64> {
        let inside = self.sets.iter().flatten().map(|(x, _)| *x).filter(|x| LOW < *x && *x < HIGH);
        let mut cuts: Vec<f64> = inside.chain([LOW, HIGH]).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        cuts
    }

    fn integral(&self, f: &dyn Fn(f64) -> f64, up_to: f64) -> f64 {
        let cuts = self.cuts();
        let pieces = cuts.windows(2).filter(|ends| ends[0] < up_to);
        pieces.map(|ends| integral(f, ends[0], ends[1].min(up_to), 40)).sum()
    }

    fn area(&self, up_to: f64) -> f64 {
        self.integral(&|x| self.at(x), up_to)
    }

    /// The moment is a quadratic between kinks: by parts, the integral of the area above.
    fn centroid(&self) -> f64 {
        let cuts = self.cuts();
        let (mut area, mut moment) = (0.0, 0.0);
        for ends in cuts.windows(2) {
            // Gauss's three points are exact for quadratics; halving finds the kinks.
            let mut waiting = vec![(ends[0], ends[1], 40)];
            while let Some((from, to, depth)) = waiting.pop() {
                let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
                let (a, b) = (self.at(from + 2e-9 * half), self.at(to - 2e-9 * half));
                let line = |share: f64| a + (b - a) * share;
                let straight = [0.13, 0.37, 0.5, 0.71, 0.93];
                if depth > 0 && straight.iter().any(|&s| (self.at(from + s * 2.0 * half) - line(s)).abs() > 1e-11) {
                    waiting.extend([(from, middle, depth - 1), (middle, to, depth - 1)]);
                    continue;
                }
                for (node, weight) in [(-0.6_f64.sqrt(), 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.6_f64.sqrt(), 5.0 / 9.0)] {
                    let x = middle + node * half;
                    area += weight * half * self.at(x);
                    moment += weight * half * self.at(x) * x;
                }
            }
        }
        moment / area
    }

    /// The network that asks for it: every rule fires as strongly as its input says.
    fn text(&self, using: &str) -> String {
        let inputs: Vec<_> = (0..self.rules.len()).map(|rule| format!("i{rule}: level")).collect();
        let points = |set: &Set| set.iter().map(|(x, y)| format!("({x:?}, {y:?})")).collect::<Vec<_>>().join(", ");
        let sets = self.sets.iter().enumerate().map(|(number, set)| format!("s{number} = points({})", points(set)));
        let rules =
            self.rules.iter().enumerate().map(|(rule, (set, _))| format!("rule i{rule} is full => y is s{set}"));
        let implied = if self.implied == Implied::Clipped { "min" } else { "product" };
        let joined = if self.joined == Joined::Largest { "max" } else { "sum" };
        format!(
            "variable level: 1 in 0 .. 1 {{ full = ramp(0, 1) }}
             network n({}) using {{ implication {implied}, aggregation {joined}, defuzzify {using} }} {{
                 output y: m in {LOW} .. {HIGH} default 7 m {{ {} }}
                 {}
             }}",
            inputs.join(", "),
            sets.collect::<Vec<_>>().join("\n"),
            rules.collect::<Vec<_>>().join("\n"),
        )
    }

    /// What the network makes of it.
    fn answer(&self, using: &str) -> f64 {
        let strengths: Vec<_> = self.rules.iter().map(|(_, strength)| *strength).collect();
        value(&self.text(using), &strengths).0
    }
}

fn planned(text: &str) -> NetworkPlan {
    let analysis = analyze_texts(&[("n.fsfn", text)]);
    let checked = analysis.checked().unwrap_or_else(|| panic!("{text}\n{}", report(&analysis)));
    plan::build_network(checked, Id::new(0))
}

/// The first output of a network, and whether a rule fired.
fn value(text: &str, readings: &[f64]) -> (f64, bool) {
    let plan = planned(text);
    let mut evaluator = Evaluator::new(&plan);
    let readings: Vec<_> = readings.iter().map(|&value| Reading { value, healthy: true }).collect();
    evaluator.evaluate(&readings, 0);
    (evaluator.real(plan.outputs[0].value), evaluator.bool(plan.outputs[0].fired))
}

/// Two to five sets of all kinds that overlap as they will, also three at once, with steps and shoulders, and beyond the
/// range; with one rule each and some more.
fn random(seed: u64, implied: Implied, joined: Joined) -> Problem {
    let mut random = Random(seed);
    let count = 2 + random.up_to(4) as usize;
    let mut sets = Vec::new();
    for _ in 0..count {
        let mut corners: Vec<f64> = (0..4).map(|_| random.up_to(60) as f64 - 20.0).collect();
        corners.sort_by(f64::total_cmp);
        let [a, b, c, d] = [corners[0], corners[1], corners[2], corners[3]];
        // In sight of the range.
        let shift = if d <= LOW + 1.0 {
            LOW + 2.0 - d
        } else if a >= HIGH - 1.0 {
            HIGH - 2.0 - a
        } else {
            0.0
        };
        let [a, b, c, d] = [a + shift, b + shift, c + shift, d + 0.5 + shift];
        sets.push(match random.up_to(4) {
            0 => vec![(a, 0.0), (b, 1.0), (d, 0.0)],
            1 => vec![(a, 0.0), (b, 1.0), (c, 1.0), (d, 0.0)],
            2 => vec![(a, 0.0), (a, 1.0), (d, 1.0), (d, 0.0)],
            _ => vec![(a, 0.25), (b, 1.0), (c, 0.5), (c, 0.75), (d, 0.0)],
        });
    }
    let rules = (0..count + random.up_to(3) as usize).map(|rule| (rule % count, 0.02 + 0.98 * random.strength()));
    let rules = rules.collect();
    Problem { sets, rules, implied, joined }
}

const CHOICES: [(Implied, Joined); 4] = [
    (Implied::Clipped, Joined::Largest),
    (Implied::Clipped, Joined::Added),
    (Implied::Scaled, Joined::Largest),
    (Implied::Scaled, Joined::Added),
];

/// What is asked of exact answers, as a share of the range.
const SHARE: f64 = 2e-9;

#[test]
fn centroids_are_exact() {
    for (implied, joined) in CHOICES {
        for seed in 0..40 {
            let problem = random(seed, implied, joined);
            let (found, wanted) = (problem.answer("centroid"), problem.centroid());
            assert!((found - wanted).abs() < SHARE * (HIGH - LOW), "{seed} {implied:?} {joined:?}: {found} {wanted}");
        }
    }
}

#[test]
fn bisectors_are_exact() {
    for (implied, joined) in CHOICES {
        for seed in 0..20 {
            let problem = random(seed, implied, joined);
            let found = problem.answer("bisector");
            let (below, all) = (problem.area(found), problem.area(HIGH));
            assert!((below / all - 0.5).abs() < 1e-9, "{seed} {implied:?} {joined:?}: {found}, {below} of {all}");
        }
    }
}

/// How finely maxima are looked for.
const PARTS: u32 = 20_000;

#[test]
fn maxima_are_where_the_degree_is_largest() {
    for (implied, joined) in CHOICES {
        for seed in 0..12 {
            let problem = random(seed, implied, joined);
            let xs = (0..=PARTS).map(|part| LOW + (HIGH - LOW) * f64::from(part) / f64::from(PARTS));
            let seen: Vec<_> = xs.map(|x| (x, problem.at(x))).collect();
            let top = seen.iter().map(|(_, degree)| *degree).fold(0.0, f64::max);
            // The degree at a step is the larger one, so steps are seen from both sides.
            let highest: Vec<_> = seen.iter().filter(|(_, degree)| *degree > top - 1e-9).map(|(x, _)| *x).collect();
            let (first, last) = (highest[0], highest[highest.len() - 1]);
            let part = (HIGH - LOW) / f64::from(PARTS);
            let close = |found: f64, wanted: f64| (found - wanted).abs() < 2.0 * part;
            let [small, large] = ["smallest_of_maximum", "largest_of_maximum"].map(|using| problem.answer(using));
            assert!(
                close(small, first) && close(large, last),
                "{seed} {implied:?} {joined:?} {small} {first} {large} {last}"
            );
            let mean = highest.iter().sum::<f64>() / highest.len() as f64;
            let found = problem.answer("mean_of_maximum");
            assert!((found - mean).abs() < 0.01, "{seed} {implied:?} {joined:?}: {found} {mean}");
        }
    }
}

#[test]
fn midpoints_are_the_sums_of_other_tools() {
    for (implied, joined) in CHOICES {
        for seed in 0..10 {
            let problem = random(seed, implied, joined);
            let xs: Vec<_> = (0..200).map(|part| LOW + (f64::from(part) + 0.5) * (HIGH - LOW) / 200.0).collect();
            let area: f64 = xs.iter().map(|&x| problem.at(x)).sum();
            let moment: f64 = xs.iter().map(|&x| problem.at(x) * x).sum();
            let found = problem.answer("centroid midpoints 200");
            assert!((found - moment / area).abs() < 1e-12 * (HIGH - LOW), "{seed}: {found} {}", moment / area);
        }
    }
}

/// Three sets that share their middles, and two that are single values.
fn symmetric(strengths: [f64; 3]) -> Problem {
    let sets = vec![
        vec![(-10.0, 0.0), (0.0, 1.0), (10.0, 0.0)],
        vec![(0.0, 0.0), (10.0, 1.0), (20.0, 0.0)],
        vec![(10.0, 0.0), (20.0, 1.0), (30.0, 0.0)],
    ];
    let rules = strengths.into_iter().enumerate().collect();
    Problem { sets, rules, implied: Implied::Clipped, joined: Joined::Largest }
}

#[test]
fn what_is_symmetric_has_its_middle_as_answer() {
    for using in ["centroid", "bisector", "mean_of_maximum", "weighted_average", "centroid midpoints 100"] {
        let found = symmetric([1.0; 3]).answer(using);
        assert!((found - 10.0).abs() < 1e-12, "{using}: {found}");
        let found = symmetric([0.0, 0.3, 0.0]).answer(using);
        assert!((found - 10.0).abs() < 1e-12, "{using}: {found}");
    }
    // Clipped at 1/2, the outermost sets are highest from -5 on and up to 25.
    assert_eq!(symmetric([0.5; 3]).answer("smallest_of_maximum"), -5.0);
    assert_eq!(symmetric([0.5; 3]).answer("largest_of_maximum"), 25.0);
    assert_eq!(symmetric([0.25, 0.5, 0.25]).answer("smallest_of_maximum"), 5.0);
    assert_eq!(symmetric([0.25, 0.75, 0.0]).answer("weighted_average"), 7.5);
}

#[test]
fn without_a_rule_that_fires_the_default_holds() {
    for using in ["centroid", "bisector", "mean_of_maximum", "weighted_average", "centroid midpoints 100"] {
        let text = symmetric([0.0; 3]).text(using);
        assert_eq!(value(&text, &[0.0; 3]), (7.0, false), "{using}");
        // As good as none, and less than the smallest degree that is one.
        assert_eq!(value(&text, &[5e-324, 0.0, 0.0]), (7.0, false), "{using}");
        let (least, fired) = value(&text, &[1e-29, 0.0, 0.0]);
        assert!(fired && least.abs() < 1e-6, "{using}: {least}");
    }
}

#[test]
fn no_reading_makes_an_output_what_is_no_number() {
    for using in ["centroid", "bisector", "smallest_of_maximum", "weighted_average", "centroid midpoints 9"] {
        for (implied, joined) in CHOICES {
            let problem = random(3, implied, joined);
            let plan = planned(&problem.text(using));
            let mut evaluator = Evaluator::new(&plan);
            let odd = [f64::NAN, f64::INFINITY, -1.0, 0.0, 5e-324, 1e-300, 1e-30, 1e-16, 0.5, 1.0 - 1e-16, 1.0, 2.0];
            for (index, first) in odd.iter().enumerate() {
                for second in odd {
                    let mut readings = vec![Reading { value: second, healthy: index % 3 != 0 }; plan.inputs.len()];
                    readings[0].value = *first;
                    let used = allocation_counter::measure(|| evaluator.evaluate(&readings, 0));
                    assert_eq!(used.count_total, 0);
                    let value = evaluator.real(plan.outputs[0].value);
                    assert!((LOW..=HIGH).contains(&value), "{using}: {value}");
                }
            }
        }
    }
}

#[test]
fn an_output_holds_its_last_value() {
    let text = symmetric([0.0; 3]).text("centroid").replace("default 7 m", "default hold");
    let plan = planned(&text);
    let mut evaluator = Evaluator::new(&plan);
    let mut at = |readings: [f64; 3]| {
        evaluator.evaluate(&readings.map(|value| Reading { value, healthy: true }), 0);
        (evaluator.real(plan.outputs[0].value), evaluator.bool(plan.outputs[0].fired))
    };
    assert_eq!(at([0.0; 3]), (0.0, false), "the value nearest to 0, before any rule fired");
    let (set, fired) = at([0.0, 0.0, 0.8]);
    assert!(fired && (set - 20.0).abs() < 1e-12, "{set}");
    assert_eq!(at([0.0; 3]), (set, false));
    assert_eq!(at([f64::NAN, 0.0, 0.0]), (set, false));
}

#[test]
fn norms_are_what_their_names_say() {
    type Norm = fn(f64, f64) -> f64;
    let t_norms: [(&str, Norm); 7] = [
        ("min", f64::min),
        ("product", |a, b| a * b),
        ("bounded_difference", |a, b| (a + b - 1.0).max(0.0)),
        ("drastic_product", |a, b| {
            if a == 1.0 {
                b
            } else if b == 1.0 {
                a
            } else {
                0.0
            }
        }),
        ("einstein_product", |a, b| a * b / (1.0 + (1.0 - a) * (1.0 - b))),
        ("hamacher_product", |a, b| if a == 0.0 && b == 0.0 { 0.0 } else { a * b / (a + b - a * b) }),
        ("nilpotent_minimum", |a, b| if a + b > 1.0 { a.min(b) } else { 0.0 }),
    ];
    let s_norms =
        ["max", "probabilistic_sum", "bounded_sum", "drastic_sum", "einstein_sum", "hamacher_sum", "nilpotent_maximum"];
    for ((and, t_norm), or) in t_norms.into_iter().zip(s_norms) {
        let text = format!(
            "variable level: 1 in 0 .. 1 {{ full = ramp(0, 1) }}
             network n(a: level, b: level) using {{ and {and}, or {or} }} {{
                 output y: 1 default 0 = takagi_sugeno
                 rule a is full and b is full => y = 1
                 rule a is full or b is full => y = 2 weight 0.5
                 rule not (a is full) => y = 3
             }}"
        );
        let plan = planned(&text);
        let mut evaluator = Evaluator::new(&plan);
        let degrees = [0.0, 0.125, 0.25, 0.5, 0.625, 0.75, 0.875, 1.0];
        for (a, b) in degrees.iter().flat_map(|&a| degrees.map(|b| (a, b))) {
            evaluator.evaluate(&[a, b].map(|value| Reading { value, healthy: true }), 0);
            let strengths: Vec<_> = plan.outputs[0].strengths.iter().map(|&real| evaluator.real(real)).collect();
            // Each s-norm is the dual of the t-norm beside it.
            let wanted = [t_norm(a, b), 0.5 * (1.0 - t_norm(1.0 - a, 1.0 - b)), 1.0 - a];
            let close = strengths.iter().zip(wanted).all(|(found, wanted)| (found - wanted).abs() < 1e-15);
            assert!(close, "{and} {or} of {a} and {b}: {strengths:?} {wanted:?}");
        }
    }
}

#[test]
fn linear_consequents_are_weighted_in_their_units() {
    let text = "variable distance: m in 0 .. 10 { near = ramp(10, 0)  far = ramp(0, 10) }
        network n(ahead: distance, aside: distance) {
            output speed: cm/s = takagi_sugeno
            output slow: m/s in 0 .. 1 = takagi_sugeno
            rule ahead is near => speed = 5 and slow = 9
            rule ahead is far  => speed = 2 * (ahead - aside / 4) / 10 s + 3 cm/s weight 0.5 and slow = 0.25
        }";
    let text = text.replace("weight 0.5 and slow = 0.25", "and slow = 0.25 weight 0.5");
    // ahead 8 m: strengths 0.2 and 0.4; 5 cm/s, and 0.2/s (8 m - 1 m) + 3 cm/s.
    let (found, fired) = value(&text, &[8.0, 4.0]);
    let wanted = (0.2 * 0.05 + 0.4 * (0.2 * 7.0 + 0.03)) / 0.6;
    assert!(fired && (found - wanted).abs() < 1e-15, "{found} {wanted}");
    let plan = planned(&text);
    let mut evaluator = Evaluator::new(&plan);
    evaluator.evaluate(&[0.0, 0.0].map(|value| Reading { value, healthy: true }), 0);
    assert_eq!(evaluator.real(plan.outputs[1].value), 1.0, "kept in its range");
}

#[test]
fn smooth_sets_take_midpoints_or_weighted_averages() {
    let network = |using: &str| {
        format!(
            "variable level: 1 in 0 .. 1 {{ low = ramp(1, 0)  high = ramp(0, 1) }}
             network n(a: level) using {{ defuzzify {using} }} {{
                 output y: deg in -90 .. 90 {{ left = gaussian(-40, 10)  right = s_shape(0, 60) }}
                 rule a is low => y is left
                 rule a is high => y is right
             }}"
        )
    };
    let (found, _) = value(&network("centroid midpoints 1000"), &[0.0]);
    assert!((found.to_degrees() + 40.0).abs() < 1e-3, "{found}");
    let (found, _) = value(&network("weighted_average"), &[0.25]);
    assert!((found.to_degrees() - (-40.0 * 0.75 + 75.0 * 0.25)).abs() < 1e-12, "{found}");
    for using in ["centroid", "bisector", "mean_of_maximum"] {
        let analysis = analyze_texts(&[("n.fsfn", &network(using))]);
        let codes: Vec<_> = doubts(&analysis).iter().map(|finding| finding.rule.code).collect();
        assert_eq!(codes, ["LM0529", "LM0529"], "{using}");
    }
}

#[test]
fn actions_take_outputs() {
    struct Told(Vec<(u32, Vec<f64>)>);
    impl Actuators for Told {
        fn command(&mut self, action: u32, arguments: &[f64], _: bool) {
            self.0.push((action, arguments.to_vec()));
        }
    }
    let pace = "variable distance: m in 0 .. 10 { near = ramp(10, 0)  far = ramp(0, 10) }
        network pace(ahead: distance) {
            output speed: m/s = takagi_sugeno
            rule ahead is near => speed = ahead / 2 s
            rule ahead is far => speed = 5
        }";
    let cart = "import pace
        robot cart { sensor ahead: m in 0 .. 10 fails 0 m  action go(speed: m/s)  action left(at: m/s) }
        behavior creep on cart {
            sense pace(ahead)
            entry ahead
            mode ahead { go(speed)  on exit { left(pace.speed) }  1: after 1 s -> rest }
            final mode rest { go(0 m/s) }
        }";
    let analysis = analyze_texts(&[("cart.msd", cart), ("pace.fsfn", pace)]);
    assert!(doubts(&analysis).is_empty(), "{}", report(&analysis));
    let plan = plan::build_alone(analysis.checked().unwrap(), Id::new(0), &[]);
    let (mut machine, mut told) = (Machine::new(&plan, 0), Told(Vec::new()));
    for (ahead, healthy) in [(10.0, true), (5.0, true), (5.0, false), (0.0, true)] {
        let readings = [Reading { value: ahead, healthy }];
        machine.step(Inputs { readings: &readings, done: false }, 400_000_000, &mut told);
    }
    let [speed, half] = [5.0, 3.75];
    let wanted = [(0, vec![speed]), (0, vec![half]), (0, vec![0.0]), (1, vec![0.0]), (0, vec![0.0])];
    assert_eq!(told.0, wanted);
}

#[test]
fn an_evaluation_shows_outputs() {
    let text = symmetric([0.0; 3]).text("centroid");
    let plan = planned(&text);
    let mut evaluator = Evaluator::new(&plan);
    let readings = [0.25, 0.0, 0.0].map(|value| Reading { value, healthy: true });
    evaluator.evaluate(&readings, 0);
    let evaluated = Evaluated { plan: &plan, evaluator: &evaluator, readings: &readings };
    let json: serde_json::Value = serde_json::from_str(&reports::eval_json(&evaluated)).unwrap();
    let value = json["outputs"]["y"]["value"].as_f64().unwrap();
    assert!(json["outputs"]["y"]["fired"] == true && value.abs() < 1e-12, "{json}");
    let shown = reports::eval(&evaluated, false);
    assert!(shown.contains("\n  y  0 m\n    strongest    █████···············  0.250  rule 1 0.250\n"), "{shown}");
    let table = reports::eval_csv(&plan, "i0,i1,i2\n0,0,0\n0,0.5,0\n", 0).unwrap();
    assert_eq!(table, "i0,i1,i2,y,y.fired\n0.0,0.0,0.0,7.0,false\n0.0,0.5,0.0,10.0,true\n");
}

#[test]
fn what_was_understood_of_outputs_is_listed() {
    let text = "variable level: 1 in 0 .. 1 { low = ramp(1, 0)  high = ramp(0, 1) }
        network n(a: level, b: level) using { and product, defuzzify centroid midpoints 9 } {
            output y: cm in 0 .. 100 default hold { all = rectangle(0, 100) }
            output z: m/s = takagi_sugeno
            rule not (a is low and b is any of {low, high}) => y is all and z = a * 2 m/s - 1 weight 0.5
            rule a is high or a is low => z = 3
        }";
    let analysis = analyze_texts(&[("n.fsfn", text)]);
    insta::assert_snapshot!(lmslc::view::program(&analysis.program), @r"
    variable level: 1 in 0 .. 1
        low = ramp(1, 0)
        high = ramp(0, 1)

    network n(a: level, b: level) using { and product, or max, implication min, aggregation max, defuzzify centroid midpoints 9 }
        output y: m in 0 .. 1 default hold
            all = rectangle(0, 1)
            rule not ((a is low) and (b is any of {low, high})) => y is all weight 0.5
        output z: m/s = takagi_sugeno
            rule not ((a is low) and (b is any of {low, high})) => z = -1 + 2 * a weight 0.5
            rule ((a is high) or (a is low)) => z = 3
    ");
}
