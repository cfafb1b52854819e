//! A chart as SVG, for papers and pages, light and dark.

use std::fmt::Write;

use super::layout::{Places, Px2, Sizes, place};
use super::{Arrow, Chart, ModeBox};
use crate::view::svg::{Anchor, Escaped, Px, Svg, width_of};

const STYLE: &str = "text{font:11px \"Helvetica Neue\",Helvetica,Arial,\"DejaVu Sans\",sans-serif;fill:#222}\
.title{font-size:15px;font-weight:bold}.name{font-size:13px;font-weight:bold}.quiet{fill:#666}\
.sheet{fill:#fff}\
.mode{fill:#f4f7fa;stroke:#33475b;stroke-width:1.4}.inhibited{stroke-dasharray:5 3}.rim{fill:none;stroke:#33475b}\
.arrow{fill:none;stroke:#33475b;stroke-width:1.3}.otherwise{stroke:#b35900;stroke-dasharray:4 3}\
.gone{opacity:.28}.head{fill:#33475b}.otherwise-head{fill:#b35900}.start{fill:#33475b}\
.priority{fill:#fff;stroke:#33475b;stroke-width:1.1}.number{font-size:10px;font-weight:bold}\
@media(prefers-color-scheme:dark){text{fill:#e6e6e6}.quiet{fill:#a0a0a0}.sheet{fill:#16191d}\
.mode{fill:#20262d;stroke:#9fb3c8}.rim{stroke:#9fb3c8}.arrow{stroke:#9fb3c8}.otherwise{stroke:#e69f00}.head,.start{fill:#9fb3c8}\
.otherwise-head{fill:#e69f00}.priority{fill:#16191d;stroke:#9fb3c8}}";

/// What stays free at the edges, px.
const EDGE: f64 = 20.0;
/// The height of the title, px.
const TITLE: f64 = 30.0;
/// The height of a line of text, px.
const LINE: f64 = 15.0;
/// Around the text of a box, px.
const PADDING: f64 = 12.0;
/// The circle around a priority, px.
const RADIUS: f64 = 8.0;
/// The dot from which the entry is pointed at, px.
const DOT: f64 = 10.0;
/// Conditions are broken into lines of about so many characters.
const LONG: usize = 30;

/// Draws a diagram: modes as boxes, dashed where a failed sensor can inhibit them, with a double border where they are
/// final; what runs inside a mode inside its box; transitions as arrows with their priorities in circles; a dot that
/// points at the entry. What is lost is pale.
pub fn svg(chart: &Chart) -> String {
    let sheet = Sheet::new(chart);
    let inside = sheet.size();
    let title = width_of(&chart.name) * 1.5;
    let (width, height) = (inside.0.max(title) + 2.0 * EDGE, inside.1 + TITLE + 2.0 * EDGE);

    let mut svg = Svg::default();
    let (width, height, name) = (Px(width), Px(height), Escaped(&chart.name));
    svg.raw(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\" role=\"img\" aria-labelledby=\"title\">"
    ));
    svg.raw(format_args!("<title id=\"title\">Mode switching diagram {name}</title>"));
    svg.raw(format_args!("<style>{STYLE}</style>"));
    svg.raw(format_args!("<defs>{}{}</defs>", head("head"), head("otherwise-head")));
    svg.raw(format_args!("<rect class=\"sheet\" width=\"{width}\" height=\"{height}\"/>"));
    svg.text("title", (EDGE, EDGE + 12.0), Anchor::Start, &chart.name);
    sheet.draw(&mut svg, (EDGE, EDGE + TITLE));
    svg.raw("</svg>");
    svg.into_text()
}

/// A chart with all its places.
struct Sheet<'c> {
    chart: &'c Chart,
    boxes: Vec<Vec<(&'static str, String)>>,
    labels: Vec<Vec<String>>,
    /// What is drawn inside each box.
    inner: Vec<Option<Self>>,
    sizes: Sizes,
    places: Places,
    /// Its corners.
    extent: (Px2, Px2),
}

impl<'c> Sheet<'c> {
    fn new(chart: &'c Chart) -> Self {
        let boxes: Vec<_> = chart.modes.iter().map(lines).collect();
        let labels: Vec<_> = chart.arrows.iter().map(label).collect();
        let inner: Vec<_> = chart.modes.iter().map(|mode| mode.inner.as_ref().map(Sheet::new)).collect();
        let sizes = sizes(chart, &boxes, &labels, &inner);
        let places = place(&sizes);
        let extent = extent(&sizes, &places);
        Self { chart, boxes, labels, inner, sizes, places, extent }
    }

    fn size(&self) -> Px2 {
        let (low, high) = self.extent;
        (high.0 - low.0, high.1 - low.1)
    }

    /// Draws it with its upper left corner there.
    fn draw(&self, svg: &mut Svg, corner: Px2) {
        let Self { chart, boxes, labels, sizes, places, extent: (low, _), .. } = self;
        svg.raw(format_args!("<g transform=\"translate({} {})\">", Px(corner.0 - low.0), Px(corner.1 - low.1)));
        let arrows = || chart.arrows.iter().map(Some).chain(chart.entry.map(|_| None)).zip(&places.arrows);
        for (arrow, (points, _)) in arrows() {
            let is_otherwise = arrow.is_some_and(|arrow| arrow.priority.is_none());
            let (class, head) = if is_otherwise { ("arrow otherwise", "otherwise-head") } else { ("arrow", "head") };
            let gone = if arrow.is_some_and(|arrow| arrow.is_lost) { " gone" } else { "" };
            svg.raw(format_args!(
                "<path class=\"{class}{gone}\" marker-end=\"url(#{head})\" d=\"{}\"/>",
                curve(points)
            ));
        }
        let placed = sizes.boxes.iter().zip(&places.boxes).zip(&self.inner);
        for ((mode, lines), ((size, at), inner)) in chart.modes.iter().zip(boxes).zip(placed) {
            faded(svg, mode.is_lost, |svg| {
                draw_box(svg, mode, lines, *size, *at);
                if let Some(inner) = inner {
                    let (width, height) = inner.size();
                    inner.draw(svg, (at.0 - width / 2.0, at.1 + size.1 / 2.0 - PADDING - height));
                }
            });
        }
        if let (Some(_), Some(at)) = (chart.entry, places.boxes.get(chart.modes.len())) {
            svg.raw(format_args!("<circle class=\"start\" cx=\"{}\" cy=\"{}\" r=\"5\"/>", Px(at.0), Px(at.1)));
        }
        for ((arrow, lines), (_, at)) in chart.arrows.iter().zip(labels).zip(&places.arrows) {
            faded(svg, arrow.is_lost, |svg| draw_label(svg, arrow, lines, *at));
        }
        svg.raw("</g>");
    }
}

/// Draws something pale where it is lost.
fn faded(svg: &mut Svg, is_lost: bool, draw: impl FnOnce(&mut Svg)) {
    if is_lost {
        svg.raw("<g class=\"gone\">");
    }
    draw(svg);
    if is_lost {
        svg.raw("</g>");
    }
}

/// The tip of an arrow.
fn head(name: &str) -> String {
    format!(
        "<marker id=\"{name}\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"8\" markerHeight=\"8\" \
         orient=\"auto\"><path class=\"{name}\" d=\"M0 1L10 5L0 9z\"/></marker>"
    )
}

/// What stands in a box under its name.
fn lines(mode: &ModeBox) -> Vec<(&'static str, String)> {
    let required = (!mode.requires.is_empty()).then(|| ("quiet", format!("requires {}", mode.requires.join(", "))));
    let commands = mode.commands.iter().map(|command| ("", command.clone()));
    required.into_iter().chain(commands).collect()
}

/// A condition in lines that break before `and` and `or`, and never between a number and its unit.
fn label(arrow: &Arrow) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in arrow.condition.split(' ') {
        let joins = ["and", "or"].contains(&word);
        match lines.last_mut() {
            Some(line)
                if !joins && line.ends_with(|last: char| last.is_ascii_digit())
                    || line.chars().count() + word.len() < if joins { LONG / 2 } else { LONG } =>
            {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn sizes(
    chart: &Chart,
    boxes: &[Vec<(&'static str, String)>],
    labels: &[Vec<String>],
    inner: &[Option<Sheet<'_>>],
) -> Sizes {
    let widest = |lines: &mut dyn Iterator<Item = &str>| lines.map(width_of).fold(0.0, f64::max);
    let of_box = |place: usize| {
        let (mode, lines, inner) = (&chart.modes[place], &boxes[place], &inner[place]);
        let inside = inner.as_ref().map_or((0.0, 0.0), |inner| (inner.size().0, inner.size().1 + PADDING));
        let width = widest(&mut lines.iter().map(|(_, line)| line.as_str())).max(width_of(&mode.name) * 1.2);
        (width.max(inside.0) + 2.0 * PADDING, LINE * (lines.len() + 1) as f64 + inside.1 + 2.0 * PADDING - 4.0)
    };
    let mut sizes = Sizes { boxes: (0..chart.modes.len()).map(of_box).collect(), arrows: Vec::new() };
    sizes.arrows.extend(chart.arrows.iter().zip(labels).map(|(arrow, lines)| {
        let width = widest(&mut lines.iter().map(String::as_str));
        (arrow.from, arrow.to, (circle(arrow) + width + 6.0, LINE * lines.len() as f64 + 6.0))
    }));
    if let Some(entry) = chart.entry {
        sizes.arrows.push((sizes.boxes.len(), entry, (0.0, 0.0)));
        sizes.boxes.push((DOT, DOT));
    }
    sizes
}

/// The room for a priority, px.
fn circle(arrow: &Arrow) -> f64 {
    if arrow.priority.is_some() { 2.0 * RADIUS + 5.0 } else { 0.0 }
}

/// The corners of all that is drawn.
fn extent(sizes: &Sizes, places: &Places) -> (Px2, Px2) {
    let boxes = places.boxes.iter().zip(&sizes.boxes);
    let labels = places.arrows.iter().map(|(_, at)| at).zip(sizes.arrows.iter().map(|(_, _, size)| size));
    let around = boxes.chain(labels).flat_map(|(at, size)| {
        [(at.0 - size.0 / 2.0, at.1 - size.1 / 2.0), (at.0 + size.0 / 2.0, at.1 + size.1 / 2.0)]
    });
    let bends = places.arrows.iter().flat_map(|(points, _)| points).copied();
    around.chain(bends).fold(((0.0, 0.0), (0.0, 0.0)), |(low, high): (Px2, Px2), at| {
        ((low.0.min(at.0), low.1.min(at.1)), (high.0.max(at.0), high.1.max(at.1)))
    })
}

/// A cubic B-spline that begins and ends at the first and the last point.
fn curve(points: &[Px2]) -> String {
    let [first, .., last] = points else { return String::new() };
    let mut data = format!("M{} {}", Px(first.0), Px(first.1));
    let mut to = |command: char, ends: &[Px2]| {
        let ends: Vec<_> = ends.iter().map(|at| format!("{} {}", Px(at.0), Px(at.1))).collect();
        let _ = write!(data, "{command}{}", ends.join(" "));
    };
    let mix = |one: Px2, other: Px2, share: f64| (one.0 + (other.0 - one.0) * share, one.1 + (other.1 - one.1) * share);
    // Between the middles of its legs each bend pulls once.
    let middle = |pair: &[Px2]| mix(pair[0], pair[1], 0.5);
    for (index, bend) in points.iter().enumerate().skip(1).take(points.len().saturating_sub(2)) {
        let (start, end) = (middle(&points[index - 1..=index]), middle(&points[index..=index + 1]));
        if index == 1 {
            to('L', &[start]);
        }
        to('C', &[mix(start, *bend, 2.0 / 3.0), mix(end, *bend, 2.0 / 3.0), end]);
    }
    to('L', &[*last]);
    data
}

fn draw_box(svg: &mut Svg, mode: &ModeBox, lines: &[(&str, String)], (width, height): Px2, at: Px2) {
    let corner = (at.0 - width / 2.0, at.1 - height / 2.0);
    let mut rectangle = |class: &str, inset: f64| {
        let (x, y) = (Px(corner.0 + inset), Px(corner.1 + inset));
        let (width, height) = (Px(width - 2.0 * inset), Px(height - 2.0 * inset));
        let class =
            format!("<rect class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"8\"/>");
        svg.raw(class);
    };
    rectangle(if mode.requires.is_empty() { "mode" } else { "mode inhibited" }, 0.0);
    if mode.is_final {
        rectangle("rim", 3.0);
    }
    let mut y = corner.1 + PADDING + 9.0;
    svg.text("name", (at.0, y), Anchor::Middle, &mode.name);
    for (class, line) in lines {
        y += LINE;
        svg.text(class, (at.0, y), Anchor::Middle, line);
    }
}

fn draw_label(svg: &mut Svg, arrow: &Arrow, lines: &[String], at: Px2) {
    let width = circle(arrow) + lines.iter().map(|line| width_of(line)).fold(0.0, f64::max);
    let left = at.0 - width / 2.0;
    if let Some(priority) = arrow.priority {
        let x = left + RADIUS;
        svg.raw(format_args!("<circle class=\"priority\" cx=\"{}\" cy=\"{}\" r=\"{RADIUS}\"/>", Px(x), Px(at.1)));
        svg.text("number", (x, at.1 + 3.6), Anchor::Middle, &priority.to_string());
    }
    let mut y = at.1 + 4.0 - LINE * (lines.len() - 1) as f64 / 2.0;
    for line in lines {
        // The arrow is interrupted where its condition stands.
        let (x, y_top, width) = (Px(left + circle(arrow) - 2.0), Px(y - 11.0), Px(width_of(line) * 0.85));
        svg.raw(format_args!("<rect class=\"sheet\" x=\"{x}\" y=\"{y_top}\" width=\"{width}\" height=\"{LINE}\"/>"));
        svg.text("", (left + circle(arrow), y), Anchor::Start, line);
        y += LINE;
    }
}
