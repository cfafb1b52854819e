//! Pictures and listings of diagrams: nothing of the source is lost, and nothing lies upon something else.

use lmslc::analysis::modes::{Fault, fault_table};
use lmslc::driver::Analysis;
use lmslc::view::{
    self,
    chart::{self, Chart},
};

use crate::random_modes::{CART, FUSION, Random};
use crate::support::{analyze_path, analyze_texts, report};

const MANIPULATION: &str = "stdlib/behaviors/obstacle_manipulation.msd";

/// A behavior with all that a picture shows.
const ODD: &str = "
robot cart {
    sensor x: m in 0 .. 10 fails 0
    sensor y: m in 0 .. 10 fails 0
    action halt()
    action go(speed: m/s)
}
behavior odd on cart {
    flag near = x < 1 m
    entry ahead
    mode ahead {
        go(1 m/s)
        1: near and y < 5 m or (x > 3 m and // or so
           held(y > 2 m, 3 s) and not failed(y)) -> rest
        2: after 3 s -> again
        3: y < 1 m -> parked
    }
    mode rest requires x, y else parked {
        go(0.1 m/s)
        on enter { halt() }
        1: after 1 s -> ahead
    }
    final mode parked { halt() }
}";

fn charts(analysis: &Analysis) -> Vec<Chart> {
    assert!(!analysis.has_errors(), "{}", report(analysis));
    analysis.program.diagrams.ids().map(|id| Chart::new(&analysis.program, &analysis.sources, id)).collect()
}

#[test]
fn a_diagram_for_other_tools() {
    let [odd] = charts(&analyze_texts(&[("odd.msd", ODD)])).try_into().unwrap();
    insta::assert_snapshot!(format!("{}\n{}", chart::dot(&odd), chart::mermaid(&odd)));
}

#[test]
fn what_the_compiler_understood() {
    insta::assert_snapshot!(view::program(&analyze_path(MANIPULATION).program));
    let odd = view::program(&analyze_texts(&[("odd.msd", ODD)]).program);
    for line in [
        "        1: ((x < 1 and y < 5) or (x > 3 and held(y > 2, 3000000000 ns) and not failed(y))) -> rest",
        "    mode rest requires x, y else parked",
        "        on enter halt()",
        "        2: after 3000000000 ns -> again",
        "    final mode parked",
    ] {
        assert!(odd.lines().any(|other| other == line), "{line}\n{odd}");
    }
}

#[test]
fn what_is_run() {
    let plans = |analysis: &Analysis| analysis.plans(None).map(|plans| view::plans(&plans.networks, &plans.diagrams));
    insta::assert_snapshot!(plans(&analyze_path(MANIPULATION)).unwrap());
    let odd = plans(&analyze_texts(&[("odd.msd", ODD)])).unwrap();
    for line in
        ["        requires input 0", "        else mode 2", "        on enter halt()", "        1: bool 12 -> ahead"]
    {
        assert!(odd.lines().any(|other| other == line), "{line}\n{odd}");
    }
}

#[test]
fn what_failed_sensors_take_away() {
    let analysis = analyze_path(MANIPULATION);
    let program = &analysis.program;
    let (id, _) = program.diagrams.iter().find(|(_, diagram)| diagram.symbol.name == "obstacle_manipulation").unwrap();
    let facts = fault_table(program, id, 1);
    let force = program.sensors.iter().find(|(_, sensor)| sensor.symbol.name == "contact_force").unwrap().0;
    let under: Vec<_> = facts.iter().filter(|facts| facts.faults.iter().any(|(sensor, _)| *sensor == force)).collect();
    let mut chart = Chart::new(program, &analysis.sources, id);
    chart.mark_lost(&under);
    // Known to have failed, push is left at once; silent, nothing is heavy any more.
    let lost: Vec<_> =
        chart.arrows.iter().filter(|arrow| arrow.is_lost).map(|arrow| arrow.condition.as_str()).collect();
    assert_eq!(lost, ["heavy_obstacle", "heavy_obstacle"]);
    assert!(chart.modes.iter().all(|mode| !mode.is_lost), "each is reached while the failure is not known");
    let svg = chart::svg(&chart);
    assert_eq!(svg.matches("<g class=\"gone\">").count(), 2, "{svg}");
    assert_eq!(chart::dot(&chart).matches("gray70").count(), 2);
    chart.mark_lost(&facts.iter().filter(|facts| facts.faults == [(force, Fault::Reported)]).collect::<Vec<_>>());
    let lost: Vec<_> = chart.modes.iter().filter(|mode| mode.is_lost).map(|mode| mode.name.as_str()).collect();
    assert_eq!(lost, ["push"], "inhibited");
}

#[test]
fn a_network_is_drawn_with_all_its_terms_and_rules() {
    for path in [
        "stdlib/networks/obstacle_id.fsfn",
        "stdlib/networks/navigator.fsfn",
        "stdlib/networks/preliminary_obstacle_id.fsfn",
    ] {
        let analysis = analyze_path(path);
        for network in analysis.program.networks.values() {
            let svg = view::network(&analysis.program, &analysis.sources, network);
            let (_, texts) = drawn(&svg);
            for input in &network.inputs {
                let terms = &analysis.program.variables[input.variable].terms;
                assert!(terms.iter().all(|term| texts.contains(&term.symbol.name)), "{path}: {texts}");
            }
            assert!(network.events.iter().all(|event| texts.contains(&event.symbol.name)), "{path}: {texts}");
            let rules =
                network.events.iter().map(|event| event.contributor.len() + event.detractor.len()).sum::<usize>();
            assert_eq!(svg.matches("class=\"rule\"").count() + 2 * network.events.len(), rules, "{path}\n{svg}");
        }
    }
}

/// A rectangle of a picture: left, top, right, bottom.
type Area = [f64; 4];

/// The modes of a picture, and its texts joined.
fn drawn(svg: &str) -> (Vec<Area>, String) {
    let document = roxmltree::Document::parse(svg).unwrap();
    let number = |node: &roxmltree::Node<'_, '_>, name| node.attribute(name).unwrap().parse::<f64>().unwrap();
    let of_class = |class: &'static str| {
        let is_of = move |node: &roxmltree::Node<'_, '_>| {
            node.has_tag_name("rect")
                && node.attribute("class").unwrap_or_default().split(' ').any(|word| word == class)
        };
        document.descendants().filter(is_of)
    };
    let area = |node: roxmltree::Node<'_, '_>| {
        let (x, y) = (number(&node, "x"), number(&node, "y"));
        [x, y, x + number(&node, "width"), y + number(&node, "height")]
    };
    let texts = document.descendants().filter(|node| node.has_tag_name("text")).filter_map(|node| node.text());
    (of_class("mode").map(area).collect(), texts.collect::<Vec<_>>().join(" "))
}

fn overlap(one: &Area, other: &Area) -> bool {
    one[0] < other[2] && other[0] < one[2] && one[1] < other[3] && other[1] < one[3]
}

fn is_sound(chart: &Chart) {
    let svg = chart::svg(chart);
    assert_eq!(svg, chart::svg(chart), "the same picture twice");
    let (modes, texts) = drawn(&svg);
    assert_eq!(modes.len(), chart.modes.len());
    for (index, mode) in modes.iter().enumerate() {
        assert!(modes[..index].iter().all(|other| !overlap(mode, other)), "{svg}");
    }
    for arrow in &chart.arrows {
        assert!(texts.contains(&arrow.condition), "{}\n{svg}", arrow.condition);
    }
    for mode in &chart.modes {
        assert!(texts.contains(&mode.name) && mode.commands.iter().all(|command| texts.contains(command)), "{svg}");
    }
    assert_eq!(svg.matches("marker-end").count(), chart.arrows.len() + usize::from(chart.entry.is_some()));
}

#[test]
fn a_picture_shows_all_and_covers_nothing() {
    charts(&analyze_texts(&[("odd.msd", ODD)])).iter().for_each(is_sound);
    charts(&analyze_path(MANIPULATION)).iter().for_each(is_sound);
    let mut random = Random { state: 3, recalls: true };
    for _ in 0..20 {
        let text = format!("{CART}{}", random.behavior("b"));
        charts(&analyze_texts(&[("b.msd", &text), ("n.fsfn", FUSION)])).iter().for_each(is_sound);
    }
}
