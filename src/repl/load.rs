//! The readings of a recorded run, told to the machine again.

use super::Refusal;
use super::session::{Driven, Session, State, number_at};
use crate::report::{Recorded, read_trace};
use crate::verify::{Number, time};

/// The state after the ticks of a trace, from a fresh one, and what to say of it. A trace does not record when actions
/// complete: they are taken to on the ticks on which the recorded mode is reached in no other way.
pub(super) fn load<'d>(session: &Session<'d>, fresh: State<'d>, text: &str) -> Result<(State<'d>, String), Refusal> {
    let driven = session.driven;
    let ticks = read_trace(text).map_err(|error| Refusal::new(error.to_string()))?;
    check(driven, &ticks)?;
    let mut state = fresh;
    let mut differs = None;
    for tick in &ticks {
        tell(driven, &mut state, tick);
        let reached = |done| mode(driven, state.mode_after(driven, done)) == tick.mode;
        state.done = !reached(false) && reached(true);
        state.step(driven);
        let now = mode(driven, state.machine.mode());
        if now != tick.mode {
            differs = differs.or(Some((tick, now)));
        }
    }
    let end = format!("  {} ticks, in the modes of the trace\n", ticks.len());
    let told = differs.map_or(end, |(tick, mode)| {
        format!(
            "  {} ticks; from {} on in other modes than the trace: in {mode}, not in {}\n",
            ticks.len(),
            time(tick.time),
            tick.mode
        )
    });
    Ok((state, told))
}

fn mode<'d>(driven: &'d Driven<'d>, mode: u32) -> &'d str {
    &driven.plan.modes[mode as usize].name
}

/// Refuses what is no run of this diagram in ticks of this length.
fn check(driven: &Driven<'_>, ticks: &[Recorded]) -> Result<(), Refusal> {
    let Some(first) = ticks.first() else { return Err(Refusal::new("the trace has no tick")) };
    if let Some(input) = driven.plan.inputs.iter().find(|input| !first.numbers.contains_key(&input.name)) {
        return Err(Refusal::new(format!("the trace has no readings of `{}`", input.name)));
    }
    let known = |name: &str| driven.plan.modes.iter().any(|mode| mode.name == name);
    if let Some(tick) = ticks.iter().find(|tick| !known(&tick.mode)) {
        return Err(Refusal::new(format!("`{}` has no mode `{}`", driven.plan.name, tick.mode)));
    }
    let lengths = ticks.windows(2).map(|pair| pair[1].time.saturating_sub(pair[0].time));
    match lengths.into_iter().find(|length| *length != driven.tick) {
        Some(length) => {
            let (length, tick) = (time(length), time(driven.tick));
            let message = format!("the trace has a tick of {length}, and this session has ticks of {tick}");
            Err(Refusal::new(message).help(format!("begin the session with `--tick {}`", length.replace(' ', ""))))
        }
        None => Ok(()),
    }
}

/// Lets the sensors say what they said on a tick; what is not a number, or has none that can be written, has failed.
fn tell(driven: &Driven<'_>, state: &mut State<'_>, tick: &Recorded) {
    for (index, input) in driven.plan.inputs.iter().enumerate() {
        let recorded = tick.numbers.get(&input.name).copied().unwrap_or(f64::NAN);
        let number = number_at(recorded.clamp(input.low, input.high), input).or_else(|| {
            // Next to 0 a number can have more digits than a literal.
            (recorded.abs() < 1e-12).then_some(Number { written: 0.0, si: 0.0 })
        });
        state.failed[index] = number.is_none();
        state.values[index] = number.unwrap_or(state.values[index]);
    }
}
