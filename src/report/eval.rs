//! One evaluation of a network as JSON.

use serde::{Serialize, Serializer};

use super::json::{SCHEMA, to_line};
use crate::interp::{Evaluator, Reading};
use crate::plan::{Event, NetworkPlan};

/// A network and what it made of its last readings.
#[derive(Debug, Clone, Copy)]
pub struct Evaluated<'a> {
    /// The network.
    pub plan: &'a NetworkPlan,
    /// Its evaluator, after an evaluation.
    pub evaluator: &'a Evaluator<'a>,
    /// What was evaluated, in SI, in the order of the network's inputs.
    pub readings: &'a [Reading],
}

impl Evaluated<'_> {
    /// What was read for an input; a missing reading counts as failed.
    pub(super) fn reading(&self, input: usize) -> Reading {
        self.readings.get(input).copied().unwrap_or(Reading { value: f64::NAN, healthy: false })
    }

    pub(super) fn contributor(&self, event: &Event) -> f64 {
        self.evaluator.real(event.contributor)
    }

    pub(super) fn detractor(&self, event: &Event) -> f64 {
        self.evaluator.real(event.detractor)
    }
}

/// An object whose members stand in the order in which the network declares them.
struct Members<'a, T>(Vec<(&'a str, T)>);

impl<T: Serialize> Serialize for Members<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

#[derive(Serialize)]
struct Evaluation<'a> {
    schema: u32,
    inputs: Members<'a, Option<f64>>,
    degrees: Members<'a, Members<'a, f64>>,
    events: Members<'a, Decided>,
    outputs: Members<'a, Computed>,
}

#[derive(Serialize)]
struct Decided {
    contributor: f64,
    detractor: f64,
    flag: bool,
}

#[derive(Serialize)]
struct Computed {
    value: f64,
    fired: bool,
}

/// Renders an evaluation as one JSON object on one line. Inputs are as they were read, in SI, and null where the
/// sensor had failed or the number was not finite; degrees of membership and strengths are from 0 to 1; outputs are in
/// SI, and `fired` says whether a rule set them.
pub fn eval_json(evaluated: &Evaluated<'_>) -> String {
    let Evaluated { plan, evaluator, .. } = evaluated;
    let inputs = plan.inputs.iter().enumerate().map(|(index, input)| {
        let reading = evaluated.reading(index);
        (input.name.as_str(), (reading.healthy && reading.value.is_finite()).then_some(reading.value))
    });
    let degrees = plan.inputs.iter().zip(&plan.degrees).map(|(input, terms)| {
        let terms = terms.iter().map(|(term, degree)| (term.as_str(), evaluator.real(*degree)));
        (input.name.as_str(), Members(terms.collect()))
    });
    let events = plan.events.iter().map(|event| {
        let (contributor, detractor) = (evaluated.contributor(event), evaluated.detractor(event));
        (event.name.as_str(), Decided { contributor, detractor, flag: evaluator.bool(event.flag) })
    });
    let outputs = plan.outputs.iter().map(|output| {
        let computed = Computed { value: evaluator.real(output.value), fired: evaluator.bool(output.fired) };
        (output.name.as_str(), computed)
    });
    to_line(&Evaluation {
        schema: SCHEMA,
        inputs: Members(inputs.collect()),
        degrees: Members(degrees.collect()),
        events: Members(events.collect()),
        outputs: Members(outputs.collect()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::samples;

    #[test]
    fn an_evaluation_is_one_object() {
        let plan = samples::network();
        let mut evaluator = Evaluator::new(&plan);
        let readings = [-0.75, 118.0].map(|value| Reading { value, healthy: true });
        evaluator.evaluate(&readings, 0);
        let evaluated = Evaluated { plan: &plan, evaluator: &evaluator, readings: &readings };
        insta::assert_snapshot!(eval_json(&evaluated), @r#"{"schema":1,"inputs":{"left":-0.75,"force":118.0},"degrees":{"left":{"neg":0.75,"zero":0.25},"force":{"low":0.41,"high":0.59}},"events":{"forward_collision":{"contributor":0.59,"detractor":0.25,"flag":true}},"outputs":{}}"#);
    }

    #[test]
    fn a_failed_sensor_reads_null() {
        let plan = samples::network();
        let mut evaluator = Evaluator::new(&plan);
        let readings = [Reading { value: -1.0, healthy: false }];
        evaluator.evaluate(&readings, 0);
        let evaluated = Evaluated { plan: &plan, evaluator: &evaluator, readings: &readings };
        let value: serde_json::Value = serde_json::from_str(&eval_json(&evaluated)).unwrap();
        assert!(value["inputs"]["left"].is_null() && value["inputs"]["force"].is_null());
        assert_eq!(value["degrees"]["left"]["zero"], 1.0);
    }
}
