//! Interfaces, and those that they extend.

use super::robots::Carrier;
use super::sensors::declared_name;
use super::{Lower, duplicate, invalid, named, symbol};
use crate::base::Id;
use crate::ir;
use crate::syntax::ast;

impl<'a> Lower<'a> {
    /// Adds an interface, and those that it extends where they have not been added yet.
    pub(super) fn interface(&mut self, tree: &'a ast::Interface) {
        let Some(chain) = self.chain(tree, Self::find_interface_tree) else { return };
        let mut extended = None;
        for tree in chain {
            let known = self.scopes.interfaces.get(&tree.name.span).copied();
            extended = Some(known.unwrap_or_else(|| self.own_interface(tree, extended)));
        }
    }

    fn own_interface(&mut self, tree: &ast::Interface, extended: Option<Id<ir::Interface>>) -> Id<ir::Interface> {
        let (mut sensors, mut actions) = (Vec::new(), Vec::new());
        if let Some(ir::Interface { sensors: promised, actions: others, .. }) =
            extended.map(|extended| &self.program.interfaces[extended])
        {
            (sensors, actions) = (promised.clone(), others.clone());
        }
        let within = std::mem::replace(&mut self.within, tree.span);
        let members = self.members(&tree.items, Carrier::Interface);
        if let Some((_, span)) = members.body {
            self.report(invalid(span, "an interface has no body").help("bodies belong to robots"));
        }
        self.check_promised_once(&tree.items, &sensors, &actions);
        self.within = within;
        sensors.extend(members.sensors);
        actions.extend(members.actions);
        let symbol = symbol(&tree.name, tree.doc.as_ref());
        let id = self.program.interfaces.add(ir::Interface { symbol, extends: extended, sensors, actions });
        self.scopes.interfaces.insert(tree.name.span, id);
        id
    }

    /// Reports what an interface promises though what it extends does already.
    fn check_promised_once(
        &mut self,
        items: &[ast::RobotItem],
        sensors: &[Id<ir::Sensor>],
        actions: &[Id<ir::Action>],
    ) {
        let program = &self.program;
        let twice = items.iter().filter_map(|item| match item {
            ast::RobotItem::Sensor(ast::Sensor { name, .. }) => {
                let mut promised = sensors.iter().map(|&id| &program.sensors[id].symbol);
                let first = promised.find(|first| declared_name(&first.name) == name.text)?;
                Some(duplicate(name, first.span, "sensor"))
            }
            ast::RobotItem::Action(ast::Action { name, .. }) => {
                let first = named(&name.text, actions, |id| &program.actions[id].symbol)?;
                Some(duplicate(name, program.actions[first].symbol.span, "action"))
            }
            _ => None,
        });
        let twice: Vec<_> = twice.collect();
        self.diagnostics.extend(twice);
    }

    /// Interfaces with those that they extend, each once.
    pub(super) fn with_extended(&self, interfaces: impl Iterator<Item = Id<ir::Interface>>) -> Vec<Id<ir::Interface>> {
        let mut found = Vec::new();
        for interface in interfaces {
            let mut next = Some(interface);
            while let Some(id) = next.filter(|id| !found.contains(id)) {
                found.push(id);
                next = self.program.interfaces[id].extends;
            }
        }
        found
    }
}
