//! Sets that hold some values together.

use super::curve::{Curve, places};
use crate::base::Fraction;

/// Some sets, by position, and the curve of the smallest of their degrees.
pub(crate) type Overlap = (Vec<usize>, Curve);

impl Curve {
    /// The linear pieces of it over a range: each from a value and the degree just after it to a value and the degree
    /// just before it.
    pub(crate) fn pieces(&self, range: &(Fraction, Fraction)) -> Vec<[(Fraction, Fraction); 2]> {
        let piece = |ends: &[&Fraction]| {
            let [from, to] = [ends[0], ends[1]];
            [(from.clone(), self.around(from).after), (to.clone(), self.around(to).before)]
        };
        places([self], range).windows(2).map(piece).collect()
    }

    /// Whether it is above 0 on some stretch of a range.
    pub(crate) fn has_area(&self, range: &(Fraction, Fraction)) -> bool {
        self.pieces(range).iter().flatten().any(|(_, degree)| !degree.is_zero())
    }
}

/// Every choice of some of these sets that hold some stretch of a range together, single sets first in their order.
/// `None` where there are more than `most`.
pub(crate) fn overlaps(sets: &[Curve], range: &(Fraction, Fraction), most: usize) -> Option<Vec<Overlap>> {
    let mut found: Vec<Overlap> = Vec::new();
    let single = sets.iter().enumerate().filter(|(_, set)| set.has_area(range));
    found.extend(single.map(|(position, set)| (vec![position], set.clone())));
    let mut next = 0;
    while let Some((chosen, all)) = found.get(next).cloned() {
        let last = chosen.last().copied().unwrap_or_default();
        for (position, set) in sets.iter().enumerate().skip(last + 1) {
            let together = all.merged(set, Ord::min);
            if together.has_area(range) {
                found.push(([chosen.as_slice(), &[position]].concat(), together));
            }
        }
        if found.len() > most {
            return None;
        }
        next += 1;
    }
    Some(found)
}
