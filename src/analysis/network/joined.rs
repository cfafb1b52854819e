//! Events of several networks over the sensors they share, as one model.

use std::collections::BTreeMap;

use super::Valuation;
use super::columns::Columns;
use super::joint;
use super::model::{EventModel, Input, Model, Rules};
use super::sensor::Sensor;
use crate::analysis::breakpoints::in_order;
use crate::analysis::support::Interval;
use crate::base::Id;
use crate::ir::{self, Literal, Program, Rule};

/// An event, and the sensors that feed the inputs of its network.
pub(in crate::analysis) struct Fed<'a> {
    pub(in crate::analysis) network: &'a ir::Network,
    pub(in crate::analysis) event: u32,
    pub(in crate::analysis) sensors: &'a [Id<ir::Sensor>],
}

/// What each sensor can read; `None` for one without any degree of membership.
pub(in crate::analysis) type Feeds = [(Id<ir::Sensor>, Option<Interval>)];

/// A literal, and the variable whose term it names.
type Named = (Id<ir::Variable>, Literal);
/// A rule: for each clause the position of a sensor, and what is named of it.
type Clauses = Vec<(usize, Vec<Named>)>;

/// Which statuses events can have together, sorted, with readings by the position of each sensor. `None` where there
/// are more than `most`, or where a variable is broken, which is reported elsewhere.
pub(in crate::analysis) fn valuations(
    program: &Program,
    events: &[Fed<'_>],
    feeds: &Feeds,
    most: usize,
) -> Option<Vec<Valuation>> {
    let model = Model::joined(program, events, feeds)?;
    joint::all_valuations(&model, &vec![0; feeds.len()], most)
}

impl Model {
    pub(super) fn joined(program: &Program, events: &[Fed<'_>], feeds: &Feeds) -> Option<Self> {
        let positions: BTreeMap<_, _> =
            feeds.iter().zip(0..).map(|((sensor, _), position)| (*sensor, position)).collect();
        let mut literals: Vec<Vec<Named>> = vec![Vec::new(); feeds.len()];
        let mut rules: Vec<Vec<Clauses>> = Vec::with_capacity(events.len());
        for fed in events {
            let clause = |clause: &ir::Clause| {
                let input = clause.input as usize;
                let variable = fed.network.inputs[input].variable;
                let any_of = clause.any_of.iter().map(|literal| (variable, *literal)).collect();
                Some((*positions.get(fed.sensors.get(input)?)?, any_of))
            };
            let rule = |rule: &Rule| rule.clauses.iter().map(clause).collect::<Option<Vec<_>>>();
            let event = &fed.network.events[fed.event as usize];
            let all = event.contributor.iter().chain(&event.detractor);
            rules.push(all.map(rule).collect::<Option<_>>()?);
        }
        for (position, any_of) in rules.iter().flatten().flatten() {
            literals[*position].extend(any_of);
        }
        for named in &mut literals {
            named.sort_unstable();
            named.dedup();
        }
        let inputs = literals.iter().zip(feeds).map(|(named, feed)| Input::fed(program, named, feed));
        let inputs: Vec<_> = inputs.collect::<Option<_>>()?;
        let events = events.iter().zip(rules).map(|(fed, rules)| {
            let place = |(input, any_of): (usize, Vec<Named>)| {
                let known = &literals[input];
                (input, any_of.iter().filter_map(|literal| known.binary_search(literal).ok()).collect())
            };
            let rules = rules.into_iter().map(|rule| rule.into_iter().map(place).collect()).collect();
            Rules { rules, contributors: fed.network.events[fed.event as usize].contributor.len() }
        });
        let events: Vec<_> = events.collect();
        Some(Self::of_rules(inputs, &events, EventModel::without_slices))
    }
}

impl Input {
    fn fed(
        program: &Program,
        named: &[Named],
        (sensor, readings): &(Id<ir::Sensor>, Option<Interval>),
    ) -> Option<Self> {
        let (low, high) = program.sensors[*sensor].range;
        let pi = if low.is_zero() { high.pi_power() } else { low.pi_power() };
        let literal = |&(variable, literal): &Named| (&program.variables[variable], literal);
        let is_sound = |(variable, literal): (&ir::Variable, Literal)| {
            variable.terms.get(literal.term as usize).is_some_and(|term| in_order(&term.shape))
        };
        if !named.iter().map(literal).all(is_sound) {
            return None;
        }
        let columns = Columns::new(named.iter().map(literal), pi)?;
        let sensor = match readings {
            Some(interval) => Sensor::between(&columns, interval, pi)?,
            None => Sensor::absent(&columns),
        };
        Some(Self { pi, columns, fails: Vec::new(), sensors: vec![sensor] })
    }
}
