//! What the tests of this room render.

use crate::base::{FileId, Sources, Span};
use crate::diag::{Diagnostic, find_rule};

fn rule(code: &str) -> &'static crate::diag::Rule {
    find_rule(code).unwrap()
}

/// Three findings in two files: several labels, notes of two lines, a place in each file, and one without anything.
pub fn diagnostics() -> (Vec<Diagnostic>, Sources) {
    let mut sources = Sources::default();
    let behavior = "behavior obstacle_manipulation on J5 {\n    \
                    mode forward {\n        \
                    transition 1 to push when obstacle_id.forward_colision\n        \
                    transition 1 to stop when obstacle_id.heavy_obstacle\n    }\n}\n";
    let msd = sources.add("examples/j5.msd", behavior);
    let fsfn = sources.add("examples/obstacle.fsfn", "// größer als 1 µm\nvariable force: N in 0 .. 250 {\n}\n");
    let at = |file: FileId, words: &str, occurrence: usize| {
        let text = &sources.get(file).unwrap().text;
        let (start, _) = text.match_indices(words).nth(occurrence).unwrap();
        Span::new(file, start as u32, (start + words.len()) as u32)
    };
    let unknown = Diagnostic::new(rule("LM0201"), at(msd, "forward_colision", 0), "no event `forward_colision`")
        .here("not an event of `obstacle_id`")
        .help("did you mean `forward_collision`?");
    let twice = Diagnostic::new(rule("LM0403"), at(msd, "1", 1), "two transitions of `forward` with priority 1")
        .here("priority 1 again")
        .label(at(msd, "1", 0), "first used here")
        .label(at(fsfn, "force", 0), "both look at this variable")
        .note("the transition with the smallest number is taken\nwhere several conditions hold")
        .note("priorities are whole numbers from 1");
    let empty = Diagnostic::new(rule("LM0503"), at(fsfn, "variable force: N in 0 .. 250 {\n}\n", 0), "no terms");
    (vec![unknown, twice, empty], sources)
}
