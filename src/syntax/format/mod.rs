//! One canonical layout of a file: the same tokens and comments, with the transitions of a mode by priority, tables in
//! columns, and space by rule. What the author broke into lines stays so where there is a choice: short blocks on one
//! line, and single empty lines.

mod columns;
mod items;
mod printer;
mod spacing;

use super::ast::FileKind;
use super::parse::parse;
use crate::base::FileId;
use crate::diag::Diagnostic;

/// Formats a file of either kind. Formatting twice changes nothing more. Linear in the text.
///
/// # Errors
///
/// The findings of a file that does not parse.
pub fn format(file: FileId, kind: FileKind, text: &str) -> Result<String, Vec<Diagnostic>> {
    let (_, findings) = parse(file, kind, text);
    if !findings.is_empty() {
        return Err(findings);
    }
    let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n").replace('\r', "\n");
    Ok(printer::print(&items::file(&text)))
}
