//! Networks over columns of readings, for logs and tuning.

use proc_macro2::TokenStream;
use quote::quote;

use super::names::{Scope, plain};
use super::network::Network;
use super::{Emission, inference, layout};

/// The function that evaluates row by row what is kept in columns, in a loop that vectorizes: nothing in it waits for the
/// row before. A network that remembers has none.
pub(super) fn evaluate(emission: Emission<'_>, network: &Network<'_>) -> Option<TokenStream> {
    if network.remembers() || network.events.is_empty() && network.outputs.is_empty() {
        return None;
    }
    let (float, blank) = (emission.float(), layout::blank());
    let mut scope = Scope::new(&["events", "outputs"]);
    let inputs: Vec<_> = network.inputs.iter().map(|name| scope.snake(&plain(name))).collect();
    let (mut columns, mut kinds, mut stores) = (inputs.clone(), vec![quote! { &[#float] }; inputs.len()], Vec::new());
    for event in &network.events {
        let column = scope.snake(&plain(event));
        stores.push(quote! { *#column = events.#event; });
        columns.push(column);
        kinds.push(quote! { &mut [bool] });
    }
    for output in &network.outputs {
        let (value, fired) = (scope.snake(&plain(output)), scope.snake(&format!("{}_fired", plain(output))));
        stores.push(quote! { *#value = outputs.#output.value; *#fired = outputs.#output.fired; });
        columns.extend([value, fired]);
        kinds.extend([quote! { &mut [#float] }, quote! { &mut [bool] }]);
    }
    let safe = inference::safe(emission, network, &|index| {
        let name = &inputs[index];
        quote! { *#name }
    });
    let (first, rest) = columns.split_first()?;
    let pattern = rest.iter().fold(quote! { #first }, |before, column| quote! { (#before, #column) });
    let events = (!network.events.is_empty()).then(|| quote! { let events = weigh(#safe).events(); });
    let outputs = network.has_outputs().then(|| quote! { let outputs = infer(#safe); });
    Some(quote! {
        #blank
        /// The same for columns of readings, as many rows as the shortest column has.
        pub fn evaluate_columns(#(#columns: #kinds),*) {
            for #pattern in #first.iter() #(.zip(#rest))* {
                #events
                #outputs
                #(#stores)*
            }
        }
    })
}
