//! How long an editor waits after a keystroke: `cargo bench --bench lsp`.
#![expect(clippy::unwrap_used, reason = "a bench without its input has nothing to measure")]

mod large;

use std::cell::RefCell;

use divan::{Bencher, counter::ItemsCount};
use lmslc::diag::Levels;
use lmslc::driver::{FileError, Files};
use lmslc::lsp::{Desk, serve};
use lsp_server::{Connection, Message, Notification, Request};
use serde_json::{Value, json};

use large::behavior;

fn main() {
    divan::main();
}

/// A machine without files.
struct Empty;

impl Files for Empty {
    fn read(&self, _path: &str) -> Result<String, FileError> {
        Err(FileError::Missing)
    }
}

impl Desk for Empty {
    fn files(&self, _folder: &str) -> Vec<String> {
        Vec::new()
    }

    fn levels(&self, _path: &str) -> Levels {
        Levels::default()
    }

    fn library(&self) -> Option<String> {
        None
    }
}

struct Editor {
    connection: Connection,
    requests: i32,
}

impl Editor {
    fn open(text: &str) -> Self {
        let (connection, other) = Connection::memory();
        std::thread::spawn(move || serve(&other, &Empty));
        let mut editor = Self { connection, requests: 0 };
        editor.ask("initialize", json!({ "capabilities": {} }));
        let document = json!({ "uri": "file:///big.msd", "languageId": "lmsl", "version": 1, "text": text });
        editor.tell("textDocument/didOpen", json!({ "textDocument": document }));
        editor.wait_for_findings();
        editor
    }

    fn tell(&self, method: &str, parameters: Value) {
        self.connection.sender.send(Notification::new(method.to_owned(), parameters).into()).unwrap();
    }

    fn ask(&mut self, method: &str, parameters: Value) {
        self.requests += 1;
        self.connection.sender.send(Request::new(self.requests.into(), method.to_owned(), parameters).into()).unwrap();
        while !matches!(self.connection.receiver.recv().unwrap(), Message::Response(_)) {}
    }

    fn wait_for_findings(&self) {
        while !matches!(self.connection.receiver.recv().unwrap(), Message::Notification(_)) {}
    }

    /// Writes over the three letters of the first command, which breaks or mends it.
    fn write(&self, text: &str) {
        let range = json!({ "start": { "line": 4, "character": 8 }, "end": { "line": 4, "character": 11 } });
        let document = json!({ "uri": "file:///big.msd", "version": 2 });
        let changes = json!([{ "range": range, "text": text }]);
        self.tell("textDocument/didChange", json!({ "textDocument": document, "contentChanges": changes }));
    }
}

/// From a keystroke to its findings: one that breaks a command, and one that mends it.
#[divan::bench(args = [200, 2_000, 20_000], max_time = 5)]
fn keystrokes(bencher: Bencher, lines: usize) {
    write_in_turn(bencher, lines, ["drj", "dri"]);
}

/// The same where nothing but the rest of the text can be parsed in between.
#[divan::bench(args = [200, 2_000], max_time = 5)]
fn syntax_errors(bencher: Bencher, lines: usize) {
    write_in_turn(bencher, lines, ["d)i", "dri"]);
}

fn write_in_turn(bencher: Bencher, lines: usize, texts: [&str; 2]) {
    let editor = Editor::open(&behavior(lines));
    bencher.counter(ItemsCount::new(texts.len())).bench_local(|| {
        for text in texts {
            editor.write(text);
            editor.wait_for_findings();
        }
    });
}

/// A keystroke, and right behind it what an editor asks for to color the text.
#[divan::bench(args = [200, 2_000], max_time = 5)]
fn keystroke_and_colors(bencher: Bencher, lines: usize) {
    let editor = RefCell::new(Editor::open(&behavior(lines)));
    bencher.bench_local(|| {
        let mut editor = editor.borrow_mut();
        editor.write("dri");
        editor.ask("textDocument/semanticTokens/full", json!({ "textDocument": { "uri": "file:///big.msd" } }));
    });
}
