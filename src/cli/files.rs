//! Files on disk, and standard input.

use std::cell::RefCell;
use std::collections::{BTreeMap, HashSet};
use std::io::Read;
use std::path::Path;

use super::{config, flags::AnalysisFlags, terminal::Terminal};
use crate::driver::{self, Analysis, FileError, Files, Options};

/// The disk, and standard input as `-`. Keeps what it was asked and what it answered.
#[derive(Default)]
pub(super) struct Disk {
    answers: RefCell<BTreeMap<Question, Answer>>,
}

/// What is asked of the disk.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Question {
    /// The text of a file.
    Text(String),
    /// The files of the language below a folder.
    Folder(String),
}

impl Question {
    /// What the disk says now.
    pub(super) fn ask(&self) -> Answer {
        match self {
            Question::Text(path) => Answer::Text(text_at(path)),
            Question::Folder(path) => Answer::Folder(files_in(path)),
        }
    }
}

/// What it answers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Answer {
    /// The text.
    Text(Result<String, FileError>),
    /// The paths, sorted; what to say where they cannot be had.
    Folder(Result<Vec<String>, String>),
}

impl Disk {
    fn ask<T>(&self, question: Question, answer: T, wrap: fn(T) -> Answer) -> T
    where
        T: Clone,
    {
        self.answers.borrow_mut().insert(question, wrap(answer.clone()));
        answer
    }

    /// Everything it was asked, with its answers.
    pub(super) fn into_answers(self) -> BTreeMap<Question, Answer> {
        self.answers.into_inner()
    }

    fn folder(&self, path: &str) -> Result<Vec<String>, String> {
        self.ask(Question::Folder(path.to_owned()), files_in(path), Answer::Folder)
    }

    /// Analyzes files, the files of folders, and `-`, under the project's configuration and the flags over it.
    ///
    /// # Errors
    /// The exit code, where the arguments or the configuration are wrong; that has been reported.
    pub(super) fn analyze(
        &self,
        paths: &[String],
        flags: Option<&AnalysisFlags>,
        terminal: &Terminal,
    ) -> Result<Analysis, u8> {
        let roots = self.expand(paths, terminal)?;
        let levels = config::levels(roots.first().map_or("", String::as_str), self, terminal)?;
        // What is run watches its properties instead: one that is refuted may well be run, to see why.
        let mut options = Options { levels, verify: flags.is_some(), ..Options::default() };
        if let Some(flags) = flags {
            flags.apply(&mut options, terminal)?;
        }
        Ok(driver::analyze(self, &roots, &options))
    }

    /// Analyzes and shows what was found, for commands that go on from there.
    ///
    /// # Errors
    /// As for [`Disk::analyze`].
    pub(super) fn look(&self, paths: &[String], terminal: &Terminal) -> Result<Analysis, u8> {
        let analysis = self.analyze(paths, None, terminal)?;
        terminal.findings(&analysis);
        Ok(analysis)
    }

    /// Paths with the files of folders in their places; a file that has several paths, under its first.
    ///
    /// # Errors
    /// The exit code, where a folder cannot be read or holds no file of the language; that has been reported.
    pub(super) fn expand(&self, paths: &[String], terminal: &Terminal) -> Result<Vec<String>, u8> {
        let mut files = Vec::new();
        for path in paths {
            if path == "-" || !Path::new(path).is_dir() {
                files.push(path.clone());
                continue;
            }
            let found = self.folder(path).map_err(|message| terminal.fail(&message, None))?;
            if found.is_empty() {
                let message = format!("the folder `{path}` holds no `.msd` or `.fsfn` file");
                let help = "hidden folders, caches, `target` and `node_modules` are passed over";
                return Err(terminal.fail(&message, Some(help)));
            }
            files.extend(found);
        }
        let mut known = HashSet::new();
        files.retain(|path| std::fs::canonicalize(path).map_or(true, |file| known.insert(file)));
        Ok(files)
    }
}

impl Files for Disk {
    fn read(&self, path: &str) -> Result<String, FileError> {
        // What was read from standard input cannot be read again.
        let question = Question::Text(path.to_owned());
        if path == "-"
            && let Some(Answer::Text(text)) = self.answers.borrow().get(&question)
        {
            return text.clone();
        }
        self.ask(question, text_at(path), Answer::Text)
    }
}

/// The text of a file, and standard input as `-`.
fn text_at(path: &str) -> Result<String, FileError> {
    if path == "-" {
        return standard_input();
    }
    if Path::new(path).is_dir() {
        return Err(FileError::Unreadable("it is a folder".to_owned()));
    }
    match std::fs::read(path) {
        Ok(bytes) => text(bytes),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Err(FileError::Missing),
        Err(error) => Err(FileError::Unreadable(error.to_string())),
    }
}

fn text(bytes: Vec<u8>) -> Result<String, FileError> {
    String::from_utf8(bytes).map_err(|error| FileError::NotUtf8 { byte: error.utf8_error().valid_up_to() })
}

fn standard_input() -> Result<String, FileError> {
    let mut bytes = Vec::new();
    std::io::stdin().read_to_end(&mut bytes).map_err(|error| FileError::Unreadable(error.to_string()))?;
    text(bytes)
}

/// Analyzes as [`Disk::look`] does, asking the disk once.
///
/// # Errors
/// As for [`Disk::analyze`].
pub(super) fn look(paths: &[String], terminal: &Terminal) -> Result<Analysis, u8> {
    Disk::default().look(paths, terminal)
}

/// The files of the language in a folder and the folders in it, by name.
///
/// # Errors
/// What to say of a folder that cannot be read.
fn files_in(folder: &str) -> Result<Vec<String>, String> {
    let mut files = Vec::new();
    collect(Path::new(folder), &mut files).map(|()| files)
}

/// Hidden folders, those that say to be caches (as cargo's do), `target` and `node_modules` are passed over.
fn collect(folder: &Path, files: &mut Vec<String>) -> Result<(), String> {
    let unread = |error| format!("the folder `{}` cannot be read: {error}", folder.display());
    let entries = std::fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
    let mut entries = entries.map_err(unread)?;
    entries.sort_by_key(std::fs::DirEntry::path);
    for entry in entries {
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        // Links to folders are not followed: they may lead in a circle.
        if entry.file_type().map_err(unread)?.is_dir() {
            let is_ours = !name.starts_with('.') && name != "target" && name != "node_modules";
            if is_ours && !path.join("CACHEDIR.TAG").exists() {
                collect(&path, files)?;
            }
        } else if path.extension().is_some_and(|ending| ending == "msd" || ending == "fsfn") {
            files.push(path.to_string_lossy().into_owned());
        }
    }
    Ok(())
}

/// The files of the language below a folder, as far as it can be read, with slashes between their folders.
pub(super) fn below(folder: &str) -> Vec<String> {
    let mut files = Vec::new();
    // What was found before something could not be read is better than nothing.
    let _ = collect(Path::new(folder), &mut files);
    if cfg!(windows) { files.into_iter().map(|path| path.replace('\\', "/")).collect() } else { files }
}

/// Where the user's system keeps what programs can make again; `None` where it does not say.
pub(super) fn user_cache() -> Option<String> {
    user_folder("XDG_CACHE_HOME", "Library/Caches", ".cache")
}

/// Where it keeps what programs remember from one call to the next.
pub(super) fn user_state() -> Option<String> {
    user_folder("XDG_STATE_HOME", "Library/Application Support", ".local/state")
}

/// A folder that a variable names, else the one of the system, below the user's home.
fn user_folder(variable: &str, of_macos: &str, of_others: &str) -> Option<String> {
    let said = |name: &str| std::env::var(name).ok().filter(|path| Path::new(path).is_absolute());
    let below_home = |folder: &str| said("HOME").map(|home| format!("{home}/{folder}"));
    let system = match std::env::consts::OS {
        "windows" => said("LOCALAPPDATA"),
        "macos" => below_home(of_macos),
        _ => below_home(of_others),
    };
    said(variable).or(system).map(|path| path.replace('\\', "/"))
}

/// Writes a text that is not meant to be changed to a file, where it does not stand there already.
///
/// # Errors
/// Those of the system.
pub(super) fn keep(path: &str, text: &str) -> std::io::Result<()> {
    let path = Path::new(path);
    if std::fs::read(path).is_ok_and(|bytes| bytes == text.as_bytes()) {
        return Ok(());
    }
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder)?;
    }
    // One that cannot be written can still be replaced.
    match std::fs::remove_file(path) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => return Err(error),
        _ => std::fs::write(path, text)?,
    }
    let mut permissions = std::fs::metadata(path)?.permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(path, permissions)
}

/// Writes a result to a file.
///
/// # Errors
/// The exit code; the reason has been reported.
pub(super) fn write(path: &str, bytes: &[u8], terminal: &Terminal) -> Result<(), u8> {
    std::fs::write(path, bytes).map_err(|error| terminal.fail(&format!("`{path}` cannot be written: {error}"), None))
}

/// Writes texts, each with a name: one to where `output` says, or several each into a file of its name in that folder.
///
/// # Errors
/// The exit code; the reason has been reported.
pub(super) fn write_each(
    texts: &[(String, String)],
    extension: &str,
    output: Option<&str>,
    terminal: &Terminal,
) -> Result<(), u8> {
    let is_folder = |path: &&str| texts.len() > 1 || Path::new(path).is_dir();
    match (texts, output, output.filter(is_folder)) {
        ([(_, text)], None, _) => {
            Terminal::print(text);
            Ok(())
        }
        (_, None, _) => {
            let message = format!("there are {} of them, and each is a text of its own", texts.len());
            Err(terminal.fail(&message, Some("name a folder for them, with `--output`")))
        }
        ([(_, text)], Some(path), None) => write(path, text.as_bytes(), terminal),
        (_, Some(folder), _) => {
            let mut names = std::collections::BTreeSet::new();
            if let Some((twice, _)) = texts.iter().find(|(name, _)| !names.insert(name)) {
                let message = format!("several are named `{twice}`, and each goes into a file of its name");
                return Err(terminal.fail(&message, Some("take their files one by one")));
            }
            make_folder(folder, terminal)?;
            texts.iter().try_for_each(|(name, text)| {
                let path = Path::new(folder).join(format!("{name}.{extension}"));
                write(&path.to_string_lossy(), text.as_bytes(), terminal)
            })
        }
    }
}

/// Makes a folder, and those it is in, where there is none yet.
///
/// # Errors
/// The exit code; the reason has been reported.
pub(super) fn make_folder(path: &str, terminal: &Terminal) -> Result<(), u8> {
    std::fs::create_dir_all(path)
        .map_err(|error| terminal.fail(&format!("the folder `{path}` cannot be made: {error}"), None))
}

/// Reads a file.
///
/// # Errors
/// The exit code; the reason has been reported.
pub(super) fn read(path: &str, terminal: &Terminal) -> Result<String, u8> {
    text_of(path).map_err(|message| terminal.fail(&message, None))
}

/// The text of a file, and standard input as `-`.
///
/// # Errors
/// What to say of it.
pub(super) fn text_of(path: &str) -> Result<String, String> {
    text_at(path).map_err(|error| unread(path, &error))
}

pub(super) fn unread(path: &str, error: &FileError) -> String {
    let reason = match error {
        FileError::Missing => return format!("there is no file `{path}`"),
        FileError::NotUtf8 { byte } => format!("it is not UTF-8 text from byte {byte} on"),
        FileError::Unreadable(reason) => reason.clone(),
    };
    format!("`{path}` cannot be read: {reason}")
}
