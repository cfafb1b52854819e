//! Sets of failed sensors, smallest first.

use crate::ir::FailReading;

/// One failed input of a network.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Fault {
    /// The position of the input in its network.
    pub input: usize,
    /// How it fails.
    pub reading: FailReading,
}

/// Failures that exist together, at most one for each input, by input. Empty when everything is well.
pub type FaultSet = Vec<Fault>;

/// Every set of at most `up_to` failures, given how each input can fail: the empty set first, smaller sets before
/// larger ones.
pub fn fault_sets<'a>(fails: impl IntoIterator<Item = &'a [FailReading]>, up_to: usize) -> Vec<FaultSet> {
    let mut sets: Vec<FaultSet> = vec![Vec::new()];
    for (input, fails) in fails.into_iter().enumerate() {
        let known = sets.len();
        for &reading in fails {
            let grown = sets[..known].iter().filter(|set| set.len() < up_to);
            let grown: Vec<_> = grown.map(|set| [set.as_slice(), &[Fault { input, reading }]].concat()).collect();
            sets.extend(grown);
        }
    }
    sets.sort_by_key(Vec::len);
    sets
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn smaller_sets_come_first() {
        let fails = [FailReading::Any, FailReading::Absent];
        let sets = fault_sets([fails.as_slice(), &[], &fails[..1]], 2);
        let shape: Vec<Vec<usize>> = sets.iter().map(|set| set.iter().map(|fault| fault.input).collect()).collect();
        assert_eq!(shape, [vec![], vec![0], vec![0], vec![2], vec![0, 2], vec![0, 2]]);
        assert_eq!(fault_sets([fails.as_slice()], 0), [vec![]]);
    }
}
