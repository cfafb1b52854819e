//! What can be asked of one event, as conditions on how its rules compare to one level.
//!
//! With `C` and `D` the strongest contributor and detractor rule, the flag is set where `C > D`. Each question holds
//! somewhere if and only if one of its conditions holds at some level of the kind it names:
//!
//! | question | level | condition |
//! |---|---|---|
//! | set | in a gap, between D and C | some c above, every d below |
//! | clear | in a gap, between C and D; or D | every c below, some d above; or no c above, some d not below |
//! | tie above 0 | above 0, C and D | no rule above, some c and some d not below |
//! | dead | 0 | no rule above |
//! | rule fires | 0 | the rule above |
//! | rule alone strongest | in a gap, below it | the rule above, every other of its side below |
//! | contributor decisive | D | the rule above, no other rule above, some d not below |
//! | detractor decisive | above 0, C | no c above, some c not below, the rule not below, every other d below |
//!
//! Where "some d not below" stands for a level that is D, 0 will do as well: an empty side has strength 0.

use std::cmp::Ordering;

use super::model::{EventModel, Level};

/// What can be asked of one event. Rules are counted through, contributors first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Question {
    /// Can the flag be set?
    Set,
    /// Can the flag be clear?
    Clear,
    /// Can the sides be equally strong, above 0?
    Tie,
    /// Can it be that no rule fires?
    Dead,
    /// Can the rule's strength be above 0?
    Fires(usize),
    /// Can the rule be stronger than every other one of its side?
    Strongest(usize),
    /// Can the flag depend on the rule: would it be another without it?
    Decisive(usize),
}

/// Some of an event's rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rules {
    Every,
    EveryBut(usize),
    Contributors,
    Detractors,
    /// The others of the rule's side.
    Beside(usize),
    One(usize),
}

/// The levels at which a condition means something.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Levels {
    Zero,
    AboveZero,
    Every,
    Gaps,
}

/// A condition on how rules compare to a level.
#[derive(Debug, Clone)]
pub(super) struct Condition {
    pub(super) levels: Levels,
    /// Of each, some rule is above.
    pub(super) some_above: Option<Rules>,
    /// Of each, some rule is not below.
    pub(super) some_reach: Vec<Rules>,
    /// At level 0, `some_reach` need not hold.
    pub(super) zero_is_reached: bool,
    /// Of these, every rule is below.
    pub(super) below: Option<Rules>,
    /// Of these, no rule is above.
    pub(super) none_above: Option<Rules>,
}

impl Question {
    /// The conditions, each of which would do; those that leave room for noise come first.
    pub(super) fn conditions(self, event: &EventModel) -> Vec<Condition> {
        use Rules::{Beside, Contributors, Detractors, Every, EveryBut, One};
        let at = |levels| Condition {
            levels,
            some_above: None,
            some_reach: Vec::new(),
            zero_is_reached: false,
            below: None,
            none_above: None,
        };
        let gap = |above, below| Condition { some_above: Some(above), below: Some(below), ..at(Levels::Gaps) };
        match self {
            Self::Set => vec![gap(Contributors, Detractors)],
            Self::Clear => vec![
                gap(Detractors, Contributors),
                Condition {
                    some_reach: vec![Detractors],
                    zero_is_reached: true,
                    none_above: Some(Contributors),
                    ..at(Levels::Every)
                },
            ],
            Self::Tie => vec![Condition {
                some_reach: vec![Contributors, Detractors],
                none_above: Some(Every),
                ..at(Levels::AboveZero)
            }],
            Self::Dead => vec![Condition { none_above: Some(Every), ..at(Levels::Zero) }],
            Self::Fires(rule) => vec![Condition { some_above: Some(One(rule)), ..at(Levels::Zero) }],
            Self::Strongest(rule) => vec![gap(One(rule), Beside(rule))],
            Self::Decisive(rule) if rule < event.contributors => vec![Condition {
                some_above: Some(One(rule)),
                some_reach: vec![Detractors],
                zero_is_reached: true,
                none_above: Some(EveryBut(rule)),
                ..at(Levels::Every)
            }],
            Self::Decisive(rule) => vec![Condition {
                some_reach: vec![Contributors, One(rule)],
                below: Some(Beside(rule)),
                none_above: Some(Contributors),
                ..at(Levels::AboveZero)
            }],
        }
    }
}

impl Rules {
    /// Which of an event's rules these are, ascending.
    pub(super) fn of(self, event: &EventModel) -> impl Iterator<Item = usize> {
        let side =
            |rule| if rule < event.contributors { 0..event.contributors } else { event.contributors..event.rules };
        let (range, without) = match self {
            Self::Every => (0..event.rules, None),
            Self::EveryBut(rule) => (0..event.rules, Some(rule)),
            Self::Contributors => (0..event.contributors, None),
            Self::Detractors => (event.contributors..event.rules, None),
            Self::Beside(rule) => (side(rule), Some(rule)),
            Self::One(rule) => (rule..rule + 1, None),
        };
        range.filter(move |rule| Some(*rule) != without)
    }
}

impl Levels {
    pub(super) fn hold(self, level: &Level) -> bool {
        match self {
            Self::Zero => level.value.is_zero(),
            Self::AboveZero => !level.value.is_zero(),
            Self::Every => true,
            Self::Gaps => level.is_gap,
        }
    }
}

impl Condition {
    /// What must be reached at a level.
    pub(super) fn reached(&self, level: &Level) -> &[Rules] {
        if self.zero_is_reached && level.value.is_zero() { &[] } else { &self.some_reach }
    }

    /// Whether rules that compare to a level like this meet it.
    pub(super) fn met(&self, event: &EventModel, level: &Level, signs: &[Ordering]) -> bool {
        let some = |rules: Rules, meets: fn(Ordering) -> bool| rules.of(event).any(|rule| meets(signs[rule]));
        let none = |rules: Option<Rules>, meets| rules.is_none_or(|rules| !some(rules, meets));
        self.levels.hold(level)
            && self.some_above.is_none_or(|rules| some(rules, Ordering::is_gt))
            && self.reached(level).iter().all(|&rules| some(rules, Ordering::is_ge))
            && none(self.below, Ordering::is_ge)
            && none(self.none_above, Ordering::is_gt)
    }
}
