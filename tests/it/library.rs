//! The library for any robot is whole: each behavior and activity on an interface has its section with its diagram, and
//! runs on two robots or more in the examples that the section names.

use std::collections::{BTreeMap, BTreeSet};

use lmslc::ir::Platform;

use crate::support::{analyze_path, files_below, root};

/// What the library has on interfaces: each diagram with its interface.
fn on_interfaces() -> BTreeMap<String, String> {
    let mut found = BTreeMap::new();
    for path in files_below("stdlib", &["msd"]) {
        let analysis = analyze_path(&path);
        let program = &analysis.program;
        for diagram in program.diagrams.values().filter(|of| analysis.roots.contains(&of.symbol.span.file)) {
            if let Platform::Interface(interface) = diagram.platform {
                found.insert(diagram.symbol.name.clone(), program.interfaces[interface].symbol.name.clone());
            }
        }
    }
    found
}

/// What the scenarios of an example run of the library: each diagram with its robots.
fn runs(path: &str) -> BTreeSet<(String, String)> {
    let analysis = analyze_path(path);
    let program = &analysis.program;
    let own = program.scenarios.values().filter(|scenario| analysis.roots.contains(&scenario.symbol.span.file));
    let runs = own.map(|scenario| (&program.diagrams[scenario.diagram].symbol, &program.robots[scenario.robot].symbol));
    let of_library = runs.filter(|(run, _)| analysis.sources.path(run.span.file).starts_with("std/"));
    of_library.map(|(run, robot)| (run.name.clone(), robot.name.clone())).collect()
}

#[test]
fn all_that_is_on_an_interface_is_shown_and_tried_on_two_robots() {
    let page = std::fs::read_to_string(root().join("docs/library.md")).unwrap();
    let sections: BTreeMap<&str, &str> =
        page.split("\n### ").skip(1).filter_map(|part| part.split_once('\n')).collect();
    let library = on_interfaces();
    assert_eq!(sections.keys().copied().collect::<Vec<_>>(), library.keys().collect::<Vec<_>>());
    for (name, interface) in &library {
        let section = sections[name.as_str()];
        assert!(section.trim_start().starts_with(&format!("On `{interface}`: ")), "{name} is on {interface}");
        assert!(section.contains(&format!("](images/{name}.svg)")), "{name} has no diagram");
        let examples = section.split('`').filter(|word| word.starts_with("examples/"));
        let tried: BTreeSet<_> = examples.flat_map(runs).filter(|(run, _)| run == name).collect();
        assert!(tried.len() >= 2, "{name} is tried on {tried:?} only");
    }
}
