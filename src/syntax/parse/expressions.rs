//! Conditions, values and commands. The grammar yields an expression as a flat list; precedence is made here, by a
//! [`Chain`] that closes products, sums, conditions and conjunctions as weaker operators arrive.

use super::grammar::{Pair, Parts, Rule};
use super::message;
use super::tree::Tree;
use crate::base::Span;
use crate::syntax::ast::{Argument, Call, CompareOp, Expr, ExprKind, Factor, IndexRange, Name, Sign};

/// What is open while a flat list is read from left to right, from weak to strong.
#[derive(Default)]
struct Chain {
    alternatives: Vec<Expr>,
    conjuncts: Vec<Expr>,
    negations: Vec<Span>,
    compared: Option<(Expr, Test)>,
    is_reported: bool,
    terms: Vec<(Sign, Expr)>,
    sign: Sign,
    factors: Vec<(Factor, Expr)>,
    side: Factor,
    minuses: Vec<Span>,
}

/// What a left side is held against.
enum Test {
    Compare(CompareOp),
    Is(Vec<Name>, Span),
}

impl Chain {
    /// Whether nothing but `not` stands in the condition that is open.
    fn is_fresh(&self) -> bool {
        self.compared.is_none() && self.terms.is_empty() && self.factors.is_empty() && self.minuses.is_empty()
    }

    fn operand(&mut self, operand: Expr) {
        let mut operand = operand;
        for minus in self.minuses.drain(..).rev() {
            let span = minus.to(operand.span);
            operand = Expr { kind: ExprKind::Negate(Box::new(operand)), span };
        }
        self.factors.push((self.side, operand));
    }

    fn close_product(&mut self) -> Option<()> {
        let product = chain(std::mem::take(&mut self.factors), ExprKind::Product)?;
        self.terms.push((self.sign, product));
        self.side = Factor::Times;
        Some(())
    }

    fn close_sum(&mut self) -> Option<Expr> {
        self.close_product()?;
        self.sign = Sign::Plus;
        chain(std::mem::take(&mut self.terms), ExprKind::Sum)
    }

    fn close_condition(&mut self) -> Option<()> {
        let mut condition = match self.compared.take() {
            None => self.close_sum()?,
            Some((left, Test::Is(terms, end))) => {
                let span = left.span.to(end);
                Expr { kind: ExprKind::Is(Box::new(left), terms), span }
            }
            Some((left, Test::Compare(operator))) => {
                let right = self.close_sum()?;
                let span = left.span.to(right.span);
                Expr { kind: ExprKind::Compare(operator, Box::new(left), Box::new(right)), span }
            }
        };
        for negation in self.negations.drain(..).rev() {
            let span = negation.to(condition.span);
            condition = Expr { kind: ExprKind::Not(Box::new(condition)), span };
        }
        self.conjuncts.push(condition);
        self.is_reported = false;
        Some(())
    }

    fn close_conjunction(&mut self) -> Option<()> {
        self.close_condition()?;
        self.alternatives.push(join(std::mem::take(&mut self.conjuncts), ExprKind::And)?);
        Some(())
    }
}

impl Tree<'_> {
    /// `a and b or c < d + e`. Linear, and without recursion but for parentheses.
    pub fn expression(&mut self, pair: Pair<'_>) -> Option<Expr> {
        // On the heap: this function recurses through parentheses, and a thread's stack may be small.
        let mut chain = Box::new(Chain::default());
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::prefix => self.prefix(&mut chain, &part),
                Rule::infix | Rule::operator => self.infix(&mut chain, &part)?,
                Rule::is_test => {
                    let span = self.span(&part);
                    let terms = self.is_test(part)?;
                    self.test(&mut chain, Test::Is(terms, span), span)?;
                }
                _ => self.operand(part).map(|operand| chain.operand(operand))?,
            }
        }
        chain.close_conjunction()?;
        join(chain.alternatives, ExprKind::Or)
    }

    fn prefix(&mut self, chain: &mut Chain, part: &Pair<'_>) {
        let span = self.span(part);
        if part.as_str() == "-" {
            chain.minuses.push(span);
            return;
        }
        if !chain.is_fresh() {
            self.diagnostics.push(message::not_inside_value(span));
        }
        chain.negations.push(span);
    }

    fn infix(&mut self, chain: &mut Chain, part: &Pair<'_>) -> Option<()> {
        if matches!(part.as_str(), "+" | "-" | "*" | "/") {
            self.no_value_after_test(chain, part);
        }
        match part.as_str() {
            "or" => chain.close_conjunction()?,
            "and" => chain.close_condition()?,
            "*" => chain.side = Factor::Times,
            "/" => chain.side = Factor::Over,
            "+" => {
                chain.close_product()?;
                chain.sign = Sign::Plus;
            }
            "-" => {
                chain.close_product()?;
                chain.sign = Sign::Minus;
            }
            operator => {
                let span = self.span(part);
                self.test(chain, Test::Compare(comparison(operator)?), span)?;
            }
        }
        Some(())
    }

    /// `x is t + 1` is reported, and read as if the test were not there.
    fn no_value_after_test(&mut self, chain: &mut Chain, operator: &Pair<'_>) {
        if matches!(chain.compared, Some((_, Test::Is(..))))
            && let Some((left, _)) = chain.compared.take()
        {
            self.diagnostics.push(message::value_after_test(self.span(operator), operator.as_str()));
            chain.operand(left);
        }
    }

    /// Begins a comparison. A second one in a row is reported, and takes the place of the first.
    fn test(&mut self, chain: &mut Chain, test: Test, place: Span) -> Option<()> {
        if chain.compared.is_some() && !std::mem::replace(&mut chain.is_reported, true) {
            self.diagnostics.push(message::chained_comparison(place));
        }
        let left = match chain.compared.take() {
            Some((left, Test::Is(..))) => left,
            _ => chain.close_sum()?,
        };
        chain.compared = Some((left, test));
        Some(())
    }

    fn is_test(&mut self, pair: Pair<'_>) -> Option<Vec<Name>> {
        let term = Parts::of(pair).next()?;
        let terms = match term.as_rule() {
            Rule::any_of => self.names(Parts::of(term).take(Rule::names)?),
            _ => vec![self.name(&term)],
        };
        Some(terms)
    }

    fn operand(&mut self, pair: Pair<'_>) -> Option<Expr> {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::group => self.expression(Parts::of(pair).take(Rule::expression)?)?.kind,
            Rule::after => ExprKind::After(self.clause_quantity(pair)?),
            Rule::done => ExprKind::Done,
            Rule::quantity => ExprKind::Quantity(self.quantity(pair)?),
            Rule::reference => return self.reference(pair),
            _ => return None,
        };
        Some(Expr { kind, span })
    }

    /// `a.b`, `a[3]`, `a(...)`
    fn reference(&mut self, pair: Pair<'_>) -> Option<Expr> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let path = self.path(parts.take(Rule::path)?);
        let kind = match parts.next() {
            None => ExprKind::Path(path),
            Some(tail) if tail.as_rule() == Rule::indices => ExprKind::Index(path, self.indices(tail)?),
            Some(tail) => ExprKind::Call(Call { path, arguments: self.arguments(tail)?, span }),
        };
        Some(Expr { kind, span })
    }

    /// `halt()`, `arc(26 cm/s, radius: 1 m)`
    pub fn call(&mut self, pair: Pair<'_>) -> Option<Call> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let path = self.path(parts.take(Rule::path)?);
        Some(Call { path, arguments: self.arguments(parts.take(Rule::arguments)?)?, span })
    }

    pub fn arguments(&mut self, pair: Pair<'_>) -> Option<Vec<Argument>> {
        let mut arguments = Vec::new();
        // A loop, not an iterator: it recurses, and adapters would take most of the stack.
        for argument in Parts::of(pair).take_all(Rule::argument) {
            let mut parts = Parts::of(argument);
            let name = self.next_name(&mut parts);
            arguments.push(Argument { name, value: self.expression(parts.take(Rule::expression)?)? });
        }
        Some(arguments)
    }

    pub fn indices(&mut self, pair: Pair<'_>) -> Option<Vec<IndexRange>> {
        let index = |pair| {
            let mut ends = Parts::of(pair);
            let first = self.number(&ends.take(Rule::unsigned)?);
            Some(IndexRange { first, last: ends.take(Rule::unsigned).map(|last| self.number(&last)) })
        };
        Parts::of(pair).take_all(Rule::index_range).map(index).collect()
    }
}

/// One part stays itself; several become a chain.
fn join(mut parts: Vec<Expr>, make: fn(Vec<Expr>) -> ExprKind) -> Option<Expr> {
    let last = parts.pop()?;
    let Some(first) = parts.first() else { return Some(last) };
    let span = first.span.to(last.span);
    parts.push(last);
    Some(Expr { kind: make(parts), span })
}

/// As [`join`], where every part has an operator in front.
fn chain<O>(mut parts: Vec<(O, Expr)>, make: fn(Vec<(O, Expr)>) -> ExprKind) -> Option<Expr> {
    let last = parts.pop()?;
    let Some((_, first)) = parts.first() else { return Some(last.1) };
    let span = first.span.to(last.1.span);
    parts.push(last);
    Some(Expr { kind: make(parts), span })
}

fn comparison(operator: &str) -> Option<CompareOp> {
    let operator = match operator {
        "<" => CompareOp::Less,
        "<=" => CompareOp::LessOrEqual,
        ">" => CompareOp::Greater,
        ">=" => CompareOp::GreaterOrEqual,
        "==" => CompareOp::Equal,
        "!=" => CompareOp::NotEqual,
        _ => return None,
    };
    Some(operator)
}
