//! The plan of a network on its own.

use super::builder::Builder;
use super::{Checked, Event, NetworkPlan, input, origin};
use crate::base::Id;
use crate::ir;

/// The plan of a network with a reading for each of its inputs. Linear in its size.
pub fn build_network(checked: Checked<'_>, network: Id<ir::Network>) -> NetworkPlan {
    let program = checked.program;
    let declared = &program.networks[network];
    let mut builder = Builder::new(program);
    let readings: Vec<_> = (0..declared.inputs.len() as u32).map(|input| builder.read(input)).collect();
    let degrees = declared
        .inputs
        .iter()
        .zip(&readings)
        .map(|(input, &reading)| {
            let terms = program.variables[input.variable].terms.iter().zip(0..);
            terms
                .map(|(term, position)| (term.symbol.name.clone(), builder.degree(reading, input.variable, position)))
                .collect()
        })
        .collect();
    let slots = builder.events(network, &readings);
    let (mut events, mut strengths) = (Vec::new(), Vec::new());
    for (event, slots) in declared.events.iter().zip(slots) {
        let (contributor, detractor, flag) = (slots.contributor, slots.detractor, slots.flag);
        let (name, origin) = (event.symbol.name.clone(), origin(&event.symbol));
        events.push(Event { name, origin, contributor, detractor, flag });
        strengths.push(slots.strengths);
    }
    let outputs = builder.outputs(network, &readings);
    let inputs = declared.inputs.iter().map(|declared| {
        let variable = &program.variables[declared.variable];
        input(&declared.symbol, &variable.unit, variable.range, &[&variable.fails])
    });
    let spans = |rules: &[ir::Rule]| rules.iter().map(|rule| rule.span).collect();
    NetworkPlan {
        position: network.index() as u32,
        name: declared.symbol.name.clone(),
        origin: origin(&declared.symbol),
        inputs: inputs.collect(),
        code: builder.code,
        degrees,
        strengths,
        rules: declared.events.iter().map(|event| (spans(&event.contributor), spans(&event.detractor))).collect(),
        events,
        outputs,
    }
}
