//! Decision tables: which row is chosen, what it commands, and what is proved of its rows.

use lmslc::base::Id;
use lmslc::interp::{Actuators, Inputs, Machine, Reading};
use lmslc::plan::{self, Plan};

use crate::emit_programs::Random;
use crate::support::{analyze_texts, report};

/// No reading is `hidden` most.
const FUSION: &str = "
    variable distance: m in 0 .. 10 fails 10 { close = ramp(4, 2)  hidden = points((2, 0), (3, 0.25), (4, 0))  far = ramp(2, 4) }
    network n(ahead: distance) { event blocked { contributor (close) detractor (far) (hidden) } }
    ";

const ROBOT: &str = "import n
    robot ring {
        sensor range: m in 0 .. 10 fails 10
        sensor touch[3]: contact fails clear
        action halt()
        action go(speed: m/s)
        action turn(angle: rad) -> done
    }
    ";

fn texts(behavior: &str) -> String {
    format!("{ROBOT}\nbehavior b on ring {{\nsense n(range)\n{behavior}\n}}")
}

fn build(behavior: &str) -> Plan {
    let analysis = analyze_texts(&[("b.msd", &texts(behavior)), ("n.fsfn", FUSION)]);
    let checked = analysis.checked().unwrap_or_else(|| panic!("{}", report(&analysis)));
    plan::build(checked, Id::new(0), Id::new(0), &[])
}

/// The commands of a tick: action, arguments, whether it starts.
#[derive(Default)]
struct Log(Vec<(u32, Vec<f64>, bool)>);

impl Actuators for Log {
    fn command(&mut self, action: u32, arguments: &[f64], start: bool) {
        self.0.push((action, arguments.to_vec(), start));
    }
}

struct Run<'p> {
    plan: &'p Plan,
    machine: Machine<'p>,
}

impl<'p> Run<'p> {
    fn new(plan: &'p Plan, seed: u64) -> Self {
        Self { plan, machine: Machine::new(plan, seed) }
    }

    /// The commands at a range, with contacts that are set or clear.
    fn step(&mut self, range: f64, touch: [bool; 3]) -> Vec<(&'p str, Vec<f64>, bool)> {
        let touch = touch.map(|touch| f64::from(u8::from(touch)));
        let readings = [range, touch[0], touch[1], touch[2]].map(|value| Reading { value, healthy: true });
        let mut log = Log::default();
        self.machine.step(Inputs { readings: &readings, done: false }, 10_000_000, &mut log);
        let plan = self.plan;
        let told = |(action, arguments, start): (u32, Vec<f64>, bool)| {
            (plan.actions[action as usize].name.as_str(), arguments, start)
        };
        log.0.into_iter().map(told).collect()
    }
}

#[test]
fn the_row_that_fits_gives_the_command_on_every_tick() {
    let plan = build(
        "entry go
         mode go {
             decide (ahead, touch[0]) {
                 (far,            clear) => go(1 m/s)
                 ({close, hidden}, clear) => nothing
                 (_,              set  ) => halt()
             }
             1: touch[2] -> stop
         }
         final mode stop { halt() }",
    );
    let mut run = Run::new(&plan, 1);
    let go = vec![("go", vec![1.0], false)];
    assert_eq!(run.step(9.0, [false; 3]), [("go", vec![1.0], true)]);
    assert_eq!(run.step(9.0, [false; 3]), go);
    assert!(run.step(1.0, [false; 3]).is_empty());
    assert_eq!(run.step(1.0, [true, false, false])[0].0, "halt");
    assert_eq!(run.step(9.0, [false; 3])[0].0, "go");
    // The mode that a tick enters gives its command on that tick.
    assert_eq!(run.step(9.0, [false, false, true]), [("halt", vec![], true)]);
}

#[test]
fn a_command_starts_when_its_row_begins_to_fit() {
    let plan = build(
        "entry go
         mode go {
             decide (touch[0], touch[1]) {
                 (clear, _    ) => turn(1 rad)
                 (set,   clear) => turn(2 rad)
                 (set,   set  ) => nothing
             }
             1: touch[2] -> again
         }",
    );
    let mut run = Run::new(&plan, 1);
    let mut starts = |touch: [bool; 3]| run.step(9.0, touch).first().map(|command| (command.1[0], command.2));
    assert_eq!([starts([false; 3]), starts([false; 3])], [Some((1.0, true)), Some((1.0, false))]);
    assert_eq!(starts([false, true, false]), Some((1.0, false)));
    assert_eq!([starts([true, false, false]), starts([true, false, false])], [Some((2.0, true)), Some((2.0, false))]);
    assert_eq!(starts([true, true, false]), None);
    assert_eq!(starts([true, false, false]), Some((2.0, true)));
    // Entered again, the row begins again.
    assert_eq!(starts([true, false, true]), Some((2.0, true)));
}

#[test]
fn one_of_several_commands_is_drawn_while_a_row_lasts() {
    let plan = build(
        "entry go
         mode go {
             decide (touch[0]) {
                 (clear) => either(go(1 m/s), go(random(2 m/s, 3 m/s)), halt())
                 (set)   => nothing
             }
             1: touch[2] -> again
         }",
    );
    let drawn = |seed: u64| -> Vec<Vec<(&str, Vec<f64>, bool)>> {
        let mut run = Run::new(&plan, seed);
        let commands = (0..60).map(|_| {
            let first = run.step(9.0, [false; 3]);
            for _ in 0..5 {
                let later = run.step(9.0, [false; 3]);
                assert_eq!((&later[0].0, &later[0].1), (&first[0].0, &first[0].1));
            }
            assert!(run.step(9.0, [true, false, false]).is_empty());
            first
        });
        commands.collect()
    };
    let commands = drawn(1);
    // A third each, give or take: 60 draws leave none out, and none takes over.
    let count = |range: std::ops::Range<f64>| {
        commands
            .iter()
            .filter(|given| given[0].1.first().map_or(range.start == 0.0, |speed| range.contains(speed)))
            .count()
    };
    let counts = [count(0.0..0.5), count(1.0..1.5), count(2.0..3.0)];
    assert!(counts.iter().sum::<usize>() == 60 && counts.iter().all(|count| (8..=35).contains(count)), "{counts:?}");
    assert_eq!(commands, drawn(1), "a run follows from its seed");
    assert_ne!(commands, drawn(2));
}

/// A random table, brute force over all its cases, and the machine in each of them.
#[test]
fn what_is_proved_of_rows_holds_in_every_case() {
    let (mut complete, mut incomplete, mut overlaps, mut never) = (0, 0, 0, 0);
    for seed in 0..400 {
        let mut random = Random(seed);
        // Of the first column's values the second is impossible.
        let columns: &[(&str, &[&str], &[bool])] = &[
            ("ahead", &["close", "hidden", "far"], &[true, false, true]),
            ("touch[0]", &["set", "clear"], &[true, true]),
            ("touch[1]", &["set", "clear"], &[true, true]),
            ("touch[2]", &["set", "clear"], &[true, true]),
        ];
        let columns = &columns[..=random.below(4) as usize];
        let mut rows: Vec<Vec<Vec<usize>>> = vec![vec![]];
        for (_, values, _) in columns {
            let split = |row: Vec<Vec<usize>>, random: &mut Random| -> Vec<Vec<Vec<usize>>> {
                let all: Vec<usize> = (0..values.len()).collect();
                let cells = match random.below(3) {
                    0 => vec![all],
                    _ => {
                        let cut = 1 + random.below(values.len() as u64 - 1) as usize;
                        vec![all[..cut].to_vec(), all[cut..].to_vec()]
                    }
                };
                cells.into_iter().map(|cell| [row.clone(), vec![cell]].concat()).collect()
            };
            rows = rows.into_iter().flat_map(|row| split(row, &mut random)).collect();
        }
        // So far one row for every case; now and then one is lost, or a cell is another.
        if rows.len() > 1 && random.chance(3) {
            rows.remove(random.below(rows.len() as u64) as usize);
        }
        if random.chance(3) {
            let (row, column) = (random.below(rows.len() as u64) as usize, random.below(columns.len() as u64) as usize);
            rows[row][column] = vec![random.below(columns[column].1.len() as u64) as usize];
        }
        let cell = |cell: &[usize], values: &[&str]| {
            let named: Vec<_> = cell.iter().map(|&value| values[value]).collect();
            if named.len() == values.len() { "_".to_owned() } else { format!("{{{}}}", named.join(", ")) }
        };
        let line = |(place, row): (usize, &Vec<Vec<usize>>)| {
            let cells: Vec<_> = row.iter().zip(columns).map(|(of, (_, values, _))| cell(of, values)).collect();
            format!("({}) => go({place} m/s)", cells.join(", "))
        };
        let text = rows.iter().enumerate().map(line).collect::<Vec<_>>().join("\n");
        let names: Vec<_> = columns.iter().map(|(name, ..)| *name).collect();
        let behavior = format!(
            "entry go\nmode go {{ decide ({}) {{\n{text}\n}}\n1: blocked and failed(range) -> again }}",
            names.join(", ")
        );
        let analysis = analyze_texts(&[("b.msd", &texts(&behavior)), ("n.fsfn", FUSION)]);
        let count = |code: &str| analysis.findings.iter().filter(|finding| finding.rule.code == code).count();

        let mut cases: Vec<Vec<usize>> = vec![vec![]];
        for (_, values, possible) in columns {
            let values = (0..values.len()).filter(|&value| possible[value]);
            cases = cases
                .iter()
                .flat_map(|case| values.clone().map(|value| [case.as_slice(), &[value]].concat()))
                .collect();
        }
        let fits = |row: &[Vec<usize>], case: &[usize]| row.iter().zip(case).all(|(cell, value)| cell.contains(value));
        let is_missing = cases.iter().any(|case| !rows.iter().any(|row| fits(row, case)));
        let common =
            |one: &[Vec<usize>], other: &[Vec<usize>]| cases.iter().any(|case| fits(one, case) && fits(other, case));
        let doubled = (0..rows.len()).filter(|&second| rows[..second].iter().any(|first| common(first, &rows[second])));
        let doubled = doubled.count();
        let unreal = rows.iter().filter(|row| !cases.iter().any(|case| fits(row, case))).count();
        assert_eq!(
            (count("LM0423") == 1, count("LM0424"), count("LM0425")),
            (is_missing, doubled, unreal),
            "{}\n{behavior}",
            report(&analysis)
        );
        incomplete += usize::from(is_missing);
        overlaps += doubled;
        never += unreal;

        let Some(checked) = analysis.checked() else { continue };
        complete += 1;
        let plan = plan::build(checked, Id::new(0), Id::new(0), &[]);
        for case in &cases {
            let row = rows.iter().position(|row| fits(row, case)).unwrap();
            let range = [1.0, f64::NAN, 9.0][case[0]];
            let touch = [1, 2, 3].map(|column| case.get(column) == Some(&0));
            assert_eq!(Run::new(&plan, 1).step(range, touch)[0].1, [row as f64], "{case:?}\n{behavior}");
        }
    }
    assert!(
        complete > 100 && incomplete > 60 && overlaps > 30 && never > 20,
        "{complete} {incomplete} {overlaps} {never}"
    );
}
