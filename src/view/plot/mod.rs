//! A run as one sheet, in the manner of LMSL figs. 10 to 12: where things went, what the sensors read, what the
//! network made of it, and what the machine did.

mod above;
mod panels;
mod scale;
mod sheet;

#[cfg(test)]
mod samples;

use super::svg::{self, Escaped, Px, Svg};
use crate::trace::{ModeChange, Trace, seconds};
pub(super) use scale::Scale;
use sheet::Sheet;

/// Colors that differ for every kind of color vision (Okabe and Ito 2008), the lightest ones left out.
const COLORS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

const STYLE: &str = "text{font:11px \"Helvetica Neue\",Helvetica,Arial,\"DejaVu Sans\",sans-serif;fill:#222}\
.title{font-size:15px;font-weight:bold}.name{font-weight:bold}.quiet{fill:#666}\
.halo{stroke:#fff;stroke-width:3px;stroke-linejoin:round;paint-order:stroke}\
path{fill:none;stroke-linejoin:round;stroke-linecap:round}\
.frame{stroke:#444}.grid{stroke:#e6e6e6}.change{stroke:#b8b8b8;stroke-dasharray:3 3;stroke-linecap:butt}\
.mode{stroke:#222;stroke-width:1.8}.flag{stroke:#009e73;stroke-width:1.4}.up{fill:#009e73;fill-opacity:.25}\
.arrow{fill:#0072b2}.path{stroke:#0072b2;stroke-width:1.4}.dot{fill:#0072b2}.hit{stroke:#cc79a7;stroke-width:2}.robot{stroke:#0072b2;stroke-width:1.8;fill:#0072b2;\
fill-opacity:.12}.then{stroke:#0072b2;stroke-width:.8;stroke-opacity:.45}.start{stroke:#0072b2;stroke-dasharray:5 3;\
stroke-linecap:butt}.box{stroke:#b35900;stroke-width:1.6;fill:#e69f00;fill-opacity:.22}.was{stroke:#b35900;\
stroke-dasharray:5 3;stroke-linecap:butt}.wall{stroke:#444;stroke-width:3}.goal{stroke:#009e73;stroke-width:2}";

/// Draws a run as an SVG sheet: a view from above to scale, then panels over one time axis for the sensors grouped by
/// unit, for each event, for named flags and for the modes. Costs a pass over the trace; the text stays below 500 kB
/// however long the run was.
pub fn plot(trace: &Trace) -> String {
    let mut body = Svg::default();
    let mut sheet = Sheet::new(trace);
    above::draw(&mut body, &mut sheet, trace);
    panels::draw(&mut body, &mut sheet, trace);
    if trace.times.is_empty() {
        sheet.empty(&mut body, "nothing was recorded");
    }

    let (width, height) = (Px(sheet::WIDTH), Px(sheet.bottom()));
    let mut svg = Svg::default();
    svg.raw(format_args!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\" role=\"img\" aria-labelledby=\"title desc\">"
    ));
    let under = subtitle(trace);
    let title = if trace.scenario.is_empty() { "run" } else { &trace.scenario };
    svg.raw(format_args!("<title id=\"title\">{}: {}</title>", Escaped(title), Escaped(&under)));
    svg.raw(format_args!("<desc id=\"desc\">{}</desc>", Escaped(&description(trace))));
    svg.raw(format_args!("<style>{STYLE}</style>"));
    svg.raw(format_args!("<rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>"));
    svg.cut_text("title", (sheet::EDGE, 26.0), svg::Anchor::Start, title, 600.0);
    svg.text("quiet", (sheet::EDGE, 44.0), svg::Anchor::Start, &under);
    svg.raw(body.into_text().trim_end());
    svg.raw("</svg>");
    svg.into_text()
}

fn subtitle(trace: &Trace) -> String {
    let named = [("", &trace.behavior), ("on ", &trace.robot)];
    let named = named.iter().filter(|(_, name)| !name.is_empty()).map(|(word, name)| format!("{word}{name}"));
    let duration = trace.times.last().map_or(0.0, |&time| seconds(time));
    let who = named.collect::<Vec<_>>().join(" ");
    format!("{who}{}{duration} s, seed {}", if who.is_empty() { "" } else { ", " }, trace.seed)
}

/// The run in words, for those who cannot see the figure.
fn description(trace: &Trace) -> String {
    const TOLD: usize = 24;
    let changes = trace.changes.iter().take(TOLD).filter_map(|change: &ModeChange| {
        let mode = trace.modes.get(change.to as usize)?;
        Some(format!("{mode} at {} s", seconds(change.time)))
    });
    let told = changes.collect::<Vec<_>>().join(", ");
    match trace.changes.len() {
        0 => "No mode was entered.".to_owned(),
        more if more > TOLD => format!("Modes over time: {told}, and {} more changes.", more - TOLD),
        _ => format!("Modes over time: {told}."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::{Column, Signal};

    /// The sheet, after checks that hold for every sheet.
    fn checked(trace: &Trace) -> String {
        let svg = plot(trace);
        let document = roxmltree::Document::parse(&svg).unwrap();
        for node in document.descendants() {
            for attribute in node.attributes() {
                let value = attribute.value();
                assert!(!value.contains("NaN") && !value.contains("inf"), "{value}");
            }
        }
        assert!(svg.len() < 500_000, "{} bytes", svg.len());
        assert_eq!(svg, plot(trace));
        svg
    }

    fn count(svg: &str, class: &str) -> usize {
        svg.matches(&format!("class=\"{class}\"")).count()
    }

    #[test]
    fn the_manipulation_experiment_has_all_its_panels() {
        let svg = checked(&samples::manipulation());
        for words in ["acceleration (m/s²)", "force (N)", "forward_collision", "time (s)", "30 kg", "90 kg", ">push<"]
        {
            assert!(svg.contains(words), "{words}");
        }
        assert_eq!(svg.matches(">contributor<").count(), 2);
        // One line for each change of mode, the entry left out.
        assert_eq!(count(&svg, "change"), 4);
        assert!(svg.contains("<title id=\"title\">two_obstacles: obstacle_manipulation on j5, 10 s, seed 1</title>"));
        assert!(svg.contains("init at 0 s, forward at 2.05 s, push at 5.02 s, stop at 8.04 s, back_up at 9.05 s."));
    }

    #[test]
    fn ten_minutes_of_noise_stay_small() {
        let svg = checked(&samples::long());
        assert!(svg.contains(">wall<") && svg.contains(">goal<"));
        assert_eq!(count(&svg, "change"), 0);
    }

    #[test]
    fn three_dozen_noisy_columns_stay_small() {
        let mut trace = samples::long();
        let noisy = trace.columns[0].clone();
        let again = (8..36).map(|number| Column { signal: Signal::Reading(number), ..noisy.clone() });
        trace.columns.extend(again);
        checked(&trace);
    }

    #[test]
    fn odd_runs_are_drawn_too() {
        assert!(checked(&Trace::default()).contains("nothing was recorded"));
        assert!(checked(&samples::one_tick()).contains("time (s)"));
        assert!(checked(&samples::many_modes()).contains("<title>approach_the_nearest_open_door_19</title>"));
        let mut lonely = samples::manipulation();
        lonely.bodies.truncate(1);
        assert_eq!(count(&checked(&lonely), "box"), 0);
        lonely.bodies.clear();
        assert!(!checked(&lonely).contains("x (m)"));
    }

    #[test]
    fn what_does_not_fit_together_is_left_out() {
        let mut trace = samples::manipulation();
        trace.scenario = "<&\"]]>\u{0}\u{b}".to_owned();
        trace.modes[1] = "a<b".to_owned();
        trace.changes[2].to = 99;
        trace.mode[5] = u32::MAX;
        trace.columns[0].values.truncate(7);
        trace.columns[1].values.clear();
        trace.goal = Some([f64::NAN, 1.0]);
        trace.walls = vec![Vec::new(), vec![[f64::INFINITY, 0.0]]];
        for column in &mut trace.columns {
            if let Some(value) = column.values.get_mut(3) {
                *value = f64::NAN;
            }
        }
        checked(&trace);
    }
}
