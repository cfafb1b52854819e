// All numbers are ours.
import std.interfaces.ranging_base

/// Drives along the middle of a corridor to its end, and back.
behavior follow_corridor on ranging_base {
    flag leftward = ahead_left > ahead_right
    flag ended    = blocked or front < 60 cm

    entry along

    mode along {
        decide (leftward) {
            (set  ) => arc(25 cm/s, radius: 3 m)
            (clear) => arc(25 cm/s, radius: -3 m)
        }
        1: ended -> about
    }
    mode about {
        turn(180 deg)
        1: done -> along
    }
}
