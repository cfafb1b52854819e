//! The navigator of Khatoon and Ibraheem (2012): exact answers, and the holes of the printed one.

use lmslc::base::Id;
use lmslc::interp::{Evaluator, Reading};
use lmslc::plan;

use crate::support::{analyze_path, report};

/// What is asked of exact answers, as a share of the range.
const SHARE: f64 = 2e-9;

/// The published sets of the navigator over their ranges, from the paper's tables 3 and 4; the outermost ones of
/// steering reach the ends.
mod khatoon {
    pub const DIRECTIONS: [[f64; 3]; 5] =
        [[-185.0, -180.0, -90.0], [-180.0, -90.0, 0.0], [-5.0, 0.0, 5.0], [0.0, 90.0, 180.0], [90.0, 180.0, 185.0]];
    pub const STEERING: [[f64; 3]; 5] =
        [[-40.0, -40.0, -20.0], [-40.0, -20.0, 0.0], [-5.0, 0.0, 5.0], [0.0, 20.0, 40.0], [20.0, 40.0, 40.0]];
    pub const SPEED: [[f64; 3]; 2] = [[0.0, 1.0, 1.2], [1.0, 1.8, 2.0]];
}

fn triangle([a, b, c]: [f64; 3], x: f64) -> f64 {
    let rise = if x >= b { 1.0 } else { (x - a) / (b - a) };
    let fall = if x <= b { 1.0 } else { (c - x) / (c - b) };
    rise.min(fall).max(0.0)
}

/// How many parts there are between two corners of an integral.
const STEPS: u32 = 40_000;

/// The centroid of clipped triangles by the middle of very many parts, each of which lies between corners.
fn centroid_of(sets: &[[f64; 3]], strengths: &[f64], low: f64, high: f64) -> f64 {
    let mut cuts: Vec<f64> = sets.iter().flatten().copied().chain([low, high]).collect();
    cuts.sort_by(f64::total_cmp);
    cuts.dedup();
    let (mut area, mut moment) = (0.0, 0.0);
    for ends in cuts.windows(2) {
        let width = (ends[1] - ends[0]) / f64::from(STEPS);
        for part in 0..STEPS {
            let x = ends[0] + (f64::from(part) + 0.5) * width;
            let clipped = sets.iter().zip(strengths).map(|(set, strength)| triangle(*set, x).min(*strength));
            let degree = clipped.fold(0.0, f64::max);
            area += degree * width;
            moment += degree * width * x;
        }
    }
    moment / area
}

#[test]
fn the_navigator_answers_as_an_integral_does() {
    let analysis = analyze_path("stdlib/networks/navigator.fsfn");
    assert!(analysis.findings.is_empty(), "{}", report(&analysis));
    let plan = plan::build_network(analysis.checked().unwrap(), Id::new(0));
    let mut evaluator = Evaluator::new(&plan);
    let directions = [-180.0, -100.0, -2.5, 30.0, 135.0];
    let grid = directions.iter().flat_map(|&target| directions.map(|gate| (target, gate)));
    for (index, (target, gate)) in grid.enumerate() {
        let distance: f64 = [0.0, 3.0, 5.5, 6.4, 20.0, 77.0, 100.0][index % 7];
        let (left, right) = ([0.0, 4.5, 6.0, 9.0][index % 4], [5.0, 0.0, 30.0][index % 3]);
        let near = if distance <= 5.0 { 1.0 } else { (7.0 - distance).max(0.0) / 2.0 };
        let far = if distance >= 50.0 { 1.0 } else { (distance - 5.0).max(0.0) / 45.0 };
        let short = |room: f64| if room <= 4.0 { 1.0 } else { (7.0 - room).max(0.0) / 3.0 };
        let mut steering = [0, 1, 2, 3, 4].map(|set| {
            let [open, goal] = [gate, target].map(|at| triangle(khatoon::DIRECTIONS[set], at));
            open.min(near).max(goal.min(far))
        });
        steering[1] = steering[1].max(short(left));
        steering[3] = steering[3].max(short(right));
        let wanted = [
            centroid_of(&khatoon::STEERING, &steering, -40.0, 40.0),
            centroid_of(&khatoon::SPEED, &[near, far], 0.0, 2.0),
        ];
        let readings = [f64::to_radians(target), f64::to_radians(gate), distance, left, right];
        evaluator.evaluate(&readings.map(|value| Reading { value, healthy: true }), 0);
        let [angle, speed] = [&plan.outputs[0], &plan.outputs[1]].map(|output| evaluator.real(output.value));
        assert!((angle.to_degrees() - wanted[0]).abs() < SHARE * 80.0, "{index}: {} {}", angle.to_degrees(), wanted[0]);
        assert!((speed - wanted[1]).abs() < SHARE * 2.0, "{index}: {speed} {}", wanted[1]);
    }
}

#[test]
fn as_it_is_printed_the_navigator_rests_at_both_ends() {
    let analysis = analyze_path("stdlib/networks/navigator_as_printed.fsfn");
    assert!(analysis.findings.is_empty(), "{}", report(&analysis));
    let plan = plan::build_network(analysis.checked().unwrap(), Id::new(0));
    let mut evaluator = Evaluator::new(&plan);
    let mut at = |obstacle: f64| {
        let readings = [0.5, -0.5, obstacle, 50.0, 50.0];
        evaluator.evaluate(&readings.map(|value| Reading { value, healthy: true }), 0);
        let [steering, speed] = [&plan.outputs[0], &plan.outputs[1]];
        let fired = [steering, speed].map(|output| evaluator.bool(output.fired));
        (fired, evaluator.real(steering.value), evaluator.real(speed.value))
    };
    for hole in [0.0, 100.0] {
        assert_eq!(at(hole), ([false; 2], 0.0, 0.0), "{hole}");
    }
    // The printed rules are fast near an obstacle, and slow far from all.
    assert!(at(5.0).2 > 1.4 && at(50.0).2 < 1.0 && at(50.0).0 == [true; 2]);
}
