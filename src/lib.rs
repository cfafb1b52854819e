//! `lmslc` compiles robot behavior written as text: modes with prioritized exits (`.msd`), fed by fuzzy sensor
//! fusion (`.fsfn`). See `ARCHITECTURE.md` for the rooms of this house.

pub mod analysis;
pub mod base;
pub mod cli;
pub mod diag;
pub mod driver;
pub mod emit;
pub mod interp;
pub mod ir;
pub mod kernel;
pub mod lsp;
mod membership;
pub mod plan;
pub mod repl;
pub mod report;
pub mod sema;
pub mod sim;
pub mod syntax;
pub mod trace;
pub mod verify;
pub mod view;

pub use cli::build;
