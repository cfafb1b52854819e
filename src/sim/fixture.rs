//! A robot, a behavior and a scenario for tests, built without the front end: the manipulation experiment with plain
//! thresholds on the force instead of a network.

use crate::base::{Dimension, Exact, Id, Span, Unit, find_unit};
use crate::ir;
use crate::ir::{BodyArgument, BodyCommandKind, SensorSource};
use crate::plan::{self, Comparison, Evidence, Origin, Plan, Step};

/// J5's body (LMSL §3), with tracking noise.
pub(super) const J5: ir::DifferentialDrive = ir::DifferentialDrive {
    mass: 59.0,
    length: 1.0,
    width: 0.75,
    track: 0.65,
    traction: 0.4,
    lag: 0.15,
    acceleration_limit: 1.0,
    impact_time: 0.05,
    tracking_noise: 0.2,
};

/// The positions of the modes of [`plan`].
pub(super) const MODES: [&str; 6] = ["init", "forward", "push", "stop", "back_up", "random_turn"];

fn symbol(name: &str) -> ir::Symbol {
    ir::Symbol { name: name.to_owned(), ..ir::Symbol::default() }
}

fn unit(name: &str) -> Unit {
    let found = find_unit(name).unwrap();
    Unit { text: name.to_owned(), scale: found.scale(), dimension: found.dimension }
}

fn acceleration() -> Unit {
    Unit { text: "m/s^2".to_owned(), scale: Exact::ONE, dimension: Dimension::of([1, 0, -2, 0, 0, 0]) }
}

fn whole(number: i128) -> Exact {
    Exact::new(number, 1, 0)
}

/// A program with one robot on a body, and no sensor noise.
pub(super) fn program(body: ir::DifferentialDrive) -> ir::Program {
    let mut program = ir::Program::default();
    let sensors = [
        ("left_acceleration", acceleration(), -4, 4, SensorSource::LeftWheelAcceleration),
        ("right_acceleration", acceleration(), -4, 4, SensorSource::RightWheelAcceleration),
        ("contact_force", unit("N"), 0, 400, SensorSource::WedgeForce),
    ];
    let sensors = sensors.map(|(name, unit, low, high, source)| {
        program.sensors.add(ir::Sensor {
            symbol: symbol(name),
            optional: true,
            unit,
            is_contact: false,
            group: None,
            kept: None,
            range: (whole(low), whole(high)),
            fails: Vec::new(),
            source: Some(source),
            noise: 0.0,
            accuracy: Exact::ZERO,
            period: 0,
            beam: 0.0,
        })
    });
    let parameter = BodyArgument::Parameter;
    let actions = [
        ("halt", BodyCommandKind::Stop, vec![]),
        ("drive", BodyCommandKind::Velocity, vec![parameter(0), BodyArgument::Constant(0.0)]),
        ("arc", BodyCommandKind::Arc, vec![parameter(0), parameter(1)]),
        ("turn", BodyCommandKind::Rotate, vec![parameter(0)]),
    ];
    let actions = actions.map(|(name, kind, arguments)| {
        program.actions.add(ir::Action {
            symbol: symbol(name),
            parameters: Vec::new(),
            reports_done: kind == BodyCommandKind::Rotate,
            command: Some(ir::BodyCommand { kind, arguments }),
            same_as: None,
        })
    });
    program.robots.add(ir::Robot {
        symbol: symbol("j5"),
        provides: Vec::new(),
        body: Some(ir::Body::DifferentialDrive(body)),
        sensors: sensors.to_vec(),
        logical: Vec::new(),
        senses: Vec::new(),
        actions: actions.to_vec(),
        drive: None,
    });
    program
}

/// A scenario of ten seconds without anything in it.
pub(super) fn scenario() -> ir::Scenario {
    ir::Scenario {
        symbol: symbol("tried"),
        diagram: Id::new(0),
        robot: Id::new(0),
        duration: 10_000_000_000,
        tick: 10_000_000,
        seed: 1,
        start: ir::Placement::At { x: 0.0, y: 0.0, heading: 0.0 },
        walls: Vec::new(),
        boxes: Vec::new(),
        goal: None,
        faults: Vec::new(),
        expectations: Vec::new(),
    }
}

/// A box of `mass` kg, 0.4 m long and 0.6 m wide.
pub(super) fn cargo(name: &str, mass: f64, place: ir::Placement) -> ir::BoxBody {
    ir::BoxBody { name: name.to_owned(), mass, length: 0.4, width: 0.6, place, span: Span::default() }
}

/// The manipulation experiment (LMSL fig. 10).
pub(super) fn manipulation() -> ir::Scenario {
    let boxes = vec![cargo("box1", 30.0, ir::Placement::Ahead(0.75)), cargo("box2", 90.0, ir::Placement::Ahead(1.5))];
    ir::Scenario { boxes, ..scenario() }
}

/// The behavior of the manipulation experiment: collisions and heavy boxes by the force alone, above 60 N and 170 N.
/// The watched conditions are: in `push`; force above 170 N.
pub(super) fn plan() -> Plan {
    const SPEED: u32 = 3;
    let constants = [60.0, 170.0, 0.26, 1.0, -0.2, 0.5, 0.0];
    let mut steps: Vec<Step> = constants.iter().zip(1..).map(|(&value, to)| Step::Constant { value, to }).collect();
    let constants = 0..steps.len() as u32;
    steps.push(Step::Read { input: 2, to: 0 });
    steps.push(Step::Compare { comparison: Comparison::Greater, left: 0, right: 1, to: 0 });
    steps.push(Step::Compare { comparison: Comparison::Greater, left: 0, right: 2, to: 1 });
    let fuse = constants.end..steps.len() as u32;
    let mut alone = |step| {
        steps.push(step);
        steps.len() as u32 - 1..steps.len() as u32
    };
    let after = |seconds: f64| Step::After { duration: (seconds * 1e9) as u64, to: 2 };
    let way = |(priority, steps, condition, target, evidence)| plan::Transition {
        priority,
        steps,
        condition,
        target,
        span: Span::default(),
        text: "as written".to_owned(),
        evidence: vec![evidence],
        parts: Vec::new(),
    };
    let (force, event) = (Evidence::Input(2), Evidence::Event(0));
    let ways = [
        vec![(1, alone(after(2.0)), 2, 1, Evidence::Dwell)],
        vec![(1, 0..0, 1, 3, force), (2, 0..0, 0, 2, event)],
        vec![(1, 0..0, 1, 3, force), (2, alone(after(4.0)), 2, 1, Evidence::Dwell)],
        vec![(1, alone(after(0.5)), 2, 4, Evidence::Dwell)],
        vec![(1, alone(after(1.5)), 2, 5, Evidence::Dwell)],
        vec![(1, alone(Step::Done { to: 2 }), 2, 1, Evidence::Dwell)],
    ];
    let watch = alone(Step::InMode { mode: 2, to: 3 });
    let call = |action, arguments| plan::Call { action, arguments };
    let calls = vec![call(0, 0..0), call(1, 0..1), call(2, 0..2), call(0, 0..0), call(1, 2..3), call(3, 3..4)];
    let mut transitions = Vec::new();
    let modes = MODES.iter().zip(ways).zip(0..).map(|((name, ways), index)| {
        let first = transitions.len() as u32;
        transitions.extend(ways.into_iter().map(way));
        plan::Mode {
            name: (*name).to_owned(),
            origin: Origin::default(),
            transitions: first..transitions.len() as u32,
            actions: index..index + 1,
            rows: 0..0,
            on_enter: 0..0,
            on_exit: 0..0,
            draws: if *name == "random_turn" { 0..1 } else { 0..0 },
            required: 0..0,
            is_final: false,
            runs: None,
            otherwise: None,
        }
    });
    let modes = modes.collect();
    let input = |name: &str, unit, low, high| plan::Input {
        name: name.to_owned(),
        origin: Origin::default(),
        unit,
        low,
        high,
        fail: 0.0,
    };
    Plan {
        position: 0,
        inner: Vec::new(),
        name: "manipulation".to_owned(),
        origin: Origin::default(),
        robot: "j5".to_owned(),
        inputs: vec![
            input("left_acceleration", acceleration(), -4.0, 4.0),
            input("right_acceleration", acceleration(), -4.0, 4.0),
            input("contact_force", unit("N"), 0.0, 400.0),
        ],
        logical: Vec::new(),
        actions: Vec::new(),
        code: plan::Code { steps, reals: 9, bools: 4, ..plan::Code::default() },
        fuse,
        watch,
        senses: Vec::new(),
        events: vec![plan::Event {
            name: "hit".to_owned(),
            origin: Origin::default(),
            contributor: 0,
            detractor: 1,
            flag: 0,
        }],
        strengths: vec![(vec![0], vec![1])],
        outputs: Vec::new(),
        flags: vec![plan::Flag { name: "heavy".to_owned(), origin: Origin::default(), value: 1 }],
        remembered: Vec::new(),
        watched: vec![3, 1],
        modes,
        transitions,
        rows: Vec::new(),
        calls,
        arguments: vec![SPEED, 4, 5, 8],
        draws: vec![plan::Draw { low: -2.0, high: 2.0, to: 8 }],
        required: Vec::new(),
        constants,
        entry: 0,
        arbiter: None,
        drive: None,
    }
}
