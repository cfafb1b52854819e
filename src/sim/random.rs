//! Random numbers: a stream of its own for each purpose, so that one does not disturb another.

use rand_distr::{Distribution, StandardNormal, StandardUniform};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;

/// What random numbers are drawn for.
#[derive(Debug, Clone, Copy)]
pub(super) enum Purpose {
    /// The machine's own draws.
    Machine = 1,
    /// The noise of sensors.
    Sensors = 2,
    /// The noise of tracking.
    Tracking = 3,
    /// The readings of faulty sensors.
    Faults = 4,
    /// What the robot's own behavior draws.
    Drive = 5,
}

/// A stream of random numbers. The same seed and purpose give the same numbers on every machine.
#[derive(Debug, Clone)]
pub(super) struct Stream(Pcg64);

impl Stream {
    /// The stream of one purpose in a run.
    pub(super) fn new(seed: u64, purpose: Purpose) -> Self {
        // An odd factor keeps different seeds different; seeding then spreads what is left of the likeness.
        Self(Pcg64::seed_from_u64(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(purpose as u64)))
    }

    /// A number from the normal distribution of mean 0 and standard deviation 1.
    pub(super) fn normal(&mut self) -> f64 {
        StandardNormal.sample(&mut self.0)
    }

    /// A number from `low` to `high`, each as likely.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        let share: f64 = StandardUniform.sample(&mut self.0);
        low + (high - low) * share
    }

    /// A seed for something else.
    pub(super) fn seed(&mut self) -> u64 {
        StandardUniform.sample(&mut self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn streams_do_not_change_between_releases() {
        let mut stream = Stream::new(1, Purpose::Sensors);
        assert_eq!(stream.seed(), 6_185_234_379_864_944_592);
    }

    #[test]
    fn purposes_and_seeds_have_streams_of_their_own() {
        let purposes = [Purpose::Machine, Purpose::Sensors, Purpose::Tracking, Purpose::Faults];
        let mut seen = std::collections::BTreeSet::new();
        for seed in 0..100 {
            seen.extend(purposes.map(|purpose| Stream::new(seed, purpose).seed()));
        }
        assert_eq!(seen.len(), 400);
    }

    #[test]
    fn normal_numbers_have_mean_0_and_deviation_1() {
        let mut stream = Stream::new(7, Purpose::Sensors);
        let numbers: Vec<f64> = (0..10_000).map(|_| stream.normal()).collect();
        let mean = numbers.iter().sum::<f64>() / 1e4;
        let variance = numbers.iter().map(|number| number * number).sum::<f64>() / 1e4;
        // The mean of 10 000 deviates by 0.01, their mean square by sqrt(2) times that; four times as much is allowed.
        assert!(mean.abs() < 0.04, "{mean}");
        assert!((variance - 1.0).abs() < 0.06, "{variance}");
    }
}
