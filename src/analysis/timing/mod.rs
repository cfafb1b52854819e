//! How far a robot goes before it can react to what is in its way (Sobh §3.4).
//!
//! What is in its way stands still, straight ahead or straight behind, and is seen by the range sensors whose beams point
//! there. The robot drives at it at a constant speed v. A sensor that is read once in t tells of a place at most t after
//! the robot passed it; the mean of n readings lags behind by (n - 1) / 2 more; and each is off by the accuracy a at
//! most. So between the place where a condition begins to hold and the first different command lie at most
//! a + v ((n + 1) t / 2 + d) where the condition waits for d, and some run comes as near to that as one likes.

mod looks;
mod motions;
mod scene;

use crate::base::{Id, Span, Unit, show_time};
use crate::diag::{Diagnostic, rules};
use crate::ir::{Body, Diagram, Mode, Op, Platform, Program, Sensor};
use looks::{looks, looks_of_mode, looks_of_robot};
use motions::motions;
use scene::Scene;

/// What a robot can do about an obstacle straight in its way, at its fastest. Numbers are SI.
#[derive(Debug, Clone, PartialEq)]
pub struct Reaction {
    /// The mode that drives; `None` for an arbiter.
    pub mode: Option<Id<Mode>>,
    /// The command that drives.
    pub command: Span,
    /// Speed over ground in m/s, negative backward.
    pub speed: f64,
    /// The range sensor that tells first.
    pub sensor: Id<Sensor>,
    /// The condition that reacts, and the distance in m at which it begins to.
    pub condition: Span,
    /// See `condition`.
    pub begins: f64,
    /// Accuracy of the sensor, m.
    pub accuracy: f64,
    /// The longest time from passing that distance to a different command, nanoseconds, were readings exact.
    pub wait: u64,
    /// The longest way from that distance to a different command, m.
    pub late: f64,
    /// The least way from there to a stand, m; 0 where a command steers while it drives.
    pub stop: f64,
}

impl Reaction {
    /// What is left in front of the robot at worst, m; below 0 where it arrives.
    pub fn left(&self) -> f64 {
        self.begins - self.late - self.stop
    }

    /// The numbers, for people.
    pub fn told(&self, program: &Program) -> String {
        let Sensor { symbol, unit, .. } = &program.sensors[self.sensor];
        let backward = if self.speed < 0.0 { "backward " } else { "" };
        let (speed, late, stop) = (speed(self.speed), round(unit, self.late), round(unit, self.stop));
        let name = &symbol.name;
        let wait = show_time(self.wait);
        let off =
            if self.accuracy > 0.0 { format!(", and is off by {}", unit.show(self.accuracy)) } else { String::new() };
        let stands = if self.stop > 0.0 { format!("; then it takes {stop} at least to stand") } else { String::new() };
        format!(
            "{backward}at {speed} it may go {late} before it is told otherwise, as `{name}` tells up to {wait} late{off}{stands}"
        )
    }
}

/// A length with three digits.
fn round(unit: &Unit, si: f64) -> String {
    let value = si / unit.scale.to_f64();
    let step = if value > 0.0 { 10_f64.powf(value.log10().floor() - 2.0) } else { 1.0 };
    unit.show((value / step).round() * step * unit.scale.to_f64())
}

fn speed(speed: f64) -> String {
    Unit::parse("m/s").map(|unit| unit.show(speed.abs())).unwrap_or_default()
}

/// Warns where a robot can be at an obstacle before it stands.
pub(super) fn check(program: &Program, diagram: Id<Diagram>, findings: &mut Vec<Diagnostic>) {
    let own = |reaction: &Reaction| reaction.mode.is_none_or(|mode| !program.diagrams[diagram].modes[mode].inherited);
    let reactions = reactions(program, diagram).into_iter().filter(own);
    findings.extend(reactions.filter(|reaction| reaction.left() < 0.0).map(|reaction| too_late(program, &reaction)));
}

fn too_late(program: &Program, reaction: &Reaction) -> Diagnostic {
    let Sensor { symbol, unit, .. } = &program.sensors[reaction.sensor];
    let before = if reaction.late >= reaction.begins { "reacts" } else { "stands" };
    let message = format!("the robot can be at what `{}` sees before it {before}", symbol.name);
    Diagnostic::new(&rules::REACTS_TOO_LATE, reaction.command, message)
        .here(format!("drives at {}", speed(reaction.speed)))
        .label(reaction.condition, format!("reacts from {} on", unit.show(reaction.begins)))
        .note(reaction.told(program))
        .help("drive slower, react from farther away, or read the sensor more often")
}

/// For each mode of a diagram, or for an arbiter as a whole, forward and backward: what it can do about an obstacle in
/// its way at its fastest, by the sensor that leaves most room. None where nothing drives straight on at a known speed,
/// where the robot has no body, and where nothing looks that way. Linear in the size of the diagrams.
pub fn reactions(program: &Program, id: Id<Diagram>) -> Vec<Reaction> {
    let diagram = &program.diagrams[id];
    let Platform::Robot(robot) = diagram.platform else { return Vec::new() };
    let robot = &program.robots[robot];
    let Some(Body::DifferentialDrive(body)) = &robot.body else { return Vec::new() };
    if diagram.incomplete {
        return Vec::new();
    }
    let scene = Scene { program, robot, body, tick: tick(program, id) };
    let mut seen = looks_of_robot(program, robot);
    let Some(arbiter) = &diagram.arbiter else {
        let all = motions(program, robot, diagram.modes.values().flat_map(Mode::commands));
        let of_mode = |(id, mode): (Id<Mode>, &Mode)| {
            let own = motions(program, robot, mode.lasting());
            let seen = [looks_of_mode(program, diagram, mode), seen.clone()].concat();
            scene.reactions(Some(id), &own, &all, &seen, deadline(program, mode))
        };
        return diagram.modes.iter().filter(|(_, mode)| !mode.incomplete).flat_map(of_mode).collect();
    };
    let mut own = Vec::new();
    let mut all = motions(program, robot, arbiter.emergencies.iter().map(|emergency| &emergency.command));
    let mut conditions: Vec<_> = arbiter.emergencies.iter().map(|emergency| emergency.condition).collect();
    for client in &arbiter.clients {
        conditions.extend(client.priorities.iter().filter_map(|(_, when)| *when));
        for layer in program.layers(client.diagram) {
            let layer = &program.diagrams[layer];
            if layer.incomplete {
                return Vec::new();
            }
            for mode in layer.modes.values() {
                own.extend(motions(program, robot, mode.lasting()));
                all.extend(motions(program, robot, mode.commands()));
                seen.extend(looks_of_mode(program, layer, mode));
            }
        }
    }
    seen.extend(conditions.into_iter().flat_map(|condition| looks(program, diagram, condition)));
    scene.reactions(None, &own, &all, &seen, u64::MAX)
}

/// The longest tick of the scenarios that run a diagram, in nanoseconds; 0 where none does: then ticks are taken to be
/// short.
fn tick(program: &Program, diagram: Id<Diagram>) -> u64 {
    let runs = program.scenarios.values().filter(|scenario| scenario.diagram == diagram);
    runs.map(|scenario| scenario.tick).max().unwrap_or(0)
}

/// The shortest time after which a mode may be left whatever is in the way, in nanoseconds.
fn deadline(program: &Program, mode: &Mode) -> u64 {
    let conditions = mode.transitions.iter().map(|exit| exit.condition);
    let parts = conditions.flat_map(|condition| super::modes::parts(program, condition));
    let times = parts.filter_map(|part| match program.exprs[part].op {
        Op::After(time) => Some(time),
        _ => None,
    });
    times.min().unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_shown_with_three_digits() {
        let unit = Unit::parse("m").unwrap();
        assert_eq!([0.043, 0.123_456, 12.345, 0.0].map(|si| round(&unit, si)), ["0.043 m", "0.123 m", "12.3 m", "0 m"]);
    }
}
