//! The language server: what an editor asks, answered from analyses of the files as they stand in the editor. One file
//! a feature.
//!
//! Imports: analysis, base, diag, driver, ir, membership, sema, syntax
//! Crates: crossbeam-channel, lsp-server, lsp-types

mod actions;
mod colors;
mod completion;
mod definition;
mod diagnostics;
mod documents;
mod drawing;
mod folder;
mod formatting;
mod hints;
mod hover;
mod known;
mod lines;
mod names;
mod place;
mod proofs;
mod rename;
mod server;
mod signature;
mod symbols;

pub use lines::Lines;
pub use server::{serve, serve_stdio};

use crate::diag::Levels;
use crate::driver::Files;

/// What the server needs of the machine it runs on, beside the texts of files. Paths are absolute, but for those of an
/// editor's texts that were never saved.
pub trait Desk: Files {
    /// The files of the language in a folder and the folders in it.
    fn files(&self, folder: &str) -> Vec<String>;

    /// The levels that the project's configuration for a file gives.
    fn levels(&self, path: &str) -> Levels;

    /// The folder in which an editor can open the standard library, as `std/robots/j5.msd`, if there is one.
    fn library(&self) -> Option<String>;
}
