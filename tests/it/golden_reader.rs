//! Reads the networks of `tests/golden` and turns each way in which their inputs fail into networks of ours.

use lmslc::analysis::network::{Fault, FaultSet};
use lmslc::base::{Exact, Id, Span, Unit};
use lmslc::ir::{
    Clause, Event, FailReading, Inference, Literal, Network, NetworkInput, Program, Rule, Shape, Symbol, Term, Variable,
};
use serde_json::Value;

/// A network under one failure. What is possible in any of the alternatives is possible.
pub struct Case {
    pub name: String,
    pub alternatives: Vec<(Program, FaultSet)>,
}

pub fn read(path: &str) -> Vec<Value> {
    let text = std::fs::read_to_string(crate::support::root().join("tests/golden").join(path)).unwrap();
    match serde_json::from_str(&text) {
        Ok(one) => vec![one],
        Err(_) => text.lines().map(|line| serde_json::from_str(line).unwrap()).collect(),
    }
}

/// Every single failure of a network, none first.
pub fn cases(net: &Value) -> Vec<Case> {
    let nominal = Case { name: "nominal".to_owned(), alternatives: vec![(program(net), Vec::new())] };
    let variables = net["variables"].as_array().unwrap().iter().enumerate();
    let faults = variables.flat_map(|(input, variable)| {
        let faults = variable["faults"].as_array().map_or(&[][..], Vec::as_slice);
        faults.iter().map(move |fault| case(net, input, variable, fault))
    });
    std::iter::once(nominal).chain(faults).collect()
}

fn case(net: &Value, input: usize, variable: &Value, fault: &Value) -> Case {
    let text = |key: &str| fault[key].as_str().unwrap_or_default();
    let (low, high) = range(variable);
    let failed = |reading| {
        let mut program = program(net);
        fails(&mut program, input, reading);
        (program, vec![Fault { input, reading }])
    };
    let sides: Vec<Exact> = match text("side") {
        "low" => vec![low],
        "high" => vec![high],
        _ => vec![low, high],
    };
    let alternatives = match (text("kind"), text("policy")) {
        ("stuck", _) => vec![failed(FailReading::Value(number(&fault["value"])))],
        ("dropout", "any") => vec![failed(FailReading::Any)],
        ("dropout", "zero") | ("out_of_range", "reject") => vec![failed(FailReading::Absent)],
        ("dropout", "ignore") => vec![(without(net, input), Vec::new())],
        ("out_of_range", "clamp") => sides.into_iter().map(|side| failed(FailReading::Value(side))).collect(),
        ("out_of_range", "raw") => {
            sides.into_iter().map(|side| (beyond(net, input, side == low), Vec::new())).collect()
        }
        other => panic!("{other:?}"),
    };
    let detail = match text("kind") {
        "stuck" => {
            format!("stuck={}", fault["value"].as_str().map_or_else(|| fault["value"].to_string(), str::to_owned))
        }
        "dropout" => format!("dropout:{}", text("policy")),
        kind => format!("{kind}:{}:{}", text("side"), text("policy")),
    };
    Case { name: format!("{}:{detail}", variable["name"].as_str().unwrap()), alternatives }
}

/// The network with five failures for each input: stuck at two readings, at an unknown one, absent, and stuck at the
/// end of its range.
pub fn with_every_failure(net: &Value) -> Program {
    let mut program = program(net);
    for (input, variable) in net["variables"].as_array().unwrap().iter().enumerate() {
        let faults = variable["faults"].as_array().unwrap().iter();
        let stuck =
            faults.filter(|fault| fault["kind"] == "stuck").map(|fault| FailReading::Value(number(&fault["value"])));
        let stuck: Vec<_> = stuck.collect();
        for reading in
            stuck.into_iter().chain([FailReading::Any, FailReading::Absent, FailReading::Value(range(variable).1)])
        {
            fails(&mut program, input, reading);
        }
    }
    program
}

/// Lets an input fail in one more way.
pub fn fails(program: &mut Program, input: usize, reading: FailReading) {
    let variable = program.networks[Id::new(0)].inputs[input].variable;
    program.variables[variable].fails.push(reading);
}

/// The network without an input; a rule left with nothing has strength 0.
fn without(net: &Value, input: usize) -> Program {
    let mut program = program(net);
    for event in &mut program.networks[Id::new(0)].events {
        for rule in event.contributor.iter_mut().chain(&mut event.detractor) {
            let named = rule.clauses.len();
            rule.clauses.retain(|clause| clause.input as usize != input);
            if named > 0 && rule.clauses.is_empty() {
                rule.clauses.push(Clause { input: 0, any_of: Vec::new() });
            }
        }
    }
    program
}

/// The network with an input that reads only what is beyond one end of its range.
fn beyond(net: &Value, input: usize, below: bool) -> Program {
    let mut program = program(net);
    let variable = program.networks[Id::new(0)].inputs[input].variable;
    let range = &mut program.variables[variable].range;
    let moved = |from: Exact, by: (i128, i128)| {
        let ratio = from.ratio();
        Exact::new(ratio.numer() * by.1 + by.0 * ratio.denom(), ratio.denom() * by.1, 0)
    };
    *range = if below {
        (moved(range.0, (-1000, 1)), moved(range.0, (-1, 1_000_000)))
    } else {
        (moved(range.1, (1, 1_000_000)), moved(range.1, (1000, 1)))
    };
    program
}

/// The network as a program of its own.
pub fn program(net: &Value) -> Program {
    let mut program = Program::default();
    let mut inputs = Vec::new();
    for variable in net["variables"].as_array().unwrap() {
        let terms = variable["terms"].as_array().unwrap().iter();
        let terms =
            terms.map(|term| Term { symbol: symbol(&term["name"]), shape: shape(term), shape_span: Span::default() });
        let range = range(variable);
        let symbol = symbol(&variable["name"]);
        let declared = Variable {
            symbol: symbol.clone(),
            unit: Unit::one(),
            range,
            fails: Vec::new(),
            terms: terms.collect(),
            incomplete: false,
        };
        inputs.push(NetworkInput { symbol, variable: program.variables.add(declared) });
    }
    let events = net["events"].as_array().unwrap().iter().map(|event| Event {
        symbol: symbol(&event["name"]),
        contributor: rules(&event["contributor"]),
        detractor: rules(&event["detractor"]),
        hysteresis: Exact::ZERO,
        hold: 0,
        confirm: 0,
    });
    let symbol = symbol(&net["name"]);
    let (events, outputs) = (events.collect(), Vec::new());
    let inference = Inference::default();
    program.networks.add(Network { symbol, inputs, events, inference, outputs, incomplete: false });
    program
}

fn rules(rules: &Value) -> Vec<Rule> {
    let rule = |rule: &Value| {
        let terms = (0..).zip(rule.as_array().unwrap());
        let clauses = terms.filter_map(|(input, term)| {
            let term = u32::try_from(term.as_u64()?).unwrap();
            Some(Clause { input, any_of: vec![Literal { term, negated: false }] })
        });
        Rule { clauses: clauses.collect(), span: Span::default() }
    };
    rules.as_array().unwrap().iter().map(rule).collect()
}

fn shape(term: &Value) -> Shape {
    let (kind, value) = term.as_object().unwrap().iter().find(|(key, _)| *key != "name").unwrap();
    let corners = || value.as_array().unwrap().iter().map(number).collect::<Vec<_>>();
    let ramp = |from: Exact, to: Exact, rising: bool| match (from == to, rising) {
        (true, true) => Shape::Points(vec![(from, Exact::ZERO), (from, Exact::ONE)]),
        (true, false) => Shape::Points(vec![(from, Exact::ONE), (from, Exact::ZERO)]),
        (false, true) => Shape::Ramp { zero_at: from, one_at: to },
        (false, false) => Shape::Ramp { zero_at: to, one_at: from },
    };
    match kind.as_str() {
        "tri" => Shape::Triangle(corners().try_into().unwrap()),
        "trap" => Shape::Trapezoid(corners().try_into().unwrap()),
        "crisp" => Shape::Rectangle(corners().try_into().unwrap()),
        "ramp_up" => ramp(corners()[0], corners()[1], true),
        "ramp_down" => ramp(corners()[0], corners()[1], false),
        "singleton" => Shape::Singleton(number(value)),
        "points" => {
            let points = value.as_array().unwrap().iter();
            Shape::Points(points.map(|point| (number(&point[0]), number(&point[1]))).collect())
        }
        other => panic!("{other}"),
    }
}

fn range(variable: &Value) -> (Exact, Exact) {
    (number(&variable["range"][0]), number(&variable["range"][1]))
}

fn number(value: &Value) -> Exact {
    let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    match text.split_once('/') {
        Some((above, below)) => Exact::new(above.parse().unwrap(), below.parse().unwrap(), 0),
        None => Exact::parse(&text).unwrap(),
    }
}

fn symbol(name: &Value) -> Symbol {
    Symbol { name: name.as_str().unwrap_or_default().to_owned(), ..Symbol::default() }
}
