//! From the strengths of sets to a number, in the interpreter's order of sums.

use std::ops::Range;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::graph::{Node, part};
use super::inference::Inference;
use super::names::plain;
use super::outputs::functions;
use super::polynomial::{self, Signed};
use super::{Emission, layout};
use crate::plan::{Aggregation, Find, Implication, Real, Slab, Step};

/// How a number comes of strengths that have names.
#[derive(Default)]
pub(super) struct Number {
    /// The constants of the module that it takes.
    pub(super) constants: TokenStream,
    pub(super) statements: TokenStream,
    pub(super) value: TokenStream,
}

/// The number that a step computes.
pub(super) fn number(emission: Emission<'_>, inference: &mut Inference<'_>, output: &Ident, of: Node) -> Number {
    let code = inference.graph.code;
    match &code.steps[of] {
        Step::Centroid { slabs, center, .. } => {
            centroid(emission, inference, output, part(&code.slabs, slabs), *center)
        }
        Step::Outline { find, implication, aggregation, stretches, strengths, .. } => {
            let float = emission.float();
            let stretches = part(&code.stretches, stretches);
            let rows = stretches.iter().map(|stretch| {
                let [from, to] = [stretch.from, stretch.to].map(|at| emission.number(at));
                let lines = part(&code.points, &stretch.lines).iter().map(|&(start, end)| {
                    let [start, end] = [start, end].map(|degree| emission.number(degree));
                    quote! { (#start, #end) }
                });
                quote! { (#from, #to, &[#(#lines),*]) }
            });
            let (name, count) = (constant(inference, output, "stretches"), Literal::usize_unsuffixed(stretches.len()));
            let doc = layout::doc(&[&format!(
                "Stretches on which all sets of `{}` are straight: ends, and degrees at both.",
                plain(output)
            )]);
            let constants =
                quote! { #doc const #name: [(#float, #float, &[(#float, #float)]); #count] = [#(#rows),*]; };
            let (function, which) = match find {
                Find::Centroid => ("outline_centroid", None),
                Find::Bisector => ("bisector", None),
                Find::SmallestOfMaximum => ("maxima", Some(quote! { .0 })),
                Find::LargestOfMaximum => ("maxima", Some(quote! { .1 })),
                Find::MeanOfMaximum => ("maxima", Some(quote! { .2 })),
            };
            let function = format_ident!("{function}");
            let (strengths, [imply, join]) = (listed(inference, strengths), how(*implication, *aggregation));
            let value = quote! { kernel::#function(#name.iter().copied(), &[#strengths], #imply, #join) #which };
            Number { constants, value, ..Number::default() }
        }
        Step::Midpoints { implication, aggregation, samples, strengths, low, high, .. } => {
            let float = emission.float();
            let sets = inference.graph.real_list(strengths).len();
            let parts = part(&code.samples, samples).chunks_exact(sets.max(1)).map(|degrees| {
                let degrees = degrees.iter().map(|&degree| emission.number(degree));
                quote! { &[#(#degrees),*] }
            });
            let (parts, name) = (parts.collect::<Vec<_>>(), constant(inference, output, "parts"));
            let count = Literal::usize_unsuffixed(parts.len());
            let doc =
                layout::doc(&[&format!("Degrees of the sets of `{}` in equal parts of its range.", plain(output))]);
            let constants = quote! { #doc const #name: [&[#float]; #count] = [#(#parts),*]; };
            let (strengths, [imply, join]) = (listed(inference, strengths), how(*implication, *aggregation));
            let [low, high] = [low, high].map(|&end| emission.number(end));
            let value = quote! { kernel::midpoints(#name.iter().copied(), &[#strengths], #imply, #join, #low, #high) };
            Number { constants, value, ..Number::default() }
        }
        Step::Mean { weights, values, .. } => {
            let (weights, values) = (inference.graph.real_list(weights), inference.graph.real_list(values));
            let products = weights.iter().zip(values).map(|(&weight, &value)| {
                let (weight, value) = (inference.operand(weight), linear(emission, inference, value));
                quote! { #weight * #value }
            });
            let zero = emission.number(0.0);
            let weighted = quote! { #zero #(+ #products)* };
            let weights = weights.iter().map(|&weight| inference.operand(weight));
            let value = quote! { kernel::weighted_mean(#zero #(+ #weights)*, #weighted) };
            Number { value, ..Number::default() }
        }
        _ => Number { value: emission.number(0.0), ..Number::default() },
    }
}

/// A new name for a constant of an output.
fn constant(inference: &mut Inference<'_>, output: &Ident, what: &str) -> Ident {
    let name = inference.scope.snake(&format!("{}_{what}", plain(output)));
    format_ident!("{}", plain(&name).to_uppercase())
}

fn listed(inference: &Inference<'_>, of: &Range<u32>) -> TokenStream {
    let values = inference.graph.real_list(of).iter().map(|&real| inference.operand(real));
    quote! { #(#values),* }
}

fn how(implication: Implication, aggregation: Aggregation) -> [TokenStream; 2] {
    let imply = match implication {
        Implication::Minimum => "minimum",
        Implication::Product => "product",
    };
    let join = match aggregation {
        Aggregation::Maximum => "maximum",
        Aggregation::Sum => "sum",
    };
    functions([imply, join])
}

/// A linear expression of inputs.
fn linear(emission: Emission<'_>, inference: &Inference<'_>, value: Real) -> TokenStream {
    let Some(node) = inference.graph.real(value) else { return TokenStream::new() };
    let Step::Linear { constant, factors, .. } = &inference.graph.code.steps[node] else { return TokenStream::new() };
    let constant = emission.number(*constant);
    let products = part(&inference.graph.code.factors, factors).iter().map(|&(real, factor)| {
        let (input, times) = (inference.operand(real), emission.number(factor.abs()));
        let product = if factor.abs() == 1.0 {
            input
        } else {
            quote! { #input * #times }
        };
        if factor < 0.0 {
            quote! { - #product }
        } else {
            quote! { + #product }
        }
    });
    if factors.is_empty() {
        constant
    } else {
        quote! { (#constant #(#products)*) }
    }
}

/// The center of area: what slabs hold, as polynomials with fixed factors. Factors of 0 are left out, and limits that no
/// strength can pass; it is the same to the last bit.
fn centroid(
    emission: Emission<'_>,
    inference: &mut Inference<'_>,
    output: &Ident,
    slabs: &[Slab],
    center: f64,
) -> Number {
    let strengths: Vec<Real> = slabs.iter().map(|slab| slab.strength).collect();
    let mut statements = inference.strengths(&strengths, output);
    let (mut areas, mut moments) = (Vec::<Signed>::new(), Vec::<Signed>::new());
    for slab in slabs {
        let height = height(emission, inference, slab, &mut statements);
        areas.extend(polynomial::without_constant(emission, &height, &[slab.area.0, slab.area.1]));
        let (linear, square, cube) = slab.moment;
        moments.extend(polynomial::without_constant(emission, &height, &[linear, square, cube]));
    }
    let [area, moment] = ["area", "moment"].map(|what| inference.scope.snake(&format!("{}_{what}", plain(output))));
    let [areas, moments] = [areas, moments].map(|terms| polynomial::sum(emission, &terms));
    let center = emission.number(center);
    statements.extend(quote! { let #area = #areas; let #moment = #moments; });
    let value = quote! { #center + kernel::weighted_mean(#area, #moment) };
    Number { statements, value, ..Number::default() }
}

/// How far a strength reaches into a slab, under a name of its own where that is not the strength itself.
fn height(
    emission: Emission<'_>,
    inference: &mut Inference<'_>,
    slab: &Slab,
    statements: &mut TokenStream,
) -> TokenStream {
    let strength = inference.operand(slab.strength);
    let is_degree = inference.graph.real(slab.strength).is_some_and(|node| inference.is_degree(node));
    let [floor, thickness] = [slab.floor, slab.thickness].map(|degree| emission.number(degree));
    let reach = match (is_degree && slab.floor == 0.0, slab.thickness >= 1.0) {
        (true, true) => return strength,
        (true, false) => quote! { kernel::minimum(#strength, #thickness) },
        (false, _) => quote! { kernel::reach(#strength, #floor, #thickness) },
    };
    let name = inference.scope.snake(&format!("{strength}_reach"));
    statements.extend(quote! { let #name = #reach; });
    quote! { #name }
}
