//! `lmslc new`

use std::path::Path;

use clap::{Args, ValueEnum};

use super::files;
use super::terminal::Terminal;
use crate::driver::is_name;

/// Make a project that checks, runs and tests at once.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc new patrol
  cd patrol && lmslc check . && lmslc test .")]
pub(super) struct New {
    /// The folder to make; its name becomes the behavior's
    folder: String,
    /// The robot to start with
    #[arg(long, value_name = "NAME", default_value = "j5")]
    robot: Robot,
}

#[derive(Clone, Copy, ValueEnum)]
enum Robot {
    /// Differential drive, wheel encoders and a wedge that feels force
    J5,
}

const CONFIG: &str = include_str!("lmsl.toml");
const WORKFLOW: &str = include_str!("workflow.yml");

impl New {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        let folder = Path::new(&self.folder);
        let last = folder.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        let name = last.to_lowercase().replace(['-', ' '], "_");
        if !is_name(&name) {
            let help = "take letters, digits and `_` for the last part of the folder, and no word of the language";
            return Err(terminal.fail(&format!("`{last}` cannot be the name of a behavior"), Some(help)));
        }
        if folder.exists() {
            return Err(terminal.fail(&format!("`{}` exists already", self.folder), Some("name another folder")));
        }
        let (behavior, scenarios) = match self.robot {
            Robot::J5 => (include_str!("j5_behavior.msd"), include_str!("j5_scenarios.msd")),
        };
        let files = [
            (format!("{name}.msd"), behavior.replace("NAME", &name)),
            ("scenarios.msd".to_owned(), scenarios.replace("NAME", &name)),
            ("lmsl.toml".to_owned(), CONFIG.to_owned()),
            (".github/workflows/behavior.yml".to_owned(), WORKFLOW.to_owned()),
        ];
        for (path, text) in &files {
            let path = folder.join(path);
            files::make_folder(&path.parent().unwrap_or(folder).to_string_lossy(), terminal)?;
            files::write(&path.to_string_lossy(), text.as_bytes(), terminal)?;
        }
        terminal.note(&format!("made `{}`; next: cd {0} && lmslc check . && lmslc test .", self.folder));
        Ok(super::CLEAN)
    }
}
