//! A network made ready for questions: its inputs in every state, its events as rules over choices of literals.

use super::columns::Columns;
use super::faults::{FaultSet, fault_sets};
use super::implication::implications;
use super::sensor::Sensor;
use super::slices::{Pattern, Slices};
use crate::analysis::breakpoints;
use crate::base::{Exact, Fraction, Id};
use crate::ir::{self, FailReading, Literal, Program, Rule};
use crate::membership::in_units;

/// What feeds an input of a network.
#[derive(Debug, Clone)]
pub struct Feed {
    /// The readings it can give, in SI: lower end, upper end.
    pub range: (Exact, Exact),
    /// How it can fail.
    pub fails: Vec<FailReading>,
}

impl Feed {
    /// What feeds each input of a network on its own.
    pub fn of_variables(program: &Program, network: &ir::Network) -> Vec<Self> {
        let of_variable = |input: &ir::NetworkInput| {
            let variable = &program.variables[input.variable];
            Self { range: variable.range, fails: variable.fails.clone() }
        };
        network.inputs.iter().map(of_variable).collect()
    }
}

/// A network with what feeds it, ready to be asked.
#[derive(Debug, Clone)]
pub struct Model {
    pub(super) inputs: Vec<Input>,
    /// With every contributor rule as weak, and every detractor rule as strong as what is known of its terms allows.
    pub(super) events: Vec<EventModel>,
    /// The other way round, where some term is smooth and only known within bounds.
    pub(super) loose: Option<Vec<EventModel>>,
    /// Pairs of events of which the first implies the second by the form of their rules.
    pub(super) implications: Vec<(usize, usize)>,
}

/// An input of a network.
#[derive(Debug, Clone)]
pub(super) struct Input {
    /// Readings are in units of this power of π.
    pub(super) pi: i8,
    /// The degrees of what the rules name.
    pub(super) columns: Columns,
    pub(super) fails: Vec<FailReading>,
    /// Healthy, then failed in each way.
    pub(super) sensors: Vec<Sensor>,
}

/// An event of a network. Its rules are counted through, contributors first.
#[derive(Debug, Clone)]
pub(super) struct EventModel {
    /// How many rules speak for it.
    pub(super) contributors: usize,
    /// How many rules it has.
    pub(super) rules: usize,
    /// The rules that name nothing; their strength is 1.
    pub(super) unconditional: Vec<usize>,
    /// The inputs it names, in order.
    pub(super) uses: Vec<Use>,
}

/// What an event names of one input.
#[derive(Debug, Clone)]
pub(super) struct Use {
    /// The position of the input in its network.
    pub(super) input: usize,
    /// The choices of literals that its rules name.
    pub(super) choices: Vec<Choice>,
    /// The patterns of the choices, by the state of the input.
    pub(super) slices: Vec<Slices>,
}

/// Literals of one input of which the largest degree counts.
#[derive(Debug, Clone)]
pub(super) struct Choice {
    /// Positions in the input's columns.
    pub(super) literals: Vec<usize>,
    /// The rules that name exactly these.
    pub(super) rules: Vec<usize>,
}

/// An input and the columns of it of which the largest degree counts.
pub(super) type Clause = (usize, Vec<usize>);

/// Rules by what they name: an input, and positions among what its columns stand for. So many contribute.
pub(super) struct Rules {
    pub(super) rules: Vec<Vec<Clause>>,
    pub(super) contributors: usize,
}

impl Model {
    /// A network on its own: its variables say what feeds it. `None` where a variable is broken, which is reported
    /// elsewhere.
    pub fn new(program: &Program, network: Id<ir::Network>) -> Option<Self> {
        let network = &program.networks[network];
        Self::fed_by(program, network, &Feed::of_variables(program, network))
    }

    /// A network whose inputs are fed by sensors with ranges and failures of their own.
    pub fn fed_by(program: &Program, network: &ir::Network, feeds: &[Feed]) -> Option<Self> {
        let rules: Vec<&Rule> =
            network.events.iter().flat_map(|event| event.contributor.iter().chain(&event.detractor)).collect();
        let clauses = rules.iter().flat_map(|rule| &rule.clauses);
        let mut named: Vec<Vec<Literal>> = vec![Vec::new(); network.inputs.len()];
        clauses.for_each(|clause| named[clause.input as usize].extend(&clause.any_of));
        for literals in &mut named {
            literals.sort_unstable();
            literals.dedup();
        }
        let inputs = network.inputs.iter().zip(feeds).zip(&named);
        let inputs =
            inputs.map(|((input, feed), literals)| Input::new(&program.variables[input.variable], literals, feed));
        let inputs: Vec<Input> = inputs.collect::<Option<_>>()?;
        let clause = |clause: &ir::Clause| {
            let input = clause.input as usize;
            let known = &named[input];
            (input, clause.any_of.iter().filter_map(|literal| known.binary_search(literal).ok()).collect())
        };
        let event = |event: &ir::Event| {
            let rules = event.contributor.iter().chain(&event.detractor);
            let rules = rules.map(|rule| rule.clauses.iter().map(clause).collect()).collect();
            Rules { rules, contributors: event.contributor.len() }
        };
        let events: Vec<_> = network.events.iter().map(event).collect();
        Some(Self::of_rules(inputs, &events, EventModel::of_clauses))
    }

    /// Events with these rules, each made of clauses over columns.
    pub(super) fn of_rules(
        inputs: Vec<Input>,
        rules: &[Rules],
        event_of: fn(Vec<Vec<Clause>>, usize, &[Input]) -> EventModel,
    ) -> Self {
        let events = |is_loose: bool| -> Vec<_> {
            let event = |of: &Rules| {
                let columns = |(number, rule): (usize, &Vec<Clause>)| {
                    let is_high = (number < of.contributors) == is_loose;
                    let columns = |(input, named): &Clause| {
                        let bounds = |named: &usize| inputs[*input].columns.bounds[*named];
                        let column = |named| if is_high { bounds(named).1 } else { bounds(named).0 };
                        (*input, named.iter().map(column).collect())
                    };
                    rule.iter().map(columns).collect()
                };
                let rules = of.rules.iter().enumerate().map(columns).collect();
                event_of(rules, of.contributors, &inputs)
            };
            rules.iter().map(event).collect()
        };
        let loose = inputs.iter().any(|input| input.columns.is_smooth()).then(|| events(true));
        let events = events(false);
        Self::of_events(inputs, events, loose)
    }

    pub(super) fn of_events(inputs: Vec<Input>, events: Vec<EventModel>, loose: Option<Vec<EventModel>>) -> Self {
        let implications = implications(&events);
        Self { inputs, events, loose, implications }
    }

    /// An event with every contributor rule as strong, and every detractor rule as weak as can be.
    pub(super) fn loose(&self, event: usize) -> &EventModel {
        &self.loose.as_ref().unwrap_or(&self.events)[event]
    }

    /// Whether some degrees are only known within bounds.
    pub fn is_smooth(&self) -> bool {
        self.loose.is_some()
    }

    /// Every set of at most `up_to` failures, smallest first.
    pub fn fault_sets(&self, up_to: usize) -> Vec<FaultSet> {
        fault_sets(self.inputs.iter().map(|input| input.fails.as_slice()), up_to)
    }

    /// The state of every input under some failures. An unknown constant can be what a healthy sensor can be.
    pub(super) fn states(&self, faults: &FaultSet) -> Vec<usize> {
        let mut states = vec![0; self.inputs.len()];
        for fault in faults {
            let declared = self.inputs.get(fault.input).and_then(|input| {
                input.fails.iter().position(|fail| *fail == fault.reading && *fail != FailReading::Any)
            });
            if let (Some(state), Some(position)) = (states.get_mut(fault.input), declared) {
                *state = position + 1;
            }
        }
        states
    }
}

impl Input {
    fn new(variable: &ir::Variable, literals: &[Literal], feed: &Feed) -> Option<Self> {
        let (low, high) = feed.range;
        if low > high || !variable.terms.iter().all(|term| breakpoints::in_order(&term.shape)) {
            return None;
        }
        let (pi, range) = in_units(feed.range);
        let columns = Columns::new(literals.iter().map(|literal| (variable, *literal)), pi)?;
        let failed = feed.fails.iter().map(|&fail| Sensor::failed(&columns, &range, fail, pi));
        let sensors = std::iter::once(Sensor::healthy(&columns, &range)).chain(failed).collect();
        Some(Self { pi, columns, fails: feed.fails.clone(), sensors })
    }
}

impl Use {
    /// The patterns at a level in some states of the inputs.
    pub(super) fn patterns(&self, states: &[usize], level: &Level) -> &[Pattern] {
        self.slices[states[self.input]].at(&level.height, level.is_gap)
    }
}

impl EventModel {
    /// An event with these rules, of which so many contribute, each the smallest of its clauses.
    pub(super) fn of_clauses(rules: Vec<Vec<Clause>>, contributors: usize, inputs: &[Input]) -> Self {
        let mut event = Self::without_slices(rules, contributors, inputs);
        for named in &mut event.uses {
            let choices: Vec<_> = named.choices.iter().map(|choice| choice.literals.as_slice()).collect();
            named.slices = inputs[named.input].sensors.iter().map(|sensor| Slices::new(sensor, &choices)).collect();
        }
        event
    }

    /// The same for questions about several events together, which look at no single level.
    pub(super) fn without_slices(rules: Vec<Vec<Clause>>, contributors: usize, _: &[Input]) -> Self {
        let count = rules.len();
        let mut uses: Vec<Use> = Vec::new();
        let mut unconditional = Vec::new();
        for (rule, clauses) in rules.into_iter().enumerate() {
            if clauses.is_empty() {
                unconditional.push(rule);
            }
            for (input, literals) in clauses {
                let position = uses.iter().position(|known| known.input == input).unwrap_or_else(|| {
                    uses.push(Use { input, choices: Vec::new(), slices: Vec::new() });
                    uses.len() - 1
                });
                let choices = &mut uses[position].choices;
                match choices.iter_mut().find(|choice| choice.literals == literals) {
                    Some(choice) => choice.rules.push(rule),
                    None => choices.push(Choice { literals, rules: vec![rule] }),
                }
            }
        }
        uses.sort_unstable_by_key(|named| named.input);
        Self { contributors, rules: count, unconditional, uses }
    }

    /// The clauses of every rule: an input and the literals of which the largest degree counts.
    pub(super) fn clauses(&self) -> Vec<Vec<(usize, &[usize])>> {
        let mut clauses = vec![Vec::new(); self.rules];
        for named in &self.uses {
            for choice in &named.choices {
                for &rule in &choice.rules {
                    clauses[rule].push((named.input, choice.literals.as_slice()));
                }
            }
        }
        clauses
    }

    /// The levels at which to look, gaps first and wide ones before narrow ones, then heights.
    pub(super) fn levels(&self, states: &[usize]) -> Vec<Level> {
        let mut heights = vec![Fraction::ZERO, Fraction::ONE];
        for named in &self.uses {
            heights.extend(named.slices[states[named.input]].heights.iter().cloned());
        }
        heights.sort_unstable();
        heights.dedup();
        let mut gaps: Vec<_> = heights.windows(2).map(|pair| (&pair[1] - &pair[0], &pair[0], &pair[1])).collect();
        gaps.sort_by(|one, other| other.0.cmp(&one.0));
        let gaps = gaps.into_iter().map(|(_, from, to)| (from.clone(), Some(from.halfway(to))));
        let gaps: Vec<_> = gaps.collect();
        let levels = gaps.into_iter().chain(heights.into_iter().map(|height| (height, None)));
        levels
            .map(|(height, halfway)| {
                let is_gap = halfway.is_some();
                Level { value: halfway.unwrap_or_else(|| height.clone()), height, is_gap }
            })
            .collect()
    }
}

/// A level to look at: a height, or one that stands for the gap above a height.
#[derive(Debug, Clone)]
pub(super) struct Level {
    pub(super) height: Fraction,
    pub(super) is_gap: bool,
    pub(super) value: Fraction,
}
