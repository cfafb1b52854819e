//! What nothing reads is reported, and what something reads from elsewhere is not.

use lmslc::diag::{Diagnostic, apply_fixes};
use lmslc::driver::Analysis;

use crate::support::{analyze_texts, report};

/// The names of rules and the text they are about.
fn unused(analysis: &Analysis) -> Vec<(&'static str, &str)> {
    assert!(!analysis.has_errors(), "{}", report(analysis));
    let told = |finding: &Diagnostic| (finding.rule.name, analysis.sources.slice(finding.span()));
    let unused = analysis.findings.iter().filter(|finding| finding.rule.name.starts_with("unused-"));
    unused.map(told).collect()
}

#[track_caller]
fn finds(texts: &[(&str, &str)], expected: &[(&str, &str)]) {
    let analysis = analyze_texts(texts);
    let told: Vec<_> =
        unused(&analysis).into_iter().map(|(rule, text)| (rule.trim_start_matches("unused-"), text)).collect();
    assert_eq!(told, expected, "{}", report(&analysis));
}

const BASE: &str = "import std.networks.obstacle_id
import std.robots.j5
behavior base on j5 {
    sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)
    flag inner = contact_force > 3 N
    flag outer = inner and contact_force > 5 N
    entry a
    mode a { halt()  1: after 1 s -> b }
    mode b { halt()  1: after 1 s -> a }
}
";
const SENSE: &str = "sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)";

#[test]
fn flags_and_senses_are_read_by_conditions_anywhere() {
    finds(&[("base.msd", BASE)], &[("sense", SENSE), ("flag", "outer")]);
    let flag = "import base\nbehavior more extends base { mode a { halt()  1: outer -> b } }";
    finds(&[("more.msd", flag), ("base.msd", BASE)], &[("sense", SENSE)]);
    let scenario = "import base\nscenario try runs base { duration 1 s  expect never outer or heavy_obstacle }";
    finds(&[("try.msd", scenario), ("base.msd", BASE)], &[]);
    let replaced = "import base\nimport std.robots.j5\nbehavior more extends base { flag outer = contact_force > 9 N  mode a { halt()  1: outer -> b } }";
    finds(
        &[("more.msd", replaced), ("base.msd", BASE)],
        &[("import", "import std.robots.j5"), ("sense", SENSE), ("flag", "outer")],
    );
    finds(&[("base.msd", &BASE.replace("after 1 s -> b", "obstacle_id.heavy_obstacle and outer -> b"))], &[]);
}

/// The file after one round of fixes.
fn fixed(text: &str) -> String {
    let analysis = analyze_texts(&[("base.msd", text)]);
    let fixes = analysis.findings.iter().filter_map(|finding| finding.fix.as_ref());
    let mut fixed = apply_fixes(fixes, &analysis.sources);
    fixed.texts.remove(&analysis.roots[0]).unwrap_or_else(|| text.to_owned())
}

#[test]
fn what_nothing_reads_is_removed_with_its_comment() {
    let documented = BASE.replace("    flag outer", "    /// Pressed hard.\n    /// Never used.\n    flag outer");
    let once = fixed(&documented);
    assert_eq!(
        once,
        BASE.replace("    flag outer = inner and contact_force > 5 N\n", "").replace(&format!("    {SENSE}\n"), "")
    );
    let twice = fixed(&fixed(&once));
    assert!(!twice.contains("flag") && !twice.contains("obstacle_id"), "{twice}");
    assert_eq!(fixed(&twice), twice);
}

#[test]
fn a_sense_stays_where_it_says_how_a_sensor_fails() {
    let fusion = "variable level: 1 in 0 .. 10 fails 7 { low = ramp(6, 4)  high = ramp(4, 6) }
        network n(v: level) { event full { contributor (high) detractor (low) } }";
    let behavior = |fails: &str| {
        format!(
            "import n
             robot cart {{ sensor x: 1 in 0 .. 10 {fails}  action halt() }}
             behavior b on cart {{
                 sense n(x)
                 entry a
                 mode a {{ halt()  1: x > 5 -> b }}
                 mode b {{ halt()  1: after 1 s -> a }}
             }}"
        )
    };
    for (fails, removed) in [("", false), ("fails any", false), ("fails 3", true)] {
        let text = behavior(fails);
        let analysis = analyze_texts(&[("b.msd", &text), ("n.fsfn", fusion)]);
        assert_eq!(unused(&analysis), [("unused-sense", "sense n(x)")]);
        assert_eq!(analysis.findings[0].fix.is_some(), removed, "{fails}");
    }
}

#[test]
fn terms_and_variables_are_read_by_networks() {
    let level = "variable level: 1 in 0 .. 10 { low = ramp(6, 4)  mid = triangle(4, 5, 6)  high = ramp(4, 6) }\n";
    let event = |rules: &str| format!("{level}network n(v: level) {{ event full {{ {rules} }} }}");
    finds(&[("n.fsfn", level)], &[]);
    finds(&[("n.fsfn", &event("contributor (high) detractor (low)"))], &[("term", "mid")]);
    finds(&[("n.fsfn", &event("contributor (_) detractor (high)"))], &[]);
    finds(&[("n.fsfn", &event("contributor (high) detractor ({low, mid})"))], &[]);
    finds(&[("n.fsfn", &event("contributor rule v is high detractor rule not v is mid"))], &[("term", "low")]);
    let built = event("contributor (high) detractor (off)")
        .replace("high = ramp(4, 6) }", "high = ramp(4, 6)  off = low or mid }");
    finds(&[("n.fsfn", &built)], &[]);
    let other = format!(
        "{level}variable speed: 1 in 0 .. 1 {{ any = rectangle(0, 1) }}
        network n(v: speed) {{ event fast {{ contributor (any) }} }}"
    );
    finds(&[("n.fsfn", &other)], &[("variable", "level")]);
    let taker = "import n\nnetwork m(v: level) { event odd { contributor (mid) } }";
    finds(&[("m.fsfn", taker), ("n.fsfn", &other)], &[]);
    let taker = "import n\nnetwork m(v: level) { event odd { contributor (mid) detractor (low) } }";
    finds(&[("m.fsfn", taker), ("n.fsfn", &event("contributor (high)"))], &[]);
}

#[test]
fn sensors_are_read_by_what_runs_on_their_robot() {
    let program = |condition: &str, requires: &str| {
        format!(
            "interface base {{
    sensor x: 1 in 0 .. 10
    action halt()
}}
robot cart provides base {{
    sensor x: 1 in 0 .. 10 fails 3
    optional sensor y: 1 in 0 .. 10 fails 3
    action halt()
}}
behavior b on cart {{
    entry a
    mode a {{ halt()  1: {condition} -> b }}
    mode b {requires} {{ halt()  1: after 1 s -> a }}
}}"
        )
    };
    finds(&[("b.msd", &program("after 1 s", ""))], &[("sensor", "y")]);
    finds(&[("b.msd", &program("failed(y)", ""))], &[]);
    finds(&[("b.msd", &program("x > y", ""))], &[]);
    finds(&[("b.msd", &program("after 1 s", "requires y else a"))], &[]);
    let text = program("after 1 s", "");
    let robot = text.split("behavior").next().unwrap();
    finds(&[("b.msd", robot)], &[]);
}
