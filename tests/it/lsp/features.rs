//! Outlines, colors, fixes, signatures and hints.

use serde_json::{Value, json};

use super::client::{Client, uri};

const FILES: [(&str, &str); 2] = [
    (
        "bump.fsfn",
        "/// Kräfte 🌏.\nvariable contact: N in 0 .. 400 {\n    low  = ramp(80, 20)\n    high = ramp(20, 80) // 🌏 näher\n}\n\
         network bump(force: contact) {\n    event bumped {\n        contributor (high)\n        detractor (low)\n    }\n}\n",
    ),
    (
        "wander.msd",
        "import bump\nimport std.robots.j5\nimport std.interfaces.mobile_base\nbehavior wander on j5 {\n    sense bump(contact_force)\n    \
         flag idle = contact_force > 100 N\n    entry go\n    mode go {\n        drive(-26 cm/s)\n        1: bumped -> back\n    }\n    \
         mode back {\n        arc(20 cm/s, radius: 1 m)\n        1: after 500 ms -> go\n    }\n}\n",
    ),
];

fn desk() -> Client {
    let mut client = Client::new(&[("other.msd", "import std.robots.j5\nrobot spare {}\n")]);
    for (name, text) in FILES {
        client.open(name, text);
    }
    client
}

fn of(name: &str) -> Value {
    json!({ "textDocument": { "uri": uri(name) } })
}

fn outline(symbols: &Value, depth: usize) -> String {
    let one = |symbol: &Value| {
        let children = symbol.get("children").map_or(String::new(), |children| outline(children, depth + 1));
        format!("{}{}\n{children}", "  ".repeat(depth), symbol["name"].as_str().unwrap())
    };
    symbols.as_array().unwrap().iter().map(one).collect()
}

#[test]
fn files_are_outlined_even_half_written() {
    let mut client = desk();
    let symbols = client.request("textDocument/documentSymbol", of("bump.fsfn"));
    assert_eq!(outline(&symbols, 0), "contact\n  low\n  high\nbump\n  bumped\n");
    assert_eq!(client.slice("bump.fsfn", &symbols[0]["children"][1]["selectionRange"]), "high");
    assert_eq!(client.slice("bump.fsfn", &symbols[0]["children"][1]["range"]), "high = ramp(20, 80)");
    client.replace("wander.msd", "1: bumped -> back", "1: bumped ->");
    let symbols = client.request("textDocument/documentSymbol", of("wander.msd"));
    assert_eq!(outline(&symbols, 0), "wander\n  idle\n  go\n  back\n");
    assert!(client.leave());
}

#[test]
fn declarations_are_found_by_some_of_their_letters() {
    let mut client = desk();
    let mut found = |query: &str| {
        let found = client.request("workspace/symbol", json!({ "query": query }));
        let shown =
            |symbol: &Value| format!("{} {}", symbol["name"].as_str().unwrap(), Client::shown(&symbol["location"]));
        found.as_array().unwrap().iter().map(shown).collect::<Vec<_>>()
    };
    assert_eq!(found("bmp"), ["bump bump.fsfn:6:9", "bumped bump.fsfn:7:11"]);
    assert_eq!(found("SPARE"), ["spare other.msd:2:7"], "in a file that is not open");
    assert_eq!(found("drive"), <[&str; 0]>::default(), "not in the library");
    assert!(client.leave());
}

#[test]
fn words_are_colored_by_what_they_mean() {
    let mut client = desk();
    let mut legend = Client::unknown(&[]);
    let greeting = legend.request("initialize", json!({ "capabilities": {} }));
    let types = &greeting["capabilities"]["semanticTokensProvider"]["legend"]["tokenTypes"];
    let mut colors = |name: &str| {
        let data = client.request("textDocument/semanticTokens/full", of(name))["data"].clone();
        let numbers: Vec<u64> = data.as_array().unwrap().iter().map(|number| number.as_u64().unwrap()).collect();
        let (mut line, mut column, mut shown) = (0, 0, Vec::new());
        for token in numbers.chunks(5) {
            column = if token[0] == 0 { column + token[1] } else { token[1] };
            line += token[0];
            let place = |character: u64| json!({ "line": line, "character": character });
            let range = json!({ "start": place(column), "end": place(column + token[2]) });
            let declared = if token[4] == 1 { "!" } else { "" };
            let kind = types[usize::try_from(token[3]).unwrap()].as_str().unwrap();
            shown.push(format!("{} {kind}{declared}", client.slice(name, &range)));
        }
        shown
    };
    let bump = colors("bump.fsfn");
    for wanted in [
        "/// Kräfte 🌏. comment",
        "variable keyword",
        "contact type!",
        "N number",
        "low enumMember!",
        "ramp function",
        "// 🌏 näher comment",
        "bump namespace!",
        "force parameter!",
        "contact type",
        "bumped event!",
        "high enumMember",
    ] {
        assert!(bump.contains(&wanted.to_owned()), "{wanted}: {bump:?}");
    }
    let wander = colors("wander.msd");
    for wanted in [
        "j5 class",
        "contact_force property",
        "idle variable!",
        "go enumMember",
        "drive method",
        "bumped event",
        "radius parameter",
    ] {
        assert!(wander.contains(&wanted.to_owned()), "{wanted}: {wander:?}");
    }
    legend.notify("exit", Value::Null);
    assert!(client.leave());
}

fn actions(client: &mut Client, before: &str, only: Option<&str>) -> Vec<(String, Value)> {
    let mut parameters = of("wander.msd");
    let place = client.place("wander.msd", before, "")["position"].clone();
    parameters["range"] = json!({ "start": place, "end": place });
    parameters["context"] = json!({ "diagnostics": [] });
    if let Some(only) = only {
        parameters["context"]["only"] = json!([only]);
    }
    let found = client.request("textDocument/codeAction", parameters);
    let shown = |action: &Value| {
        (action["title"].as_str().unwrap().to_owned(), action["edit"]["changes"][uri("wander.msd")].clone())
    };
    found.as_array().unwrap().iter().map(shown).collect()
}

#[test]
fn fixes_are_offered_and_mend_what_was_found() {
    let mut client = desk();
    assert!(client.wait("wander.msd").iter().any(|message| message.contains("nothing reads the flag `idle`")));
    let found = actions(&mut client, "flag idle", Some("quickfix"));
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].0, "remove the flag");
    let edits = found[0].1.as_array().unwrap();
    assert_eq!(edits.len(), 1);
    assert_eq!(client.slice("wander.msd", &edits[0]["range"]), "    flag idle = contact_force > 100 N\n");
    assert!(actions(&mut client, "entry", Some("quickfix")).is_empty());
    let all = actions(&mut client, "entry", Some("source.fixAll"));
    assert_eq!(all[0].0, "fix what can be fixed (2)");
    let fixed = all[0].1[0]["newText"].as_str().unwrap().to_owned();
    assert!(!fixed.contains("idle") && !fixed.contains("mobile_base"), "{fixed}");
    let whole = client.text("wander.msd").to_owned();
    client.replace("wander.msd", &whole, &fixed);
    assert!(
        client.wait("wander.msd").iter().all(|message| !message.starts_with('2')),
        "{:?}",
        client.messages("wander.msd")
    );
    assert!(client.leave());
}

fn signature(client: &mut Client, name: &str, old: &str, written: &str) -> (String, String) {
    client.replace(name, old, written);
    let place = client.place(name, written, "");
    let help = client.request("textDocument/signatureHelp", place);
    client.replace(name, written, old);
    let signature = &help["signatures"][0];
    let active = signature["activeParameter"].as_u64().unwrap_or(99) as usize;
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    (text(&signature["label"]), text(&signature["parameters"][active]["label"]))
}

#[test]
fn what_is_called_says_what_it_takes() {
    let mut client = desk();
    let pair = |label: &str, active: &str| (label.to_owned(), active.to_owned());
    let mut in_mode = |written: &str| signature(&mut client, "wander.msd", "arc(20 cm/s, radius: 1 m)", written);
    assert_eq!(in_mode("arc("), pair("arc(speed: m/s, radius: m)", "speed: m/s"));
    assert_eq!(in_mode("arc(20 cm/s, "), pair("arc(speed: m/s, radius: m)", "radius: m"));
    assert_eq!(in_mode("turn(random(-20 deg, "), pair("random(low, high)", "high"));
    assert_eq!(in_mode("2: held(bumped, "), pair("held(condition, time)", "time"));
    assert_eq!(in_mode("// arc("), pair("", ""));
    assert_eq!(in_mode("halt()"), pair("", ""), "behind the parentheses");
    let sense = signature(&mut client, "wander.msd", "sense bump(contact_force)", "sense bump(");
    assert_eq!(sense, pair("bump(force: N)", "force: N"));
    let shape = signature(&mut client, "bump.fsfn", "ramp(80, 20)", "trapezoid(1, 2, ");
    assert_eq!(shape, pair("trapezoid(a, b, c, d)", "c"));
    assert!(client.leave());
}

#[test]
fn quantities_are_hinted_in_si() {
    let mut client = desk();
    let mut hints = |name: &str, lines: u32| {
        let mut parameters = of(name);
        parameters["range"] =
            json!({ "start": { "line": 0, "character": 0 }, "end": { "line": lines, "character": 0 } });
        let found = client.request("textDocument/inlayHint", parameters);
        let shown = |hint: &Value| {
            format!(
                "{}:{} {}",
                hint["position"]["line"],
                hint["position"]["character"],
                hint["label"].as_str().unwrap()
            )
        };
        found.as_array().unwrap().iter().map(shown).collect::<Vec<_>>()
    };
    assert_eq!(hints("bump.fsfn", 99), ["1:16 2 terms"]);
    assert_eq!(hints("wander.msd", 99), ["8:22 = -0.26 m/s", "12:19 = 0.2 m/s", "13:23 = 0.5 s"]);
    assert_eq!(hints("wander.msd", 9), ["8:22 = -0.26 m/s"]);
    assert!(client.leave());
}
