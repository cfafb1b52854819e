//! The ticks of a mode: what can be true, and which exit is then taken.

use std::collections::BTreeSet;
use std::fmt::Write;

use super::condition::Expressions;
use super::names::Kind;
use super::proctype::Writer;
use crate::analysis::modes::{Case, Guards};
use crate::base::Id;
use crate::ir::{Mode, Transition};

impl Writer<'_, '_> {
    pub(super) fn ticks(&mut self, id: Id<Mode>, guards: &Guards) {
        let mode = &self.diagram.modes[id];
        let clock = &guards.clock;
        let expressions = Expressions::new(self.program, self.sources, self.diagram, guards, self.names);
        let (name, place) = (self.mode(id), self.place(mode.symbol.span));
        _ = writeln!(self.text, "\n    /* mode {}, {place} */", mode.symbol.name);
        _ = writeln!(self.text, "    :: atomic {{ mode == {name} ->");
        for (counter, (_, most)) in clock.counters.iter().enumerate() {
            _ = writeln!(self.text, "        if :: counts[{counter}] < {most} -> counts[{counter}]++ :: skip fi;");
        }
        self.valuations(guards, &expressions.flags);
        for statement in &expressions.open {
            _ = writeln!(self.text, "        {statement};");
        }
        let counters = (0..clock.counters.len()).map(|counter| format!("; counts[{counter}] = 0"));
        let timer = clock.thresholds.first().map(|_| "; passed = 0".to_owned());
        let restart: String = timer.into_iter().chain(counters).collect();
        let mut tried = self.lost(id, &restart);
        for (transition, condition) in mode.transitions.iter().zip(&expressions.roots) {
            tried += self.exit(mode, transition, condition, &restart);
        }
        self.text += &match clock.thresholds.len() {
            0 => "        skip".to_owned(),
            most => format!("        if :: passed < {most} -> passed++ :: skip fi"),
        };
        if tried > 0 {
            _ = write!(self.text, "\n       {}", " fi".repeat(tried));
        }
        if !expressions.set.is_empty() {
            let clear: Vec<_> = expressions.set.iter().map(|flag| format!("{flag} = false")).collect();
            _ = write!(self.text, ";\n        {}", step(&clear));
        }
        self.text += "\n    }\n";
    }

    /// One choice of what is true, among all that can be with what has failed.
    fn valuations(&mut self, guards: &Guards, flags: &[Option<String>]) {
        let mut groups: Vec<(&[u64], Vec<&Case>)> = Vec::new();
        for case in &guards.cases {
            match groups.iter_mut().find(|(valuations, _)| *valuations == case.valuations) {
                Some((_, cases)) => cases.push(case),
                None => groups.push((&case.valuations, vec![case])),
            }
        }
        let failed = guards.cases.iter().flat_map(|case| &case.faults);
        let concerned: BTreeSet<_> = failed.map(|(sensor, _)| *sensor).collect();
        let guard = |case: &&Case| {
            let states: Vec<_> = concerned.iter().map(|sensor| self.state(*sensor, &case.faults)).collect();
            states.join(" && ")
        };
        let text = match groups.as_slice() {
            [([0], _)] => return,
            [(valuations, _)] => choice("        ", valuations, flags),
            several => {
                let option = |(valuations, cases): &(&[u64], Vec<&Case>)| {
                    // A line that ends in an operator goes on.
                    let any: Vec<_> = cases.iter().map(guard).collect();
                    format!(
                        "        :: {} ->\n{}\n",
                        any.join(" ||\n           "),
                        choice("            ", valuations, flags)
                    )
                };
                format!("        if\n{}        fi", several.iter().map(option).collect::<String>())
            }
        };
        _ = writeln!(self.text, "{text};");
    }

    /// Where the machine goes before any exit is tried, because a required sensor has failed. Answers how many
    /// branches are open.
    fn lost(&mut self, id: Id<Mode>, restart: &str) -> usize {
        let missing = self.required(id, "==");
        let Some(otherwise) = self.diagram.modes[id].otherwise.filter(|_| !missing.is_empty()) else { return 0 };
        let guards = [vec![format!("({})", missing.join(" || "))], self.required(otherwise, "!=")].concat();
        let target = self.mode(otherwise);
        _ = writeln!(self.text, "        if");
        _ = writeln!(self.text, "        :: {} -> mode = {target}{restart}", guards.join(" && "));
        _ = writeln!(self.text, "        :: else ->");
        1
    }

    /// An exit, a statement for each set of failed sensors. Answers how many branches are open.
    fn exit(&mut self, mode: &Mode, transition: &Transition, condition: &str, restart: &str) -> usize {
        let Some(to) = transition.target else { return 0 };
        let guard = [vec![condition.to_owned()], self.required(to, "!=")].concat().join(" && ");
        let target = self.mode(to);
        let (line, _) = self.sources.position(transition.span.file, transition.span.start);
        let written = self.sources.slice(transition.span).split_whitespace().collect::<Vec<_>>().join(" ");
        _ = writeln!(self.text, "        /* {}, line {line} */", written.replace("*/", "* /"));
        _ = writeln!(self.text, "        if");
        let text = format!("{} {}", mode.symbol.name, transition.priority);
        if let [_] = self.machine.faults.as_slice() {
            let label = self.names.of(Kind::Exit, &text);
            _ = writeln!(self.text, "        :: {guard} -> {label}: mode = {target}{restart}");
        } else {
            _ = writeln!(self.text, "        :: {guard} -> if");
            for (set, faults) in self.machine.faults.iter().enumerate() {
                let label = self.names.of(Kind::Exit, &format!("{text} {set}"));
                _ = writeln!(self.text, "            :: {} -> {label}: mode = {target}", self.failed(faults));
            }
            _ = writeln!(self.text, "            fi{restart}");
        }
        _ = writeln!(self.text, "        :: else ->");
        1
    }
}

/// One choice of some valuations, without the end of its line.
fn choice(indent: &str, valuations: &[u64], flags: &[Option<String>]) -> String {
    let mut text = format!("{indent}if\n");
    for valuation in valuations {
        let set = flags.iter().enumerate().filter(|(bit, _)| valuation >> bit & 1 == 1);
        let set: Vec<_> = set.filter_map(|(_, flag)| Some(format!("{} = true", flag.as_ref()?))).collect();
        _ = writeln!(text, "{indent}:: {}", step(&set));
    }
    text + indent + "fi"
}

/// Assignments as one statement.
fn step(assignments: &[String]) -> String {
    match assignments {
        [] => "skip".to_owned(),
        [one] => one.clone(),
        several => format!("d_step {{ {} }}", several.join("; ")),
    }
}
