//! `lmslc fmt`

use clap::Args;
use similar::TextDiff;

use super::files::{self, Disk};
use super::terminal::Terminal;
use crate::base::Sources;
use crate::driver;

/// Lay files out in the one canonical way.
#[derive(Args)]
#[command(after_help = "\
Nothing but space changes, and the order of a mode's transitions, which are sorted by priority. Files that do not parse \
are reported and left alone.

Examples:
  lmslc fmt behaviors/
  lmslc fmt --check .
  lmslc fmt - < rough.msd")]
pub(super) struct Fmt {
    /// Files, folders, or `-` for standard input, which is written to standard output
    #[arg(required = true)]
    files: Vec<String>,
    /// Write nothing; show what would change, and exit with 1 where something would
    #[arg(long)]
    check: bool,
}

impl Fmt {
    pub(super) fn execute(&self, terminal: &Terminal) -> Result<u8, u8> {
        let paths = Disk::default().expand(&self.files, terminal)?;
        let (mut changed, mut broken) = (0, 0);
        for path in &paths {
            let text = files::read(path, terminal)?;
            let mut sources = Sources::default();
            let file = sources.add(path.as_str(), text.as_str());
            match driver::format(&sources, file) {
                Err(findings) => {
                    terminal.errors(&findings, &sources);
                    broken += 1;
                }
                Ok(formatted) if path == "-" && !self.check => Terminal::print(&formatted),
                Ok(formatted) if formatted == text => {}
                Ok(formatted) => {
                    changed += 1;
                    if self.check {
                        let diff = TextDiff::from_lines(&text, &formatted);
                        Terminal::print(&diff.unified_diff().header(path, path).to_string());
                    } else {
                        files::write(path, formatted.as_bytes(), terminal)?;
                    }
                }
            }
        }
        terminal.note(&self.summary(paths.len(), changed, broken));
        Ok(if broken > 0 || self.check && changed > 0 { super::FINDINGS } else { super::CLEAN })
    }

    fn summary(&self, all: usize, changed: usize, broken: usize) -> String {
        let files = |count: usize| format!("{count} file{}", if count == 1 { "" } else { "s" });
        let done = if self.check { "would be formatted" } else { "formatted" };
        let left = all - changed - broken;
        let same = if left == 1 { "it is" } else { "they are" };
        let mut text = format!("{} {done}, {left} left as {same}", files(changed));
        if broken > 0 {
            text += &format!(", {} not understood", files(broken));
        }
        text
    }
}
