//! Membership functions drawn with letters, a line for each.

use crate::base::{Exact, Unit};
use crate::ir::{Shape, Term};
use crate::membership::function;

/// Columns of a drawing.
const WIDTH: usize = 48;
/// Readings that are looked at for a column: the highest degree among them is drawn.
const SAMPLES: usize = 16;
/// From degree 0 to degree 1.
const LEVELS: [char; 9] = [' ', '▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];

/// The terms of a variable or an output over its range, with their names before and the range's ends below.
pub(super) fn drawing<'t>(terms: impl IntoIterator<Item = &'t Term>, range: (Exact, Exact), unit: &Unit) -> String {
    let terms: Vec<_> = terms.into_iter().filter(|term| !is_broken(&term.shape)).collect();
    let widest = terms.iter().map(|term| term.symbol.name.len()).max().unwrap_or(0);
    let ends = (range.0.to_f64(), range.1.to_f64());
    let mut text = String::new();
    for term in terms {
        text += &format!("{:widest$} |{}|\n", term.symbol.name, curve(&term.shape, ends));
    }
    let (low, high) = (unit.show(ends.0), unit.show(ends.1));
    let gap = (WIDTH + 2).saturating_sub(low.chars().count());
    text + &format!("{:widest$} {low}{high:>gap$}\n", "")
}

/// A shape without points was broken and reported.
fn is_broken(shape: &Shape) -> bool {
    matches!(shape, Shape::Points(points) if points.is_empty())
}

fn curve(shape: &Shape, (low, high): (f64, f64)) -> String {
    let degree = function(shape);
    let column = |column: usize| {
        let at = |sample: usize| low + (high - low) * ((column * SAMPLES + sample) as f64 / (WIDTH * SAMPLES) as f64);
        let highest = match shape {
            Shape::Singleton(single) if (at(0)..=at(SAMPLES)).contains(&single.to_f64()) => 1.0,
            _ => (0..=SAMPLES).map(|sample| degree(at(sample))).fold(0.0, f64::max),
        };
        LEVELS[((highest * 8.0).ceil() as usize).min(8)]
    };
    (0..WIDTH).map(column).collect()
}
