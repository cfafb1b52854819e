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
