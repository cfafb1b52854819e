//! One integration binary: every module tests one promise.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "tests")]
#![allow(clippy::disallowed_methods, clippy::print_stderr, reason = "tests read files")]

mod architecture;
mod book;
mod charts;
mod ci;
mod cli;
mod columns;
mod corpus;
mod defects;
mod docs;
mod editors;
mod emit;
mod emit_harness;
mod emit_programs;
mod examples;
mod fault_table;
mod fault_words;
mod faults;
mod format;
mod fuzzy_findings;
mod golden;
mod golden_reader;
mod limits;
mod lsp;
mod modes;
mod navigator;
mod network;
mod network_more;
mod outputs;
mod pages;
mod parse_again;
mod promela;
mod properties;
mod random_modes;
mod random_properties;
mod repl;
mod rounds;
mod sessions;
mod support;
mod syntax;
mod terminal;
mod tick;
mod trials;
mod unused;
mod watch;
