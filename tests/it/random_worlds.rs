//! Random worlds: whatever stands in them and whatever a robot is told, nothing ever gets into anything else.

use std::f64::consts::PI;
use std::ops::Range;

use lmslc::base::{Id, Span};
use lmslc::driver::{FileError, Files, Options, analyze};
use lmslc::ir::{self, Placement};
use lmslc::kernel::next_random;
use lmslc::sim::Simulation;

/// A robot of LABMATE's size with sonars that are read on every tick, and what it can be told.
const ROVER: &str = "
    robot rover {
        body differential_drive { mass 50 kg  size (0.81 m, 0.75 m)  track 0.6 m  traction 0.5 }
        sensor sonar[24]: m in 15 cm .. 10 m  fails 10 m  = ring.range  accuracy 2.5 cm  beam 15 deg
        sensor front: contact  fails set  = bumper.front
        sensor back:  contact  fails set  = bumper.back
        action stop()                            = body.stop()
        action travel(distance: m, speed: m/s)   = body.travel(distance, speed)
        action turn(angle: rad) -> done          = body.rotate(angle)
        action drive(speed: m/s, rate: rad/s)    = body.velocity(speed, rate)
    }
    behavior idle on rover { entry rest  final mode rest { stop() } }
    scenario empty runs idle { duration 1 s }
";

/// ns
pub const TICK: u64 = 10_000_000;
/// What is shared by less than this is touched, m.
const SKIN: f64 = 1e-5;

struct Text;

impl Files for Text {
    fn read(&self, path: &str) -> Result<String, FileError> {
        if path == "main.msd" { Ok(ROVER.to_owned()) } else { Err(FileError::Missing) }
    }
}

/// The program of the rover, with an empty scenario.
pub fn rover() -> ir::Program {
    let analysis = analyze(&Text, &["main.msd".to_owned()], &Options::default());
    assert!(!analysis.has_errors(), "{:?}", analysis.findings);
    analysis.program
}

/// Random numbers.
pub struct Random(pub u64);

impl Random {
    pub fn below(&mut self, limit: u64) -> u64 {
        next_random(&mut self.0) % limit
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (next_random(&mut self.0) >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Tells a robot something.
    pub fn command(&mut self, robot: &mut Simulation<'_>) {
        match self.below(8) {
            0 => robot.command(0, &[], true),
            1 => robot.command(1, &[self.between(-2.0, 2.0), self.between(-1.0, 1.0)], true),
            2 => robot.command(1, &[0.0, self.between(-1.0, 1.0)], true),
            3 | 4 => robot.command(2, &[self.between(-PI, PI)], true),
            _ => robot.command(3, &[self.between(-1.0, 1.0), self.between(-1.5, 1.5)], true),
        }
    }
}

/// Something rectangular: its middle, its heading, half its length and half its width.
type Body = ([f64; 2], f64, [f64; 2]);

/// Whether a straight line reaches into a body, by cutting off what is beside it (Liang and Barsky 1984).
fn pierces([from, to]: [[f64; 2]; 2], (middle, heading, half): Body) -> bool {
    let seen = [from, to].map(|[x, y]| {
        let ([x, y], (sin, cos)) = ([x - middle[0], y - middle[1]], heading.sin_cos());
        [x * cos + y * sin, y * cos - x * sin]
    });
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let (start, along) = (seen[0][axis], seen[1][axis] - seen[0][axis]);
        let bound = half[axis] - SKIN;
        if along == 0.0 {
            if start.abs() >= bound {
                return false;
            }
            continue;
        }
        let [one, other] = [(-bound - start) / along, (bound - start) / along];
        first = first.max(one.min(other));
        last = last.min(one.max(other));
    }
    first < last
}

fn sides((middle, heading, half): Body) -> [[[f64; 2]; 2]; 4] {
    let (sin, cos) = heading.sin_cos();
    let corner = |along: f64, across: f64| {
        let (x, y) = (along * half[0], across * half[1]);
        [middle[0] + x * cos - y * sin, middle[1] + x * sin + y * cos]
    };
    let corners = [corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)];
    [0, 1, 2, 3].map(|side| [corners[side], corners[(side + 1) % 4]])
}

/// Whether two straight lines cross.
fn cross([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let side = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
}

/// A room with a bent outline, a partition with a doorway, walls that stand about, and boxes.
fn scenario(program: &ir::Program, random: &mut Random) -> ir::Scenario {
    let mut bent = |x: f64, y: f64| [x + random.between(-0.5, 0.5), y + random.between(-0.5, 0.5)];
    let outline = [bent(-3.0, -2.0), bent(3.0, -2.0), bent(4.0, 0.0), bent(3.0, 2.0), bent(-3.0, 2.0)];
    let mut lines = vec![[outline.as_slice(), &[outline[0]]].concat()];
    let door = random.between(-1.0, 1.0);
    lines.push(vec![[1.2, -3.0], [1.2, door - 0.45]]);
    lines.push(vec![[1.2, door + 0.45], [1.2, 3.0]]);
    for _ in 0..random.below(6) {
        let from = [random.between(-3.0, 3.0), random.between(-2.0, 2.0)];
        lines.push(vec![from, [from[0] + random.between(-1.5, 1.5), from[1] + random.between(-1.5, 1.5)]]);
    }
    let start = Placement::At { x: 0.0, y: 0.0, heading: random.between(-PI, PI) };
    let mut scenario = ir::Scenario { start, ..program.scenarios[Id::new(0)].clone() };
    let can_start = |scenario: &ir::Scenario| Simulation::new(program, scenario, [].iter(), 0).is_ok();
    for corners in lines {
        scenario.walls.push(ir::Wall { corners, is_door: false, span: Span::default() });
        if !can_start(&scenario) {
            scenario.walls.pop();
        }
    }
    for _ in 0..random.below(7) {
        scenario.boxes.push(ir::BoxBody {
            name: "crate".to_owned(),
            mass: random.between(2.0, 120.0),
            length: random.between(0.02, 0.8),
            width: random.between(0.02, 0.8),
            place: Placement::At {
                x: random.between(-3.0, 3.0),
                y: random.between(-2.0, 2.0),
                heading: random.between(-PI, PI),
            },
            span: Span::default(),
        });
        if !can_start(&scenario) {
            scenario.boxes.pop();
        }
    }
    scenario
}

/// Drives robots through random worlds, one for each seed, for three seconds each.
///
/// # Panics
///
/// Where a robot or a box reaches into something or passes a wall, and where a reading is out of its range.
pub fn try_worlds(program: &ir::Program, seeds: Range<u64>) {
    for seed in seeds {
        let mut random = Random(seed);
        let scenario = scenario(program, &mut random);
        let walls: Vec<[[f64; 2]; 2]> =
            scenario.walls.iter().flat_map(|wall| wall.corners.windows(2)).map(|ends| [ends[0], ends[1]]).collect();
        let halves: Vec<[f64; 2]> = std::iter::once([0.405, 0.375])
            .chain(scenario.boxes.iter().map(|one| [one.length / 2.0, one.width / 2.0]))
            .collect();
        let mut robot = Simulation::new(program, &scenario, [].iter(), seed).unwrap();
        let bodies = |robot: &Simulation<'_>| -> Vec<Body> {
            robot.poses().zip(&halves).map(|([x, y, heading], half)| ([x, y], heading, *half)).collect()
        };
        let mut before = bodies(&robot);
        for tick in 0..300 {
            if tick % 50 == 0 {
                random.command(&mut robot);
            }
            for reading in &robot.read(tick * TICK)[..24] {
                assert!(reading.healthy && (0.15..=10.0).contains(&reading.value), "seed {seed}: {reading:?}");
            }
            robot.advance(TICK);
            let after = bodies(&robot);
            for (index, (body, was)) in after.iter().zip(&before).enumerate() {
                assert!([body.0[0], body.0[1], body.1].iter().all(|number| number.is_finite()), "seed {seed}");
                for wall in &walls {
                    assert!(!pierces(*wall, *body), "seed {seed}, tick {tick}: {index} is in a wall");
                    assert!(!cross(*wall, [was.0, body.0]), "seed {seed}, tick {tick}: {index} passed a wall");
                }
                for (other, shape) in after.iter().enumerate().filter(|(other, _)| *other != index) {
                    let is_in = sides(*shape).iter().any(|side| pierces(*side, *body));
                    assert!(!is_in, "seed {seed}, tick {tick}: {other} is in {index}");
                }
            }
            before = after;
        }
    }
}

#[test]
fn in_random_worlds_nothing_gets_into_anything() {
    try_worlds(&rover(), 0..100);
}
