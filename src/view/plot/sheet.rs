//! The layout of a sheet: panels below each other, their names at the left, their legends at the right.

use super::scale::Scale;
use crate::trace::{Trace, seconds};
use crate::view::svg::{Anchor, Svg, width_of};

/// The width of a sheet, px.
pub(super) const WIDTH: f64 = 1040.0;
/// What stays free at the edges, px.
pub(super) const EDGE: f64 = 16.0;
/// The widest legend, px.
pub(super) const LEGEND: f64 = 208.0;
/// The height of a line of a legend, px.
pub(super) const LEGEND_LINE: f64 = 16.0;
/// The widest name of a mode, px.
pub(super) const MODE_NAME: f64 = 130.0;

/// Where panels go, from top to bottom.
pub(super) struct Sheet {
    /// Time in s to px, common to all panels.
    pub(super) time: Scale,
    /// How many px of a curve share a highest and a lowest point.
    pub(super) bucket: f64,
    top: f64,
    panels: u32,
}

/// A rectangle to draw in, px.
#[derive(Clone, Copy)]
pub(super) struct Panel {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
}

impl Sheet {
    pub(super) fn new(trace: &Trace) -> Self {
        let names = trace.modes.iter().chain(&trace.places).map(|name| width_of(name)).fold(0.0, f64::max);
        let left = EDGE + (names.min(MODE_NAME) + 54.0).max(84.0);
        let right = WIDTH - EDGE - LEGEND;
        let duration = trace.times.last().map_or(0.0, |&time| seconds(time));
        let time = Scale { low: 0.0, high: if duration > 0.0 { duration } else { 1.0 }, from: left, to: right };
        // A curve may take four points of about ten characters for every bucket; all of them together 350 kB.
        let curves = trace.columns.iter().filter(|column| !column.signal.is_pose()).count();
        let bucket = curves as f64 * (right - left) * 40.0 / 350_000.0;
        Self { time, bucket: bucket.max(1.0), top: 58.0, panels: 0 }
    }

    /// The next panel, `height` px high and `gap` px below the one before, with its letter.
    pub(super) fn panel(&mut self, svg: &mut Svg, height: f64, gap: f64) -> Panel {
        let top = self.top + gap;
        self.top = top + height;
        let letter = char::from_u32(u32::from('a') + self.panels % 26).unwrap_or('a');
        self.panels += 1;
        svg.text("name", (EDGE, top + 9.0), Anchor::Start, &format!("({letter})"));
        Panel { left: self.time.from, right: self.time.to, top, bottom: top + height }
    }

    /// A panel that goes with the one before: without a letter.
    pub(super) fn strip(&mut self, height: f64, gap: f64) -> Panel {
        let top = self.top + gap;
        self.top = top + height;
        Panel { left: self.time.from, right: self.time.to, top, bottom: top + height }
    }

    /// Leaves room for the labels of a horizontal axis.
    pub(super) fn skip(&mut self, height: f64) {
        self.top += height;
    }

    /// Where the last panel ends.
    pub(super) fn top(&self) -> f64 {
        self.top
    }

    /// The height of the sheet.
    pub(super) fn bottom(&self) -> f64 {
        self.top + EDGE
    }

    /// A sheet with nothing on it says so.
    pub(super) fn empty(&mut self, svg: &mut Svg, why: &str) {
        self.top += 40.0;
        svg.text("quiet", (WIDTH / 2.0, self.top), Anchor::Middle, why);
        self.top += 20.0;
    }
}

impl Panel {
    pub(super) fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// The border, over what it holds.
    pub(super) fn frame(&self, svg: &mut Svg) {
        let Self { left, right, top, bottom } = self;
        svg.shape("frame", &format!("M{left:.1} {top:.1}H{right:.1}V{bottom:.1}H{left:.1}Z"));
    }

    /// Numbers and light lines for a vertical axis, and what it measures.
    pub(super) fn vertical_axis(&self, svg: &mut Svg, scale: Scale, count: f64, name: &str) {
        for (value, text) in scale.ticks(count) {
            let y = scale.px(value);
            svg.line("grid", (self.left, y), (self.right, y));
            svg.text("", (self.left - 7.0, y + 4.0), Anchor::End, &text);
        }
        svg.upward_text("quiet", (self.left - 56.0, f64::midpoint(self.top, self.bottom)), name);
    }

    /// Numbers for a horizontal axis, and what it measures.
    pub(super) fn horizontal_axis(&self, svg: &mut Svg, scale: Scale, count: f64, name: &str) {
        for (value, text) in scale.ticks(count) {
            let x = scale.px(value);
            svg.line("frame", (x, self.bottom), (x, self.bottom + 4.0));
            svg.text("", (x, self.bottom + 17.0), Anchor::Middle, &text);
        }
        svg.text("quiet", (f64::midpoint(self.left, self.right), self.bottom + 34.0), Anchor::Middle, name);
    }

    /// Where a line of the legend begins: the middle of its sample.
    pub(super) fn legend(&self, line: usize) -> (f64, f64) {
        (self.right + 14.0, self.top + 6.0 + line as f64 * LEGEND_LINE)
    }

    /// A line of the legend with a sample of a curve.
    pub(super) fn legend_curve(&self, svg: &mut Svg, line: usize, (color, width): (&str, f64), name: &str) {
        let (x, y) = self.legend(line);
        svg.path("", color, width, &format!("M{x:.1} {y:.1}h18"));
        self.legend_name(svg, line, "", name);
    }

    /// A line of the legend with a sample of its own, drawn before.
    pub(super) fn legend_name(&self, svg: &mut Svg, line: usize, class: &str, name: &str) {
        let (x, y) = self.legend(line);
        svg.cut_text(class, (x + 25.0, y + 4.0), Anchor::Start, name, LEGEND - 39.0);
    }
}
