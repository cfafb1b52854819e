//! Polynomials with fixed factors as straight-line code.

use proc_macro2::TokenStream;
use quote::quote;

use super::Emission;

/// An expression, or its negative: to negate changes no other bit of any sum, difference or product.
pub(super) struct Signed {
    is_negative: bool,
    tokens: TokenStream,
    /// Whether it stands in parentheses when it is multiplied.
    is_compound: bool,
}

/// `height * (f0 + height * (f1 + ..))` without the factors that are 0; `None` where all are.
pub(super) fn without_constant(emission: Emission<'_>, height: &TokenStream, factors: &[f64]) -> Option<Signed> {
    let inner = nested(emission, height, factors)?;
    let Signed { is_negative, tokens, is_compound } = inner;
    let inner = if is_compound {
        quote! { (#tokens) }
    } else {
        tokens
    };
    Some(Signed { is_negative, tokens: quote! { #height * #inner }, is_compound: true })
}

fn nested(emission: Emission<'_>, height: &TokenStream, factors: &[f64]) -> Option<Signed> {
    let (&first, rest) = factors.split_first()?;
    let rest = without_constant(emission, height, rest);
    if first == 0.0 {
        return rest;
    }
    let (is_negative, first) = (first < 0.0, emission.number(first.abs()));
    Some(match rest {
        None => Signed { is_negative, tokens: first, is_compound: false },
        Some(Signed { is_negative: is_rest_negative, tokens, .. }) => {
            let sign = if is_rest_negative == is_negative {
                quote! { + }
            } else {
                quote! { - }
            };
            Signed { is_negative, tokens: quote! { #first #sign #tokens }, is_compound: true }
        }
    })
}

/// The sum of terms in their order; 0 of none.
pub(super) fn sum(emission: Emission<'_>, terms: &[Signed]) -> TokenStream {
    let terms =
        terms.iter().enumerate().map(|(index, Signed { is_negative, tokens, .. })| match (index, is_negative) {
            (0, false) => quote! { #tokens },
            (0, true) => quote! { -(#tokens) },
            (_, false) => quote! { + #tokens },
            (_, true) => quote! { - #tokens },
        });
    let terms: Vec<_> = terms.collect();
    if terms.is_empty() {
        emission.number(0.0)
    } else {
        quote! { #(#terms)* }
    }
}
