//! Events that imply each other by the form of their rules, whatever the curves.

use super::model::EventModel;

/// Pairs of different events of which the first implies the second.
pub(super) fn implications(events: &[EventModel]) -> Vec<(usize, usize)> {
    let pairs = (0..events.len()).flat_map(|premise| (0..events.len()).map(move |conclusion| (premise, conclusion)));
    pairs
        .filter(|&(premise, conclusion)| premise != conclusion && implies(&events[premise], &events[conclusion]))
        .collect()
}

/// Whether wherever `premise` is set, `conclusion` is: what speaks for the premise speaks for the conclusion, and what
/// speaks against the conclusion speaks against the premise. `false` proves nothing.
fn implies(premise: &EventModel, conclusion: &EventModel) -> bool {
    let (premise_rules, conclusion_rules) = (premise.clauses(), conclusion.clauses());
    let (for_premise, against_premise) = premise_rules.split_at(premise.contributors);
    let (for_conclusion, against_conclusion) = conclusion_rules.split_at(conclusion.contributors);
    for_premise.iter().all(|weak| for_conclusion.iter().any(|strong| at_most(weak, strong)))
        && against_conclusion.iter().all(|weak| against_premise.iter().any(|strong| at_most(weak, strong)))
}

/// Whether a rule is nowhere stronger than another: it has a narrower clause for each of the other's.
pub(super) fn at_most(weak: &[(usize, &[usize])], strong: &[(usize, &[usize])]) -> bool {
    let narrower = |(input, wide): &(usize, &[usize])| {
        weak.iter().any(|(same, narrow)| same == input && narrow.iter().all(|literal| wide.contains(literal)))
    };
    strong.iter().all(narrower)
}
