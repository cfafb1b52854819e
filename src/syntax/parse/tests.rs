//! The grammar against the corpus of sound files, and the trees of constructs with a trap in them.

use std::collections::BTreeSet;

use super::grammar::{self, Rule};
use super::pieces::{Block, DECLARATIONS};
use super::{KEYWORDS, parse};
use crate::base::FileId;
use crate::diag::Diagnostic;
use crate::syntax::ast::{self, DiagramItem, Expr, ExprKind, File, FileKind, Item};

/// The files of the corpus that parse, with their names.
macro_rules! corpus {
    ($($name:literal)*) => {
        &[$(($name, include_str!(concat!("../../../tests/corpus/syntax/pass/", $name)))),*]
    };
}

const CORPUS: &[(&str, &str)] = corpus!(
    "arbiters.msd" "behaviors.msd" "line_endings.fsfn" "navigator.fsfn" "obstacle_id.fsfn" "old_line_endings.msd"
    "robots.msd" "trials.msd"
);

/// Rules that never yield a node: silent ones, and those that only look ahead.
fn is_silent(rule: Rule) -> bool {
    let name = format!("{rule:?}");
    name.starts_with("only_")
        || matches!(
            rule,
            Rule::WHITESPACE
                | Rule::comment
                | Rule::letter
                | Rule::word
                | Rule::joint
                | Rule::reserved
                | Rule::digits
                | Rule::unit_after
                | Rule::unit_stop
                | Rule::gap
                | Rule::follower
                | Rule::operand
        )
}

fn modes(text: &str) -> (File, Vec<Diagnostic>) {
    parse(FileId(0), FileKind::Modes, text)
}

/// The condition of `flag f = ...`.
fn condition(text: &str) -> Expr {
    let (file, diagnostics) = modes(&format!("behavior b on r {{ flag f = {text} }}"));
    assert!(diagnostics.is_empty(), "{text}: {diagnostics:?}");
    let Some(Item::Diagram(diagram)) = file.items.into_iter().next() else { panic!("no behavior") };
    match diagram.items.into_iter().next() {
        Some(DiagramItem::Flag(flag)) => flag.condition,
        other => panic!("no flag but {other:?}"),
    }
}

/// An expression in prefix form.
fn show(expression: &Expr) -> String {
    let all = |parts: &[Expr]| parts.iter().map(show).collect::<Vec<_>>().join(" ");
    match &expression.kind {
        ExprKind::Path(path) => path.segments.iter().map(|name| &*name.text).collect::<Vec<_>>().join("."),
        ExprKind::Index(path, indices) => format!("{}[{}]", path.segments[0].text, indices.len()),
        ExprKind::Quantity(quantity) => match &quantity.unit {
            None => quantity.number.text.clone(),
            Some(unit) => format!("{}{}", quantity.number.text, show_unit(unit)),
        },
        ExprKind::Not(inner) => format!("(not {})", show(inner)),
        ExprKind::And(parts) => format!("(and {})", all(parts)),
        ExprKind::Or(parts) => format!("(or {})", all(parts)),
        ExprKind::Compare(operator, left, right) => format!("({operator:?} {} {})", show(left), show(right)),
        ExprKind::Is(left, terms) => format!("(is {} {})", show(left), terms.len()),
        ExprKind::After(_) => "after".to_owned(),
        ExprKind::Done => "done".to_owned(),
        ExprKind::Call(call) => format!("{}({})", call.path.segments[0].text, call.arguments.len()),
        ExprKind::Negate(inner) => format!("(- {})", show(inner)),
        ExprKind::Sum(terms) => {
            let terms = terms.iter().map(|(sign, term)| format!("{sign:?} {}", show(term)));
            format!("({})", terms.collect::<Vec<_>>().join(" "))
        }
        ExprKind::Product(factors) => {
            let factors = factors.iter().map(|(side, factor)| format!("{side:?} {}", show(factor)));
            format!("({})", factors.collect::<Vec<_>>().join(" "))
        }
    }
}

fn show_unit(unit: &ast::Unit) -> String {
    unit.factors.iter().map(|factor| format!("{}^{}", factor.name.text, factor.power)).collect::<Vec<_>>().join(" ")
}

#[test]
fn every_rule_is_exercised_by_the_corpus() {
    let mut seen = BTreeSet::from([Rule::EOI]);
    for (_, text) in CORPUS {
        for (_, matched) in super::declarations(text) {
            seen.extend(matched.nodes().map(|(rule, _)| rule));
        }
    }
    let missing: Vec<_> = Rule::all_rules().iter().filter(|rule| !seen.contains(rule) && !is_silent(**rule)).collect();
    assert!(missing.is_empty(), "not in the corpus: {missing:?}");
}

/// The words of a text that the grammar takes for keywords, as `line:column word`, both from 1.
fn keywords(text: &str) -> Vec<String> {
    let joins = [Rule::prefix, Rule::infix, Rule::connective, Rule::negation, Rule::hedge];
    let is_keyword = |rule: Rule| format!("{rule:?}").starts_with("kw_") || joins.contains(&rule);
    let place = |byte: usize| {
        let before = text[..byte].replace("\r\n", "\n").replace('\r', "\n");
        let line = before.rsplit('\n').next().unwrap_or("");
        (before.matches('\n').count() + 1, line.chars().count() + 1)
    };
    let mut found = BTreeSet::new();
    for (start, matched) in super::declarations(text) {
        let words = matched.nodes().filter(|(rule, _)| is_keyword(*rule));
        let words = words.map(|(_, range)| (start + range.start, &text[start + range.start..start + range.end]));
        let words = words.filter(|(_, word)| word.starts_with(char::is_alphabetic));
        found.extend(words.map(|(at, word)| (place(at), word.to_owned())));
    }
    found.into_iter().map(|((line, column), word)| format!("{line}:{column} {word}")).collect()
}

#[test]
fn editors_are_told_where_keywords_stand() {
    let told = CORPUS.iter().flat_map(|(name, text)| [vec![(*name).to_owned()], keywords(text)].concat());
    let told = told.collect::<Vec<_>>().join("\n");
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("../../../editors");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("keywords", told));
}

#[test]
fn keywords_are_sorted_and_cover_what_begins_a_member() {
    assert!(KEYWORDS.is_sorted());
    assert!(DECLARATIONS.iter().all(|word| KEYWORDS.contains(word)));
    for block in [Block::Network, Block::Event, Block::Diagram, Block::Mode] {
        assert!(block.keywords().iter().all(|word| KEYWORDS.contains(word)), "{block:?}");
    }
}

#[test]
fn no_keyword_is_a_unit() {
    for keyword in KEYWORDS {
        let text = format!("a = singleton(3 {keyword})");
        assert!(grammar::run(Rule::only_term, &text).is_err(), "{keyword} is taken as a unit");
    }
}

#[test]
fn precedence_is_that_of_the_reference() {
    let cases = [
        ("a or b and not c", "(or a (and b (not c)))"),
        ("not a < b and c", "(and (not (Less a b)) c)"),
        ("a and (b and c)", "(and a (and b c))"),
        ("a - 3 < -4 * b + c / -d", "(Less (Plus a Minus 3) (Plus (Times -4 Times b) Plus (Times c Over (- d))))"),
        ("a -3 m > - 4", "(Greater (Plus a Minus 3m^1) (- 4))"),
        ("3 m / y > 2 m/s^-2*kg", "(Greater (Times 3m^1 Over y) 2m^1 s^2 kg^1)"),
        ("x is t and not y is any of {a, b}", "(and (is x 1) (not (is y 2)))"),
        ("((a)) and done or after 3 s", "(or (and a done) after)"),
        ("not not a", "(not (not a))"),
        (
            "count(f) >= 3 and sonar[0, 2..3] < goal.range",
            "(and (GreaterOrEqual count(1) 3) (Less sonar[2] goal.range))",
        ),
    ];
    for (text, expected) in cases {
        assert_eq!(show(&condition(text)), expected, "{text}");
    }
}

#[test]
fn a_factor_after_a_slash_is_below_the_line_alone() {
    let unit = condition("x > 1 kg*m/s^2/A*K");
    assert_eq!(show(&unit), "(Greater x 1kg^1 m^1 s^-2 A^-1 K^1)");
}

#[test]
fn spans_are_bytes_of_the_text_that_was_given() {
    let text = "\u{feff}// ä\r\nbehavior b on r {\r\n    flag a = not (x or y) // ü\r\n    entry e\r\n}\r\n// end";
    let (file, diagnostics) = modes(text);
    assert!(diagnostics.is_empty());
    let Item::Diagram(diagram) = &file.items[0] else { panic!("no behavior") };
    assert!(text[diagram.span.range()].starts_with("behavior") && text[diagram.span.range()].ends_with('}'));
    let DiagramItem::Flag(flag) = &diagram.items[0] else { panic!("no flag") };
    assert_eq!(&text[flag.span.range()], "flag a = not (x or y)");
    assert_eq!(&text[flag.condition.span.range()], "not (x or y)");
    let DiagramItem::Entry { span, .. } = &diagram.items[1] else { panic!("no entry") };
    assert_eq!(&text[span.range()], "entry e");
}

#[test]
fn doc_comments_go_to_what_follows() {
    let text = "/// One.\n///  Two.\n// aside\nbehavior b on r {\n/// f\nflag f = a ///  late\nentry e\n/// m\nmode e {\n/// t\n1: f -> e\n/// lost\n}\n//// no doc\nmode g { }\n}";
    let (file, diagnostics) = modes(text);
    assert!(diagnostics.is_empty());
    let Item::Diagram(diagram) = &file.items[0] else { panic!("no behavior") };
    let lines = |doc: &Option<ast::Doc>| doc.as_ref().map(|doc| doc.lines.clone()).unwrap_or_default();
    assert_eq!(lines(&diagram.doc), ["One.", " Two."]);
    let docs = diagram.items.iter().map(|item| match item {
        DiagramItem::Flag(flag) => lines(&flag.doc),
        DiagramItem::Mode(mode) => match mode.items.first() {
            Some(ast::ModeItem::Transition(transition)) => [lines(&mode.doc), lines(&transition.doc)].concat(),
            _ => lines(&mode.doc),
        },
        _ => Vec::new(),
    });
    assert_eq!(docs.collect::<Vec<_>>(), [vec!["f".to_owned()], vec![], vec!["m".into(), "t".into()], vec![]]);
}

#[test]
fn a_keyword_as_a_name_is_reported_and_the_tree_kept() {
    let (file, diagnostics) = modes("behavior b on r { entry flag mode flag { 1: hit -> mode } }");
    assert_eq!(diagnostics.iter().map(|finding| finding.rule.code).collect::<Vec<_>>(), ["LM0103"; 3]);
    let Item::Diagram(diagram) = &file.items[0] else { panic!("no behavior") };
    assert!(
        matches!(&*diagram.items, [DiagramItem::Entry { .. }, DiagramItem::Mode(mode)] if mode.name.text == "flag")
    );
}

#[test]
fn a_large_declaration_has_the_same_tree_as_its_parts() {
    let modes_text =
        "mode a { halt() 1: x is any of {b, c} -> a 2: y -> a decide (a) { (b) => nothing (c) => halt() } }\n";
    let text = format!("behavior b on r {{ entry a {} }}", modes_text.repeat(100));
    let (file, diagnostics) = modes(&text);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let Item::Diagram(diagram) = &file.items[0] else { panic!("no behavior") };
    assert_eq!(diagram.items.len(), 101);
    assert_eq!(&text[diagram.span.range()], text);
    assert!(diagram.items.iter().skip(1).all(|item| matches!(item, DiagramItem::Mode(mode) if mode.items.len() == 4)));
}
