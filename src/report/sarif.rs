//! Diagnostics as SARIF 2.1.0 (OASIS, 2020), for code scanning.

use serde_json::{Value, json};

use super::json::to_line;
use super::places::Places;
use crate::base::{FileId, Sources, Span};
use crate::diag::{Diagnostic, Edit, RULES, Rule, Severity};

/// Renders diagnostics in their order as one run, with the rules they belong to. What is suppressed is left out.
pub fn sarif(diagnostics: &[Diagnostic], sources: &Sources) -> String {
    let places = Places::new(sources);
    let found = |rule: &&&Rule| diagnostics.iter().any(|diagnostic| diagnostic.rule == **rule);
    let rules: Vec<&Rule> = RULES.iter().filter(found).copied().collect();
    to_line(&json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "lmslc",
                "semanticVersion": env!("CARGO_PKG_VERSION"),
                "rules": rules.iter().map(|rule| descriptor(rule)).collect::<Vec<_>>(),
            } },
            "columnKind": "unicodeCodePoints",
            "results": diagnostics.iter().map(|diagnostic| result(diagnostic, &rules, &places)).collect::<Vec<_>>(),
        }],
    }))
}

fn descriptor(rule: &Rule) -> Value {
    // A page is a heading, a paragraph, and sections.
    let description = rule.page.split("\n\n").nth(1).unwrap_or(rule.summary);
    json!({
        "id": rule.code,
        "name": rule.name,
        "shortDescription": { "text": rule.summary },
        "fullDescription": { "text": description.trim() },
        "help": { "text": rule.page, "markdown": rule.page },
        "defaultConfiguration": { "level": level(rule.level) },
    })
}

fn result(diagnostic: &Diagnostic, rules: &[&Rule], places: &Places<'_>) -> Value {
    let mut locations = diagnostic.labels.iter().map(|label| location(label.span, &label.message, places));
    let mut result = json!({
        "ruleId": diagnostic.rule.code,
        "ruleIndex": rules.iter().position(|&rule| rule == diagnostic.rule),
        "level": level(diagnostic.severity),
        "message": { "text": diagnostic.text() },
        "locations": locations.next().into_iter().collect::<Vec<_>>(),
        "relatedLocations": locations.collect::<Vec<_>>(),
    });
    if let Some(fix) = &diagnostic.fix {
        let changes = fix.edits.iter().map(|edit| change(edit, places)).collect::<Vec<_>>();
        result["fixes"] = json!([{ "description": { "text": fix.message }, "artifactChanges": changes }]);
    }
    result
}

fn location(span: Span, message: &str, places: &Places<'_>) -> Value {
    let mut location = json!({ "physicalLocation": { "artifactLocation": artifact(span.file, places), "region": region(span, places) } });
    if !message.is_empty() {
        location["message"] = json!({ "text": message });
    }
    location
}

fn change(edit: &Edit, places: &Places<'_>) -> Value {
    json!({
        "artifactLocation": artifact(edit.span.file, places),
        "replacements": [{ "deletedRegion": region(edit.span, places), "insertedContent": { "text": edit.text } }],
    })
}

/// Lines and columns count from 1; the end is one past the last character, as SARIF has it.
fn region(span: Span, places: &Places<'_>) -> Value {
    let (start_line, start_column) = places.position(span.file, span.start);
    let (end_line, end_column) = places.position(span.file, span.end);
    json!({ "startLine": start_line, "startColumn": start_column, "endLine": end_line, "endColumn": end_column })
}

fn artifact(file: FileId, places: &Places<'_>) -> Value {
    json!({ "uri": uri(places.path(file)) })
}

/// A path as a reference (RFC 3986): relative as it is, absolute as a `file:` address.
fn uri(path: &str) -> String {
    let scheme = if path.starts_with('/') { "file://" } else { "" };
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let encode = |byte: u8| if plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") };
    path.bytes().fold(scheme.to_owned(), |uri, byte| uri + &encode(byte))
}

const fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Info => "note",
        Severity::Warning => "warning",
        Severity::Error => "error",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::samples;

    #[test]
    fn every_finding_is_a_result_with_its_rule() {
        let (diagnostics, sources) = samples::diagnostics();
        let mut log: Value = serde_json::from_str(&sarif(&diagnostics, &sources)).unwrap();
        for rule in log["runs"][0]["tool"]["driver"]["rules"].as_array_mut().unwrap() {
            // Pages change for reasons of their own.
            assert!(rule["help"]["text"].as_str().unwrap().starts_with(&format!("# {}", rule["id"].as_str().unwrap())));
            rule["help"] = json!("...");
            rule["fullDescription"] = json!("...");
        }
        insta::assert_snapshot!(serde_json::to_string_pretty(&log).unwrap());
    }

    #[test]
    fn paths_are_references() {
        assert_eq!(uri("examples/j5/manipulation.msd"), "examples/j5/manipulation.msd");
        assert_eq!(uri("/home/ü b/a:1.msd"), "file:///home/%C3%BC%20b/a%3A1.msd");
    }
}
