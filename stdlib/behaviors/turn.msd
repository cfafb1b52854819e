// The angle and the time are ours.
import std.interfaces.mobile_base

/// Looks around: a quarter turn to the left, a rest, and on.
behavior turn on mobile_base {
    entry look

    mode look {
        halt()
        1: after 2 s -> on_around
    }
    mode on_around {
        turn(90 deg)
        1: done -> look
    }
}
