//! Text on a terminal: color where it is wanted, and lines that fit.

/// Puts ANSI escapes around words, or does not.
pub(super) struct Paint {
    pub(super) color: bool,
}

impl Paint {
    pub(super) fn bold(&self, text: &str) -> String {
        self.with("1", text)
    }

    pub(super) fn good(&self, text: &str) -> String {
        self.with("1;32", text)
    }

    pub(super) fn bad(&self, text: &str) -> String {
        self.with("1;31", text)
    }

    pub(super) fn faint(&self, text: &str) -> String {
        self.with("2", text)
    }

    fn with(&self, code: &str, text: &str) -> String {
        if self.color { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_owned() }
    }
}

/// Fills lines of `width` characters with items and semicolons between them. A line breaks between items where it
/// can, inside an item where that alone is too long, and never inside a word.
pub(super) fn wrap(items: &[String], width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    let fits = |line: &str, more: &str| line.chars().count() + 1 + more.chars().count() <= width;
    for (index, item) in items.iter().enumerate() {
        let item = if index + 1 < items.len() { format!("{item};") } else { item.clone() };
        if line.is_empty() || !fits(&line, &item) {
            lines.extend((!line.is_empty()).then(|| std::mem::take(&mut line)));
            for word in item.split_whitespace() {
                if !line.is_empty() && !fits(&line, word) {
                    lines.push(std::mem::take(&mut line));
                }
                push(&mut line, word);
            }
        } else {
            push(&mut line, &item);
        }
    }
    lines.extend((!line.is_empty()).then_some(line));
    lines
}

fn push(line: &mut String, more: &str) {
    if !line.is_empty() {
        line.push(' ');
    }
    line.push_str(more);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_stay_whole_where_they_can() {
        let items = ["force 118 N".to_owned(), "left -1.71 m/s^2".to_owned(), "x 1".to_owned()];
        assert_eq!(wrap(&items, 80), ["force 118 N; left -1.71 m/s^2; x 1"]);
        assert_eq!(wrap(&items, 21), ["force 118 N;", "left -1.71 m/s^2; x 1"]);
        assert_eq!(wrap(&items, 9), ["force 118", "N;", "left", "-1.71", "m/s^2;", "x 1"]);
        assert!(wrap(&[], 9).is_empty());
    }
}
