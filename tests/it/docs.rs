//! Nothing in the documentation goes untried: programs are sound or say that they are not, every other block is read by
//! what it is written for, and every link leads somewhere.

use std::path::Path;
use std::process::Command;

use crate::support::{Fence, analyze_fences, analyze_texts, doubts, fences, files_below, report, root};

/// Blocks that nothing here can read, and the only pages they may stand on.
const SHOWN_AS_THEY_ARE: [(&str, &str); 3] =
    [("docs/ci.md", "yaml"), ("docs/editors.md", "lua"), ("docs/editors.md", "lisp")];

/// All pages, as paths from the root.
fn all_pages() -> Vec<String> {
    [files_below("docs", &["md"]), vec!["README.md".to_owned()]].concat()
}

/// The pages but for those of diagnostics, whose programs have tests of their own.
fn pages() -> Vec<String> {
    all_pages().into_iter().filter(|path| !path.starts_with("docs/errors/")).collect()
}

fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap()
}

/// A fence with the earlier ones of its page that it may import.
fn with_files(fences: &[Fence], index: usize) -> Vec<&Fence> {
    let files = fences[..index].iter().filter(|fence| fence.is_program() && fence.file.is_some());
    files.chain([&fences[index]]).collect()
}

#[test]
fn every_program_of_the_documentation_is_what_it_says() {
    let (mut programs, mut wrong) = (0, Vec::new());
    for path in pages() {
        let fences = fences(&read(&path));
        for (index, fence) in fences.iter().enumerate().filter(|(_, fence)| fence.is_program()) {
            programs += 1;
            let analysis = analyze_fences(&with_files(&fences, index));
            let codes: Vec<_> = doubts(&analysis).into_iter().map(|finding| finding.rule.code).collect();
            let is_so = match fence.tag.split_once(',') {
                None => codes.is_empty(),
                Some((_, "later")) => !codes.is_empty() && codes.iter().all(|code| *code == "LM0105"),
                Some((_, "mistake")) => !codes.is_empty() && !codes.contains(&"LM0105"),
                Some(_) => false,
            };
            if !is_so {
                wrong.push(format!("{path}:{} is `{}`\n{}", fence.line, fence.tag, report(&analysis)));
            }
        }
    }
    assert!(programs > 20, "{programs}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether the lines of a shell script that call `lmslc` call it rightly: it is asked for help behind them.
fn is_called_rightly(script: &str) -> bool {
    let commands = script.split(['\n', '|', ';']).flat_map(|line| line.split("&&")).map(str::trim);
    let calls = commands.filter_map(|command| command.trim_start_matches("exec ").strip_prefix("lmslc "));
    calls.into_iter().all(|arguments| {
        let words = arguments.split_whitespace().take_while(|word| !matches!(*word, ">" | "<" | "#"));
        let output = Command::new(env!("CARGO_BIN_EXE_lmslc")).args(words).arg("--help").output().unwrap();
        output.status.success()
    })
}

/// Whether a text is a whole program of the language, which ought to say so.
fn is_program(text: &str) -> bool {
    let sound = |path| !analyze_texts(&[(path, text)]).has_errors();
    text.contains('{') && (sound("page.msd") || sound("page.fsfn"))
}

/// Whether a block is what its tag says, as far as that can be told here.
fn is_read(path: &str, fence: &Fence) -> bool {
    match fence.tag.as_str() {
        // Programs are analyzed above and in `pages`, sessions replayed in `sessions`.
        _ if fence.is_program() => true,
        "console" => fence.file.is_none(),
        // Compared with the files they show in `emit` and `sessions`.
        "rust" if fence.file.is_some() => true,
        "rust" => syn::parse_file(&fence.text).is_ok(),
        "toml" => toml::from_str::<toml::Table>(&fence.text).is_ok(),
        "json" => serde_json::from_str::<serde_json::Value>(&fence.text).is_ok(),
        "csv" => csv::Reader::from_reader(fence.text.as_bytes()).records().all(|record| record.is_ok()),
        "sh" => is_called_rightly(&fence.text),
        // A form, a part or an output.
        "text" => !is_program(&fence.text),
        other => SHOWN_AS_THEY_ARE.contains(&(path, other)),
    }
}

#[test]
fn no_block_goes_untried() {
    for path in all_pages() {
        let text = read(&path);
        for fence in fences(&text) {
            assert!(is_read(&path, &fence), "{path}:{}: `{}`\n{}", fence.line, fence.tag, fence.text);
        }
        let mut is_open = false;
        for (line, number) in text.lines().zip(1..) {
            is_open ^= line.starts_with("```");
            let hides = |start: &str| line.trim_start().starts_with(start);
            let hidden = hides("~~~") || (hides("```") && !line.starts_with("```"));
            assert!(is_open || !(hidden || line.starts_with("    ")), "{path}:{number}: a block that no test sees");
        }
    }
}

/// The name of a heading in links, as mdBook and code hosts make it.
fn slug(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.collect::<String>().to_lowercase().replace(' ', "-")
}

/// The text of a page without its blocks and code spans.
fn prose(page: &str) -> String {
    let outside = page.split("\n```").step_by(2).map(|part| part.split_once('\n').map_or("", |(_, rest)| rest));
    outside.flat_map(|part| part.split('`').step_by(2)).collect()
}

#[test]
fn every_link_to_a_page_or_heading_leads_somewhere() {
    for path in all_pages() {
        let folder = Path::new(&path).parent().unwrap().to_owned();
        let text = format!("\n{}", read(&path));
        for target in prose(&text).split("](").skip(1).map(|rest| rest.split(')').next().unwrap().to_owned()) {
            if target.contains("://") {
                continue;
            }
            let (file, heading) = target.split_once('#').unwrap_or((&target, ""));
            let file = if file.is_empty() { root().join(&path) } else { root().join(&folder).join(file) };
            assert!(file.exists(), "{path} links to {target}");
            let book = root().join("docs").canonicalize().unwrap();
            let leaves = path.starts_with("docs/") && !file.canonicalize().unwrap().starts_with(book);
            assert!(!leaves, "{path} links out of the book, to {target}");
            let page = std::fs::read_to_string(&file).unwrap_or_default();
            let mut headings = page.lines().filter_map(|line| line.strip_prefix('#'));
            let found = heading.is_empty() || headings.any(|line| slug(line.trim_start_matches('#').trim()) == heading);
            assert!(found, "{path} links to {target}");
        }
    }
}
