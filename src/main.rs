//! The command line; see `lmslc --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    lmslc::cli::main()
}
