//! What names mean: definitions, references, renaming, hovers.

use serde_json::{Value, json};

use super::client::{Client, uri};

/// A network and what it takes, with a comment whose characters are not one byte and not one code unit each.
const BUMP: &str = "\
/// Kräfte 🌏 am Keil.
variable contact: N in 0 .. 400 fails 0 {
    low  = ramp(80, 20)
    /* 🌏 */ high = ramp(20, 80)
}
network bump(force: contact) {
    /// Something was touched.
    event bumped {
        contributor (high)
        detractor rule force is low
    }
}
";

const WANDER: &str = "\
import bump
import std.robots.j5
behavior wander on j5 {
    sense bump(force: contact_force)
    entry go
    /// Straight ahead.
    mode go {
        drive(26 cm/s)
        1: bumped -> back
    }
    mode back {
        drive(-20 cm/s)
        1: after 2 s and not bump.bumped -> go
    }
}
behavior wander_on extends wander {
    mode go {
        arc(26 cm/s, radius: 2 m)
        1: bumped -> back
    }
}
property never_both of wander: never back and go
";

fn desk() -> Client {
    let bump = BUMP.replace("/* 🌏 */ ", "");
    let mut client = Client::new(&[]);
    client.open("bump.fsfn", &bump);
    client.open("wander.msd", WANDER);
    client
}

fn definitions(client: &mut Client, name: &str, before: &str, after: &str) -> Vec<String> {
    let place = client.place(name, before, after);
    let found = client.request("textDocument/definition", place);
    found.as_array().map(|found| found.iter().map(Client::shown).collect()).unwrap_or_default()
}

fn references(client: &mut Client, name: &str, before: &str, after: &str) -> Vec<String> {
    let mut place = client.place(name, before, after);
    place["context"] = json!({ "includeDeclaration": true });
    let found = client.request("textDocument/references", place);
    found.as_array().unwrap().iter().map(Client::shown).collect()
}

#[test]
fn names_lead_to_their_declarations() {
    let mut client = desk();
    let mut lead = |before: &str, after: &str| definitions(&mut client, "wander.msd", before, after).join(" ");
    assert_eq!(lead("-> ba", "ck"), "wander.msd:11:10", "a mode");
    assert_eq!(lead("1: bumped", " -> back"), "bump.fsfn:8:11", "an event, right behind its name");
    assert_eq!(lead("not bump.", "bumped"), "bump.fsfn:8:11");
    assert_eq!(lead("not b", "ump."), "wander.msd:4:11", "where the network is sensed");
    assert_eq!(lead("sense ", "bump"), "bump.fsfn:6:9", "the network");
    assert_eq!(lead("sense bump(", "force"), "bump.fsfn:6:14", "its input");
    assert_eq!(lead("impo", "rt bump"), "bump.fsfn:1:1", "a file");
    assert_eq!(lead("on ", "j5"), "file:///library/std/robots/j5.msd:11:7", "the library");
    assert_eq!(lead("(force: ", "contact_force"), "file:///library/std/robots/j5.msd:28:21");
    assert_eq!(lead("2 m)", ""), "", "no name");
    assert_eq!(lead("import std.", "robots"), "file:///library/std/robots/j5.msd:1:1");
    assert_eq!(lead("extends wander {\n    mode ", "go"), "wander.msd:7:10", "what it stands in the place of");
    assert_eq!(definitions(&mut client, "bump.fsfn", "force is ", "low"), ["bump.fsfn:3:5"]);
    assert_eq!(definitions(&mut client, "bump.fsfn", "(force: ", "contact"), ["bump.fsfn:2:10"]);
    assert!(client.leave());
}

#[test]
fn a_definition_is_found_beside_what_is_half_written() {
    let mut client = desk();
    client.replace("wander.msd", "drive(26 cm/s)", "drive(26");
    assert_eq!(definitions(&mut client, "wander.msd", "not bump.", "bumped"), ["bump.fsfn:8:11"]);
    assert!(client.leave());
}

#[test]
fn references_are_found_across_files() {
    let mut client = desk();
    let bumped = ["bump.fsfn:8:11", "wander.msd:9:12", "wander.msd:13:35", "wander.msd:19:12"];
    assert_eq!(references(&mut client, "wander.msd", "1: ", "bumped"), bumped);
    assert_eq!(references(&mut client, "bump.fsfn", "event ", "bumped"), bumped);
    assert_eq!(
        references(&mut client, "wander.msd", "entry ", "go"),
        ["wander.msd:5:11", "wander.msd:7:10", "wander.msd:13:45", "wander.msd:17:10", "wander.msd:22:47"],
        "with the mode that stands in its place"
    );
    let drive = references(&mut client, "wander.msd", "", "drive");
    assert!(drive.contains(&"file:///library/std/interfaces/mobile_base.msd:6:12".to_owned()), "{drive:?}");
    assert!(client.leave());
}

#[test]
fn references_are_found_in_files_that_are_not_open() {
    let mut client = Client::new(&[("wander.msd", WANDER), ("broken.msd", "import bump mode {")]);
    client.open("bump.fsfn", &BUMP.replace("/* 🌏 */ ", ""));
    let bumped = references(&mut client, "bump.fsfn", "event ", "bumped");
    assert_eq!(bumped, ["bump.fsfn:8:11", "wander.msd:9:12", "wander.msd:13:35", "wander.msd:19:12"]);
    assert!(client.leave());
}

/// Renames, and answers what stands in each file then.
fn rename(client: &mut Client, name: &str, before: &str, after: &str, new: &str) -> Value {
    let mut place = client.place(name, before, after);
    place["newName"] = json!(new);
    client.request("textDocument/rename", place)["changes"].clone()
}

#[test]
fn renaming_changes_every_file() {
    let mut client = desk();
    let changes = rename(&mut client, "wander.msd", "1: ", "bumped", "touched");
    let mut texts: Vec<(String, String)> = Vec::new();
    for (address, edits) in changes.as_object().unwrap() {
        let name = address.trim_start_matches("file:///home/robot/").to_owned();
        for edit in edits.as_array().unwrap() {
            assert_eq!(client.slice(&name, &edit["range"]), "bumped");
            assert_eq!(edit["newText"], "touched");
        }
        texts.push((name.clone(), client.text(&name).replace("bumped", "touched")));
        assert_eq!(edits.as_array().unwrap().len(), client.text(&name).matches("bumped").count());
    }
    assert_eq!(texts.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["bump.fsfn", "wander.msd"]);
    let analysis = crate::support::analyze_texts(&[("wander.msd", &texts[1].1), ("bump.fsfn", &texts[0].1)]);
    assert!(!analysis.has_errors(), "{}", crate::support::report(&analysis));
    assert!(client.leave());
}

#[test]
fn renaming_refuses_what_would_break_something() {
    let mut client = desk();
    let mut refused = |before: &str, after: &str, new: &str| {
        let mut place = client.place("wander.msd", before, after);
        place["newName"] = json!(new);
        client.refused("textDocument/rename", place).1
    };
    assert_eq!(refused("-> ", "back", "go"), "with that name mode `go` is declared twice");
    assert_eq!(refused("-> ", "back", "mode"), "`mode` is not a name");
    assert_eq!(refused("-> ", "back", "two words"), "`two words` is not a name");
    assert_eq!(
        refused("", "drive", "roll"),
        "`drive` is named in `std/robots/j5.msd`, which is of the standard library"
    );
    let place = client.place("wander.msd", "on ", "j5");
    assert!(client.refused("textDocument/prepareRename", place).1.contains("standard library"));
    let place = client.place("wander.msd", "-> ", "back");
    let range = client.request("textDocument/prepareRename", place);
    assert_eq!(client.slice("wander.msd", &range), "back");
    assert!(client.leave());
}

fn hover(client: &mut Client, name: &str, before: &str, after: &str) -> String {
    let place = client.place(name, before, after);
    let found = client.request("textDocument/hover", place);
    found["contents"]["value"].as_str().unwrap_or_default().to_owned()
}

#[test]
fn hovers_tell_what_there_is_to_know() {
    let mut client = desk();
    insta::assert_snapshot!("hover_variable", hover(&mut client, "bump.fsfn", "(force: ", "contact"));
    insta::assert_snapshot!("hover_term", hover(&mut client, "bump.fsfn", "(", "high"));
    insta::assert_snapshot!("hover_event", hover(&mut client, "wander.msd", "1: ", "bumped"));
    insta::assert_snapshot!("hover_mode", hover(&mut client, "wander.msd", "entry ", "go"));
    insta::assert_snapshot!("hover_exit", hover(&mut client, "wander.msd", "", "1: after 2 s"));
    insta::assert_snapshot!("hover_sensor", hover(&mut client, "wander.msd", "(force: ", "contact_force"));
    insta::assert_snapshot!("hover_action", hover(&mut client, "wander.msd", "", "arc"));
    assert_eq!(hover(&mut client, "wander.msd", "after ", "2 s"), "");
    assert!(client.leave());
}

#[test]
fn hovers_tell_of_time_and_accuracy() {
    let mut client = desk();
    let robot = "robot scout {
            body differential_drive { mass 20 kg  size (0.5 m, 0.4 m)  track 0.35 m  traction 0.6 }
            sensor sonar[8]: m in 15 cm .. 5 m  fails 5 m  = ring.range  accuracy 2.5 cm  period 60 ms  beam 45 deg
            logical front = min(sonar[7, 0]) within 1 cm
            action drive(speed: m/s) = body.velocity(speed, 0 deg/s)
        }
        behavior creep on scout {
            entry go
            mode go { drive(0.3 m/s)  1: front < 1 m -> back }
            final mode back { drive(-0.1 m/s) }
        }";
    client.open("scout.msd", robot);
    insta::assert_snapshot!("hover_mean", hover(&mut client, "scout.msd", "1: ", "front"));
    insta::assert_snapshot!("hover_reaction", hover(&mut client, "scout.msd", "entry ", "go"));
    assert!(client.leave());
}

#[test]
fn what_is_asked_of_a_file_that_is_not_open_has_no_answer() {
    let mut client = desk();
    let place = json!({ "textDocument": { "uri": uri("other.msd") }, "position": { "line": 9, "character": 9 } });
    assert_eq!(client.request("textDocument/hover", place.clone()), Value::Null);
    assert_eq!(client.request("textDocument/definition", place), Value::Null);
    assert!(client.leave());
}
