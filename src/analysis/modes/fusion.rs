//! What the mode analysis asks of the networks: which events can be set together.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use crate::analysis::network::{self, Fed, Feeds};
use crate::analysis::support::Interval;
use crate::base::{Exact, Id};
use crate::ir::{Diagram, Program, Sensor};

/// Readings in SI, each sensor once.
pub(super) type Readings = Vec<(Id<Sensor>, Exact)>;

/// Which events, and what their sensors can read.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct Question {
    /// The sense and the position of each event; none has a memory.
    pub(super) events: Vec<(u32, u32)>,
    /// The readings each of their sensors can give; `None` for one without any degree of membership.
    pub(super) feeds: Vec<(Id<Sensor>, Option<Interval>)>,
}

/// Events that can be set together, while the others are clear.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Valuation {
    /// A bit for each event asked for.
    pub(super) set: u64,
    /// Readings that do it; `None` where a number cannot be kept.
    pub(super) readings: Option<Readings>,
}

/// All answers to a question; `None` where there are too many, or a network is broken.
type Answer = Option<Rc<Vec<Valuation>>>;

/// More valuations than this are not looked into.
const MOST_VALUATIONS: usize = 1 << 10;

/// Answers, remembered: many modes ask the same.
#[derive(Default)]
pub(super) struct Fusion {
    answers: RefCell<HashMap<Question, Answer>>,
}

impl Fusion {
    pub(super) fn ask(&self, program: &Program, diagram: &Diagram, question: Question) -> Answer {
        if let Some(answer) = self.answers.borrow().get(&question) {
            return answer.clone();
        }
        let answer = valuations(program, diagram, &question).map(Rc::new);
        self.answers.borrow_mut().insert(question, answer.clone());
        answer
    }
}

fn valuations(program: &Program, diagram: &Diagram, question: &Question) -> Option<Vec<Valuation>> {
    let fed = |&(sense, event): &(u32, u32)| {
        let sense = &diagram.senses[sense as usize];
        Fed { network: &program.networks[sense.network], event, sensors: &sense.inputs }
    };
    let events: Vec<_> = question.events.iter().map(fed).collect();
    let found = network::valuations(program, &events, &question.feeds, MOST_VALUATIONS)?;
    let valuation = |valuation: network::Valuation| Valuation {
        set: valuation.set.iter().zip(0..).map(|(set, event)| u64::from(*set) << event).sum(),
        readings: valuation.witness.and_then(|witness| readings(&question.feeds, &witness)),
    };
    Some(found.into_iter().map(valuation).collect())
}

fn readings(feeds: &Feeds, witness: &network::Witness) -> Option<Readings> {
    let read =
        feeds.iter().zip(&witness.readings).filter_map(|((sensor, _), reading)| Some((*sensor, reading.as_ref()?)));
    read.map(|(sensor, reading)| Some((sensor, Exact::from_fraction(&reading.fraction, reading.pi)?))).collect()
}
