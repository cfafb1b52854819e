//! A run of a scenario: sense, decide, move, on every tick.

use std::fmt;

use super::drive::Drive;
use super::expect::{Verdict, judge};
use super::random::{Purpose, Stream};
use super::record::Recorder;
use super::simulation::{Simulation, build};
use crate::base::Span;
use crate::diag::{Diagnostic, rules};
use crate::interp::{Inputs, Machine};
use crate::ir;
use crate::plan::Plan;
use crate::trace::{Footprint, Trace};

/// The most ticks of a run: more than a day at 10 ms, and about as much as fits into memory when recorded.
const MOST_TICKS: u64 = 10_000_000;

/// What a caller may change about a scenario.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunOptions {
    /// The seed of everything random, instead of the scenario's.
    pub seed: Option<u64>,
    /// Faults in addition to the scenario's; of two faults of one sensor the later one counts, and these come last.
    pub faults: Vec<ir::Fault>,
}

/// A run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// What happened.
    pub trace: Trace,
    /// What became of the scenario's expectations, in order.
    pub verdicts: Vec<Verdict>,
    /// For each event of the plan, whether each of its contributor rules and each of its detractor rules gave its side
    /// its strength on some tick, above 0.
    pub decided: Vec<(Vec<bool>, Vec<bool>)>,
}

/// Why a scenario cannot be run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RunError {
    /// Its robot has no body.
    NoBody,
    /// It would have this many ticks, more than can be recorded.
    TooLong(u64),
    /// Two things stand in one place at the start.
    Overlap {
        /// The name of one: a box's, or `robot`.
        what: String,
        /// The name of the other: a box's, or `a wall`.
        with: String,
        /// Where the one that is declared later stands.
        span: Span,
    },
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoBody => f.write_str("the robot has no body"),
            Self::TooLong(ticks) => write!(f, "it has {ticks} ticks; the most is {MOST_TICKS}"),
            Self::Overlap { what, with, .. } => write!(f, "{what} and {with} stand in one place at the start"),
        }
    }
}

impl std::error::Error for RunError {}

/// Runs a scenario by the plan of its diagram on its robot. The run is a function of what it is given: the same seed
/// gives the same run. Linear in the scenario's duration and, where nothing touches, in its boxes and walls.
///
/// # Errors
///
/// [`RunError`] where there is nothing to move, or where things overlap at the start.
pub fn run(program: &ir::Program, plan: &Plan, scenario: &ir::Scenario, options: &RunOptions) -> Result<Run, RunError> {
    let ticks = ticks(scenario)?;
    let seed = options.seed.unwrap_or(scenario.seed);
    let faults = scenario.faults.iter().chain(&options.faults);
    let mut simulation = Simulation::new(program, scenario, faults, seed)?;
    let mut machine = machine(plan, seed);
    let mut drive = Drive::new(program, &program.robots[scenario.robot], plan, seed);

    let tick = scenario.tick.max(1);
    let bodies = footprints(&program.robots[scenario.robot], scenario);
    let mut recorder = Recorder::new(plan, scenario, bodies, seed, ticks as usize);
    for number in 0..ticks {
        let time = number * tick;
        let dt = if number == 0 { 0 } else { tick };
        let Simulation { world, sensing, driver } = &mut simulation;
        let done = driver.body.done();
        let readings = sensing.read(&driver.body, world, time);
        drive.begin(done, readings);
        driver.given = false;
        machine.step(Inputs { readings, done }, dt, &mut drive.over(driver));
        if machine.has_moved() && !driver.given {
            driver.body.forget_done();
        }
        recorder.tick(time, readings, &machine, world);
        drive.step(done, readings, dt, driver);
        recorder.see(sensing.hits(world, time));
        if number + 1 < ticks {
            simulation.advance(tick);
        }
    }
    let (trace, held, decided) = recorder.finish();
    let verdicts = judge(scenario, &trace, &held);
    Ok(Run { trace, verdicts, decided })
}

/// A machine before its first tick; what it draws follows from the seed of the run.
pub fn machine(plan: &Plan, seed: u64) -> Machine<'_> {
    Machine::new(plan, Stream::new(seed, Purpose::Machine).seed())
}

/// How many ticks a scenario has.
fn ticks(scenario: &ir::Scenario) -> Result<u64, RunError> {
    let ticks = (scenario.duration / scenario.tick.max(1)).saturating_add(1);
    if ticks > MOST_TICKS { Err(RunError::TooLong(ticks)) } else { Ok(ticks) }
}

/// The scenarios that cannot start: those whose robot has no body, or where things stand in one place.
pub fn placements(program: &ir::Program) -> Vec<Diagnostic> {
    let start = |scenario: &ir::Scenario| match &program.robots[scenario.robot].body {
        Some(body) => ticks(scenario).and_then(|_| build(body, scenario)).err(),
        None => Some(RunError::NoBody),
    };
    program.scenarios.values().filter_map(|scenario| Some(cannot_start(scenario, &start(scenario)?))).collect()
}

fn cannot_start(scenario: &ir::Scenario, error: &RunError) -> Diagnostic {
    let name = &scenario.symbol.name;
    match error {
        RunError::NoBody => {
            Diagnostic::new(&rules::MISSING_PART, scenario.symbol.span, format!("the robot of `{name}` has no body"))
                .help("write `body differential_drive { ... }` in the robot, so that it can be simulated")
        }
        RunError::TooLong(ticks) => {
            let message = format!("`{name}` has {ticks} ticks; the most is {MOST_TICKS}");
            Diagnostic::new(&rules::RUN_TOO_LONG, scenario.symbol.span, message)
                .note("a run has a tick at its start and after each `tick` of its `duration`; every one is recorded")
                .help("make the duration shorter, or the tick longer")
        }
        RunError::Overlap { what, with, span } => {
            let shown = |thing: &str| match thing {
                "robot" => "the robot".to_owned(),
                "a wall" => thing.to_owned(),
                name => format!("the box `{name}`"),
            };
            let message = format!("{} and {} overlap at the start of `{name}`", shown(what), shown(with));
            // A wall may be shared with other scenarios; the robot is this one's to place.
            let diagnostic = if what == "robot" {
                Diagnostic::new(&rules::BAD_PLACEMENT, scenario.symbol.span, message).label(*span, "this wall")
            } else {
                Diagnostic::new(&rules::BAD_PLACEMENT, *span, message).label(scenario.symbol.span, "in this scenario")
            };
            diagnostic.note("`at (x, y)` is the middle of a body, `at D ahead` the free floor in front of the robot")
        }
    }
}

fn footprints(robot: &ir::Robot, scenario: &ir::Scenario) -> Vec<Footprint> {
    let robot = robot.body.as_ref().map(|body| {
        let [length, width] = body.size();
        Footprint { name: "robot".to_owned(), mass: body.mass(), length, width }
    });
    let boxes = scenario.boxes.iter().map(|one| Footprint {
        name: one.name.clone(),
        mass: one.mass,
        length: one.length,
        width: one.width,
    });
    robot.into_iter().chain(boxes).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Id;
    use crate::ir::{Expectation, ExpectationKind, FaultReading, Placement, Window};
    use crate::sim::fixture::{J5, MODES, cargo, manipulation, plan, program, scenario};
    use crate::trace::Signal;

    fn values(trace: &Trace, signal: Signal) -> &[f64] {
        &trace.column(signal).unwrap().values
    }

    /// When a mode was entered first, s.
    fn entered(trace: &Trace, mode: &str) -> f64 {
        let mode = MODES.iter().position(|name| *name == mode).unwrap() as u32;
        trace.changes.iter().find(|change| change.to == mode).unwrap().time as f64 / 1e9
    }

    #[test]
    fn manipulation_runs_as_in_the_paper() {
        let quiet = ir::DifferentialDrive { tracking_noise: 0.0, ..J5 };
        let trace = run(&program(quiet), &plan(), &manipulation(), &RunOptions::default()).unwrap().trace;
        let went: Vec<&str> = trace.changes.iter().map(|change| MODES[change.to as usize]).collect();
        assert_eq!(went, MODES);
        // 2 s of waiting, 0.75 m at 0.26 m/s, and what speeding up costs: the lag, and the limit of 1 m/s² below
        // 0.11 m/s, where the lag asks for more. Then at most two ticks until it is read and acted on.
        let first = 2.0 + 0.75 / 0.26 + J5.lag + 0.11 * 0.11 / (2.0 * 0.26);
        assert!((first..first + 0.02).contains(&entered(&trace, "push")), "{}", entered(&trace, "push"));
        // The paper's "approximately the 8 second mark".
        assert!((7.5..8.5).contains(&entered(&trace, "stop")), "{}", entered(&trace, "stop"));
        let force = values(&trace, Signal::Reading(2));
        let at = |seconds: f64| (seconds * 100.0) as usize;
        assert_eq!(force[at(4.5)], 0.0);
        // μ m g of 30 kg, then μ M g of the robot.
        assert!((force[at(6.5)] - 117.68).abs() < 0.01, "{}", force[at(6.5)]);
        assert!((force[at(7.75)] - 231.44).abs() < 0.01, "{}", force[at(7.75)]);
        // 0.26 m/s · 30/89 in 0.05 s.
        let spike = values(&trace, Signal::Reading(0))[at(5.0)..at(5.2)].iter().copied().fold(0.0, f64::min);
        assert!((spike + 1.753).abs() < 0.01, "{spike}");
    }

    #[test]
    fn manipulation_does_not_hang_on_its_seed() {
        for seed in 0..20 {
            let options = RunOptions { seed: Some(seed), ..RunOptions::default() };
            let trace = run(&program(J5), &plan(), &manipulation(), &options).unwrap().trace;
            let (push, stop) = (entered(&trace, "push"), entered(&trace, "stop"));
            assert!((4.5..5.5).contains(&push) && (7.5..8.5).contains(&stop), "seed {seed}: {push} {stop}");
        }
    }

    #[test]
    fn a_run_is_a_function_of_its_seed() {
        let mut program = program(J5);
        program.sensors[Id::new(2)].noise = 2.0;
        let of = |seed| {
            let options = RunOptions { seed: Some(seed), ..RunOptions::default() };
            let run = run(&program, &plan(), &manipulation(), &options).unwrap();
            assert_eq!(run.trace.seed, seed);
            let bits = run.trace.columns.iter().flat_map(|column| column.values.iter().map(|value| value.to_bits()));
            (bits.collect::<Vec<u64>>(), run.trace.changes)
        };
        assert_eq!(of(3), of(3));
        assert_ne!(of(3).0, of(4).0);
    }

    #[test]
    fn a_trace_has_its_columns_in_order() {
        let trace = run(&program(J5), &plan(), &manipulation(), &RunOptions::default()).unwrap().trace;
        let names: Vec<&str> = trace.columns.iter().map(|column| column.name.as_str()).collect();
        let expected = [
            "left_acceleration",
            "right_acceleration",
            "contact_force",
            "hit.contributor",
            "hit.detractor",
            "hit",
            "heavy",
            "robot.x",
            "robot.y",
            "robot.heading",
            "box1.x",
            "box1.y",
            "box1.heading",
            "box2.x",
            "box2.y",
            "box2.heading",
        ];
        assert_eq!(names, expected);
        // The first tick is at 0 and the last at the scenario's end.
        assert_eq!((trace.times.first(), trace.times.last()), (Some(&0), Some(&10_000_000_000)));
        assert_eq!(trace.times.len(), 1001);
        assert!(trace.columns.iter().all(|column| column.values.len() == 1001));
        let evidence = |change: usize| trace.changes[change].evidence.first().map(|found| found.text.as_str());
        assert_eq!((evidence(0), evidence(1)), (None, Some("2.00 s")));
        assert_eq!(evidence(2), Some("contributor 117.68 > detractor 60.00"));
        assert_eq!(evidence(3), Some("231.4 N"));
    }

    #[test]
    fn the_last_tick_is_within_the_duration() {
        let scenario = ir::Scenario { duration: 1_000_000_000, tick: 300_000_000, ..scenario() };
        let trace = run(&program(J5), &plan(), &scenario, &RunOptions::default()).unwrap().trace;
        assert_eq!(trace.times, [0, 300_000_000, 600_000_000, 900_000_000]);
    }

    #[test]
    fn what_overlaps_at_the_start_is_refused() {
        let at = |x| Placement::At { x, y: 0.0, heading: 0.0 };
        let wall = |x| ir::Wall { corners: vec![[x, -1.0], [x, 1.0]], is_door: false, span: Span::default() };
        let refused = |boxes: Vec<ir::BoxBody>, walls| {
            run(&program(J5), &plan(), &ir::Scenario { walls, boxes, ..scenario() }, &RunOptions::default())
                .map_err(|error| error.to_string())
                .err()
        };
        let message = |what, with| Some(format!("{what} and {with} stand in one place at the start"));
        assert_eq!(refused(vec![cargo("a", 1.0, at(0.6))], vec![]), message("a", "robot"));
        assert_eq!(refused(vec![cargo("a", 1.0, at(1.0)), cargo("b", 1.0, at(1.3))], vec![]), message("b", "a"));
        assert_eq!(refused(vec![cargo("a", 1.0, at(1.0))], vec![wall(1.1)]), message("a", "a wall"));
        assert_eq!(refused(vec![], vec![wall(0.1)]), message("robot", "a wall"));
        // Flush is not overlapping.
        assert_eq!(refused(vec![cargo("a", 1.0, at(0.7)), cargo("b", 1.0, at(1.1))], vec![wall(1.3)]), None);
        let mut bodiless = program(J5);
        bodiless.robots[Id::new(0)].body = None;
        assert_eq!(run(&bodiless, &plan(), &scenario(), &RunOptions::default()), Err(RunError::NoBody));
    }

    #[test]
    fn faults_reach_the_machine_and_verdicts_say_what_was_seen() {
        let expectation = |text: &str, kind| Expectation { text: text.to_owned(), kind, span: Span::default() };
        let transition = ExpectationKind::Transition { from: Id::new(1), to: Id::new(2), window: Window::WHOLE };
        let expectations = vec![
            expectation("forward -> push", transition),
            expectation("within push", ExpectationKind::Within(Id::new(0), Window::WHOLE)),
            expectation("never heavy", ExpectationKind::Never(Id::new(1), Window::WHOLE)),
        ];
        let scenario = ir::Scenario { expectations, ..manipulation() };
        let fault = ir::Fault {
            sensor: Id::new(2),
            reading: FaultReading::Stuck(0.0),
            window: Window::WHOLE,
            span: Span::default(),
        };
        let quiet = program(ir::DifferentialDrive { tracking_noise: 0.0, ..J5 });
        let verdicts = |faults| {
            let verdicts = run(&quiet, &plan(), &scenario, &RunOptions { seed: None, faults }).unwrap().verdicts;
            verdicts.into_iter().map(|verdict| (verdict.passed, verdict.seen)).collect::<Vec<_>>()
        };
        let seen = [(true, "taken at 5.06 s"), (true, "held at 5.06 s"), (false, "held at 7.68 s")];
        assert_eq!(verdicts(vec![]), seen.map(|(passed, seen)| (passed, seen.to_owned())));
        let lost = "never taken; the run went init, forward";
        let seen = [(false, lost), (false, "never held"), (true, "never held")];
        assert_eq!(verdicts(vec![fault]), seen.map(|(passed, seen)| (passed, seen.to_owned())));
    }
}
