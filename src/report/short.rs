//! Diagnostics one a line, for editors and for `grep`.

use super::places::Places;
use crate::base::Sources;
use crate::diag::Diagnostic;

/// Renders diagnostics in their order as `path:line:column: severity[CODE]: message`, one a line; lines and columns
/// count from 1, columns in characters.
pub fn short(diagnostics: &[Diagnostic], sources: &Sources) -> String {
    let places = Places::new(sources);
    diagnostics.iter().map(|diagnostic| line(diagnostic, &places)).collect()
}

pub(super) fn line(diagnostic: &Diagnostic, places: &Places<'_>) -> String {
    let span = diagnostic.span();
    let (line, column) = places.position(span.file, span.start);
    let (path, severity, code) = (places.path(span.file), diagnostic.severity.name(), diagnostic.rule.code);
    // One finding is one line, whatever its message holds.
    let message = diagnostic.message.replace(['\n', '\r'], " ");
    format!("{path}:{line}:{column}: {severity}[{code}]: {message}\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::samples;

    #[test]
    fn every_finding_is_one_line() {
        let (diagnostics, sources) = samples::diagnostics();
        insta::assert_snapshot!(short(&diagnostics, &sources));
    }
}
