//! What the mode analysis asks of the networks: which events can be set together.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use crate::analysis::support::Interval;
use crate::base::{Exact, Id};
use crate::ir::{Diagram, Sensor};

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
    /// Readings that do it; `None` where it is not excluded, but not shown either.
    pub(super) readings: Option<Readings>,
}

/// What decides it. Every valuation that some readings give must be among the answers.
pub(super) trait Fusion {
    fn valuations(&self, diagram: &Diagram, question: &Question) -> Vec<Valuation>;
}

/// Remembers the answers: many modes ask the same.
pub(super) struct Remembered<F> {
    fusion: F,
    answers: RefCell<HashMap<Question, Rc<Vec<Valuation>>>>,
}

impl<F: Fusion> Remembered<F> {
    pub(super) fn new(fusion: F) -> Self {
        Self { fusion, answers: RefCell::default() }
    }

    pub(super) fn ask(&self, diagram: &Diagram, question: Question) -> Rc<Vec<Valuation>> {
        if let Some(answer) = self.answers.borrow().get(&question) {
            return Rc::clone(answer);
        }
        let answer = Rc::new(self.fusion.valuations(diagram, &question));
        self.answers.borrow_mut().insert(question, Rc::clone(&answer));
        answer
    }
}
