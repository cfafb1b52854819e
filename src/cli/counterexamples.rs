//! Refuted properties as files that `lmslc run` shows.

use std::path::{Component, Path};

use super::files;
use super::terminal::Terminal;
use crate::base::FileId;
use crate::driver::Analysis;

/// Writes one file for each refuted property of which the simulator shows a run. It imports what the property is about,
/// so the folder must hold that too, at any depth.
///
/// # Errors
/// The exit code; the reason has been reported.
pub(super) fn write(analysis: &Analysis, folder: &str, terminal: &Terminal) -> Result<(), u8> {
    for shown in &analysis.counterexamples {
        let property = &analysis.program.properties[shown.property];
        let diagram = &analysis.program.diagrams[property.diagram];
        let mut imports = Vec::new();
        for file in [property.symbol.span.file, diagram.symbol.span.file] {
            let import =
                format!("import {}\n", imported(analysis, file, folder).map_err(|error| error.report(terminal))?);
            if !imports.contains(&import) {
                imports.push(import);
            }
        }
        let (name, imports) = (&property.symbol.name, imports.concat());
        let text = format!("// A run that breaks `{name}`, as found by `lmslc check`.\n\n{imports}\n{}", shown.text);
        let path = Path::new(folder).join(format!("{}.msd", shown.name));
        let path = path.to_string_lossy();
        files::write(&path, text.as_bytes(), terminal)?;
        terminal.note(&format!("`{name}` is broken by `{path}`; `lmslc run {path}` shows how"));
    }
    Ok(())
}

/// Why no file in a folder can import another.
pub(super) struct NotBelow {
    pub(super) message: String,
    pub(super) help: &'static str,
}

impl NotBelow {
    fn report(&self, terminal: &Terminal) -> u8 {
        terminal.fail(&self.message, Some(self.help))
    }
}

/// How a file in a folder imports another.
pub(super) fn imported(analysis: &Analysis, file: FileId, folder: &str) -> Result<String, NotBelow> {
    let path = analysis.sources.path(file);
    if let Some(inside) = path.strip_prefix("std/") {
        return Ok(format!("std.{}", inside.trim_end_matches(".msd").replace('/', ".")));
    }
    below(Path::new(path), Path::new(folder)).ok_or_else(|| NotBelow {
        message: format!("no file in `{folder}` can import `{path}`"),
        help: "name the folder it is in, or one above that; an import is made of plain words",
    })
}

/// The way from a folder down to a file, as an import spells it.
fn below(file: &Path, folder: &Path) -> Option<String> {
    let (file, folder) = (file.canonicalize().ok()?, folder.canonicalize().ok()?);
    let inside = file.strip_prefix(folder).ok()?.with_extension("");
    let is_word = |word: &&str| {
        let is_letter = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
        word.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_') && word.chars().all(is_letter)
    };
    let words = inside.components().map(|part| match part {
        Component::Normal(word) => word.to_str().filter(is_word),
        _ => None,
    });
    words.collect::<Option<Vec<_>>>().filter(|words| words.first() != Some(&"std")).map(|words| words.join("."))
}
