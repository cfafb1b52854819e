//! What each word is, for coloring: by what it means, where that is known.

use lsp_types::{SemanticToken, SemanticTokenModifier, SemanticTokenType, SemanticTokensLegend};

use super::known::Known;
use super::names::Entity;
use crate::base::{FileId, Span, find_unit};
use crate::sema;
use crate::syntax::{KEYWORDS, TokenKind, tokens};

/// The kinds of words, by the protocol's names.
const TYPES: [SemanticTokenType; 13] = [
    SemanticTokenType::COMMENT,
    SemanticTokenType::KEYWORD,
    SemanticTokenType::NUMBER,
    SemanticTokenType::FUNCTION,
    SemanticTokenType::TYPE,
    SemanticTokenType::ENUM_MEMBER,
    SemanticTokenType::NAMESPACE,
    SemanticTokenType::PARAMETER,
    SemanticTokenType::EVENT,
    SemanticTokenType::PROPERTY,
    SemanticTokenType::CLASS,
    SemanticTokenType::METHOD,
    SemanticTokenType::VARIABLE,
];

/// The kinds of words that are told apart.
pub(super) fn legend() -> SemanticTokensLegend {
    SemanticTokensLegend { token_types: TYPES.to_vec(), token_modifiers: vec![SemanticTokenModifier::DECLARATION] }
}

/// The words of a file, each relative to the one before it, as the protocol has it.
pub(super) fn colors(known: &Known, file: FileId) -> Vec<SemanticToken> {
    let text = known.text(file);
    let mut colored = Vec::new();
    let mut end = 0;
    for token in tokens(text) {
        let (start, next) = (token.start as usize, token.end as usize);
        comments(text, end..start, &mut colored);
        end = next;
        let word = text.get(start..next).unwrap_or("");
        let name = Span::new(file, token.start, token.end);
        let kind = match (token.kind, known.entity(name)) {
            (TokenKind::Number, _) => Some(SemanticTokenType::NUMBER),
            (TokenKind::Word, Some(entity)) => Some(of_entity(entity)),
            // What belongs to a path, `goal.distance`, is no keyword, whatever else it may be.
            (TokenKind::Word, None) if in_path(text, start..next) => None,
            (TokenKind::Word, None) => of_word(word, text.get(next..).is_some_and(|rest| rest.starts_with('('))),
            _ => None,
        };
        colored.extend(kind.map(|kind| (start..next, kind, known.declared().contains_key(&name))));
    }
    comments(text, end..text.len(), &mut colored);
    relative(known, file, colored)
}

type Colored = (std::ops::Range<usize>, SemanticTokenType, bool);

/// The comments between two tokens.
fn comments(text: &str, gap: std::ops::Range<usize>, colored: &mut Vec<Colored>) {
    let mut start = gap.start;
    for line in text.get(gap).unwrap_or("").split_inclusive(['\n', '\r']) {
        if let Some(at) = line.find("//") {
            colored.push((start + at..start + line.trim_end().len(), SemanticTokenType::COMMENT, false));
        }
        start += line.len();
    }
}

/// Whether a word has a dot beside it, and not two, as in a range.
fn in_path(text: &str, word: std::ops::Range<usize>) -> bool {
    let (before, behind) = (text.get(..word.start).unwrap_or(""), text.get(word.end..).unwrap_or(""));
    before.ends_with('.') && !before.ends_with("..") || behind.starts_with('.') && !behind.starts_with("..")
}

fn of_word(word: &str, is_called: bool) -> Option<SemanticTokenType> {
    if KEYWORDS.binary_search(&word).is_ok() {
        return Some(SemanticTokenType::KEYWORD);
    }
    let is_function =
        sema::shapes().any(|(name, _)| name == word) || sema::FUNCTIONS.iter().any(|(name, _)| *name == word);
    match (is_function, find_unit(word)) {
        (true, _) => Some(SemanticTokenType::FUNCTION),
        (false, Some(_)) if !is_called => Some(SemanticTokenType::NUMBER),
        (false, _) => None,
    }
}

fn of_entity(entity: Entity) -> SemanticTokenType {
    match entity {
        Entity::Variable(_) => SemanticTokenType::TYPE,
        Entity::Term(..) | Entity::OutputTerm(..) | Entity::Mode(..) => SemanticTokenType::ENUM_MEMBER,
        Entity::Network(_) | Entity::Sense(..) => SemanticTokenType::NAMESPACE,
        Entity::Input(..) | Entity::Parameter(..) => SemanticTokenType::PARAMETER,
        Entity::Event(..) => SemanticTokenType::EVENT,
        Entity::Output(..) | Entity::Sensor(_) => SemanticTokenType::PROPERTY,
        Entity::Interface(_) | Entity::Robot(_) | Entity::Diagram(_) | Entity::World(_) | Entity::Scenario(_) => {
            SemanticTokenType::CLASS
        }
        Entity::Action(_) => SemanticTokenType::METHOD,
        Entity::Flag(..) | Entity::Property(_) => SemanticTokenType::VARIABLE,
    }
}

fn relative(known: &Known, file: FileId, colored: Vec<Colored>) -> Vec<SemanticToken> {
    let mut before = lsp_types::Position::default();
    let token = |(bytes, kind, is_declared): Colored| {
        let range = known.range_of(file, bytes);
        let delta_line = range.start.line - before.line;
        let delta_start =
            if delta_line == 0 { range.start.character - before.character } else { range.start.character };
        before = range.start;
        SemanticToken {
            delta_line,
            delta_start,
            length: range.end.character.saturating_sub(range.start.character),
            token_type: TYPES.iter().position(|known| *known == kind).unwrap_or(0) as u32,
            token_modifiers_bitset: u32::from(is_declared),
        }
    };
    colored.into_iter().map(token).collect()
}
