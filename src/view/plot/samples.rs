//! Runs to draw: the papers' manipulation experiment with made-up physics, and the odd ones.

use crate::trace::{Column, Footprint, ModeChange, Signal, Trace, seconds};

/// The modes of the manipulation behavior, by their numbers in LMSL fig. 12.
const MODES: [&str; 7] = ["init", "forward", "stop", "back_up", "random_turn", "arc", "push"];

/// Noise from -1 to 1 that is the same in every run (the finalizer of SplitMix64).
fn noise(tick: usize, stream: u64) -> f64 {
    let mut z = (tick as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ stream.wrapping_mul(0xD1B5_4A32_D192_ED03);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    (z >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

/// Runs `of` over the times of a trace and keeps what it says as a column.
fn record(trace: &mut Trace, name: &str, unit: &str, signal: Signal, of: impl Fn(f64, usize) -> f64) {
    let values = trace.times.iter().enumerate().map(|(tick, &time)| of(seconds(time), tick)).collect();
    trace.columns.push(Column { name: name.to_owned(), unit: unit.to_owned(), signal, values });
}

fn change(time: f64, from: Option<u32>, to: u32) -> ModeChange {
    let time = (time * 1e9).round() as u64;
    ModeChange { time, from, to, priority: Some(1), condition: String::new(), evidence: Vec::new() }
}

/// A trace without columns: a tick every 10 ms and these changes of mode.
fn bare(duration: f64, changes: &[(f64, u32)], modes: &[&str]) -> Trace {
    let times: Vec<u64> = (0..=(duration * 100.0) as u64).map(|tick| tick * 10_000_000).collect();
    let active = |time: u64| changes.iter().rev().find(|(at, _)| seconds(time) >= *at).map_or(0, |&(_, mode)| mode);
    let from = std::iter::once(None).chain(changes.iter().map(|&(_, mode)| Some(mode)));
    Trace {
        scenario: "two_obstacles".to_owned(),
        behavior: "obstacle_manipulation".to_owned(),
        robot: "j5".to_owned(),
        seed: 1,
        modes: modes.iter().map(|&mode| mode.to_owned()).collect(),
        mode: times.iter().map(|&time| active(time)).collect(),
        changes: changes.iter().zip(from).map(|(&(time, to), from)| change(time, from, to)).collect(),
        times,
        ..Trace::default()
    }
}

/// The manipulation experiment (LMSL §4): 10 s, impacts at 5 s and 8 s, then stop and back up.
pub fn manipulation() -> Trace {
    let mut trace = bare(10.0, &[(0.0, 0), (2.05, 1), (5.02, 6), (8.04, 2), (9.05, 3)], &MODES);
    let spike = |t: f64, at: f64, depth: f64| if (at..at + 0.09).contains(&t) { -depth } else { 0.0 };
    let start = |t: f64| if (2.05..2.9).contains(&t) { 1.6 * (-(t - 2.05) / 0.15).exp() } else { 0.0 };
    let stop = |t: f64| if (8.04..8.8).contains(&t) { -0.8 * (-(t - 8.04) / 0.15).exp() } else { 0.0 };
    let back = |t: f64| if t >= 9.05 { -1.1 * (-(t - 9.05) / 0.15).exp() } else { 0.0 };
    let acceleration = move |t: f64| start(t) + stop(t) + back(t) + spike(t, 5.0, 1.71) + spike(t, 8.0, 2.6);
    for (number, (side, stream)) in [("left", 1), ("right", 2)].into_iter().enumerate() {
        let name = format!("{side}_wheel_acceleration");
        record(&mut trace, &name, "m/s^2", Signal::Reading(number as u32), |t, tick| {
            acceleration(t) + if t > 2.05 { 0.12 } else { 0.02 } * noise(tick, stream)
        });
    }
    record(&mut trace, "contact_force", "N", Signal::Reading(2), |t, tick| {
        let level = if t < 5.02 {
            0.0
        } else if t < 8.02 {
            118.0
        } else if t < 8.3 {
            231.0
        } else if t < 9.2 {
            35.0
        } else {
            0.0
        };
        (level + 1.5 * noise(tick, 3)).max(0.0)
    });
    let bump = |t: f64, at: f64, high: f64| high * (1.0 - ((t - at) / 0.12).abs()).max(0.0);
    let event = |trace: &mut Trace, number: u32, name: &str, contributor: &dyn Fn(f64) -> f64, quiet: f64| {
        let full = format!("obstacle_id.{name}");
        let detractor = |t: f64| ((1.0 - contributor(t)) * quiet).clamp(0.0, 1.0);
        record(trace, &format!("{full}.contributor"), "1", Signal::Contributor(number), |t, _| contributor(t));
        record(trace, &format!("{full}.detractor"), "1", Signal::Detractor(number), |t, tick| {
            (detractor(t) - 0.04 * noise(tick, 9).abs()).max(0.0)
        });
        record(trace, &full, "1", Signal::Event(number), |t, _| f64::from(contributor(t) > detractor(t)));
    };
    event(&mut trace, 0, "forward_collision", &|t| bump(t, 5.06, 0.93).max(bump(t, 8.06, 1.0)), 0.96);
    event(
        &mut trace,
        1,
        "heavy_obstacle",
        &|t| if t < 5.02 { 0.0 } else { bump(t, 8.16, 1.6).min(1.0).max(if t < 8.3 { 0.1 } else { 0.0 }) },
        1.0,
    );
    let x = |t: f64| 0.26 * (t.clamp(2.1, 8.0) - 2.1) - 0.2 * (t - 9.1).max(0.0);
    pose(&mut trace, "robot", (1.0, 0.75, 59.0), |t| (x(t), 0.02 * x(t), 0.01));
    let pushed = |t: f64| 0.26 * (t.clamp(5.0, 8.3) - 5.0);
    pose(&mut trace, "box1", (0.4, 0.6, 30.0), |t| (1.48 + pushed(t), 0.02 * pushed(t), 0.0));
    pose(&mut trace, "box2", (0.5, 0.8, 90.0), |t| (2.71 + 0.26 * (t.clamp(8.0, 8.3) - 8.0), 0.0, 0.0));
    trace
}

fn pose(trace: &mut Trace, name: &str, (length, width, mass): (f64, f64, f64), of: impl Fn(f64) -> (f64, f64, f64)) {
    let number = trace.bodies.len() as u32;
    trace.bodies.push(Footprint { name: name.to_owned(), mass, length, width });
    record(trace, &format!("{name}.x"), "m", Signal::X(number), |t, _| of(t).0);
    record(trace, &format!("{name}.y"), "m", Signal::Y(number), |t, _| of(t).1);
    record(trace, &format!("{name}.heading"), "rad", Signal::Heading(number), |t, _| of(t).2);
}

/// Ten minutes in a room of boxes with walls and a goal: noisy sensors, flickering flags, hundreds of changes.
pub fn long() -> Trace {
    let changes: Vec<(f64, u32)> = (0..240).map(|n| (f64::from(n) * 2.5, [0, 1, 6, 2, 3, 4][n as usize % 6])).collect();
    let mut trace = bare(600.0, &changes, &MODES);
    for number in 0..8 {
        record(&mut trace, &format!("sonar_{number}"), "m", Signal::Reading(number), |t, tick| {
            1.5 + (t / (20.0 + f64::from(number))).sin() + 0.3 * noise(tick, u64::from(number))
        });
    }
    record(&mut trace, "near.wall.contributor", "1", Signal::Contributor(0), |_, tick| noise(tick, 20).abs());
    record(&mut trace, "near.wall.detractor", "1", Signal::Detractor(0), |_, tick| noise(tick, 21).abs());
    record(&mut trace, "near.wall", "1", Signal::Event(0), |_, tick| {
        f64::from(noise(tick, 20).abs() > noise(tick, 21).abs())
    });
    record(&mut trace, "close", "1", Signal::Flag(0), |t, _| f64::from((t / 9.0).sin() > 0.4));
    record(&mut trace, "an_event_with_a_name_of_some_length", "1", Signal::Flag(1), |t, _| {
        f64::from((t / 30.0).sin() > 0.0)
    });
    pose(&mut trace, "robot", (1.0, 0.75, 59.0), |t| {
        (2.6 * (t / 17.0).sin(), 1.9 * (t / 11.0).cos() + 0.3 * (t / 3.0).sin(), t / 9.0)
    });
    pose(&mut trace, "box1", (0.4, 0.6, 30.0), |t| (1.0 + t / 600.0, -1.0, t / 300.0));
    pose(&mut trace, "box2", (0.1, 0.1, 2.5), |_| (-2.0, 1.5, 0.4));
    trace.walls =
        vec![vec![[-3.5, -2.8], [3.5, -2.8], [3.5, 2.8], [-3.5, 2.8], [-3.5, -2.8]], vec![[0.0, 2.8], [0.0, 1.6]]];
    trace.goal = Some([3.0, 2.2]);
    trace
}

/// Twenty modes, no sensors, no bodies.
pub fn many_modes() -> Trace {
    let names: Vec<String> =
        (0..20).map(|n| format!("{}_{n}", ["search", "approach_the_nearest_open_door"][n % 2])).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let changes: Vec<(f64, u32)> = (0..40).map(|n| (f64::from(n) * 0.75, (n * 7) % 20)).collect();
    bare(30.0, &changes, &names)
}

/// One tick of the manipulation experiment.
pub fn one_tick() -> Trace {
    let mut trace = manipulation();
    trace.times.truncate(1);
    trace.mode.truncate(1);
    trace.changes.truncate(1);
    trace.columns.iter_mut().for_each(|column| column.values.truncate(1));
    trace
}
