// The speed and the radius are ours.
import std.interfaces.alert_base

/// Drives a circle to the left, and the other way around once something is in the way.
behavior arc on alert_base {
    entry leftward

    mode leftward {
        arc(25 cm/s, radius: 1 m)
        1: blocked -> back_up_right
    }
    mode back_up_right {
        arc(-20 cm/s, radius: 1 m)
        1: after 1.5 s -> rightward
    }
    mode rightward {
        arc(25 cm/s, radius: -1 m)
        1: blocked -> back_up_left
    }
    mode back_up_left {
        arc(-20 cm/s, radius: -1 m)
        1: after 1.5 s -> leftward
    }
}
