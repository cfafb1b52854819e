//! A network of clipped sets in `fuzzy-logic_rs`, which defuzzifies by sampling.
#![expect(clippy::panic, clippy::cast_possible_wrap, reason = "for one network, whose sets are few and plain")]

use fuzzy_logic_rs::aggregations::Aggregations;
use fuzzy_logic_rs::defuzzifications::Defuzzifiers;
use fuzzy_logic_rs::fuzzy_inference_systems::MamdaniFIS;
use fuzzy_logic_rs::implications::Implications;
use fuzzy_logic_rs::membership_functions::{MF, MFKind, Trapezoid, Triangle};
use fuzzy_logic_rs::membership_ranges::MembershipRange;
use fuzzy_logic_rs::rules::Rule;
use fuzzy_logic_rs::s_norms::SNorms;
use fuzzy_logic_rs::t_norms::TNorms;
use fuzzy_logic_rs::variables::{InputVariable, OutputVariable};
use lmslc::base::Exact;
use lmslc::ir::{Consequent, Network, Program, Shape};
use lmslc::kernel;

/// How many samples of an output are taken, as its examples do.
const SAMPLES: i32 = 100;

/// Builds the network there. A rule names a term of every input and every output: one more term of each input is 1
/// everywhere, and one more of each output is 0.
pub fn network(program: &Program, network: &Network) -> MamdaniFIS {
    let mut system =
        MamdaniFIS::new(SNorms::Max, TNorms::Min, Implications::Min, Aggregations::Max, Defuzzifiers::Centroid);
    let numbers = |range: (Exact, Exact)| (range.0.to_f64(), range.1.to_f64());
    let mut any = Vec::new();
    for input in &network.inputs {
        let variable = &program.variables[input.variable];
        let (low, high) = numbers(variable.range);
        let mut made = InputVariable::new(input.symbol.name.clone(), (low, high));
        for term in &variable.terms {
            let kind = match term.shape {
                Shape::Triangle(corners) => {
                    let [a, b, c] = corners.map(Exact::to_f64);
                    MFKind::Triangle(Triangle::new(a, b, c))
                }
                Shape::Trapezoid(corners) => {
                    let [a, b, c, d] = corners.map(Exact::to_f64);
                    MFKind::Trapezoid(Trapezoid::new(a, b, c, d))
                }
                Shape::Ramp { zero_at, one_at } => {
                    let (zero_at, one_at) = (zero_at.to_f64(), one_at.to_f64());
                    let (from, to) = (low - 2.0, high + 2.0);
                    let rises = zero_at < one_at;
                    let rising = || Trapezoid::new(zero_at, one_at, to, to);
                    MFKind::Trapezoid(if rises { rising() } else { Trapezoid::new(from, from, one_at, zero_at) })
                }
                ref other => panic!("{other:?} is not asked for"),
            };
            made.add_membership(MF::new(term.symbol.name.clone(), kind));
        }
        any.push(variable.terms.len() as i32);
        let everywhere = Trapezoid::new(low - 2.0, low - 1.0, high + 1.0, high + 2.0);
        made.add_membership(MF::new("any".to_owned(), MFKind::Trapezoid(everywhere)));
        system.add_input(made);
    }
    for output in &network.outputs {
        let mut made = OutputVariable::new(output.symbol.name.clone(), numbers(output.range.unwrap()), SAMPLES);
        let universe = made.get_universe().clone();
        for term in &output.terms {
            let Shape::Triangle(corners) = term.shape else { panic!("{:?} is not asked for", term.shape) };
            let [a, b, c] = corners.map(Exact::to_f64);
            let degrees = universe.iter().map(|x| kernel::triangle(*x, a, b, c)).collect();
            made.add_membership(MembershipRange::new(term.symbol.name.clone(), degrees));
        }
        made.add_membership(MembershipRange::new("none".to_owned(), vec![0.0; universe.len()]));
        system.add_output(made);
    }
    let none: Vec<_> = network.outputs.iter().map(|output| output.terms.len() as i32).collect();
    for (position, output) in network.outputs.iter().enumerate() {
        for rule in &output.rules {
            let Consequent::Term(term) = rule.consequent else { panic!("only terms are asked for") };
            for case in &rule.cases {
                let (mut inputs, mut outputs) = (any.clone(), none.clone());
                for clause in &case.clauses {
                    inputs[clause.input as usize] = clause.any_of[0].term as i32;
                }
                outputs[position] = term as i32;
                system.add_rule(Rule::new_and([inputs, outputs].concat(), 1.0));
            }
        }
    }
    system
}
