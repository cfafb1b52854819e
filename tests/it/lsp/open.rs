//! Long work on what stands open.

use serde_json::json;

use super::client::{Client, uri};

const CANCELLED: i32 = -32800;

/// A behavior of many modes, and so many properties of it.
fn long(modes: usize, properties: usize) -> String {
    let mut text = "import std.robots.j5\nbehavior big on j5 {\n    entry m0\n".to_owned();
    for mode in 0..modes {
        let next = (mode + 1) % modes;
        text += &format!("    mode m{mode} {{\n        drive(26 cm/s)\n        1: after 2 s -> m{next}\n    }}\n");
    }
    text += "}\n";
    for property in 0..properties {
        text += &format!("property p{property}: m0 leads to m{} within 10 s\n", property + 1);
    }
    text
}

#[test]
fn a_request_that_is_taken_back_while_the_server_is_busy_is_not_carried_out() {
    let mut client = Client::new(&[]);
    client.open("a.msd", &long(400, 0));
    let of_file = json!({ "textDocument": { "uri": uri("a.msd") } });
    let first = client.ask("textDocument/semanticTokens/full", of_file.clone());
    let second = client.ask("textDocument/documentSymbol", of_file.clone());
    let third = client.ask("textDocument/documentSymbol", of_file);
    client.notify("$/cancelRequest", json!({ "id": second }));
    client.notify("$/cancelRequest", json!({ "id": "never asked" }));
    assert!(client.answer(first).response_result.is_ok());
    assert_eq!(client.answer(second).response_result.unwrap_err().code, CANCELLED);
    assert!(client.answer(third).response_result.is_ok());
    assert!(client.leave());
}

#[test]
fn requests_are_answered_while_properties_are_looked_at() {
    let silence = std::time::Duration::from_millis(600);
    let mut client = Client::new(&[]);
    client.open("a.msd", &long(200, 150));
    assert!(client.wait("a.msd").is_empty());
    std::thread::sleep(silence);
    let outline = client.request("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri("a.msd") } }));
    assert_eq!(outline.as_array().unwrap().len(), 151);
    assert!(client.messages("a.msd").is_empty(), "the properties were looked at already");
    // The long way is given up: what is asked for now is another one.
    let (from, _) = client.text("a.msd").split_once("property p1:").unwrap();
    let rest = client.text("a.msd")[from.len()..].to_owned();
    client.replace("a.msd", &rest, "property late: m0 leads to m7 within 10 s\n");
    assert_eq!(client.wait("a.msd").len(), 1);
    assert!(client.messages("a.msd")[0].contains("late"), "{:?}", client.messages("a.msd"));
    assert!(client.leave());
}
