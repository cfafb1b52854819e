//! Every room keeps to the imports and crates that its door declares, and the rooms form no circle.

use std::collections::{BTreeMap, BTreeSet};

use petgraph::algo::toposort;
use petgraph::graphmap::DiGraphMap;

use crate::support::{files_below, root};

struct Room {
    imports: BTreeSet<String>,
    crates: BTreeSet<String>,
    text: Vec<(String, String)>,
}

/// A room is a folder or a file of `src`; its door is its `mod.rs`, or the file.
fn rooms() -> BTreeMap<String, Room> {
    let mut texts: BTreeMap<String, Vec<(String, String)>> = BTreeMap::new();
    for path in files_below("src", &["rs"]) {
        let inside = path.strip_prefix("src/").unwrap();
        let room = inside.split('/').next().unwrap().trim_end_matches(".rs");
        if room != "lib" && room != "main" {
            let text = std::fs::read_to_string(root().join(&path)).unwrap();
            texts.entry(room.to_owned()).or_default().push((path, text));
        }
    }
    texts
        .into_iter()
        .map(|(name, text)| {
            let is_door = |path: &str| path == format!("src/{name}/mod.rs") || path == format!("src/{name}.rs");
            let (_, door) = text.iter().find(|(path, _)| is_door(path)).unwrap_or_else(|| panic!("{name} has no door"));
            let (imports, crates) = (declared(door, "//! Imports:", &name), declared(door, "//! Crates:", &name));
            (name, Room { imports, crates, text })
        })
        .collect()
}

fn declared(door: &str, line: &str, room: &str) -> BTreeSet<String> {
    let declared = door.lines().find_map(|text| text.strip_prefix(line));
    let declared = declared.unwrap_or_else(|| panic!("the door of `{room}` has no line `{line}`"));
    declared.split(',').map(str::trim).filter(|name| *name != "–").map(|name| name.replace('-', "_")).collect()
}

/// The words that stand in front of `::` and behind `prefix`, outside of comments.
fn words_behind<'t>(text: &'t str, prefix: &str) -> BTreeSet<&'t str> {
    let code = text.lines().map(|line| line.split("//").next().unwrap());
    let mut words = BTreeSet::new();
    for line in code {
        for (start, _) in line.match_indices(prefix) {
            let before = line[..start].chars().next_back();
            let word = &line[start + prefix.len()..];
            let end = word.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(word.len());
            if before.is_none_or(|c| !c.is_alphanumeric() && c != '_' && c != ':') && end > 0 {
                words.insert(&word[..end]);
            }
        }
    }
    words
}

fn dependencies() -> BTreeSet<String> {
    let manifest = std::fs::read_to_string(root().join("Cargo.toml")).unwrap();
    let section = manifest.split("[dependencies]").nth(1).unwrap().split("\n[").next().unwrap();
    let names = section.lines().filter_map(|line| line.split_once('=')).map(|(name, _)| name.trim().replace('-', "_"));
    names.collect()
}

#[test]
fn rooms_import_what_their_doors_say_and_nothing_else() {
    let rooms = rooms();
    for (name, room) in &rooms {
        let used: BTreeSet<String> = room
            .text
            .iter()
            .flat_map(|(_, text)| {
                let grouped = text.lines().filter_map(|line| line.trim().strip_prefix("use crate::{"));
                let grouped = grouped.flat_map(|names| {
                    names.split([',', '}']).map(|name| name.trim().split("::").next().unwrap().to_owned())
                });
                words_behind(text, "crate::").into_iter().map(str::to_owned).chain(grouped)
            })
            .filter(|used| rooms.contains_key(used) && used != name)
            .collect();
        assert_eq!(used, room.imports, "the imports of `{name}`: used and declared");
    }
}

#[test]
fn rooms_use_the_crates_their_doors_say_and_each_crate_has_one_owner() {
    let dependencies = dependencies();
    let mut owners: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for (name, room) in rooms() {
        let mut used = BTreeSet::new();
        for (_, text) in &room.text {
            for dependency in &dependencies {
                let path = format!("{dependency}::");
                let behind = |line: &str| {
                    line.match_indices(&path).any(|(start, _)| {
                        let before = line[..start].chars().next_back();
                        before.is_none_or(|c| !c.is_alphanumeric() && c != '_' && c != ':')
                    })
                };
                if text.lines().any(|line| behind(line.split("//").next().unwrap())) {
                    used.insert(dependency.clone());
                }
            }
        }
        assert_eq!(used, room.crates, "the crates of `{name}`: used and declared");
        for dependency in used {
            owners.entry(dependency).or_default().push(name.clone());
        }
    }
    // serde's derives stand where the types are; everything else has one owner.
    owners.remove("serde");
    let shared: Vec<_> = owners.iter().filter(|(_, owners)| owners.len() > 1).collect();
    assert!(shared.is_empty(), "crates with more than one owner: {shared:?}");
    let idle: Vec<_> = dependencies.iter().filter(|name| *name != "serde" && !owners.contains_key(*name)).collect();
    assert!(idle.is_empty(), "dependencies that no room uses: {idle:?}");
}

#[test]
fn rooms_form_no_circle() {
    let rooms = rooms();
    let mut graph = DiGraphMap::<&str, ()>::new();
    for (name, room) in &rooms {
        for import in &room.imports {
            graph.add_edge(name, import, ());
        }
    }
    assert!(toposort(&graph, None).is_ok(), "some rooms import each other");
}

#[test]
fn what_must_not_meet_does_not() {
    let rooms = rooms();
    let absent = [
        ("plan", "syntax"),
        ("plan", "sema"),
        ("interp", "ir"),
        ("emit", "ir"),
        ("analysis", "syntax"),
        ("report", "syntax"),
        ("sim", "syntax"),
        ("view", "sim"),
    ];
    for (room, other) in absent {
        assert!(!rooms[room].imports.contains(other), "`{room}` must not know `{other}`");
    }
    let kernel = &rooms["kernel"];
    assert!(kernel.imports.is_empty() && kernel.crates.iter().eq(["libm"]), "`kernel` knows nothing of ours");
}

#[test]
fn the_architecture_page_names_every_room() {
    let page = std::fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split('`').next());
    let named: BTreeSet<String> = rows.map(str::to_owned).collect();
    assert_eq!(named, rooms().into_keys().collect::<BTreeSet<_>>());
}
