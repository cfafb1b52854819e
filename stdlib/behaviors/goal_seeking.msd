// The goal-directed client of experiment 2 (Sobh et al. 2000). How it goes around things is ours: the paper does not say.
// It turns by as much as `ahead` spans: smaller turns take longer, as it stops between them.

import std.networks.clearances
import std.robots.labmate

/// Turns to the goal and drives there; goes on for a while where another client turned it away.
behavior goal_seeking on labmate {
    sense goal_direction(goal_bearing)

    entry seek

    mode seek {
        decide (direction) {
            (left ) => turn_left(30 deg)
            (ahead) => go_frwd(0 inch)
            (right) => turn_right(30 deg)
        }
        1: goal_distance < 50 cm -> arrived
        2: lost                  -> detour
    }
    mode detour {
        go_frwd(0 inch)
        1: goal_distance < 50 cm -> arrived
        2: held(not lost, 3 s)   -> seek
    }
    final mode arrived { stop() }
}
