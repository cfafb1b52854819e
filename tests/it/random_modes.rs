//! Random diagrams under random readings and failures: what was proved never to happen does not.

use lmslc::analysis::modes::{Way, fault_table};
use lmslc::base::{Exact, Id};
use lmslc::interp::{Actuators, Inputs, Machine, Reading, Taken};
use lmslc::ir::Sensor;
use lmslc::kernel::next_random;
use lmslc::plan;

use crate::fault_table::replay_all;
use crate::support::{analyze_texts, report};

/// The network that random behaviors sense, `n`.
pub const FUSION: &str = "
    variable level: 1 in 0 .. 10 { low = ramp(6, 4)  mid = triangle(4, 5, 6)  high = ramp(4, 6) }
    network n(v: level, w: level) {
        event full { contributor (high, -) detractor ({low, mid}, -) }
        event some { contributor (high, _) (_, high) detractor (low, low) }
        event all  { contributor (high, high) detractor (low, _) (_, low) }
        event odd  { contributor (low, high) (mid, -) detractor (_, mid) }
        event late confirm 200 ms { contributor (high, -) detractor ({low, mid}, -) }
    }
    ";

/// The robot that random behaviors are on.
pub const CART: &str = "import n
    robot cart {
        body differential_drive { mass 50 kg  size (1 m, 1 m)  track 0.6 m  traction 0.5 }
        sensor x: 1 in 0 .. 10 fails 3
        optional sensor y: 1 in 0 .. 10 fails 7
        action turn(angle: rad) -> done = body.rotate(angle)
    }
    ";

/// Makes behaviors.
pub struct Random {
    pub state: u64,
    /// Whether conditions look at the past.
    pub recalls: bool,
}

impl Random {
    pub fn below(&mut self, limit: u64) -> u64 {
        next_random(&mut self.state) % limit
    }

    pub fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.below(values.len() as u64) as usize]
    }

    pub fn atom(&mut self) -> String {
        let flag = self.one_of(&["full", "some", "all", "odd", "late", "x > 5", "x < 4", "x > y", "y >= 5", "y == 5"]);
        match self.below(9) {
            0..=4 if !self.recalls => flag.to_owned(),
            0 => format!("rising({flag})"),
            1 => format!("falling({flag})"),
            2 => format!("latched({flag})"),
            3 => format!("held({flag}, 300 ms)"),
            4 => format!("count({flag}) >= {}", 1 + self.below(2)),
            5 => format!("after {} ms", 300 * (1 + self.below(3))),
            6 => self.one_of(&["failed(x)", "failed(y)", "done"]).to_owned(),
            _ => flag.to_owned(),
        }
    }

    fn condition(&mut self) -> String {
        let mut condition = self.atom();
        for _ in 0..self.below(3) {
            let word = self.one_of(&["and", "or", "and not"]);
            condition = format!("({condition}) {word} ({})", self.atom());
        }
        condition
    }

    /// A behavior on a cart with sensors `x` and `y`.
    pub fn behavior(&mut self, name: &str) -> String {
        let mut text = format!("behavior {name} on cart {{ sense n(x, y)  entry m0\n");
        for mode in 0..4 {
            let requires = if mode == 3 { "requires y else m1" } else { "" };
            text += &format!("mode m{mode} {requires} {{ turn(1 rad)\n");
            for priority in 1..=3 {
                text += &format!("{priority}: {} -> m{}\n", self.condition(), self.below(4));
            }
            text += "}\n";
        }
        text + "}\n"
    }
}

pub struct Deaf;

impl Actuators for Deaf {
    fn command(&mut self, _action: u32, _arguments: &[f64], _start: bool) {}
}

#[test]
fn what_never_happens_is_not_seen() {
    let mut random = Random { state: 7, recalls: true };
    let (mut dead, mut live) = (0, 0);
    for _ in 0..80 {
        let text = format!("{CART}{}", random.behavior("b"));
        let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
        let plan = plan::build(analysis.checked().unwrap(), Id::new(0), Id::new(0), &[]);
        let healthy = fault_table(&analysis.program, Id::new(0), 0).remove(0);
        let exits: Vec<_> = healthy.modes.iter().flat_map(|mode| mode.exits.iter().map(Option::is_some)).collect();
        // A finding about a transition stands on it.
        let codes = ["LM0402", "LM0409", "LM0412", "LM0413", "LM0418"];
        let never: Vec<_> = analysis.findings.iter().filter(|finding| codes.contains(&finding.rule.code)).collect();
        let is_never = |index: u32| {
            let span = plan.transitions[index as usize].span;
            never.iter().any(|finding| span.start <= finding.span().start && finding.span().end <= span.end)
        };
        dead += exits.iter().filter(|exit| !**exit).count();
        let mut seen = vec![false; exits.len()];
        for fails in [false, true] {
            let mut machine = Machine::new(&plan, 1);
            let mut readings = [0.0; 2].map(|value| Reading { value, healthy: true });
            for _ in 0..3000 {
                for reading in &mut readings {
                    if random.below(3) == 0 {
                        reading.value = random.below(21) as f64 / 2.0;
                        reading.healthy = !fails || random.below(3) > 0;
                    }
                }
                let done = random.below(4) == 0;
                let before = machine.mode() as usize;
                let taken = machine.step(Inputs { readings: &readings, done }, 100_000_000, &mut Deaf);
                if let Taken::Transition(index) = taken {
                    assert!(!is_never(index), "{}\n{text}", report(&analysis));
                    assert!(fails || exits[index as usize], "transition {index} of m{before}\n{text}");
                    seen[index as usize] = true;
                }
                assert!(fails || healthy.modes[machine.mode() as usize].reachable, "{text}");
            }
        }
        live += seen.iter().filter(|seen| **seen).count();
    }
    assert!(dead > 50 && live > 400, "{dead} dead, {live} live: the diagrams show nothing");
}

#[test]
fn what_is_shown_of_the_past_happens() {
    let mut random = Random { state: 3, recalls: true };
    let mut shown = 0;
    for _ in 0..25 {
        // What an event remembers is not followed.
        let text = format!("{CART}{}", random.behavior("b").replace("late", "odd"));
        let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
        let table = fault_table(&analysis.program, Id::new(0), 1);
        shown += replay_all(&analysis, Id::new(0), &table);
    }
    assert!(shown > 200, "{shown} exits shown");
}

#[test]
fn what_a_failure_traps_never_gets_out() {
    let mut random = Random { state: 11, recalls: false };
    let mut trapped = 0;
    for _ in 0..50 {
        let text = format!("{CART}{}", random.behavior("b"));
        let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
        let plan = plan::build(analysis.checked().unwrap(), Id::new(0), Id::new(0), &[]);
        for finding in analysis.findings.iter().filter(|finding| finding.rule.code == "LM0604") {
            let (modes, failures) = finding.message.split_once(" with ").unwrap();
            let trap: Vec<_> = (0..4_u32).filter(|mode| modes.contains(&format!("`m{mode}`"))).collect();
            let ways = [("`x` failed at 3", 0, 3.0, true), ("`y` failed at 7", 1, 7.0, true)];
            let known = [("`x` known to have failed", 0, 0.0, false), ("`y` known to have failed", 1, 0.0, false)];
            for (_, sensor, value, healthy) in ways.into_iter().chain(known).filter(|way| failures.contains(way.0)) {
                let mut machine = Machine::new(&plan, 1);
                let mut readings = [0.0; 2].map(|value| Reading { value, healthy: true });
                let mut is_caught = false;
                for tick in 0..600 {
                    for reading in &mut readings {
                        reading.value = random.below(21) as f64 / 2.0;
                    }
                    if tick > 100 {
                        readings[sensor] = Reading { value, healthy };
                        is_caught |= trap.contains(&machine.mode());
                    }
                    let done = random.below(4) == 0;
                    machine.step(Inputs { readings: &readings, done }, 100_000_000, &mut Deaf);
                    assert!(!is_caught || trap.contains(&machine.mode()), "{}\n{text}", report(&analysis));
                }
                trapped += usize::from(is_caught);
            }
        }
    }
    assert!(trapped > 10, "{trapped} traps: the diagrams show nothing");
}

/// A behavior whose modes ask events and compare `x` with three numbers each, all leading to `end`.
fn comparing(modes: &[[f64; 3]]) -> String {
    let mut text = format!("{CART} behavior b on cart {{ sense n(x, y)  entry m0\n");
    for (mode, [one, two, three]) in modes.iter().enumerate() {
        text += &format!(
            "mode m{mode} {{ turn(1 rad) 1: odd and x > {one} -> end 2: some and not full and x <= {two} -> end
                3: all and x == {three} -> end 4: not odd and full and x < {three} -> end }}\n"
        );
    }
    text + "mode end { turn(2 rad) 1: odd -> m0 } }"
}

#[test]
fn what_a_mode_can_do_does_not_depend_on_how_many_there_are() {
    let mut random = Random { state: 5, recalls: false };
    // Among them the readings at which degrees cross or bend.
    let mut number = || random.below(41) as f64 / 4.0;
    let modes: Vec<[f64; 3]> = (0..40).map(|_| [number(), number(), number()]).collect();
    let text = comparing(&modes);
    let together = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
    let together = fault_table(&together.program, Id::new(0), 1);
    let mut shown = 0;
    for (mode, numbers) in modes.iter().enumerate() {
        let text = comparing(&[*numbers]);
        let alone = analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)]);
        for facts in fault_table(&alone.program, Id::new(0), 1) {
            let Some(among) = together.iter().find(|among| among.faults == facts.faults) else { continue };
            let live = |exits: &[Option<Way>]| exits.iter().map(Option::is_some).collect::<Vec<_>>();
            assert_eq!(live(&among.modes[mode].exits), live(&facts.modes[0].exits), "{text}");
        }
        // What shows it among many modes does it alone.
        let plan = plan::build(alone.checked().unwrap(), Id::new(0), Id::new(0), &[]);
        for (exit, way) in together[0].modes[mode].exits.iter().enumerate() {
            let Some(Way::Shown(moments)) = way else { continue };
            let mut machine = Machine::new(&plan, 1);
            let told = |readings: &[(Id<Sensor>, Exact)]| {
                [0, 1].map(|sensor| {
                    let at = readings.iter().find(|(known, _)| known.index() == sensor);
                    Reading { value: at.map_or(0.0, |(_, at)| at.to_f64()), healthy: true }
                })
            };
            let mut step = |readings: &[(Id<Sensor>, Exact)]| {
                machine.step(Inputs { readings: &told(readings), done: false }, 100_000_000, &mut Deaf)
            };
            step(&[]);
            let last = moments.iter().map(|moment| step(&moment.readings)).last();
            assert!(
                matches!(last, Some(Taken::Transition(taken)) if taken as usize == exit),
                "exit {exit}: {last:?}\n{text}"
            );
            shown += 1;
        }
    }
    assert!(shown > 80, "{shown} exits shown");
}
