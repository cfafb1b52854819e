//! `lmslc completions` and `lmslc man`

use clap::{Args, CommandFactory};
use clap_complete::Shell;

use super::terminal::Terminal;

/// Print what a shell needs to complete commands, flags and files.
#[derive(Args)]
#[command(after_help = "\
Examples:
  lmslc completions bash > ~/.local/share/bash-completion/completions/lmslc
  lmslc completions zsh > ~/.zfunc/_lmslc
  lmslc completions fish > ~/.config/fish/completions/lmslc.fish")]
pub(super) struct Completions {
    /// The shell
    shell: Shell,
}

impl Completions {
    pub(super) fn execute(&self) -> u8 {
        let mut text = Vec::new();
        clap_complete::generate(self.shell, &mut super::Arguments::command(), "lmslc", &mut text);
        Terminal::print(&String::from_utf8_lossy(&text));
        super::CLEAN
    }
}

/// Prints the manual: a page for the command, followed by one for each of its commands.
pub(super) fn man() -> u8 {
    let mut command = super::Arguments::command();
    command.build();
    let pages = [command.clone()].into_iter().chain(command.get_subcommands().cloned());
    for page in pages.filter(|page| page.get_name() != "help") {
        let mut text = Vec::new();
        // Writing to memory has no way to fail.
        let _ = clap_mangen::Man::new(page).render(&mut text);
        Terminal::print(&String::from_utf8_lossy(&text));
    }
    super::CLEAN
}
