//! What the mode analysis asks of the networks: which events can be set together.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use crate::analysis::network::{self, Fed, Sweep};
use crate::analysis::support::Interval;
use crate::analysis::{Source, source};
use crate::base::{Exact, Id};
use crate::ir::{Diagram, Program, Sense, Sensor};

/// Readings in SI, each sensor once.
pub(super) type Readings = Vec<(Id<Sensor>, Exact)>;

/// Which events, and what their sensors can read.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct Question {
    /// What [`Fusion::senses`] says of the sense, and the position of each event; none has a memory.
    pub(super) events: Vec<(u32, u32)>,
    /// The readings each of their sensors can give; `None` for one without any degree of membership.
    pub(super) feeds: Vec<(Id<Sensor>, Option<Interval>)>,
}

/// The positions of sensors among the feeds that read within less.
pub(super) type Within = Vec<(usize, Interval)>;

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
/// After so many questions that differ in where one sensor reads, all that it can read is looked into at once.
const MOST_LOOKS: usize = 4;

/// What has been asked, remembered: many modes ask the same, in many diagrams.
#[derive(Default)]
pub(super) struct Fusion {
    sources: RefCell<Vec<Source>>,
    asked: RefCell<HashMap<Question, Rc<RefCell<Asked>>>>,
}

impl Fusion {
    /// A number for each sense of a diagram; the same for the same network over the same sensors.
    pub(super) fn senses(&self, diagram: &Diagram) -> Vec<u32> {
        let mut sources = self.sources.borrow_mut();
        let mut number = |sense: &Sense| {
            let source = source(sense);
            let position = sources.iter().position(|known| *known == source).unwrap_or_else(|| {
                sources.push(source);
                sources.len() - 1
            });
            position as u32
        };
        diagram.senses.iter().map(&mut number).collect()
    }

    pub(super) fn about(&self, question: Question) -> Rc<RefCell<Asked>> {
        let mut asked = self.asked.borrow_mut();
        let new = |Question { events, feeds }: &Question| {
            let sources = self.sources.borrow();
            let events = events.iter().map(|(sense, event)| (sources[*sense as usize].clone(), *event)).collect();
            Rc::new(RefCell::new(Asked {
                events,
                feeds: feeds.clone(),
                answers: HashMap::new(),
                sweeps: HashMap::new(),
            }))
        };
        Rc::clone(asked.entry(question).or_insert_with_key(new))
    }
}

/// A question with what has been found by now.
pub(super) struct Asked {
    events: Vec<(Source, u32)>,
    feeds: Vec<(Id<Sensor>, Option<Interval>)>,
    answers: HashMap<Within, Answer>,
    /// By the position of a sensor.
    sweeps: HashMap<usize, Looks>,
}

/// What is known by what one sensor reads.
enum Looks {
    /// So many questions were asked.
    Asked(usize),
    /// Everything, if that is not too much.
    Swept(Option<Sweep>),
}

impl Asked {
    pub(super) fn within(&mut self, program: &Program, within: Within) -> Answer {
        if let Some(answer) = self.answers.get(&within) {
            return answer.clone();
        }
        if let [(swept, interval)] = within.as_slice()
            && let Some(sweep) = self.sweep(program, *swept)
        {
            let found = sweep.within(interval).into_iter();
            return Some(Rc::new(found.map(|(set, readings)| Valuation { set: bits(set), readings }).collect()));
        }
        let answer = self.valuations(program, &within).map(Rc::new);
        self.answers.insert(within, answer.clone());
        answer
    }

    /// Everything by what one sensor reads, once it has been asked for often enough.
    fn sweep(&mut self, program: &Program, swept: usize) -> Option<&Sweep> {
        let looks = self.sweeps.entry(swept).or_insert(Looks::Asked(0));
        match looks {
            Looks::Asked(count) if *count < MOST_LOOKS => *count += 1,
            Looks::Asked(_) => {
                *looks = Looks::Swept(Sweep::new(program, &fed(program, &self.events), &self.feeds, swept));
            }
            Looks::Swept(_) => {}
        }
        match looks {
            Looks::Swept(sweep) => sweep.as_ref(),
            Looks::Asked(_) => None,
        }
    }

    fn valuations(&self, program: &Program, within: &Within) -> Option<Vec<Valuation>> {
        let mut feeds = self.feeds.clone();
        for (position, interval) in within {
            feeds[*position].1 = Some(*interval);
        }
        let found = network::valuations(program, &fed(program, &self.events), &feeds, MOST_VALUATIONS)?;
        let valuation = |valuation: network::Valuation| Valuation {
            set: bits(&valuation.set),
            readings: valuation.witness.and_then(|witness| network::readings(&feeds, &witness)),
        };
        Some(found.into_iter().map(valuation).collect())
    }
}

fn fed<'a>(program: &'a Program, events: &'a [(Source, u32)]) -> Vec<Fed<'a>> {
    let fed = |((network, sensors), event): &'a (Source, u32)| Fed {
        network: &program.networks[*network],
        event: *event,
        sensors,
    };
    events.iter().map(fed).collect()
}

/// A bit for each event.
fn bits(set: &[bool]) -> u64 {
    set.iter().zip(0..).map(|(set, event)| u64::from(*set) << event).sum()
}
