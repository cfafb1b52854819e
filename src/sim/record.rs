//! Writes down what happens in a run, tick by tick.

use std::collections::BTreeSet;

use super::world::World;
use crate::base::Unit;
use crate::interp::{Machine, Proposal, Reading, Taken};
use crate::ir;
use crate::plan::{self, Plan};
use crate::trace::{Column, Evidence, Footprint, LogEntry, ModeChange, Signal, Trace};

/// A trace being written.
#[derive(Debug)]
pub(super) struct Recorder<'a> {
    plan: &'a Plan,
    trace: Trace,
    /// For each watched condition, whether it held, one for each tick.
    held: Vec<Vec<bool>>,
    /// For each event, whether each of its contributor and detractor rules was the strongest of its side on some tick.
    decided: Vec<Decided>,
    /// The mode that acted on the tick before.
    mode: Option<u32>,
    /// What was last said of each client of an arbiter, and last of its emergencies.
    said: Vec<String>,
    /// The places at which range sensors met something, in [`GRAIN`]s.
    hits: BTreeSet<(i32, i32)>,
}

/// How fine hits are told apart, m.
const GRAIN: f64 = 0.05;
/// The most places of hits that are recorded.
const MOST_HITS: usize = 20_000;

/// For each contributor rule and each detractor rule of an event, whether it gave its side its strength on some tick.
pub(super) type Decided = (Vec<bool>, Vec<bool>);

impl<'a> Recorder<'a> {
    /// An empty trace with room for `ticks` ticks.
    pub(super) fn new(
        plan: &'a Plan,
        scenario: &ir::Scenario,
        bodies: Vec<Footprint>,
        seed: u64,
        ticks: usize,
    ) -> Self {
        let column = |name: String, unit: String, signal| {
            let values = Vec::with_capacity(ticks);
            Column { name, unit, signal, values }
        };
        let plain = |name: String, signal| column(name, "1".to_owned(), signal);
        let mut columns = Vec::new();
        for (index, input) in (0..).zip(&plan.inputs) {
            columns.push(column(input.name.clone(), input.unit.dimension.si_unit(), Signal::Reading(index)));
        }
        for (index, logical) in (0..).zip(&plan.logical) {
            columns.push(column(logical.name.clone(), logical.unit.dimension.si_unit(), Signal::Logical(index)));
        }
        for (index, event) in (0..).zip(&plan.events) {
            columns.push(plain(format!("{}.contributor", event.name), Signal::Contributor(index)));
            columns.push(plain(format!("{}.detractor", event.name), Signal::Detractor(index)));
            columns.push(plain(event.name.clone(), Signal::Event(index)));
        }
        for (index, flag) in (0..).zip(&plan.flags) {
            columns.push(plain(flag.name.clone(), Signal::Flag(index)));
        }
        for (index, body) in (0..).zip(&bodies) {
            columns.push(column(format!("{}.x", body.name), "m".to_owned(), Signal::X(index)));
            columns.push(column(format!("{}.y", body.name), "m".to_owned(), Signal::Y(index)));
            columns.push(column(format!("{}.heading", body.name), "rad".to_owned(), Signal::Heading(index)));
        }
        let trace = Trace {
            scenario: scenario.symbol.name.clone(),
            behavior: plan.name.clone(),
            robot: plan.robot.clone(),
            seed,
            times: Vec::with_capacity(ticks),
            modes: plan.modes.iter().map(|mode| mode.name.clone()).collect(),
            mode: Vec::with_capacity(ticks),
            columns,
            changes: Vec::new(),
            places: Vec::new(),
            place: Vec::new(),
            inner: Vec::new(),
            log: Vec::new(),
            hits: Vec::new(),
            bodies,
            walls: scenario.walls.iter().map(|wall| wall.corners.clone()).collect(),
            goal: scenario.goal,
        };
        let decided =
            plan.strengths.iter().map(|(for_it, against)| (vec![false; for_it.len()], vec![false; against.len()]));
        let held = vec![Vec::with_capacity(ticks); plan.watched.len()];
        Self { plan, trace, held, decided: decided.collect(), mode: None, said: Vec::new(), hits: BTreeSet::new() }
    }

    /// Writes down one tick.
    pub(super) fn tick(&mut self, time: u64, readings: &[Reading], machine: &Machine<'_>, world: &World) {
        self.trace.times.push(time);
        self.trace.mode.push(machine.mode());
        self.change(time, readings, machine);
        self.log(time, machine);
        self.mode = Some(machine.mode());
        for (held, &watched) in self.held.iter_mut().zip(&self.plan.watched) {
            held.push(machine.bool(watched));
        }
        self.decide(machine);
        let plan = self.plan;
        let truth = |bool| f64::from(u8::from(machine.bool(bool)));
        let sensors = readings.iter().map(|reading| reading.value);
        let logical = plan.logical.iter().map(|logical| machine.value(logical.value));
        let events = plan
            .events
            .iter()
            .flat_map(|event| [machine.real(event.contributor), machine.real(event.detractor), truth(event.flag)]);
        let flags = plan.flags.iter().map(|flag| truth(flag.value));
        let robot = (world.robot().middle(), world.heading());
        let boxes = world.boxes().map(|shape| (shape.middle(), shape.pose.rotation.angle()));
        let poses = std::iter::once(robot).chain(boxes).flat_map(|(middle, heading)| [middle.x, middle.y, heading]);
        for (column, value) in
            self.trace.columns.iter_mut().zip(sensors.chain(logical).chain(events).chain(flags).chain(poses))
        {
            column.values.push(value);
        }
    }

    fn decide(&mut self, machine: &Machine<'_>) {
        for ((event, strengths), decided) in self.plan.events.iter().zip(&self.plan.strengths).zip(&mut self.decided) {
            let side = |of: plan::Real, rules: &[plan::Real], decided: &mut [bool]| {
                let strength = machine.real(of);
                for (rule, decided) in rules.iter().zip(decided).filter(|_| strength > 0.0) {
                    *decided |= machine.real(*rule) == strength;
                }
            };
            side(event.contributor, &strengths.0, &mut decided.0);
            side(event.detractor, &strengths.1, &mut decided.1);
        }
    }

    /// Notes a change of mode, or one inside the mode: the outermost of those of a tick.
    fn change(&mut self, time: u64, readings: &[Reading], machine: &Machine<'_>) {
        let (from, has_layers) = (self.mode, !self.plan.inner.is_empty());
        let place = has_layers.then(|| self.note_place(machine));
        if let Some(change) = self.reasons(time, readings, machine, from, machine.mode()) {
            self.trace.changes.push(change);
            return;
        }
        let Some((from, to)) = place else { return };
        let layers = std::iter::successors(machine.inner(), |inner| inner.inner());
        let change = layers.map(|inner| self.reasons(time, readings, inner, from, to)).find(Option::is_some);
        self.trace.inner.extend(change.flatten());
    }

    /// Notes where the machine is and what runs inside it: the positions before and now.
    fn note_place(&mut self, machine: &Machine<'_>) -> (Option<u32>, u32) {
        let before = self.trace.place.last().copied();
        let now = match before {
            Some(before) if !machine.has_moved() => before,
            _ => {
                let place = machine.place();
                let known = self.trace.places.iter().position(|known| *known == place);
                known.unwrap_or_else(|| {
                    self.trace.places.push(place);
                    self.trace.places.len() - 1
                }) as u32
            }
        };
        self.trace.place.push(now);
        (before, now)
    }

    /// Why a machine has entered a mode on this tick; `None` where it stayed.
    fn reasons(
        &self,
        time: u64,
        readings: &[Reading],
        machine: &Machine<'_>,
        from: Option<u32>,
        to: u32,
    ) -> Option<ModeChange> {
        let plan = machine.plan();
        let (priority, condition, evidence) = match machine.taken() {
            Taken::Stayed => return None,
            Taken::Entered => (None, String::new(), Vec::new()),
            Taken::Transition(index) => {
                let transition = &plan.transitions[index as usize];
                let shown = |&of: &plan::Evidence| evidence(plan, of, readings, machine, machine.lasted());
                let shown = transition.evidence.iter().map(shown);
                (Some(transition.priority), transition.text.clone(), shown.collect())
            }
            Taken::Handed => (None, self.reason(machine), Vec::new()),
            Taken::Lost { input, .. } => {
                let name = plan.inputs[input as usize].name.clone();
                (None, format!("failed({name})"), vec![Evidence { name, text: "failed".to_owned() }])
            }
        };
        Some(ModeChange { time, from, to, priority, condition, evidence })
    }

    /// Why an arbiter handed the robot on: the emergency, or the command that won.
    fn reason(&self, machine: &Machine<'_>) -> String {
        let won = machine.proposals().iter().find(|proposal| proposal.won).and_then(|proposal| proposal.action);
        match (emergency(self.plan, machine), won) {
            (Some(emergency), _) => emergency.text.clone(),
            (None, Some(action)) => self.plan.actions[action as usize].name.clone(),
            (None, None) => String::new(),
        }
    }

    /// Notes what became of the proposals of an arbiter's clients, where that is another thing than before.
    fn log(&mut self, time: u64, machine: &Machine<'_>) {
        let Some(arbiter) = &self.plan.arbiter else { return };
        let told = |action: u32| self.plan.actions[action as usize].name.to_uppercase().replace('_', "-");
        let of_client = |(place, (client, proposal)): (usize, (&plan::Client, &Proposal))| {
            let Some(action) = proposal.action else { return String::new() };
            let fate = if proposal.won { "Accepted" } else { "Rejected" };
            let mode = machine.client(place).map_or(0, Machine::mode);
            let mode = match client.plan.modes.as_slice() {
                [_] => String::new(),
                modes => modes.get(mode as usize).map_or(String::new(), |mode| format!(": {}", mode.name)),
            };
            format!("{fate} {} from {} ({}{mode})", told(action), place + 1, client.name)
        };
        let of_clients = arbiter.clients.iter().zip(machine.proposals()).enumerate().map(of_client);
        let bypass = emergency(self.plan, machine).map_or_else(String::new, |emergency| {
            let action = self.plan.calls[emergency.call as usize].action;
            format!("Emergency {} at {}", told(action), emergency.text)
        });
        let said: Vec<String> = of_clients.chain([bypass]).collect();
        let is_new = |place: usize, text: &String| !text.is_empty() && self.said.get(place) != Some(text);
        let mut new: Vec<&String> =
            said.iter().enumerate().filter(|(place, text)| is_new(*place, text)).map(|(_, text)| text).collect();
        new.sort_by_key(|text| text.starts_with("Rejected"));
        self.trace.log.extend(new.into_iter().map(|text| LogEntry { time, text: text.clone() }));
        self.said = said;
    }

    /// Notes where range sensors met something.
    pub(super) fn see(&mut self, hits: impl Iterator<Item = [f64; 2]>) {
        let cells = hits.map(|hit| hit.map(|coordinate| (coordinate / GRAIN).round() as i32).into());
        for cell in cells {
            if self.hits.len() < MOST_HITS {
                self.hits.insert(cell);
            }
        }
    }

    /// The trace, for each watched condition whether it held on each tick, and which rules decided.
    pub(super) fn finish(mut self) -> (Trace, Vec<Vec<bool>>, Vec<Decided>) {
        let place = |cell: i32| f64::from(cell) * GRAIN;
        self.trace.hits = self.hits.into_iter().map(|(x, y)| [place(x), place(y)]).collect();
        (self.trace, self.held, self.decided)
    }
}

/// The emergency that has the robot.
fn emergency<'p>(plan: &'p Plan, machine: &Machine<'_>) -> Option<&'p plan::Emergency> {
    let arbiter = plan.arbiter.as_ref().filter(|_| machine.mode() == plan::Arbiter::EMERGENCY)?;
    arbiter.emergencies.iter().find(|emergency| machine.bool(emergency.condition))
}

/// A number that a condition looks at, for people. `dwell` is how long the mode has been active, ns.
pub fn evidence(plan: &Plan, of: plan::Evidence, readings: &[Reading], machine: &Machine<'_>, dwell: u64) -> Evidence {
    match of {
        plan::Evidence::Input(index) => {
            let input = &plan.inputs[index as usize];
            let text = match readings.get(index as usize) {
                Some(reading) if reading.healthy => show_briefly(&input.unit, reading.value),
                Some(_) | None => "failed".to_owned(),
            };
            Evidence { name: input.name.clone(), text }
        }
        plan::Evidence::Logical(index) => {
            let logical = &plan.logical[index as usize];
            Evidence { name: logical.name.clone(), text: show_briefly(&logical.unit, machine.value(logical.value)) }
        }
        plan::Evidence::Event(index) => {
            let event = &plan.events[index as usize];
            let (contributor, detractor) = (machine.real(event.contributor), machine.real(event.detractor));
            let sign = if contributor > detractor { ">" } else { "<=" };
            let text = format!("contributor {contributor:.2} {sign} detractor {detractor:.2}");
            Evidence { name: event.name.clone(), text }
        }
        plan::Evidence::Dwell => {
            Evidence { name: "time in mode".to_owned(), text: format!("{:.2} s", dwell as f64 / 1e9) }
        }
    }
}

/// An SI value in a unit, to four digits: more would be noise to whoever reads it.
fn show_briefly(unit: &Unit, si: f64) -> String {
    let scale = unit.scale.to_f64();
    let value = si / scale;
    if value == 0.0 || !value.is_finite() {
        return unit.show(si);
    }
    let digit = 10_f64.powi(value.abs().log10().floor() as i32 - 3);
    unit.show((value / digit).round() * digit * scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::{Dimension, Exact};

    #[test]
    fn evidence_has_four_digits() {
        let centimetres = Unit { text: "cm".to_owned(), scale: Exact::new(1, 100, 0), dimension: Dimension::LENGTH };
        assert_eq!(show_briefly(&centimetres, 0.123_456_789), "12.35 cm");
        assert_eq!(show_briefly(&Unit::one(), -1234.567), "-1235");
        assert_eq!(show_briefly(&Unit::one(), 0.0), "0");
    }
}
