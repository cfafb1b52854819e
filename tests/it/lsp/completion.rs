//! What can be written, by place, in texts that are half written.

use serde_json::Value;

use super::client::Client;

/// What is offered at the `|` of a text; the text is whole but for what is being written there.
fn offered(client: &mut Client, name: &str, text: &str) -> Vec<String> {
    let (before, after) = text.split_once('|').unwrap();
    client.open(name, &format!("{before}{after}"));
    let place = client.place(name, before, "");
    let items = client.request("textDocument/completion", place);
    items.as_array().unwrap().iter().map(|item| item["label"].as_str().unwrap().to_owned()).collect()
}

const NETWORK: &str = "\
variable contact: N in 0 .. 400 {
    low  = ramp(80, 20)
    high = ramp(20, 80)
}
variable slope: deg in -20 .. 20 {
    down = ramp(0, -10)
    up   = ramp(0, 10)
}
network bump(force: contact, pitch: slope) {
    event bumped {
        contributor (high, _)
        detractor
            (low, {down, up})
            ROW
    }
    event tilted over (pitch) {
        contributor (up)
        TILT
    }
}
VARIABLE
";

fn in_network(client: &mut Client, place: &str, written: &str) -> Vec<String> {
    let text = ["ROW", "TILT", "VARIABLE"]
        .iter()
        .fold(NETWORK.to_owned(), |text, known| text.replace(known, if *known == place { written } else { "" }));
    offered(client, "bump.fsfn", &text)
}

#[test]
fn a_cell_takes_the_terms_of_its_variable() {
    let mut client = Client::new(&[]);
    let mut row = |written: &str| in_network(&mut client, "ROW", written);
    assert_eq!(row("(|"), ["_", "high", "low"]);
    assert_eq!(row("(low, |"), ["_", "down", "up"]);
    assert_eq!(row("(low, {down, u|})"), ["_", "down", "up"]);
    assert_eq!(row("({low, high}, d|"), ["_", "down", "up"]);
    assert_eq!(row("rule |"), ["force", "not", "pitch"]);
    assert_eq!(row("rule force |"), ["is"]);
    assert_eq!(row("rule force is |"), ["any of {", "high", "low"]);
    assert_eq!(row("rule force is low and (pitch is d|"), ["any of {", "down", "up"]);
    assert_eq!(row("rule force is low and |"), ["force", "not", "pitch"]);
    assert_eq!(row("|"), ["contributor", "detractor", "rule"]);
    assert_eq!(in_network(&mut client, "TILT", "detractor (|"), ["_", "down", "up"]);
    assert!(client.leave());
}

#[test]
fn variables_and_networks_are_written_from_what_there_is() {
    let mut client = Client::new(&[]);
    let mut there = |written: &str| in_network(&mut client, "VARIABLE", written);
    let shapes = there("variable v: m in 0 .. 1 { a = |");
    assert!(
        ["gaussian", "not", "points", "ramp", "very"].iter().all(|shape| shapes.contains(&(*shape).to_owned())),
        "{shapes:?}"
    );
    assert!(there("variable v: |").contains(&"rpm".to_owned()));
    assert_eq!(there("network n(a: |"), ["contact", "slope"]);
    assert_eq!(there("|"), ["import", "network", "variable"]);
    assert_eq!(there("// network n(a: |"), <[&str; 0]>::default());
    assert!(client.leave());
}

const WANDER: &str = "\
import bump
import std.robots.j5
behavior wander on j5 {
    sense bump(force: contact_force, pitch: contact_force)
    flag hard = contact_force > 100 N
    entry go
    BODY
    mode go {
        drive(26 cm/s)
        MODE
        1: bumped -> back
    }
    mode back requires contact_force else go {
        drive(-20 cm/s)
        1: after 2 s -> go
    }
}
END
";

fn in_behavior(client: &mut Client, place: &str, written: &str) -> Vec<String> {
    let network = ["ROW", "TILT", "VARIABLE"].iter().fold(NETWORK.to_owned(), |text, known| text.replace(known, ""));
    client.open("bump.fsfn", &network.replace("deg in", "N in"));
    let text = ["BODY", "MODE", "END"]
        .iter()
        .fold(WANDER.to_owned(), |text, known| text.replace(known, if *known == place { written } else { "" }));
    offered(client, "wander.msd", &text)
}

#[test]
fn modes_conditions_and_commands_are_offered_where_they_belong() {
    let mut client = Client::new(&[("lib/turns.msd", "robot other {}"), ("bump.fsfn", "")]);
    let mut mode = |written: &str| in_behavior(&mut client, "MODE", written);
    assert_eq!(mode("2: hard -> |"), ["again", "back", "go"]);
    assert_eq!(mode("2: hard -> ba|"), ["again", "back", "go"]);
    let sensors = ["blocked", "contact_force", "left_wheel_acceleration", "overloaded", "right_wheel_acceleration"];
    assert_eq!(mode("2: failed(|"), sensors);
    assert_eq!(mode("2: bump.|"), ["bumped", "tilted"]);
    for half in ["2: |", "2: not |", "2: hard and |", "2: held(b|", "2: (hard or t|", "2: hard and (not t|"] {
        let conditions = mode(half);
        let wanted = ["after", "bumped", "contact_force", "failed", "hard", "tilted"];
        assert!(wanted.iter().all(|word| conditions.contains(&(*word).to_owned())), "{half}: {conditions:?}");
        assert!(!conditions.contains(&"go".to_owned()), "{half}: a mode is no condition of a behavior");
    }
    assert!(mode("2: contact_force > 3 |").contains(&"kN".to_owned()));
    let commands = mode("|");
    assert!(
        ["arc", "drive", "halt", "on", "turn"].iter().all(|word| commands.contains(&(*word).to_owned())),
        "{commands:?}"
    );
    assert_eq!(mode("arc(|"), ["radius: ", "random", "speed: "]);
    assert!(mode("arc(2 |").contains(&"cm".to_owned()));
    let mut body = |written: &str| in_behavior(&mut client, "BODY", written);
    assert_eq!(body("|"), ["entry", "final", "flag", "mode", "sense"]);
    assert_eq!(body("sense |"), ["bump"]);
    let sensors = ["blocked", "contact_force", "left_wheel_acceleration", "overloaded", "right_wheel_acceleration"];
    assert_eq!(body("mode stop requires |"), sensors);
    assert_eq!(body("mode stop requires contact_force else |"), ["back", "go"]);
    assert!(body("flag f = |").contains(&"bumped".to_owned()));
    assert!(body("sense bump(|").contains(&"force: ".to_owned()));
    assert!(client.leave());
}

#[test]
fn a_decision_table_takes_terms_and_commands() {
    let mut client = Client::new(&[("bump.fsfn", "")]);
    let mut table = |written: &str| in_behavior(&mut client, "MODE", &format!("decide (force, hard) {{ {written} }}"));
    assert_eq!(table("(|"), ["_", "high", "low"]);
    assert_eq!(table("(low, |"), ["_", "clear", "set"]);
    assert_eq!(table("(low, _) => nothing\n ({low, h|"), ["_", "high", "low"]);
    assert_eq!(table("(low, _) => halt()\n (high, |"), ["_", "clear", "set"]);
    for half in ["(low, _) => |", "(low, _) => dri|", "(low, _) => either(|"] {
        let commands = table(half);
        assert!(
            ["arc", "drive", "halt", "turn"].iter().all(|word| commands.contains(&(*word).to_owned())),
            "{half}: {commands:?}"
        );
    }
    assert!(table("(low, _) => |").contains(&"nothing".to_owned()));
    let columns = in_behavior(&mut client, "MODE", "decide (|) { }");
    assert!(
        ["force", "pitch", "hard", "bumped"].iter().all(|word| columns.contains(&(*word).to_owned())),
        "{columns:?}"
    );
}

#[test]
fn a_robot_is_offered_what_it_has_and_senses() {
    let mut client = Client::new(&[("r.msd", "")]);
    let mut robot = |written: &str| {
        let text = "import std.networks.obstacle_id\nrobot r {\n    sensor force: N in 0 .. 400 fails 0
    sensor speed[2]: m/s^2 in -4 .. 4 fails 0\n    sense obstacle_id(speed[0], speed[1], force)\n    ";
        offered(&mut client, "r.msd", &format!("{text}{written}\n}}\n"))
    };
    assert_eq!(robot("sense |"), ["obstacle_id"]);
    for half in ["logical l = |", "logical l = force > 3 N and |", "logical l = not |"] {
        let conditions = robot(half);
        let all = ["force", "forward_collision", "heavy_obstacle", "failed"];
        assert!(all.iter().all(|word| conditions.contains(&(*word).to_owned())), "{half}: {conditions:?}");
    }
}

#[test]
fn what_follows_a_behavior_speaks_of_it() {
    let mut client = Client::new(&[("lib/turns.msd", "robot other {}"), ("a.msd", "")]);
    let mut end = |written: &str| in_behavior(&mut client, "END", written);
    assert_eq!(end("behavior b on |"), ["j5"]);
    assert_eq!(end("behavior b extends |"), ["wander"]);
    assert_eq!(end("scenario s runs |"), ["wander"]);
    assert_eq!(end("scenario s runs wander { expect modes go, |"), ["back", "go"]);
    assert!(end("scenario s runs wander { expect never |").contains(&"back".to_owned()));
    let sensors = ["blocked", "contact_force", "left_wheel_acceleration", "overloaded", "right_wheel_acceleration"];
    assert_eq!(end("scenario s runs wander { fault |"), sensors);
    assert!(end("property p: never |").contains(&"go".to_owned()));
    assert_eq!(end("import |"), ["a", "bump", "lib", "std"]);
    assert_eq!(end("import lib.|"), ["turns"]);
    assert_eq!(end("import std.robots.|"), ["car", "j5", "labmate", "scout"]);
    assert!(client.leave());
}

#[test]
fn something_is_answered_all_over_every_example() {
    let mut client = Client::new(&[]);
    for path in crate::support::files_below("examples/j5", &["msd", "fsfn"])
        .into_iter()
        .chain(crate::support::files_below("stdlib", &["msd", "fsfn"]))
    {
        let text = std::fs::read_to_string(crate::support::root().join(&path)).unwrap();
        let name = path.replace('/', "_");
        client.open(&name, &text);
        for (line, text) in text.lines().enumerate().step_by(5) {
            for character in (0..=text.len()).step_by(7) {
                let place = serde_json::json!({ "textDocument": { "uri": super::client::uri(&name) }, "position": { "line": line, "character": character } });
                let items: Value = client.request("textDocument/completion", place.clone());
                assert!(items.is_array());
                client.request("textDocument/hover", place);
            }
        }
    }
    assert!(client.leave());
}

#[test]
fn what_runs_inside_a_mode_is_named_by_its_modes() {
    const LAYERS: &str = "
robot cart {
    sensor x: 1 in 0 .. 10 fails 0
    action say(word: 1)
}
behavior inner on cart {
    entry a
    mode a { say(1)  1: x > 5 -> b }
    mode b { say(2)  1: x < 5 -> a }
}
activity middle on cart {
    entry m
    mode m = inner { 1: x > 9 -> n }
    mode n = inner { 1: x < 1 -> m }
}
goal outer on cart {
    entry o
    mode o = middle {
        1: x > 9 -> p
        WRITTEN
    }
    mode p = inner { 1: x < 1 -> o }
}
";
    let mut client = Client::new(&[]);
    let mut goal = |written: &str| offered(&mut client, "layers.msd", &LAYERS.replace("WRITTEN", written));
    assert_eq!(goal("2: o.|"), ["m", "mode", "n"]);
    assert_eq!(goal("2: o.mode is |"), ["m", "n"]);
    assert_eq!(goal("2: x > 1 and o.m.mode is |"), ["a", "b"]);
    assert_eq!(goal("2: o.nothing.mode is |"), [""; 0]);
    let condition = goal("2: |");
    assert!(["o", "p", "x"].iter().all(|name| condition.iter().any(|known| known == name)), "{condition:?}");
}
