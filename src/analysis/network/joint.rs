//! Which events of a network can be set together, exactly.
//!
//! An event is set where some level lies strictly between its detractor and its contributor, and clear where some level
//! lies between them the other way round, ends included. A propositional solver chooses a cell for each input, a status
//! for each event, and *bounds*: literals above or below the event's level that make it so. Bounds whose cells lie on
//! one side of the level for sure are settled by where the level lies among the ends of cells; the rest are linear
//! inequalities between an input's place in its cell and a level. They are decided by elimination, and what
//! contradicts itself is handed back as a clause. There is no grid of levels: two levels cut a cell by slanted lines.

use super::event::{EventFacts, Verdict};
use super::joint_bounds::{Bound, Bounds, Side};
use super::linear::{self, Inequality};
use super::model::{EventModel, Model};
use super::sensor::Cell;
use super::solver::{Proposition, Solver};
use super::witness::{Reading, Witness};
use crate::base::Fraction;

/// Statuses that events can have together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Valuation {
    /// Whether each event is set, in order.
    pub set: Vec<bool>,
    /// Readings at which it is so; none where smooth terms leave it open whether there are any.
    pub witness: Option<Witness>,
}

/// The valuations that are possible in some states of the inputs, sorted. What is known of each event alone is a start.
pub(super) fn valuations<'a>(
    model: &Model,
    states: &[usize],
    facts: impl IntoIterator<Item = &'a EventFacts>,
) -> Vec<Valuation> {
    let mut known = Known::new(model);
    for (facts, set) in facts.into_iter().zip(known.set.clone()) {
        for (verdict, status) in [(&facts.set, set), (&facts.clear, !set)] {
            if !verdict.is_possible() {
                known.solver.demand([!status]);
            }
        }
        for witness in [&facts.set, &facts.clear, &facts.tie, &facts.dead].into_iter().filter_map(Verdict::witness) {
            let witness = model.complete_in(states, witness);
            if let Some(flags) = model.flags(states, &witness) {
                known.found(flags, Some(witness));
            }
        }
    }
    known.all(model, states, usize::MAX).unwrap_or_default()
}

/// The same where nothing is known of the events yet; `None` where there are more than `most`.
pub(super) fn all_valuations(model: &Model, states: &[usize], most: usize) -> Option<Vec<Valuation>> {
    let mut known = Known::new(model);
    known.look(model, states);
    known.all(model, states, most)
}

/// The most combinations of readings that are looked at before a search.
const MOST_LOOKS: usize = 64;

/// Whether some events can have these statuses together.
pub(super) fn verdict_of(model: &Model, states: &[usize], statuses: &[(usize, bool)]) -> Verdict {
    let mut known = Known::new(model);
    for &(event, set) in statuses {
        let status = known.set[event];
        known.solver.demand([if set { status } else { !status }]);
    }
    let mut search = Search::new(model, states, known);
    search.find();
    let found = search.known.valuations.pop();
    found.map_or(Verdict::Never, |found| found.witness.map_or(Verdict::Unknown, Verdict::Possible))
}

/// The valuations found so far; the solver is to find another one.
struct Known {
    solver: Solver,
    /// Whether each event is set.
    set: Vec<Proposition>,
    valuations: Vec<Valuation>,
}

impl Known {
    fn new(model: &Model) -> Self {
        let mut solver = Solver::default();
        let set: Vec<_> = model.events.iter().map(|_| solver.proposition()).collect();
        for &(premise, conclusion) in &model.implications {
            solver.demand([!set[premise], set[conclusion]]);
        }
        Self { solver, set, valuations: Vec::new() }
    }

    fn found(&mut self, set: Vec<bool>, witness: Option<Witness>) {
        if self.valuations.iter().all(|known| known.set != set) {
            let other = self.set.iter().zip(&set).map(|(&status, &set)| if set { !status } else { status });
            let other: Vec<_> = other.collect();
            self.solver.demand(other);
            self.valuations.push(Valuation { set, witness });
        }
    }
}

impl Known {
    /// Looks at the middle of every combination of cells, where there are few. Where each cell is a point, nothing is
    /// left to search for.
    fn look(&mut self, model: &Model, states: &[usize]) {
        let sensors: Vec<_> = model.inputs.iter().zip(states).map(|(input, &state)| &input.sensors[state]).collect();
        let combinations = sensors.iter().map(|sensor| sensor.cells.len()).fold(1, usize::saturating_mul);
        if combinations > MOST_LOOKS {
            return;
        }
        let middle = Fraction::new(1, 2);
        let mut all_sure = sensors.iter().all(|sensor| sensor.cells.iter().all(Cell::is_point));
        for mut number in 0..combinations {
            let readings = sensors.iter().zip(&model.inputs).map(|(sensor, input)| {
                let cell = &sensor.cells[number % sensor.cells.len()];
                number /= sensor.cells.len();
                Some(Reading { fraction: cell.reading(&middle)?, pi: input.pi })
            });
            let witness = Witness { readings: readings.collect() };
            match model.flags(states, &witness) {
                Some(flags) => self.found(flags, Some(witness)),
                None => all_sure = false,
            }
        }
        if all_sure {
            self.solver.demand([]);
        }
    }

    /// All of them, sorted; `None` where there are more than `most`.
    fn all(mut self, model: &Model, states: &[usize], most: usize) -> Option<Vec<Valuation>> {
        // Often nothing is left to search for.
        if self.solver.holds(&[]) {
            let mut search = Search::new(model, states, self);
            while search.known.valuations.len() <= most && search.find() {}
            self = search.known;
        }
        self.valuations.sort_by(|one, other| one.set.cmp(&other.set));
        (self.valuations.len() <= most).then_some(self.valuations)
    }
}

/// What is searched for statuses that events can have together.
pub(super) struct Search<'a> {
    model: &'a Model,
    states: &'a [usize],
    known: Known,
    bounds: Bounds,
    limits: Vec<Limit>,
}

/// A limit to where an input is in a cell.
struct Limit {
    /// The limit, and the cell.
    reason: [Proposition; 2],
    inequality: Inequality,
}

impl<'a> Search<'a> {
    /// Everything that the inputs can read in these states.
    pub(super) fn over(model: &'a Model, states: &'a [usize]) -> Self {
        Self::new(model, states, Known::new(model))
    }

    fn new(model: &'a Model, states: &'a [usize], mut known: Known) -> Self {
        let bounds = Bounds::new(model, states, &mut known.solver);
        let mut search = Self { model, states, known, bounds, limits: Vec::new() };
        for position in 0..model.events.len() {
            search.demand_event(position, model.loose(position), true);
            search.demand_event(position, &model.events[position], false);
        }
        search
    }

    /// Some contributor rule is high and every detractor rule low while the event is set; the other way round while it
    /// is clear.
    fn demand_event(&mut self, position: usize, event: &EventModel, is_set: bool) {
        let clauses = event.clauses();
        let (contributors, detractors) = clauses.split_at(event.contributors);
        let (high, low) = if is_set { (contributors, detractors) } else { (detractors, contributors) };
        let Known { solver, set, .. } = &mut self.known;
        let bounds = &mut self.bounds;
        let status = if is_set { set[position] } else { !set[position] };
        let mut some_high = vec![!status];
        if !is_set {
            // A level of 0 is reached by an empty side too.
            some_high.push(bounds.constant(solver, position, Side::Above, is_set, Fraction::ZERO));
        }
        for rule in high {
            let all = solver.proposition();
            for (input, literals) in rule {
                let literals = literals.iter().map(|&literal| (*input, literal));
                let any = literals.map(|literal| bounds.literal(solver, position, Side::Above, is_set, literal));
                let any: Vec<_> = any.chain([!all]).collect();
                solver.demand(any);
            }
            if rule.is_empty() {
                let one = bounds.constant(solver, position, Side::Above, is_set, Fraction::ONE);
                solver.demand([!all, one]);
            }
            some_high.push(all);
        }
        solver.demand(some_high);
        for rule in low {
            let mut some_low = vec![!status];
            for (input, literals) in rule {
                let all = solver.proposition();
                for &literal in *literals {
                    let below = bounds.literal(solver, position, Side::Below, is_set, (*input, literal));
                    solver.demand([!all, below]);
                }
                if literals.is_empty() {
                    let zero = bounds.constant(solver, position, Side::Below, is_set, Fraction::ZERO);
                    solver.demand([!all, zero]);
                }
                some_low.push(all);
            }
            if rule.is_empty() {
                some_low.push(bounds.constant(solver, position, Side::Below, is_set, Fraction::ONE));
            }
            solver.demand(some_low);
        }
    }

    /// Finds one more valuation, if there is one.
    fn find(&mut self) -> bool {
        let order: Vec<_> = (0..self.bounds.unknowns()).collect();
        let Some((set, left)) = self.next(&order) else { return false };
        let witness = self.witness(&left.values());
        let is_sure = self.model.flags(self.states, &witness).as_ref() == Some(&set);
        self.known.found(set, is_sure.then_some(witness));
        true
    }

    /// Statuses that nothing excludes, and what is left of the inequalities once places and levels are eliminated in some
    /// order.
    pub(super) fn next(&mut self, order: &[usize]) -> Option<(Vec<bool>, linear::Eliminated)> {
        while self.known.solver.holds(&[]) {
            let set: Vec<_> = self.known.set.iter().map(|&set| self.known.solver.value(set)).collect();
            let (inequalities, reasons) = self.inequalities(&set);
            match linear::eliminate(order.iter().copied(), inequalities) {
                Ok(left) => return Some((set, left)),
                Err(because) => {
                    let mut clause: Vec<_> = because.iter().flat_map(|&reason| &reasons[reason]).map(|&p| !p).collect();
                    clause.sort_unstable();
                    clause.dedup();
                    self.known.solver.demand(clause);
                }
            }
        }
        None
    }

    /// What the bounds and limits of the model found last say of places and levels, with the propositions each follows
    /// from.
    fn inequalities(&self, set: &[bool]) -> (Vec<Inequality>, Vec<Vec<Proposition>>) {
        let mut inequalities = self.bounds.domains();
        let mut reasons = Vec::new();
        for bound in &self.bounds.all {
            if bound.when_set == set[bound.event] && self.known.solver.value(bound.proposition) {
                let (inequality, reason) = self.inequality(bound, reasons.len());
                inequalities.push(inequality);
                reasons.push(reason);
            }
        }
        for limit in self.limits.iter().filter(|limit| limit.reason.iter().all(|&p| self.known.solver.value(p))) {
            inequalities.push(Inequality { because: vec![reasons.len()], ..limit.inequality.clone() });
            reasons.push(limit.reason.to_vec());
        }
        (inequalities, reasons)
    }

    fn inequality(&self, bound: &Bound, number: usize) -> (Inequality, Vec<Proposition>) {
        let mut reason = vec![bound.proposition];
        let level = self.bounds.level(bound.event);
        let (constant, slope) = match bound.literal {
            None => (bound.constant.clone(), None),
            Some((input, literal)) => {
                let chosen = self.bounds.chosen(&self.known.solver, input);
                reason.extend(self.bounds.cells[input].get(chosen));
                let (from, to) = &self.model.inputs[input].sensors[self.states[input]].cells[chosen].degrees[literal];
                (from.clone(), Some((input, to - from)).filter(|(_, slope)| !slope.is_zero()))
            }
        };
        let above = [(level, Fraction::from(-1))];
        let mut factors: Vec<_> = slope.into_iter().chain(above).collect();
        let mut constant = constant;
        if bound.side == Side::Below {
            constant = -&constant;
            for (_, factor) in &mut factors {
                *factor = -&*factor;
            }
        }
        (Inequality { factors, constant, strict: bound.when_set, because: vec![number] }, reason)
    }

    /// The cell that an input is in, in the model found last.
    pub(super) fn chosen(&self, input: usize) -> usize {
        self.bounds.chosen(&self.known.solver, input)
    }

    pub(super) fn unknowns(&self) -> usize {
        self.bounds.unknowns()
    }

    /// Excludes statuses while an input is in a cell between these places, each with whether it is left out.
    pub(super) fn exclude(
        &mut self,
        set: &[bool],
        (input, cell): (usize, usize),
        (from, to): (&(Fraction, bool), &(Fraction, bool)),
    ) {
        let other = self.known.set.iter().zip(set).map(|(&status, &set)| if set { !status } else { status });
        let here = self.bounds.cells[input][cell];
        let mut clause: Vec<_> = other.chain([!here]).collect();
        let ends = [(from, Fraction::ZERO, -1), (to, Fraction::ONE, 1)];
        for ((place, is_left_out), end, sign) in ends {
            if *place != end {
                let proposition = self.known.solver.proposition();
                let constant = if sign < 0 { place.clone() } else { -place };
                let factors = vec![(input, Fraction::from(sign))];
                let inequality = Inequality { factors, constant, strict: !is_left_out, because: Vec::new() };
                self.limits.push(Limit { reason: [proposition, here], inequality });
                clause.push(proposition);
            }
        }
        self.known.solver.demand(clause);
    }

    pub(super) fn witness(&self, values: &[Fraction]) -> Witness {
        let readings = self.model.inputs.iter().enumerate().map(|(position, input)| {
            let cell = &input.sensors[self.states[position]].cells[self.chosen(position)];
            Some(Reading { fraction: cell.reading(&values[position])?, pi: input.pi })
        });
        Witness { readings: readings.collect() }
    }
}
