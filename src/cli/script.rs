//! Compiling for the crate whose build script calls this.
#![expect(clippy::print_stdout, reason = "cargo reads what a build script prints")]

use std::path::{Path, PathBuf};

use super::terminal::Terminal;
use super::{When, build::explain, config, files::Disk};
use crate::base::Sources;
use crate::diag::{Diagnostic, Severity};
use crate::emit::Options;
use crate::{driver, report};

/// Compiles a file in the build script of a crate: `behaviors/patrol.msd` to `patrol.rs` in cargo's `OUT_DIR`, from where
/// the crate includes it. Tells cargo to run the script again when the file, a file that it imports or its `lmsl.toml`
/// has changed. What `lmslc check` finds becomes cargo's warnings and errors; after an error nothing is written and the
/// build fails.
///
/// ```no_run
/// // In the `main` of build.rs:
/// lmslc::build("behaviors/patrol.msd", &lmslc::emit::Options::default());
/// ```
///
/// ```text
/// mod robot {
///     include!(concat!(env!("OUT_DIR"), "/patrol.rs"));
/// }
/// ```
pub fn build(file: &str, options: &Options) {
    let folder = std::env::var_os("OUT_DIR").map(PathBuf::from);
    for line in compile(file, options, folder.as_deref()) {
        println!("{line}");
    }
}

/// Writes the code to a folder and answers what to tell cargo.
fn compile(file: &str, options: &Options, folder: Option<&Path>) -> Vec<String> {
    let changes = |path: &str| format!("cargo::rerun-if-changed={path}");
    let failed = |message: String| format!("cargo::error={message}");
    let configuration = config::find(file).map(|path| changes(&path.to_string_lossy()));
    let mut lines: Vec<String> = configuration.into_iter().collect();
    let terminal = Terminal::new(When::Never, Severity::Warning);
    let Ok(analysis) = Disk::default().analyze(&[file.to_owned()], None, &terminal) else {
        lines.push(changes(file));
        lines.push(failed(format!("`{file}` cannot be compiled; what is wrong stands above")));
        return lines;
    };
    let paths = analysis.sources.iter().map(|(_, source)| source.path.as_str());
    let of_library = |path: &str| driver::LIBRARY.iter().any(|(known, _)| *known == path);
    lines.extend(paths.filter(|path| !of_library(path)).map(changes));
    let worth_saying = analysis.findings.iter().filter(|finding| finding.severity >= Severity::Warning);
    lines.extend(worth_saying.flat_map(|finding| tell(finding, &analysis.sources)));
    let name = Path::new(file).with_extension("rs");
    let place = folder.zip(name.file_name()).map(|(folder, name)| folder.join(name));
    match (analysis.rust(options), place) {
        (Err(reason), _) => {
            let reason = explain(&reason, file);
            lines.extend(reason.map(|(message, help)| failed(format!("{message}; {help}"))));
        }
        (Ok(_), None) => lines.push(failed("there is no `OUT_DIR`: call this in a build script".to_owned())),
        (Ok(code), Some(place)) => {
            if let Err(error) = std::fs::write(&place, code) {
                lines.push(failed(format!("`{}` cannot be written: {error}", place.display())));
            }
        }
    }
    lines
}

/// A finding as cargo shows it, one line each for what it says and what to do.
fn tell(finding: &Diagnostic, sources: &Sources) -> Vec<String> {
    let kind = if finding.severity == Severity::Error { "error" } else { "warning" };
    let text = report::short(std::slice::from_ref(finding), sources);
    let help = finding.help.iter().map(|help| format!("  help: {}", help.replace(['\n', '\r'], " ")));
    std::iter::once(text.trim_end().to_owned()).chain(help).map(|line| format!("cargo::{kind}={line}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What cargo is told of a file among others, without the folder they lie in, and what is written.
    fn compiled(files: &[(&str, &str)]) -> (Vec<String>, Option<String>) {
        let folder = tempfile::tempdir().unwrap();
        for (path, text) in files {
            std::fs::write(folder.path().join(path), text).unwrap();
        }
        let path = folder.path().to_str().unwrap();
        let lines = compile(&format!("{path}/{}", files[0].0), &Options::default(), Some(folder.path()));
        let written = std::fs::read_to_string(folder.path().join(files[0].0).with_extension("rs")).ok();
        (lines.into_iter().map(|line| line.replace(&format!("{path}/"), "")).collect(), written)
    }

    const BEHAVIOR: &str = "import std.robots.j5\nimport parts\nbehavior b on j5 { entry a
        mode a { halt()  1: x -> again } flag x = contact_force > 1 N }";

    #[test]
    fn cargo_is_told_of_every_file_and_the_code_is_written() {
        let (lines, written) = compiled(&[("b.msd", BEHAVIOR), ("parts.msd", "world w { }"), ("lmsl.toml", "")]);
        let changed = ["lmsl.toml", "b.msd", "parts.msd"].map(|path| format!("cargo::rerun-if-changed={path}"));
        assert_eq!(lines[..3], changed);
        assert_eq!(lines[3], "cargo::warning=b.msd:2:1: warning[LM0207]: nothing of `parts.msd` is used in this file");
        assert!(written.unwrap().starts_with("// @generated by lmslc"));
    }

    #[test]
    fn an_error_fails_the_build_and_writes_nothing() {
        let broken = BEHAVIOR.replace("-> again", "-> aa");
        let (lines, written) = compiled(&[("b.msd", &broken), ("parts.msd", "")]);
        let error = lines.iter().position(|line| line.starts_with("cargo::error=b.msd:4:")).unwrap();
        assert!(lines[error + 1].starts_with("cargo::error=  help: "), "{lines:?}");
        assert_eq!(written, None);
        let (lines, written) = compiled(&[("b.msd", "world w { }")]);
        assert!(lines[1].starts_with("cargo::error=`b.msd` declares no behavior and no network"), "{lines:?}");
        assert_eq!(written, None);
        let (lines, _) = compiled(&[("b.msd", BEHAVIOR), ("parts.msd", ""), ("lmsl.toml", "[level]")]);
        assert!(lines.last().unwrap().starts_with("cargo::error=`b.msd` cannot be compiled"), "{lines:?}");
        let missing = compile("no/such.msd", &Options::default(), None);
        assert!(missing.iter().any(|line| line.contains("there is no file")), "{missing:?}");
    }
}
