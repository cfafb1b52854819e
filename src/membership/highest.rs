//! Where each of some sets holds more of a reading than the others.

use super::curve::{Curve, places};
use crate::base::Fraction;

/// Readings from one end to the other; `true` where an end belongs to them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Stretch {
    pub(crate) from: (Fraction, bool),
    pub(crate) to: (Fraction, bool),
}

/// For each set the readings of a range that belong to it most, ascending. Of sets that are equal somewhere the first
/// one counts, so every reading belongs to exactly one set most.
pub(crate) fn highest(sets: &[Curve], range: &(Fraction, Fraction)) -> Vec<Vec<Stretch>> {
    let places = places(sets, range);
    let crossings = places.windows(2).flat_map(|ends| crossings(sets, ends[0], ends[1]));
    let mut cuts: Vec<Fraction> = places.iter().copied().cloned().chain(crossings).collect();
    cuts.sort_unstable();
    cuts.dedup();
    let mut found: Vec<Vec<Stretch>> = vec![Vec::new(); sets.len()];
    let mut add = |at: &Fraction, from: (&Fraction, bool), to: (&Fraction, bool), last: &mut Option<usize>| {
        let degrees = sets.iter().map(|set| set.around(at).at);
        let best = degrees.enumerate().reduce(|best, other| if other.1 > best.1 { other } else { best });
        let Some((set, _)) = best else { return };
        match found[set].last_mut() {
            Some(stretch) if *last == Some(set) => stretch.to = (to.0.clone(), to.1),
            _ => found[set].push(Stretch { from: (from.0.clone(), from.1), to: (to.0.clone(), to.1) }),
        }
        *last = Some(set);
    };
    let mut last = None;
    for (index, cut) in cuts.iter().enumerate() {
        add(cut, (cut, true), (cut, true), &mut last);
        if let Some(next) = cuts.get(index + 1) {
            add(&cut.halfway(next), (cut, false), (next, false), &mut last);
        }
    }
    found
}

/// Where two of some sets cross strictly between two readings, between which all of them are linear.
fn crossings(sets: &[Curve], from: &Fraction, to: &Fraction) -> Vec<Fraction> {
    let ends: Vec<_> = sets.iter().map(|set| (set.around(from).after, set.around(to).before)).collect();
    let pairs =
        ends.iter().enumerate().flat_map(|(index, one)| ends[index + 1..].iter().map(move |other| (one, other)));
    let crossing = |(one, other): (&(Fraction, Fraction), &(Fraction, Fraction))| {
        let (first, last) = (&one.0 - &other.0, &one.1 - &other.1);
        let share = first.over(&(&first - &last))?;
        let at = from + &(&(to - from) * &share);
        (*from < at && at < *to).then_some(at)
    };
    pairs.filter_map(crossing).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(corners: &[(i128, i128)]) -> Curve {
        Curve::through(corners.iter().map(|&(at, degree)| (Fraction::from(at), Fraction::from(degree))))
    }

    #[test]
    fn every_reading_belongs_to_one_set_most() {
        let sets = [curve(&[(0, 1), (4, 0)]), curve(&[(0, 0), (4, 1), (8, 0)]), curve(&[(6, 0), (8, 1)])];
        let range = (Fraction::from(0), Fraction::from(9));
        let stretch = |from: (i128, i128, bool), to: (i128, i128, bool)| Stretch {
            from: (Fraction::new(from.0, from.1), from.2),
            to: (Fraction::new(to.0, to.1), to.2),
        };
        let found = highest(&sets, &range);
        // The middle of the first two falls to the first; the last two cross where 2 - x/4 = x/2 - 3.
        assert_eq!(found[0], [stretch((0, 1, true), (2, 1, true))]);
        assert_eq!(found[1], [stretch((2, 1, false), (20, 3, true))]);
        assert_eq!(found[2], [stretch((20, 3, false), (9, 1, true))]);
    }

    #[test]
    fn where_nothing_holds_the_first_set_counts() {
        let sets = [curve(&[(0, 0), (1, 1), (2, 0)]), curve(&[(4, 0), (5, 1), (6, 0)])];
        let found = highest(&sets, &(Fraction::from(0), Fraction::from(8)));
        assert_eq!(found[0].len(), 2);
        assert_eq!(found[1].len(), 1);
    }
}
