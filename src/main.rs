//! The command line; see `lmslc --help`.
fn main() {}
