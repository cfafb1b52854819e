//! Changes of text that mend a finding.

use std::collections::{BTreeMap, BTreeSet};

use crate::base::{FileId, Sources, Span};

/// A change that mends a finding and leaves the program's behavior as it is.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fix {
    /// What it does, as in "remove the import".
    pub message: String,
    /// All of it; a part alone is no fix.
    pub edits: Vec<Edit>,
}

/// Text put in the place of other text.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct Edit {
    /// What is replaced.
    pub span: Span,
    /// By what.
    pub text: String,
}

impl Edit {
    /// Removes `span`; with it the blanks before it where it ends its line, and the whole line where it stands alone.
    pub fn remove(span: Span, sources: &Sources) -> Self {
        let text = sources.get(span.file).map_or("", |source| source.text.as_str());
        let before = text.get(..span.range().start).unwrap_or("");
        let after = text.get(span.range().end..).unwrap_or("");
        let (mut start, mut end) = (before.len(), span.range().end);
        let blanks_after = after.len() - after.trim_start_matches([' ', '\t']).len();
        let rest = after.get(blanks_after..).unwrap_or("");
        if rest.is_empty() || rest.starts_with(['\n', '\r']) {
            let kept = before.trim_end_matches([' ', '\t']);
            start = kept.len();
            if kept.is_empty() || kept.ends_with(['\n', '\r', '\u{feff}']) {
                let line_end = ["\r\n", "\n", "\r"].into_iter().find(|end| rest.starts_with(end));
                end += blanks_after + line_end.map_or(0, str::len);
            }
        }
        Self { span: Span::new(span.file, start as u32, end as u32), text: String::new() }
    }
}

/// Files after fixes.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Fixed {
    /// The new texts of the files that were changed.
    pub texts: BTreeMap<FileId, String>,
    /// How many fixes were applied.
    pub count: usize,
}

/// Applies fixes in their order, but none that touches text an earlier one replaces: it is for the next round, when the
/// findings are known anew. Costs a pass over the changed files.
pub fn apply_fixes<'a>(fixes: impl IntoIterator<Item = &'a Fix>, sources: &Sources) -> Fixed {
    let mut accepted: BTreeSet<&Edit> = BTreeSet::new();
    let mut fixed = Fixed::default();
    for fix in fixes {
        let taken = fix.edits.iter().take_while(|edit| fits(edit, &accepted, sources) && accepted.insert(edit)).count();
        if taken == fix.edits.len() {
            fixed.count += 1;
        } else {
            for edit in fix.edits.iter().take(taken) {
                accepted.remove(edit);
            }
        }
    }
    // From the end, so that places before a change stay where they are.
    for edit in accepted.into_iter().rev() {
        let text = || sources.get(edit.span.file).map(|source| source.text.clone()).unwrap_or_default();
        fixed.texts.entry(edit.span.file).or_insert_with(text).replace_range(edit.span.range(), &edit.text);
    }
    fixed
}

/// Whether an edit lies in its file and apart from those accepted; they do not overlap, so its neighbors decide.
fn fits(edit: &Edit, accepted: &BTreeSet<&Edit>, sources: &Sources) -> bool {
    let source = sources.get(edit.span.file);
    source.is_some_and(|source| source.text.get(edit.span.range()).is_some())
        && accepted.range::<Edit, _>(..edit).next_back().is_none_or(|before| apart(before.span, edit.span))
        && accepted.range::<Edit, _>(edit..).next().is_none_or(|after| apart(edit.span, after.span))
}

/// Whether `first` ends before `second` begins; two changes at one place are not apart.
fn apart(first: Span, second: Span) -> bool {
    first.file != second.file || (first.end <= second.start && first.start < second.start)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn without(text: &str, word: &str) -> String {
        let mut sources = Sources::default();
        let file = sources.add("a.msd", text);
        let start = text.find(word).unwrap() as u32;
        let edit = Edit::remove(Span::new(file, start, start + word.len() as u32), &sources);
        let fix = Fix { message: String::new(), edits: vec![edit] };
        let mut fixed = apply_fixes([&fix], &sources);
        assert_eq!(fixed.count, 1);
        fixed.texts.remove(&file).unwrap()
    }

    #[test]
    fn what_stands_alone_takes_its_line_along() {
        assert_eq!(without("one\n  two \nthree\n", "two"), "one\nthree\n");
        assert_eq!(without("one\r\ntwo\r\nthree\r\n", "two"), "one\r\nthree\r\n");
        assert_eq!(without("\u{feff}one\ntwo", "one"), "\u{feff}two");
        assert_eq!(without("one\ntwo", "two"), "one\n");
        assert_eq!(without("one  two\n", "two"), "one\n");
        assert_eq!(without("one two\n", "one"), " two\n");
        assert_eq!(without("one", "one"), "");
    }

    #[test]
    fn changes_that_touch_wait_for_the_next_round() {
        let mut sources = Sources::default();
        let file = sources.add("a.msd", "abcdefé");
        let fix = |ranges: &[(u32, u32)]| {
            let edit = |&(start, end)| Edit { span: Span::new(file, start, end), text: "-".to_owned() };
            Fix { message: String::new(), edits: ranges.iter().map(edit).collect() }
        };
        let apply = |fixes: &[Fix]| {
            let fixed = apply_fixes(fixes, &sources);
            (fixed.count, fixed.texts.get(&file).cloned().unwrap_or_default())
        };
        assert_eq!(apply(&[fix(&[(0, 2)]), fix(&[(1, 3)]), fix(&[(2, 3)])]), (2, "--defé".to_owned()));
        assert_eq!(apply(&[fix(&[(4, 5)]), fix(&[(0, 1), (4, 6)])]), (1, "abcd-fé".to_owned()));
        assert_eq!(apply(&[fix(&[(1, 1)]), fix(&[(1, 1)])]), (1, "a-bcdefé".to_owned()));
        assert_eq!(apply(&[fix(&[(7, 8)]), fix(&[(3, 99)])]), (0, String::new()));
    }
}
