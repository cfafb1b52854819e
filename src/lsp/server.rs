//! The loop: messages in, answers and findings out, from the first greeting to the last.

use std::collections::VecDeque;
use std::rc::Rc;
use std::time::Duration;

use crossbeam_channel::{after, never, select};
use lsp_server::{Connection, ErrorCode, Message, Notification, Request, RequestId, Response};
use lsp_types::notification::{self as notifications, Notification as _};
use lsp_types::request::{self as requests, Request as _};
use lsp_types::{
    CancelParams, CodeActionKind, CodeActionOptions, CodeActionOrCommand, CodeActionParams,
    CodeActionProviderCapability, CompletionOptions, CompletionResponse, DidChangeTextDocumentParams,
    DidChangeWatchedFilesParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, DidSaveTextDocumentParams,
    DocumentFormattingParams, DocumentSymbolResponse, HoverProviderCapability, InitializeParams, InitializeResult,
    NumberOrString, OneOf, PrepareRenameResponse, PublishDiagnosticsParams, RenameOptions, RenameParams,
    SemanticTokens, SemanticTokensFullOptions, SemanticTokensOptions, SemanticTokensResult,
    SemanticTokensServerCapabilities, ServerCapabilities, ServerInfo, SignatureHelpOptions, TextDocumentPositionParams,
    TextDocumentSyncCapability, TextDocumentSyncKind, TextEdit, Uri, WorkDoneProgressOptions, WorkspaceEdit,
    WorkspaceSymbolResponse,
};

use super::documents::{Changed, Document, Documents, Overlay};
use super::folder::Folder;
use super::known::Known;
use super::proofs::Proofs;
use super::{
    Desk, actions, colors, completion, definition, diagnostics, formatting, hints, hover, rename, signature, symbols,
};
use crate::base::{FileId, Span};
use crate::driver::{self, Analysis, Files, Memo, Options};

/// How long the client must be silent before properties are proved or refuted, which can take longer than a keystroke.
const SILENCE: Duration = Duration::from_millis(300);

/// The language of both kinds of file, as clients call it.
const LANGUAGE: &str = "lmsl";

/// The file that an analysis of one file was asked for is its first.
const ROOT: FileId = FileId(0);

/// How to look at all files together: for what they name.
fn all() -> Options {
    Options { faults: 0, verify: false, ..Options::default() }
}

/// Serves one client over standard input and output. Answers whether it took its leave as the protocol wants it.
pub fn serve_stdio(desk: &dyn Desk) -> bool {
    let (connection, threads) = Connection::stdio();
    let orderly = serve(&connection, desk);
    drop(connection);
    // After an orderly end there is nothing left to read; else the reading thread may wait forever.
    orderly && threads.join().is_ok()
}

/// Serves one client until it leaves. Answers whether it took its leave as the protocol wants it.
pub fn serve(connection: &Connection, desk: &dyn Desk) -> bool {
    let Ok((id, parameters)) = connection.initialize_start() else { return false };
    let greeting = Request { id, method: requests::Initialize::METHOD.to_owned(), params: parameters };
    let mut server = Server {
        connection,
        desk,
        folder: Folder::default(),
        documents: Documents::default(),
        memo: Memo::default(),
        proofs: Proofs::default(),
        everything: None,
        waiting: VecDeque::new(),
        is_leaving: false,
    };
    let response = reply::<requests::Initialize>(greeting, |parameters| Ok(server.initialize(&parameters)));
    server.send(response);
    server.run()
}

/// Why a request is not carried out.
pub(super) struct Refusal {
    code: ErrorCode,
    message: String,
}

fn refused(message: String) -> Refusal {
    Refusal { code: ErrorCode::RequestFailed, message }
}

struct Server<'a> {
    connection: &'a Connection,
    desk: &'a dyn Desk,
    folder: Folder,
    documents: Documents,
    memo: Memo,
    proofs: Proofs,
    /// What is known of all files together, since the last change.
    everything: Option<Rc<Known>>,
    /// Messages that have come and were not looked at yet.
    waiting: VecDeque<Message>,
    /// Whether the client has said that it will leave.
    is_leaving: bool,
}

/// Answers a request, or says what is wrong with its parameters.
fn reply<R: requests::Request>(
    request: Request,
    answer: impl FnOnce(R::Params) -> Result<R::Result, Refusal>,
) -> Response {
    let id = request.id.clone();
    let answered = match request.extract::<R::Params>(R::METHOD) {
        Ok((_, parameters)) => answer(parameters),
        Err(error) => Err(Refusal { code: ErrorCode::InvalidParams, message: error.to_string() }),
    };
    match answered {
        Ok(result) => Response::new_ok(id, result),
        Err(Refusal { code, message }) => Response::new_err(id, code as i32, message),
    }
}

fn capabilities() -> ServerCapabilities {
    ServerCapabilities {
        text_document_sync: Some(TextDocumentSyncCapability::Kind(TextDocumentSyncKind::INCREMENTAL)),
        document_formatting_provider: Some(OneOf::Left(true)),
        definition_provider: Some(OneOf::Left(true)),
        references_provider: Some(OneOf::Left(true)),
        rename_provider: Some(OneOf::Right(RenameOptions {
            prepare_provider: Some(true),
            work_done_progress_options: WorkDoneProgressOptions::default(),
        })),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some([".", ":", "(", ",", "{", ">", " "].map(str::to_owned).to_vec()),
            ..CompletionOptions::default()
        }),
        document_symbol_provider: Some(OneOf::Left(true)),
        workspace_symbol_provider: Some(OneOf::Left(true)),
        semantic_tokens_provider: Some(SemanticTokensServerCapabilities::SemanticTokensOptions(
            SemanticTokensOptions {
                legend: colors::legend(),
                full: Some(SemanticTokensFullOptions::Bool(true)),
                ..SemanticTokensOptions::default()
            },
        )),
        code_action_provider: Some(CodeActionProviderCapability::Options(CodeActionOptions {
            code_action_kinds: Some(vec![CodeActionKind::QUICKFIX, CodeActionKind::SOURCE_FIX_ALL]),
            ..CodeActionOptions::default()
        })),
        signature_help_provider: Some(SignatureHelpOptions {
            trigger_characters: Some(["(", ","].map(str::to_owned).to_vec()),
            ..SignatureHelpOptions::default()
        }),
        inlay_hint_provider: Some(OneOf::Left(true)),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        ..ServerCapabilities::default()
    }
}

impl Server<'_> {
    fn initialize(&mut self, parameters: &InitializeParams) -> InitializeResult {
        let folders = parameters.workspace_folders.as_deref().unwrap_or_default();
        #[expect(deprecated, reason = "clients that know of one folder only say so here")]
        let root = folders.first().map(|folder| &folder.uri).or(parameters.root_uri.as_ref());
        self.folder = Folder::new(root, self.desk.library());
        let version = Some(env!("CARGO_PKG_VERSION").to_owned());
        let server_info = Some(ServerInfo { name: env!("CARGO_PKG_NAME").to_owned(), version });
        InitializeResult { capabilities: capabilities(), server_info }
    }

    fn run(&mut self) -> bool {
        while let Some(message) = self.next() {
            match message {
                Message::Request(request) => {
                    let response = self.answer(request);
                    self.send(response);
                }
                Message::Notification(told) if told.method == notifications::Exit::METHOD => return self.is_leaving,
                Message::Notification(told) => self.note(told),
                Message::Response(_) => {}
            }
        }
        false
    }

    /// The next message; `None` when the client is gone. What has to be told is told while none is waiting.
    fn next(&mut self) -> Option<Message> {
        loop {
            self.waiting.extend(self.connection.receiver.try_iter());
            if let Some(message) = self.waiting.pop_front() {
                return Some(message);
            }
            self.tell();
            self.proofs.stop_unless(|path, quick| self.documents.is_current(path, quick));
            let is_done = self.proofs.is_at_work() || self.documents.unproved().is_none();
            let silence = if is_done { never() } else { after(SILENCE) };
            select! {
                recv(self.connection.receiver) -> message => return message.ok(),
                recv(self.proofs.result()) -> result => self.proved(result.ok()),
                recv(silence) -> _ => self.prove(),
            }
        }
    }

    /// Has the properties of a document looked at.
    fn prove(&mut self) {
        let Some((path, quick, levels)) = self.documents.unproved() else { return };
        let files = Overlay { documents: &self.documents, folder: &self.folder, desk: self.desk };
        let loaded = driver::load(&mut self.memo, &files, std::slice::from_ref(&path));
        self.proofs.begin(&path, quick, loaded, Options { levels, ..Options::default() });
    }

    /// Takes over what came of that, if the document is still the same. Without a result it is not tried again.
    fn proved(&mut self, result: Option<Analysis>) {
        let Some((path, quick)) = self.proofs.end() else { return };
        if let Some(document) = self.documents.open.get_mut(&path)
            && document.known.as_ref().is_some_and(|known| Rc::ptr_eq(known, &quick))
        {
            let known = result.map_or(quick, |analysis| Rc::new(Known::new(analysis)));
            (document.known, document.is_thorough, document.is_told) = (Some(known), true, false);
        }
    }

    /// A client that is gone is noticed where the next message is waited for.
    fn send(&self, message: impl Into<Message>) {
        let _ = self.connection.sender.send(message.into());
    }

    fn answer(&mut self, request: Request) -> Response {
        if self.is_leaving {
            let message = "the server has been shut down".to_owned();
            return Response::new_err(request.id, ErrorCode::InvalidRequest as i32, message);
        }
        if self.is_cancelled(&request.id) {
            return Response::new_err(request.id, ErrorCode::RequestCanceled as i32, "cancelled".to_owned());
        }
        match request.method.as_str() {
            requests::Shutdown::METHOD => {
                self.is_leaving = true;
                Response::new_ok(request.id, ())
            }
            requests::Formatting::METHOD => reply::<requests::Formatting>(request, |of| Ok(self.format(&of))),
            requests::GotoDefinition::METHOD => reply::<requests::GotoDefinition>(request, |of| {
                let found = self.named(&of.text_document_position_params);
                Ok(found.map(|(known, name)| definition::definition(&known, name, &self.folder).into()))
            }),
            requests::References::METHOD => reply::<requests::References>(request, |of| {
                let found = self.named_anywhere(&of.text_document_position);
                let all = of.context.include_declaration;
                Ok(found.map(|(known, name)| definition::references(&known, name, all, &self.folder)))
            }),
            requests::PrepareRenameRequest::METHOD => {
                reply::<requests::PrepareRenameRequest>(request, |of| self.prepare_rename(&of))
            }
            requests::Rename::METHOD => reply::<requests::Rename>(request, |of| self.rename(&of)),
            requests::Completion::METHOD => reply::<requests::Completion>(request, |of| {
                let found = self.at(&of.text_document_position);
                let beside = || self.beside(&of.text_document_position.text_document.uri);
                let items = found.map(|(known, byte)| completion::completion(&known, ROOT, byte, &beside));
                Ok(items.map(CompletionResponse::Array))
            }),
            requests::DocumentSymbolRequest::METHOD => reply::<requests::DocumentSymbolRequest>(request, |of| {
                let known = self.know(&self.folder.path(&of.text_document.uri));
                Ok(known.map(|known| DocumentSymbolResponse::Nested(symbols::outline(&known, ROOT))))
            }),
            requests::WorkspaceSymbolRequest::METHOD => reply::<requests::WorkspaceSymbolRequest>(request, |of| {
                let found = symbols::search(&self.know_all(), &of.query, &self.folder);
                Ok(Some(WorkspaceSymbolResponse::Flat(found)))
            }),
            requests::SemanticTokensFullRequest::METHOD => {
                reply::<requests::SemanticTokensFullRequest>(request, |of| {
                    let known = self.know(&self.folder.path(&of.text_document.uri));
                    let colors = known.map(|known| colors::colors(&known, ROOT));
                    Ok(colors.map(|data| SemanticTokensResult::Tokens(SemanticTokens { result_id: None, data })))
                })
            }
            requests::CodeActionRequest::METHOD => {
                reply::<requests::CodeActionRequest>(request, |of| Ok(self.actions(&of)))
            }
            requests::SignatureHelpRequest::METHOD => reply::<requests::SignatureHelpRequest>(request, |of| {
                let found = self.at(&of.text_document_position_params);
                Ok(found.and_then(|(known, byte)| signature::signature(&known, ROOT, byte)))
            }),
            requests::InlayHintRequest::METHOD => reply::<requests::InlayHintRequest>(request, |of| {
                let known = self.know(&self.folder.path(&of.text_document.uri));
                Ok(known.map(|known| {
                    let bytes = known.byte(ROOT, of.range.start)..known.byte(ROOT, of.range.end) + 1;
                    hints::hints(&known, ROOT, &bytes)
                }))
            }),
            requests::HoverRequest::METHOD => reply::<requests::HoverRequest>(request, |of| {
                let found = self.at(&of.text_document_position_params);
                Ok(found.and_then(|(known, byte)| hover::hover(&known, ROOT, byte)))
            }),
            _ => {
                let message = format!("there is no method `{}`", request.method);
                Response::new_err(request.id, ErrorCode::MethodNotFound as i32, message)
            }
        }
    }

    /// Whether a request that is about to be answered is taken back by a message behind it.
    fn is_cancelled(&self, id: &RequestId) -> bool {
        self.waiting.iter().any(|message| {
            let Message::Notification(told) = message else { return false };
            let cancelled = told.clone().extract::<CancelParams>(notifications::Cancel::METHOD);
            cancelled.is_ok_and(|cancelled| match cancelled.id {
                NumberOrString::Number(number) => *id == RequestId::from(number),
                NumberOrString::String(text) => *id == RequestId::from(text),
            })
        })
    }

    /// Takes a notification over. One that is broken, or unknown, changes nothing.
    fn note(&mut self, told: Notification) {
        let method = told.method.clone();
        self.everything = None;
        match method.as_str() {
            notifications::DidOpenTextDocument::METHOD => {
                if let Ok(opened) = told.extract(&method) {
                    self.opened(opened);
                }
            }
            notifications::DidChangeTextDocument::METHOD => {
                if let Ok(changed) = told.extract(&method) {
                    self.changed(changed);
                }
            }
            notifications::DidCloseTextDocument::METHOD => {
                if let Ok(closed) = told.extract(&method) {
                    self.closed(&closed);
                }
            }
            notifications::DidSaveTextDocument::METHOD => {
                if let Ok(saved) = told.extract(&method) {
                    self.saved(&saved);
                }
            }
            notifications::DidChangeWatchedFiles::METHOD => {
                if let Ok(changed) = told.extract(&method) {
                    self.files_changed(&changed);
                }
            }
            _ => {}
        }
    }

    fn opened(&mut self, opened: DidOpenTextDocumentParams) {
        let document = opened.text_document;
        let path = self.folder.path(&document.uri);
        // A client may be set up to open more with us than is ours. A text that has no file yet is ours if it says so.
        let is_file = document.uri.as_str().starts_with("file:");
        if driver::kind(&path).is_none() && (is_file || document.language_id != LANGUAGE) {
            return;
        }
        let levels = self.desk.levels(&self.folder.on_disk(&path));
        self.documents.forget_all();
        let (uri, text, version) = (document.uri, document.text, document.version);
        self.documents.open.insert(
            path,
            Document { uri, text, version, levels, known: None, is_thorough: false, told: None, is_told: false },
        );
    }

    fn changed(&mut self, changed: DidChangeTextDocumentParams) {
        let path = self.folder.path(&changed.text_document.uri);
        let Some(document) = self.documents.open.get_mut(&path) else { return };
        document.version = changed.text_document.version;
        for change in changed.content_changes {
            document.change(change);
        }
        self.documents.forget(&path);
    }

    fn closed(&mut self, closed: &DidCloseTextDocumentParams) {
        let uri = &closed.text_document.uri;
        if self.documents.open.remove(&self.folder.path(uri)).is_some() {
            self.documents.forget_all();
            self.publish(uri.clone(), None, Vec::new());
        }
    }

    fn saved(&mut self, saved: &DidSaveTextDocumentParams) {
        let path = self.folder.path(&saved.text_document.uri);
        let levels = self.desk.levels(&self.folder.on_disk(&path));
        if let Some(document) = self.documents.open.get_mut(&path) {
            document.levels = levels;
            document.known = None;
        }
    }

    fn files_changed(&mut self, _: &DidChangeWatchedFilesParams) {
        for (path, document) in &mut self.documents.open {
            document.levels = self.desk.levels(&self.folder.on_disk(path));
        }
        self.documents.forget_all();
    }

    /// What is known of a document; looks at it where nothing is.
    fn know(&mut self, path: &str) -> Option<Rc<Known>> {
        let document = self.documents.open.get(path)?;
        if let Some(known) = &document.known {
            return Some(Rc::clone(known));
        }
        let files = Overlay { documents: &self.documents, folder: &self.folder, desk: self.desk };
        let loaded = driver::load(&mut self.memo, &files, &[path.to_owned()]);
        let options = Options { levels: document.levels.clone(), verify: false, ..Options::default() };
        let analysis = driver::examine(loaded, &options);
        let is_thorough = analysis.program.properties.is_empty();
        let known = Rc::new(Known::new(analysis));
        let document = self.documents.open.get_mut(path)?;
        (document.known, document.is_thorough, document.is_told) = (Some(Rc::clone(&known)), is_thorough, false);
        Some(known)
    }

    /// What is known of the document of a position, and the byte there.
    fn at(&mut self, of: &TextDocumentPositionParams) -> Option<(Rc<Known>, usize)> {
        let known = self.know(&self.folder.path(&of.text_document.uri))?;
        let byte = known.byte(ROOT, of.position);
        Some((known, byte))
    }

    /// The name at a position.
    fn named(&mut self, of: &TextDocumentPositionParams) -> Option<(Rc<Known>, Span)> {
        let (known, byte) = self.at(of)?;
        let name = known.name_at(ROOT, byte)?;
        Some((known, name))
    }

    /// The name at a position, among all files of the client's folder and all open ones.
    fn named_anywhere(&mut self, of: &TextDocumentPositionParams) -> Option<(Rc<Known>, Span)> {
        let known = self.know_all();
        let file = known.file(&self.folder.path(&of.text_document.uri))?;
        let name = known.name_at(file, known.byte(file, of.position))?;
        Some((known, name))
    }

    /// What is known of all files of the client's folder and all open ones together.
    fn know_all(&mut self) -> Rc<Known> {
        if let Some(known) = &self.everything {
            return Rc::clone(known);
        }
        let paths = self.all_paths();
        let files = Overlay { documents: &self.documents, folder: &self.folder, desk: self.desk };
        let loaded = driver::load(&mut self.memo, &files, &paths);
        let known = Rc::new(Known::new(driver::examine(loaded, &all())));
        self.everything = Some(Rc::clone(&known));
        known
    }

    fn all_paths(&self) -> Vec<String> {
        let on_disk = self.folder.root().map(|root| self.desk.files(root)).unwrap_or_default();
        let on_disk = on_disk.into_iter().map(|path| self.folder.relative(path));
        self.documents.open.keys().cloned().chain(on_disk).collect()
    }

    /// The fixes for a range of a document, of the kinds that are asked for.
    fn actions(&mut self, of: &CodeActionParams) -> Option<Vec<CodeActionOrCommand>> {
        let known = self.know(&self.folder.path(&of.text_document.uri))?;
        let bytes = known.byte(ROOT, of.range.start)..=known.byte(ROOT, of.range.end);
        let is_wanted = |kind: Option<&CodeActionKind>| match (&of.context.only, kind) {
            (Some(only), Some(kind)) => only.iter().any(|wanted| kind.as_str().starts_with(wanted.as_str())),
            _ => true,
        };
        let actions = actions::actions(&known, ROOT, &bytes, &self.folder).into_iter();
        let actions = actions.filter(|action| is_wanted(action.kind.as_ref()));
        Some(actions.map(CodeActionOrCommand::CodeAction).collect())
    }

    /// The names by which a file can import those beside it, and those in the folders there.
    fn beside(&self, uri: &Uri) -> Vec<String> {
        let path = self.folder.path(uri);
        let folder = path.rsplit_once('/').map_or("", |(folder, _)| folder);
        let inside = |other: &String| {
            let rest =
                if folder.is_empty() { Some(other.as_str()) } else { other.strip_prefix(folder)?.strip_prefix('/') };
            let stem = rest?.rsplit_once('.')?.0;
            (*other != path).then(|| stem.replace('/', "."))
        };
        self.all_paths().iter().filter_map(inside).collect()
    }

    fn prepare_rename(&mut self, of: &TextDocumentPositionParams) -> Result<Option<PrepareRenameResponse>, Refusal> {
        let Some((known, name)) = self.named_anywhere(of) else { return Ok(None) };
        rename::places(&known, name).map_err(refused)?;
        Ok(Some(PrepareRenameResponse::Range(known.range(name))))
    }

    fn rename(&mut self, of: &RenameParams) -> Result<Option<WorkspaceEdit>, Refusal> {
        let new = &of.new_name;
        let Some((known, name)) = self.named_anywhere(&of.text_document_position) else { return Ok(None) };
        let places = rename::places(&known, name).map_err(refused)?;
        if !driver::is_name(new) {
            return Err(refused(format!("`{new}` is not a name")));
        }
        let texts = rename::renamed(&known, &places, new);
        let texts =
            texts.into_iter().map(|(file, text)| (known.analysis.sources.path(file).to_owned(), text)).collect();
        let paths = self.all_paths();
        let under = Overlay { documents: &self.documents, folder: &self.folder, desk: self.desk };
        let changed = driver::load(&mut self.memo, &Changed { texts, under }, &paths);
        let after = driver::examine(changed, &all());
        match rename::new_error(&known, &Known::new(after)) {
            Some(message) => Err(refused(format!("with that name {message}"))),
            None => Ok(Some(rename::edit(&known, &places, new, &self.folder))),
        }
    }

    /// Publishes what is found in the documents of which something new is known, where it is something else than before.
    fn tell(&mut self) {
        let untold = self.documents.open.iter().filter(|(_, document)| document.known.is_none() || !document.is_told);
        let untold: Vec<_> = untold.map(|(path, _)| path.clone()).collect();
        for path in &untold {
            let Some(known) = self.know(path) else { continue };
            let found =
                diagnostics::diagnostics(&known, ROOT, |path| self.documents.open.contains_key(path), &self.folder);
            let Some(document) = self.documents.open.get_mut(path) else { continue };
            document.is_told = true;
            if document.told.as_ref() != Some(&found) {
                document.told = Some(found.clone());
                let (uri, version) = (document.uri.clone(), document.version);
                self.publish(uri, Some(version), found);
            }
        }
        if !untold.is_empty() {
            self.memo.forget_unused();
        }
    }

    fn publish(&self, uri: Uri, version: Option<i32>, diagnostics: Vec<lsp_types::Diagnostic>) {
        let found = PublishDiagnosticsParams { uri, diagnostics, version };
        self.send(Notification::new(notifications::PublishDiagnostics::METHOD.to_owned(), found));
    }

    fn format(&self, of: &DocumentFormattingParams) -> Option<Vec<TextEdit>> {
        let path = self.folder.path(&of.text_document.uri);
        let files = Overlay { documents: &self.documents, folder: &self.folder, desk: self.desk };
        Some(formatting::formatting(files.kind(&path)?, &self.documents.open.get(&path)?.text))
    }
}
