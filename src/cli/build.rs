//! `lmslc build`

use std::collections::BTreeSet;
use std::path::Path;

use clap::{Args, ValueEnum};

use super::files;
use super::terminal::{Terminal, exit_code};
use crate::analysis::modes;
use crate::base::Id;
use crate::driver::Analysis;
use crate::ir::Diagram;
use crate::view;

/// Make something of behaviors that other tools read.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc build stdlib/behaviors/obstacle_manipulation.msd --emit promela -o model.pml
  lmslc build stdlib/behaviors --emit promela --faults 1 -o models/")]
pub(super) struct Build {
    /// Files that hold behaviors, folders, or `-` for standard input
    #[arg(required = true)]
    files: Vec<String>,
    /// What to make
    #[arg(long, value_name = "KIND")]
    emit: Emit,
    /// The most sensors that fail while the model runs
    #[arg(long = "faults", value_name = "K", default_value_t = 0)]
    up_to: usize,
    /// Where to write: a file, or a folder where there are several behaviors; standard output takes all of them
    #[arg(short, long, value_name = "PATH")]
    output: Option<String>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Emit {
    /// A model for the model checker Spin, over all flags that readings can set together
    Promela,
}

impl Emit {
    /// How the names of its files end.
    fn ending(self) -> &'static str {
        match self {
            Self::Promela => "pml",
        }
    }
}

impl Build {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        let analysis = files::look(&self.files, terminal)?;
        if analysis.checked().is_none() {
            return Err(exit_code(&analysis));
        }
        let is_asked = |diagram: &Diagram| analysis.roots.contains(&diagram.symbol.span.file);
        let diagrams = analysis.program.diagrams.iter().filter(|(_, diagram)| is_asked(diagram));
        let diagrams: Vec<_> = diagrams.map(|(id, _)| id).collect();
        if diagrams.is_empty() {
            return Err(terminal.fail(&format!("`{}` holds no behavior", self.files.join("`, `")), None));
        }
        let Some(output) = &self.output else {
            Terminal::print(&self.make(&analysis, &diagrams, terminal)?);
            return Ok(super::CLEAN);
        };
        let name = |id: &Id<Diagram>| analysis.program.diagrams[*id].symbol.name.as_str();
        if diagrams.len() == 1 && !Path::new(output).is_dir() {
            files::write(output, self.make(&analysis, &diagrams, terminal)?.as_bytes(), terminal)?;
            return Ok(super::CLEAN);
        }
        let mut names = BTreeSet::new();
        if let Some(twice) = diagrams.iter().find(|id| !names.insert(name(id))) {
            let message =
                format!("several behaviors are named `{}`, and each goes into a file of its name", name(twice));
            return Err(terminal.fail(&message, Some("build their files one by one")));
        }
        files::make_folder(output, terminal)?;
        for id in &diagrams {
            let path = Path::new(output).join(format!("{}.{}", name(id), self.emit.ending()));
            files::write(&path.to_string_lossy(), self.make(&analysis, &[*id], terminal)?.as_bytes(), terminal)?;
        }
        Ok(super::CLEAN)
    }

    /// The text for some behaviors.
    fn make(&self, analysis: &Analysis, diagrams: &[Id<Diagram>], terminal: &Terminal) -> Result<String, u8> {
        match self.emit {
            Emit::Promela => self.promela(analysis, diagrams, terminal),
        }
    }

    fn promela(&self, analysis: &Analysis, diagrams: &[Id<Diagram>], terminal: &Terminal) -> Result<String, u8> {
        let program = &analysis.program;
        let fewer = (self.up_to > 0).then_some("let fewer sensors fail together, with `--faults`");
        let machine = |id: &Id<Diagram>| {
            modes::machine(program, *id, self.up_to).map_err(|mode| {
                let diagram = &program.diagrams[*id];
                let (mode, diagram) = (&diagram.modes[mode].symbol.name, &diagram.symbol.name);
                terminal.fail(&format!("mode `{mode}` of `{diagram}` has more cases than are looked into"), fewer)
            })
        };
        let machines = diagrams.iter().map(machine).collect::<Result<Vec<_>, _>>()?;
        view::promela(program, &analysis.sources, &machines).ok_or_else(|| {
            terminal.fail("Promela has no names for more than 255 modes, or ways in which sensors fail", fewer)
        })
    }
}
