//! The grammar reads what the compiler reads, and takes the same words for keywords.

#![allow(clippy::disallowed_methods, clippy::unwrap_used, reason = "tests read files")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use tree_sitter::{Node, Parser, Query, QueryCursor, StreamingIterator, Tree};
use tree_sitter_lmsl::{FOLDS_QUERY, HIGHLIGHTS_QUERY, LANGUAGE};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The files of the language below a folder of the repository, sorted.
fn files_below(folder: &str) -> Vec<PathBuf> {
    let mut waiting = vec![root().join(folder)];
    let mut found = Vec::new();
    while let Some(folder) = waiting.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                waiting.push(path);
            } else if path.extension().is_some_and(|ending| ending == "msd" || ending == "fsfn") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// The files that have a sound syntax: all but those in which the compiler misses something.
fn sound_files() -> Vec<(PathBuf, String)> {
    let folders = ["stdlib", "examples", "tests/corpus"];
    let paths = folders.into_iter().flat_map(files_below);
    let texts = paths.map(|path| (path.clone(), std::fs::read_to_string(path).unwrap()));
    let is_sound = |(path, text): &(PathBuf, String)| {
        !path.to_string_lossy().contains("/syntax/fail/")
            && !["LM0101", "LM0102", "LM0103"].iter().any(|code| text.contains(code))
    };
    texts.filter(is_sound).collect()
}

fn parse(text: &str) -> Tree {
    let mut parser = Parser::new();
    parser.set_language(&LANGUAGE.into()).unwrap();
    parser.parse(text, None).unwrap()
}

/// All nodes of a tree, each before those in it.
fn nodes(tree: &Tree) -> Vec<Node<'_>> {
    let mut waiting = vec![tree.root_node()];
    let mut found = Vec::new();
    while let Some(node) = waiting.pop() {
        found.push(node);
        waiting.extend((0..node.child_count()).rev().filter_map(|index| node.child(index as u32)));
    }
    found
}

fn place(node: Node<'_>) -> String {
    format!("{}:{}", node.start_position().row + 1, node.start_position().column + 1)
}

#[test]
fn every_sound_file_parses() {
    let files = sound_files();
    assert!(files.len() > 100, "{}", files.len());
    let mut wrong = Vec::new();
    for (path, text) in files {
        let tree = parse(&text);
        let broken = nodes(&tree).into_iter().filter(|node| node.is_error() || node.is_missing());
        wrong.extend(broken.map(|node| format!("{}:{}", path.display(), place(node))));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn keywords_are_those_of_the_compiler() {
    let told = std::fs::read_to_string(root().join("editors/keywords.snap")).unwrap();
    let mut expected: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    let mut file = "";
    for line in told.split("---\n").nth(2).unwrap().lines() {
        if line.starts_with(|c: char| c.is_ascii_digit()) {
            expected.get_mut(file).unwrap().push(line);
        } else {
            file = line;
            expected.insert(file, Vec::new());
        }
    }
    assert!(expected.len() >= 8);
    for (file, keywords) in expected {
        let text = std::fs::read_to_string(root().join("tests/corpus/syntax/pass").join(file)).unwrap();
        // Columns are told in characters, and lines by any ending.
        let text = text.replace('\u{feff}', " ").replace("\r\n", "\n").replace('\r', "\n");
        let tree = parse(&text);
        let is_keyword = |node: &Node<'_>| {
            (!node.is_named() || node.kind() == "done")
                && node.kind().starts_with(char::is_alphabetic)
                && node.child_count() == 0
        };
        let found: Vec<_> = nodes(&tree)
            .into_iter()
            .filter(is_keyword)
            .map(|node| format!("{} {}", place(node), node.kind()))
            .collect();
        assert_eq!(found, keywords, "{file}");
    }
}

#[test]
fn every_word_has_one_color() {
    let query = Query::new(&LANGUAGE.into(), HIGHLIGHTS_QUERY).unwrap();
    for (path, text) in sound_files() {
        let tree = parse(&text);
        let mut cursor = QueryCursor::new();
        let mut captures = cursor.captures(&query, tree.root_node(), text.as_bytes());
        let mut colored = BTreeSet::new();
        while let Some((found, index)) = captures.next() {
            let node = found.captures[*index].node;
            let is_first = colored.insert((node.start_byte(), node.end_byte()));
            assert!(is_first, "{}:{}: {} twice", path.display(), place(node), node.kind());
        }
        let leaves = nodes(&tree).into_iter().filter(|node| node.child_count() == 0 && node.parent().is_some());
        for leaf in leaves {
            let around = std::iter::successors(Some(leaf), |node| node.parent());
            let mut ranges = around.map(|node| (node.start_byte(), node.end_byte()));
            assert!(
                ranges.any(|range| colored.contains(&range)),
                "{}:{}: {}",
                path.display(),
                place(leaf),
                leaf.kind()
            );
        }
    }
}

#[test]
fn declarations_fold() {
    let query = Query::new(&LANGUAGE.into(), FOLDS_QUERY).unwrap();
    let text = std::fs::read_to_string(root().join("stdlib/behaviors/obstacle_manipulation.msd")).unwrap();
    let tree = parse(&text);
    let mut cursor = QueryCursor::new();
    let mut matches = cursor.matches(&query, tree.root_node(), text.as_bytes());
    let mut kinds = BTreeSet::new();
    while let Some(found) = matches.next() {
        kinds.insert(found.captures[0].node.kind());
    }
    assert_eq!(kinds, BTreeSet::from(["diagram", "mode"]));
}

#[test]
fn a_broken_line_leaves_the_others_whole() {
    let text = "behavior b on r {\n entry a\n mode a {\n  halt()\n  1: hit b\n  2: after 2 s -> a\n }\n mode c { halt() }\n}\n";
    let tree = parse(text);
    let modes = nodes(&tree).into_iter().filter(|node| node.is_named() && node.kind() == "mode").count();
    assert!(tree.root_node().has_error());
    assert_eq!(modes, 2);
}
