//! What stands open: texts without a file, files that are not open, and long work on what is.

use serde_json::{Value, json};

use super::ROBOT;
use super::client::{Client, uri};

const CANCELLED: i32 = -32800;

/// Opens a text that was never saved.
fn open_untitled(client: &mut Client, language: &str, text: &str) {
    let document = json!({ "uri": "untitled:Untitled-1", "languageId": language, "version": 1, "text": text });
    client.notify("textDocument/didOpen", json!({ "textDocument": document }));
}

/// Answers a request about that.
fn of_untitled(client: &mut Client, method: &str) -> Value {
    let options = json!({ "tabSize": 4, "insertSpaces": true });
    let position = json!({ "line": 0, "character": 0 });
    let document = json!({ "uri": "untitled:Untitled-1" });
    client.request(method, json!({ "textDocument": document, "position": position, "options": options }))
}

#[test]
fn a_text_that_was_never_saved_is_of_the_kind_that_it_is_written_for() {
    let mut client = Client::new(&[("b.msd", ROBOT)]);
    open_untitled(&mut client, "lmsl", "import b\nscenario s runs to_and_fro { duration 3 s }");
    assert!(client.wait("untitled:Untitled-1").is_empty());
    assert_eq!(of_untitled(&mut client, "textDocument/formatting").as_array().unwrap().len(), 1);
    assert_eq!(of_untitled(&mut client, "textDocument/documentSymbol")[0]["name"], "s");
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": "untitled:Untitled-1" } }));
    client.wait("untitled:Untitled-1");
    open_untitled(&mut client, "lmsl", "variable speed: m/s in 0 .. 1 {\n    slow = falling(0 m/s, 1 m)\n}\n");
    let found = client.wait("untitled:Untitled-1");
    assert!(
        found.iter().any(|found| found.contains('m')) && !found.iter().any(|found| found.contains(".msd")),
        "{found:?}"
    );
    let labels = of_untitled(&mut client, "textDocument/completion");
    let labels: Vec<_> = labels.as_array().unwrap().iter().map(|item| item["label"].as_str().unwrap()).collect();
    assert!(labels.contains(&"network") && !labels.contains(&"behavior"), "{labels:?}");
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": "untitled:Untitled-1" } }));
    client.wait("untitled:Untitled-1");
    open_untitled(&mut client, "plaintext", "variable {");
    client.open("a.msd", ROBOT);
    client.wait("a.msd");
    assert_eq!(client.found["untitled:Untitled-1"], Vec::<Value>::new(), "what is not of the language is left alone");
    assert!(client.leave());
}

#[test]
fn errors_in_a_file_that_is_not_open_are_told_where_it_is_imported() {
    let broken = ROBOT.replace("-> there", "-> nowhere").replace("drive(26 cm/s)", "drive(26 cm)");
    let mut client = Client::new(&[("b.msd", &broken), ("c.msd", "import b\n")]);
    let text = "import std.robots.j5\nimport c\nimport b\nscenario s runs to_and_fro { duration 3 s }";
    client.open("a.msd", text);
    let found = client.wait("a.msd");
    assert_eq!(found.iter().filter(|found| found.starts_with("1 `b.msd` has 2 errors: ")).count(), 1, "{found:?}");
    let at_import =
        client.found["a.msd"].iter().find(|found| found["message"].as_str().unwrap().starts_with("`b.msd`"));
    let at_import = at_import.unwrap().clone();
    assert_eq!(client.slice("a.msd", &at_import["range"]), "import b");
    let related = at_import["relatedInformation"].as_array().unwrap();
    let places: Vec<_> = related.iter().map(|related| Client::shown(&related["location"])).collect();
    assert_eq!(places, ["b.msd:7:15", "b.msd:12:25"]);
    assert!(related[1]["message"].as_str().unwrap().starts_with("no mode is named `nowhere`"), "{related:?}");

    client.open("b.msd", &broken);
    assert_eq!(client.wait("b.msd").len(), 2);
    let found = client.messages("a.msd");
    assert!(!found.iter().any(|found| found.contains("b.msd")), "an open file has its errors itself: {found:?}");
    client.notify("textDocument/didClose", json!({ "textDocument": { "uri": uri("b.msd") } }));
    assert!(client.wait("a.msd").iter().any(|found| found.contains("`b.msd` has 2 errors")));
    client.replace("a.msd", "import b\n", "");
    assert!(client.wait("a.msd").iter().any(|found| found.contains("`b.msd` has 2 errors")));
    let through = client.found["a.msd"].iter().find(|found| found["message"].as_str().unwrap().starts_with("`b.msd`"));
    let range = through.unwrap()["range"].clone();
    assert_eq!(client.slice("a.msd", &range), "import c", "it is imported through another");
    assert!(client.leave());
}

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
