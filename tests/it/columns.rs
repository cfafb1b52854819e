//! Columns of readings: what is computed in blocks is what is computed one by one, to the last bit.

use lmslc::base::Id;
use lmslc::interp::{Columns, Evaluator, Reading};
use lmslc::kernel::next_random;
use lmslc::plan::{self, NetworkPlan};

use crate::support::{analyze_path, analyze_texts, report};

/// Everything that a step can be in a network, and all that remembers.
const MANY: &str = "
    variable v: 1 in 0 .. 10 fails 4 {
        low = ramp(6, 2)  mid = gaussian(5, 1)  high = points((2, 0), (7, 1), (9, 0.5))
        odd = very low or not high  edge = rectangle(3, 4)
    }
    network n(a: v, b: v) using { or probabilistic_sum } {
        event plain { contributor (low, _) (edge, {mid, odd}) detractor (high, -) }
        event slow hysteresis 0.1 hold 30 ms confirm 20 ms { contributor (low, -) detractor (high, mid) }
        output kept: 1 in 0 .. 4 default hold { small = triangle(0, 1, 2)  large = triangle(1, 3, 4) }
        output half: 1 in 0 .. 4 default 2 { small = triangle(0, 1, 2)  large = ramp(1, 3) }
        output line: 1 default 0 = takagi_sugeno
        rule a is edge => kept is small
        rule b is edge and a is high => kept is large and half is large weight 0.7
        rule a is low or b is low => line = 2 * a + 1
        rule a is mid => line = b
        rule a is odd => half is small
    }";

/// Compares on random readings, good and bad ones, more than a block of them.
fn agree(plan: &NetworkPlan, state: &mut u64) {
    let odd = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1e300, 0.0, -0.0, 3.0, 1e300];
    let mut number = || match next_random(state) % 8 {
        0 => odd[(next_random(state) % 8) as usize],
        _ => (next_random(state) % 1000) as f64 / 37.0 - 5.0,
    };
    let (mut single, mut columns) = (Evaluator::new(plan), Columns::new(plan));
    for rows in [Columns::BLOCK, 1, 0, 17, Columns::BLOCK, 3] {
        let readings: Vec<Vec<f64>> =
            plan.inputs.iter().map(|_| std::iter::repeat_with(&mut number).take(rows).collect()).collect();
        columns.evaluate(&readings, 10_000_000);
        for row in 0..rows {
            let one: Vec<_> = readings.iter().map(|column| Reading { value: column[row], healthy: true }).collect();
            single.evaluate(&one, 10_000_000);
            for real in 0..plan.code.reals {
                let (found, wanted) = (columns.reals(real)[row], single.real(real));
                assert_eq!(found.to_bits(), wanted.to_bits(), "{}: real {real} in row {row}", plan.name);
            }
            for bool in 0..plan.code.bools {
                assert_eq!(columns.bools(bool)[row], single.bool(bool), "{}: bool {bool} in row {row}", plan.name);
            }
        }
        assert!((0..plan.code.reals).all(|real| columns.reals(real).len() == rows));
    }
}

#[test]
fn columns_are_what_single_readings_are() {
    let mut state = 5;
    let many = analyze_texts(&[("n.fsfn", MANY)]);
    assert!(!many.has_errors(), "{}", report(&many));
    for analysis in
        [many, analyze_path("stdlib/networks/obstacle_id.fsfn"), analyze_path("stdlib/networks/navigator.fsfn")]
    {
        for network in 0..analysis.program.networks.len() as u32 {
            agree(&plan::build_network(analysis.checked().unwrap(), Id::new(network)), &mut state);
        }
    }
}
