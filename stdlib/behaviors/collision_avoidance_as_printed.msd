// Reaction control as Table 1 of Sobh et al. 2000 prints it: with the right side close and the left one far, it turns
// RIGHT while it moves forward, towards what is close. The angle of 20 deg is ours.
import std.networks.clearances
import std.robots.labmate

/// Turns towards what is close.
behavior collision_avoidance_as_printed on labmate {
    sense clearances(right, left, front, back)

    /// No way to go.
    flag enclosed = right is close and left is close and front is close and back is close

    entry forward

    mode forward {
        decide (right, left, front, back) {
            (close, close, close, close) => stop()
            (close, close, close, far  ) => go_bkwd(0 inch)
            (close, close, far,   _    ) => nothing
            (close, far,   _,     _    ) => turn_right(20 deg)
            (far,   close, _,     _    ) => turn_left(20 deg)
            (far,   far,   close, _    ) => either(turn_left(20 deg), turn_right(20 deg))
            (far,   far,   far,   _    ) => nothing
        }
        1: state is faulted  -> recover
        2: enclosed          -> deadlock
        3: state is backward -> backward
    }
    mode backward {
        decide (right, left, front, back) {
            (close, close, close, close) => stop()
            (close, close, close, far  ) => nothing
            (close, close, far,   close) => go_frwd(0 inch)
            (close, close, far,   far  ) => nothing
            (close, far,   _,     _    ) => turn_left(20 deg)
            (far,   close, _,     _    ) => turn_right(20 deg)
            (far,   far,   close, close) => either(turn_left(20 deg), turn_right(20 deg))
            (far,   far,   close, far  ) => nothing
            (far,   far,   far,   close) => either(turn_left(20 deg), turn_right(20 deg))
            (far,   far,   far,   far  ) => nothing
        }
        1: state is faulted                       -> recover
        2: enclosed                               -> deadlock
        3: state is any of {forward, left, right} -> forward
    }
    mode deadlock {
        stop()
        1: state is faulted -> recover
        2: not enclosed     -> forward
    }
    /// Out of the state that a contact leads to.
    mode recover {
        reset()
        1: not state is faulted -> forward
    }
}
