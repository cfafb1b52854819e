//! What every part of the tree builder needs: spans, names, numbers, units, doc comments.
//!
//! A builder function answers `None` where the tree of the grammar has another shape than it takes, which would be a
//! fault of the compiler; it is reported once, as such, by [`Tree::build`].

use super::grammar::{Pair, Parts, Rule};
use super::scan::Scan;
use super::{KEYWORDS, message};
use crate::base::{FileId, Span};
use crate::diag::{Diagnostic, rules};
use crate::syntax::ast;

/// Builds nodes from what the grammar matched, and collects what is wrong.
pub struct Tree<'a> {
    pub file: FileId,
    pub text: &'a str,
    pub scan: &'a Scan,
    /// Where the piece that is being built starts in the file.
    pub base: usize,
    pub diagnostics: Vec<Diagnostic>,
}

impl Tree<'_> {
    /// Builds a node, and reports a fault of the compiler where that fails.
    pub fn build<'i, T>(&mut self, pair: Pair<'i>, make: fn(&mut Self, Pair<'i>) -> Option<T>) -> Option<T> {
        let span = self.span(&pair);
        let node = make(self, pair);
        if node.is_none() {
            let message = "the compiler cannot build the syntax tree of this text";
            self.diagnostics.push(Diagnostic::new(&rules::INTERNAL, span, message));
        }
        node
    }

    pub fn span(&self, pair: &Pair<'_>) -> Span {
        self.place(pair.start() + self.base, pair.end() + self.base)
    }

    pub fn place(&self, start: usize, end: usize) -> Span {
        Span::new(self.file, start as u32, end as u32)
    }

    /// The `///` lines that end in front of a place.
    pub fn doc(&self, before: Span) -> Option<ast::Doc> {
        let block = self.scan.doc_before(before.start)?;
        let lines = block.iter().map(|line| self.text.get(line.clone()).unwrap_or("")).collect::<Vec<_>>();
        let strip = |line: &&str| {
            let text = line.trim_start_matches('/');
            text.strip_prefix(' ').unwrap_or(text).trim_end().to_owned()
        };
        let span = self.place(block.first()?.start, block.last()?.end);
        Some(ast::Doc { lines: lines.iter().map(strip).collect(), span })
    }

    /// A word where any will do.
    pub fn word(&self, pair: &Pair<'_>) -> ast::Name {
        ast::Name { text: pair.as_str().to_owned(), span: self.span(pair) }
    }

    /// A word that must not be a keyword.
    pub fn name(&mut self, pair: &Pair<'_>) -> ast::Name {
        let name = self.word(pair);
        if KEYWORDS.binary_search(&pair.as_str()).is_ok() {
            self.diagnostics.push(message::keyword_as_name(name.span, pair.as_str()));
        }
        name
    }

    pub fn next_name(&mut self, parts: &mut Parts<'_>) -> Option<ast::Name> {
        parts.take(Rule::name).map(|pair| self.name(&pair))
    }

    /// The name in a clause like `on j5` or `else stop`.
    pub fn clause_name(&mut self, clause: Pair<'_>) -> Option<ast::Name> {
        self.next_name(&mut Parts::of(clause))
    }

    pub fn names(&mut self, pair: Pair<'_>) -> Vec<ast::Name> {
        Parts::of(pair).take_all(Rule::name).map(|pair| self.name(&pair)).collect()
    }

    /// In front of a dot no word is reserved, and `goal` and `robot` may be read like sensors.
    pub fn path(&mut self, pair: Pair<'_>) -> ast::Path {
        let span = self.span(&pair);
        let words = pair.into_inner().filter(|part| part.as_rule() != Rule::dot);
        let segments = words.map(|word| self.word(&word)).collect::<Vec<_>>();
        if let ([only], Some(word)) = (&*segments, pair.into_inner().next())
            && !matches!(&*only.text, "goal" | "robot")
        {
            self.name(&word);
        }
        ast::Path { segments, span }
    }

    pub fn number(&self, pair: &Pair<'_>) -> ast::Number {
        ast::Number { text: pair.as_str().to_owned(), span: self.span(pair) }
    }

    pub fn unit(&mut self, pair: Pair<'_>) -> Option<ast::Unit> {
        let span = self.span(&pair);
        let mut factors = Vec::new();
        let mut sign = 1;
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::unit_over => sign = -1,
                Rule::unit_times => sign = 1,
                _ => factors.push(self.unit_factor(part, sign)?),
            }
        }
        Some(ast::Unit { factors, span })
    }

    fn unit_factor(&mut self, pair: Pair<'_>, sign: i32) -> Option<ast::UnitFactor> {
        let mut parts = Parts::of(pair);
        let name = self.word(&parts.next()?);
        // A power past `i32` is past every dimension too, which is where it is reported.
        let power = parts.take(Rule::unit_power).map_or(1, |power| power.as_str().parse().unwrap_or(i32::MAX));
        Some(ast::UnitFactor { name, power: sign * power })
    }

    pub fn quantity(&mut self, pair: Pair<'_>) -> Option<ast::Quantity> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let number = self.number(&parts.take(Rule::number)?);
        let unit = match parts.take(Rule::unit) {
            Some(unit) => Some(self.unit(unit)?),
            None => None,
        };
        Some(ast::Quantity { number, unit, span })
    }

    pub fn next_quantity(&mut self, parts: &mut Parts<'_>) -> Option<ast::Quantity> {
        self.quantity(parts.take(Rule::quantity)?)
    }

    /// The quantity in a clause like `noise 0.05` or `hold 200 ms`.
    pub fn clause_quantity(&mut self, clause: Pair<'_>) -> Option<ast::Quantity> {
        self.next_quantity(&mut Parts::of(clause))
    }

    /// The quantity in a clause that may be left out.
    #[expect(clippy::option_option, reason = "a clause may be left out, and a tree may be broken")]
    pub fn optional_quantity(&mut self, parts: &mut Parts<'_>, clause: Rule) -> Option<Option<ast::Quantity>> {
        parts.take(clause).map_or(Some(None), |clause| self.clause_quantity(clause).map(Some))
    }

    pub fn quantities(&mut self, pair: Pair<'_>) -> Option<Vec<ast::Quantity>> {
        Parts::of(pair).take_all(Rule::quantity).map(|pair| self.quantity(pair)).collect()
    }

    pub fn pair_of_quantities(&mut self, pair: Pair<'_>) -> Option<(ast::Quantity, ast::Quantity)> {
        let mut parts = Parts::of(pair);
        Some((self.next_quantity(&mut parts)?, self.next_quantity(&mut parts)?))
    }

    pub fn range(&mut self, pair: Pair<'_>) -> Option<ast::Range> {
        let span = self.span(&pair);
        let (low, high) = self.pair_of_quantities(pair)?;
        Some(ast::Range { low, high, span })
    }

    /// The range in a clause that may be left out, `in -4 .. 4` or `within 4 s .. 6 s`.
    #[expect(clippy::option_option, reason = "a clause may be left out, and a tree may be broken")]
    pub fn optional_range(&mut self, parts: &mut Parts<'_>, clause: Rule) -> Option<Option<ast::Range>> {
        let Some(clause) = parts.take(clause) else { return Some(None) };
        self.range(Parts::of(clause).take(Rule::range)?).map(Some)
    }

    pub fn fail_readings(&mut self, clause: Pair<'_>) -> Option<Vec<ast::FailReading>> {
        Parts::of(clause).take_all(Rule::fail_reading).map(|reading| self.fail_reading(reading)).collect()
    }

    pub fn fail_reading(&mut self, pair: Pair<'_>) -> Option<ast::FailReading> {
        let span = self.span(&pair);
        let reading = match pair.as_str() {
            "any" => ast::FailReading::Any(span),
            "absent" => ast::FailReading::Absent(span),
            "set" => ast::FailReading::Set(span),
            "clear" => ast::FailReading::Clear(span),
            _ => ast::FailReading::Value(self.clause_quantity(pair)?),
        };
        Some(reading)
    }

    pub fn row(&mut self, pair: Pair<'_>) -> Option<ast::Row> {
        let span = self.span(&pair);
        let cells = Parts::of(pair).take_all(Rule::cell).map(|cell| self.cell(cell)).collect::<Option<_>>()?;
        Some(ast::Row { cells, span })
    }

    fn cell(&mut self, pair: Pair<'_>) -> Option<ast::Cell> {
        let span = self.span(&pair);
        let part = pair.into_inner().next()?;
        let kind = match part.as_rule() {
            Rule::minus => ast::CellKind::Omitted,
            Rule::wildcard => ast::CellKind::Any,
            Rule::cell_set => ast::CellKind::AnyOf(self.names(Parts::of(part).take(Rule::names)?)),
            _ => ast::CellKind::Term(self.name(&part)),
        };
        Some(ast::Cell { kind, span })
    }

    /// Keeps something that may be said once, and reports it where it is said again.
    pub fn once<T>(&mut self, kept: &mut Option<T>, value: T, place: Span, what: &str) {
        if kept.is_some() {
            self.diagnostics.push(Diagnostic::new(&rules::TWICE, place, format!("`{what}` is said twice")));
        } else {
            *kept = Some(value);
        }
    }
}
