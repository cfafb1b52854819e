//! Logical sensors that find the widest opening around a robot (Khatoon and Ibraheem 2012, section 2.1).

use super::sensors::plain;
use super::{Lower, invalid, missing_part, symbol};
use crate::base::{Dimension, Exact, Id, Span, Unit};
use crate::ir::{self, Grouping, SensorSource};
use crate::syntax::ast;

/// The function that finds it.
pub(super) const WIDEST: &str = "widest";

impl Lower<'_> {
    /// The widest opening among neighboring beams of a ring.
    pub(super) fn widest(
        &mut self,
        tree: &ast::Logical,
        call: &ast::Call,
        sensors: &[Id<ir::Sensor>],
        groups: &[&str],
    ) -> Option<ir::Sensor> {
        let is_beyond = |argument: &&ast::Argument| argument.name.as_ref().is_some_and(|name| name.text == "beyond");
        let beams = call.arguments.iter().filter(|argument| !is_beyond(argument));
        let of = self.members_of(call, beams, sensors, groups)?;
        let Some(ast::Argument { value: ast::Expr { kind: ast::ExprKind::Quantity(beyond), .. }, .. }) =
            call.arguments.iter().find(is_beyond)
        else {
            let diagnostic = missing_part(call.span, "nothing says how far an opening reaches");
            self.report(diagnostic.help("write a distance behind the beams, as in `widest(range, beyond: 5 m)`"));
            return None;
        };
        let beyond = self.quantity_of(beyond, Dimension::LENGTH, None)?;
        let Some((first, spacing)) = self.fan(&of) else {
            let diagnostic = invalid(call.span, "an opening lies among neighboring beams of one ring");
            self.report(diagnostic.help(
                "name sensors of one array with `= ring.range`, each to the left of the one before, as in `range[18..23, 0..5]`",
            ));
            return None;
        };
        let readings = self.counts(tree.within.as_ref(), &of)?;
        let half_turn = Exact::new(1, 1, 1);
        let degree = Unit { text: "deg".to_owned(), scale: Exact::new(1, 180, 1), dimension: Dimension::ANGLE };
        let range = (Exact::ZERO.minus(half_turn)?, half_turn);
        Some(ir::Sensor {
            fails: self.fan_fails(&of, first, spacing),
            group: Some(ir::Group { how: Grouping::Widest { beyond, first, spacing }, of, readings }),
            ..plain(symbol(&tree.name, tree.doc.as_ref()), false, degree, range)
        })
    }

    /// The bearing of the first of some neighboring beams, above -π up to π, and the angle from each to the next; `None`
    /// where they are no neighbors.
    fn fan(&self, of: &[Id<ir::Sensor>]) -> Option<(Exact, Exact)> {
        let beam = |id: &Id<ir::Sensor>| match self.program.sensors[*id].source {
            Some(SensorSource::Range { beam, of }) => Some((beam, of, self.program.sensors[*id].symbol.span)),
            _ => None,
        };
        let beams: Vec<_> = of.iter().map(beam).collect::<Option<_>>()?;
        let &(first, count, ring) = beams.first()?;
        let is_next = |(place, &(beam, of, array)): (u32, &(u32, u32, Span))| {
            array == ring && of == count && beam == (first + place) % count
        };
        if count < 2 || !(0..).zip(&beams).all(is_next) {
            return None;
        }
        let spacing = Exact::new(2, count.into(), 1);
        let turned = 2 * i128::from(first) + 1;
        let turned = if turned > count.into() { turned - 2 * i128::from(count) } else { turned };
        Some((Exact::new(turned, count.into(), 1), spacing))
    }

    /// What an opening is taken to be when all beams have failed alike: the whole fan, which a ring has straight ahead.
    fn fan_fails(&self, of: &[Id<ir::Sensor>], first: Exact, spacing: Exact) -> Vec<ir::FailReading> {
        let mut fails = of.iter().map(|&id| self.program.sensors[id].fails.first());
        let Some(Some(ir::FailReading::Value(alike))) = fails.next() else { return Vec::new() };
        if !fails.all(|other| other == Some(&ir::FailReading::Value(*alike))) {
            return Vec::new();
        }
        let across = spacing.times(Exact::new(of.len() as i128 - 1, 2, 0));
        let middle = across.and_then(|across| first.plus(across));
        let is_ring = spacing.times(Exact::new(of.len() as i128, 2, 0)) == Some(Exact::new(1, 1, 1));
        let bearing = if is_ring { Some(Exact::ZERO) } else { middle };
        bearing.map(ir::FailReading::Value).into_iter().collect()
    }
}
