//! A client that speaks the protocol with a server in memory, as an editor would.

use std::collections::{BTreeMap, HashMap};
use std::thread::JoinHandle;
use std::time::Duration;

use lmslc::diag::Levels;
use lmslc::driver::{FileError, Files};
use lmslc::lsp::{Desk, Lines, serve};
use lsp_server::{Connection, Message, Notification, Request, Response};
use serde_json::{Value, json};

/// A disk with some files, below `/home/robot`.
struct Shelf(HashMap<String, String>);

impl Files for Shelf {
    fn read(&self, path: &str) -> Result<String, FileError> {
        self.0.get(path).cloned().ok_or(FileError::Missing)
    }
}

impl Desk for Shelf {
    fn files(&self, folder: &str) -> Vec<String> {
        let mut files: Vec<_> = self.0.keys().filter(|path| path.starts_with(folder)).cloned().collect();
        files.sort();
        files
    }

    fn levels(&self, _path: &str) -> Levels {
        Levels::default()
    }

    fn library(&self) -> Option<String> {
        Some("/library".to_owned())
    }
}

/// The longest a test waits for an answer.
const PATIENCE: Duration = Duration::from_secs(90);

pub struct Client {
    connection: Connection,
    server: Option<JoinHandle<bool>>,
    requests: i32,
    /// What stands in the editor.
    texts: HashMap<String, String>,
    /// What was found in each file, as it was told last.
    pub found: BTreeMap<String, Vec<Value>>,
}

pub fn uri(name: &str) -> String {
    format!("file:///home/robot/{name}")
}

impl Client {
    /// Greets a server whose disk has some files in `/home/robot`.
    pub fn new(disk: &[(&str, &str)]) -> Self {
        let mut client = Self::unknown(disk);
        let greeting = client.request(
            "initialize",
            json!({ "processId": null, "capabilities": {}, "workspaceFolders": [{ "uri": "file:///home/robot", "name": "work" }] }),
        );
        assert_eq!(greeting["serverInfo"]["name"], "lmslc");
        client.notify("initialized", json!({}));
        client
    }

    /// Starts a server without a greeting.
    pub fn unknown(disk: &[(&str, &str)]) -> Self {
        let shelf =
            Shelf(disk.iter().map(|(name, text)| (format!("/home/robot/{name}"), (*text).to_owned())).collect());
        let (connection, other) = Connection::memory();
        let server = Some(std::thread::spawn(move || serve(&other, &shelf)));
        Self { connection, server, requests: 0, texts: HashMap::new(), found: BTreeMap::new() }
    }

    pub fn notify(&self, method: &str, parameters: Value) {
        self.connection.sender.send(Notification::new(method.to_owned(), parameters).into()).unwrap();
    }

    /// Sends a request and answers its number.
    pub fn ask(&mut self, method: &str, parameters: Value) -> i32 {
        self.requests += 1;
        self.connection.sender.send(Request::new(self.requests.into(), method.to_owned(), parameters).into()).unwrap();
        self.requests
    }

    /// The answer to a request; what is published before it is kept.
    pub fn answer(&mut self, id: i32) -> Response {
        loop {
            match self.connection.receiver.recv_timeout(PATIENCE).unwrap() {
                Message::Response(response) => {
                    assert_eq!(response.id, id.into());
                    return response;
                }
                message => self.keep(message),
            }
        }
    }

    pub fn request(&mut self, method: &str, parameters: Value) -> Value {
        let id = self.ask(method, parameters);
        self.answer(id).response_result.unwrap_or_else(|error| panic!("{method}: {error:?}"))
    }

    pub fn refused(&mut self, method: &str, parameters: Value) -> (i32, String) {
        let id = self.ask(method, parameters);
        let error = self.answer(id).response_result.unwrap_err();
        (error.code, error.message)
    }

    fn keep(&mut self, message: Message) {
        let Message::Notification(told) = message else { panic!("{message:?}") };
        assert_eq!(told.method, "textDocument/publishDiagnostics");
        let name = told.params["uri"].as_str().unwrap().trim_start_matches("file:///home/robot/").to_owned();
        self.found.insert(name, told.params["diagnostics"].as_array().unwrap().clone());
    }

    /// Waits until something is published of a file, and answers the messages.
    pub fn wait(&mut self, name: &str) -> Vec<String> {
        self.found.remove(name);
        while !self.found.contains_key(name) {
            let message = self.connection.receiver.recv_timeout(PATIENCE).unwrap();
            self.keep(message);
        }
        self.messages(name)
    }

    /// What was found in a file, each with its severity and the first line of its message.
    pub fn messages(&self, name: &str) -> Vec<String> {
        let shown = |found: &Value| {
            let message = found["message"].as_str().unwrap().lines().next().unwrap();
            format!("{} {message}", found["severity"])
        };
        self.found[name].iter().map(shown).collect()
    }

    pub fn open(&mut self, name: &str, text: &str) {
        self.texts.insert(name.to_owned(), text.to_owned());
        let document = json!({ "uri": uri(name), "languageId": "lmsl", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    /// Replaces the first occurrence of some text, as a change of that range.
    pub fn replace(&mut self, name: &str, old: &str, new: &str) {
        let text = self.texts.get_mut(name).unwrap();
        let start = text.find(old).unwrap();
        let range = Lines::new(text).range(text, start..start + old.len());
        text.replace_range(start..start + old.len(), new);
        let change = json!({ "range": range, "text": new });
        let document = json!({ "uri": uri(name), "version": 2 });
        self.notify("textDocument/didChange", json!({ "textDocument": document, "contentChanges": [change] }));
    }

    pub fn text(&self, name: &str) -> &str {
        &self.texts[name]
    }

    /// The text under a range of an open file.
    pub fn slice(&self, name: &str, range: &Value) -> &str {
        let range: lsp_types::Range = serde_json::from_value(range.clone()).unwrap();
        let text = self.text(name);
        let lines = Lines::new(text);
        &text[lines.byte(text, range.start)..lines.byte(text, range.end)]
    }

    /// The parameters of a request about the place right behind the first occurrence of `before`, in front of `after`.
    pub fn place(&self, name: &str, before: &str, after: &str) -> Value {
        let text = self.text(name);
        let byte = text.find(&format!("{before}{after}")).unwrap() + before.len();
        json!({ "textDocument": { "uri": uri(name) }, "position": Lines::new(text).position(text, byte) })
    }

    /// A place as file, line and column from 1, for what is open or in the library.
    pub fn shown(location: &Value) -> String {
        let start = &location["range"]["start"];
        let (line, column) = (start["line"].as_u64().unwrap() + 1, start["character"].as_u64().unwrap() + 1);
        let file = location["uri"].as_str().unwrap().trim_start_matches("file:///home/robot/");
        format!("{file}:{line}:{column}")
    }

    /// Says goodbye; whether the server took it for an orderly one.
    pub fn leave(mut self) -> bool {
        assert_eq!(self.request("shutdown", Value::Null), Value::Null);
        self.hang_up()
    }

    /// Leaves without a word before.
    pub fn hang_up(mut self) -> bool {
        self.notify("exit", Value::Null);
        self.server.take().unwrap().join().unwrap()
    }
}
