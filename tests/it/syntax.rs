//! Parsing of both kinds of file: what is sound, what is broken, and what is absurd.

use std::path::{Path, PathBuf};

use lmslc::base::{FileId, Sources};
use lmslc::diag::Diagnostic;
use lmslc::syntax::ast::{DiagramItem, File, FileKind, Item, NetworkItem, OutputBody};
use lmslc::syntax::parse;

fn kind_of(path: &Path) -> FileKind {
    if path.extension().is_some_and(|extension| extension == "fsfn") { FileKind::Fusion } else { FileKind::Modes }
}

fn corpus(folder: &str) -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/corpus/syntax").join(folder);
    let mut paths: Vec<_> = std::fs::read_dir(root).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "fsfn" || extension == "msd"));
    paths.sort();
    let read = |path: PathBuf| {
        let text = std::fs::read_to_string(&path).unwrap();
        (path, text)
    };
    paths.into_iter().map(read).collect()
}

fn parse_modes(text: &str) -> (File, Vec<Diagnostic>) {
    parse(FileId(0), FileKind::Modes, text)
}

/// Each finding with its place and the line it stands on.
fn render(path: &str, text: &str, diagnostics: &[Diagnostic]) -> String {
    use std::fmt::Write as _;
    let mut sources = Sources::default();
    let file = sources.add(path, text);
    let mut shown = String::new();
    for diagnostic in diagnostics {
        let (line, column) = sources.position(file, diagnostic.span().start);
        let source = text.lines().nth(line - 1).unwrap_or("");
        let marks = "^".repeat((diagnostic.span().end - diagnostic.span().start).max(1) as usize);
        writeln!(shown, "{line}:{column} {} {}", diagnostic.rule.code, diagnostic.message).unwrap();
        writeln!(shown, "    {source}\n    {}{marks}", " ".repeat(column - 1)).unwrap();
        for label in diagnostic.labels.iter().skip(1) {
            let (line, column) = sources.position(file, label.span.start);
            writeln!(shown, "    {line}:{column} {}", label.message).unwrap();
        }
        if let Some(help) = &diagnostic.help {
            writeln!(shown, "    help: {help}").unwrap();
        }
    }
    shown
}

#[test]
fn sound_files_parse_without_findings() {
    for (path, text) in corpus("pass") {
        let (_, diagnostics) = parse(FileId(0), kind_of(&path), &text);
        assert_eq!(render("", &text, &diagnostics), "", "{}", path.display());
    }
}

#[test]
fn findings_show_source_and_message() {
    for (path, text) in corpus("fail") {
        let (_, diagnostics) = parse(FileId(0), kind_of(&path), &text);
        let name = path.file_name().unwrap().to_string_lossy().replace('.', "_");
        insta::assert_snapshot!(name, render("", &text, &diagnostics));
    }
}

#[test]
fn five_faults_in_five_modes_give_five_findings() {
    let faults = ["1: hit b", "1 hit -> b", "drive(3 m/s", "1: hit and -> b", "1: -> b"];
    let sound = "mode sound {\n drive(1 m/s)\n 1: hit -> b\n 2: miss -> sound\n}\n";
    let broken = faults.iter().enumerate();
    let broken = broken.map(|(index, fault)| format!("mode m{index} {{\n halt()\n {fault}\n 9: hit -> b\n}}\n{sound}"));
    let (file, diagnostics) = parse_modes(&format!("behavior b on r {{\n{}}}\n", broken.collect::<String>()));
    assert_eq!(diagnostics.len(), 5, "{diagnostics:?}");
    let Item::Diagram(diagram) = &file.items[0] else { panic!("no behavior") };
    assert_eq!(diagram.items.len(), 10);
    for item in &diagram.items {
        let DiagramItem::Mode(mode) = item else { panic!("a mode was lost: {item:?}") };
        assert_eq!(mode.items.len(), 3);
    }
}

#[test]
fn a_fault_costs_its_own_member_only() {
    let text = "network n(a: v) {\n event one { contributor (x) (y z) (w) detractor (x) }\n event { contributor (x) }\n \
                output y: m in 0 .. 1 { low = ramp(0, 1) high = ramp(1 0) }\n rule a is x => y is low\n}\n";
    let (file, diagnostics) = parse(FileId(0), FileKind::Fusion, text);
    assert_eq!(diagnostics.len(), 3, "{diagnostics:?}");
    let Item::Network(network) = &file.items[0] else { panic!("no network") };
    let [NetworkItem::Event(event), NetworkItem::Error(_), NetworkItem::Output(output), NetworkItem::Rule(_)] =
        &*network.items
    else {
        panic!("{:?}", network.items)
    };
    assert_eq!(event.sides.iter().map(|side| side.rules.len()).collect::<Vec<_>>(), [2, 1]);
    assert!(matches!(&output.body, OutputBody::Terms(terms) if terms.len() == 1));
}

fn flag(condition: &str) -> String {
    format!("behavior b on r {{ flag deep = {condition}\n entry a mode a {{ halt() }} }}\nproperty p: never deep\n")
}

#[test]
fn nesting_is_limited_before_anything_recurses() {
    let nested = |depth: usize| format!("{}a{}", "(".repeat(depth), ")".repeat(depth));
    let calls = |depth: usize| format!("{}a{}", "f(".repeat(depth), ")".repeat(depth));
    let negations = |depth: usize| format!("{}a", "not ".repeat(depth));
    let mixed = |depth: usize| format!("{}a{}", "not (-(".repeat(depth), "))".repeat(depth));
    let sound = [nested(256), calls(256), negations(256), mixed(64)];
    for text in sound {
        let (_, diagnostics) = parse_modes(&flag(&text));
        assert_eq!(diagnostics, [], "{text}");
    }
    let deep = [nested(257), nested(10_000), calls(10_000), negations(10_000), mixed(10_000), "(".repeat(10_000)];
    for text in deep {
        let (file, diagnostics) = parse_modes(&flag(&text));
        let codes: Vec<_> = diagnostics.iter().map(|finding| finding.rule.code).collect();
        assert_eq!(codes, ["LM0102"], "{}", &text[..20]);
        let Item::Diagram(diagram) = &file.items[0] else { panic!("no behavior") };
        assert!(matches!(&*diagram.items, [DiagramItem::Error(_), DiagramItem::Entry { .. }, DiagramItem::Mode(_)]));
        assert!(matches!(file.items[1], Item::Property(_)));
    }
}

#[test]
fn shapes_nest_no_deeper_than_conditions() {
    let shape =
        |depth: usize| format!("variable v: m {{ a = {}b{}\n c = b }}", "very (".repeat(depth), ")".repeat(depth));
    assert_eq!(parse(FileId(0), FileKind::Fusion, &shape(128)).1, []);
    for depth in [129, 10_000] {
        let (file, diagnostics) = parse(FileId(0), FileKind::Fusion, &shape(depth));
        assert_eq!(diagnostics.iter().map(|finding| finding.rule.code).collect::<Vec<_>>(), ["LM0102"]);
        let Item::Variable(variable) = &file.items[0] else { panic!("no variable") };
        assert_eq!(variable.terms.len(), 1);
    }
}

#[test]
fn flat_chains_may_be_long() {
    let chains =
        [("a", " and b", 100_000), ("a", " or b", 20_000), ("a < 0", " + b", 20_000), ("a < 0", " * b", 20_000)];
    for (first, more, length) in chains {
        let (file, diagnostics) = parse_modes(&flag(&format!("{first}{}", more.repeat(length))));
        assert_eq!((file.items.len(), diagnostics), (2, Vec::new()), "{more}");
    }
    let (_, diagnostics) = parse_modes(&flag(&format!("a{}", " < b".repeat(20_000))));
    assert_eq!(diagnostics.len(), 1);
    let rows = "(neg, _, {low, med}, -)\n".repeat(20_000);
    let text = format!("network n(a: b) {{ event e {{ contributor {rows} }} }}");
    assert_eq!(parse(FileId(0), FileKind::Fusion, &text).1, []);
}

#[test]
fn a_hundred_thousand_lines_parse() {
    let mode = "    mode m {\n        drive(26 cm/s)\n        1: heavy_obstacle -> stop\n        2: hit and after 4 s -> m\n    }\n";
    let behavior = format!("/// Many.\nbehavior b on j5 {{\n    entry m\n{}}}\n", mode.repeat(19));
    let text = behavior.repeat(1020);
    assert!(text.lines().count() > 100_000);
    let (file, diagnostics) = parse_modes(&text);
    assert_eq!((file.items.len(), diagnostics.len()), (1020, 0));
}

/// A small generator of pseudo-random numbers (Knuth's constants), so that a failure repeats.
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit.max(1)
    }
}

/// Parses, and checks what must hold of any text.
fn check_total(kind: FileKind, text: &str) {
    let (file, diagnostics) = parse(FileId(0), kind, text);
    let has_error = file.items.iter().any(|item| matches!(item, Item::Error(_)));
    assert!(!has_error || !diagnostics.is_empty(), "a fault without a finding in {text:?}");
    for finding in &diagnostics {
        assert_ne!(finding.rule.code, "LM9901", "{finding:?} in {text:?}");
        for label in &finding.labels {
            assert!(text.get(label.span.range()).is_some(), "{finding:?} in {text:?}");
        }
    }
}

/// Prefixes of chunks instead of files: what stands in front of a declaration does not change how it parses, and
/// the number of bytes parsed grows with the square of the length.
fn check_prefixes(folder: &str) {
    for (path, text) in corpus(folder) {
        for chunk in text.split_inclusive("\n}\n") {
            for end in (0..=chunk.len()).filter(|&end| chunk.is_char_boundary(end)) {
                check_total(kind_of(&path), &chunk[..end]);
            }
        }
    }
}

#[test]
fn every_prefix_of_a_sound_declaration_parses_to_something() {
    check_prefixes("pass");
}

#[test]
fn every_prefix_of_a_broken_declaration_parses_to_something() {
    check_prefixes("fail");
}

#[test]
fn damaged_files_parse_to_something() {
    let pieces =
        ["{", "}", "(", ")", "->", "\n", ":", "mode ", "\0", "é", "1", " not ", "//", "///", "\u{feff}", ",", "-"];
    let mut random = Random(2007);
    for (path, text) in corpus("pass") {
        for _ in 0..60 {
            let mut damaged = text.clone();
            for _ in 0..=random.below(4) {
                let boundaries: Vec<_> = damaged.char_indices().map(|(at, _)| at).collect();
                let Some(&at) = boundaries.get(random.below(boundaries.len())) else { break };
                if random.below(2) == 0 {
                    damaged.remove(at);
                } else {
                    damaged.insert_str(at, pieces[random.below(pieces.len())]);
                }
            }
            check_total(kind_of(&path), &damaged);
        }
    }
}
