// The hybrid of Khatoon and Ibraheem (2012, section 1.1): a global planner gives temporary goals on the map that is known, the
// fuzzy navigator drives from one to the next, and a supervisor plans anew where progress stops. The paper leaves open how it
// notices that; here a temporary goal that is not reached within 75 s will do, and anything that is touched. All times and
// distances are ours.

import std.networks.navigator
import std.robots.car

/// Drives to the goal by temporary goals, and plans anew where it gets no further.
activity hybrid_navigation on car {
    entry plan

    /// Asks for a way from where the robot is.
    mode plan = stand_by {
        on enter { plan() }
        1: done -> leg
    }
    /// To the next temporary goal.
    mode leg = seek_waypoint {
        on enter { next_waypoint() }
        1: goal_distance < 1.5 m        -> arrived
        2: front_bumper or back_bumper  -> back_off
        3: done and goal_distance > 7 m -> again
        4: after 75 s                   -> plan
        5: failed(waypoint_distance)    -> plan
    }
    /// Off what it has touched.
    mode back_off = reverse {
        1: done -> plan
    }
    final mode arrived = stand_by
}

/// To a temporary goal as to a goal.
behavior seek_waypoint on car {
    sense navigator(waypoint_bearing, gate, nearest, left, right)

    entry navigate

    mode navigate {
        steer(speed, steering)
        1: waypoint_distance < 7 m -> there
    }
    final mode there { steer(speed, steering) }
}

/// Straight back for a while.
behavior reverse on car {
    entry back

    mode back {
        drive(-1 m/s)
        1: after 4 s -> off
    }
    final mode off { halt() }
}

/// Stands until what was asked for has been done.
behavior stand_by on car {
    entry wait

    mode wait {
        halt()
        1: after 300 ms -> ready
    }
    final mode ready { halt() }
}
