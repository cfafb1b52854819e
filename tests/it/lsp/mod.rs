//! The language server, driven through its protocol.

mod client;
mod completion;
mod features;
mod names;
mod open;
mod stdio;

use serde_json::{Value, json};

use client::{Client, uri};

pub const ROBOT: &str = "\
import std.robots.j5

/// Fährt 🌏 hin und her.
behavior to_and_fro on j5 {
    entry there
    mode there {
        drive(26 cm/s)
        1: after 2 s -> back
    }
    mode back {
        drive(-26 cm/s)
        1: after 2 s -> there
    }
}
";

#[test]
fn a_half_written_file_has_one_finding_and_none_when_it_is_whole_again() {
    let mut client = Client::new(&[]);
    client.open("a.msd", ROBOT);
    assert!(client.wait("a.msd").is_empty());
    client.replace("a.msd", "1: after 2 s -> back", "1: after 2 s -> ");
    let broken = client.wait("a.msd");
    assert_eq!(broken.len(), 1, "{broken:?}");
    assert!(broken[0].starts_with("1 "), "{broken:?}");
    client.replace("a.msd", "1: after 2 s -> ", "1: after 2 s -> bak");
    assert_eq!(client.wait("a.msd"), ["1 no mode is named `bak`"]);
    let found = client.found["a.msd"][0].clone();
    assert_eq!((found["code"].as_str(), found["source"].as_str()), (Some("LM0201"), Some("lmslc")));
    assert_eq!(client.slice("a.msd", &found["range"]), "bak");
    assert!(found["message"].as_str().unwrap().ends_with("help: did you mean `back`?"), "{found}");
    client.replace("a.msd", "bak", "back");
    assert!(client.wait("a.msd").is_empty());
    assert!(client.leave());
}

#[test]
fn every_text_that_is_typed_on_the_way_is_answered() {
    let mut client = Client::new(&[]);
    client.open("a.msd", "");
    assert!(client.wait("a.msd").is_empty());
    for (start, end) in ROBOT.char_indices().map(|(at, c)| (at, at + c.len_utf8())) {
        let place = lmslc::lsp::Lines::new(&ROBOT[..start]).position(&ROBOT[..start], start);
        let change = json!({ "range": { "start": place, "end": place }, "text": &ROBOT[start..end] });
        let document = json!({ "uri": uri("a.msd"), "version": start });
        client.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
        client.request(
            "textDocument/formatting",
            json!({ "textDocument": { "uri": uri("a.msd") }, "options": { "tabSize": 4, "insertSpaces": true } }),
        );
    }
    assert!(client.leave());
}

#[test]
fn an_unsaved_file_imports_another_unsaved_one() {
    let mut client = Client::new(&[("b.msd", "behavior old on j5 {}")]);
    client.open("a.msd", "import b\nscenario s runs to_and_fro { duration 3 s }");
    assert_eq!(client.wait("a.msd").first().unwrap(), "1 no behavior is named `to_and_fro`");
    client.open("b.msd", ROBOT);
    assert!(client.wait("a.msd").is_empty());
    client.replace("b.msd", "to_and_fro", "fro_and_to");
    assert_eq!(client.wait("a.msd").first().unwrap(), "1 no behavior is named `to_and_fro`");
    // What is on the disk counts again.
    client.replace("b.msd", "fro_and_to", "to_and_fro");
    assert!(client.wait("a.msd").is_empty());
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri("b.msd") } }));
    assert_eq!(client.wait("a.msd").first().unwrap(), "1 no behavior is named `to_and_fro`");
    assert!(client.leave());
}

#[test]
fn a_refuted_property_is_told_when_the_client_is_silent() {
    let mut client = Client::new(&[]);
    client.open("a.msd", &format!("{ROBOT}property never_back: never back\n"));
    assert!(client.wait("a.msd").is_empty());
    assert!(client.wait("a.msd")[0].contains("never_back"), "{:?}", client.messages("a.msd"));
    assert!(client.leave());
}

#[test]
fn what_is_not_of_the_language_is_left_alone() {
    let mut client = Client::new(&[]);
    client.open("notes.txt", "mode {");
    assert_eq!(formatting(&mut client, "notes.txt"), Value::Null);
    client.open("a.msd", ROBOT);
    client.wait("a.msd");
    assert_eq!(client.found.keys().collect::<Vec<_>>(), ["a.msd"]);
    assert!(client.leave());
}

fn formatting(client: &mut Client, name: &str) -> Value {
    let options = json!({ "tabSize": 4, "insertSpaces": true });
    client.request("textDocument/formatting", json!({ "textDocument": { "uri": uri(name) }, "options": options }))
}

#[test]
fn formatting_changes_the_lines_that_are_not_as_they_should_be() {
    let mut client = Client::new(&[]);
    client.open("a.msd", &ROBOT.replace("        drive(-26 cm/s)", "  drive( -26 cm/s )"));
    let edits = formatting(&mut client, "a.msd");
    assert_eq!(edits.as_array().unwrap().len(), 1);
    assert_eq!(client.slice("a.msd", &edits[0]["range"]), "  drive( -26 cm/s )\n");
    assert_eq!(edits[0]["newText"], "        drive(-26 cm/s)\n");
    client.replace("a.msd", "  drive( -26 cm/s )", "        drive(-26 cm/s)");
    assert_eq!(formatting(&mut client, "a.msd"), json!([]));
    client.replace("a.msd", "drive(-26 cm/s)", "drive(-26 cm/s");
    assert_eq!(formatting(&mut client, "a.msd"), json!([]), "what does not parse is left alone");
    assert!(client.leave());
}

#[test]
fn the_life_of_a_server_is_the_protocols() {
    const NOT_INITIALIZED: i32 = -32002;
    const INVALID_REQUEST: i32 = -32600;
    const NO_METHOD: i32 = -32601;
    const INVALID_PARAMETERS: i32 = -32602;
    let mut early = Client::unknown(&[]);
    assert_eq!(early.refused("textDocument/hover", json!({})).0, NOT_INITIALIZED);
    assert!(!early.hang_up());

    let mut client = Client::new(&[]);
    assert_eq!(client.refused("textDocument/sing", json!({})).0, NO_METHOD);
    assert_eq!(client.refused("textDocument/formatting", json!({ "textDocument": 3 })).0, INVALID_PARAMETERS);
    client.notify("$/unheard", json!({}));
    client.notify("textDocument/didChange", json!({ "nothing": "fitting" }));
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri("never_opened.msd") } }));
    client.request("shutdown", Value::Null);
    assert_eq!(client.refused("textDocument/formatting", json!({})).0, INVALID_REQUEST);
    assert!(client.hang_up());

    assert!(!Client::new(&[]).hang_up(), "an exit without a shutdown is no orderly one");
}
