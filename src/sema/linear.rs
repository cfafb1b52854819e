//! Linear expressions of a network's inputs.

use std::collections::BTreeMap;

use super::quantities::{mismatch, too_long};
use super::{Lower, invalid};
use crate::base::{Dimension, Exact, Unit};
use crate::ir;
use crate::syntax::ast::{Expr, ExprKind, Factor, Sign};

/// An expression as far as it is known: a constant, and the factor of each input, in SI.
struct Form {
    dimension: Dimension,
    constant: Exact,
    factors: BTreeMap<u32, Exact>,
}

impl Form {
    fn constant(constant: Exact, dimension: Dimension) -> Self {
        Self { dimension, constant, factors: BTreeMap::new() }
    }

    /// Each number of it, changed; `None` where one cannot be kept exactly.
    fn map(self, change: impl Fn(Exact) -> Option<Exact>) -> Option<Self> {
        let factors = self.factors.into_iter().map(|(input, factor)| Some((input, change(factor)?)));
        Some(Self { constant: change(self.constant)?, factors: factors.collect::<Option<_>>()?, ..self })
    }

    fn plus(mut self, other: Self) -> Option<Self> {
        self.constant = self.constant.plus(other.constant)?;
        for (input, factor) in other.factors {
            let sum = self.factors.get(&input).map_or(Some(factor), |known| known.plus(factor))?;
            self.factors.insert(input, sum);
        }
        Some(self)
    }
}

impl Lower<'_> {
    /// A linear expression of a unit's dimension. A number that stands alone between signs takes the unit.
    pub(super) fn linear(&mut self, tree: &Expr, network: &ir::Network, unit: &Unit) -> Option<ir::Linear> {
        let form = self.form(tree, network, Some(unit))?;
        if form.dimension != unit.dimension {
            self.report(mismatch(tree.span, form.dimension, unit.dimension));
            return None;
        }
        let factors = form.factors.into_iter().filter(|(_, factor)| !factor.is_zero()).collect();
        Some(ir::Linear { constant: form.constant, factors })
    }

    fn form(&mut self, tree: &Expr, network: &ir::Network, unit: Option<&Unit>) -> Option<Form> {
        let form = match &tree.kind {
            ExprKind::Path(_) => {
                let input = self.subject(tree, network)?;
                let dimension = self.program.variables[network.inputs[input as usize].variable].unit.dimension;
                Some(Form { dimension, constant: Exact::ZERO, factors: BTreeMap::from([(input, Exact::ONE)]) })
            }
            ExprKind::Quantity(quantity) => match unit {
                Some(unit) if quantity.unit.is_none() => {
                    Some(Form::constant(self.quantity_in(quantity, unit)?, unit.dimension))
                }
                _ => {
                    let quantity = self.quantity(quantity)?;
                    Some(Form::constant(quantity.value, quantity.dimension))
                }
            },
            ExprKind::Negate(inner) => self.form(inner, network, unit)?.map(negated),
            ExprKind::Sum(terms) => return self.sum(tree, terms, network, unit),
            ExprKind::Product(factors) => return self.product(tree, factors, network),
            _ => {
                let diagnostic = invalid(tree.span, "a linear expression of the network's inputs is needed");
                self.report(diagnostic.help("write for instance `distance / 2 s + 0.1 m/s`"));
                return None;
            }
        };
        if form.is_none() {
            self.report(too_long(tree.span, "this expression"));
        }
        form
    }

    fn sum(&mut self, tree: &Expr, terms: &[(Sign, Expr)], network: &ir::Network, unit: Option<&Unit>) -> Option<Form> {
        let mut sum: Option<Form> = None;
        for (sign, term) in terms {
            let form = self.form(term, network, unit)?;
            let wanted = unit.map(|unit| unit.dimension).or(sum.as_ref().map(|sum| sum.dimension));
            if let Some(wanted) = wanted.filter(|wanted| *wanted != form.dimension) {
                self.report(mismatch(term.span, form.dimension, wanted));
                return None;
            }
            let signed = if *sign == Sign::Minus { form.map(negated) } else { Some(form) };
            let total = signed.and_then(|form| match sum.take() {
                Some(sum) => sum.plus(form),
                None => Some(form),
            });
            if total.is_none() {
                self.report(too_long(tree.span, "this expression"));
            }
            sum = Some(total?);
        }
        sum
    }

    fn product(&mut self, tree: &Expr, factors: &[(Factor, Expr)], network: &ir::Network) -> Option<Form> {
        let mut product = Form::constant(Exact::ONE, Dimension::NONE);
        for (side, factor) in factors {
            let form = self.form(factor, network, None)?;
            let is_over = *side == Factor::Over;
            let is_linear = form.factors.is_empty() || product.factors.is_empty() && !is_over;
            if !is_linear || is_over && form.constant.is_zero() {
                let message = if is_linear { "this divides by 0" } else { "this is not linear in the inputs" };
                self.report(invalid(factor.span, message));
                return None;
            }
            let dimension = product.dimension.times(form.dimension, if is_over { -1 } else { 1 });
            let scaled = if is_over {
                product.map(|number| number.over(form.constant))
            } else if form.factors.is_empty() {
                product.map(|number| number.times(form.constant))
            } else {
                form.map(|number| number.times(product.constant))
            };
            match scaled.zip(dimension) {
                Some((scaled, dimension)) => product = Form { dimension, ..scaled },
                None => {
                    self.report(too_long(tree.span, "this expression"));
                    return None;
                }
            }
        }
        Some(product)
    }
}

fn negated(number: Exact) -> Option<Exact> {
    Exact::ZERO.minus(number)
}
