//! The navigator as one writes it who knows what its sets hold, to the same bits.

use crate::emitted_navigator::navigator::Inputs;

fn least(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

fn most(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

fn clamp(x: f64, low: f64, high: f64) -> f64 {
    if x.is_finite() { most(least(x, high), low) } else { 0.0 }
}

/// A degree between 0 and 1 of something that is at most 1, or may be more.
fn positive(x: f64) -> f64 {
    most(0.0, x)
}

const QUARTER: f64 = std::f64::consts::FRAC_PI_2;
const HALF: f64 = std::f64::consts::PI;
const NARROW: f64 = 0.087_266_462_599_716_47;

/// The degrees of a direction: hard right, right, straight, left, hard left.
fn directions(x: f64) -> [f64; 5] {
    [
        positive((-QUARTER - x) / QUARTER),
        positive(least(x + HALF, -x) / QUARTER),
        positive(least(x + NARROW, NARROW - x) / NARROW),
        positive(least(x, HALF - x) / QUARTER),
        positive((x - QUARTER) / QUARTER),
    ]
}

/// Steering in rad and speed in m/s.
#[inline]
pub fn navigator(inputs: &Inputs) -> [f64; 2] {
    let target = directions(clamp(inputs.target, -HALF, HALF));
    let gate = directions(clamp(inputs.gate, -HALF, HALF));
    let obstacle = clamp(inputs.obstacle, 0.0, 100.0);
    let near = positive(least(1.0, (7.0 - obstacle) / 2.0));
    let far = positive(least(1.0, (obstacle - 5.0) / 45.0));
    let [left, right] = [inputs.left, inputs.right].map(|x| positive(least(1.0, (7.0 - clamp(x, 0.0, 100.0)) / 3.0)));
    let toward = |way: usize| most(least(gate[way], near), least(target[way], far));
    let (a, b, c) = (toward(0), most(toward(1), left), toward(2));
    let (d, e) = (most(toward(3), right), toward(4));
    // What two neighbors share, up to where they cross.
    let (ab, bc) = (least(least(a, b), 0.5), least(least(b, c), 0.2));
    let (cd, de) = (least(least(c, d), 0.2), least(least(d, e), 0.5));
    let area = a * (0.349_065_850_398_865_9 - a * 0.174_532_925_199_432_95)
        + b * (0.698_131_700_797_731_8 - b * 0.349_065_850_398_865_9)
        + c * (0.174_532_925_199_432_95 - c * 0.087_266_462_599_716_47)
        + d * (0.698_131_700_797_731_8 - d * 0.349_065_850_398_865_9)
        + e * (0.349_065_850_398_865_9 - e * 0.174_532_925_199_432_95)
        - ab * (0.349_065_850_398_865_9 - ab * 0.349_065_850_398_865_9)
        - bc * (0.087_266_462_599_716_47 - bc * 0.218_166_156_499_291_2)
        - cd * (0.087_266_462_599_716_47 - cd * 0.218_166_156_499_291_2)
        - de * (0.349_065_850_398_865_9 - de * 0.349_065_850_398_865_9);
    let outer =
        |s: f64| s * (0.182_770_451_872_025_15 - s * (0.060_923_483_957_341_72 + s * 0.020_307_827_985_780_572));
    let inner = |s: f64| s * (0.243_693_935_829_366_88 - s * 0.121_846_967_914_683_44);
    let shared = |s: f64| s * (0.182_770_451_872_025_15 - s * 0.182_770_451_872_025_15);
    let beside =
        |s: f64| s * (0.003_807_717_747_333_857_5 - s * (0.003_807_717_747_333_857_5 + s * 0.019_038_588_736_669_287));
    let moment = -outer(a) - inner(b) + inner(d) + outer(e) + shared(ab) + beside(bc) - beside(cd) - shared(de);
    // Some rule always fires.
    let steering = most(least(0.0 + moment / area, 0.698_131_700_797_731_8), -0.698_131_700_797_731_8);
    let both = least(least(near, far), 0.2);
    let area = near * (1.2 - near * 0.6) + far * (1.0 - far * 0.5) - both * (0.2 - both * 0.5);
    let moment = -(near * (0.48 - near * (0.48 - near * 0.16))) + far * (0.5 - far * (0.1 + far * 0.1))
        - both * (0.02 - both * (0.02 + both * 0.1));
    let speed = most(least(1.0 + moment / area, 2.0), 0.0);
    [steering, speed]
}
