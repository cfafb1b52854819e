//! What the compiler understood, as text: names resolved, numbers in SI, `extends` and names of conditions followed,
//! transitions by priority. It reads like the language, and nothing reads it back.

mod condition;
mod fusion;
mod machine;
mod plan;

pub use plan::plans;
mod outputs;

use std::fmt::Display;

use crate::ir::Program;

/// Lines under headings.
#[derive(Default)]
struct Lines(String);

impl Lines {
    /// A line, indented by so many steps.
    fn add(&mut self, depth: usize, line: impl Display) {
        let line = format!("{:1$}{line}", "", 4 * depth);
        self.0 += line.trim_end();
        self.0.push('\n');
    }

    /// A declaration, set off from what stands before it.
    fn head(&mut self, line: impl Display) {
        if !self.0.is_empty() {
            self.0.push('\n');
        }
        self.add(0, line);
    }
}

/// Everything that a program declares and imports, in the order of its arenas. Linear in its size, apart from named
/// conditions, which are written out.
pub fn program(program: &Program) -> String {
    let mut lines = Lines::default();
    for variable in program.variables.values() {
        fusion::variable(&mut lines, variable);
    }
    for network in program.networks.values() {
        fusion::network(&mut lines, program, network);
    }
    for robot in program.robots.values() {
        machine::robot(&mut lines, program, robot);
    }
    for diagram in program.diagrams.values().filter(|diagram| diagram.arbiter.is_none()) {
        machine::diagram(&mut lines, program, diagram);
    }
    lines.0
}
