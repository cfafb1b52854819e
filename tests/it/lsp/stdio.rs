//! The binary over its standard input and output, with the framing of a real client.

use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use serde_json::{Value, json};

struct Editor {
    server: Child,
    to: Option<ChildStdin>,
    from: BufReader<ChildStdout>,
}

impl Editor {
    fn start(cache: &std::path::Path) -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_lmslc"));
        command.args(["lsp", "--stdio"]).env("XDG_CACHE_HOME", cache);
        let mut server = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let (to, from) = (server.stdin.take(), BufReader::new(server.stdout.take().unwrap()));
        Self { server, to, from }
    }

    fn say(&mut self, message: &Value) {
        let text = message.to_string();
        let framed = format!(
            "Content-Length: {}\r\nContent-Type: application/vscode-jsonrpc; charset=utf-8\r\n\r\n{text}",
            text.len()
        );
        self.to.as_mut().unwrap().write_all(framed.as_bytes()).unwrap();
    }

    fn hear(&mut self) -> Value {
        let mut length = 0;
        loop {
            let mut line = String::new();
            self.from.read_line(&mut line).unwrap();
            match line.trim_end().split_once(": ") {
                Some(("Content-Length", bytes)) => length = bytes.parse().unwrap(),
                Some(_) => {}
                None => break,
            }
        }
        let mut bytes = vec![0; length];
        self.from.read_exact(&mut bytes).unwrap();
        serde_json::from_slice(&bytes).unwrap()
    }

    fn leave(mut self) -> Option<i32> {
        self.to = None;
        self.server.wait().unwrap().code()
    }
}

fn greeting() -> Value {
    let parameters = json!({ "processId": null, "rootUri": null, "capabilities": {} });
    json!({ "jsonrpc": "2.0", "id": "first", "method": "initialize", "params": parameters })
}

#[test]
fn a_session_over_standard_input_and_output() {
    let cache = tempfile::tempdir().unwrap();
    let mut editor = Editor::start(cache.path());
    editor.say(&greeting());
    let answer = editor.hear();
    assert_eq!((&answer["id"], &answer["result"]["serverInfo"]["name"]), (&json!("first"), &json!("lmslc")));
    editor.say(&json!({ "jsonrpc": "2.0", "method": "initialized", "params": {} }));
    let document =
        json!({ "uri": "file:///nowhere/a.msd", "languageId": "lmsl", "version": 7, "text": "// 🌏\nbehavior é" });
    editor.say(&json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": { "textDocument": document } }));
    let told = editor.hear();
    assert_eq!(told["method"], "textDocument/publishDiagnostics");
    assert_eq!(told["params"]["version"], 7);
    assert_eq!(told["params"]["diagnostics"][0]["range"]["start"]["line"], 1, "{told}");
    let library =
        std::fs::read_to_string(cache.path().join(format!("lmslc/{}/std/robots/j5.msd", env!("CARGO_PKG_VERSION"))));
    assert!(library.unwrap().contains("robot j5"), "the library can be opened");
    editor.say(&json!({ "jsonrpc": "2.0", "id": 2, "method": "shutdown" }));
    assert_eq!(editor.hear()["result"], Value::Null);
    editor.say(&json!({ "jsonrpc": "2.0", "method": "exit" }));
    assert_eq!(editor.leave(), Some(0));
}

#[test]
fn a_client_that_goes_without_a_word_leaves_no_server_behind() {
    let cache = tempfile::tempdir().unwrap();
    let mut editor = Editor::start(cache.path());
    editor.say(&greeting());
    editor.hear();
    assert_eq!(editor.leave(), Some(1));
}
