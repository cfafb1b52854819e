//! What a scenario expects does not depend on what its behavior happens to compute.

use lmslc::base::Id;
use lmslc::plan;
use lmslc::sim::{self, RunOptions};

use crate::support::clean;

/// Which expectations of a short run are met, with more lines in the behavior's first mode and beside its modes.
fn met(in_mode: &str, beside: &str) -> Vec<bool> {
    let text = format!(
        "import std.robots.j5
         behavior b on j5 {{
             flag pressed = left_wheel_acceleration > -5 m/s^2
             {beside}
             entry a
             mode a {{ halt()  1: after 500 ms -> b  {in_mode} }}
             final mode b {{ halt() }}
         }}
         scenario s runs b {{
             duration 1 s
             expect never after 200 ms and b within 500 ms .. 600 ms
             expect always latched(pressed) within 200 ms .. 900 ms
             expect never count(pressed) >= 1 and b
         }}"
    )
    .replace("> -5 m/s^2", "> -4 m/s^2");
    let analysis = clean("s.msd", &text);
    let scenario = &analysis.program.scenarios[Id::new(0)];
    let plan = plan::build_scenario(analysis.checked().unwrap(), scenario);
    let run = sim::run(&analysis.program, &plan, scenario, &RunOptions::default()).unwrap();
    run.verdicts.iter().map(|verdict| verdict.passed).collect()
}

#[test]
fn expectations_have_a_memory_of_their_own() {
    let alone = met("", "");
    assert_eq!(alone, [true; 3]);
    assert_eq!(met("2: latched(pressed) and count(pressed) >= 50 -> b", ""), alone);
    assert_eq!(met("2: unused and failed(contact_force) -> b", "flag unused = after 200 ms"), alone);
}
