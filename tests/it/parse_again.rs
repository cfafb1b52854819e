//! What was parsed before comes out as if it were parsed for the first time.

use lmslc::base::FileId;
use lmslc::driver;
use lmslc::syntax::ast::FileKind;
use lmslc::syntax::{Memo, parse, parse_again};

use crate::support::{files_below, root};

const EDITS: u32 = 8;

/// Numbers below a bound, in no order that matters (Knuth's MMIX generator).
struct Draws(u64);

impl Draws {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % bound.max(1)
    }

    fn place(&mut self, text: &str) -> usize {
        text.floor_char_boundary(self.below(text.len() + 1))
    }
}

/// Takes something away, moves everything, or writes down once more what stands elsewhere.
fn edited(text: &str, draws: &mut Draws) -> String {
    let at = draws.place(text);
    let end = text.ceil_char_boundary((at + draws.below(12)).min(text.len()));
    let (before, cut, after) = (&text[..at], &text[at..end], &text[end..]);
    match draws.below(4) {
        0 => format!("{before}{after}"),
        1 => format!("// moved\n\n{text}"),
        2 => format!("{before}\n    {cut}{after}"),
        _ => {
            let from = draws.place(text);
            let to = text.ceil_char_boundary((from + draws.below(200)).min(text.len()));
            format!("{before}{cut}{}{after}", &text[from..to])
        }
    }
}

#[test]
fn a_text_that_is_parsed_again_has_the_same_tree_and_findings() {
    let mut draws = Draws(0);
    let mut memo = Memo::default();
    for path in ["stdlib", "examples", "tests/corpus"].iter().flat_map(|folder| files_below(folder, &["msd", "fsfn"])) {
        let Ok(mut text) = std::fs::read_to_string(root().join(&path)) else { continue };
        let kind = driver::kind(&path).unwrap();
        for edit in 0..EDITS {
            let file = FileId(edit % 3);
            assert_eq!(parse_again(&mut memo, file, kind, &text), parse(file, kind, &text), "{path}:\n{text}");
            text = edited(&text, &mut draws);
            memo.forget_unused();
        }
    }
}

#[test]
fn a_large_behavior_is_the_same_after_every_keystroke() {
    let mode =
        |index: usize| format!("    /// Mode {index}.\n    mode m{index} {{\n        1: hit{index} -> m0\n    }}\n");
    let modes: String = (0..300).map(mode).collect();
    let text = format!("behavior b on r {{\n{modes}}}\n");
    let mut memo = Memo::default();
    for typed in ["", "x", "xy", "{", "}", "1:", "///", "mode ", "behavior "] {
        let text = text.replacen("hit150", &format!("hit150{typed}"), 1);
        let again = parse_again(&mut memo, FileId(0), FileKind::Modes, &text);
        assert_eq!(again, parse(FileId(0), FileKind::Modes, &text), "{typed}");
        memo.forget_unused();
    }
}
