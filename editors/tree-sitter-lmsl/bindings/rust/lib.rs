//! The language for programs that read trees: the grammar, and which of its nodes are what.

use tree_sitter_language::LanguageFn;

unsafe extern "C" {
    fn tree_sitter_lmsl() -> *const ();
}

/// The grammar.
// The generated parser has this function, and it gives a table that nothing changes.
pub const LANGUAGE: LanguageFn = unsafe { LanguageFn::from_raw(tree_sitter_lmsl) };

/// How nodes are colored.
pub const HIGHLIGHTS_QUERY: &str = include_str!("../../queries/highlights.scm");

/// What can be folded.
pub const FOLDS_QUERY: &str = include_str!("../../queries/folds.scm");
