//! Networks as pictures: the membership functions of every input, and the rules of every event as a table.

use std::fmt::Write;

use super::plot::Scale;
use super::svg::{Anchor, Escaped, Px, Svg, width_of};
use crate::base::{Exact, Sources, Unit};
use crate::ir::{Event, Network, Output, Program, Rule, Term, Variable};
use crate::membership::{Membership, function, in_units};

/// Colors of terms that differ for every kind of color vision (Okabe and Ito 2008).
const COLORS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#7f7f7f"];

const STYLE: &str = "text{font:11px \"Helvetica Neue\",Helvetica,Arial,\"DejaVu Sans\",sans-serif;fill:#222}\
.title{font-size:15px;font-weight:bold}.name{font-weight:bold}.quiet{fill:#666}.sheet{fill:#fff}\
path{fill:none;stroke-linejoin:round}.frame{stroke:#444}.grid{stroke:#e6e6e6}.rule{stroke:#d0d0d0}.heavy{stroke:#444}\
@media(prefers-color-scheme:dark){text{fill:#e6e6e6}.quiet{fill:#a0a0a0}.sheet{fill:#16191d}.frame,.heavy{stroke:#9fb3c8}\
.grid,.rule{stroke:#333a42}}";

/// What stays free at the edges, px.
const EDGE: f64 = 20.0;
/// The size of a plot of membership functions, px.
const PLOT: (f64, f64) = (340.0, 110.0);
/// From one plot to the next, px.
const GAP: (f64, f64) = (60.0, 82.0);
/// The height of a row of a table, px.
const ROW: f64 = 19.0;
/// How many steps a curve is drawn in, besides its bends.
const SAMPLES: usize = 340;

/// Draws a network: a plot for each input and output, two side by side, then a table for each event and the rules of
/// each output.
pub fn network(program: &Program, sources: &Sources, network: &Network) -> String {
    let mut body = Svg::default();
    let mut bottom = EDGE + 34.0;
    let inputs = network.inputs.iter().map(|input| {
        let Variable { unit, range, terms, .. } = &program.variables[input.variable];
        Axis { name: &input.symbol.name, unit, range: *range, terms }
    });
    let outputs = network.outputs.iter().filter_map(|output| {
        let Output { symbol, unit, range, terms, .. } = output;
        Some(Axis { name: &symbol.name, unit, range: (*range)?, terms }).filter(|axis| !axis.terms.is_empty())
    });
    for (index, axis) in inputs.chain(outputs).enumerate() {
        let (column, row) = (index % 2, index / 2);
        let corner = (EDGE + 34.0 + column as f64 * (PLOT.0 + GAP.0), EDGE + 66.0 + row as f64 * (PLOT.1 + GAP.1));
        membership(&mut body, &axis, corner);
        bottom = corner.1 + PLOT.1 + 44.0;
    }
    let mut width = EDGE * 2.0 + 34.0 + PLOT.0 * 2.0 + GAP.0;
    for event in &network.events {
        width = width.max(table(&mut body, program, network, event, &mut bottom));
    }
    for output in &network.outputs {
        bottom += 26.0;
        body.text("name", (EDGE, bottom), Anchor::Start, &output.symbol.name);
        for rule in &output.rules {
            bottom += ROW;
            let text = sources.slice(rule.span).split_whitespace().collect::<Vec<_>>().join(" ");
            body.text("", (EDGE + 12.0, bottom), Anchor::Start, &text);
            width = width.max(2.0 * EDGE + 12.0 + width_of(&text));
        }
    }
    let (width, height, name) = (Px(width), Px(bottom + EDGE), Escaped(&network.symbol.name));
    let mut svg = Svg::default();
    svg.raw(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\" role=\"img\" aria-labelledby=\"title\">"
    ));
    svg.raw(format_args!("<title id=\"title\">Network {name}</title>"));
    svg.raw(format_args!("<style>{STYLE}</style>"));
    svg.raw(format_args!("<rect class=\"sheet\" width=\"{width}\" height=\"{height}\"/>"));
    svg.text("title", (EDGE, EDGE + 12.0), Anchor::Start, &network.symbol.name);
    svg.raw(body.into_text().trim_end());
    svg.raw("</svg>");
    svg.into_text()
}

/// Something with sets: an input, or an output.
struct Axis<'a> {
    name: &'a str,
    unit: &'a Unit,
    /// SI.
    range: (Exact, Exact),
    terms: &'a [Term],
}

fn membership(svg: &mut Svg, axis: &Axis<'_>, (left, top): (f64, f64)) {
    let (low, high) = (axis.range.0.to_f64(), axis.range.1.to_f64());
    let scale = axis.unit.scale.to_f64();
    let (right, bottom) = (left + PLOT.0, top + PLOT.1);
    let across = Scale { low: low / scale, high: high / scale, from: left, to: right };
    let up = Scale { low: 0.0, high: 1.0, from: bottom, to: top };
    svg.text("name", (left, top - 28.0), Anchor::Start, axis.name);
    for (value, text) in [(0.0, "0"), (0.5, "0.5"), (1.0, "1")] {
        svg.line("grid", (left, up.px(value)), (right, up.px(value)));
        svg.text("quiet", (left - 6.0, up.px(value) + 4.0), Anchor::End, text);
    }
    for (value, text) in across.ticks(6.0) {
        svg.line("frame", (across.px(value), bottom), (across.px(value), bottom + 4.0));
        svg.text("quiet", (across.px(value), bottom + 16.0), Anchor::Middle, &text);
    }
    svg.text("quiet", (right, bottom + 31.0), Anchor::End, &axis.unit.text);
    // Where the name on a line ends.
    let mut ends = [f64::NEG_INFINITY; 2];
    for (index, term) in axis.terms.iter().enumerate() {
        let points = points(term, axis.range);
        let color = COLORS[index % COLORS.len()];
        let mut data = String::new();
        let curve = points.iter().map(|(x, degree)| (across.px(x / scale), up.px(*degree)));
        for (index, (x, y)) in simplified(curve).into_iter().enumerate() {
            let _ = write!(data, "{}{} {}", if index == 0 { 'M' } else { 'L' }, Px(x), Px(y));
        }
        svg.path("", color, 1.8, &data);
        // Over the middle of where it is largest.
        let most = points.iter().map(|(_, degree)| *degree).fold(0.0, f64::max);
        let mut largest = points.iter().filter(|(_, degree)| *degree >= most - 1e-9).map(|(x, _)| *x);
        let (first, last) = (largest.next().unwrap_or(low), largest.next_back());
        let half = 6.0 + width_of(&term.symbol.name) * 0.45;
        let middle = across.px(f64::midpoint(first, last.unwrap_or(first)) / scale);
        let x = middle.clamp(left + half, (right - half).max(left + half));
        let line = usize::from(ends[0] > x - half);
        ends[line] = x + half;
        let y = top - 6.0 - 11.0 * line as f64;
        let dot = (Px(x - half + 3.0), Px(y - 3.5));
        svg.raw(format_args!("<circle cx=\"{}\" cy=\"{}\" r=\"3\" fill=\"{color}\"/>", dot.0, dot.1));
        svg.text("", (x - half + 10.0, y), Anchor::Start, &term.symbol.name);
    }
    svg.shape("frame", &format!("M{left:.1} {top:.1}V{bottom:.1}H{right:.1}"));
}

/// Readings from end to end, all at which a set bends among them, and its degrees there.
fn points(term: &Term, range: (Exact, Exact)) -> Vec<(f64, f64)> {
    let (low, high) = (range.0.to_f64(), range.1.to_f64());
    let (pi, _) = in_units(range);
    let bends = Membership::new(&term.shape, pi).low;
    let bends = bends.bends().filter_map(|bend| Some(Exact::from_fraction(bend, pi)?.to_f64()));
    let mut readings: Vec<_> = (0..=SAMPLES).map(|at| low + (high - low) * at as f64 / SAMPLES as f64).collect();
    // Beside a bend too: it may be a step.
    let beside = (high - low) * 1e-6;
    readings.extend(bends.flat_map(|bend| [bend - beside, bend, bend + beside]).filter(|x| low <= *x && *x <= high));
    readings.sort_by(f64::total_cmp);
    let degree = function(&term.shape);
    readings.into_iter().map(|x| (x, degree(x))).collect()
}

/// Points without those that lie on the line between their neighbours, to a tenth of a px.
fn simplified(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    let mut last: Option<(f64, f64)> = None;
    for point in points {
        if let (Some(from), Some(between)) = (kept.last().copied(), last) {
            let share = (between.0 - from.0) / (point.0 - from.0);
            if (from.1 + (point.1 - from.1) * share - between.1).abs() > 0.05 {
                kept.push(between);
            }
        } else {
            kept.push(point);
        }
        last = Some(point);
    }
    kept.extend(last);
    kept
}

/// A table of an event's rules under `bottom`, which moves down; answers how wide the sheet must be.
fn table(svg: &mut Svg, program: &Program, network: &Network, event: &Event, bottom: &mut f64) -> f64 {
    let rows: Vec<_> = [("for", &event.contributor), ("against", &event.detractor)]
        .into_iter()
        .flat_map(|(side, rules)| rules.iter().map(move |rule| (side, cells(program, network, rule))))
        .collect();
    let heads: Vec<_> = network.inputs.iter().map(|input| input.symbol.name.as_str()).collect();
    let width = |column: usize| {
        let cells = rows.iter().map(|(_, cells)| cells[column].as_str()).chain([heads[column]]);
        cells.map(width_of).fold(0.0, f64::max) + 22.0
    };
    let mut left = vec![EDGE + 70.0];
    for column in 0..heads.len() {
        left.push(left[column] + width(column));
    }
    let right = left.last().copied().unwrap_or(EDGE);
    *bottom += 30.0;
    svg.text("name", (EDGE, *bottom), Anchor::Start, &event.symbol.name);
    *bottom += ROW + 2.0;
    for (head, left) in heads.iter().zip(&left) {
        svg.text("name", (*left, *bottom), Anchor::Start, head);
    }
    let mut last = "";
    for (side, cells) in &rows {
        svg.line(if last == *side { "rule" } else { "heavy" }, (EDGE, *bottom + 5.0), (right, *bottom + 5.0));
        *bottom += ROW;
        if last != *side {
            svg.text("quiet", (EDGE, *bottom), Anchor::Start, side);
            last = side;
        }
        for (cell, left) in cells.iter().zip(&left) {
            svg.text("", (*left, *bottom), Anchor::Start, cell);
        }
    }
    svg.line("heavy", (EDGE, *bottom + 5.0), (right, *bottom + 5.0));
    *bottom += 6.0;
    right + EDGE
}

/// A rule's cells, one for each input: a term, several, any, or left out.
fn cells(program: &Program, network: &Network, rule: &Rule) -> Vec<String> {
    let of_input = |(position, input): (usize, &crate::ir::NetworkInput)| {
        let terms = &program.variables[input.variable].terms;
        let clauses = rule.clauses.iter().filter(|clause| clause.input as usize == position).map(|clause| {
            let is_any = clause.any_of.len() == terms.len() && clause.any_of.iter().all(|literal| !literal.negated);
            let words = clause.any_of.iter().map(|literal| {
                let name = &terms[literal.term as usize].symbol.name;
                if literal.negated { format!("not {name}") } else { name.clone() }
            });
            if is_any { "_".to_owned() } else { words.collect::<Vec<_>>().join(" or ") }
        });
        let clauses: Vec<_> = clauses.collect();
        if clauses.is_empty() { "–".to_owned() } else { clauses.join(" and ") }
    };
    network.inputs.iter().enumerate().map(of_input).collect()
}
