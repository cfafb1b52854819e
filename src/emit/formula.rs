//! Rules as minima and maxima, with what they share taken out.
//!
//! On numbers that are ordered, `max(min(a, x), min(a, y))` is `min(a, max(x, y))`: each side gives back one of the
//! same numbers, so nothing is rounded, and the other form has the same bits. Degrees are from 0 to 1, without NaN
//! and without -0.

use std::collections::HashMap;

use proc_macro2::TokenStream;
use quote::quote;

use super::graph::Node;

/// A combination of degrees.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Formula {
    /// The value of a step.
    Value(Node),
    /// The smallest; 1 of none.
    Minimum(Vec<Formula>),
    /// The largest; 0 of none.
    Maximum(Vec<Formula>),
}

/// The maximum over rules of the minimum over each rule's degrees, factored greedily: the degree that most rules share
/// is taken out of them, and so on in what is left of them and in the others.
pub(super) fn factored(rules: &[Vec<Node>]) -> Formula {
    let mut rules: Vec<Vec<Node>> = rules.to_vec();
    for rule in &mut rules {
        rule.sort_unstable();
        rule.dedup();
    }
    if rules.iter().any(Vec::is_empty) {
        return Formula::Minimum(Vec::new());
    }
    let mut parts = Vec::new();
    while let Some(shared) = most_shared(&rules) {
        let (mut with, without): (Vec<_>, Vec<_>) = rules.into_iter().partition(|rule| rule.contains(&shared));
        rules = without;
        for rule in &mut with {
            rule.retain(|degree| *degree != shared);
        }
        // One of them holds nothing else: the others are never larger than it.
        parts.push(if with.iter().any(Vec::is_empty) {
            Formula::Value(shared)
        } else {
            minimum(vec![Formula::Value(shared), factored(&with)])
        });
    }
    parts.extend(rules.into_iter().map(|rule| minimum(rule.into_iter().map(Formula::Value).collect())));
    single(parts, Formula::Maximum)
}

/// The degree that occurs in the most rules, the first of several, if it occurs in two.
fn most_shared(rules: &[Vec<Node>]) -> Option<Node> {
    let mut counts: HashMap<Node, usize> = HashMap::new();
    for degree in rules.iter().flatten() {
        *counts.entry(*degree).or_default() += 1;
    }
    let most = counts.values().copied().max().filter(|most| *most > 1)?;
    rules.iter().flatten().copied().find(|degree| counts.get(degree) == Some(&most))
}

fn minimum(parts: Vec<Formula>) -> Formula {
    let flat = parts.into_iter().flat_map(|part| match part {
        Formula::Minimum(parts) => parts,
        part => vec![part],
    });
    single(flat.collect(), Formula::Minimum)
}

fn single(mut parts: Vec<Formula>, many: impl Fn(Vec<Formula>) -> Formula) -> Formula {
    match (parts.pop(), parts.is_empty()) {
        (Some(only), true) => only,
        (last, _) => {
            parts.extend(last);
            many(parts)
        }
    }
}

impl Formula {
    /// The formula in calls of the kernel, halved again and again: the order of minima does not matter, and a tree
    /// is computed faster than a chain.
    pub(super) fn tokens(&self, value: &impl Fn(Node) -> TokenStream) -> TokenStream {
        match self {
            Formula::Value(node) => value(*node),
            Formula::Minimum(parts) => tree(parts, value, &quote! { minimum }, &quote! { 1.0 }),
            Formula::Maximum(parts) => tree(parts, value, &quote! { maximum }, &quote! { 0.0 }),
        }
    }

    /// The same with the parts of each minimum and maximum in order: values by a key, so that what different rules share
    /// is the same call, which is computed once; then what takes longer, so that nothing waits for it.
    pub(super) fn sorted<K: Ord>(self, key: &impl Fn(Node) -> K) -> Self {
        let sorted = |parts: Vec<Formula>| {
            let mut parts: Vec<_> = parts.into_iter().map(|part| part.sorted(key)).collect();
            parts.sort_by_cached_key(|part| match part {
                Formula::Value(node) => (0, Some(key(*node))),
                part => (part.depth(), None),
            });
            parts
        };
        match self {
            Formula::Value(node) => Formula::Value(node),
            Formula::Minimum(parts) => Formula::Minimum(sorted(parts)),
            Formula::Maximum(parts) => Formula::Maximum(sorted(parts)),
        }
    }

    /// How many minima and maxima lie in each other.
    fn depth(&self) -> usize {
        match self {
            Formula::Value(_) => 0,
            Formula::Minimum(parts) | Formula::Maximum(parts) => {
                1 + parts.iter().map(Formula::depth).max().unwrap_or_default()
            }
        }
    }

    /// The values it is made of.
    pub(super) fn values(&self) -> Vec<Node> {
        match self {
            Formula::Value(node) => vec![*node],
            Formula::Minimum(parts) | Formula::Maximum(parts) => parts.iter().flat_map(Formula::values).collect(),
        }
    }
}

fn tree(
    parts: &[Formula],
    value: &impl Fn(Node) -> TokenStream,
    function: &TokenStream,
    empty: &TokenStream,
) -> TokenStream {
    match parts {
        [] => empty.clone(),
        [only] => only.tokens(value),
        parts => {
            let (left, right) = parts.split_at(parts.len().div_ceil(2));
            let (left, right) = (tree(left, value, function, empty), tree(right, value, function, empty));
            quote! { kernel::#function(#left, #right) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::{draw, next_random};

    fn evaluate(formula: &Formula, degrees: &[f64]) -> f64 {
        let all = |parts: &[Formula]| parts.iter().map(|part| evaluate(part, degrees)).collect::<Vec<_>>();
        match formula {
            Formula::Value(node) => degrees[*node],
            Formula::Minimum(parts) => all(parts).into_iter().fold(1.0, f64::min),
            Formula::Maximum(parts) => all(parts).into_iter().fold(0.0, f64::max),
        }
    }

    #[test]
    fn what_rules_share_is_computed_once() {
        let formula = factored(&[vec![0, 5], vec![1, 5], vec![2, 3]]);
        let value = Formula::Value;
        let shared = Formula::Minimum(vec![value(5), Formula::Maximum(vec![value(0), value(1)])]);
        assert_eq!(formula, Formula::Maximum(vec![shared, Formula::Minimum(vec![value(2), value(3)])]));
        let sorted = factored(&[vec![0, 5], vec![1, 5], vec![3, 2]]).sorted(&|node| node);
        let shared = Formula::Minimum(vec![value(5), Formula::Maximum(vec![value(0), value(1)])]);
        assert_eq!(sorted, Formula::Maximum(vec![Formula::Minimum(vec![value(2), value(3)]), shared]));
        assert_eq!(factored(&[vec![0, 1], vec![0]]), value(0));
        assert_eq!(factored(&[vec![0, 1], vec![]]), Formula::Minimum(vec![]));
        assert_eq!(factored(&[]), Formula::Maximum(vec![]));
    }

    #[test]
    fn factoring_changes_no_bit() {
        let mut seed = 5;
        for _ in 0..2_000 {
            let mut below = |limit| (next_random(&mut seed) % limit) as usize;
            let rules: Vec<Vec<Node>> = (0..below(7)).map(|_| (0..below(5)).map(|_| below(6)).collect()).collect();
            let formula = factored(&rules).sorted(&|node| node % 4);
            let degrees = [0; 6].map(|_| draw(&mut seed, -0.2, 1.2).clamp(0.0, 1.0));
            let strength = |rule: &Vec<Node>| rule.iter().map(|&node| degrees[node]).fold(1.0, f64::min);
            let plain = rules.iter().map(strength).fold(0.0, f64::max);
            assert_eq!(evaluate(&formula, &degrees).to_bits(), plain.to_bits(), "{rules:?} as {formula:?}");
        }
    }
}
