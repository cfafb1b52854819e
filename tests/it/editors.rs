//! What editors are given agrees with the language: its keywords, shapes and units, and the snippets.

use std::collections::BTreeSet;

use lmslc::base::{FileId, UNITS};
use lmslc::sema;
use lmslc::syntax::ast::FileKind;
use lmslc::syntax::{format, parse};
use serde_json::Value;

use crate::support::{files_below, root};

fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap()
}

fn json(path: &str) -> Value {
    serde_json::from_str(&read(path)).unwrap()
}

/// The keywords of the grammar: what stands in quotes in the rules of keywords, and the words that join names.
fn keywords() -> BTreeSet<String> {
    let grammar: String = files_below("grammar", &["pest"]).iter().map(|path| read(path)).collect();
    let rules = ["kw_", "prefix ", "infix ", "connective ", "negation ", "hedge "];
    let lines = grammar.lines().filter(|line| rules.iter().any(|rule| line.starts_with(rule)));
    let words = lines.flat_map(|line| line.split('"').skip(1).step_by(2).map(str::to_owned));
    words.filter(|word| word.starts_with(char::is_alphabetic)).collect()
}

/// The lowercase words in the regular expressions of a grammar, without its classes and boundaries.
fn words_of(expression: &str) -> BTreeSet<String> {
    let mut plain = String::new();
    let mut classes = 0;
    let mut characters = expression.chars();
    while let Some(character) = characters.next() {
        match character {
            '\\' => plain.extend(characters.next().map(|_| ' ')),
            '[' => classes += 1,
            ']' => classes -= 1,
            _ if classes == 0 => plain.push(character),
            _ => {}
        }
    }
    let words = plain.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
    words
        .filter(|word| word.len() > 1 && word.starts_with(|c: char| c.is_ascii_lowercase()))
        .map(str::to_owned)
        .collect()
}

/// The regular expressions below a part of the grammar of VS Code.
fn expressions(of: &Value) -> Vec<&str> {
    match of {
        Value::Object(members) => members
            .iter()
            .flat_map(|(key, value)| match value {
                Value::String(text) if matches!(key.as_str(), "match" | "begin" | "end") => vec![text.as_str()],
                value => expressions(value),
            })
            .collect(),
        Value::Array(items) => items.iter().flat_map(expressions).collect(),
        _ => Vec::new(),
    }
}

fn words_below(of: &Value) -> BTreeSet<String> {
    expressions(of).into_iter().flat_map(words_of).collect()
}

/// The names of the functions and shapes of the language.
fn functions() -> BTreeSet<String> {
    let shapes = sema::shapes().map(|(name, _)| name);
    let functions = sema::FUNCTIONS.iter().map(|(name, _)| *name);
    shapes.chain(functions).chain(["random", "min", "max"]).map(str::to_owned).collect()
}

fn units() -> BTreeSet<String> {
    UNITS.iter().map(|unit| unit.name.to_owned()).collect()
}

#[test]
fn vs_code_knows_the_words_of_the_language_and_no_others() {
    let grammar = json("editors/vscode/syntaxes/lmsl.tmLanguage.json");
    let words = words_below(&grammar["repository"]);
    let ours: BTreeSet<_> = keywords().into_iter().chain(functions()).collect();
    let missing: Vec<_> = ours.difference(&words).collect();
    let units = units();
    let strange: Vec<_> = words.difference(&ours).filter(|word| !units.contains(*word)).collect();
    assert!(missing.is_empty() && strange.is_empty(), "missing {missing:?}, strange {strange:?}");
}

/// The words in quotes in a grammar of tree-sitter.
fn quoted(of: &Value) -> BTreeSet<String> {
    match of {
        Value::Object(members) if members.get("type").is_some_and(|kind| kind == "STRING") => {
            members["value"].as_str().map(str::to_owned).into_iter().collect()
        }
        Value::Object(members) => members.values().flat_map(quoted).collect(),
        Value::Array(items) => items.iter().flat_map(quoted).collect(),
        _ => BTreeSet::new(),
    }
}

#[test]
fn tree_sitter_knows_the_words_of_the_language_and_no_others() {
    let mut words = quoted(&json("editors/tree-sitter-lmsl/src/grammar.json")["rules"]);
    words.retain(|word| word.starts_with(char::is_alphabetic));
    assert_eq!(words, keywords());
}

#[test]
fn vs_code_knows_every_unit() {
    let grammar = json("editors/vscode/syntaxes/lmsl.tmLanguage.json");
    for place in ["unit-of", "number"] {
        let listed = expressions(&grammar["repository"][place]).concat();
        let listed: BTreeSet<_> = listed.split(['|', '(', ')', ':', '?']).map(str::to_owned).collect();
        let missing: Vec<_> = units().into_iter().filter(|unit| !listed.contains(unit)).collect();
        assert!(missing.is_empty(), "{place}: {missing:?}");
    }
}

/// A snippet with its placeholders filled in: `${1:what stands there}`, `${2|the first,the second|}`.
fn filled(snippet: &str) -> String {
    let mut text = snippet.replace("$0", "");
    while let Some(start) = text.find("${") {
        let end = start + text[start..].find('}').unwrap();
        let inside = text[start + 2..end].trim_start_matches(|c: char| c.is_ascii_digit());
        let value = match inside.strip_prefix('|') {
            Some(choices) => choices.replace("\\,", "\u{0}").split([',', '|']).next().unwrap().replace('\u{0}', ","),
            None => inside.strip_prefix(':').unwrap().to_owned(),
        };
        text.replace_range(start..=end, &value);
    }
    text.trim_end().to_owned()
}

/// What a snippet may stand in, each with its place marked.
const AROUND: [&str; 9] = [
    "@\n",
    "behavior b on r {\n    @\n}\n",
    "behavior b on r {\n    mode m {\n        @\n    }\n}\n",
    "robot r {\n    @\n}\n",
    "scenario s runs b {\n    @\n}\n",
    "variable v: m in 0 .. 1 {\n    @\n}\n",
    "network n(a: v) {\n    @\n}\n",
    "network n(a: v) {\n    event e {\n        contributor\n            @\n    }\n}\n",
    "world w {\n    @\n}\n",
];

#[test]
fn snippets_parse_and_are_laid_out_as_the_formatter_does() {
    let (mut count, mut wrong) = (0, Vec::new());
    for (kind, path) in
        [(FileKind::Modes, "editors/vscode/snippets/msd.json"), (FileKind::Fusion, "editors/vscode/snippets/fsfn.json")]
    {
        let Value::Object(snippets) = json(path) else { panic!("{path}") };
        for (name, snippet) in snippets {
            let body = match &snippet["body"] {
                Value::Array(lines) => lines.iter().map(|line| line.as_str().unwrap()).collect::<Vec<_>>().join("\n"),
                line => line.as_str().unwrap().to_owned(),
            };
            let text = filled(&body);
            let fits = |around: &str| {
                let margin = around.split('@').next().unwrap().rsplit('\n').next().unwrap();
                let lines = text.lines().enumerate().map(|(index, line)| {
                    if index == 0 || line.is_empty() { line.to_owned() } else { format!("{margin}{line}") }
                });
                let whole = around.replace('@', &lines.collect::<Vec<_>>().join("\n"));
                let (_, findings) = parse(FileId(0), kind, &whole);
                findings.is_empty() && format(FileId(0), kind, &whole).is_ok_and(|formatted| formatted == whole)
            };
            if !AROUND.iter().any(|around| fits(around)) {
                wrong.push(format!("{path}: {name}\n{text}"));
            }
            count += 1;
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(count > 30, "{count}");
}
