//! Worlds, scenarios and properties.

use super::grammar::{Pair, Parts, Rule};
use super::tree::Tree;
use crate::syntax::ast::{
    BoxItem, Expect, ExpectKind, ExpectWindow, FaultWindow, PlaceAt, Point, Property, PropertyKind, Scenario,
    ScenarioItem, SensorRef, World, WorldItem,
};

impl Tree<'_> {
    pub fn world(&mut self, pair: Pair<'_>) -> Option<World> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.world_head(parts.take(Rule::world_head)?)?;
        let items = parts.take_all(Rule::world_item).map(|item| self.world_item(item)).collect::<Option<_>>()?;
        Some(World { items, span, ..head })
    }

    /// A world without its items.
    pub fn world_head(&mut self, pair: Pair<'_>) -> Option<World> {
        let span = self.span(&pair);
        Some(World { doc: self.doc(span), name: self.clause_name(pair)?, items: Vec::new(), span })
    }

    pub fn world_item(&mut self, pair: Pair<'_>) -> Option<WorldItem> {
        let item = Parts::of(pair).next()?;
        let span = self.span(&item);
        match item.as_rule() {
            Rule::wall => {
                let mut parts = Parts::of(item);
                let points = parts.take_all(Rule::point).map(|point| self.point(point)).collect::<Option<_>>()?;
                Some(WorldItem::Wall { points, span })
            }
            Rule::door => {
                let mut parts = Parts::of(item);
                let at = self.point(parts.take(Rule::point)?)?;
                let width = self.next_quantity(&mut parts)?;
                let heading = self.optional_quantity(&mut parts, Rule::heading)?;
                Some(WorldItem::Door { at, width, heading, open: parts.take(Rule::open).is_some(), span })
            }
            Rule::box_item => self.box_item(item).map(WorldItem::Box),
            _ => self.point(Parts::of(item).take(Rule::point)?).map(WorldItem::Goal),
        }
    }

    fn point(&mut self, pair: Pair<'_>) -> Option<Point> {
        let span = self.span(&pair);
        let (x, y) = self.pair_of_quantities(pair)?;
        Some(Point { x, y, span })
    }

    fn box_item(&mut self, pair: Pair<'_>) -> Option<BoxItem> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = match parts.take(Rule::box_name) {
            Some(name) => Some(self.clause_name(name)?),
            None => None,
        };
        let mass = self.next_quantity(&mut parts)?;
        let size = self.pair_of_quantities(parts.take(Rule::size)?)?;
        Some(BoxItem { name, mass, size, place: self.place_at(parts.take(Rule::place_at)?)?, span })
    }

    fn place_at(&mut self, pair: Pair<'_>) -> Option<PlaceAt> {
        let mut parts = Parts::of(pair);
        match parts.take(Rule::point) {
            Some(point) => {
                let at = self.point(point)?;
                Some(PlaceAt::Point { at, heading: self.optional_quantity(&mut parts, Rule::heading)? })
            }
            None => self.next_quantity(&mut parts).map(PlaceAt::Ahead),
        }
    }

    pub fn scenario(&mut self, pair: Pair<'_>) -> Option<Scenario> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.scenario_head(parts.take(Rule::scenario_head)?)?;
        let items = parts.take_all(Rule::scenario_item).map(|item| self.scenario_item(item));
        Some(Scenario { items: items.collect::<Option<_>>()?, span, ..head })
    }

    /// A scenario without its items.
    pub fn scenario_head(&mut self, pair: Pair<'_>) -> Option<Scenario> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        let (mut runs, mut on, mut within, mut extends) = (None, None, None, None);
        while let Some(clause) = parts.next() {
            let place = self.span(&clause);
            let (slot, word) = match clause.as_rule() {
                Rule::runs_clause => (&mut runs, "runs"),
                Rule::on_clause => (&mut on, "on"),
                Rule::in_clause => (&mut within, "in"),
                _ => (&mut extends, "extends"),
            };
            let name = self.clause_name(clause)?;
            self.once(slot, name, place, word);
        }
        Some(Scenario { doc: self.doc(span), name, runs, on, within, extends, items: Vec::new(), span })
    }

    pub fn scenario_item(&mut self, pair: Pair<'_>) -> Option<ScenarioItem> {
        let item = Parts::of(pair).next()?;
        let span = self.span(&item);
        match item.as_rule() {
            Rule::duration => Some(ScenarioItem::Duration(self.clause_quantity(item)?, span)),
            Rule::tick => Some(ScenarioItem::Tick(self.clause_quantity(item)?, span)),
            Rule::seed => Some(ScenarioItem::Seed(self.number(&Parts::of(item).take(Rule::unsigned)?), span)),
            Rule::place => self.placement(item),
            Rule::fault => {
                let mut parts = Parts::of(item);
                let sensor = self.sensor_ref(parts.take(Rule::sensor_ref)?)?;
                let reading = self.fail_reading(parts.take(Rule::fail_reading)?)?;
                Some(ScenarioItem::Fault { sensor, reading, window: self.fault_window(&mut parts)?, span })
            }
            Rule::fail => {
                let mut parts = Parts::of(item);
                let sensor = self.sensor_ref(parts.take(Rule::sensor_ref)?)?;
                Some(ScenarioItem::Fail { sensor, window: self.fault_window(&mut parts)?, span })
            }
            _ => self.expectation(item).map(ScenarioItem::Expect),
        }
    }

    fn placement(&mut self, pair: Pair<'_>) -> Option<ScenarioItem> {
        let span = self.span(&pair);
        let placed = Parts::of(pair).next()?;
        if placed.as_rule() == Rule::box_item {
            return self.box_item(placed).map(ScenarioItem::PlaceBox);
        }
        let mut parts = Parts::of(placed);
        let robot = match parts.take(Rule::robot_name) {
            Some(name) => Some(self.clause_name(name)?),
            None => None,
        };
        Some(ScenarioItem::PlaceRobot { robot, place: self.place_at(parts.take(Rule::place_at)?)?, span })
    }

    fn sensor_ref(&mut self, pair: Pair<'_>) -> Option<SensorRef> {
        let mut parts = Parts::of(pair);
        let path = self.path(parts.take(Rule::path)?);
        let indices = match parts.take(Rule::indices) {
            Some(indices) => self.indices(indices)?,
            None => Vec::new(),
        };
        Some(SensorRef { path, indices })
    }

    fn fault_window(&mut self, parts: &mut Parts<'_>) -> Option<FaultWindow> {
        let from = self.optional_quantity(parts, Rule::from)?;
        Some(FaultWindow { from, to: self.optional_quantity(parts, Rule::to)? })
    }

    fn expectation(&mut self, pair: Pair<'_>) -> Option<Expect> {
        let span = self.span(&pair);
        let claim = Parts::of(pair).next()?;
        let rule = claim.as_rule();
        let mut parts = Parts::of(claim);
        let kind = match rule {
            Rule::expect_modes => ExpectKind::Modes(self.names(parts.take(Rule::names)?)),
            Rule::expect_transition => ExpectKind::Transition {
                from: self.next_name(&mut parts)?,
                to: self.next_name(&mut parts)?,
                within: self.optional_range(&mut parts, Rule::within)?,
            },
            Rule::expect_never => ExpectKind::Never {
                condition: self.expression(parts.take(Rule::expression)?)?,
                window: self.expect_window(&mut parts)?,
            },
            Rule::expect_always => ExpectKind::Always {
                condition: self.expression(parts.take(Rule::expression)?)?,
                window: self.expect_window(&mut parts)?,
            },
            _ => ExpectKind::Within {
                condition: self.expression(parts.take(Rule::expression)?)?,
                window: self.optional_range(&mut parts, Rule::within)?,
            },
        };
        Some(Expect { kind, span })
    }

    fn expect_window(&mut self, parts: &mut Parts<'_>) -> Option<ExpectWindow> {
        let Some(window) = parts.next() else { return Some(ExpectWindow::Whole) };
        match window.as_rule() {
            Rule::before => self.clause_quantity(window).map(ExpectWindow::Before),
            Rule::since => self.clause_quantity(window).map(ExpectWindow::After),
            _ => self.range(Parts::of(window).take(Rule::range)?).map(ExpectWindow::Within),
        }
    }

    pub fn property(&mut self, pair: Pair<'_>) -> Option<Property> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let mut head = Parts::of(parts.take(Rule::property_head)?);
        let name = self.next_name(&mut head)?;
        let of = match head.take(Rule::of_clause) {
            Some(of) => Some(self.clause_name(of)?),
            None => None,
        };
        let claim = parts.next()?;
        let rule = claim.as_rule();
        let mut parts = Parts::of(claim);
        let condition = self.expression(parts.take(Rule::expression)?)?;
        let kind = match rule {
            Rule::claim_never => PropertyKind::Never(condition),
            Rule::claim_always => PropertyKind::Always(condition),
            _ => PropertyKind::LeadsTo {
                cause: condition,
                effect: self.expression(parts.take(Rule::expression)?)?,
                within: self.optional_quantity(&mut parts, Rule::time_limit)?,
            },
        };
        Some(Property { doc: self.doc(span), name, of, kind, span })
    }
}
