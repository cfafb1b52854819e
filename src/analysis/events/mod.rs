//! What the events of a network can do: when they are set, what decides it, and what never does.
//!
//! A claim that something never happens holds for all readings of the variables' ranges while all is well.

mod always_set;
mod at_rest;
mod both_sides;
mod comparison;
mod dead_zone;
mod duplicate_rule;
mod idle_detractor;
mod needless_input;
mod never_decisive;
mod never_fires;
mod never_set;
mod no_detractor;
mod noise;
mod redundant;
mod related;
mod subsumed;
mod tie;
mod unused_input;
mod weak_any;

pub(super) use noise::Noise;

use super::network::{EventFacts, FaultSet, Model, NetworkFacts, Question, Reading, RuleFacts, Witness};
use crate::base::{Fraction, Id};
use crate::diag::Diagnostic;
use crate::ir::{Event, Network, Program, Rule, Symbol};

/// While all is well.
const HEALTHY: FaultSet = Vec::new();

/// Events with more rules than this are not asked what costs more than a look at each of their rules.
const MOST_RULES: usize = 1 << 7;

/// An event with what is known of it.
struct Subject<'a> {
    program: &'a Program,
    network: &'a Network,
    model: &'a Model,
    /// Its position in the network.
    index: usize,
    event: &'a Event,
    facts: &'a EventFacts,
    network_facts: &'a NetworkFacts,
    /// Whether what is declared in a place is judged there.
    matters: &'a dyn Fn(&Symbol) -> bool,
}

/// Finds what is wrong, doubtful, or only worth knowing of a network's events.
pub(super) fn check(
    program: &Program,
    network: Id<Network>,
    matters: &dyn Fn(&Symbol) -> bool,
    findings: &mut Vec<Diagnostic>,
) {
    let Some(model) = whole(program, &program.networks[network]).then(|| Model::new(program, network)).flatten() else {
        return;
    };
    let facts = model.facts_under(&HEALTHY);
    let network = &program.networks[network];
    for (index, event) in network.events.iter().enumerate() {
        let (model, own) = (&model, &facts.events[index]);
        let subject = Subject { program, network, model, index, event, facts: own, network_facts: &facts, matters };
        // An event that is always the same hides what else could be said of its rules.
        let is_settled = both_sides::check(&subject, findings)
            || never_set::check(&subject, findings)
            || always_set::check(&subject, findings);
        if !is_settled {
            no_detractor::check(&subject, findings);
        }
        // Of smooth terms only bounds are known; what depends on more than these is left open.
        if !is_settled && !model.is_smooth() {
            let needless_rules = redundant::check(&subject, findings);
            tie::check(&subject, &needless_rules, findings);
            dead_zone::check(&subject, findings);
            let needless = needless_input::check(&subject, findings);
            comparison::check(&subject, &needless, findings);
            weak_any::check(&subject, &needless, findings);
            at_rest::check(&subject, findings);
        }
    }
    related::check(network, &model, &facts, findings);
    unused_input::check(network, findings);
}

/// Whether all of a network and its variables is known.
pub(super) fn whole(program: &Program, network: &Network) -> bool {
    !network.incomplete && network.inputs.iter().all(|input| !program.variables[input.variable].incomplete)
}

impl<'a> Subject<'a> {
    fn name(&self) -> &'a str {
        &self.event.symbol.name
    }

    /// A rule by its number, contributors first.
    fn rule(&self, rule: usize) -> &'a Rule {
        let contributors = &self.event.contributor;
        contributors.get(rule).unwrap_or_else(|| &self.event.detractor[rule - contributors.len()])
    }

    fn rule_facts(&self, rule: usize) -> &'a RuleFacts {
        let contributors = &self.facts.contributor;
        contributors.get(rule).unwrap_or_else(|| &self.facts.detractor[rule - contributors.len()])
    }

    fn contributes(&self, rule: usize) -> bool {
        rule < self.event.contributor.len()
    }

    /// As messages name the side of a rule.
    fn side(&self, rule: usize) -> &'static str {
        if self.contributes(rule) { "contributor" } else { "detractor" }
    }

    /// Whether the flag can stay as it is although the rules call for another.
    fn has_hysteresis(&self) -> bool {
        !self.event.hysteresis.is_zero()
    }

    /// The inputs that its rules name, ascending.
    fn named_inputs(&self) -> Vec<usize> {
        let rules = self.event.contributor.iter().chain(&self.event.detractor);
        let mut inputs: Vec<_> = rules.flat_map(|rule| &rule.clauses).map(|clause| clause.input as usize).collect();
        inputs.sort_unstable();
        inputs.dedup();
        inputs
    }

    fn rule_count(&self) -> usize {
        self.event.contributor.len() + self.event.detractor.len()
    }

    fn is_large(&self) -> bool {
        self.rule_count() > MOST_RULES
    }

    fn has_memory(&self) -> bool {
        self.has_hysteresis() || self.event.hold > 0 || self.event.confirm > 0
    }

    /// Readings as messages name them: "`left` at 0.5 m/s^2, `force` at 115 N".
    fn at(&self, witness: &Witness) -> String {
        let known = witness.readings.iter().enumerate().filter_map(|(input, reading)| Some((input, reading.as_ref()?)));
        let shown: Vec<_> =
            known.map(|(input, reading)| format!("{} at {}", self.input(input), self.show(input, reading))).collect();
        shown.join(", ")
    }

    fn show(&self, input: usize, reading: &Reading) -> String {
        self.program.variables[self.network.inputs[input].variable].unit.show(reading.to_f64())
    }

    fn input(&self, input: usize) -> String {
        format!("`{}`", self.network.inputs[input].symbol.name)
    }

    fn inputs(&self, inputs: &[usize]) -> String {
        listed(inputs.iter().map(|&input| self.input(input)).collect(), "and")
    }

    /// How strong each rule is.
    fn strengths(&self, witness: &Witness) -> Vec<Fraction> {
        self.model.strengths(self.index, &HEALTHY, &self.model.complete(&HEALTHY, witness))
    }

    /// How strong the contributor and the detractor are where the rules are this strong.
    fn sides(&self, strengths: &[Fraction]) -> (Fraction, Fraction) {
        let (contributors, detractors) = strengths.split_at(self.event.contributor.len());
        let strongest = |rules: &[Fraction]| rules.iter().max().cloned().unwrap_or(Fraction::ZERO);
        (strongest(contributors), strongest(detractors))
    }

    /// Adds why something never happens: the rules and inputs that suffice to see it, and the degrees at which it was
    /// looked.
    fn with_proof(&self, diagnostic: Diagnostic, question: Question, excluded: &str) -> Diagnostic {
        let Some(proof) = self.model.proof(self.index, &HEALTHY, question) else { return diagnostic };
        let rules = match proof.rules.len() {
            0 => "no rule".to_owned(),
            1 => "the rule marked here".to_owned(),
            count @ 2..=3 => format!("the {count} rules marked here"),
            count => format!("{count} rules, of which three are marked here"),
        };
        let enough = match proof.inputs.as_slice() {
            [] => format!("{rules} suffice to see it, whatever is read"),
            [input] => format!("{rules} and the input {} suffice to see it", self.input(*input)),
            inputs => format!("{rules} and the inputs {} suffice to see it", self.inputs(inputs)),
        };
        let (count, levels) = (proof.levels.len(), proof.levels.iter().map(degree));
        let shown: Vec<_> = levels.step_by(count.div_ceil(4).max(1)).collect();
        let marked = proof.rules.iter().take(3).fold(diagnostic, |diagnostic, &rule| {
            let fires = self.rule_facts(rule).fires.is_possible();
            let does = match (fires, self.contributes(rule)) {
                (false, _) => "never fires",
                (true, true) => "speaks for it",
                (true, false) => "speaks against it",
            };
            diagnostic.label(self.rule(rule).span, does)
        });
        marked.note(format!(
            "proof: no degree from 0 to 1 is {excluded} ({count} stand for all, such as {}); {enough}",
            listed(shown, "and")
        ))
    }
}

/// Words one after another: "a, b and c".
pub(super) fn listed(mut words: Vec<String>, joined: &str) -> String {
    match words.pop() {
        Some(last) if words.is_empty() => last,
        Some(last) => format!("{} {joined} {last}", words.join(", ")),
        None => String::new(),
    }
}

/// A degree of membership as messages show it.
fn degree(degree: &Fraction) -> String {
    format!("{}", (degree.to_f64() * 1000.0).round() / 1000.0)
}
