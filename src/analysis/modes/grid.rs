//! Joint valuations of events from a grid of critical readings.
//!
//! On one sensor everything is linear between corners and crossings, so one reading in each gap and each critical
//! reading itself are all there is. Over several sensors the grid only shows what can be; what it does not show is
//! excluded only by the rules themselves, or by the events that depend on one sensor alone.

use std::collections::{BTreeMap, BTreeSet};

use super::curve::Curve;
use super::fusion::{Fusion, Question, Readings, Valuation};
use crate::analysis::support::{Cut, Interval};
use crate::base::{Exact, Id};
use crate::ir::{Diagram, Event, Program, Rule, Sensor, Variable};

/// More combinations of readings are thinned out.
const MOST_READINGS: usize = 4096;
/// More events than this have too many joint valuations to list.
const MOST_EVENTS: usize = 10;

/// A provider of joint valuations that needs no search.
pub(super) struct Grid<'a> {
    pub(super) program: &'a Program,
}

impl Fusion for Grid<'_> {
    fn valuations(&self, diagram: &Diagram, question: &Question) -> Vec<Valuation> {
        let asked = self.asked(diagram, question);
        let axes: Option<Vec<_>> =
            (0..question.feeds.len()).map(|sensor| self.axis(question, sensor, &asked)).collect();
        let shown = axes.map_or_else(Shown::default, |axes| shown(axes, &asked, question));
        let mut valuations: Vec<_> = shown.valuations.iter().map(|(set, readings)| witnessed(*set, readings)).collect();
        if !shown.complete {
            let all = 0..1_u64 << asked.len().min(MOST_EVENTS);
            let unknown = all.filter(|set| !shown.valuations.contains_key(set));
            let open = unknown.filter(|set| !shown.excludes(*set) && !contradicts(*set, &asked));
            valuations.extend(open.map(|set| Valuation { set, readings: None }));
        }
        valuations
    }
}

fn witnessed(set: u64, readings: &Readings) -> Valuation {
    Valuation { set, readings: Some(readings.clone()) }
}

/// A term of a variable on a sensor of the question.
type Literal = (usize, Id<Variable>, u32, bool);
/// A rule as the maxima it is the minimum of.
type Antecedent = Vec<Vec<Literal>>;

/// An event with its rules over the sensors of the question.
struct Asked {
    contributor: Vec<Antecedent>,
    detractor: Vec<Antecedent>,
}

impl Asked {
    fn literals(&self) -> impl Iterator<Item = &Literal> {
        self.contributor.iter().chain(&self.detractor).flatten().flatten()
    }

    /// Whether this event is set whenever the other one is, whatever the terms look like.
    fn follows_from(&self, other: &Self) -> bool {
        other.contributor.iter().all(|rule| self.contributor.iter().any(|wider| is_at_least(wider, rule)))
            && self.detractor.iter().all(|rule| other.detractor.iter().any(|wider| is_at_least(wider, rule)))
    }
}

/// Whether each maximum of `wider` has all terms of one of `rule`, so that its strength is never below.
fn is_at_least(wider: &Antecedent, rule: &Antecedent) -> bool {
    wider.iter().all(|wide| rule.iter().any(|narrow| narrow.iter().all(|literal| wide.contains(literal))))
}

fn contradicts(set: u64, asked: &[Asked]) -> bool {
    let is_set = |event: usize| set >> event & 1 == 1;
    (0..asked.len()).any(|clear| {
        !is_set(clear) && (0..asked.len()).any(|event| is_set(event) && asked[clear].follows_from(&asked[event]))
    })
}

/// The readings of one sensor at which something changes or stands still, with the degrees there.
struct Axis {
    points: Vec<(Option<Exact>, BTreeMap<Literal, Exact>)>,
}

impl Grid<'_> {
    fn asked(&self, diagram: &Diagram, question: &Question) -> Vec<Asked> {
        let event = |&(sense, event): &(u32, u32)| {
            let sense = &diagram.senses[sense as usize];
            let network = &self.program.networks[sense.network];
            let Event { contributor, detractor, .. } = &network.events[event as usize];
            let place = |sensor: Id<Sensor>| question.feeds.iter().position(|(fed, _)| *fed == sensor).unwrap_or(0);
            let antecedent = |rule: &Rule| -> Antecedent {
                let clauses = rule.clauses.iter().map(|clause| {
                    let (input, variable) = (clause.input as usize, network.inputs[clause.input as usize].variable);
                    let sensor = place(sense.inputs[input]);
                    clause.any_of.iter().map(|literal| (sensor, variable, literal.term, literal.negated)).collect()
                });
                clauses.collect()
            };
            Asked {
                contributor: contributor.iter().map(antecedent).collect(),
                detractor: detractor.iter().map(antecedent).collect(),
            }
        };
        question.events.iter().map(event).collect()
    }

    /// `None` where a number cannot be kept exactly.
    fn axis(&self, question: &Question, sensor: usize, asked: &[Asked]) -> Option<Axis> {
        let literals: BTreeSet<Literal> =
            asked.iter().flat_map(Asked::literals).filter(|literal| literal.0 == sensor).copied().collect();
        let mut curves = BTreeMap::new();
        for &(_, variable, term, _) in &literals {
            let shape = &self.program.variables[variable].terms[term as usize].shape;
            curves.insert((variable, term), Curve::new(shape)?);
        }
        let Some(interval) = question.feeds[sensor].1 else {
            let degree = |negated| if negated { Exact::ONE } else { Exact::ZERO };
            let degrees = literals.iter().map(|literal| (*literal, degree(literal.3))).collect();
            return Some(Axis { points: vec![(None, degrees)] });
        };
        let mut points = Vec::new();
        for reading in critical(&curves.values().collect::<Vec<_>>(), interval)? {
            let mut degrees = BTreeMap::new();
            for literal @ &(_, variable, term, negated) in &literals {
                let degree = curves[&(variable, term)].degree(reading)?;
                degrees.insert(*literal, if negated { Exact::ONE.minus(degree)? } else { degree });
            }
            points.push((Some(reading), degrees));
        }
        Some(Axis { points })
    }
}

/// The corners and crossings of some curves and their complements in an interval, and a reading in each gap.
fn critical(curves: &[&Curve], (from, to): Interval) -> Option<Vec<Exact>> {
    let mut corners: BTreeSet<Exact> = curves.iter().flat_map(|curve| curve.corners()).collect();
    corners.extend([from.at, to.at]);
    corners.retain(|at| from.at <= *at && *at <= to.at);
    let mut readings = corners.clone();
    for (&low, &high) in corners.iter().zip(corners.iter().skip(1)) {
        for (index, curve) in curves.iter().enumerate() {
            readings.extend(curve.crossing_complement(curve, (low, high))?);
            for other in &curves[..index] {
                readings.extend(curve.crossing(other, (low, high))?);
                readings.extend(curve.crossing_complement(other, (low, high))?);
            }
        }
    }
    let gaps: Option<Vec<_>> =
        readings.iter().zip(readings.iter().skip(1)).map(|(low, high)| low.between(*high)).collect();
    readings.extend(gaps?);
    Some(readings.into_iter().filter(|at| from <= Cut::before(*at) && Cut::after(*at) <= to).collect())
}

/// What the grid shows.
#[derive(Default)]
struct Shown {
    valuations: BTreeMap<u64, Readings>,
    /// Whether there is nothing else.
    complete: bool,
    /// Events that are always set, and events that never are, by the bounds of their rules.
    always: u64,
    never: u64,
    /// Events that at most one sensor decides: what is shown of them together is all there is.
    decided: Vec<u64>,
}

impl Shown {
    fn excludes(&self, set: u64) -> bool {
        if set & self.never != 0 || self.always & !set != 0 {
            return true;
        }
        self.decided.iter().any(|events| !self.valuations.keys().any(|shown| shown & events == set & events))
    }
}

fn shown(mut axes: Vec<Axis>, asked: &[Asked], question: &Question) -> Shown {
    let mut result = Shown::default();
    for (index, event) in asked.iter().enumerate() {
        let (contributor, detractor) = (bounds(&event.contributor, &axes), bounds(&event.detractor, &axes));
        result.never |= u64::from(contributor.1 <= detractor.0) << index;
        result.always |= u64::from(contributor.0 > detractor.1) << index;
    }
    let is_free: Vec<_> = axes.iter().map(|axis| axis.points.len() > 1).collect();
    let whole = axes.iter().map(|axis| axis.points.len()).try_fold(1_usize, usize::checked_mul);
    let thinned = whole.is_none_or(|whole| whole > MOST_READINGS);
    while axes
        .iter()
        .map(|axis| axis.points.len())
        .try_fold(1_usize, usize::checked_mul)
        .is_none_or(|n| n > MOST_READINGS)
    {
        let Some(longest) = axes.iter_mut().max_by_key(|axis| axis.points.len()) else { break };
        let mut keep = false;
        longest.points.retain(|_| {
            keep = !keep;
            keep
        });
    }
    let free_sensors = |events: &mut dyn Iterator<Item = &Asked>| -> BTreeSet<usize> {
        events.flat_map(Asked::literals).map(|literal| literal.0).filter(|sensor| is_free[*sensor]).collect()
    };
    if !thinned {
        let sensors: Vec<_> = asked.iter().map(|event| free_sensors(&mut std::iter::once(event))).collect();
        result.complete = sensors.iter().all(|sensors| sensors.len() <= 1);
        for sensor in 0..axes.len() {
            let decided = (0..asked.len()).filter(|event| sensors[*event].iter().all(|other| *other == sensor));
            result.decided.push(decided.map(|event| 1 << event).sum());
        }
    }
    let ranks = ranks(&axes);
    let mut place = vec![0; axes.len()];
    if axes.iter().any(|axis| axis.points.is_empty()) {
        return result;
    }
    loop {
        let degree = |literal: &Literal| ranks[literal.0][place[literal.0]][literal];
        let strength = |rule: &Antecedent| {
            rule.iter().map(|clause| clause.iter().map(degree).max().unwrap_or(0)).min().unwrap_or(u32::MAX)
        };
        let side = |rules: &[Antecedent]| rules.iter().map(strength).max().unwrap_or(0);
        let is_set = |event: &Asked| side(&event.contributor) > side(&event.detractor);
        let set = asked.iter().enumerate().filter(|(_, event)| is_set(event)).map(|(index, _)| 1 << index).sum();
        result.valuations.entry(set).or_insert_with(|| {
            let readings = question.feeds.iter().zip(&axes).zip(&place);
            readings.filter_map(|(((sensor, _), axis), place)| Some((*sensor, axis.points[*place].0?))).collect()
        });
        // The next combination of readings: count up, with the first sensor as the last digit.
        let Some(digit) = (0..axes.len()).find(|axis| place[*axis] + 1 < axes[*axis].points.len()) else { break };
        place[..digit].fill(0);
        place[digit] += 1;
    }
    result
}

/// The least and the greatest strength that one side of an event can have, where a degree that is not the same at all
/// readings can be any.
fn bounds(rules: &[Antecedent], axes: &[Axis]) -> (Exact, Exact) {
    let degree = |literal: &Literal| {
        let mut degrees = axes[literal.0].points.iter().map(|(_, degrees)| degrees[literal]);
        let first = degrees.next().unwrap_or(Exact::ZERO);
        if degrees.all(|degree| degree == first) { (first, first) } else { (Exact::ZERO, Exact::ONE) }
    };
    let larger = |a: (Exact, Exact), b: (Exact, Exact)| (a.0.max(b.0), a.1.max(b.1));
    let smaller = |a: (Exact, Exact), b: (Exact, Exact)| (a.0.min(b.0), a.1.min(b.1));
    let (zero, one) = ((Exact::ZERO, Exact::ZERO), (Exact::ONE, Exact::ONE));
    let clause = |clause: &Vec<Literal>| clause.iter().map(degree).fold(zero, larger);
    let strength = |rule: &Antecedent| rule.iter().map(clause).fold(one, smaller);
    rules.iter().map(strength).fold(zero, larger)
}

/// Every degree as its place in the order of all degrees: minima, maxima and comparisons need no more. A rule
/// without clauses is stronger than any, as strong as 1.
fn ranks(axes: &[Axis]) -> Vec<Vec<BTreeMap<Literal, u32>>> {
    let degrees: BTreeSet<Exact> =
        axes.iter().flat_map(|axis| &axis.points).flat_map(|(_, degrees)| degrees.values()).copied().collect();
    let order: BTreeMap<Exact, u32> = degrees.into_iter().zip(1..).collect();
    let rank = |degree: &Exact| match order[degree] {
        _ if degree.is_zero() => 0,
        _ if *degree == Exact::ONE => u32::MAX,
        rank => rank,
    };
    let of_point =
        |degrees: &BTreeMap<Literal, Exact>| degrees.iter().map(|(key, degree)| (*key, rank(degree))).collect();
    axes.iter().map(|axis| axis.points.iter().map(|(_, degrees)| of_point(degrees)).collect()).collect()
}
