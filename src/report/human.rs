//! Diagnostics for people: the message, the lines it is about, the language's rule and the way out.

use codespan_reporting::diagnostic::{self as shown, LabelStyle};
use codespan_reporting::term::termcolor::Buffer;
use codespan_reporting::term::{Config, Styles, StylesWriter, emit_to_write_style};

use super::places::Places;
use super::short;
use crate::base::{FileId, Sources};
use crate::diag::{Diagnostic, Severity};

/// Renders diagnostics in their order, a blank line after each. `color` adds ANSI escapes. Costs a pass over all
/// sources, then time in the size of what is shown.
pub fn human(diagnostics: &[Diagnostic], sources: &Sources, color: bool) -> String {
    let places = Places::new(sources);
    let config = Config::default();
    let styles = Styles::default();
    let mut buffer = if color { Buffer::ansi() } else { Buffer::no_color() };
    for diagnostic in diagnostics {
        let mut one = if color { Buffer::ansi() } else { Buffer::no_color() };
        let writer = &mut StylesWriter::new(&mut one, &styles);
        // A finding must never be lost to its decoration: where the lines cannot be shown, its text still is.
        if emit_to_write_style(writer, &config, &places, &to_shown(diagnostic, &places)).is_err() {
            one.clear();
            append(&mut one, short::line(diagnostic, &places).as_bytes());
        }
        append(&mut buffer, one.as_slice());
    }
    String::from_utf8_lossy(buffer.as_slice()).into_owned()
}

/// Writing to memory has no way to fail.
fn append(buffer: &mut Buffer, bytes: &[u8]) {
    let _ = std::io::Write::write_all(buffer, bytes);
}

fn to_shown(diagnostic: &Diagnostic, places: &Places<'_>) -> shown::Diagnostic<FileId> {
    let severity = match diagnostic.severity {
        Severity::Info => shown::Severity::Note,
        Severity::Warning => shown::Severity::Warning,
        Severity::Error => shown::Severity::Error,
    };
    let labels = diagnostic.labels.iter().enumerate().filter_map(|(index, label)| {
        let style = if index == 0 { LabelStyle::Primary } else { LabelStyle::Secondary };
        let range = places.shown(label.span)?;
        Some(shown::Label::new(style, label.span.file, range).with_message(&label.message))
    });
    let notes = diagnostic.notes.iter().map(|note| hanging("note: ", note));
    let help = diagnostic.help.iter().map(|help| hanging("help: ", help));
    shown::Diagnostic::new(severity)
        .with_code(diagnostic.rule.code)
        .with_message(&diagnostic.message)
        .with_labels(labels.collect())
        .with_notes(notes.chain(help).collect())
}

/// `text` after `prefix`, its further lines indented to stand below the first.
fn hanging(prefix: &str, text: &str) -> String {
    let indent = format!("\n{}", " ".repeat(prefix.len()));
    format!("{prefix}{}", text.replace('\n', &indent))
}

/// How many findings there are of each severity, as the line after the list: `3 errors, 1 warning`; `no findings`
/// without any.
pub fn summary(diagnostics: &[Diagnostic]) -> String {
    let count = |severity, one: &str| {
        let number = diagnostics.iter().filter(|diagnostic| diagnostic.severity == severity).count();
        (number > 0).then(|| format!("{number} {one}{}", if number == 1 { "" } else { "s" }))
    };
    let counts = [count(Severity::Error, "error"), count(Severity::Warning, "warning"), count(Severity::Info, "note")];
    let counts: Vec<String> = counts.into_iter().flatten().collect();
    if counts.is_empty() { "no findings".to_owned() } else { counts.join(", ") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Span;
    use crate::diag::find_rule;
    use crate::report::samples;

    #[test]
    fn the_lines_are_shown_with_their_reasons() {
        let (diagnostics, sources) = samples::diagnostics();
        insta::assert_snapshot!(human(&diagnostics, &sources, false));
    }

    #[test]
    fn color_adds_escapes_and_nothing_else() {
        let (diagnostics, sources) = samples::diagnostics();
        let colored = human(&diagnostics, &sources, true);
        assert!(colored.contains("\u{1b}["));
        let mut plain = String::new();
        let mut escape = false;
        for character in colored.chars() {
            match character {
                '\u{1b}' => escape = true,
                'm' if escape => escape = false,
                _ if escape => {}
                other => plain.push(other),
            }
        }
        assert_eq!(plain, human(&diagnostics, &sources, false));
    }

    #[test]
    fn no_place_is_too_wrong_to_show() {
        let mut sources = Sources::default();
        let file = sources.add("a.msd", "é∈\n\nbc");
        let rule = find_rule("LM0101").unwrap();
        for file in [file, FileId(9)] {
            for start in 0..10 {
                for end in 0..10 {
                    let wrong = Diagnostic::new(rule, Span::new(file, start, end), "wrong").here("here");
                    let text = human(&[wrong], &sources, false);
                    assert!(text.starts_with("error[LM0101]: wrong\n"), "{text}");
                }
            }
        }
    }

    #[test]
    fn thousands_of_findings_do_not_take_long() {
        let mut sources = Sources::default();
        let file = sources.add("a.msd", "transition to push when forward_collision\n".repeat(20_000));
        let rule = find_rule("LM0101").unwrap();
        let at = |index: u32| Span::new(file, index * 42, index * 42 + 10);
        let many: Vec<_> = (0..5_000).map(|index| Diagnostic::new(rule, at(index * 4), "wrong")).collect();
        assert_eq!(human(&many, &sources, false).matches("error[LM0101]").count(), 5_000);
    }

    #[test]
    fn the_summary_counts_in_plain_words() {
        let (mut diagnostics, _) = samples::diagnostics();
        assert_eq!(summary(&diagnostics), "2 errors, 1 warning");
        diagnostics.remove(0);
        assert_eq!(summary(&diagnostics), "1 error, 1 warning");
        diagnostics[0].severity = Severity::Info;
        diagnostics[1].severity = Severity::Info;
        assert_eq!(summary(&diagnostics), "2 notes");
        assert_eq!(summary(&[]), "no findings");
    }
}
