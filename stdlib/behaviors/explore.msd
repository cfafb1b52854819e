// All numbers are ours.
import std.interfaces.ranging_base

/// Wanders: straight ahead, and at what is in the way to the side where it sees farther, by chance more or less.
behavior explore on ranging_base {
    flag leftward = ahead_left > ahead_right
    flag shut     = blocked or front < 45 cm

    entry onward

    mode onward {
        drive(25 cm/s)
        1: shut and leftward -> turn_left
        2: shut              -> turn_right
        3: after 40 s        -> turn_left
    }
    mode turn_left {
        turn(random(30 deg, 100 deg))
        1: done and shut -> again
        2: done          -> onward
    }
    mode turn_right {
        turn(random(-100 deg, -30 deg))
        1: done and shut -> again
        2: done          -> onward
    }
}
