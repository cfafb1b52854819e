//! The book is whole: it has every page, every picture, every command and every option.

use std::collections::BTreeSet;
use std::process::Command;

use lmslc::diag::{RULES, Rule};
use lmslc::ir::Symbol;
use lmslc::view::{self, chart};

use crate::support::{analyze_path, files_below, keep_picture, root};

fn read(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap()
}

#[test]
fn every_page_stands_in_the_summary_once() {
    let summary = read("docs/SUMMARY.md");
    for page in files_below("docs", &["md"]).iter().map(|path| path.trim_start_matches("docs/")) {
        let count = summary.matches(&format!("]({page})")).count();
        assert_eq!(count, usize::from(page != "SUMMARY.md"), "{page} in docs/SUMMARY.md");
    }
}

#[test]
fn the_summary_lists_every_rule() {
    let line = |rule: &&Rule| format!("  - [{0}: {1}](errors/{0}.md)\n", rule.code, rule.name);
    let expected: String = RULES.iter().map(line).collect();
    assert!(read("docs/SUMMARY.md").contains(&expected), "copy this to docs/SUMMARY.md:\n{expected}");
}

#[test]
fn the_book_colors_the_keywords_of_the_language() {
    let script = read("docs/book/lmsl.js");
    let listed = script.split_once("keyword:").unwrap().1.split_once("},").unwrap().0;
    let listed: Vec<_> = listed.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty()).collect();
    let keywords: Vec<_> = lmslc::syntax::KEYWORDS.iter().copied().filter(|word| *word != "_").collect();
    assert_eq!(listed, keywords);
}

/// Each behavior and network that a file of the library or an example declares, with its picture.
fn pictures() -> Vec<(String, String)> {
    let mut pictures = Vec::new();
    for path in ["stdlib", "examples"].iter().flat_map(|folder| files_below(folder, &["msd", "fsfn"])) {
        let analysis = analyze_path(&path);
        let (program, sources) = (&analysis.program, &analysis.sources);
        let is_own = |symbol: &Symbol| analysis.roots.contains(&symbol.span.file);
        let diagrams = program.diagrams.iter().filter(|(_, of)| is_own(&of.symbol) && of.arbiter.is_none());
        for (id, diagram) in diagrams {
            pictures.push((diagram.symbol.name.clone(), chart::svg(&chart::Chart::new(program, sources, id))));
        }
        let networks = program
            .networks
            .values()
            .filter(|of| is_own(&of.symbol) && !(of.events.is_empty() && of.outputs.is_empty()));
        for network in networks {
            pictures.push((network.symbol.name.clone(), view::network(program, sources, network)));
        }
    }
    pictures
}

#[test]
fn every_behavior_and_network_hangs_in_the_gallery() {
    let (gallery, pictures) = (read("docs/gallery.md"), pictures());
    assert!(pictures.len() >= 10);
    for (name, picture) in &pictures {
        assert!(gallery.contains(&format!("](images/{name}.svg)")), "docs/gallery.md does not show {name}");
        keep_picture(&root().join(format!("docs/images/{name}.svg")), picture);
    }
    assert_eq!(gallery.matches("](images/").count(), pictures.len(), "docs/gallery.md shows what is no more");
}

/// What `lmslc` prints when it is asked for help.
fn help(command: &str) -> String {
    let arguments = command.split_whitespace().chain(["--help"]);
    let output = Command::new(env!("CARGO_BIN_EXE_lmslc")).args(arguments).output().unwrap();
    String::from_utf8(output.stdout).unwrap()
}

/// The commands there are.
fn commands() -> Vec<String> {
    let help = help("");
    let listed = help.split_once("Commands:\n").unwrap().1.split("\n\n").next().unwrap().to_owned();
    let names = listed.lines().map(|line| line.split_whitespace().next().unwrap().to_owned());
    names.filter(|name| name != "help").collect()
}

/// The options that a help text lists, and the values that they can take where these are listed.
fn offered(help: &str) -> BTreeSet<String> {
    let mut offered = BTreeSet::new();
    for line in help.lines().map(str::trim_start) {
        if line.starts_with('-') && !line.starts_with("- ") {
            offered
                .extend(line.split([' ', ',', '=']).take(3).filter(|word| word.starts_with("--")).map(str::to_owned));
        }
        let value = line.strip_prefix("- ").and_then(|line| line.split_once(':'));
        offered.extend(value.map(|(value, _)| value.to_owned()));
    }
    offered
}

/// The text below a heading of level two.
fn section(page: &str, heading: &str) -> String {
    let rest = page.split_once(&format!("\n## {heading}\n")).unwrap_or_else(|| panic!("no section `{heading}`")).1;
    rest.split("\n## ").next().unwrap().to_owned()
}

#[test]
fn every_command_is_documented_with_every_option() {
    let page = read("docs/commands.md");
    let everywhere = section(&page, "Everywhere");
    let commands = commands();
    assert!(commands.len() >= 14, "{commands:?}");
    assert_eq!(page.matches("\n## `lmslc ").count(), commands.len(), "a section for each of {commands:?}");
    for command in &commands {
        let section = section(&page, &format!("`lmslc {command}`"));
        let offered = offered(&help(command));
        let is_told = |text: &str, option: &str| text.split(['`', ' ', '\n', '|']).any(|word| word == option);
        for option in &offered {
            assert!(is_told(&section, option) || is_told(&everywhere, option), "`lmslc {command}` has {option}");
        }
        for row in section.lines().filter_map(|line| line.strip_prefix("| `-")) {
            let option = format!("-{}", row.split(['`', ' ', ',']).next().unwrap());
            let is_offered = offered.contains(&option) || help(command).contains(&format!(" {option}, "));
            assert!(is_offered, "`lmslc {command}` has no {option}");
        }
    }
}
