//! `lmslc lsp`

use clap::Args;

use super::config;
use super::files::{self, Disk};
use super::terminal::Terminal;
use crate::diag::Levels;
use crate::driver::{self, FileError, Files};
use crate::lsp::{self, Desk};

/// Serve an editor: the language server, over standard input and output.
#[derive(Args)]
#[command(after_help = "\
Editors start this themselves; docs/editors.md says how to set them up.")]
pub(super) struct Lsp {
    /// Taken for granted, and accepted because many clients say it
    #[arg(long, hide = true)]
    stdio: bool,
}

/// Serves the client on the other end until it leaves; answers the exit code.
pub(super) fn serve(terminal: &Terminal) -> u8 {
    let library = files::user_cache().and_then(|folder| library(&folder));
    let is_orderly = lsp::serve_stdio(&Machine { terminal, library });
    if is_orderly { super::CLEAN } else { super::FINDINGS }
}

/// The disk, the project's configuration, and a copy of the library that editors can open.
struct Machine<'a> {
    terminal: &'a Terminal,
    library: Option<String>,
}

impl Files for Machine<'_> {
    fn read(&self, path: &str) -> Result<String, FileError> {
        Disk::default().read(path)
    }
}

impl Desk for Machine<'_> {
    fn files(&self, folder: &str) -> Vec<String> {
        files::below(folder)
    }

    fn levels(&self, path: &str) -> Levels {
        config::levels(path, self, self.terminal).unwrap_or_default()
    }

    fn library(&self) -> Option<String> {
        self.library.clone()
    }
}

/// Writes the library, where it is not there already, so that a definition in it can be opened. The files cannot be
/// written: what is in the binary counts. `None` where there is no place for it.
fn library(cache: &str) -> Option<String> {
    let folder = format!("{cache}/lmslc/{}", env!("CARGO_PKG_VERSION"));
    for (path, text) in driver::LIBRARY {
        files::keep(&format!("{folder}/{path}"), text).ok()?;
    }
    Some(folder)
}
