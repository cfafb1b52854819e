//! What happened over time: sensors, events, flags and modes (LMSL figs. 11 and 12).

use super::COLORS;
use super::scale::{Scale, curve, limits, steps};
use super::sheet::{LEGEND_LINE, MODE_NAME, Panel, Sheet, WIDTH};
use crate::trace::{Column, Signal, Trace, seconds};
use crate::view::svg::{Anchor, Svg, width_of};

/// The most curves in one panel of sensors.
const CURVES: usize = COLORS.len();
/// Beyond this many changes of mode their lines would hide the rest.
const CHANGES: usize = 80;

/// Draws all panels over time, and the lines at changes of mode beneath them.
pub(super) fn draw(svg: &mut Svg, sheet: &mut Sheet, trace: &Trace) {
    if trace.times.is_empty() {
        return;
    }
    let mut panels = Svg::default();
    // Room for the names of the modes.
    sheet.skip(14.0);
    let top = sheet.top();
    let mut last = None;
    for group in groups(trace) {
        last = Some(sensors(&mut panels, sheet, trace, &group));
    }
    for (name, column) in trace.flags() {
        if let Signal::Event(event) = column.signal {
            last = Some(self::event(&mut panels, sheet, trace, event, name));
        }
    }
    let named: Vec<_> = trace.flags().into_iter().filter(|(_, column)| is_named(column)).collect();
    for (index, (name, column)) in named.iter().enumerate() {
        let panel = if index == 0 { sheet.panel(&mut panels, 14.0, 22.0) } else { sheet.strip(14.0, 5.0) };
        flag(&mut panels, sheet, trace, panel, column);
        panel.legend_name(&mut panels, 0, "", name);
        last = Some(panel);
    }
    if !trace.modes.is_empty() {
        last = Some(modes(&mut panels, sheet, trace, "mode", &trace.modes, &trace.mode));
    }
    if !trace.places.is_empty() {
        last = Some(modes(&mut panels, sheet, trace, "within", &trace.places, &trace.place));
    }
    let Some(last) = last else { return };
    last.horizontal_axis(&mut panels, sheet.time, 10.0, "time (s)");
    changes(svg, sheet, trace, (top + 16.0, last.bottom));
    svg.raw(panels.into_text().trim_end());
    sheet.skip(34.0);
}

fn is_named(column: &Column) -> bool {
    matches!(column.signal, Signal::Flag(_))
}

/// Whether a reading has a curve: the elements of arrays would be too many, and logical sensors stand for them.
fn is_shown(column: &Column) -> bool {
    matches!(column.signal, Signal::Reading(_) | Signal::Logical(_)) && !column.name.contains(['[', '.'])
}

/// The readings with one unit, in order of appearance, in groups that a panel can show.
fn groups(trace: &Trace) -> Vec<Vec<&Column>> {
    let mut units: Vec<Vec<&Column>> = Vec::new();
    for column in trace.columns.iter().filter(|column| is_shown(column)) {
        match units.iter_mut().find(|unit| unit.first().is_some_and(|first| first.unit == column.unit)) {
            Some(unit) => unit.push(column),
            None => units.push(vec![column]),
        }
    }
    let even = |unit: &[&Column]| unit.len().div_ceil(unit.len().div_ceil(CURVES).max(1)).max(1);
    units.iter().flat_map(|unit| unit.chunks(even(unit)).map(<[_]>::to_vec)).collect()
}

fn sensors(svg: &mut Svg, sheet: &mut Sheet, trace: &Trace, columns: &[&Column]) -> Panel {
    let height = (columns.len() as f64 * LEGEND_LINE + 8.0).max(112.0);
    let panel = sheet.panel(svg, height, 16.0);
    let (low, high) = limits(columns.iter().flat_map(|column| column.values.iter().copied()), 4.0);
    let scale = Scale { low, high, from: panel.bottom, to: panel.top };
    let unit = columns.first().map_or("", |column| column.unit.as_str());
    panel.vertical_axis(svg, scale, 4.0, &measured(unit));
    for (index, (column, color)) in columns.iter().zip(COLORS).enumerate() {
        // Where the two wheels of a robot do the same, the thinner one leaves the other visible.
        let width = if index == 0 && columns.len() == 2 { 2.4 } else { 1.2 };
        let data = curve(points(sheet, trace, column, scale), sheet.bucket);
        if data.is_empty() {
            panel.legend_name(svg, index, "quiet", &format!("{}: none", column.name));
        } else {
            svg.path("", color, width, &data);
            panel.legend_curve(svg, index, (color, width), &column.name);
        }
    }
    panel.frame(svg);
    panel
}

/// SI units as traces write them, with what they measure and how they are printed.
const MEASURED: [(&str, &str); 16] = [
    ("1", "reading"),
    ("m", "distance (m)"),
    ("m/s", "speed (m/s)"),
    ("m/s^2", "acceleration (m/s²)"),
    ("N", "force (N)"),
    ("rad", "angle (rad)"),
    ("rad/s", "turn rate (rad/s)"),
    ("kg", "mass (kg)"),
    ("s", "time (s)"),
    ("Hz", "frequency (Hz)"),
    ("A", "current (A)"),
    ("K", "temperature (K)"),
    ("V", "voltage (V)"),
    ("W", "power (W)"),
    ("Pa", "pressure (Pa)"),
    ("J", "energy (J)"),
];

/// The name of an axis for readings in a unit.
fn measured(unit: &str) -> String {
    match MEASURED.iter().find(|(known, _)| *known == unit) {
        Some((_, name)) => (*name).to_owned(),
        None => format!("reading ({})", unit.replace("^2", "²").replace("^3", "³")),
    }
}

/// Contributor and detractor of an event, and its flag below them.
fn event(svg: &mut Svg, sheet: &mut Sheet, trace: &Trace, event: u32, name: &str) -> Panel {
    let panel = sheet.panel(svg, 72.0, 22.0);
    let scale = Scale { low: 0.0, high: 1.0, from: panel.bottom - 3.0, to: panel.top + 3.0 };
    panel.vertical_axis(svg, scale, 2.0, "strength");
    panel.legend_name(svg, 0, "name", name);
    // At a tie, where the flag stays clear, the thinner contributor leaves the detractor visible.
    let sides =
        [(2, "detractor", Signal::Detractor(event), 1, 2.6), (1, "contributor", Signal::Contributor(event), 0, 1.4)];
    for (line_number, side, signal, color, width) in sides {
        if let (Some(column), Some(color)) = (trace.column(signal), COLORS.get(color)) {
            // A strength is from 0 to 1; anything else must not leave the panel.
            let inside = |(x, y): (f64, f64)| (x, if y.is_finite() { y.clamp(scale.to, scale.from) } else { y });
            let data = curve(points(sheet, trace, column, scale).map(inside), sheet.bucket);
            svg.path("", color, width, &data);
            panel.legend_curve(svg, line_number, (color, width), side);
        }
    }
    panel.frame(svg);
    let strip = sheet.strip(14.0, 4.0);
    if let Some(column) = trace.column(Signal::Event(event)) {
        flag(svg, sheet, trace, strip, column);
        strip.legend_name(svg, 0, "", "flag");
    }
    strip
}

/// A flag as a step with its sample in the legend.
fn flag(svg: &mut Svg, sheet: &Sheet, trace: &Trace, panel: Panel, column: &Column) {
    let scale = Scale { low: 0.0, high: 1.0, from: panel.bottom - 2.0, to: panel.top + 2.0 };
    let points = points(sheet, trace, column, scale).map(|(x, y)| (x, if y.is_finite() { y } else { scale.from }));
    let data = curve(steps(points), sheet.bucket);
    let (x, y) = panel.legend(0);
    let sample = format!("M{:.1} {:.1}h6v-8h6v8h6", x, y + 4.0);
    if !data.is_empty() {
        let (base, start) = (scale.from, sheet.time.px(0.0));
        svg.shape("up", &format!("{data}V{base:.1}H{start:.1}Z"));
    }
    svg.shape("flag", &data);
    svg.shape("flag", &sample);
    panel.frame(svg);
}

/// Which of some modes or places was active, as a step, with their numbers and names (LMSL fig. 12).
fn modes(svg: &mut Svg, sheet: &mut Sheet, trace: &Trace, title: &str, names: &[String], active: &[u32]) -> Panel {
    let count = names.len() as f64;
    let panel = sheet.panel(svg, (count * 17.0).max(60.0), 22.0);
    let half = panel.height() / count / 2.0;
    let scale = Scale { low: 0.0, high: (count - 1.0).max(1.0), from: panel.bottom - half, to: panel.top + half };
    for (number, name) in names.iter().enumerate() {
        let y = scale.px(number as f64);
        svg.line("grid", (panel.left, y), (panel.right, y));
        svg.text("", (panel.left - 7.0, y + 4.0), Anchor::End, &number.to_string());
        svg.cut_text("", (panel.left - 27.0, y + 4.0), Anchor::End, name, MODE_NAME);
    }
    panel.legend_name(svg, 0, "name", title);
    let ticks = trace.times.iter().zip(active);
    let points = ticks.map(|(&time, &mode)| (sheet.time.px(seconds(time)), scale.px(f64::from(mode))));
    let data = curve(steps(points), sheet.bucket);
    svg.shape("mode", &data);
    let (x, y) = panel.legend(0);
    svg.shape("mode", &format!("M{:.1} {:.1}h9v-8h9", x, y + 4.0));
    panel.frame(svg);
    panel
}

/// Lines through all panels where the mode changed, with the names of the modes where they fit.
fn changes(svg: &mut Svg, sheet: &Sheet, trace: &Trace, (top, bottom): (f64, f64)) {
    let mut free = f64::NEG_INFINITY;
    let mut drawn = f64::NEG_INFINITY;
    let many = trace.changes.len() > CHANGES;
    for change in &trace.changes {
        let x = sheet.time.px(seconds(change.time));
        if !many && x - drawn >= 1.0 && change.from.is_some() {
            svg.line("change", (x, top), (x, bottom));
            drawn = x;
        }
        let Some(name) = trace.modes.get(change.to as usize) else { continue };
        let width = width_of(name).min(MODE_NAME);
        if !many && x >= free && x + width <= WIDTH {
            svg.cut_text("quiet", (x, top - 5.0), Anchor::Start, name, MODE_NAME);
            free = x + width + 6.0;
        }
    }
}

fn points<'a>(
    sheet: &Sheet,
    trace: &'a Trace,
    column: &'a Column,
    scale: Scale,
) -> impl Iterator<Item = (f64, f64)> + use<'a> {
    let time = sheet.time;
    trace.times.iter().zip(&column.values).map(move |(&at, &value)| (time.px(seconds(at)), scale.px(value)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_name_what_a_unit_measures() {
        assert_eq!(
            ["m/s^2", "N", "1", "m^2/s^3"].map(measured),
            ["acceleration (m/s²)", "force (N)", "reading", "reading (m²/s³)"]
        );
    }

    #[test]
    fn readings_share_a_panel_by_unit_and_evenly() {
        let column = |number: u32, unit: &str| Column {
            name: String::new(),
            unit: unit.to_owned(),
            signal: Signal::Reading(number),
            values: Vec::new(),
        };
        let columns = (0..14).map(|number| column(number, "m")).chain([column(14, "N"), column(15, "m")]);
        let trace = Trace { columns: columns.collect(), ..Trace::default() };
        let sizes: Vec<usize> = groups(&trace).iter().map(Vec::len).collect();
        assert_eq!(sizes, [5, 5, 5, 1]);
    }
}
