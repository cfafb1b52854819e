//! Findings that the source itself says are fine, and why: `// lmsl: allow(dead-end) because the mission ends here`.

use std::collections::{BTreeMap, BTreeSet};

use super::{Diagnostic, Edit, Fix, Rule, Severity, find_rule, rules};
use crate::base::{FileId, Sources, Span};

/// What a suppression looks like, for help lines.
const FORM: &str = "write `// lmsl: allow(RULE) because REASON`";

/// A file, the code of a rule, and the first byte of the line that is spoken of; `None` for the whole file.
type Key = (FileId, &'static str, Option<u32>);

/// Comments that suppress one rule in one place.
#[derive(Debug, Clone)]
struct Suppression {
    rule: &'static Rule,
    /// One past the line's last byte.
    end: u32,
    comments: Vec<Span>,
}

/// All suppressions of a compilation.
#[derive(Debug, Clone, Default)]
pub struct Suppressions(BTreeMap<Key, Suppression>);

impl Suppressions {
    /// Collects the suppressions of all files in one pass over their text; reports those that cannot be.
    pub fn collect(sources: &Sources, findings: &mut Vec<Diagnostic>) -> Self {
        let mut all: BTreeMap<Key, Suppression> = BTreeMap::new();
        for (file, source) in sources.iter() {
            for comment in comments(file, &source.text) {
                match parse(&comment, &source.text) {
                    Some(Ok((rule, line))) => {
                        let key = (file, rule.code, line.map(|line| line.start));
                        let end = line.map_or(0, |line| line.end);
                        let new = || Suppression { rule, end, comments: Vec::new() };
                        all.entry(key).or_insert_with(new).comments.push(comment.span);
                    }
                    Some(Err(finding)) => findings.push(finding),
                    None => {}
                }
            }
        }
        Self(all)
    }

    /// Whether a finding is suppressed: its primary label begins in a file or line that is spoken of.
    pub fn cover(&self, finding: &Diagnostic) -> bool {
        self.covering(finding).next().is_some()
    }

    /// One finding for each comment that covers none of `findings`, of the files and rules that were looked at.
    pub fn unused(
        &self,
        findings: &[Diagnostic],
        sources: &Sources,
        looked_at: impl Fn(FileId, &Rule) -> bool,
    ) -> Vec<Diagnostic> {
        let used: BTreeSet<&Key> = findings.iter().flat_map(|finding| self.covering(finding)).collect();
        let idle = self.0.iter().filter(|(key, of)| !used.contains(key) && looked_at(key.0, of.rule));
        let idle = idle.map(|(_, suppression)| suppression);
        idle.flat_map(|idle| idle.comments.iter().map(|&comment| unused(idle.rule, comment, sources))).collect()
    }

    fn covering(&self, finding: &Diagnostic) -> impl Iterator<Item = &Key> {
        let (place, code) = (finding.span(), finding.rule.code);
        let whole_file = self.0.get_key_value(&(place.file, code, None));
        // Lines do not overlap, so it is the last one that begins before the finding, or none.
        let line = self.0.range((place.file, code, Some(0))..=(place.file, code, Some(place.start))).next_back();
        let line = line.filter(|(_, line)| place.start <= line.end);
        whole_file.into_iter().chain(line).map(|(key, _)| key)
    }
}

/// A line comment.
struct Comment<'a> {
    /// Its text without the slashes.
    text: &'a str,
    span: Span,
    /// The line it speaks of: its own, or the next line of code where it has none on its own.
    reach: Span,
    /// Whether nothing but comments stands before it.
    at_top: bool,
}

/// Every comment of a text. The language has no strings, so a comment begins wherever two slashes stand.
fn comments(file: FileId, text: &str) -> Vec<Comment<'_>> {
    let span = |part: &str| {
        let start = offset(part, text);
        Span::new(file, start, start + part.len() as u32)
    };
    let mut comments: Vec<Comment<'_>> = Vec::new();
    // How many comments stand directly above, alone on their lines.
    let mut above = 0;
    let mut at_top = true;
    for line in lines(text) {
        let (code, comment) = line.find("//").map_or((line, None), |start| (&line[..start], Some(&line[start..])));
        let has_code = !code.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}').is_empty();
        at_top &= !has_code;
        if has_code {
            let start = comments.len() - above;
            for waiting in &mut comments[start..] {
                waiting.reach = span(line);
            }
        }
        above = if has_code || comment.is_none() { 0 } else { above + 1 };
        if let Some(comment) = comment {
            comments.push(Comment { text: &comment[2..], span: span(comment), reach: span(line), at_top });
        }
    }
    comments
}

/// The lines of a text, however they end: `\n`, `\r\n` or `\r`.
fn lines(text: &str) -> impl Iterator<Item = &str> {
    text.split_inclusive('\n').flat_map(|line| {
        let line = line.strip_suffix('\n').unwrap_or(line);
        line.strip_suffix('\r').unwrap_or(line).split('\r')
    })
}

/// Where a part of a text begins in it.
fn offset(part: &str, text: &str) -> u32 {
    (part.as_ptr().addr() - text.as_ptr().addr()) as u32
}

/// The rule that a comment suppresses and the line on which, `None` for the whole file, or why it does not. Nothing for
/// a comment that is for people only.
fn parse(comment: &Comment<'_>, text: &str) -> Option<Result<(&'static Rule, Option<Span>), Diagnostic>> {
    // A reason ends where another comment begins.
    let directive = comment.text.split("//").next()?.trim().strip_prefix("lmsl:")?.trim_start();
    let place = |part: &str| {
        let start = offset(part, text);
        Span::new(comment.span.file, start, start + part.len() as u32)
    };
    let Some((verb, (name, rest))) = directive
        .split_once('(')
        .and_then(|(verb, rest)| Some((verb.trim_end(), rest.split_once(')')?)))
        .filter(|(verb, _)| ["allow", "allow-file"].contains(verb))
    else {
        return Some(Err(unreadable(comment.span)));
    };
    let name = name.trim();
    let reason = rest.trim_start().strip_prefix("because").filter(|reason| reason.starts_with(char::is_whitespace));
    let whole_file = verb == "allow-file";
    Some(match find_rule(name) {
        None => Err(unknown_rule(name, place(name))),
        Some(rule) if rule.level == Severity::Error => Err(always_an_error(rule, place(name))),
        Some(_) if reason.is_none_or(|reason| reason.trim().is_empty()) => Err(no_reason(name, comment.span)),
        Some(_) if whole_file && !comment.at_top => Err(not_at_top(name, comment.span)),
        Some(rule) => Ok((rule, (!whole_file).then_some(comment.reach))),
    })
}

fn unreadable(span: Span) -> Diagnostic {
    Diagnostic::new(&rules::BAD_SUPPRESSION, span, "this comment says nothing the compiler knows")
        .help(format!("{FORM}, or `allow-file` at the top of the file"))
}

fn unknown_rule(name: &str, span: Span) -> Diagnostic {
    Diagnostic::new(&rules::BAD_SUPPRESSION, span, format!("there is no diagnostic `{name}`"))
        .help_maybe(super::did_you_mean(name, rules::names()))
}

fn always_an_error(rule: &Rule, span: Span) -> Diagnostic {
    Diagnostic::new(&rules::BAD_SUPPRESSION, span, format!("`{}` is an error and cannot be suppressed", rule.name))
        .note("a program it is found in has no meaning")
}

fn no_reason(name: &str, span: Span) -> Diagnostic {
    Diagnostic::new(&rules::BAD_SUPPRESSION, span, format!("`{name}` is suppressed without a reason"))
        .note("without a reason nothing is suppressed")
        .help(format!("say why it is right here: `allow({name}) because ...`"))
}

fn not_at_top(name: &str, span: Span) -> Diagnostic {
    Diagnostic::new(
        &rules::BAD_SUPPRESSION,
        span,
        format!("`allow-file({name})` does not stand at the top of its file"),
    )
    .note("only comments may stand before it")
    .help("move it there, or write `allow` for the line below")
}

fn unused(rule: &Rule, comment: Span, sources: &Sources) -> Diagnostic {
    let message = format!("this comment suppresses no `{}`", rule.name);
    Diagnostic::new(&rules::UNUSED_SUPPRESSION, comment, message)
        .help("remove it")
        .fix(Fix { message: "remove the comment".to_owned(), edits: vec![Edit::remove(comment, sources)] })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The texts that each comment speaks of.
    fn reaches(text: &str) -> Vec<(&str, &str)> {
        let comments = comments(FileId(0), text).into_iter();
        comments.map(|comment| (comment.text.trim(), text[comment.reach.range()].trim())).collect()
    }

    #[test]
    fn a_comment_speaks_of_its_line_or_the_one_below() {
        for end in ["\n", "\r\n", "\r"] {
            let text = ["// a", "/// b", "  mode x { // c", "// d", "", "} // e", "// f"].join(end);
            let own = "mode x { // c";
            let found = [("a", own), ("/ b", own), ("c", own), ("d", "// d"), ("e", "} // e"), ("f", "// f")];
            assert_eq!(reaches(&text), found, "{end:?}");
        }
        assert_eq!(reaches("\u{feff}// a\nmode"), [("a", "mode")]);
        assert!(reaches("").is_empty());
    }

    #[test]
    fn every_prefix_of_a_suppression_is_read() {
        let text = "// lmsl: allow(dead-end) because the mission ends here";
        for end in 0..=text.len() {
            let mut sources = Sources::default();
            sources.add("a.msd", &text[..end]);
            let mut findings = Vec::new();
            let found = Suppressions::collect(&sources, &mut findings).0.len();
            let written = end >= "// lmsl:".len();
            assert_eq!(found + findings.len(), usize::from(written), "{}", &text[..end]);
            assert_eq!(found == 1, end > "// lmsl: allow(dead-end) because ".len(), "{}", &text[..end]);
        }
    }
}
