//! Diagnostics as workflow commands, which GitHub shows on the lines of a change.

use super::places::Places;
use crate::base::Sources;
use crate::diag::{Diagnostic, Severity};

/// Renders diagnostics in their order, one workflow command a line:
/// `::error file=a.msd,line=1,col=2,endLine=1,endColumn=5,title=LM0404 unreachable-mode::message`. Notes and help are
/// further lines of the message.
pub fn github(diagnostics: &[Diagnostic], sources: &Sources) -> String {
    let places = Places::new(sources);
    diagnostics.iter().map(|diagnostic| command(diagnostic, &places)).collect()
}

fn command(diagnostic: &Diagnostic, places: &Places<'_>) -> String {
    let kind = match diagnostic.severity {
        Severity::Info => "notice",
        Severity::Warning => "warning",
        Severity::Error => "error",
    };
    let span = diagnostic.span();
    let (line, column) = places.position(span.file, span.start);
    let (end_line, end_column) = places.position(span.file, span.end);
    let file = property(places.path(span.file));
    // GitHub takes columns only where a place lies on one line.
    let place = if line == end_line {
        format!("file={file},line={line},col={column},endLine={line},endColumn={end_column}")
    } else {
        format!("file={file},line={line},endLine={end_line}")
    };
    let title = property(&format!("{} {}", diagnostic.rule.code, diagnostic.rule.name));
    format!("::{kind} {place},title={title}::{}\n", data(&diagnostic.text()))
}

/// A message as a command carries it.
fn data(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// A value between the commas of a command.
fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::Span;
    use crate::diag::rules;
    use crate::report::samples;

    #[test]
    fn every_finding_is_one_command() {
        let (diagnostics, sources) = samples::diagnostics();
        insta::assert_snapshot!(github(&diagnostics, &sources));
    }

    #[test]
    fn what_commands_are_made_of_is_escaped() {
        let mut sources = Sources::default();
        let file = sources.add("a,b:100%.msd", "mode x\n");
        let finding = Diagnostic::new(&rules::DEAD_END, Span::new(file, 5, 6), "50 %, a::b\r\nc").help("d");
        insta::assert_snapshot!(
            github(&[finding], &sources),
            @"::warning file=a%2Cb%3A100%25.msd,line=1,col=6,endLine=1,endColumn=7,title=LM0406 dead-end::50 %25, a::b%0D%0Ac%0Ahelp: d"
        );
    }
}
