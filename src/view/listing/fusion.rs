//! Variables and networks.

use super::{Lines, outputs};
use crate::base::Exact;
use crate::ir::{Clause, Event, FailReading, Network, Part, Program, Rule, Shape, Variable};

pub(super) fn variable(lines: &mut Lines, variable: &Variable) {
    let (low, high) = variable.range;
    let unit = variable.unit.dimension.si_unit();
    lines.head(format_args!("variable {}: {unit} in {low} .. {high}{}", variable.symbol.name, fails(&variable.fails)));
    for term in &variable.terms {
        lines.add(1, format_args!("{} = {}", term.symbol.name, shape(&term.shape)));
    }
}

/// How a sensor fails, as a clause of its declaration.
pub(super) fn fails(fails: &[FailReading]) -> String {
    let ways = fails.iter().map(|fail| match fail {
        FailReading::Value(at) => at.to_string(),
        FailReading::Any => "any".to_owned(),
        FailReading::Absent => "absent".to_owned(),
    });
    let ways: Vec<_> = ways.collect();
    if ways.is_empty() { String::new() } else { format!(" fails {}", ways.join(", ")) }
}

pub(super) fn shape(shape: &Shape) -> String {
    let call = |name: &str, numbers: &[Exact]| {
        let numbers: Vec<_> = numbers.iter().map(Exact::to_string).collect();
        format!("{name}({})", numbers.join(", "))
    };
    match shape {
        Shape::Triangle(corners) => call("triangle", corners),
        Shape::Trapezoid(corners) => call("trapezoid", corners),
        Shape::Ramp { zero_at, one_at } => call("ramp", &[*zero_at, *one_at]),
        Shape::Rectangle(ends) => call("rectangle", ends),
        Shape::Singleton(at) => call("singleton", &[*at]),
        Shape::Points(points) => {
            let points: Vec<_> = points.iter().map(|(x, degree)| format!("({x}, {degree})")).collect();
            format!("points({})", points.join(", "))
        }
        Shape::Gaussian(numbers) => call("gaussian", numbers),
        Shape::Gaussian2(numbers) => call("gaussian2", numbers),
        Shape::Bell(numbers) => call("bell", numbers),
        Shape::Sigmoid(numbers) => call("sigmoid", numbers),
        Shape::Rise(ends) => call("s_shape", ends),
        Shape::Fall(ends) => call("z_shape", ends),
        Shape::RiseAndFall(corners) => call("pi_shape", corners),
        Shape::Cosine(numbers) => call("cosine", numbers),
        Shape::Built(parts) => built(parts),
    }
}

/// The last part, with the parts that it is built from in place.
fn built(parts: &[Part]) -> String {
    let mut texts: Vec<String> = Vec::new();
    for part in parts {
        let of = |at: &u32| texts[*at as usize].as_str();
        let joined = |of_these: &[u32], word: &str| {
            format!("({})", of_these.iter().map(of).collect::<Vec<_>>().join(&format!(" {word} ")))
        };
        let text = match part {
            Part::Shape(simple) => shape(simple),
            Part::Not(at) => format!("not {}", of(at)),
            Part::Very(at) => format!("very {}", of(at)),
            Part::Somewhat(at) => format!("somewhat {}", of(at)),
            Part::All(of_these) => joined(of_these, "and"),
            Part::Any(of_these) => joined(of_these, "or"),
        };
        texts.push(text);
    }
    texts.pop().unwrap_or_default()
}

pub(super) fn network(lines: &mut Lines, program: &Program, network: &Network) {
    let inputs = network.inputs.iter();
    let inputs =
        inputs.map(|input| format!("{}: {}", input.symbol.name, program.variables[input.variable].symbol.name));
    let using = if network.outputs.is_empty() { String::new() } else { outputs::using(network.inference) };
    let inputs = inputs.collect::<Vec<_>>().join(", ");
    lines.head(format_args!("network {}({inputs}){using}", network.symbol.name));
    for event in &network.events {
        lines.add(1, format_args!("event {}{}", event.symbol.name, memory(event)));
        for (side, rules) in [("contributor", &event.contributor), ("detractor", &event.detractor)] {
            for rule in rules {
                lines.add(2, format_args!("{side} {}", antecedent(program, network, rule)));
            }
        }
    }
    for output in &network.outputs {
        outputs::output(lines, program, network, output);
    }
}

fn memory(event: &Event) -> String {
    let mut text = String::new();
    if !event.hysteresis.is_zero() {
        text += &format!(" hysteresis {}", event.hysteresis);
    }
    for (word, duration) in [("hold", event.hold), ("confirm", event.confirm)] {
        if duration > 0 {
            text += &format!(" {word} {duration} ns");
        }
    }
    text
}

/// `left is neg and force is any of {low, med}`, as rules in words are written.
fn antecedent(program: &Program, network: &Network, rule: &Rule) -> String {
    let clauses: Vec<_> = rule.clauses.iter().map(|of| clause(program, network, of)).collect();
    if clauses.is_empty() { "always".to_owned() } else { clauses.join(" and ") }
}

/// `left is neg`, `force is any of {low, med}`
pub(super) fn clause(program: &Program, network: &Network, clause: &Clause) -> String {
    let input = &network.inputs[clause.input as usize];
    let terms = &program.variables[input.variable].terms;
    let words = clause.any_of.iter().map(|literal| {
        let name = &terms[literal.term as usize].symbol.name;
        if literal.negated { format!("not {name}") } else { name.clone() }
    });
    let words: Vec<_> = words.collect();
    match words.as_slice() {
        [word] => format!("{} is {word}", input.symbol.name),
        words => format!("{} is any of {{{}}}", input.symbol.name, words.join(", ")),
    }
}
