//! `switching` in smlang: one event, guarded transitions by priority, and a last one that stays. The timer stands in the
//! context, for guards cannot change the data of a state.

use smlang::statemachine;

use crate::by_hand::above;
use crate::switching::Inputs;
use crate::{Commands, TURN};

statemachine! {
    transitions: {
        *Init + Tick(&'a Inputs) [after_2s] / cruise = Forward,
        Init + Tick(&'a Inputs) / wait = Init,
        Forward + Tick(&'a Inputs) [heavy] / halt = Stop,
        Forward + Tick(&'a Inputs) [hit] / push = Push,
        Forward + Tick(&'a Inputs) / cruise = Forward,
        Stop + Tick(&'a Inputs) [after_500ms] / back_up = BackUp,
        Stop + Tick(&'a Inputs) / wait = Stop,
        BackUp + Tick(&'a Inputs) [after_1500ms] / turn = Turn,
        BackUp + Tick(&'a Inputs) / go_on_back = BackUp,
        Turn + Tick(&'a Inputs) [done] / cruise = Forward,
        Turn + Tick(&'a Inputs) / go_on_turning = Turn,
        Push + Tick(&'a Inputs) [lost_or_heavy] / halt = Stop,
        Push + Tick(&'a Inputs) [after_4s] / cruise = Forward,
        Push + Tick(&'a Inputs) / go_on_pushing = Push,
    }
}

/// What guards and actions see.
pub struct Context<'r> {
    pub robot: &'r mut Commands,
    /// ns
    pub elapsed: u32,
}

impl StateMachineContext for Context<'_> {
    fn after_2s(&self, _: &Inputs) -> Result<bool, ()> {
        Ok(self.elapsed >= 2_000_000_000)
    }

    fn after_500ms(&self, _: &Inputs) -> Result<bool, ()> {
        Ok(self.elapsed >= 500_000_000)
    }

    fn after_1500ms(&self, _: &Inputs) -> Result<bool, ()> {
        Ok(self.elapsed >= 1_500_000_000)
    }

    fn after_4s(&self, _: &Inputs) -> Result<bool, ()> {
        Ok(self.elapsed >= 4_000_000_000)
    }

    fn heavy(&self, inputs: &Inputs) -> Result<bool, ()> {
        Ok(above(inputs, 150.0))
    }

    fn hit(&self, inputs: &Inputs) -> Result<bool, ()> {
        Ok(above(inputs, 60.0))
    }

    fn lost_or_heavy(&self, inputs: &Inputs) -> Result<bool, ()> {
        Ok(inputs.failed.force || above(inputs, 150.0))
    }

    fn done(&self, inputs: &Inputs) -> Result<bool, ()> {
        Ok(inputs.done)
    }

    fn wait(&mut self, _: &Inputs) -> Result<(), ()> {
        self.robot.halt();
        Ok(())
    }

    fn cruise(&mut self, _: &Inputs) -> Result<(), ()> {
        self.robot.drive(0.26);
        Ok(())
    }

    fn halt(&mut self, _: &Inputs) -> Result<(), ()> {
        self.elapsed = 0;
        self.robot.halt();
        Ok(())
    }

    fn push(&mut self, _: &Inputs) -> Result<(), ()> {
        self.elapsed = 0;
        self.robot.arc(0.26, 1.0);
        Ok(())
    }

    fn go_on_pushing(&mut self, _: &Inputs) -> Result<(), ()> {
        self.robot.arc(0.26, 1.0);
        Ok(())
    }

    fn back_up(&mut self, _: &Inputs) -> Result<(), ()> {
        self.elapsed = 0;
        self.robot.drive(-0.2);
        Ok(())
    }

    fn go_on_back(&mut self, _: &Inputs) -> Result<(), ()> {
        self.robot.drive(-0.2);
        Ok(())
    }

    fn turn(&mut self, _: &Inputs) -> Result<(), ()> {
        self.robot.turn(TURN, true);
        Ok(())
    }

    fn go_on_turning(&mut self, _: &Inputs) -> Result<(), ()> {
        self.robot.turn(TURN, false);
        Ok(())
    }
}
