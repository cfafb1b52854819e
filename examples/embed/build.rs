//! Compiles the behavior before the crate.

use lmslc::emit::Options;

fn main() {
    lmslc::build("patrol.msd", &Options::default());
}
