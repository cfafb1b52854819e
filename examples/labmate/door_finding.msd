// The door-finding client of experiment 3 (Sobh et al. 2000). The paper does not say how it finds doors; this is ours.

import std.robots.labmate

/// Along the hallway, to where the sonars see farthest: through openings, and past them.
behavior door_finding on labmate {
    flag walled    = sonar[23] < 1.3 m or sonar[0] < 1.3 m
    flag open      = sonar[23] > 1.8 m and sonar[0] > 1.8 m
    flag leftward  = reach_left > reach_right
    /// Heading across the hallway, or back.
    flag too_left  = heading > 60 deg
    flag too_right = heading < -60 deg

    entry onward

    mode onward {
        go_frwd(0 inch)
        1: lost                            -> pass
        2: walled or too_left or too_right -> search
    }
    mode search {
        decide (too_left, too_right, leftward) {
            (set,   set,   _    ) => nothing
            (set,   clear, _    ) => turn_right(10 deg)
            (clear, set,   _    ) => turn_left(10 deg)
            (clear, clear, set  ) => turn_left(10 deg)
            (clear, clear, clear) => turn_right(10 deg)
        }
        1: lost                                    -> pass
        2: open and not too_left and not too_right -> onward
    }
    /// Another client has turned it away: on for a while, past what was close.
    mode pass {
        go_frwd(0 inch)
        1: held(not lost, 2 s) -> onward
    }
}
