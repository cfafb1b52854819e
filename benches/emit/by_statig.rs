//! `switching` in statig: each mode a state with its own timer, its command given on entry and on every tick after it.

use statig::Outcome::{self, Handled, Transition};
use statig::blocking::{IntoStateMachine, State};

use crate::by_hand::above;
use crate::switching::Inputs;
use crate::{Commands, TICK, TURN};

#[derive(Clone, Copy)]
pub struct Switching;

#[derive(Clone, Copy)]
pub enum Mode {
    Init(u32),
    Forward,
    Stop(u32),
    BackUp(u32),
    Turn,
    Push(u32),
}

impl IntoStateMachine for Switching {
    type Event<'event> = Inputs;
    type Context<'context> = Commands;
    type State = Mode;
    type Superstate<'state> = ();

    fn initial() -> Mode {
        Mode::Init(0)
    }
}

impl Mode {
    #[inline]
    fn act(self, robot: &mut Commands, start: bool) {
        match self {
            Self::Init(_) | Self::Stop(_) => robot.halt(),
            Self::Forward => robot.drive(0.26),
            Self::BackUp(_) => robot.drive(-0.2),
            Self::Turn => robot.turn(TURN, start),
            Self::Push(_) => robot.arc(0.26, 1.0),
        }
    }

    /// Where it leads, if anywhere.
    #[inline]
    fn exit(&mut self, inputs: &Inputs) -> Option<Self> {
        if let Self::Init(elapsed) | Self::Stop(elapsed) | Self::BackUp(elapsed) | Self::Push(elapsed) = self {
            *elapsed = elapsed.saturating_add(TICK);
        }
        match *self {
            Self::Init(elapsed) => (elapsed >= 2_000_000_000).then_some(Self::Forward),
            Self::Forward if above(inputs, 150.0) => Some(Self::Stop(0)),
            Self::Forward => above(inputs, 60.0).then_some(Self::Push(0)),
            Self::Stop(elapsed) => (elapsed >= 500_000_000).then_some(Self::BackUp(0)),
            Self::BackUp(elapsed) => (elapsed >= 1_500_000_000).then_some(Self::Turn),
            Self::Turn => inputs.done.then_some(Self::Forward),
            Self::Push(_) if inputs.failed.force || above(inputs, 150.0) => Some(Self::Stop(0)),
            Self::Push(elapsed) => (elapsed >= 4_000_000_000).then_some(Self::Forward),
        }
    }
}

impl State<Switching> for Mode {
    fn call_handler(&mut self, _: &mut Switching, inputs: &Inputs, robot: &mut Commands) -> Outcome<Self> {
        match self.exit(inputs) {
            Some(target) => Transition(target),
            None => {
                self.act(robot, false);
                Handled
            }
        }
    }

    fn call_entry_action(&mut self, _: &mut Switching, robot: &mut Commands) {
        self.act(robot, true);
    }
}
