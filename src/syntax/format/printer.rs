//! Items as lines.

use super::columns::{Row, aligned, has_columns};
use super::items::{File, Item, Note, Token};
use super::spacing::is_spaced;
use crate::syntax::parse::Rule;

/// Lines are kept within so many characters where they can be broken.
const WIDTH: usize = 120;
/// How much further what belongs to something is indented.
const STEP: usize = 4;
/// Long lines are broken inside of fewer parentheses than this.
const MOST_NESTED: usize = 4;

pub fn print(file: &File<'_>) -> String {
    let mut printer = Printer { lines: Vec::new() };
    let mut last: Option<&Item<'_>> = None;
    for item in &file.items {
        // Imports stand together, and so may properties.
        if last.is_some_and(|last| last.kind != item.kind || item.block.is_some()) {
            printer.blank();
        }
        printer.item(item, &Row::new(item).text(), 0);
        last = Some(item);
    }
    printer.notes(&file.tail, 0);
    printer.into_text()
}

/// A line without its end; empty between others.
#[derive(Default)]
struct Line {
    text: String,
    /// A comment behind it.
    comment: Option<String>,
    /// Whether what follows belongs to it.
    opens: bool,
}

struct Printer {
    lines: Vec<Line>,
}

impl Printer {
    fn line(&mut self, depth: usize, text: &str, comment: Option<&str>) {
        let text = format!("{:1$}{text}", "", depth * STEP);
        self.lines.push(Line { text, comment: comment.map(str::to_owned), opens: false });
    }

    /// An empty line, but not two, and not where a block begins.
    fn blank(&mut self) {
        if self.lines.last().is_some_and(|last| !last.opens && !last.text.is_empty()) {
            self.lines.push(Line::default());
        }
    }

    fn notes(&mut self, notes: &[Note<'_>], depth: usize) {
        for note in notes {
            if note.blank_before {
                self.blank();
            }
            self.line(depth, note.text, None);
        }
    }

    /// Items below each other: neighbours of a kind in columns, transitions by priority.
    fn items(&mut self, items: &[Item<'_>], depth: usize) {
        let items = by_priority(items);
        let mut rest = items.as_slice();
        while let [first, others @ ..] = rest {
            let on_line = others.iter().take_while(|item| shares_line(first, item)).count();
            let below = || others.iter().take_while(|item| item.kind == first.kind && !item.is_set_off()).count();
            let together = 1 + if on_line > 0 || !has_columns(first.kind) { on_line } else { below() };
            let (group, others) = rest.split_at(together);
            let rows: Vec<_> = group.iter().map(|item| Row::new(item)).collect();
            if on_line > 0 {
                let text = rows.iter().map(Row::text).collect::<Vec<_>>().join("  ");
                self.lead(first, depth);
                self.line(depth, &text, group.last().and_then(|last| last.tokens.last()?.after));
            } else {
                for (item, text) in group.iter().zip(aligned(&rows)) {
                    self.item(item, &text, depth);
                }
            }
            rest = others;
        }
    }

    /// What stands in front of an item.
    fn lead(&mut self, item: &Item<'_>, depth: usize) {
        if let Some(token) = item.tokens.first() {
            self.notes(&token.before, depth);
            if token.blank_before {
                self.blank();
            }
        }
    }

    /// An item whose own tokens are `text` where they fit on a line.
    fn item(&mut self, item: &Item<'_>, text: &str, depth: usize) {
        self.lead(item, depth);
        let fits = |text: &str| depth * STEP + text.chars().count() <= WIDTH;
        let comment = item.tokens.last().and_then(|token| token.after);
        let whole = item.block.as_ref().filter(|block| block.on_one_line).and_then(|_| inline(item));
        if let Some((whole, comment)) = whole.filter(|(whole, _)| fits(whole)) {
            self.line(depth, &whole, comment);
            return;
        }
        if fits(text) && !is_interrupted(&item.tokens) {
            self.line(depth, text, comment);
        } else {
            self.broken(&item.tokens, depth);
        }
        let Some(block) = &item.block else { return };
        if let Some(line) = self.lines.last_mut() {
            line.opens = true;
        }
        self.items(&block.items, depth + 1);
        if let Some(close) = &block.close {
            self.notes(&close.before, depth + 1);
            self.line(depth, close.text, close.after);
        }
    }

    /// Tokens on several lines: as few as can be, broken where the fewest parentheses are open, and at comments.
    fn broken(&mut self, tokens: &[Token<'_>], depth: usize) {
        let room = WIDTH - (depth + 1) * STEP;
        let fits = |pieces: &Vec<&[Token<'_>]>| pieces.iter().all(|piece| joined(piece).chars().count() <= room);
        let all = (0..MOST_NESTED).map(|nested| pieces(tokens, nested));
        let Some(pieces) = all.reduce(|coarse, fine| if fits(&coarse) { coarse } else { fine }) else { return };
        let (mut text, mut indent, mut last) = (String::new(), depth, None::<&Token<'_>>);
        for piece in pieces {
            let (Some(first), word) = (piece.first(), joined(piece)) else { continue };
            if let Some(last) = last {
                let is_noted = last.after.is_some() || !first.before.is_empty();
                if is_noted || text.chars().count() + 1 + word.chars().count() > room {
                    self.line(indent, &text, last.after);
                    text.clear();
                    indent = depth + 1;
                    self.notes(&first.before, indent);
                } else if is_spaced(last, first) {
                    text.push(' ');
                }
            }
            text.push_str(&word);
            last = piece.last();
        }
        self.line(indent, &text, last.and_then(|last| last.after));
    }

    /// Comments behind lines that stand below each other begin in one column.
    fn into_text(self) -> String {
        let mut text = String::new();
        let mut rest = self.lines.as_slice();
        while let [first, others @ ..] = rest {
            let indent = |line: &Line| line.text.chars().take_while(|c| *c == ' ').count();
            let is_below = |line: &&Line| line.comment.is_some() && !line.opens && indent(line) == indent(first);
            let below = || others.iter().take_while(is_below).count();
            let together = 1 + if first.comment.is_none() || first.opens { 0 } else { below() };
            let (group, others) = rest.split_at(together);
            let width = group.iter().map(|line| line.text.chars().count()).max().unwrap_or_default();
            for Line { text: line, comment, .. } in group {
                text.push_str(line);
                if let Some(comment) = comment {
                    text.extend(std::iter::repeat_n(' ', width - line.chars().count() + 2));
                    text.push_str(comment);
                }
                text.push('\n');
            }
            rest = others;
        }
        text
    }
}

/// Transitions among themselves by priority; everything else stays where it is.
fn by_priority<'i, 't>(items: &'i [Item<'t>]) -> Vec<&'i Item<'t>> {
    let is_transition = |item: &&Item<'_>| item.kind == Rule::transition;
    let priority = |item: &&Item<'_>| item.tokens.first().and_then(|token| token.text.parse::<u64>().ok());
    let mut transitions: Vec<_> = items.iter().filter(is_transition).collect();
    transitions.sort_by_key(priority);
    let mut transitions = transitions.into_iter();
    items.iter().map(|item| if is_transition(&item) { transitions.next().unwrap_or(item) } else { item }).collect()
}

/// Whether two settings stand on one line, as the author wrote them.
fn shares_line(first: &Item<'_>, other: &Item<'_>) -> bool {
    let is_setting =
        |item: &Item<'_>| matches!(item.kind, Rule::duration | Rule::tick | Rule::seed | Rule::body_parameter);
    is_setting(first) && is_setting(other) && first.line() == other.line()
}

/// An item with its block in one line, and the comment behind it; none where comments stand inside.
fn inline<'t>(item: &Item<'t>) -> Option<(String, Option<&'t str>)> {
    let mut text = Row::new(item).text();
    let Some(block) = &item.block else {
        return (!is_interrupted(&item.tokens)).then(|| (text, item.tokens.last().and_then(|token| token.after)));
    };
    let last = item.tokens.last().is_some_and(|token| token.after.is_some());
    if last || is_interrupted(&item.tokens) {
        return None;
    }
    let mut comment = None;
    for (index, inner) in by_priority(&block.items).into_iter().enumerate() {
        let is_noted = inner.tokens.first().is_some_and(|token| !token.before.is_empty());
        if is_noted || comment.is_some() {
            return None;
        }
        let (inner, behind) = inline(inner)?;
        text.push_str(if index > 0 && block.close.is_some() { "  " } else { " " });
        text.push_str(&inner);
        comment = behind;
    }
    let Some(close) = &block.close else { return Some((text, comment)) };
    if comment.is_some() || !close.before.is_empty() {
        return None;
    }
    text.push_str(if block.items.is_empty() { "}" } else { " }" });
    Some((text, close.after))
}

/// Whether a comment stands between some tokens.
fn is_interrupted(tokens: &[Token<'_>]) -> bool {
    tokens.windows(2).any(|pair| pair[0].after.is_some() || !pair[1].before.is_empty())
}

fn joined(tokens: &[Token<'_>]) -> String {
    let mut text = String::new();
    let mut last = None;
    for token in tokens {
        if last.is_some_and(|last| is_spaced(last, token)) {
            text.push(' ');
        }
        text.push_str(token.text);
        last = Some(token);
    }
    text
}

/// Tokens in pieces between which a line can end where not more than so many parentheses are open, or does for a
/// comment.
fn pieces<'i, 't>(tokens: &'i [Token<'t>], nested: usize) -> Vec<&'i [Token<'t>]> {
    let (mut pieces, mut start, mut open) = (Vec::new(), 0, 0_usize);
    for (index, pair) in tokens.windows(2).enumerate() {
        let [last, token] = pair else { continue };
        match last.rule {
            Rule::open_paren | Rule::open_index => open += 1,
            Rule::close_paren | Rule::close_index => open = open.saturating_sub(1),
            _ => {}
        }
        let is_noted = last.after.is_some() || !token.before.is_empty();
        if is_noted || open <= nested && can_begin_line(last, token) {
            pieces.push(&tokens[start..=index]);
            start = index + 1;
        }
    }
    pieces.push(&tokens[start..]);
    pieces
}

fn can_begin_line(last: &Token<'_>, token: &Token<'_>) -> bool {
    let joins = token.rule == Rule::infix && ["and", "or"].contains(&token.text);
    let is_clause = matches!(
        token.rule,
        Rule::arrow
            | Rule::fat_arrow
            | Rule::kw_fails
            | Rule::kw_noise
            | Rule::kw_requires
            | Rule::kw_else
            | Rule::kw_extends
            | Rule::kw_using
            | Rule::kw_within
            | Rule::connective
    );
    last.rule == Rule::comma || joins || is_clause
}
