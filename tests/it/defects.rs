//! One defect, one small file: each is found, by its own code, at its place, with what makes it true.

use std::collections::BTreeSet;

use crate::support::{analyze_texts, doubts, report};

/// A defect: what is wrong, the behavior, the codes that are found, and words of the message, labels and notes of the
/// first one.
struct Defect {
    what: &'static str,
    behavior: &'static str,
    codes: &'static [&'static str],
    told: &'static [&'static str],
}

const SENSE: &str = "sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)";

const DEFECTS: &[Defect] = &[
    Defect {
        what: "a mode with no way in",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle -> b }
            mode b { halt()  1: after 1 s -> a }
            mode c { halt()  1: after 1 s -> a }",
        codes: &["LM0404"],
        told: &["no path of transitions leads to `c`", "the machine starts here"],
    },
    Defect {
        what: "a mode with no way out",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle -> b }
            mode b { halt() }",
        codes: &["LM0406"],
        told: &["no transition leaves `b`"],
    },
    Defect {
        what: "an exit that is always true above a guarded one",
        behavior: "entry a
            mode a { halt()  1: forward_collision or not forward_collision -> b  2: heavy_obstacle -> c }
            mode b { halt()  1: after 1 s -> c }
            mode c { halt()  1: after 1 s -> a }",
        codes: &["LM0410"],
        told: &["the condition of the transition to `b` always holds", "never tried"],
    },
    Defect {
        what: "a guard that a higher one implies",
        behavior: "entry a
            mode a { halt()  1: contact_force > 20 N -> b  2: contact_force > 80 N and heavy_obstacle -> c }
            mode b { halt()  1: after 1 s -> c }
            mode c { halt()  1: after 1 s -> a }",
        codes: &["LM0402"],
        told: &["the transition to `c` can never be taken", "holds whenever the lower one does"],
    },
    Defect {
        what: "a guard of events that exclude each other",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle and not forward_collision -> b  2: forward_collision -> b }
            mode b { halt()  1: after 1 s -> a }",
        codes: &["LM0409"],
        told: &["the condition of the transition to `b` can never hold", "no readings make this true"],
    },
    Defect {
        what: "one guard twice with two targets",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle -> b  2: heavy_obstacle -> c }
            mode b { halt()  1: after 1 s -> c }
            mode c { halt()  1: after 1 s -> a }",
        codes: &["LM0412"],
        told: &["the transition to `c` has the condition of a higher one", "`b` comes first"],
    },
    Defect {
        what: "two exits of one priority",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle -> b  1: forward_collision -> c }
            mode b { halt()  1: after 1 s -> c }
            mode c { halt()  1: after 1 s -> a }",
        codes: &["LM0403"],
        told: &["two transitions of `a` have priority 1", "first used here"],
    },
    Defect {
        what: "a target that is not declared",
        behavior: "entry ahead
            mode ahead { halt()  1: heavy_obstacle -> stpo }
            mode stop  { halt()  1: after 1 s -> ahead }",
        codes: &["LM0201"],
        told: &["no mode is named `stpo`", "did you mean `stop`?"],
    },
    Defect {
        what: "a flag that is never read",
        behavior: "flag weak = contact_force < 3 N
            entry a
            mode a { halt()  1: heavy_obstacle -> b }
            mode b { halt()  1: after 1 s -> a }",
        codes: &["LM0208"],
        told: &["nothing reads the flag `weak`"],
    },
    Defect {
        what: "a flag that is not declared",
        behavior: "flag weak = contact_force < 3 N
            entry a
            mode a { halt()  1: heavy_obstacle -> b  2: waek -> b }
            mode b { halt()  1: weak and after 1 s -> a }",
        codes: &["LM0201"],
        told: &["no flag, event or sensor is named `waek`", "did you mean `weak`?"],
    },
    Defect {
        what: "no entry",
        behavior: "mode a { halt()  1: heavy_obstacle -> b }
            mode b { halt()  1: after 1 s -> a }",
        codes: &["LM0401"],
        told: &["`it` does not say in which mode it starts", "write `entry a`"],
    },
    Defect {
        what: "a longer timer under a shorter one",
        behavior: "entry a
            mode a { halt()  1: after 1 s -> b  2: after 2 s and heavy_obstacle -> c  3: heavy_obstacle -> c }
            mode b { halt()  1: after 1 s -> a }
            mode c { halt()  1: after 1 s -> a }",
        codes: &["LM0413"],
        told: &["`a` never lasts until the transition to `c`", "leaves the mode before"],
    },
    Defect {
        what: "a mode whose only way in is a masked exit",
        behavior: "entry a
            mode a { halt()  1: forward_collision -> b  2: heavy_obstacle -> c }
            mode b { halt()  1: after 1 s -> a }
            mode c { halt()  1: after 1 s -> d }
            mode d { halt()  1: after 1 s -> a }",
        codes: &["LM0414", "LM0402"],
        told: &["no transition to `c` is ever taken", "never taken"],
    },
    Defect {
        what: "a cycle of modes of one tick",
        behavior: "entry a
            mode a { halt()  1: forward_collision -> b }
            mode b { halt()  1: contact_force > 80 N -> c  2: after 1 s -> a }
            mode c { halt()  1: heavy_obstacle -> a }",
        codes: &["LM0416"],
        told: &[
            "`a`, `b`, `c` follow each other on every tick",
            "as long as the readings stay: ",
            "`contact_force` at ",
        ],
    },
    Defect {
        what: "a timer that `again` starves",
        behavior: "entry a
            mode a { halt()  1: after 1 s -> again  2: after 2 s -> b  3: heavy_obstacle -> b }
            mode b { halt()  1: after 1 s -> a }",
        codes: &["LM0420"],
        told: &["the timer of the transition to `b` is always restarted before it ends", "restarts the timer before"],
    },
    Defect {
        what: "guards that together are always true",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle -> b  2: not heavy_obstacle -> c }
            mode b { halt()  1: after 1 s -> c }
            mode c { halt()  1: after 1 s -> a }",
        codes: &["LM0411"],
        told: &["`a` is always left on its first tick", "one of these always holds"],
    },
    Defect {
        what: "an island of modes",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle -> b }
            mode b { halt()  1: after 1 s -> a }
            mode c { halt()  1: after 1 s -> d }
            mode d { halt()  1: after 1 s -> c  2: heavy_obstacle -> a }",
        codes: &["LM0417"],
        told: &["`c`, `d` lead only to each other, and nothing leads to them", "the machine starts here"],
    },
    Defect {
        what: "a mode that is declared twice",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle -> b }
            mode b { halt()  1: after 1 s -> a }
            mode b { halt()  1: after 2 s -> a }",
        codes: &["LM0202"],
        told: &["mode `b` is declared twice", "first declared here"],
    },
    Defect {
        what: "two modes that swap on a flag and its negation",
        behavior: "entry a
            mode a { halt()  1: heavy_obstacle -> b }
            mode b { halt()  1: not heavy_obstacle -> a }",
        codes: &["LM0419"],
        told: &["noise alone can drive `a` and `b` to and fro", "`contact_force` has a noise of 2 N"],
    },
    Defect {
        what: "a command that another overrides",
        behavior: "entry a
            mode a { halt() drive(26 cm/s)  1: heavy_obstacle -> b }
            mode b { halt()  1: after 1 s -> a }",
        codes: &["LM0422"],
        told: &["`halt` is overridden by `drive` on the same tick"],
    },
];

/// Codes that are one entry of the catalogue: names that nothing declares.
const SHARED: [&str; 1] = ["LM0201"];

#[track_caller]
fn found(what: &str, text: &str, codes: &[&str], told: &[&str]) {
    let analysis = analyze_texts(&[("it.msd", text)]);
    let text = report(&analysis);
    // What failures do has tests of its own.
    let found = doubts(&analysis).into_iter().filter(|finding| !finding.rule.is_about_faults());
    let found: BTreeSet<_> = found.map(|finding| finding.rule.code).collect();
    assert_eq!(found, codes.iter().copied().collect(), "{what}\n{text}");
    let own = analysis.findings.iter().find(|finding| finding.rule.code == codes[0]).unwrap();
    let labels = own.labels.iter().map(|label| label.message.as_str());
    let said: Vec<_> = [own.text()].into_iter().chain(labels.map(str::to_owned)).collect();
    for words in told {
        assert!(said.iter().any(|said| said.contains(words)), "{what}: {words}\n{text}");
    }
}

#[test]
fn each_defect_is_found_by_its_own_code() {
    let imports = "import std.networks.obstacle_id\nimport std.robots.j5\n";
    let mut seen = BTreeSet::new();
    for Defect { what, behavior, codes, told } in DEFECTS {
        let text = format!("{imports}behavior it on j5 {{\n{SENSE}\n{behavior}\n}}\n");
        found(what, &text, codes, told);
        assert!(seen.insert(codes[0]) || SHARED.contains(&codes[0]), "{what}: {}", codes[0]);
    }
}

#[test]
fn a_heavy_obstacle_below_a_collision_is_never_seen() {
    let text = "import std.behaviors.obstacle_manipulation
        behavior it extends obstacle_manipulation {
            mode forward {
                drive(26 cm/s)
                1: forward_collision -> push
                2: heavy_obstacle    -> stop
            }
        }";
    let told = ["the transition to `stop` can never be taken", "holds whenever the lower one does"];
    found("heavy below collision", text, &["LM0402"], &told);
}
