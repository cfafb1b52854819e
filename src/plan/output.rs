//! Continuous outputs as steps.

use std::ops::Range;

use super::builder::{Builder, Key, list};
use super::slabs::{Domain, clipped, scaled};
use super::{Bool, Find, Output, Real, Step, Stretch, origin};
use crate::base::{Exact, Id};
use crate::ir::{self, Aggregation, Consequent, Defuzzifier, Implication, Inference, SNorm, Statement, TNorm};
use crate::membership::{Curve, Membership, function, in_units, middle_of_largest, overlaps};

/// An output of the plan being built: its value, whether a rule fired, and the strengths of its rules and of its sets.
struct OutputSlots {
    value: Real,
    fired: Bool,
    strengths: Vec<Real>,
    sets: Vec<(String, Real)>,
}

/// Sets of an output, each with a strength.
struct Activated<'a> {
    sets: Vec<&'a ir::Term>,
    strengths: Vec<Real>,
    range: (Exact, Exact),
    inference: Inference,
}

impl Builder<'_> {
    /// The outputs of a network whose inputs have been read.
    pub(super) fn outputs(&mut self, network: Id<ir::Network>, readings: &[Real]) -> Vec<Output> {
        let network = &self.program.networks[network];
        let outputs = network.outputs.iter().map(|output| {
            let OutputSlots { value, fired, strengths, sets } = self.output(output, network, readings);
            let (name, origin) = (output.symbol.name.clone(), origin(&output.symbol));
            let rules = output.rules.iter().map(|rule| rule.span).collect();
            Output { name, origin, unit: output.unit.clone(), value, fired, strengths, sets, rules }
        });
        outputs.collect()
    }

    fn output(&mut self, output: &ir::Output, network: &ir::Network, readings: &[Real]) -> OutputSlots {
        let strengths: Vec<Real> =
            output.rules.iter().map(|rule| self.rule_strength(rule, network, readings)).collect();
        let strongest = self.maximum(&strengths);
        let fired = self.bool(Key::Fires(strongest), |_, to| Step::Fires { of: strongest, to });
        let mut sets = Vec::new();
        let value = match output.range {
            Some(range) if !output.terms.is_empty() => {
                let activated = self.activated(output, range, network.inference, &strengths);
                let names = activated.sets.iter().map(|set| set.symbol.name.clone());
                sets = names.zip(activated.strengths.iter().copied()).collect();
                self.defuzzified(&activated)
            }
            _ => {
                let values = output.rules.iter().filter_map(|rule| match &rule.consequent {
                    Consequent::Linear(linear) => Some(self.linear(linear, readings)),
                    Consequent::Term(_) => None,
                });
                let values: Vec<_> = values.collect();
                self.mean(&strengths, &values)
            }
        };
        let range = output.range.map(|(low, high)| (low.to_f64(), high.to_f64()));
        let value = range.map_or(value, |(low, high)| self.step(|to| Step::Limit { of: value, low, high, to }));
        // Without a default it is proved that some rule fires; the number nearest to 0 is as good as any.
        let nearest = range.map_or(0.0, |(low, high)| 0.0_f64.clamp(low, high));
        let value = match output.default {
            Some(ir::Rest::Last) => {
                self.code.kept.push(nearest);
                let kept = self.code.kept.len() as u32 - 1;
                self.step(|to| Step::Keep { fired, of: value, kept, to })
            }
            Some(ir::Rest::Value(otherwise)) => {
                let otherwise = otherwise.to_f64();
                self.step(|to| Step::Otherwise { fired, of: value, otherwise, to })
            }
            None => self.step(|to| Step::Otherwise { fired, of: value, otherwise: nearest, to }),
        };
        OutputSlots { value, fired, strengths, sets }
    }

    /// A step whose value nothing else shares.
    fn step(&mut self, step: impl FnOnce(Real) -> Step) -> Real {
        let to = self.new_real();
        self.code.steps.push(step(to));
        to
    }

    fn rule_strength(&mut self, rule: &ir::OutputRule, network: &ir::Network, readings: &[Real]) -> Real {
        let Inference { and, or, .. } = network.inference;
        let mut parts: Vec<Real> = Vec::with_capacity(rule.antecedent.len());
        for statement in &rule.antecedent {
            let some = |of: &[u32]| of.iter().map(|&of| parts[of as usize]).collect::<Vec<_>>();
            let part = match statement {
                Statement::Is(clause) => self.clause(clause, &network.inputs, readings),
                Statement::Not(of) => self.complement(parts[*of as usize]),
                Statement::All(of) if and == TNorm::Minimum => self.minimum(&some(of)),
                Statement::Any(of) if or == SNorm::Maximum => self.maximum(&some(of)),
                Statement::All(of) => self.chained(&some(of), |builder, left, right| {
                    let step = |_: &mut _, to| Step::TNorm { norm: and, left, right, to };
                    builder.real(Key::TNorm(and, left, right), step)
                }),
                Statement::Any(of) => self.chained(&some(of), |builder, left, right| {
                    let step = |_: &mut _, to| Step::SNorm { norm: or, left, right, to };
                    builder.real(Key::SNorm(or, left, right), step)
                }),
            };
            parts.push(part);
        }
        let of = parts.last().copied().unwrap_or_else(|| self.constant(0.0));
        if rule.weight == Exact::ONE {
            return of;
        }
        let weight = rule.weight.to_f64();
        self.real(Key::Weigh(of, weight.to_bits()), |_, to| Step::Weigh { of, weight, to })
    }

    fn chained(&mut self, of: &[Real], mut join: impl FnMut(&mut Self, Real, Real) -> Real) -> Real {
        let joined = of.iter().copied().reduce(|left, right| join(self, left, right));
        joined.unwrap_or_else(|| self.constant(0.0))
    }

    fn linear(&mut self, linear: &ir::Linear, readings: &[Real]) -> Real {
        let factors = linear.factors.iter().map(|(input, factor)| (readings[*input as usize], factor.to_f64()));
        let start = self.code.factors.len() as u32;
        self.code.factors.extend(factors);
        let (constant, factors) = (linear.constant.to_f64(), start..self.code.factors.len() as u32);
        self.step(|to| Step::Linear { constant, factors, to })
    }

    fn mean(&mut self, weights: &[Real], values: &[Real]) -> Real {
        let (weights, values) = (self.list(weights), self.list(values));
        self.step(|to| Step::Mean { weights, values, to })
    }

    fn list(&mut self, of: &[Real]) -> Range<u32> {
        list(&mut self.code.real_lists, of)
    }

    /// Where the largest degree counts, the strongest rule of each set; where degrees are added, every rule.
    fn activated<'a>(
        &mut self,
        output: &'a ir::Output,
        range: (Exact, Exact),
        inference: Inference,
        strengths: &[Real],
    ) -> Activated<'a> {
        let named = output.rules.iter().map(|rule| match rule.consequent {
            Consequent::Term(term) => Some(term as usize),
            Consequent::Linear(_) => None,
        });
        let named: Vec<(usize, Real)> = named.zip(strengths).filter_map(|(term, &real)| Some((term?, real))).collect();
        let (sets, strengths) = match inference.aggregation {
            Aggregation::Sum => named.iter().map(|&(term, real)| (&output.terms[term], real)).unzip(),
            Aggregation::Maximum => {
                let of_term = |term: usize| named.iter().filter(move |(of, _)| *of == term).map(|(_, real)| *real);
                let terms = output.terms.iter().enumerate();
                let terms = terms.map(|(position, term)| (term, of_term(position).collect::<Vec<_>>()));
                terms.filter(|(_, of)| !of.is_empty()).map(|(term, of)| (term, self.maximum(&of))).unzip()
            }
        };
        Activated { sets, strengths, range, inference }
    }

    fn defuzzified(&mut self, activated: &Activated<'_>) -> Real {
        let Inference { implication, aggregation, .. } = activated.inference;
        let find = match (activated.inference.defuzzifier, implication, aggregation) {
            (Defuzzifier::Centroid, Implication::Product, Aggregation::Maximum) => Find::Centroid,
            (Defuzzifier::Centroid, ..) => return self.centroid(activated),
            (Defuzzifier::Midpoints(parts), ..) => return self.midpoints(activated, parts),
            (Defuzzifier::WeightedAverage, ..) => return self.weighted_average(activated),
            (Defuzzifier::Bisector, ..) => Find::Bisector,
            (Defuzzifier::SmallestOfMaximum, ..) => Find::SmallestOfMaximum,
            (Defuzzifier::LargestOfMaximum, ..) => Find::LargestOfMaximum,
            (Defuzzifier::MeanOfMaximum, ..) => Find::MeanOfMaximum,
        };
        let stretches = self.stretches(activated);
        let strengths = self.list(&activated.strengths);
        self.step(|to| Step::Outline { find, implication, aggregation, stretches, strengths, to })
    }

    /// By inclusion and exclusion: the largest of some degrees is the sum over the choices of some of them of the
    /// smallest, with the sign of an odd number of them; and where clipped sets overlap, their smallest degree is the
    /// set of the smallest degrees, clipped at the smallest strength.
    fn centroid(&mut self, activated: &Activated<'_>) -> Real {
        let (curves, domain) = activated.curves();
        let mut slabs = Vec::new();
        match (activated.inference.implication, activated.inference.aggregation) {
            (Implication::Product, _) => {
                let sets = curves.iter().zip(&activated.strengths);
                slabs.extend(sets.map(|(set, &strength)| scaled(set, &domain, strength)));
            }
            (Implication::Minimum, Aggregation::Sum) => {
                let sets = curves.iter().zip(&activated.strengths);
                slabs.extend(sets.flat_map(|(set, &strength)| clipped(set, &domain, strength, 1)));
            }
            (Implication::Minimum, Aggregation::Maximum) => {
                for (chosen, set) in overlaps(&curves, &domain.range, usize::MAX).unwrap_or_default() {
                    let strengths: Vec<_> = chosen.iter().map(|&set| activated.strengths[set]).collect();
                    let strength = self.minimum(&strengths);
                    slabs.extend(clipped(&set, &domain, strength, if chosen.len() % 2 == 1 { 1 } else { -1 }));
                }
            }
        }
        let start = self.code.slabs.len() as u32;
        self.code.slabs.extend(slabs);
        let slabs = start..self.code.slabs.len() as u32;
        let center = domain.middle.to_f64_times_pi(domain.pi);
        self.step(|to| Step::Centroid { slabs, center, to })
    }

    fn stretches(&mut self, activated: &Activated<'_>) -> Range<u32> {
        let (curves, domain) = activated.curves();
        let (low, high) = &domain.range;
        let bends = curves.iter().flat_map(Curve::bends).filter(|at| low < *at && *at < high);
        let mut places: Vec<_> = bends.chain([low, high]).collect();
        places.sort_unstable();
        places.dedup();
        let start = self.code.stretches.len() as u32;
        for ends in places.windows(2) {
            let [from, to] = [ends[0], ends[1]];
            let first = self.code.points.len() as u32;
            let line = |curve: &Curve| (curve.around(from).after.to_f64(), curve.around(to).before.to_f64());
            self.code.points.extend(curves.iter().map(line));
            let lines = first..self.code.points.len() as u32;
            let [from, to] = [from, to].map(|at| at.to_f64_times_pi(domain.pi));
            self.code.stretches.push(Stretch { from, to, lines });
        }
        start..self.code.stretches.len() as u32
    }

    fn midpoints(&mut self, activated: &Activated<'_>, parts: u32) -> Real {
        let (low, high) = (activated.range.0.to_f64(), activated.range.1.to_f64());
        let functions: Vec<_> = activated.sets.iter().map(|set| function(&set.shape)).collect();
        let start = self.code.samples.len() as u32;
        for part in 0..parts {
            let x = low + (f64::from(part) + 0.5) * ((high - low) / f64::from(parts));
            self.code.samples.extend(functions.iter().map(|function| function(x)));
        }
        let samples = start..self.code.samples.len() as u32;
        let strengths = self.list(&activated.strengths);
        let Inference { implication, aggregation, .. } = activated.inference;
        self.step(|to| Step::Midpoints { implication, aggregation, samples, strengths, low, high, to })
    }

    fn weighted_average(&mut self, activated: &Activated<'_>) -> Real {
        let largest = activated.sets.iter().map(|set| middle_of_largest(&set.shape, activated.range).unwrap_or(0.0));
        let values: Vec<_> =
            largest.map(|constant| self.step(|to| Step::Linear { constant, factors: 0..0, to })).collect();
        self.mean(&activated.strengths, &values)
    }
}

impl Activated<'_> {
    fn curves(&self) -> (Vec<Curve>, Domain) {
        let (pi, range) = in_units(self.range);
        let curves = self.sets.iter().map(|set| Membership::new(&set.shape, pi).low).collect();
        let middle = range.0.halfway(&range.1);
        (curves, Domain { range, middle, pi })
    }
}
