//! The modes of a plan, and what they share.

use std::ops::Range;

use super::builder::{Builder, Names};
use super::diagram::build_on;
use super::platform::Platform;
use super::{Arbiter, Call, Checked, Client, Draw, Emergency, Mode, Real, Row, Run, Transition, origin};
use crate::base::Id;
use crate::ir;

/// The lists of a plan that its modes share.
pub(super) struct Parts<'a> {
    pub(super) platform: Platform<'a>,
    pub(super) checked: Checked<'a>,
    pub(super) diagram: &'a ir::Diagram,
    /// The diagrams that run inside, each once.
    pub(super) inner: Vec<Id<ir::Diagram>>,
    pub(super) transitions: Vec<Transition>,
    pub(super) rows: Vec<Row>,
    pub(super) calls: Vec<Call>,
    pub(super) arguments: Vec<Real>,
    pub(super) draws: Vec<Draw>,
    pub(super) required: Vec<u32>,
}

impl<'a> Parts<'a> {
    pub(super) fn new(platform: Platform<'a>, checked: Checked<'a>, diagram: &'a ir::Diagram) -> Self {
        let mut inner = Vec::new();
        for run in diagram.modes.values().filter_map(|mode| mode.runs) {
            if !inner.contains(&run.diagram) {
                inner.push(run.diagram);
            }
        }
        Self {
            platform,
            checked,
            diagram,
            inner,
            transitions: Vec::new(),
            rows: Vec::new(),
            calls: Vec::new(),
            arguments: Vec::new(),
            draws: Vec::new(),
            required: Vec::new(),
        }
    }

    pub(super) fn arbiter(
        &mut self,
        arbiter: &ir::Arbiter,
        on: ir::Platform,
        builder: &mut Builder<'_>,
        names: &Names<'_>,
    ) -> Arbiter {
        let emergency = |emergency: &ir::Emergency| {
            let condition = builder.expr(emergency.condition, names);
            let text = self.checked.on_one_line(self.platform.program.exprs[emergency.condition].span);
            let call = self.calls(std::slice::from_ref(&emergency.command), builder, names).start;
            Emergency { condition, text, call }
        };
        let emergencies = arbiter.emergencies.iter().map(emergency).collect();
        let client = |client: &ir::Client| Client {
            name: client.symbol.name.clone(),
            plan: Box::new(build_on(self.checked, client.diagram, on, &[])),
            priorities: client
                .priorities
                .iter()
                .map(|&(level, when)| (level, when.map(|when| builder.expr(when, names))))
                .collect(),
        };
        let clients = arbiter.clients.iter().map(client).collect();
        let fed = |source: ir::SensorSource| {
            let is_it = |id: &Id<ir::Sensor>| self.platform.program.sensors[*id].source == Some(source);
            Some(self.platform.sensors.iter().position(is_it)? as u32)
        };
        let (won, lost) = (fed(ir::SensorSource::Won), fed(ir::SensorSource::Lost));
        Arbiter { emergencies, clients, ties: arbiter.ties.unwrap_or(ir::Ties::InOrder), won, lost }
    }

    pub(super) fn mode(
        &mut self,
        id: Id<ir::Mode>,
        mode: &ir::Mode,
        builder: &mut Builder<'_>,
        names: &Names<'_>,
    ) -> Mode {
        let draws = self.draws.len() as u32;
        let on_enter = self.calls(&mode.on_enter, builder, names);
        // A table of one row gives its command whatever happens.
        let (always, table) = match mode.decision.as_ref().map(|table| table.rows.as_slice()) {
            Some([row]) if row.commands.len() < 2 => (row.commands.as_slice(), [].as_slice()),
            rows => ([].as_slice(), rows.unwrap_or_default()),
        };
        let actions = self.calls(&[&mode.actions, always].concat(), builder, names);
        let on_exit = self.calls(&mode.on_exit, builder, names);
        let draws = draws..self.draws.len() as u32;
        let rows = self.rows(table, builder, names);
        let required = self.required.len() as u32;
        self.required.extend(mode.requires.iter().flat_map(|&(sensor, _)| self.platform.inputs_of(sensor)));
        let transitions = self.transitions.len() as u32;
        for transition in &mode.transitions {
            let transition = self.transition(id, transition, builder, names);
            self.transitions.push(transition);
        }
        let runs = mode.runs.and_then(|run| {
            let inner = self.inner.iter().position(|inner| *inner == run.diagram)? as u32;
            Some(Run { inner, resumes: run.resumes })
        });
        Mode {
            name: mode.symbol.name.clone(),
            origin: origin(&mode.symbol),
            is_final: mode.is_final,
            runs,
            transitions: transitions..self.transitions.len() as u32,
            actions,
            rows,
            on_enter,
            on_exit,
            draws,
            required: required..self.required.len() as u32,
            otherwise: mode.otherwise.map(|mode| mode.index() as u32),
        }
    }

    fn rows(&mut self, rows: &[ir::DecisionRow], builder: &mut Builder<'_>, names: &Names<'_>) -> Range<u32> {
        let first = self.rows.len() as u32;
        for row in rows {
            builder.begin_part();
            let start = builder.position();
            let condition = builder.expr(row.condition, names);
            let steps = start..builder.position();
            let draws = self.draws.len() as u32;
            let several = row.commands.len() as f64;
            let pick = (row.commands.len() > 1).then(|| builder.new_real());
            self.draws.extend(pick.map(|to| Draw { low: 0.0, high: several, to }));
            let calls = self.calls(&row.commands, builder, names);
            let draws = draws..self.draws.len() as u32;
            self.rows.push(Row { steps, condition, calls, pick, draws, span: row.span });
        }
        first..self.rows.len() as u32
    }

    fn calls(&mut self, calls: &[ir::Call], builder: &mut Builder<'_>, names: &Names<'_>) -> Range<u32> {
        let start = self.calls.len() as u32;
        for call in calls {
            let first = self.arguments.len() as u32;
            for argument in &call.arguments {
                let real = match argument {
                    ir::Argument::Constant(value) => builder.constant(value.to_f64()),
                    ir::Argument::Random { low, high } => {
                        let to = builder.new_real();
                        self.draws.push(Draw { low: low.to_f64(), high: high.to_f64(), to });
                        to
                    }
                    ir::Argument::Reading(sensor) => builder.sensor(*sensor, names.platform, names.logical),
                    ir::Argument::Output { sense, output } => names.outputs[*sense as usize][*output as usize],
                };
                self.arguments.push(real);
            }
            let arguments = first..self.arguments.len() as u32;
            self.calls.push(Call { action: self.platform.action(call.action), arguments });
        }
        start..self.calls.len() as u32
    }

    fn transition(
        &self,
        from: Id<ir::Mode>,
        transition: &ir::Transition,
        builder: &mut Builder<'_>,
        names: &Names<'_>,
    ) -> Transition {
        builder.begin_part();
        let start = builder.position();
        let condition = builder.expr(transition.condition, names);
        let steps = start..builder.position();
        Transition {
            priority: transition.priority,
            steps,
            condition,
            target: transition.target.unwrap_or(from).index() as u32,
            span: transition.span,
            text: self.checked.on_one_line(self.platform.program.exprs[transition.condition].span),
            evidence: self.evidence(transition.condition),
            parts: self.parts(transition.condition, builder, names),
        }
    }
}
