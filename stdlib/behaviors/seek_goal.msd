// All numbers are ours.
import std.interfaces.located_base

/// Drives to its goal, and around what is in the way; stands still while it does not know where the goal is.
behavior seek_goal on located_base {
    flag arrived  = goal_distance < 50 cm
    flag shut     = blocked or front < 50 cm
    flag left_of  = goal_bearing > 10 deg
    flag right_of = goal_bearing < -10 deg
    flag known    = not failed(goal_distance) and not failed(goal_bearing)

    entry wait

    mode wait {
        halt()
        1: held(known, 1 s) -> seek
    }
    mode seek requires goal_distance, goal_bearing else wait {
        decide (left_of, right_of) {
            (set,   clear) => arc(25 cm/s, radius: 50 cm)
            (clear, set  ) => arc(25 cm/s, radius: -50 cm)
            (clear, clear) => drive(25 cm/s)
            (set,   set  ) => nothing
        }
        1: arrived                           -> arrive
        2: shut and ahead_left > ahead_right -> turn_left
        3: shut                              -> turn_right
    }
    mode turn_left {
        turn(30 deg)
        1: done and shut -> again
        2: done          -> past
    }
    mode turn_right {
        turn(-30 deg)
        1: done and shut -> again
        2: done          -> past
    }
    /// A way along what was in the way.
    mode past {
        drive(25 cm/s)
        1: arrived                           -> arrive
        2: shut and ahead_left > ahead_right -> turn_left
        3: shut                              -> turn_right
        4: after 3 s                         -> seek
    }
    final mode arrive { halt() }
}
