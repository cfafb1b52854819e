//! Parsing a piece at a time: a whole declaration if it is sound; else its head and its members, each for itself, so
//! that one fault costs one member.

use std::ops::Range;

use super::fusion::side_kind;
use super::grammar::{Error, Pair, Rule};
use super::layout::Layout;
use super::memo::Memo;
use super::pieces::Block;
use super::tree::Tree;
use super::{depth, message};
use crate::base::Span;
use crate::syntax::ast::{
    ArbiterItem, DiagramItem, EventRule, EventSide, Item, ModeItem, NetworkItem, OutputBody, RobotItem, ScenarioItem,
    TeamItem, Term, WorldItem,
};

type Piece = Range<usize>;
type Make<'a, T> = for<'t, 'i> fn(&'t mut Tree<'a>, Pair<'i>) -> Option<T>;

/// A piece of more tokens than this is tried a member at a time first: the parser's memory grows with what it parses
/// at once, and that costs more than cutting.
const LARGE: usize = 2000;

/// Parses the pieces of one file.
pub struct Recovery<'a> {
    pub tree: Tree<'a>,
    pub layout: &'a Layout<'a>,
    pub memo: &'a mut Memo,
}

/// Why a piece could not be parsed as a whole.
enum Failure {
    /// The grammar does not take it.
    Syntax(Box<Error>),
    /// Nesting goes too deep at this token.
    Deep(usize),
    /// It holds a brace without its other half, or a fault of the compiler; either was reported.
    Reported,
}

impl<'a> Recovery<'a> {
    /// The declaration in a piece of the file.
    pub fn declaration(&mut self, piece: &Piece) -> Item {
        let item = self.whole_or_inside(Rule::only_declaration, piece, Tree::declaration, Self::declaration_in_pieces);
        item.unwrap_or_else(|| Item::Error(self.span(piece)))
    }

    /// Parses a piece as a whole, else what is sound inside it; the other way round where it is large.
    fn whole_or_inside<T>(
        &mut self,
        rule: Rule,
        piece: &Piece,
        make: Make<'a, T>,
        inside: fn(&mut Self, &Piece) -> Option<T>,
    ) -> Option<T> {
        let before = self.tree.diagnostics.len();
        if piece.len() <= LARGE {
            return match self.attempt(rule, piece, make) {
                Ok(node) => Some(node),
                Err(failure) => {
                    let node = inside(self, piece);
                    self.report_unless(before, failure, piece);
                    node
                }
            };
        }
        let node = inside(self, piece);
        if node.is_some() && self.tree.diagnostics.len() == before && !self.layout.has_fault(piece) {
            return node;
        }
        let findings = self.tree.diagnostics.split_off(before);
        match self.attempt(rule, piece, make) {
            Ok(node) => Some(node),
            Err(failure) => {
                self.tree.diagnostics.extend(findings);
                self.report_unless(before, failure, piece);
                node
            }
        }
    }

    /// Reports a failure unless something inside the piece was reported already.
    fn report_unless(&mut self, before: usize, failure: Failure, piece: &Piece) {
        if self.tree.diagnostics.len() == before {
            self.report(failure, piece);
        }
    }

    /// Parses a piece that has no members of its own.
    fn piece<T>(&mut self, rule: Rule, piece: &Piece, make: Make<'a, T>) -> Option<T> {
        self.whole_or_inside(rule, piece, make, |_, _| None)
    }

    fn attempt<T>(&mut self, rule: Rule, piece: &Piece, make: Make<'a, T>) -> Result<T, Failure> {
        if self.layout.has_fault(piece) {
            return Err(Failure::Reported);
        }
        if let Some(token) = depth::first_too_deep(self.layout, piece) {
            return Err(Failure::Deep(token));
        }
        let span = self.span(piece);
        let text = self.layout.text.get(span.range()).unwrap_or("");
        let matched = self.memo.run(rule, text);
        let matched = matched.as_ref().as_ref().map_err(|error| Failure::Syntax(error.clone()))?;
        self.tree.base = span.start as usize;
        let node = matched.root(text).and_then(|pair| self.tree.build(pair, make));
        node.ok_or(Failure::Reported)
    }

    fn report(&mut self, failure: Failure, piece: &Piece) {
        let diagnostic = match failure {
            Failure::Syntax(error) => message::syntax_error(self.layout, self.tree.file, piece, &error),
            Failure::Deep(token) => Some(message::too_deep(self.layout, self.tree.file, token)),
            Failure::Reported => None,
        };
        self.tree.diagnostics.extend(diagnostic);
    }

    fn span(&self, piece: &Piece) -> Span {
        let token = |index: usize| self.layout.tokens.get(index);
        let start = token(piece.start).map_or(self.layout.text.len(), |token| token.start as usize);
        let end = token(piece.end.wrapping_sub(1)).map_or(start, |token| token.end as usize);
        self.tree.place(start, end.max(start))
    }

    fn declaration_in_pieces(&mut self, piece: &Piece) -> Option<Item> {
        let open = self.layout.block_of(piece)?;
        let head = piece.start..open;
        let span = self.span(piece);
        let item = match self.layout.word(piece.start) {
            "variable" => {
                let mut node = self.piece(Rule::only_variable_head, &head, Tree::variable_head)?;
                node.terms = self.terms(open);
                node.span = span;
                Item::Variable(node)
            }
            "network" => {
                let mut node = self.piece(Rule::only_network_head, &head, Tree::network_head)?;
                node.items = self.members(Block::Network, open, Self::network_item);
                node.span = span;
                Item::Network(node)
            }
            "interface" => {
                let mut node = self.piece(Rule::only_interface_head, &head, Tree::interface_head)?;
                node.items = self.members(Block::Robot, open, Self::robot_item);
                node.span = span;
                Item::Interface(node)
            }
            "robot" => {
                let mut node = self.piece(Rule::only_robot_head, &head, Tree::robot_head)?;
                node.items = self.members(Block::Robot, open, Self::robot_item);
                node.span = span;
                Item::Robot(node)
            }
            "behavior" | "activity" | "goal" => {
                let mut node = self.piece(Rule::only_diagram_head, &head, Tree::diagram_head)?;
                node.items = self.members(Block::Diagram, open, Self::diagram_item);
                node.span = span;
                Item::Diagram(node)
            }
            "arbiter" => {
                let mut node = self.piece(Rule::only_arbiter_head, &head, Tree::arbiter_head)?;
                node.items = self.members(Block::Arbiter, open, Self::arbiter_item);
                node.span = span;
                Item::Arbiter(node)
            }
            "team" => {
                let mut node = self.piece(Rule::only_team_head, &head, Tree::team_head)?;
                node.items = self.members(Block::Team, open, Self::team_item);
                node.span = span;
                Item::Team(node)
            }
            "world" => {
                let mut node = self.piece(Rule::only_world_head, &head, Tree::world_head)?;
                node.items = self.members(Block::World, open, Self::world_item);
                node.span = span;
                Item::World(node)
            }
            "scenario" => {
                let mut node = self.piece(Rule::only_scenario_head, &head, Tree::scenario_head)?;
                node.items = self.members(Block::Scenario, open, Self::scenario_item);
                node.span = span;
                Item::Scenario(node)
            }
            _ => return None,
        };
        Some(item)
    }

    fn members<T>(&mut self, block: Block, open: usize, parse: fn(&mut Self, &Piece) -> T) -> Vec<T> {
        self.layout.members(block, open).iter().map(|piece| parse(self, piece)).collect()
    }

    fn terms(&mut self, open: usize) -> Vec<Term> {
        let parse = |this: &mut Self, piece: &Piece| this.piece(Rule::only_term, piece, Tree::term);
        self.members(Block::Terms, open, parse).into_iter().flatten().collect()
    }

    fn network_item(&mut self, piece: &Piece) -> NetworkItem {
        let rule = Rule::only_network_item;
        let item = self.whole_or_inside(rule, piece, Tree::network_item, Self::network_item_in_pieces);
        item.unwrap_or_else(|| NetworkItem::Error(self.span(piece)))
    }

    fn network_item_in_pieces(&mut self, piece: &Piece) -> Option<NetworkItem> {
        let open = self.layout.block_of(piece)?;
        let head = piece.start..open;
        match self.layout.word(piece.start) {
            "event" => {
                let mut event = self.piece(Rule::only_event_head, &head, Tree::event_head)?;
                event.sides = self.event_sides(open);
                event.span = self.span(piece);
                Some(NetworkItem::Event(event))
            }
            "output" => {
                let mut output = self.piece(Rule::only_output_head, &head, Tree::output_head)?;
                output.body = OutputBody::Terms(self.terms(open));
                output.span = self.span(piece);
                Some(NetworkItem::Output(output))
            }
            _ => None,
        }
    }

    fn event_sides(&mut self, open: usize) -> Vec<EventSide> {
        let mut sides: Vec<EventSide> = Vec::new();
        let mut is_reported = false;
        for mut piece in self.layout.members(Block::Event, open) {
            let word = self.layout.word(piece.start);
            if matches!(word, "contributor" | "detractor") {
                let keyword = self.span(&(piece.start..piece.start + 1));
                sides.push(EventSide { kind: side_kind(word), keyword, rules: Vec::new() });
                piece.start += 1;
            }
            if piece.is_empty() {
                continue;
            }
            if let Some(side) = sides.last_mut() {
                side.rules.extend(self.event_rule(&piece));
            } else if !std::mem::replace(&mut is_reported, true) {
                let expected = "`contributor` or `detractor`";
                let diagnostic = message::expected(self.layout, self.tree.file, piece.start, expected);
                self.tree.diagnostics.push(diagnostic);
            }
        }
        sides
    }

    fn event_rule(&mut self, piece: &Piece) -> Option<EventRule> {
        self.piece(Rule::only_event_rule, piece, Tree::event_rule)
    }

    fn robot_item(&mut self, piece: &Piece) -> RobotItem {
        let item = self.piece(Rule::only_robot_item, piece, Tree::robot_item);
        item.unwrap_or_else(|| RobotItem::Error(self.span(piece)))
    }

    fn diagram_item(&mut self, piece: &Piece) -> DiagramItem {
        let rule = Rule::only_diagram_item;
        let item = self.whole_or_inside(rule, piece, Tree::diagram_item, Self::mode_in_pieces);
        item.unwrap_or_else(|| DiagramItem::Error(self.span(piece)))
    }

    fn mode_in_pieces(&mut self, piece: &Piece) -> Option<DiagramItem> {
        if !matches!(self.layout.word(piece.start), "mode" | "final") {
            return None;
        }
        let open = self.layout.block_of(piece)?;
        let mut mode = self.piece(Rule::only_mode_head, &(piece.start..open), Tree::mode_head)?;
        mode.items = self.members(Block::Mode, open, Self::mode_item);
        mode.span = self.span(piece);
        Some(DiagramItem::Mode(mode))
    }

    fn mode_item(&mut self, piece: &Piece) -> ModeItem {
        let item = self.whole_or_inside(Rule::only_mode_item, piece, Tree::mode_item, Self::mode_item_in_pieces);
        item.unwrap_or_else(|| ModeItem::Error(self.span(piece)))
    }

    fn mode_item_in_pieces(&mut self, piece: &Piece) -> Option<ModeItem> {
        let open = self.layout.block_of(piece)?;
        if self.layout.word(piece.start) == "decide" {
            let mut decide = self.piece(Rule::only_decide_head, &(piece.start..open), Tree::decide_head)?;
            let parse = |this: &mut Self, piece: &Piece| this.piece(Rule::only_decide_row, piece, Tree::decide_row);
            decide.rows = self.members(Block::Decide, open, parse).into_iter().flatten().collect();
            decide.span = self.span(piece);
            return Some(ModeItem::Decide(decide));
        }
        if self.layout.word(piece.start) != "on" || open != piece.start + 2 {
            return None;
        }
        let commands = |this: &mut Self| {
            let parse = |this: &mut Self, piece: &Piece| this.piece(Rule::only_call, piece, Tree::call);
            this.members(Block::Commands, open, parse).into_iter().flatten().collect()
        };
        match self.layout.word(piece.start + 1) {
            "enter" => Some(ModeItem::OnEnter(commands(self), self.span(piece))),
            "exit" => Some(ModeItem::OnExit(commands(self), self.span(piece))),
            _ => None,
        }
    }

    fn arbiter_item(&mut self, piece: &Piece) -> ArbiterItem {
        let item = self.piece(Rule::only_arbiter_item, piece, Tree::arbiter_item);
        item.unwrap_or_else(|| ArbiterItem::Error(self.span(piece)))
    }

    fn team_item(&mut self, piece: &Piece) -> TeamItem {
        let item = self.piece(Rule::only_team_item, piece, Tree::team_item);
        item.unwrap_or_else(|| TeamItem::Error(self.span(piece)))
    }

    fn world_item(&mut self, piece: &Piece) -> WorldItem {
        let item = self.piece(Rule::only_world_item, piece, Tree::world_item);
        item.unwrap_or_else(|| WorldItem::Error(self.span(piece)))
    }

    fn scenario_item(&mut self, piece: &Piece) -> ScenarioItem {
        let item = self.piece(Rule::only_scenario_item, piece, Tree::scenario_item);
        item.unwrap_or_else(|| ScenarioItem::Error(self.span(piece)))
    }
}
