//! What the documentation shows of the terminal is what the terminal shows.

use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;

use crate::support::{fences, files_below, root};

/// Where the sessions of a page run: its files as far as they are written, the library and the examples.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for shared in ["stdlib", "examples"] {
        std::os::unix::fs::symlink(root().join(shared), folder.path().join(shared)).unwrap();
    }
    folder
}

/// What a command answers: results, then remarks. Behind `<` stands the file that it reads.
fn answer(folder: &Path, command: &str) -> String {
    let (command, input) = command.split_once(" < ").unwrap_or((command, ""));
    let words = command.strip_prefix("lmslc ").unwrap_or_else(|| panic!("`{command}` is not run by any test"));
    let input = match input {
        "" => Stdio::null(),
        path => std::fs::File::open(folder.join(path)).unwrap().into(),
    };
    let output = Command::new(env!("CARGO_BIN_EXE_lmslc"))
        .args(words.split_whitespace())
        .stdin(input)
        .current_dir(folder)
        .env("COLUMNS", "100")
        .env("NO_COLOR", "1")
        .output()
        .unwrap();
    String::from_utf8(output.stdout).unwrap() + &String::from_utf8(output.stderr).unwrap()
}

/// The page with every session replayed, and the folder after that.
fn replayed(text: &str) -> (String, TempDir) {
    let (folder, mut now) = (folder(), text.to_owned());
    // From the end, the lines of what comes before keep their numbers; from the beginning they are replayed.
    let mut answers = Vec::new();
    for fence in fences(text) {
        match &fence.file {
            Some(name) if fence.is_part => {
                let made = std::fs::read_to_string(folder.path().join(name)).unwrap();
                assert!(made.contains(&fence.text), "line {}: not in {name}:\n{made}", fence.line);
            }
            Some(name) => {
                let path = folder.path().join(name);
                std::fs::create_dir_all(path.parent().unwrap()).unwrap();
                std::fs::write(path, &fence.text).unwrap();
            }
            None if fence.tag == "console" => {
                let commands = fence.text.lines().filter_map(|line| line.strip_prefix("$ "));
                let replay = commands.map(|command| format!("$ {command}\n{}", answer(folder.path(), command)));
                let replay = replay.collect::<Vec<_>>().join("\n");
                assert!(!replay.is_empty(), "the session at line {} runs nothing", fence.line);
                answers.push((fence, replay));
            }
            None => {}
        }
    }
    for (fence, replay) in answers.iter().rev() {
        let start = text.lines().take(fence.line - 1).map(|line| line.len() + 1).sum::<usize>();
        now.replace_range(start..start + fence.text.len(), replay);
    }
    (now, folder)
}

/// With `UPDATE_SESSIONS=1` the pages are rewritten instead.
#[test]
fn sessions_are_real() {
    let pages = [vec!["README.md".to_owned()], files_below("docs", &["md"])].concat();
    let mut count = 0;
    for page in pages {
        let text = std::fs::read_to_string(root().join(&page)).unwrap();
        if !text.contains("```console") {
            continue;
        }
        count += 1;
        let (now, folder) = replayed(&text);
        if std::env::var("UPDATE_SESSIONS").is_ok() {
            std::fs::write(root().join(&page), &now).unwrap();
        } else {
            assert!(
                text == now,
                "a session in {page} is out of date; UPDATE_SESSIONS=1 cargo test rewrites it:\n{now}"
            );
        }
        pictures_are_drawn(&page, &text, folder.path());
    }
    assert!(count > 5);
}

/// The pictures that a page shows of its sessions are those that they drew. With `UPDATE_PICTURES=1` they are redrawn.
fn pictures_are_drawn(page: &str, text: &str, folder: &Path) {
    let own = Path::new("images").join(Path::new(page).file_stem().unwrap());
    for (shown, _) in text.split("](").skip(1).filter_map(|rest| rest.split_once(')')) {
        let Ok(name) = Path::new(shown).strip_prefix(&own) else { continue };
        let drawn = std::fs::read_to_string(folder.join(name)).unwrap();
        let kept = root().join("docs").join(shown);
        crate::support::keep_picture(&kept, &drawn);
    }
}

#[test]
fn the_picture_is_of_the_run_that_is_shown() {
    let folder = folder();
    answer(folder.path(), "lmslc run examples/j5/manipulation.msd --plot manipulation.svg");
    let drawn = std::fs::read_to_string(folder.path().join("manipulation.svg")).unwrap();
    crate::support::keep_picture(&root().join("docs/pictures/manipulation.svg"), &drawn);
}
