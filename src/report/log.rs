//! The log of an arbiter, in the words of the paper (Sobh et al. 2000, section 5).

use crate::trace::{Trace, seconds};

/// One line for each proposal whose fate changed: when, and what became of it. Empty for anything but an arbiter.
pub fn log(trace: &Trace) -> String {
    let lines = trace.log.iter().map(|entry| format!("{:>8.2} s  {}", seconds(entry.time), entry.text));
    lines.fold(String::new(), |log, line| log + &line + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::trace::LogEntry;

    #[test]
    fn lines_begin_with_the_time() {
        let entry = |time, text: &str| LogEntry { time, text: text.to_owned() };
        let log = [entry(0, "Accepted GO-FRWD from 2 (wander)"), entry(61_500_000_000, "Emergency BRAKE at bumper")];
        let trace = Trace { log: log.to_vec(), ..Trace::default() };
        assert_eq!(
            super::log(&trace),
            "    0.00 s  Accepted GO-FRWD from 2 (wander)\n   61.50 s  Emergency BRAKE at bumper\n"
        );
    }
}
