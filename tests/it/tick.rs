//! The tick, rule by rule.

use lmslc::base::Id;
use lmslc::interp::{Actuators, Inputs, Machine, Reading, Taken};
use lmslc::plan::{self, Plan};

use crate::support::{analyze_texts, doubts, report};

const MILLISECOND: u64 = 1_000_000;

/// A robot with two sensors; `x` and `y` are 0 to 10, and fail at 3.
const ROBOT: &str = "
    robot cart {
        sensor x: 1 in 0 .. 10 fails 3
        optional sensor y: 1 in 0 .. 10 fails 3
        action halt()
        action go(speed: m/s)
        action turn(angle: rad) -> done
        action ring(times: 1)
    }
    ";

fn build(behavior: &str) -> Plan {
    let text = format!("{ROBOT}\nbehavior b on cart {{\n{behavior}\n}}");
    let analysis = analyze_texts(&[("b.msd", &text)]);
    // Some of them cannot go on once a sensor has failed.
    let is_clean = doubts(&analysis).iter().all(|finding| finding.rule.is_about_faults());
    assert!(is_clean, "{}", report(&analysis));
    plan::build(analysis.checked().unwrap(), Id::new(0), Id::new(0), &[])
}

#[derive(Default)]
struct Log(Vec<(u32, Vec<f64>, bool)>);

impl Actuators for Log {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        self.0.push((action, arguments.to_vec(), start));
    }
}

struct Silent;

impl Actuators for Silent {
    fn command(&mut self, _action: u32, _arguments: &[f64], _start: bool) {}
}

/// A machine that is told readings and answers with the names of its modes.
struct Run<'p> {
    plan: &'p Plan,
    machine: Machine<'p>,
    log: Log,
    healthy: [bool; 2],
    done: bool,
}

impl<'p> Run<'p> {
    fn new(plan: &'p Plan) -> Self {
        Self { plan, machine: Machine::new(plan, 1), log: Log::default(), healthy: [true; 2], done: false }
    }

    fn step_for(&mut self, x: f64, y: f64, dt: u64) -> &'p str {
        let readings = [Reading { value: x, healthy: self.healthy[0] }, Reading { value: y, healthy: self.healthy[1] }];
        self.log.0.clear();
        self.machine.step(Inputs { readings: &readings, done: self.done }, dt, &mut self.log);
        &self.plan.modes[self.machine.mode() as usize].name
    }

    fn step(&mut self, x: f64, y: f64) -> &'p str {
        self.step_for(x, y, 10 * MILLISECOND)
    }

    /// The names of the actions of the last tick, in order.
    fn actions(&self) -> Vec<&'p str> {
        self.log.0.iter().map(|(action, ..)| self.plan.actions[*action as usize].name.as_str()).collect()
    }
}

#[test]
fn the_smallest_number_wins_whatever_the_order_in_the_text() {
    let plan = build(
        "entry a
         mode a { halt()  2: x > 1 -> b  1: x > 2 -> c }
         final mode b { halt() }
         final mode c { halt() }",
    );
    let mut run = Run::new(&plan);
    run.step(0.0, 0.0);
    assert_eq!(run.step(5.0, 0.0), "c");
    let mut run = Run::new(&plan);
    run.step(0.0, 0.0);
    assert_eq!(run.step(1.5, 0.0), "b");
}

#[test]
fn one_transition_a_tick_and_the_entry_is_held_for_one() {
    let plan = build(
        "entry a
         mode a { halt()  1: x > 1 -> b }
         mode b { halt()  1: x > 1 -> c }
         final mode c { halt() }",
    );
    let mut run = Run::new(&plan);
    assert_eq!([run.step(5.0, 0.0), run.step(5.0, 0.0), run.step(5.0, 0.0)], ["a", "b", "c"]);
}

#[test]
fn an_inhibited_target_lets_the_next_transition_through() {
    let plan = build(
        "entry a
         mode a { halt()  1: x > 1 -> b  2: x > 1 -> c }
         mode b requires y else c { halt()  1: x < 1 -> a }
         mode c { halt()  1: x < 1 -> a }",
    );
    let mut run = Run::new(&plan);
    run.step(0.0, 0.0);
    assert_eq!(run.step(5.0, 0.0), "b");
    let mut run = Run::new(&plan);
    run.healthy[1] = false;
    run.step(0.0, 0.0);
    assert_eq!(run.step(5.0, 0.0), "c");
}

#[test]
fn else_comes_before_every_exit_when_a_required_sensor_fails() {
    let plan = build(
        "entry a
         mode a { halt()  1: x > 1 -> b }
         mode b requires y else c { halt()  1: x > 1 -> d }
         final mode c { halt() }
         final mode d { halt() }",
    );
    let mut run = Run::new(&plan);
    run.step(5.0, 0.0);
    assert_eq!(run.step(5.0, 0.0), "b");
    run.healthy[1] = false;
    assert_eq!(run.step(5.0, 0.0), "c");
}

#[test]
fn a_timer_counts_from_the_entry_of_its_mode_and_again_restarts_it() {
    let plan = build(
        "entry a
         mode a { halt()  1: x > 1 -> again  2: after 30 ms -> b }
         mode b { halt()  1: after 20 ms -> a }",
    );
    let mut run = Run::new(&plan);
    let seen: Vec<_> = (0..7).map(|_| run.step(0.0, 0.0)).collect();
    assert_eq!(seen, ["a", "a", "a", "b", "b", "a", "a"]);
    let mut run = Run::new(&plan);
    for x in [0.0, 0.0, 5.0, 0.0, 0.0] {
        assert_eq!(run.step(x, 0.0), "a");
    }
    assert_eq!(run.step(0.0, 0.0), "b");
}

#[test]
fn time_is_counted_in_nanoseconds_however_long_the_ticks() {
    let plan = build(
        "entry a
         mode a { halt()  1: after 100 ms -> b }
         final mode b { halt() }",
    );
    let mut run = Run::new(&plan);
    for dt in [0, 33_333_333, 33_333_333, 33_333_333] {
        assert_eq!(run.step_for(0.0, 0.0, dt), "a");
    }
    assert_eq!(run.step_for(0.0, 0.0, 1), "b");
}

#[test]
fn commands_run_in_the_tick_that_entered_exit_before_enter() {
    let plan = build(
        "entry a
         mode a { go(1 m/s)  on exit { ring(1) }  1: x > 1 -> b }
         mode b { halt()  on enter { ring(2) }  1: after 1 s -> a }",
    );
    let mut run = Run::new(&plan);
    run.step(0.0, 0.0);
    assert_eq!(run.actions(), ["go"]);
    run.step(5.0, 0.0);
    assert_eq!(run.actions(), ["ring", "ring", "halt"]);
    assert_eq!(run.log.0[0].1, [1.0]);
    assert_eq!(run.log.0[1].1, [2.0]);
    assert!(run.log.0[2].2, "the command is new");
    run.step(0.0, 0.0);
    assert_eq!(run.actions(), ["halt"]);
    assert!(!run.log.0[0].2, "the command goes on");
}

#[test]
fn counters_count_rising_edges_since_the_mode_was_entered() {
    let plan = build(
        "flag high = x > 5
         entry a
         mode a { halt()  1: count(high) >= 2 -> b }
         mode b { halt()  1: count(high) >= 1 -> a }",
    );
    let mut run = Run::new(&plan);
    let seen: Vec<_> = [9.0, 9.0, 0.0, 9.0, 9.0, 0.0, 9.0, 9.0, 0.0].map(|x| run.step(x, 0.0)).to_vec();
    // The first edge falls on the tick of entry and does not count. The edge that leads to `b` does not count there.
    assert_eq!(seen, ["a", "a", "a", "a", "a", "a", "b", "b", "b"]);
    assert_eq!(run.step(9.0, 0.0), "a");
}

#[test]
fn history_is_read_through_its_operators() {
    let plan = build(
        "flag high = x > 5
         entry a
         mode a {
             halt()
             1: rising(high) and y == 1 -> r
             2: falling(high) and y == 2 -> r
             3: held(high, 20 ms) and y == 3 -> r
             4: latched(high) and y == 4 -> r
         }
         final mode r { halt() }",
    );
    let after = |readings: &[(f64, f64)]| {
        let mut run = Run::new(&plan);
        readings.iter().map(|&(x, y)| run.step(x, y)).last().unwrap()
    };
    assert_eq!(after(&[(0.0, 1.0), (9.0, 1.0)]), "r");
    assert_eq!(after(&[(9.0, 1.0), (9.0, 1.0)]), "a");
    assert_eq!(after(&[(9.0, 0.0), (0.0, 2.0)]), "r");
    assert_eq!(after(&[(0.0, 2.0), (0.0, 2.0)]), "a");
    assert_eq!(after(&[(9.0, 3.0), (9.0, 3.0)]), "a");
    assert_eq!(after(&[(9.0, 3.0), (9.0, 3.0), (9.0, 3.0)]), "r");
    assert_eq!(after(&[(9.0, 3.0), (0.0, 3.0), (9.0, 3.0)]), "a");
    assert_eq!(after(&[(0.0, 0.0), (9.0, 0.0), (0.0, 4.0)]), "r");
    assert_eq!(after(&[(9.0, 0.0), (0.0, 4.0)]), "a", "what held before the mode was entered is not latched");
}

#[test]
fn done_reports_the_action_and_random_is_drawn_once_per_entry() {
    let plan = build(
        "entry a
         mode a { turn(random(-1 rad, 1 rad))  1: done -> again }",
    );
    let mut run = Run::new(&plan);
    run.step(0.0, 0.0);
    let first = run.log.0[0].1.clone();
    run.step(0.0, 0.0);
    assert_eq!(run.log.0[0].1, first);
    run.done = true;
    run.step(0.0, 0.0);
    assert_ne!(run.log.0[0].1, first);
    assert!((-1.0..=1.0).contains(&run.log.0[0].1[0]));
    let mut again = Run::new(&plan);
    again.step(0.0, 0.0);
    assert_eq!(again.log.0[0].1, first, "one seed, one stream");
}

#[test]
fn unusable_readings_are_replaced_or_clamped() {
    let plan = build(
        "entry a
         mode a {
             halt()
             1: x == 3 -> failed_reading
             2: x == 10 -> clamped
             3: failed(y) -> told
         }
         final mode failed_reading { halt() }
         final mode clamped { halt() }
         final mode told { halt() }",
    );
    let after = |x: f64, healthy: [bool; 2]| {
        let mut run = Run::new(&plan);
        run.step(0.0, 0.0);
        run.healthy = healthy;
        run.step(x, 0.0)
    };
    assert_eq!(after(f64::NAN, [true, true]), "failed_reading");
    assert_eq!(after(f64::NEG_INFINITY, [true, true]), "failed_reading");
    assert_eq!(after(7.0, [false, true]), "failed_reading");
    assert_eq!(after(1e9, [true, true]), "clamped");
    assert_eq!(after(7.0, [true, false]), "told");
    assert_eq!(after(7.0, [true, true]), "a");
}

#[test]
fn flags_may_stand_in_any_order() {
    let plan = build(
        "flag both = left and not right
         flag left = x > 5
         flag right = y > 5
         entry a
         mode a { halt()  1: both -> b }
         final mode b { halt() }",
    );
    let mut run = Run::new(&plan);
    run.step(0.0, 0.0);
    assert_eq!(run.step(9.0, 9.0), "a");
    assert_eq!(run.step(9.0, 0.0), "b");
}

/// A network whose event is set above 5, with options.
fn network(options: &str) -> Plan {
    let fusion = format!(
        "variable level: 1 in 0 .. 10 {{ low = ramp(10, 0)  high = ramp(0, 10) }}
         network n(v: level) {{ event e {options} {{ contributor (high) detractor (low) }} }}"
    );
    let modes = format!(
        "import n\n{ROBOT}\nbehavior b on cart {{ sense n(x)  entry a  mode a {{ halt() 1: e -> b }} mode b {{ halt() 1: not e -> a }} }}"
    );
    let analysis = analyze_texts(&[("b.msd", &modes), ("n.fsfn", &fusion)]);
    assert!(doubts(&analysis).is_empty(), "{}", report(&analysis));
    plan::build(analysis.checked().unwrap(), Id::new(0), Id::new(0), &[])
}

fn walk(plan: &Plan, readings: &[f64]) -> String {
    let mut run = Run::new(plan);
    readings.iter().map(|&x| run.step(x, 0.0)).collect()
}

#[test]
fn a_tie_leaves_the_flag_clear() {
    let plan = network("");
    assert_eq!(walk(&plan, &[0.0, 5.0, 5.0]), "aaa");
    assert_eq!(walk(&plan, &[0.0, 5.001, 5.0]), "aba");
}

#[test]
fn events_remember_only_what_their_options_say() {
    // high - low is (x - 5) / 5: set above 6, cleared below 4, kept between.
    assert_eq!(walk(&network("hysteresis 0.2"), &[0.0, 5.9, 6.1, 4.1, 3.9]), "aabba");
    // Ticks of 10 ms: true on the ticks at 10, 20 and 30 ms, so for 20 ms at 30 ms.
    assert_eq!(walk(&network("confirm 20 ms"), &[0.0, 9.0, 9.0, 9.0, 0.0]), "aaaba");
    assert_eq!(walk(&network("hold 20 ms"), &[0.0, 9.0, 0.0, 0.0, 0.0]), "abbaa");
}

#[test]
fn what_a_tick_did_is_told() {
    let plan = build(
        "entry a
         mode a { halt()  1: x > 1 -> b }
         mode b requires y else a { halt()  1: x < 1 -> a }",
    );
    let mut machine = Machine::new(&plan, 0);
    let mut tick = |x: f64, healthy: bool| {
        let readings = [Reading { value: x, healthy: true }, Reading { value: 0.0, healthy }];
        machine.step(Inputs { readings: &readings, done: false }, MILLISECOND, &mut Log::default())
    };
    assert_eq!(tick(0.0, true), Taken::Entered);
    assert_eq!(tick(0.0, true), Taken::Stayed);
    assert_eq!(tick(5.0, true), Taken::Transition(0));
    assert_eq!(tick(5.0, false), Taken::Lost { from: 1, input: 1 });
}

#[test]
fn a_tick_allocates_nothing() {
    let plan = build(
        "flag high = x > 5
         entry a
         mode a { turn(random(-1 rad, 1 rad))  1: rising(high) and count(high) >= 1 -> b  2: after 30 ms -> again }
         mode b requires y else a { halt()  on enter { ring(2) }  1: held(high, 20 ms) or y < 1 -> a }",
    );
    let mut machine = Machine::new(&plan, 1);
    let allocated = allocation_counter::measure(|| {
        for tick in 0..1000_u32 {
            let reading = |value: u32| Reading { value: f64::from(value % 10), healthy: tick % 97 > 3 };
            let readings = [reading(tick), reading(tick / 7)];
            machine.step(Inputs { readings: &readings, done: tick % 3 == 0 }, 10 * MILLISECOND, &mut Silent);
        }
    });
    assert_eq!(allocated.count_total, 0);
    assert!(machine.dwell() > 0, "the machine has been running");
}
