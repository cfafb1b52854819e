//! How fast the modes of large diagrams are analyzed: `cargo bench --bench modes`.
#![expect(clippy::unwrap_used, reason = "a bench without its input has nothing to measure")]

use divan::{Bencher, black_box, counter::ItemsCount};
use lmslc::analysis;
use lmslc::base::Id;
use lmslc::driver::{Analysis, FileError, Files, Options, analyze};

fn main() {
    divan::main();
}

struct Text(String);

impl Files for Text {
    fn read(&self, path: &str) -> Result<String, FileError> {
        if path == "main.msd" { Ok(self.0.clone()) } else { Err(FileError::Missing) }
    }
}

/// So many modes with two exits each: a network's event, or a comparison of its own number and a timer.
fn behavior(modes: usize) -> Analysis {
    let mut text = "import std.networks.obstacle_id\nimport std.robots.j5\n".to_owned();
    text +=
        "behavior big on j5 {\n sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)\n";
    text += " entry m0\n";
    for mode in 0..modes {
        let (next, far) = ((mode + 1) % modes, (mode * 7 + 3) % modes);
        let guard = match mode % 2 {
            0 => "after 100 ms and heavy_obstacle".to_owned(),
            _ => format!("after 100 ms and contact_force > {} N and not failed(contact_force)", mode % 400),
        };
        text += &format!(" mode m{mode} {{ drive(26 cm/s) 1: {guard} -> m{far} 2: after 2 s -> m{next} }}\n");
    }
    let analysis = analyze(&Text(text + "}\n"), &["main.msd".to_owned()], &Options::default());
    assert!(!analysis.has_errors());
    analysis
}

/// A goal that runs so many activities, each of which runs so many behaviors of so many modes, all over the same sensors:
/// every other mode asks the network, the rest compare a number of their own; every layer can leave by the same readings.
fn layers(count: usize) -> Analysis {
    let mut text = "import std.networks.obstacle_id\nimport std.robots.j5\n".to_owned();
    let sense = "sense obstacle_id(left_wheel_acceleration, right_wheel_acceleration, contact_force)";
    let ring = |text: &mut String,
                title: &str,
                wait: u32,
                inner: &dyn Fn(usize) -> String,
                guard: &dyn Fn(usize) -> String| {
        *text += &format!("{title} on j5 {{\n {sense}\n entry m0\n");
        for mode in 0..count {
            let (next, far) = ((mode + 1) % count, (mode * 3 + 1) % count);
            *text += &format!(
                " mode m{mode} {} 1: {} -> m{far} 2: after {wait} s -> m{next} }}\n",
                inner(mode),
                guard(mode)
            );
        }
        *text += "}\n";
    };
    for activity in 0..count {
        for behavior in 0..count {
            let title = format!("behavior b{activity}_{behavior}");
            let force = |mode: usize| 100 + (mode * 31 + behavior * 7 + activity) % 300;
            let guard = |mode: usize| match mode % 2 {
                0 => format!("after 200 ms and contact_force > {} N", force(mode)),
                _ => "after 200 ms and heavy_obstacle".to_owned(),
            };
            ring(&mut text, &title, 90, &|_| "{ drive(26 cm/s)".to_owned(), &guard);
        }
        let inner = |mode| format!("= b{activity}_{mode} {{");
        let guard = |mode: usize| format!("held(forward_collision, {} s)", mode + 2);
        ring(&mut text, &format!("activity a{activity}"), 900, &inner, &guard);
    }
    let guard = |mode: usize| format!("contact_force > {} N and after 30 s", 390 - mode);
    ring(&mut text, "goal g", 9000, &|mode| format!("= a{mode} {{"), &guard);
    let analysis = analyze(&Text(text), &["main.msd".to_owned()], &Options::default());
    assert!(!analysis.has_errors());
    analysis
}

/// Of `count` activities of `count` behaviors of `count` modes; the networks of the library are not judged.
#[divan::bench(args = [3, 10], max_time = 5)]
fn check_layers(bencher: Bencher, count: usize) {
    let analysis = layers(count);
    bencher.bench(|| analysis::run(black_box(&analysis.program), 1, |file| analysis.roots.contains(&file)));
}

#[divan::bench(args = [100, 1_000, 5_000], max_time = 3)]
fn check_modes(bencher: Bencher, modes: usize) {
    let analysis = behavior(modes);
    bencher.counter(ItemsCount::new(modes)).bench(|| analysis::run(black_box(&analysis.program), 1, |_| true));
}

#[divan::bench(args = [100, 1_000], max_time = 3)]
fn fault_table_of_single_faults(bencher: Bencher, modes: usize) {
    let analysis = behavior(modes);
    let diagram = analysis.program.diagrams.ids().next_back().unwrap_or(Id::new(0));
    bencher.bench(|| analysis::modes::fault_table(black_box(&analysis.program), diagram, 1));
}

#[divan::bench]
fn fault_table_of_obstacle_manipulation(bencher: Bencher) {
    let text = "import std.behaviors.obstacle_manipulation\n".to_owned();
    let analysis = analyze(&Text(text), &["main.msd".to_owned()], &Options::default());
    let diagram = analysis.program.diagrams.ids().next_back().unwrap();
    bencher.bench(|| analysis::modes::fault_table(black_box(&analysis.program), diagram, 3));
}
