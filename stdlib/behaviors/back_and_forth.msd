// Speeds, times and angles are ours.
import std.interfaces.alert_base

/// To and fro: straight ahead until something is in the way, then back where it came from.
behavior back_and_forth on alert_base {
    entry onward

    mode onward {
        drive(25 cm/s)
        1: blocked -> back_up
    }
    mode back_up {
        drive(-15 cm/s)
        1: after 2 s -> about
    }
    mode about {
        turn(180 deg)
        1: done -> onward
    }
}
