//! The project's configuration: `lmsl.toml` beside the first file, or in a folder above it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use toml::Spanned;

use super::files::unread;
use super::terminal::Terminal;
use crate::base::{Sources, Span};
use crate::diag::{self, Diagnostic, Level, Levels, find_rule, rules};
use crate::driver::Files;

const NAME: &str = "lmsl.toml";

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Configuration {
    /// Rules by code or name, each `allow`, `warn` or `deny`.
    #[serde(default)]
    levels: BTreeMap<Spanned<String>, Spanned<String>>,
}

/// The levels that the configuration for a file gives; the default ones without a configuration.
///
/// # Errors
/// The exit code, where the configuration is wrong; that has been reported.
pub(super) fn levels(file: &str, files: &dyn Files, terminal: &Terminal) -> Result<Levels, u8> {
    let known = places(file).into_iter().map(|path| path.to_string_lossy().into_owned());
    let mut known = known.map(|path| (files.read(&path), path));
    let Some((text, path)) = known.find(|(text, path)| text.is_ok() || Path::new(path).is_file()) else {
        return Ok(Levels::default());
    };
    let text = text.map_err(|error| terminal.fail(&unread(&path, &error), None))?;
    parse(&path, &text).map_err(|(findings, sources)| {
        terminal.errors(&findings, &sources);
        super::USAGE
    })
}

/// The configuration that holds for a file.
pub(super) fn find(file: &str) -> Option<PathBuf> {
    places(file).into_iter().find(|path| path.is_file())
}

/// Where the configuration for a file can lie, the nearest place first.
fn places(file: &str) -> Vec<PathBuf> {
    let folder = if file == "-" { Path::new(".") } else { Path::new(file).parent().unwrap_or(Path::new(".")) };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let (Ok(start), Ok(here)) = (std::path::absolute(folder), std::env::current_dir()) else { return Vec::new() };
    let place = |folder: &Path| {
        let path = folder.join(NAME);
        path.strip_prefix(&here).map(Path::to_path_buf).unwrap_or(path)
    };
    start.ancestors().map(place).collect()
}

fn parse(path: &str, text: &str) -> Result<Levels, (Vec<Diagnostic>, Sources)> {
    let mut sources = Sources::default();
    let file = sources.add(path, text);
    let span = |range: std::ops::Range<usize>| Span::new(file, range.start as u32, range.end as u32);
    let mut findings = Vec::new();
    let mut levels = Levels::default();
    match toml::from_str::<Configuration>(text) {
        Ok(configuration) => {
            for (name, level) in &configuration.levels {
                let rule = find_rule(name.get_ref());
                let wanted = match level.get_ref().as_str() {
                    "allow" => Some(Level::Allow),
                    "warn" => Some(Level::Warn),
                    "deny" => Some(Level::Deny),
                    _ => None,
                };
                if rule.is_none() {
                    findings.push(unknown_rule(name.get_ref(), span(name.span())));
                }
                if wanted.is_none() {
                    findings.push(unknown_level(level.get_ref(), span(level.span())));
                }
                if let (Some(rule), Some(wanted)) = (rule, wanted)
                    && !levels.set(rule, wanted)
                {
                    findings.push(fixed_level(rule, span(name.span())));
                }
            }
        }
        Err(error) => {
            let place = span(error.span().unwrap_or_default());
            let message = error.message().lines().next().unwrap_or_default().to_owned();
            findings.push(Diagnostic::new(&rules::BAD_CONFIGURATION, place, message));
        }
    }
    if findings.is_empty() { Ok(levels) } else { Err((findings, sources)) }
}

fn unknown_rule(name: &str, span: Span) -> Diagnostic {
    Diagnostic::new(&rules::BAD_CONFIGURATION, span, format!("there is no diagnostic `{name}`"))
        .help_maybe(diag::did_you_mean(name, rules::names()))
}

fn unknown_level(level: &str, span: Span) -> Diagnostic {
    Diagnostic::new(&rules::BAD_CONFIGURATION, span, format!("`{level}` is not a level"))
        .help("write \"allow\", \"warn\" or \"deny\"")
}

fn fixed_level(rule: &diag::Rule, span: Span) -> Diagnostic {
    Diagnostic::new(&rules::BAD_CONFIGURATION, span, format!("`{}` is always an error", rule.name))
        .note("a program it is found in has no meaning")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn messages(text: &str) -> Vec<String> {
        match parse("lmsl.toml", text) {
            Ok(_) => Vec::new(),
            Err((findings, _)) => findings.into_iter().map(|finding| finding.message).collect(),
        }
    }

    #[test]
    fn a_configuration_is_checked_word_by_word() {
        assert!(messages("").is_empty());
        assert!(messages("[levels]\nLM0404 = \"allow\"\ndead-end = \"deny\"\nunknown-name = \"deny\"").is_empty());
        assert_eq!(messages("[levels]\ndead-and = \"deny\""), ["there is no diagnostic `dead-and`"]);
        assert_eq!(messages("[levels]\ndead-end = \"never\""), ["`never` is not a level"]);
        assert_eq!(messages("[levels]\nunknown-name = \"allow\""), ["`unknown-name` is always an error"]);
        assert_eq!(messages("[level]\n").len(), 1);
    }
}
