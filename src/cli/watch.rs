//! `--watch`: another round whenever something that was read reads otherwise.

use std::collections::BTreeMap;
use std::io::{IsTerminal, Write};
use std::time::{Duration, Instant};

use super::files::{Answer, Disk, Question};
use super::terminal::Terminal;

/// The least time between two looks at the disk.
const PAUSE: Duration = Duration::from_millis(200);
/// How long nothing may change before what has changed is read: an editor may write a file in several steps.
const SETTLED: Duration = Duration::from_millis(50);
/// The part of the time that looking may take: one in so many.
const SHARE: u32 = 20;

/// Refuses what cannot be watched.
///
/// # Errors
/// The exit code; the reason has been reported.
pub(super) fn refuse(paths: &[String], is_for_people: bool, terminal: &Terminal) -> Result<(), u8> {
    if paths.iter().any(|path| path == "-") {
        return Err(terminal.fail("standard input cannot be watched", Some("give the file by its name")));
    }
    if !is_for_people {
        let message = "`--watch` goes with what people read, not with this `--format`";
        return Err(terminal.fail(message, Some("leave `--format` out")));
    }
    Ok(())
}

/// Does a round, and another one whenever what the disk answered to it would be answered otherwise: files and folders that
/// were read, and files that were looked for and are not there. Ends only when it is interrupted.
///
/// Texts are compared, not times: a change is never missed, whatever wrote it and on whichever disk, and a file that is
/// saved as it was is no change.
pub(super) fn rounds(terminal: &Terminal, round: impl Fn(&Disk) -> Result<u8, u8>) -> ! {
    let mut changed = None;
    loop {
        begin(changed.as_deref(), terminal);
        let disk = Disk::default();
        // What was found has been shown; there is no one to give the exit code to.
        let _ = round(&disk);
        let answers = disk.into_answers();
        let count = answers.iter().filter(|(question, answer)| is_watched(question, answer)).count();
        terminal.note(&format!("watching {count} file{}; Ctrl-C ends", if count == 1 { "" } else { "s" }));
        changed = Some(wait(&answers));
    }
}

/// On a terminal each round has the screen to itself; elsewhere a line tells what it is for.
fn begin(changed: Option<&str>, terminal: &Terminal) {
    let is_screen = std::io::stderr().is_terminal() && std::io::stdout().is_terminal() && Terminal::can_draw();
    if is_screen {
        Terminal::print("\x1b[2J\x1b[3J\x1b[H");
        // The rest of what is shown may go to standard error.
        let _ = std::io::stdout().flush();
    }
    if let Some(path) = changed {
        terminal.note(&format!("--- `{path}` has changed"));
    }
}

fn is_watched(question: &Question, answer: &Answer) -> bool {
    match (question, answer) {
        (Question::Text(_), Answer::Text(text)) => text.is_ok(),
        _ => false,
    }
}

/// Until an answer is another one and stays so; the path that it is about.
fn wait(answers: &BTreeMap<Question, Answer>) -> String {
    let mut pause = PAUSE;
    loop {
        std::thread::sleep(pause);
        let start = Instant::now();
        let mut differing = differing(answers);
        pause = PAUSE.max(start.elapsed() * SHARE);
        while let Some((question, _)) = &differing {
            let path = match question {
                Question::Text(path) | Question::Folder(path) => path.clone(),
            };
            std::thread::sleep(SETTLED);
            let now = self::differing(answers);
            if now == differing {
                return path;
            }
            differing = now;
        }
    }
}

/// The first question that has another answer now, with that answer.
fn differing(answers: &BTreeMap<Question, Answer>) -> Option<(Question, Answer)> {
    answers.iter().find_map(|(question, answer)| {
        let now = question.ask();
        (now != *answer).then(|| (question.clone(), now))
    })
}
