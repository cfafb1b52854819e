//! Mode switching diagrams, arbiters and teams.

use super::grammar::{Pair, Parts, Rule};
use super::tree::Tree;
use crate::diag::{Diagnostic, rules};
use crate::syntax::ast::{
    Arbiter, ArbiterItem, Call, Child, Client, ClientPriority, Decide, DecideRow, Diagram, DiagramItem, Expr, ExprKind,
    Flag, Layer, Mode, ModeItem, Name, Path, Sense, Target, Team, TeamItem, Transition,
};

impl Tree<'_> {
    pub fn diagram(&mut self, pair: Pair<'_>) -> Option<Diagram> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.diagram_head(parts.take(Rule::diagram_head)?)?;
        let items = parts.take_all(Rule::diagram_item).map(|item| self.diagram_item(item)).collect::<Option<_>>()?;
        Some(Diagram { items, span, ..head })
    }

    /// A diagram without its items.
    pub fn diagram_head(&mut self, pair: Pair<'_>) -> Option<Diagram> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let layer = match parts.take(Rule::layer)?.as_str() {
            "behavior" => Layer::Behavior,
            "activity" => Layer::Activity,
            _ => Layer::Goal,
        };
        let name = self.next_name(&mut parts)?;
        let (mut on, mut extends) = (None, None);
        while let Some(clause) = parts.next() {
            let place = self.span(&clause);
            let (slot, word) = match clause.as_rule() {
                Rule::on_clause => (&mut on, "on"),
                _ => (&mut extends, "extends"),
            };
            let name = self.clause_name(clause)?;
            self.once(slot, name, place, word);
        }
        Some(Diagram { doc: self.doc(span), layer, name, on, extends, items: Vec::new(), span })
    }

    pub fn diagram_item(&mut self, pair: Pair<'_>) -> Option<DiagramItem> {
        let item = Parts::of(pair).next()?;
        match item.as_rule() {
            Rule::sense => self.sense(item).map(DiagramItem::Sense),
            Rule::entry => {
                let span = self.span(&item);
                Some(DiagramItem::Entry { mode: self.clause_name(item)?, span })
            }
            Rule::flag => self.flag(item).map(DiagramItem::Flag),
            _ => self.mode(item).map(DiagramItem::Mode),
        }
    }

    pub fn sense(&mut self, pair: Pair<'_>) -> Option<Sense> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let alias = match parts.take(Rule::alias) {
            Some(alias) => Some(self.clause_name(alias)?),
            None => None,
        };
        let network = self.next_name(&mut parts)?;
        Some(Sense { alias, network, arguments: self.arguments(parts.take(Rule::arguments)?)?, span })
    }

    fn flag(&mut self, pair: Pair<'_>) -> Option<Flag> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        Some(Flag { doc: self.doc(span), name, condition: self.expression(parts.take(Rule::expression)?)?, span })
    }

    fn mode(&mut self, pair: Pair<'_>) -> Option<Mode> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.mode_head(parts.take(Rule::mode_head)?)?;
        let mut items = Vec::new();
        if let Some(block) = parts.take(Rule::mode_block) {
            for item in Parts::of(block).take_all(Rule::mode_item) {
                items.push(self.mode_item(item)?);
            }
        } else {
            self.require_block(&head);
        }
        Some(Mode { items, span, ..head })
    }

    /// Only a mode that runs a diagram can do without braces.
    fn require_block(&mut self, head: &Mode) {
        if head.child.is_none() {
            let end = self.place(head.span.end as usize, head.span.end as usize);
            let message = format!("expected `{{` or `= diagram` for mode `{}`", head.name.text);
            self.diagnostics.push(Diagnostic::new(&rules::SYNTAX_ERROR, end, message));
        }
    }

    /// A mode without its items.
    pub fn mode_head(&mut self, pair: Pair<'_>) -> Option<Mode> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let is_final = parts.take(Rule::is_final).map(|word| self.span(&word));
        let name = self.next_name(&mut parts)?;
        let (mut child, mut requires) = (None, None);
        while let Some(clause) = parts.next() {
            let place = self.span(&clause);
            if clause.as_rule() == Rule::child {
                let value = self.child(clause)?;
                self.once(&mut child, value, place, "=");
            } else {
                let value = self.requires(clause)?;
                self.once(&mut requires, value, place, "requires");
            }
        }
        let (requires, otherwise) = requires.unwrap_or_default();
        let items = Vec::new();
        Some(Mode { doc: self.doc(span), is_final, name, child, requires, otherwise, items, span })
    }

    fn child(&mut self, pair: Pair<'_>) -> Option<Child> {
        let mut parts = Parts::of(pair);
        let diagram = self.next_name(&mut parts)?;
        Some(Child { diagram, resume: parts.take(Rule::resume).map(|word| self.span(&word)) })
    }

    fn requires(&mut self, pair: Pair<'_>) -> Option<(Vec<Name>, Option<Name>)> {
        let mut parts = Parts::of(pair);
        let names = self.names(parts.take(Rule::names)?);
        let otherwise = match parts.take(Rule::otherwise) {
            Some(clause) => Some(self.clause_name(clause)?),
            None => None,
        };
        Some((names, otherwise))
    }

    pub fn mode_item(&mut self, pair: Pair<'_>) -> Option<ModeItem> {
        let item = Parts::of(pair).next()?;
        let span = self.span(&item);
        match item.as_rule() {
            Rule::call => self.call(item).map(ModeItem::Action),
            Rule::on_enter => Some(ModeItem::OnEnter(self.commands(item)?, span)),
            Rule::on_exit => Some(ModeItem::OnExit(self.commands(item)?, span)),
            Rule::decide => self.decide(item).map(ModeItem::Decide),
            _ => self.transition(item).map(ModeItem::Transition),
        }
    }

    fn commands(&mut self, pair: Pair<'_>) -> Option<Vec<Call>> {
        let mut parts = Parts::of(Parts::of(pair).take(Rule::commands)?);
        parts.take_all(Rule::call).map(|call| self.call(call)).collect()
    }

    fn transition(&mut self, pair: Pair<'_>) -> Option<Transition> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let priority = self.number(&parts.take(Rule::unsigned)?);
        let condition = self.expression(parts.take(Rule::expression)?)?;
        let target = Parts::of(parts.take(Rule::target)?).next()?;
        let target = match target.as_rule() {
            Rule::again => Target::Again(self.span(&target)),
            _ => Target::Mode(self.name(&target)),
        };
        Some(Transition { doc: self.doc(span), priority, condition, target, span })
    }

    fn decide(&mut self, pair: Pair<'_>) -> Option<Decide> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.decide_head(parts.take(Rule::decide_head)?)?;
        let rows = parts.take_all(Rule::decide_row).map(|row| self.decide_row(row)).collect::<Option<_>>()?;
        Some(Decide { rows, span, ..head })
    }

    /// A `decide` without its rows.
    pub fn decide_head(&mut self, pair: Pair<'_>) -> Option<Decide> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let subjects = parts.take_all(Rule::expression).map(|subject| self.expression(subject));
        Some(Decide { subjects: subjects.collect::<Option<_>>()?, rows: Vec::new(), span })
    }

    pub fn decide_row(&mut self, pair: Pair<'_>) -> Option<DecideRow> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let row = self.row(parts.take(Rule::row)?)?;
        let command = parts.next()?;
        let command = match command.as_rule() {
            Rule::nothing => self.nothing(&command),
            _ => self.expression(command)?,
        };
        Some(DecideRow { row, command, span })
    }

    fn nothing(&self, pair: &Pair<'_>) -> Expr {
        let span = self.span(pair);
        Expr { kind: ExprKind::Path(Path { segments: vec![self.word(pair)], span }), span }
    }

    pub fn arbiter(&mut self, pair: Pair<'_>) -> Option<Arbiter> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.arbiter_head(parts.take(Rule::arbiter_head)?)?;
        let items = parts.take_all(Rule::arbiter_item).map(|item| self.arbiter_item(item)).collect::<Option<_>>()?;
        Some(Arbiter { items, span, ..head })
    }

    /// An arbiter without its items.
    pub fn arbiter_head(&mut self, pair: Pair<'_>) -> Option<Arbiter> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        let on = match parts.take(Rule::on_clause) {
            Some(clause) => Some(self.clause_name(clause)?),
            None => None,
        };
        Some(Arbiter { doc: self.doc(span), name, on, items: Vec::new(), span })
    }

    pub fn arbiter_item(&mut self, pair: Pair<'_>) -> Option<ArbiterItem> {
        let item = Parts::of(pair).next()?;
        let span = self.span(&item);
        match item.as_rule() {
            Rule::emergency => {
                let mut parts = Parts::of(item);
                let condition = self.expression(parts.take(Rule::expression)?)?;
                Some(ArbiterItem::Emergency { condition, command: self.call(parts.take(Rule::call)?)?, span })
            }
            Rule::client => self.client(item).map(ArbiterItem::Client),
            _ => Some(ArbiterItem::Ties { order: self.clause_name(item)?, span }),
        }
    }

    fn client(&mut self, pair: Pair<'_>) -> Option<Client> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let name = self.next_name(&mut parts)?;
        let diagram = self.next_name(&mut parts)?;
        let priorities = parts.take_all(Rule::client_priority).map(|part| self.client_priority(part));
        let priorities = priorities.collect::<Option<_>>()?;
        Some(Client { doc: self.doc(span), name, diagram, priorities, span })
    }

    fn client_priority(&mut self, pair: Pair<'_>) -> Option<ClientPriority> {
        let mut parts = Parts::of(pair);
        let priority = self.number(&parts.take(Rule::unsigned)?);
        let when = match parts.take(Rule::expression) {
            Some(condition) => Some(self.expression(condition)?),
            None => None,
        };
        Some(ClientPriority { priority, when })
    }

    pub fn team(&mut self, pair: Pair<'_>) -> Option<Team> {
        let span = self.span(&pair);
        let mut parts = Parts::of(pair);
        let head = self.team_head(parts.take(Rule::team_head)?)?;
        let items = parts.take_all(Rule::team_item).map(|item| self.team_item(item)).collect::<Option<_>>()?;
        Some(Team { items, span, ..head })
    }

    /// A team without its items.
    pub fn team_head(&mut self, pair: Pair<'_>) -> Option<Team> {
        let span = self.span(&pair);
        Some(Team { doc: self.doc(span), name: self.clause_name(pair)?, items: Vec::new(), span })
    }

    pub fn team_item(&mut self, pair: Pair<'_>) -> Option<TeamItem> {
        let item = Parts::of(pair).next()?;
        let span = self.span(&item);
        let is_member = item.as_rule() == Rule::member;
        let mut parts = Parts::of(item);
        if is_member {
            let name = self.next_name(&mut parts)?;
            let robot = self.next_name(&mut parts)?;
            return Some(TeamItem::Member { name, robot, runs: self.next_name(&mut parts)?, span });
        }
        let flag = self.path(parts.take(Rule::path)?);
        Some(TeamItem::Link { flag, condition: self.expression(parts.take(Rule::expression)?)?, span })
    }
}
