// All numbers are ours.
import std.interfaces.located_base

/// Turns to its goal and drives up to it, slowly where it is near; stands still while it does not know where the goal is.
behavior dock on located_base {
    flag docked    = goal_distance < 10 cm
    flag near      = goal_distance < 50 cm
    flag too_right = goal_bearing > 10 deg
    flag too_left  = goal_bearing < -10 deg
    flag known     = not failed(goal_distance) and not failed(goal_bearing)

    entry wait

    mode wait {
        halt()
        1: held(known, 1 s) -> approach
    }
    mode approach requires goal_distance, goal_bearing else wait {
        decide (near) {
            (clear) => drive(25 cm/s)
            (set  ) => drive(8 cm/s)
        }
        1: docked    -> rest
        2: too_right -> turn_left
        3: too_left  -> turn_right
    }
    mode turn_left {
        turn(10 deg)
        1: done -> approach
    }
    mode turn_right {
        turn(-10 deg)
        1: done -> approach
    }
    final mode rest { halt() }
}
