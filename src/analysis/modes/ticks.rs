//! The ticks that can be: every feasible truth of a formula's atoms, with readings that give it.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use super::faults::{self, FaultSet};
use super::formula::{Atom, Formula, Operand};
use super::fusion::{Asked, Fusion, Question, Readings, Valuation};
use crate::analysis::support::{Cut, Interval};
use crate::base::{Exact, Id};
use crate::ir::{Diagram, Program, Sense, Sensor};

/// What the modes of a diagram are looked at with.
pub(in crate::analysis) struct Scene<'a> {
    pub(in crate::analysis) program: &'a Program,
    pub(in crate::analysis) diagram: &'a Diagram,
    fusion: Rc<Fusion>,
    /// The numbers of the diagram's senses.
    senses: Vec<u32>,
}

impl<'a> Scene<'a> {
    pub(in crate::analysis) fn new(program: &'a Program, diagram: &'a Diagram) -> Self {
        Self::sharing(program, diagram, &Rc::default())
    }

    /// With what is known of the networks by now. Sensors and networks are the same in all programs that share it.
    pub(super) fn sharing(program: &'a Program, diagram: &'a Diagram, fusion: &Rc<Fusion>) -> Self {
        Self { program, diagram, fusion: Rc::clone(fusion), senses: fusion.senses(diagram) }
    }

    /// Whether every sense has its inputs. Where they were broken, what its events do is unknown.
    pub(in crate::analysis) fn is_whole(&self) -> bool {
        let is_whole = |sense: &Sense| sense.inputs.len() == self.program.networks[sense.network].inputs.len();
        self.diagram.senses.iter().all(is_whole)
    }

    fn readings(&self, sensor: Id<Sensor>, faults: &FaultSet) -> Option<Interval> {
        faults::readings(self.program, self.diagram, sensor, faults)
    }
}

/// A feasible tick; timers and counters are the state's, and count as clear here.
#[derive(Debug, Clone)]
pub(super) struct Tick {
    /// A bit for each atom that is true.
    pub(super) truth: u64,
    /// Readings that give it, apart from the past; `None` where it is not excluded, but not shown either.
    pub(super) readings: Option<Readings>,
}

/// More ticks than this are not looked into.
const MOST_TICKS: usize = 1 << 13;

/// Where a sensor can read, as far as comparisons can tell.
type Cell = (Interval, Exact);

/// Every feasible tick; `None` where there are too many, or a number cannot be kept exactly.
pub(super) fn feasible(scene: &Scene<'_>, formula: &Formula, faults: &FaultSet) -> Option<Vec<Tick>> {
    let decided = decided(scene, formula, faults)?;
    let free: Vec<_> = (0..formula.atoms.len()).filter(|atom| is_free(&formula.atoms[*atom])).collect();
    let choices = 1_usize << free.len().min(16);
    if decided.len() * choices > MOST_TICKS {
        return None;
    }
    let choices: Vec<u64> = (0..choices)
        .map(|choice| free.iter().enumerate().map(|(bit, atom)| (choice as u64 >> bit & 1) << atom).sum())
        .collect();
    let chosen = |tick: Tick| choices.iter().map(move |chosen| Tick { truth: tick.truth | chosen, ..tick.clone() });
    Some(decided.into_iter().flat_map(chosen).collect())
}

/// The same as far as readings and failures decide; the other atoms are clear.
pub(super) fn decided(scene: &Scene<'_>, formula: &Formula, faults: &FaultSet) -> Option<Vec<Tick>> {
    let fixed = fixed(scene.program, formula, faults);
    let cells = compared(scene, formula, faults)?;
    let sizes: Vec<_> = cells.values().map(Vec::len).collect();
    if sizes.iter().copied().try_fold(1, usize::checked_mul)? > MOST_TICKS {
        return None;
    }
    let fused = Fused::new(scene, formula, faults);
    let mut ticks = Vec::new();
    let mut known = BTreeSet::new();
    let mut place = vec![0; cells.len()];
    loop {
        let here: BTreeMap<_, _> =
            cells.iter().zip(&place).map(|((sensor, cells), at)| (*sensor, cells[*at])).collect();
        let held = fixed | comparisons(formula, &here);
        for valuation in fused.within(&here)?.iter() {
            let truth = held | fused.truth(valuation.set);
            if known.insert(truth) {
                let readings = valuation.readings.as_ref().and_then(|fused| merged(formula, &here, fused));
                ticks.push(Tick { truth, readings });
            }
        }
        if ticks.len() > MOST_TICKS {
            return None;
        }
        let Some(digit) = (0..sizes.len()).find(|digit| place[*digit] + 1 < sizes[*digit]) else { break };
        place[..digit].fill(0);
        place[digit] += 1;
    }
    // What is shown comes first, so that it is found first.
    ticks.sort_by_key(|tick| tick.readings.is_none());
    Some(ticks)
}

/// Whether readings and failures leave it open.
fn is_free(atom: &Atom) -> bool {
    match atom {
        Atom::Past(..) | Atom::Done | Atom::Inside(_) | Atom::Open(_) => true,
        // Readings and failures decide, or the state.
        Atom::Event { .. }
        | Atom::Compare(..)
        | Atom::Failed(_)
        | Atom::After(_)
        | Atom::Count(..)
        | Atom::Lasted(_)
        | Atom::In(_)
        | Atom::Entered(_)
        | Atom::Left(_) => false,
    }
}

/// The atoms that the faults decide.
fn fixed(program: &Program, formula: &Formula, faults: &FaultSet) -> u64 {
    let is_failed = |atom: &Atom| matches!(atom, Atom::Failed(sensor) if faults::is_reported(program, faults, *sensor));
    formula.truth_of(is_failed)
}

/// The cells of every sensor that is compared. A sensor beside a number is cut at the number. Sensors beside each
/// other are cut at all their numbers, and take as many readings between two as there are such sensors: every order
/// of them is then among the combinations.
fn compared(scene: &Scene<'_>, formula: &Formula, faults: &FaultSet) -> Option<BTreeMap<Id<Sensor>, Vec<Cell>>> {
    let mut cuts: BTreeMap<Id<Sensor>, BTreeSet<Exact>> = BTreeMap::new();
    let mut linked = BTreeSet::new();
    for atom in &formula.atoms {
        match atom {
            Atom::Compare(_, sensor, Operand::Number(number)) => {
                cuts.entry(*sensor).or_default().insert(*number);
            }
            Atom::Compare(_, left, Operand::Sensor(right)) => {
                cuts.entry(*left).or_default();
                cuts.entry(*right).or_default();
                linked.extend([*left, *right]);
            }
            _ => {}
        }
    }
    let mut together = BTreeSet::new();
    for sensor in &linked {
        let range = scene.program.sensors[*sensor].range;
        let (from, to) = scene.readings(*sensor, faults).unwrap_or((Cut::before(range.0), Cut::after(range.1)));
        together.extend(cuts[sensor].iter().chain([&from.at, &to.at]));
    }
    let of_sensor = |(sensor, own): (Id<Sensor>, BTreeSet<Exact>)| {
        let range = scene.program.sensors[sensor].range;
        // A sensor without any degree still has a reading, and nothing is known of it.
        let within = scene.readings(sensor, faults).unwrap_or((Cut::before(range.0), Cut::after(range.1)));
        let (cuts, count) = if linked.contains(&sensor) { (&together, linked.len()) } else { (&own, 1) };
        Some((sensor, cut(within, cuts, count)?))
    };
    cuts.into_iter().map(of_sensor).collect()
}

/// The readings of an interval one by one where it is cut, and `count` of those between two cuts.
fn cut((from, to): Interval, cuts: &BTreeSet<Exact>, count: usize) -> Option<Vec<Cell>> {
    let mut cuts = cuts.clone();
    cuts.extend([from.at, to.at]);
    let cuts: Vec<_> = cuts.into_iter().filter(|at| from.at <= *at && *at <= to.at).collect();
    let mut cells = Vec::new();
    for (index, &at) in cuts.iter().enumerate() {
        if from <= Cut::before(at) && Cut::after(at) <= to {
            cells.push(((Cut::before(at), Cut::after(at)), at));
        }
        let Some(&next) = cuts.get(index + 1) else { continue };
        let mut low = at;
        for _ in 0..count {
            low = low.between(next)?;
            cells.push(((Cut::after(at), Cut::before(next)), low));
        }
    }
    Some(cells)
}

/// The comparisons that hold at some readings.
fn comparisons(formula: &Formula, here: &BTreeMap<Id<Sensor>, Cell>) -> u64 {
    let holds = |atom: &Atom| match atom {
        Atom::Compare(comparison, left, right) => {
            let right = match right {
                Operand::Number(number) => *number,
                Operand::Sensor(sensor) => here[sensor].1,
            };
            comparison.holds(here[left].1, right)
        }
        _ => false,
    };
    formula.truth_of(holds)
}

/// What networks say of the events of a formula.
struct Fused<'s, 'a> {
    scene: &'s Scene<'a>,
    faults: &'s FaultSet,
    /// Its events among its atoms.
    atoms: Vec<usize>,
    /// Their sensors, with whether each gives any reading.
    sensors: Vec<(Id<Sensor>, bool)>,
    asked: Rc<RefCell<Asked>>,
}

impl<'s, 'a> Fused<'s, 'a> {
    fn new(scene: &'s Scene<'a>, formula: &Formula, faults: &'s FaultSet) -> Self {
        let is_event = |atom: &usize| matches!(formula.atoms[*atom], Atom::Event { .. });
        let atoms = (0..formula.atoms.len()).filter(is_event).collect();
        let question = question(scene, &events(formula), faults);
        let sensors = question.feeds.iter().map(|(sensor, feed)| (*sensor, feed.is_some())).collect();
        Self { scene, faults, atoms, sensors, asked: scene.fusion.about(question) }
    }

    /// What can be set together in one combination of cells; `None` where there is too much to look into.
    fn within(&self, here: &BTreeMap<Id<Sensor>, Cell>) -> Option<Rc<Vec<Valuation>>> {
        if self.atoms.is_empty() {
            let is_shown = here.keys().all(|sensor| self.scene.readings(*sensor, self.faults).is_some());
            return Some(Rc::new(vec![Valuation { set: 0, readings: is_shown.then(Vec::new) }]));
        }
        let sensors = self.sensors.iter().enumerate().filter(|(_, (_, reads))| *reads);
        let within = sensors.filter_map(|(position, (sensor, _))| Some((position, here.get(sensor)?.0))).collect();
        self.asked.borrow_mut().within(self.scene.program, within)
    }

    /// The atoms of the events that are set.
    fn truth(&self, set: u64) -> u64 {
        self.atoms.iter().enumerate().map(|(bit, atom)| (set >> bit & 1) << atom).sum()
    }
}

/// The events of a formula.
pub(super) fn events(formula: &Formula) -> Vec<(u32, u32)> {
    let events = formula.atoms.iter().filter_map(|atom| match *atom {
        Atom::Event { sense, event } => Some((sense, event)),
        _ => None,
    });
    events.collect()
}

/// What to ask of some events.
fn question(scene: &Scene<'_>, events: &[(u32, u32)], faults: &FaultSet) -> Question {
    let sensors: BTreeSet<_> =
        events.iter().flat_map(|(sense, _)| &scene.diagram.senses[*sense as usize].inputs).copied().collect();
    let feeds = sensors.into_iter().map(|sensor| (sensor, scene.readings(sensor, faults))).collect();
    let events = events.iter().map(|(sense, event)| (scene.senses[*sense as usize], *event)).collect();
    Question { events, feeds }
}

/// Whether some events can be set together under some faults as ever.
pub(super) fn is_fused_alike(scene: &Scene<'_>, events: &[(u32, u32)], faults: &FaultSet) -> bool {
    let sets = |faults: &FaultSet| {
        let asked = scene.fusion.about(question(scene, events, faults));
        let answers = asked.borrow_mut().within(scene.program, Vec::new())?;
        Some(answers.iter().map(|answer| answer.set).collect::<BTreeSet<_>>())
    };
    events.is_empty() || sets(&FaultSet::new()).is_some_and(|healthy| sets(faults) == Some(healthy))
}

/// The readings that set the events, and those of the compared sensors that feed none of them; `None` where the
/// readings of the events put compared sensors into another order.
fn merged(formula: &Formula, here: &BTreeMap<Id<Sensor>, Cell>, fused: &Readings) -> Option<Readings> {
    let mut merged: BTreeMap<_, _> = here.iter().map(|(sensor, (_, at))| (*sensor, *at)).collect();
    merged.extend(fused.iter().copied());
    let moved = here.iter().map(|(sensor, (cell, _))| (*sensor, (*cell, merged[sensor]))).collect();
    (comparisons(formula, &moved) == comparisons(formula, here)).then(|| merged.into_iter().collect())
}
