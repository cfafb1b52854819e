//! Continuous outputs: every reading gives them a value, and their sets can be defuzzified as is asked.

use super::breakpoints::{self, in_order};
use super::events::{listed, whole};
use super::network::{Fault, FaultSet, Feed, Model, Verdict};
use super::support::support;
use crate::base::{Exact, Id, Span};
use crate::diag::{Diagnostic, rules};
use crate::ir::{
    Aggregation, Defuzzifier, Diagram, Event, FailReading, Implication, Inference, Network, Output, Program, SNorm,
    Shape, Statement, Symbol, TNorm, Term,
};
use crate::membership::{Curve, Membership, function, in_units, middle_of_largest, overlaps};

/// The most choices of overlapping sets that a centroid is computed from.
const MOST_OVERLAPS: usize = 256;

/// Judges the outputs of a network on its own, with at most so many failed sensors.
pub(super) fn check(program: &Program, network: Id<Network>, faults: usize, findings: &mut Vec<Diagnostic>) {
    let network = &program.networks[network];
    let is_known = |term: &Term| term.shape != Shape::Points(Vec::new());
    for output in network.outputs.iter().filter(|output| output.terms.iter().all(is_known)) {
        breakpoints::check(&output.terms, &output.unit, findings);
        if let Some(range) = output.range.filter(|_| output.terms.iter().all(|term| in_order(&term.shape))) {
            check_sets(output, range, network.inference, findings);
        }
    }
    let feeds = Feed::of_variables(program, network);
    let Some(model) = modeled(program, network, &feeds) else { return };
    for (index, output) in network.outputs.iter().enumerate().filter(|(_, output)| output.default.is_none()) {
        findings.extend(gap(program, network, &model, index, faults).map(|gap| gap.at_output(output)));
    }
}

/// Judges the outputs of networks whose sensors give readings beyond the variables that they feed.
pub(super) fn check_senses(program: &Program, diagram: &Diagram, findings: &mut Vec<Diagnostic>) {
    for sense in &diagram.senses {
        let network = &program.networks[sense.network];
        let variables = Feed::of_variables(program, network);
        let sensors = sense.inputs.iter().map(|&sensor| program.sensors[sensor].range).zip(&variables);
        let feeds: Vec<_> = sensors.map(|(range, feed)| Feed { range, fails: feed.fails.clone() }).collect();
        let is_wider = feeds
            .iter()
            .zip(&variables)
            .any(|(feed, variable)| feed.range.0 < variable.range.0 || feed.range.1 > variable.range.1);
        // Readings of a part of the range are judged with the network.
        if !is_wider || feeds.len() != network.inputs.len() {
            continue;
        }
        let Some((alone, model)) = modeled(program, network, &variables).zip(modeled(program, network, &feeds)) else {
            continue;
        };
        for (index, output) in network.outputs.iter().enumerate().filter(|(_, output)| output.default.is_none()) {
            if gap(program, network, &alone, index, 0).is_none() {
                let gap = gap(program, network, &model, index, 0);
                findings.extend(gap.map(|gap| gap.at_sense(&sense.symbol, output)));
            }
        }
    }
}

/// A network whose events are set where some rule of an output fires.
fn modeled(program: &Program, network: &Network, feeds: &[Feed]) -> Option<Model> {
    let event = |output: &Output| Event {
        symbol: output.symbol.clone(),
        contributor: output.rules.iter().flat_map(|rule| rule.cases.clone()).collect(),
        detractor: Vec::new(),
        hysteresis: Exact::ZERO,
        hold: 0,
        confirm: 0,
    };
    let is_asked = network.outputs.iter().any(|output| output.default.is_none()) && whole(program, network);
    let events = network.outputs.iter().map(event).collect();
    is_asked.then(|| Model::fed_by(program, &Network { events, ..network.clone() }, feeds)).flatten()
}

/// Readings at which no rule of an output fires, or what leaves open whether there are any.
struct Gap {
    message: String,
    example: String,
    note: Option<&'static str>,
}

/// All norms agree on what is 0 and what is 1 where minimum and maximum are: so the readings that are found have no
/// rule that fires. Norms that can be 0, or 1, between other degrees may leave more.
fn gap(program: &Program, network: &Network, model: &Model, index: usize, faults: usize) -> Option<Gap> {
    let output = &network.outputs[index];
    // A failed sensor whose reading is in range is one that reads it; only one without a reading is new.
    let is_absent = |fault: &Fault| fault.reading == FailReading::Absent;
    let sets = model.fault_sets(faults);
    let verdicts = sets.into_iter().filter(|set| set.iter().all(is_absent)).map(|set| (model.clear(index, &set), set));
    let (verdict, failed) = verdicts.into_iter().find(|(verdict, _)| verdict.is_possible()).unzip();
    let name = &output.symbol.name;
    match verdict {
        Some(Verdict::Possible(witness)) => {
            let failed: FaultSet = failed.unwrap_or_default();
            let shown =
                network.inputs.iter().zip(witness.readings).enumerate().filter_map(|(position, (input, reading))| {
                    let name = &input.symbol.name;
                    let unit = &program.variables[input.variable].unit;
                    let at = reading.map(|reading| format!("`{name}` at {}", unit.show(reading.to_f64())));
                    let is_failed = failed.iter().any(|fault| fault.input == position);
                    at.or_else(|| is_failed.then(|| format!("`{name}` without a reading")))
                });
            let shown: Vec<_> = shown.collect();
            let example = if shown.is_empty() {
                "whatever is read".to_owned()
            } else {
                format!("for instance with {}", listed(shown, "and"))
            };
            Some(Gap { message: format!("no rule sets `{name}` at some readings"), example, note: None })
        }
        Some(_) => Some(Gap {
            message: format!("it is not known that some rule always sets `{name}`"),
            example: "the degrees of smooth terms are known within bounds, which are too wide to say".to_owned(),
            note: None,
        }),
        None if has_loose_norm(network.inference, output) => Some(Gap {
            message: format!("it is not known that some rule always sets `{name}`"),
            example: "the norms that were chosen can come to 0 though all degrees are above 0".to_owned(),
            note: None,
        }),
        None => None,
    }
}

/// Whether a rule uses a norm that can be 0 although no degree is 0, or 1 although none is 1.
fn has_loose_norm(inference: Inference, output: &Output) -> bool {
    let Inference { and, or, .. } = inference;
    let and = matches!(and, TNorm::Bounded | TNorm::Drastic | TNorm::Nilpotent);
    let or = matches!(or, SNorm::Bounded | SNorm::Drastic | SNorm::Nilpotent);
    output.rules.iter().flat_map(|rule| &rule.antecedent).any(|statement| match statement {
        Statement::All(_) => and,
        Statement::Any(_) => or,
        Statement::Is(_) | Statement::Not(_) => false,
    })
}

impl Gap {
    fn at(self, span: Span, output: &Output) -> Diagnostic {
        let value = output.range.map_or_else(
            || output.unit.show(0.0),
            |(low, high)| output.unit.show(0.0_f64.clamp(low.to_f64(), high.to_f64())),
        );
        let diagnostic = Diagnostic::new(&rules::OUTPUT_GAP, span, self.message)
            .note(self.example)
            .help(format!("say what it is then: `default {value}` or `default hold`; or add a rule"));
        match self.note {
            Some(note) => diagnostic.note(note),
            None => diagnostic,
        }
    }

    fn at_output(self, output: &Output) -> Diagnostic {
        self.at(output.symbol.span, output)
    }

    fn at_sense(self, sense: &Symbol, output: &Output) -> Diagnostic {
        let note = Some("the sensor gives readings beyond the range of the variable that it feeds");
        Self { note, ..self }.at(sense.span, output).label(output.symbol.span, "the output, which has no `default`")
    }
}

fn check_sets(output: &Output, range: (Exact, Exact), inference: Inference, findings: &mut Vec<Diagnostic>) {
    let found = findings.len();
    for term in &output.terms {
        findings.extend(unfit(term, output, range, inference));
    }
    let is_counted = (inference.defuzzifier, inference.implication, inference.aggregation)
        == (Defuzzifier::Centroid, Implication::Minimum, Aggregation::Maximum);
    if is_counted && findings.len() == found {
        let (pi, range) = in_units(range);
        let curves: Vec<Curve> = output.terms.iter().map(|term| Membership::new(&term.shape, pi).low).collect();
        if overlaps(&curves, &range, MOST_OVERLAPS).is_none() {
            findings.push(too_many(output));
        }
    }
}

/// What keeps a set from being defuzzified.
fn unfit(term: &Term, output: &Output, range: (Exact, Exact), inference: Inference) -> Option<Diagnostic> {
    let (pi, units) = in_units(range);
    match inference.defuzzifier {
        Defuzzifier::WeightedAverage if support(&term.shape, range).is_empty() => {
            Some(without_area(term, output, "is 0 for every value of", "move the set into the range"))
        }
        Defuzzifier::WeightedAverage => {
            middle_of_largest(&term.shape, range).is_none().then(|| smooth(term, "where it is largest"))
        }
        Defuzzifier::Midpoints(parts) => {
            let (low, high) = (range.0.to_f64(), range.1.to_f64());
            let at = |part: u32| low + (f64::from(part) + 0.5) * ((high - low) / f64::from(parts));
            let degree = function(&term.shape);
            let is_seen = (0..parts).any(|part| degree(at(part)) > 0.0);
            (!is_seen).then(|| {
                without_area(term, output, "is 0 at every midpoint of", "take more midpoints, or widen the set")
            })
        }
        Defuzzifier::Centroid
        | Defuzzifier::Bisector
        | Defuzzifier::SmallestOfMaximum
        | Defuzzifier::LargestOfMaximum
        | Defuzzifier::MeanOfMaximum => {
            let membership = Membership::new(&term.shape, pi);
            if !membership.is_exact() {
                Some(smooth(term, "its area"))
            } else if !membership.low.has_area(&units) {
                let help = "widen the set or the range; single values are for `using { defuzzify weighted_average }`";
                Some(without_area(term, output, "holds no stretch of the range of", help))
            } else {
                None
            }
        }
    }
}

fn without_area(term: &Term, output: &Output, what: &str, help: &str) -> Diagnostic {
    let message = format!("`{}` {what} `{}`", term.symbol.name, output.symbol.name);
    Diagnostic::new(&rules::SET_WITHOUT_AREA, term.shape_span, message)
        .note("a rule that names it would fire without giving the output a value")
        .help(help)
}

fn smooth(term: &Term, what: &str) -> Diagnostic {
    let message = format!("the set `{}` is smooth, so {what} is not computed exactly", term.symbol.name);
    Diagnostic::new(&rules::NOT_EXACT, term.shape_span, message)
        .note("sets of straight lines are defuzzified exactly; others need a number of midpoints to look at")
        .help("write `using { defuzzify centroid midpoints 200 }`, or draw the set with `points`")
}

fn too_many(output: &Output) -> Diagnostic {
    let message = format!("too many sets of `{}` overlap", output.symbol.name);
    Diagnostic::new(&rules::NOT_EXACT, output.symbol.span, message)
        .note(format!("an exact centroid adds up every choice of sets that overlap; at most {MOST_OVERLAPS} are taken"))
        .help("narrow the sets, or write `using { defuzzify centroid midpoints 200 }`")
}
