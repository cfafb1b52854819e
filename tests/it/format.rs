//! The formatter: what it keeps, what it changes, and that it comes to rest.

use lmslc::base::FileId;
use lmslc::syntax::{ast::FileKind, format, parse};

use crate::support::{files_below, root};

fn kind(path: &str) -> FileKind {
    if path.rsplit('.').next() == Some("fsfn") { FileKind::Fusion } else { FileKind::Modes }
}

fn formatted(kind: FileKind, text: &str) -> String {
    match format(FileId(0), kind, text) {
        Ok(text) => text,
        Err(findings) => panic!("{findings:?}\n{text}"),
    }
}

/// All characters but space, in any order.
fn characters(text: &str) -> Vec<char> {
    let mut characters: Vec<_> = text.chars().filter(|c| !c.is_whitespace() && *c != '\u{feff}').collect();
    characters.sort_unstable();
    characters
}

/// Formats a text and demands that nothing is lost, and that formatting again changes nothing.
fn sound(path: &str, text: &str) -> String {
    let once = formatted(kind(path), text);
    assert_eq!(characters(&once), characters(text), "{path}\n{once}");
    assert_eq!(formatted(kind(path), &once), once, "{path}");
    assert!(once.lines().all(|line| line.trim_end() == line), "{path}\n{once}");
    once
}

#[test]
fn what_was_written_in_a_hurry() {
    let fsfn = "\u{feff}// top\r\n\r\n\r\n/// Doc.\r\nvariable  v :N in 0..10 fails 0 ,10 {low=ramp( 5 ,1 ) // near\r\n\
        \r\n\r\n   middle = triangle(1,5,9)   // between\r\n high=points( (1,0),(9 , 1) )\r\n\r\n}\r\n\
        network n( a:v,b : v ) using{and product,implication product}{event e over( a,b ) hold 3 s{ contributor(low,_)\r\n\
        (high,{low,middle}) // wide\r\n\r\n// alone\r\n(_,high)\r\n detractor rule not a is low and(b is any of{ high,low }or b is high)}}";
    insta::assert_snapshot!("fusion", sound("n.fsfn", fsfn));
    let msd = "import b\nimport a\nrobot r provides i,j{body differential_drive{mass 5 kg   size(1 m,2 m)\ntrack 1 m}\n\
        optional sensor x:m in -1..1 fails any=wheel.left.speed\nsensor s[24] : m in 0..1\n logical f=min( s[21..23,0] )\n\
        action turn( angle:rad )->done=body.rotate( angle )}\nbehavior b on r{sense n(x)\nflag f=x>-1\nflag longer = x < - y\n\
        entry a mode a{turn(random(-1 rad,1 rad))\n// second\n2: not f and(x>1 m or held( f,3 s ))->a\n10:done->again\n1 : x  is low-> c\n\
        on enter{halt()}}\nfinal mode c{halt()} mode d requires x,y else a{\n1: first_long_flag and second_long_flag and \
        (third_long_flag or fourth_long_flag) and not fifth_long_flag and sixth_long_flag_of_all -> a\n\n// last\n}}\n\
        scenario s runs b on r{duration 3 s seed 1\nfault x=0 m from 1 s\nfault longer=any from 10 s to 12 s\n\
        expect a->c within 1 s..2 s}\nproperty p:never f\nproperty q: f leads to mode_x within 3 s // why\n// end";
    insta::assert_snapshot!("modes", sound("b.msd", msd));
}

#[test]
fn comments_keep_their_places() {
    let text = "behavior b on r { // opens
    // first
    entry a // entry

    // mode

    mode a { // a
        go(1 m/s, // speed
           2 m)   // radius
        1: x > 1 // low
           // and
           and y < 2 -> a // again
        // closes
    } // closed
    // of b
} // end
// tail
";
    let once = sound("b.msd", text);
    for comment in text.split("//").skip(1) {
        let comment = comment.lines().next().unwrap().trim_end();
        assert!(once.contains(&format!("//{comment}")), "{comment}\n{once}");
    }
    insta::assert_snapshot!(once);
}

#[test]
fn the_library_and_the_examples_are_formatted() {
    for path in ["stdlib", "examples"].iter().flat_map(|folder| files_below(folder, &["msd", "fsfn"])) {
        let text = std::fs::read_to_string(root().join(&path)).unwrap();
        assert!(formatted(kind(&path), &text) == text, "`lmslc fmt {path}` changes it");
    }
}

#[test]
fn every_file_comes_to_rest_and_loses_nothing() {
    let mut seen = 0;
    for folder in ["stdlib", "examples", "tests/corpus"] {
        for path in files_below(folder, &["msd", "fsfn"]) {
            let Ok(text) = std::fs::read_to_string(root().join(&path)) else { continue };
            let (_, findings) = parse(FileId(0), kind(&path), &text);
            if findings.is_empty() {
                sound(&path, &text);
                seen += 1;
            } else {
                assert!(format(FileId(0), kind(&path), &text).is_err(), "{path}");
            }
        }
    }
    assert!(seen > 100, "{seen} files");
}
