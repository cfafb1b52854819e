//! What the documentation shows of the terminal is what the terminal shows.

use std::process::{Command, Stdio};

use crate::support::{files_below, root};

/// The `console` fences of a page: the line each begins on, and its lines.
fn sessions(text: &str) -> Vec<(usize, Vec<&str>)> {
    let mut found = Vec::new();
    let mut lines = text.lines().enumerate();
    while let Some((number, line)) = lines.next() {
        if line == "```console" {
            found.push((number + 1, lines.by_ref().map(|(_, line)| line).take_while(|line| *line != "```").collect()));
        }
    }
    found
}

/// What a command answers: results, then remarks. Behind `<` stands the file that it reads.
fn answer(command: &str) -> String {
    let (command, input) = command.split_once(" < ").unwrap_or((command, ""));
    let words = command.split_whitespace().skip(1);
    let input = match input {
        "" => Stdio::null(),
        path => std::fs::File::open(root().join(path)).unwrap().into(),
    };
    let output = Command::new(env!("CARGO_BIN_EXE_lmslc"))
        .args(words)
        .stdin(input)
        .current_dir(root())
        .env("COLUMNS", "100")
        .env("NO_COLOR", "1")
        .output()
        .unwrap();
    String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap()
}

/// The page with every session replayed.
fn replayed(text: &str) -> String {
    let mut pages = text.to_owned();
    for (number, lines) in sessions(text) {
        let shown = format!("```console\n{}\n```\n", lines.join("\n"));
        let commands = lines.iter().filter(|line| line.starts_with("$ lmslc "));
        let replay: Vec<_> = commands.map(|command| format!("{command}\n{}", answer(&command[2..]))).collect();
        assert!(!replay.is_empty(), "the session at line {number} runs nothing");
        pages = pages.replace(&shown, &format!("```console\n{}```\n", replay.join("\n")));
    }
    pages
}

/// With `UPDATE_SESSIONS=1` the pages are rewritten instead.
#[test]
fn sessions_are_real() {
    let pages = [vec!["README.md".to_owned()], files_below("docs", &["md"])].concat();
    let mut replayed_any = false;
    for page in pages {
        let text = std::fs::read_to_string(root().join(&page)).unwrap();
        let now = replayed(&text);
        replayed_any |= text.contains("```console");
        if std::env::var("UPDATE_SESSIONS").is_ok() {
            std::fs::write(root().join(&page), &now).unwrap();
        } else {
            assert!(
                text == now,
                "a session in {page} is out of date; UPDATE_SESSIONS=1 cargo test rewrites it:\n{now}"
            );
        }
    }
    assert!(replayed_any);
}

#[test]
fn the_picture_is_of_the_run_that_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    let drawn = folder.path().join("manipulation.svg");
    answer(&format!("lmslc run examples/j5/manipulation.msd --plot {}", drawn.display()));
    let kept = std::fs::read_to_string(root().join("docs/pictures/manipulation.svg")).unwrap();
    assert!(std::fs::read_to_string(drawn).unwrap() == kept, "docs/pictures/manipulation.svg is out of date");
}
