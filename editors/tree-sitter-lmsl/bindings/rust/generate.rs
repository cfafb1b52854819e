//! Writes the parser anew from `grammar.js`, as `tree-sitter generate` does.

use tree_sitter_generate::{GenerateError, OptLevel, generate_parser_in_directory};

/// What editors of the last years read.
const ABI: usize = 14;

fn main() -> Result<(), GenerateError> {
    let folder = env!("CARGO_MANIFEST_DIR");
    let same: Option<&str> = None;
    generate_parser_in_directory(folder, same, same, ABI, None, Some("node"), true, OptLevel::default())
}
