//! `lmslc build`

use std::path::Path;

use clap::{Args, ValueEnum};

use super::files;
use super::terminal::{Terminal, exit_code};
use crate::analysis::modes;
use crate::base::Id;
use crate::driver::{Analysis, NotCompiled, Plans};
use crate::emit::{Float, Options};
use crate::ir::Diagram;
use crate::view;
use crate::view::chart::{self, Chart};

/// Compile behaviors and networks to code, or to what other tools read.
#[derive(Args)]
#[command(after_help = "\
Code is made of the behaviors and networks that the files declare, and of the behaviors that their scenarios run.

Examples:
  lmslc build stdlib/behaviors/obstacle_manipulation.msd -o manipulation.rs
  lmslc build stdlib/networks/obstacle_id.fsfn --float f32
  lmslc build stdlib/behaviors --emit promela --faults 1 -o models/
  lmslc build stdlib/behaviors/obstacle_manipulation.msd --emit svg -o fig7.svg")]
pub(super) struct Build {
    /// Files, folders, or `-` for standard input
    #[arg(required = true)]
    files: Vec<String>,
    /// What to make
    #[arg(long, value_name = "KIND", default_value = "rust")]
    emit: Emit,
    /// Rust: the type of numbers [default: f64]
    #[arg(long, value_name = "TYPE")]
    float: Option<FloatType>,
    /// Rust: derive serde's traits for states and readings under this feature of your crate
    #[arg(long, value_name = "FEATURE")]
    serde: Option<String>,
    /// Rust and plan: the robot to compile for what is written on an interface
    #[arg(long, value_name = "NAME")]
    robot: Option<String>,
    /// Promela: the most sensors that fail while the model runs [default: 0]
    #[arg(long = "faults", value_name = "K")]
    up_to: Option<usize>,
    /// Where to write: a file, or for models and pictures a folder where there are several behaviors; otherwise standard
    /// output
    #[arg(short, long, value_name = "PATH")]
    output: Option<String>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Emit {
    /// A Rust module: `no_std`, without allocation, `unsafe`, panics or dependencies
    Rust,
    /// A model for the model checker Spin, over all flags that readings can set together
    Promela,
    /// What the compiler understood: names resolved, numbers in SI, `extends` followed
    Ir,
    /// The steps that are run and compiled, in their order
    Plan,
    /// A picture of each mode switching diagram
    Svg,
    /// Each mode switching diagram for Graphviz
    Dot,
    /// Each mode switching diagram for Mermaid
    Mermaid,
}

#[derive(Clone, Copy, ValueEnum)]
enum FloatType {
    /// The same numbers as everywhere else in lmslc, to the last bit
    F64,
    /// Half the size, rounded earlier
    F32,
}

impl Build {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        if let Some(flag) = self.misplaced() {
            return Err(terminal.fail(&format!("`{flag}` says nothing about what is made here"), Some("leave it out")));
        }
        let analysis = files::look(&self.files, terminal)?;
        if analysis.checked().is_none() {
            return Err(exit_code(&analysis));
        }
        let diagrams = analysis.program.diagrams.values().filter(|of| analysis.roots.contains(&of.symbol.span.file));
        for arbiter in
            diagrams.filter(|of| of.arbiter.is_some() && !matches!(self.emit, Emit::Ir | Emit::Rust | Emit::Plan))
        {
            let name = &arbiter.symbol.name;
            terminal.note(&format!("note: the arbiter `{name}` is left out: this is made of its clients, one by one"));
        }
        match self.emit {
            Emit::Rust => self.write(&self.rust(&analysis, terminal)?, terminal)?,
            Emit::Promela => self.models(&analysis, terminal)?,
            Emit::Ir => self.write(&view::program(&analysis.program), terminal)?,
            Emit::Plan => self.write(&self.plan(&analysis, terminal)?, terminal)?,
            Emit::Svg => self.pictures(&analysis, "svg", chart::svg, terminal)?,
            Emit::Dot => self.pictures(&analysis, "dot", chart::dot, terminal)?,
            Emit::Mermaid => self.pictures(&analysis, "mmd", chart::mermaid, terminal)?,
        }
        Ok(super::CLEAN)
    }

    /// A flag that belongs to something else than what is made.
    fn misplaced(&self) -> Option<&'static str> {
        let of_rust = [("--float", self.float.is_some()), ("--serde", self.serde.is_some())];
        let of_plans = [("--robot", self.robot.is_some())];
        let of_promela = [("--faults", self.up_to.is_some())];
        let elsewhere = match self.emit {
            Emit::Rust => of_promela.to_vec(),
            Emit::Plan => [of_rust.as_slice(), &of_promela].concat(),
            Emit::Promela => [of_rust.as_slice(), &of_plans].concat(),
            Emit::Ir | Emit::Svg | Emit::Dot | Emit::Mermaid => [of_rust.as_slice(), &of_plans, &of_promela].concat(),
        };
        elsewhere.iter().find(|(_, is_given)| *is_given).map(|(flag, _)| *flag)
    }

    /// To where the arguments say.
    fn write(&self, text: &str, terminal: &Terminal) -> Result<(), u8> {
        match &self.output {
            None => {
                Terminal::print(text);
                Ok(())
            }
            Some(path) => files::write(path, text.as_bytes(), terminal),
        }
    }

    fn plan(&self, analysis: &Analysis, terminal: &Terminal) -> Result<String, u8> {
        let plans = analysis.plans(self.robot.as_deref());
        let Plans { networks, diagrams } = plans.map_err(|reason| self.not_compiled(&reason, analysis, terminal))?;
        Ok(view::plans(&networks, &diagrams))
    }

    fn not_compiled(&self, reason: &NotCompiled, analysis: &Analysis, terminal: &Terminal) -> u8 {
        match explain(reason, &self.files.join("`, `")) {
            None => exit_code(analysis),
            Some((message, help)) => terminal.fail(&message, Some(&help)),
        }
    }

    fn rust(&self, analysis: &Analysis, terminal: &Terminal) -> Result<String, u8> {
        let float = match self.float {
            None | Some(FloatType::F64) => Float::F64,
            Some(FloatType::F32) => Float::F32,
        };
        let options = Options { float, serde: self.serde.clone(), robot: self.robot.clone() };
        analysis.rust(&options).map_err(|reason| self.not_compiled(&reason, analysis, terminal))
    }

    /// The behaviors that the files declare.
    fn diagrams(&self, analysis: &Analysis, terminal: &Terminal) -> Result<Vec<Id<Diagram>>, u8> {
        let is_asked = |diagram: &Diagram| analysis.roots.contains(&diagram.symbol.span.file);
        let diagrams =
            analysis.program.diagrams.iter().filter(|(_, diagram)| is_asked(diagram) && diagram.arbiter.is_none());
        let diagrams: Vec<_> = diagrams.map(|(id, _)| id).collect();
        if diagrams.is_empty() {
            return Err(terminal.fail(&format!("`{}` holds no behavior", self.files.join("`, `")), None));
        }
        Ok(diagrams)
    }

    /// Writes models: into one text, or each into a file of its name.
    fn models(&self, analysis: &Analysis, terminal: &Terminal) -> Result<(), u8> {
        let diagrams = self.diagrams(analysis, terminal)?;
        if self.output.as_ref().is_none_or(|path| diagrams.len() == 1 && !Path::new(path).is_dir()) {
            return self.write(&self.promela(analysis, &diagrams, terminal)?, terminal);
        }
        let model = |id: &Id<Diagram>| Ok((name(analysis, *id), self.promela(analysis, &[*id], terminal)?));
        let models = diagrams.iter().map(model).collect::<Result<Vec<_>, u8>>()?;
        files::write_each(&models, "pml", self.output.as_deref(), terminal)
    }

    fn pictures(
        &self,
        analysis: &Analysis,
        extension: &str,
        draw: fn(&Chart) -> String,
        terminal: &Terminal,
    ) -> Result<(), u8> {
        let diagrams = self.diagrams(analysis, terminal)?;
        let picture =
            |id: &Id<Diagram>| (name(analysis, *id), draw(&Chart::new(&analysis.program, &analysis.sources, *id)));
        let pictures: Vec<_> = diagrams.iter().map(picture).collect();
        files::write_each(&pictures, extension, self.output.as_deref(), terminal)
    }

    fn promela(&self, analysis: &Analysis, diagrams: &[Id<Diagram>], terminal: &Terminal) -> Result<String, u8> {
        let program = &analysis.program;
        let up_to = self.up_to.unwrap_or(0);
        let fewer = (up_to > 0).then_some("let fewer sensors fail together, with `--faults`");
        let machine = |id: &Id<Diagram>| {
            modes::machine(program, *id, up_to).map_err(|mode| {
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

fn name(analysis: &Analysis, diagram: Id<Diagram>) -> String {
    analysis.program.diagrams[diagram].symbol.name.clone()
}

/// What keeps a file from being compiled, and what to do about it; `None` where findings say it.
pub(super) fn explain(reason: &NotCompiled, file: &str) -> Option<(String, String)> {
    match reason {
        NotCompiled::Errors => None,
        NotCompiled::Nothing => Some((
            format!("`{file}` declares no behavior and no network, and no scenario that runs one"),
            "name the file that declares it".to_owned(),
        )),
        NotCompiled::Ambiguous(behavior, robots) => Some((
            format!("`{behavior}` is written on an interface that {} robots provide", robots.len()),
            format!("name the robot to compile it for: {}", robots.join(", ")),
        )),
        NotCompiled::NotWrittenFor(behavior) => Some((
            format!("`{behavior}` is not written for a robot of that name"),
            "name one that provides its interface".to_owned(),
        )),
    }
}
