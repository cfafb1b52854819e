//! Diagrams as a model for Spin, over the valuations that some readings give.

mod condition;
mod names;
mod proctype;
mod tick;

use std::fmt::Write;

use names::{Kind, Names};
use proctype::proctype;

use crate::analysis::modes::Machine;
use crate::base::Sources;
use crate::ir::Program;

const HEAD: &str = "\
/* Made by lmslc. Each pass through the loop of a process is a tick: it chooses flags that some readings set together,
   then takes the first exit whose condition holds and whose target is not inhibited. What looks to the past is free
   as far as the present allows.

   The exits that are never taken are the labels that this lists as unreached:

       spin -a -o3 MODEL.pml
       cc -o pan pan.c
       ./pan -m1000000
*/
";

/// The state of a sensor that has not failed.
const HEALTHY: &str = "healthy";
/// More names than this no enumeration of Promela holds.
const MOST_NAMES: usize = 255;

/// Machines as one Promela model, in which one of them is chosen at the start and runs for ever. Each exit is a
/// statement with a label, `MODE_PRIORITY`, and where sensors fail one for each set of failed sensors, in the order of
/// [`Machine::faults`]: `MODE_PRIORITY_SET`. Linear in the number of feasible valuations. `None` where there are more
/// than 255 modes, or ways in which sensors fail.
pub fn promela(program: &Program, sources: &Sources, machines: &[Machine]) -> Option<String> {
    let mut names = Names::default();
    names.of(Kind::Fault, HEALTHY);
    let processes: Vec<_> = machines.iter().map(|machine| proctype(program, sources, machine, &mut names)).collect();
    if names.all(Kind::Mode).len().max(names.all(Kind::Fault).len()) > MOST_NAMES {
        return None;
    }
    let mut text = HEAD.to_owned() + &variables(&names, machines);
    for (_, process) in &processes {
        text += process;
    }
    text += "\ninit {\n    if\n";
    for (name, _) in &processes {
        _ = writeln!(text, "    :: run {name}()");
    }
    text += "    fi\n}\n";
    Some(text)
}

/// What all processes share, since only one of them runs.
fn variables(names: &Names, machines: &[Machine]) -> String {
    let list = |kind| names.all(kind).into_iter().map(|(_, name)| name).collect::<Vec<_>>().join(", ");
    let mut text = format!("\nmtype:mode = {{ {} }};\nmtype:mode mode;\n", list(Kind::Mode));
    let sensors = names.all(Kind::Sensor);
    if !sensors.is_empty() {
        _ = writeln!(text, "\nmtype:fault = {{ {} }};", list(Kind::Fault));
        text += "byte failures; /* sensors that have failed: at any time, and for ever */\n";
    }
    for (_, sensor) in sensors {
        _ = writeln!(text, "mtype:fault {sensor} = {HEALTHY};");
    }
    let clocks = || machines.iter().flat_map(|machine| &machine.modes).map(|mode| &mode.clock);
    text += "\n";
    if clocks().any(|clock| !clock.thresholds.is_empty()) {
        text += "byte passed; /* timers of the mode that have run out */\n";
    }
    let counts = clocks().map(|clock| clock.counters.len()).max().unwrap_or(0);
    if counts > 0 {
        _ = writeln!(text, "byte counts[{counts}]; /* what has risen since the mode was entered */");
    }
    for (meaning, flag) in names.all(Kind::Flag) {
        _ = writeln!(text, "bool {flag}; /* {meaning} */");
    }
    text
}
