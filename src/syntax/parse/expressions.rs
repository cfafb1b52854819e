//! Conditions, values and commands. The grammar keeps chains flat; precedence is made here.

use super::grammar::{Pair, Parts, Rule};
use super::tree::Tree;
use crate::syntax::ast::{Argument, Call, CompareOp, Expr, ExprKind, Factor, IndexRange, Sign};

impl Tree<'_> {
    /// `a and b or c`: `or` binds weakest.
    pub fn expression(&mut self, pair: Pair<'_>) -> Option<Expr> {
        let mut alternatives = Vec::new();
        let mut all = Vec::new();
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::kw_or => alternatives.push(join(std::mem::take(&mut all), ExprKind::And)?),
                Rule::kw_and => {}
                _ => all.push(self.condition(part)?),
            }
        }
        alternatives.push(join(all, ExprKind::And)?);
        join(alternatives, ExprKind::Or)
    }

    /// `not x is t`: `not` binds weaker than a comparison.
    fn condition(&mut self, pair: Pair<'_>) -> Option<Expr> {
        let mut negations = Vec::new();
        let mut parts = pair.into_inner();
        let mut part = parts.next()?;
        while part.as_rule() == Rule::kw_not {
            negations.push(self.span(&part));
            part = parts.next()?;
        }
        let left = self.sum(part)?;
        let mut expression = match parts.next() {
            Some(test) => self.test(left, test)?,
            None => left,
        };
        for negation in negations.into_iter().rev() {
            let span = negation.to(expression.span);
            expression = Expr { kind: ExprKind::Not(Box::new(expression)), span };
        }
        Some(expression)
    }

    fn test(&mut self, left: Expr, pair: Pair<'_>) -> Option<Expr> {
        let span = left.span.to(self.span(&pair));
        if pair.as_rule() == Rule::is_test {
            let term = Parts::of(pair).next()?;
            let terms = match term.as_rule() {
                Rule::any_of => self.names(Parts::of(term).take(Rule::names)?),
                _ => vec![self.name(&term)],
            };
            return Some(Expr { kind: ExprKind::Is(Box::new(left), terms), span });
        }
        let mut parts = pair.into_inner();
        let operator = comparison(parts.next()?.as_rule())?;
        let right = self.sum(parts.next()?)?;
        Some(Expr { kind: ExprKind::Compare(operator, Box::new(left), Box::new(right)), span })
    }

    /// `a * b + c`: products bind stronger than sums.
    pub fn sum(&mut self, pair: Pair<'_>) -> Option<Expr> {
        let mut terms = Vec::new();
        let mut sign = Sign::Plus;
        let mut factors = Vec::new();
        let mut side = Factor::Times;
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::times => side = Factor::Times,
                Rule::over => side = Factor::Over,
                operator @ (Rule::plus | Rule::minus) => {
                    terms.push((sign, chain(std::mem::take(&mut factors), ExprKind::Product)?));
                    sign = if operator == Rule::plus { Sign::Plus } else { Sign::Minus };
                    side = Factor::Times;
                }
                _ => factors.push((side, self.operand(part)?)),
            }
        }
        terms.push((sign, chain(factors, ExprKind::Product)?));
        chain(terms, ExprKind::Sum)
    }

    fn operand(&mut self, pair: Pair<'_>) -> Option<Expr> {
        let mut negations = Vec::new();
        let mut parts = pair.into_inner();
        let mut part = parts.next()?;
        while part.as_rule() == Rule::negate {
            negations.push(self.span(&part));
            part = parts.next()?;
        }
        let mut expression = self.primary(part)?;
        for negation in negations.into_iter().rev() {
            let span = negation.to(expression.span);
            expression = Expr { kind: ExprKind::Negate(Box::new(expression)), span };
        }
        Some(expression)
    }

    fn primary(&mut self, pair: Pair<'_>) -> Option<Expr> {
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
        Parts::of(pair).take_all(Rule::argument).map(|argument| self.argument(argument)).collect()
    }

    fn argument(&mut self, pair: Pair<'_>) -> Option<Argument> {
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts);
        Some(Argument { name, value: self.expression(parts.take(Rule::expression)?)? })
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

fn comparison(rule: Rule) -> Option<CompareOp> {
    let operator = match rule {
        Rule::less => CompareOp::Less,
        Rule::less_equal => CompareOp::LessOrEqual,
        Rule::more => CompareOp::Greater,
        Rule::more_equal => CompareOp::GreaterOrEqual,
        Rule::double_equal => CompareOp::Equal,
        Rule::not_equal => CompareOp::NotEqual,
        _ => return None,
    };
    Some(operator)
}
