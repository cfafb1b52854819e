//! `lmslc graph`

use clap::{Args, ValueEnum};

use super::files;
use super::terminal::{Terminal, exit_code, listed};
use crate::analysis::modes::fault_table;
use crate::base::Id;
use crate::diag::did_you_mean;
use crate::driver::Analysis;
use crate::ir::{Diagram, Sensor, Symbol};
use crate::view;
use crate::view::chart::{self, Chart};

/// Draw mode switching diagrams, or networks.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc graph stdlib/behaviors/obstacle_manipulation.msd -o manipulation.svg
  lmslc graph stdlib/behaviors/obstacle_manipulation.msd --failed contact_force -o without_force.svg
  lmslc graph stdlib/networks/obstacle_id.fsfn --network -o obstacle_id.svg
  lmslc graph stdlib/behaviors/obstacle_avoidance.msd --format mermaid")]
pub(super) struct Graph {
    /// The file that holds behaviors or networks, or `-` for standard input
    file: String,
    /// What to draw for
    #[arg(long, value_name = "FORMAT", default_value = "svg")]
    format: Format,
    /// Draw pale what is lost once this sensor has failed; for several, all of them
    #[arg(long, value_name = "SENSOR")]
    failed: Vec<String>,
    /// Draw the membership functions and rules of the networks instead
    #[arg(long, conflicts_with = "failed")]
    network: bool,
    /// Where to write: a file, or a folder where there are several pictures; otherwise standard output
    #[arg(short, long, value_name = "PATH")]
    output: Option<String>,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// A picture
    Svg,
    /// Graphviz
    Dot,
    /// Markdown pages of many sites
    Mermaid,
}

impl Graph {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        let analysis = files::look(std::slice::from_ref(&self.file), terminal)?;
        let pictures =
            if self.network { self.networks(&analysis, terminal)? } else { self.diagrams(&analysis, terminal)? };
        if pictures.is_empty() {
            let what = if self.network { "network" } else { "behavior" };
            let has_networks = analysis.program.networks.values().any(|network| is_own(&analysis, &network.symbol));
            let help = (!self.network && has_networks).then_some("`--network` draws its networks");
            return Err(terminal.fail(&format!("`{}` holds no {what}", self.file), help));
        }
        let extension = match self.format {
            Format::Svg => "svg",
            Format::Dot => "dot",
            Format::Mermaid => "mmd",
        };
        files::write_each(&pictures, extension, self.output.as_deref(), terminal)?;
        Ok(super::CLEAN)
    }

    /// The behaviors that the file declares, each with its name.
    fn diagrams(&self, analysis: &Analysis, terminal: &Terminal) -> Result<Vec<(String, String)>, u8> {
        // What is broken is drawn as far as it is understood; what failures do to it is another matter.
        if analysis.has_errors() && !self.failed.is_empty() {
            return Err(exit_code(analysis));
        }
        let program = &analysis.program;
        let own = program.diagrams.iter();
        let own = own.filter(|(_, diagram)| is_own(analysis, &diagram.symbol) && diagram.arbiter.is_none());
        let draw = |(id, diagram): (Id<Diagram>, &Diagram)| {
            let mut chart = Chart::new(program, &analysis.sources, id);
            if !self.failed.is_empty() {
                let failed = self.sensors(analysis, diagram, terminal)?;
                let facts = fault_table(program, id, failed.len());
                let fails = |sensor: &Id<Sensor>| failed.contains(sensor);
                let mut under: Vec<_> =
                    facts.iter().filter(|facts| facts.faults.iter().all(|(id, _)| fails(id))).collect();
                // Of sensors that nothing looks at there are no facts.
                let most = under.iter().map(|facts| facts.faults.len()).max().unwrap_or(0);
                under.retain(|facts| facts.faults.len() == most);
                chart.mark_lost(&under);
            }
            let picture = match self.format {
                Format::Svg => chart::svg(&chart),
                Format::Dot => chart::dot(&chart),
                Format::Mermaid => chart::mermaid(&chart),
            };
            Ok((diagram.symbol.name.clone(), picture))
        };
        own.map(draw).collect()
    }

    /// The sensors that are to have failed.
    fn sensors(&self, analysis: &Analysis, diagram: &Diagram, terminal: &Terminal) -> Result<Vec<Id<Sensor>>, u8> {
        let program = &analysis.program;
        let known = program.sensors_of(diagram.platform);
        let name = |sensor: &Id<Sensor>| program.sensors[*sensor].symbol.name.as_str();
        let find = |wanted: &String| {
            known.iter().copied().find(|sensor| name(sensor) == wanted).ok_or_else(|| {
                let names = known.iter().map(name);
                let help = did_you_mean(wanted, names.clone())
                    .unwrap_or_else(|| format!("its sensors are: {}", listed(names)));
                let message = format!("`{}` has no sensor `{wanted}`", diagram.symbol.name);
                terminal.fail(&message, Some(&help))
            })
        };
        let mut sensors = self.failed.iter().map(find).collect::<Result<Vec<_>, _>>()?;
        sensors.sort_unstable();
        sensors.dedup();
        Ok(sensors)
    }

    /// The networks that the file declares, each with its name.
    fn networks(&self, analysis: &Analysis, terminal: &Terminal) -> Result<Vec<(String, String)>, u8> {
        if self.format != Format::Svg {
            return Err(terminal.fail("networks are drawn as SVG only", Some("leave `--format` out")));
        }
        if analysis.has_errors() {
            return Err(exit_code(analysis));
        }
        let program = &analysis.program;
        let own = program.networks.values().filter(|network| is_own(analysis, &network.symbol));
        Ok(own.map(|of| (of.symbol.name.clone(), view::network(program, &analysis.sources, of))).collect())
    }
}

fn is_own(analysis: &Analysis, symbol: &Symbol) -> bool {
    analysis.roots.contains(&symbol.span.file)
}
