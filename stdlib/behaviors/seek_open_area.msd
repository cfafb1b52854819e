// After the open-area seeker that Khatoon and Ibraheem (2012) compare with; all numbers are ours.
import std.interfaces.ranging_base

/// Heads for where it sees farthest.
behavior seek_open_area on ranging_base {
    flag leftward = ahead_left > ahead_right
    flag open     = front > ahead_left and front > ahead_right
    flag shut     = blocked or front < 50 cm

    entry onward

    mode onward {
        decide (open, leftward) {
            (set,   _    ) => drive(25 cm/s)
            (clear, set  ) => arc(25 cm/s, radius: 1 m)
            (clear, clear) => arc(25 cm/s, radius: -1 m)
        }
        1: shut and leftward -> turn_left
        2: shut              -> turn_right
    }
    /// On in the same direction until there is room ahead, so that it does not swing to and fro.
    mode turn_left {
        turn(30 deg)
        1: done and shut -> again
        2: done          -> onward
    }
    mode turn_right {
        turn(-30 deg)
        1: done and shut -> again
        2: done          -> onward
    }
}
