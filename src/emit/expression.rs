//! One step as one expression.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::graph::{Graph, part};
use super::layout::number;
use super::{Emission, Float};
use crate::plan::{Comparison, Input, Shape};

/// An expression, and what holds it together.
#[derive(Debug, Clone)]
pub(super) struct Expression {
    tokens: TokenStream,
    binding: Binding,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Binding {
    /// A name, a call, a literal, or one of these with an operator in front.
    Whole,
    Comparison,
    And,
    Or,
}

impl Expression {
    pub(super) fn whole(tokens: TokenStream) -> Self {
        Self { tokens, binding: Binding::Whole }
    }

    pub(super) fn comparison(tokens: TokenStream) -> Self {
        Self { tokens, binding: Binding::Comparison }
    }

    /// As it stands on its own.
    pub(super) fn tokens(&self) -> TokenStream {
        self.tokens.clone()
    }

    /// In parentheses unless it is bound by one of these.
    fn within(&self, clear: &[Binding]) -> TokenStream {
        let tokens = &self.tokens;
        if clear.contains(&self.binding) {
            quote! { #tokens }
        } else {
            quote! { (#tokens) }
        }
    }
}

pub(super) fn not(of: &Expression) -> Expression {
    let of = of.within(&[Binding::Whole]);
    Expression::whole(quote! { !#of })
}

/// `&&` between operands; true without any.
pub(super) fn all(of: &[Expression]) -> Expression {
    let empty = Expression::whole(quote! { true });
    joined(of, Binding::And, &quote! { && }).unwrap_or(empty)
}

/// `||` between operands; false without any.
pub(super) fn any(of: &[Expression]) -> Expression {
    let empty = Expression::whole(quote! { false });
    joined(of, Binding::Or, &quote! { || }).unwrap_or(empty)
}

fn joined(of: &[Expression], binding: Binding, operator: &TokenStream) -> Option<Expression> {
    /// More operands than this are put in parentheses by halves, so that what reads the text needs no deep stack.
    const MANY: usize = 64;
    let clear = [Binding::Whole, Binding::Comparison, binding];
    match of {
        [only] => Some(only.clone()),
        of if of.len() > MANY => {
            let (left, right) = of.split_at(of.len() / 2);
            let [left, right] = [left, right].map(|half| joined(half, binding, operator));
            let (left, right) = (left?.tokens, right?.tokens);
            Some(Expression { tokens: quote! { (#left) #operator (#right) }, binding })
        }
        of => {
            let (first, rest) = of.split_first()?;
            let (first, rest) = (first.within(&clear), rest.iter().map(|operand| operand.within(&clear)));
            Some(Expression { tokens: quote! { #first #(#operator #rest)* }, binding })
        }
    }
}

pub(super) fn compare(comparison: Comparison, left: &Expression, right: &Expression) -> Expression {
    let (left, right) = (left.tokens(), right.tokens());
    Expression::comparison(match comparison {
        Comparison::Less => quote! { #left < #right },
        Comparison::LessOrEqual => quote! { #left <= #right },
        Comparison::Greater => quote! { #left > #right },
        Comparison::GreaterOrEqual => quote! { #left >= #right },
        Comparison::Equal => quote! { #left == #right },
        Comparison::NotEqual => quote! { #left != #right },
    })
}

impl Emission<'_> {
    pub(super) fn number(self, value: f64) -> TokenStream {
        number(value, self.options.float)
    }

    /// A counter as a number.
    pub(super) fn counted(self, counter: &TokenStream) -> TokenStream {
        match self.options.float {
            Float::F64 => quote! { f64::from(#counter) },
            Float::F32 => quote! { (#counter as f32) },
        }
    }

    /// A reading made safe.
    pub(super) fn sanitized(self, reading: &TokenStream, healthy: &TokenStream, input: &Input) -> TokenStream {
        let [low, high, fail] = [input.low, input.high, input.fail].map(|value| self.number(value));
        quote! { kernel::sanitize(#reading, #healthy, #low, #high, #fail) }
    }

    /// A degree of membership.
    pub(super) fn degree(self, of: &TokenStream, shape: &Shape, graph: &Graph<'_>) -> TokenStream {
        let numbers = |numbers: &[f64]| numbers.iter().map(|&value| self.number(value)).collect::<Vec<_>>();
        let (function, numbers) = match shape {
            Shape::Ramp { zero_at, one_at } => ("ramp", numbers(&[*zero_at, *one_at])),
            Shape::Triangle(of) => ("triangle", numbers(of)),
            Shape::Trapezoid(of) => ("trapezoid", numbers(of)),
            Shape::Rectangle(of) => ("rectangle", numbers(of)),
            Shape::Singleton(at) => ("singleton", numbers(&[*at])),
            Shape::Points(span) => {
                let points = part(&graph.code.points, span).iter().map(|&(at, degree)| {
                    let (at, degree) = (self.number(at), self.number(degree));
                    quote! { (#at, #degree) }
                });
                ("points", vec![quote! { &[#(#points),*] }])
            }
            Shape::Gaussian(of) => ("gaussian", numbers(of)),
            Shape::Gaussian2(of) => ("gaussian2", numbers(of)),
            Shape::Bell(of) => ("bell", numbers(of)),
            Shape::Sigmoid(of) => ("sigmoid", numbers(of)),
            Shape::Rise(of) => ("rise", numbers(of)),
            Shape::Fall(of) => ("fall", numbers(of)),
            Shape::RiseAndFall(of) => ("rise_and_fall", numbers(of)),
            Shape::Cosine(of) => ("cosine", numbers(of)),
        };
        let function = format_ident!("{function}");
        quote! { kernel::#function(#of, #(#numbers),*) }
    }
}
