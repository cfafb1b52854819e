// The door-finding client of experiment 3 (Sobh et al. 2000). The paper does not say how it finds doors; this is ours.

import std.robots.labmate

/// Along the hallway, to the widest opening the sonars see.
behavior door_finding on labmate {
    /// Heading across the hallway, or back.
    flag too_left  = heading > 60 deg
    flag too_right = heading < -60 deg
    flag leftward  = opening > 10 deg
    flag rightward = opening < -10 deg

    entry search

    mode search {
        decide (too_left, too_right, leftward, rightward) {
            (set,   _,     _,     _    ) => turn_right(10 deg)
            (clear, set,   _,     _    ) => turn_left(10 deg)
            (clear, clear, set,   _    ) => turn_left(10 deg)
            (clear, clear, clear, set  ) => turn_right(10 deg)
            (clear, clear, clear, clear) => go_frwd(0 inch)
        }
        1: lost -> pass
    }
    /// Another client has turned it away: on for a while, past what was close.
    mode pass {
        go_frwd(0 inch)
        1: held(not lost, 2 s) -> search
    }
}
