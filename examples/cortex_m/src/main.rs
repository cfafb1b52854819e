//! The manipulation behavior of the J5 on a Cortex-M4. It is fed with the readings of the simulator's runs, prints when it
//! enters which mode, and fails where a tick is not, to the last bit, what the simulator computed.

#![no_std]
#![no_main]

/// What the build script had made of the behavior.
mod behavior {
    include!(concat!(env!("OUT_DIR"), "/behavior.rs"));
}

use core::convert::Infallible;
use core::hint::black_box;
use core::panic::PanicInfo;

use cortex_m::peripheral::{Peripherals, SYST, syst::SystClkSource};
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, heprintln, hprintln};

use behavior::obstacle_id::{self, Strengths};
use behavior::obstacle_manipulation::{Failed, Inputs, Machine, Robot};

/// A recorded run.
struct Run {
    scenario: &'static str,
    ticks: &'static [Tick],
}

/// What the simulator recorded of a tick.
struct Tick {
    time_ns: u64,
    /// The accelerations of the left and the right wheel, m/s², and the contact force, N.
    readings: [f64; 3],
    mode: &'static str,
    /// Contributor and detractor of `forward_collision`, then of `heavy_obstacle`.
    strengths: [f64; 4],
}

/// What the build script recorded.
static RUNS: [Run; 2] = include!(concat!(env!("OUT_DIR"), "/runs.rs"));

/// The robot's motors, which do not move: what they did stands in the readings.
struct Motors;

impl Robot for Motors {
    type Error = Infallible;

    fn halt(&mut self) -> Result<(), Infallible> {
        Ok(())
    }

    fn drive(&mut self, _speed: f64) -> Result<(), Infallible> {
        Ok(())
    }

    fn arc(&mut self, _speed: f64, _radius: f64) -> Result<(), Infallible> {
        Ok(())
    }

    fn turn(&mut self, _angle: f64, _start: bool) -> Result<(), Infallible> {
        Ok(())
    }
}

#[entry]
fn main() -> ! {
    let mut timer = Peripherals::take().unwrap().SYST;
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(COUNTS - 1);
    timer.clear_current();
    timer.enable_counter();
    for run in &RUNS {
        follow(run);
    }
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!()
}

/// Goes through a run and panics where the machine leaves it.
fn follow(run: &Run) {
    hprintln!("{}", run.scenario);
    let mut machine = Machine::new(1);
    let (mut before_ns, mut before, mut longest) = (0, None, 0);
    for tick in run.ticks {
        let [left, right, force] = tick.readings;
        let inputs = Inputs {
            left_wheel_acceleration: left,
            right_wheel_acceleration: right,
            contact_force: force,
            failed: Failed::default(),
            // The runs end before a turn does.
            done: false,
        };
        let (Ok(mode), instructions) = counted(|| machine.step(&inputs, tick.time_ns - before_ns, &mut Motors));
        longest = longest.max(instructions);
        if before != Some(mode) {
            let hundredths = tick.time_ns / 10_000_000;
            hprintln!("{:5}.{:02} s  {}", hundredths / 100, hundredths % 100, mode.name());
        }
        assert_eq!(mode.name(), tick.mode, "at {} ns", tick.time_ns);
        let strengths = obstacle_id::strengths(&obstacle_id::Inputs { left, right, force });
        assert_eq!(bits(strengths), tick.strengths.map(f64::to_bits), "at {} ns", tick.time_ns);
        (before_ns, before) = (tick.time_ns, Some(mode));
    }
    heprintln!("{} ticks, the longest about {} instructions", run.ticks.len(), longest);
}

fn bits(Strengths { forward_collision, heavy_obstacle }: Strengths) -> [u64; 4] {
    let strengths = [forward_collision, heavy_obstacle].map(|event| [event.contributor, event.detractor]);
    [strengths[0][0], strengths[0][1], strengths[1][0], strengths[1][1]].map(f64::to_bits)
}

/// What `work` gives, and about how many instructions it took: the emulator takes 1 ns for each, and its timer counts at
/// 25 MHz, down.
fn counted<T>(work: impl FnOnce() -> T) -> (T, u32) {
    let start = SYST::get_current();
    let result = black_box(work());
    (result, start.wrapping_sub(SYST::get_current()) % COUNTS * 40)
}

/// The timer has 24 bits.
const COUNTS: u32 = 1 << 24;

#[panic_handler]
fn panic(info: &PanicInfo) -> ! {
    heprintln!("{}", info);
    debug::exit(debug::EXIT_FAILURE);
    loop {}
}
